//! What a file is: a domain in JSON, or outlines that other programs drew.

use crate::args::OutlineOptions;
use crate::failure::{Failure, plainly};
use crate::input;
use crate::terminal::say;
use mindeg::Domain;
use mindeg_outlines::{self as outlines, Division, Feature, OutlineFormat, Outlines};
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// Extensions of meshes, which are no domains.
const MESHES: [&str; 8] = ["glb", "gltf", "stl", "ply", "off", "vtk", "vtu", "fbx"];

/// What a file holds.
pub(crate) enum Content {
    /// One domain, in JSON.
    Domain(Box<Domain>),
    /// Polygons, in any other format.
    Polygons(Polygons),
}

/// The polygons of a file, or those that were chosen.
pub(crate) struct Polygons {
    /// The file, as messages name it.
    pub(crate) file: String,
    pub(crate) format: OutlineFormat,
    /// In the order of the file; indices count from 1 among all polygons of the file.
    pub(crate) polygons: Vec<Polygon>,
    division: Division,
    is_repaired: bool,
}

/// One polygon of a file.
pub(crate) struct Polygon {
    pub(crate) index: usize,
    /// Its name, with a number if several polygons have it; empty if it has none.
    pub(crate) label: String,
    feature: Feature,
}

impl Polygon {
    /// What messages and files call it.
    pub(crate) fn name(&self) -> String {
        if self.label.is_empty() { format!("polygon {}", self.index) } else { self.label.clone() }
    }
}

impl Polygons {
    /// The domain of one of them.
    pub(crate) fn domain(&self, polygon: &Polygon) -> Result<Domain, Failure> {
        let name = (!polygon.label.is_empty()).then(|| polygon.label.clone());
        let feature = Feature { name, ..polygon.feature.clone() };
        feature.domain(&self.division).map_err(|error| {
            let hint = if error.is_touch() && !self.is_repaired {
                "; --repair parts rings that touch themselves"
            } else {
                ""
            };
            Failure::Input(format!("{error}{hint}")).of(&polygon.name())
        })
    }

    /// The only one, or why there are several.
    pub(crate) fn only(&self) -> Result<Domain, Failure> {
        match &self.polygons[..] {
            [polygon] => self.domain(polygon).map_err(|failure| failure.of(&self.file)),
            polygons => Err(Failure::Input(format!(
                "{} has {} polygons; choose one with --feature, by its name or index: {}",
                self.file,
                polygons.len(),
                listed(polygons)
            ))),
        }
    }
}

/// The first polygons in a few words.
fn listed(polygons: &[Polygon]) -> String {
    const SHOWN: usize = 5;
    let one = |polygon: &Polygon| match &*polygon.label {
        "" => polygon.index.to_string(),
        label => format!("{} ({label})", polygon.index),
    };
    let shown: Vec<String> = polygons.iter().take(SHOWN).map(one).collect();
    let more = if polygons.len() > SHOWN { ", …; mindeg domain lists all" } else { "" };
    format!("{}{more}", shown.join(", "))
}

/// Reads a file, or standard input where the path is `-`.
pub(crate) fn read(
    path: &Path,
    options: &OutlineOptions,
    size: Option<f64>,
) -> Result<Content, Failure> {
    let (name, bytes) = bytes_of(path)?;
    if bytes.trim_ascii().is_empty() {
        return Err(Failure::Input(format!("{name} is empty; a domain is expected")));
    }
    let path = (path != Path::new("-")).then_some(path);
    let Some(format) = format(path, &name, &bytes)? else {
        options.refuse_for_json(&name)?;
        let text = String::from_utf8(bytes)
            .map_err(|error| Failure::Input(format!("{name} is not UTF-8 text: {error}")))?;
        let domain =
            Domain::from_json(&text).map_err(|error| Failure::Input(format!("{name}: {error}")))?;
        return Ok(Content::Domain(Box::new(domain)));
    };
    let bad = |error| Failure::Input(format!("{name}: {error}"));
    let mut outlines = outlines::read(&bytes, format).map_err(bad)?;
    drop(bytes);
    if options.repair {
        outlines = outlines.repaired().map_err(bad)?;
    }
    let Outlines { features, notes } = outlines;
    notes.iter().for_each(|note| say(&format!("{name}: {note}")));
    let polygons = chosen(labelled(features), options, &name)?;
    let corner_angle = options.corner_angle;
    let division = Division { corner_angle, size };
    let is_repaired = options.repair;
    Ok(Content::Polygons(Polygons { file: name, format, polygons, division, is_repaired }))
}

/// What messages call a file, and its bytes.
fn bytes_of(path: &Path) -> Result<(String, Vec<u8>), Failure> {
    let name = input::name_of(path);
    let bytes = if path == Path::new("-") {
        input::standard_input("domain").map(<[u8]>::to_vec)
    } else {
        refuse_mesh(path)?;
        input::note(path, "domain");
        fs::read(path)
    };
    match bytes {
        Ok(bytes) => Ok((name, bytes)),
        Err(error) => Err(Failure::Io(format!("cannot read {name}: {}", plainly(&error)))),
    }
}

fn refuse_mesh(path: &Path) -> Result<(), Failure> {
    let extension = path.extension().map(|name| name.to_string_lossy().to_lowercase());
    if extension.is_some_and(|extension| MESHES.contains(&extension.as_str())) {
        return Err(Failure::Input(format!(
            "{} is a mesh, not a domain; mindeg view, inspect and convert take meshes",
            path.display()
        )));
    }
    Ok(())
}

/// The format of outlines in a file; none if it is, or should be, a domain in JSON.
fn format(path: Option<&Path>, name: &str, bytes: &[u8]) -> Result<Option<OutlineFormat>, Failure> {
    let told = path.and_then(OutlineFormat::of_path);
    let looks_like = OutlineFormat::of_content(bytes);
    let is_json = bytes.trim_ascii_start().starts_with(b"{") && looks_like.is_none();
    let ends_as_json = path.is_some_and(|path| {
        path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("json"))
    });
    match (told, looks_like) {
        (None, Some(OutlineFormat::GeoJson)) if ends_as_json => Ok(looks_like),
        (None, Some(format)) if ends_as_json => Err(Failure::Input(format!(
            "{name} ends in .json, and its content looks like {}; rename it to end in .{}",
            format.name(),
            format.extensions()[0]
        ))),
        (Some(format), None) if is_json && format != OutlineFormat::GeoJson => {
            Err(Failure::Input(format!(
                "{name} ends as {} does, and its content is JSON; rename it to end in .json",
                format.name()
            )))
        }
        // The reader of domains says best what is wrong with other text.
        (None, None) => Ok(None),
        _ => match outlines::format_of(path, bytes) {
            Ok(format) => Ok(Some(format)),
            Err(error) => Err(Failure::Input(format!("{name}: {error}"))),
        },
    }
}

/// The polygons with labels that differ.
fn labelled(features: Vec<Feature>) -> Vec<Polygon> {
    let mut counts: BTreeMap<String, usize> = BTreeMap::new();
    for name in features.iter().filter_map(|feature| feature.name.as_ref()) {
        *counts.entry(name.clone()).or_default() += 1;
    }
    let mut numbers: BTreeMap<String, usize> = BTreeMap::new();
    let polygon = |(index, feature): (usize, Feature)| {
        let label = match &feature.name {
            None => String::new(),
            Some(name) if counts[name] == 1 => name.clone(),
            Some(name) => {
                let number = numbers.entry(name.clone()).or_default();
                *number += 1;
                format!("{name} {number}")
            }
        };
        Polygon { index: index + 1, label, feature }
    };
    features.into_iter().enumerate().map(polygon).collect()
}

/// The polygons that `--feature` names: one by its label or index, or all of one name.
fn chosen(
    polygons: Vec<Polygon>,
    options: &OutlineOptions,
    file: &str,
) -> Result<Vec<Polygon>, Failure> {
    let Some(wanted) = &options.feature else { return Ok(polygons) };
    let of_name = |polygon: &Polygon| polygon.feature.name.as_ref() == Some(wanted);
    let by_label = polygons.iter().any(|polygon| polygon.label == *wanted);
    let by_name = !by_label && polygons.iter().any(of_name);
    let index = wanted.parse::<usize>().ok();
    let problem = format!(
        "{file} has no polygon {wanted:?}; give a name, or an index from 1 to {}: {}",
        polygons.len(),
        listed(&polygons)
    );
    let is_chosen = |polygon: &Polygon| match (by_label, by_name) {
        (true, _) => polygon.label == *wanted,
        (_, true) => of_name(polygon),
        _ => Some(polygon.index) == index,
    };
    let chosen: Vec<Polygon> = polygons.into_iter().filter(|it| is_chosen(it)).collect();
    if chosen.is_empty() { Err(Failure::Input(problem)) } else { Ok(chosen) }
}
