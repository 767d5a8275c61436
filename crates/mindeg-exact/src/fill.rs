//! The triangulation of least area of a closed loop in space, under a limit on degrees.
//!
//! Without holes in sight or a plane, every pair of vertices may be joined, and a zig-zag gives
//! degree 4 to any loop of five vertices or more: the degree alone says nothing. The area does. An
//! interval dynamic program finds the triangulation of least area whose vertices keep a limit on
//! their total degrees, the edges outside the loop included.
//!
//! A chord splits the loop into two pieces, which depend on each other only through the numbers of
//! chords at its ends. So the program keeps, for each piece, the triangulations that no other one
//! beats in both numbers and area. For n vertices and fronts of f of them it takes O(n³ f²) time
//! and O(n² f) memory.
//!
//! # Definitions
//!
//! - *Limit.* The limit D holds at each vertex that has no more than D edges outside the filling.
//!   A vertex that has more gets no chord.
//! - *Least area.* Areas are rounded to 2^-50 of a power of two above the loop's extent; triangulations
//!   whose areas differ by less than 2^-36 of it a triangle count as equal, and then the better
//!   shaped triangles win.
//! - *Flat triangles* (height below 1e-9 of the longest edge) are used only where each
//!   triangulation has as many.
//!
//! Limits: nothing keeps triangles from crossing each other where a loop is folded. At most
//! [`MAX_LOOP`] vertices and [`MAX_STATES`] kept triangulations of pieces.

mod any_degree;
mod limited;
mod problem;

use crate::linked::chord_counts;
use crate::space::{self, Cost};
use crate::unsolved::Unsolved;
use any_degree::AnyDegree;
use limited::Limited;
use mindeg_mesh::Progress;
use mindeg_mesh::quality::area_in_space;
pub use problem::{LoopProblem, MAX_LOOP, MAX_STATES};

/// How many edges a vertex may have.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LoopLimit {
    /// At most so many.
    AtMost(u32),
    /// The least limit whose triangulation has no more flat triangles than without a limit, and at most
    /// `1 + extra_area` times the area.
    LeastWithin {
        /// The first limit to try.
        from: u32,
        /// A share of the least area, 0 or more; infinite for any area.
        extra_area: f64,
    },
}

/// The triangulation of a loop.
#[derive(Clone, Debug, PartialEq)]
pub struct LoopTriangulation {
    /// n - 2 triangles, by indices of the loop's vertices. Each runs round as the loop does.
    pub triangles: Vec<[u32; 3]>,
    /// The limit that it keeps.
    pub limit: u32,
    /// The largest total degree of the loop's vertices.
    pub max_degree: u32,
    /// The sum of areas, in square units of length.
    pub area: f64,
    /// The least area without a limit, and the largest total degree that goes with it.
    pub without_limit: (f64, u32),
    /// The least possible limit and the area that it takes, where a higher one was chosen for its
    /// area.
    pub least_limit: Option<(u32, f64)>,
}

/// The triangles of a loop, and their cost.
type Solved = (Vec<[u32; 3]>, Cost);

/// The triangulation of least area of a loop, under a limit on the total degrees of its vertices.
///
/// O(n³) time for n vertices without a limit, and O(n³ f²) for each limit that is tried, for fronts
/// of f states.
///
/// # Errors
///
/// A limit that no triangulation keeps, excluded edges that each needs, too many states, or a cancelled `progress`.
///
/// # Example
///
/// ```
/// use glam::DVec3;
/// use mindeg_exact::{LoopLimit, LoopProblem, Progress, fill_loop};
///
/// // A square whose corners go up and down in turn: either diagonal folds it.
/// let loop_ = [(0., 0., 0.), (1., 0., 1.), (1., 1., 0.), (0., 1., 1.)].map(DVec3::from);
/// let problem = LoopProblem::new(&loop_, &[2; 4], [[0, 2]])?;
/// let filled = fill_loop(&problem, LoopLimit::AtMost(6), Progress::NONE)?;
/// assert_eq!(filled.triangles, [[0, 1, 3], [1, 2, 3]]);
/// assert_eq!((filled.limit, filled.max_degree), (6, 3));
/// # Ok::<(), mindeg_exact::Unsolved>(())
/// ```
pub fn fill_loop(
    problem: &LoopProblem,
    limit: LoopLimit,
    progress: Progress<'_>,
) -> Result<LoopTriangulation, Unsolved> {
    let points = space::scaled(problem.points.iter());
    let any = AnyDegree::solve(problem, &points, progress)?.ok_or(Unsolved::Excluded)?;
    let free = any.triangles(&points);
    let least = any.cost();
    let without_limit = (area(problem, &free), max_degree(problem, &free));
    let result = |triangles: Vec<[u32; 3]>, limit: u32| {
        let (area, max_degree) = (area(problem, &triangles), max_degree(problem, &triangles));
        LoopTriangulation { triangles, limit, max_degree, area, without_limit, least_limit: None }
    };
    let solve = |limit: u32| -> Result<Option<Solved>, Unsolved> {
        if keeps(problem, &free, limit) {
            return Ok(Some((free.clone(), least)));
        }
        let capacities = problem.capacities(limit);
        let ends: u64 = capacities.iter().map(|&capacity| u64::from(capacity)).sum();
        // Each of the n - 3 chords has two ends.
        if ends < 2 * (points.len() as u64 - 3) {
            return Ok(None);
        }
        let limited = Limited::solve(problem, &points, &capacities, limit, progress)?;
        Ok(limited.best().map(|cost| (limited.triangles(&points), cost)))
    };
    // Without a limit `free` is an answer, so some limit has one.
    let least_from = |from: u32, most_flat: u32, most_area: f64| -> Result<_, Unsolved> {
        let mut least_limit = None;
        for limit in from..without_limit.1 {
            if let Some((triangles, cost)) = solve(limit)?
                && cost.flat <= most_flat
            {
                let area = area(problem, &triangles);
                if area <= most_area {
                    return Ok(LoopTriangulation { least_limit, ..result(triangles, limit) });
                }
                least_limit.get_or_insert((limit, area));
            }
        }
        let limit = from.max(without_limit.1);
        Ok(LoopTriangulation { least_limit, ..result(free.clone(), limit) })
    };
    match limit {
        LoopLimit::LeastWithin { from, extra_area } => {
            // Infinity times zero is NaN; the least area then decides.
            let most_area = ((1.0 + extra_area) * without_limit.0).max(without_limit.0);
            least_from(from, least.flat, most_area)
        }
        LoopLimit::AtMost(limit) => match solve(limit)? {
            Some((triangles, _)) => Ok(result(triangles, limit)),
            None => {
                let found = least_from(limit + 1, u32::MAX, f64::INFINITY)?;
                Err(Unsolved::Infeasible { max_degree: limit, least: found.limit })
            }
        },
    }
}

/// The total degrees: edges outside, and chords.
fn degrees(problem: &LoopProblem, triangles: &[[u32; 3]]) -> Vec<u32> {
    let chords = chord_counts(problem.points.len(), triangles);
    chords.iter().zip(&problem.external).map(|(chords, external)| chords + external).collect()
}

fn max_degree(problem: &LoopProblem, triangles: &[[u32; 3]]) -> u32 {
    degrees(problem, triangles).into_iter().max().unwrap_or(0)
}

/// Whether each vertex keeps a limit, or has no chord.
fn keeps(problem: &LoopProblem, triangles: &[[u32; 3]], limit: u32) -> bool {
    let degrees = degrees(problem, triangles);
    degrees.iter().zip(&problem.external).all(|(&degree, &own)| degree <= limit.max(own))
}

fn area(problem: &LoopProblem, triangles: &[[u32; 3]]) -> f64 {
    let at = |vertex: u32| problem.points[vertex as usize];
    triangles.iter().map(|corners| area_in_space(corners.map(at))).sum()
}
