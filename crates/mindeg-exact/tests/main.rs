//! What the crate offers, tested as its users see it. One program: each more takes a link, and a core idles at its end.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod answers;
mod bridge;
mod cover;
mod domains;
mod exact;
mod fill;
mod joint;
mod outlines;
mod plain;
mod polygons;
mod turned;
