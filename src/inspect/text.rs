//! The findings as text for people: what is wrong first.

use mindeg::inspection::{Inspection, InspectionOptions, NoConvexOutline};
use mindeg::quality::{Distribution, METRICS};
use mindeg_answers::inspected::InspectionReport;
use mindeg_answers::numbers::{number, percent, steady_angle};
use mindeg_mesh::listed;
use std::fmt::{Display, Write};

/// How many of a kind are named one by one.
const NAMED: usize = 5;
/// How many degrees have a row of their own.
const ROWS: usize = 16;

pub(super) fn text(
    report: &InspectionReport,
    inspection: &Inspection,
    options: &InspectionOptions,
) -> String {
    let mut text = String::new();
    // Writing to a string cannot fail.
    let _ = write_text(&mut text, report, inspection, options);
    text
}

fn write_text(
    text: &mut String,
    report: &InspectionReport,
    inspection: &Inspection,
    options: &InspectionOptions,
) -> std::fmt::Result {
    write_defects(text, report)?;
    writeln!(text)?;
    write_counts(text, report)?;
    writeln!(text)?;
    write_degrees(text, report, options)?;
    write_outline(text, report, inspection)?;
    writeln!(text)?;
    write_quality(text, report)?;
    writeln!(text, "\nVertices, faces and triangles are numbered from 0, in the order of the file.")
}

fn write_defects(text: &mut String, report: &InspectionReport) -> std::fmt::Result {
    let edge = |[a, b]: &[u32; 2]| format!("{a}-{b}");
    let defects = [
        ("non-manifold edges", named(&report.non_manifold_edges, edge)),
        ("non-manifold vertices", named(&report.non_manifold_vertices, u32::to_string)),
        ("edges with inconsistent winding", named(&report.inconsistent_edges, edge)),
        ("duplicate faces", named(&report.duplicate_faces, u32::to_string)),
        ("zero-area triangles", named(&report.zero_area_triangles, u32::to_string)),
        ("unreferenced vertices", named(&report.unreferenced_vertices, u32::to_string)),
    ];
    let found: Vec<_> = defects.iter().filter(|(_, (count, _))| *count > 0).collect();
    let verdict = match found.len() {
        0 => "nothing wrong found".to_owned(),
        1 => "1 kind of defect".to_owned(),
        kinds => format!("{kinds} kinds of defects"),
    };
    let [min, max] = [report.min_angle, report.max_angle].map(steady_angle);
    writeln!(
        text,
        "{}: {verdict}; maximum degree {}, angles from {min} to {max}",
        report.file.as_deref().unwrap_or_default(),
        report.max_degree
    )?;
    for (name, (count, names)) in found {
        writeln!(text, "  {name:<32}{count:>9}  {names}")?;
    }
    Ok(())
}

/// How many there are, and the first of them by name.
fn named<T>(things: &[T], name: impl Fn(&T) -> String) -> (usize, String) {
    (things.len(), listed(things.iter().map(name), NAMED, ", "))
}

fn write_counts(text: &mut String, report: &InspectionReport) -> std::fmt::Result {
    let mut row = |name: &str, count: &dyn Display, note: String| {
        let line = format!("{name:<21}{count:>9}  {note}");
        writeln!(text, "{}", line.trim_end())
    };
    let welded = match report.welded_vertices {
        0 => String::new(),
        count => format!("merged with an earlier one: {count}"),
    };
    let cut = match (report.quads, report.polygons) {
        (0, 0) => String::new(),
        (quads, polygons) => {
            format!("for areas and angles, cut from quads: {quads}, larger polygons: {polygons}")
        }
    };
    row("vertices", &report.vertices, welded)?;
    row("faces", &report.faces, String::new())?;
    row("triangles", &report.triangles, cut)?;
    row("edges", &report.edges, String::new())?;
    row("boundary edges", &report.boundary_edges, String::new())?;
    row("boundary loops", &report.boundary_loops, String::new())?;
    if report.open_boundaries > 0 {
        let note = "lines of boundary edges that end at non-manifold edges".to_owned();
        row("open boundaries", &report.open_boundaries, note)?;
    }
    row("components", &report.components, String::new())?;
    row("Euler characteristic", &report.euler_characteristic, String::new())?;
    if let (Some(genus), Some(volume)) = (report.genus, report.volume) {
        row("genus", &genus, "closed and manifold".to_owned())?;
        row("volume", &number(volume), "length³".to_owned())?;
    }
    if !report.not_read.is_empty() {
        writeln!(text, "Not measured: {}.", report.not_read.join("; "))?;
    }
    if report.line_segments + report.points > 0 {
        writeln!(
            text,
            "Left out: {} line segments and {} points.",
            report.line_segments, report.points
        )?;
    }
    Ok(())
}

fn write_degrees(
    text: &mut String,
    report: &InspectionReport,
    options: &InspectionOptions,
) -> std::fmt::Result {
    writeln!(text, "degree     boundary  interior")?;
    let [boundary, interior] =
        [&report.degree_histogram.boundary, &report.degree_histogram.interior];
    let mut degrees: Vec<u32> = boundary.keys().chain(interior.keys()).copied().collect();
    degrees.sort_unstable();
    degrees.dedup();
    let rows = if degrees.len() > ROWS { ROWS - 1 } else { degrees.len() };
    let (own, rest) = degrees.split_at(rows);
    for degree in own {
        let [boundary, interior] =
            [boundary, interior].map(|counts| counts.get(degree).copied().unwrap_or(0));
        writeln!(text, "{degree:<9}{boundary:>10}{interior:>10}")?;
    }
    if let [first, .., last] = rest {
        let [boundary, interior] =
            [boundary, interior].map(|counts| counts.range(first..).map(|(_, n)| n).sum::<u64>());
        writeln!(text, "{:<9}{boundary:>10}{interior:>10}", format!("{first}–{last}"))?;
    }
    let more = format!("more than {} edges", options.pole_degree);
    match report.poles.len() {
        0 => writeln!(text, "No vertex has {more}.")?,
        1 => writeln!(text, "1 vertex has {more}:")?,
        count => writeln!(text, "{count} vertices have {more}:")?,
    }
    for pole in report.poles.iter().take(NAMED) {
        let [x, y, z] = pole.position;
        let place = if pole.on_boundary { "boundary" } else { "interior" };
        writeln!(text, "  vertex {} has {} ({place}, at {x}, {y}, {z})", pole.vertex, pole.degree)?;
    }
    if report.poles.len() > NAMED { writeln!(text, "  …") } else { Ok(()) }
}

fn write_outline(
    text: &mut String,
    report: &InspectionReport,
    inspection: &Inspection,
) -> std::fmt::Result {
    match (&report.outline, &inspection.outline) {
        (Some(outline), _) => {
            let counts = listed(outline.intervals.iter().map(u32::to_string), ROWS, ", ");
            let [least, found] = [outline.least_max_degree, report.max_degree];
            let comparison = if least == found { "as" } else { "where" };
            // A quad may have less edges than any triangle mesh.
            let of_triangles =
                if report.quads + report.polygons > 0 { " of triangles" } else { "" };
            writeln!(
                text,
                "All vertices are on a convex outline of {} sides with {} intervals. The least \
                 maximum degree{of_triangles} for it is {least}, {comparison} this mesh has {found}.",
                outline.intervals.len(),
                counts
            )
        }
        (None, _) if report.polygon.is_some() => match &report.polygon {
            Some(polygon) => writeln!(text, "{}", polygon.text(report.max_degree)),
            None => Ok(()),
        },
        (None, Err(NoConvexOutline::NotADisk | NoConvexOutline::InteriorVertices)) => Ok(()),
        (None, _) => writeln!(
            text,
            "All vertices are on the boundary, but its least maximum degree is not known: {}.",
            report.no_outline.as_deref().unwrap_or_default()
        ),
    }
}

fn write_quality(text: &mut String, report: &InspectionReport) -> std::fmt::Result {
    let row = |name: &str, cells: [&str; 6], unit: &str| {
        let cells: String = cells.iter().map(|cell| format!("{cell:>11}")).collect();
        format!("{name:<16}{cells}  {unit}").trim_end().to_owned()
    };
    writeln!(text, "{}", row("measure", ["min", "1%", "median", "mean", "99%", "max"], ""))?;
    for metric in METRICS {
        if let Some(spread) = report.metrics.get(metric.name) {
            let Distribution { min, p01, median, mean, p99, max } = *spread;
            let unit = if metric.unit == "1" { "" } else { metric.unit };
            let cell = |value: f64| match unit {
                "degrees" => steady_angle(value).trim_end_matches('°').to_owned(),
                _ => number(value),
            };
            let cells = [min, p01, median, mean, p99, max].map(cell);
            let cells = cells.each_ref().map(String::as_str);
            writeln!(text, "{}", row(metric.name, cells, unit))?;
        }
    }
    let shares: Vec<String> = report
        .share_below_degrees
        .iter()
        .map(|(angle, share)| format!("{} below {angle}°", percent(*share)))
        .collect();
    writeln!(text, "Minimum angles: {}. Total area: {}.", shares.join(", "), number(report.area))?;
    writeln!(text, "Worst triangles:")?;
    for worst in &report.worst_triangles {
        let [a, b, c] = worst.vertices;
        let [min, max] = [worst.min_angle, worst.max_angle].map(steady_angle);
        writeln!(
            text,
            "  triangle {} (vertices {a}, {b}, {c}): angles from {min} to {max}",
            worst.triangle
        )?;
    }
    Ok(())
}
