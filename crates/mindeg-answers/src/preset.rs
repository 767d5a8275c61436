//! The rules that programs have for a mesh.

use crate::numbers::{self, number, steady_angle};
use mindeg::Interior;
use mindeg::glam::DVec3;
use mindeg_mesh::{LineKind, TriMesh, Triangles as _};
use std::f64::consts::PI;
use std::ops::RangeInclusive;

/// The rules of a program.
#[derive(Clone, Debug, PartialEq)]
pub struct PresetRules {
    /// The name of the preset.
    pub name: &'static str,
    /// The program, its rules and their source.
    pub description: &'static str,
    least_interior_triangles: Option<u32>,
    most_triangles: Option<u32>,
    most_edges: Option<u32>,
    angles: Option<RangeInclusive<f64>>,
    area_ratio: Option<f64>,
    /// The longest side over the radius of the circle of the same area.
    most_skewness: Option<f64>,
    /// Each triangle has a corner inside.
    corner_inside: bool,
    /// Triangles are counter-clockwise and have an area.
    counter_clockwise: bool,
    /// The triangles at each boundary vertex hang together by edges.
    one_fan: bool,
    /// No triangle has all its corners on the boundary and two of them at open water.
    one_open_side: bool,
}

/// A program whose rules a mesh is to keep.
pub type Preset = &'static PresetRules;

const NOTHING: PresetRules = PresetRules {
    name: "",
    description: "",
    least_interior_triangles: None,
    most_triangles: None,
    most_edges: None,
    angles: None,
    area_ratio: None,
    most_skewness: None,
    corner_inside: false,
    counter_clockwise: false,
    one_fan: false,
    one_open_side: false,
};

/// So many further triangles that break a rule are named.
const MOST_NAMED: usize = 8;

/// All presets.
//
// The comments say where each rule stands, looked up in November 2026. Rules that no source gives are not here: none of these programs states a
// least angle or a greatest degree but SWAN, and the rule of FVCOM is one of its tools.
pub static PRESETS: [PresetRules; 8] = [
    // docs/technical_reference/parameter_definitions/index.rst, NM: corners counter-clockwise. src/mesh.F,
    // initializeMesh: a negative area ends the run; the table of neighbours gets as many places as the mesh needs.
    PresetRules {
        name: "adcirc",
        description: "ADCIRC (tides, storm surge): triangles counter-clockwise, with an area. Source: NM in \
                      ADCIRC's manual and initializeMesh in its mesh.F, which set no limit on degrees",
        counter_clockwise: true,
        ..NOTHING
    },
    // anuga/abstract_2d_finite_volumes/general_mesh.py, General_mesh: an area of 0 or less ends the run.
    PresetRules {
        name: "anuga",
        description: "ANUGA (floods, tsunamis): triangles counter-clockwise, with an area. Source: \
                      general_mesh.py of anuga_core",
        counter_clockwise: true,
        ..NOTHING
    },
    // docs/getting-started/grid-generation.md, Mesh quality: what skewness is, and that more than 15 does no harm;
    // typical-workflow.md: up to 60, areas from 1 m2 on, CFL above 0.4. src/Hydro/grid_subs.F90, aquire_hgrid: an area of 0
    // or less, neighbours of opposite orientation and boundary nodes with two runs of elements end the run.
    PresetRules {
        name: "schism",
        description: "SCHISM (ocean): skewness at most 60, the longest side over the radius of the circle of \
                      the same area; triangles counter-clockwise, in one fan at each boundary vertex; areas of \
                      at least 1 m² are not checked. Source: SCHISM's manual, typical-workflow.md and \
                      grid-generation.md, and its grid_subs.F90",
        most_skewness: Some(60.0),
        counter_clockwise: true,
        one_fan: true,
        ..NOTHING
    },
    // SwanCheckGrid.ftn90: 4 to 10 cells at a vertex, fewer at the boundary; no cosine of an angle of -0.8 or less.
    // SwanGridCell.ftn90 looks for the next cell at a vertex as if all were counter-clockwise.
    PresetRules {
        name: "swan",
        description: "SWAN (waves): at least 4 triangles at each interior vertex, at most 10 at any, angles \
                      below 143.13°, triangles counter-clockwise. Source: SwanCheckGrid and SwanGridCell of \
                      SWAN, and its technical manual, node88.html",
        least_interior_triangles: Some(4),
        most_triangles: Some(10),
        angles: Some(0.0..=143.13),
        counter_clockwise: true,
        ..NOTHING
    },
    // documentation/stbtel/user/latex/03_mesh_treatment.tex: three boundary corners may give wrong results, and corners are
    // numbered counter-clockwise. sources/utils/bief/geoelt.f: a determinant below 1e-20 ends the run; checkmesh.f finds
    // triangles at corners with no other one possible, but does not recommend them.
    PresetRules {
        name: "telemac",
        description: "TELEMAC (rivers, coasts): no triangle has all its corners on the boundary, all are \
                      counter-clockwise. Source: STBTEL's user manual, overstressed triangles, and geoelt.f of \
                      BIEF",
        corner_inside: true,
        counter_clockwise: true,
        ..NOTHING
    },
    // FVCOM 4: src/tge.F, triangle_grid_edge: an element without neighbours, a boundary node with two runs of elements, and
    // an element with three boundary nodes of which two are open end the run; NBVE gets as many places as the mesh needs.
    // src/mod_input.F: elements of a grid file are counter-clockwise. The 8 are those of a copy of triangle_grid_edge for
    // tools, whose NBVE has 9 places.
    PresetRules {
        name: "fvcom",
        description: "FVCOM (ocean): triangles counter-clockwise, in one fan at each boundary vertex; none has \
                      all corners on the boundary and two of them at open water; at most 8 at each vertex, \
                      which tools with NBVE(M,9) hold, FVCOM 4 takes more. Source: tge.F and mod_input.F of FVCOM",
        most_triangles: Some(8),
        counter_clockwise: true,
        one_fan: true,
        one_open_side: true,
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

    /// The wishes for points inside with what these rules ask of them, where nothing else was wished.
    #[must_use]
    pub fn asked_of(&self, wanted: Interior) -> Interior {
        let corners = (self.corner_inside || self.one_open_side).then_some(2);
        Interior { boundary_corners: wanted.boundary_corners.or(corners), ..wanted }
    }

    fn broken(&self, mesh: &TriMesh) -> Vec<String> {
        let triangles = mesh.triangles();
        let vertices = Vertices::new(mesh.positions().len(), triangles);
        let middle = |index: usize| {
            let corners = triangles[index].map(|v| mesh.positions()[v as usize]);
            place(corners.iter().sum::<DVec3>() / 3.0)
        };
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
                    let place = place(mesh.positions()[*index]);
                    let has = of(vertex);
                    broken.push(format!("vertex {index} at {place} has {has}{what}{count}"));
                }
            };
        if let Some(least) = self.least_interior_triangles {
            vertex(
                &|v| !v.is_boundary() && v.triangles < least,
                &format!(" triangles, below {least}; mindeg improve makes it 5 to 7"),
                &|v| v.triangles,
            );
        }
        if let Some(most) = self.most_triangles {
            let what = format!(" triangles, above {most}; mindeg improve makes it 5 to 7 inside");
            vertex(&|v| v.triangles > most, &what, &|v| v.triangles);
        }
        if let Some(most) = self.most_edges {
            vertex(&|v| v.edges > most, &format!(" edges, above {most}"), &|v| v.edges);
        }
        if self.one_fan {
            vertex(
                &|v| v.boundary_edges > 2,
                " boundary edges: the boundary touches itself there; move its parts away from each other, as mesh --condition does",
                &|v| v.boundary_edges,
            );
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
                    "triangle {index} at {} has angles from {} to {}, outside {}° to {}°; points inside and two triangles at each corner of \
                     the boundary (--boundary-corners 2) make them better, and mesh --condition where the boundary is narrow",
                    middle(index as usize),
                    steady_angle(quality.min_angle),
                    steady_angle(quality.max_angle),
                    range.start(),
                    range.end()
                ));
            }
        }
        let corners = |index: usize| triangles[index].map(|v| mesh.positions()[v as usize]);
        let mut first = |is_bad: &dyn Fn(usize) -> bool, what: String| {
            let bad: Vec<usize> = (0..triangles.len()).filter(|&index| is_bad(index)).collect();
            let Some((first, more)) = bad.split_first() else { return };
            let named: Vec<String> = more.iter().take(MOST_NAMED).map(usize::to_string).collect();
            let at = middle(*first);
            let rest = match more.len().saturating_sub(MOST_NAMED) {
                0 => String::new(),
                rest => format!(" and {rest} more"),
            };
            broken.push(match more.len() {
                0 => format!("triangle {first} at {at} {what}"),
                1 => format!("triangle {first} at {at} {what}; so does triangle {}", named[0]),
                _ => format!(
                    "triangle {first} at {at} {what}; so do triangles {}{rest}",
                    named.join(", ")
                ),
            });
        };
        if let Some(most) = self.most_skewness {
            first(
                &|index| skewness(corners(index)) > most,
                format!("has a skewness above {most}; an angle near 0° or 180° makes it"),
            );
        }
        if self.corner_inside {
            let on_boundary = |v: &u32| vertices.0[*v as usize].is_boundary();
            first(
                &|index| triangles[index].iter().all(on_boundary),
                "has all its corners on the boundary; divide it by a point, or flip the edge that cuts it off"
                    .to_owned(),
            );
        }
        if self.counter_clockwise {
            first(
                &|index| turned_area(corners(index)) <= 0.0,
                "is not counter-clockwise, or has no area".to_owned(),
            );
        }
        if self.one_open_side {
            let open = at_open_water(mesh);
            first(
                &|index| {
                    let corners = triangles[index].map(|v| v as usize);
                    corners.iter().all(|v| vertices.0[*v].is_boundary())
                        && corners.iter().filter(|v| open[**v]).count() > 1
                },
                "has all its corners on the boundary, two of them at open water; divide it by a point, or flip the edge that cuts it off"
                    .to_owned(),
            );
        }
        if let Some(most) = self.area_ratio
            && let Some((ratio, [a, b])) = area_ratio(mesh)
            && ratio > most
        {
            let ratio = number(ratio);
            broken.push(format!(
                "triangles {a} and {b} differ in area by a factor of {ratio}, above {most}"
            ));
        }
        broken
    }
}

/// A place in the plane, or in space.
fn place(at: DVec3) -> String {
    if at.z == 0.0 { numbers::place(at.truncate()) } else { numbers::place(at) }
}

/// Of each vertex whether a line of open water ends or passes there.
fn at_open_water(mesh: &TriMesh) -> Vec<bool> {
    let mut open = vec![false; mesh.positions().len()];
    for (index, line) in mesh.lines().iter().enumerate() {
        if mesh.line_kind(index) == Some(LineKind::Open) {
            let segments =
                &mesh.segments()[line.segments.start as usize..line.segments.end as usize];
            segments.as_flattened().iter().for_each(|v| open[*v as usize] = true);
        }
    }
    open
}

/// Twice the area of a triangle of the plane, seen along the z axis; negative if it is clockwise.
fn turned_area([a, b, c]: [DVec3; 3]) -> f64 {
    (b - a).truncate().perp_dot((c - a).truncate())
}

/// The longest side over the radius of the circle of the same area.
fn skewness([a, b, c]: [DVec3; 3]) -> f64 {
    let longest = [a - b, b - c, c - a].map(|side| side.length()).into_iter().fold(0.0, f64::max);
    longest / ((b - a).cross(c - a).length() / 2.0 / PI).sqrt()
}

/// The counts of triangles and edges at a vertex.
#[derive(Clone, Debug, Default)]
struct Vertex {
    triangles: u32,
    edges: u32,
    boundary_edges: u32,
}

impl Vertex {
    fn is_boundary(&self) -> bool {
        self.boundary_edges > 0
    }
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
                vertices[v as usize].boundary_edges += u32::from(edge.len() == 1);
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
    use mindeg_mesh::Line;

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
            (
                "swan",
                3,
                "vertex 0 at (0, 0) has 3 triangles, below 4; mindeg improve makes it 5 to 7",
            ),
            ("swan", 4, ""),
            ("swan", 10, ""),
            (
                "swan",
                11,
                "vertex 0 at (0, 0) has 11 triangles, above 10; mindeg improve makes it 5 to 7 inside",
            ),
            ("adcirc", 3, ""),
            ("anuga", 3, ""),
            ("telemac", 3, ""),
            ("schism", 60, ""),
            ("fvcom", 8, ""),
            (
                "fvcom",
                9,
                "vertex 0 at (0, 0) has 9 triangles, above 8; mindeg improve makes it 5 to 7 inside",
            ),
            ("qmap", 6, ""),
            ("qmap", 7, "vertex 0 at (0, 0) has 7 edges, above 6"),
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
    fn triangles_are_named_that_a_model_cannot_take() {
        let mesh = |third: [f64; 2]| {
            let points = [[0.0, 0.0], [1.0, 0.0], third].map(|[x, y]| DVec3::new(x, y, 0.0));
            TriMesh::new(points.to_vec(), vec![[0, 1, 2]]).unwrap()
        };
        let broken = |name: &str, third| preset(name).broken_by(&mesh(third)).unwrap_or_default();
        for (name, third, said) in [
            (
                "telemac",
                [0.0, 1.0],
                "triangle 0 at (0.333333, 0.333333) has all its corners on the boundary",
            ),
            ("anuga", [0.0, -1.0], "triangle 0 at (0.333333, -0.333333) is not counter-clockwise"),
            (
                "adcirc",
                [0.5, 0.0],
                "triangle 0 at (0.5, 0) is not counter-clockwise, or has no area",
            ),
            // Twice pi over the height is the square of the skewness.
            ("schism", [0.5, 0.001], "triangle 0 at (0.5, 0.000333333) has a skewness above 60"),
            ("swan", [0.5, 0.166], "triangle 0 at (0.5, 0.0553333) has angles from"),
        ] {
            assert!(broken(name, third).contains(said), "{name}: {}", broken(name, third));
        }
        assert_eq!(broken("schism", [0.5, 0.002]), "");
        assert_eq!(broken("swan", [0.5, 0.167]), "");
        assert_eq!(broken("anuga", [0.0, 1.0]), "");
    }

    #[test]
    fn further_triangles_are_named_and_counted() {
        let wheels = |count: u32| {
            let corner = |i: u32, third: f64| DVec3::new(f64::from(i) + third / 2.0, third, 0.0);
            let points = (0..count)
                .flat_map(|i| [corner(3 * i, 0.0), corner(3 * i + 1, 0.0), corner(3 * i, 1.0)]);
            let triangles = (0..count).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]);
            let mesh = TriMesh::new(points.collect(), triangles.collect()).unwrap();
            preset("telemac").broken_by(&mesh).unwrap()
        };
        assert!(wheels(1).ends_with("cuts it off"), "{}", wheels(1));
        assert!(wheels(2).ends_with("; so does triangle 1"), "{}", wheels(2));
        let many = "; so do triangles 1, 2, 3, 4, 5, 6, 7, 8 and 3 more";
        assert!(wheels(12).ends_with(many), "{}", wheels(12));
    }

    #[test]
    fn programs_that_stop_at_clockwise_triangles_are_known() {
        let clockwise = |mesh: TriMesh| {
            let turned = mesh.triangles().iter().map(|[a, b, c]| [*a, *c, *b]).collect();
            TriMesh::new(mesh.positions().to_vec(), turned).unwrap()
        };
        for name in ["adcirc", "anuga", "schism", "swan", "telemac", "fvcom"] {
            assert_eq!(preset(name).broken_by(&wheel(6)), None, "{name}");
            let broken = preset(name).broken_by(&clockwise(wheel(6))).unwrap_or_default();
            let words = "triangle 0 at (0.5, 0.288675) is not counter-clockwise";
            assert!(broken.contains(words), "{name}: {broken}");
        }
    }

    #[test]
    fn a_boundary_that_touches_itself_is_named() {
        // Two triangles with one corner in common.
        let points = [[0.0, 0.0], [1.0, -0.5], [1.0, 0.5], [-1.0, 0.5], [-1.0, -0.5]];
        let points = points.map(|[x, y]| DVec3::new(x, y, 0.0)).to_vec();
        let mesh = TriMesh::new(points, vec![[0, 1, 2], [0, 3, 4]]).unwrap();
        for name in ["schism", "fvcom"] {
            let broken = preset(name).broken_by(&mesh).unwrap_or_default();
            assert!(
                broken.contains(
                    "vertex 0 at (0, 0) has 4 boundary edges: the boundary touches itself there"
                ),
                "{name}: {broken}"
            );
        }
        assert_eq!(preset("adcirc").broken_by(&mesh), None);
    }

    #[test]
    fn triangles_with_two_open_corners_and_none_inside_are_named() {
        // A square of two triangles, with one side open; then with a point in its middle.
        let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.5, 0.5]];
        let points = corners.map(|[x, y]| DVec3::new(x, y, 0.0));
        let mesh = |points: &[DVec3], triangles: Vec<[u32; 3]>, kind| {
            let line = Line { name: "south".into(), segments: 0..1, is_straight: true };
            let mesh = TriMesh::new(points.to_vec(), triangles).unwrap();
            let mesh = mesh.with_lines(vec![line], vec![[0, 1]]).unwrap();
            mesh.with_line_kinds(vec![Some(kind)])
        };
        let two = || vec![[0, 1, 2], [0, 2, 3]];
        let broken = |mesh: &TriMesh| preset("fvcom").broken_by(mesh).unwrap_or_default();
        let found = broken(&mesh(&points[..4], two(), LineKind::Open));
        let words =
            "triangle 0 at (0.666667, 0.333333) has all its corners on the boundary, two of them";
        assert!(found.contains(words), "{found}");
        assert_eq!(broken(&mesh(&points[..4], two(), LineKind::Land)), "");
        let four = vec![[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]];
        assert_eq!(broken(&mesh(&points, four, LineKind::Open)), "");
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
