//! Limits that a mesh has to keep, so that a build can stop at one that does not.

use crate::bar::Bar;
use crate::failure::Failure;
use crate::preset::Preset;
use clap::Args;
use mindeg::BoundaryMesh;
use mindeg::quality::TriangleQuality;
use mindeg_answers::numbers::steady_angle;
use mindeg_mesh::{TriMesh, Triangles};

/// What a mesh must be to pass.
#[derive(Debug, Args)]
#[command(next_help_heading = "Gates")]
pub(crate) struct Gates {
    /// End with exit code 3 if a vertex has more edges than this
    #[arg(long, value_name = "N", value_parser = parse_degree, allow_hyphen_values = true)]
    pub(crate) fail_above_degree: Option<u32>,

    /// End with exit code 3 if a triangle has an angle below this many degrees, up to 60
    #[arg(long, value_name = "A", value_parser = parse_angle, allow_hyphen_values = true)]
    pub(crate) fail_below_angle: Option<f64>,

    /// End with exit code 3 if the mesh breaks a rule of this program
    #[arg(long, value_name = "PROGRAM")]
    pub(crate) preset: Option<Preset>,
}

fn parse_degree(text: &str) -> Result<u32, String> {
    text.trim().parse().map_err(|_| "give a whole number of edges, such as 6".to_owned())
}

fn parse_angle(text: &str) -> Result<f64, String> {
    let angle = text.trim().parse().ok().filter(|angle| (0.0..=60.0).contains(angle));
    angle.ok_or_else(|| "give degrees from 0 to 60; no triangle has only larger angles".into())
}

/// As [`steady_angle`] has it, with all digits where rounding would hide that the angle is below `limit`.
pub(crate) fn degrees_below(angle: f64, limit: f64) -> String {
    let rounded = steady_angle(angle);
    let hides = rounded.trim_end_matches('°').parse().is_ok_and(|shown: f64| shown >= limit);
    if hides { format!("{angle}°") } else { rounded }
}

/// A triangle, and what it has for vertices.
pub(crate) struct NamedTriangle {
    pub(crate) number: u32,
    pub(crate) vertices: [u32; 3],
}

impl NamedTriangle {
    /// The triangle with the minimum angle.
    pub(crate) fn worst_of(mesh: &TriMesh) -> Self {
        let angle = |t: &[u32; 3]| {
            let [a, b, c] = t.map(|v| mesh.positions()[v as usize]);
            TriangleQuality::in_space(a, b, c).min_angle
        };
        let worst = (0..).zip(mesh.triangles()).min_by(|a, b| angle(a.1).total_cmp(&angle(b.1)));
        worst.map_or(Self { number: 0, vertices: [0, 1, 2] }, |(number, vertices)| Self {
            number,
            vertices: *vertices,
        })
    }
}

impl Gates {
    /// Passes a mesh of this maximum degree and minimum angle in degrees, or fails and names
    /// the vertex and the triangle that have them, which are asked for only then.
    pub(crate) fn check(
        &self,
        max_degree: u32,
        min_angle: f64,
        highest_vertex: impl FnOnce() -> u32,
        worst_triangle: impl FnOnce() -> NamedTriangle,
    ) -> Result<(), Failure> {
        let mut failed = Vec::new();
        if let Some(limit) = self.fail_above_degree.filter(|&limit| max_degree > limit) {
            let vertex = highest_vertex();
            failed.push(format!(
                "vertex {vertex} has {max_degree} edges; --fail-above-degree allows {limit}"
            ));
        }
        if let Some(limit) = self.fail_below_angle.filter(|&limit| min_angle < limit) {
            let NamedTriangle { number, vertices: [a, b, c] } = worst_triangle();
            failed.push(format!(
                "triangle {number} (vertices {a}, {b}, {c}) has an angle of {}; \
                 --fail-below-angle asks for {limit}°",
                degrees_below(min_angle, limit)
            ));
        }
        if failed.is_empty() {
            return Ok(());
        }
        Err(Failure::Gate(format!("{} (counted from 0)", failed.join("; "))))
    }

    /// Checks a mesh given as a list, of which the minimum angle is known.
    pub(crate) fn check_list(&self, mesh: &TriMesh, min_angle: f64) -> Result<(), Failure> {
        let max_degree = mesh.max_degree();
        let highest_vertex = || {
            let highest = (0..).zip(mesh.degrees()).find(|(_, degree)| **degree == max_degree);
            highest.map_or(0, |(vertex, _)| vertex)
        };
        self.check(max_degree, min_angle, highest_vertex, || NamedTriangle::worst_of(mesh))?;
        self.preset.map_or(Ok(()), |preset| preset.check(mesh))
    }

    /// Checks the mesh of a domain, of which the minimum angle is known. Degrees are total. To name
    /// a triangle that fails all are looked at again, and the bar shows it.
    pub(crate) fn check_mesh(
        &self,
        mesh: &BoundaryMesh,
        min_angle: f64,
        bar: &Bar,
    ) -> Result<(), Failure> {
        let max_degree = mesh.max_total_degree();
        let highest_vertex = || {
            let is_highest = |&vertex: &u32| mesh.total_degree(vertex) == max_degree;
            (0..mesh.vertex_count()).find(is_highest).unwrap_or_default()
        };
        let worst_triangle = || {
            let angles = (0..).zip(mesh.qualities().map(|quality| quality.min_angle));
            let worst = bar.waiting("looking for the worst triangle", || {
                angles.min_by(|(_, a), (_, b)| a.total_cmp(b))
            });
            let number = worst.map_or(0, |(number, _)| number);
            NamedTriangle { number, vertices: mesh.triangle(number) }
        };
        self.check(max_degree, min_angle, highest_vertex, worst_triangle)?;
        let Some(preset) = self.preset else { return Ok(()) };
        let points = mesh.points().map(|point| point.extend(0.0)).collect();
        let triangles = mesh.triangles().collect();
        let mesh = TriMesh::new(points, triangles);
        preset.check(&mesh.map_err(|error| Failure::Input(error.to_string()))?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_angle_that_fails_does_not_read_as_one_that_passes() {
        for (angle, limit, shown) in [
            (0.47490800682170436, 10.0, "0.475°"),
            (29.9999, 30.0, "29.9999°"),
            (29.99, 30.0, "29.990°"),
            (0.0012, 0.002, "0.0012°"),
            (0.00195, 0.002, "0.00195°"),
        ] {
            assert_eq!(degrees_below(angle, limit), shown);
        }
    }
}
