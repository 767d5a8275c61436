//! A drawing by layers: each has polygons of its own, which are named after it.
//!
//! A ring in one of the same layer is a hole. A polygon in one of another layer is cut from that, and stays a region. Lines
//! that close no ring, and points, lie inside.

use std::sync::Arc as Shared;

use glam::DVec2;
use mindeg_domain::InnerPoint;

use crate::curve::Segment;
use crate::error::OutlineError;
use crate::loops::{Chains, Link, chains};
use crate::nesting::{Loop, fits_in, loops, polygons, smallest_around};
use crate::outline::{Border, Feature, FillRule, Outlines, Piece};

/// A name of a layer.
type Layer = Option<Shared<str>>;

/// The polygons of each layer, in the order of the drawing, and lines and points inside.
///
/// # Errors
///
/// Three or more lines of a layer at a point; no closed outline.
pub(super) fn outlines(
    points: &[DVec2],
    links: Vec<Link>,
    inner: Vec<(Layer, DVec2)>,
    notes: Vec<String>,
) -> Result<Outlines, OutlineError> {
    let mut layers: Vec<(String, Vec<Link>)> = Vec::new();
    for link in links {
        let name = link.side.as_deref().unwrap_or_default().to_uppercase();
        match layers.iter_mut().find(|layer| layer.0 == name) {
            Some((_, own)) => own.push(link),
            None => layers.push((name, vec![link])),
        }
    }
    let mut outlines = Outlines { notes, ..Outlines::default() };
    let mut of_layers = Vec::new();
    for (index, (_, links)) in layers.iter().enumerate() {
        let name = links.first().and_then(|link| link.side.clone());
        let Chains { mut rings, open } = chains(points, links)?;
        let pieces = rings.iter_mut().flat_map(|ring| &mut ring.pieces);
        pieces.for_each(|piece| piece.side = None);
        let (features, _) = polygons(rings, FillRule::EvenOdd, name.as_deref())?;
        for feature in features {
            of_layers.push(index);
            outlines.features.push(feature);
            outlines.end_shape();
        }
        outlines
            .inside
            .lines
            .extend(open.iter().flat_map(|(pieces, ends)| borders(pieces, ends[1])));
    }
    if outlines.features.is_empty() {
        return Err(OutlineError::place(
            "the section ENTITIES",
            "no line closes; close the boundary",
        ));
    }
    cut_others(&mut outlines.features, &of_layers);
    let point = |(layer, at): (Layer, DVec2)| InnerPoint {
        at,
        name: layer.map(|name| name.to_string()),
        ..InnerPoint::default()
    };
    outlines.inside.points = inner.into_iter().map(point).collect();
    Ok(outlines)
}

/// Makes a hole of each polygon in the smallest one around it that is of another layer.
fn cut_others(features: &mut [Feature], of_layers: &[usize]) {
    let loops: Vec<Vec<Loop>> = features.iter().map(|feature| loops(&feature.rings)).collect();
    for inner in 0..features.len() {
        let own = &loops[inner][0].points;
        let is_around = |&outer: &usize| {
            of_layers[outer] != of_layers[inner]
                && !loops[outer][1..].iter().any(|hole| fits_in(own, &hole.points))
        };
        let around = (0..features.len()).filter(is_around).map(|outer| (outer, &loops[outer][0]));
        if let Some(outer) = smallest_around(around, own) {
            let hole = features[inner].rings[0].clone();
            features[outer].rings.push(hole);
        }
    }
}

/// The pieces of a line that ends at a point, as lines inside.
fn borders(pieces: &[Piece], end: DVec2) -> impl Iterator<Item = Border> {
    let ends = pieces.iter().skip(1).map(|piece| piece.start).chain([end]);
    pieces.iter().zip(ends).map(|(piece, end)| Border {
        segment: Segment { start: piece.start, end, curve: piece.curve },
        side: piece.side.clone(),
        begins_side: piece.begins_side,
        beside: [None; 2],
    })
}
