//! What the crate offers, tested as its users see it. One program: each more takes a link, and a core idles at its end.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

mod condition;
mod narrow;

/// No place wants a size of its own.
const ANY: fn(glam::DVec2) -> f64 = |_| f64::INFINITY;
