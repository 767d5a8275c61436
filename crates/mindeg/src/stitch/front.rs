//! The rings around the gap between a mesh and what is left of another one that overlapped it.
//!
//! They run along the front, the edges where triangles were dropped, and on along the old boundary, the bank, as far as it keeps
//! clear of the first mesh; an edge leads from there to the boundary of the first mesh.

use std::collections::{BTreeMap, BTreeSet};

use glam::DVec2;
use mindeg_mesh::{TriMesh, Triangles};

use super::cut::Cut;
use super::gap::{Corner, Step, shown};
use super::joining::Told;
use super::overlap::{Border, Overlap, angle, meet, nearest_of};
use super::proof::boundary_of;
use crate::error::MeshError;

/// The bank stays clear of the first mesh by this share of the longer edge of both.
const CLEAR: f64 = 0.4;
/// An edge to the first mesh may go so many vertices away from the nearest one.
const ASIDE: usize = 8;
/// The bank may end so many vertices earlier for a better edge.
const BACK: usize = 2;
/// The angles beside such an edge, in radians: wanted, and the least.
const ANGLES: [f64; 2] = [0.9, 0.35];

/// The rings, and what is on them besides vertices of meshes.
pub(super) struct Front {
    pub(super) rings: Vec<Vec<Step>>,
    pub(super) free: Vec<DVec2>,
    pub(super) told: Vec<Told>,
}

/// The names and kinds of the edges of lines.
pub(super) struct Named(BTreeMap<[u32; 2], Told>);

impl Named {
    pub(super) fn new(mesh: &TriMesh) -> Self {
        let mut named = BTreeMap::new();
        for (index, line) in mesh.lines().iter().enumerate() {
            let own = line.segments.start as usize..line.segments.end as usize;
            for [from, to] in &mesh.segments()[own] {
                let told = (Some(line.name.clone()), mesh.line_kind(index));
                named.insert([*from.min(to), *from.max(to)], told);
            }
        }
        Self(named)
    }

    fn of(&self, [from, to]: [u32; 2]) -> Told {
        self.0.get(&[from.min(to), from.max(to)]).cloned().unwrap_or_default()
    }
}

/// A place on the way around the gap.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Place {
    First(u32),
    Second(u32),
}

/// An edge of the bank that comes too near the first mesh.
#[derive(Clone, Copy)]
struct End {
    /// The last vertex of the bank that is clear, and its edge there; the vertices are in the order of the way.
    bank: [u32; 2],
    /// Whether the way leaves the bank here, or comes to it.
    is_exit: bool,
}

/// The ways around the gap.
struct Ways<'a> {
    first: &'a Border<'a>,
    second: &'a Border<'a>,
    before: BTreeMap<u32, u32>,
    /// The way along the front and the bank, and back.
    onward: BTreeMap<u32, u32>,
    back: BTreeMap<u32, u32>,
    is_front: BTreeSet<[u32; 2]>,
}

impl Front {
    pub(super) fn new(overlap: &Overlap<'_>, cut: &Cut, named: &Named) -> Result<Self, MeshError> {
        let Overlap { first, second, .. } = overlap;
        let left = boundary_of(&cut.triangles, second.points)?;
        let is_bank = |from: &u32, to: &u32| second.next.get(from) == Some(to);
        let front = left.iter().filter(|(from, to)| !is_bank(from, to));
        let front: Vec<[u32; 2]> = front.map(|(from, to)| [*to, *from]).collect();
        let bank: Vec<[u32; 2]> = second
            .next
            .iter()
            .filter(|(from, to)| left.get(from) != Some(to))
            .map(|(from, to)| [*from, *to])
            .collect();
        let ends = |[from, to]: [u32; 2]| [from, to].map(|end| second.points[end as usize]);
        let is_clear = |vertex: u32, [from, to]: [DVec2; 2]| {
            let at = second.points[vertex as usize];
            let (edge, distance) = first.nearest(at);
            let [a, b] = first.ends(edge);
            cut.number(vertex).is_some()
                || distance >= CLEAR * from.distance(to).max(a.distance(b)) && !first.has(at)
        };
        let is_usable = |edge: &[u32; 2]| {
            let own = ends(*edge);
            edge.iter().all(|end| is_clear(*end, own)) && first.met_by(own).is_empty()
        };
        let (usable, blocked): (Vec<[u32; 2]>, Vec<[u32; 2]>) =
            bank.into_iter().partition(is_usable);
        let ways = Ways {
            first,
            second,
            before: first.next.iter().map(|(from, to)| (*to, *from)).collect(),
            onward: front.iter().chain(&usable).map(|[from, to]| (*from, *to)).collect(),
            back: front.iter().chain(&usable).map(|[from, to]| (*to, *from)).collect(),
            is_front: front.iter().copied().collect(),
        };
        let mut told = Vec::new();
        let mut tell = |edge: [u32; 2]| {
            told.push(named.of(edge));
            told.len() as u32 - 1
        };
        let mut along: BTreeMap<Place, (Place, Option<u32>)> = BTreeMap::new();
        for [from, to] in front {
            along.insert(Place::Second(from), (Place::Second(to), None));
        }
        for edge @ [from, to] in usable {
            along.insert(Place::Second(from), (Place::Second(to), Some(tell(edge))));
        }
        let mut taken = BTreeSet::new();
        for bank @ [from, to] in blocked {
            let exit = ways.back.contains_key(&from).then_some(true);
            let entry = ways.onward.contains_key(&to).then_some(false);
            for is_exit in exit.into_iter().chain(entry) {
                let end = End { bank, is_exit };
                let [on_bank, on_first] = ways.edge_to_first(end, &taken)?;
                taken.insert(on_first);
                let edge = [Place::Second(on_bank), Place::First(on_first)];
                let [from, to] = if is_exit { edge } else { [edge[1], edge[0]] };
                along.insert(from, (to, Some(tell(bank))));
            }
        }
        for (from, to) in &ways.before {
            along.entry(Place::First(*from)).or_insert((Place::First(*to), None));
        }
        let rings = around(&along, &ways)?;
        let offset = first.points.len() as u32;
        let (mut free, mut numbers) = (Vec::new(), BTreeMap::new());
        let mut corner = |place: Place| match place {
            Place::First(vertex) => Corner::Mesh(vertex),
            Place::Second(vertex) => match cut.number(vertex) {
                Some(number) => Corner::Mesh(offset + number),
                None => Corner::Area(*numbers.entry(vertex).or_insert_with(|| {
                    free.push(second.points[vertex as usize]);
                    free.len() as u32 - 1
                })),
            },
        };
        let rings = rings
            .into_iter()
            .map(|ring| ring.into_iter().map(|place| (corner(place), along[&place].1)).collect())
            .collect();
        Ok(Self { rings, free, told })
    }
}

/// The rings of all ways: those along the front, and whole boundaries that nothing else has.
fn around(
    along: &BTreeMap<Place, (Place, Option<u32>)>,
    ways: &Ways<'_>,
) -> Result<Vec<Vec<Place>>, MeshError> {
    let (mut rings, mut is_done) = (Vec::new(), BTreeSet::new());
    // The front first: what is only of the first mesh comes after.
    let starts = ways.is_front.iter().map(|[from, _]| Place::Second(*from));
    let others = along.keys().rev().copied();
    for (is_front, start) in starts.map(|it| (true, it)).chain(others.map(|it| (false, it))) {
        let mut ring: Vec<Place> = Vec::new();
        let mut place = start;
        while is_done.insert(place) {
            ring.push(place);
            let Some((next, _)) = along.get(&place) else { break };
            place = *next;
        }
        if ring.is_empty() {
            continue;
        }
        if place == start {
            rings.push(ring);
        } else if is_front {
            let at = match place {
                Place::First(vertex) => ways.first.points[vertex as usize],
                Place::Second(vertex) => ways.second.points[vertex as usize],
            };
            return Err(MeshError::Refused(format!(
                "the boundaries of the meshes do not lead around the gap near {}: cut one of them back there, and give the area \
                 of the gap with --within (within in Python)",
                shown(at)
            )));
        }
    }
    Ok(rings)
}

impl Ways<'_> {
    /// The best edge from the end of a bank to the first mesh: a vertex of the second mesh, then one of the first.
    fn edge_to_first(&self, end: End, taken: &BTreeSet<u32>) -> Result<[u32; 2], MeshError> {
        let [from, to] = end.bank.map(|vertex| self.second.points[vertex as usize]);
        let (own, other) = if end.is_exit { (from, to) } else { (to, from) };
        let met = self.first.met_by([own, other]);
        let far = |edge: &u32| nearest_of(self.first.ends(*edge), own).distance(own);
        let contact = met.into_iter().min_by(|a, b| far(a).total_cmp(&far(b)));
        let contact = contact.unwrap_or_else(|| self.first.nearest(other).0);
        let place = nearest_of(self.first.ends(contact), own);
        let mut on_first = Vec::new();
        let [mut low, mut high] = self.first.edges[contact as usize];
        for _ in 0..=ASIDE {
            on_first.extend([low, high]);
            (low, high) = (self.before[&low], self.first.next[&high]);
        }
        let mut on_bank = vec![if end.is_exit { end.bank[0] } else { end.bank[1] }];
        while on_bank.len() <= BACK {
            let last = on_bank[on_bank.len() - 1];
            let (way, edge) = match end.is_exit {
                true => (self.back.get(&last), self.back.get(&last).map(|it| [*it, last])),
                false => (self.onward.get(&last), self.onward.get(&last).map(|it| [last, *it])),
            };
            match (way, edge) {
                (Some(&vertex), Some(edge)) if !self.is_front.contains(&edge) => {
                    on_bank.push(vertex)
                }
                _ => break,
            }
        }
        let mut best: Option<(bool, f64, [u32; 2])> = None;
        for &vertex in &on_bank {
            for &target in on_first.iter().filter(|target| !taken.contains(target)) {
                let [q, p] =
                    [self.second.points[vertex as usize], self.first.points[target as usize]];
                let sharpest = self.sharpest([vertex, target], end.is_exit);
                let is_wide = sharpest >= ANGLES[0];
                if sharpest < ANGLES[1] || !self.is_free([vertex, target]) {
                    continue;
                }
                let way = q.distance(p) + p.distance(place) + q.distance(own);
                let cost = if is_wide { way } else { -sharpest };
                let found = (!is_wide, cost, [vertex, target]);
                if best.is_none_or(|best| (found.0, found.1) < (best.0, best.1)) {
                    best = Some(found);
                }
            }
        }
        best.map(|found| found.2).ok_or_else(|| {
            MeshError::Refused(format!(
                "no edge leads from the boundary of the second mesh at {} to the first one: cut one of them back there, and give \
                 the area of the gap with --within (within in Python)",
                shown(own)
            ))
        })
    }

    /// The smaller one of the angles that the gap has at the ends of an edge between the meshes.
    fn sharpest(&self, [vertex, target]: [u32; 2], is_exit: bool) -> f64 {
        let second = |vertex: &u32| self.second.points[*vertex as usize];
        let first = |vertex: &u32| self.first.points[*vertex as usize];
        let [q, p] = [second(&vertex), first(&target)];
        let angles = if is_exit {
            let last = self.back.get(&vertex).map_or(q, second);
            let next = first(&self.before[&target]);
            [angle([p - q, last - q]), angle([next - p, q - p])]
        } else {
            let next = self.onward.get(&vertex).map_or(q, second);
            let last = first(&self.first.next[&target]);
            [angle([next - q, p - q]), angle([q - p, last - p])]
        };
        angles[0].min(angles[1])
    }

    /// Whether an edge between the meshes meets nothing on its way.
    fn is_free(&self, [vertex, target]: [u32; 2]) -> bool {
        let ends = [self.second.points[vertex as usize], self.first.points[target as usize]];
        let of_target = |edge: &u32| self.first.edges[*edge as usize].contains(&target);
        self.first.met_by(ends).iter().all(of_target)
            && self.onward.iter().filter(|(from, to)| **from != vertex && **to != vertex).all(
                |(from, to)| !meet([*from, *to].map(|end| self.second.points[end as usize]), ends),
            )
    }
}
