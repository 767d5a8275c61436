//! The C interface of mindeg: arrays of points go in, a mesh comes out, in one opaque handle.
//!
//! `mindeg.h` beside this crate is its manual. Programs in C, C++, Fortran, Julia and others link the shared library
//! `mindeg_c`; programs in Rust take the crate `mindeg` itself.
//!
//! ```
//! use mindeg_c::{MindegMesh, mindeg_error, mindeg_max_degree, mindeg_triangle_count};
//!
//! let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
//! let mesh = MindegMesh::of_rings(vec![square.to_vec()], None);
//! assert!(mindeg_error(Some(&mesh)).is_null());
//! assert_eq!(mindeg_triangle_count(Some(&mesh)), 2);
//! assert_eq!(mindeg_max_degree(Some(&mesh)), 3);
//! ```
//!
//! # Limits
//!
//! One polygon with its holes, or one domain, in the plane. Work can neither be watched nor cancelled. A panic, which
//! would be a fault of mindeg, becomes an error with its message on standard error; memory that runs out ends the program.

mod exported;
mod handle;
mod wanted;

pub use exported::*;
pub use handle::MindegMesh;
