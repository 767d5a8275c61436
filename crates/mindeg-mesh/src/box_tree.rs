//! A tree of boxes around triangles or edges: which boxes meet, and which item is nearest to a point.

use glam::DVec3;

use crate::Bounds;

/// Boxes to a leaf: a few boxes are tested faster than split.
const LEAF: usize = 8;

/// A binary tree over the boxes around items, such as triangles or edges; an item is the index of its box.
///
/// # Example
///
/// ```
/// use glam::DVec3;
/// use mindeg_mesh::{Bounds, BoxTree};
///
/// let points = [DVec3::ZERO, 4.0 * DVec3::X, DVec3::ONE];
/// let tree = BoxTree::new(points.map(|point| Bounds { min: point, max: point }).to_vec());
/// let squared = |item: u32| points[item as usize].distance_squared(DVec3::X);
/// assert_eq!(tree.nearest(DVec3::X, f64::INFINITY, squared), Some((0, 1.0)));
/// assert_eq!(tree.nearest(DVec3::X, 0.5, squared), None);
/// ```
#[derive(Clone, Debug)]
pub struct BoxTree {
    boxes: Vec<Bounds<DVec3>>,
    /// The boxes, leaf by leaf.
    order: Vec<u32>,
    /// The box around each node's range of `order`; the children of node i are 2i + 1 and 2i + 2.
    parts: Vec<Bounds<DVec3>>,
}

const NOTHING: Bounds<DVec3> = Bounds { min: DVec3::INFINITY, max: DVec3::NEG_INFINITY };

/// The most that rounding adds to the distance of a box, as a share: an item never seems nearer than its box.
const ROUNDING: f64 = 1.0 + 1e-12;

impl BoxTree {
    /// The tree over some boxes. O(n log n).
    pub fn new(boxes: Vec<Bounds<DVec3>>) -> Self {
        let mut order: Vec<u32> = (0..boxes.len() as u32).collect();
        let levels = boxes.len().div_ceil(LEAF).next_power_of_two();
        let mut parts = vec![NOTHING; 2 * levels - 1];
        split(&boxes, &mut order, &mut parts, 0);
        Self { boxes, order, parts }
    }

    /// Appends the items whose boxes meet the box `own`, in an order of the tree.
    pub fn meet(&self, own: Bounds<DVec3>, found: &mut Vec<u32>) {
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

    /// Appends the items whose boxes meet the box of the item `of`, itself included.
    pub(crate) fn meet_item(&self, of: u32, found: &mut Vec<u32>) {
        self.meet(self.boxes[of as usize], found);
    }

    /// The item nearest to a point and its squared distance, if that is at most `within`; of items equally near,
    /// the one of least index.
    ///
    /// `squared` gives the squared distance from the point to an item, infinity for an item that does not count.
    /// It must not be less than that to the box of the item. O(log n) for items that lie apart.
    pub fn nearest(
        &self,
        point: DVec3,
        within: f64,
        mut squared: impl FnMut(u32) -> f64,
    ) -> Option<(u32, f64)> {
        let (mut best, mut least) = (u32::MAX, within);
        // Depth first, the nearer child first: nodes with their ranges in `order` and their distances.
        let mut stack = [(0, 0, 0, 0.0); STACK];
        let mut height = 1;
        stack[0] = (0, 0, self.order.len(), squared_distance(self.parts[0], point));
        while height > 0 {
            height -= 1;
            let (part, start, end, distance) = stack[height];
            if distance > least * ROUNDING {
                continue;
            }
            if end - start <= LEAF || 2 * part + 2 >= self.parts.len() {
                for &item in &self.order[start..end] {
                    if squared_distance(self.boxes[item as usize], point) > least * ROUNDING {
                        continue;
                    }
                    let found = squared(item);
                    if found < least || (found == least && item < best && found.is_finite()) {
                        (best, least) = (item, found);
                    }
                }
                continue;
            }
            let middle = start + (end - start) / 2;
            let child = |part: usize, start, end| {
                (part, start, end, squared_distance(self.parts[part], point))
            };
            let [low, high] =
                [child(2 * part + 1, start, middle), child(2 * part + 2, middle, end)];
            let (near, far) = if high.3 < low.3 { (high, low) } else { (low, high) };
            stack[height] = far;
            stack[height + 1] = near;
            height += 2;
        }
        (best != u32::MAX).then_some((best, least))
    }
}

/// More than the levels of a tree of 2^32 items: each level leaves one node on the stack.
const STACK: usize = 40;

fn squared_distance(of: Bounds<DVec3>, point: DVec3) -> f64 {
    (of.min - point).max(point - of.max).max(DVec3::ZERO).length_squared()
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

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// The tree finds the same item as a comparison of all, ties included.
        #[test]
        fn the_nearest_is_that_of_a_full_search(
            corners in prop::collection::vec(prop::array::uniform3(-9_i8..9), 1..80),
            point in prop::array::uniform3(-12_i8..12),
            within in 0_u8..30,
        ) {
            let at = |p: [i8; 3]| DVec3::from(p.map(f64::from));
            let corners: Vec<DVec3> = corners.into_iter().map(at).collect();
            let point = at(point);
            let boxes = corners.iter().map(|&p| Bounds { min: p, max: p + DVec3::new(1.0, 0.0, 2.0) });
            let tree = BoxTree::new(boxes.collect());
            // The items are the least corners of the boxes; every seventh does not count.
            let squared = |item: u32| match item % 7 {
                3 => f64::INFINITY,
                _ => corners[item as usize].distance_squared(point),
            };
            let within = f64::from(within) * f64::from(within);
            let all = (0..corners.len() as u32).map(|item| (item, squared(item)));
            let expected = all
                .filter(|&(_, d)| d <= within)
                .min_by(|a, b| a.1.total_cmp(&b.1).then(a.0.cmp(&b.0)));
            prop_assert_eq!(tree.nearest(point, within, squared), expected);
        }
    }
}
