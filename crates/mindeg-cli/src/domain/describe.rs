//! `mindeg domain`: what was understood of a file, and the domain in JSON.

use super::{Content, Polygons, subject};
use crate::args::DescribeArguments;
use crate::failure::Failure;
use crate::named_files::{is_pattern, names, prepare, summed_up};
use crate::output::{Outputs, is_standard_output, write_to};
use crate::standard_output::{print, print_json};
use crate::terminal::say;
use mindeg::Domain;
use mindeg_outlines::Polygon;
use serde::Serialize;
use std::fmt::Write as _;
use std::path::Path;

/// What `--json` prints for each polygon.
#[derive(Serialize)]
struct Row {
    index: usize,
    name: Option<String>,
    /// Why it is no domain.
    error: Option<String>,
    #[serde(flatten)]
    shape: Option<Shape>,
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
            area: domain.placement().area(),
            min: bounds.min.to_array(),
            max: bounds.max.to_array(),
        }
    }
}

pub(crate) fn run(arguments: &DescribeArguments) -> Result<(), Failure> {
    match (subject(&arguments.domain)?, &arguments.output) {
        (Content::Domain(domain), Some(path)) => write(&domain, path),
        (Content::Polygons(polygons), Some(path)) if is_pattern(path) => write_all(&polygons, path),
        (Content::Polygons(polygons), Some(path)) => write(&polygons.only()?, path),
        (content, None) => show(&content, arguments.json),
    }
}

fn show(content: &Content, json: bool) -> Result<(), Failure> {
    let rows: Vec<Row> = match content {
        Content::Domain(domain) => {
            let name = domain.name().map(str::to_owned);
            vec![Row { index: 1, name, error: None, shape: Some(Shape::of(domain)) }]
        }
        Content::Polygons(polygons) => {
            polygons.polygons.iter().map(|polygon| row(polygons, polygon)).collect()
        }
    };
    if json {
        return print_json(&rows);
    }
    let mut text = String::new();
    if let Content::Polygons(polygons) = content {
        let count = rows.len();
        let what = if count == 1 { "polygon" } else { "polygons" };
        let _ = writeln!(text, "{}: {}, {count} {what}", polygons.file, polygons.format.name());
    }
    rows.iter().for_each(|row| text.push_str(&line(row)));
    print(&text)
}

fn row(polygons: &Polygons, polygon: &Polygon) -> Row {
    let (shape, error) = match polygons.domain(polygon) {
        Ok(domain) => (Some(Shape::of(&domain)), None),
        Err(failure) => (None, failure.message().map(str::to_owned)),
    };
    let name = (!polygon.label.is_empty()).then(|| polygon.label.clone());
    Row { index: polygon.index, name, error, shape }
}

fn line(row: &Row) -> String {
    let name = row.name.as_deref().unwrap_or("unnamed");
    let Some(Shape { rings, sides, vertices, area, min, max }) = &row.shape else {
        return format!("{:>5}  {}\n", row.index, row.error.as_deref().unwrap_or_default());
    };
    let holes = match rings - 1 {
        0 => String::new(),
        1 => ", 1 hole".to_owned(),
        holes => format!(", {holes} holes"),
    };
    let side = if *sides == 1 { "side" } else { "sides" };
    format!(
        "{:>5}  {name}: {vertices} points on {sides} {side}{holes}, area {area:.4e}, from ({:.6}, \
         {:.6}) to ({:.6}, {:.6})\n",
        row.index, min[0], min[1], max[0], max[1]
    )
}

/// Writes the JSON of one domain.
fn write(domain: &Domain, path: &Path) -> Result<(), Failure> {
    let mut outputs = Outputs::default();
    let out = outputs.open(path)?;
    write_to(path, out, |out| writeln!(out, "{}", domain.to_json()))?;
    outputs.finish()?;
    if !is_standard_output(path) {
        say(&format!("wrote {}", path.display()));
    }
    Ok(())
}

/// Writes a file for each polygon; one that is no domain does not keep the others from it.
fn write_all(polygons: &Polygons, pattern: &Path) -> Result<(), Failure> {
    let files = names(pattern, &polygons.polygons, "json");
    prepare(&files)?;
    let mut failures = Vec::new();
    for (polygon, file) in polygons.polygons.iter().zip(&files) {
        let written = polygons.domain(polygon).and_then(|domain| write(&domain, file));
        failures.extend(written.err());
    }
    summed_up(failures, files.len(), "are no domains; the others were written")
}
