//! What the crate offers, tested as its users see it. One program: each more takes a link, and a core idles at its end.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod elements;
mod faults;
mod independent_readers;
mod inspection_outline;
mod known_before;
mod many_formats;
mod materials;
mod names;
mod page;
mod polygons;
mod read_gltf;
mod read_obj;
mod round_trip;
mod solver_formats;
mod writers;
