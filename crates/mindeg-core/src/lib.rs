//! Triangulations of convex polygons from their boundary points alone, with the least possible
//! maximum degree, as a formula.
//!
//! A mesh generator often knows only the number of intervals on each side of a domain. From these
//! counts, this crate computes a triangulation that adds no points and whose largest vertex degree
//! is as small as possible, with a proof. The degree of a vertex is the number of its edges, its
//! two boundary edges included (graphics programs call it "valence").
//!
//! Source: Pangfeng Liu, "Minimum degree triangulation for rectangular domains" (2005), extended from
//! rectangles to every convex polygon.
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
//! # Ok::<(), mindeg_core::Defect>(())
//! ```
//!
//! A triangulation is one [`Strip`] between two [`Chain`]s, in the order of the letters of a
//! [`Word`], or two strips that share an edge. The construction takes O(k) time for k sides,
//! whatever the number of intervals, and any triangle or degree takes O(1) more.
//!
//! # Contents
//!
//! - [`least_degree_triangulation`] builds one optimal triangulation and shows the three
//!   constructions in figures; [`Candidates`] lists all that the constructions allow.
//! - [`least_max_degree`] is the optimum. [`certificate`] proves that no triangulation has less,
//!   [`bound`] has the theorems that it uses, and [`suggest`] finds the smallest change of counts
//!   for a lower optimum.
//! - [`RingStrip`] joins two closed loops of vertices, as a tube or an annulus has them.
//! - [`RingStrip`] joins two closed loops of vertices, for example of a tube or an annulus.
//!
//! # Indices
//!
//! Vertices are `u32` indices `0..n`, counter-clockwise from the corner where the first side
//! starts. A triangle is a counter-clockwise `[u32; 3]`, as in an index buffer. Sides are `usize`
//! indices from 0; messages count sides from 1. Interval counts are `u64`, so that this crate can
//! refuse a count that is too large.
//!
//! # Limits
//!
//! Polygons are convex and have at most [`MAX_VERTICES`] boundary vertices. The crate does not
//! know positions, so it does not control angles: a small degree alone does not make good angles.
#![no_std]

extern crate alloc;

pub mod bound;
mod boundary;
mod candidates;
mod certificate;
mod construction;
mod cut;
mod defect;
mod least_degree;
mod ring;
mod ring_strip;
mod strip;
mod suggest;
mod triangles;
mod triangulation;
mod verify;
mod word;

pub use boundary::{Boundary, MAX_VERTICES};
pub use candidates::Candidates;
pub use certificate::{Certificate, certificate, least_max_degree};
pub use cut::{Cut, best_cuts, least_imbalance};
pub use defect::Defect;
pub use least_degree::least_degree_triangulation;
pub use ring_strip::RingStrip;
pub use strip::{Chain, End, Strip};
pub use suggest::{Change, Suggestion, suggest, suggestions};
pub use triangles::TriangleIter;
pub use triangulation::{Neighbors, Triangulation};
pub use verify::{Verified, verify};
pub use word::{Letter, Word};
