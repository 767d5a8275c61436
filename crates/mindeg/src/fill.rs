//! Closing the boundary loops of a mesh.
//!
//! Each loop gets the triangulation of least area under a limit on the *total* degree of its
//! vertices: the edges that the mesh has there count. An edge that the mesh has already is not
//! made again, so no edge gets three faces. The edges that one loop adds count for the next where they share
//! vertices; loops that share none are filled at the same time, with the same result. Where a given limit fails so, the
//! loops are decided together: `joint.rs`.
//!
//! The given mesh stays: vertices, triangles, groups, lines and names keep their indices. The new
//! triangles form the group `fill`, at the end.
//!
//! Limits: the filling may cross other triangles; [`Filled::crossings`] names where.

mod joint;
mod posed;

use self::joint::{Share, Shares};
use self::posed::posed;
use crate::error::MeshError;
use crate::loops::{Loops, MeshLoop};
use crate::points_inside::{Around, NoPoints};
pub use crate::points_inside::{PointsInside, points_between};
use glam::DVec3;
use mindeg_exact::{LoopLimit, Unsolved, fill_loop};
use mindeg_mesh::crossing::crossings;
use mindeg_mesh::parallel::map_all;
use mindeg_mesh::quality::{area_in_space, min_angle};
use mindeg_mesh::{Cancelled, Progress, Step, TriMesh};
use std::collections::{BTreeMap, BTreeSet};
use std::ops::{ControlFlow, Range};

/// The name of the group of new triangles.
pub const FILL: &str = "fill";

/// Why a loop stays open that nobody asked for by name.
const RIM: &str = "it is the rim of a flat sheet, on which the filling would lie";

/// Why a loop stays open that could be filled but for the edges around it.
const EDGES_THERE: &str = "every triangulation of it needs an edge that the mesh has already";

/// The least limit that [`fill`] tries without a given limit. Below, the area of a filling grows
/// quickly; see `docs/fill-and-bridge.md`.
pub const FIRST_LIMIT: u32 = 6;

/// How much more area than the least a filling may take where no limit is given, as a share. With
/// more, fillings of uneven loops begin to fold; see `docs/fill-and-bridge.md`.
pub const EXTRA_AREA: f64 = 0.05;

/// The loops to fill, and the options.
#[derive(Clone, Debug, PartialEq)]
pub struct FillOptions {
    /// The limit on total degrees; without one, for each loop the least that is possible, from
    /// [`FIRST_LIMIT`] up, with no more than [`extra_area`](Self::extra_area).
    pub max_degree: Option<u32>,
    /// How much more area than without a limit a filling may take where no limit is given, as a
    /// share, 0 or more; [`EXTRA_AREA`] by default. Infinite: the least limit, whatever its area.
    pub extra_area: f64,
    /// Loops of this many vertices or more stay open.
    pub max_loop: usize,
    /// The indices of the loops to fill; without indices, all loops but the rims of flat sheets.
    pub only: Option<Vec<usize>>,
    /// Whether fillings have points inside: edges as long as those of the rim, 5 to 7 of them at each vertex of the filling and
    /// its rim, in a surface that continues the mesh around as smoothly as it can.
    pub interior: bool,
}

/// 500 vertices, no limit of its own, all loops, no points inside.
impl Default for FillOptions {
    fn default() -> Self {
        let (max_degree, only) = (None, None);
        Self { max_degree, extra_area: EXTRA_AREA, max_loop: 500, only, interior: false }
    }
}

/// A mesh with its loops filled.
#[derive(Clone, Debug)]
pub struct Filled {
    /// The mesh.
    pub mesh: TriMesh,
    /// The loops that were filled, in order.
    pub filled: Vec<FilledLoop>,
    /// The loops that were to be filled and stay open, in order.
    pub left: Vec<LeftLoop>,
    /// The largest degree of the whole mesh, vertices at the same place as one.
    pub max_degree: u32,
    /// The new triangles that cross another triangle, each with the first that it crosses.
    pub crossings: Vec<[u32; 2]>,
}

/// A loop that was filled.
#[derive(Clone, Debug, PartialEq)]
pub struct FilledLoop {
    /// Its index.
    pub index: usize,
    /// How many vertices it has.
    pub vertices: usize,
    /// Its triangles.
    pub triangles: Range<u32>,
    /// The limit that it keeps. Vertices that had more edges before got no new edge.
    pub limit: u32,
    /// The largest total degree of its vertices.
    pub max_degree: u32,
    /// The area of its triangles.
    pub area: f64,
    /// The least area without a limit, and the largest total degree that goes with it.
    pub without_limit: (f64, u32),
    /// The least possible limit from [`FIRST_LIMIT`] up and the area that it takes, where a higher
    /// one was chosen for its area.
    pub least_limit: Option<(u32, f64)>,
    /// The minimum angle of its triangles, in degrees.
    pub min_angle: f64,
    /// Its points inside, or why it has none though they were asked for; `None` if they were not.
    pub inside: Option<Result<PointsInside, String>>,
}

/// A loop that stays open.
#[derive(Clone, Debug, PartialEq)]
pub struct LeftLoop {
    /// Its index.
    pub index: usize,
    /// How many vertices it has.
    pub vertices: usize,
    /// Why.
    pub reason: String,
}

/// Closes boundary loops of a mesh, `loops` of it, by triangulations of least area under a limit on the total
/// degrees.
///
/// O(n³) time for a loop of n vertices, times the square of the number of degree pairs that matter;
/// O(n²) memory; and O(m log m) for the m triangles of the mesh.
///
/// # Errors
///
/// [`MeshError`]. A loop that cannot be filled for what it is stays open, and is in
/// [`Filled::left`].
///
/// # Example
///
/// ```
/// use mindeg::{Loops, Progress, TriMesh, fill::{FillOptions, fill}, glam::DVec3};
///
/// // A pyramid without its base.
/// let corners = [(0., 0., 0.), (1., 0., 0.), (1., 1., 0.), (0., 1., 0.), (0.5, 0.5, 1.)];
/// let sides = vec![[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]];
/// let open = TriMesh::new(corners.map(DVec3::from).to_vec(), sides)?;
/// let loops = Loops::of(&open);
/// let closed = fill(open, &loops, &FillOptions::default(), Progress::NONE)?;
/// assert!(closed.mesh.boundary_loops().is_empty());
/// assert_eq!((closed.filled[0].limit, closed.filled[0].max_degree), (6, 4));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn fill(
    mesh: TriMesh,
    loops: &Loops,
    options: &FillOptions,
    progress: Progress<'_>,
) -> Result<Filled, MeshError> {
    fill_with(mesh, loops, options, &mut Shares::new(), progress)
}

/// [`fill`] with the shares of chords at vertices of several loops that are known to keep the limit together.
fn fill_with(
    mesh: TriMesh,
    before: &Loops,
    options: &FillOptions,
    shares: &mut Shares,
    progress: Progress<'_>,
) -> Result<Filled, MeshError> {
    let all = before.list();
    let mut loops = before.clone();
    let mut chosen = options.only.clone().unwrap_or_else(|| (0..all.len()).collect());
    chosen.sort_unstable();
    chosen.dedup();
    let within = LoopLimit::LeastWithin { from: FIRST_LIMIT, extra_area: options.extra_area };
    let limit = options.max_degree.map_or(within, LoopLimit::AtMost);
    let (mut tasks, mut left) = (Vec::new(), Vec::new());
    for index in chosen {
        let found = loops.get(index)?;
        let (vertices, max_loop) = (found.vertices.len(), options.max_loop);
        let is_too_long = vertices >= max_loop;
        let too_long =
            format!("it has {vertices} vertices, and only loops below {max_loop} are filled");
        let reason = found.defect.map(|defect| defect.to_string());
        let reason = reason.or_else(|| is_too_long.then_some(too_long));
        let is_unwanted = found.is_rim && options.only.is_none();
        let reason = reason.or_else(|| is_unwanted.then(|| RIM.to_owned()));
        match reason {
            Some(reason) => left.push(LeftLoop { index, vertices, reason }),
            None => tasks.push(index),
        }
    }
    let mut solutions = BTreeMap::new();
    let counter = progress.counter("filling loops", tasks.len() as u64);
    let is_cancelled = |_: Step<'_>| match counter.add(0) {
        Ok(()) => ControlFlow::Continue(()),
        Err(Cancelled) => ControlFlow::Break(()),
    };
    // A single loop tells more of itself.
    let inner = if tasks.len() > 1 { Progress::new(&is_cancelled) } else { progress };
    for level in levels(&tasks, all) {
        let solved = map_all(level.clone(), |index| {
            let solved = match shares.get(&index) {
                Some(share) => joint::solve(&mesh, &all[index], &loops, share, limit, inner),
                None => posed(&mesh, &all[index], &loops, None, &[])
                    .and_then(|problem| fill_loop(&problem, limit, inner)),
            };
            counter.add(usize::from(tasks.len() > 1))?;
            solved
        });
        for (index, solved) in level.into_iter().zip(solved) {
            let MeshLoop { vertices, .. } = &all[index];
            match solved {
                Ok(solved) => {
                    // The loop ran with the faces; its filling runs against them.
                    let vertex = |i: u32| vertices[vertices.len() - 1 - i as usize];
                    let own: Vec<_> = solved.triangles.iter().map(|t| t.map(vertex)).collect();
                    loops.add(&own);
                    solutions.insert(index, (solved, own));
                }
                // The loops before it may have taken the edge, or more than they need.
                Err(Unsolved::Excluded)
                    if !shares.contains_key(&index)
                        && joint::share(&mesh, before, &tasks, index, None, shares, inner)? =>
                {
                    return fill_with(mesh, before, options, shares, progress);
                }
                Err(Unsolved::Excluded) => {
                    let (vertices, reason) = (vertices.len(), EDGES_THERE.to_owned());
                    left.push(LeftLoop { index, vertices, reason });
                }
                Err(Unsolved::Cancelled(cancelled)) => return Err(cancelled.into()),
                Err(Unsolved::Infeasible { max_degree, .. })
                    if !shares.get(&index).is_some_and(Share::is_limited)
                        && joint::share(
                            &mesh,
                            before,
                            &tasks,
                            index,
                            Some(max_degree),
                            shares,
                            inner,
                        )? =>
                {
                    return fill_with(mesh, before, options, shares, progress);
                }
                Err(source) => {
                    let (number, first) = (index + 1, vertices[0]);
                    let sentence = format!("loop {number} from vertex {first}: {source}");
                    return Err(MeshError::Refused(sentence));
                }
            }
        }
    }
    left.sort_by_key(|left| left.index);
    let first_triangle = mesh.triangles().len();
    let mut points = Vec::new();
    let (mut filled, mut triangles) = (Vec::new(), Vec::new());
    let on_loops = all.iter().flat_map(|found| &found.vertices).copied();
    let mut around = Around::of(&mesh, &loops, on_loops.filter(|_| options.interior));
    for (index, (solved, plain)) in solutions {
        let rim = &all[index].vertices;
        let mut found = FilledLoop {
            index,
            vertices: rim.len(),
            triangles: 0..0,
            limit: solved.limit,
            max_degree: solved.max_degree,
            area: solved.area,
            without_limit: solved.without_limit,
            least_limit: solved.least_limit,
            min_angle: 0.0,
            inside: None,
        };
        let mut own = plain;
        if options.interior {
            let next = mesh.positions().len() + points.len();
            match around.meshed(&mesh, &[rim], &own, next, progress) {
                Ok(filling) => {
                    own = filling.triangles;
                    points.extend(filling.points);
                    let vertices = next as u32..(mesh.positions().len() + points.len()) as u32;
                    found.inside = Some(Ok(PointsInside::of(vertices)));
                }
                Err(NoPoints::Cancelled) => return Err(Cancelled.into()),
                Err(NoPoints::Because(reason)) => found.inside = Some(Err(reason)),
            }
            around.add(&own);
        }
        let start = first_triangle + triangles.len();
        // Checked below, before anybody sees it.
        found.triangles = start as u32..(start + own.len()) as u32;
        triangles.extend(own);
        filled.push(found);
    }
    let mesh = mesh.with_vertices_added(&points)?.with_triangles_added(FILL, &triangles)?;
    let mut is_open = BTreeSet::new();
    if options.interior {
        loops = Loops::of(&mesh);
        is_open.extend(loops.list().iter().flat_map(|it| &it.vertices).copied());
    }
    for found in &mut filled {
        let own = found.triangles.start as usize..found.triangles.end as usize;
        let own = &mesh.triangles()[own];
        found.min_angle = min_angle(mesh.positions(), own);
        if let Some(Ok(inside)) = &mut found.inside {
            let degree = |v: u32| (loops.degrees[v as usize], is_open.contains(&v));
            inside.judge(&[&all[found.index].vertices], degree);
            found.max_degree = inside.degrees[1];
            found.area = area(mesh.positions(), own);
        }
    }
    progress.report("looking for crossings", 0, 1)?;
    let new = first_triangle as u32..mesh.triangles().len() as u32;
    let crossings = crossings(mesh.positions(), &loops.merged(mesh.triangles()), new);
    progress.report("looking for crossings", 1, 1)?;
    let max_degree = loops.degrees.iter().copied().max().unwrap_or(0);
    Ok(Filled { mesh, filled, left, max_degree, crossings })
}

/// Loops that can be filled at the same time: those of a level share no vertex, and come after the
/// loops before them with which they share one. So the result is that of one after the other.
fn levels(tasks: &[usize], all: &[MeshLoop]) -> Vec<Vec<usize>> {
    let mut next_level = BTreeMap::new();
    let mut levels: Vec<Vec<usize>> = Vec::new();
    for &index in tasks {
        let vertices = &all[index].vertices;
        let level = vertices.iter().filter_map(|vertex| next_level.get(vertex)).max();
        let level = level.copied().unwrap_or(0);
        next_level.extend(vertices.iter().map(|&vertex| (vertex, level + 1)));
        if level == levels.len() {
            levels.push(Vec::new());
        }
        levels[level].push(index);
    }
    levels
}

/// The area of some triangles.
fn area(positions: &[DVec3], triangles: &[[u32; 3]]) -> f64 {
    let at = |vertex: u32| positions[vertex as usize];
    triangles.iter().map(|corners| area_in_space(corners.map(at))).sum()
}
