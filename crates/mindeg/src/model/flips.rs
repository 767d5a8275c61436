//! Fewer edges at crowded vertices of a face that is no polygon, by flips: the windows of the solver take polygons alone.
//!
//! Limits: flips one by one end where none of them is better.

use std::collections::BTreeMap;

use mindeg_exact::Cost;
use mindeg_mesh::planar::{orientation, passes};

use super::face::PlaneFace;

/// The triangles of a face after flips at crowded places that lower the cost, if there are any, and the steps of work.
/// `chords` are those at each place; `is_crowded` takes a place and a number of chords.
pub(super) fn improved(
    face: &PlaneFace,
    triangles: &[[u32; 3]],
    mut chords: Vec<u32>,
    cost: &impl Cost,
    is_crowded: impl Fn(u32, u32) -> bool,
) -> (Option<Vec<[u32; 3]>>, u64) {
    let mut left: BTreeMap<[u32; 2], u32> = BTreeMap::new();
    for &[a, b, c] in triangles {
        left.extend([([a, b], c), ([b, c], a), ([c, a], b)]);
    }
    let mut fixed: Vec<[u32; 2]> = face.boundary.segments().to_vec();
    fixed.iter_mut().for_each(|ends| ends.sort_unstable());
    fixed.sort_unstable();
    let is_allowed = |corners: [u32; 3]| {
        let [a, b, c] = corners.map(|place| face.boundary.point(place));
        orientation(a, b, c) > 0.0
            && !passes([a, b], c)
            && !passes([b, c], a)
            && !passes([c, a], b)
            && cost.triangle([a, b, c]).is_some()
    };
    let (mut steps, mut is_changed) = (0, false);
    for place in 0..chords.len() as u32 {
        // Each flip takes a chord of the place, so they come to an end.
        while is_crowded(place, chords[place as usize]) {
            let change = |place: u32, by: i32| {
                let before = chords[place as usize];
                let after = before.saturating_add_signed(by);
                i64::from(cost.vertex(place, after)) - i64::from(cost.vertex(place, before))
            };
            let mut best: Option<(i64, [u32; 3])> = None;
            for (&[_, to], &c) in left.range([place, 0]..=[place, u32::MAX]) {
                steps += 1;
                let Some(&d) = left.get(&[to, place]) else { continue };
                let gain = change(place, -1) + change(to, -1) + change(c, 1) + change(d, 1);
                if gain < best.map_or(0, |best| best.0)
                    && fixed.binary_search(&[place.min(to), place.max(to)]).is_err()
                    && is_allowed([place, d, c])
                    && is_allowed([d, to, c])
                {
                    best = Some((gain, [to, c, d]));
                }
            }
            let Some((_, [to, c, d])) = best else { break };
            left.remove(&[place, to]);
            left.remove(&[to, place]);
            left.extend([([place, d], c), ([d, c], place), ([c, place], d)]);
            left.extend([([d, to], c), ([to, c], d), ([c, d], to)]);
            for (place, by) in [(place, -1), (to, -1), (c, 1), (d, 1)] {
                chords[place as usize] = chords[place as usize].saturating_add_signed(by);
            }
            is_changed = true;
        }
    }
    let first = |(&[a, b], &c): (&[u32; 2], &u32)| (a < b && a < c).then_some([a, b, c]);
    (is_changed.then(|| left.iter().filter_map(first).collect()), steps)
}
