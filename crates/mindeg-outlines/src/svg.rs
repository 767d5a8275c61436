//! SVG: the closed shapes of a drawing, with their curves.
//!
//! `path`, `rect`, `circle`, `ellipse`, `polygon` and `polyline`, with the transforms of the
//! elements around them. Each element is filled by its own `fill-rule`, so one path may be several
//! polygons with holes; its `id` is their name. Coordinates are user units, with y turned up.
//!
//! Nested drawings are fitted into their boxes, clips cut, and the first child of a `switch` that a viewer
//! in English shows is taken.
//!
//! Limits: style sheets are not read, only attributes and `style`, and one that moves or hides shapes is refused; `use`, `text`, images and masked
//! elements are left out, and so is what viewers do not show.

mod arc;
mod clip;
mod path;
mod shapes;
mod style;
mod transform;

use std::collections::BTreeMap;
use std::rc::Rc;

use glam::{DAffine2, DVec2};
use roxmltree::{Document, Node, ParsingOptions};
use svgtypes::{ViewBox, ViewBoxError};

use self::clip::Clip;
use self::path::Subpath;
use self::style::Style;
use super::outline::FillRule;
use super::outline::{DrawnRing, Outlines};
use super::text::{at_line, counted, counted_all, quoted, text_of};
use crate::error::OutlineError;

/// Reads the shapes of an SVG document.
///
/// # Errors
///
/// Malformed XML and malformed attributes, each with the line; a document
/// without a closed shape.
pub(super) fn read(bytes: &[u8]) -> Result<Outlines, OutlineError> {
    let text = text_of(bytes)?;
    // A document type is harmless; entities may make a small file large.
    if text.contains("<!ENTITY") {
        return Err(OutlineError::place(
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
        by_id: document.descendants().filter_map(|it| Some((it.attribute("id")?, it))).collect(),
        outlines: Outlines::default(),
        left_out: BTreeMap::new(),
        gaps: 0,
        cuts: 0,
    };
    reader.style_sheets()?;
    reader.tree(root)?;
    reader.end()
}

struct Reader<'a, 'input> {
    document: &'a Document<'input>,
    by_id: BTreeMap<&'a str, Node<'a, 'input>>,
    outlines: Outlines,
    left_out: BTreeMap<&'static str, usize>,
    /// How many small gaps were closed.
    gaps: usize,
    /// How many shapes were cut by clips.
    cuts: usize,
}

impl<'a, 'input> Reader<'a, 'input> {
    /// Leaves out style sheets, which may stand anywhere.
    fn style_sheets(&mut self) -> Result<(), OutlineError> {
        for node in self.document.descendants().filter(|it| it.tag_name().name() == "style") {
            if let Some(property) = node.text().and_then(style::decisive) {
                let property = quoted(&property);
                return Err(self.error(
                    node,
                    format!(
                        "the style sheet sets {property}, which moves, shapes or hides elements, and style \
                         sheets are not read; write it into each element, such as with svgo's inlineStyles"
                    ),
                ));
            }
            self.leave_out("style sheet");
        }
        Ok(())
    }

    /// Reads an element and all below it, in the order of the document.
    fn tree(&mut self, root: Node<'a, 'input>) -> Result<(), OutlineError> {
        // y points down in SVG.
        let upright = Style::new(DAffine2::from_cols_array(&[1.0, 0.0, 0.0, -1.0, 0.0, 0.0]));
        let mut open = vec![(root, upright)];
        while let Some((node, outer)) = open.pop() {
            let name = node.tag_name().name();
            if drawn(node).is_none() {
                // Definitions, which draw nothing where they stand, and what is not SVG.
                continue;
            }
            if !applies(node) {
                self.leave_out("element for other programs or languages");
                continue;
            }
            if let Some((_, Some(what))) = drawn(node) {
                self.leave_out(what);
                continue;
            }
            let mut style =
                outer.inherited_by(node).map_err(|problem| self.error(node, problem))?;
            if style.own.is_hidden {
                self.leave_out("hidden element");
                continue;
            }
            if style.own.is_masked {
                self.leave_out("masked element");
                continue;
            }
            if let Some(id) = style.clip_path() {
                let clip = id.and_then(|id| self.clip(id, &style));
                style.clips.extend(clip.map_err(|problem| self.error(node, problem))?);
            }
            if name == "svg" {
                let size = drawing(node, &mut style, node == root);
                if !size.map_err(|problem| self.error(node, problem))? {
                    self.leave_out("hidden element");
                    continue;
                }
            }
            let subpaths = shapes::subpaths(node).map_err(|problem| self.error(node, problem))?;
            match subpaths {
                Some(subpaths) if subpaths.is_empty() => self.leave_out("shape without extent"),
                Some(subpaths) => self.shape(node, &style, subpaths)?,
                None => {
                    let children = node.children().filter(Node::is_element);
                    let children: Vec<_> = if name == "switch" {
                        children.filter(|&it| drawn(it).is_some() && applies(it)).take(1).collect()
                    } else {
                        children.collect()
                    };
                    open.extend(children.into_iter().rev().map(|it| (it, style.clone())));
                }
            }
        }
        Ok(())
    }

    /// The region of a `clipPath` for an element; `None` if no element has its id.
    fn clip(&self, id: &str, style: &Style) -> Result<Option<Rc<Clip>>, String> {
        let Some(&node) = self.by_id.get(id).filter(|it| it.tag_name().name() == "clipPath") else {
            return Ok(None);
        };
        let unread =
            |what: &str| Err(format!("the clipPath {} {what}; cut the shape with it", quoted(id)));
        if node.attribute("clipPathUnits").is_some_and(|units| units != "userSpaceOnUse") {
            return unread("has units of the shape's box");
        }
        let outer = Style::new(style.transform).inherited_by(node)?;
        let mut shapes = Vec::new();
        for child in node.children().filter(Node::is_element).filter(|&it| drawn(it).is_some()) {
            let mut style = outer.inherited_by(child)?;
            if style.own.is_hidden || style.is_invisible || !applies(child) {
                continue;
            }
            let child = match self.used(child) {
                Some(used) => {
                    let place = ["x", "y"].map(|name| shapes::length(child, name, None));
                    let [x, y] = place.map(|it| it.map(Option::unwrap_or_default));
                    style.transform *= DAffine2::from_translation(DVec2::new(x?, y?));
                    style = style.inherited_by(used)?;
                    used
                }
                None => child,
            };
            let Some(subpaths) = shapes::subpaths(child)? else {
                return unread("holds more than shapes");
            };
            if [&outer, &style].iter().any(|it| it.own.clip_path.is_some() || it.own.is_masked) {
                return unread("is cut itself");
            }
            let rings = subpaths.iter().map(|subpath| subpath.ring(&style.transform));
            shapes.push((rings.collect(), style.clip_rule));
        }
        Ok(Some(Rc::new(Clip(shapes))))
    }

    /// The element that a `use` shows.
    fn used(&self, node: Node<'_, '_>) -> Option<Node<'a, 'input>> {
        let of_xlink = node.attribute(("http://www.w3.org/1999/xlink", "href"));
        let href =
            node.attribute("href").or(of_xlink).filter(|_| node.tag_name().name() == "use")?;
        self.by_id.get(href.trim().strip_prefix('#')?).copied()
    }

    fn shape(
        &mut self,
        node: Node<'_, '_>,
        style: &Style,
        subpaths: Vec<Subpath>,
    ) -> Result<(), OutlineError> {
        if style.is_invisible {
            self.leave_out("hidden element");
            return Ok(());
        }
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
            let is_finite =
                |ring: &DrawnRing| ring.flattened().iter().all(|point| point.is_finite());
            if !is_finite(&ring) {
                return Err(self.error(node, "a coordinate is too large for a 64-bit float"));
            }
            if ring.is_flat() {
                self.leave_out("line without area");
            } else {
                rings.push(ring);
            }
        }
        let mut rule = style.fill_rule;
        for clip in &style.clips {
            let left = clip.cut(&rings, rule).map_err(|problem| self.error(node, problem))?;
            if let Some(left) = left {
                (rings, rule) = (left, FillRule::EvenOdd);
                self.cuts += 1;
            }
        }
        let name = node.attribute("id").filter(|id| !id.trim().is_empty());
        let without_effect = self.outlines.add(rings, rule, name)?;
        if without_effect > 0 {
            *self.left_out.entry("ring inside a filled area").or_default() += without_effect;
        }
        Ok(())
    }

    fn leave_out(&mut self, what: &'static str) {
        *self.left_out.entry(what).or_default() += 1;
    }

    fn error(&self, node: Node<'_, '_>, problem: impl Into<String>) -> OutlineError {
        let line = self.document.text_pos_at(node.range().start).row;
        at_line(line.into(), format!("<{}>: {}", node.tag_name().name(), problem.into()))
    }

    fn end(mut self) -> Result<Outlines, OutlineError> {
        let left_out = counted_all(&self.left_out);
        if self.outlines.features.is_empty() {
            let only =
                if left_out.is_empty() { String::new() } else { format!(", only {left_out}") };
            return Err(OutlineError::place(
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
        if self.cuts > 0 {
            self.outlines.notes.push(format!("cut {} by clips", counted(self.cuts, "shape")));
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

/// The elements that draw something, and the name of those that are left out.
const DRAWN: [(&str, Option<&str>); 15] = [
    ("svg", None),
    ("g", None),
    ("a", None),
    ("switch", None),
    ("path", None),
    ("rect", None),
    ("circle", None),
    ("ellipse", None),
    ("polygon", None),
    ("polyline", None),
    ("use", Some("<use>")),
    ("text", Some("<text>")),
    ("line", Some("<line>")),
    ("image", Some("image")),
    ("foreignObject", Some("image")),
];

/// The row of an element that draws something.
fn drawn(node: Node<'_, '_>) -> Option<(&'static str, Option<&'static str>)> {
    DRAWN.into_iter().find(|(name, _)| *name == node.tag_name().name())
}

/// Whether viewers in English show an element.
fn applies(node: Node<'_, '_>) -> bool {
    let is_english = |tag: &str| tag.trim() == "en" || tag.trim().starts_with("en-");
    node.attribute("requiredExtensions").is_none_or(|names| names.trim().is_empty())
        && node.attribute("systemLanguage").is_none_or(|tags| tags.split(',').any(is_english))
}

/// Goes from the coordinates around a drawing to those in it. Tells whether it shows anything.
fn drawing(node: Node<'_, '_>, style: &mut Style, is_root: bool) -> Result<bool, String> {
    let view = node.attribute("viewBox").map(str::parse::<ViewBox>).transpose();
    let view = match view {
        // A drawing without extent shows nothing; the outermost one is read without its box.
        Err(ViewBoxError::InvalidSize) => return Ok(is_root),
        other => other.map_err(|error| error.to_string())?,
    };
    let whole = style.drawing;
    let of_view = view.map(|view| DVec2::new(view.w, view.h));
    if is_root {
        let length = |name| shapes::length(node, name, None).ok().flatten();
        let own = length("width").zip(length("height")).map(DVec2::from);
        style.drawing = of_view.or(own);
        return Ok(true);
    }
    let x = shapes::length(node, "x", whole.map(|it| it.x))?.unwrap_or(0.0);
    let y = shapes::length(node, "y", whole.map(|it| it.y))?.unwrap_or(0.0);
    style.transform *= DAffine2::from_translation(DVec2::new(x, y));
    // Without a length it is as large as the drawing around it.
    let width = shapes::length(node, "width", whole.map(|it| it.x))?.or(whole.map(|it| it.x));
    let height = shapes::length(node, "height", whole.map(|it| it.y))?.or(whole.map(|it| it.y));
    let size = width.zip(height).map(DVec2::from);
    style.drawing = of_view.or(size);
    let Some(size) = size else {
        let problem = "a drawing inside needs width and height, or a viewBox around it";
        return if view.is_some() { Err(problem.to_owned()) } else { Ok(true) };
    };
    if size.min_element() <= 0.0 {
        return Ok(false);
    }
    if !style.own.overflows {
        let corners = [DVec2::ZERO, DVec2::new(size.x, 0.0), size, DVec2::new(0.0, size.y)];
        let corners = corners.map(|corner| style.transform.transform_point2(corner));
        let ring = DrawnRing::of_points(corners);
        style.clips.push(Rc::new(Clip(vec![(vec![ring], FillRule::NonZero)])));
    }
    if let Some(view) = view {
        let ratio = node.attribute("preserveAspectRatio").unwrap_or("xMidYMid");
        let ratio = ratio.parse().map_err(|error| format!("preserveAspectRatio: {error}"))?;
        style.transform *= transform::fitted(view, ratio, size);
    }
    Ok(true)
}

#[cfg(test)]
mod tests;
