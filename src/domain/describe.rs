//! `mindeg domain`: what was understood of a file, and the domain in JSON.

use super::{Subject, subject};
use crate::args::DescribeArguments;
use crate::bar::Bar;
use crate::failure::Failure;
use crate::interrupt::SESSION;
use crate::making::wrote;
use crate::named_files::{is_pattern, names, prepare, summed_up};
use crate::standard_output::{print, print_json};
use crate::terminal::say;
use mindeg::{Domain, DomainJsonError};
use mindeg_answers::names::shown;
use mindeg_answers::numbers::{coordinate, number};
use mindeg_files::{Outputs, Polygon, PolygonFile, Wanted, write_to};
use serde::Serialize;
use std::path::Path;

/// The output of `--json` for each polygon.
#[derive(Serialize)]
struct Row {
    index: usize,
    name: Option<String>,
    /// The reason why it is not a domain.
    error: Option<String>,
    /// All faults of a domain in JSON.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    faults: Vec<Fault>,
    #[serde(flatten)]
    shape: Option<Shape>,
}

/// A fault of a domain in JSON, and where it is in the text.
#[derive(Serialize)]
struct Fault {
    path: String,
    line: usize,
    column: usize,
    message: String,
}

impl Fault {
    fn of(error: &DomainJsonError) -> Self {
        let DomainJsonError { path, line, column, message, .. } = error;
        Self { path: path.clone(), line: *line, column: *column, message: message.clone() }
    }
}

#[derive(Serialize)]
struct Shape {
    rings: usize,
    sides: usize,
    vertices: u32,
    area: f64,
    min: [f64; 2],
    max: [f64; 2],
}

impl Shape {
    fn of(domain: &Domain) -> Self {
        let bounds = domain.placement().bounds();
        Self {
            rings: domain.rings().ring_count(),
            sides: domain.rings().side_count(),
            vertices: domain.rings().vertex_count(),
            area: domain.area(),
            min: bounds.min.to_array(),
            max: bounds.max.to_array(),
        }
    }
}

pub(crate) fn run(arguments: &DescribeArguments) -> Result<(), Failure> {
    let mut domain = arguments.domain.clone();
    domain.options.outline.separate = arguments.output.as_deref().is_none_or(is_pattern);
    let subject = subject(&domain, Wanted::Domain, &Bar::new(true));
    if let Err(Failure::Domain { message, error }) = &subject
        && arguments.json
    {
        let faults = std::iter::once(&**error).chain(&error.more).map(Fault::of).collect();
        let (name, error) = (None, Some(message.clone()));
        print_json(&[Row { index: 1, name, error, faults, shape: None }])?;
    }
    match (subject?, &arguments.output) {
        (Subject::Polygons(polygons), Some(path)) if is_pattern(path) => write_all(&polygons, path),
        (subject, Some(path)) => write(&subject.only()?, path),
        (subject, None) => show(&subject, arguments.json),
    }
}

fn show(subject: &Subject, json: bool) -> Result<(), Failure> {
    let (rows, title): (Vec<Row>, _) = match subject {
        Subject::Polygons(polygons) => {
            let rows: Vec<Row> =
                polygons.polygons.iter().map(|polygon| row(polygons, polygon)).collect();
            let what = if rows.len() == 1 { "polygon" } else { "polygons" };
            let format = polygons.format.name();
            let title = format!("{}: {format}, {} {what}\n", polygons.file, rows.len());
            (rows, title)
        }
        Subject::Domain(domain) => {
            let name = domain.name().map(str::to_owned);
            (
                vec![Row {
                    index: 1,
                    name,
                    error: None,
                    faults: Vec::new(),
                    shape: Some(Shape::of(domain)),
                }],
                String::new(),
            )
        }
        Subject::Model(_) | Subject::Mesh(_) => unreachable!("opened as a domain"),
    };
    if json {
        return print_json(&rows);
    }
    print(&rows.iter().map(line).fold(title, |text, line| text + &line))
}

fn row(polygons: &PolygonFile, polygon: &Polygon) -> Row {
    let (shape, error) = match polygons.domain(polygon) {
        Ok(domain) => (Some(Shape::of(&domain)), None),
        Err(error) => (None, Some(error.to_string())),
    };
    let name = (!polygon.label.is_empty()).then(|| polygon.label.clone());
    Row { index: polygon.index, name, error, faults: Vec::new(), shape }
}

fn line(row: &Row) -> String {
    let name = shown(row.name.as_deref().unwrap_or("unnamed"));
    let Some(Shape { rings, sides, vertices, area, min, max }) = &row.shape else {
        return format!("{:>5}  {}\n", row.index, row.error.as_deref().unwrap_or_default());
    };
    let holes = match rings - 1 {
        0 => String::new(),
        1 => ", 1 hole".to_owned(),
        holes => format!(", {holes} holes"),
    };
    let [x, y] = min.map(coordinate);
    let [right, top] = max.map(coordinate);
    let side = if *sides == 1 { "side" } else { "sides" };
    format!(
        "{:>5}  {name}: {vertices} points on {sides} {side}{holes}, area {}, from ({x}, {y}) to \
         ({right}, {top})\n",
        row.index,
        number(*area)
    )
}

/// Writes the JSON of one domain.
pub(crate) fn write(domain: &Domain, path: &Path) -> Result<(), Failure> {
    write_texts(&[(domain.to_json(), path)])
}

/// Writes files of one text each, all or none.
pub(crate) fn write_texts(texts: &[(String, &Path)]) -> Result<(), Failure> {
    let mut outputs = Outputs::new(&SESSION);
    let mut files = Vec::new();
    for (text, path) in texts {
        files.push((text, *path, outputs.open(path)?));
    }
    let mut names = Vec::new();
    for (text, path, out) in files {
        write_to(path, out, |out| writeln!(out, "{text}"))?;
        names.push(path.display().to_string());
    }
    outputs.finish()?;
    if let Some(wrote) = wrote(&names) {
        say(&wrote);
    }
    Ok(())
}

/// Writes a file for each polygon; skips polygons that are not domains.
fn write_all(polygons: &PolygonFile, pattern: &Path) -> Result<(), Failure> {
    let files = names(pattern, &polygons.polygons, "json");
    prepare(&files)?;
    let mut failures = Vec::new();
    for (polygon, file) in polygons.polygons.iter().zip(&files) {
        let domain = polygons.domain(polygon).map_err(Failure::from);
        let written = domain.and_then(|domain| write(&domain, file));
        failures.extend(written.err());
    }
    summed_up(failures, files.len(), "polygons are no domains; the others were written")
}
