//! An element's inherited and own properties: its position and its paint.

use std::rc::Rc;

use glam::{DAffine2, DVec2};
use roxmltree::Node;
use svgtypes::FuncIRI;

use super::super::outline::FillRule;
use super::super::text::quoted;
use super::clip::Clip;
use super::transform;

/// The properties of an element that matter for its outline.
#[derive(Clone, Debug)]
pub(super) struct Style {
    /// From the element's coordinates to those of the outlines.
    pub(super) transform: DAffine2,
    /// The size of the nearest drawing around it, in its units, if it has one.
    pub(super) drawing: Option<DVec2>,
    pub(super) fill_rule: FillRule,
    pub(super) clip_rule: FillRule,
    pub(super) is_filled: bool,
    pub(super) is_stroked: bool,
    /// Whether the element is invisible; its children need not be.
    pub(super) is_invisible: bool,
    /// The clips that cut the element, from the outermost on.
    pub(super) clips: Vec<Rc<Clip>>,
    pub(super) own: Own,
}

/// The properties that an element does not inherit.
#[derive(Clone, Debug, Default)]
pub(super) struct Own {
    /// Whether nothing of it is shown, nor of what is in it.
    pub(super) is_hidden: bool,
    pub(super) is_masked: bool,
    /// How its `clip-path` is written.
    pub(super) clip_path: Option<String>,
    /// Whether a drawing inside shows what lies outside it.
    pub(super) overflows: bool,
    transform: DAffine2,
    origin: Option<String>,
    /// A property that moves it and is not read.
    unread: Option<String>,
}

/// Properties that may be attributes.
const ATTRIBUTES: [&str; 14] = [
    "fill",
    "stroke",
    "fill-rule",
    "clip-rule",
    "display",
    "visibility",
    "opacity",
    "fill-opacity",
    "stroke-opacity",
    "clip-path",
    "mask",
    "overflow",
    "transform-origin",
    "transform-box",
];

impl Style {
    pub(super) fn new(transform: DAffine2) -> Self {
        Self {
            transform,
            drawing: None,
            fill_rule: FillRule::NonZero,
            clip_rule: FillRule::NonZero,
            is_filled: true,
            is_stroked: false,
            is_invisible: false,
            clips: Vec::new(),
            own: Own::default(),
        }
    }

    /// The style of an element inside one that has this style.
    pub(super) fn inherited_by(&self, node: Node<'_, '_>) -> Result<Self, String> {
        let mut style = Style { own: Own::default(), ..self.clone() };
        if let Some(text) = node.attribute("transform") {
            style.own.transform = transform::of_attribute(text)?;
        }
        for name in ATTRIBUTES {
            if let Some(value) = node.attribute(name) {
                style.set(name, value)?;
            }
        }
        // Declarations of `style` outrank the attributes.
        for (name, value) in declarations(node) {
            style.set(name, value)?;
        }
        if let Some(unread) = &style.own.unread {
            let attribute = if unread == "d" { "d" } else { "transform" };
            return Err(format!("{unread} is not read; write it as {attribute}=\"…\""));
        }
        let own = style.own.transform;
        let origin = match &style.own.origin {
            Some(text) if own != DAffine2::IDENTITY => transform::origin(text, style.drawing)?,
            _ => DVec2::ZERO,
        };
        style.transform *= DAffine2::from_translation(origin) * own;
        style.transform *= DAffine2::from_translation(-origin);
        Ok(style)
    }

    fn set(&mut self, name: &str, value: &str) -> Result<(), String> {
        let value = value.trim();
        let is_painted = !matches!(value, "none" | "transparent");
        let is_nothing = value.trim_end_matches('%').parse() == Ok(0.0);
        let rule = if value == "evenodd" { FillRule::EvenOdd } else { FillRule::NonZero };
        let own = &mut self.own;
        match (name, value) {
            (_, "inherit") => {}
            ("fill", _) => self.is_filled = is_painted,
            ("stroke", _) => self.is_stroked = is_painted,
            ("fill-opacity", _) => self.is_filled &= !is_nothing,
            ("stroke-opacity", _) => self.is_stroked &= !is_nothing,
            ("fill-rule", _) => self.fill_rule = rule,
            ("clip-rule", _) => self.clip_rule = rule,
            ("display", _) => own.is_hidden |= value == "none",
            ("opacity", _) => own.is_hidden |= is_nothing,
            ("visibility", _) => self.is_invisible = value != "visible",
            ("mask" | "mask-image", _) => own.is_masked = value != "none",
            ("clip-path", _) => own.clip_path = (value != "none").then(|| value.to_owned()),
            ("overflow", _) => own.overflows = matches!(value, "visible" | "auto"),
            ("transform", _) => own.transform = transform::of_style(value)?,
            ("transform-origin", _) => own.origin = Some(value.to_owned()),
            ("transform-box", "view-box") | ("translate" | "rotate" | "scale", "none") => {}
            ("transform-box" | "translate" | "rotate" | "scale" | "d", _) => {
                own.unread = Some(name.to_owned())
            }
            _ => {}
        }
        Ok(())
    }

    /// The id of the element that clips this one, if it names one.
    pub(super) fn clip_path(&self) -> Option<Result<&str, String>> {
        let text = self.own.clip_path.as_deref()?;
        let id = FuncIRI::from_str(text).map(|iri| iri.0);
        Some(id.map_err(|_| format!("clip-path={} is not read", quoted(text))))
    }
}

/// The declarations of an element's `style`.
pub(super) fn declarations<'a>(
    node: Node<'a, '_>,
) -> impl DoubleEndedIterator<Item = (&'a str, &'a str)> {
    let all = node.attribute("style").unwrap_or_default().split(';');
    all.filter_map(|declaration| declaration.split_once(':'))
        .map(|(name, value)| (name.trim(), value.trim().trim_end_matches("!important").trim()))
}

/// A property that a style sheet gives shapes and that changes where they are or whether they are shown.
pub(super) fn decisive(sheet: &str) -> Option<String> {
    let mut rest = sheet;
    let mut text = String::new();
    while let Some((before, comment)) = rest.split_once("/*") {
        text.push_str(before);
        rest = comment.split_once("*/").map_or("", |(_, after)| after);
    }
    text.push_str(rest);
    text.split(['{', '}', ';']).find_map(|declaration| {
        let (name, value) = declaration.split_once(':')?;
        let (name, value) = (name.trim(), value.trim().trim_end_matches("!important").trim());
        let is_decisive = match name {
            "display" => value == "none",
            "visibility" => value != "visible",
            "transform" | "translate" | "rotate" | "scale" | "clip-path" | "mask" => {
                value != "none"
            }
            "fill-rule" | "clip-rule" => value == "evenodd",
            "opacity" => value.trim_end_matches('%').parse() == Ok(0.0),
            "d" | "x" | "y" | "width" | "height" | "cx" | "cy" | "r" | "rx" | "ry" => true,
            _ => false,
        };
        is_decisive.then(|| format!("{name}: {value}"))
    })
}
