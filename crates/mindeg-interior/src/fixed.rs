//! Fixed points and segments inside a domain: checked, and divided as the size field wants.

use crate::edge_tree::{EdgeTree, Item};
use crate::exact::meet;
use crate::near::Near;
use crate::options::{Fixed, InteriorError, is_usable};
use crate::packing::{Piece, is_inside_of};
use crate::size::SizeField;
use glam::DVec2;
use mindeg_domain::SizeAt;
use mindeg_mesh::planar::{PlanarBoundary, orientation};

/// Fixed points with those that divide segments, and the edges that segments are divided into.
#[derive(Debug, Clone, Default)]
pub(crate) struct Breaklines {
    /// After the outline's points.
    pub(crate) points: Vec<DVec2>,
    pub(crate) edges: Vec<[u32; 2]>,
}

impl Breaklines {
    pub(crate) fn pieces(&self, outline: &PlanarBoundary) -> Vec<Piece> {
        let at = |v: u32| self.at(outline, v);
        self.edges.iter().map(|[a, b]| Piece { from: at(*a), to: at(*b) }).collect()
    }

    fn at(&self, outline: &PlanarBoundary, vertex: u32) -> DVec2 {
        let boundary = outline.points();
        match boundary.get(vertex as usize) {
            Some(point) => *point,
            None => self.points[vertex as usize - boundary.len()],
        }
    }
}

/// Checks and divides. Also gives sizes where fixed points are nearer to each other or to the boundary
/// than the size field wants.
pub(crate) fn breaklines(
    outline: &PlanarBoundary,
    fixed: &Fixed,
    field: &SizeField,
) -> Result<(Breaklines, Vec<SizeAt>), InteriorError> {
    let mut lines = Breaklines { points: fixed.points.clone(), edges: Vec::new() };
    if fixed.points.is_empty() && fixed.segments.is_empty() {
        return Ok((lines, Vec::new()));
    }
    check_points(outline, fixed)?;
    check_segments(outline, fixed, &lines)?;
    let vertices = outline.points().len();
    for [a, b] in &fixed.segments {
        let (from, to) = (lines.at(outline, *a), lines.at(outline, *b));
        let mut last = *a;
        for share in divisions(from, to, field) {
            lines.points.push(from.lerp(to, share));
            let point = (vertices + lines.points.len() - 1) as u32;
            lines.edges.push([last, point]);
            last = point;
        }
        lines.edges.push([last, *b]);
    }
    let crowded = crowded(outline, &lines, field);
    Ok((lines, crowded))
}

fn check_points(outline: &PlanarBoundary, fixed: &Fixed) -> Result<(), InteriorError> {
    let tree = EdgeTree::of_boundary(outline);
    for (index, point) in fixed.points.iter().enumerate() {
        let outside = || {
            let what = format!("fixed point {index}");
            Err(InteriorError::Outside { what, at: point.to_array() })
        };
        if !is_usable(*point) {
            return outside();
        }
        match tree.nearest(*point, f64::INFINITY) {
            Some((edge, distance)) if distance > 0.0 && is_inside_of(outline, edge, *point) => {}
            _ => return outside(),
        }
    }
    let mut order: Vec<usize> = (0..fixed.points.len()).collect();
    let key = |i: &usize| fixed.points[*i].to_array();
    order.sort_by(|i, j| {
        let (a, b) = (key(i), key(j));
        a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])).then(i.cmp(j))
    });
    let same = order.windows(2).find(|pair| fixed.points[pair[0]] == fixed.points[pair[1]]);
    same.map_or(Ok(()), |pair| {
        let what = format!("fixed point {}, a second one,", pair[1]);
        Err(InteriorError::Outside { what, at: key(&pair[0]) })
    })
}

fn check_segments(
    outline: &PlanarBoundary,
    fixed: &Fixed,
    lines: &Breaklines,
) -> Result<(), InteriorError> {
    let vertices = outline.points().len() + fixed.points.len();
    let mut items = Vec::new();
    for (segment, ends) in fixed.segments.iter().enumerate() {
        if ends[0] == ends[1] || ends.iter().any(|v| *v as usize >= vertices) {
            return Err(InteriorError::Segment { segment, ends: *ends, vertices });
        }
        let [from, to] = ends.map(|v| lines.at(outline, v));
        items.push(Item { id: segment as u32, from, to, size: from.distance(to), reach: 0.0 });
    }
    let boundary = EdgeTree::of_boundary(outline);
    let tree = EdgeTree::of_items(items);
    let points = EdgeTree::of_items(
        (0..)
            .zip(&fixed.points)
            .map(|(id, at)| Item { id, from: *at, to: *at, size: 0.0, reach: 0.0 })
            .collect(),
    );
    for (segment, ends) in fixed.segments.iter().enumerate() {
        let [from, to] = ends.map(|v| lines.at(outline, v));
        let mut touched = None;
        let touches = |other: [u32; 2]| {
            let [c, d] = other.map(|v| lines.at(outline, v));
            // A common end is fine unless the two overlap.
            let common = ends.iter().find(|v| other.contains(v));
            match common {
                None => meet(from, to, c, d),
                Some(v) => {
                    let at = lines.at(outline, *v);
                    let far = |pair: [u32; 2]| pair.into_iter().find(|u| u != v).unwrap_or(*v);
                    let [p, q] = [far(*ends), far(other)].map(|v| lines.at(outline, v));
                    orientation(at, p, q) == 0.0 && (p - at).dot(q - at) > 0.0
                }
            }
        };
        boundary.visit(
            |node| node.may_touch(from, to),
            |edge| {
                let other = [edge, outline.next(edge)];
                if touches(other) {
                    touched = Some(format!("boundary edge {}-{}", other[0], other[1]));
                }
            },
        );
        tree.visit(
            |node| node.may_touch(from, to),
            |other| {
                if other as usize != segment && touches(fixed.segments[other as usize]) {
                    touched = Some(format!("fixed segment {other}"));
                }
            },
        );
        points.visit(
            |node| node.may_touch(from, to),
            |point| {
                let vertex = outline.vertex_count() + point;
                let at = fixed.points[point as usize];
                if !ends.contains(&vertex) && meet(from, to, at, at) {
                    touched = Some(format!("fixed point {point}"));
                }
            },
        );
        let middle = from.midpoint(to);
        let is_outside = boundary
            .nearest(middle, f64::INFINITY)
            .is_none_or(|(edge, _)| !is_inside_of(outline, edge, middle));
        if touched.is_none() && is_outside {
            touched = Some("the outside of the domain".into());
        }
        if let Some(what) = touched {
            return Err(InteriorError::SegmentCrosses { segment, what });
        }
    }
    Ok(())
}

/// Where to divide a segment, as shares of it: pieces about as long as the size wants.
fn divisions(from: DVec2, to: DVec2, field: &SizeField) -> Vec<f64> {
    let length = from.distance(to);
    // The number of sizes that go into the segment up to each step, by the trapezoid rule.
    let mut shares = vec![0.0];
    let mut counts = vec![0.0];
    let mut share: f64 = 0.0;
    let least = 1e-6;
    while share < 1.0 {
        let size = field.at(from.lerp(to, share)).max(least * length);
        let step = (0.25 * size / length).min(1.0 - share);
        let middle = field.at(from.lerp(to, share + step / 2.0)).max(least * length);
        let last = counts[counts.len() - 1];
        counts.push(last + step * length / middle);
        share = if 1.0 - share - step < 1e-12 { 1.0 } else { share + step };
        shares.push(share);
    }
    let total = counts[counts.len() - 1];
    let pieces = libm::round(total).max(1.0);
    let mut at = 0;
    (1..pieces as u64)
        .map(|i| {
            let wanted = total * i as f64 / pieces;
            while counts[at + 1] < wanted {
                at += 1;
            }
            let part = (wanted - counts[at]) / (counts[at + 1] - counts[at]);
            shares[at] + (shares[at + 1] - shares[at]) * part
        })
        .collect()
}

/// Sizes for fixed points that have a neighbour nearer than the size wants.
fn crowded(outline: &PlanarBoundary, lines: &Breaklines, field: &SizeField) -> Vec<SizeAt> {
    // Fixed points lie inside.
    let mut near = Near::new(outline.bounds());
    outline.points().iter().for_each(|p| near.insert(*p));
    let mut sizes = Vec::new();
    for point in &lines.points {
        let size = field.at(*point);
        if let Some((_, distance)) = near.nearest(*point, 0.7 * size) {
            sizes.push(SizeAt { at: *point, size: distance });
        } else if let Some((_, distance)) = field.boundary().nearest(*point, 0.5 * size) {
            sizes.push(SizeAt { at: *point, size: distance * 1.2 });
        }
        near.insert(*point);
    }
    sizes
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples;

    #[test]
    fn pieces_of_a_segment_are_as_long_as_the_size_wants() {
        let outline = samples::rectangle(40.0, 20.0, [40, 20, 40, 20]);
        let field = SizeField::new(&outline, 1.2, Some(2.0), &[], &[]);
        // In the middle of the plate, one size.
        let [from, to] = [[10.0, 10.0], [30.0, 10.0]].map(DVec2::from);
        let shares = divisions(from, to, &field);
        assert_eq!(shares.len(), 9);
        for (i, share) in (1..).zip(&shares) {
            assert!((share - f64::from(i) / 10.0).abs() < 1e-9, "{shares:?}");
        }
        // Towards a small size at one end, every piece has the same share of the sizes along it.
        let places = [SizeAt { at: to, size: 0.1 }];
        let field = SizeField::new(&outline, 1.2, Some(2.0), &[], &places);
        let shares = divisions(from, to, &field);
        let ends: Vec<f64> = [0.0].into_iter().chain(shares).chain([1.0]).collect();
        let sizes = |from_share: f64, to_share: f64| -> f64 {
            let steps = 1000;
            let step = (to_share - from_share) / f64::from(steps);
            let at = |i: i32| from.lerp(to, from_share + (f64::from(i) + 0.5) * step);
            (0..steps).map(|i| step * 20.0 / field.at(at(i))).sum()
        };
        let total = sizes(0.0, 1.0);
        assert_eq!(ends.len() - 1, total.round() as usize);
        for pair in ends.windows(2) {
            let share = sizes(pair[0], pair[1]) * (ends.len() - 1) as f64 / total;
            assert!((share - 1.0).abs() < 0.05, "{pair:?} {share} {total}");
        }
        // Shorter than the size: one piece.
        assert!(divisions(from, from + DVec2::X, &field).is_empty());
    }
}
