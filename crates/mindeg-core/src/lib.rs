//! The triangulation of a convex polygon from its boundary points alone, with the least
//! possible maximum degree, as a formula.
//!
//! A mesh generator often knows only how many intervals each side of a domain gets. From these
//! counts this crate gives a triangulation that uses no other points, in which the busiest
//! vertex has as few edges as any triangulation can have, and says why it cannot be fewer. The
//! mathematics is that of C.-L. Liu, "Minimum degree triangulation for rectangular domains"
//! (2005), carried over from rectangles to every convex polygon.
//!
//! ```
//! use mindeg_core::{Boundary, least_degree_triangulation};
//!
//! let boundary = Boundary::new(&[3, 3, 2, 2])?;
//! let triangulation = least_degree_triangulation(&boundary);
//! assert_eq!(triangulation.max_degree(), 4);
//! for [a, b, c] in triangulation.triangles() {
//!     println!("{a} {b} {c}");
//! }
//! # Ok::<(), mindeg_core::BoundaryError>(())
//! ```
//!
//! A triangulation is one [`Strip`] between two [`Chain`]s, in the order that a [`Word`] spells,
//! or two strips that share an edge. It is found in O(k) time for k sides, whatever the number
//! of intervals, and any triangle or degree follows in O(1).
//!
//! # What is here
//!
//! - [`least_degree_triangulation`] builds one optimal triangulation, [`Candidates`] all that the
//!   constructions allow.
//! - [`certificate`] says what the optimum is and why it cannot be less, [`bound`] has the
//!   statements behind it, and [`suggest`] what to change for a lower one.
//! - [`verify`] checks triangles from whatever source, and [`exact`] finds the optimum by search:
//!   both know nothing of the constructions.
//!
//! # Numbers
//!
//! Vertices are plain `u32`, `0..n` counter-clockwise from the corner where the first side
//! starts, as index buffers hold them; a triangle is a counter-clockwise `[u32; 3]`. Sides are
//! `usize` indices from 0. Interval counts come in as `u64`, so that a count that is too large
//! is refused here and not cut off before.
//!
//! # Limits
//!
//! Convex polygons only, at most [`MAX_VERTICES`] boundary vertices, and no positions: how the
//! triangles look is up to the geometry they are placed on. A small degree does not by itself
//! make good angles.
#![no_std]

extern crate alloc;

pub mod bound;
mod boundary;
mod candidates;
mod certificate;
mod construction;
mod cut;
pub mod exact;
mod least_degree;
mod ring;
mod strip;
mod suggest;
mod triangles;
mod triangulation;
mod verify;
mod word;

pub use boundary::{Boundary, BoundaryError, MAX_VERTICES};
pub use candidates::Candidates;
pub use certificate::{Certificate, CertificateError, certificate, least_max_degree};
pub use cut::{Cut, best_cuts, least_imbalance};
pub use least_degree::least_degree_triangulation;
pub use strip::{Chain, End, Strip};
pub use suggest::{Change, Suggestion, suggest, suggestions};
pub use triangles::Triangles;
pub use triangulation::{Neighbors, Triangulation};
pub use verify::{Defect, Verified, verify};
pub use word::{Letter, Word};
