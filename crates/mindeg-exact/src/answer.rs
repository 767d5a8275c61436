//! The answers: the best angle under a cap, and the whole trade-off.

use crate::chords::Chords;
use crate::degree::degree_range;
use crate::measure;
use crate::problem::{Domain, NoChords, Problem};
use crate::progress::{Stopped, Watch};
use crate::search::{Search, any_triangulation};
use mindeg_core::least_max_degree as of_counts;
use thiserror::Error;

/// The triangulation with the largest minimum angle under a cap.
#[derive(Clone, Debug, PartialEq)]
pub struct Optimum {
    /// The cap on the degree of every vertex. No vertex need have so many edges.
    pub max_degree: u32,
    /// The smallest angle of all triangles, in degrees: 0 to 60, to the 36 bits of [`measure`].
    pub min_angle: f64,
    /// How many vertices have as many edges as they may, those outside included: as few as
    /// this angle allows.
    pub vertices_at_cap: u32,
    /// The sum of Verdict's `shape` over all triangles, 0 to n-2: as large as this angle and
    /// so few vertices at their cap allow.
    pub shape_sum: f64,
    /// The n-2 triangles, counter-clockwise from their smallest vertex, in ascending order.
    pub triangles: Vec<[u32; 3]>,
}

/// The angle that each degree buys.
#[derive(Clone, Debug, PartialEq)]
pub struct TradeOff {
    /// The optimum for every cap, from the least possible one to the first with which the
    /// angle is as large as with any.
    pub optima: Vec<Optimum>,
    /// The largest minimum angle of all triangulations, in degrees, which is that of a
    /// Delaunay triangulation. It is the last optimum's, unless caps of single vertices stand
    /// against it.
    pub uncapped_min_angle: f64,
}

/// Why there is no answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum Unsolved {
    /// Every triangulation breaks the cap for all.
    #[error("no triangulation here has maximum degree {max_degree}; the least is {least}")]
    Infeasible {
        /// The cap.
        max_degree: u32,
        /// The least cap that can be kept.
        least: u32,
    },
    /// Every triangulation breaks a vertex's own cap, however large the cap for all.
    #[error(
        "no triangulation keeps to the caps of single vertices, whatever its maximum degree; \
         raise these caps"
    )]
    VertexCaps,
    /// More triples of vertices see each other than the problem allows.
    #[error(
        "more than {max_triples} triples of vertices see each other, too many for exact work; \
         use windows, or a larger limit"
    )]
    TooLarge {
        /// The limit.
        max_triples: u64,
    },
    /// A domain with holes, or whose boundary is not the ring 0, 1, 2, …
    #[error("exact work needs a polygon without holes; use windows")]
    NotAPolygon,
    /// The [`Watch`] asked to stop.
    #[error("stopped before the answer was found")]
    Stopped,
}

impl From<Stopped> for Unsolved {
    fn from(Stopped: Stopped) -> Self {
        Self::Stopped
    }
}

impl Problem {
    pub(crate) fn chords_or_refusal(&self) -> Result<Chords, Unsolved> {
        self.chords().map_err(|reason| match reason {
            NoChords::TooMany => Unsolved::TooLarge { max_triples: self.max_triples() },
            NoChords::Rings => Unsolved::NotAPolygon,
        })
    }

    /// Whether the closed form knows the least maximum degree.
    fn closed_form(&self) -> Option<u32> {
        match &self.domain {
            Domain::Convex(boundary) if self.is_plain() => Some(of_counts(boundary)),
            _ => None,
        }
    }
}

/// The triangulation with the largest minimum angle in which no vertex has more than
/// `max_degree` edges, outside ones included, or more than its own cap.
///
/// Of several, one with the fewest vertices at their cap is taken, and of those one with the
/// largest sum of `shape`. What is still a tie is decided by a fixed rule: the same input has
/// the same answer on every machine and any number of threads. Angles and shapes are compared
/// as [`measure`] defines them.
///
/// O(n³) time and O(n²) memory, times a power of the degree that pruning keeps small; the
/// current rayon pool is used.
///
/// # Errors
///
/// The caps cannot be kept, or `watch` asked to stop.
///
/// # Example
///
/// ```
/// use glam::DVec2;
/// use mindeg_core::Boundary;
/// use mindeg_exact::{Problem, Unsolved, best_angle, unwatched};
///
/// // A square of 2 by 2, with two intervals to a side.
/// let boundary = Boundary::new(&[2, 2, 2, 2])?;
/// let points = [(0, 0), (1, 0), (2, 0), (2, 1), (2, 2), (1, 2), (0, 2), (0, 1)];
/// let points = points.map(|(x, y)| DVec2::new(f64::from(x), f64::from(y)));
/// let problem = Problem::new(&boundary, &points)?;
///
/// let optimum = best_angle(&problem, 5, &mut unwatched)?;
/// assert!((optimum.min_angle - 45.0).abs() < 1e-9);
/// let refused = best_angle(&problem, 3, &mut unwatched);
/// assert_eq!(refused, Err(Unsolved::Infeasible { max_degree: 3, least: 4 }));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn best_angle(
    problem: &Problem,
    max_degree: u32,
    watch: Watch<'_>,
) -> Result<Optimum, Unsolved> {
    let chords = problem.chords_or_refusal()?;
    let is_possible = match problem.closed_form() {
        Some(least) => max_degree >= least,
        None => any_triangulation(problem, &chords, max_degree, watch)?.is_some(),
    };
    match problem.caps(max_degree) {
        Some(caps) if is_possible => {
            let mut search = Search::new(problem, &chords, watch)?;
            let tangent = search.best_tangent(&caps, 0.0, watch)?;
            Ok(search.optimum(&caps, tangent, watch)?)
        }
        _ => Err(Unsolved::Infeasible { max_degree, least: least_max_degree(problem, watch)? }),
    }
}

/// The optimum for every maximum degree, from [`least_max_degree`] up to the first that buys as
/// large an angle as no cap at all; each as [`best_angle`] finds it.
///
/// # Errors
///
/// Caps of single vertices cannot be kept, or `watch` asked to stop.
///
/// # Example
///
/// ```
/// use glam::DVec2;
/// use mindeg_core::Boundary;
/// use mindeg_exact::{Problem, trade_off, unwatched};
///
/// let boundary = Boundary::new(&[2, 2, 2, 2])?;
/// let points = [(0, 0), (1, 0), (2, 0), (2, 1), (2, 2), (1, 2), (0, 2), (0, 1)];
/// let points = points.map(|(x, y)| DVec2::new(f64::from(x), f64::from(y)));
/// let trade_off = trade_off(&Problem::new(&boundary, &points)?, &mut unwatched)?;
///
/// let [four, five] = &trade_off.optima[..] else { panic!("degrees 4 and 5") };
/// assert!((four.min_angle - 18.435).abs() < 1e-3);
/// assert_eq!(five.min_angle, trade_off.uncapped_min_angle);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn trade_off(problem: &Problem, watch: Watch<'_>) -> Result<TradeOff, Unsolved> {
    trade_off_until(problem, &mut |_, _| false, watch)
}

/// The [`trade_off`] up to the first optimum for which `is_enough` is true; it also gets the
/// largest minimum angle of all triangulations, in degrees.
///
/// # Errors
///
/// As [`trade_off`].
///
/// # Example
///
/// ```
/// use glam::DVec2;
/// use mindeg_core::Boundary;
/// use mindeg_exact::{Problem, trade_off_until, unwatched};
///
/// let boundary = Boundary::new(&[2, 2, 2, 2])?;
/// let points = [(0, 0), (1, 0), (2, 0), (2, 1), (2, 2), (1, 2), (0, 2), (0, 1)];
/// let points = points.map(|(x, y)| DVec2::new(f64::from(x), f64::from(y)));
/// let problem = Problem::new(&boundary, &points)?;
/// let has_a_third = &mut |optimum: &mindeg_exact::Optimum, most| optimum.min_angle > most / 3.0;
/// let kept = trade_off_until(&problem, has_a_third, &mut unwatched)?;
/// assert_eq!(kept.optima.last().unwrap().max_degree, 4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn trade_off_until(
    problem: &Problem,
    is_enough: &mut dyn FnMut(&Optimum, f64) -> bool,
    watch: Watch<'_>,
) -> Result<TradeOff, Unsolved> {
    let chords = problem.chords_or_refusal()?;
    let least = least_max_degree(problem, watch)?;
    let mut search = Search::new(problem, &chords, watch)?;
    let caps = |max_degree| problem.caps(max_degree).expect("no cap below the least is asked for");
    let most = if problem.is_plain() {
        search.uncapped_tangent()
    } else {
        search.best_tangent(&caps(problem.no_cap()), 0.0, watch)?
    };
    let uncapped_min_angle = measure::degrees(search.uncapped_tangent());
    let mut optima = Vec::new();
    let mut tangent = 0.0;
    for max_degree in least..=problem.no_cap() {
        let caps = caps(max_degree);
        tangent = search.best_tangent(&caps, tangent, watch)?;
        let optimum = search.optimum(&caps, tangent, watch)?;
        let is_last = tangent == most || is_enough(&optimum, uncapped_min_angle);
        optima.push(optimum);
        if is_last {
            break;
        }
    }
    Ok(TradeOff { optima, uncapped_min_angle })
}

/// The least maximum degree that some triangulation has, outside edges and vertices' own caps
/// considered.
///
/// O(k) where there are none, else a few passes of O(n³) at most.
///
/// # Errors
///
/// Caps of single vertices cannot be kept, or `watch` asked to stop.
///
/// # Example
///
/// ```
/// use glam::DVec2;
/// use mindeg_core::Boundary;
/// use mindeg_exact::{Problem, Unsolved, least_max_degree, unwatched};
///
/// let boundary = Boundary::new(&[2, 1, 1])?;
/// let points = [(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (0.0, 2.0)].map(DVec2::from);
/// let mut problem = Problem::new(&boundary, &points)?;
/// assert_eq!(least_max_degree(&problem, &mut unwatched)?, 3);
/// problem.set_outside_degree(3, 4);
/// assert_eq!(least_max_degree(&problem, &mut unwatched)?, 7);
/// problem.set_max_degree(1, 2); // but only 1 and 3 can be joined
/// assert_eq!(least_max_degree(&problem, &mut unwatched), Err(Unsolved::VertexCaps));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn least_max_degree(problem: &Problem, watch: Watch<'_>) -> Result<u32, Unsolved> {
    match problem.closed_form() {
        Some(least) => Ok(least),
        None => {
            // Refused at once where it may come to nothing.
            if let Domain::Rings(_) = problem.domain {
                return Err(Unsolved::NotAPolygon);
            }
            let range = degree_range(problem, watch)?;
            let max_triples = problem.max_triples();
            if range.is_proven() {
                Ok(range.max_degree)
            } else {
                Err(Unsolved::TooLarge { max_triples })
            }
        }
    }
}

/// The least maximum degree and a triangulation that has it, whatever the limits.
pub(crate) fn least_by_search(
    problem: &Problem,
    chords: &Chords,
    watch: Watch<'_>,
) -> Result<(u32, Vec<[u32; 3]>), Unsolved> {
    let none = problem.no_cap();
    let mut found = any_triangulation(problem, chords, none, watch)?.ok_or(Unsolved::VertexCaps)?;
    // Up in growing steps, then down by halves, since small caps take the least time.
    let least = 4.min(problem.points().len() as u32 - 1);
    let (mut too_small, mut enough) = (least - 1, least.min(none));
    while enough < none {
        if let Some(triangles) = any_triangulation(problem, chords, enough, watch)? {
            found = triangles;
            break;
        }
        let step = enough - too_small;
        (too_small, enough) = (enough, enough.saturating_add(2 * step).min(none));
    }
    while enough - too_small > 1 {
        let middle = too_small + (enough - too_small) / 2;
        match any_triangulation(problem, chords, middle, watch)? {
            Some(triangles) => (enough, found) = (middle, triangles),
            None => too_small = middle,
        }
    }
    Ok((enough, found))
}
