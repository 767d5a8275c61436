//! Whether a mesh keeps the surface of a part, and what it fails.

use crate::demands::Demands;
use crate::interior::DegreeViolation;
use crate::numbers::{count, number, percent, steady_angle};
use mindeg::TriMesh;
use mindeg::verify::{MeshDefect, ProvenDegree, SurfaceRules, VerifiedSurface};
use mindeg_mesh::Bounds;
use mindeg_mesh::distance::DistanceBound;
use mindeg_mesh::inspection::VertexDegree;
use serde::Serialize;

/// A bound of at most so many roundings of the diagonal is all rounding: it is written as 0.
const ROUNDINGS: f64 = 64.0;

/// The verdict on a mesh beside a part; docs/verify.md gives the meaning of each key. Lengths are in units of the files,
/// angles in degrees.
#[derive(Clone, Debug, Serialize)]
pub struct SurfaceAnswer {
    file: String,
    part: String,
    valid: bool,
    defects: Vec<MeshDefect>,
    vertices: usize,
    triangles: usize,
    max_degree: u32,
    /// The least and greatest degree; null without such a vertex.
    interior_degree: Option<[u32; 2]>,
    boundary_degree: Option<[u32; 2]>,
    violations: Vec<DegreeViolation>,
    certified: Vec<ProvenDegree>,
    min_angle: f64,
    min_angle_triangle: u32,
    tolerance: f64,
    diagonal: f64,
    to_part: Distance,
    from_part: Distance,
    boundary_to_part: Option<Distance>,
    boundary_from_part: Option<Distance>,
    features_from_part: Option<Distance>,
    crossings: usize,
    part_crossings: usize,
    /// The demands that the mesh fails, in words; all defects among them.
    pub failed: Vec<String>,
    passed: bool,
}

/// How far the farthest point is.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Distance {
    /// The distance of the point at `position`.
    pub at_least: f64,
    /// No point is farther; null if there is nothing to measure to.
    pub at_most: Option<f64>,
    /// A point that is `at_least` off.
    pub position: [f64; 3],
}

impl From<DistanceBound> for Distance {
    fn from(bound: DistanceBound) -> Self {
        let at_most = Some(bound.upper).filter(|upper| upper.is_finite());
        let at_least = if bound.lower.is_finite() { bound.lower } else { 0.0 };
        Self { at_least, at_most, position: bound.place.to_array() }
    }
}

/// The maximum degree of vertices by their least and greatest degrees.
pub(crate) fn greatest(ranges: [Option<[u32; 2]>; 2]) -> u32 {
    ranges.into_iter().flatten().map(|[_, most]| most).max().unwrap_or(0)
}

impl SurfaceAnswer {
    /// The answer for the mesh of a file and the part of another.
    #[must_use]
    pub fn of(
        (file, mesh): (&str, &TriMesh),
        (part, of_part): (&str, &TriMesh),
        rules: &SurfaceRules,
        found: &VerifiedSurface,
        demands: &Demands,
    ) -> Self {
        let bounds = Bounds::of_space(of_part.positions().iter().copied());
        let mut failed: Vec<String> =
            found.defects.iter().map(|defect| defect.message.clone()).collect();
        failed.extend(demands.unmet_by(&mesh.welded(0.0), found.min_angle.0));
        let violation = |found: &VertexDegree| DegreeViolation {
            vertex: found.vertex,
            position: mesh.positions()[found.vertex as usize].to_array(),
            degree: found.degree,
            on_boundary: found.on_boundary,
        };
        let boundary = |index: usize| found.boundaries.map(|both| both[index].into());
        Self {
            file: file.to_owned(),
            part: part.to_owned(),
            valid: found.defects.is_empty(),
            defects: found.defects.clone(),
            vertices: found.vertices,
            triangles: found.triangles,
            max_degree: greatest([found.inside, found.boundary]),
            interior_degree: found.inside,
            boundary_degree: found.boundary,
            violations: found.out_of_range.iter().map(violation).collect(),
            certified: found.proven.clone(),
            min_angle: found.min_angle.0,
            min_angle_triangle: found.min_angle.1,
            tolerance: rules.tolerance,
            diagonal: bounds.map_or(0.0, |bounds| bounds.size().length()),
            to_part: found.to_part.into(),
            from_part: found.from_part.into(),
            boundary_to_part: boundary(0),
            boundary_from_part: boundary(1),
            features_from_part: found.features.map(Distance::from),
            crossings: found.crossings.len(),
            part_crossings: found.part_crossings,
            passed: failed.is_empty(),
            failed,
        }
    }

    /// A line a figure.
    #[must_use]
    pub fn text(&self) -> String {
        let verb = if self.valid { "keeps" } else { "does not keep" };
        let mut text = format!("{} {verb} the surface of {}\n", self.file, self.part);
        let mut row = |name: &str, value: String| {
            text.push_str(&format!("{name:<17} {value}\n"));
        };
        row("vertices", count(self.vertices as u64));
        row("triangles", count(self.triangles as u64));
        let range = |[least, most]: [u32; 2], place: &str| match least == most {
            true => format!("{least} {place}"),
            false => format!("{least} to {most} {place}"),
        };
        let inside = self.interior_degree.map(|degrees| range(degrees, "off the boundary"));
        let outside = self.boundary_degree.map(|degrees| range(degrees, "on it"));
        let degrees: Vec<String> = inside.into_iter().chain(outside).collect();
        let wrong = match self.violations.len() {
            0 => String::new(),
            wrong => format!("; {} out of range", count(wrong as u64)),
        };
        let forced = match self.certified.len() {
            0 => String::new(),
            proven => format!("; {} as corners of the part force", count(proven as u64)),
        };
        row("degrees", degrees.join(", ") + &forced + &wrong);
        let angle = steady_angle(self.min_angle);
        row("minimum angle", format!("{angle}, in triangle {}", self.min_angle_triangle));
        let share = |length: f64| match self.diagonal > 0.0 {
            true => format!("{} ({})", number(length), percent(length / self.diagonal)),
            false => number(length),
        };
        let rounding = ROUNDINGS * f64::EPSILON * self.diagonal;
        let known = |length: f64| share(if length <= rounding { 0.0 } else { length });
        let most = |distance: &Distance| distance.at_most.map_or("∞".to_owned(), known);
        row(
            "distance",
            format!(
                "at most {} from the part, and back at most {}; tolerance {}",
                most(&self.to_part),
                most(&self.from_part),
                share(self.tolerance)
            ),
        );
        if let (Some(there), Some(back)) = (&self.boundary_to_part, &self.boundary_from_part) {
            row("boundary", format!("at most {}, and back at most {}", most(there), most(back)));
        }
        if let Some(features) = &self.features_from_part {
            row("sharp edges", format!("at most {} from those of the mesh", most(features)));
        }
        if self.part_crossings > 0 || self.crossings > 0 {
            let [own, of_part] =
                [self.crossings, self.part_crossings].map(|number| count(number as u64));
            row("crossings", format!("{own} triangles cross others; {of_part} of the part do"));
        }
        text
    }
}
