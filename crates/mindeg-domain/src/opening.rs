//! The stretches of a boundary that were asked to be open water, and which of them are.

use crate::domain::Domain;
use glam::DVec2;

/// Why an edge is to be open water.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Asked {
    /// It is on the box.
    pub(crate) is_of_box: bool,
    /// Its side was named, or it is between two given points.
    pub(crate) by_place: bool,
    /// It has no name of its own: it is on the box, or of a stretch whose sides have several names.
    pub(crate) is_nameless: bool,
}

impl Asked {
    pub(crate) fn is_open(self) -> bool {
        self.is_of_box || self.by_place
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
/// length, all of the box alone but the longest.
pub(crate) fn openings(
    domain: &Domain,
    asked: &mut [Asked],
    least_length: Option<f64>,
) -> Vec<Opening> {
    let rings = domain.rings();
    let point = |vertex: u32| domain.placement().point(vertex);
    let told = |at: DVec2| domain.projection().map_or(at, |projection| projection.to_degrees(at));
    let mut found: Vec<(Vec<u32>, Opening)> = Vec::new();
    for range in rings.rings() {
        let mut edges: Vec<u32> = range.clone().collect();
        // From behind an edge that is not open, each stretch comes whole.
        let closed = range.clone().find(|edge| !asked[*edge as usize].is_open());
        edges.rotate_left(closed.map_or(0, |closed| (closed - range.start) as usize));
        let is_open = |edge: &u32| asked[*edge as usize].is_open();
        for stretch in edges.chunk_by(|a, b| is_open(a) == is_open(b)) {
            let (Some(first), Some(last)) = (stretch.first(), stretch.last()) else { continue };
            if !is_open(first) {
                continue;
            }
            let length = |edge: &u32| point(*edge).distance(point(rings.next(*edge)));
            let length = stretch.iter().map(length).sum();
            let ends = [*first, rings.next(*last)].map(|end| told(point(end)));
            // The whole ring has no ends between which it could be land.
            let is_open = closed.is_none() || least_length.is_none_or(|least| length >= least);
            found.push((stretch.to_vec(), Opening { length, ends, is_open }));
        }
    }
    if least_length.is_none() {
        let is_of_box = |stretch: &[u32]| stretch.iter().all(|e| !asked[*e as usize].by_place);
        let of_box = || found.iter().filter(|(stretch, _)| is_of_box(stretch));
        let longest = of_box().map(|(_, opening)| opening.length).fold(0.0, f64::max);
        let first = of_box().find(|(_, opening)| opening.length == longest);
        let first = first.and_then(|(stretch, _)| stretch.first().copied());
        for (stretch, opening) in &mut found {
            opening.is_open = !is_of_box(stretch) || stretch.first().copied() == first;
        }
    }
    for (stretch, opening) in &found {
        let name = |edge: &u32| {
            let name = &domain.sides()[rings.side_of(*edge)].name;
            name.as_ref().filter(|_| !asked[*edge as usize].is_nameless)
        };
        // A stretch is one boundary, by whatever sides it passes.
        let has_one_name = stretch.windows(2).all(|pair| name(&pair[0]) == name(&pair[1]));
        for edge in stretch {
            let own = &mut asked[*edge as usize];
            if opening.is_open {
                own.is_nameless |= !has_one_name;
            } else {
                *own = Asked { is_nameless: own.is_nameless, ..Asked::default() };
            }
        }
    }
    found.into_iter().map(|(_, opening)| opening).collect()
}
