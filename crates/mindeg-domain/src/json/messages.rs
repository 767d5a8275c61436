//! The whole message of each text that is not read: `messages.txt` has them.

use super::*;

#[path = "../../../../tests/pinned.rs"]
mod pinned;

#[test]
fn pinned_texts_are_answered_with_what_is_wrong_and_where() {
    pinned::check("src/json/messages.txt", |text| {
        Domain::from_json(text).map_or_else(|error| error.to_string(), |_| "read".into())
    });
}
