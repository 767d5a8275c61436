//! The least maximum degree of any polygon, proven, and how much angle each degree buys.
//!
//! A least maximum degree says nothing about angles, and a Delaunay triangulation, which has
//! the largest minimum angle, nothing about degrees. For a polygon with given boundary
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
//! # What is here
//!
//! - [`Problem`]: a convex polygon from its counts ([`Problem::new`]), or any domain with some
//!   triangulation of it ([`Problem::triangulated`]).
//! - [`degree_range`]: the least maximum degree and what proves it, or the gap.
//! - [`best_angle`] and [`trade_off`]: the best angle under one limit, and under each.
//! - [`windows()`]: for any size, and for holes: as few edges at the busiest vertices as can be reached
//!   near them, at a guaranteed minimum angle.
//! - [`check`]: whether triangles are a triangulation, by other means.
//!
//! # How it works
//!
//! A chord is admissible when it lies inside, and no two of its side's vertices are its ends. On a polygon
//! that is not convex these are the vertices that see each other, found through the given triangulation
//! with exact predicates, and often few.
//!
//! A chord splits the polygon, and either piece matters to the other only through its numbers
//! of edges at the chord's ends. So an interval dynamic program over all chords, with these
//! two numbers as its state, decides whether some triangulation keeps to the caps and has no
//! angle below a threshold. A search over thresholds ends on an actual triangle's angle, and a
//! last run of the same program, among the triangulations that have it, chooses the mesh. Edges
//! that occur in no triangulation with such angles, whatever the degrees, are left out
//! before each run, and few remain. The angle of a Delaunay triangulation bounds the search from the start.
//!
//! That a Delaunay triangulation has the largest minimum angle is due to Sibson ("Locally
//! equiangular triangulations", 1978); the least degree of convex polygons is that of C.-L. Liu, "Minimum degree
//! triangulation for rectangular domains" (2005), by way of [`mindeg_core`].
//!
//! # Limits
//!
//! Convex polygons: at most [`MAX_VERTICES`] boundary vertices. Other polygons: at most
//! [`MAX_TRIPLES`] triples of vertices that see each other, which are counted before the work
//! starts; beyond that, and with holes, there are windows and lower bounds. One pass of the
//! dynamic program takes time in proportion to the triples, memory some 50 bytes a chord.
//! On one core, the trade-off of a convex polygon of 2,000 vertices at equal intervals takes about a second, of
//! 4,000 about 7. Graded intervals make for
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

pub use answer::{
    Optimum, TradeOff, Unsolved, best_angle, least_max_degree, trade_off, trade_off_until,
};
pub use apex::ApexBound;
pub use degree::{DegreeRange, LowerBound, Reached, degree_range};
pub use problem::{MAX_TRIPLES, MAX_VERTICES, Problem, ProblemError};
pub use progress::{Progress, Stage, Watch, unwatched};
pub use windows::{WindowGoal, Windowed, windows};
pub use zigzag::ZigZag;
