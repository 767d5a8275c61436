//! Domains and meshes as the page draws them.

use mindeg::glam::DVec2;
use mindeg::interior::{Cause, InteriorMesh};
use mindeg::quality::{DegreeHistogram, Distribution, METRICS, Metric, TriangleQuality};
use mindeg::{BoundaryMesh, Bounds, Domain, Line, Region, TriMesh};
use mindeg_answers::interior::{angles_and_degrees, local_limits};
use mindeg_answers::mesh as words;
use mindeg_answers::numbers::{percent, steady_angle, triangles};
use mindeg_answers::sizes::coarse_sides;
use mindeg_compare::axis::{Axis, BARS};
use mindeg_mesh::LineKind;
use mindeg_mesh::planar::PlanarBoundary;

use crate::api::{Bars, DomainShown, LineShown, PlaceShown, Request, Shown, SideShown, View};
use crate::arrays::{f32s, f64s, u32s};
use crate::mesh::Made;
use crate::terms::without_options;

/// The most vertices of a wrong degree that are marked.
const MOST_MARKS: usize = 100;

pub(crate) fn domain(domain: &Domain) -> DomainShown {
    let rings = domain.rings();
    let bounds = domain.placement().bounds();
    let center = bounds.center();
    let side = |side| SideShown {
        name: domain.side_name(side),
        ring: rings.ring_of_side(side),
        start: rings.corner(side),
        intervals: rings.intervals(side),
        is_straight: domain.is_straight(side),
    };
    DomainShown {
        name: domain.name().map(str::to_owned),
        vertices: rings.vertex_count() as usize + domain.inner_points().len(),
        holes: domain.hole_count(),
        triangles: triangle_count(domain),
        is_convex: domain.convex().is_some(),
        center: center.to_array(),
        size: bounds.size().to_array(),
        points: f64s(domain.placement().points().map(|point| point - center)),
        rings: rings.rings().map(|ring| ring.start).chain([rings.vertex_count()]).collect(),
        sides: (0..rings.side_count()).map(side).collect(),
        lines: lines(domain, center),
        named_points: named_points(domain),
        regions: regions(domain),
        region_count: if domain.is_map() { domain.region_count() } else { 0 },
        notes: domain.notes(),
    }
}

/// The number of triangles of every mesh of the boundary and the points inside: regions that are holes have none.
fn triangle_count(domain: &Domain) -> u32 {
    let whole = domain.rings().triangle_count() + 2 * domain.inner_points().len() as u32;
    let (Some(faces), Ok(boundary)) = (domain.faces(), domain.boundary()) else { return whole };
    let borders = (0..).zip(boundary.face_borders(faces));
    let holes = borders.filter(|(face, _)| domain.is_hole(*face)).map(|(_, hole)| hole.boundary);
    let triangles = |hole: PlanarBoundary| {
        hole.vertex_count() + 2 * (hole.ring_count() + hole.inner_points().len()) as u32 - 4
    };
    whole - holes.map(triangles).sum::<u32>()
}

fn lines(domain: &Domain, center: DVec2) -> Vec<LineShown> {
    let Ok(boundary) = domain.boundary() else { return Vec::new() };
    let (points, segments) = (|v: &u32| boundary.point(*v) - center, domain.inner_segments());
    let line = |(line, _): (Line, Option<LineKind>)| {
        let own = &segments[line.segments.start as usize..line.segments.end as usize];
        LineShown { name: line.name, segments: f64s(own.as_flattened().iter().map(points)) }
    };
    domain.inner_lines().into_iter().map(line).collect()
}

fn named_points(domain: &Domain) -> Vec<PlaceShown> {
    let points = domain.inside().points.iter();
    let named = points.filter_map(|point| Some((point.name.clone()?, point.at)));
    named.map(|(name, at)| PlaceShown { name, at: at.to_array() }).collect()
}

fn regions(domain: &Domain) -> Vec<PlaceShown> {
    let regions = (0..).zip(&domain.inside().regions).filter(|(_, region)| !region.hole);
    let place = |(face, region): (u32, &Region)| PlaceShown {
        name: domain.region_name(face),
        at: region.at.to_array(),
    };
    regions.map(place).collect()
}

/// A mesh with its figures.
pub(crate) struct Figure {
    frame: Bounds,
    /// The points beyond the boundary points.
    interior_points: Vec<DVec2>,
    triangles: Vec<[u32; 3]>,
    /// With external degrees.
    degrees: Vec<u32>,
    qualities: Vec<TriangleQuality>,
    /// No mesh has a smaller maximum degree.
    at_least: Option<u32>,
    delaunay_min_angle: Option<f64>,
    words: String,
    marks: Vec<PlaceShown>,
}

impl Figure {
    /// A mesh of the boundary points, to show until a better one is found.
    pub(crate) fn for_now(mesh: &BoundaryMesh) -> Self {
        let figure = Self::of(mesh);
        let words = figure.in_short() + " A better mesh is looked for.";
        Self { words, ..figure }
    }

    /// A mesh with points inside, to show until another one follows.
    pub(crate) fn draft(domain: &Domain, draft: &TriMesh, what_follows: &str) -> Self {
        let figure = Self::listed(domain, draft);
        let words = format!("{} {what_follows}", figure.in_short());
        Self { words, ..figure }
    }

    /// A mesh of the boundary points.
    fn of(mesh: &BoundaryMesh) -> Self {
        Self {
            frame: mesh.domain().placement().bounds(),
            interior_points: mesh.domain().inner_points().to_vec(),
            triangles: mesh.triangles().collect(),
            degrees: (0..mesh.vertex_count()).map(|vertex| mesh.total_degree(vertex)).collect(),
            qualities: mesh.qualities().collect(),
            at_least: None,
            delaunay_min_angle: None,
            words: String::new(),
            marks: Vec::new(),
        }
    }

    /// A mesh of a domain, with what is known of it.
    pub(crate) fn made(domain: &Domain, made: &Made) -> Self {
        match made {
            Made::Boundary(meshed, goal) => {
                let figure = Self::of(&meshed.mesh);
                let (min, max) = figure.angles();
                let mut lines = vec![words::mesh(meshed, [min, max]) + "."];
                lines.extend(words::standing(meshed, *goal, min));
                Self {
                    at_least: Some(meshed.least_max_degree),
                    delaunay_min_angle: meshed.delaunay_min_angle,
                    words: lines.join(" "),
                    ..figure
                }
            }
            Made::Delaunay(mesh) => {
                let figure = Self::listed(domain, mesh);
                let (min, _) = figure.angles();
                let words =
                    figure.in_short() + " No mesh of these points has a larger minimum angle.";
                Self { delaunay_min_angle: Some(min), words, ..figure }
            }
            Made::Interior(found) => {
                let (figure, report) = (Self::listed(domain, &found.mesh), &found.report);
                let mut words = format!(
                    "{} boundary and {} interior vertices, {}, {}. {}",
                    found.mesh.positions().len() - report.interior_points,
                    report.interior_points,
                    triangles(report.triangles as u64),
                    angles_and_degrees(report),
                    local_limits(report, domain.projection()),
                );
                words.extend(
                    coarse_sides(found, domain.projection()).map(|sides| format!(" {sides}")),
                );
                Self { words, marks: marks(domain, found), ..figure }
            }
        }
    }

    /// A list of triangles whose first points are those of the boundary.
    fn listed(domain: &Domain, mesh: &TriMesh) -> Self {
        let points: Vec<DVec2> = mesh.positions().iter().map(|point| point.truncate()).collect();
        let vertices = domain.rings().vertex_count();
        let external = |vertex: usize| match vertex as u32 {
            vertex if vertex < vertices => domain.external_degree(vertex),
            _ => 0,
        };
        let mut degrees: Vec<u32> = (0..points.len()).map(external).collect();
        // Around a vertex inside, edges and triangles alternate; at the boundary there is an edge more.
        degrees[..vertices as usize].iter_mut().for_each(|degree| *degree += 1);
        for &vertex in mesh.triangles().iter().flatten() {
            degrees[vertex as usize] += 1;
        }
        let quality = |triangle: &[u32; 3]| {
            let [a, b, c] = triangle.map(|vertex| points[vertex as usize]);
            TriangleQuality::of(a, b, c)
        };
        Self {
            frame: domain.placement().bounds(),
            interior_points: points[vertices as usize..].to_vec(),
            triangles: mesh.triangles().to_vec(),
            qualities: mesh.triangles().iter().map(quality).collect(),
            degrees,
            at_least: None,
            delaunay_min_angle: None,
            words: String::new(),
            marks: Vec::new(),
        }
    }

    /// Size, degree and angles in a sentence.
    fn in_short(&self) -> String {
        let (min, max) = self.angles();
        format!(
            "{} vertices, {}, maximum degree {}, angles {} to {}.",
            self.degrees.len(),
            triangles(self.triangles.len() as u64),
            self.max_degree(),
            steady_angle(min),
            steady_angle(max),
        )
    }

    /// The greatest degree.
    pub(crate) fn max_degree(&self) -> u32 {
        self.degrees.iter().copied().max().unwrap_or(0)
    }

    /// The minimum and the maximum angle in degrees.
    fn angles(&self) -> (f64, f64) {
        let ends = (180.0_f64, 0.0_f64);
        self.qualities.iter().fold(ends, |(min, max), quality| {
            (min.min(quality.min_angle), max.max(quality.max_angle))
        })
    }

    pub(crate) fn shown(&self, view: View, is_last: bool, request: &Request) -> Shown {
        let measure = METRICS.iter().find(|metric| Some(metric.name) == request.color.as_deref());
        let max_degree = self.max_degree();
        let by_angle = |&a: &usize, &b: &usize| {
            self.qualities[a].min_angle.total_cmp(&self.qualities[b].min_angle)
        };
        let worst = (0..self.qualities.len()).min_by(by_angle).unwrap_or(0);
        let (min_angle, max_angle) = self.angles();
        let values = |metric: &Metric| f32s(self.qualities.iter().map(metric.of));
        let histogram: DegreeHistogram = self.degrees.iter().copied().collect();
        let first_of_max = self.degrees.iter().position(|&degree| degree == max_degree);
        let of_delaunay = |most: f64| (min_angle / most).min(1.0);
        let center = self.frame.center();
        Shown {
            view,
            is_last,
            words: without_options(&self.words),
            interior_points: f64s(self.interior_points.iter().map(|&p| p - center)),
            triangles: u32s(self.triangles.iter().flatten().copied()),
            degrees: u32s(self.degrees.iter().copied()),
            values: measure.map_or_else(String::new, values),
            max_degree,
            at_least: self.at_least,
            min_angle,
            max_angle,
            share_of_delaunay: self.delaunay_min_angle.map(of_delaunay),
            degree_bars: histogram.iter().map(|(degree, count)| [degree.into(), count]).collect(),
            bars: measure.and_then(|measure| self.bars(measure)),
            worst_triangle: worst as u32,
            max_degree_vertex: first_of_max.unwrap_or(0) as u32,
            marks: self.marks.clone(),
        }
    }

    fn bars(&self, metric: &Metric) -> Option<Bars> {
        let values: Vec<f64> = self.qualities.iter().map(metric.of).collect();
        let axis = axis(metric, self.frame.size());
        let mut counts = vec![0; BARS];
        values.iter().for_each(|&value| counts[axis.bar(value)] += 1);
        let Distribution { min, median, mean, max, .. } = Distribution::of(values)?;
        let measure = metric.name.to_owned();
        let Axis { range, is_logarithmic } = axis;
        Some(Bars { measure, range, is_logarithmic, counts, min, median, mean, max })
    }
}

/// The places of a mesh with points inside that decide its angle, lose most of it, or break a degree limit.
fn marks(domain: &Domain, found: &InteriorMesh) -> Vec<PlaceShown> {
    let InteriorMesh { report, limit, .. } = found;
    let at = |vertex: u32| domain.placement().point(vertex).to_array();
    let place = |name: String, at| PlaceShown { name, at };
    let decides = match &limit.cause {
        Cause::Corner { vertex, .. } | Cause::Vertex { vertex, .. } => vec![*vertex],
        Cause::Facing { vertices, .. } => vertices.to_vec(),
    };
    let boundary = domain.rings().vertex_count();
    let decides = decides.into_iter().filter(|&vertex| vertex < boundary);
    let mut marks: Vec<PlaceShown> = decides
        .map(|vertex| place(format!("limit {}", steady_angle(limit.min_angle)), at(vertex)))
        .collect();
    if report.local.worst < 0.9995 {
        let share = percent(report.local.worst);
        let own = steady_angle(report.local.limit);
        marks.push(place(format!("{share} of its limit, {own}"), report.local.at.to_array()));
    }
    let violations = report.violations.iter().take(MOST_MARKS);
    marks.extend(violations.map(|it| place(format!("degree {}", it.degree), it.at.to_array())));
    marks
}

/// The axis of a measure.
fn axis(metric: &Metric, size: DVec2) -> Axis {
    let (range, is_logarithmic) = match (metric.unit, metric.best) {
        // Whether a needle has a tenth of a degree or two degrees matters, as in the reports.
        ("degrees", Some(best)) if metric.worst == 0.0 => ([0.1, best], true),
        ("degrees", Some(best)) => ([best.min(metric.worst), best.max(metric.worst)], false),
        (_, Some(best)) if metric.worst.is_finite() => ([metric.worst, best], false),
        (_, Some(best)) => ([best, 1e3 * best], true),
        ("length", None) => ([1e-4 * size.max_element(), size.max_element()], true),
        (_, None) => ([1e-8 * size.element_product(), size.element_product()], true),
    };
    Axis { range, is_logarithmic }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Four points, cut from vertex 0 to vertex 2.
    fn plate(vertices: &str) -> (Domain, TriMesh) {
        let text = format!(
            r#"{{"polygon": {{"corners": [[1,2],[5,2],[5,5],[1,5]]}}, "size": 9, "vertices": {vertices}}}"#
        );
        let domain = Domain::from_json(&text).unwrap();
        let points = domain.placement().points().map(|point| point.extend(0.0)).collect();
        (domain, TriMesh::new(points, vec![[0, 1, 2], [0, 2, 3]]).unwrap())
    }

    #[test]
    fn the_frame_is_the_middle_and_the_extent() {
        let shown = super::domain(&plate("[]").0);
        assert_eq!((shown.center, shown.size), ([3.0, 3.5], [4.0, 3.0]));
    }

    /// A ring of lines round a hole, a line that ends inside, and a point.
    #[test]
    fn lines_points_and_regions_are_told_with_their_names() {
        let map = r#"{"rectangle": {"width": 4, "height": 3}, "size": 1,
            "lines": [{"corners": [[1, 1], [2, 1], [2, 2], [1, 2]], "closed": true},
                {"corners": [[4, 2], [3, 2]], "name": "wall"}],
            "points": [{"at": [0.5, 0.5]}, {"at": [3.5, 2.5], "name": "gauge"}],
            "regions": [{"at": [1.5, 1.5], "hole": true}, {"at": [3.5, 0.5], "name": "steel"}]}"#;
        let domain = Domain::from_json(map).unwrap();
        let shown = super::domain(&domain);
        let names = |places: &[PlaceShown]| {
            places.iter().map(|it| (it.name.clone(), it.at)).collect::<Vec<_>>()
        };
        assert_eq!(names(&shown.named_points), [("gauge".to_owned(), [3.5, 2.5])]);
        assert_eq!(names(&shown.regions), [("steel".to_owned(), [3.5, 0.5])]);
        assert_eq!(shown.region_count, 1);
        let mesh =
            mindeg::mesh(&domain, mindeg::Goal::LeastDegree, mindeg::Progress::NONE).unwrap();
        assert_eq!(shown.triangles, mesh.mesh.triangle_count());
        // From the center of the rectangle.
        let wall = [[2.0, 0.5], [1.0, 0.5]].map(DVec2::from);
        assert_eq!(
            (&*shown.lines[1].name, &shown.lines[1].segments),
            ("wall", &f64s(wall.into_iter()))
        );
        assert_eq!(shown.lines.len(), 2);
        let plain = super::domain(&plate("[]").0);
        assert!(plain.lines.is_empty() && plain.regions.is_empty() && plain.region_count == 0);
    }

    /// Of two holes that touch, one is a line around a region. Its vertices were left out in some rows.
    #[test]
    fn vertices_and_holes_are_those_of_the_mesh() {
        let touching = r#"{"rectangle": {"width": 10, "height": 10}, "size": 10,
            "holes": [{"ring": [[5, 5], [5, 8], [8, 8], [8, 5]]}],
            "lines": [{"closed": true, "corners": [[2, 2], [2, 5], [5, 5], [5, 2]]}],
            "regions": [{"at": [3, 3], "hole": true}]}"#;
        let domain = Domain::from_json(touching).unwrap();
        let shown = super::domain(&domain);
        assert_eq!((shown.vertices, shown.holes), (11, 2));
        let none = mindeg::Progress::NONE;
        let found = mindeg::interior::mesh(&domain, &mindeg::Interior::default(), none).unwrap();
        let figure = Figure::made(&domain, &Made::Interior(Box::new(found)));
        assert!(figure.words.starts_with("11 boundary and "), "{}", figure.words);
    }

    #[test]
    fn degrees_count_the_edges_outside_too() {
        let (domain, mesh) = plate(r#"[{"vertex": 1, "outside_degree": 7}]"#);
        assert_eq!(Figure::listed(&domain, &mesh).degrees, [3, 9, 3, 2]);
    }

    #[test]
    fn a_mesh_is_told_in_a_sentence() {
        let (domain, mesh) = plate("[]");
        assert_eq!(
            Figure::listed(&domain, &mesh).in_short(),
            "4 vertices, 2 triangles, maximum degree 3, angles 36.870° to 90.000°."
        );
    }

    #[test]
    fn every_measure_has_an_axis_from_its_worst_to_its_best() {
        let size = DVec2::new(40.0, 30.0);
        for (name, range, is_logarithmic) in [
            ("min_angle", [0.1, 60.0], true),
            ("max_angle", [60.0, 180.0], false),
            ("shape", [0.0, 1.0], false),
            ("edge_ratio", [1.0, 1000.0], true),
            // Parts of the longer side and of the rectangle round the domain.
            ("minimum_height", [1e-4 * 40.0, 40.0], true),
            ("area", [1e-8 * 1200.0, 1200.0], true),
        ] {
            let metric = METRICS.iter().find(|metric| metric.name == name).unwrap();
            assert_eq!(axis(metric, size), Axis { range, is_logarithmic }, "{name}");
        }
    }
}
