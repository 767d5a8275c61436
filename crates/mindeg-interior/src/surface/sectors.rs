//! The degrees that vertices on features may have: in each sector between two curves, and in all.

use crate::array_mesh::{ArrayMesh, Kind, NONE};
use crate::surface::reference::{CurveLabel, OnSurface};
use glam::DVec3;
use std::ops::RangeInclusive;

/// The triangles of a vertex between two edges that are parts of curves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SurfaceSector {
    /// The sum of their angles, in degrees.
    pub(crate) angle: f64,
    pub(crate) triangles: u32,
}

/// The sectors of a vertex.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Sectors {
    pub(crate) sectors: Vec<SurfaceSector>,
    /// True if the vertex is not on the boundary.
    pub(crate) is_closed: bool,
}

/// A good angle at a corner is at least this, in degrees: more triangles do not fit into a sector.
const LEAST_ANGLE: f64 = 28.0;
/// The most triangles at a vertex on the boundary, where its sectors allow so few.
pub(crate) const MOST_ON_BOUNDARY: u32 = 4;
/// Curves whose edges turn by more than this angle, in degrees, divide sectors for all who look.
const SHARP: f64 = 40.0;
/// No vertex has fewer triangles all around it.
const LEAST_AROUND: u32 = 3;
/// The greatest angle that a sector's triangles should have, in degrees.
const GREATEST_ANGLE: f64 = 100.0;

impl SurfaceSector {
    /// How many triangles it may have at a corner.
    fn range(&self) -> RangeInclusive<u32> {
        let least = libm::ceil(self.angle / GREATEST_ANGLE - 0.05).max(1.0);
        let ideal = libm::round(self.angle / 60.0) + 1.0;
        let most = ideal.min(libm::floor(self.angle / LEAST_ANGLE)).max(least);
        least as u32..=most as u32
    }

    /// The same on a curve, which turns little.
    fn range_on_curve(&self) -> RangeInclusive<u32> {
        let least = if self.angle < 115.0 { 1 } else { 2 };
        let most = if self.angle > 230.0 { 5 } else { 4 };
        least..=most
    }
}

impl Sectors {
    /// The sectors of a vertex as they are in the mesh.
    pub(crate) fn of(mesh: &ArrayMesh<OnSurface<'_>>, vertex: u32) -> Self {
        Self::between(mesh, vertex, |t, i| is_of_curve(mesh, t, i))
    }

    /// The sectors that a checker sees, which knows no curves: between edges that are sharp, on the boundary or between groups.
    /// Sharp edges of short lines, which are no curves, divide them, too.
    pub(crate) fn seen(mesh: &ArrayMesh<OnSurface<'_>>, vertex: u32) -> Self {
        Self::between(mesh, vertex, |t, i| is_seen(mesh, t, i))
    }

    /// The sectors between curves that a checker sees.
    pub(crate) fn sharp(mesh: &ArrayMesh<OnSurface<'_>>, vertex: u32) -> Self {
        Self::between(mesh, vertex, |t, i| is_of_curve(mesh, t, i) && is_seen(mesh, t, i))
    }

    /// The sectors of a vertex between those edges that count, each as a triangle and the corner opposite.
    fn between(
        mesh: &ArrayMesh<OnSurface<'_>>,
        vertex: u32,
        counts: impl Fn(u32, usize) -> bool,
    ) -> Self {
        let mut sectors = Vec::new();
        let is_closed = each_sector(mesh, vertex, counts, |sector| sectors.push(sector));
        Self { sectors, is_closed }
    }

    /// No mesh has a greater minimum angle in these sectors, in degrees: each has the best number of equal angles.
    pub(crate) fn limit(&self) -> f64 {
        let of_count = |angle: f64, n: u32| {
            let share = angle / f64::from(n);
            share.min(90.0 - 0.5 * share)
        };
        let of_sector = |sector: &SurfaceSector| {
            let most = libm::ceil(sector.angle / 30.0).max(1.0) as u32;
            (1..=most).map(|n| of_count(sector.angle, n)).fold(0.0, f64::max)
        };
        self.sectors.iter().map(of_sector).fold(60.0, f64::min)
    }

    /// How many triangles these sectors have in any mesh without an angle below `least`, in degrees: in each of the n
    /// triangles of a sector the angle is between `least` and 180 degrees less twice that. Off the boundary there are three at
    /// least.
    pub(crate) fn allowed(&self, least: f64) -> [u32; 2] {
        let counts = self.sectors.iter().map(|sector| {
            // A hair less: sectors are sums of rounded angles.
            let low = libm::ceil(sector.angle / (180.0 - 2.0 * least) - 1e-9).max(1.0);
            let high = libm::floor(sector.angle / least + 1e-9).max(low);
            [low, high].map(|count| count as u32)
        });
        let all = counts.fold([0, 0], |[low, high], count| [low + count[0], high + count[1]]);
        all.map(|count| if self.is_closed { count.max(LEAST_AROUND) } else { count })
    }

    /// How many triangles a corner between these sharp curves may have in all: as many as other vertices, unless it is proven that
    /// no mesh without an angle below `floor`, in degrees, has so many. Then the nearest number that a checker takes, and no other:
    /// none between passes. `seen` are its sectors for a checker. `all` are those between all its curves, which stay: fewer
    /// triangles than these need, a corner never has.
    pub(crate) fn total(
        &self,
        [seen, all]: [&Self; 2],
        interior: &RangeInclusive<u32>,
        floor: f64,
    ) -> RangeInclusive<u32> {
        let [[low, _], [least, most], [needed, _]] =
            [self, seen, all].map(|sectors| sectors.allowed(floor));
        if !self.is_closed {
            return 1..=low.max(MOST_ON_BOUNDARY);
        }
        // At a needle's tip each more makes all of them thinner.
        if self.sectors.len() == 1 && self.sectors[0].angle < f64::from(LEAST_AROUND) * floor {
            return LEAST_AROUND..=LEAST_AROUND;
        }
        if most < *interior.start() && needed <= most {
            return most..=most;
        }
        // Sharp edges that are no curves may go: alone they ask for no more than others have.
        if low > *interior.end() {
            let nearest = least.max(needed);
            return nearest..=nearest;
        }
        interior.clone()
    }
}

/// What the sectors of a vertex make of its degree.
#[derive(Debug, Clone, Copy, Default)]
struct Tally {
    sectors: u32,
    triangles: u32,
    fewer: u32,
    more: u32,
    needed: u32,
    soft: f64,
}

impl Tally {
    fn add(&mut self, kind: Kind, sector: SurfaceSector) {
        let range = if kind == Kind::Curve { sector.range_on_curve() } else { sector.range() };
        self.sectors += 1;
        self.triangles += sector.triangles;
        self.needed += range.start();
        self.fewer += range.start().saturating_sub(sector.triangles);
        self.more += sector.triangles.saturating_sub(*range.end());
        let off = (f64::from(sector.triangles) - sector.angle / 60.0).abs() - 0.5;
        self.soft += off.max(0.0);
    }

    fn degree(&self, is_closed: bool, total: &RangeInclusive<u32>) -> (u32, f64) {
        // Where all sectors together may not have what each needs for good angles, some have fewer.
        let left = self.needed.saturating_sub(*total.end());
        let excess = self.fewer.saturating_sub(left) + self.more;
        // One sector has all the triangles: they do not count twice.
        let excess = match (is_closed, self.sectors) {
            (true, 1) => beyond(self.triangles, total),
            (true, _) => excess + beyond(self.triangles, total),
            (false, _) => excess.max(beyond(self.triangles, total)),
        };
        (excess, self.soft)
    }
}

/// By how much the numbers of triangles in the sectors of a vertex are out of their ranges, and how far from the best ones. `total`: how
/// many there may be in all, off the boundary and on it.
pub(crate) fn degree(
    mesh: &ArrayMesh<OnSurface<'_>>,
    vertex: u32,
    total: [&RangeInclusive<u32>; 2],
) -> (u32, f64) {
    let (mut tally, kind) = (Tally::default(), mesh.vertices[vertex as usize].kind);
    let counts = |t, i| is_of_curve(mesh, t, i);
    let is_closed = each_sector(mesh, vertex, counts, |sector| tally.add(kind, sector));
    tally.degree(is_closed, total[usize::from(!is_closed)])
}

/// Gives the sectors of a vertex between those edges that count, counter-clockwise, from the boundary if it has one. True if closed.
fn each_sector(
    mesh: &ArrayMesh<OnSurface<'_>>,
    vertex: u32,
    counts: impl Fn(u32, usize) -> bool,
    mut give: impl FnMut(SurfaceSector),
) -> bool {
    // Beyond the edge after a triangle, and beyond that before it.
    let beside = |t: u32, i: usize| {
        let triangle = &mesh.triangles[t as usize];
        triangle.neighbours[(triangle.corner(vertex) + i) % 3]
    };
    // Whether an edge that counts lies before each triangle.
    let before = |t: u32| counts(t, (mesh.triangles[t as usize].corner(vertex) + 2) % 3);
    let anchor = mesh.vertices[vertex as usize].anchor;
    let (mut first, mut at) = (None, anchor);
    let is_closed = loop {
        if first.is_none() && before(at) {
            first = Some(at);
        }
        at = beside(at, 1);
        if at == anchor || at == NONE {
            break at == anchor;
        }
    };
    let mut start = anchor;
    if is_closed {
        start = first.unwrap_or(anchor);
    } else {
        while beside(start, 2) != NONE {
            start = beside(start, 2);
        }
    }
    let mut sector = SurfaceSector { angle: 0.0, triangles: 0 };
    at = start;
    loop {
        let corner = mesh.triangles[at as usize].corner(vertex);
        let corners = mesh.corners(at);
        let [x, a, b] = [0, 1, 2].map(|i| corners[(corner + i) % 3]);
        sector.angle += angle(a - x, b - x);
        sector.triangles += 1;
        at = beside(at, 1);
        let is_last = at == start || at == NONE;
        if is_last || before(at) {
            give(sector);
            sector = SurfaceSector { angle: 0.0, triangles: 0 };
        }
        if is_last {
            return is_closed;
        }
    }
}

/// Whether an edge is part of a curve.
fn is_of_curve(mesh: &ArrayMesh<OnSurface<'_>>, t: u32, i: usize) -> bool {
    mesh.triangles[t as usize].labels[i] != CurveLabel::default()
}

/// Whether who knows no curves sees that an edge is of one: it is sharp, on the boundary or between groups.
fn is_seen(mesh: &ArrayMesh<OnSurface<'_>>, t: u32, i: usize) -> bool {
    let surface = &mesh.space.0.surface;
    let normal = |t: u32| {
        let [a, b, c] = mesh.corners(t);
        (b - a).cross(c - a).normalize_or_zero()
    };
    let group = |t: u32| surface.group(mesh.triangles[t as usize].patch);
    let other = mesh.triangles[t as usize].neighbours[i];
    other == NONE
        || group(t) != group(other)
        || normal(t).dot(normal(other)) < libm::cos(SHARP.to_radians())
}

fn beyond(count: u32, range: &RangeInclusive<u32>) -> u32 {
    count.saturating_sub(*range.end()).max(range.start().saturating_sub(count))
}

/// The angle between two vectors, in degrees.
pub(crate) fn angle(a: DVec3, b: DVec3) -> f64 {
    libm::atan2(a.cross(b).length(), a.dot(b)).to_degrees()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::work::tests::{mesh, reference};

    fn sectors(angles: &[(f64, u32)], is_closed: bool) -> Sectors {
        let sector = |(angle, triangles): &(f64, u32)| SurfaceSector {
            angle: *angle,
            triangles: *triangles,
        };
        Sectors { sectors: angles.iter().map(sector).collect(), is_closed }
    }

    fn degree_of(found: &Sectors, kind: Kind, total: &RangeInclusive<u32>) -> u32 {
        let mut tally = Tally::default();
        found.sectors.iter().for_each(|sector| tally.add(kind, *sector));
        tally.degree(found.is_closed, total).0
    }

    #[test]
    fn sectors_lie_between_curves() {
        let reference = reference("cube", 2.0);
        let mesh = mesh(&reference);
        for v in 0..mesh.vertices.len() as u32 {
            let found = Sectors::of(&mesh, v);
            let total: u32 = found.sectors.iter().map(|sector| sector.triangles).sum();
            assert_eq!(total, mesh.vertices[v as usize].triangles);
            let (count, each) = match mesh.vertices[v as usize].kind {
                Kind::Fixed => (3, 90.0),
                Kind::Curve => (2, 180.0),
                _ => (1, 360.0),
            };
            assert_eq!(found.sectors.len(), count);
            assert!(found.is_closed && found.sectors.iter().all(|s| (s.angle - each).abs() < 1e-9));
        }
    }

    #[test]
    fn degrees_count_by_sector_and_in_all() {
        let excess = |kind, list: &[(f64, u32)], is_closed| {
            let sectors = sectors(list, is_closed);
            let total = match (kind, is_closed) {
                (Kind::Curve, true) => 5..=7,
                (Kind::Curve, false) => 1..=MOST_ON_BOUNDARY,
                _ => sectors.total([&sectors; 2], &(5..=7), 35.0),
            };
            degree_of(&sectors, kind, &total)
        };
        // On a curve: 2 to 4 triangles on each side, 5 to 7 in all.
        assert_eq!(excess(Kind::Curve, &[(180.0, 3), (180.0, 3)], true), 0);
        assert_eq!(excess(Kind::Curve, &[(180.0, 2), (180.0, 2)], true), 1);
        assert_eq!(excess(Kind::Curve, &[(180.0, 4), (180.0, 4)], true), 1);
        assert_eq!(excess(Kind::Curve, &[(180.0, 1), (180.0, 5)], true), 2);
        // On the boundary at most 5 edges.
        assert_eq!(excess(Kind::Curve, &[(180.0, 4)], false), 0);
        assert_eq!(excess(Kind::Curve, &[(180.0, 5)], false), 1);
        // A reflex corner has 4 triangles, too, and one between five sectors 5.
        assert_eq!(excess(Kind::Fixed, &[(330.0, 4)], false), 0);
        assert_eq!(excess(Kind::Fixed, &[(330.0, 5)], false), 1);
        assert_eq!(excess(Kind::Fixed, &[(60.0, 1); 5], false), 0);
        // The corner of a cube has 5 or 6 triangles, one or two or three in a sector.
        assert_eq!(excess(Kind::Fixed, &[(90.0, 2), (90.0, 2), (90.0, 1)], true), 0);
        assert_eq!(excess(Kind::Fixed, &[(90.0, 1), (90.0, 1), (90.0, 1)], true), 2);
        assert_eq!(excess(Kind::Fixed, &[(90.0, 4), (90.0, 1), (90.0, 1)], true), 1);
        // Eight curves leave no other choice.
        assert_eq!(excess(Kind::Fixed, &[(45.0, 1); 8], true), 0);
        // A pointed tip has what fits, and a needle's no more than there must be.
        assert_eq!([3, 4].map(|n| excess(Kind::Fixed, &[(79.0, n)], true)), [0, 1]);
        assert_eq!(excess(Kind::Fixed, &[(150.0, 4)], true), 0);
    }

    #[test]
    fn corners_have_another_degree_only_where_it_is_proven() {
        let total = |list: &[(f64, u32)], is_closed| {
            let sectors = sectors(list, is_closed);
            sectors.total([&sectors; 2], &(5..=7), 35.0).into_inner()
        };
        // Good angles ask for 8 triangles, 35 degrees for 7 and then 8.
        assert_eq!(total(&[(109.0, 2), (120.0, 2), (168.0, 2), (120.0, 2)], true), (5, 7));
        assert_eq!(total(&[(111.0, 2), (120.0, 2), (168.0, 2), (120.0, 2)], true), (8, 8));
        assert_eq!(total(&[(60.0, 1); 3], true), (3, 3));
        // One sector has room for 5 triangles, but a checker sees three with room for 4.
        let (whole, seen) = (&[(195.0, 4)], &[(75.0, 2), (60.0, 1), (60.0, 1)]);
        assert_eq!((total(whole, true), total(seen, true)), ((5, 7), (4, 4)));
        let of = |sharp: &[(f64, u32)], seen: &[(f64, u32)], all: &[(f64, u32)]| {
            let [sharp, seen, all] = [sharp, seen, all].map(|list| sectors(list, true));
            sharp.total([&seen, &all], &(5..=7), 35.0).into_inner()
        };
        assert_eq!(of(whole, seen, whole), (4, 4));
        // Five sectors between curves have five triangles, whatever a checker sees.
        let narrow = [(60.0, 1), (60.0, 1), (20.0, 1), (20.0, 1), (20.0, 1)];
        assert_eq!(of(&[(60.0, 1); 3], &[(60.0, 1); 3], &narrow), (5, 7));
        // More than 7 only where curves ask for so many, then as many as a checker asks for.
        let [seven, eight, nine] = [7, 8, 9].map(|count| vec![(38.0, 1); count]);
        assert_eq!(of(&seven, &eight, &seven), (5, 7));
        assert_eq!([of(&eight, &nine, &eight), of(&eight, &eight, &nine)], [(9, 9); 2]);
        // A sector of 20 degrees has a triangle, too.
        assert_eq!(total(&[(71.0, 1), (20.0, 1), (71.0, 1)], true), (5, 7));
        assert_eq!(total(&[(109.0, 2), (20.0, 1), (150.0, 2)], false), (1, 4));
        assert_eq!(total(&[(111.0, 2), (20.0, 1), (150.0, 2)], false), (1, 5));
        // One sector may do with one triangle less then, but no more than one.
        let excess = |counts: [u32; 4]| {
            let angles = [109.0, 120.0, 168.0, 120.0];
            let list: Vec<(f64, u32)> = angles.into_iter().zip(counts).collect();
            degree_of(&sectors(&list, true), Kind::Fixed, &(5..=7))
        };
        assert_eq!([[2, 2, 2, 2], [1, 2, 2, 2], [1, 1, 2, 2]].map(excess), [1, 0, 1]);
    }

    #[test]
    fn curves_that_turn_little_divide_no_sectors_for_the_proof() {
        let reference = reference("cube", 2.0);
        let mut mesh = mesh(&reference);
        let inside = mesh.vertices.iter().position(|v| v.kind == Kind::Free).unwrap() as u32;
        let mut star = Vec::new();
        mesh.star(inside, &mut star);
        for t in [star[0], star[2]] {
            let triangle = mesh.triangles[t as usize];
            let other = triangle.vertices[(triangle.corner(inside) + 1) % 3];
            mesh.lock(inside, other, CurveLabel(0)).unwrap();
        }
        assert_eq!(Sectors::of(&mesh, inside).sectors.len(), 2);
        assert_eq!(Sectors::sharp(&mesh, inside).sectors.len(), 1);
        let corner = mesh.vertices.iter().position(|v| v.kind == Kind::Fixed).unwrap() as u32;
        assert_eq!(Sectors::sharp(&mesh, corner).sectors.len(), 3);
        // Sharp edges of no curve do so for a checker alone.
        mesh.triangles.iter_mut().for_each(|triangle| triangle.labels = [CurveLabel::default(); 3]);
        assert_eq!(
            [Sectors::sharp(&mesh, corner), Sectors::seen(&mesh, corner)]
                .map(|it| it.sectors.len()),
            [1, 3]
        );
    }

    #[test]
    fn sectors_allow_what_their_angles_do() {
        // The corner of a cube; eight curves; a tip.
        assert_eq!(sectors(&[(90.0, 1); 3], true).allowed(35.0), [3, 6]);
        assert_eq!(sectors(&[(45.0, 1); 8], true).allowed(35.0), [8, 8]);
        assert_eq!(sectors(&[(79.0, 3)], true).allowed(35.0), [3, 3]);
        assert_eq!(sectors(&[(30.0, 1), (180.0, 3)], true).allowed(35.0), [3, 6]);
        assert_eq!(sectors(&[(180.0, 3)], false).allowed(36.0), [2, 5]);
    }

    #[test]
    fn limits_are_those_of_equal_angles() {
        for (angle, limit) in
            [(90.0, 45.0), (25.0, 25.0), (120.0, 60.0), (60.0, 60.0), (150.0, 52.5)]
        {
            let found = sectors(&[(angle, 1), (180.0, 3)], true).limit();
            assert!((found - limit).abs() < 1e-9, "{angle}: {found}");
        }
    }
}
