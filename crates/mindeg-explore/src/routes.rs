//! The routes: each address and its answer.

use std::ops::ControlFlow;
use std::sync::Arc;

use axum::body::{Body, Bytes};
use axum::extract::{Path, Request, State};
use axum::http::StatusCode;
use axum::http::header::{self, HeaderName, HeaderValue};
use axum::middleware::{Next, from_fn_with_state};
use axum::response::{IntoResponse, Response};
use axum::routing::{get, post};
use axum::{Extension, Router};
use mindeg_files::{Input, Session};
use mindeg_mesh::{Progress, Step};
use serde::Deserialize;
use tokio::sync::mpsc;

use crate::all::{All, FAULT, answered, failed, worked};
use crate::answer::{self, answer};
use crate::api::{AnswerLine, View};
use crate::body::{Lines, MAX_BYTES};
use crate::command::KnownFiles;
use crate::conditioned;
use crate::download::{Download, download};
use crate::facts::facts;
use crate::files::{self, File};
use crate::guard::HasToken;
use crate::presets::presets;
use crate::reading::sources;
use crate::received::{Asked, Sent};
use crate::refusal::{Refusal, bad_request, json, refused};
use crate::solid;
use crate::terms::without_options;
use crate::whole;
use crate::work::TIME_LIMIT;

const POLICY: &str = "default-src 'none'; script-src 'self'; style-src 'self'; \
                      img-src 'self' data: blob:; connect-src 'self'; frame-ancestors 'none'; \
                      base-uri 'none'; form-action 'none'";

pub(crate) fn router(all: Arc<All>) -> Router {
    let purpose = all.purpose;
    Router::new()
        .route("/", get(async || page(files::INDEX)))
        .route("/page/{name}", get(page_file))
        .route("/api/start", get(start))
        .route("/api/start/choices", get(start_choices))
        .route("/api/start/divided", get(start_divided))
        .route("/api/start/file", get(start_file))
        .route("/api/presets", get(async || json(&presets())))
        .route("/api/facts", get(async move || json(&facts(MAX_BYTES, purpose))))
        .route("/api/answer", post(answers))
        .route("/api/read", post(reading))
        .route("/api/condition", post(conditions))
        .route("/api/divide", post(divides))
        .route("/api/solid", post(solids))
        .route("/api/solid/file", post(solid_files))
        .route("/api/whole", post(wholes))
        .route("/api/whole/file", post(whole_files))
        .route("/api/download", post(downloads))
        .route("/api/state/{id}", get(state).put(keep_state))
        .fallback(async || refused(StatusCode::NOT_FOUND, "there is nothing at this address"))
        .method_not_allowed_fallback(async || {
            refused(StatusCode::METHOD_NOT_ALLOWED, "this address takes another method")
        })
        .layer(from_fn_with_state(Arc::clone(&all), guarded))
        .with_state(all)
}

/// Checks who asks, and tells the browser to keep others out.
async fn guarded(
    State(all): State<Arc<All>>,
    Extension(has_token): Extension<HasToken>,
    request: Request,
    next: Next,
) -> Response {
    let needs_token = request.uri().path().starts_with("/api/");
    let checked = all.guard.check(request.method(), request.headers(), needs_token);
    let mut response = match checked {
        Ok(()) => {
            if needs_token {
                has_token.show();
            }
            next.run(request).await
        }
        Err((status, message)) => refused(status, message).into_response(),
    };
    let fixed = [
        (header::CONTENT_SECURITY_POLICY, POLICY),
        (header::X_CONTENT_TYPE_OPTIONS, "nosniff"),
        (header::CACHE_CONTROL, "no-store"),
        (header::REFERRER_POLICY, "no-referrer"),
        (HeaderName::from_static("cross-origin-resource-policy"), "same-origin"),
        (HeaderName::from_static("cross-origin-opener-policy"), "same-origin"),
    ];
    for (name, value) in fixed {
        response.headers_mut().insert(name, HeaderValue::from_static(value));
    }
    response
}

fn page(file: File) -> Response {
    ([(header::CONTENT_TYPE, file.kind)], file.text).into_response()
}

async fn page_file(Path(name): Path<String>) -> Result<Response, Refusal> {
    let missing = || refused(StatusCode::NOT_FOUND, "the page has no such file");
    files::named(&name).map(page).ok_or_else(missing)
}

async fn start(State(all): State<Arc<All>>) -> Response {
    json(&all.start.clone().or_else(|| presets().into_iter().next()))
}

/// The domains to choose from at the start.
async fn start_choices(State(all): State<Arc<All>>) -> Response {
    json(&all.choices)
}

/// The same, read anew for edges of a length.
async fn start_divided(
    State(all): State<Arc<All>>,
    Asked(Length { size }): Asked<Length>,
) -> Result<Response, Refusal> {
    let Some(divide) = all.divide.clone() else {
        return Err(refused(StatusCode::NOT_FOUND, "the page was started without a domain"));
    };
    Ok(json(&worked(&all, move |_| divide.by(size)).await?))
}

/// The file of the surface to start with.
async fn start_file(State(all): State<Arc<All>>) -> Response {
    ([(header::CONTENT_TYPE, "application/octet-stream")], all.surface.clone()).into_response()
}

#[derive(Deserialize)]
struct Tab {
    tab: String,
}

/// Whether a name is one that the page gives to tabs and states.
fn is_name(name: &str) -> bool {
    let is_plain = |byte: u8| byte.is_ascii_alphanumeric() || matches!(byte, b'-' | b'_');
    (1..=64).contains(&name.len()) && name.bytes().all(is_plain)
}

async fn answers(
    State(all): State<Arc<All>>,
    Asked(Tab { tab }): Asked<Tab>,
    Sent(bytes): Sent,
) -> Result<Response, Refusal> {
    if !is_name(&tab) {
        return Err(bad_request("tab takes up to 64 letters, digits, - and _"));
    }
    let work = all.works.start(&tab);
    let (lines, received) = mpsc::unbounded_channel::<Bytes>();
    tokio::spawn(async move {
        let Some(turn) = all.works.turn().await else { return };
        let last = lines.clone();
        let answered = tokio::task::spawn_blocking(move || {
            let stops = || work.is_over() || lines.is_closed() || work.is_late();
            let callback = |_: Step<'_>| match stops() {
                true => ControlFlow::Break(()),
                false => ControlFlow::Continue(()),
            };
            let progress = Progress::new(&callback);
            let mut out = |line: &AnswerLine| send(&lines, line);
            let done = turn.work(|| answer(&bytes, &all.known, progress, &mut out));
            if done.is_err() && work.is_late() {
                send(&lines, &answer::late(TIME_LIMIT));
            }
        });
        if answered.await.is_err() {
            send(&last, &answer::refused(None, FAULT.to_owned()));
        }
    });
    let kind = [(header::CONTENT_TYPE, "application/x-ndjson")];
    Ok((kind, Body::new(Lines(received))).into_response())
}

/// Sends a line of an answer.
fn send(lines: &mpsc::UnboundedSender<Bytes>, line: &AnswerLine) {
    if let Ok(mut text) = serde_json::to_vec(line) {
        text.push(b'\n');
        // Nobody reads on: the next step of the work ends it.
        let _ = lines.send(text.into());
    }
}

#[derive(Deserialize)]
struct Named {
    name: String,
    size: Option<f64>,
}

/// The domains in a file.
async fn reading(
    Asked(Named { name, size }): Asked<Named>,
    Sent(bytes): Sent,
) -> Result<Response, Refusal> {
    let read = tokio::task::spawn_blocking(move || {
        sources(&Session::new("--"), &Input::Bytes(&name, &bytes), size)
    })
    .await;
    match read {
        Ok(Ok(mut sources)) => {
            for message in sources.iter_mut().filter_map(|source| source.message.as_mut()) {
                *message = without_options(message);
            }
            Ok(json(&sources))
        }
        Ok(Err(error)) => {
            Err(refused(StatusCode::UNPROCESSABLE_ENTITY, &without_options(&error.to_string())))
        }
        Err(_) => Err(failed()),
    }
}

#[derive(Deserialize)]
struct Wanted {
    format: String,
    #[serde(default)]
    file: usize,
    /// Instead of that of the request.
    view: Option<View>,
}

/// A file of a mesh.
async fn downloads(
    State(all): State<Arc<All>>,
    Asked(Wanted { format, file, view }): Asked<Wanted>,
    Sent(bytes): Sent,
) -> Result<Response, Refusal> {
    let work = move |bytes: &[u8], _: &KnownFiles, progress: Progress<'_>| {
        download(bytes, view, &format, file, progress)
    };
    Ok(attached(answered(all, bytes, work).await?))
}

/// The length of edges.
#[derive(Deserialize)]
struct Length {
    size: f64,
}

/// A divided boundary.
async fn divides(
    State(all): State<Arc<All>>,
    Asked(Length { size }): Asked<Length>,
    Sent(bytes): Sent,
) -> Result<Response, Refusal> {
    let work =
        move |bytes: &[u8], _: &KnownFiles, _: Progress<'_>| conditioned::divided_json(size, bytes);
    Ok(json(&answered(all, bytes, work).await?))
}

/// A changed boundary.
async fn conditions(
    State(all): State<Arc<All>>,
    Asked(wanted): Asked<conditioned::Asked>,
    Sent(bytes): Sent,
) -> Result<Response, Refusal> {
    let work = move |bytes: &[u8], known: &KnownFiles, _: Progress<'_>| {
        conditioned::conditioned(wanted, bytes, known)
    };
    Ok(json(&answered(all, bytes, work).await?))
}

/// A surface in space.
async fn solids(
    State(all): State<Arc<All>>,
    Asked(wanted): Asked<solid::Asked>,
    Sent(bytes): Sent,
) -> Result<Response, Refusal> {
    let work = move |bytes: &[u8], known: &KnownFiles, progress: Progress<'_>| {
        solid::shown(&wanted, bytes, known, progress)
    };
    Ok(json(&answered(all, bytes, work).await?))
}

/// A file of a surface in space.
async fn solid_files(
    State(all): State<Arc<All>>,
    Asked(wanted): Asked<solid::Asked>,
    Sent(bytes): Sent,
) -> Result<Response, Refusal> {
    let work = move |bytes: &[u8], _: &KnownFiles, progress: Progress<'_>| {
        solid::file(&wanted, bytes, progress)
    };
    Ok(attached(answered(all, bytes, work).await?))
}

/// The mesh of a whole map.
async fn wholes(
    State(all): State<Arc<All>>,
    Asked(wanted): Asked<whole::Asked>,
    Sent(bytes): Sent,
) -> Result<Response, Refusal> {
    let work = move |bytes: &[u8], _: &KnownFiles, progress: Progress<'_>| {
        whole::shown(&wanted, bytes, progress)
    };
    Ok(json(&answered(all, bytes, work).await?))
}

/// A file of the mesh of a whole map.
async fn whole_files(
    State(all): State<Arc<All>>,
    Asked(wanted): Asked<whole::Asked>,
    Sent(bytes): Sent,
) -> Result<Response, Refusal> {
    let work = move |bytes: &[u8], _: &KnownFiles, progress: Progress<'_>| {
        whole::file(&wanted, bytes, progress)
    };
    Ok(attached(answered(all, bytes, work).await?))
}

/// A file to save.
fn attached(file: Download) -> Response {
    // The name has letters, digits and dashes only.
    let disposition = format!("attachment; filename=\"{}\"", file.name);
    let kind = (header::CONTENT_TYPE, "application/octet-stream".to_owned());
    let disposition = (header::CONTENT_DISPOSITION, disposition);
    ([kind, disposition], file.bytes).into_response()
}

async fn state(State(all): State<Arc<All>>, Path(id): Path<String>) -> Result<Response, Refusal> {
    let gone = || refused(StatusCode::NOT_FOUND, "this address is of another run, or too old");
    let state = all.states.get(&id).ok_or_else(gone)?;
    Ok(([(header::CONTENT_TYPE, "application/json")], state).into_response())
}

async fn keep_state(
    State(all): State<Arc<All>>,
    Path(id): Path<String>,
    Sent(bytes): Sent,
) -> Result<Response, Refusal> {
    if !is_name(&id) {
        return Err(bad_request("a state's ID has up to 64 letters, digits, - and _"));
    }
    if serde_json::from_slice::<serde::de::IgnoredAny>(&bytes).is_err() {
        return Err(bad_request("a state is JSON"));
    }
    all.states.put(id, bytes);
    Ok(StatusCode::NO_CONTENT.into_response())
}
