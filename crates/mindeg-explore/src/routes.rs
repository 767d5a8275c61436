//! The routes: each address and its answer.

use std::convert::Infallible;
use std::future::poll_fn;
use std::ops::ControlFlow;
use std::pin::Pin;
use std::sync::Arc;
use std::task::{Context, Poll};
use std::time::Duration;

use axum::body::{Body, Bytes, HttpBody};
use axum::extract::rejection::QueryRejection;
use axum::extract::{Path, Query, Request, State};
use axum::http::StatusCode;
use axum::http::header::{self, HeaderName, HeaderValue};
use axum::middleware::{Next, from_fn_with_state};
use axum::response::{IntoResponse, Response};
use axum::routing::{get, post};
use axum::{Extension, Router};
use http_body::Frame;
use mindeg_files::{Input, Session};
use mindeg_mesh::{Progress, Step};
use rayon::ThreadPoolBuildError;
use serde::{Deserialize, Serialize};
use tokio::sync::mpsc;

use crate::answer::{self, answer};
use crate::api::{AnswerLine, Source, View};
use crate::command::KnownFiles;
use crate::download::download;
use crate::facts::facts;
use crate::files::{self, File};
use crate::guard::{Guard, HasToken};
use crate::presets::presets;
use crate::reading::sources;
use crate::states::States;
use crate::work::{TIME_LIMIT, Work, Works};

/// The most bytes of a body.
pub(crate) const MAX_BYTES: usize = 8 << 20;

/// How long the rest of a body that is too large is taken in.
const DRAIN_TIME: Duration = Duration::from_secs(2);

/// How long the body of a request may take to come.
const BODY_TIME: Duration = Duration::from_secs(30);

const POLICY: &str = "default-src 'none'; script-src 'self'; style-src 'self'; \
                      img-src 'self' data: blob:; connect-src 'self'; frame-ancestors 'none'; \
                      base-uri 'none'; form-action 'none'";

/// The state that requests are answered from.
pub(crate) struct All {
    guard: Guard,
    start: Option<Source>,
    known: KnownFiles,
    works: Works,
    states: States,
}

impl All {
    pub(crate) fn new(
        guard: Guard,
        start: Option<Source>,
        known: KnownFiles,
    ) -> Result<Self, ThreadPoolBuildError> {
        Ok(Self { guard, start, known, works: Works::new()?, states: States::default() })
    }

    /// The token that requests must have.
    pub(crate) fn token(&self) -> &str {
        &self.guard.token
    }
}

pub(crate) fn router(all: Arc<All>) -> Router {
    Router::new()
        .route("/", get(async || page(files::INDEX)))
        .route("/page/{name}", get(page_file))
        .route("/api/start", get(start))
        .route("/api/presets", get(async || json(&presets())))
        .route("/api/facts", get(async || json(&facts(MAX_BYTES))))
        .route("/api/answer", post(answers))
        .route("/api/read", post(reading))
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

/// A request that is refused.
struct Refusal {
    status: StatusCode,
    message: String,
}

impl IntoResponse for Refusal {
    fn into_response(self) -> Response {
        #[derive(Serialize)]
        struct Refused {
            message: String,
        }
        let mut response = json(&Refused { message: self.message });
        *response.status_mut() = self.status;
        response
    }
}

/// A request that is refused, with the sentence to show.
fn refused(status: StatusCode, message: &str) -> Refusal {
    Refusal { status, message: message.to_owned() }
}

fn json(value: &impl Serialize) -> Response {
    match serde_json::to_vec(value) {
        Ok(text) => ([(header::CONTENT_TYPE, "application/json")], text).into_response(),
        Err(error) => (StatusCode::INTERNAL_SERVER_ERROR, error.to_string()).into_response(),
    }
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

/// The whole body, if it is small enough and comes soon enough.
async fn body(request: Request) -> Result<Bytes, Refusal> {
    let mut body = request.into_body();
    let mut bytes = Vec::new();
    let mut is_large = body.size_hint().lower() > MAX_BYTES as u64;
    let read = async {
        while !is_large && let Some(data) = next(&mut body).await? {
            bytes.extend_from_slice(&data);
            is_large = bytes.len() > MAX_BYTES;
        }
        Ok::<(), axum::Error>(())
    };
    match tokio::time::timeout(BODY_TIME, read).await {
        Ok(Ok(())) if !is_large => Ok(bytes.into()),
        Ok(Ok(())) => {
            // Who still sends does not read the answer: so some of the rest is taken in.
            let _ = tokio::time::timeout(DRAIN_TIME, drained(&mut body)).await;
            Err(refused(
                StatusCode::PAYLOAD_TOO_LARGE,
                "the request is larger than 8 MB; the command line takes larger domains",
            ))
        }
        Ok(Err(_)) => Err(refused(StatusCode::BAD_REQUEST, "the request is cut off")),
        Err(_) => {
            Err(refused(StatusCode::REQUEST_TIMEOUT, "the request took more than 30 s to come"))
        }
    }
}

/// The next bytes of a body.
async fn next(body: &mut Body) -> Result<Option<Bytes>, axum::Error> {
    loop {
        match poll_fn(|context| Pin::new(&mut *body).poll_frame(context)).await.transpose()? {
            None => return Ok(None),
            Some(frame) => {
                if let Ok(data) = frame.into_data() {
                    return Ok(Some(data));
                }
            }
        }
    }
}

/// Reads on, up to eight times as much as a body may have.
async fn drained(body: &mut Body) {
    let mut left = 8 * MAX_BYTES;
    while let Ok(Some(data)) = next(body).await
        && let Some(less) = left.checked_sub(data.len())
    {
        left = less;
    }
}

/// The query after `?` in an address, if it is valid.
type Asked<T> = Result<Query<T>, QueryRejection>;

fn asked<T>(query: Asked<T>) -> Result<T, Refusal> {
    query.map(|Query(asked)| asked).map_err(|error| bad_request(&error.body_text()))
}

fn bad_request(message: &str) -> Refusal {
    refused(StatusCode::BAD_REQUEST, message)
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
    query: Asked<Tab>,
    request: Request,
) -> Result<Response, Refusal> {
    let Tab { tab } = asked(query)?;
    if !is_name(&tab) {
        return Err(bad_request("tab takes up to 64 letters, digits, - and _"));
    }
    let work = all.works.start(&tab);
    let bytes = body(request).await?;
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

/// A body of lines as they come.
struct Lines(mpsc::UnboundedReceiver<Bytes>);

impl HttpBody for Lines {
    type Data = Bytes;
    type Error = Infallible;

    fn poll_frame(
        mut self: Pin<&mut Self>,
        context: &mut Context<'_>,
    ) -> Poll<Option<Result<Frame<Bytes>, Infallible>>> {
        self.0.poll_recv(context).map(|line| line.map(|line| Ok(Frame::data(line))))
    }
}

#[derive(Deserialize)]
struct Named {
    name: String,
}

/// The domains in a file.
async fn reading(query: Asked<Named>, request: Request) -> Result<Response, Refusal> {
    let Named { name } = asked(query)?;
    let bytes = body(request).await?;
    let read = tokio::task::spawn_blocking(move || {
        sources(&Session::new(""), &Input::Bytes(&name, &bytes))
    })
    .await;
    match read {
        Ok(Ok(sources)) => Ok(json(&sources)),
        Ok(Err(error)) => Err(refused(StatusCode::UNPROCESSABLE_ENTITY, &error.to_string())),
        Err(_) => Err(failed()),
    }
}

/// The message if a thread ended before its work.
const FAULT: &str = "this failed, which is a fault of mindeg; please report it with the domain";

fn failed() -> Refusal {
    refused(StatusCode::INTERNAL_SERVER_ERROR, FAULT)
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
    query: Asked<Wanted>,
    request: Request,
) -> Result<Response, Refusal> {
    let Wanted { format, file, view } = asked(query)?;
    let bytes = body(request).await?;
    let Some(turn) = all.works.turn().await else { return Err(failed()) };
    let work = Work::alone();
    let made = tokio::task::spawn_blocking(move || {
        let callback = |_: Step<'_>| match work.is_late() {
            true => ControlFlow::Break(()),
            false => ControlFlow::Continue(()),
        };
        let progress = Progress::new(&callback);
        turn.work(|| download(&bytes, view, &format, file, progress))
    });
    match made.await {
        Ok(Ok(file)) => {
            // The name has letters, digits and dashes only.
            let disposition = format!("attachment; filename=\"{}\"", file.name);
            let kind = (header::CONTENT_TYPE, "application/octet-stream".to_owned());
            let disposition = (header::CONTENT_DISPOSITION, disposition);
            Ok(([kind, disposition], file.bytes).into_response())
        }
        Ok(Err(message)) => Err(refused(StatusCode::UNPROCESSABLE_ENTITY, &message)),
        Err(_) => Err(failed()),
    }
}

async fn state(State(all): State<Arc<All>>, Path(id): Path<String>) -> Result<Response, Refusal> {
    let gone = || refused(StatusCode::NOT_FOUND, "this address is of another run, or too old");
    let state = all.states.get(&id).ok_or_else(gone)?;
    Ok(([(header::CONTENT_TYPE, "application/json")], state).into_response())
}

async fn keep_state(
    State(all): State<Arc<All>>,
    Path(id): Path<String>,
    request: Request,
) -> Result<Response, Refusal> {
    if !is_name(&id) {
        return Err(bad_request("a state's ID has up to 64 letters, digits, - and _"));
    }
    let bytes = body(request).await?;
    if serde_json::from_slice::<serde::de::IgnoredAny>(&bytes).is_err() {
        return Err(bad_request("a state is JSON"));
    }
    all.states.put(id, bytes);
    Ok(StatusCode::NO_CONTENT.into_response())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::future::Future;

    fn finished<T>(work: impl Future<Output = T>) -> T {
        let runtime = tokio::runtime::Builder::new_current_thread().enable_time().build();
        runtime.unwrap().block_on(work)
    }

    #[test]
    fn a_body_of_exactly_the_most_bytes_is_taken() {
        for (more, expected) in [(0, Ok(MAX_BYTES)), (1, Err(StatusCode::PAYLOAD_TOO_LARGE))] {
            let request = Request::new(Body::from(vec![b' '; MAX_BYTES + more]));
            let taken = finished(body(request)).map(|bytes| bytes.len());
            assert_eq!(taken.map_err(|refusal| refusal.status), expected);
        }
    }

    #[test]
    fn eight_times_the_most_bytes_are_drained() {
        let (sender, received) = mpsc::unbounded_channel();
        let chunk = Bytes::from(vec![b' '; MAX_BYTES / 4]);
        for _ in 0..40 {
            sender.send(chunk.clone()).unwrap();
        }
        drop(sender);
        let mut body = Body::new(Lines(received));
        let left = finished(async {
            drained(&mut body).await;
            let mut left = 0;
            while let Ok(Some(_)) = next(&mut body).await {
                left += 1;
            }
            left
        });
        // 32 chunks are let through, and the one that is too many is taken before it is seen to be.
        assert_eq!(left, 40 - 33);
    }
}
