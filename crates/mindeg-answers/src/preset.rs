//! The rules that programs have for a mesh.

use crate::numbers::{four_digits, steady_angle};
use mindeg_mesh::TriMesh;
use std::ops::RangeInclusive;

/// The rules of a program.
#[derive(Clone, Debug, PartialEq)]
pub struct PresetRules {
    /// The name of the preset.
    pub name: &'static str,
    /// The program, its rules and their source.
    pub description: &'static str,
    interior_triangles: Option<RangeInclusive<u32>>,
    most_triangles: Option<u32>,
    most_edges: Option<u32>,
    angles: Option<RangeInclusive<f64>>,
    area_ratio: Option<f64>,
}

/// A program whose rules a mesh is to keep.
pub type Preset = &'static PresetRules;

const NOTHING: PresetRules = PresetRules {
    name: "",
    description: "",
    interior_triangles: None,
    most_triangles: None,
    most_edges: None,
    angles: None,
    area_ratio: None,
};

/// All presets.
pub static PRESETS: [PresetRules; 4] = [
    PresetRules {
        name: "swan",
        description: "SWAN (waves): 4 to 10 triangles at each interior vertex; its limit on large angles is \
                      not checked. Source: SWAN's technical manual, swanmodel.sourceforge.io, node88.html",
        interior_triangles: Some(4..=10),
        ..NOTHING
    },
    PresetRules {
        name: "fvcom",
        description: "FVCOM (ocean): at most 8 triangles at each vertex, which its array NBVE(M,9) holds. \
                      Source: the declaration in FVCOM's code",
        most_triangles: Some(8),
        ..NOTHING
    },
    PresetRules {
        name: "sms",
        description: "SMS (surface water): angles from 10° to 150°, areas of neighbours within a factor of \
                      2. Source: xmswiki.com/wiki/SMS:Mesh_Quality",
        angles: Some(10.0..=150.0),
        area_ratio: Some(2.0),
        ..NOTHING
    },
    PresetRules {
        name: "qmap",
        description: "Quake patches from Blender: at most 6 edges at each vertex. Source: \
                      github.com/c-d-a/io_export_qmap/issues/19",
        most_edges: Some(6),
        ..NOTHING
    },
];

impl PresetRules {
    /// The first place that breaks each rule, in words; `None` if the mesh keeps all. Vertices at one position
    /// count one by one.
    #[must_use]
    pub fn broken_by(&self, mesh: &TriMesh) -> Option<String> {
        let broken = self.broken(mesh);
        (!broken.is_empty()).then(|| format!("preset {}: {}", self.name, broken.join("; ")))
    }

    fn broken(&self, mesh: &TriMesh) -> Vec<String> {
        let triangles = mesh.triangles();
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
            && let Some((ratio, [a, b])) = area_ratio(mesh)
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

/// The counts of triangles and edges at a vertex.
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
fn area_ratio(mesh: &TriMesh) -> Option<(f64, [u32; 2])> {
    let triangles = mesh.triangles();
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

    /// A polygon of so many corners round its center.
    fn wheel(corners: u32) -> TriMesh {
        let corner = |i: u32| {
            let angle = std::f64::consts::TAU * f64::from(i) / f64::from(corners);
            DVec3::new(angle.cos(), angle.sin(), 0.0)
        };
        let points = [DVec3::ZERO].into_iter().chain((0..corners).map(corner)).collect();
        let triangles = (0..corners).map(|i| [0, 1 + i, 1 + (i + 1) % corners]).collect();
        TriMesh::new(points, triangles).unwrap()
    }

    fn preset(name: &str) -> Preset {
        PRESETS.iter().find(|preset| preset.name == name).unwrap()
    }

    #[test]
    fn presets_name_what_breaks_them() {
        for (name, corners, broken) in [
            ("swan", 3, "vertex 0 has 3 triangles, outside 4 to 10"),
            ("swan", 4, ""),
            ("swan", 10, ""),
            ("swan", 11, "vertex 0 has 11 triangles, outside 4 to 10"),
            ("fvcom", 8, ""),
            ("fvcom", 9, "vertex 0 has 9 triangles, above 8"),
            ("qmap", 6, ""),
            ("qmap", 7, "vertex 0 has 7 edges, above 6"),
            ("sms", 6, ""),
            ("sms", 60, "triangle "),
        ] {
            let found = preset(name).broken_by(&wheel(corners)).unwrap_or_default();
            let expected =
                if broken.is_empty() { String::new() } else { format!("preset {name}: {broken}") };
            let same = found == expected || corners == 60 && found.starts_with(&expected);
            assert!(same, "{found}");
        }
    }

    #[test]
    fn areas_of_neighbours_are_compared() {
        let points =
            [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 3.0]].map(|[x, y]| DVec3::new(x, y, 0.0));
        let mesh = TriMesh::new(points.to_vec(), vec![[0, 1, 2], [2, 1, 3]]).unwrap();
        assert_eq!(area_ratio(&mesh), Some((3.0, [0, 1])));
        let broken = preset("sms").broken_by(&mesh).unwrap();
        assert!(broken.contains("triangles 0 and 1 differ in area by a factor of 3"), "{broken}");
    }
}
