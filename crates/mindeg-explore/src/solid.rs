//! Surfaces in space: what a file holds, and what it becomes when it is meshed anew, filled or bridged.

use mindeg::bridge::{BridgeOptions, bridge};
use mindeg::fill::{FillOptions, fill};
use mindeg::glam::DVec3;
use mindeg::model::{fill_model, mesh_model};
use mindeg::quality::TriangleQuality;
use mindeg::remesh::{Remesh, remesh};
use mindeg::{Goal, Interior, Loops, Model, TriMesh};
use mindeg_answers::command::shell_word;
use mindeg_answers::loops::{BridgeAnswer, FillAnswer, LoopName};
use mindeg_answers::model::ModelAnswer;
use mindeg_answers::numbers::{steady_angle, triangles};
use mindeg_answers::remesh::RemeshAnswer;
use mindeg_files::{Content, Input, ReadOptions, Session, Wanted};
use mindeg_mesh::{Progress, Triangles};
use serde::{Deserialize, Serialize};

use crate::arrays::{f32s, u32s};
use crate::command::KnownFiles;
use crate::download::{Download, written};
use crate::format::format_named;
use crate::terms::without_options;

/// The most triangles that are shown.
const MAX_TRIANGLES: usize = 400_000;

/// The work on a surface.
#[derive(Clone, Copy, Debug, Default, Deserialize, Eq, PartialEq)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Change {
    /// Nothing.
    #[default]
    Nothing,
    /// The faces of a whole model get points inside.
    Interior,
    /// It is meshed anew.
    Remesh,
    /// Its holes are closed.
    Fill,
    /// Two of its loops are joined.
    Bridge,
}

/// The wishes for a surface, beside the bytes of its file.
#[derive(Clone, Debug, Deserialize)]
pub(crate) struct Asked {
    /// The name of the file, whose extension tells its format.
    name: String,
    #[serde(default)]
    change: Change,
    /// The edge length of a surface meshed anew.
    size: Option<f64>,
    /// Whether holes are filled, or loops joined, with points inside.
    #[serde(default)]
    interior: bool,
    /// The indices of the loops to fill or to join, with commas between; all without it.
    #[serde(default)]
    loops: String,
    /// The format of a download.
    #[serde(default)]
    format: String,
}

impl Asked {
    /// The name of a file of the result, without its extension.
    fn stem(&self) -> String {
        let letters = |c: char| match c.is_ascii_alphanumeric() {
            true => c.to_ascii_lowercase(),
            false => '-',
        };
        let name = self.name.split('.').next().unwrap_or("surface");
        let which = match self.change {
            Change::Nothing => "as-it-is",
            Change::Interior => "points-inside",
            Change::Remesh => "remeshed",
            Change::Fill => "filled",
            Change::Bridge => "bridged",
        };
        format!("{}-{which}", name.chars().map(letters).collect::<String>())
    }

    /// The indices of the loops that are chosen.
    fn chosen(&self) -> Vec<usize> {
        self.loops.split(',').filter_map(|index| index.parse().ok()).collect()
    }
}

/// The command that writes the mesh that is asked for: of a whole model, its mesh first.
fn command(asked: &Asked, known: &KnownFiles, is_model: bool) -> String {
    let file = shell_word(known.surface(&asked.name));
    let mesh = format!("{}.obj", Asked { change: Change::Nothing, ..asked.clone() }.stem());
    let of_model = format!("mindeg mesh {file} -o {mesh}");
    let file = match (is_model, asked.change) {
        (true, Change::Nothing) => return of_model,
        (true, Change::Interior) => {
            return format!("mindeg mesh {file} --interior -o {}.obj", asked.stem());
        }
        (true, _) => mesh,
        (false, _) => file,
    };
    let interior = if asked.interior { " --interior" } else { "" };
    let numbered = |option: &str, index: usize| format!(" {option} {}", index + 1);
    let (verb, options) = match asked.change {
        Change::Nothing | Change::Interior => ("convert", String::new()),
        Change::Remesh => {
            ("remesh", asked.size.map(|size| format!(" --size {size}")).unwrap_or_default())
        }
        Change::Fill => {
            let loops = asked.chosen().into_iter().map(|index| numbered("--loop", index));
            ("fill", loops.collect::<String>() + interior)
        }
        Change::Bridge => {
            let ends = ["--from", "--to"].into_iter().zip(asked.chosen());
            let ends: String = ends.map(|(option, index)| numbered(option, index)).collect();
            ("bridge", ends + interior)
        }
    };
    let line = format!("mindeg {verb} {file}{options} -o {}.obj", asked.stem());
    if is_model { format!("{of_model}\n{line}") } else { line }
}

/// A surface as the page draws it.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct SolidShown {
    name: String,
    /// Whether its file has a whole model.
    is_model: bool,
    /// Its state, or the changes, in sentences.
    words: String,
    /// The command that writes the same mesh.
    command: String,
    vertices: usize,
    triangles: usize,
    max_degree: u32,
    /// In degrees.
    min_angle: f64,
    /// x, y and z of each vertex from the middle: `f32`, base64.
    positions: String,
    /// Three vertices each: `u32`, base64.
    corners: String,
    /// The degree of each vertex: `u32`, base64.
    degrees: String,
    /// The minimum and the maximum angle of each triangle: `f32`, base64.
    min_angles: String,
    max_angles: String,
    worst_triangle: u32,
    max_degree_vertex: u32,
    /// Its boundary loops, in words.
    loops: Vec<String>,
    /// The vertices of each in order: `u32`, base64.
    loop_vertices: Vec<String>,
    /// The first of the triangles that are new, if some are and the others stayed.
    first_new: Option<u32>,
}

/// A surface with what was asked for.
///
/// # Errors
///
/// Why there is none, in a sentence.
pub(crate) fn shown(
    asked: &Asked,
    bytes: &[u8],
    known: &KnownFiles,
    progress: Progress<'_>,
) -> Result<SolidShown, String> {
    let Changed { mesh, words, first_new, is_model } = changed(asked, bytes, progress)?;
    let name = mesh.name().unwrap_or(&asked.name).to_owned();
    let drawn = drawn(&mesh)?;
    let words = if words.is_empty() { drawn.words.clone() } else { words };
    let command = command(asked, known, is_model);
    Ok(SolidShown { first_new, is_model, ..drawn.told(name, &words, command) })
}

impl SolidShown {
    /// The same with its name, what is known of it in sentences, and the command that writes it.
    pub(crate) fn told(self, name: String, words: &str, command: String) -> Self {
        Self { name, words: without_options(words), command, ..self }
    }
}

/// A mesh as the page draws it, with its figures in a sentence.
///
/// # Errors
///
/// More triangles than the page shows.
pub(crate) fn drawn(mesh: &TriMesh) -> Result<SolidShown, String> {
    if mesh.triangles().len() > MAX_TRIANGLES {
        return Err(format!(
            "the surface has {} triangles; the page shows up to {MAX_TRIANGLES}, mindeg view any number",
            mesh.triangles().len()
        ));
    }
    let positions = mesh.positions();
    let ends = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    let (low, high) = positions.iter().fold(ends, |(low, high), &p| (low.min(p), high.max(p)));
    let center = low / 2.0 + high / 2.0;
    let quality = |triangle: &[u32; 3]| {
        let [a, b, c] = triangle.map(|vertex| positions[vertex as usize]);
        TriangleQuality::in_space(a, b, c)
    };
    let qualities: Vec<TriangleQuality> = mesh.triangles().iter().map(quality).collect();
    let least = (0..qualities.len())
        .min_by(|&a, &b| qualities[a].min_angle.total_cmp(&qualities[b].min_angle));
    let degrees = mesh.degrees();
    let max_degree = degrees.iter().copied().max().unwrap_or(0);
    let min_angle = least.map_or(0.0, |worst| qualities[worst].min_angle);
    let loops = Loops::of(mesh);
    let listed = loops.list().iter().enumerate();
    let counts = format!(
        "{} vertices, {}, maximum degree {max_degree}, minimum angle {}.",
        positions.len(),
        triangles(qualities.len() as u64),
        steady_angle(min_angle)
    );
    Ok(SolidShown {
        name: String::new(),
        is_model: false,
        command: String::new(),
        words: counts,
        vertices: positions.len(),
        triangles: qualities.len(),
        max_degree,
        min_angle,
        positions: f32s(positions.iter().flat_map(|&p| (p - center).to_array())),
        corners: u32s(mesh.triangles().iter().flatten().copied()),
        degrees: u32s(degrees.iter().copied()),
        min_angles: f32s(qualities.iter().map(|quality| quality.min_angle)),
        max_angles: f32s(qualities.iter().map(|quality| quality.max_angle)),
        worst_triangle: least.unwrap_or(0) as u32,
        max_degree_vertex: degrees.iter().position(|&it| it == max_degree).unwrap_or(0) as u32,
        loops: listed.map(|(index, found)| LoopName::new(index, found).text()).collect(),
        loop_vertices: loops.list().iter().map(|it| u32s(it.vertices.iter().copied())).collect(),
        first_new: None,
    })
}

/// A file of a surface with what was asked for.
///
/// # Errors
///
/// Why there is none, in a sentence.
pub(crate) fn file(
    asked: &Asked,
    bytes: &[u8],
    progress: Progress<'_>,
) -> Result<Download, String> {
    let format = format_named(&asked.format)?;
    let Changed { mesh, .. } = changed(asked, bytes, progress)?;
    written(&mesh, format, &asked.stem(), 0)
}

/// The surface in a file; of a whole model, its mesh and how it was made: with points inside, or of least degree.
fn surface(
    input: &Input<'_>,
    change: Change,
    progress: Progress<'_>,
) -> Result<(TriMesh, String), String> {
    let session = Session::new("");
    let options = ReadOptions::default();
    match session.mesh(input, None, progress) {
        Ok(_) if change == Change::Interior => {
            Err("points inside are for whole models; mesh a surface anew".to_owned())
        }
        Ok(mesh) => Ok((mesh, String::new())),
        Err(error) => match session.open(input, Wanted::Model, &options, progress) {
            Ok(Content::Model(text)) => {
                let model = Model::from_json(&text).map_err(|error| error.to_string())?;
                if change == Change::Interior {
                    let filled = fill_model(&model, &Interior::default(), progress)
                        .map_err(|error| error.to_string())?;
                    let words = ModelAnswer::filled(&model, &filled).words;
                    return Ok((filled.mesh, words));
                }
                let meshed = mesh_model(&model, Goal::LeastDegree, 1.0, progress)
                    .map_err(|error| error.to_string())?;
                let words = ModelAnswer::of(&model, &meshed).words;
                Ok((meshed.mesh, words))
            }
            _ => Err(error.to_string()),
        },
    }
}

/// A surface with what was asked for.
struct Changed {
    mesh: TriMesh,
    /// The change that was made, in sentences.
    words: String,
    /// The first of the triangles that were added.
    first_new: Option<u32>,
    /// Whether the file holds a whole model.
    is_model: bool,
}

/// The surface in a file with what was asked for.
fn changed(asked: &Asked, bytes: &[u8], progress: Progress<'_>) -> Result<Changed, String> {
    let (mesh, words) = surface(&Input::Bytes(&asked.name, bytes), asked.change, progress)?;
    let (is_model, chosen) = (!words.is_empty(), asked.chosen());
    let loops = Loops::of(&mesh);
    let (count, before) = (loops.list().len(), mesh.triangle_count());
    if let Some(index) = chosen.iter().find(|index| **index >= count) {
        return Err(format!("there is no loop {}; the surface has {count}", index + 1));
    }
    match asked.change {
        Change::Nothing | Change::Interior => {
            Ok(Changed { mesh, words, first_new: None, is_model })
        }
        Change::Remesh => {
            let wish = Remesh { size: asked.size, ..Remesh::default() };
            let found = remesh(&mesh, &wish, progress).map_err(|error| error.to_string())?;
            let answer = RemeshAnswer::of(&asked.name, &mesh, None, &found);
            Ok(Changed { mesh: found.mesh, words: answer.text(), first_new: None, is_model })
        }
        Change::Fill => {
            let options = FillOptions {
                only: (!chosen.is_empty()).then_some(chosen),
                interior: asked.interior,
                ..FillOptions::default()
            };
            let result =
                fill(mesh, &loops, &options, progress).map_err(|error| error.to_string())?;
            if result.filled.is_empty() {
                return Err("it has no hole to fill".to_owned());
            }
            let words = FillAnswer::of(&asked.name, &result, &loops).text(&options);
            Ok(Changed { mesh: result.mesh, words, first_new: Some(before), is_model })
        }
        Change::Bridge => {
            let ends = match (&chosen[..], count) {
                (&[from, to], _) => [from, to],
                ([], 2) => [0, 1],
                _ => return Err(format!("choose two of its {count} loops")),
            };
            let name = |index: usize| LoopName::new(index, &loops.list()[index]);
            let names = ends.map(name);
            let options = BridgeOptions { interior: asked.interior, ..BridgeOptions::default() };
            let result = bridge((mesh, &loops), None, ends, &options, progress)
                .map_err(|error| error.to_string())?;
            let [from, to] = names;
            let words = BridgeAnswer::of(&result, from, to).text();
            Ok(Changed { mesh: result.mesh, words, first_new: Some(before), is_model })
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A cube without its lid and its floor.
    const TUBE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n\
        f 1 2 6\nf 1 6 5\nf 2 3 7\nf 2 7 6\nf 3 4 8\nf 3 8 7\nf 4 1 5\nf 4 5 8\n";

    /// Two rectangles that meet at a ridge.
    const TENT: &str = r#"{"size": 0.5, "corners": [[0, 0, 0], [4, 0, 0], [4, 2, 2], [0, 2, 2], [4, 4, 0], [0, 4, 0]],
        "faces": [{"corners": [0, 1, 2, 3]}, {"corners": [3, 2, 4, 5]}]}"#;

    fn asked(change: Change, loops: &str) -> Asked {
        let name = "tube.obj".to_owned();
        let (loops, format) = (loops.to_owned(), "obj".to_owned());
        Asked { name, change, size: None, interior: false, loops, format }
    }

    #[test]
    fn a_surface_is_told_and_changed() {
        let bytes = TUBE.as_bytes();
        let found = |change, loops| {
            shown(&asked(change, loops), bytes, &KnownFiles::default(), Progress::NONE)
        };
        let whole = found(Change::Nothing, "").unwrap();
        assert_eq!((whole.vertices, whole.triangles, whole.loops.len()), (8, 8, 2));
        let filled = found(Change::Fill, "").unwrap();
        assert_eq!((filled.triangles, filled.first_new), (12, Some(8)));
        // Of four vertices each.
        assert_eq!(whole.loop_vertices.iter().map(String::len).collect::<Vec<_>>(), [24, 24]);
        let one = found(Change::Fill, "1").unwrap();
        assert_eq!(one.triangles, 10);
        assert_eq!(one.command, "mindeg fill tube.obj --loop 2 -o tube-filled.obj");
        let mut known = KnownFiles::default();
        known.add_surface("tube.obj", "my models/tube.obj");
        let bridge = Asked { interior: true, ..asked(Change::Bridge, "0,1") };
        let line =
            "mindeg bridge 'my models/tube.obj' --from 1 --to 2 --interior -o tube-bridged.obj";
        assert_eq!(command(&bridge, &known, false), line);
        let remesh = Asked { size: Some(0.5), ..asked(Change::Remesh, "") };
        let lines = "mindeg mesh tube.obj -o tube-as-it-is.obj\n\
            mindeg remesh tube-as-it-is.obj --size 0.5 -o tube-remeshed.obj";
        assert_eq!(command(&remesh, &KnownFiles::default(), true), lines);
        assert!(found(Change::Remesh, "").unwrap().min_angle > 20.0);
        assert!(found(Change::Fill, "7").unwrap_err().contains("no loop 8"));
        let file = file(&asked(Change::Fill, ""), bytes, Progress::NONE).unwrap();
        assert_eq!(file.name, "tube-filled.obj");
        assert!(file.bytes.starts_with(b"#") || !file.bytes.is_empty());
    }

    /// As `mindeg mesh` makes them, with the command that does.
    #[test]
    fn a_whole_model_has_two_meshes() {
        let model = TENT.as_bytes();
        let asked = |change| Asked { name: "tent.json".to_owned(), ..asked(change, "") };
        let found =
            |change| shown(&asked(change), model, &KnownFiles::default(), Progress::NONE).unwrap();
        let (alone, inside) = (found(Change::Nothing), found(Change::Interior));
        assert!(alone.is_model && inside.is_model && inside.loops == alone.loops);
        assert!(inside.vertices > alone.vertices && inside.min_angle > 30.0, "{}", inside.words);
        assert_eq!(inside.command, "mindeg mesh tent.json --interior -o tent-points-inside.obj");
        let saved = file(&asked(Change::Interior), model, Progress::NONE).unwrap();
        assert_eq!(saved.name, "tent-points-inside.obj");
        let tube = Asked { name: "tube.obj".to_owned(), ..asked(Change::Interior) };
        let refused = shown(&tube, TUBE.as_bytes(), &KnownFiles::default(), Progress::NONE);
        assert!(refused.unwrap_err().contains("whole models"));
    }

    #[test]
    fn a_hole_is_filled_with_points_inside() {
        // A pyramid over a square of 24 points, without its floor.
        let mut cone = "v 3 3 3\n".to_owned();
        for step in 0..24 {
            let [x, y] = match (step / 6, step % 6) {
                (0, along) => [along, 0],
                (1, along) => [6, along],
                (2, along) => [6 - along, 6],
                (_, along) => [0, 6 - along],
            };
            cone += &format!("v {x} {y} 0\nf 1 {} {}\n", step + 2, 2 + (step + 1) % 24);
        }
        let filled = |interior| {
            let asked = Asked { interior, ..asked(Change::Fill, "") };
            shown(&asked, cone.as_bytes(), &KnownFiles::default(), Progress::NONE).unwrap()
        };
        assert_eq!(filled(false).vertices, 25);
        assert!(filled(true).vertices > 40 && filled(true).loops.is_empty());
    }

    #[test]
    fn two_loops_are_joined() {
        // Two squares, one above the other.
        let rings = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n\
            f 3 2 1\nf 4 3 1\nf 5 6 7\nf 5 7 8\n";
        let joined = shown(
            &asked(Change::Bridge, ""),
            rings.as_bytes(),
            &KnownFiles::default(),
            Progress::NONE,
        )
        .unwrap();
        assert_eq!((joined.triangles, joined.loops.len()), (12, 0));
    }
}
