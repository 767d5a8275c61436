//! A tree of boxes around triangles.

use glam::DVec3;

/// Triangles to a leaf: a few boxes are tested faster than split.
const LEAF: usize = 8;

/// Triangles in halves, quarters and so on, each part with the box around it.
pub(super) struct Tree {
    /// The box of each triangle.
    boxes: Vec<[DVec3; 2]>,
    /// The triangles, leaf by leaf.
    order: Vec<u32>,
    /// The box around each part of `order`: halves of part i are the parts 2i + 1 and 2i + 2.
    parts: Vec<[DVec3; 2]>,
}

const NOTHING: [DVec3; 2] = [DVec3::INFINITY, DVec3::NEG_INFINITY];

impl Tree {
    pub(super) fn new(positions: &[DVec3], triangles: &[[u32; 3]]) -> Self {
        let around = |corners: &[u32; 3]| {
            let [a, b, c] = corners.map(|vertex| positions[vertex as usize]);
            [a.min(b).min(c), a.max(b).max(c)]
        };
        let boxes: Vec<[DVec3; 2]> = triangles.iter().map(around).collect();
        let mut order: Vec<u32> = (0..triangles.len() as u32).collect();
        let levels = triangles.len().div_ceil(LEAF).next_power_of_two();
        let mut parts = vec![NOTHING; 2 * levels - 1];
        split(&boxes, &mut order, &mut parts, 0);
        Self { boxes, order, parts }
    }

    /// Appends the triangles whose boxes meet that of a triangle, itself included.
    pub(super) fn meet(&self, triangle: u32, found: &mut Vec<u32>) {
        let own = self.boxes[triangle as usize];
        // Depth first: a stack of parts, with their ranges in `order`.
        let mut stack = vec![(0, 0..self.order.len())];
        while let Some((part, range)) = stack.pop() {
            if !meet(self.parts[part], own) {
                continue;
            }
            if range.len() <= LEAF || 2 * part + 2 >= self.parts.len() {
                let triangles = self.order[range].iter();
                found.extend(triangles.filter(|&&other| meet(self.boxes[other as usize], own)));
            } else {
                let middle = range.start + range.len() / 2;
                stack.push((2 * part + 1, range.start..middle));
                stack.push((2 * part + 2, middle..range.end));
            }
        }
    }
}

fn meet([a_min, a_max]: [DVec3; 2], [b_min, b_max]: [DVec3; 2]) -> bool {
    a_min.cmple(b_max).all() && b_min.cmple(a_max).all()
}

/// Sorts the triangles of a part into its halves, and sets its box and theirs. The depth is the
/// logarithm of their number.
fn split(boxes: &[[DVec3; 2]], order: &mut [u32], parts: &mut [[DVec3; 2]], part: usize) {
    let around = order.iter().fold(NOTHING, |[min, max], &triangle| {
        let [own_min, own_max] = boxes[triangle as usize];
        [min.min(own_min), max.max(own_max)]
    });
    parts[part] = around;
    if order.len() <= LEAF || 2 * part + 2 >= parts.len() {
        return;
    }
    let extent = around[1] - around[0];
    let axis = if extent.x >= extent.y && extent.x >= extent.z {
        0
    } else if extent.y >= extent.z {
        1
    } else {
        2
    };
    let middle = |triangle: u32| {
        let [min, max] = boxes[triangle as usize];
        0.5 * min[axis] + 0.5 * max[axis]
    };
    let half = order.len() / 2;
    order.select_nth_unstable_by(half, |&a, &b| middle(a).total_cmp(&middle(b)).then(a.cmp(&b)));
    let (low, high) = order.split_at_mut(half);
    split(boxes, low, parts, 2 * part + 1);
    split(boxes, high, parts, 2 * part + 2);
}
