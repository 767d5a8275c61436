//! The routes: each address and its answer.

use std::sync::Arc;

use axum::body::{Body, Bytes};
use axum::extract::{Path, Request, State};
use axum::http::StatusCode;
use axum::http::header::{self, HeaderName, HeaderValue};
use axum::middleware::{Next, from_fn_with_state};
use axum::response::{IntoResponse, Response};
use axum::routing::{MethodRouter, get, post};
use axum::{Extension, Router};
use mindeg_files::{Input, Session};
use mindeg_mesh::Progress;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use tokio::sync::mpsc;

use crate::all::{All, FAULT, answered, failed, worked};
use crate::answer::{self, answer};
use crate::api::{AnswerLine, View};
use crate::body::{Lines, MAX_BYTES};
use crate::command::KnownFiles;
use crate::conditioned::{conditioned, divided_json};
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
    let purpose = all.setup.purpose;
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
        .route("/api/condition", worked_on(conditioned, told))
        .route(
            "/api/divide",
            worked_on(|of: &Length, body, _, _| divided_json(of.size, body), told),
        )
        .route("/api/solid", worked_on(solid::shown, told))
        .route("/api/solid/file", worked_on(|of, body, _, on| solid::file(of, body, on), attached))
        .route("/api/whole", worked_on(|of, body, _, on| whole::shown(of, body, on), told))
        .route("/api/whole/file", worked_on(|of, body, _, on| whole::file(of, body, on), attached))
        .route("/api/download", worked_on(saved, attached))
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
    json(&all.setup.start.clone().or_else(|| presets().into_iter().next()))
}

/// The domains to choose from at the start.
async fn start_choices(State(all): State<Arc<All>>) -> Response {
    json(&all.setup.choices)
}

/// The same, read anew for edges of a length.
async fn start_divided(
    State(all): State<Arc<All>>,
    Asked(Length { size }): Asked<Length>,
) -> Result<Response, Refusal> {
    let Some(divide) = all.setup.divide.clone() else {
        return Err(refused(StatusCode::NOT_FOUND, "the page was started without a domain"));
    };
    Ok(json(&worked(&all, move |_| divide.by(size)).await?))
}

/// The file of the surface to start with.
async fn start_file(State(all): State<Arc<All>>) -> Response {
    ([(header::CONTENT_TYPE, "application/octet-stream")], all.setup.surface.clone())
        .into_response()
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
            let callback = Progress::while_it(|| !stops());
            let progress = Progress::new(&callback);
            let mut out = |line: &AnswerLine| send(&lines, line);
            let done = turn.work(|| answer(&bytes, &all.setup.known, progress, &mut out));
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

/// The length of edges.
#[derive(Deserialize)]
struct Length {
    size: f64,
}

/// A route whose query and body are worked on, and whose answer `respond` makes of the result.
fn worked_on<Q, T>(
    work: impl Fn(&Q, &[u8], &KnownFiles, Progress<'_>) -> Result<T, String>
    + Copy
    + Send
    + Sync
    + 'static,
    respond: fn(T) -> Response,
) -> MethodRouter<Arc<All>>
where
    Q: DeserializeOwned + Send + 'static,
    T: Send + 'static,
{
    post(async move |State(all): State<Arc<All>>, Asked(asked): Asked<Q>, Sent(bytes): Sent| {
        let work = move |bytes: &[u8], known: &KnownFiles, progress: Progress<'_>| {
            work(&asked, bytes, known, progress)
        };
        answered(all, bytes, work).await.map(respond)
    })
}

/// A file of a mesh.
fn saved(
    Wanted { format, file, view }: &Wanted,
    body: &[u8],
    _: &KnownFiles,
    progress: Progress<'_>,
) -> Result<Download, String> {
    download(body, *view, format, *file, progress)
}

fn told(answer: impl Serialize) -> Response {
    json(&answer)
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
