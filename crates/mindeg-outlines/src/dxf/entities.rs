//! The entities of a drawing as runs of lines and arcs.

use std::f64::consts::TAU;
use std::sync::Arc as Shared;

use glam::DVec2;

use super::super::curve::{EllipseArc, PieceCurve};
use super::super::text::{at_line, number, quoted};
use super::pairs::Pair;
use crate::error::OutlineError;

/// A run of the pen: points, and how each goes on to the next.
pub(super) struct Entity {
    pub(super) layer: Option<Shared<str>>,
    pub(super) points: Vec<DVec2>,
    /// For each point the tangent of a quarter of the angle of the arc to the next.
    bulges: Vec<f64>,
    pub(super) is_closed: bool,
    /// An arc or circle, from its only or first point.
    arc: Option<EllipseArc>,
    /// Whether vertices may follow as entities of their own.
    pub(super) is_open: bool,
}

impl Entity {
    /// An entity of a supported kind; `None` for others.
    pub(super) fn read(name: &str, pairs: &[Pair<'_>]) -> Result<Option<Self>, OutlineError> {
        let mut entity = Self {
            layer: layer_of(pairs),
            points: Vec::new(),
            bulges: Vec::new(),
            is_closed: false,
            arc: None,
            is_open: name == "POLYLINE",
        };
        let flags = whole(pairs, 70);
        match name {
            "LINE" => {
                entity.add_point(need(pairs, 10)?, need(pairs, 20)?);
                entity.add_point(need(pairs, 11)?, need(pairs, 21)?);
                return Ok(Some(entity));
            }
            "LWPOLYLINE" => {
                entity.is_closed = flags & 1 != 0;
                entity.add(pairs)?;
            }
            "POLYLINE" => {
                // Meshes and polylines in space have other flags.
                if flags & (8 | 16 | 64) != 0 {
                    return Ok(None);
                }
                entity.is_closed = flags & 1 != 0;
            }
            "CIRCLE" | "ARC" => {
                let center = DVec2::new(need(pairs, 10)?, need(pairs, 20)?);
                let radius = need(pairs, 40)?;
                let axes = [DVec2::X * radius, DVec2::Y * radius];
                let (start, sweep) = if name == "CIRCLE" {
                    (0.0, 0.0)
                } else {
                    let (start, end) = (need(pairs, 50)?, need(pairs, 51)?);
                    (start.to_radians(), (end - start).rem_euclid(360.0).to_radians())
                };
                // An arc from 0 to 360 degrees is a circle.
                entity.is_closed = sweep == 0.0;
                let sweep = if entity.is_closed { TAU } else { sweep };
                let arc = EllipseArc { center, axes, start, sweep };
                let ends = [start, start + sweep].map(|angle| arc.point(angle));
                entity.arc = Some(arc);
                entity.points = if entity.is_closed { vec![ends[0]] } else { ends.to_vec() };
            }
            _ => return Ok(None),
        }
        if faces_down(name, pairs)? {
            entity.mirror();
        }
        Ok(Some(entity))
    }

    /// Adds the vertices that pairs give.
    pub(super) fn add(&mut self, pairs: &[Pair<'_>]) -> Result<(), OutlineError> {
        for pair in pairs {
            match pair.code {
                10 => self.add_point(finite(pair)?, 0.0),
                20 => {
                    let y = finite(pair)?;
                    self.points.iter_mut().rev().take(1).for_each(|point| point.y = y);
                }
                42 => {
                    let bulge = finite(pair)?;
                    self.bulges.iter_mut().rev().take(1).for_each(|last| *last = bulge);
                }
                _ => {}
            }
        }
        Ok(())
    }

    fn add_point(&mut self, x: f64, y: f64) {
        self.points.push(DVec2::new(x, y));
        self.bulges.push(0.0);
    }

    fn mirror(&mut self) {
        self.points.iter_mut().for_each(|point| point.x = -point.x);
        self.bulges.iter_mut().for_each(|bulge| *bulge = -*bulge);
        if let Some(arc) = &mut self.arc {
            arc.center.x = -arc.center.x;
            arc.axes[0] = -arc.axes[0];
        }
    }

    /// How the point at an index goes on to the next.
    pub(super) fn curve(&self, index: usize) -> PieceCurve {
        match self.arc {
            Some(arc) => PieceCurve::Arc(arc),
            None => {
                let next = self.points[(index + 1) % self.points.len()];
                bulged(self.points[index], next, self.bulges[index])
            }
        }
    }
}

/// The arc between two points that turns by four times the arc tangent of the bulge, to the left
/// if it is positive.
fn bulged(start: DVec2, end: DVec2, bulge: f64) -> PieceCurve {
    if bulge == 0.0 || start == end {
        return PieceCurve::Line;
    }
    let sweep = 4.0 * libm::atan(bulge);
    let half = (end - start) / 2.0;
    // The center lies left of the chord if the arc turns left by less than half a circle.
    let center = start + half + half.perp() * ((1.0 - bulge * bulge) / (2.0 * bulge));
    let toward = start - center;
    // The start lies on the first axis.
    PieceCurve::Arc(EllipseArc { center, axes: [toward, toward.perp()], start: 0.0, sweep })
}

/// How much of a unit vector rounding may turn away from the z axis.
const TILT: f64 = 1e-9;

/// Whether the plane of an entity is seen from below, which mirrors its x axis.
fn faces_down(name: &str, pairs: &[Pair<'_>]) -> Result<bool, OutlineError> {
    let [x, y] = [value(pairs, 210)?.unwrap_or(0.0), value(pairs, 220)?.unwrap_or(0.0)];
    let z = value(pairs, 230)?.unwrap_or(1.0);
    if x.abs().max(y.abs()) <= TILT * z.abs() {
        return Ok(z < 0.0);
    }
    let line = pairs.first().map_or(1, |pair| pair.line);
    Err(at_line(
        line,
        format!(
            "the {name} lies in a tilted plane: its extrusion is ({x:?}, {y:?}, {z:?}), expected \
             (0, 0, 1) or (0, 0, -1); turn it into the xy plane, or delete it"
        ),
    ))
}

/// The layer of an entity. Layer 0 is where drawings begin, and no name.
pub(super) fn layer_of(pairs: &[Pair<'_>]) -> Option<Shared<str>> {
    let layer = text(pairs, 8);
    (!matches!(layer, "" | "0")).then(|| Shared::from(layer))
}

/// The place of a POINT.
pub(super) fn point_at(pairs: &[Pair<'_>]) -> Result<DVec2, OutlineError> {
    let point = DVec2::new(need(pairs, 10)?, need(pairs, 20)?);
    Ok(if faces_down("POINT", pairs)? { DVec2::new(-point.x, point.y) } else { point })
}

fn finite(pair: &Pair<'_>) -> Result<f64, OutlineError> {
    number(pair.value).ok_or_else(|| {
        let problem = format!("found {}, expected a finite number", quoted(pair.value));
        at_line(pair.line + 1, problem)
    })
}

/// The whole number of a group code, 0 if it is missing.
pub(super) fn whole(pairs: &[Pair<'_>], code: i32) -> i64 {
    let pair = pairs.iter().find(|pair| pair.code == code);
    pair.and_then(|pair| pair.value.parse().ok()).unwrap_or(0)
}

/// The text of a group code, empty if it is missing.
pub(super) fn text<'a>(pairs: &[Pair<'a>], code: i32) -> &'a str {
    pairs.iter().find(|pair| pair.code == code).map_or("", |pair| pair.value)
}

fn value(pairs: &[Pair<'_>], code: i32) -> Result<Option<f64>, OutlineError> {
    pairs.iter().find(|pair| pair.code == code).map(finite).transpose()
}

fn need(pairs: &[Pair<'_>], code: i32) -> Result<f64, OutlineError> {
    value(pairs, code)?.ok_or_else(|| {
        let (line, name) = pairs.first().map_or((1, ""), |pair| (pair.line, pair.value));
        at_line(line, format!("the {name} has no group code {code}"))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn bulges_are_arcs() {
        let (start, end) = (DVec2::new(1.0, 1.0), DVec2::new(3.0, 1.0));
        for (bulge, center, sweep) in [
            (1.0, [2.0, 1.0], PI),
            (-1.0, [2.0, 1.0], -PI),
            ((PI / 8.0).tan(), [2.0, 2.0], PI / 2.0),
            (-(PI / 8.0).tan(), [2.0, 0.0], -PI / 2.0),
            ((PI * 3.0 / 8.0).tan(), [2.0, 0.0], PI * 1.5),
        ] {
            let PieceCurve::Arc(arc) = bulged(start, end, bulge) else { panic!("{bulge}") };
            assert!(arc.center.distance(center.into()) < 1e-12, "{bulge}: {arc:?}");
            assert!((arc.sweep - sweep).abs() < 1e-12, "{bulge}: {arc:?}");
            assert!(arc.point(0.0).distance(start) < 1e-12, "{bulge}: {arc:?}");
            assert!(arc.point(arc.sweep).distance(end) < 1e-12, "{bulge}: {arc:?}");
        }
        assert_eq!(bulged(start, end, 0.0), PieceCurve::Line);
    }
}
