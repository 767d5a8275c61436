//! How long the edges of a remesh are, at each vertex of a surface.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use glam::DVec3;
use mindeg_mesh::{Bounds, BoxTree, Cancelled, Progress, edges_of};

use crate::curves::CurveSpan;
use crate::links::by_vertex;
use crate::surface::{Spot, Surface};

/// The rules for the edge lengths of a remesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SizeRules {
    /// The edge length where nothing asks for a shorter one.
    pub size: f64,
    /// How far the middle of an edge may be from a bent surface, in units of length; never more than 0.15 `size`.
    pub tolerance: f64,
    /// How much longer edges become, per unit of length on the way.
    pub growth: f64,
    /// The shortest edge length.
    pub least: f64,
}

/// The greatest distance between an edge and the surface, as a share of the size: thin parts would vanish.
const CHORD: f64 = 0.15;
/// Edges on flat parts are at most this many sizes long where they follow the curvature.
const FLATTEST: f64 = 3.0;
/// An edge is at most this many times as long as the distance between two curves.
const BETWEEN: f64 = 1.1;
/// Two points of curves belong together if the way along curves is at most this many times their distance.
const WAY: f64 = 3.0;
/// Or at most this many sizes.
const NEAR: f64 = 1.5;
/// The edges round a closed curve.
const ROUND: f64 = 5.0;

impl SizeRules {
    /// Edges of one length, where neither curvature nor near features ask for shorter ones: not below a fifth of it.
    pub fn of_size(size: f64) -> Self {
        Self { size, tolerance: CHORD * size, growth: 0.4, least: 0.2 * size }
    }

    /// The same where the surface bends or features are near; where it is flat, edges are up to three times as long.
    pub fn by_curvature(size: f64) -> Self {
        Self { size: FLATTEST * size, ..Self::of_size(size) }
    }
}

/// The wanted edge length at each vertex of a surface whose edges are at most `rules.size` long.
pub(crate) fn sizes(
    surface: &Surface,
    rules: &SizeRules,
    progress: Progress<'_>,
) -> Result<Vec<f64>, Cancelled> {
    let mut sizes = vec![rules.size; surface.points().len()];
    bend(surface, rules, &mut sizes);
    curve_lengths(surface, &mut sizes);
    between_curves(surface, rules, &mut sizes, progress)?;
    sizes.iter_mut().for_each(|size| *size = size.clamp(rules.least.min(rules.size), rules.size));
    grow(surface, rules.growth, &mut sizes);
    Ok(sizes)
}

/// An edge of length s has the middle s²k/8 from a circle of curvature k; a triangle's centre is farther.
fn bend(surface: &Surface, rules: &SizeRules, sizes: &mut [f64]) {
    let chord = rules.tolerance.min(CHORD * rules.size);
    for (t, corners) in (0_u32..).zip(surface.triangles()) {
        for i in 0..3 {
            let [a, b] = [(i + 1) % 3, (i + 2) % 3];
            let edge =
                surface.points()[corners[b] as usize] - surface.points()[corners[a] as usize];
            let turn = surface.corner_normal(t, b) - surface.corner_normal(t, a);
            let curvature = turn.dot(edge).abs() / edge.length_squared();
            // The triangle of one edge length in a sphere that is `chord` from it at its centre.
            let squared = 6.0 * chord / curvature - 3.0 * chord * chord;
            for end in [a, b] {
                let size = &mut sizes[corners[end] as usize];
                *size = size.min(squared.max(0.0).sqrt());
            }
        }
    }
}

/// An open curve has an edge, a closed one has five.
fn curve_lengths(surface: &Surface, sizes: &mut [f64]) {
    for span in surface.spans() {
        let curve = surface.curve(span.curve);
        let is_open = !curve.is_closed();
        let most = if is_open { curve.length() } else { curve.length() / ROUND };
        for v in span.vertices {
            if !is_open || surface.spot(v) == Spot::Corner {
                sizes[v as usize] = sizes[v as usize].min(most);
            }
        }
    }
}

/// Where another curve, or a far part of the same, is near, an edge fits between them.
fn between_curves(
    surface: &Surface,
    rules: &SizeRules,
    sizes: &mut [f64],
    progress: Progress<'_>,
) -> Result<(), Cancelled> {
    let spans = surface.spans();
    let at = |v: u32| surface.points()[v as usize];
    let ends = |span: u32| spans[span as usize].vertices.map(at);
    let boxes = (0..spans.len() as u32).map(|span| {
        let [a, b] = ends(span);
        Bounds { min: a.min(b), max: a.max(b) }
    });
    let tree = BoxTree::new(boxes.collect());
    let mut ways = Ways::new(surface);
    let (mut near, mut done) = (Vec::new(), 0);
    let on_curves = (0..surface.points().len() as u32).filter(|&v| ways.is_on_curve(v));
    for v in on_curves.collect::<Vec<u32>>() {
        done += 1;
        if done % 0x400 == 0 {
            progress.report("finding near features", done, spans.len() as u64)?;
        }
        near.clear();
        let reach = DVec3::splat(rules.size / BETWEEN);
        tree.meet(Bounds { min: at(v) - reach, max: at(v) + reach }, &mut near);
        let found = near.iter().map(|&span| (distance(at(v), ends(span)), span));
        let mut found: Vec<(f64, u32)> =
            found.filter(|(d, _)| BETWEEN * d < sizes[v as usize]).collect();
        if found.is_empty() {
            continue;
        }
        found.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        ways.start(v, WAY * rules.size);
        let far = |d: f64, span: u32| {
            let way = ways.to(span);
            way > WAY * d && way > NEAR * rules.size
        };
        if let Some((d, _)) = found.into_iter().find(|&(d, span)| far(d, span)) {
            sizes[v as usize] = sizes[v as usize].min(BETWEEN * d);
        }
    }
    Ok(())
}

fn distance(from: DVec3, [a, b]: [DVec3; 2]) -> f64 {
    let edge = b - a;
    let t = ((from - a).dot(edge) / edge.length_squared()).clamp(0.0, 1.0);
    from.distance(a.lerp(b, t))
}

/// Distances along curves from one vertex.
struct Ways<'a> {
    surface: &'a Surface,
    /// The spans at each vertex; see [`by_vertex`].
    starts: Vec<usize>,
    at: Vec<u32>,
    lengths: Vec<f64>,
    reached: Vec<u32>,
    heap: BinaryHeap<Reverse<(u64, u32)>>,
}

impl<'a> Ways<'a> {
    fn new(surface: &'a Surface) -> Self {
        let count = surface.points().len();
        let (starts, at) = by_vertex(count, surface.spans().iter().map(|span| span.vertices));
        let lengths = vec![f64::INFINITY; count];
        Self { surface, starts, at, lengths, reached: Vec::new(), heap: BinaryHeap::new() }
    }

    fn is_on_curve(&self, vertex: u32) -> bool {
        self.starts[vertex as usize] < self.starts[vertex as usize + 1]
    }

    /// Forgets the last start; finds all vertices no farther than `most` from a new one.
    fn start(&mut self, vertex: u32, most: f64) {
        self.reached.drain(..).for_each(|v| self.lengths[v as usize] = f64::INFINITY);
        self.reach(vertex, 0.0);
        while let Some(Reverse((bits, v))) = self.heap.pop() {
            let length = self.lengths[v as usize];
            if length.to_bits() != bits {
                continue;
            }
            for index in self.starts[v as usize]..self.starts[v as usize + 1] {
                let CurveSpan { vertices: [from, to], range, .. } =
                    self.surface.spans()[self.at[index] as usize];
                let other = if from == v { to } else { from };
                let way = length + (range[1] - range[0]);
                if way <= most && way < self.lengths[other as usize] {
                    self.reach(other, way);
                }
            }
        }
    }

    fn reach(&mut self, vertex: u32, length: f64) {
        if self.lengths[vertex as usize] == f64::INFINITY {
            self.reached.push(vertex);
        }
        self.lengths[vertex as usize] = length;
        self.heap.push(Reverse((length.to_bits(), vertex)));
    }

    /// The way to the nearer end of a span; infinity if it is farther than asked.
    fn to(&self, span: u32) -> f64 {
        let [a, b] = self.surface.spans()[span as usize].vertices;
        self.lengths[a as usize].min(self.lengths[b as usize])
    }
}

/// Lowers sizes so that they grow by at most `growth` per unit of length along edges. O(n log n).
fn grow(surface: &Surface, growth: f64, sizes: &mut [f64]) {
    let (starts, at) = {
        let edges = surface.triangles().iter().copied().flat_map(edges_of);
        by_vertex(sizes.len(), edges)
    };
    let corner = |edge: u32| {
        let [a, b, c] = surface.triangles()[edge as usize / 3];
        [[a, b], [b, c], [c, a]][edge as usize % 3]
    };
    let mut heap: BinaryHeap<Reverse<(u64, u32)>> =
        (0_u32..).zip(&*sizes).map(|(v, size)| Reverse((size.to_bits(), v))).collect();
    while let Some(Reverse((bits, v))) = heap.pop() {
        let size = sizes[v as usize];
        if size.to_bits() != bits {
            continue;
        }
        for &edge in &at[starts[v as usize]..starts[v as usize + 1]] {
            let [a, b] = corner(edge);
            let other = if a == v { b } else { a };
            let [p, q] = [v, other].map(|v| surface.points()[v as usize]);
            let most = size + growth * p.distance(q);
            if most < sizes[other as usize] {
                sizes[other as usize] = most;
                heap.push(Reverse((most.to_bits(), other)));
            }
        }
    }
}
