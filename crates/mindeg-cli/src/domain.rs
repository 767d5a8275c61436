//! From arguments to a validated domain.

use crate::args::{Counts, DomainArguments, DomainOptions};
use crate::failure::{Failure, plainly};
use crate::input;
use mindeg::{Domain, Intervals, Outline, Rectangle, Side};
use std::fs;
use std::io::{self, Read};
use std::path::Path;

/// What a domain without a name is called.
pub(crate) const UNNAMED: &str = "domain";

/// Extensions of meshes, which are no domains.
const MESHES: [&str; 10] = ["obj", "glb", "gltf", "stl", "ply", "off", "msh", "vtk", "vtu", "fbx"];

/// The one domain that the arguments describe.
pub(crate) fn domain(arguments: &DomainArguments) -> Result<Domain, Failure> {
    match &arguments.file {
        None => from_options(&arguments.options),
        Some(path) => from_file(path, &arguments.options),
    }
}

/// What a domain is called at the start of a line.
pub(crate) fn name(domain: &Domain) -> &str {
    domain.name().unwrap_or(UNNAMED)
}

/// What a domain is called within a sentence.
pub(crate) fn name_in_text(domain: &Domain) -> &str {
    domain.name().unwrap_or("the domain")
}

/// The intervals of each side, as typed or as a domain's file has them; and that domain.
pub(crate) fn counts(counts: &Counts) -> Result<(Vec<u64>, Option<Domain>), Failure> {
    match counts {
        Counts::Given(counts) => Ok((counts.clone(), None)),
        Counts::Domain(path) => {
            let domain = read(path)?;
            if domain.is_constrained() {
                let message = "the domain gives outside_degree or max_degree, which interval \
                               counts alone do not tell; mindeg mesh and mindeg tradeoff keep to \
                               them";
                return Err(Failure::Input(message.to_owned()));
            }
            let Some(convex) = domain.convex() else {
                let message = "the domain is not convex, and interval counts alone describe convex \
                               domains";
                return Err(Failure::Input(message.to_owned()));
            };
            Ok((convex.boundary().sides().map(u64::from).collect(), Some(domain)))
        }
    }
}

/// The domain in a file, with the options in place of what the file gives for its sides.
pub(crate) fn from_file(path: &Path, options: &DomainOptions) -> Result<Domain, Failure> {
    let domain = read(path)?;
    let DomainOptions { intervals, size, spacing, .. } = options;
    if intervals.is_none() && size.is_none() && spacing.is_none() {
        return Ok(domain);
    }
    let sides = overridden(domain.sides().to_vec(), options)?;
    domain.with_sides(sides).map_err(bad)
}

/// The domain that options describe without a file.
pub(crate) fn from_options(options: &DomainOptions) -> Result<Domain, Failure> {
    let DomainOptions { rectangle, corners, intervals, size, .. } = options;
    let (outline, side_count) = match (rectangle, corners) {
        (Some(size), _) => (Outline::Rectangle(Rectangle::new(size.width, size.height)), 4),
        (None, Some(corners)) => {
            let corners: Vec<_> = corners.0.iter().copied().map(Into::into).collect();
            let count = corners.len();
            (Outline::Polygon(corners), count)
        }
        (None, None) => {
            let message = "no domain: name a JSON file, or - for standard input, or give --rectangle or --corners".to_owned();
            return Err(Failure::Input(message));
        }
    };
    if intervals.is_none() && size.is_none() {
        let message = "how many intervals? give --intervals a,b,… or --size S".to_owned();
        return Err(Failure::Input(message));
    }
    let sides = overridden(vec![Side::count(1); side_count], options)?;
    Domain::new(outline, sides).map_err(bad)
}

fn bad(error: mindeg::DomainError) -> Failure {
    Failure::Input(error.to_string())
}

/// The sides with what the options give in place of what they were.
fn overridden(mut sides: Vec<Side>, options: &DomainOptions) -> Result<Vec<Side>, Failure> {
    if let Some(counts) = &options.intervals {
        if counts.0.len() != sides.len() {
            return Err(Failure::Input(format!(
                "--intervals gives {} counts for {} sides; give one for each side, \
                 counter-clockwise",
                counts.0.len(),
                sides.len()
            )));
        }
        for (side, &count) in sides.iter_mut().zip(&counts.0) {
            side.intervals = Intervals::Count(count);
        }
    }
    for side in &mut sides {
        if let Some(size) = options.size {
            side.intervals = Intervals::Size(size);
        }
        if let Some(spacing) = &options.spacing {
            side.spacing = spacing.clone();
        }
    }
    Ok(sides)
}

/// Reads a domain from a JSON file, or from standard input where the path is `-`.
fn read(path: &Path) -> Result<Domain, Failure> {
    let (name, text) = if path == Path::new("-") {
        input::note_standard_input("domain");
        let mut text = Vec::new();
        let read = io::stdin().lock().read_to_end(&mut text).map(|_| text);
        ("standard input".to_owned(), read)
    } else {
        refuse_mesh(path)?;
        input::note(path, "domain");
        (path.display().to_string(), fs::read(path))
    };
    let bytes =
        text.map_err(|error| Failure::Io(format!("cannot read {name}: {}", plainly(&error))))?;
    let text = String::from_utf8(bytes)
        .map_err(|error| Failure::Input(format!("{name} is not UTF-8 text: {error}")))?;
    if text.trim().is_empty() {
        return Err(Failure::Input(format!("{name} is empty; a domain in JSON is expected")));
    }
    Domain::from_json(&text).map_err(|error| Failure::Input(format!("{name}: {error}")))
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
