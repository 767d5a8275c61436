//! SVG: the closed shapes of a drawing, with their curves.
//!
//! `path`, `rect`, `circle`, `ellipse`, `polygon` and `polyline`, with the transforms of the
//! elements around them. Each element is filled by its own `fill-rule`, so one path may be several
//! polygons with holes; its `id` is their name. Coordinates are user units, with y turned up.
//!
//! Limits: style sheets are not read, only attributes and `style`; `use`, `text` and images are
//! left out, and so are shapes with neither fill nor stroke.

mod arc;
mod path;
mod shapes;
mod style;

use std::collections::BTreeMap;

use glam::DAffine2;
use roxmltree::{Document, Node, ParsingOptions};

use self::path::Subpath;
use self::style::Style;
use super::outline::{Outlines, Ring};
use super::text::{at_line, counted, text_of};
use crate::error::ReadError;

/// Reads the shapes of an SVG document.
///
/// # Errors
///
/// Text that is no XML, attributes that are not as SVG has them, each with the line; a document
/// without a closed shape.
pub(super) fn read(bytes: &[u8]) -> Result<Outlines, ReadError> {
    let text = text_of(bytes)?;
    // A document type is harmless; entities may make a small file large.
    if text.contains("<!ENTITY") {
        return Err(ReadError::place(
            "the document type",
            "the file defines entities, which are not read; save it as plain SVG",
        ));
    }
    let options = ParsingOptions { allow_dtd: true, ..ParsingOptions::default() };
    let document = Document::parse_with_options(text, options).map_err(|error| {
        let place = format!(" at {}", error.pos());
        let problem = error.to_string().replacen(&place, "", 1);
        at_line(error.pos().row.into(), format!("column {}: {problem}", error.pos().col))
    })?;
    let root = document.root_element();
    if root.tag_name().name() != "svg" {
        let problem = format!("the root element is <{}>, expected <svg>", root.tag_name().name());
        return Err(at_line(1, problem));
    }
    let mut reader = Reader {
        document: &document,
        outlines: Outlines::default(),
        left_out: BTreeMap::new(),
        gaps: 0,
    };
    reader.tree(root)?;
    reader.end()
}

struct Reader<'a, 'input> {
    document: &'a Document<'input>,
    outlines: Outlines,
    left_out: BTreeMap<&'static str, usize>,
    /// How many small gaps were closed.
    gaps: usize,
}

impl Reader<'_, '_> {
    /// Reads an element and all below it, in the order of the document.
    fn tree(&mut self, root: Node<'_, '_>) -> Result<(), ReadError> {
        // y points down in SVG.
        let upright = Style::new(DAffine2::from_cols_array(&[1.0, 0.0, 0.0, -1.0, 0.0, 0.0]));
        let mut open = vec![(root, upright)];
        while let Some((node, outer)) = open.pop() {
            let name = node.tag_name().name();
            match name {
                "svg" | "g" | "a" | "switch" | "path" | "rect" | "circle" | "ellipse"
                | "polygon" | "polyline" => {}
                "use" | "text" | "image" | "foreignObject" | "line" | "style" => {
                    self.leave_out(match name {
                        "use" => "<use>",
                        "text" => "<text>",
                        "line" => "<line>",
                        "style" => "style sheet",
                        _ => "image",
                    });
                    continue;
                }
                // Definitions, which draw nothing where they stand, and what is not SVG.
                _ => continue,
            }
            let style = outer.inherited_by(node).map_err(|problem| self.error(node, problem))?;
            if style.is_hidden {
                self.leave_out("hidden element");
                continue;
            }
            let subpaths = shapes::subpaths(node).map_err(|problem| self.error(node, problem))?;
            match subpaths {
                Some(subpaths) => self.shape(node, &style, subpaths)?,
                None => {
                    let children: Vec<_> =
                        node.children().filter(Node::is_element).map(|it| (it, style)).collect();
                    open.extend(children.into_iter().rev());
                }
            }
        }
        Ok(())
    }

    fn shape(
        &mut self,
        node: Node<'_, '_>,
        style: &Style,
        subpaths: Vec<Subpath>,
    ) -> Result<(), ReadError> {
        if !style.is_filled && !style.is_stroked {
            self.leave_out("shape with neither fill nor stroke");
            return Ok(());
        }
        let mut rings = Vec::new();
        for subpath in subpaths {
            if !subpath.is_closed && !style.is_filled {
                self.leave_out("open line");
                continue;
            }
            self.gaps += usize::from(subpath.has_small_gap());
            let ring = subpath.ring(&style.transform);
            let is_finite = |ring: &Ring| ring.flattened().iter().all(|point| point.is_finite());
            if !is_finite(&ring) {
                return Err(self.error(node, "a coordinate is too large for a 64-bit float"));
            }
            if ring.doubled_area() == 0.0 {
                self.leave_out("line without area");
            } else {
                rings.push(ring);
            }
        }
        let name = node.attribute("id").filter(|id| !id.trim().is_empty());
        let without_effect = self.outlines.add(rings, style.fill_rule, name)?;
        if without_effect > 0 {
            *self.left_out.entry("ring inside a filled area").or_default() += without_effect;
        }
        Ok(())
    }

    fn leave_out(&mut self, what: &'static str) {
        *self.left_out.entry(what).or_default() += 1;
    }

    fn error(&self, node: Node<'_, '_>, problem: impl Into<String>) -> ReadError {
        let line = self.document.text_pos_at(node.range().start).row;
        at_line(line.into(), format!("<{}>: {}", node.tag_name().name(), problem.into()))
    }

    fn end(mut self) -> Result<Outlines, ReadError> {
        let left_out: Vec<String> =
            self.left_out.iter().map(|(what, &count)| counted(count, what)).collect();
        let left_out = left_out.join(", ");
        if self.outlines.features.is_empty() {
            let only =
                if left_out.is_empty() { String::new() } else { format!(", only {left_out}") };
            return Err(ReadError::place(
                "the whole drawing",
                format!(
                    "no closed shape{only}; convert text, <use> and strokes to paths, such as \
                     with Inkscape's Path > Object to Path"
                ),
            ));
        }
        if !left_out.is_empty() {
            self.outlines.notes.push(format!("left out {left_out}"));
        }
        if self.gaps > 0 {
            let gaps = counted(self.gaps, "gap");
            self.outlines.notes.push(format!(
                "closed {gaps} of less than 0.05% of the shape between the ends of closed paths"
            ));
        }
        Ok(self.outlines)
    }
}

#[cfg(test)]
mod tests;
