//! The basic shapes as subpaths.

use std::f64::consts::{FRAC_PI_2, TAU};

use glam::DVec2;
use roxmltree::Node;
use svgtypes::{Length, PointsParser};

use super::super::curve::{EllipseArc, PieceCurve};
use super::path::{Subpath, subpaths as of_path};
use super::style::declarations;
use super::transform::in_px;

/// The subpaths of a shape; `None` for an element that holds others.
pub(super) fn subpaths(node: Node<'_, '_>) -> Result<Option<Vec<Subpath>>, String> {
    let length = |name| length(node, name, None);
    let subpath = match node.tag_name().name() {
        "path" => return of_path(node.attribute("d").unwrap_or_default()).map(Some),
        "polygon" | "polyline" => {
            let parser = PointsParser::from(node.attribute("points").unwrap_or_default());
            let points: Vec<DVec2> = parser.map(|(x, y)| DVec2::new(x, y)).collect();
            let is_closed = node.tag_name().name() == "polygon" || points.first() == points.last();
            Subpath::polygon(&points).map(|polygon| Subpath { is_closed, ..polygon })
        }
        "circle" => {
            let radius = length("r")?.unwrap_or(0.0);
            ellipse(center(node)?, DVec2::splat(radius))
        }
        "ellipse" => {
            let (rx, ry) = (length("rx")?, length("ry")?);
            let radii = DVec2::new(rx.or(ry).unwrap_or(0.0), ry.or(rx).unwrap_or(0.0));
            ellipse(center(node)?, radii)
        }
        "rect" => {
            let corner = DVec2::new(length("x")?.unwrap_or(0.0), length("y")?.unwrap_or(0.0));
            let size =
                DVec2::new(length("width")?.unwrap_or(0.0), length("height")?.unwrap_or(0.0));
            let (rx, ry) = (length("rx")?, length("ry")?);
            let radii = DVec2::new(rx.or(ry).unwrap_or(0.0), ry.or(rx).unwrap_or(0.0));
            rectangle(corner, size, radii)
        }
        _ => return Ok(None),
    };
    Ok(Some(subpath.into_iter().collect()))
}

fn center(node: Node<'_, '_>) -> Result<DVec2, String> {
    let length = |name| length(node, name, None);
    Ok(DVec2::new(length("cx")?.unwrap_or(0.0), length("cy")?.unwrap_or(0.0)))
}

/// A length of an element, by `style` or an attribute, in user units; `whole` is what shares are shares of.
pub(super) fn length(
    node: Node<'_, '_>,
    name: &str,
    whole: Option<f64>,
) -> Result<Option<f64>, String> {
    // Viewers pass over lengths without a unit in a style.
    let is_bare = |text: &str| text.parse::<f64>().is_ok_and(|it| it != 0.0);
    let of_style = declarations(node).rev().find(|&(own, value)| own == name && !is_bare(value));
    let text = of_style.map(|(_, value)| value).or(node.attribute(name));
    let Some(text) = text.filter(|text| text.trim() != "auto") else { return Ok(None) };
    let length: Length = text.trim().parse().map_err(|error| format!("{name}: {error}"))?;
    let px = in_px(length, whole);
    px.ok_or_else(|| format!("{name}=\"{text}\" depends on something else; give a number"))
        .map(Some)
}

/// An ellipse from its point on the right.
fn ellipse(center: DVec2, radii: DVec2) -> Option<Subpath> {
    let axes = [DVec2::X * radii.x, DVec2::Y * radii.y];
    let start = center + axes[0];
    let arc = EllipseArc { center, axes, start: 0.0, sweep: TAU };
    let is_shape = radii.min_element() > 0.0;
    let curves = vec![(PieceCurve::Arc(arc), start)];
    is_shape.then_some(Subpath { curves, is_closed: true, ..Subpath::at(start) })
}

/// A rectangle with round corners, if they have a radius.
fn rectangle(corner: DVec2, size: DVec2, radii: DVec2) -> Option<Subpath> {
    if size.min_element() <= 0.0 {
        return None;
    }
    let far = corner + size;
    let radii = radii.max(DVec2::ZERO).min(size / 2.0);
    let corners = [corner, DVec2::new(far.x, corner.y), far, DVec2::new(corner.x, far.y)];
    if radii.min_element() == 0.0 {
        return Subpath::polygon(&corners);
    }
    let axes = [DVec2::X * radii.x, DVec2::Y * radii.y];
    // From the end of the first corner's arc on; each arc begins and ends on a side.
    let inward = [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]].map(DVec2::from);
    let mut subpath = Subpath::at(corner + axes[0]);
    for index in [1, 2, 3, 0] {
        let center = corners[index] + inward[index] * radii;
        let (on_x, on_y) = (axes[0] * -inward[index].x, axes[1] * -inward[index].y);
        let ends = if index % 2 == 1 { [on_y, on_x] } else { [on_x, on_y] };
        let start = FRAC_PI_2 * [2.0, 3.0, 0.0, 1.0][index];
        let arc = EllipseArc { center, axes, start, sweep: FRAC_PI_2 };
        subpath.curves.push((PieceCurve::Line, center + ends[0]));
        subpath.curves.push((PieceCurve::Arc(arc), center + ends[1]));
    }
    subpath.is_closed = true;
    Some(subpath)
}
