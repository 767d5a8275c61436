//! The stretches of a boundary that were asked to be open water, and which of them are.

use crate::domain::Domain;
use glam::DVec2;
use std::collections::BTreeSet;
use std::ops::Range;

/// Why an edge is to be open water.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Asked {
    /// It is on the box.
    pub(crate) is_of_box: bool,
    /// Its side was named, or it is between two given points.
    pub(crate) by_place: bool,
    /// Its side is open water already.
    pub(crate) is_given: bool,
}

impl Asked {
    pub(crate) fn is_open(self) -> bool {
        self.is_of_box || self.by_place || self.is_given
    }
}

/// A stretch of the boundary that was asked to be open water.
#[derive(Clone, Debug, PartialEq)]
pub struct Opening {
    /// Its length, in the unit of the coordinates.
    pub length: f64,
    /// Where it begins and ends, counter-clockwise along the outer boundary; in degrees if the domain was projected.
    pub ends: [DVec2; 2],
    /// Whether it is open water. It is land otherwise.
    pub is_open: bool,
}

/// The stretches that are asked to be open. Of these, the ones shorter than a length are to be land, and asked no more; without a
/// length, all of the box but its longest, whatever else is asked. What is open already stays so.
pub(crate) fn openings(
    domain: &Domain,
    asked: &mut [Asked],
    least_length: Option<f64>,
) -> Vec<Opening> {
    let rings = domain.rings();
    let point = |vertex: u32| domain.placement().point(vertex);
    let told = |at: DVec2| domain.projection().map_or(at, |projection| projection.to_degrees(at));
    let length_of = |stretch: &[u32]| -> f64 {
        let length = |edge: &u32| point(*edge).distance(point(rings.next(*edge)));
        stretch.iter().map(length).sum()
    };
    let mut longest: (f64, Vec<u32>) = (0.0, Vec::new());
    for range in rings.rings() {
        for stretch in stretches(range, |edge| asked[edge as usize].is_of_box) {
            let length = length_of(&stretch);
            if asked[stretch[0] as usize].is_of_box && length > longest.0 {
                longest = (length, stretch);
            }
        }
    }
    let longest: BTreeSet<u32> = longest.1.into_iter().collect();
    // With a length, stretches are as long as all that is asked together.
    let opens = |edge: u32| {
        let own = asked[edge as usize];
        own.by_place || own.is_given || least_length.is_some() || longest.contains(&edge)
    };
    let mut found: Vec<(Vec<u32>, Opening)> = Vec::new();
    for range in rings.rings() {
        let count = range.len();
        for stretch in stretches(range, |edge| (asked[edge as usize].is_open(), opens(edge))) {
            let (first, last) = (stretch[0], stretch[stretch.len() - 1]);
            if !asked[first as usize].is_open() {
                continue;
            }
            let length = length_of(&stretch);
            let ends = [first, rings.next(last)].map(|end| told(point(end)));
            // The whole ring has no ends between which it could be land.
            let is_whole = stretch.len() == count;
            let stays = || stretch.iter().any(|edge| asked[*edge as usize].is_given);
            let is_long = least_length.is_none_or(|least| length >= least);
            let is_open = opens(first) && (is_long || is_whole || stays());
            found.push((stretch, Opening { length, ends, is_open }));
        }
    }
    for (stretch, _) in found.iter().filter(|(_, opening)| !opening.is_open) {
        stretch.iter().for_each(|edge| asked[*edge as usize] = Asked::default());
    }
    found.into_iter().map(|(_, opening)| opening).collect()
}

/// The edges of a ring in runs with one state each; a run over the ring's start is whole.
fn stretches<T: PartialEq>(ring: Range<u32>, state: impl Fn(u32) -> T) -> Vec<Vec<u32>> {
    let mut edges: Vec<u32> = ring.collect();
    let begins = edges.windows(2).position(|pair| state(pair[0]) != state(pair[1]));
    edges.rotate_left(begins.map_or(0, |at| at + 1));
    edges.chunk_by(|a, b| state(*a) == state(*b)).map(<[u32]>::to_vec).collect()
}
