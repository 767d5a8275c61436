//! What a user does, through the real binary.

mod compare;
mod degree;
mod inspect;
mod mesh;
mod run;
mod suggest;
mod tradeoff;
