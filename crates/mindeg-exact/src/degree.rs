//! The least maximum degree with its proof, or what is reached and what is known below.

use crate::answer::{Unsolved, least_by_search};
use crate::apex::{ApexBound, apex_bound};
use crate::delaunay::least_tangent;
use crate::problem::{Domain, MANY_EDGES, Problem};
use crate::progress::Watch;
use crate::search::any_triangulation;
use crate::triangulation::Triangulation;
use crate::windows::{WindowGoal, windows};
use crate::zigzag::{self, Found, ZigZag};
use mindeg_core::{least_degree_triangulation, least_max_degree};

/// How many triangles the test for degree 4 may walk through, about a second.
const ZIGZAG_STEPS: u64 = 50_000_000;

/// The shares of the start's smallest tangent at which windows are tried.
const SHARES: [f64; 3] = [0.9, 0.5, 0.0];

/// A triangulation, its maximum degree, and the largest degree that is known to be necessary.
#[derive(Clone, Debug, PartialEq)]
pub struct DegreeRange {
    /// The maximum degree of `triangles`, edges outside included.
    pub max_degree: u32,
    /// No triangulation has a smaller maximum degree than this.
    pub lower_bound: u32,
    /// How `max_degree` was reached.
    pub reached_by: Reached,
    /// Why it cannot be below `lower_bound`.
    pub bounded_by: LowerBound,
    /// The triangles, counter-clockwise.
    pub triangles: Vec<[u32; 3]>,
}

impl DegreeRange {
    /// Whether the maximum degree is proven to be the least.
    #[must_use]
    pub fn is_proven(&self) -> bool {
        self.max_degree == self.lower_bound
    }
}

/// How a maximum degree was reached.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Reached {
    /// By the formula for convex polygons.
    ClosedForm,
    /// By this zig-zag, of degree 4.
    ZigZag(ZigZag),
    /// By windows.
    Windows,
    /// By the dynamic program over all triangulations.
    Exhaustive,
}

/// Why no triangulation has a smaller maximum degree.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum LowerBound {
    /// The formula for convex polygons is optimal (Liu's bounds).
    ClosedForm,
    /// The degrees add up to so many, or one vertex has so many edges outside.
    Counting,
    /// Degree 4 takes one of n zig-zags, and each of them has one of these chords, in the order
    /// of [`ZigZag::all`], which are not admissible.
    BlockedZigZags(Vec<[u32; 2]>),
    /// Too many boundary edges for the vertices that see them.
    Apexes(ApexBound),
    /// The dynamic program over all triangulations finds none of smaller degree.
    Exhaustive,
}

/// The least maximum degree, with what proves it; where that is too much work, the degree
/// reached and a lower bound.
///
/// On a convex polygon without limits by the formula. On other polygons the n zig-zags decide
/// about 4; [`windows()`] give an upper bound, and where that is 5 all is proven; else the dynamic
/// program goes down from there, if the triples of vertices that see each other are within the problem's limit, and
/// it need not go below what a matching of boundary edges to apexes shows to be necessary. With holes there is windows' result and the counting bound.
///
/// # Errors
///
/// Caps of single vertices cannot be kept (or, with holes or beyond exact work, windows do not
/// keep them: [`Unsolved::TooLarge`], [`Unsolved::NotAPolygon`]), or `watch` asked to stop.
///
/// # Example
///
/// ```
/// use glam::DVec2;
/// use mindeg_exact::{LowerBound, Problem, degree_range, unwatched};
///
/// // A star of six points.
/// let at = |corner: u32| {
///     let radius = if corner % 2 == 0 { 3.0 } else { 1.0 };
///     DVec2::from_angle(f64::from(corner) * std::f64::consts::PI / 6.0) * radius
/// };
/// let points: Vec<DVec2> = (0..12).map(at).collect();
/// let tips = (0..6).map(|tip| [(2 * tip + 11) % 12, 2 * tip, 2 * tip + 1]);
/// let triangles: Vec<_> = tips.chain([[1, 3, 5], [1, 5, 7], [1, 7, 9], [1, 9, 11]]).collect();
/// let problem = Problem::triangulated(&points, &Vec::from_iter(0..12), &triangles)?;
///
/// let range = degree_range(&problem, &mut unwatched)?;
/// assert_eq!((range.max_degree, range.lower_bound), (5, 5));
/// assert!(matches!(range.bounded_by, LowerBound::BlockedZigZags(chords) if chords.len() == 12));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn degree_range(problem: &Problem, watch: Watch<'_>) -> Result<DegreeRange, Unsolved> {
    match &problem.domain {
        Domain::Convex(boundary) if problem.is_plain() => {
            let max_degree = least_max_degree(boundary);
            Ok(DegreeRange {
                max_degree,
                lower_bound: max_degree,
                reached_by: Reached::ClosedForm,
                bounded_by: LowerBound::ClosedForm,
                triangles: least_degree_triangulation(boundary).triangles().collect(),
            })
        }
        Domain::Simple(mesh) if problem.is_plain() => polygon(problem, mesh, watch),
        _ => with_limits(problem, watch),
    }
}

/// What the sum of the degrees and the edges outside make necessary.
fn counting_bound(problem: &Problem, triangles: usize) -> u32 {
    let vertices = problem.points().len();
    let outside = |vertex| u64::from(problem.outside_degree(vertex));
    let sum: u64 = (0..vertices as u32).map(outside).sum();
    // Every triangle has three sides, and the boundary edges have one triangle instead of two.
    let mean = (3 * triangles as u64 + vertices as u64 + sum).div_ceil(vertices as u64);
    // Without a hole, an ear has a tip of degree 2, and from four vertices on there is a chord.
    let least = 4.min(vertices as u64 - 1);
    let has_ear = triangles < vertices;
    let busiest = (0..vertices as u32).map(outside).max().unwrap_or(0) + 2;
    mean.max(busiest).max(if has_ear { least } else { 0 }) as u32
}

fn polygon(
    problem: &Problem,
    mesh: &Triangulation,
    watch: Watch<'_>,
) -> Result<DegreeRange, Unsolved> {
    let vertices = problem.points().len();
    let mut lower_bound = counting_bound(problem, mesh.triangles.len());
    let mut bounded_by = LowerBound::Counting;
    if vertices >= 7 {
        match zigzag::find(problem, mesh, ZIGZAG_STEPS) {
            Found::ZigZag(zigzag) => {
                return Ok(DegreeRange {
                    max_degree: 4,
                    lower_bound,
                    reached_by: Reached::ZigZag(zigzag),
                    bounded_by,
                    triangles: zigzag.triangles().collect(),
                });
            }
            Found::Blocked(chords) => {
                (lower_bound, bounded_by) = (5, LowerBound::BlockedZigZags(chords));
            }
            Found::Unknown => {}
        }
    }
    let (max_degree, triangles) = by_windows(problem, mesh, lower_bound, watch)?;
    let reached_by = Reached::Windows;
    let mut range = DegreeRange { max_degree, lower_bound, reached_by, bounded_by, triangles };
    if range.is_proven() {
        return Ok(range);
    }
    let Ok(chords) = problem.chords() else { return Ok(range) };
    if let Some(bound) = apex_bound(&chords)
        && bound.max_degree() > range.lower_bound
    {
        range.lower_bound = bound.max_degree();
        range.bounded_by = LowerBound::Apexes(bound);
    }
    while !range.is_proven() {
        match any_triangulation(problem, &chords, range.max_degree - 1, watch)? {
            Some(triangles) => {
                range.max_degree -= 1;
                range.reached_by = Reached::Exhaustive;
                range.triangles = triangles;
            }
            None => {
                range.lower_bound = range.max_degree;
                range.bounded_by = LowerBound::Exhaustive;
            }
        }
    }
    Ok(range)
}

/// The least degree that windows reach, at as large an angle as they reach it.
fn by_windows(
    problem: &Problem,
    mesh: &Triangulation,
    lower_bound: u32,
    watch: Watch<'_>,
) -> Result<(u32, Vec<[u32; 3]>), Unsolved> {
    let start = least_tangent(mesh, problem.points(), problem.sides());
    let mut best: Option<(u32, Vec<[u32; 3]>)> = None;
    for share in SHARES {
        let goal = WindowGoal { max_degree: lower_bound, min_tangent: share * start };
        let windowed = windows(problem, goal, watch)?;
        if best.as_ref().is_none_or(|(degree, _)| windowed.max_degree < *degree) {
            best = Some((windowed.max_degree, windowed.triangles));
        }
        if best.as_ref().is_some_and(|(degree, _)| *degree == lower_bound) {
            break;
        }
    }
    Ok(best.expect("some share was tried"))
}

fn with_limits(problem: &Problem, watch: Watch<'_>) -> Result<DegreeRange, Unsolved> {
    let lower_bound = counting_bound(problem, problem.triangulation().triangles.len());
    let goal = WindowGoal { max_degree: lower_bound, min_tangent: 0.0 };
    let windowed = windows(problem, goal, watch)?;
    let range = DegreeRange {
        max_degree: windowed.max_degree,
        lower_bound,
        reached_by: Reached::Windows,
        bounded_by: LowerBound::Counting,
        triangles: windowed.triangles,
    };
    let are_told_apart = range.max_degree < MANY_EDGES;
    if windowed.keeps_vertex_limits && range.is_proven() && are_told_apart {
        return Ok(range);
    }
    let chords = match problem.chords_or_refusal() {
        Ok(chords) => chords,
        Err(_) if windowed.keeps_vertex_limits => return Ok(range),
        Err(refusal) => return Err(refusal),
    };
    let (least, triangles) = least_by_search(problem, &chords, watch)?;
    Ok(DegreeRange {
        max_degree: least,
        lower_bound: least,
        reached_by: Reached::Exhaustive,
        bounded_by: LowerBound::Exhaustive,
        triangles,
    })
}
