//! A tree of boxes around triangles or edges.

use glam::DVec3;

use crate::Bounds;

/// Boxes to a leaf: a few boxes are tested faster than split.
const LEAF: usize = 8;

/// A binary tree of boxes: each node has the box around its share of the boxes.
pub(crate) struct Tree {
    boxes: Vec<Bounds<DVec3>>,
    /// The boxes, leaf by leaf.
    order: Vec<u32>,
    /// The box around each node's range of `order`; the children of node i are 2i + 1 and 2i + 2.
    parts: Vec<Bounds<DVec3>>,
}

const NOTHING: Bounds<DVec3> = Bounds { min: DVec3::INFINITY, max: DVec3::NEG_INFINITY };

impl Tree {
    pub(crate) fn new(boxes: Vec<Bounds<DVec3>>) -> Self {
        let mut order: Vec<u32> = (0..boxes.len() as u32).collect();
        let levels = boxes.len().div_ceil(LEAF).next_power_of_two();
        let mut parts = vec![NOTHING; 2 * levels - 1];
        split(&boxes, &mut order, &mut parts, 0);
        Self { boxes, order, parts }
    }

    /// Appends the boxes that meet the box `of`, itself included.
    pub(crate) fn meet(&self, of: u32, found: &mut Vec<u32>) {
        let own = self.boxes[of as usize];
        // Depth first: a stack of nodes, with their ranges in `order`.
        let mut stack = vec![(0, 0..self.order.len())];
        while let Some((part, range)) = stack.pop() {
            if !meet(self.parts[part], own) {
                continue;
            }
            if range.len() <= LEAF || 2 * part + 2 >= self.parts.len() {
                let boxes = self.order[range].iter();
                found.extend(boxes.filter(|&&other| meet(self.boxes[other as usize], own)));
            } else {
                let middle = range.start + range.len() / 2;
                stack.push((2 * part + 1, range.start..middle));
                stack.push((2 * part + 2, middle..range.end));
            }
        }
    }
}

fn meet(a: Bounds<DVec3>, b: Bounds<DVec3>) -> bool {
    a.min.cmple(b.max).all() && b.min.cmple(a.max).all()
}

/// Sorts the boxes of a node into its two children, and sets the boxes around it and them. The
/// depth is the logarithm of the number of boxes.
fn split(boxes: &[Bounds<DVec3>], order: &mut [u32], parts: &mut [Bounds<DVec3>], part: usize) {
    let around = order.iter().map(|&of| boxes[of as usize]).fold(NOTHING, Bounds::union);
    parts[part] = around;
    if order.len() <= LEAF || 2 * part + 2 >= parts.len() {
        return;
    }
    let extent = around.size();
    let axis = if extent.x >= extent.y && extent.x >= extent.z {
        0
    } else if extent.y >= extent.z {
        1
    } else {
        2
    };
    let middle = |of: u32| {
        let Bounds { min, max } = boxes[of as usize];
        0.5 * min[axis] + 0.5 * max[axis]
    };
    let half = order.len() / 2;
    order.select_nth_unstable_by(half, |&a, &b| middle(a).total_cmp(&middle(b)).then(a.cmp(&b)));
    let (low, high) = order.split_at_mut(half);
    split(boxes, low, parts, 2 * part + 1);
    split(boxes, high, parts, 2 * part + 2);
}
