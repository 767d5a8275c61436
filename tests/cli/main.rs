//! What a user does, through the real binary.

mod compare;
mod degree;
mod mesh;
mod run;
mod suggest;
mod tradeoff;
