//! What an element inherits: where it lies, and how it is painted.

use glam::{DAffine2, DVec2};
use roxmltree::Node;
use svgtypes::{TransformListParser, TransformListToken};

use super::super::nesting::FillRule;

/// The properties of an element that matter for its outline.
#[derive(Clone, Copy, Debug)]
pub(super) struct Style {
    /// From the element's coordinates to those of the outlines.
    pub(super) transform: DAffine2,
    pub(super) fill_rule: FillRule,
    pub(super) is_filled: bool,
    pub(super) is_stroked: bool,
    /// Whether nothing of it is shown.
    pub(super) is_hidden: bool,
}

impl Style {
    pub(super) fn new(transform: DAffine2) -> Self {
        Self {
            transform,
            fill_rule: FillRule::NonZero,
            is_filled: true,
            is_stroked: false,
            is_hidden: false,
        }
    }

    /// The style of an element inside one that has this style.
    pub(super) fn inherited_by(mut self, node: Node<'_, '_>) -> Result<Self, String> {
        if let Some(text) = node.attribute("transform") {
            self.transform *= transform(text)?;
        }
        for name in ["fill", "stroke", "fill-rule", "display", "visibility"] {
            if let Some(value) = node.attribute(name) {
                self.set(name, value);
            }
        }
        // Declarations of `style` outrank the attributes.
        for declaration in node.attribute("style").unwrap_or_default().split(';') {
            if let Some((name, value)) = declaration.split_once(':') {
                self.set(name.trim(), value);
            }
        }
        Ok(self)
    }

    fn set(&mut self, name: &str, value: &str) {
        let value = value.trim();
        let is_painted = !matches!(value, "none" | "transparent");
        match (name, value) {
            (_, "inherit") => {}
            ("fill", _) => self.is_filled = is_painted,
            ("stroke", _) => self.is_stroked = is_painted,
            ("fill-rule", "evenodd") => self.fill_rule = FillRule::EvenOdd,
            ("fill-rule", _) => self.fill_rule = FillRule::NonZero,
            ("display", "none") | ("visibility", "hidden" | "collapse") => self.is_hidden = true,
            _ => {}
        }
    }
}

/// The product of a list of transforms.
fn transform(text: &str) -> Result<DAffine2, String> {
    let mut product = DAffine2::IDENTITY;
    for token in TransformListParser::from(text) {
        let token = token.map_err(|error| format!("transform: {error}"))?;
        product *= match token {
            TransformListToken::Matrix { a, b, c, d, e, f } => {
                DAffine2::from_cols_array(&[a, b, c, d, e, f])
            }
            TransformListToken::Translate { tx, ty } => {
                DAffine2::from_translation(DVec2::new(tx, ty))
            }
            TransformListToken::Scale { sx, sy } => DAffine2::from_scale(DVec2::new(sx, sy)),
            TransformListToken::Rotate { angle } => rotation(angle),
            TransformListToken::SkewX { angle } => {
                DAffine2::from_cols_array(&[1.0, 0.0, libm::tan(angle.to_radians()), 1.0, 0.0, 0.0])
            }
            TransformListToken::SkewY { angle } => {
                DAffine2::from_cols_array(&[1.0, libm::tan(angle.to_radians()), 0.0, 1.0, 0.0, 0.0])
            }
        };
    }
    Ok(product)
}

/// A rotation by degrees, exact for right angles.
fn rotation(degrees: f64) -> DAffine2 {
    let turned = degrees.rem_euclid(360.0);
    let (sin, cos) = if turned == 0.0 {
        (0.0, 1.0)
    } else if turned == 90.0 {
        (1.0, 0.0)
    } else if turned == 180.0 {
        (0.0, -1.0)
    } else if turned == 270.0 {
        (-1.0, 0.0)
    } else {
        libm::sincos(degrees.to_radians())
    };
    DAffine2::from_cols_array(&[cos, sin, -sin, cos, 0.0, 0.0])
}
