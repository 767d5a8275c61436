//! What a user does, through the real binary.

mod compare;
mod degree;
mod domain;
mod inspect;
#[cfg(unix)]
mod interrupts;
#[cfg(unix)]
mod limits;
#[cfg(target_os = "linux")]
mod memory;
mod mesh;
#[cfg(target_os = "linux")]
mod progress;
mod run;
mod suggest;
mod tradeoff;
