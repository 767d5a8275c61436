//! The whole map of a file whose parts share no edge: the one mesh of all of them.

use mindeg::beside::mesh_all;
use mindeg::interior;
use mindeg::{Domain, TriMesh};
use mindeg_answers::advice::{Advice, AdviceAnswer, Purpose, advised_interior};
use mindeg_answers::command::{FEWEST_EDGES, MeshCommand, POINTS_INSIDE, mesh_stem};
use mindeg_answers::interior::{angles_and_degrees, local_limits};
use mindeg_answers::mesh::{MeshBesideAnswer, mesh_beside};
use mindeg_answers::names::part_name;
use mindeg_answers::numbers::triangles;
use mindeg_mesh::Progress;
use serde::{Deserialize, Serialize};
use serde_json::value::RawValue;

use crate::answer::MAX_VERTICES;
use crate::download::{Download, written};
use crate::format::format_named;
use crate::solid::{SolidShown, drawn};

/// A map of several parts, as the page gets and sends it.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub struct WholeMap {
    name: String,
    /// The words of the command line that name its file, and say how it is read.
    words: Vec<String>,
    parts: Vec<Box<RawValue>>,
}

impl WholeMap {
    /// The map of domains that a file holds, if there are several, and not too many points for the page.
    #[must_use]
    pub fn of(name: &str, words: &[String], domains: &[Domain]) -> Option<Self> {
        let points: u32 = domains.iter().map(|domain| domain.rings().vertex_count()).sum();
        if domains.len() < 2 || points > MAX_VERTICES {
            return None;
        }
        let json = |domain: &Domain| RawValue::from_string(domain.to_json()).ok();
        let parts = domains.iter().map(json).collect::<Option<_>>()?;
        Some(Self { name: name.to_owned(), words: words.to_vec(), parts })
    }

    /// The same where the file is read with one option more.
    pub(crate) fn with_option(mut self, option: &str) -> Self {
        self.words.push(option.to_owned());
        self
    }
}

/// A request about a map.
#[derive(Clone, Debug, Deserialize)]
pub(crate) struct Asked {
    /// The purpose of its mesh; as advised without it.
    purpose: Option<String>,
    /// The format of a download.
    #[serde(default)]
    format: String,
}

/// The mesh of a map as the page draws it.
#[derive(Debug, Serialize)]
pub(crate) struct WholeShown {
    #[serde(flatten)]
    mesh: SolidShown,
    purpose: Purpose,
    /// The meshes to take, where none was asked for.
    advice: Option<AdviceAnswer>,
}

/// A map whose mesh is asked for.
struct Map {
    /// The first part under the name of all.
    named: Domain,
    words: Vec<String>,
    domains: Vec<Domain>,
}

impl Map {
    fn of(body: &[u8]) -> Result<Self, String> {
        let WholeMap { name, words, parts } = serde_json::from_slice(body)
            .map_err(|error| format!("the request is not what the page sends: {error}"))?;

        let domains: Vec<Domain> = parts
            .iter()
            .map(|text| Domain::from_json_up_to(text.get(), MAX_VERTICES))
            .collect::<Result<_, _>>()
            .map_err(|error| error.without_position())?;
        let first = domains.first().ok_or("the map has no part")?.clone();
        let named = first.clone().named(name).unwrap_or(first);
        Ok(Self { named, words, domains })
    }

    /// The mesh for a purpose, and what is known of it in sentences.
    fn mesh(&self, purpose: Purpose, progress: Progress<'_>) -> Result<(TriMesh, String), String> {
        let of_part = |index: usize, error: String| {
            format!("{}: {error}", part_name(index, &self.domains[index]))
        };
        let name = self.named.name().unwrap_or("map");
        let Some(goal) = purpose.goal() else {
            let wanted = advised_interior(&self.domains[0]);
            let found = interior::mesh_all(&self.domains, &wanted, progress)
                .map_err(|(index, error)| of_part(index, error.to_string()))?;
            let report = &found.report;
            let words = format!(
                "{} in {} parts, {}. {}",
                triangles(report.triangles as u64),
                self.domains.len(),
                angles_and_degrees(report),
                local_limits(report, self.domains[0].projection())
            );
            return Ok((found.mesh.named(name), words));
        };
        let found = mesh_all(&self.domains, goal, progress)
            .map_err(|(index, error)| of_part(index, error.to_string()))?;
        let angles = found.parts.iter().map(|part| {
            let range = part.mesh.angle_range();
            [range.min, range.max]
        });
        let angles: Vec<[f64; 2]> = angles.collect();
        let answer = MeshBesideAnswer::of(&found, &angles, Some(name));
        let words = mesh_beside(&found, &answer, goal).join(". ");
        Ok((found.mesh.named(name), words))
    }
}

/// The mesh of a map.
///
/// # Errors
///
/// Why there is none, in a sentence.
pub(crate) fn shown(
    asked: &Asked,
    body: &[u8],
    progress: Progress<'_>,
) -> Result<WholeShown, String> {
    let map = Map::of(body)?;
    let told = asked.purpose.as_deref().map(str::parse::<Purpose>).transpose()?;
    let (purpose, advice) = match told {
        Some(purpose) => (purpose, None),
        None => {
            let advice =
                Advice::of(&map.domains, progress).map_err(|(_, error)| error.to_string())?;
            (advice.first, Some(AdviceAnswer::of(advice)))
        }
    };
    let (mesh, words) = map.mesh(purpose, progress)?;
    let command = MeshCommand::of(&map.words, &map.named).advised(purpose);
    let name = map.named.name().unwrap_or("map").to_owned();
    let mesh = drawn(&mesh)?.told(name, &words, command);
    Ok(WholeShown { mesh, purpose, advice })
}

/// A file of the mesh of a map.
///
/// # Errors
///
/// Why there is none, in a sentence.
pub(crate) fn file(asked: &Asked, body: &[u8], progress: Progress<'_>) -> Result<Download, String> {
    let map = Map::of(body)?;
    let purpose: Purpose = asked.purpose.as_deref().unwrap_or_default().parse()?;
    let format = format_named(&asked.format)?;
    let which = match purpose {
        Purpose::Solver => POINTS_INSIDE,
        Purpose::Fewest => FEWEST_EDGES,
        Purpose::Patch => "keep angle 95",
    };
    let (mesh, _) = map.mesh(purpose, progress)?;
    written(&mesh, format, &mesh_stem(&map.named, which), 0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The mesh of a map is that of all its parts, by the command that makes it.
    #[test]
    fn a_map_of_two_parts_is_one_mesh() {
        let square = |at: f64| {
            let corners = [[at, 0.0], [at + 4.0, 0.0], [at + 4.0, 3.0], [at, 3.0]];
            Domain::polygon(corners, [6, 4, 2, 2].map(mindeg::Side::count).into()).unwrap()
        };
        let domains = [square(0.0), square(9.0)];
        let words = ["my land.svg".to_owned()];
        assert!(WholeMap::of("land", &words, &domains[..1]).is_none());
        let map = WholeMap::of("land", &words, &domains).unwrap().with_option("--repair");
        let body = serde_json::to_vec(&map).unwrap();
        let asked = |purpose: Option<&str>| Asked {
            purpose: purpose.map(str::to_owned),
            format: "obj".to_owned(),
        };
        let told = |purpose| {
            let found = shown(&asked(purpose), &body, Progress::NONE).unwrap();
            serde_json::to_value(found).unwrap()
        };
        let advised = told(None);
        assert_eq!((&advised["purpose"], &advised["name"]), (&"solver".into(), &"land".into()));
        assert!(advised["advice"].is_object());
        let line = "mindeg mesh 'my land.svg' --repair --interior -o land-points-inside.obj";
        assert_eq!(advised["command"], line);
        let fewest = told(Some("fewest"));
        let words = fewest["words"].as_str().unwrap();
        assert!(words.contains("in 2 parts: 28 vertices, 24 triangles"), "{words}");
        let saved = file(&asked(Some("fewest")), &body, Progress::NONE).unwrap();
        assert_eq!(saved.name, "land-fewest-edges.obj");
        let faces = String::from_utf8(saved.bytes).unwrap();
        assert_eq!(faces.lines().filter(|line| line.starts_with("f ")).count(), 24);
        assert!(shown(&asked(Some("game")), &body, Progress::NONE).is_err());
    }
}
