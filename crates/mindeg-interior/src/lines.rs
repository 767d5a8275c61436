//! Turns fixed lines, whose ends may be positions, into fixed points and segments between vertices.

use crate::edge_tree::EdgeTree;
use crate::near::Near;
use crate::options::{Fixed, InteriorError, is_usable};
use mindeg_domain::{FixedLines, LineEnd};
use mindeg_mesh::planar::PlanarBoundary;

/// Ends nearer to a vertex than this share of the domain's extent are that vertex.
const SAME: f64 = 1e-9;

impl Fixed {
    /// Fixed points and segments from points and lines. An end at the place of a boundary vertex or
    /// fixed point is that vertex; another is a fixed point more.
    ///
    /// O(n) for n boundary vertices and ends.
    ///
    /// # Errors
    ///
    /// An end on the boundary between its vertices, at a place that is no pair of ordinary
    /// numbers; or what [`FixedLines::check`] refuses.
    pub fn of_lines(outline: &PlanarBoundary, wanted: &FixedLines) -> Result<Self, InteriorError> {
        wanted.check()?;
        let mut points = wanted.points.clone();
        let near_enough = SAME * outline.bounds().size().max_element();
        let boundary = outline.points();
        let mut near = Near::new(outline.bounds());
        boundary.iter().for_each(|point| near.insert(*point));
        let tree = (!wanted.lines.is_empty()).then(|| EdgeTree::of_boundary(outline));
        // Lines out of range are refused with their index when all is meshed.
        points.iter().for_each(|point| near.insert(*point));
        let mut segments = Vec::new();
        for (line, ends) in wanted.lines.iter().enumerate() {
            let mut vertices = Vec::with_capacity(ends.len());
            for end in ends {
                vertices.push(match *end {
                    LineEnd::Point(index) => (boundary.len() + index) as u32,
                    LineEnd::At(at) => {
                        let what = format!("an end of fixed line {line}");
                        if !is_usable(at) {
                            return Err(InteriorError::Outside { what, at: at.to_array() });
                        }
                        if let Some((vertex, _)) = near.nearest(at, near_enough) {
                            vertex
                        } else {
                            if let Some((edge, distance)) =
                                tree.as_ref().and_then(|tree| tree.nearest(at, f64::INFINITY))
                                && distance <= near_enough
                            {
                                let vertex = [edge, outline.next(edge)]
                                    .into_iter()
                                    .min_by(|a, b| {
                                        let away = |v: u32| outline.point(v).distance_squared(at);
                                        away(*a).total_cmp(&away(*b))
                                    })
                                    .unwrap_or(edge);
                                return Err(InteriorError::EndOffVertex {
                                    line,
                                    at: at.to_array(),
                                    vertex,
                                    nearest: outline.point(vertex).to_array(),
                                });
                            }
                            near.insert(at);
                            points.push(at);
                            (boundary.len() + points.len() - 1) as u32
                        }
                    }
                });
            }
            segments.extend(vertices.windows(2).map(|ends| [ends[0], ends[1]]));
        }
        Ok(Self { points, segments })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples;
    use glam::DVec2;

    #[test]
    fn ends_become_vertices() {
        let outline = samples::rectangle(4.0, 2.0, [4, 2, 4, 2]);
        let at = |x: f64, y: f64| LineEnd::At(DVec2::new(x, y));
        let resolve = |lines: Vec<Vec<LineEnd>>| {
            let points = vec![DVec2::new(1.0, 1.0)];
            Fixed::of_lines(&outline, &FixedLines { points, lines })
        };
        let found = resolve(vec![
            vec![at(0.0, 1.0), LineEnd::Point(0), at(2.0, 1.5)],
            vec![at(2.0, 1.5), at(4.0, 1.0 + 1e-12)],
        ]);
        let found = found.unwrap();
        assert_eq!(found.points, [DVec2::new(1.0, 1.0), DVec2::new(2.0, 1.5)]);
        assert_eq!(found.segments, [[11, 12], [12, 13], [13, 5]]);
        for (ends, message) in [
            (
                vec![at(0.0, 1.5), at(1.0, 1.0)],
                "fixed line 0 ends on the boundary at (0, 1.5), between its points; the nearest is vertex 10 at (0, 2): end the line there, or put a boundary point here",
            ),
            (
                vec![LineEnd::Point(3), at(1.0, 1.0)],
                "fixed line 0 names fixed point 3; \"points\" has 1 (counted from 0)",
            ),
            (
                vec![at(f64::NAN, 1.5), at(1.0, 1.0)],
                "an end of fixed line 0 at (NaN, 1.5) is not inside the domain",
            ),
        ] {
            assert_eq!(resolve(vec![ends]).unwrap_err().to_string(), message);
        }
    }
}
