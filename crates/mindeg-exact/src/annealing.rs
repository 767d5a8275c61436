//! A mesh within limits by annealing: flips of random edges, the rarer the more a flip costs.
//!
//! Where nearly every vertex must have as many chords as its limit leaves, a search by clauses has no grip: too many vertices
//! pay for each other. Flips carry a chord too many from vertex to vertex until it meets one that is missing.
//!
//! Limits: it never says that there is no mesh.

use crate::linked::{Linked, chord_counts, is_convex};
use crate::measure::min_angle_tangent;
use crate::problem::Problem;
use crate::progress::Stage;
use half_edges::HalfEdges;
use mindeg_mesh::{Cancelled, Progress, Random};

mod half_edges;

/// How readily a flip that costs more is made: with the chance exp(-cost / warmth). It sinks from the first to the second,
/// again and again, since what is frozen too early must melt.
const WARMTH: [f64; 2] = [0.8, 0.5];

/// The tries in which it sinks once.
const COOLING: u64 = 1 << 25;

/// Where more chords than these are still beyond their limits at the best of several coolings, none will be found soon.
const HOPELESS: (u64, i64) = (4, 2);

/// A flip that costs as much is never made: its chance is below 2^-43.
const NEVER: usize = 24;

/// Chords that are missing, or beyond the limit, cost nothing more when they are more than these.
const MOST_MISSING: i32 = 4;
const MOST_BEYOND: i32 = 1000;

/// Tries from one report of progress, and one warmth, to the next.
const REPORT: u64 = 1 << 16;

/// Looks for triangulations of several faces in which no vertex has more chords than `most_chords` says and no triangle has
/// a [`min_angle_tangent`] below that of its face in `least_tangents`. Each face has the vertex of the whole at every
/// vertex of its own, and begins with the triangulation of its problem. None if so many `tries` of flips find none, or the
/// first of them do not come near one: they take some 15 ns each. The result depends on the arguments alone.
///
/// # Errors
///
/// A cancelled `progress`.
pub fn anneal(
    faces: &[(&Problem, &[u32])],
    most_chords: &[u32],
    least_tangents: &[f64],
    tries: u64,
    progress: Progress<'_>,
) -> Result<Option<Vec<Vec<[u32; 3]>>>, Cancelled> {
    let stage = Stage::new(progress, "flipping edges");
    let meshes: Vec<Linked> = faces.iter().map(|(problem, _)| problem.triangulation()).collect();
    // The edges of every vertex beyond its limit; below 0 where it has fewer.
    let mut beyond: Vec<i32> = most_chords.iter().map(|&most| -(most as i32)).collect();
    let (mut first_places, mut vertices) = (Vec::with_capacity(faces.len()), Vec::new());
    for (mesh, (problem, own)) in meshes.iter().zip(faces) {
        let chords = chord_counts(problem.points().len(), &mesh.triangles);
        chords.iter().zip(*own).for_each(|(&chords, &v)| beyond[v as usize] += chords as i32);
        first_places.push(vertices.len() as u32);
        vertices.extend_from_slice(own);
    }
    let mut halves = HalfEdges::new(&meshes, &first_places);
    let chords = halves.chords();
    let mut excess: i64 = beyond.iter().map(|&own| i64::from(own.max(0))).sum();
    let mut least = excess;
    let mut chances = [0.0; NEVER];
    // Of several turns, each goes another way.
    let mut random = Random::new(tries);
    for turn in 0..tries {
        if excess == 0 {
            return Ok(Some(halves.triangles(&first_places)));
        }
        if turn.is_multiple_of(REPORT) {
            stage.report(turn as f64 / tries as f64)?;
            if turn >= HOPELESS.0 * COOLING && least > HOPELESS.1 {
                break;
            }
            chances = chances_at((turn % COOLING) as f64 / COOLING as f64);
        }
        let Some(&[chord, face]) = chords.get(random.below(chords.len())) else { break };
        let corners = halves.corners_at(chord);
        let [a, b, c, d] = corners.map(|place| vertices[place as usize] as usize);
        let ends = [(c, 1), (d, 1), (a, -1), (b, -1)];
        // One after another, as several may be one vertex of the whole.
        let (mut change, mut more) = (0, 0);
        for (vertex, by) in ends {
            let own = &mut beyond[vertex];
            change += cost(*own + by) - cost(*own);
            more += i64::from((*own + by).max(0) - (*own).max(0));
            *own += by;
        }
        let is_tried = change <= 0
            || chances.get(change as usize).is_some_and(|&chance| random.unit() < chance);
        let is_possible = || {
            let problem = faces[face as usize].0;
            let points = problem.points();
            let [a, b, c, d] = corners.map(|place| place - first_places[face as usize]);
            let tangent = least_tangents[face as usize];
            let is_wide = |corners: [u32; 3]| {
                tangent <= 0.0 || min_angle_tangent(corners.map(|v| points[v as usize])) >= tangent
            };
            !problem.sides().forbids(points, [c, d, a, b])
                && is_convex([a, b, c, d].map(|v| points[v as usize]))
                && is_wide([c, a, d])
                && is_wide([d, b, c])
        };
        if is_tried && is_possible() {
            halves.flip(chord);
            excess += more;
            least = least.min(excess);
        } else {
            ends.iter().for_each(|&(vertex, by)| beyond[vertex] -= by);
        }
    }
    Ok(None)
}

/// For each cost the chance of a flip, after a part of one cooling.
fn chances_at(part: f64) -> [f64; NEVER] {
    let [from, to] = WARMTH;
    let warmth = from * libm::pow(to / from, part);
    std::array::from_fn(|cost| libm::exp(-(cost as f64) / warmth))
}

/// The cost of a vertex with so many chords beyond its limit: squares, so that they spread.
fn cost(beyond: i32) -> i32 {
    let beyond = beyond.clamp(-MOST_MISSING, MOST_BEYOND);
    if beyond > 0 { 2 * beyond.pow(2) } else { beyond.pow(2) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec2;
    use mindeg_mesh::planar::PlanarBoundary;

    /// A fan of a regular polygon, stretched across the direction of its center.
    fn stretched_fan(corners: u32, stretch: f64) -> Problem {
        let at = |corner: u32| {
            let angle = f64::from(corner) * std::f64::consts::TAU / f64::from(corners);
            DVec2::new(libm::cos(angle), stretch * libm::sin(angle))
        };
        let boundary = PlanarBoundary::new(&[Vec::from_iter((0..corners).map(at))]).unwrap();
        let fan: Vec<[u32; 3]> = (1..corners - 1).map(|it| [0, it, it + 1]).collect();
        Problem::triangulated(&boundary, &fan).unwrap()
    }

    fn fan(corners: u32) -> Problem {
        stretched_fan(corners, 1.0)
    }

    fn anneal_one(problem: &Problem, most: u32, least: f64) -> Option<Vec<[u32; 3]>> {
        let n = problem.points().len();
        let vertices = Vec::from_iter(0..n as u32);
        let faces = [(problem, &vertices[..])];
        let found = anneal(&faces, &vec![most; n], &[least], 100_000, Progress::NONE).unwrap();
        found.map(|mut faces| faces.remove(0))
    }

    #[test]
    fn a_fan_becomes_a_zig_zag_and_no_less() {
        let problem = fan(20);
        let found = anneal_one(&problem, 2, 0.0).unwrap();
        let chords = chord_counts(20, &found);
        assert_eq!((found.len(), chords.iter().max()), (18, Some(&2)));
        assert_eq!(chords.iter().sum::<u32>(), 2 * 17);
        assert_eq!(anneal_one(&problem, 1, 0.0), None);
    }

    #[test]
    fn angles_are_kept() {
        let problem = stretched_fan(12, 4.0);
        let tangent = |triangles: &[[u32; 3]]| {
            let of = |it: &[u32; 3]| min_angle_tangent(it.map(|v| problem.points()[v as usize]));
            triangles.iter().map(of).fold(f64::INFINITY, f64::min)
        };
        let least = tangent(&problem.triangulation().triangles);
        // The first of the ways to 3 chords has a smaller angle.
        let found = |least| tangent(&anneal_one(&problem, 3, least).unwrap());
        assert!(found(0.0) < least);
        assert!(found(least) >= least);
    }

    #[test]
    fn two_sides_of_a_sheet_share_the_limits_of_their_vertices() {
        let (front, back) = (fan(9), fan(9));
        let vertices: Vec<u32> = (0..9).collect();
        let turned: Vec<u32> = (0..9).map(|it| (9 - it) % 9).collect();
        let faces = [(&front, &vertices[..]), (&back, &turned[..])];
        let decide = |most| anneal(&faces, &[most; 9], &[0.0; 2], 100_000, Progress::NONE).unwrap();
        // 12 chords on 9 vertices.
        assert_eq!(decide(2), None);
        let found = decide(3).unwrap();
        let [a, b] = [0, 1].map(|face| chord_counts(9, &found[face]));
        assert!((0..9).all(|v| a[v] + b[(9 - v) % 9] <= 3), "{a:?} {b:?}");
    }
}
