//! The page, its files and the answers on a loopback address.

use std::convert::Infallible;
use std::io;
use std::net::{Ipv4Addr, SocketAddr};
use std::ops::ControlFlow;
use std::pin::Pin;
use std::sync::Arc;
use std::task::{Context, Poll};
use std::time::Duration;

use axum::Router;
use axum::body::{Body, Bytes, HttpBody};
use axum::extract::{Path, Query, Request, State};
use axum::http::StatusCode;
use axum::http::header::{self, HeaderName, HeaderValue};
use axum::middleware::{Next, from_fn_with_state};
use axum::response::{IntoResponse, Response};
use axum::routing::{get, post};
use http_body::Frame;
use hyper::server::conn::http1;
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::service::TowerToHyperService;
use mindeg_mesh::{Progress, Step};
use serde::{Deserialize, Serialize};
use tokio::net::TcpListener;
use tokio::sync::{Semaphore, mpsc};

use crate::answer::{self, answer};
use crate::api::{Line, Source};
use crate::files::{self, File};
use crate::guard::Guard;
use crate::presets::presets;
use crate::token::token;
use crate::work::{TIME_LIMIT, Works};

/// The most bytes of a body.
pub(crate) const MAX_BYTES: usize = 8 << 20;

/// The most connections at once; further ones wait.
const MOST_CONNECTIONS: usize = 64;

/// How long the head of a request may take to come.
const HEAD_TIME: Duration = Duration::from_secs(10);

/// How long the body of a request may take to come.
const BODY_TIME: Duration = Duration::from_secs(30);

/// The stack of a thread that works on an answer, as large as that of a main thread.
const STACK: usize = 8 << 20;

const POLICY: &str = "default-src 'none'; script-src 'self'; style-src 'self'; \
                      img-src 'self' data: blob:; connect-src 'self'; frame-ancestors 'none'; \
                      base-uri 'none'; form-action 'none'";

/// What a server starts with.
#[derive(Clone, Debug, Default)]
pub struct Setup {
    /// The port; 0 for any that is free.
    pub port: u16,
    /// The domain to show first.
    pub start: Option<Source>,
}

/// Why a server does not start, or ends.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ServerError {
    /// The port is taken, or not ours to take.
    #[error("cannot listen on port {port}: {error}")]
    Listen {
        /// The port.
        port: u16,
        /// What the system says.
        error: io::Error,
    },
    /// The system gives no random numbers.
    #[error("the system gives no random numbers for a token: {0}")]
    Random(#[from] getrandom::Error),
    /// The connections can no longer be waited for.
    #[error("cannot wait for connections: {0}")]
    Wait(#[from] io::Error),
}

/// A server that listens on 127.0.0.1.
pub struct Server {
    runtime: tokio::runtime::Runtime,
    listener: TcpListener,
    address: SocketAddr,
    all: Arc<All>,
}

/// What requests are answered from.
struct All {
    guard: Guard,
    setup: Setup,
    works: Works,
}

impl Server {
    /// Listens; [`run`](Self::run) answers.
    ///
    /// # Errors
    ///
    /// A port that is taken, and a system without random numbers.
    pub fn new(setup: Setup) -> Result<Self, ServerError> {
        let port = setup.port;
        let runtime = tokio::runtime::Builder::new_current_thread()
            .enable_all()
            .thread_stack_size(STACK)
            .build()?;
        let bound = runtime.block_on(TcpListener::bind((Ipv4Addr::LOCALHOST, port)));
        let listener = bound.map_err(|error| ServerError::Listen { port, error })?;
        let address = listener.local_addr()?;
        let guard = Guard { port: address.port(), token: token()? };
        let all = Arc::new(All { guard, setup, works: Works::new() });
        Ok(Self { runtime, listener, address, all })
    }

    /// The address to open, with the token.
    #[must_use]
    pub fn address(&self) -> String {
        format!("http://{}/#{}", self.address, self.all.guard.token)
    }

    /// Answers until the process ends.
    ///
    /// # Errors
    ///
    /// Connections that can no longer be waited for.
    pub fn run(self) -> Result<Infallible, ServerError> {
        let Self { runtime, listener, all, .. } = self;
        runtime.block_on(serve(listener, router(all)))
    }
}

async fn serve(listener: TcpListener, router: Router) -> Result<Infallible, ServerError> {
    let connections = Arc::new(Semaphore::new(MOST_CONNECTIONS));
    let service = TowerToHyperService::new(router);
    loop {
        let permit = Arc::clone(&connections).acquire_owned().await;
        let stream = match listener.accept().await {
            Ok((stream, _)) => stream,
            // Of one connection, or of too many open files: others may come later.
            Err(_) => {
                tokio::time::sleep(Duration::from_millis(50)).await;
                continue;
            }
        };
        let service = service.clone();
        tokio::spawn(async move {
            let _permit = permit;
            let _ = stream.set_nodelay(true);
            let connection = http1::Builder::new()
                .timer(TokioTimer::new())
                .header_read_timeout(HEAD_TIME)
                .serve_connection(TokioIo::new(stream), service);
            // Who closes a connection early has no use for an error.
            let _ = connection.await;
        });
    }
}

fn router(all: Arc<All>) -> Router {
    Router::new()
        .route("/", get(async || page(files::INDEX)))
        .route("/page/{name}", get(page_file))
        .route("/api/start", get(start))
        .route("/api/presets", get(async || json(&presets())))
        .route("/api/answer", post(answers))
        .fallback(async || refused(StatusCode::NOT_FOUND, "there is nothing at this address"))
        .layer(from_fn_with_state(Arc::clone(&all), guarded))
        .with_state(all)
}

/// Checks who asks, and tells the browser to keep others out.
async fn guarded(State(all): State<Arc<All>>, request: Request, next: Next) -> Response {
    let needs_token = request.uri().path().starts_with("/api/");
    let checked = all.guard.check(request.method(), request.headers(), needs_token);
    let mut response = match checked {
        Ok(()) => next.run(request).await,
        Err((status, message)) => refused(status, message),
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

/// A request that is refused, with the sentence to show.
fn refused(status: StatusCode, message: &str) -> Response {
    #[derive(Serialize)]
    struct Refused<'a> {
        message: &'a str,
    }
    let mut response = json(&Refused { message });
    *response.status_mut() = status;
    response
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

async fn page_file(Path(name): Path<String>) -> Response {
    match files::named(&name) {
        Some(file) => page(file),
        None => refused(StatusCode::NOT_FOUND, "the page has no such file"),
    }
}

async fn start(State(all): State<Arc<All>>) -> Response {
    json(&all.setup.start.clone().or_else(|| presets().into_iter().next()))
}

/// The whole body, if it is small enough and comes soon enough.
async fn body(request: Request) -> Result<Bytes, Response> {
    let read = axum::body::to_bytes(request.into_body(), MAX_BYTES);
    match tokio::time::timeout(BODY_TIME, read).await {
        Ok(Ok(bytes)) => Ok(bytes),
        Ok(Err(_)) => Err(refused(
            StatusCode::PAYLOAD_TOO_LARGE,
            "the request is cut off or larger than 8 MB; the command line takes larger domains",
        )),
        Err(_) => {
            Err(refused(StatusCode::REQUEST_TIMEOUT, "the request took more than 30 s to come"))
        }
    }
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
    Query(Tab { tab }): Query<Tab>,
    request: Request,
) -> Response {
    if !is_name(&tab) {
        return refused(StatusCode::BAD_REQUEST, "tab takes up to 64 letters, digits, - and _");
    }
    let work = all.works.start(&tab);
    let bytes = match body(request).await {
        Ok(bytes) => bytes,
        Err(refusal) => return refusal,
    };
    let (lines, received) = mpsc::unbounded_channel::<Bytes>();
    tokio::spawn(async move {
        let Some(turn) = all.works.turn().await else { return };
        tokio::task::spawn_blocking(move || {
            let _turn = turn;
            let stops = || work.is_over() || lines.is_closed() || work.is_late();
            let callback = |_: Step<'_>| match stops() {
                true => ControlFlow::Break(()),
                false => ControlFlow::Continue(()),
            };
            let mut send = |line: &Line| {
                if let Ok(mut text) = serde_json::to_vec(line) {
                    text.push(b'\n');
                    // Nobody reads on: the next step of the work ends it.
                    let _ = lines.send(text.into());
                }
            };
            let done = answer(&bytes, Progress::new(&callback), &mut send);
            if done.is_err() && work.is_late() {
                send(&answer::late(TIME_LIMIT));
            }
        });
    });
    let kind = [(header::CONTENT_TYPE, "application/x-ndjson")];
    (kind, Body::new(Lines(received))).into_response()
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
