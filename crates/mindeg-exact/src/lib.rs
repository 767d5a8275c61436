//! The least maximum degree of any polygon, proven, and how much angle each degree buys.
//!
//! A least maximum degree says nothing about angles, and a Delaunay triangulation, which has the
//! largest minimum angle, nothing about degrees. For a polygon with given boundary points this
//! crate finds what lies between: under any degree limit, for all vertices or for single ones, the
//! triangulation of the boundary points with the largest minimum angle. One degree above the least
//! often allows the Delaunay angle already.
//!
//! ```
//! use glam::DVec2;
//! use mindeg_core::Boundary;
//! use mindeg_exact::{Problem, Progress, trade_off};
//!
//! // A rectangle of 4 by 3, with three intervals to a side.
//! let boundary = Boundary::new(&[3, 3, 3, 3])?;
//! let corners = [(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0), (0.0, 0.0)].map(DVec2::from);
//! let side = |ends: &[DVec2]| [0.0, 1.0, 2.0].map(|i| ends[0].lerp(ends[1], i / 3.0));
//! let points: Vec<DVec2> = corners.windows(2).flat_map(side).collect();
//!
//! let problem = Problem::new(&boundary, &points)?;
//! for optimum in trade_off(&problem, Progress::NONE)?.optima {
//!     println!("degree {}: {:.3}°", optimum.max_degree, optimum.min_angle);
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # What is here
//!
//! - [`Problem`]: a convex polygon from its counts ([`Problem::new`]), or any domain with some
//!   triangulation of it ([`Problem::triangulated`]).
//! - [`degree_range`]: the least maximum degree with its proof, or an upper and a lower bound.
//! - [`best_angle`] and [`trade_off`]: the best angle under one limit, and under each.
//! - [`windows()`]: for any size, and with holes: fewer edges at the vertices with the most, at a
//!   guaranteed minimum angle.
//! - [`fill_loop`]: the triangulation of least area of a closed loop in space, under a degree limit.
//! - [`bridge_rings`]: the strip between two loops with the least maximum degree, and of those the
//!   largest minimum angle.
//! - [`check`]: whether the proof of a lower bound holds, by other means.
//!
//! # How it works
//!
//! A chord is admissible if it lies inside and no side has both of its ends. On a polygon that is
//! not convex, the two ends see each other; the crate finds these pairs through the given
//! triangulation, with exact predicates, and often they are few.
//!
//! A chord splits the polygon into two pieces. Each depends on the other only through the numbers
//! of edges at the chord's ends. So an interval dynamic program over all chords, with these two
//! numbers as its state, decides whether some triangulation keeps the degree limits and has no
//! angle below a threshold. A search over thresholds ends on the angle of an actual triangle. A
//! last run of the same program chooses the mesh among the triangulations with that angle. Before
//! each run the search removes the edges that occur in no triangulation with such angles, whatever
//! the degrees; few remain. The angle of a Delaunay triangulation bounds the search from the start.
//!
//! That a Delaunay triangulation has the largest minimum angle is due to Sibson ("Locally
//! equiangular triangulations", 1978); the least degree of convex polygons to Pangfeng Liu, "Minimum
//! degree triangulation for rectangular domains" (2005), by way of [`mindeg_core`].
//!
//! # Limits
//!
//! Convex polygons: at most [`MAX_VERTICES`] boundary vertices. Other polygons: at most
//! [`MAX_TRIPLES`] triples of vertices that see each other, counted before the work starts. For
//! larger polygons, and for holes, there are windows and lower bounds. One pass of the dynamic
//! program takes time in proportion to the triples, and some 50 bytes of memory a chord.
//!
//! On one core, the trade-off of a convex polygon of 2,000 vertices at equal intervals takes about
//! a second, of 4,000 about 7. With graded intervals, many degrees have an angle of their own, and
//! the work on each is long: if every interval of 2,000 is a hundredth longer than the one before,
//! 73 degrees do, and the trade-off takes minutes.
//!
//! Angles and shapes are compared to 36 bits, see [`measure`]. Long work reports its [`Progress`]
//! on the calling thread, and the callback can cancel it.

#[cfg(test)]
extern crate self as mindeg_exact;

mod annealing;
mod annulus;
mod answer;
mod apex;
mod breakout;
mod bridge;
pub mod check;
mod chords;
mod cover;
mod degree;
mod delaunay;
mod feasibility;
mod fill;
mod front;
mod fronts;
mod hulls;
mod least_cost;
mod least_weight;
mod limits;
mod linked;
pub mod measure;
mod merit;
mod patch;
mod pieces;
mod problem;
mod progress;
mod reach;
mod rows;
mod search;
mod sides;
mod space;
mod unsolved;
mod visibility;
mod window;
mod windows;
mod zigzag;

pub use annealing::anneal;
pub use answer::{AngleOptima, best_angle, least_max_degree, trade_off, trade_off_until};
pub use apex::ApexBound;
pub use breakout::Breakout;
pub use bridge::{Bridge, BridgeProblem, MAX_STEPS, bridge_rings, largest_bridge_angle};
pub use cover::{Cover, Decision, Element, Literal, MAX_CANDIDATES, Refutation, SearchedAngle};
pub use degree::{DegreeRange, LowerBound, Reached, degree_range, lower_bound};
pub use fill::{LoopLimit, LoopProblem, LoopTriangulation, MAX_LOOP, MAX_STATES, fill_loop};
pub use least_weight::LeastWeight;
pub use mindeg_mesh::{Cancelled, Progress};
pub use patch::{Block, Cost, Patch};
pub use problem::{COVER_STEPS, MAX_TRIPLES, Problem};
pub use search::Optimum;
pub use unsolved::{MAX_VERTICES, Unsolved};
pub use windows::{Windowed, windows};
pub use zigzag::ZigZag;
