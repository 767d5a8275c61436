//! The bodies of requests, as large and as long as they may be, and of answers that come line by line.

use std::convert::Infallible;
use std::future::poll_fn;
use std::pin::Pin;
use std::task::{Context, Poll};
use std::time::Duration;

use axum::body::{Body, Bytes, HttpBody};
use axum::extract::Request;
use axum::http::StatusCode;
use http_body::Frame;
use tokio::sync::mpsc;

use crate::refusal::{Refusal, refused};

/// The most bytes of a body.
pub const MAX_BYTES: usize = 8 << 20;

/// How long the rest of a body that is too large is taken in.
const DRAIN_TIME: Duration = Duration::from_secs(2);

/// How long the body of a request may take to come.
const BODY_TIME: Duration = Duration::from_secs(30);

/// The whole body, if it is small enough and comes soon enough.
pub(crate) async fn body(request: Request) -> Result<Bytes, Refusal> {
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

/// A body of lines as they come.
pub(crate) struct Lines(pub(crate) mpsc::UnboundedReceiver<Bytes>);

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
