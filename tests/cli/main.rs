//! What a user does, through the real binary.

mod compare;
mod degree;
mod inspect;
#[cfg(target_os = "linux")]
mod memory;
#[cfg(unix)]
mod interrupts;
#[cfg(unix)]
mod limits;
mod mesh;
#[cfg(target_os = "linux")]
mod progress;
mod run;
mod suggest;
mod tradeoff;
