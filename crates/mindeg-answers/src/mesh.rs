//! The proven facts about a mesh.

use mindeg::beside::MeshBeside;
use mindeg::exact::share_of;
use mindeg::interior::InteriorMesh;
use mindeg::model::ModelMesh;
use mindeg::{FoundBy, Goal, Meshed, TriMesh};
use mindeg_mesh::Triangles;
use mindeg_mesh::quality::TriangleQuality;
use serde::Serialize;

use crate::interior::InteriorAnswer;
use crate::names::{part_name, shown};
use crate::numbers::{self, counted, percent, steady_angle};

/// A mesh of boundary points; angles are in degrees. Degrees are total: edges outside the domain count.
#[derive(Clone, Debug, Serialize)]
pub struct MeshAnswer {
    /// The name of the domain.
    pub name: Option<String>,
    /// The intervals of each side.
    pub intervals: Vec<u32>,
    /// Vertices.
    pub vertices: u32,
    /// Triangles.
    pub triangles: u32,
    /// The most edges at a vertex.
    pub max_degree: u32,
    /// Null where it is not known; no mesh has less than `at_least`.
    pub least_max_degree: Option<u32>,
    /// No mesh has a smaller maximum degree.
    pub at_least: u32,
    /// The minimum angle of all triangles.
    pub min_angle: f64,
    /// The maximum angle of all triangles.
    pub max_angle: f64,
    /// See [`found_by`].
    pub found_by: &'static str,
    /// The largest minimum angle of all meshes of these points, Delaunay's; null where it was not worked out.
    pub angle_limit: Option<f64>,
    /// `min_angle` / `angle_limit`; at most 1.
    pub share_of_limit: Option<f64>,
    /// Whether the corners ran clockwise.
    pub reversed: bool,
}

/// A mesh as it is, of any program; angles are in degrees.
#[derive(Clone, Debug, Serialize)]
pub struct ListedMesh {
    /// The file that it is from; null where it is made of options.
    pub file: Option<String>,
    /// Vertices.
    pub vertices: usize,
    /// Triangles.
    pub triangles: usize,
    /// The most edges at a vertex.
    pub max_degree: u32,
    /// The minimum angle of all triangles; null without triangles.
    pub min_angle: Option<f64>,
    /// The maximum angle of all triangles; null without triangles.
    pub max_angle: Option<f64>,
    /// The kinds of values at vertices that the file has and the mesh lacks.
    pub dropped: Vec<&'static str>,
}

/// What no mesh of the same domain or model betters, beside one of its meshes; all null for a mesh from a file.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct KnownLimits {
    /// Null where it is not known; no mesh has less than `at_least`.
    pub least_max_degree: Option<u32>,
    /// No mesh has a smaller maximum degree.
    pub at_least: Option<u32>,
    /// The largest minimum angle that any mesh has; null of models, and where it was not worked out.
    pub angle_limit: Option<f64>,
    /// `min_angle` / `angle_limit`; of a model, the smallest that a face has.
    pub share_of_limit: Option<f64>,
}

impl From<&MeshBeside> for KnownLimits {
    fn from(found: &MeshBeside) -> Self {
        let (least, is_proven) = found.least_max_degree();
        let angle_limit = found.delaunay_min_angle();
        let min_angle = ListedMesh::of(None, &found.mesh).min_angle;
        Self {
            least_max_degree: is_proven.then_some(least),
            at_least: Some(least),
            angle_limit,
            share_of_limit: min_angle.zip(angle_limit).map(|(angle, most)| share_of(angle, most)),
        }
    }
}

impl From<&InteriorMesh> for KnownLimits {
    fn from(found: &InteriorMesh) -> Self {
        let answer = InteriorAnswer::from(found);
        Self {
            least_max_degree: answer.least_max_degree,
            at_least: Some(answer.at_least),
            angle_limit: Some(answer.angle_limit),
            share_of_limit: Some(answer.share_of_limit),
        }
    }
}

impl From<&ModelMesh> for KnownLimits {
    fn from(found: &ModelMesh) -> Self {
        Self {
            least_max_degree: found.is_proven().then_some(found.max_degree),
            at_least: Some(found.lower_bound),
            angle_limit: None,
            share_of_limit: found.angle_share,
        }
    }
}

/// A mesh that is shown, with what is known of all meshes of its domain or model.
#[derive(Clone, Debug, Serialize)]
pub struct ShownMesh {
    /// The mesh.
    #[serde(flatten)]
    pub mesh: ListedMesh,
    /// What no other betters.
    #[serde(flatten)]
    pub limits: KnownLimits,
}

impl ListedMesh {
    /// The answer for a mesh. O(n).
    #[must_use]
    pub fn of(file: Option<String>, mesh: &TriMesh) -> Self {
        let angles = |triangle: &[u32; 3]| {
            let [a, b, c] = triangle.map(|vertex| mesh.positions()[vertex as usize]);
            let quality = TriangleQuality::in_space(a, b, c);
            [quality.min_angle, quality.max_angle]
        };
        let range =
            |[least, greatest]: [f64; 2], [min, max]: [f64; 2]| [least.min(min), greatest.max(max)];
        let range = mesh.triangles().iter().map(angles).reduce(range);
        Self {
            file,
            vertices: mesh.positions().len(),
            triangles: mesh.triangles().len(),
            max_degree: mesh.max_degree(),
            min_angle: range.map(|[least, _]| least),
            max_angle: range.map(|[_, greatest]| greatest),
            dropped: mesh.dropped().to_vec(),
        }
    }
}

impl MeshAnswer {
    /// The answer for a mesh of these angles, the least and the greatest.
    #[must_use]
    pub fn of(meshed: &Meshed, [min_angle, max_angle]: [f64; 2]) -> Self {
        let (mesh, least) = (&meshed.mesh, meshed.least_max_degree);
        let domain = mesh.domain();
        Self {
            name: domain.name().map(str::to_owned),
            intervals: domain.rings().sides().collect(),
            vertices: mesh.vertex_count(),
            triangles: mesh.triangle_count(),
            max_degree: mesh.max_total_degree(),
            least_max_degree: meshed.is_least_proven.then_some(least),
            at_least: least,
            min_angle,
            max_angle,
            found_by: found_by(meshed.found_by),
            angle_limit: meshed.delaunay_min_angle,
            share_of_limit: meshed.delaunay_min_angle.map(|most| share_of(min_angle, most)),
            reversed: domain.was_reversed(),
        }
    }
}

/// The mesh of several domains beside each other.
#[derive(Clone, Debug, Serialize)]
pub struct MeshBesideAnswer {
    /// The name of all of them together, the intervals of the sides of all, and the mesh of all. `found_by` is that of the
    /// part that decides the degree.
    #[serde(flatten)]
    pub all: MeshAnswer,
    /// How many regions all parts have; several may share a name.
    pub regions: usize,
    /// The mesh of each domain.
    pub parts: Vec<MeshAnswer>,
}

impl MeshBesideAnswer {
    /// The answer for a mesh whose parts have these angles, the least and the greatest.
    #[must_use]
    pub fn of(found: &MeshBeside, angles: &[[f64; 2]], name: Option<&str>) -> Self {
        let answer = |(part, angles): (&Meshed, &[f64; 2])| MeshAnswer::of(part, *angles);
        let parts: Vec<MeshAnswer> = found.parts.iter().zip(angles).map(answer).collect();
        let (least, is_proven) = found.least_max_degree();
        let deciding = parts.get(found.deciding_part);
        let min_angle = parts.iter().map(|part| part.min_angle).fold(f64::INFINITY, f64::min);
        let angle_limit = found.delaunay_min_angle();
        let all = MeshAnswer {
            name: name.map(str::to_owned),
            intervals: parts.iter().flat_map(|part| part.intervals.iter().copied()).collect(),
            vertices: parts.iter().map(|part| part.vertices).sum(),
            triangles: parts.iter().map(|part| part.triangles).sum(),
            max_degree: parts.iter().map(|part| part.max_degree).fold(0, u32::max),
            least_max_degree: is_proven.then_some(least),
            at_least: least,
            min_angle,
            max_angle: parts.iter().map(|part| part.max_angle).fold(0.0, f64::max),
            found_by: deciding.map_or("windows", |part| part.found_by),
            angle_limit,
            share_of_limit: angle_limit.map(|most| share_of(min_angle, most)),
            reversed: parts.iter().any(|part| part.reversed),
        };
        let regions = found.parts.iter().map(|part| part.mesh.domain().region_count()).sum();
        Self { all, regions, parts }
    }
}

/// The mesh of several domains, in lines: its size, its degree and its angles, and the part with the highest degree.
#[must_use]
pub fn mesh_beside(found: &MeshBeside, answer: &MeshBesideAnswer, goal: Goal) -> Vec<String> {
    let MeshBesideAnswer { all, regions, parts } = answer;
    let counts = [all.vertices, all.triangles, all.max_degree];
    let size = in_line(
        counts,
        "",
        (all.least_max_degree.is_some(), all.at_least),
        [all.min_angle, all.max_angle],
    );
    let count = parts.len();
    let name = shown(all.name.as_deref().unwrap_or("map")).into_owned();
    let regions = counted(*regions as u64, "region");
    let in_parts = counted(count as u64, "part");
    let mut lines = vec![format!("{name}: {regions} in {in_parts}: {size}")];
    let meshed = &found.parts[found.deciding_part];
    let standing = standing_of(meshed, goal, all.min_angle, found.delaunay_min_angle());
    lines.extend(standing.map(|standing| {
        let part = part_name(found.deciding_part, meshed.mesh.domain());
        format!("The highest degree is that of {part}. {standing}")
    }));
    lines
}

/// How a mesh was found: `formula`, `search` (exact), `windows` (the degree is an upper bound), `exhaustive` or
/// `zig_zag` (the degree is the least, the angle may not be the largest with it).
#[must_use]
pub fn found_by(found_by: FoundBy) -> &'static str {
    match found_by {
        FoundBy::Formula => "formula",
        FoundBy::Search => "search",
        FoundBy::Windows { .. } => "windows",
        FoundBy::Exhaustive => "exhaustive",
        FoundBy::ZigZag => "zig_zag",
    }
}

/// The size of a mesh, its degree and its angles, the least and the greatest in degrees, in a line.
#[must_use]
pub fn mesh(meshed: &Meshed, angles: [f64; 2]) -> String {
    let mesh = &meshed.mesh;
    let total = match mesh.domain() {
        domain if domain.periodic().is_some() => "joined ",
        domain if domain.is_constrained() => "total ",
        _ => "",
    };
    let counts = [mesh.vertex_count(), mesh.triangle_count(), mesh.max_total_degree()];
    in_line(counts, total, (meshed.is_least_proven, meshed.least_max_degree), angles)
}

fn in_line(
    [vertices, triangles, max_degree]: [u32; 3],
    total: &str,
    (is_proven, least): (bool, u32),
    angles: [f64; 2],
) -> String {
    let [min, max] = angles.map(steady_angle);
    let triangles = numbers::triangles(triangles);
    let least_is = if is_proven { "least possible" } else { "no mesh has less than" };
    format!(
        "{vertices} vertices, {triangles}, maximum {total}degree {max_degree} ({least_is} {least}), \
         angles {min} to {max}"
    )
}

/// The proven facts about a mesh, if the first line does not say them.
#[must_use]
pub fn standing(meshed: &Meshed, goal: Goal, min_angle: f64) -> Option<String> {
    standing_of(meshed, goal, min_angle, meshed.delaunay_min_angle)
}

/// The same of a mesh that a part decides: the angles, the least and Delaunay's, are those of all.
fn standing_of(
    meshed: &Meshed,
    goal: Goal,
    min_angle: f64,
    delaunay_min_angle: Option<f64>,
) -> Option<String> {
    let (max_degree, least) = (meshed.mesh.max_total_degree(), meshed.least_max_degree);
    let share = delaunay_min_angle.map(|most| share_of(min_angle, most));
    let kept = delaunay_min_angle.zip(share).map(|(most, share)| {
        let share = if share < 1.0 { percent(share) } else { "all".to_owned() };
        format!("{share} of Delaunay's minimum angle, {}", steady_angle(most))
    });
    match (meshed.found_by, goal, kept) {
        (FoundBy::Formula, Goal::LeastDegree, _) => {
            Some("It is the best of the candidates that were tried.".to_owned())
        }
        (FoundBy::Formula, _, _) => Some(
            "No window reached the limit; the formula did. A larger minimum angle may be possible."
                .to_owned(),
        ),
        (FoundBy::Search, Goal::KeepAngle(share), Some(kept)) => {
            let asked = percent(share);
            Some(format!("It has {kept}. No smaller degree keeps {asked}."))
        }
        (FoundBy::Windows { share }, _, Some(kept)) => {
            let share = match goal {
                // More may have come at the same degree than was asked for.
                Goal::KeepAngle(wanted) => wanted,
                Goal::LeastDegree | Goal::Optimize(_) => 0.0,
                Goal::MaxDegree(_) => share,
            };
            let asked = percent(share);
            let gap = if max_degree == least {
                "no degree is smaller".to_owned()
            } else if meshed.is_least_proven && goal == Goal::LeastDegree {
                "no mesh has less".to_owned()
            } else if share == 0.0 {
                format!("whether a degree from {least} on is possible is not known")
            } else {
                format!("whether a degree from {least} on is possible with {asked} is not known")
            };
            Some(format!("It has {kept}. Degree {max_degree} was reached; {gap}."))
        }
        (FoundBy::Exhaustive | FoundBy::ZigZag, _, Some(kept)) if share < Some(1.0) => {
            Some(format!("It has {kept}; more may be possible with this degree."))
        }
        (FoundBy::Exhaustive | FoundBy::ZigZag, _, Some(kept)) => Some(format!("It has {kept}.")),
        (_, _, _) => None,
    }
}
