//! The domains of a planar subdivision: the rings, lines and regions of each.

use std::collections::{BTreeMap, BTreeSet};

use glam::DVec2;
use mindeg_domain::InnerPoint;
use mindeg_mesh::DisjointSets;

use super::gaps::Gap;
use super::inner_point::inner_point;
use super::plane::{Plane, Run};
use crate::error::OutlineError;
use crate::nesting::{Loop, smallest_around};
use crate::overlay::edge::{Step, points_of};
use crate::overlay::faces::Graph;
use crate::overlay::turns_left;
use crate::text::shown;

/// The region of a face, and a point in it.
type Face = (u32, DVec2);

/// The rings and lines of one domain, and its regions.
pub(super) struct Part {
    pub(super) outer: Run,
    pub(super) holes: Vec<Run>,
    pub(super) lines: Vec<Run>,
    pub(super) regions: Vec<Face>,
    /// Points in holes whose rings are among the lines, because they touch other rings.
    pub(super) hole_faces: Vec<DVec2>,
    around: Loop,
}

/// The part that a point lies in, or at a vertex of whose outer ring: of several around it the smallest, since parts lie in
/// holes of others.
pub(super) fn part_around(parts: &[Part], at: DVec2) -> Option<usize> {
    let at_vertex = parts.iter().position(|part| part.around.points.contains(&at));
    let around = || smallest_around(parts.iter().map(|part| &part.around).enumerate(), &[at]);
    at_vertex.or_else(around)
}

/// The parts, each with the set of regions that share edges.
struct Parts {
    parts: Vec<Part>,
    of_set: BTreeMap<u32, Vec<usize>>,
}

impl Parts {
    /// The part of a set of regions around some points: where regions touch themselves, a set has several.
    fn around(&mut self, set: u32, points: &[DVec2]) -> Option<&mut Part> {
        let of_set = self.of_set.get(&set)?;
        let loops = |&part: &usize| (part, &self.parts[part].around);
        let part = match &of_set[..] {
            [only] => *only,
            several => smallest_around(several.iter().map(loops), points)?,
        };
        self.parts.get_mut(part)
    }
}

/// The domains of a plane with points inside, in the order of their first regions, and the longest gap between regions.
pub(super) fn parts(
    plane: &Plane<'_>,
    regions: usize,
    inner: &[InnerPoint],
) -> Result<(Vec<Part>, Option<Gap>), OutlineError> {
    let graph = Graph::new(&plane.links, &plane.points);
    plane.check_sides(&graph)?;
    let mut sets = DisjointSets::new(regions);
    for link in 0..plane.links.len() {
        if let (Some(one), Some(other)) = (plane.left(2 * link), plane.left(2 * link + 1)) {
            sets.join(one, other);
        }
    }
    let mut set_of = |region: Option<u32>| sets.least(region.unwrap_or_default());
    let is_bound = |half: usize| plane.left(half).is_some() && plane.left(half ^ 1).is_none();
    let mut found = Parts { parts: Vec::new(), of_set: BTreeMap::new() };
    let mut holes = Vec::new();
    for ((), steps) in graph.rings(|half| is_bound(half).then_some(())) {
        let points = points_of(&steps, &plane.points);
        let set = set_of(plane.left_of(&steps[0]));
        let run = Run { end: steps[0].from, steps };
        if turns_left(&points) {
            found.of_set.entry(set).or_default().push(found.parts.len());
            let (holes, lines) = (Vec::new(), Vec::new());
            let (regions, hole_faces) = (Vec::new(), Vec::new());
            let around = Loop::new(points);
            found.parts.push(Part { outer: run, holes, lines, regions, hole_faces, around });
        } else {
            holes.push((set, run, points));
        }
    }
    for (set, run, points) in holes {
        if let Some(part) = found.around(set, &points) {
            part.holes.push(run);
        }
    }
    for run in inner_runs(plane, &graph) {
        let [a, b] = plane.ends(run.steps[0].chord);
        let middle = a + (b - a) / 2.0;
        let region = plane.left_of(&run.steps[0]);
        let region = region.or_else(|| plane.regions_around(middle).first().copied());
        if let Some(part) = found.around(set_of(region), &[middle]) {
            part.lines.push(run);
        }
    }
    let (faces, gap) = faces(plane, &graph, regions, inner)?;
    for (region, at) in faces {
        if let Some(part) = found.around(set_of(Some(region)), &[at]) {
            part.regions.push((region, at));
        }
    }
    let mut parts = found.parts;
    parts.iter_mut().try_for_each(|part| part_touching_holes(plane, part))?;
    parts.sort_by_key(|part| part.regions.first().map(|region| region.0));
    Ok((parts, gap))
}

/// The runs of edges between two regions, or inside one, between nodes.
fn inner_runs(plane: &Plane<'_>, graph: &Graph<'_>) -> Vec<Run> {
    let is_inner = |half: usize| plane.left(half).is_some() == plane.left(half ^ 1).is_some();
    let mut used = vec![false; plane.links.len()];
    let mut runs = Vec::new();
    // From nodes first, so that what is left closes.
    for wants_node in [true, false] {
        for vertex in (0..plane.points.len()).filter(|&v| plane.is_node[v] == wants_node) {
            for &first in &graph.around[vertex] {
                if used[first / 2] || !is_inner(first) {
                    continue;
                }
                let mut steps: Vec<Step> = Vec::new();
                let mut next = Some(first);
                let mut end = vertex as u32;
                while let Some(half) = next {
                    used[half / 2] = true;
                    steps.push(plane.step(half));
                    end = graph.end(half);
                    let onward = graph.around[end as usize].iter().find(|&&it| !used[it / 2]);
                    next = onward.copied().filter(|_| !plane.is_node[end as usize]);
                }
                runs.push(Run { steps, end });
            }
        }
    }
    runs
}

/// The faces inside regions, each with its region and a point in it, in the order of the regions; and the longest gap.
fn faces(
    plane: &Plane<'_>,
    graph: &Graph<'_>,
    regions: usize,
    inner: &[InnerPoint],
) -> Result<(Vec<Face>, Option<Gap>), OutlineError> {
    let mut edges: Vec<Vec<[DVec2; 2]>> = vec![Vec::new(); regions];
    // The point in a face may be none of the points inside.
    let mut lines: Vec<[DVec2; 2]> = inner.iter().map(|point| [point.at; 2]).collect();
    for chord in 0..plane.chords.len() as u32 {
        let beside = plane.border(chord).beside;
        beside.iter().flatten().for_each(|&region| edges[region as usize].push(plane.ends(chord)));
        lines.extend((beside == [None; 2]).then(|| plane.ends(chord)));
    }
    edges.iter_mut().for_each(|edges| edges.extend_from_slice(&lines));
    let (mut faces, mut gap) = (Vec::new(), None);
    for ((), steps) in graph.rings(|_| Some(())) {
        let ring = points_of(&steps, &plane.points);
        // A ring of two steps goes there and back.
        if steps.len() < 3 || !turns_left(&ring) {
            continue;
        }
        let is_line = |step: &Step| plane.border(step.chord).beside == [None; 2];
        let region = match steps.iter().all(is_line) {
            // Lines have no region beside them: they lie inside one.
            true => plane.regions_around(ring[0].midpoint(ring[1])).first().copied(),
            false => steps.iter().find_map(|step| plane.left_of(step)),
        };
        let Some(region) = region else {
            gap = Gap::longer(gap, Gap::of(plane, &steps, &ring));
            continue;
        };
        let at = inner_point(&ring, &edges[region as usize]);
        let at = at.ok_or_else(|| too_thin("region", ring[0]))?;
        faces.push((region, at));
    }
    faces.sort_by_key(|face| face.0);
    Ok((faces, Gap::longer(gap, Gap::open(plane))))
}

/// Makes lines of the holes that touch the outline or a hole before: rings may not touch, lines may.
fn part_touching_holes(plane: &Plane<'_>, part: &mut Part) -> Result<(), OutlineError> {
    let mut seen: BTreeSet<u32> = part.outer.steps.iter().map(|step| step.from).collect();
    for run in std::mem::take(&mut part.holes) {
        if run.steps.iter().any(|step| seen.contains(&step.from)) {
            let mut ring = points_of(&run.steps, &plane.points);
            ring.reverse();
            let edges: Vec<[DVec2; 2]> =
                run.steps.iter().map(|step| plane.ends(step.chord)).collect();
            part.hole_faces
                .push(inner_point(&ring, &edges).ok_or_else(|| too_thin("hole", ring[0]))?);
            part.lines.push(run);
        } else {
            seen.extend(run.steps.iter().map(|step| step.from));
            part.holes.push(run);
        }
    }
    Ok(())
}

fn too_thin(what: &str, at: DVec2) -> OutlineError {
    let place = format!("the {what} at {}", shown(at));
    OutlineError::place(place, "it is too thin for 64-bit floats; simplify it, or drop it")
        .telling([at])
}
