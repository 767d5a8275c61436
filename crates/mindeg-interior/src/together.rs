//! Degree limits that exclude each other while angles stay.
//!
//! At one vertex the sectors between frozen edges may get by with few triangles, and still not all of several vertices: a sector of one triangle
//! is cut off by the edge opposite, and so the sectors beside it need more. If all triangles at a vertex have at least an angle, a sector there has
//! at least as many triangles as its fan ([`limits`](crate::limits)) needs for that. With the triangle on the frozen edge between two sectors,
//! whose apex is somewhere ([`edge_limits`](crate::edge_limits)), only some pairs of numbers are possible; and behind a sector of one triangle the
//! same holds for the edge that cuts it off. So the sectors of a group of vertices, face by face and in a row, have a least
//! number of triangles in all, which a dynamic program finds. Where that is above the sum of the degree limits, no mesh keeps them all.
//!
//! The angles are a share of those that a mesh has at the group and at the other ends of its frozen edges: what is proven is that degrees
//! get no lower unless angles there do. It is proven up to rounding.

use crate::edge_limits::{Ear, Place, apart, cut_off, fewest_of_fan};
use crate::star::{Sector, Stars};
use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::PI;

/// The shares of the angles at hand that a mesh must have: the first that a proof takes counts.
const SHARES: [f64; 4] = [0.25, 0.5, 0.75, 0.95];
/// Larger groups are not tried.
const MOST_VERTICES: usize = 4;
/// With more vertices above their limits, the search has more to do than proofs have to excuse.
const MOST_PLACES: usize = 32;
/// This number of triangles stands for more, too.
const MANY: u32 = 9;
/// Boxes of angles that are smaller are not divided further, in radians.
const SMALL: f64 = 2e-3;
/// So many boxes are looked at for one edge; of the rest no more is known than what their bounds are.
const MOST_BOXES: usize = 8000;

/// The numbers of triangles on both sides of an edge: all that are possible are, each for itself, at least those of one of these.
type Least = Vec<[u32; 2]>;

/// A sector: its vertex, and the index there.
type Name = (u32, usize);

/// The facts about the vertices that stay.
pub(crate) struct Together<'a> {
    stars: &'a Stars,
    /// The angle in degrees that all triangles at each vertex have, and the share of it that is asked for.
    angles: &'a [f64],
    share: f64,
    /// The numbers of triangles that vertices have, and those that they may have.
    counts: &'a [u32],
    limits: &'a [u32],
    /// The least found for the edge from each sector to the next one, and for the edge that cuts a sector off.
    pairs: BTreeMap<Name, Least>,
    ears: BTreeMap<Name, Least>,
}

impl<'a> Together<'a> {
    pub(crate) fn new(
        stars: &'a Stars,
        angles: &'a [f64],
        counts: &'a [u32],
        limits: &'a [u32],
    ) -> Self {
        let (pairs, ears) = (BTreeMap::new(), BTreeMap::new());
        Self { stars, angles, share: 1.0, counts, limits, pairs, ears }
    }

    /// Groups of vertices that are above their limits by no more, in all, than in any mesh with this share of the angles.
    pub(crate) fn groups(mut self) -> Vec<(BTreeSet<u32>, f64)> {
        let mut found: Vec<(BTreeSet<u32>, f64)> = Vec::new();
        let all = 0..self.counts.len() as u32;
        let above: Vec<u32> = all.filter(|v| self.excess(*v) > 0).collect();
        let shares = if above.len() > MOST_PLACES { &[] } else { &SHARES[..] };
        for share in shares {
            (self.share, self.pairs, self.ears) = (*share, BTreeMap::new(), BTreeMap::new());
            for vertex in &above {
                if !found.iter().any(|(group, _)| group.contains(vertex)) {
                    found.extend(self.group_of(*vertex).map(|group| (group, *share)));
                }
            }
        }
        found
    }

    /// By how many triangles a vertex is above its limit.
    fn excess(&self, vertex: u32) -> u32 {
        self.counts[vertex as usize].saturating_sub(self.limits[vertex as usize])
    }

    /// A group round a vertex, which grows by the neighbour that leaves least unproven.
    fn group_of(&mut self, vertex: u32) -> Option<BTreeSet<u32>> {
        let mut group = BTreeSet::from([vertex]);
        while self.unproven(&group) > 0 {
            if group.len() == MOST_VERTICES {
                return None;
            }
            let near: BTreeSet<u32> = group.iter().flat_map(|v| self.stars.ends(*v)).collect();
            let known = |v: &&u32| (**v as usize) < self.counts.len();
            let near: Vec<u32> = near.difference(&group).filter(known).copied().collect();
            let tried = near.iter().map(|v| {
                let with: BTreeSet<u32> = group.iter().copied().chain([*v]).collect();
                (self.unproven(&with), with)
            });
            group = tried.min_by_key(|tried| tried.0)?.1;
        }
        Some(group)
    }

    /// The excess of a group that its sectors do not prove.
    fn unproven(&mut self, group: &BTreeSet<u32>) -> i64 {
        let sum = |of: &dyn Fn(u32) -> u32| group.iter().map(|v| i64::from(of(*v))).sum::<i64>();
        let (has, limit) = (sum(&|v| self.excess(v)), sum(&|v| self.limits[v as usize]));
        has + limit - i64::from(self.least(group))
    }

    /// The least number of triangles in all sectors of a group.
    fn least(&mut self, group: &BTreeSet<u32>) -> u32 {
        let stars = self.stars;
        let mut left: BTreeSet<Name> =
            group.iter().flat_map(|&v| (0..stars.at(v).len()).map(move |i| (v, i))).collect();
        let mut sum = 0;
        while let Some(&name) = left.first() {
            // Back to the first sector of the row, or once round a face.
            let mut first = name;
            while let Some(before) = self.before(first).filter(|own| left.contains(own)) {
                if before == name {
                    break;
                }
                first = before;
            }
            let mut row = Vec::new();
            let mut next = Some(first);
            while let Some(name) = next.filter(|name| left.remove(name)) {
                row.push(name);
                next = self.after(name);
            }
            sum += self.least_of_row(&row);
        }
        sum
    }

    /// The least number of triangles in sectors in a row along a face, whatever the sectors at its ends have.
    fn least_of_row(&mut self, row: &[Name]) -> u32 {
        let ends = [self.before(row[0]), self.after(row[row.len() - 1])];
        let [Some(before), Some(after)] = ends else { return 0 };
        let all: Vec<Name> =
            [before].into_iter().chain(row.iter().copied()).chain([after]).collect();
        let fewest: Vec<u32> = all.iter().map(|name| self.fewest(*name)).collect();
        let counts = |i: usize| fewest[i]..=MANY;
        // The least number so far by the numbers of the last two sectors.
        let mut least: BTreeMap<[u32; 2], u32> = BTreeMap::new();
        for (i, name) in all.iter().enumerate().skip(1) {
            let counted = |count: u32| if i + 1 < all.len() { count } else { 0 };
            let pair = self.pair(all[i - 1]);
            if i == 1 {
                let both = counts(0).flat_map(|a| counts(1).map(move |b| [a, b]));
                least = both.filter(|own| allows(&pair, *own)).map(|own| (own, own[1])).collect();
                continue;
            }
            let ear = self.ear(all[i - 1], [all[i - 2], *name]);
            let mut longer: BTreeMap<[u32; 2], u32> = BTreeMap::new();
            for ([a, b], sum) in &least {
                for c in counts(i) {
                    if allows(&pair, [*b, c]) && (*b > 1 || allows(&ear, [*a, c])) {
                        let sum = sum + counted(c);
                        longer.entry([*b, c]).and_modify(|own| *own = sum.min(*own)).or_insert(sum);
                    }
                }
            }
            least = longer;
        }
        least.into_values().min().unwrap_or(0)
    }

    fn sector(&self, (vertex, index): Name) -> Sector {
        self.stars.at(vertex)[index]
    }

    fn angle(&self, (vertex, _): Name) -> f64 {
        // Of a vertex of which nothing is known, nothing is asked.
        let angle = self.angles.get(vertex as usize).copied().unwrap_or(0.0);
        self.share * angle * (PI / 180.0)
    }

    /// The sector that is next along the face, at the other end of the last edge.
    fn after(&self, name: Name) -> Option<Name> {
        let other = self.sector(name).ends[1];
        let index = self.stars.at(other).iter().position(|own| own.ends[0] == name.0)?;
        Some((other, index))
    }

    fn before(&self, name: Name) -> Option<Name> {
        let other = self.sector(name).ends[0];
        let index = self.stars.at(other).iter().position(|own| own.ends[1] == name.0)?;
        Some((other, index))
    }

    /// The fewest triangles that a sector takes by itself.
    fn fewest(&self, name: Name) -> u32 {
        let Sector { angle, lengths: [a, b], least, .. } = self.sector(name);
        let fan = fewest_of_fan([angle; 2], [a.max(b) / a.min(b); 2], self.angle(name), MANY);
        least.max(fan.unwrap_or(1))
    }

    /// The least numbers of a sector and the next one.
    fn pair(&mut self, name: Name) -> Least {
        if let Some(known) = self.pairs.get(&name) {
            return known.clone();
        }
        let Some(after) = self.after(name) else { return vec![[1, 1]] };
        let [one, other] = [name, after].map(|name| self.sector(name));
        let place = Place {
            angles: [one.angle, other.angle],
            length: one.lengths[1],
            next: [one.lengths[0], other.lengths[1]],
        };
        // A face of three edges may be one triangle.
        let found = match one.ends[0] == other.ends[1] {
            true => vec![[1, 1]],
            false => place.least([name, after].map(|name| self.angle(name))),
        };
        self.pairs.insert(name, found.clone());
        found
    }

    /// The least numbers of the sectors beside one of a single triangle; none where that cannot be.
    fn ear(&mut self, name: Name, beside: [Name; 2]) -> Least {
        if let Some(known) = self.ears.get(&name) {
            return known.clone();
        }
        let found = self.behind(name, beside);
        self.ears.insert(name, found.clone());
        found
    }

    fn behind(&self, name: Name, beside: [Name; 2]) -> Least {
        let (own, [one, other]) = (self.sector(name), beside.map(|name| self.sector(name)));
        if own.angle >= PI || one.vertex == other.vertex {
            return Vec::new();
        }
        if one.ends[0] == other.vertex {
            return vec![[1, 1]];
        }
        let (corners, length) = cut_off(own.angle, own.lengths);
        let kept = beside.map(|name| self.angle(name));
        let most = kept[0].max(kept[1]).max(self.angle(name));
        if corners[0].min(corners[1]).min(own.angle) < most {
            return Vec::new();
        }
        let place = Place {
            angles: [one.angle - corners[0], other.angle - corners[1]],
            length,
            next: [one.lengths[0], other.lengths[1]],
        };
        if place.angles[0] <= 0.0 || place.angles[1] <= 0.0 {
            return Vec::new();
        }
        let found = match one.ends[0] == other.ends[1] {
            true => vec![[1, 1]],
            false => place.least(kept),
        };
        found.into_iter().map(|counts| counts.map(|count| count + 1)).collect()
    }
}

/// Whether numbers are at least those of one of these.
fn allows(least: &Least, [a, b]: [u32; 2]) -> bool {
    least.iter().any(|own| own[0].min(MANY) <= a && own[1].min(MANY) <= b)
}

impl Place {
    /// The least numbers of triangles in both sectors if all at each end have these angles.
    fn least(&self, kept: [f64; 2]) -> Least {
        let both = kept[0].max(kept[1]);
        let mut found = Least::new();
        for end in 0..2 {
            let ear = self.ear(end).filter(|ear| ear.least >= both);
            let fan = ear.and_then(|Ear { left, ratio, .. }| {
                let ratio = ratio.max(1.0 / ratio);
                fewest_of_fan([left; 2], [ratio; 2], kept[1 - end], MANY)
            });
            let counts = |fan: u32| if end == 0 { [1, 1 + fan] } else { [1 + fan, 1] };
            found.extend(fan.map(counts));
        }
        let mut boxes = vec![self.angles.map(|angle| [both, angle.min(PI)])];
        let mut seen = 0;
        while let Some(sides) = boxes.pop() {
            let widths = sides.map(|[low, high]| high - low);
            let Some(bound) = self.counts(sides, kept) else { continue };
            if allows(&found, bound) {
                continue;
            }
            seen += 1;
            if seen > MOST_BOXES || widths[0].max(widths[1]) < SMALL {
                found.push(bound);
                continue;
            }
            let middles = sides.map(|[low, high]| f64::midpoint(low, high));
            found.extend(self.counts(middles.map(|middle| [middle; 2]), kept));
            let longer = usize::from(widths[1] > widths[0]);
            for half in 0..2 {
                let mut part = sides;
                part[longer][1 - half] = middles[longer];
                boxes.push(part);
            }
        }
        found
    }

    /// No apex seen under these angles has fewer triangles in one of the sectors; `None` if none has the angles.
    fn counts(&self, [first, second]: [[f64; 2]; 2], kept: [f64; 2]) -> Option<[u32; 2]> {
        let both = kept[0].max(kept[1]);
        if first[1] < both || second[1] < both || PI - first[0] - second[0] < both {
            return None;
        }
        let mut counts = [1; 2];
        for end in 0..2 {
            let [own, other] = if end == 0 { [first, second] } else { [second, first] };
            let left = [self.angles[end] - own[1], self.angles[end] - own[0]];
            let lengths = apart(&own, &other).map(|length| length * self.length / self.next[end]);
            counts[end] += fewest_of_fan(left, lengths, kept[end], MANY)?;
        }
        Some(counts)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::breaklines::Breaklines;
    use crate::limits::fan_limit;
    use crate::options::Options;
    use crate::triangle::min_angle;
    use crate::{generate, samples};
    use glam::DVec2;
    use mindeg_mesh::Progress;
    use mindeg_mesh::planar::PlanarBoundary;

    #[test]
    fn no_apex_leaves_fewer_triangles_on_both_sides() {
        let (mut tight, mut blocked) = (0, 0);
        for i in 0..40 {
            let of = |prime: f64| libm::fmod(f64::from(i) * prime, 1.0);
            let place = Place {
                angles: [0.6 + 2.4 * of(0.37), 0.6 + 2.4 * of(0.61)],
                length: 1.0,
                next: [0.2 + 3.0 * of(0.23), 0.2 + 3.0 * of(0.83)],
            };
            let kept = [0.1 + 0.4 * of(0.47), 0.1 + 0.4 * of(0.71)];
            let least = place.least(kept);
            let mut seen = BTreeSet::new();
            for j in 0..160 * 160 {
                let (x, y) = (f64::from(j % 160) / 40.0 - 1.5, f64::from(j / 160 + 1) / 60.0);
                let angles = [libm::atan2(y, x), libm::atan2(y, 1.0 - x)];
                let third = PI - angles[0] - angles[1];
                if angles[0].min(angles[1]).min(third) < kept[0].max(kept[1]) {
                    continue;
                }
                let spokes = [libm::hypot(x, y), libm::hypot(1.0 - x, y)];
                let fan = |end: usize| {
                    let left = place.angles[end] - angles[end];
                    let reaches = |k: &u32| {
                        let limit = fan_limit(left, spokes[end], place.next[end], Some(*k));
                        left > 0.0 && limit >= kept[end].to_degrees()
                    };
                    (1..MANY).find(reaches)
                };
                if let (Some(a), Some(b)) = (fan(0), fan(1)) {
                    assert!(allows(&least, [1 + a, 1 + b]), "{i}: {a} {b} {least:?}");
                    seen.insert([1 + a, 1 + b]);
                }
            }
            tight += usize::from(least.iter().any(|own| seen.contains(own)));
            blocked += usize::from(!allows(&least, [2, 2]));
        }
        assert!(tight > 10 && blocked > 5, "{tight} {blocked}");
    }

    #[test]
    fn no_group_has_fewer_triangles_than_are_proven() {
        let mut more_than_alone = 0;
        for intervals in [[1, 3, 2, 9], [7, 1, 5, 2], [4, 12, 1, 3], [2, 2, 11, 1]] {
            let outline = samples::rectangle(4.0, 3.0, intervals);
            let found = generate(&outline, &Options::default(), Progress::NONE).unwrap();
            let of = outline.points().len();
            let (mut counts, mut angles) = (vec![0; of], vec![60.0_f64; of]);
            for triangle in &found.triangles {
                let angle = min_angle(triangle.map(|v| found.points[v as usize]));
                for v in triangle.iter().map(|v| *v as usize).filter(|v| *v < of) {
                    counts[v] += 1;
                    angles[v] = angles[v].min(angle);
                }
            }
            let stars = Stars::new(&outline, &Breaklines::default());
            let mut together = Together::new(&stars, &angles, &counts, &counts);
            together.share = 1.0 - 1e-9;
            for first in 0..of {
                for length in 1..=4 {
                    let group: BTreeSet<u32> =
                        (first..first + length).map(|v| (v % of) as u32).collect();
                    let has: u32 = group.iter().map(|v| counts[*v as usize]).sum();
                    let least = together.least(&group);
                    assert!(least <= has, "{intervals:?} {group:?}: {least} {has}");
                    let alone: u32 = group.iter().map(|v| together.fewest((*v, 0))).sum();
                    more_than_alone += usize::from(least > alone);
                }
            }
        }
        assert!(more_than_alone > 50, "{more_than_alone}");
    }

    /// Four kites that meet at a point: where no edge cuts their corners there off, all have two triangles.
    #[test]
    fn corners_that_no_edge_cuts_off_have_two_triangles() {
        // Of the tip beside the others: 33.7 degrees, and 56.3.
        for (inner, more) in [(0.4, 1), (0.6, 0)] {
            let turned = |p: DVec2| [p, p.perp(), -p, -p.perp()];
            let (tips, sides) = (turned(DVec2::X), turned(DVec2::splat(inner)));
            let ring: Vec<DVec2> =
                (0..8).map(|i| if i % 2 == 0 { tips[i / 2] } else { sides[i / 2] }).collect();
            let outline = PlanarBoundary::new(&[ring]).unwrap();
            let edges = (0..4).map(|i| [2 * i, 8]).collect();
            let lines = Breaklines { points: vec![DVec2::ZERO], edges };
            let stars = Stars::new(&outline, &lines);
            let (counts, mut limits) = ([4, 3, 4, 3, 4, 3, 4, 3, 8], [4; 9]);
            limits[8] = 7;
            let groups = Together::new(&stars, &[10.0; 9], &counts, &limits).groups();
            assert_eq!(groups.len(), more, "{inner}: {groups:?}");
            assert!(groups.iter().all(|own| own.0.contains(&8) && own.1 == 0.25), "{groups:?}");
        }
    }
}
