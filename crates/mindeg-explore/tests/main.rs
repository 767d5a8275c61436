//! What the crate offers, tested as its users see it. One program: each more takes a link, and a core idles at its end.

#![expect(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod answers;
mod sockets;
