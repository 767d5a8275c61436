//! What the page wants kept, so that its address brings it back while the process runs.

use std::sync::{Mutex, PoisonError};

use axum::body::Bytes;

/// The most states; the one that was kept longest ago goes first.
const MOST: usize = 32;

/// Kept texts by their IDs.
#[derive(Default)]
pub(crate) struct States(Mutex<Vec<(String, Bytes)>>);

impl States {
    pub(crate) fn put(&self, id: String, state: Bytes) {
        let mut states = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        states.retain(|(other, _)| *other != id);
        if states.len() >= MOST {
            states.remove(0);
        }
        states.push((id, state));
    }

    pub(crate) fn get(&self, id: &str) -> Option<Bytes> {
        let states = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        states.iter().find(|(other, _)| other == id).map(|(_, state)| state.clone())
    }
}
