//! The states that the page stores, so that its address brings them back while the process runs.

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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_state_that_is_kept_again_leaves_the_others() {
        let states = States::default();
        for id in 0..MOST {
            states.put(id.to_string(), Bytes::from_static(b"old"));
        }
        states.put("1".to_owned(), Bytes::from_static(b"new"));
        for id in 0..MOST {
            let expected = if id == 1 { &b"new"[..] } else { b"old" };
            assert_eq!(states.get(&id.to_string()).as_deref(), Some(expected), "{id}");
        }
        // It is the youngest now: the next ones push out 0 and 2.
        for id in ["a", "b"] {
            states.put(id.to_owned(), Bytes::new());
        }
        let is_kept = ["0", "1", "2", "3"].map(|id| states.get(id).is_some());
        assert_eq!(is_kept, [false, true, false, true]);
    }
}
