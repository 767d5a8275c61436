//! One domain, triangulated by every method.

use crate::figures::{DefectKind, DomainFigures, MethodDefect, MethodFigures};
use crate::interior;
use crate::reference::Reference;
use crate::report::{Provenance, Report};
use crate::{Method, NoTriangulation, measure, regions, verdict};
use glam::DVec2;
use mindeg::exact::{self, ExactMesh, TradeOff};
use mindeg::{Domain, Goal, MeshError, Progress, Rings};
use mindeg_answers::advice::{Advice, AdvisedMesh, FEWEST, KEPT, Purpose, advised_interior};
use mindeg_answers::on_edges::is_poor;
use mindeg_answers::trade_off::TradeOffAnswer;
use mindeg_mesh::planar::PlanarBoundary;
use std::time::{Duration, Instant};

/// The largest number of boundary vertices that can be compared: unlike mindeg's own meshes,
/// the others are lists in memory.
pub const MAX_COMPARED_VERTICES: u32 = 10_000_000;

/// The limits of a comparison.
///
/// ```
/// assert_eq!(mindeg_compare::CompareOptions::default().time_limit.as_secs(), 60);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CompareOptions {
    /// How long each method may take, 60 seconds unless told otherwise. The report lists one
    /// that takes longer as such.
    pub time_limit: Duration,
    /// The largest number of boundary vertices for which the exact trade-off is worked out, 400
    /// unless told otherwise: about a second's work.
    pub exact_vertices: u32,
    /// Whether the mesh with points inside is compared with a refinement, too, and made on domains of any size; not unless
    /// told otherwise.
    pub interior: bool,
    /// The purpose of the mesh, if that is known.
    pub purpose: Option<Purpose>,
}

impl Default for CompareOptions {
    fn default() -> Self {
        Self {
            time_limit: Duration::from_secs(60),
            exact_vertices: 400,
            interior: false,
            purpose: None,
        }
    }
}

/// Why a domain cannot be compared.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CompareError {
    /// More vertices than [`MAX_COMPARED_VERTICES`].
    #[error(
        "the domain has {vertices} boundary vertices, and a comparison keeps whole meshes in \
         memory: at most {MAX_COMPARED_VERTICES} can be compared; use fewer intervals"
    )]
    TooManyVertices {
        /// How many there are.
        vertices: u32,
    },
    /// The domain cannot be meshed.
    #[error(transparent)]
    Mesh(#[from] MeshError),
}

/// A domain's triangulations with their figures.
///
/// # Example
///
/// ```
/// use mindeg_compare::{CompareOptions, compare};
/// use mindeg::{Domain, Side};
///
/// let sides = [1000, 3, 5, 2].map(Side::count).to_vec();
/// let comparison = compare(&Domain::rectangle(4.0, 3.0, sides)?, &CompareOptions::default())?;
/// let degrees = comparison.report().methods.iter().map(|method| method.max_degree);
/// // mindeg, Delaunay, ear clipping, and a fan from the middle of the side of 2.
/// assert_eq!(degrees.take(4).collect::<Vec<_>>(), [Some(114), Some(379), Some(1009), Some(1009)]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Comparison {
    report: Report,
    boundary: PlanarBoundary,
    /// The points of the boundary and of lines and points inside, then those of [`Method::Inside`].
    points: Vec<DVec2>,
    /// How many of them all other methods have.
    shared_points: usize,
    /// The rings of the domain as closed lines, and the lines inside.
    outlines: Vec<Vec<DVec2>>,
    /// The triangles of each method of the report; empty for a method without a mesh.
    triangles: Vec<Vec<[u32; 3]>>,
    trade_off: Option<TradeOff>,
}

impl Comparison {
    /// The figures.
    #[must_use]
    pub fn report(&self) -> &Report {
        &self.report
    }

    /// The boundary points, in the order of the vertices, those of lines and points inside, and for
    /// [`Method::Inside`] those that it has besides.
    #[must_use]
    pub fn points(&self, method: Method) -> &[DVec2] {
        match method {
            Method::Inside => &self.points,
            _ => &self.points[..self.shared_points],
        }
    }

    /// The rings of the domain as closed lines, and the lines inside.
    pub(crate) fn outlines(&self) -> &[Vec<DVec2>] {
        &self.outlines
    }

    pub(crate) fn boundary(&self) -> &PlanarBoundary {
        &self.boundary
    }

    /// The methods of the report, each with its triangles; empty for a method without a mesh.
    pub fn methods(&self) -> impl ExactSizeIterator<Item = (&MethodFigures, &[[u32; 3]])> {
        self.report.methods.iter().zip(self.triangles.iter().map(Vec::as_slice))
    }

    /// The triangles of the method with the given index in the report.
    pub(crate) fn triangles(&self, method: usize) -> &[[u32; 3]] {
        &self.triangles[method]
    }

    /// The trade-off of degree and angle on the domain, if it was computed.
    #[must_use]
    pub fn trade_off(&self) -> Option<&TradeOff> {
        self.trade_off.as_ref()
    }

    /// The same comparison without the times taken: what is left depends on the domain alone.
    #[must_use]
    pub fn without_times(mut self) -> Self {
        for method in &mut self.report.methods {
            method.seconds = None;
        }
        for figures in &mut self.report.interior {
            figures.seconds = None;
        }
        self
    }

    /// The same comparison with what made it, for reports to say.
    #[must_use]
    pub fn made_by(mut self, provenance: Provenance) -> Self {
        self.report.provenance = provenance;
        self
    }
}

/// Triangulates a domain by every method, checks and measures the results.
///
/// A reference that fails is part of the report. The exact trade-off and its meshes are added for
/// domains up to [`CompareOptions::exact_vertices`]. O(n log n) besides what the methods take.
///
/// # Errors
///
/// Too many vertices, or a domain on which mindeg itself has no mesh.
pub fn compare(domain: &Domain, options: &CompareOptions) -> Result<Comparison, CompareError> {
    let vertices = domain.rings().vertex_count();
    if vertices > MAX_COMPARED_VERTICES {
        return Err(CompareError::TooManyVertices { vertices });
    }
    if domain.is_constrained() {
        return Err(MeshError::Constrained.into());
    }
    let start = Instant::now();
    let meshed = mindeg::mesh(domain, Goal::LeastDegree, Progress::NONE)?;
    let own: Vec<[u32; 3]> = meshed.mesh.triangles().collect();
    let own_time = start.elapsed();

    let boundary = domain.boundary().map_err(MeshError::from)?.into_owned();
    let at_least = meshed.least_max_degree;
    let checker = measure::Checker::new(domain, &boundary, meshed.mesh.triangle_count());
    let figures = |method, triangles: &[[u32; 3]]| MethodFigures {
        method,
        description: method.description().into_owned(),
        ..measure::figures(&checker, triangles, at_least)
    };
    let mut methods = vec![MethodFigures {
        seconds: Some(own_time.as_secs_f64()),
        ..figures(Method::LeastDegree, &own)
    }];
    let mut triangles = vec![own];
    for &reference in Reference::of(domain) {
        let method = Method::Reference(reference);
        let outcome = reference.triangulate(domain, &boundary, options.time_limit);
        let (measured, list) = match outcome {
            Ok(timed) => {
                let measured = figures(method, &timed.triangles);
                let seconds = Some(timed.time.as_secs_f64());
                (MethodFigures { seconds, ..measured }, timed.triangles)
            }
            Err(reason) => (without_triangles(method, &reason), Vec::new()),
        };
        methods.push(measured);
        triangles.push(list);
    }
    let trade_off = exact_trade_off(domain, options);
    for exact in trade_off.iter().flat_map(shown) {
        let list: Vec<[u32; 3]> = exact.mesh.triangles().collect();
        methods.push(figures(Method::Exact { max_degree: exact.max_degree }, &list));
        triangles.push(list);
    }
    let mut points = regions::points(&boundary).into_owned();
    let shared_points = points.len();
    let wanted = match options.interior {
        true => domain.interior().cloned().unwrap_or_default(),
        false => advised_interior(domain),
    };
    let inside = interior::inside(domain, &wanted, options.time_limit);
    let [patch, fewest] =
        [Goal::KeepAngle(KEPT), FEWEST].map(|goal| mindeg::mesh(domain, goal, Progress::NONE).ok());
    let mut advice = Advice::among(
        inside
            .as_ref()
            .map(|(found, _)| AdvisedMesh::of_interior(&found.report))
            .map_err(Into::into),
        patch.as_ref().map(AdvisedMesh::of),
        fewest.as_ref().map(AdvisedMesh::of),
    );
    if inside.as_ref().is_ok_and(|(found, _)| is_poor(found)) {
        let start = Instant::now();
        let in_time = Progress::while_it(|| start.elapsed() < options.time_limit);
        let own = std::slice::from_ref(domain);
        advice = advice.and_points_on_edges(own, Progress::new(&in_time));
    }
    // Where the trade-off was not worked out, no method has these meshes.
    let advised = [(patch, Method::Kept), (fewest, Method::Fewest)];
    for (advised, method) in advised.into_iter().filter(|_| trade_off.is_none()) {
        let Some(advised) = advised else { continue };
        let list: Vec<[u32; 3]> = advised.mesh.triangles().collect();
        methods.push(figures(method, &list));
        triangles.push(list);
    }
    let mut interior = Vec::new();
    if options.interior {
        interior = interior::beside(domain, &inside, options.time_limit);
    }
    if let Ok((found, seconds)) = inside {
        points = interior::points(&found);
        let list = found.mesh.triangles();
        methods.push(MethodFigures {
            method: Method::Inside,
            description: Method::Inside.description().into_owned(),
            seconds: Some(seconds),
            ..measure::figures_inside(domain, &boundary, &points, list)
        });
        triangles.push(list.to_vec());
    }
    mark_same_meshes(&mut methods, &triangles);
    let rings = domain.rings();
    let outlines = outlines(domain, &boundary);
    let triangle_count = meshed.mesh.triangle_count();
    let edge_count = measure::degrees(&boundary, &triangles[0]).iter().sum::<u32>() / 2;
    let domain = DomainFigures {
        name: domain.name().map(str::to_owned),
        intervals: rings.sides().collect(),
        side_lengths: side_lengths(&boundary, rings),
        side_names: domain.sides().iter().map(|side| side.name.clone()).collect(),
        corners: domain.placement().corners().iter().map(DVec2::to_array).collect(),
        vertices: meshed.mesh.vertex_count(),
        holes: domain.hole_count() as u32,
        regions: regions::regions(domain),
        triangles: triangle_count,
        // An edge on the boundary is of one triangle, any other of two.
        interior_edges: 3 * triangle_count - edge_count,
        at_least,
        least_max_degree: meshed.is_least_proven.then_some(at_least),
    };
    let mut report = Report {
        provenance: Provenance::default(),
        domain,
        purpose: options.purpose,
        advice,
        methods,
        trade_off: trade_off.as_ref().map(TradeOffAnswer::of),
        interior,
        verdict: String::new(),
    };
    report.verdict = verdict::verdict(&report).text();
    Ok(Comparison { report, boundary, points, shared_points, outlines, triangles, trade_off })
}

/// The sum of the lengths of each side's intervals.
fn side_lengths(boundary: &PlanarBoundary, rings: &Rings) -> Vec<f64> {
    let at = |vertex: u32| boundary.points()[vertex as usize];
    let length = |side: usize| {
        let first = rings.corner(side);
        let edges = (first..first + rings.intervals(side)).map(|v| (at(v), at(boundary.next(v))));
        edges.map(|(from, to)| from.distance(to)).sum()
    };
    (0..rings.side_count()).map(length).collect()
}

/// The rings as closed lines, of straight sides the corners, of others all points; and each edge of the lines inside.
fn outlines(domain: &Domain, boundary: &PlanarBoundary) -> Vec<Vec<DVec2>> {
    let (rings, placement) = (domain.rings(), domain.placement());
    let line = |ring: usize| {
        let sides = rings.ring_sides(ring).flat_map(|side| {
            let first = rings.corner(side);
            let shown = if domain.is_straight(side) { 1 } else { rings.intervals(side) };
            first..first + shown
        });
        let start = rings.ring(ring).start;
        sides.chain([start]).map(|vertex| placement.point(vertex)).collect()
    };
    let inside =
        boundary.segments().iter().map(|ends| ends.map(|end| boundary.point(end)).to_vec());
    (0..rings.ring_count()).map(line).chain(inside).collect()
}

/// The trade-off, if the size and the time allow it.
fn exact_trade_off(domain: &Domain, options: &CompareOptions) -> Option<TradeOff> {
    if domain.rings().vertex_count() > options.exact_vertices {
        return None;
    }
    let start = Instant::now();
    let in_time = Progress::while_it(|| start.elapsed() < options.time_limit);
    // A trade-off found by windows is not exact.
    exact::trade_off(domain, Progress::new(&in_time)).ok().filter(TradeOff::is_exact)
}

/// The points of the curve that a comparison shows: the least degree, the next, the first
/// with enough of the angle and the first with all of it.
fn shown(trade_off: &TradeOff) -> impl Iterator<Item = &ExactMesh> {
    let meshes = trade_off.meshes();
    let last = meshes.len().saturating_sub(1);
    let kept = trade_off.keeping(KEPT).map(|exact| exact.max_degree);
    let is_kept = move |place: usize| Some(meshes[place].max_degree) == kept;
    let is_shown = move |place| place < 2 || is_kept(place) || place == last;
    meshes.iter().enumerate().filter(move |&(place, _)| is_shown(place)).map(|(_, mesh)| mesh)
}

/// Notes of every method which one before it has the same triangles.
fn mark_same_meshes(methods: &mut [MethodFigures], triangles: &[Vec<[u32; 3]>]) {
    // Meshes that differ mostly have different histograms; few are sorted to be compared.
    let sorted = |triangles: &[[u32; 3]]| {
        let mut sorted = triangles.to_vec();
        for triangle in &mut sorted {
            let first = (0..3).min_by_key(|&corner| triangle[corner]).unwrap_or(0);
            triangle.rotate_left(first);
        }
        sorted.sort_unstable();
        sorted
    };
    for place in 0..methods.len() {
        let method = &methods[place];
        let same = method.outcome().and_then(|(degree, _)| {
            (0..place).find(|&other| {
                let other_degree = methods[other].outcome().map(|(degree, _)| degree);
                other_degree == Some(degree)
                    && methods[other].degree_histogram == method.degree_histogram
                    && sorted(&triangles[other]) == sorted(&triangles[place])
            })
        });
        methods[place].same_mesh_as = same.map(|other| methods[other].method);
    }
}

fn without_triangles(method: Method, reason: &NoTriangulation) -> MethodFigures {
    let kind = match reason {
        NoTriangulation::TimeLimit { .. } => DefectKind::TimeLimit,
        _ => DefectKind::NoTriangles,
    };
    let defect = MethodDefect { kind, count: None, message: reason.to_string() };
    MethodFigures {
        method,
        description: method.description().into_owned(),
        defects: vec![defect],
        ..MethodFigures::default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use mindeg::Side;

    #[test]
    fn what_is_late_is_reported_and_the_rest_goes_on() {
        let domain = Domain::rectangle(4.0, 3.0, vec![Side::count(4000); 4]).unwrap();
        let options =
            CompareOptions { time_limit: Duration::from_millis(1), ..CompareOptions::default() };
        let comparison = compare(&domain, &options).unwrap();
        let report = comparison.report();
        assert!(report.methods[0].valid);
        for method in &report.methods[1..3] {
            assert_eq!(method.defects[0].kind, DefectKind::TimeLimit, "{}", method.method);
            assert_eq!((method.valid, method.max_degree, method.seconds), (false, None, None));
        }
        assert!(report.verdict.starts_with(
            "There is no Delaunay triangulation to compare with: it did not finish within the \
             time limit of 0.001 s. mindeg has at most 4 edges at a vertex, the least possible,"
        ));
    }

    #[test]
    fn too_large_a_domain_is_refused_at_once() {
        let domain = Domain::rectangle(4.0, 3.0, vec![Side::count(3_000_000); 4]).unwrap();
        let refusal = compare(&domain, &CompareOptions::default()).unwrap_err();
        assert_eq!(
            refusal.to_string(),
            "the domain has 12000000 boundary vertices, and a comparison keeps whole meshes in \
             memory: at most 10000000 can be compared; use fewer intervals"
        );
    }

    /// A ring of lines round a region that is a hole, and a line that ends inside.
    #[test]
    fn regions_that_are_holes_have_no_triangles() {
        let map = r#"{"rectangle": {"width": 4, "height": 3}, "size": 1,
            "lines": [{"corners": [[1, 1], [2, 1], [2, 2], [1, 2]], "closed": true}LINE],
            "regions": [{"at": [1.5, 1.5], "hole": true}, {"at": [3.5, 0.5]}]}"#;
        for (line, vertices, ears) in
            [("", 18, true), (r#", {"corners": [[4, 2], [3, 2]]}"#, 19, false)]
        {
            let domain = Domain::from_json(&map.replace("LINE", line)).unwrap();
            let comparison = compare(&domain, &CompareOptions::default()).unwrap();
            let DomainFigures { regions, holes, vertices: all, triangles, interior_edges, .. } =
                comparison.report().domain;
            assert_eq!((regions, holes, all), (Some(1), 1, vertices));
            // By Euler's formula, with 18 edges on the boundary.
            assert_eq!((triangles, interior_edges), (2 * vertices - 18, 3 * vertices - 36));
            let [own, delaunay, ear_clipping, ..] = &comparison.report().methods[..] else {
                panic!("{line}")
            };
            assert!(own.valid && delaunay.valid, "{:?}", delaunay.defects);
            let refuses = |defect: &MethodDefect| {
                defect.message.starts_with("ear clipping takes rings alone")
            };
            assert_eq!(ear_clipping.defects.iter().any(refuses), !ears, "{ear_clipping:?}");
        }
    }

    #[test]
    fn every_method_has_its_triangles_and_they_have_the_edges() {
        let frame = r#"{"rectangle": {"width": 6, "height": 4}, "size": 1,
            "holes": [{"corners": [[2, 1], [4, 1], [4, 3], [2, 3]]}]}"#;
        let plate = r#"{"rectangle": {"width": 4, "height": 3}, "size": 1}"#;
        for (text, holes) in [(plate, 0), (frame, 1)] {
            let comparison =
                compare(&Domain::from_json(text).unwrap(), &CompareOptions::default()).unwrap();
            let report = comparison.report();
            assert_eq!(report.domain.holes, holes);
            for (place, (method, triangles)) in comparison.methods().enumerate() {
                assert_eq!(comparison.triangles(place), triangles, "{}", method.method);
                if method.valid && method.method != Method::Inside {
                    assert_eq!(triangles.len() as u32, report.domain.triangles);
                    // Each triangle has three sides; two triangles share each side that is not on the boundary.
                    let inner_sides = 3 * triangles.len() as u32 - report.domain.vertices;
                    assert_eq!(report.domain.interior_edges, inner_sides / 2);
                }
            }
            assert!(report.methods[0].valid && !comparison.triangles(0).is_empty());
        }
    }

    /// The last side of a ring ends at its first corner, and a curve is longer than its chord.
    #[test]
    fn sides_have_their_own_lengths() {
        let text = r#"{"polygon": {"corners": [[0,0],[4,0],[4,4],[0,4]]}, "size": 1,
            "sides": [{}, {}, {"intervals": 400, "arc": {"through": [2, 6]}}, {}],
            "holes": [{"corners": [[1, 1], [3, 1], [3, 2]]}]}"#;
        let comparison =
            compare(&Domain::from_json(text).unwrap(), &CompareOptions::default()).unwrap();
        let lengths = &comparison.report().domain.side_lengths;
        let half_circle = 2.0 * std::f64::consts::PI;
        let mut hole = [lengths[4], lengths[5], lengths[6]];
        hole.sort_by(f64::total_cmp);
        for (found, expected) in lengths[..4].iter().chain(&hole).zip([
            4.0,
            4.0,
            half_circle,
            4.0,
            1.0,
            2.0,
            5.0_f64.sqrt(),
        ]) {
            assert!((found - expected).abs() < 1e-4, "{lengths:?}");
        }
    }

    #[test]
    fn outlines_have_the_corners_and_all_points_of_curves() {
        let text = r#"{"polygon": {"corners": [[0,0],[4,0],[4,4],[0,4]]}, "size": 1,
            "sides": [{}, {}, {"intervals": 4, "arc": {"through": [2, 6]}}, {}]}"#;
        let domain = Domain::from_json(text).unwrap();
        let lines = outlines(&domain, &domain.boundary().unwrap());
        assert_eq!(lines.len(), 1);
        // Corners are vertices 0, 4, 8 and 12; the arc goes from 8 to 12.
        let shown = [0, 4, 8, 9, 10, 11, 12, 0].map(|vertex| domain.placement().point(vertex));
        assert_eq!(lines[0], shown);
    }

    #[test]
    fn of_a_long_curve_the_first_two_the_advised_and_the_last_are_shown() {
        let domain = Domain::rectangle(4.0, 3.0, [40, 2, 2, 2].map(Side::count).into()).unwrap();
        let trade_off = exact_trade_off(&domain, &CompareOptions::default()).unwrap();
        let all = trade_off.meshes().iter().map(|exact| exact.max_degree);
        assert_eq!(all.collect::<Vec<_>>(), [11, 12, 13, 14, 15, 16, 17]);
        // Degree 16 is the first with 95% of the angle.
        let shown = shown(&trade_off).map(|exact| exact.max_degree);
        assert_eq!(shown.collect::<Vec<_>>(), [11, 12, 16, 17]);
    }
}
