//! The least maximum degree with its proof, or what is reached and what is known below.

use crate::apex::{ApexBound, apex_bound};
use crate::cover::Refutation;
use crate::feasibility::{any_triangulation, least_by_search};
use crate::linked::Linked;
use crate::measure::least_tangent;
use crate::problem::{Domain, Problem};
use crate::unsolved::Unsolved;
use crate::windows::windows;
use crate::zigzag::{self, Found, ZigZag};
use mindeg_core::{least_degree_triangulation, least_max_degree};
use mindeg_mesh::Progress;

mod descent;
mod rings;

/// The most triangles that the test for degree 4 walks through, about a second.
const ZIGZAG_STEPS: u64 = 50_000_000;

/// The shares of the given triangulation's minimum tangent that windows keep, one after the other.
const SHARES: [f64; 3] = [0.9, 0.5, 0.0];

/// The shares that the dynamic program keeps.
const SEARCHED_SHARES: [f64; 2] = [0.5, 0.0];

/// A triangulation, its maximum degree, and a lower bound on the maximum degree of all.
#[derive(Clone, Debug, PartialEq)]
pub struct DegreeRange {
    /// The maximum degree of `triangles`, external edges included.
    pub max_degree: u32,
    /// No triangulation has a smaller maximum degree than this.
    pub lower_bound: u32,
    /// The method that reached `max_degree`.
    pub reached_by: Reached,
    /// The proof of `lower_bound`.
    pub bounded_by: LowerBound,
    /// The triangles, counter-clockwise.
    pub triangles: Vec<[u32; 3]>,
}

impl DegreeRange {
    /// Takes a bound if it is larger.
    fn raise(&mut self, bound: Option<ApexBound>) {
        if let Some(bound) = bound
            && bound.max_degree() > self.lower_bound
        {
            self.lower_bound = bound.max_degree();
            self.bounded_by = LowerBound::Apexes(bound);
        }
    }

    /// Whether the maximum degree is proven to be the least.
    #[must_use]
    pub fn is_proven(&self) -> bool {
        self.max_degree == self.lower_bound
    }

    /// Whether the work may end: the degree is proven, or the problem's wanted degree is reached or excluded.
    fn is_decided(&self, problem: &Problem) -> bool {
        let wanted = problem.wanted_degree;
        self.is_proven()
            || wanted.is_some_and(|wanted| self.max_degree <= wanted || wanted < self.lower_bound)
    }

    /// Takes the triangles of a search.
    fn reach(&mut self, problem: &Problem, triangles: Vec<[u32; 3]>) {
        self.max_degree = problem.max_degree_of(&triangles);
        self.reached_by = Reached::Search;
        self.triangles = triangles;
    }
}

/// The method that reached a maximum degree.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Reached {
    /// The formula for convex polygons.
    ClosedForm,
    /// This zig-zag, of degree 4.
    ZigZag(ZigZag),
    /// Windows.
    Windows,
    /// The dynamic program over all triangulations.
    Exhaustive,
    /// The strip between the rings of a domain with one hole, of degree 4.
    Strip,
    /// The search with learned clauses over all triangulations, [`Cover`](crate::Cover).
    Search,
    /// Windows, of which some make other vertices worse for a while.
    Descent,
}

/// Why no triangulation has a smaller maximum degree.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum LowerBound {
    /// Liu's bounds, which the formula for convex polygons reaches.
    ClosedForm,
    /// The sum of the degrees, or the external degree of one vertex.
    Counting,
    /// Degree 4 needs one of n zig-zags, and each has a chord that is not admissible: these, in the
    /// order of [`ZigZag::all`].
    BlockedZigZags(Vec<[u32; 2]>),
    /// Too many boundary edges for the vertices that can be their apexes.
    Apexes(ApexBound),
    /// The dynamic program over all triangulations, which finds none of smaller degree.
    Exhaustive,
    /// Degree 4 needs a strip between the rings of a domain with one hole, and none is a triangulation.
    NoStrip,
    /// Clauses prove that no triangulation has a smaller degree, or keeps the limits with it.
    Refuted(Refutation),
}

/// The least maximum degree with its proof; if that takes too much work, a degree that is reached
/// and a lower bound.
///
/// The formula answers for a convex polygon without limits. On other polygons:
///
/// 1. The n zig-zags decide whether degree 4 is possible.
/// 2. [`windows()`] give an upper bound; 5 is then proven.
/// 3. A matching of boundary edges to apexes gives a lower bound.
/// 4. The dynamic program halves what is left between the bounds, if the triples of vertices that
///    see each other are within the problem's limit.
///
/// With holes, windows give the upper bound, and the sum of the degrees or the apexes the lower one. The strips
/// between two rings decide about degree 4. A [`Cover`](crate::Cover) decides the degrees between the bounds, at first
/// with few steps, and then after windows that may make other vertices worse for a while, within
/// [`Problem::set_max_steps`].
///
/// # Errors
///
/// - [`Unsolved::VertexLimits`]: no triangulation keeps the degree limits of single vertices.
/// - [`Unsolved::TooLarge`], [`Unsolved::Undecided`]: windows do not keep these limits, and the
///   polygon is too large for exact work, or a search with holes takes too many steps.
/// - [`Unsolved::Cancelled`]: `progress` cancelled the work.
///
/// # Example
///
/// ```
/// use glam::DVec2;
/// use mindeg_exact::{LowerBound, Problem, Progress, degree_range};
/// use mindeg_mesh::planar::PlanarBoundary;
///
/// // A star of six points.
/// let at = |corner: u32| {
///     let radius = if corner % 2 == 0 { 3.0 } else { 1.0 };
///     DVec2::from_angle(f64::from(corner) * std::f64::consts::PI / 6.0) * radius
/// };
/// let points: Vec<DVec2> = (0..12).map(at).collect();
/// let tips = (0..6).map(|tip| [(2 * tip + 11) % 12, 2 * tip, 2 * tip + 1]);
/// let triangles: Vec<_> = tips.chain([[1, 3, 5], [1, 5, 7], [1, 7, 9], [1, 9, 11]]).collect();
/// let problem = Problem::triangulated(&PlanarBoundary::new(&[points])?, &triangles)?;
///
/// let range = degree_range(&problem, Progress::NONE)?;
/// assert_eq!((range.max_degree, range.lower_bound), (5, 5));
/// assert!(matches!(range.bounded_by, LowerBound::BlockedZigZags(chords) if chords.len() == 12));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn degree_range(problem: &Problem, progress: Progress<'_>) -> Result<DegreeRange, Unsolved> {
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
        Domain::Simple(mesh) if problem.is_plain() => polygon(problem, mesh, progress),
        Domain::Rings(mesh) if problem.is_plain() => {
            DegreeRange::with_holes(problem, mesh, progress)
        }
        _ => with_limits(problem, progress),
    }
}

/// The lower bound from the sum of the degrees and from external degrees.
fn counting_bound(problem: &Problem, triangles: usize) -> u32 {
    let vertices = problem.points().len();
    let external = |vertex| u64::from(problem.external_degree(vertex));
    let sum: u64 = (0..vertices as u32).map(external).sum();
    // Every triangle has three sides, and the boundary edges have one triangle instead of two.
    let mean = (3 * triangles as u64 + vertices as u64 + sum).div_ceil(vertices as u64);
    // Without a hole, an ear has a tip of degree 2, and from four vertices on there is a chord.
    let least = 4.min(vertices as u64 - 1);
    let has_ear = triangles < vertices;
    let largest = (0..vertices as u32).map(external).max().unwrap_or(0) + 2;
    mean.max(largest).max(if has_ear { least } else { 0 }) as u32
}

/// A lower bound on the maximum degree of all triangulations, with its proof, in little time: from
/// the sum of the degrees and external degrees, and, of a polygon without holes or limits, from the
/// zig-zags.
#[must_use]
pub fn lower_bound(problem: &Problem) -> (u32, LowerBound) {
    match &problem.domain {
        Domain::Convex(boundary) if problem.is_plain() => {
            (least_max_degree(boundary), LowerBound::ClosedForm)
        }
        Domain::Simple(mesh) if problem.is_plain() => match zigzags(problem, mesh) {
            Some(Found::Blocked(chords)) => (5, LowerBound::BlockedZigZags(chords)),
            _ => (counting_bound(problem, mesh.triangles.len()), LowerBound::Counting),
        },
        Domain::Convex(_) | Domain::Simple(_) | Domain::Rings(_) => {
            let triangles = match &problem.domain {
                Domain::Convex(boundary) => boundary.vertex_count() as usize - 2,
                Domain::Simple(mesh) | Domain::Rings(mesh) => mesh.triangles.len(),
            };
            (counting_bound(problem, triangles), LowerBound::Counting)
        }
    }
}

/// The test of all zig-zags, from the number of vertices on for which it decides about degree 4.
fn zigzags(problem: &Problem, mesh: &Linked) -> Option<Found> {
    (problem.points().len() >= 7).then(|| zigzag::find(problem, mesh, ZIGZAG_STEPS))
}

fn polygon(
    problem: &Problem,
    mesh: &Linked,
    progress: Progress<'_>,
) -> Result<DegreeRange, Unsolved> {
    let vertices = problem.points().len();
    let (lower_bound, bounded_by) = match zigzags(problem, mesh) {
        Some(Found::ZigZag(zigzag)) => {
            return Ok(DegreeRange {
                max_degree: 4,
                lower_bound: 4,
                reached_by: Reached::ZigZag(zigzag),
                bounded_by: LowerBound::Counting,
                triangles: zigzag.triangles().collect(),
            });
        }
        Some(Found::Blocked(chords)) => (5, LowerBound::BlockedZigZags(chords)),
        _ => (counting_bound(problem, mesh.triangles.len()), LowerBound::Counting),
    };
    let (max_degree, triangles) = by_windows(problem, mesh, lower_bound, progress)?;
    let reached_by = Reached::Windows;
    let mut range = DegreeRange { max_degree, lower_bound, reached_by, bounded_by, triangles };
    if range.is_decided(problem) {
        return Ok(range);
    }
    let chords = match problem.visible_chords(progress) {
        Err(Unsolved::TooLarge { .. }) => return Ok(range),
        chords => chords?,
    };
    let next: Vec<u32> = (1..vertices as u32).chain([0]).collect();
    range.raise(apex_bound(&next, chords.ends()));
    if range.is_decided(problem) {
        return Ok(range);
    }
    match problem.require_triples(chords, progress) {
        Err(Unsolved::TooLarge { .. }) => return Ok(range),
        within => within?,
    }
    let start = least_tangent(problem.points(), &mesh.triangles);
    while !range.is_decided(problem) {
        // The lower half first: a smaller limit takes less time, and windows are seldom far off.
        let middle = range.lower_bound + (range.max_degree - 1 - range.lower_bound) / 2;
        let max_degree = problem.wanted_degree.unwrap_or(middle);
        let mut found = None;
        for share in SEARCHED_SHARES {
            found = any_triangulation(problem, chords, max_degree, share * start, progress)?;
            if found.is_some() {
                break;
            }
        }
        match found {
            Some(triangles) => {
                (range.max_degree, range.reached_by) = (max_degree, Reached::Exhaustive);
                range.triangles = triangles;
            }
            None => {
                range.lower_bound = max_degree + 1;
                range.bounded_by = LowerBound::Exhaustive;
            }
        }
    }
    Ok(range)
}

/// The least degree that windows reach, with the largest of the shares that reaches it; that of the given mesh
/// where the bound excludes the wanted degree.
fn by_windows(
    problem: &Problem,
    mesh: &Linked,
    lower_bound: u32,
    progress: Progress<'_>,
) -> Result<(u32, Vec<[u32; 3]>), Unsolved> {
    let enough = problem.wanted_degree.unwrap_or(lower_bound);
    if enough < lower_bound {
        return Ok((problem.max_degree_of(&mesh.triangles), mesh.triangles.clone()));
    }
    let start = least_tangent(problem.points(), &mesh.triangles);
    let mut best: Option<(u32, Vec<[u32; 3]>)> = None;
    for share in SHARES {
        let windowed = windows(problem, enough, share * start, progress)?;
        if best.as_ref().is_none_or(|(degree, _)| windowed.max_degree < *degree) {
            best = Some((windowed.max_degree, windowed.triangles));
        }
        if best.as_ref().is_some_and(|(degree, _)| *degree <= enough) {
            break;
        }
    }
    Ok(best.expect("some share was tried"))
}

fn with_limits(problem: &Problem, progress: Progress<'_>) -> Result<DegreeRange, Unsolved> {
    let lower_bound = counting_bound(problem, problem.triangulation().triangles.len());
    let windowed = windows(problem, lower_bound, 0.0, progress)?;
    let mut range = DegreeRange {
        max_degree: problem.max_degree_of(&windowed.triangles),
        lower_bound,
        reached_by: Reached::Windows,
        bounded_by: LowerBound::Counting,
        triangles: windowed.triangles,
    };
    if windowed.keeps_vertex_limits && range.is_proven() {
        return Ok(range);
    }
    if let Domain::Rings(_) = problem.domain {
        return range.within_limits(problem, windowed.keeps_vertex_limits, progress);
    }
    let chords = match problem.chords(progress) {
        Err(Unsolved::TooLarge { .. }) if windowed.keeps_vertex_limits => return Ok(range),
        chords => chords?,
    };
    let (least, triangles) = least_by_search(problem, chords, progress)?;
    range = DegreeRange {
        max_degree: least,
        lower_bound: least,
        reached_by: Reached::Exhaustive,
        bounded_by: LowerBound::Exhaustive,
        triangles,
    };
    Ok(range)
}
