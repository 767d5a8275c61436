//! DXF as text: the closed outlines that lines, polylines, arcs and circles form.
//!
//! `LINE`, `LWPOLYLINE` and `POLYLINE` with bulges, `ARC` and `CIRCLE` of the section `ENTITIES`.
//! Lines that meet within a millionth of the drawing's size form rings; arcs stay
//! arcs. Rings inside others are holes. If a ring's lines lie in several layers, these name its
//! sides; if all of a polygon's lie in one, that is its name.
//!
//! Limits: no blocks, splines or ellipses, which are left out and counted; no binary files.

mod entities;
mod joining;
mod pairs;

use std::collections::BTreeMap;

use super::nesting::{FillRule, polygons};
use super::outline::Outlines;
use super::text::{at_line, counted};
use crate::error::ReadError;
use entities::Entity;
use pairs::{Pair, pairs};

/// Names of the units by the values of `$INSUNITS`.
const UNITS: [&str; 7] =
    ["no unit", "inches", "feet", "miles", "millimeters", "centimeters", "meters"];

/// Reads the entities of a DXF.
///
/// # Errors
///
/// Binary files; what is not as the format has it, with its line; a drawing without a closed
/// outline.
pub(super) fn read(bytes: &[u8]) -> Result<Outlines, ReadError> {
    if bytes.starts_with(b"AutoCAD Binary DXF") {
        return Err(at_line(1, "this is a binary DXF; save it as ASCII DXF"));
    }
    // Old files have names in the encodings of their countries; numbers are plain anyway.
    let text = String::from_utf8_lossy(bytes);
    let drawing = drawing(&text)?;
    let mut notes = Vec::new();
    if let Some(unit) = drawing.units.and_then(|unit| UNITS.get(unit).copied()) {
        notes.push(format!("the drawing's unit ($INSUNITS) is {unit}; coordinates are kept"));
    }
    let (rings, note) = joining::rings(drawing.entities)?;
    notes.extend(note);
    let left_out: Vec<String> =
        drawing.left_out.iter().map(|(name, &count)| counted(count, name)).collect();
    let left_out = left_out.join(", ");
    if rings.is_empty() {
        let only = if left_out.is_empty() { String::new() } else { format!(", only {left_out}") };
        return Err(ReadError::place(
            "the section ENTITIES",
            format!(
                "no closed outline{only}; explode blocks, and convert splines to polylines or arcs"
            ),
        ));
    }
    if !left_out.is_empty() {
        notes.push(format!("left out {left_out}"));
    }
    let (mut features, _) = polygons(rings, FillRule::EvenOdd, None)?;
    features.iter_mut().for_each(|feature| feature.name_by_side());
    Ok(Outlines { features, notes })
}

/// What the sections of a file hold.
#[derive(Default)]
struct Drawing {
    entities: Vec<Entity>,
    left_out: BTreeMap<String, usize>,
    units: Option<usize>,
}

fn drawing(text: &str) -> Result<Drawing, ReadError> {
    let mut drawing = Drawing::default();
    let mut section = "";
    let mut wants_section = false;
    let mut wants_units = false;
    let mut open: Option<(&str, Vec<Pair<'_>>)> = None;
    for pair in pairs(text) {
        let pair = pair?;
        if pair.code == 0 {
            if let Some((name, pairs)) = open.take() {
                drawing.take(name, &pairs)?;
            }
            match pair.value {
                "SECTION" => wants_section = true,
                "ENDSEC" => section = "",
                "EOF" => return Ok(drawing),
                name if section == "ENTITIES" => open = Some((name, vec![pair])),
                _ => {}
            }
        } else if wants_section && pair.code == 2 {
            (section, wants_section) = (pair.value, false);
        } else if let Some((_, pairs)) = &mut open {
            pairs.push(pair);
        } else if section == "HEADER" && pair.code == 9 {
            wants_units = pair.value == "$INSUNITS";
        } else if wants_units && pair.code == 70 {
            drawing.units = pair.value.parse().ok();
        }
    }
    // A file that ends early: what it holds is taken.
    if let Some((name, pairs)) = open {
        drawing.take(name, &pairs)?;
    }
    Ok(drawing)
}

impl Drawing {
    /// Takes an entity, if it is of a kind that is read.
    fn take(&mut self, name: &str, pairs: &[Pair<'_>]) -> Result<(), ReadError> {
        match name {
            // The parts of a POLYLINE follow it as entities of their own.
            "VERTEX" => {
                if let Some(polyline) = self.entities.last_mut().filter(|last| last.is_open) {
                    polyline.add(pairs)?;
                }
            }
            "SEQEND" => {
                self.entities.iter_mut().rev().take(1).for_each(|last| last.is_open = false)
            }
            _ => match Entity::read(name, pairs)? {
                Some(entity) => self.entities.push(entity),
                None => {
                    // Some files have names of any length here.
                    let name = name.chars().take(20).collect();
                    *self.left_out.entry(name).or_default() += 1;
                }
            },
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests;
