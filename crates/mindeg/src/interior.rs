//! Meshes with interior points: the boundary stays bit for bit, degrees get within their limits, and the
//! minimum angle near its proven limit.
//!
//! [`mesh`] meshes a domain, [`angle_limit`] says beforehand which minimum angle no mesh of its boundary
//! can exceed and what decides that, [`lift`] which counts to change for more, and [`improve`] applies
//! the optimiser to a planar mesh of any program.
//!
//! ```
//! use mindeg::{Domain, Interior, Progress, Side, Triangles, interior};
//!
//! let domain = Domain::rectangle(4.0, 3.0, [12, 9, 4, 4].map(Side::count).into())?;
//! let limit = interior::angle_limit(&domain, &Interior::default())?;
//! let found = interior::mesh(&domain, &Interior::default(), Progress::NONE)?;
//! assert!(found.report.violations.is_empty());
//! assert!(found.report.min_angle > 0.95 * limit.min_angle.min(35.0));
//! assert_eq!(found.mesh.lines()[0].name, "side 1");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Limits are proven; degrees and angles are reached by a search without a guarantee, and the [`InteriorReport`]
//! says what was reached. How it works: [`mindeg_interior`].

mod beside;
mod coarse;
mod condition;
mod improve;
mod lift;
mod limit;
mod plane;
mod posed;

pub use beside::mesh_all;
pub use coarse::CoarseSide;
pub use condition::{condition, condition_all};
pub use improve::{ImprovedMesh, improve};
pub use lift::{Lift, lift};
pub use limit::{AngleLimit, Cause, angle_limit};
pub use mindeg_condition::{
    BoundaryChange, BoundaryDemands, ChangeKind, Conditioned, LEAST_GROWTH, Left, Narrow,
    NarrowReason, Reason, Why,
};
pub use mindeg_interior::limits::{FanLimit, Limits, TentLimit, degree_limit};
pub use mindeg_interior::{
    CertifiedVertex, CornerTradeOff, InteriorError, InteriorReport, LocalShares, SizeReport,
    TogetherBound, Violation,
};

use posed::Posed;

use crate::boundary_mesh::{lines, periodic_lines};
use crate::regions::groups;
use mindeg_domain::{Domain, Interior};
use mindeg_interior::{Generated, generate_showing};
use mindeg_mesh::planar::PlanarBoundary;
use mindeg_mesh::{Line, Progress, TriMesh};

/// A mesh with interior points, and what it is like.
#[derive(Clone, Debug, PartialEq)]
pub struct InteriorMesh {
    /// The mesh: the boundary vertices in their order, the points and lines inside, then the others. Its lines are
    /// the sides of the domain, then the lines inside; its groups are the regions, if there are any.
    pub mesh: TriMesh,
    /// The measures of the mesh that was reached.
    pub report: InteriorReport,
    /// The minimum angle that no mesh of the boundary can exceed.
    pub limit: AngleLimit,
    /// The sides and lines whose edges are longer than the sizes asked for there, the worst first.
    pub coarse_sides: Vec<CoarseSide>,
}

/// Meshes a domain with interior points.
///
/// Where the domain gives a boundary vertex a degree limit, that holds instead of
/// [`Interior::boundary_degree`], and external degrees count. Equal input gives equal bytes on every machine. O(n log n) for n
/// points, besides what is spent where degrees or angles need mending.
///
/// # Errors
///
/// A wish without a meaning or that is proven impossible, more points than allowed, boundary points too close to triangulate, and a `progress` that cancels.
pub fn mesh(
    domain: &Domain,
    wanted: &Interior,
    progress: Progress<'_>,
) -> Result<InteriorMesh, InteriorError> {
    mesh_showing(domain, wanted, None, progress)
}

/// A mesh to look at while a boundary changes: points packed inside, with 5 to 7 edges for most of them, which nothing works on. Where
/// it would have more points than `most`, about, edges far from the boundary are longer.
///
/// # Errors
///
/// The errors of [`mesh`].
///
/// ```
/// use mindeg::{Domain, Interior, Progress, Side, interior};
///
/// let domain = Domain::rectangle(4.0, 3.0, [80, 60, 80, 60].map(Side::count).into())?;
/// let [few, many] = [500, 20_000].map(|most| interior::draft(&domain, &Interior::default(), most, Progress::NONE));
/// let [few, many] = [few?, many?].map(|mesh| mesh.positions().len());
/// assert!(280 < few && few < 1200 && 3000 < many);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn draft(
    domain: &Domain,
    wanted: &Interior,
    most: usize,
    progress: Progress<'_>,
) -> Result<TriMesh, InteriorError> {
    let posed = Posed::new(domain)?;
    let options = posed.options(domain, wanted)?;
    let found = mindeg_interior::draft(posed.boundary(), &options, most, progress);
    Ok(in_domain(domain, &posed, found.map_err(|error| posed.error(error))?)?.0)
}

/// [`mesh`]; `show`, if it is given, gets a mesh soon: of the first packing of points, before it is worked on.
///
/// # Errors
///
/// The errors of [`mesh`].
pub fn mesh_showing(
    domain: &Domain,
    wanted: &Interior,
    show: Option<&mut dyn FnMut(TriMesh)>,
    progress: Progress<'_>,
) -> Result<InteriorMesh, InteriorError> {
    let posed = Posed::new(domain)?;
    let options = posed.options(domain, wanted)?;
    let boundary = posed.boundary();
    let mut draft = show.map(|show| {
        |found| {
            if let Ok((mesh, ())) = in_domain(domain, &posed, found) {
                show(mesh);
            }
        }
    });
    let draft = draft.as_mut().map(|draft| draft as &mut dyn FnMut(Generated<()>));
    let found = generate_showing(boundary, &options, draft, progress);
    let found = found.map_err(|error| posed.error(error))?;
    let (mesh, report) = in_domain(domain, &posed, found)?;
    let limit = AngleLimit::new(domain, &posed, &report.limits);
    let report = posed.report(report, &mesh);
    let sizes = report.sizes.as_ref();
    let coarse_sides = sizes.map(|sizes| coarse::coarse_sides(domain, &sizes.coarse));
    let coarse_sides = coarse_sides.unwrap_or_default();
    Ok(InteriorMesh { mesh, report, limit, coarse_sides })
}

/// A mesh of the engine as one of the domain, and its report as it is.
fn in_domain<R>(
    domain: &Domain,
    posed: &Posed<'_>,
    found: Generated<R>,
) -> Result<(TriMesh, R), InteriorError> {
    let found = posed.in_domain(found);
    let boundary = &posed.whole;
    let points = found.points.iter().map(|point| point.extend(0.0)).collect();
    let mut lines = lines(domain);
    let mut kinds: Vec<_> = domain.sides().iter().map(|side| side.kind).collect();
    let mut segments: Vec<[u32; 2]> = boundary.edges().collect();
    let pieces = pieces(boundary, &found.line_edges);
    for (line, kind) in domain.inner_lines() {
        let start = segments.len() as u32;
        let own = &pieces[line.segments.start as usize..line.segments.end as usize];
        segments.extend(own.concat());
        lines.push(Line { segments: start..segments.len() as u32, ..line });
        kinds.push(kind);
    }
    let pieces = pieces.iter().map(|pieces| &pieces[..]);
    let (triangles, groups) = groups(domain, boundary, pieces, found.triangles);
    let mesh = TriMesh::new(points, triangles)
        .and_then(|mesh| mesh.with_lines(lines, segments))
        .and_then(|mesh| mesh.with_named_vertices(domain.named_vertices()))
        .and_then(|mesh| mesh.with_periodic_lines(periodic_lines(domain)))
        .map(|mesh| mesh.with_line_kinds(kinds))
        .map_err(|error| InteriorError::NotFilled(error.to_string()))?;
    let mesh = match groups.is_empty() {
        true => mesh,
        false => mesh.with_groups(groups),
    };
    Ok((mesh.called(domain.name()), found.report))
}

/// The edges that each segment of the lines was divided into.
fn pieces(boundary: &PlanarBoundary, edges: &[[u32; 2]]) -> Vec<Vec<[u32; 2]>> {
    let mut edges = edges.iter().copied();
    let mut own = |end: u32| {
        let mut pieces = Vec::new();
        for edge in edges.by_ref() {
            pieces.push(edge);
            if edge[1] == end {
                break;
            }
        }
        pieces
    };
    boundary.segments().iter().map(|&[_, end]| own(end)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use mindeg_domain::{Arc, Curve, Outline, Side};
    use mindeg_mesh::{Triangles, edges_of};

    /// The points of a curved side of one interval are on a line, whichever mesh of the domain has it.
    #[test]
    fn sides_are_straight_in_both_kinds_of_meshes_alike() {
        let arc = |intervals| {
            let curve = Curve::Arc(Arc::Through([1.0, -0.5].into()));
            let sides = vec![Side::count(intervals).along(curve), Side::count(2), Side::count(2)];
            Domain::new(
                Outline::Polygon([[0.0, 0.0], [2.0, 0.0], [1.0, 2.0]].map(Into::into).into()),
                sides,
            )
            .unwrap()
        };
        for intervals in [1, 2, 5] {
            let domain = arc(intervals);
            let boundary = crate::mesh(&domain, crate::Goal::LeastDegree, Progress::NONE).unwrap();
            let filled = mesh(&domain, &Interior::default(), Progress::NONE).unwrap();
            let straight = |lines: &[Line]| -> Vec<bool> {
                lines.iter().map(|line| line.is_straight).collect()
            };
            let expected = [intervals == 1, true, true];
            assert_eq!(straight(&boundary.mesh.lines()), expected, "{intervals}");
            assert_eq!(straight(&filled.mesh.lines()), expected, "{intervals}");
        }
    }

    /// A draft is a mesh of the same boundary, and whoever sees it gets the same mesh in the end.
    #[test]
    fn a_draft_comes_first_and_changes_nothing() {
        let domain = Domain::from_json(
            r#"{"rectangle": {"width": 6, "height": 4}, "size": 0.3,
                "lines": [{"corners": [[2, 1], [3, 1], [3, 2], [2, 2]], "closed": true}],
                "regions": [{"at": [2.5, 1.5], "hole": true}]}"#,
        )
        .unwrap();
        let wanted = Interior::default();
        let mut drafts = Vec::new();
        let mut show = |draft: TriMesh| drafts.push(draft);
        let found = mesh_showing(&domain, &wanted, Some(&mut show), Progress::NONE).unwrap();
        assert_eq!(found, mesh(&domain, &wanted, Progress::NONE).unwrap());
        let [draft] = &drafts[..] else { panic!("{} drafts", drafts.len()) };
        let given = domain.boundary().unwrap().points().len();
        assert_eq!(draft.positions()[..given], found.mesh.positions()[..given]);
        assert!(draft.positions().len() > given && *draft != found.mesh);
    }

    /// The mean length of the edges inside a disc that are on no side.
    fn mean_length(mesh: &TriMesh, at: [f64; 2], radius: f64) -> f64 {
        let at = glam::DVec3::new(at[0], at[1], 0.0);
        let edges = mesh.triangles().iter().copied().flat_map(edges_of);
        let ends = edges.map(|edge| edge.map(|v| mesh.positions()[v as usize]));
        let near = ends.filter(|ends| ends.iter().all(|end| end.distance(at) < radius));
        let lengths: Vec<f64> = near.map(|[a, b]| a.distance(b)).collect();
        lengths.iter().sum::<f64>() / lengths.len() as f64
    }

    #[test]
    fn sizes_of_regions_and_near_lines_are_kept() {
        let json = |inside: &str| {
            format!(
                r#"{{"rectangle": {{"width": 8, "height": 4}}, "size": 0.5,
                    "lines": [{{"corners": [[4, 0], [4, 4]], "size": 0.5, "name": "wall"}}], {inside}}}"#
            )
        };
        let meshed = |inside: &str| {
            let domain = Domain::from_json(&json(inside)).unwrap();
            let wanted = domain.interior().cloned().unwrap_or_default();
            super::mesh(&domain, &wanted, Progress::NONE)
        };
        let [left, right] = [[1.7, 2.0], [6.0, 2.0]];
        let regions =
            |keys: &str| format!(r#""regions": [{{"at": [1, 1]}}, {{"at": [6, 1], {keys}}}]"#);
        let lengths = |mesh: &TriMesh| [left, right].map(|at| mean_length(mesh, at, 1.0));
        let [coarse, fine] = lengths(&meshed(&regions(r#""size": 0.1"#)).unwrap().mesh);
        assert!(coarse > 0.4 && (0.07..0.13).contains(&fine), "{coarse} {fine}");
        // No triangle is larger than asked, but where the boundary stays.
        let found = meshed(&regions(r#""max_area": 0.02"#)).unwrap();
        let areas: Vec<f64> = found
            .mesh
            .triangles()
            .iter()
            .map(|triangle| triangle.map(|v| found.mesh.positions()[v as usize].truncate()))
            .filter(|corners| corners.iter().all(|c| c.distance(right.into()) < 1.4))
            .map(|[a, b, c]| (b - a).perp_dot(c - a) / 2.0)
            .collect();
        let greatest = areas.iter().copied().fold(0.0, f64::max);
        assert!(areas.len() > 100 && greatest <= 0.02 && greatest > 0.012, "{greatest}");
        // Near the line, and up to the distance.
        let near = r#""interior": {"sizes": [{"from": ["wall"], "size": 0.1, "growth": 0.1, "until": 1}]}"#;
        let mesh = meshed(near).unwrap().mesh;
        let [at_wall, beyond] = [[4.0, 2.0], [4.9, 2.0]].map(|at| mean_length(&mesh, at, 0.35));
        assert!(
            (0.08..0.14).contains(&at_wall) && (0.15..0.25).contains(&beyond),
            "{at_wall} {beyond}"
        );
        assert!(mean_length(&mesh, [7.0, 2.0], 0.9) > 0.4);
        let wrong = meshed(&near.replace("wall", "Wall")).unwrap_err().to_string();
        let names = r#"no side or line has the name "Wall"; there are "side 1", "side 2", "side 3", "side 4", "wall""#;
        assert!(wrong.starts_with("interior.sizes[0].from: ") && wrong.ends_with(names), "{wrong}");
    }
}
