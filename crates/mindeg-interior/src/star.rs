//! The limit of the minimum angle where frozen edges meet.
//!
//! Each of the sectors between them is a fan ([`limits`](crate::limits)): with k_i triangles in sector i, the
//! **star limit** is the greatest over all k_1 + … + k_m within the degree of the least fan limit of the sectors.
//! Every sector needs a triangle, and two from 180 degrees on: where that makes more than the degree limit, no mesh
//! keeps it.

use crate::breaklines::Breaklines;
use crate::limits::{fan_limit_from, shared_out};
use mindeg_mesh::planar::{PlanarBoundary, orientation};
use std::f64::consts::TAU;

/// The room between two frozen edges that meet at a vertex, counter-clockwise from the first to the second.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Sector {
    pub(crate) vertex: u32,
    /// The other ends of the edges.
    pub(crate) ends: [u32; 2],
    /// The angle in radians; a full turn at the end of a line.
    pub(crate) angle: f64,
    /// The lengths of the edges.
    pub(crate) lengths: [f64; 2],
    /// The least number of triangles that fill it.
    pub(crate) least: u32,
}

impl Sector {
    /// The fan limit in degrees with at most so many triangles.
    pub(crate) fn limit(&self, max_triangles: Option<u32>) -> f64 {
        fan_limit_from(self.least, self.angle, self.lengths, max_triangles)
    }
}

/// The sectors at all vertices where frozen edges meet.
#[derive(Debug, Clone, Default)]
pub(crate) struct Stars {
    /// By vertex, and counter-clockwise at each.
    sectors: Vec<Sector>,
    /// The first sector of each vertex, then the number of sectors.
    starts: Vec<u32>,
}

impl Stars {
    /// The stars of an outline's vertices, then of the points of lines.
    pub(crate) fn new(outline: &PlanarBoundary, lines: &Breaklines) -> Self {
        let on_rings = outline.vertex_count();
        let count = on_rings as usize + lines.points.len();
        let mut ends: Vec<[u32; 2]> =
            lines.edges.iter().flat_map(|[a, b]| [[*a, *b], [*b, *a]]).collect();
        ends.sort_unstable();
        ends.dedup();
        let mut stars = Self { sectors: Vec::with_capacity(count), starts: vec![0] };
        let mut inner = ends.chunk_by(|a, b| a[0] == b[0]).peekable();
        for vertex in 0..count as u32 {
            let own = inner.next_if(|own| own[0][0] == vertex).unwrap_or_default();
            let own = own.iter().map(|ends| ends[1]);
            if vertex < on_rings {
                stars.push_open(outline, lines, vertex, own.collect());
            } else {
                stars.push_closed(outline, lines, vertex, own.collect());
            }
            stars.starts.push(stars.sectors.len() as u32);
        }
        stars
    }

    /// The same where each triangle has a corner inside: a vertex of the outline without lines has two triangles, since the
    /// only one would have its neighbours as corners.
    pub(crate) fn with_corners_inside(mut self, outline: &PlanarBoundary) -> Self {
        for vertex in 0..outline.vertex_count() as usize {
            if let [sector] =
                &mut self.sectors[self.starts[vertex] as usize..self.starts[vertex + 1] as usize]
            {
                sector.least = sector.least.max(2);
            }
        }
        self
    }

    /// The sectors of a vertex on a ring.
    fn push_open(
        &mut self,
        outline: &PlanarBoundary,
        lines: &Breaklines,
        vertex: u32,
        inner: Vec<u32>,
    ) {
        let [next, previous] = [outline.next(vertex), outline.previous(vertex)];
        let whole = Sector {
            vertex,
            ends: [next, previous],
            angle: outline.angle(vertex),
            lengths: [outline.length(vertex), outline.length(previous)],
            least: least(outline, lines, vertex, [next, previous]),
        };
        if inner.is_empty() {
            self.sectors.push(whole);
            return;
        }
        self.push_between(outline, lines, vertex, [next, previous], inner);
    }

    /// The sectors of a vertex inside.
    fn push_closed(
        &mut self,
        outline: &PlanarBoundary,
        lines: &Breaklines,
        vertex: u32,
        inner: Vec<u32>,
    ) {
        let Some(first) = inner.first().copied() else { return };
        self.push_between(outline, lines, vertex, [first, first], inner[1..].to_vec());
    }

    /// The sectors from the first of two ends over inner ones to the last.
    fn push_between(
        &mut self,
        outline: &PlanarBoundary,
        lines: &Breaklines,
        vertex: u32,
        [first, last]: [u32; 2],
        inner: Vec<u32>,
    ) {
        let mut ends = ordered(outline, lines, vertex, first, inner);
        ends.insert(0, first);
        ends.push(last);
        self.sectors
            .extend(ends.windows(2).map(|ends| sector(outline, lines, vertex, [ends[0], ends[1]])));
    }

    /// The sectors at a vertex; none where nothing is frozen.
    pub(crate) fn at(&self, vertex: u32) -> &[Sector] {
        match self.starts.get(vertex as usize..vertex as usize + 2) {
            Some([start, end]) => &self.sectors[*start as usize..*end as usize],
            _ => &[],
        }
    }

    /// The sectors of the same face at the first and at the last end of a sector's edges.
    pub(crate) fn beside(&self, sector: &Sector) -> [Option<&Sector>; 2] {
        let [first, last] = sector.ends.map(|end| self.at(end).iter());
        let vertex = sector.vertex;
        [
            first.clone().find(|own| own.ends[1] == vertex),
            last.clone().find(|own| own.ends[0] == vertex),
        ]
    }

    /// The least limit of each of so many vertices that `limits` tells for a sector; `most` where none is less.
    pub(crate) fn least_limits(
        &self,
        vertices: usize,
        most: f64,
        limits: impl Fn(&Sector) -> Option<[(u32, f64); 2]>,
    ) -> Vec<f64> {
        let mut least = vec![most; vertices];
        let sectors = (0..vertices as u32).flat_map(|vertex| self.at(vertex));
        for (vertex, limit) in sectors.filter_map(limits).flatten() {
            least[vertex as usize] = least[vertex as usize].min(limit);
        }
        least
    }

    /// The other ends of the frozen edges at a vertex, counter-clockwise.
    pub(crate) fn ends(&self, vertex: u32) -> Vec<u32> {
        let sectors = self.at(vertex);
        let mut ends: Vec<u32> = sectors.iter().map(|sector| sector.ends[0]).collect();
        let last = sectors.last().map(|sector| sector.ends[1]);
        ends.extend(last.filter(|last| *last != ends[0]));
        ends
    }

    /// The star limit in degrees of a vertex with at most so many triangles; 0 where its sectors need more.
    pub(crate) fn limit(&self, vertex: u32, max_triangles: Option<u32>) -> f64 {
        match (self.at(vertex), max_triangles) {
            ([], _) => 60.0,
            ([sector], _) => sector.limit(max_triangles),
            (sectors, None) => sectors.iter().map(|sector| sector.limit(None)).fold(60.0, f64::min),
            (sectors, Some(most)) => {
                let limit = |(sector, own): (&Sector, u32)| sector.limit(Some(own));
                let counts = allotted(sectors, most);
                counts.map_or(0.0, |counts| {
                    sectors.iter().zip(counts).map(limit).fold(60.0, f64::min)
                })
            }
        }
    }

    /// The least number of triangles that any mesh has at a vertex.
    pub(crate) fn least(&self, vertex: u32) -> u32 {
        self.at(vertex).iter().map(|sector| sector.least).sum()
    }
}

/// How sectors share so many triangles, so that the least fan limit is greatest; `None` where there are more sectors.
pub(crate) fn allotted(sectors: &[Sector], triangles: u32) -> Option<Vec<u32>> {
    shared_out(sectors.len(), triangles, |i, most| sectors[i].limit(Some(most)))
}

/// Other ends of edges at a vertex, counter-clockwise from the direction to `first` on; exact.
fn ordered(
    outline: &PlanarBoundary,
    lines: &Breaklines,
    vertex: u32,
    first: u32,
    mut ends: Vec<u32>,
) -> Vec<u32> {
    let at = |v: u32| lines.at(outline, v);
    let turns = |from: u32, to: u32| orientation(at(vertex), at(from), at(to)) > 0.0;
    ends.sort_by(|a, b| {
        turns(first, *b).cmp(&turns(first, *a)).then_with(|| turns(*b, *a).cmp(&turns(*a, *b)))
    });
    ends
}

fn sector(outline: &PlanarBoundary, lines: &Breaklines, vertex: u32, ends: [u32; 2]) -> Sector {
    let at = |v: u32| lines.at(outline, v);
    let [from, to] = ends.map(|end| at(end) - at(vertex));
    let angle = libm::atan2(from.perp_dot(to), from.dot(to));
    let least = least(outline, lines, vertex, ends);
    let angle = if least > 1 && angle <= 0.0 { angle + TAU } else { angle };
    Sector { vertex, ends, angle, lengths: [from.length(), to.length()], least }
}

/// The least number of triangles in a sector: each has an angle below 180 degrees.
fn least(outline: &PlanarBoundary, lines: &Breaklines, vertex: u32, [from, to]: [u32; 2]) -> u32 {
    let at = |v: u32| lines.at(outline, v);
    if from == to {
        3
    } else if orientation(at(vertex), at(from), at(to)) > 0.0 {
        1
    } else {
        2
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples;
    use glam::DVec2;

    /// The stars of a triangle round a vertex at the origin with lines from there, each of length 1.
    fn stars(directions: &[f64]) -> Stars {
        let ring = [[-9.0, -9.0], [9.0, -9.0], [0.0, 9.0]].map(DVec2::from);
        let ends = directions.iter().map(|degrees| DVec2::from_angle(degrees.to_radians()));
        let points: Vec<DVec2> = [DVec2::ZERO].into_iter().chain(ends).collect();
        let edges = (4..4 + directions.len() as u32).map(|end| [end, 3]).collect();
        Stars::new(&PlanarBoundary::new(&[ring]).unwrap(), &Breaklines { points, edges })
    }

    #[test]
    fn sectors_share_the_triangles_of_a_star() {
        // Six sectors of 60 degrees; three of 120 with six triangles; of 7 triangles one is of no use.
        let (six, three) = ([0.0, 60.0, 120.0, 180.0, 240.0, 300.0], [240.0, 0.0, 120.0]);
        for (directions, most, limit) in [
            (&six[..], 6, 60.0),
            (&six, 7, 60.0),
            (&six, 5, 0.0),
            (&three, 6, 60.0),
            (&three, 7, 60.0),
            (&three, 5, 30.0),
            // A sector of 20 degrees decides.
            (&[0.0, 20.0, 180.0], 7, 20.0),
            // The end of a line.
            (&[30.0], 7, 60.0),
            (&[30.0], 4, 45.0),
        ] {
            let found = stars(directions).limit(3, Some(most));
            assert!((found - limit).abs() < 1e-9, "{directions:?} {most}: {found}");
        }
    }

    #[test]
    fn sectors_at_a_straight_boundary_share_its_triangles() {
        // One triangle of 60 degrees, and two.
        let outline = samples::rectangle(4.0, 3.0, [4, 3, 4, 3]);
        let end = outline.point(2) + DVec2::from_angle(std::f64::consts::FRAC_PI_3);
        let lines = Breaklines { points: vec![end], edges: vec![[2, 14]] };
        let stars = Stars::new(&outline, &lines);
        assert_eq!(
            stars.at(2).iter().map(|sector| sector.ends).collect::<Vec<_>>(),
            [[3, 14], [14, 1]]
        );
        assert!((stars.limit(2, Some(3)) - 60.0).abs() < 1e-9);
        assert!((stars.limit(2, Some(2)) - 30.0).abs() < 1e-9);
        assert_eq!([0, 2, 14].map(|vertex| stars.least(vertex)), [1, 2, 3]);
    }

    #[test]
    fn every_sector_needs_a_triangle() {
        for (directions, least) in [
            (&[0.0, 60.0, 120.0, 180.0, 240.0, 300.0][..], 6),
            (&[0.0, 10.0, 20.0], 4),
            (&[0.0, 170.0], 3),
            (&[77.0], 3),
            (&[], 0),
        ] {
            assert_eq!(stars(directions).least(3), least, "{directions:?}");
        }
    }
}
