//! A search tree over edges, for the questions that meshing asks of its boundary.
//!
//! A node stands for a run of consecutive edges. It keeps the chord of the run and how far the
//! run strays from it, so a straight side is one exact node, however many edges it has and
//! whichever way it points.

use glam::DVec2;
use mindeg_mesh::Bounds;
use mindeg_mesh::planar::PlanarBoundary;

mod node;

#[cfg(test)]
pub(crate) use node::distance_to_segment;
pub(crate) use node::{Node, is_uniform};

/// One edge, or one point with a size (then both ends are equal).
#[derive(Debug, Clone, Copy)]
pub(crate) struct Item {
    pub(crate) id: u32,
    pub(crate) from: DVec2,
    pub(crate) to: DVec2,
    /// The size that the mesh has here: an edge's length.
    pub(crate) size: f64,
    /// How far round it the size is the same.
    pub(crate) reach: f64,
}

/// The tree: one root for each ring, and nodes above these, which searches begin with.
#[derive(Debug, Clone, Default)]
pub(crate) struct EdgeTree {
    /// Those below a root come together.
    nodes: Vec<Node>,
    roots: Vec<u32>,
    /// Of all rings.
    top: Option<u32>,
}

/// Turns below this count as straight: rounded points of one side. Decides how fast a search is, and no
/// answer.
const STRAIGHT: f64 = 1e-7;

impl EdgeTree {
    /// The tree over the edges of a boundary, each ring from one of its corners on; an edge's id is
    /// its first vertex.
    pub(crate) fn of_boundary(boundary: &PlanarBoundary) -> Self {
        let mut tree = Self::default();
        let mut boxes = Vec::new();
        for ring in boundary.rings() {
            let turns = |vertex: &u32| {
                let [before, at, after] =
                    [boundary.previous(*vertex), *vertex, boundary.next(*vertex)]
                        .map(|v| boundary.point(v));
                !is_straight(at - before, after - at)
            };
            let start = ring.clone().find(turns).unwrap_or(ring.start);
            let item = |id| {
                let [from, to] = [id, boundary.next(id)].map(|v| boundary.point(v));
                Item { id, from, to, size: from.distance(to), reach: 0.0 }
            };
            let items: Vec<Item> = (start..ring.end).chain(ring.start..start).map(item).collect();
            boxes.push(tree.push_root(&items));
        }
        tree.join_roots(&boxes);
        tree
    }

    /// The tree over loose segments or points, in an order of its own.
    pub(crate) fn of_items(mut items: Vec<Item>) -> Self {
        let mut tree = Self::default();
        if !items.is_empty() {
            sort_by_place(&mut items);
            let bounds = tree.push_root(&items);
            tree.join_roots(&[bounds]);
        }
        tree
    }

    /// A search looks at few of many rings.
    fn join_roots(&mut self, boxes: &[Bounds]) {
        let of_ring = |(id, bounds): (u32, &Bounds)| {
            let middle = bounds.center();
            Item { id, from: middle, to: middle, size: 0.0, reach: 0.0 }
        };
        let mut rings: Vec<Item> = (0..).zip(boxes).map(of_ring).collect();
        sort_by_place(&mut rings);
        let ring = |item: &Item| (self.roots[item.id as usize], boxes[item.id as usize]);
        let rings: Vec<(u32, Bounds)> = rings.iter().map(ring).collect();
        if !rings.is_empty() {
            self.top = Some(self.joined(&rings).0);
        }
    }

    /// The node above some roots, and the box around their edges.
    fn joined(&mut self, rings: &[(u32, Bounds)]) -> (u32, Bounds) {
        if let [ring] = rings {
            return *ring;
        }
        let (first, second) = rings.split_at(rings.len() / 2);
        let (a, b) = (self.joined(first), self.joined(second));
        let (node, bounds) = self.join([a, b]);
        self.nodes.push(node);
        (self.nodes.len() as u32 - 1, bounds)
    }

    /// A node above two.
    fn join(&self, [(first, a), (second, b)]: [(u32, Bounds); 2]) -> (Node, Bounds) {
        let bounds = Bounds { min: a.min.min(b.min), max: a.max.max(b.max) };
        let [a, b] = [first, second].map(|half| &self.nodes[half as usize]);
        (Node { halves: [first, second], ..Node::join(a, b, &bounds) }, bounds)
    }

    fn push_root(&mut self, items: &[Item]) -> Bounds {
        self.roots.push(self.nodes.len() as u32);
        // corners[i]: the run turns, or breaks, before item i.
        let corners: Vec<u32> = (1..items.len() as u32)
            .filter(|i| {
                let (a, b) = (&items[*i as usize - 1], &items[*i as usize]);
                a.to != b.from || !is_straight(a.to - a.from, b.to - b.from)
            })
            .collect();
        self.build(items, 0, &corners).1
    }

    /// The new node, and the box around its edges as far as they reach.
    fn build(&mut self, items: &[Item], offset: u32, corners: &[u32]) -> (u32, Bounds) {
        let at = self.nodes.len();
        if let [item] = items {
            self.nodes.push(Node::leaf(item));
            let (min, max) = (item.from.min(item.to), item.from.max(item.to));
            return (at as u32, Bounds { min: min - item.reach, max: max + item.reach });
        }
        // Split at the corner nearest to the middle, so that straight sides stay whole.
        let end = offset + items.len() as u32;
        let inner = &corners
            [corners.partition_point(|c| *c <= offset)..corners.partition_point(|c| *c < end)];
        let middle = offset + items.len() as u32 / 2;
        let after = inner.partition_point(|c| *c < middle);
        let candidates = [after.checked_sub(1).and_then(|i| inner.get(i)), inner.get(after)];
        let split = candidates
            .into_iter()
            .flatten()
            .min_by_key(|corner| corner.abs_diff(middle))
            .copied()
            .unwrap_or(middle);
        // The place is taken first: nodes are in preorder.
        self.nodes.push(Node::leaf(&items[0]));
        let (first, second) = items.split_at((split - offset) as usize);
        let halves = [self.build(first, offset, inner), self.build(second, split, inner)];
        let (node, bounds) = self.join(halves);
        self.nodes[at] = Node { is_straight: inner.is_empty(), ..node };
        (at as u32, bounds)
    }

    /// Calls `edge` with the id of every edge that no node above it excludes.
    pub(crate) fn visit(&self, mut enter: impl FnMut(&Node) -> bool, mut edge: impl FnMut(u32)) {
        let mut stack = Vec::from_iter(self.top);
        while let Some(at) = stack.pop() {
            let node = &self.nodes[at as usize];
            match self.children(at) {
                _ if !enter(node) => {}
                None => edge(node.id),
                Some([first, second]) => stack.extend([second, first]),
            }
        }
    }

    /// How many runs turn.
    pub(crate) fn turns(&self) -> usize {
        let of_rings = self.nodes.len() - self.roots.len().saturating_sub(1);
        self.nodes[..of_rings].iter().filter(|node| !node.is_straight).count()
    }

    pub(crate) fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    pub(crate) fn roots(&self) -> &[u32] {
        &self.roots
    }

    /// The nearest edge and its distance, if any is nearer than `within`.
    pub(crate) fn nearest(&self, x: DVec2, within: f64) -> Option<(u32, f64)> {
        let mut best = (u32::MAX, within);
        if let Some(top) = self.top {
            self.nearest_below(top, self.distance(top, x), x, &mut best);
        }
        (best.0 != u32::MAX).then_some(best)
    }

    /// `distance`: of the node.
    fn nearest_below(&self, at: u32, distance: f64, x: DVec2, best: &mut (u32, f64)) {
        if distance >= best.1 {
            return;
        }
        match self.children(at) {
            None => *best = (self.nodes[at as usize].id, distance),
            Some(children) => {
                let [a, b] = children;
                let bounds = [self.distance(a, x), self.distance(b, x)];
                let first = usize::from(bounds[1] < bounds[0]);
                for child in [first, 1 - first] {
                    self.nearest_below(children[child], bounds[child], x, best);
                }
            }
        }
    }

    /// The least of size + growth * distance over all edges, where that is below `least`.
    pub(crate) fn least_grown(&self, growth: f64, x: DVec2, least: &mut f64) {
        if let Some(top) = self.top {
            self.least_grown_below(top, growth, x, least);
        }
    }

    /// The same below one node.
    pub(crate) fn least_grown_below(&self, at: u32, growth: f64, x: DVec2, least: &mut f64) {
        self.bounded_below(at, self.grown(at, growth, x), growth, x, least);
    }

    fn distance(&self, at: u32, x: DVec2) -> f64 {
        self.nodes[at as usize].distance(x)
    }

    /// No edge below a node has less.
    fn grown(&self, at: u32, growth: f64, x: DVec2) -> f64 {
        let node = &self.nodes[at as usize];
        node.least + growth * node.distance(x)
    }

    /// `bound`: of the node.
    fn bounded_below(&self, at: u32, bound: f64, growth: f64, x: DVec2, least: &mut f64) {
        if bound >= *least {
            return;
        }
        match self.children(at) {
            Some(children) if !is_uniform(&self.nodes[at as usize]) => {
                let [a, b] = children;
                let bounds = [self.grown(a, growth, x), self.grown(b, growth, x)];
                let first = usize::from(bounds[1] < bounds[0]);
                for child in [first, 1 - first] {
                    self.bounded_below(children[child], bounds[child], growth, x, least);
                }
            }
            _ => *least = bound,
        }
    }

    /// The greatest of size - growth * distance over all edges, where that is above `greatest`.
    pub(crate) fn greatest_shrunk(&self, growth: f64, x: DVec2, greatest: &mut f64) {
        if let Some(top) = self.top {
            self.bounded_above(top, self.shrunk(top, growth, x), growth, x, greatest);
        }
    }

    /// No edge below a node has more.
    fn shrunk(&self, at: u32, growth: f64, x: DVec2) -> f64 {
        let node = &self.nodes[at as usize];
        node.greatest - growth * node.distance(x)
    }

    /// `bound`: of the node.
    fn bounded_above(&self, at: u32, bound: f64, growth: f64, x: DVec2, greatest: &mut f64) {
        if bound <= *greatest {
            return;
        }
        match self.children(at) {
            Some(children) if !is_uniform(&self.nodes[at as usize]) => {
                let [a, b] = children;
                let bounds = [self.shrunk(a, growth, x), self.shrunk(b, growth, x)];
                let first = usize::from(bounds[1] > bounds[0]);
                for child in [first, 1 - first] {
                    self.bounded_above(children[child], bounds[child], growth, x, greatest);
                }
            }
            _ => *greatest = bound,
        }
    }

    /// The two halves of a run; none for a single edge.
    pub(crate) fn children(&self, at: u32) -> Option<[u32; 2]> {
        let halves = self.nodes[at as usize].halves;
        (halves != [0; 2]).then_some(halves)
    }
}

/// True if a run may go from direction `a` to direction `b` and still count as straight.
fn is_straight(a: DVec2, b: DVec2) -> bool {
    a.dot(b) > 0.0 && a.perp_dot(b).abs() <= STRAIGHT * a.dot(b)
}

/// Orders items so that near ones come near each other: halves along the wider axis.
fn sort_by_place(items: &mut [Item]) {
    if items.len() < 3 {
        return;
    }
    let Some(bounds) = Bounds::of(items.iter().map(|item| item.from)) else { return };
    let axis = usize::from(bounds.size().y > bounds.size().x);
    let middle = items.len() / 2;
    items.select_nth_unstable_by(middle, |a, b| {
        a.from[axis].total_cmp(&b.from[axis]).then(a.id.cmp(&b.id))
    });
    let (first, second) = items.split_at_mut(middle);
    sort_by_place(first);
    sort_by_place(second);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples;

    #[test]
    fn the_nearest_edge_is_that_of_a_full_search() {
        let outline = samples::plate_with_hole();
        let tree = EdgeTree::of_boundary(&outline);
        for i in 0..400 {
            let x = DVec2::new(f64::from(i % 20) * 0.61 - 1.0, f64::from(i / 20) * 0.57 - 1.0);
            let brute = outline
                .edges()
                .map(|[a, b]| distance_to_segment(x, outline.point(a), outline.point(b)))
                .fold(f64::INFINITY, f64::min);
            let (edge, distance) = tree.nearest(x, f64::INFINITY).unwrap();
            assert_eq!(distance, brute, "{x}");
            let ends = [edge, outline.next(edge)].map(|v| outline.point(v));
            assert_eq!(distance_to_segment(x, ends[0], ends[1]), brute);
        }
    }

    #[test]
    fn a_straight_side_is_one_node() {
        let outline = samples::rectangle(4.0, 3.0, [64, 48, 64, 48]);
        let tree = EdgeTree::of_boundary(&outline);
        let whole = tree.nodes().iter().filter(|n| n.is_straight && n.length > 2.9);
        assert_eq!(whole.count(), 4);
    }

    #[test]
    fn a_search_looks_at_few_of_many_rings() {
        let square = |x: f64, y: f64, size: f64| {
            let corners = [[0.0, 0.0], [size, 0.0], [size, size], [0.0, size]];
            samples::ring(&corners.map(|[a, b]| [x + a, y + b]), &[3; 4])
        };
        let hole = |i: u32| {
            let mut ring = square(f64::from(i % 30) + 0.3, f64::from(i / 30) + 0.3, 0.4);
            ring.reverse();
            ring
        };
        let rings: Vec<_> =
            std::iter::once(square(0.0, 0.0, 30.0)).chain((0..900).map(hole)).collect();
        let outline = PlanarBoundary::new(&rings).unwrap();
        let tree = EdgeTree::of_boundary(&outline);
        let ends = |[a, b]: [u32; 2]| [outline.point(a), outline.point(b)];
        for i in 0..60 {
            let x = DVec2::new(f64::from(i) * 0.47, f64::from(i % 7) * 4.1);
            let far = |[a, b]: [DVec2; 2]| distance_to_segment(x, a, b);
            let nearest = outline.edges().map(|edge| far(ends(edge))).fold(f64::INFINITY, f64::min);
            assert_eq!(tree.nearest(x, f64::INFINITY).unwrap().1, nearest);
            let less = |[a, b]: [DVec2; 2]| a.distance(b) - 0.5 * far([a, b]);
            let shrunk = outline.edges().map(|edge| less(ends(edge))).fold(-1e9, f64::max);
            let mut found = f64::NEG_INFINITY;
            tree.greatest_shrunk(0.5, x, &mut found);
            assert!((found - shrunk).abs() < 1e-9, "{x}: {found} {shrunk}");
            let mut looked_at = 0;
            let enter = |node: &Node| {
                looked_at += 1;
                node.distance(x) <= nearest
            };
            tree.visit(enter, |_| {});
            assert!(looked_at < 200, "{looked_at}");
        }
    }
}
