//! What the crate offers, tested as its users see it. One program: each more takes a link, and a core idles at its end.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod changes;
mod example_domains;
mod goals;
mod interior;
mod loops;
mod map_degrees;
mod maps;
mod models;
#[path = "../../mindeg-exact/tests/outlines/mod.rs"]
mod outlines;
mod polygons;
mod progress;
mod properties;
mod remesh;
mod repair;
mod solids;
mod stars;
mod threads;
mod turned;
mod verify;
mod verify_surface;
