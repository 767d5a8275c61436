//! Interior points for a fixed boundary: degrees 5 to 7 inside, at most 5 at the boundary, and a minimum
//! angle near its proven limit.
//!
//! Give the boundary points of a domain, convex or not, with or without holes. The boundary stays
//! bit for bit; [`generate`] adds points inside. [`improve`] applies the optimiser alone to any planar
//! triangle mesh. [`limits::limits`] says beforehand which minimum angle no mesh of this boundary can exceed.
//!
//! ```
//! use glam::DVec2;
//! use mindeg_interior::{Options, generate};
//! use mindeg_mesh::Progress;
//! use mindeg_mesh::planar::PlanarBoundary;
//!
//! // A unit square with 8 intervals on each side.
//! let corners = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y];
//! let side = |i: usize| (0..8).map(move |j| corners[i].lerp(corners[(i + 1) % 4], f64::from(j) / 8.0));
//! let ring: Vec<DVec2> = (0..4).flat_map(side).collect();
//!
//! let outline = PlanarBoundary::new(&[&ring])?;
//! let mesh = generate(&outline, &Options::default(), Progress::NONE)?;
//! assert_eq!(mesh.points[..32], ring[..]);
//! assert!(mesh.report.min_angle > 35.0);
//! assert!(mesh.report.violations.is_empty());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # How it works
//!
//! 1. A size field carries the lengths of the boundary edges inside: their mean, weighted by how each
//!    edge is seen, and nowhere more than length + growth * distance.
//! 2. A packing grows from the boundary inwards. Each point makes an equilateral triangle with
//!    what is there, and sectors between edges of unequal length, of the boundary or of lines, get the fan of their limit.
//! 3. A constrained Delaunay triangulation connects the points.
//! 4. The optimiser smooths, and where a degree or an angle is wrong it tries flips, collapses and
//!    vertex splits. Each is undone unless the energy falls and no small angle gets smaller.
//! 5. Where something is left to be desired, the disc round that place is worked on alone, with its rim frozen: chains and
//!    pairs of operations, random operations in a row, new starts.
//! 6. Flips bring degrees nearer to 6, and the last smoothing raises the mean quality; no angle that counts gets smaller.
//! 7. If the mesh is small, or little is left in it, other seeds are tried, and the best mesh is returned.
//!
//! # What is proven, and what is not
//!
//! The limits are proven ([`limits`]). Validity is checked with exact predicates on every mesh before it is returned:
//! all triangles are counter-clockwise, and the edges of the boundary and its lines are there. Degrees and angles are reached by
//! a heuristic search without a guarantee; the [`InteriorReport`] says what was reached.
//!
//! Measured by the `corpus` example on 200 random convex polygons of 3 to 8 sides with 3 to 60 intervals each, 60
//! polygons with reflex corners and a hole, and the project's 8 domains: no violation on any, and the minimum
//! angle at 0.999 of min(limit, 35 degrees) in the mean and 0.98 at worst. 10^6 triangles take 2.5 s of one core
//! (the `scale` example).
//!
//! # Surfaces in space
//!
//! [`remesh`] applies the same operations and trials to a surface: long edges of the surface's own triangles are split, short
//! ones collapse, degrees become even by flips, vertices move in tangent planes and are projected. Features stay:
//! vertices on curves move along them, corners do not move. No operation may take the mesh farther from the surface, or
//! leave samples of the surface farther from the mesh, than the tolerance, unless they were.
//!
//! Equal input gives equal bytes on every machine: transcendental functions come from `libm`, orders
//! are fixed, and one thread does all the work.

mod across;
mod ahead;
mod anneal;
mod array_mesh;
mod asked;
mod bistellar;
mod breaklines;
mod cells;
mod chains;
mod compass;
mod disc;
mod draft;
mod ears;
mod edge_limits;
mod edge_tree;
mod energy;
mod failed;
mod filling;
mod finish;
mod fixed;
mod frozen;
mod generate;
mod goal;
mod improve;
mod invariants;
mod joined;
mod kernel;
mod lengths;
pub mod limits;
mod manifold;
mod measure;
mod near;
mod operations;
mod optimise;
mod options;
mod order;
mod packing;
mod places;
mod plane;
mod redraw;
mod report;
mod restart;
#[cfg(test)]
mod samples;
mod sight;
mod size;
mod sketch;
mod smooth;
mod space;
mod stage;
mod star;
mod start;
mod surface;
mod tents;
mod together;
mod trial;
mod triangle;
mod verdict;
mod worth;

pub use across::sizes_across;
pub use asked::{size_of_area, sizes_asked};
pub use draft::draft;
pub use edge_limits::edge_limit;
pub use generate::{Generated, generate, generate_once, generate_showing};
pub use improve::{Improved, Keep, improve};
pub use lengths::{CoarseEdge, SizeReport};
pub use mindeg_domain::{Interior, Prefer, Size, SizeAt};
pub use options::{InteriorError, JoinedVertices, Options, check_coordinates};
pub use report::{
    CertifiedVertex, CornerTradeOff, InteriorReport, LocalShares, TogetherBound, Violation,
};
pub use size::grow_fast;
pub use surface::{
    CornerLimit, OffDegree, RemeshError, RemeshOptions, RemeshReport, Remeshed, RemeshedCurve,
    improve_surface, remesh,
};
pub use triangle::least_angle;
