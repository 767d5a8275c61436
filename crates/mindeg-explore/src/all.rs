//! The state that answers requests, and the work on them in its turn.

use std::sync::Arc;

use axum::body::Bytes;
use axum::http::StatusCode;
use mindeg_mesh::Progress;
use rayon::ThreadPoolBuildError;

use crate::command::KnownFiles;
use crate::guard::Guard;
use crate::refusal::{Refusal, refused};
use crate::setup::Setup;
use crate::states::States;
use crate::terms::without_options;
use crate::work::{Work, Works};

/// The state that requests are answered from.
pub(crate) struct All {
    pub(crate) guard: Guard,
    pub(crate) setup: Setup,
    pub(crate) works: Works,
    pub(crate) states: States,
}

impl All {
    pub(crate) fn new(guard: Guard, setup: Setup) -> Result<Self, ThreadPoolBuildError> {
        Ok(Self { guard, setup, works: Works::new()?, states: States::default() })
    }

    /// The token that requests must have.
    pub(crate) fn token(&self) -> &str {
        &self.guard.token
    }
}

/// The message if a thread ended before its work.
pub(crate) const FAULT: &str =
    "this failed, which is a fault of mindeg; please report it with the domain";

pub(crate) fn failed() -> Refusal {
    refused(StatusCode::INTERNAL_SERVER_ERROR, FAULT)
}

/// Work on the body of a request.
pub(crate) async fn answered<T: Send + 'static>(
    all: Arc<All>,
    bytes: Bytes,
    work: impl FnOnce(&[u8], &KnownFiles, Progress<'_>) -> Result<T, String> + Send + 'static,
) -> Result<T, Refusal> {
    let own = Arc::clone(&all);
    worked(&all, move |progress| work(&bytes, &own.setup.known, progress)).await
}

/// Work that no other request ends, in its turn and with a time limit.
pub(crate) async fn worked<T: Send + 'static>(
    all: &All,
    work: impl FnOnce(Progress<'_>) -> Result<T, String> + Send + 'static,
) -> Result<T, Refusal> {
    let Some(turn) = all.works.turn().await else { return Err(failed()) };
    let alone = Work::alone();
    let made = tokio::task::spawn_blocking(move || {
        let in_time = Progress::while_it(|| !alone.is_late());
        turn.work(|| work(Progress::new(&in_time)))
    });
    match made.await {
        Ok(Ok(made)) => Ok(made),
        Ok(Err(message)) => {
            Err(refused(StatusCode::UNPROCESSABLE_ENTITY, &without_options(&message)))
        }
        Err(_) => Err(failed()),
    }
}
