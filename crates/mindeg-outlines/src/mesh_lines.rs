//! The lines of files that hold meshes: OBJ and Gmsh's MSH, by the readers of meshes.
//!
//! The closed loops of the lines are rings, with their points bit for bit; loops inside others are holes.
//! In an MSH a curve of the geometry is a side, and the name of its physical group the side's name. In an
//! OBJ, objects and groups (`o`, `g`) name the sides of a ring that consists of several of them, or the
//! polygon if it lies in one; an OBJ with faces is a mesh, but an MSH may have both.

use std::sync::Arc as Shared;

use mindeg_formats::{Polylines, msh, obj};

use super::curve::PieceCurve;
use super::loops::{self, Link};
use super::outline::Outlines;
use super::text::counted;
use crate::error::OutlineError;

/// Reads the line elements of an MSH, in text or binary.
///
/// # Errors
///
/// Malformed input; a file without lines, or with lines that close no ring or do not lie in
/// a plane of equal z.
pub(super) fn read_msh(bytes: &[u8]) -> Result<Outlines, OutlineError> {
    let file = msh::read_lines(bytes)?;
    let others = counted(file.others as usize, "other element");
    if file.segments.is_empty() {
        let problem = format!(
            "the file has no line elements, only {others}; mesh the curves with gmsh -1, and save all \
             elements (Mesh.SaveAll = 1) or a physical group of the curves"
        );
        return Err(OutlineError::place("$Elements", problem));
    }
    let has_others = file.others > 0;
    let mut outlines = outlines(file, true)?;
    outlines.notes.extend(has_others.then(|| format!("left out {others}")));
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
        let problem = "the file has faces, so it is a mesh; mindeg view, inspect and convert take \
                       meshes; keep only its v and l lines to mesh the outline";
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
    let mut links = Vec::with_capacity(file.segments.len());
    for (index, line) in (0..).zip(&file.lines) {
        let side = (!line.name.trim().is_empty()).then(|| Shared::from(&*line.name));
        let segments = line.segments.start as usize..line.segments.end as usize;
        links.extend(file.segments[segments].iter().map(|&ends| {
            let part_of = if by_line { index } else { 0 };
            Link { ends, curve: PieceCurve::Line, side: side.clone(), part_of }
        }));
    }
    let heights = file.segments.as_flattened().iter().map(|&end| file.positions[end as usize].z);
    let mut notes: Vec<String> = height(heights)?.into_iter().collect();
    let points: Vec<_> = file.positions.iter().map(|point| point.truncate()).collect();
    let (rings, note) = loops::rings(&points, &links)?;
    notes.extend(note);
    Outlines::of_rings(rings, notes)
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
