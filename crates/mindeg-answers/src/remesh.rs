//! The figures that a remesh reached.

use crate::interior::DegreeViolation;
use crate::loops::not_in_the_mesh;
use crate::numbers::{count, number, percent, place, steady_angle};
use crate::surface::{Distance, greatest};
use mindeg::remesh::RemeshedPart;
use mindeg::repair::Repairs;
use mindeg::verify::{MeshDefect, ProvenDegree};
use mindeg::{Bounds, TriMesh};
use serde::Serialize;

/// A remesh of a part; docs/remesh.md gives the meaning of each key. Lengths are in units of the file, angles in degrees.
#[derive(Clone, Debug, Serialize)]
pub struct RemeshAnswer {
    file: String,
    vertices: usize,
    triangles: usize,
    /// The edge length that was used.
    size: f64,
    /// The tolerance that was asked for, or null.
    tolerance: Option<f64>,
    diagonal: f64,
    max_degree: u32,
    interior_degree: Option<[u32; 2]>,
    boundary_degree: Option<[u32; 2]>,
    violations: Vec<OffVertex>,
    certified: Vec<ProvenDegree>,
    min_angle: f64,
    min_angle_triangle: u32,
    corner_limits: Vec<LimitingCorner>,
    curves: usize,
    corners: usize,
    patches: usize,
    to_part: Distance,
    from_part: Distance,
    curves_to_part: Option<Distance>,
    curves_from_part: Option<Distance>,
    crossings: usize,
    part_crossings: usize,
    /// The repairs before the work, or null.
    repairs: Option<Repairs>,
    dropped: Vec<&'static str>,
    /// Why the mesh may not take the place of the part.
    pub defects: Vec<MeshDefect>,
}

/// A vertex whose degree is not as wanted.
#[derive(Clone, Debug, Serialize)]
struct OffVertex {
    #[serde(flatten)]
    vertex: DegreeViolation,
    /// The edges of feature curves that meet there.
    curves: u32,
}

/// A corner that allows no greater minimum angle.
#[derive(Clone, Debug, Serialize)]
struct LimitingCorner {
    vertex: u32,
    position: [f64; 3],
    /// The angles between its curves.
    sectors: Vec<f64>,
    limit: f64,
}

impl RemeshAnswer {
    /// The answer for the part of a file and its remesh.
    #[must_use]
    pub fn of(file: &str, part: &TriMesh, tolerance: Option<f64>, found: &RemeshedPart) -> Self {
        let bounds = Bounds::of_space(part.positions().iter().copied());
        let (reached, verified) = (&found.reached, &found.verified);
        let off_vertex = |off: &mindeg::remesh::OffDegree| OffVertex {
            vertex: DegreeViolation {
                vertex: off.vertex,
                position: off.at.to_array(),
                degree: off.degree,
                on_boundary: off.is_boundary,
            },
            curves: off.curves,
        };
        let corner = |corner: &mindeg::remesh::CornerLimit| LimitingCorner {
            vertex: corner.vertex,
            position: corner.at.to_array(),
            sectors: corner.sectors.clone(),
            limit: corner.limit,
        };
        let is_open = |off: &&mindeg::remesh::OffDegree| {
            verified.proven.iter().all(|certified| certified.vertex != off.vertex)
        };
        let curves = |index: usize| found.curves.map(|both| both[index].into());
        Self {
            file: file.to_owned(),
            vertices: verified.vertices,
            triangles: verified.triangles,
            size: reached.size,
            tolerance,
            diagonal: bounds.map_or(0.0, |bounds| bounds.size().length()),
            max_degree: greatest([verified.inside, verified.boundary]),
            interior_degree: verified.inside,
            boundary_degree: verified.boundary,
            violations: reached.off_degree.iter().filter(is_open).map(off_vertex).collect(),
            certified: verified.proven.clone(),
            min_angle: verified.min_angle.0,
            min_angle_triangle: verified.min_angle.1,
            corner_limits: reached.corner_limits.iter().map(corner).collect(),
            curves: found.features.curves,
            corners: found.features.corners,
            patches: found.features.patches,
            to_part: verified.to_part.into(),
            from_part: verified.from_part.into(),
            curves_to_part: curves(1),
            curves_from_part: curves(0),
            crossings: verified.crossings.len(),
            part_crossings: verified.part_crossings,
            repairs: found.repairs,
            dropped: [&found.dropped, part.dropped()].concat(),
            defects: found.defects().collect(),
        }
    }

    /// The summary for people.
    #[must_use]
    pub fn text(&self) -> String {
        let range = |[least, most]: [u32; 2]| match least == most {
            true => format!("{least}"),
            false => format!("{least} to {most}"),
        };
        let degrees = match (self.interior_degree, self.boundary_degree) {
            (Some(inside), Some(boundary)) => {
                format!("{}, {} at the boundary", range(inside), range(boundary))
            }
            (Some(degrees), None) | (None, Some(degrees)) => range(degrees),
            (None, None) => String::new(),
        };
        let mut lines = vec![format!(
            "{}: {} vertices, {} triangles, minimum angle {}; degrees {degrees}",
            self.file,
            count(self.vertices as u64),
            count(self.triangles as u64),
            steady_angle(self.min_angle),
        )];
        lines.extend(self.repairs.map(|repairs| mended(&repairs)));
        lines.push(match self.curves + self.corners {
            0 => "It has no feature.".to_owned(),
            _ => format!(
                "It keeps {}, {} and {}.",
                things(self.curves, "feature curve", "feature curves"),
                things(self.corners, "corner", "corners"),
                things(self.patches, "patch", "patches between them")
            ),
        });
        lines.push(self.distances());
        if let Some(worst) = self.corner_limits.iter().min_by(|a, b| a.limit.total_cmp(&b.limit)) {
            lines.push(format!(
                "{} the minimum angle, the most at {}: {}; a greater --feature-angle may drop features.",
                things(self.corner_limits.len(), "corner limits", "corners limit"),
                place(worst.position),
                steady_angle(worst.limit)
            ));
        }
        if let Some(first) = self.certified.first() {
            let what_to_do = match first.sectors.as_slice() {
                [sum] => format!(
                    "the part's angles there sum to {}, and only a blunter tip has room for more",
                    steady_angle(*sum)
                ),
                _ => "--feature-angle 180 may drop these corners".to_owned(),
            };
            lines.push(format!(
                "{} the degree that corners of the part force, the first is vertex {} with {}; {what_to_do}.",
                things(self.certified.len(), "vertex has", "vertices have"),
                first.vertex,
                first.degree
            ));
        }
        if let Some(OffVertex { vertex: off, .. }) = self.violations.first() {
            lines.push(format!(
                "warning: {} another degree than wanted, the first is vertex {} with {}, at {}",
                things(self.violations.len(), "vertex has", "vertices have"),
                off.vertex,
                off.degree,
                place(off.position)
            ));
        }
        if self.crossings > 0 && self.part_crossings > 0 {
            lines.push(format!(
                "warning: {} others, and {} of the part",
                things(self.crossings, "triangle crosses", "triangles cross"),
                count(self.part_crossings as u64)
            ));
        }
        lines.extend(not_in_the_mesh(&self.dropped));
        lines.join("\n")
    }

    fn distances(&self) -> String {
        let most = |distance: &Distance| match distance.at_most {
            Some(length) if length <= 1e-8 * self.diagonal => "0".to_owned(),
            Some(length) if self.diagonal > 0.0 => {
                format!("{} ({})", number(length), percent(length / self.diagonal))
            }
            Some(length) => number(length),
            None => "∞".to_owned(),
        };
        let surfaces = format!(
            "No point is farther from the part than {}, none of the part farther from the mesh than {}",
            most(&self.to_part),
            most(&self.from_part)
        );
        match &self.curves_from_part {
            Some(curves) => {
                format!("{surfaces}, none of its curves from the mesh's than {}.", most(curves))
            }
            None => surfaces + ".",
        }
    }
}

/// A number with the word for one or many.
fn things(number: usize, one: &str, many: &str) -> String {
    match number {
        1 => format!("1 {one}"),
        number => format!("{} {many}", count(number as u64)),
    }
}

/// The repairs, in a sentence.
fn mended(repairs: &Repairs) -> String {
    let Repairs {
        welded_points,
        flat_faces,
        doubled_faces,
        crowded_faces,
        turned_faces,
        split_points,
        filled_holes,
        fill_faces,
    } = *repairs;
    let done = [
        (welded_points, "point welded", "points welded"),
        (flat_faces, "face without area dropped", "faces without area dropped"),
        (doubled_faces, "doubled face dropped", "doubled faces dropped"),
        (crowded_faces, "face too many at an edge dropped", "faces too many at edges dropped"),
        (turned_faces, "face turned over", "faces turned over"),
        (split_points, "point of several fans split", "points of several fans split"),
        (filled_holes, "hole filled", "holes filled"),
        (fill_faces, "face in them", "faces in them"),
    ];
    let done = done.into_iter().filter(|(number, ..)| *number > 0);
    let done: Vec<String> = done.map(|(number, one, many)| things(number, one, many)).collect();
    match done.is_empty() {
        true => "Nothing was to be repaired.".to_owned(),
        false => format!("Repaired first: {}.", done.join(", ")),
    }
}
