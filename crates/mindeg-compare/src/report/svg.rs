//! The common parts of this crate's SVG pictures: colors, coordinates, and small meshes.
//!
//! Pictures come from templates, which escape what they are given. A picture inside a page takes its
//! colors from the page; one that stands alone brings them along, since not every viewer knows CSS
//! variables.

mod curve;

pub(super) use curve::{Curve, Marks};

use glam::DVec2;
use mindeg::exact::TradeOff;
use mindeg::{Bounds, Mesh};
use mindeg_formats::svg::Inset;
use mindeg_formats::{WriteError, degree_color};
use mindeg_mesh::{TriMesh, Triangles};
use serde::Serialize;
use std::io;

/// The looks of a [`Curve`].
pub(super) const CURVE_STYLE: &str = include_str!("svg/curve.css");

/// The colors of pages and pictures by name, on a light and on a dark background.
#[rustfmt::skip]
const PALETTE: [(&str, &str, &str); 15] = [
    ("page", "#f6f8fa", "#0d1117"),
    ("card", "#ffffff", "#151b23"),
    ("text", "#1f2328", "#f0f6fc"),
    ("muted", "#59636e", "#9aa5b1"),
    ("line", "#d1d9e0", "#3d444d"),
    ("accent", "#0a63c9", "#6cb0ff"),
    ("warning", "#9a3412", "#fdba74"),
    ("edge", "#27313d", "#d5dfea"),
    ("outline", "#2b3440", "#c3ccd8"),
    ("ring", "#ffffff", "#f0f6fc"),
    ("good", "#f2f6fa", "#18212c"),
    ("middling", "#9cc3e0", "#28567a"),
    ("bad", "#4a90cc", "#397cb0"),
    ("mark", "#c2410c", "#ff9d5c"),
    ("grid", "#e4e9ee", "#262c34"),
];

/// The style sheet of a page: the palette as CSS variables, then `sheets`. Paper is always light.
pub(super) fn page_style(sheets: &[&str]) -> String {
    let variables =
        |pick: fn(&(&str, &str, &str)) -> String| -> String { PALETTE.iter().map(pick).collect() };
    format!(
        ":root {{ {}}}\n@media screen and (prefers-color-scheme: dark) {{ :root:not(.printing) {{ \
         {}}} }}\n{}",
        variables(|(name, light, _)| format!("--{name}: {light}; ")),
        variables(|(name, _, dark)| format!("--{name}: {dark}; ")),
        sheets.concat()
    )
}

/// The style sheet of a picture that stands alone: `sheet` with the palette put in.
pub(super) fn standalone_style(sheet: &str) -> String {
    let (mut light, mut dark) = (sheet.to_owned(), sheet.to_owned());
    for (name, on_light, on_dark) in PALETTE {
        let variable = format!("var(--{name})");
        light = light.replace(&variable, on_light);
        dark = dark.replace(&variable, on_dark);
    }
    format!("{light}@media (prefers-color-scheme: dark) {{\n{dark}}}\n")
}

/// A length or coordinate, to a tenth of a pixel.
pub(super) fn pixel(length: f64) -> f64 {
    (length * 10.0).round() / 10.0
}

/// The color of some degrees in meshes, and what a legend calls them.
#[derive(Serialize)]
pub(super) struct DegreeColor {
    /// The lowest of the degrees; the next entry of a scale has the first that is not among them.
    pub(super) from: u32,
    pub(super) color: String,
    pub(super) name: String,
}

/// The colors of the vertices' degrees in the meshes, from the lowest; also of those with points `inside`, if such a mesh is
/// shown.
pub(super) fn degree_legend(trade_off: &TradeOff, inside: Option<&TriMesh>) -> Vec<DegreeColor> {
    let meshes = trade_off.meshes().iter().map(|exact| exact.mesh.max_degree());
    let top = meshes.chain(inside.map(TriMesh::max_degree)).fold(0, u32::max);
    let degrees = degree_color::DISTINCT.filter(|&degree| degree <= top);
    let entry = |degree| {
        let stands_for_more = degree == *degree_color::DISTINCT.end() && degree < top;
        let more = if stands_for_more { "+" } else { "" };
        DegreeColor { from: degree, color: hex(degree), name: format!("{degree}{more}") }
    };
    degrees.map(entry).collect()
}

/// The highest degrees, in ranges that double, as a report colors them: matplotlib's *viridis* (CC0)
/// from yellow, where the colors of low degrees end, to blue.
const HIGH_DEGREES: [(u32, &str); 6] = [
    (9, "#b5de2b"),
    (17, "#6ece58"),
    (33, "#35b779"),
    (65, "#1f9e89"),
    (129, "#26828e"),
    (257, "#31688e"),
];

/// The colors of all degrees, from the lowest. Up to 8 they are those of mesh files.
pub(super) fn degree_scale() -> Vec<DegreeColor> {
    let low = degree_color::DISTINCT.map(|degree| DegreeColor {
        from: degree,
        color: hex(degree),
        name: degree.to_string(),
    });
    let high = HIGH_DEGREES.iter().enumerate().map(|(place, &(from, color))| DegreeColor {
        from,
        color: color.to_owned(),
        name: match HIGH_DEGREES.get(place + 1) {
            Some((next, _)) => format!("{from} to {}", next - 1),
            None => format!("{from} or more"),
        },
    });
    low.chain(high).collect()
}

/// The color of a degree in mesh files, in CSS syntax.
fn hex(degree: u32) -> String {
    let [red, green, blue] = degree_color::srgb(degree);
    format!("#{red:02x}{green:02x}{blue:02x}")
}

/// A mesh drawn into some space of a picture, as SVG elements.
pub(super) fn mesh(mesh: &dyn Mesh, bounds: Bounds, space: Bounds) -> io::Result<String> {
    let mut drawing = Vec::new();
    match Inset::new(bounds, space).write(mesh, &mut drawing) {
        Ok(()) => String::from_utf8(drawing).map_err(io::Error::other),
        Err(WriteError::Io(error)) => Err(error),
        Err(other) => Err(io::Error::other(other)),
    }
}

/// A box of some size at the origin.
pub(super) fn space(size: DVec2) -> Bounds {
    Bounds { min: DVec2::ZERO, max: size }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_that_stands_alone_has_no_variables() {
        let style = standalone_style(CURVE_STYLE);
        assert!(!style.contains("var("), "{style}");
        assert!(style.contains("fill: #0a63c9") && style.contains("fill: #6cb0ff"));
    }

    #[test]
    fn degrees_far_apart_differ_in_color() {
        let scale = degree_scale();
        assert!(scale.is_sorted_by(|a, b| a.from < b.from));
        let color = |degree| &scale[scale.partition_point(|entry| entry.from <= degree) - 1].color;
        assert_ne!(color(114), color(203));
        assert_ne!(color(9), color(32));
        assert_eq!(color(2), "#0d0887");
    }

    #[test]
    fn edges_stand_out_on_every_triangle() {
        // WCAG's contrast ratio; 3 is its bound for graphics.
        let luminance = |hex: &str| {
            let channel = |at| {
                let value = u8::from_str_radix(&hex[at..at + 2], 16).unwrap();
                let value = f64::from(value) / 255.0;
                if value <= 0.040_45 {
                    value / 12.92
                } else {
                    libm::pow((value + 0.055) / 1.055, 2.4)
                }
            };
            0.2126 * channel(1) + 0.7152 * channel(3) + 0.0722 * channel(5)
        };
        let color = |wanted| PALETTE.iter().find(|(name, _, _)| *name == wanted).unwrap();
        let edge = color("edge");
        for triangle in ["good", "middling", "bad"].map(color) {
            for (one, other) in [(edge.1, triangle.1), (edge.2, triangle.2)] {
                let (one, other) = (luminance(one), luminance(other));
                let contrast = (one.max(other) + 0.05) / (one.min(other) + 0.05);
                assert!(contrast >= 3.0, "{}: {contrast}", triangle.0);
            }
        }
    }

    #[test]
    fn every_variable_of_a_page_has_a_color() {
        let sheet = include_str!("page.css");
        for use_of in sheet.split("var(--").skip(1) {
            let name = use_of.split(')').next().unwrap_or_default();
            assert!(PALETTE.iter().any(|(known, _, _)| *known == name), "{name}");
        }
    }
}
