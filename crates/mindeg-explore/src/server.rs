//! The page, its files and the answers on a loopback address.

use std::convert::Infallible;
use std::io;
use std::net::{Ipv4Addr, SocketAddr};
use std::pin::pin;
use std::sync::Arc;
use std::time::Duration;

use axum::{Extension, Router};
use hyper::server::conn::http1;
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::service::TowerToHyperService;
use tokio::net::TcpListener;
use tokio::sync::Semaphore;
use tokio::time::timeout;

use crate::all::All;
use crate::guard::{Guard, HasToken};
use crate::routes::router;
use crate::setup::Setup;
use crate::token::token;

/// The most connections at once; further ones wait.
const MOST_CONNECTIONS: usize = 64;

/// How long connections may last, so that nobody who does not send, or does not read, keeps others waiting
/// for theirs: at the end of its time a connection takes no further request, and as long again later it is closed.
#[derive(Clone, Copy, Debug)]
struct Times {
    /// The time of a connection without a token: for the head of a request, or for the page's files, which are small.
    stranger: Duration,
    /// The time of any other connection: longer than any answer takes.
    page: Duration,
}

const TIMES: Times = Times { stranger: Duration::from_secs(5), page: Duration::from_secs(300) };

/// Why a server does not start, or ends.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ServerError {
    /// The port is taken, or not ours to take.
    #[error("cannot listen on port {port}: {error}")]
    Listen {
        /// The port.
        port: u16,
        /// The error of the system.
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
        let all = Arc::new(All::new(guard, setup)?);
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
        runtime.block_on(serve(listener, router(all), TIMES))
    }
}

async fn serve(
    listener: TcpListener,
    router: Router,
    times: Times,
) -> Result<Infallible, ServerError> {
    let connections = Arc::new(Semaphore::new(MOST_CONNECTIONS));
    loop {
        let permit = Arc::clone(&connections).acquire_owned().await;
        let stream = match listener.accept().await {
            Ok((stream, _)) => stream,
            // One connection failed, or too many files are open: other connections may come later.
            Err(_) => {
                tokio::time::sleep(Duration::from_millis(50)).await;
                continue;
            }
        };
        let router = router.clone();
        tokio::spawn(async move {
            let _permit = permit;
            let _ = stream.set_nodelay(true);
            let has_token = HasToken::default();
            let service = TowerToHyperService::new(router.layer(Extension(has_token.clone())));
            let connection = http1::Builder::new()
                .timer(TokioTimer::new())
                .header_read_timeout(2 * times.stranger)
                .serve_connection(TokioIo::new(stream), service);
            // Who closes a connection early has no use for an error.
            let mut connection = pin!(connection);
            let mut last = times.stranger;
            let mut is_over = timeout(last, connection.as_mut()).await.is_ok();
            if !is_over && has_token.is_shown() {
                last = times.page;
                is_over = timeout(last, connection.as_mut()).await.is_ok();
            }
            if !is_over {
                connection.as_mut().graceful_shutdown();
                let _ = timeout(last, connection).await;
            }
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use axum::routing::get;
    use std::io::{Read, Write};
    use std::net::TcpStream;
    use std::thread::{sleep, spawn};
    use std::time::Instant;

    /// A server of more bytes than sockets hold, at `/` without the token and at `/api` with it.
    fn served(times: Times) -> SocketAddr {
        let (sender, receiver) = std::sync::mpsc::channel();
        spawn(move || {
            let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build()?;
            runtime.block_on(async {
                let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, 0)).await?;
                sender.send(listener.local_addr()?).unwrap();
                let shown = async |Extension(token): Extension<HasToken>| {
                    token.show();
                    vec![b' '; 8 << 20]
                };
                let router = Router::new().route("/", get(async || vec![b' '; 8 << 20]));
                serve(listener, router.route("/api", get(shown)), times).await
            })
        });
        receiver.recv().unwrap()
    }

    fn asked(address: SocketAddr, path: &str) -> TcpStream {
        let mut stream = TcpStream::connect(address).unwrap();
        stream.set_read_timeout(Some(Duration::from_secs(60))).unwrap();
        write!(stream, "GET {path} HTTP/1.1\r\nHost: x\r\n\r\n").unwrap();
        stream
    }

    /// Whether all of the answer comes.
    fn is_whole(stream: &mut TcpStream) -> bool {
        let mut answer = vec![0; 8 << 20];
        stream.read_exact(&mut answer).is_ok()
    }

    const SHORT: Duration = Duration::from_millis(300);

    #[test]
    fn readers_that_read_nothing_keep_nobody_out() {
        let address = served(Times { stranger: SHORT, page: SHORT });
        for path in ["/", "/api"] {
            let held: Vec<_> = (0..MOST_CONNECTIONS).map(|_| asked(address, path)).collect();
            assert!(is_whole(&mut asked(address, "/")), "{path}");
            drop(held);
        }
    }

    #[test]
    fn a_head_that_never_ends_is_given_up() {
        let address = served(Times { stranger: SHORT, page: Duration::from_secs(600) });
        let mut stream = TcpStream::connect(address).unwrap();
        stream.set_read_timeout(Some(Duration::from_secs(60))).unwrap();
        stream.write_all(b"GET / HTTP/1.1\r\nHost:").unwrap();
        let mut answer = String::new();
        stream.read_to_string(&mut answer).unwrap();
        assert!(answer.is_empty() || answer.starts_with("HTTP/1.1 408"), "{answer}");
    }

    #[test]
    fn a_reader_of_a_byte_at_a_time_is_closed() {
        let address = served(Times { stranger: SHORT, page: Duration::from_secs(600) });
        let mut slow = asked(address, "/");
        let start = Instant::now();
        // The bytes in the sockets' buffers still come, and then the end.
        while slow.read(&mut [0]).is_ok_and(|count| count > 0) && start.elapsed() < 3 * SHORT {
            sleep(Duration::from_millis(20));
        }
        assert!(!is_whole(&mut slow));
        let mut with_token = asked(address, "/api");
        sleep(3 * SHORT);
        assert!(is_whole(&mut with_token));
    }
}
