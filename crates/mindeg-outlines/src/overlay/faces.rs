//! The sides of edges that meet at their ends alone: what is inside, and the rings round it.

use std::cmp::Ordering;
use std::collections::BTreeMap;

use glam::DVec2;
use mindeg_mesh::Bounds;
use mindeg_mesh::planar::orientation;

use super::super::nesting::{is_within, too_deep};
use super::edge::{Edge, Layer, Step};

/// The most comparisons of a vertex with an edge, which take some seconds.
const MOST_COMPARISONS: u64 = 4_000_000_000;

/// All edges between two vertices as one. As a half-edge, `2 * index` runs from the first end to the
/// second and `2 * index + 1` back.
pub(in super::super) struct Link {
    pub(in super::super) ends: [u32; 2],
    /// The first of its edges, and whether that one runs from the first end to the second.
    pub(in super::super) edge: Edge,
    pub(in super::super) forward: bool,
}

/// A number for each layer, such as a winding number or by how much one changes: by layer, without zeros.
pub(in super::super) type ByLayer = Vec<(u32, i64)>;

/// Adds a multiple of numbers to others.
fn add(sum: &mut ByLayer, more: &[(u32, i64)], times: i64) {
    for &(layer, number) in more {
        match sum.binary_search_by_key(&layer, |entry| entry.0) {
            Ok(at) => sum[at].1 += times * number,
            Err(at) => sum.insert(at, (layer, times * number)),
        }
    }
    sum.retain(|entry| entry.1 != 0);
}

/// The winding numbers on the left of half-edges: for each half-edge the index of all that are there.
pub(in super::super) struct Windings {
    pub(in super::super) left: Vec<u32>,
    pub(in super::super) all: Vec<ByLayer>,
}

/// The simple rings between inside and outside, with inside on their left, and how many links have
/// one of them on both sides.
pub(super) fn boundary(
    edges: &[Edge],
    points: &[DVec2],
    layers: &[Layer<'_>],
    layer_of: impl Fn(&Edge) -> usize,
    is_inside: impl Fn(&[bool]) -> bool,
) -> Result<(Vec<Vec<Step>>, usize), String> {
    let (links, changes) = links(edges, |edge| layer_of(edge) as u32);
    let graph = Graph::new(&links, points);
    let windings = graph.windings(&changes)?;
    let counted = |windings: &ByLayer| {
        let mut counted = vec![false; layers.len()];
        for &(layer, winding) in windings {
            counted[layer as usize] = layers[layer as usize].rule.counts(winding);
        }
        is_inside(&counted)
    };
    let of_windings: Vec<bool> = windings.all.iter().map(counted).collect();
    let inside: Vec<bool> =
        windings.left.iter().map(|windings| of_windings[*windings as usize]).collect();
    let is_bound = |half: usize| inside[half] && !inside[half ^ 1];
    let bounds = (0..2 * links.len()).filter(|&half| is_bound(half)).count();
    let rings = graph.rings(|half| is_bound(half).then_some(()));
    Ok((rings.into_iter().map(|(_, ring)| ring).collect(), links.len() - bounds))
}

/// The links of all edges, and for each link by how much the winding numbers to its left exceed those to its right.
pub(in super::super) fn links(
    edges: &[Edge],
    layer_of: impl Fn(&Edge) -> u32,
) -> (Vec<Link>, Vec<ByLayer>) {
    let lower_first =
        |edge: &Edge| [edge.ends[0].min(edge.ends[1]), edge.ends[0].max(edge.ends[1])];
    let mut order: Vec<&Edge> = edges.iter().collect();
    order.sort_by_key(|edge| (lower_first(edge), edge.chord));
    let mut links: Vec<Link> = Vec::new();
    let mut changes: Vec<ByLayer> = Vec::new();
    for &edge in order {
        let ends = lower_first(&edge);
        let forward = edge.ends == ends;
        if links.last().is_none_or(|last| last.ends != ends) {
            links.push(Link { ends, edge, forward });
            changes.push(ByLayer::new());
        }
        let change = if forward { 1 } else { -1 };
        changes.iter_mut().rev().take(1).for_each(|it| add(it, &[(layer_of(&edge), 1)], change));
    }
    (links, changes)
}

/// The half-edges round each vertex.
pub(in super::super) struct Graph<'a> {
    links: &'a [Link],
    points: &'a [DVec2],
    /// The half-edges that leave each vertex, counter-clockwise, from downwards on.
    pub(in super::super) around: Vec<Vec<usize>>,
    /// The index of each half-edge among those that leave its vertex.
    place: Vec<usize>,
}

impl<'a> Graph<'a> {
    pub(in super::super) fn new(links: &'a [Link], points: &'a [DVec2]) -> Self {
        let mut around = vec![Vec::new(); points.len()];
        for (index, link) in links.iter().enumerate() {
            around[link.ends[0] as usize].push(2 * index);
            around[link.ends[1] as usize].push(2 * index + 1);
        }
        let place = vec![0; 2 * links.len()];
        let mut graph = Self { links, points, around: Vec::new(), place };
        for (vertex, halves) in around.iter_mut().enumerate() {
            let origin = points[vertex];
            halves.sort_by(|&one, &other| {
                let [one, other] = [one, other].map(|half| points[graph.end(half) as usize]);
                // To the right and straight up first, then to the left and straight down.
                let is_left = |p: DVec2| p.x < origin.x || p.x == origin.x && p.y < origin.y;
                let turn = orientation(origin, other, one);
                let turns = turn.partial_cmp(&0.0).unwrap_or(Ordering::Equal);
                is_left(one).cmp(&is_left(other)).then(turns)
            });
            halves.iter().enumerate().for_each(|(at, &half)| graph.place[half] = at);
        }
        graph.around = around;
        graph
    }

    fn start(&self, half: usize) -> u32 {
        self.links[half / 2].ends[half % 2]
    }

    pub(in super::super) fn end(&self, half: usize) -> u32 {
        self.links[half / 2].ends[1 - half % 2]
    }

    /// The winding numbers, of which these are the changes over links.
    pub(in super::super) fn windings(&self, changes: &[ByLayer]) -> Result<Windings, String> {
        let sign = |half: usize| if half.is_multiple_of(2) { 1 } else { -1 };
        let parts = self.parts();
        let mut known: BTreeMap<ByLayer, u32> = BTreeMap::new();
        let mut all: Vec<ByLayer> = Vec::new();
        let mut index = |windings: ByLayer, all: &mut Vec<ByLayer>| {
            *known.entry(windings).or_insert_with_key(|windings| {
                all.push(windings.clone());
                all.len() as u32 - 1
            })
        };
        let mut left = vec![0; 2 * self.links.len()];
        let mut is_known = vec![false; self.points.len()];
        let mut budget = MOST_COMPARISONS;
        for (at, part) in parts.iter().enumerate() {
            // The other groups decide the winding numbers left of the leftmost vertex.
            let vertex = part.leftmost;
            let mut outside = ByLayer::new();
            for (_, other) in parts.iter().enumerate().filter(|&(other, _)| other != at) {
                let point = self.points[vertex as usize];
                let is_in_box = is_within(Bounds { min: point, max: point }, other.bounds);
                let cost = if is_in_box { 1 + other.links.len() as u64 } else { 1 };
                budget = budget.checked_sub(cost).ok_or_else(|| too_deep(parts.len()))?;
                if is_in_box {
                    let crossed = other.links.iter().filter_map(|&link| self.crossed(link, point));
                    crossed.for_each(|half| add(&mut outside, &changes[half / 2], sign(half)));
                }
            }
            is_known[vertex as usize] = true;
            let outside = index(outside, &mut all);
            let mut open = vec![(vertex, self.around[vertex as usize].len(), outside)];
            while let Some((vertex, from, mut winding)) = open.pop() {
                // Go all the way round, from the sector before the half-edge at `from` on.
                let halves = &self.around[vertex as usize];
                for at in (0..halves.len()).map(|i| (from + i) % halves.len()) {
                    let half = halves[at];
                    let twin = half ^ 1;
                    left[twin] = winding;
                    let mut next = all[winding as usize].clone();
                    add(&mut next, &changes[half / 2], sign(half));
                    winding = index(next, &mut all);
                    left[half] = winding;
                    let end = self.end(half);
                    if !std::mem::replace(&mut is_known[end as usize], true) {
                        // The opposite half-edge has on its right the sector on the left of this one.
                        open.push((end, self.place[twin], winding));
                    }
                }
            }
        }
        Ok(Windings { left, all })
    }

    /// The half-edge of a link that has a point on its left, if a ray to the right from there crosses it.
    fn crossed(&self, link: usize, point: DVec2) -> Option<usize> {
        let [a, b] = self.links[link].ends.map(|end| self.points[end as usize]);
        if (a.y > point.y) == (b.y > point.y) {
            return None;
        }
        let half = 2 * link + usize::from(a.y > b.y);
        let turn = orientation(a, b, point);
        ((turn > 0.0) == (a.y < b.y)).then_some(half)
    }

    /// The links that hang together.
    fn parts(&self) -> Vec<Part> {
        let mut is_seen = vec![false; self.points.len()];
        let mut parts = Vec::new();
        for first in 0..self.points.len() {
            if is_seen[first] || self.around[first].is_empty() {
                continue;
            }
            is_seen[first] = true;
            let start = self.points[first];
            let mut part = Part {
                links: Vec::new(),
                leftmost: first as u32,
                bounds: Bounds { min: start, max: start },
            };
            let mut open = vec![first as u32];
            while let Some(vertex) = open.pop() {
                let point = self.points[vertex as usize];
                let leftmost = self.points[part.leftmost as usize];
                if point.x < leftmost.x || point.x == leftmost.x && point.y < leftmost.y {
                    part.leftmost = vertex;
                }
                part.bounds.min = part.bounds.min.min(point);
                part.bounds.max = part.bounds.max.max(point);
                for &half in &self.around[vertex as usize] {
                    if half % 2 == 0 {
                        part.links.push(half / 2);
                    }
                    let end = self.end(half);
                    if !std::mem::replace(&mut is_seen[end as usize], true) {
                        open.push(end);
                    }
                }
            }
            parts.push(part);
        }
        parts
    }

    /// The rings of half-edges of the same kind, each parted where it comes back to a vertex; `None` is no kind.
    pub(in super::super) fn rings<K: PartialEq>(
        &self,
        kind: impl Fn(usize) -> Option<K>,
    ) -> Vec<(K, Vec<Step>)> {
        let mut used = vec![false; 2 * self.links.len()];
        let mut position = vec![None; self.points.len()];
        let mut rings = Vec::new();
        for first in 0..used.len() {
            if used[first] {
                continue;
            }
            let Some(own) = kind(first) else { continue };
            let is_own = |half: usize| kind(half).as_ref() == Some(&own);
            let mut found = Vec::new();
            let mut run: Vec<Step> = Vec::new();
            let mut half = first;
            while !std::mem::replace(&mut used[half], true) {
                let link = &self.links[half / 2];
                let from = self.start(half);
                if let Some(at) = position[from as usize] {
                    found.push(Self::cut(&mut run, at, &mut position));
                }
                position[from as usize] = Some(run.len());
                let forward = link.forward == (half % 2 == 0);
                run.push(Step { from, chord: link.edge.chord, forward });
                // The next one clockwise bounds the same inside.
                let halves = &self.around[self.end(half) as usize];
                let (back, count) = (self.place[half ^ 1], halves.len());
                let mut clockwise = (1..=count).map(|i| halves[(back + count - i) % count]);
                half = clockwise.find(|&half| is_own(half)).unwrap_or(half);
            }
            if !run.is_empty() {
                found.push(Self::cut(&mut run, 0, &mut position));
            }
            rings.extend(found.into_iter().map(|ring| (kind(first), ring)));
        }
        rings.into_iter().filter_map(|(kind, ring)| Some((kind?, ring))).collect()
    }

    /// The end of a run, from a position on.
    fn cut(run: &mut Vec<Step>, at: usize, position: &mut [Option<usize>]) -> Vec<Step> {
        let ring = run.split_off(at);
        ring.iter().for_each(|step| position[step.from as usize] = None);
        ring
    }
}

/// Links that hang together, with their box.
struct Part {
    links: Vec<usize>,
    leftmost: u32,
    bounds: Bounds,
}
