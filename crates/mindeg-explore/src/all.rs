//! The state that answers requests, and the work on them in its turn.

use std::ops::ControlFlow;
use std::sync::Arc;

use axum::body::Bytes;
use axum::http::StatusCode;
use mindeg_answers::advice::Purpose;
use mindeg_mesh::{Progress, Step};
use rayon::ThreadPoolBuildError;

use crate::api::Source;
use crate::command::KnownFiles;
use crate::guard::Guard;
use crate::refusal::{Refusal, refused};
use crate::setup::{Divide, Setup};
use crate::states::States;
use crate::terms::without_options;
use crate::work::{Work, Works};

/// The state that requests are answered from.
pub(crate) struct All {
    pub(crate) guard: Guard,
    pub(crate) start: Option<Source>,
    pub(crate) choices: Vec<Source>,
    pub(crate) divide: Option<Divide>,
    pub(crate) surface: Bytes,
    pub(crate) known: KnownFiles,
    pub(crate) purpose: Option<Purpose>,
    pub(crate) works: Works,
    pub(crate) states: States,
}

impl All {
    pub(crate) fn new(guard: Guard, setup: Setup) -> Result<Self, ThreadPoolBuildError> {
        let Setup { start, choices, divide, surface, known, purpose, port: _ } = setup;
        let (surface, works, states) = (surface.into(), Works::new()?, States::default());
        Ok(Self { guard, start, choices, divide, surface, known, purpose, works, states })
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
    worked(&all, move |progress| work(&bytes, &own.known, progress)).await
}

/// Work that no other request ends, in its turn and with a time limit.
pub(crate) async fn worked<T: Send + 'static>(
    all: &All,
    work: impl FnOnce(Progress<'_>) -> Result<T, String> + Send + 'static,
) -> Result<T, Refusal> {
    let Some(turn) = all.works.turn().await else { return Err(failed()) };
    let alone = Work::alone();
    let made = tokio::task::spawn_blocking(move || {
        let callback = |_: Step<'_>| match alone.is_late() {
            true => ControlFlow::Break(()),
            false => ControlFlow::Continue(()),
        };
        let progress = Progress::new(&callback);
        turn.work(|| work(progress))
    });
    match made.await {
        Ok(Ok(made)) => Ok(made),
        Ok(Err(message)) => {
            Err(refused(StatusCode::UNPROCESSABLE_ENTITY, &without_options(&message)))
        }
        Err(_) => Err(failed()),
    }
}
