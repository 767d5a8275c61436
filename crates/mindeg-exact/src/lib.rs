//! How much angle each degree buys: the exact trade-off, and the best mesh at any cap.
//!
//! A least maximum degree says nothing about angles, and a Delaunay triangulation, which has
//! the largest minimum angle, nothing about degrees. For a convex polygon with given boundary
//! points this crate finds what lies between: for any cap on the degree, for all vertices or
//! for single ones, the triangulation of the boundary points with the largest minimum angle
//! there is. One degree above the least often has the Delaunay angle already.
//!
//! ```
//! use glam::DVec2;
//! use mindeg_core::Boundary;
//! use mindeg_exact::{Problem, trade_off, unwatched};
//!
//! // A rectangle of 4 by 3, with three intervals to a side.
//! let boundary = Boundary::new(&[3, 3, 3, 3])?;
//! let corners = [(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0), (0.0, 0.0)].map(DVec2::from);
//! let side = |ends: &[DVec2]| [0.0, 1.0, 2.0].map(|i| ends[0].lerp(ends[1], i / 3.0));
//! let points: Vec<DVec2> = corners.windows(2).flat_map(side).collect();
//!
//! let problem = Problem::new(&boundary, &points)?;
//! for optimum in trade_off(&problem, &mut unwatched)?.optima {
//!     println!("degree {}: {:.3}°", optimum.max_degree, optimum.min_angle);
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # How it works
//!
//! A chord splits the polygon, and either piece matters to the other only through its numbers
//! of edges at the chord's ends. So an interval dynamic program over all chords, with these
//! two numbers as its state, decides whether some triangulation keeps to the caps and has no
//! angle below a threshold. A search over thresholds ends on an actual triangle's angle, and a
//! last run of the same program, among the triangulations that have it, chooses the mesh. Edges
//! that occur in no triangulation with such angles, whatever the degrees, are left out of all
//! this from the start, and few remain.
//!
//! That a Delaunay triangulation has the largest minimum angle is due to Sibson ("Locally
//! equiangular triangulations", 1978); the least degree is that of C.-L. Liu, "Minimum degree
//! triangulation for rectangular domains" (2005), by way of [`mindeg_core`].
//!
//! # Limits
//!
//! At most [`MAX_VERTICES`] boundary vertices: time grows with the cube of their number and
//! memory with its square. On four cores, the trade-off for 400 vertices at equal intervals
//! takes a fraction of a second, for 2,000 some seconds and 110 MB. Graded intervals make for
//! many degrees with an angle of their own and for long work on each: 2,000 vertices where every
//! interval is a hundredth longer than the one before have 73 such degrees and take minutes.
//! Angles and shapes are compared to 36 bits, see [`measure`].

#[cfg(test)]
extern crate self as mindeg_exact;

mod answer;
mod apex;
pub mod check;
mod chords;
mod degree;
mod delaunay;
pub mod measure;
mod merit;
mod pieces;
mod problem;
mod progress;
mod reach;
mod search;
mod triangulation;
mod visibility;
mod window;
mod windows;
mod zigzag;

pub use answer::{Optimum, TradeOff, Unsolved, best_angle, least_max_degree, trade_off};
pub use apex::ApexBound;
pub use degree::{DegreeRange, LowerBound, Reached, degree_range};
pub use problem::{MAX_TRIPLES, MAX_VERTICES, Problem, ProblemError};
pub use progress::{Progress, Stage, Watch, unwatched};
pub use windows::{WindowGoal, Windowed, windows};
pub use zigzag::ZigZag;
