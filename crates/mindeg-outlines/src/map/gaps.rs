//! Gaps between regions that are far longer than wide, as where a border was drawn twice.

use glam::DVec2;
use mindeg_mesh::number;
use mindeg_mesh::planar::doubled_area;

use super::plane::Plane;
use crate::curve::norm;
use crate::error::OutlineError;
use crate::overlay::crossings::MOST_COMPARISONS;
use crate::overlay::edge::Step;
use crate::text::shown;

/// Whatever has no region between several and a width that is a smaller share of its length is a gap.
const SLIVER: f64 = 1e-3;

/// Edges that face each other along less than this share of their greatest coordinate do so by rounding.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// A gap between two regions.
pub(super) struct Gap {
    at: DVec2,
    width: f64,
    length: f64,
    regions: [u32; 2],
}

impl Gap {
    /// The gap on the left of a ring, if it lies between several regions.
    pub(super) fn of(plane: &Plane<'_>, steps: &[Step], points: &[DVec2]) -> Option<Self> {
        let regions = || steps.iter().filter_map(|step| plane.right_of(step));
        let first = regions().next()?;
        let regions = [first, regions().find(|&region| region != first)?];
        let ends = points.iter().zip(points.iter().cycle().skip(1));
        let length = ends.map(|(a, b)| a.distance(*b)).sum::<f64>() / 2.0;
        let width = doubled_area(points).abs() / 2.0 / length;
        (width < SLIVER * length).then_some(Self { at: points[0], width, length, regions })
    }

    /// The longer one of two.
    pub(super) fn longer(one: Option<Self>, other: Option<Self>) -> Option<Self> {
        let length = |gap: &Option<Self>| gap.as_ref().map_or(0.0, |gap| gap.length);
        if length(&other) > length(&one) { other } else { one }
    }

    /// The longest gap between two edges of different regions that nothing closes at its ends. O(n log n) where few edges lie
    /// above each other; beyond a limit of comparisons the rest is not looked at.
    pub(super) fn open(plane: &Plane<'_>) -> Option<Self> {
        let bounds = (0..2 * plane.links.len()).filter_map(|half| {
            let region = plane.left(half ^ 1).filter(|_| plane.left(half).is_none())?;
            let ends = plane.links[half / 2].ends.map(|end| plane.points[end as usize]);
            let [a, b] = if half.is_multiple_of(2) { ends } else { [ends[1], ends[0]] };
            Some(Bound::new(region, a, b))
        });
        let mut bounds: Vec<Bound> = bounds.collect();
        bounds.sort_by(|a, b| a.low.x.total_cmp(&b.low.x));
        let (mut longest, mut budget) = (None, MOST_COMPARISONS);
        for (index, one) in bounds.iter().enumerate() {
            for other in bounds[index + 1..].iter().take_while(|other| other.low.x <= one.high.x) {
                budget -= 1;
                if budget == 0 {
                    return longest;
                }
                if one.region != other.region
                    && one.low.y <= other.high.y
                    && other.low.y <= one.high.y
                {
                    longest = Self::longer(longest, one.gap(other));
                    longest = Self::longer(longest, other.gap(one));
                }
            }
        }
        longest
    }

    pub(super) fn error(&self, names: &[String]) -> OutlineError {
        let [one, other] = self.regions.map(|region| &names[region as usize]);
        let problem = format!(
            "a gap {} wide and {} long is between {one} and {other}; --repair --snap {} closes it, --repair \
             alone keeps it",
            number(self.width),
            number(self.length),
            number(2.0 * self.width)
        );
        OutlineError::place(shown(self.at), problem).telling([self.at])
    }
}

/// An edge with a region on its right and none on its left, and the box in which a gap beside it lies.
struct Bound {
    region: u32,
    start: DVec2,
    end: DVec2,
    low: DVec2,
    high: DVec2,
}

impl Bound {
    fn new(region: u32, start: DVec2, end: DVec2) -> Self {
        let reach = SLIVER * norm(end - start);
        let (low, high) = (start.min(end) - reach, start.max(end) + reach);
        Self { region, start, end, low, high }
    }

    /// The gap between this edge and one of another region that faces it, if that is near along some length.
    fn gap(&self, other: &Self) -> Option<Gap> {
        let length = norm(self.end - self.start);
        let along = (self.end - self.start) / length;
        // The other one runs back.
        let [from, to] = [other.end, other.start].map(|end| {
            let span = end - self.start;
            DVec2::new(along.dot(span), along.perp_dot(span))
        });
        let (first, last) = (from.x.max(0.0), to.x.min(length));
        let common = last - first;
        // Edges that end at one point face each other by what rounding leaves.
        let greatest = self.low.abs().max(self.high.abs()).max_element();
        if common <= ROUNDING * greatest {
            return None;
        }
        let across = |x: f64| from.y + (to.y - from.y) * ((x - from.x) / (to.x - from.x));
        let ends = [across(first), across(last)];
        let width = ends[0].max(ends[1]);
        let is_gap = ends.iter().all(|&across| across >= 0.0) && width < SLIVER * common;
        let at = self.start + along * first;
        let regions = [self.region.min(other.region), self.region.max(other.region)];
        is_gap.then_some(Gap { at, width, length: common, regions })
    }
}
