//! DXF as text: the closed outlines that lines, polylines, arcs and circles form.
//!
//! `LINE`, `LWPOLYLINE` and `POLYLINE` with bulges, `ARC` and `CIRCLE` of the section `ENTITIES`.
//! Lines that meet within a millionth of the drawing's size form rings; arcs stay
//! arcs. Rings inside others are holes. If a ring's lines lie in several layers, these name its
//! sides; if all of a polygon's lie in one, that is its name.
//!
//! By layers (`layers.rs`), each layer has polygons of its own, and open lines and points lie inside.
//!
//! Left out and counted: blocks, splines, ellipses, and all that a viewer hides (paper space, layers that
//! are off or frozen, invisible entities, the control points of splines).
//!
//! Limits: entities in planes other than the xy plane are refused; no binary files.

mod entities;
mod joining;
mod layers;
mod pairs;

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc as Shared;

use glam::DVec2;

use super::loops;
use super::outline::Outlines;
use super::selection::Selection;
use super::text::{at_line, clean, counted, quoted};
use crate::error::OutlineError;
use entities::{Entity, layer_of, point_at, text, whole};
use pairs::{Pair, pairs};

/// Names of the units by the values of `$INSUNITS`.
const UNITS: [&str; 7] =
    ["no unit", "inches", "feet", "miles", "millimeters", "centimeters", "meters"];

/// Reads the entities of a DXF, or those of one layer.
///
/// # Errors
///
/// Binary files; malformed input, with its line; a drawing without a closed
/// outline, or without the layer.
pub(super) fn read(bytes: &[u8], selection: &Selection) -> Result<Outlines, OutlineError> {
    let by_layer = match selection.name_by.as_deref() {
        None => false,
        Some("layer") => true,
        Some(other) => {
            let problem =
                format!("a DXF has no property {}; its polygons are named by layer", quoted(other));
            return Err(OutlineError::place("", problem));
        }
    };
    if bytes.starts_with(b"AutoCAD Binary DXF") {
        return Err(at_line(1, "this is a binary DXF; save it as ASCII DXF"));
    }
    // Old files have names in the encodings of their countries; numbers are plain anyway.
    let text = String::from_utf8_lossy(bytes);
    let mut drawing = drawing(&text)?;
    if let Some(layer) = &selection.layer {
        drawing.take_layer(layer)?;
    }
    if !by_layer && !drawing.points.is_empty() {
        *drawing.left_out.entry(("", "POINT".to_owned())).or_default() += drawing.points.len();
    }
    let mut notes = Vec::new();
    if let Some(unit) = drawing.units.and_then(|unit| UNITS.get(unit).copied()) {
        notes.push(format!("the drawing's unit ($INSUNITS) is {unit}; coordinates are kept"));
    }
    let (points, links) = joining::links(&drawing.entities)?;
    let left_out: Vec<String> = (drawing.left_out.iter())
        .map(|((why, name), &count)| format!("{}{why}", counted(count, name)))
        .collect();
    let left_out = left_out.join(", ");
    if links.is_empty() {
        let only = if left_out.is_empty() { String::new() } else { format!(", only {left_out}") };
        return Err(OutlineError::place(
            "the section ENTITIES",
            format!(
                "no closed outline{only}; explode blocks, and convert splines to polylines or arcs"
            ),
        ));
    }
    let left_out = (!left_out.is_empty()).then(|| format!("left out {left_out}"));
    if by_layer {
        notes.extend(left_out);
        return layers::outlines(&points, links, drawing.points, notes);
    }
    let (rings, open) = loops::rings(&points, &links)?;
    notes.extend(open.into_iter().chain(left_out));
    let mut outlines = Outlines::of_rings(rings, notes)?;
    outlines.features.iter_mut().for_each(|feature| feature.name_by_side());
    Ok(outlines)
}

/// The contents of a file's sections.
#[derive(Default)]
struct Drawing {
    entities: Vec<Entity>,
    /// Points, with their layers.
    points: Vec<(Option<Shared<str>>, DVec2)>,
    /// How many of a name were left out for a reason.
    left_out: BTreeMap<(&'static str, String), usize>,
    /// Layers that are off or frozen, in upper case: layer names ignore case.
    hidden_layers: BTreeSet<String>,
    units: Option<usize>,
}

fn drawing(text: &str) -> Result<Drawing, OutlineError> {
    let mut drawing = Drawing::default();
    let mut section = "";
    let mut wants_section = false;
    let mut wants_units = false;
    let mut open: Option<(&str, Vec<Pair<'_>>)> = None;
    for pair in pairs(text) {
        let pair = pair?;
        if pair.code == 0 {
            if let Some((name, pairs)) = open.take() {
                drawing.take(section, name, &pairs)?;
            }
            match pair.value {
                "SECTION" => wants_section = true,
                "ENDSEC" => section = "",
                "EOF" => return Ok(drawing),
                name if matches!(section, "TABLES" | "ENTITIES") => open = Some((name, vec![pair])),
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
        drawing.take(section, name, &pairs)?;
    }
    Ok(drawing)
}

impl Drawing {
    /// Takes an entity, if it is shown and of a kind that is read, or a layer.
    fn take(&mut self, section: &str, name: &str, pairs: &[Pair<'_>]) -> Result<(), OutlineError> {
        if section == "TABLES" {
            // A color below 0 turns a layer off, the first flag freezes it.
            if name == "LAYER" && (whole(pairs, 62) < 0 || whole(pairs, 70) & 1 != 0) {
                self.hidden_layers.insert(text(pairs, 2).to_uppercase());
            }
            return Ok(());
        }
        // The parts of a POLYLINE follow it as entities of their own.
        let polyline = self.entities.last_mut().filter(|last| last.is_open);
        if name == "VERTEX" {
            match polyline {
                // The control points of a spline, which viewers do not show.
                Some(_) if whole(pairs, 70) & 16 != 0 => self.leave_out("control point", ""),
                Some(polyline) => polyline.add(pairs)?,
                None => {}
            }
            return Ok(());
        }
        if let Some(polyline) = polyline {
            polyline.is_open = false;
        }
        if name == "SEQEND" {
            return Ok(());
        }
        let why = self.hidden(pairs);
        if name == "POINT" && why.is_empty() {
            self.points.push((layer_of(pairs), point_at(pairs)?));
            return Ok(());
        }
        match if why.is_empty() { Entity::read(name, pairs)? } else { None } {
            Some(entity) => self.entities.push(entity),
            None => self.leave_out(name, why),
        }
        Ok(())
    }

    /// Drops all that is not in a layer; names of layers ignore case.
    fn take_layer(&mut self, wanted: &str) -> Result<(), OutlineError> {
        let name = |layer: &Option<Shared<str>>| layer.as_deref().unwrap_or("0").to_owned();
        let layers = self.entities.iter().map(|entity| &entity.layer);
        let layers = layers.chain(self.points.iter().map(|point| &point.0));
        let layers: BTreeSet<String> = layers.map(name).collect();
        let is_wanted =
            |layer: &Option<Shared<str>>| name(layer).to_uppercase() == wanted.to_uppercase();
        self.entities.retain(|entity| is_wanted(&entity.layer));
        self.points.retain(|point| is_wanted(&point.0));
        if self.entities.is_empty() && self.points.is_empty() {
            let layers: Vec<String> = layers.iter().map(|layer| quoted(layer)).collect();
            let problem =
                format!("no layer is {}; the file has {}", quoted(wanted), layers.join(", "));
            return Err(OutlineError::place("", problem));
        }
        Ok(())
    }

    /// Why viewers do not show an entity; empty if they do.
    fn hidden(&self, pairs: &[Pair<'_>]) -> &'static str {
        if whole(pairs, 67) == 1 {
            " in paper space"
        } else if whole(pairs, 60) == 1 {
            " that cannot be seen"
        } else if self.hidden_layers.contains(&text(pairs, 8).to_uppercase()) {
            " on layers that are off or frozen"
        } else {
            ""
        }
    }

    fn leave_out(&mut self, name: &str, why: &'static str) {
        // Some files have names of any length here.
        let name = clean(name).chars().take(20).collect();
        *self.left_out.entry((why, name)).or_default() += 1;
    }
}

#[cfg(test)]
mod tests;
