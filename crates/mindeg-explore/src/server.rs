//! The page, its files and the answers on a loopback address.

use std::convert::Infallible;
use std::io;
use std::net::{Ipv4Addr, SocketAddr};
use std::sync::Arc;
use std::time::Duration;

use axum::Router;
use hyper::server::conn::http1;
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::service::TowerToHyperService;
use tokio::net::TcpListener;
use tokio::sync::Semaphore;

use crate::api::Source;
use crate::command::KnownFiles;
use crate::guard::Guard;
use crate::routes::{All, router};
use crate::token::token;

/// The most connections at once; further ones wait.
const MOST_CONNECTIONS: usize = 64;

/// How long the head of a request may take to come.
const HEAD_TIME: Duration = Duration::from_secs(10);

/// What a server starts with.
#[derive(Clone, Debug, Default)]
pub struct Setup {
    /// The port; 0 for any that is free.
    pub port: u16,
    /// The domain to show first; the first preset otherwise.
    pub start: Option<Source>,
    /// Files that the page's commands may name.
    pub known: KnownFiles,
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
    /// The threads that work on answers do not start.
    #[error("cannot start threads: {0}")]
    Threads(#[from] rayon::ThreadPoolBuildError),
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

impl Server {
    /// Listens; [`run`](Self::run) answers.
    ///
    /// # Errors
    ///
    /// A port that is taken, and a system without random numbers or threads.
    pub fn new(setup: Setup) -> Result<Self, ServerError> {
        let port = setup.port;
        let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build()?;
        let bound = runtime.block_on(TcpListener::bind((Ipv4Addr::LOCALHOST, port)));
        let listener = bound.map_err(|error| ServerError::Listen { port, error })?;
        let address = listener.local_addr()?;
        let guard = Guard { port: address.port(), token: token()? };
        let all = Arc::new(All::new(guard, setup.start, setup.known)?);
        Ok(Self { runtime, listener, address, all })
    }

    /// The address to open, with the token.
    #[must_use]
    pub fn address(&self) -> String {
        format!("http://{}/#{}", self.address, self.all.token())
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
