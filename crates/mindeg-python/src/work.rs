//! Long work: without the interpreter's lock, cancelled by Ctrl-C or by who follows its progress.

use std::fmt::Display;
use std::ops::ControlFlow;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

use mindeg::{Progress, Step};
use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;

/// How often Python is asked for a signal, and told of the progress.
const BETWEEN_SIGNALS: Duration = Duration::from_millis(50);

/// Does work on a thread of its own while this one looks for signals: Python handles them on its
/// main thread only. A signal whose handler raises, as Ctrl-C's does, cancels the work; so does what the callback of
/// `mindeg.progress` raises, which this thread calls.
pub(crate) fn done<T: Send, E: Display + Send>(
    py: Python<'_>,
    work: impl FnOnce(Progress<'_>) -> Result<T, E> + Send,
) -> PyResult<T> {
    let callback = py.import("mindeg._progress")?.getattr("callback")?.call_method0("get")?;
    let callback = (!callback.is_none()).then(|| callback.unbind());
    let latest = Mutex::new(None);
    let is_cancelled = AtomicBool::new(false);
    let go_on = |step: Step<'_>| {
        if callback.is_some()
            && let Ok(mut latest) = latest.try_lock()
        {
            *latest = Some((step.stage.to_owned(), step.done, step.total));
        }
        if is_cancelled.load(Relaxed) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    py.detach(|| {
        thread::scope(|scope| {
            let (sender, receiver) = channel();
            let go_on = &go_on;
            scope.spawn(move || {
                // Nobody listens only if this thread has panicked.
                let _ = sender.send(work(Progress::new(go_on)));
            });
            let mut raised = None;
            loop {
                match receiver.recv_timeout(BETWEEN_SIGNALS) {
                    Ok(_) if raised.is_some() => break,
                    Ok(outcome) => return outcome.map_err(value_error),
                    Err(RecvTimeoutError::Disconnected) => break,
                    Err(RecvTimeoutError::Timeout) if raised.is_none() => {
                        let step = latest.lock().ok().and_then(|mut latest| latest.take());
                        let told = |py: Python<'_>| {
                            py.check_signals()?;
                            if let (Some(callback), Some(step)) = (&callback, step) {
                                callback.call1(py, step)?;
                            }
                            Ok::<_, PyErr>(())
                        };
                        raised = Python::attach(told).err();
                        is_cancelled.store(raised.is_some(), Relaxed);
                    }
                    Err(RecvTimeoutError::Timeout) => {}
                }
            }
            Err(raised
                .unwrap_or_else(|| PyRuntimeError::new_err("the work ended without a result")))
        })
    })
}

/// A `ValueError` with the words of an error.
pub(crate) fn value_error(error: impl Display) -> PyErr {
    PyValueError::new_err(error.to_string())
}
