//! What a user does, through the real binary.

mod compare;
mod degree;
mod inspect;
#[cfg(target_os = "linux")]
mod memory;
mod mesh;
mod run;
mod suggest;
mod tradeoff;
