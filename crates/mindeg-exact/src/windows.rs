//! Fewer edges at the vertices with the most, by windows around them, in near-linear time.

use crate::linked::Linked;
use crate::measure::{self, least_tangent};
use crate::problem::Problem;
use crate::progress::Stage;
use crate::unsolved::Unsolved;
use crate::window::{Aim, Work};
use mindeg_mesh::Progress;
use mindeg_mesh::parallel::sort_all;
use std::collections::BTreeMap;

/// Triangles of a window, from the first try to the last.
const SIZES: [usize; 5] = [12, 24, 48, 96, 192];

/// The most positions that are tried in a fan larger than the window.
const PLACES: usize = 64;

/// Vertices from one report of progress to the next.
const REPORT: u32 = 64;

/// The result of [`windows()`].
#[derive(Clone, Debug, PartialEq)]
pub struct Windowed {
    /// The triangles, counter-clockwise, in ascending order.
    pub triangles: Vec<[u32; 3]>,
    /// The largest number of edges at a vertex, external ones included.
    pub max_degree: u32,
    /// Whether the triangles keep the degree limits of single vertices.
    pub keeps_vertex_limits: bool,
    /// The minimum angle, in degrees: at least the smaller one of the demanded one and of the given
    /// triangulation's.
    pub min_angle: f64,
}

/// Takes edges off the vertices with the most of them: an upper bound on the least maximum degree,
/// at a guaranteed minimum angle.
///
/// The work ends when no vertex has more than `max_degree` edges, external ones included; 0 asks for as few as
/// possible. No new triangle has a smaller [`min_angle_tangent`](measure::min_angle_tangent) than
/// `min_tangent`; 0 allows any.
///
/// The start is the given triangulation; for [`Problem::new`], that of the formula. A window is the
/// fan of such a vertex with some triangles around it, a disk. The exact dynamic program finds a
/// triangulation of it in which the vertex has fewer edges and every other one keeps its limit. The
/// work ends at the first vertex with the most edges that no window of 12 to 192 triangles
/// improves. Any domain is possible, with holes too.
///
/// Near-linear time: each window takes constant time, and the sum of the excess degrees falls with
/// each. The same input has the same answer on every machine.
///
/// # Errors
///
/// A cancelled `progress`.
///
/// # Example
///
/// ```
/// use glam::DVec2;
/// use mindeg_exact::{Problem, Progress, windows};
/// use mindeg_mesh::planar::PlanarBoundary;
///
/// // A regular octagon, as a fan.
/// let at = |corner: u32| DVec2::from_angle(f64::from(corner) * std::f64::consts::FRAC_PI_4);
/// let points: Vec<DVec2> = (0..8).map(at).collect();
/// let fan: Vec<[u32; 3]> = (1..7).map(|corner| [0, corner, corner + 1]).collect();
/// let problem = Problem::triangulated(&PlanarBoundary::new(&[points])?, &fan)?;
/// assert_eq!(windows(&problem, 0, 0.0, Progress::NONE)?.max_degree, 4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn windows(
    problem: &Problem,
    max_degree: u32,
    min_tangent: f64,
    progress: Progress<'_>,
) -> Result<Windowed, Unsolved> {
    let mut work = Work::new(problem, problem.triangulation());
    let own_limit = |vertex: u32| problem.own_limit(vertex).unwrap_or(u32::MAX);
    let vertices = 0..problem.points().len() as u32;
    let mut resume = BTreeMap::new();

    // First the degree limits of single vertices, whatever edges the others get.
    let stage = Stage::new(progress, "keeping the degree limits of vertices");
    let mut keeps_vertex_limits = true;
    let mut tries = 0;
    for vertex in vertices.clone() {
        while work.totals[vertex as usize] > own_limit(vertex) {
            if tries % REPORT == 0 {
                stage.report(f64::from(vertex) / f64::from(vertices.end))?;
            }
            tries += 1;
            let aim = Aim {
                vertex,
                keep: work.totals[vertex as usize] - 1,
                limit: &own_limit,
                threshold: min_tangent,
            };
            if improve(&mut work, &aim, &mut resume).is_none() {
                keeps_vertex_limits = false;
                break;
            }
        }
    }

    let mut with_total = BTreeMap::<u32, Vec<u32>>::new();
    for vertex in vertices {
        let total = work.totals[vertex as usize];
        if total > max_degree {
            with_total.entry(total).or_default().push(vertex);
        }
    }
    let start = with_total.keys().next_back().map_or(0.0, |&total| f64::from(total));
    'levels: while let Some((total, mut level)) = with_total.pop_last() {
        level.sort_unstable();
        level.dedup();
        let stage = Stage::new(progress, format!("taking edges off vertices of degree {total}"));
        let share = ((start - f64::from(total)) / start).clamp(0.0, 1.0);
        for vertex in level {
            if work.totals[vertex as usize] != total {
                continue;
            }
            if tries % REPORT == 0 {
                stage.report(share)?;
            }
            tries += 1;
            // Far from the goal, many edges of the window go at once, to vertices with far fewer
            // edges.
            let is_far = total > 64 && total / 2 > max_degree;
            let most = if is_far { total / 2 } else { total - 1 };
            let limit = |other: u32| own_limit(other).min(most);
            let threshold = min_tangent;
            let steps = if is_far { &[24, 6, 1][..] } else { &[1] };
            let changed = steps.iter().find_map(|step| {
                let aim = Aim { vertex, keep: total - step, limit: &limit, threshold };
                improve(&mut work, &aim, &mut resume)
            });
            let Some(changed) = changed else { break 'levels };
            for vertex in changed {
                let total = work.totals[vertex as usize];
                if total > max_degree {
                    with_total.entry(total).or_default().push(vertex);
                }
            }
        }
    }
    Ok(finished(problem, work, keeps_vertex_limits))
}

fn finished(problem: &Problem, work: Work<'_>, keeps_vertex_limits: bool) -> Windowed {
    let max_degree = work.totals.iter().copied().max().unwrap_or(0);
    let Linked { mut triangles, .. } = work.mesh;
    for triangle in &mut triangles {
        let least = (0..3).min_by_key(|&corner| triangle[corner]).unwrap_or(0);
        triangle.rotate_left(least);
    }
    sort_all(&mut triangles);
    let min_angle = measure::degrees(least_tangent(problem.points(), &triangles));
    Windowed { triangles, max_degree, keeps_vertex_limits, min_angle }
}

/// Tries windows of growing size around the aim's vertex until one achieves the aim, and returns
/// the vertices whose number of edges it has changed. In a fan that is larger than the window, it
/// goes on where the last window of the same vertex ended.
fn improve(
    work: &mut Work<'_>,
    aim: &Aim<'_>,
    resume: &mut BTreeMap<u32, u32>,
) -> Option<Vec<u32>> {
    let lost = (work.totals[aim.vertex as usize] - aim.keep) as usize;
    for size in SIZES {
        let fan = work.fan_len(aim.vertex);
        if fan <= size {
            let start = work.first_of_fan(aim.vertex);
            if let (_, Some(changed)) = work.retriangulate(aim, start, fan, size) {
                return Some(changed);
            }
            continue;
        }
        let part_of_fan = size * 2 / 3;
        if lost >= part_of_fan {
            continue;
        }
        for _ in 0..PLACES.min(fan / part_of_fan + 1) {
            let start = resume
                .get(&aim.vertex)
                .copied()
                .filter(|&triangle| {
                    let triangle = work.mesh.triangles.get(triangle as usize);
                    triangle.is_some_and(|corners| corners.contains(&aim.vertex))
                })
                .unwrap_or(work.first_of_fan(aim.vertex));
            let (after, changed) = work.retriangulate(aim, start, part_of_fan, size);
            resume.insert(aim.vertex, after);
            if changed.is_some() {
                return changed;
            }
        }
    }
    None
}
