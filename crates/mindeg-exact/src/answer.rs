//! The answers: the best angle under a degree limit, and the whole trade-off.

use crate::degree::degree_range;
use crate::feasibility::any_triangulation;
use crate::measure;
use crate::problem::{Domain, Problem};
use crate::search::{Optimum, Search};
use crate::unsolved::Unsolved;
use mindeg_core::least_max_degree as of_counts;
use mindeg_mesh::Progress;

/// The minimum angle that each degree buys.
#[derive(Clone, Debug, PartialEq)]
pub struct AngleOptima {
    /// The optimum for every degree limit, from the least possible one to the first that allows as
    /// large an angle as any.
    pub optima: Vec<Optimum>,
    /// The largest minimum angle of all triangulations, in degrees, which is that of a Delaunay
    /// triangulation. The last optimum has it, unless degree limits of single vertices rule that
    /// out.
    pub unlimited_min_angle: f64,
}

/// The least maximum degree, if the closed form gives it.
fn closed_form(problem: &Problem) -> Option<u32> {
    match &problem.domain {
        Domain::Convex(boundary) if problem.is_plain() => Some(of_counts(boundary)),
        _ => None,
    }
}

/// The triangulation with the largest minimum angle in which no vertex has more than `max_degree`
/// edges, external ones included, or more than its own degree limit.
///
/// Of several, the answer is one with the fewest vertices at their limit, and of those one with the
/// largest sum of `shape`. A fixed rule decides remaining ties: the same input has the same answer
/// on every machine and any number of threads. Angles and shapes are compared as [`measure`]
/// defines them.
///
/// O(n³) time and O(n²) memory, times a power of the degree that pruning keeps small; in parallel
/// in the current rayon pool.
///
/// # Errors
///
/// No triangulation keeps the limits, a polygon that is too large or has holes, or a cancelled
/// `progress`.
///
/// # Example
///
/// ```
/// use glam::DVec2;
/// use mindeg_core::Boundary;
/// use mindeg_exact::{Problem, Progress, Unsolved, best_angle};
///
/// // A square of 2 by 2, with two intervals to a side.
/// let boundary = Boundary::new(&[2, 2, 2, 2])?;
/// let points = [(0, 0), (1, 0), (2, 0), (2, 1), (2, 2), (1, 2), (0, 2), (0, 1)];
/// let points = points.map(|(x, y)| DVec2::new(f64::from(x), f64::from(y)));
/// let problem = Problem::new(&boundary, &points)?;
///
/// let optimum = best_angle(&problem, 5, Progress::NONE)?;
/// assert!((optimum.min_angle - 45.0).abs() < 1e-9);
/// let refused = best_angle(&problem, 3, Progress::NONE);
/// assert_eq!(refused, Err(Unsolved::Infeasible { max_degree: 3, least: 4 }));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn best_angle(
    problem: &Problem,
    max_degree: u32,
    progress: Progress<'_>,
) -> Result<Optimum, Unsolved> {
    let chords = problem.chords(progress)?;
    let is_possible = match closed_form(problem) {
        Some(least) => max_degree >= least,
        None => any_triangulation(problem, chords, max_degree, 0.0, progress)?.is_some(),
    };
    match problem.degree_limits(max_degree) {
        Some(limits) if is_possible => {
            let mut search = Search::new(problem, chords, progress)?;
            let tangent = search.best_tangent(&limits, 0.0)?;
            Ok(search.optimum(&limits, tangent)?)
        }
        _ => Err(Unsolved::Infeasible { max_degree, least: least_max_degree(problem, progress)? }),
    }
}

/// The optimum for every maximum degree, from [`least_max_degree`] up to the first that allows as
/// large an angle as no limit at all; each as [`best_angle`] finds it.
///
/// # Errors
///
/// No triangulation keeps the degree limits of single vertices, a polygon that is too large or has
/// holes, or a cancelled `progress`.
///
/// # Example
///
/// ```
/// use glam::DVec2;
/// use mindeg_core::Boundary;
/// use mindeg_exact::{Problem, Progress, trade_off};
///
/// let boundary = Boundary::new(&[2, 2, 2, 2])?;
/// let points = [(0, 0), (1, 0), (2, 0), (2, 1), (2, 2), (1, 2), (0, 2), (0, 1)];
/// let points = points.map(|(x, y)| DVec2::new(f64::from(x), f64::from(y)));
/// let trade_off = trade_off(&Problem::new(&boundary, &points)?, Progress::NONE)?;
///
/// let [four, five] = &trade_off.optima[..] else { panic!("degrees 4 and 5") };
/// assert!((four.min_angle - 18.435).abs() < 1e-3);
/// assert_eq!(five.min_angle, trade_off.unlimited_min_angle);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn trade_off(problem: &Problem, progress: Progress<'_>) -> Result<AngleOptima, Unsolved> {
    trade_off_until(problem, &mut |_, _| false, progress)
}

/// The [`trade_off`] up to the first optimum for which `is_enough` is true; its second argument is
/// the largest minimum angle of all triangulations, in degrees.
///
/// # Errors
///
/// The errors of [`trade_off`].
///
/// # Example
///
/// ```
/// use glam::DVec2;
/// use mindeg_core::Boundary;
/// use mindeg_exact::{Problem, Progress, trade_off_until};
///
/// let boundary = Boundary::new(&[2, 2, 2, 2])?;
/// let points = [(0, 0), (1, 0), (2, 0), (2, 1), (2, 2), (1, 2), (0, 2), (0, 1)];
/// let points = points.map(|(x, y)| DVec2::new(f64::from(x), f64::from(y)));
/// let problem = Problem::new(&boundary, &points)?;
/// let has_a_third = &mut |optimum: &mindeg_exact::Optimum, most| optimum.min_angle > most / 3.0;
/// let kept = trade_off_until(&problem, has_a_third, Progress::NONE)?;
/// assert_eq!(kept.optima.last().unwrap().max_degree, 4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn trade_off_until(
    problem: &Problem,
    is_enough: &mut dyn FnMut(&Optimum, f64) -> bool,
    progress: Progress<'_>,
) -> Result<AngleOptima, Unsolved> {
    let chords = problem.chords(progress)?;
    let least = least_max_degree(problem, progress)?;
    let mut search = Search::new(problem, chords, progress)?;
    let limits =
        |max_degree| problem.degree_limits(max_degree).expect("no limit is below the least");
    let most = if problem.is_plain() {
        search.unlimited_tangent()
    } else {
        search.best_tangent(&limits(problem.no_limit()), 0.0)?
    };
    let unlimited_min_angle = measure::degrees(search.unlimited_tangent());
    let mut optima = Vec::new();
    let mut tangent = 0.0;
    for max_degree in least..=problem.no_limit() {
        let limits = limits(max_degree);
        tangent = search.best_tangent(&limits, tangent)?;
        let optimum = search.optimum(&limits, tangent)?;
        let is_last = tangent == most || is_enough(&optimum, unlimited_min_angle);
        optima.push(optimum);
        if is_last {
            break;
        }
    }
    Ok(AngleOptima { optima, unlimited_min_angle })
}

/// The least maximum degree of all triangulations, with external degrees and the degree limits of
/// single vertices.
///
/// O(k) for k sides if the polygon is convex and has neither, else a few passes of O(n³) at most.
///
/// # Errors
///
/// No triangulation keeps the degree limits of single vertices, a polygon that is too large, a search with
/// holes that takes too many steps, or a cancelled `progress`.
///
/// # Example
///
/// ```
/// use glam::DVec2;
/// use mindeg_core::Boundary;
/// use mindeg_exact::{Problem, Progress, Unsolved, least_max_degree};
///
/// let boundary = Boundary::new(&[2, 1, 1])?;
/// let points = [(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (0.0, 2.0)].map(DVec2::from);
/// let mut problem = Problem::new(&boundary, &points)?;
/// assert_eq!(least_max_degree(&problem, Progress::NONE)?, 3);
/// problem.set_external_degree(3, 4);
/// assert_eq!(least_max_degree(&problem, Progress::NONE)?, 7);
/// problem.set_degree_limit(1, 2); // but only 1 and 3 can be joined
/// assert_eq!(least_max_degree(&problem, Progress::NONE), Err(Unsolved::VertexLimits));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn least_max_degree(problem: &Problem, progress: Progress<'_>) -> Result<u32, Unsolved> {
    if let Some(least) = closed_form(problem) {
        return Ok(least);
    }
    let range = degree_range(problem, progress)?;
    if range.is_proven() {
        Ok(range.max_degree)
    } else if let Domain::Rings(_) = problem.domain {
        Err(Unsolved::Undecided)
    } else {
        Err(Unsolved::TooLarge { max_triples: problem.max_triples })
    }
}
