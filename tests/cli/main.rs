//! The actions of a user, through the real binary.

mod bridge;
mod compare;
mod condition;
mod convert;
mod degree;
#[cfg(target_os = "linux")]
mod determinism;
#[cfg(unix)]
mod documents;
mod domain;
mod explore;
#[cfg(unix)]
mod files;
mod fill;
#[cfg(target_os = "linux")]
mod hostile_files;
mod improve;
mod inspect;
mod interior;
#[cfg(unix)]
mod interrupts;
#[cfg(unix)]
mod limits;
mod maps;
#[cfg(target_os = "linux")]
mod memory;
mod mesh;
#[cfg(unix)]
mod mesh_files;
mod mistakes;
mod models;
mod names;
mod numbers;
mod ocean;
mod outlines;
#[cfg(unix)]
mod outputs_that_are_inputs;
mod periodic;
#[path = "../pinned.rs"]
mod pinned;
mod polygons;
#[cfg(target_os = "linux")]
mod progress;
mod recipe;
#[cfg(target_os = "linux")]
mod refused_outputs;
mod remesh;
mod run;
mod slips;
mod stitch;
mod suggest;
mod terminal;
mod tradeoff;
mod unused;
mod verify;
mod view;
