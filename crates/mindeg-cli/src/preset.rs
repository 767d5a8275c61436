//! What programs demand of a mesh, as gates.

use crate::failure::Failure;
use clap::ValueEnum;
use mindeg::inspection::weld;
use mindeg_answers::numbers::{four_digits, steady_angle};
use mindeg_mesh::TriMesh;
use std::ops::RangeInclusive;

/// A program and what it demands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Preset {
    /// SWAN (waves): 4 to 10 triangles at each interior vertex; its limit on large angles is not checked.
    /// Source: SWAN's technical manual,
    /// swanmodel.sourceforge.io, node88.html
    Swan,
    /// FVCOM (ocean): at most 8 triangles at each vertex, which its array NBVE(M,9) holds.
    /// Source: the declaration in FVCOM's code
    Fvcom,
    /// SMS (surface water): angles from 10° to 150°, areas of neighbours within a factor of 2.
    /// Source: xmswiki.com/wiki/SMS:Mesh_Quality
    Sms,
    /// Quake patches from Blender: at most 6 edges at each vertex.
    /// Source: github.com/c-d-a/io_export_qmap/issues/19
    Qmap,
}

/// Limits; what is not limited has none.
struct Demands {
    interior_triangles: Option<RangeInclusive<u32>>,
    most_triangles: Option<u32>,
    most_edges: Option<u32>,
    angles: Option<RangeInclusive<f64>>,
    area_ratio: Option<f64>,
}

const NOTHING: Demands = Demands {
    interior_triangles: None,
    most_triangles: None,
    most_edges: None,
    angles: None,
    area_ratio: None,
};

impl Preset {
    fn name(self) -> &'static str {
        match self {
            Self::Swan => "swan",
            Self::Fvcom => "fvcom",
            Self::Sms => "sms",
            Self::Qmap => "qmap",
        }
    }

    fn demands(self) -> Demands {
        match self {
            Self::Swan => Demands { interior_triangles: Some(4..=10), ..NOTHING },
            Self::Fvcom => Demands { most_triangles: Some(8), ..NOTHING },
            Self::Sms => Demands { angles: Some(10.0..=150.0), area_ratio: Some(2.0), ..NOTHING },
            Self::Qmap => Demands { most_edges: Some(6), ..NOTHING },
        }
    }

    /// Passes a mesh, or fails and names the first place that breaks each demand. Vertices with
    /// equal coordinates count as one.
    pub(crate) fn check(self, mesh: &TriMesh) -> Result<(), Failure> {
        let names = weld(mesh.positions(), 0.0);
        let triangles: Vec<[u32; 3]> =
            mesh.triangles().iter().map(|t| t.map(|v| names[v as usize])).collect();
        let broken = self.demands().broken(mesh, &triangles);
        if broken.is_empty() {
            return Ok(());
        }
        let name = self.name();
        Err(Failure::Gate(format!("--preset {name}: {} (counted from 0)", broken.join("; "))))
    }
}

impl Demands {
    fn broken(&self, mesh: &TriMesh, triangles: &[[u32; 3]]) -> Vec<String> {
        let vertices = Vertices::new(mesh.positions().len(), triangles);
        let mut broken = Vec::new();
        let mut vertex =
            |is_bad: &dyn Fn(&Vertex) -> bool, what: &str, of: &dyn Fn(&Vertex) -> u32| {
                let bad: Vec<(usize, &Vertex)> = vertices
                    .0
                    .iter()
                    .enumerate()
                    .filter(|(_, v)| v.triangles > 0 && is_bad(v))
                    .collect();
                if let Some((index, vertex)) = bad.first() {
                    let count = match bad.len() {
                        1 => String::new(),
                        count => format!(", and {} more do", count - 1),
                    };
                    broken.push(format!("vertex {index} has {}{what}{count}", of(vertex)));
                }
            };
        if let Some(range) = &self.interior_triangles {
            vertex(
                &|v| !v.is_boundary && !range.contains(&v.triangles),
                &format!(" triangles, outside {} to {}", range.start(), range.end()),
                &|v| v.triangles,
            );
        }
        if let Some(most) = self.most_triangles {
            vertex(&|v| v.triangles > most, &format!(" triangles, above {most}"), &|v| v.triangles);
        }
        if let Some(most) = self.most_edges {
            vertex(&|v| v.edges > most, &format!(" edges, above {most}"), &|v| v.edges);
        }
        if let Some(range) = &self.angles {
            let qualities = (0..).zip(triangles).map(|(index, t): (u32, _)| {
                let [a, b, c] = t.map(|v| mesh.positions()[v as usize]);
                (index, mindeg::quality::TriangleQuality::in_space(a, b, c))
            });
            let bad = qualities
                .filter(|(_, q)| q.min_angle < *range.start() || q.max_angle > *range.end())
                .min_by(|a, b| a.1.min_angle.total_cmp(&b.1.min_angle));
            if let Some((index, quality)) = bad {
                broken.push(format!(
                    "triangle {index} has angles from {} to {}, outside {}° to {}°",
                    steady_angle(quality.min_angle),
                    steady_angle(quality.max_angle),
                    range.start(),
                    range.end()
                ));
            }
        }
        if let Some(most) = self.area_ratio
            && let Some((ratio, [a, b])) = area_ratio(mesh, triangles)
            && ratio > most
        {
            let ratio = four_digits(ratio);
            broken.push(format!(
                "triangles {a} and {b} differ in area by a factor of {ratio}, above {most}"
            ));
        }
        broken
    }
}

/// What meets at a vertex.
#[derive(Clone, Debug, Default)]
struct Vertex {
    triangles: u32,
    edges: u32,
    is_boundary: bool,
}

struct Vertices(Vec<Vertex>);

impl Vertices {
    fn new(count: usize, triangles: &[[u32; 3]]) -> Self {
        let mut vertices = vec![Vertex::default(); count];
        triangles.as_flattened().iter().for_each(|v| vertices[*v as usize].triangles += 1);
        let halves = sorted_halves(triangles);
        for edge in halves.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)) {
            for v in [edge[0].0, edge[0].1] {
                vertices[v as usize].edges += 1;
                vertices[v as usize].is_boundary |= edge.len() == 1;
            }
        }
        Self(vertices)
    }
}

/// The edges of all triangles, each as its vertices in ascending order and the triangle, sorted.
fn sorted_halves(triangles: &[[u32; 3]]) -> Vec<(u32, u32, u32)> {
    let edges = |(index, [a, b, c]): (u32, &[u32; 3])| {
        [[*a, *b], [*b, *c], [*c, *a]].map(|[a, b]| (a.min(b), a.max(b), index))
    };
    let mut halves: Vec<_> = (0..).zip(triangles).flat_map(edges).collect();
    halves.sort_unstable();
    halves
}

/// The greatest ratio of the areas of two triangles with a common edge, and these.
fn area_ratio(mesh: &TriMesh, triangles: &[[u32; 3]]) -> Option<(f64, [u32; 2])> {
    let area = |t: u32| {
        let [a, b, c] = triangles[t as usize].map(|v| mesh.positions()[v as usize]);
        (b - a).cross(c - a).length()
    };
    let halves = sorted_halves(triangles);
    let pairs = halves.windows(2).filter(|pair| (pair[0].0, pair[0].1) == (pair[1].0, pair[1].1));
    let ratios = pairs.map(|pair| {
        let [a, b] = [pair[0].2, pair[1].2];
        let ratio = area(a) / area(b);
        (ratio.max(1.0 / ratio), [a, b])
    });
    ratios.max_by(|a, b| a.0.total_cmp(&b.0).then(b.1.cmp(&a.1)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use mindeg::glam::DVec3;

    /// A polygon of so many corners round its center, each triangle with vertices of its own.
    fn wheel(corners: u32) -> TriMesh {
        let corner = |i: u32| {
            let angle = std::f64::consts::TAU * f64::from(i % corners) / f64::from(corners);
            DVec3::new(angle.cos(), angle.sin(), 0.0)
        };
        let points = (0..corners).flat_map(|i| [DVec3::ZERO, corner(i), corner(i + 1)]).collect();
        let triangles = (0..corners).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
        TriMesh::new(points, triangles).unwrap()
    }

    #[test]
    fn presets_name_what_breaks_them() {
        for (preset, corners, message) in [
            (
                Preset::Swan,
                3,
                "--preset swan: vertex 0 has 3 triangles, outside 4 to 10 (counted from 0)",
            ),
            (Preset::Swan, 4, ""),
            (Preset::Swan, 10, ""),
            (
                Preset::Swan,
                11,
                "--preset swan: vertex 0 has 11 triangles, outside 4 to 10 (counted from 0)",
            ),
            (Preset::Fvcom, 8, ""),
            (
                Preset::Fvcom,
                9,
                "--preset fvcom: vertex 0 has 9 triangles, above 8 (counted from 0)",
            ),
            (Preset::Qmap, 6, ""),
            (Preset::Qmap, 7, "--preset qmap: vertex 0 has 7 edges, above 6 (counted from 0)"),
            (Preset::Sms, 6, ""),
            (
                Preset::Sms,
                60,
                "--preset sms: triangle 59 has angles from 6.00° to 87.0°, outside 10° to 150° (counted from 0)",
            ),
        ] {
            let found = preset.check(&wheel(corners));
            let found =
                found.err().and_then(|f| f.message().map(str::to_owned)).unwrap_or_default();
            let same =
                found == message || corners == 60 && found.starts_with("--preset sms: triangle ");
            assert!(same, "{found}");
        }
    }

    #[test]
    fn areas_of_neighbours_are_compared() {
        let points =
            [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 3.0]].map(|[x, y]| DVec3::new(x, y, 0.0));
        let mesh = TriMesh::new(points.to_vec(), vec![[0, 1, 2], [2, 1, 3]]).unwrap();
        assert_eq!(area_ratio(&mesh, mesh.triangles()), Some((3.0, [0, 1])));
        let refusal = Preset::Sms.check(&mesh).unwrap_err();
        assert!(
            refusal
                .message()
                .unwrap_or_default()
                .contains("triangles 0 and 1 differ in area by a factor of 3")
        );
    }
}
