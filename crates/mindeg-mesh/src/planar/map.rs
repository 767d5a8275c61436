//! Boundaries from rings, lines and points, and the faces between them.

use std::collections::BTreeMap;
use std::ops::Range;

use glam::DVec2;

use super::boundary::PlanarBoundary;
use super::faults::{BoundaryFaults, check_lines, check_nesting, check_rings};
use super::in_ring::BoundaryPlace;
use super::sweep::{around_point, side_of, swept};

/// The faces that the lines of a [`PlanarBoundary`] divide its domain into, counted from 0.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Faces {
    /// The number of faces, at least 1.
    pub count: usize,
    /// The face on the left and on the right of each edge, of rings and then of lines; none outside the domain.
    pub beside: Vec<[Option<u32>; 2]>,
    /// The face around each point that was asked for; none outside the domain.
    pub around: Vec<Option<u32>>,
    /// The face around each inner point that no line has.
    pub points: Vec<Option<u32>>,
}

impl PlanarBoundary {
    /// A boundary of rings that run the right way round: the outer one first. O(n log n).
    ///
    /// # Errors
    ///
    /// All faults of the rings.
    pub fn new<R: AsRef<[DVec2]>>(rings: &[R]) -> Result<Self, BoundaryFaults> {
        let (boundary, turned) = Self::oriented(rings)?;
        if turned.is_empty() { Ok(boundary) } else { Err(BoundaryFaults::directions(turned)) }
    }

    /// A boundary of rings that run either way round, and the indices of the reversed rings, which
    /// keep their first points. O(n log n).
    ///
    /// # Errors
    ///
    /// All faults of the rings.
    pub fn oriented<R: AsRef<[DVec2]>>(rings: &[R]) -> Result<(Self, Vec<usize>), BoundaryFaults> {
        Self::map(rings, &[], &[])
    }

    /// [`oriented`](Self::oriented) with points inside the domain and lines. A line is a sequence of vertices:
    /// of the rings as given, or of `points` after them; its last vertex may be its first. O(n log n).
    ///
    /// # Errors
    ///
    /// All faults of the rings; then of points and lines that are outside, or that meet elsewhere than at a vertex.
    ///
    /// # Panics
    ///
    /// If a line has a vertex that does not exist.
    ///
    /// # Example
    ///
    /// ```
    /// use glam::DVec2;
    /// use mindeg_mesh::planar::PlanarBoundary;
    ///
    /// // A line divides a square, and ends at two of its corners.
    /// let square = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]].map(DVec2::from);
    /// let middle = [DVec2::new(1.0, 2.0)];
    /// let (boundary, _) = PlanarBoundary::map(&[square], &middle, &[vec![0, 4, 2]])?;
    /// assert_eq!(boundary.segments(), [[0, 4], [4, 2]]);
    /// let faces = boundary.faces(&[[1.0, 3.0], [3.0, 1.0]].map(DVec2::from))?;
    /// assert_eq!((faces.count, faces.around), (2, vec![Some(0), Some(1)]));
    /// assert_eq!(faces.beside[4], [Some(0), Some(1)]); // on both sides of the line's first edge
    /// # Ok::<(), mindeg_mesh::planar::BoundaryFaults>(())
    /// ```
    pub fn map<R: AsRef<[DVec2]>>(
        rings: &[R],
        points: &[DVec2],
        lines: &[Vec<u32>],
    ) -> Result<(Self, Vec<usize>), BoundaryFaults> {
        check_rings(rings)?;
        let mut boundary = Self::of_mesh(rings);
        boundary.points.extend_from_slice(points);
        for line in lines {
            boundary.segments.extend(line.windows(2).map(|ends| [ends[0], ends[1]]));
            boundary.line_starts.push(boundary.segments.len() as u32);
        }
        check_lines(&boundary, lines)?;
        let swept =
            swept(&boundary, false).map_err(|first| BoundaryFaults::all(&boundary, first))?;
        check_nesting(&boundary, &swept)?;
        let is_turned = |&ring: &usize| swept.nesting[ring].is_counter_clockwise != (ring == 0);
        let turned: Vec<usize> = (0..swept.nesting.len()).filter(is_turned).collect();
        boundary.turn(&turned);
        Ok((boundary, turned))
    }

    /// Reverses rings, each from the same first point.
    fn turn(&mut self, turned: &[usize]) {
        for &ring in turned {
            let Range { start, end } = self.ring(ring);
            self.points[start as usize + 1..end as usize].reverse();
        }
        if turned.is_empty() {
            return;
        }
        let mut segments = std::mem::take(&mut self.segments);
        for vertex in segments.as_flattened_mut().iter_mut() {
            if *vertex < self.vertex_count() {
                let ring = self.in_ring(*vertex).ring;
                let Range { start, end } = self.ring(ring);
                if *vertex > start && turned.contains(&ring) {
                    *vertex = start + end - *vertex;
                }
            }
        }
        self.segments = segments;
    }

    /// The faces between rings and lines, and those around `at`. O(n log n).
    ///
    /// Faces around points come first, in their order; then the others, by their first edges.
    ///
    /// # Errors
    ///
    /// A point that is on an edge or a vertex, or that comes twice: inner points after those of the boundary.
    pub fn faces(&self, at: &[DVec2]) -> Result<Faces, BoundaryFaults> {
        let mut marked = self.clone();
        marked.points.extend_from_slice(at);
        check_lines(&marked, &[])?;
        let swept = swept(&marked, true).map_err(|first| BoundaryFaults::all(&marked, first))?;
        let Some(mut sides) = swept.sides else { unreachable!("the sides are wanted") };
        // A ring has the domain on its left.
        let mut numbers: BTreeMap<u32, Option<u32>> =
            self.rings().map(|ring| (sides.least(side_of(ring.start, false)), None)).collect();
        let mut count = 0;
        let mut face = |side: u32| {
            *numbers.entry(sides.least(side)).or_insert_with(|| {
                count += 1;
                Some(count - 1)
            })
        };
        let around = (self.points.len() as u32..marked.points.len() as u32)
            .map(|vertex| face(around_point(&marked, vertex)))
            .collect();
        let beside = (0..self.edge_count())
            .map(|edge| [true, false].map(|is_left| face(side_of(edge, is_left))))
            .collect();
        let mut points = vec![None; self.inner_points().len()];
        for (vertex, _) in swept.around_points {
            if let Some(point) = points.get_mut((vertex - self.vertex_count()) as usize) {
                *point = face(around_point(&marked, vertex));
            }
        }
        Ok(Faces { beside, around, points, count: count as usize })
    }

    /// A vertex, as messages name it: by the first line that has it, if it is on no ring.
    pub fn place_of_vertex(&self, vertex: u32) -> BoundaryPlace {
        if vertex < self.vertex_count() {
            return BoundaryPlace::Ring(self.in_ring(vertex));
        }
        let ends = self.segments.as_flattened();
        match ends.iter().position(|&end| end == vertex) {
            None => BoundaryPlace::Point((vertex - self.vertex_count()) as usize),
            Some(end) => {
                let (line, index) = self.on_line(end as u32 / 2);
                BoundaryPlace::Line { line, index: index + end % 2 }
            }
        }
    }

    /// An edge, as messages name it.
    pub fn place_of_edge(&self, edge: u32) -> BoundaryPlace {
        match edge.checked_sub(self.vertex_count()) {
            None => BoundaryPlace::Ring(self.in_ring(edge)),
            Some(segment) => {
                let (line, index) = self.on_line(segment);
                BoundaryPlace::Line { line, index }
            }
        }
    }

    /// The line of a segment, and the segment's index on it.
    fn on_line(&self, segment: u32) -> (usize, usize) {
        let line = self.line_starts.partition_point(|&start| start <= segment) - 1;
        (line, (segment - self.line_starts[line]) as usize)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const SQUARE: [[f64; 2]; 4] = [[0.0, 0.0], [8.0, 0.0], [8.0, 8.0], [0.0, 8.0]];
    const HOLE: [[f64; 2]; 4] = [[2.0, 2.0], [2.0, 4.0], [4.0, 4.0], [4.0, 2.0]];

    /// Inner points, lines and the message of their faults.
    type Faulty<'a> = (&'a [[f64; 2]], &'a [&'a [u32]], &'a str);

    fn mapped(
        rings: &[&[[f64; 2]]],
        points: &[[f64; 2]],
        lines: &[&[u32]],
    ) -> Result<PlanarBoundary, BoundaryFaults> {
        let points_of = |points: &[[f64; 2]]| points.iter().copied().map(DVec2::from).collect();
        let rings: Vec<Vec<DVec2>> = rings.iter().map(|ring| points_of(ring)).collect();
        let lines: Vec<Vec<u32>> = lines.iter().map(|line| line.to_vec()).collect();
        let inner: Vec<DVec2> = points_of(points);
        PlanarBoundary::map(&rings, &inner, &lines).map(|found| found.0)
    }

    #[test]
    fn lines_may_end_on_rings_and_lines_and_close() {
        // Across the square, a tail on that, a closed line, a loose point, and a line between hole and outline.
        let points = [[4.0, 6.0], [4.0, 5.0], [6.0, 1.0], [7.0, 1.0], [7.0, 2.0], [5.0, 5.0]];
        let lines: &[&[u32]] = &[&[3, 8, 2], &[8, 9], &[10, 11, 12, 10], &[4, 0]];
        let boundary = mapped(&[&SQUARE, &HOLE], &points, lines).unwrap();
        assert_eq!((boundary.line_count(), boundary.edge_count()), (4, 15));
        assert_eq!(boundary.line(2), [[10, 11], [11, 12], [12, 10]]);
        let at = [[1.0, 7.9], [1.0, 7.0], [6.9, 1.1], [3.0, 3.0], [9.0, 9.0]];
        let faces = boundary.faces(&at.map(DVec2::from)).unwrap();
        assert_eq!((faces.count, faces.around), (3, vec![Some(0), Some(1), Some(2), None, None]));
        // The side of the square, the hole, the tail and the closed line.
        let beside = |edge: usize| faces.beside[edge];
        assert_eq!((beside(2), beside(3)), ([Some(0), None], [Some(1), None]));
        assert_eq!((beside(4), beside(8)), ([Some(1), None], [Some(0), Some(1)]));
        assert_eq!((beside(10), beside(11)), ([Some(1); 2], [Some(2), Some(1)]));
    }

    #[test]
    fn lines_keep_their_vertices_if_rings_are_reversed() {
        let mut clockwise = SQUARE;
        clockwise.reverse();
        // From (0, 8), the first corner, to (8, 0), the third; and to the corner after the first.
        let boundary = mapped(&[&clockwise], &[[2.0, 3.0]], &[&[0, 4, 2], &[4, 1]]).unwrap();
        let ends =
            boundary.segments().iter().map(|ends| ends.map(|v| boundary.point(v).to_array()));
        assert_eq!(
            ends.collect::<Vec<_>>(),
            [[[0.0, 8.0], [2.0, 3.0]], [[2.0, 3.0], [8.0, 0.0]], [[2.0, 3.0], [8.0, 8.0]]]
        );
    }

    #[test]
    fn every_fault_of_a_line_is_named() {
        let rings: &[&[[f64; 2]]] = &[&SQUARE, &HOLE];
        let nan = f64::NAN;
        #[rustfmt::skip]
        let table: &[Faulty<'_>] = &[
            (&[[1.0, nan]], &[&[0], &[1, 1]], "inner point 1 is not finite; line 1 has fewer than 2 points; point 1 of line 2 and point 2 of line 2 coincide"),
            (&[[1.0, 7.0], [7.0, 1.0]], &[&[8, 9]], "point 3 of hole 1 lies on edge 1 of line 1"),
            (&[[9.0, 9.0], [9.0, 10.0], [3.0, 3.0], [1.0, 1.0]], &[&[8, 9]], "edge 1 of line 1 lies outside the domain; inner point 3 lies outside the domain"),
            (&[[1.0, 1.0], [9.0, 1.0]], &[&[8, 9]], "edge 2 and edge 1 of line 1 cross"),
            (&[[1.0, 1.0], [7.0, 7.0], [7.0, 5.0], [5.0, 7.0]], &[&[8, 0], &[10, 11], &[6, 9]], "edge 1 of line 2 and edge 1 of line 3 cross"),
            (&[[1.0, 5.0], [1.0, 6.0], [2.0, 5.5], [1.0, 5.5]], &[&[8, 9], &[10, 11]], "point 2 of line 2 lies on edge 1 of line 1"),
            (&[[1.0, 5.0], [1.0, 6.0], [1.0, 5.5]], &[&[8, 9]], "inner point 3 lies on edge 1 of line 1"),
            (&[[8.0, 5.0]], &[], "inner point 1 lies on edge 2"),
            (&[[5.0, 5.0], [5.0, 5.0]], &[], "inner point 1 and inner point 2 coincide"),
            (&[[8.0, 8.0]], &[], "point 3 and inner point 1 coincide"),
            (&[], &[&[1, 2]], "edge 2 and edge 1 of line 1 lie on each other"),
            (&[[5.0, 5.0], [6.0, 6.0]], &[&[8, 2], &[9, 8]], "edge 1 of line 1 and edge 1 of line 2 lie on each other; point 1 of line 2 lies on edge 1 of line 1"),
            (&[], &[&[5, 7]], "edge 1 of line 1 lies outside the domain"),
        ];
        for (points, lines, expected) in table {
            let faults = mapped(rings, points, lines).unwrap_err();
            assert_eq!(faults.to_string(), *expected, "{points:?} {lines:?}");
        }
        let boundary = mapped(rings, &[[5.0, 5.0]], &[]).unwrap();
        let on = boundary.faces(&[DVec2::new(8.0, 1.0)]).unwrap_err();
        assert_eq!(on.to_string(), "inner point 2 lies on edge 2");
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(3000))]

        /// On a small grid lines touch, cross and divide in all ways.
        #[test]
        fn faces_agree_with_eulers_formula(
            ends in prop::collection::vec([0..7_i32, 0..7, 0..7, 0..7], 1..7),
        ) {
            let square = [[0, 0], [6, 0], [6, 6], [0, 6]];
            let at = |[x, y]: [i32; 2]| DVec2::new(x.into(), y.into());
            let mut points: Vec<[i32; 2]> = square.to_vec();
            let mut index = |point: [i32; 2]| {
                points.iter().position(|&p| p == point).unwrap_or_else(|| {
                    points.push(point);
                    points.len() - 1
                }) as u32
            };
            let mut lines: Vec<Vec<u32>> = Vec::new();
            for [a, b, c, d] in ends {
                let line = vec![index([a, b]), index([c, d])];
                if line[0] != line[1] {
                    lines.push(line);
                }
            }
            let inner: Vec<DVec2> = points[4..].iter().map(|&p| at(p)).collect();
            let found = PlanarBoundary::map(&[square.map(at)], &inner, &lines);
            let edges: Vec<[u32; 2]> = (0..4).map(|v| [v, (v + 1) % 4])
                .chain(lines.iter().map(|line| [line[0], line[1]]))
                .collect();
            prop_assert_eq!(found.is_ok(), is_valid(&points, &edges), "{:?} {:?}", points, edges);
            if let Ok((boundary, _)) = found {
                let faces = boundary.faces(&[]).unwrap();
                let mut parts = crate::connectivity::disjoint_sets::DisjointSets::new(points.len());
                edges.iter().for_each(|&[a, b]| parts.join(a, b));
                // V - E + F = 1 + C, with the outside as a face, and points as components.
                let expected = 1 + parts.count() + edges.len() - points.len() - 1;
                prop_assert_eq!(faces.count, expected.max(1), "{:?} {:?}", points, edges);
            }
        }
    }

    /// By the definition, in exact integers: no edge twice, no point inside an edge, no crossing.
    fn is_valid(points: &[[i32; 2]], edges: &[[u32; 2]]) -> bool {
        let area = |a: [i32; 2], b: [i32; 2], c: [i32; 2]| {
            (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
        };
        let inside = |a: [i32; 2], b: [i32; 2], c: [i32; 2]| {
            area(a, b, c) == 0
                && c != a
                && c != b
                && (0..2).all(|i| a[i].min(b[i]) <= c[i] && c[i] <= a[i].max(b[i]))
        };
        let at = |v: u32| points[v as usize];
        edges.iter().enumerate().all(|(i, &[a, b])| {
            if edges[i + 1..].iter().any(|&other| other == [a, b] || other == [b, a]) {
                return false;
            }
            let [a, b] = [at(a), at(b)];
            let crosses = |&[c, d]: &[u32; 2]| {
                let [c, d] = [at(c), at(d)];
                area(a, b, c).signum() * area(a, b, d).signum() < 0
                    && area(c, d, a).signum() * area(c, d, b).signum() < 0
            };
            points.iter().all(|&point| !inside(a, b, point)) && !edges[i + 1..].iter().any(crosses)
        })
    }
}
