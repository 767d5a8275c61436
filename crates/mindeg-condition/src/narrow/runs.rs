//! Runs of narrow triangles: which are closed or opened, and which stay.

use super::plane::{Plane, Triangle};
use super::pockets::{is_deep, pockets};
use super::rules::{Narrows, Rules};
use super::trace::is_on_ring;
use crate::chains::NONE;
use crate::changes::{BoundaryChange, ChangeKind, Narrow, NarrowReason, Why};
use crate::demands::Hold;
use crate::grid::Grid;
use glam::DVec2;

/// So often runs that may not change are left out, and the rest is looked at anew.
const TRIES: usize = 1000;

/// The triangles that change sides.
pub(super) struct Turned {
    pub(super) is_turned: Vec<bool>,
    pub(super) changes: Vec<BoundaryChange>,
    pub(super) narrow: Vec<Narrow>,
}

/// Triangles that hang together.
struct Run {
    triangles: Vec<u32>,
    /// Sides towards what is wider.
    mouths: Vec<(u32, usize)>,
    /// Where it is narrowest, and how narrow.
    at: DVec2,
    width: f64,
    /// The change of it, or why it stays; none if it is no deeper than wide.
    plan: Option<Result<ChangeKind, NarrowReason>>,
}

/// The narrow places of one kind that change sides.
pub(super) fn turned<'p>(plane: &'p Plane<'p>, rules: &Rules<'p>, kind: Narrows) -> Turned {
    let mut found = Runs::new(plane, rules, kind);
    for _ in 0..TRIES {
        found.turn();
        let faults = found.faults();
        if faults.is_empty() {
            break;
        }
        for run in faults {
            found.all[run as usize].plan = Some(Err(NarrowReason::Kept));
        }
    }
    let of_width = |kind, at| BoundaryChange { kind, at, why: Why::Width, edge: None, moved: None };
    let of_runs = found.all.iter().filter_map(|run| {
        let kind = (*run.plan.as_ref()?).ok()?;
        Some(of_width(kind, run.at))
    });
    let changes =
        of_runs.chain(found.basins.iter().map(|basin| of_width(ChangeKind::BasinDropped, *basin)));
    let stays = found.all.iter().filter_map(|run| {
        let reason = (*run.plan.as_ref()?).err()?;
        Some(Narrow { at: run.at, width: run.width, reason })
    });
    let (changes, narrow) = (changes.collect(), stays.collect());
    Turned { is_turned: found.owner.iter().map(|owner| *owner != NONE).collect(), changes, narrow }
}

struct Runs<'p> {
    plane: &'p Plane<'p>,
    kind: Narrows,
    all: Vec<Run>,
    /// The run of each narrow triangle.
    of: Vec<u32>,
    /// The run by which each triangle changes sides.
    owner: Vec<u32>,
    /// A place within each part that was cut off with a strait.
    basins: Vec<DVec2>,
    /// The straits whose basins have a point that stays in the domain.
    marked: Vec<u32>,
    marks: (&'p [DVec2], Grid),
    /// The parts of the domain, of each triangle and by parts.
    wholes: (Vec<u32>, Vec<Vec<u32>>),
    /// The triangles at each node, those of node n from `starts[n]` on.
    at_nodes: Vec<u32>,
    starts: Vec<u32>,
}

impl<'p> Runs<'p> {
    fn new(plane: &'p Plane<'p>, rules: &Rules<'p>, kind: Narrows) -> Self {
        let count = plane.triangles.len();
        let is_wanted = |index: u32| {
            let triangle = &plane.triangles[index as usize];
            triangle.is_narrow && triangle.is_of(kind)
        };
        let (mut of, groups) = parts(plane, is_wanted, |triangle, side| {
            plane.triangles[triangle as usize].is_open(side)
        });
        let mut all: Vec<Run> = groups.into_iter().map(|own| run(plane, own, &of)).collect();
        let marks = (rules.marks, Grid::new(rules.marks));
        let planned =
            |run: &Run, of: &[u32]| plan(plane, run, of, kind, |it| is_marked(plane, &marks, it));
        for index in 0..all.len() {
            all[index].plan = planned(&all[index], &of);
            if !matches!(all[index].plan, None | Some(Err(NarrowReason::Between))) {
                continue;
            }
            for own in pockets(plane, &all[index].triangles, &of) {
                let new = all.len() as u32;
                own.iter().for_each(|triangle| of[*triangle as usize] = new);
                let mut pocket = run(plane, own, &of);
                pocket.plan = planned(&pocket, &of);
                all.push(pocket);
            }
        }
        let wholes = match kind {
            Narrows::Domain => waters(plane, |index| plane.triangles[index as usize].is_domain),
            Narrows::Outside => Default::default(),
        };
        let (at_nodes, starts) = around_nodes(plane);
        Self {
            plane,
            kind,
            all,
            of,
            owner: vec![NONE; count],
            basins: Vec::new(),
            marked: Vec::new(),
            marks,
            wholes,
            at_nodes,
            starts,
        }
    }

    /// Turns what is planned, and of each water that a strait parts all but the largest part.
    fn turn(&mut self) {
        self.basins.clear();
        self.marked.clear();
        for index in 0..self.owner.len() {
            let run = self.of[index];
            let is_planned = run != NONE && matches!(self.all[run as usize].plan, Some(Ok(_)));
            self.owner[index] = if is_planned { run } else { NONE };
        }
        if self.kind == Narrows::Outside {
            return;
        }
        let plane = self.plane;
        let (whole, wholes) = &self.wholes;
        let is_left = |index: u32| {
            plane.triangles[index as usize].is_domain && self.owner[index as usize] == NONE
        };
        let (_, basins) = waters(plane, is_left);
        let area = |own: &Vec<u32>| -> f64 {
            own.iter().map(|triangle| plane.triangles[*triangle as usize].area).sum()
        };
        let mut largest = vec![(0.0, usize::MAX); wholes.len()];
        for (index, own) in basins.iter().enumerate() {
            let (whole, area) = (whole[own[0] as usize] as usize, area(own));
            if area > largest[whole].0 {
                largest[whole] = (area, index);
            }
        }
        for (index, own) in basins.iter().enumerate() {
            if largest[whole[own[0] as usize] as usize].1 == index {
                continue;
            }
            // It goes with a strait that cut it off.
            let beside = own.iter().flat_map(|triangle| plane.triangles[*triangle as usize].beside);
            let strait =
                beside.filter(|other| *other != NONE).map(|other| self.owner[other as usize]);
            let strait = strait.filter(|owner| *owner != NONE).min();
            let Some(strait) = strait else { continue };
            if own.iter().any(|triangle| is_marked(plane, &self.marks, *triangle)) {
                self.marked.push(strait);
            }
            own.iter().for_each(|triangle| self.owner[*triangle as usize] = strait);
            let most = own.iter().max_by(|a, b| {
                let area = |triangle: u32| plane.triangles[triangle as usize].area;
                area(**a).total_cmp(&area(**b))
            });
            let at = most.map_or(DVec2::ZERO, |triangle| center(plane, *triangle));
            self.basins.push(at);
        }
    }

    /// The runs that may not change as planned: where the boundary would touch itself, or something that stays would go.
    fn faults(&self) -> Vec<u32> {
        let plane = self.plane;
        let is_turned: Vec<bool> = self.owner.iter().map(|owner| *owner != NONE).collect();
        let mut faults = self.marked.clone();
        for (index, triangle) in (0..).zip(&plane.triangles) {
            let owner = self.owner[index as usize];
            if owner == NONE {
                continue;
            }
            let is_held = |side: usize| triangle.pieces[side].is_some_and(|piece| piece.is_held);
            if (0..3).any(is_held) {
                faults.push(owner);
            }
            for node in triangle.corners.into_iter().flatten() {
                let own = &plane.pieces.nodes[node as usize];
                let begins = self.around(node).filter(|other| {
                    let corners = plane.triangles[*other as usize].corners;
                    let side = corners.iter().position(|corner| *corner == Some(node));
                    side.is_some_and(|side| is_on_ring(plane, &is_turned, *other, side))
                });
                let begins = begins.count();
                let is_lost = begins == 0 && own.hold >= Hold::End;
                // A place of lines alone is on no ring.
                let is_free = !own.is_shared && own.point.is_some();
                if !is_free || begins > 1 || is_lost {
                    faults.extend(self.around(node).map(|other| self.owner[other as usize]));
                }
            }
        }
        faults.sort_unstable();
        faults.dedup();
        faults.retain(|run| *run != NONE);
        faults
    }

    fn around(&self, node: u32) -> impl Iterator<Item = u32> + use<'_> {
        let range = self.starts[node as usize] as usize..self.starts[node as usize + 1] as usize;
        self.at_nodes[range].iter().copied()
    }
}

/// The triangles at each node, and where those of each begin.
fn around_nodes(plane: &Plane<'_>) -> (Vec<u32>, Vec<u32>) {
    let corners = |(index, triangle): (u32, &Triangle)| {
        triangle.corners.into_iter().flatten().map(move |node| (node, index))
    };
    let mut all: Vec<(u32, u32)> = (0..).zip(&plane.triangles).flat_map(corners).collect();
    all.sort_unstable();
    let mut starts = vec![0; plane.pieces.nodes.len() + 1];
    for (node, _) in &all {
        starts[*node as usize + 1] += 1;
    }
    for node in 1..starts.len() {
        starts[node] += starts[node - 1];
    }
    (all.into_iter().map(|(_, triangle)| triangle).collect(), starts)
}

/// The parts of the wanted triangles that hang together through some sides: the part of each triangle, and the triangles of each
/// part.
fn parts(
    plane: &Plane<'_>,
    is_wanted: impl Fn(u32) -> bool,
    is_through: impl Fn(u32, usize) -> bool,
) -> (Vec<u32>, Vec<Vec<u32>>) {
    let mut of = vec![NONE; plane.triangles.len()];
    let mut groups: Vec<Vec<u32>> = Vec::new();
    for first in 0..plane.triangles.len() as u32 {
        if of[first as usize] != NONE || !is_wanted(first) {
            continue;
        }
        let group = groups.len() as u32;
        of[first as usize] = group;
        let (mut own, mut next) = (vec![first], 0);
        while next < own.len() {
            let triangle = own[next];
            next += 1;
            for side in 0..3 {
                let other = plane.triangles[triangle as usize].beside[side];
                let is_new = other != NONE && of[other as usize] == NONE;
                if is_new && is_through(triangle, side) && is_wanted(other) {
                    of[other as usize] = group;
                    own.push(other);
                }
            }
        }
        groups.push(own);
    }
    (of, groups)
}

/// The parts of the domain: those that borders between regions part are one.
fn waters(plane: &Plane<'_>, is_wanted: impl Fn(u32) -> bool) -> (Vec<u32>, Vec<Vec<u32>>) {
    parts(plane, is_wanted, |triangle, side| {
        let piece = plane.triangles[triangle as usize].pieces[side];
        piece.is_none_or(|piece| piece.has_domain == [true; 2])
    })
}

/// A run of triangles, without a plan.
fn run(plane: &Plane<'_>, triangles: Vec<u32>, of: &[u32]) -> Run {
    let mut mouths = Vec::new();
    let (mut width, mut at) = (f64::INFINITY, center(plane, triangles[0]));
    for &triangle in &triangles {
        let own = &plane.triangles[triangle as usize];
        for side in (0..3).filter(|side| own.is_open(*side)) {
            let other = own.beside[side];
            if other == NONE || of[other as usize] != of[triangle as usize] {
                mouths.push((triangle, side));
            }
            let length = plane.length(triangle, side);
            if let (true, Some([a, b])) = (length < width, plane.ends(triangle, side)) {
                (width, at) = (length, plane.at(a).midpoint(plane.at(b)));
            }
        }
    }
    Run { triangles, mouths, at, width, plan: None }
}

/// The change of a run, or why it stays.
fn plan(
    plane: &Plane<'_>,
    run: &Run,
    of: &[u32],
    kind: Narrows,
    is_marked: impl Fn(u32) -> bool,
) -> Option<Result<ChangeKind, NarrowReason>> {
    let planned = match (&run.mouths[..], kind) {
        ([], _) => return Some(Err(NarrowReason::Everywhere)),
        (&[(triangle, side)], _) => {
            // A run no deeper than wide is a bay, or a cape.
            if !is_deep(plane, triangle, side, of) {
                return None;
            }
            if kind == Narrows::Domain { ChangeKind::InletClosed } else { ChangeKind::SpitCut }
        }
        (_, Narrows::Domain) => ChangeKind::StraitClosed,
        (_, Narrows::Outside) => return Some(Err(NarrowReason::Between)),
    };
    let stays = |triangle: u32| {
        let mut pieces = plane.triangles[triangle as usize].pieces.iter().flatten();
        pieces.any(|piece| piece.is_held) || is_marked(triangle)
    };
    let stays = run.triangles.iter().any(|triangle| stays(*triangle));
    Some(if stays { Err(NarrowReason::Kept) } else { Ok(planned) })
}

/// Whether a point that changes no side is in a triangle.
fn is_marked(plane: &Plane<'_>, (marks, grid): &(&[DVec2], Grid), triangle: u32) -> bool {
    let [Some(a), Some(b), Some(c)] = plane.triangles[triangle as usize].corners else {
        return false;
    };
    let corners = [a, b, c].map(|node| plane.at(node));
    grid.any_within(corners, |mark| marks[mark as usize], |_| true)
}

fn center(plane: &Plane<'_>, triangle: u32) -> DVec2 {
    let corners = plane.triangles[triangle as usize].corners.into_iter().flatten();
    let at: Vec<DVec2> = corners.map(|node| plane.at(node)).collect();
    at.iter().sum::<DVec2>() / at.len().max(1) as f64
}
