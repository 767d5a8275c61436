//! From arguments to a validated domain.

use crate::args::DomainArguments;
use crate::failure::Failure;
use mindeg::{Domain, Intervals, Outline, Rectangle, Side};
use std::fs;
use std::io::{self, Read};
use std::path::Path;

/// The one domain that the arguments describe.
pub(crate) fn domain(arguments: &DomainArguments) -> Result<Domain, Failure> {
    match &arguments.files[..] {
        [] => from_options(arguments),
        [path] => from_file(path, arguments),
        [_, second, ..] => Err(Failure::Input(format!(
            "one domain at a time: {} is a second one",
            second.display()
        ))),
    }
}

/// The domain in a file, with the options in place of what the file says of its sides.
pub(crate) fn from_file(path: &Path, arguments: &DomainArguments) -> Result<Domain, Failure> {
    let domain = read(path)?;
    let DomainArguments { intervals, size, spacing, .. } = arguments;
    if intervals.is_none() && size.is_none() && spacing.is_none() {
        return Ok(domain);
    }
    let sides = overridden(domain.sides().to_vec(), arguments)?;
    let constraints = domain.constraints().clone();
    let replaced =
        Domain::constrained(domain.outline().clone(), sides, constraints).map_err(bad)?;
    match domain.name() {
        Some(name) => replaced.named(name).map_err(bad),
        None => Ok(replaced),
    }
}

fn from_options(arguments: &DomainArguments) -> Result<Domain, Failure> {
    let DomainArguments { rectangle, corners, intervals, size, .. } = arguments;
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
    let sides = overridden(vec![Side::count(1); side_count], arguments)?;
    Domain::new(outline, sides).map_err(bad)
}

fn bad(error: mindeg::DomainError) -> Failure {
    Failure::Input(error.to_string())
}

/// The sides with what the arguments say of them in place of what they were.
fn overridden(mut sides: Vec<Side>, arguments: &DomainArguments) -> Result<Vec<Side>, Failure> {
    if let Some(counts) = &arguments.intervals {
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
        if let Some(size) = arguments.size {
            side.intervals = Intervals::Size(size);
        }
        if let Some(spacing) = &arguments.spacing {
            side.spacing = spacing.clone();
        }
    }
    Ok(sides)
}

/// Reads a domain from a JSON file, or from standard input where the path is `-`.
fn read(path: &Path) -> Result<Domain, Failure> {
    let (name, text) = if path == Path::new("-") {
        let mut text = Vec::new();
        let read = io::stdin().lock().read_to_end(&mut text).map(|_| text);
        ("standard input".to_owned(), read)
    } else {
        (path.display().to_string(), fs::read(path))
    };
    let bytes = text.map_err(|error| Failure::Io(format!("cannot read {name}: {error}")))?;
    let text = String::from_utf8(bytes)
        .map_err(|error| Failure::Input(format!("{name} is not UTF-8 text: {error}")))?;
    Domain::from_json(&text).map_err(|error| Failure::Input(format!("{name}: {error}")))
}
