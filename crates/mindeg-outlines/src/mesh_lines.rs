//! The lines of files that hold meshes: OBJ and Gmsh's MSH, by the readers of meshes.
//!
//! The closed loops of the lines are rings, with their points bit for bit; loops inside others are holes.
//! In an MSH a curve of the geometry is a side, and the name of its physical group the side's name; where it says which
//! surfaces there are, each is a polygon, other curves are lines inside, and a loop that no surface fills is a hole. In an
//! OBJ, objects and groups (`o`, `g`) name the sides of a ring that consists of several of them, or the
//! polygon if it lies in one; an OBJ with faces is a mesh, but an MSH may have both.

use std::collections::{HashMap, HashSet};
use std::sync::Arc as Shared;

use mindeg_domain::InnerPoint;
use mindeg_formats::{Polylines, msh, obj};
use mindeg_mesh::{NamedVertex, listed, sorted};

use super::curve::{PieceCurve, Segment};
use super::loops::{self, Link};
use super::outline::{Border, FillRule, Outlines};
use super::periodic::PeriodicCurve;
use super::text::{clean, counted};
use crate::error::OutlineError;

/// Reads the line elements of an MSH, in text or binary.
///
/// # Errors
///
/// Malformed input; a file without lines, or with lines that close no ring or do not lie in
/// a plane of equal z.
pub(super) fn read_msh(bytes: &[u8]) -> Result<Outlines, OutlineError> {
    let file = msh::read_lines(bytes)?;
    let others = counted(usize::try_from(file.others).unwrap_or(usize::MAX), "other element");
    if file.segments.is_empty() {
        let problem = format!(
            "the file has no line elements, only {others}; mesh the curves with gmsh -1, and save all \
             elements (Mesh.SaveAll = 1) or a physical group of the curves"
        );
        return Err(OutlineError::place("$Elements", problem));
    }
    let points: Vec<_> = file.positions.iter().map(|point| point.truncate()).collect();
    let periodic = file.periodic.iter().map(|line| PeriodicCurve::new(line, &points)).collect();
    let has_others = file.others > 0;
    let are_straightened = file.are_straightened;
    let left_groups = file.left_groups.clone();
    let outlines = match file.surfaces.is_empty() {
        true => outlines(file, true),
        false => surfaces(&file),
    };
    let mut outlines = outlines.map_err(|mut error| {
        if error.problem == loops::BRANCHES {
            error.problem.push_str(", or save several surfaces as MSH 4.1 (gmsh -1 -format msh4)");
        }
        error
    })?;
    outlines.periodic = periodic;
    outlines.notes.extend(has_others.then(|| format!("left out {others}")));
    let straightened =
        || "took edges of higher order as straight ones between their ends".to_owned();
    outlines.notes.extend(are_straightened.then(straightened));
    if !left_groups.is_empty() {
        let quoted = left_groups.iter().map(|name| format!("{name:?}"));
        outlines.notes.push(format!(
            "left out what {} shares with other physical groups: each point, curve and surface is in the first one alone",
            listed(quoted, 5, ", ")
        ));
    }
    Ok(outlines)
}

/// Reads the lines of an OBJ.
///
/// # Errors
///
/// The errors of [`read_msh`]; a file with faces.
pub(super) fn read_obj(bytes: &[u8]) -> Result<Outlines, OutlineError> {
    let file = obj::read_lines(bytes)?;
    if file.others > 0 {
        let problem = "the file has faces, so it is a model or a mesh: mindeg mesh meshes its faces and tells their \
                       least degree, and inspect, view and convert take meshes; keep only its v and l lines for an outline";
        return Err(OutlineError::place("", problem));
    }
    if file.segments.is_empty() {
        let problem = "the file has no lines; give a closed loop, such as l 1 2 3 1";
        return Err(OutlineError::place("", problem));
    }
    let mut outlines = outlines(file, false)?;
    outlines.features.iter_mut().for_each(|feature| feature.name_by_side());
    Ok(outlines)
}

/// The polygons that lines form; sides begin where another line does, if `by_line`.
pub(super) fn outlines(file: Polylines, by_line: bool) -> Result<Outlines, OutlineError> {
    let links = links(&file, by_line);
    let heights = file.segments.as_flattened().iter().map(|&end| file.positions[end as usize].z);
    let mut notes: Vec<String> = height(heights)?.into_iter().collect();
    let points: Vec<_> = file.positions.iter().map(|point| point.truncate()).collect();
    let (rings, note) = loops::rings(&points, &links)?;
    let way_out = if by_line { "; with a physical surface around it, it stays" } else { "" };
    notes.extend(note.map(|note| format!("{note}{way_out}")));
    Outlines::of_rings(rings, notes)
}

/// The segments of a file; sides begin where another line does, if `by_line`.
pub(super) fn links(file: &Polylines, by_line: bool) -> Vec<Link> {
    let mut links = Vec::with_capacity(file.segments.len());
    for (index, line) in (0..).zip(&file.lines) {
        let side = (!line.name.trim().is_empty()).then(|| Shared::from(&*line.name));
        let segments = line.segments.start as usize..line.segments.end as usize;
        links.extend(file.segments[segments].iter().map(|&ends| {
            let part_of = if by_line { index } else { 0 };
            Link { ends, curve: PieceCurve::Line, side: side.clone(), part_of }
        }));
    }
    links
}

/// The polygons that are surfaces of a file; its other lines and points lie inside them.
fn surfaces(file: &Polylines) -> Result<Outlines, OutlineError> {
    let mut lines = HashMap::new();
    for (index, line) in file.lines.iter().enumerate() {
        let name = (!line.name.trim().is_empty()).then(|| Shared::<str>::from(&*line.name));
        let own = line.segments.start as usize..line.segments.end as usize;
        lines.extend(
            file.segments[own].iter().map(|&edge| (sorted(edge), (index as u64, name.clone()))),
        );
    }
    let around = file.surfaces.iter().flat_map(|surface| &surface.edges);
    let ends = file.segments.iter().chain(around).flatten();
    let points = file.points.iter().map(|point| &point.vertex);
    let heights = ends.chain(points).map(|&end| file.positions[end as usize].z);
    let mut outlines =
        Outlines { notes: height(heights)?.into_iter().collect(), ..Outlines::default() };
    let points: Vec<_> = file.positions.iter().map(|point| point.truncate()).collect();
    let mut is_bound = HashSet::new();
    for (surface, index) in file.surfaces.iter().zip(1..) {
        let link = |&ends: &[u32; 2]| {
            let (part_of, side) = lines.get(&sorted(ends)).cloned().unwrap_or((u64::MAX, None));
            Link { ends, curve: PieceCurve::Line, side, part_of }
        };
        let links: Vec<Link> = surface.edges.iter().map(link).collect();
        let of_surface = |error: OutlineError| {
            let name = if surface.name.is_empty() { "without a name" } else { &*surface.name };
            let place = format!("surface {index} ({name}): {}", error.place);
            OutlineError { place, ..error }
        };
        let (rings, note) = loops::rings(&points, &links).map_err(of_surface)?;
        outlines.notes.extend(note);
        let name = Some(&*surface.name).filter(|name| !name.is_empty());
        outlines.add(rings, FillRule::EvenOdd, name)?;
        is_bound.extend(surface.edges.iter().map(|&edge| sorted(edge)));
    }
    let mut on_lines = HashSet::new();
    for line in &file.lines {
        let side = lines.get(&sorted(file.segments[line.segments.start as usize]));
        for segment in line.segments.clone() {
            let ends = file.segments[segment as usize];
            on_lines.extend(ends);
            if !is_bound.contains(&sorted(ends)) {
                let [start, end] = ends.map(|end| points[end as usize]);
                outlines.inside.lines.push(Border {
                    segment: Segment { start, end, curve: PieceCurve::Line },
                    side: side.and_then(|(_, name)| name.clone()),
                    begins_side: segment == line.segments.start,
                    beside: [None; 2],
                });
            }
        }
    }
    on_lines.extend(is_bound.into_iter().flatten());
    for NamedVertex { name, vertex } in &file.points {
        let name = Some(clean(name)).filter(|name| !name.is_empty());
        if name.is_some() || !on_lines.contains(vertex) {
            let at = points[*vertex as usize];
            outlines.inside.points.push(InnerPoint { at, name, size: None });
        }
    }
    Ok(outlines)
}

/// A note if all z are one number other than 0.
fn height(mut z: impl Iterator<Item = f64>) -> Result<Option<String>, OutlineError> {
    let Some(first) = z.next() else { return Ok(None) };
    if let Some(other) = z.find(|&other| other != first) {
        return Err(OutlineError::place(
            "",
            format!(
                "the points do not lie in a plane of equal z: found z = {first:?} and z = \
                 {other:?}; turn the outline into the plane z = 0"
            ),
        ));
    }
    Ok((first != 0.0).then(|| format!("left out the height z = {first:?} of all points")))
}

#[cfg(test)]
mod tests;
