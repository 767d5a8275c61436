//! Divides the triangles of a surface, without leaving it, until its edges are as short as its sizes ask.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use mindeg_mesh::{Cancelled, Progress};

use crate::NONE;
use crate::curves::CurveSpan;
use crate::links::edge_of;
use crate::sizes::{SizeRules, sizes};
use crate::surface::Surface;

/// An edge of the reference is at most this much longer than the size there.
const LONGEST: f64 = 1.5;

impl Surface {
    /// The same surface with shorter edges, and with a size at each vertex.
    ///
    /// Edges are bisected, longest first, so that points stay on the surface. Features and patches stay the same;
    /// [`origin`](Self::origin) gives the triangle that each triangle is a part of. O(n log n) for n triangles of the
    /// result.
    ///
    /// # Errors
    ///
    /// [`Cancelled`], if the callback breaks.
    ///
    /// # Example
    ///
    /// ```
    /// use glam::DVec3;
    /// use mindeg_mesh::Progress;
    /// use mindeg_surfaces::{FeatureRules, SizeRules, Surface};
    ///
    /// let points = [DVec3::ZERO, DVec3::X, DVec3::Y];
    /// let surface = Surface::new(&points, &[[0, 1, 2]], &[], &FeatureRules::default())?;
    /// let fine = surface.refined(&SizeRules::of_size(0.25), Progress::NONE)?;
    /// assert!(fine.triangles().len() > 16 && fine.curves() == surface.curves());
    /// assert!((0..fine.points().len() as u32).all(|v| fine.size(v) <= 0.25));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn refined(&self, rules: &SizeRules, progress: Progress<'_>) -> Result<Self, Cancelled> {
        // Sizes are computed on triangles that are fine enough to have them.
        let mut coarse = vec![rules.size; self.points().len()];
        let first = self.bisected(&mut coarse, 1.0, progress)?;
        let mut wanted = sizes(&first, rules, progress)?;
        let mut fine = first.bisected(&mut wanted, LONGEST, progress)?;
        fine.sizes = sizes(&fine, rules, progress)?;
        Ok(fine)
    }

    /// Bisects the edges longer than `factor` times the lesser size at their ends. New vertices are appended to
    /// `sizes`, with the mean of both ends.
    fn bisected(
        &self,
        sizes: &mut Vec<f64>,
        factor: f64,
        progress: Progress<'_>,
    ) -> Result<Self, Cancelled> {
        let mut work = Bisection { surface: self.clone(), sizes, factor, heap: BinaryHeap::new() };
        for t in 0..self.triangles().len() as u32 {
            work.push(t, |u| u > t);
        }
        let mut done = 0;
        while let Some((_, Reverse((t, ends)))) = work.heap.pop() {
            let corners = work.surface.links.triangles[t as usize];
            let i = (0..3).find(|i| [corners[(i + 1) % 3], corners[(i + 2) % 3]] == ends);
            if let Some(i) = i {
                done += 1;
                if done % 0x1000 == 0 {
                    progress.report("dividing triangles", done, done + work.heap.len() as u64)?;
                }
                work.split(t, i);
            }
        }
        let Self { links, mut curves, patches, groups, origins, .. } = work.surface;
        curves.is_corner.resize(links.points.len(), false);
        Ok(Self::assembled(links, curves, (patches, groups), origins))
    }
}

struct Bisection<'a> {
    surface: Surface,
    sizes: &'a mut Vec<f64>,
    factor: f64,
    /// Edges that are too long, by their lengths as multiples of the longest allowed: with a triangle and its
    /// vertices there. Entries grow old when a triangle changes.
    heap: BinaryHeap<(u64, Reverse<LongEdge>)>,
}

/// A triangle and the vertices of one of its edges.
type LongEdge = (u32, [u32; 2]);

impl Bisection<'_> {
    /// Adds the edges of a triangle that are too long and have a neighbour that `counts`; [`NONE`] counts always.
    fn push(&mut self, t: u32, counts: impl Fn(u32) -> bool) {
        let links = &self.surface.links;
        let corners = links.triangles[t as usize];
        for i in 0..3 {
            let u = links.neighbours[t as usize][i];
            let [a, b] = [corners[(i + 1) % 3], corners[(i + 2) % 3]];
            let length = links.points[a as usize].distance(links.points[b as usize]);
            let ratio = length / (self.factor * self.sizes[a as usize].min(self.sizes[b as usize]));
            if ratio > 1.0 && (u == NONE || counts(u)) {
                // Positive numbers have the order of their bits.
                self.heap.push((ratio.to_bits(), Reverse((t, [a, b]))));
            }
        }
    }

    /// Divides the edge opposite corner `i` of triangle `t`, and the triangles beside it, at its middle.
    fn split(&mut self, t: u32, i: usize) {
        let links = &mut self.surface.links;
        let corners = links.triangles[t as usize];
        let [a, b] = [corners[(i + 1) % 3], corners[(i + 2) % 3]];
        let u = links.neighbours[t as usize][i];
        let middle = links.points.len() as u32;
        links.points.push(links.points[a as usize].midpoint(links.points[b as usize]));
        links.inputs.push(NONE);
        self.sizes.push(0.5 * (self.sizes[a as usize] + self.sizes[b as usize]));
        let halves = self.split_span(self.surface.curves.span_of[t as usize][i], [a, b], middle);
        let second = self.cut(t, i, middle, halves);
        if u == NONE {
            self.push(t, |_| true);
            self.push(second, |_| true);
            return;
        }
        let j = edge_of(self.surface.links.triangles[u as usize], corners, i);
        let fourth = self.cut(u, j, middle, [halves[1], halves[0]]);
        // The parts lie across from each other: t has a, u has b.
        let neighbours = &mut self.surface.links.neighbours;
        neighbours[t as usize][i] = fourth;
        neighbours[fourth as usize][j] = t;
        neighbours[second as usize][i] = u;
        neighbours[u as usize][j] = second;
        for part in [t, second, u, fourth] {
            self.push(part, |_| true);
        }
    }

    /// Divides a span at a vertex; the results are the spans at `a` and at `b`.
    fn split_span(&mut self, span: u32, [a, b]: [u32; 2], middle: u32) -> [u32; 2] {
        let spans = &mut self.surface.curves.spans;
        let Some(&CurveSpan { curve, vertices: [from, to], range: [start, end] }) =
            spans.get(span as usize)
        else {
            return [NONE; 2];
        };
        let at = 0.5 * (start + end);
        spans[span as usize] = CurveSpan { curve, vertices: [from, middle], range: [start, at] };
        spans.push(CurveSpan { curve, vertices: [middle, to], range: [at, end] });
        let other = (spans.len() - 1) as u32;
        debug_assert!(from == a && to == b || from == b && to == a);
        if from == a { [span, other] } else { [other, span] }
    }

    /// Cuts a triangle from its corner `i` to a vertex on the edge opposite: it keeps the first end of that edge, a new
    /// triangle gets the second. `halves` are the spans of both parts of the edge.
    fn cut(&mut self, t: u32, i: usize, middle: u32, halves: [u32; 2]) -> u32 {
        let Surface { links, curves, patches, origins, .. } = &mut self.surface;
        let [first, second] = [(i + 1) % 3, (i + 2) % 3];
        let new = links.triangles.len() as u32;
        let old = t as usize;
        let mut corners = links.triangles[old];
        corners[first] = middle;
        links.triangles.push(corners);
        links.triangles[old][second] = middle;
        // The edge opposite the first end goes to the new triangle.
        let beyond = links.neighbours[old][first];
        let mut around = [NONE; 3];
        (around[first], around[second]) = (beyond, t);
        links.neighbours.push(around);
        links.neighbours[old][first] = new;
        if beyond != NONE {
            let back = edge_of(links.triangles[beyond as usize], corners, first);
            links.neighbours[beyond as usize][back] = new;
        }
        let mut spans = [NONE; 3];
        (spans[i], spans[first]) = (halves[1], curves.span_of[old][first]);
        curves.span_of.push(spans);
        (curves.span_of[old][i], curves.span_of[old][first]) = (halves[0], NONE);
        patches.push(patches[old]);
        origins.push(origins[old]);
        new
    }
}
