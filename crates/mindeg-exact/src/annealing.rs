//! A mesh within limits by annealing: flips of random edges, the rarer the more a flip costs.
//!
//! Where nearly every vertex must have as many chords as its limit leaves, a search by clauses has no grip: too many vertices
//! pay for each other. Flips carry a chord too many from vertex to vertex until it meets one that is missing.
//!
//! Limits: it never says that there is no mesh. The temperature stays the same, as the last chords take longest.

use crate::linked::{Linked, chord_counts, is_convex};
use crate::measure::min_angle_tangent;
use crate::problem::Problem;
use crate::progress::Stage;
use mindeg_mesh::{Cancelled, Progress, Random};

/// How readily a flip that costs more is made: with the chance exp(-cost / `WARMTH`).
const WARMTH: f64 = 0.6;

/// A flip that costs as much is never made: its chance is below 2^-53.
const NEVER: usize = 24;

/// Chords that are missing, or beyond the limit, cost nothing more when they are more than these.
const MOST_MISSING: i32 = 4;
const MOST_BEYOND: i32 = 1000;

/// Tries from one report of progress to the next.
const REPORT: u64 = 1 << 16;

/// Looks for triangulations of several faces in which no vertex has more chords than `most_chords` says and no triangle has
/// a [`min_angle_tangent`] below that of its face in `least_tangents`. Each face has the vertex of the whole at every
/// vertex of its own, and begins with the triangulation of its problem. None if so many `tries` of flips find none: they take
/// some 50 ns each. The result depends on the arguments alone.
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
    let mut meshes: Vec<Linked> =
        faces.iter().map(|(problem, _)| problem.triangulation()).collect();
    // What every vertex has beyond its limit, below 0 where it has less.
    let mut beyond: Vec<i32> = most_chords.iter().map(|&most| -(most as i32)).collect();
    for (mesh, (problem, vertices)) in meshes.iter().zip(faces) {
        let chords = chord_counts(problem.points().len(), &mesh.triangles);
        chords.iter().zip(*vertices).for_each(|(&own, &v)| beyond[v as usize] += own as i32);
    }
    let mut excess: i64 = beyond.iter().map(|&own| i64::from(own.max(0))).sum();
    let places: Vec<[u32; 2]> = (0..)
        .zip(&meshes)
        .flat_map(|(face, mesh)| (0..mesh.triangles.len() as u32).map(move |it| [face, it]))
        .collect();
    let chances: Vec<f64> = (0..NEVER).map(|cost| libm::exp(-(cost as f64) / WARMTH)).collect();
    let mut random = Random::new(most_chords.len() as u64);
    for turn in 0..tries {
        if excess == 0 {
            return Ok(Some(meshes.into_iter().map(|mesh| mesh.triangles).collect()));
        }
        if turn.is_multiple_of(REPORT) {
            stage.report(turn as f64 / tries as f64)?;
        }
        let at = random.below(3 * places.len());
        let ([face, triangle], edge) = (places[at / 3], at % 3);
        let mesh = &mut meshes[face as usize];
        let Some(corners) = mesh.corners_at(triangle, edge) else { continue };
        let (problem, vertices) = faces[face as usize];
        let [a, b, c, d] = corners;
        let ends = [(c, 1), (d, 1), (a, -1), (b, -1)];
        // One after another, as several may be one vertex of the whole.
        let (mut change, mut more) = (0, 0);
        for (corner, by) in ends {
            let own = &mut beyond[vertices[corner as usize] as usize];
            change += cost(*own + by) - cost(*own);
            more += i64::from((*own + by).max(0) - (*own).max(0));
            *own += by;
        }
        let is_tried = change <= 0
            || chances.get(change as usize).is_some_and(|&chance| random.unit() < chance);
        let points = problem.points();
        let least = least_tangents[face as usize];
        let is_wide = |corners: [u32; 3]| {
            least <= 0.0 || min_angle_tangent(corners.map(|v| points[v as usize])) >= least
        };
        if is_tried
            && is_convex(corners.map(|v| points[v as usize]))
            && !problem.sides().forbids(points, [c, d, a, b])
            && is_wide([c, a, d])
            && is_wide([d, b, c])
        {
            mesh.flip(triangle, edge);
            excess += more;
        } else {
            ends.iter().for_each(|&(corner, by)| beyond[vertices[corner as usize] as usize] -= by);
        }
    }
    Ok(None)
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

    /// A fan of a regular polygon.
    fn fan(corners: u32) -> Problem {
        let at = |corner: u32| {
            DVec2::from_angle(f64::from(corner) * std::f64::consts::TAU / f64::from(corners))
        };
        let boundary = PlanarBoundary::new(&[Vec::from_iter((0..corners).map(at))]).unwrap();
        let fan: Vec<[u32; 3]> = (1..corners - 1).map(|it| [0, it, it + 1]).collect();
        Problem::triangulated(&boundary, &fan).unwrap()
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
        // Each flip keeps the angle, here that of the fan: 180 / 20 degrees.
        let least = libm::tan(std::f64::consts::PI / 20.5);
        let kept = anneal_one(&problem, 3, least).unwrap();
        let tangent = |it: &[u32; 3]| min_angle_tangent(it.map(|v| problem.points()[v as usize]));
        assert!(kept.iter().all(|triangle| tangent(triangle) >= least));
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
