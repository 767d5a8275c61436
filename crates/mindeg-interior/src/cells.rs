//! The edges that matter to the sizes in each part of the plane, so that a size takes O(1) however many edges turn.
//!
//! The plane is divided into square cells of cells, as far as places are asked for. A cell knows the edges that may
//! bound sizes in it by their growth, the edges near it, and at its corners the sums over all others: what is far is
//! seen nearly alike from all of a cell, and its sums inside are linear in the column and the row. A cell takes over
//! what its parent knows, so that only edges that become far count anew.

use crate::edge_tree::EdgeTree;
use crate::sight::{Seen, extent, is_far, is_one};
use glam::DVec2;
use mindeg_mesh::Bounds;
use std::f64::consts::SQRT_2;

/// The edges that stay, and places with sizes of their own.
#[derive(Debug, Clone)]
pub(crate) struct Sources {
    pub(crate) boundary: EdgeTree,
    /// The edges inside that stay as they are.
    pub(crate) frozen: EdgeTree,
    pub(crate) places: EdgeTree,
    pub(crate) growth: f64,
    /// The growth from edges, which may be less.
    pub(crate) growth_from_edges: f64,
}

/// The bound of the size at a place, and the mean that makes it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct AtPlace {
    /// The least of size + growth * distance.
    pub(crate) grown: f64,
    /// The mean of lengths, not at edges.
    pub(crate) mean: Option<f64>,
}

/// Cells of cells, each made when a place in it is asked for.
#[derive(Debug, Clone)]
pub(crate) struct Cells {
    cells: Vec<Cell>,
    runs: Vec<Run>,
    middle: DVec2,
    half: f64,
}

/// A node of one of the trees.
#[derive(Debug, Clone, Copy)]
struct Run {
    tree: u8,
    node: u32,
}

#[derive(Debug, Clone, Copy, Default)]
struct Cell {
    is_known: bool,
    is_last: bool,
    /// The first of four; 0 before there are any.
    children: u32,
    /// In the list of runs, what is near lies between the first two, and what may bound sizes between the last two.
    ends: [u32; 3],
    /// The sources far away, as seen at the corners.
    far: [Seen; 4],
    /// The bound at the middle.
    grown: f64,
}

/// An edge is far from a cell at so many of its sides.
const FAR: f64 = 3.0;
/// A cell this much smaller than sizes in it is not divided.
const FINE: f64 = 1.0;
/// A cell with no more edges near it, nor more bounds, is not divided.
const FEW: [usize; 2] = [8, 4];
const DEEPEST: u32 = 60;
/// Room around the domain.
const MARGIN: f64 = 0.25;
/// The corners of the unit square, as cells are divided.
const CORNERS: [DVec2; 4] = [DVec2::ZERO, DVec2::X, DVec2::Y, DVec2::ONE];
/// The tree of places.
const PLACES: u8 = 2;
/// Above rounding.
pub(crate) const HAIR: f64 = 1.0 + 1e-9;

impl Sources {
    fn tree(&self, run: Run) -> &EdgeTree {
        match run.tree {
            0 => &self.boundary,
            1 => &self.frozen,
            _ => &self.places,
        }
    }

    /// The growth from what is in the tree of a run.
    fn growth(&self, run: Run) -> f64 {
        if run.tree == PLACES { self.growth } else { self.growth_from_edges }
    }

    /// The least of size + growth * distance, if less than `least`.
    pub(crate) fn least_grown(&self, x: DVec2, least: f64) -> f64 {
        self.least_grown_by(self.growth_from_edges, x, least)
    }

    /// The same with another growth from edges.
    pub(crate) fn least_grown_by(&self, growth: f64, x: DVec2, mut least: f64) -> f64 {
        self.boundary.least_grown(growth, x, &mut least);
        self.frozen.least_grown(growth, x, &mut least);
        self.places.least_grown(self.growth, x, &mut least);
        least
    }

    /// The edges that stay, by the roots of their trees.
    pub(crate) fn edges(&self) -> impl Iterator<Item = (&EdgeTree, u32)> {
        let trees = [&self.boundary, &self.frozen].into_iter();
        trees.flat_map(|tree| tree.roots().iter().map(move |root| (tree, *root)))
    }

    /// The mean of lengths, told from all edges.
    pub(crate) fn mean(&self, x: DVec2) -> Option<f64> {
        let mut seen = Seen::default();
        self.edges().for_each(|(tree, root)| seen.add(tree, root, x));
        seen.mean()
    }

    fn roots(&self) -> Vec<Run> {
        let trees = (0..).zip([&self.boundary, &self.frozen, &self.places]);
        let roots = trees.map(|(tree, of)| of.roots().iter().map(move |&node| Run { tree, node }));
        roots.flatten().collect()
    }
}

impl Cells {
    /// One cell around these bounds, and all edges.
    pub(crate) fn new(bounds: Bounds, sources: &Sources) -> Self {
        let bounding = sources.roots();
        let mut runs = bounding.clone();
        runs.retain(|run| run.tree != PLACES);
        let near = runs.len() as u32;
        runs.extend(bounding);
        let middle = bounds.min.midpoint(bounds.max);
        let half = (0.5 + MARGIN) * bounds.size().max_element();
        let grown = sources.least_grown(middle, f64::INFINITY);
        let ends = [0, near, runs.len() as u32];
        let cell = Cell { is_known: true, ends, grown, ..Cell::default() };
        Self { cells: vec![cell], runs, middle, half }
    }

    /// The bound and the mean of sizes at a place; nothing outside all cells.
    pub(crate) fn at(&mut self, sources: &Sources, x: DVec2) -> Option<AtPlace> {
        let (mut at, mut middle, mut half) = (0, self.middle, self.half);
        let is_inside = (x - middle).abs().max_element() <= half;
        if !is_inside {
            return None;
        }
        let mut depth = 0;
        while !self.cells[at].is_last {
            if self.cells[at].children == 0 {
                self.cells[at].children = self.cells.len() as u32;
                self.cells.extend([Cell::default(); 4]);
            }
            let quadrant = usize::from(x.x > middle.x) + 2 * usize::from(x.y > middle.y);
            let child = self.cells[at].children as usize + quadrant;
            half /= 2.0;
            let offset = [-1.0, 1.0].map(|sign| sign * half);
            let next = middle + DVec2::new(offset[quadrant % 2], offset[quadrant / 2]);
            depth += 1;
            if !self.cells[child].is_known {
                self.cells[child] =
                    self.child(sources, &self.cells[at].clone(), quadrant, next, half);
            }
            (at, middle) = (child, next);
            if depth == DEEPEST {
                break;
            }
        }
        let cell = &self.cells[at];
        let place = ((x - middle) / half + DVec2::ONE) / 2.0;
        let mut seen = cell.far_at(place);
        let [start, near, end] = cell.ends.map(|end| end as usize);
        for run in &self.runs[start..near] {
            seen.add(sources.tree(*run), run.node, x);
        }
        let mut grown = cell.grown + sources.growth * x.distance(middle) * HAIR;
        for run in &self.runs[near..end] {
            let growth = sources.growth(*run);
            sources.tree(*run).least_grown_below(run.node, growth, x, &mut grown);
        }
        Some(AtPlace { grown, mean: seen.mean() })
    }

    /// One of the four parts of a cell.
    fn child(
        &mut self,
        sources: &Sources,
        parent: &Cell,
        quadrant: usize,
        middle: DVec2,
        half: f64,
    ) -> Cell {
        let side = 2.0 * half;
        let [reach, slack] = [half * SQRT_2, 2.0 * sources.growth * half * SQRT_2];
        let low = DVec2::new((quadrant % 2) as f64, (quadrant / 2) as f64) / 2.0;
        let mut far = CORNERS.map(|corner| parent.far_at(low + corner / 2.0));
        let start = self.runs.len();
        let mut is_few = true;
        let mut stack = Vec::new();
        for index in (parent.ends[0]..parent.ends[1]).rev() {
            stack.push(self.runs[index as usize]);
        }
        while let Some(run) = stack.pop() {
            let tree = sources.tree(run);
            let node = &tree.nodes()[run.node as usize];
            let distance = node.distance(middle) - reach;
            let is_one = is_one(tree, run.node);
            if distance >= FAR * side && (is_one || is_far(node, distance)) {
                for (corner, far) in CORNERS.iter().zip(&mut far) {
                    let corner = middle + half * (2.0 * *corner - DVec2::ONE);
                    far.add_whole(tree, run.node, corner);
                }
            } else if is_one || distance < FAR * side && extent(node) <= side {
                is_few &= is_one;
                self.runs.push(run);
            } else if let Some(children) = tree.children(run.node) {
                stack.extend(children.map(|node| Run { node, ..run }));
            }
        }
        let near = self.runs.len();
        let mut grown = f64::INFINITY;
        for index in parent.ends[1]..parent.ends[2] {
            let run = self.runs[index as usize];
            let growth = sources.growth(run);
            sources.tree(run).least_grown_below(run.node, growth, middle, &mut grown);
            stack.push(run);
        }
        while let Some(run) = stack.pop() {
            let tree = sources.tree(run);
            let node = &tree.nodes()[run.node as usize];
            let bound = node.least + sources.growth(run) * node.distance(middle);
            if bound > (grown + slack) * HAIR {
                continue;
            }
            let is_one = is_one(tree, run.node);
            if is_one || extent(node) <= side {
                is_few &= is_one;
                self.runs.push(run);
            } else if let Some(children) = tree.children(run.node) {
                stack.extend(children.map(|node| Run { node, ..run }));
            }
        }
        let ends = [start, near, self.runs.len()];
        let is_few = is_few && near - start <= FEW[0] && ends[2] - near <= FEW[1];
        let is_last = is_few || side <= FINE * grown;
        Cell { is_known: true, is_last, children: 0, ends: ends.map(|end| end as u32), far, grown }
    }
}

impl Cell {
    /// The sums over what is far, at a place in the unit square.
    fn far_at(&self, place: DVec2) -> Seen {
        let share = |i: usize| (DVec2::ONE - (place - CORNERS[i]).abs()).element_product();
        Seen::mixed([0, 1, 2, 3].map(|i| (self.far[i], share(i))))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::edge_tree::Item;
    use crate::samples;
    use mindeg_mesh::planar::PlanarBoundary;

    /// A bay of long edges and a coast of short ones, lines of many lengths inside, and places.
    fn sources() -> (PlanarBoundary, Sources) {
        let outline = samples::rectangle(20.0, 12.0, [900, 2, 5, 3]);
        let item =
            |id: u32, from: DVec2, to: DVec2, size: f64| Item { id, from, to, size, reach: 0.0 };
        let lines = (0..700).map(|i| {
            let turn = f64::from(i);
            let from = DVec2::new(10.0 + 9.0 * libm::sin(1.7 * turn), 6.0 + 5.0 * libm::cos(turn));
            let to = from + DVec2::from_angle(turn) * (0.002 + 0.4 / (1.0 + turn % 17.0));
            item(i, from, to, from.distance(to))
        });
        let places = [[4.0, 4.0], [4.1, 4.0]].map(|at| item(0, at.into(), at.into(), 0.01));
        let sources = Sources {
            boundary: EdgeTree::of_boundary(&outline),
            frozen: EdgeTree::of_items(lines.collect()),
            places: EdgeTree::of_items(places.to_vec()),
            growth: 0.5,
            growth_from_edges: 0.3,
        };
        (outline, sources)
    }

    #[test]
    fn cells_tell_what_all_edges_tell() {
        let (outline, sources) = sources();
        let mut cells = Cells::new(outline.bounds(), &sources);
        let (mut worst, mut sum) = (0.0_f64, 0.0);
        for i in 0..2500 {
            let place = DVec2::new(f64::from(i % 50) + 0.53, f64::from(i / 50) + 0.47) / 50.0;
            let x = place * DVec2::new(20.0, 12.0);
            let found = cells.at(&sources, x).unwrap();
            let grown = sources.least_grown(x, f64::INFINITY);
            assert!((found.grown / grown - 1.0).abs() < 1e-7, "{x}");
            let error = (found.mean.unwrap() / sources.mean(x).unwrap() - 1.0).abs();
            (worst, sum) = (worst.max(error), sum + error);
        }
        assert!(worst < 0.08 && sum / 2500.0 < 0.02, "{worst} {}", sum / 2500.0);
        // Few of all edges are looked at.
        let last = cells.cells.iter().filter(|cell| cell.is_last);
        let runs: Vec<u32> = last.map(|cell| cell.ends[2] - cell.ends[0]).collect();
        let mean = f64::from(runs.iter().sum::<u32>()) / runs.len() as f64;
        assert!(mean < 40.0, "{mean}");
        assert!(cells.at(&sources, DVec2::new(-30.0, 1.0)).is_none());
    }
}
