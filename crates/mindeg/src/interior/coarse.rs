//! Sides and lines whose edges are longer than the sizes asked for there.

use glam::DVec2;
use mindeg_domain::Domain;
use mindeg_interior::CoarseEdge;
use std::collections::BTreeMap;

/// A side or line with edges that are more than 1.4 times as long as the sizes asked for there.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "json", derive(serde::Serialize))]
pub struct CoarseSide {
    /// Its name, such as "side 1".
    pub name: String,
    /// The middle of the edge that is the most times too long.
    #[cfg_attr(feature = "json", serde(rename = "position"))]
    pub at: DVec2,
    /// The length of that edge.
    pub length: f64,
    /// The size asked for there.
    pub size: f64,
    /// The number of intervals that the side has.
    pub intervals: u64,
    /// The number of intervals that the sizes ask for.
    pub wanted_intervals: u64,
}

/// The sides and lines of edges that are too long, the worst first.
pub(super) fn coarse_sides(domain: &Domain, edges: &[CoarseEdge]) -> Vec<CoarseSide> {
    let rings = domain.rings();
    let lines = domain.inner_lines();
    // The lines have all segments, in order.
    let line_of = |segment: u32| lines.partition_point(|(line, _)| line.segments.end <= segment);
    let mut found: BTreeMap<usize, CoarseSide> = BTreeMap::new();
    for edge in edges {
        let (index, name, intervals) = match edge.edge.checked_sub(rings.vertex_count()) {
            None => {
                let side = rings.side_of(edge.edge);
                (side, domain.side_name(side), u64::from(rings.intervals(side)))
            }
            Some(segment) => {
                let line = line_of(segment);
                let (name, count) = (&lines[line].0.name, lines[line].0.segments.len());
                (rings.side_count() + line, name.clone(), count as u64)
            }
        };
        let CoarseEdge { at, length, size, .. } = *edge;
        let side = found.entry(index).or_insert_with(|| {
            let wanted_intervals = intervals;
            CoarseSide { name, at, length, size, intervals, wanted_intervals }
        });
        // Sizes far too small for any boundary stay numbers.
        let pieces = (length / size * (1.0 - 1e-9)).ceil().min(1e15) as u64;
        side.wanted_intervals += pieces - 1;
        if length / size > side.length / side.size {
            (side.at, side.length, side.size) = (at, length, size);
        }
    }
    let mut sides: Vec<CoarseSide> = found.into_values().collect();
    sort(&mut sides);
    sides
}

/// The worst first.
pub(super) fn sort(sides: &mut [CoarseSide]) {
    sides.sort_by(|a, b| (b.length / b.size).total_cmp(&(a.length / a.size)));
}

#[cfg(test)]
mod tests {
    use crate::{Domain, Progress, interior};

    /// On a square of four corners a size of 0.1 was ignored.
    #[test]
    fn sizes_that_the_boundary_contradicts_are_told_by_side() {
        let found = |json: &str| {
            let domain = Domain::from_json(json).unwrap();
            let wanted = domain.interior().cloned().unwrap_or_default();
            let mesh = interior::mesh(&domain, &wanted, Progress::NONE).unwrap();
            let side =
                |side: interior::CoarseSide| (side.name, side.intervals, side.wanted_intervals);
            mesh.coarse_sides.into_iter().map(side).collect::<Vec<_>>()
        };
        let square = |inside: &str| {
            format!(
                r#"{{"polygon": {{"corners": [[0, 0], [1, 0], [1, 1], [0, 1]]}}, "size": 1, "interior": {{{inside}}}}}"#
            )
        };
        let sides = [1, 2, 3, 4].map(|side| (format!("side {side}"), 1, 10));
        assert_eq!(found(&square(r#""size_inside": 0.1"#)), sides);
        assert_eq!(found(&square("")), []);
        // Within growth of the middle, each edge is longer than its size.
        let sides = [1, 2, 3, 4].map(|side| (format!("side {side}"), 1, 4));
        assert_eq!(found(&square(r#""sizes": [[0.5, 0.5, 0.05]]"#)), sides);
        assert_eq!(found(&square(r#""sizes": [[0.5, 0.5, 0.5]]"#)), []);
        // A line that stays, and one that may be divided.
        let line = |how: &str| {
            format!(
                r#"{{"rectangle": {{"width": 4, "height": 4}}, "size": 0.5, "lines": [{{"corners": [[1, 2], [3, 2]], {how}}}],
                    "interior": {{"sizes": [[2, 2, 0.1]]}}}}"#
            )
        };
        let coarse = found(&line(r#""intervals": 2, "name": "wall""#));
        assert_eq!(coarse, [("wall".to_owned(), 2, 6)]);
        assert_eq!(found(&line(r#""size": 0.5"#)), []);
        // Far from the boundary the size is reached.
        let wide = r#"{"rectangle": {"width": 9, "height": 9}, "size": 1, "interior": {"size_inside": 0.2}}"#;
        assert_eq!(found(wide), []);
    }
}
