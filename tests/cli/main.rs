//! What a user does, through the real binary.

mod degree;
mod mesh;
mod run;
mod suggest;
