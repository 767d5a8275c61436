//! The strip of triangles between two rings: the least maximum degree, and then the largest minimum
//! angle.
//!
//! A strip joins two rings of p and q vertices by p + q triangles without any new vertex, as a
//! tube or an annulus. [`RingStrip`](mindeg_core::RingStrip) has the least maximum degree in closed
//! form, where vertices have no edges but those of the rings and the strip, and any two may be
//! joined. This module searches where they may not, and among all strips of the same degree.
//!
//! # The search
//!
//! A strip is a closed staircase on a torus of p by q edges between the rings: each step advances
//! along one ring. A vertex has one such edge, and one more for each step that it stays. So a
//! dynamic program over the edges, with the length of the current run as its state, finds the
//! staircase with the best worst triangle whose runs keep the degree limits. It starts from each
//! of the edges at one vertex; a start ends as soon as all its staircases are worse than the best
//! so far. Among strips with the largest minimum angle, it takes the one of least area.
//!
//! # In a plane
//!
//! Where all vertices lie in one plane, a strip must not fold. **Lemma.** If all triangles of a
//! strip between two simple rings are counter-clockwise, and their outer edges run along the outer ring
//! counter-clockwise and along the inner ring clockwise, then the strip is a triangulation of the
//! region between. *Proof.* The triangles round a point off all edges number the winding number of
//! their boundary there, since none counts negative. That boundary is the two rings: 1 between
//! them, 0 elsewhere. ∎ So the exact sign of each triangle decides, and no visibility is worked out.

mod plane;
mod staircase;

use crate::space;
use crate::unsolved::Unsolved;
use glam::DVec3;
use mindeg_core::RingStrip;
use mindeg_mesh::Progress;
use plane::Plane;
use staircase::{Capacities, Path, Search, Steps};

/// The most states that a search may visit: vertices of one ring times edges between the rings
/// times lengths of runs. Most searches visit a small share of them.
pub const MAX_STEPS: u64 = 1 << 36;

/// The most states that are kept at a time, of 8 bytes each.
const MAX_TABLE: u64 = 1 << 25;

const NO_PLANAR_STRIP: &str = "both loops lie in one plane, and no single strip fits between them: one must lie \
    inside the other, each edge must see a vertex of the other loop, and the faces of both must look the same way";

fn too_large(p: usize, q: usize) -> Unsolved {
    Unsolved::Refused(format!("loops of {p} and {q} vertices are too large for the exact search"))
}

/// Two rings in space, and what is around them.
///
/// The strip's triangles run forward along the x ring and backward along the y ring.
#[derive(Clone, Debug)]
pub struct BridgeProblem {
    points: [Vec<DVec3>; 2],
    external: [Vec<u32>; 2],
    /// For vertex i of the x ring and j of the y ring, whether no edge may join them, at i q + j.
    excluded: Vec<bool>,
}

/// A strip between two rings.
#[derive(Clone, Debug, PartialEq)]
pub struct Bridge {
    /// p + q triangles; the vertices of the x ring are `0..p`, those of the y ring `p..p + q`.
    pub triangles: Vec<[u32; 3]>,
    /// The largest total degree of the rings' vertices.
    pub max_degree: u32,
    /// The minimum angle of all triangles, in degrees: no strip within the limit has a larger one.
    pub min_angle: f64,
    /// The least maximum degree of a strip between these rings.
    pub least_max_degree: u32,
    /// The bound from counting alone, without geometry: no strip has a smaller maximum degree.
    pub lower_bound: u32,
    /// The largest minimum angle under a limit one higher, if that is larger; in degrees.
    pub next_min_angle: Option<f64>,
    /// The largest minimum angle without a limit, in degrees, and the degree of a strip with it.
    pub without_limit: (f64, u32),
    /// Whether the rings lie in one plane.
    pub is_planar: bool,
}

impl BridgeProblem {
    /// Two rings of three vertices or more. `external` are the edges at each vertex without those
    /// of the strip: its two ring edges, and what else is there. `excluded` are pairs of a vertex
    /// of the x ring and one of the y ring that may not be joined. O(p q) memory.
    ///
    /// # Errors
    ///
    /// A ring of fewer than three vertices, or too many vertices.
    ///
    /// # Panics
    ///
    /// If a point is not finite, there are not as many external degrees as points, or an index of
    /// a pair is out of range.
    pub fn new(
        points: [&[DVec3]; 2],
        external: [&[u32]; 2],
        excluded: impl IntoIterator<Item = [u32; 2]>,
    ) -> Result<Self, Unsolved> {
        let [p, q] = points.map(<[DVec3]>::len);
        assert!(external.map(<[u32]>::len) == [p, q], "as many degrees as points");
        assert!(points.iter().all(|ring| ring.iter().all(|point| point.is_finite())));
        let count = |n: usize| u32::try_from(n).unwrap_or(u32::MAX);
        RingStrip::new(count(p), count(q)).map_err(|error| Unsolved::refused(error.to_string()))?;
        if p as u64 * q as u64 > MAX_TABLE / 2 {
            return Err(too_large(p, q));
        }
        let mut pairs = vec![false; p * q];
        for [i, j] in excluded {
            assert!((j as usize) < q, "the y ring has {q} vertices");
            pairs[i as usize * q + j as usize] = true;
        }
        let points = points.map(<[DVec3]>::to_vec);
        Ok(Self { points, external: external.map(<[u32]>::to_vec), excluded: pairs })
    }

    /// Counting proves this: each vertex gets one edge of the strip, and the vertices of one ring
    /// share as many more as the other ring has edges. With equal external degrees of e this is
    /// e + 1 + ⌈p/q⌉ for p >= q.
    #[must_use]
    pub fn lower_bound(&self) -> u32 {
        let [x, y] = &self.external;
        let least = |own: &[u32], edges: usize| {
            let one_each = own.iter().max().map_or(0, |most| most + 1);
            let free = |limit: u32| own.iter().map(|&own| u64::from(limit - 1 - own)).sum::<u64>();
            (one_each..).find(|&limit| free(limit) >= edges as u64).unwrap_or(u32::MAX)
        };
        least(x, y.len()).max(least(y, x.len()))
    }

    /// For each step of a strip the minimum angle of its triangle as a cost, the larger the worse;
    /// and its area.
    fn steps(&self, plane: Option<&Plane>) -> (Steps, Steps) {
        let [p, q] = [0, 1].map(|ring| self.points[ring].len());
        let all = space::scaled(self.points[0].iter().chain(&self.points[1]));
        let (x, y) = all.split_at(p);
        let mut angles = Steps::blocked(p, q);
        let mut areas = Steps::blocked(p, q);
        for i in 0..p {
            for j in 0..q {
                let (next_i, next_j) = ((i + 1) % p, (j + 1) % q);
                let is_free = |i: usize, j: usize| !self.excluded[i * q + j];
                let mut set = |is_x: bool, next: bool, [a, b, c]: [usize; 3]| {
                    let unfolded = plane.is_none_or(|plane| plane.is_unfolded([a, b, c]));
                    if is_free(i, j) && next && unfolded {
                        let [a, b, c] = [a, b, c].map(|vertex| all[vertex]);
                        // Positive numbers have bits in their order. The shift leaves room above.
                        let angle = !space::min_angle_tangent(a, b, c).to_bits() >> 1;
                        angles.set(is_x, i, j, angle);
                        areas.set(is_x, i, j, space::cost(a, b, c).area);
                    }
                };
                set(true, is_free(next_i, j), [i, next_i, p + j]);
                set(false, is_free(i, next_j), [i, p + next_j, p + j]);
            }
        }
        debug_assert_eq!((x.len(), y.len()), (p, q));
        (angles, areas)
    }
}

/// The strip between two rings with the largest minimum angle under a limit on the total degrees of
/// their vertices, or under the least limit that some strip keeps.
///
/// # Errors
///
/// A limit that no strip keeps, excluded edges that each needs, rings of one plane that no strip joins without
/// folds, more work than [`MAX_STEPS`], or a cancelled `progress`.
///
/// # Example
///
/// ```
/// use glam::DVec3;
/// use mindeg_exact::{BridgeProblem, Progress, bridge_rings};
///
/// // A square above a triangle.
/// let square = [(0., 0., 1.), (4., 0., 1.), (4., 4., 1.), (0., 4., 1.)].map(DVec3::from);
/// let triangle = [(0., 0., 0.), (4., 0., 0.), (2., 4., 0.)].map(DVec3::from);
/// let problem = BridgeProblem::new([&square, &triangle], [&[2; 4], &[2; 3]], [])?;
/// let bridge = bridge_rings(&problem, None, Progress::NONE)?;
/// assert_eq!((bridge.triangles.len(), bridge.max_degree), (7, 5));
/// # Ok::<(), mindeg_exact::Unsolved>(())
/// ```
pub fn bridge_rings(
    problem: &BridgeProblem,
    limit: Option<u32>,
    progress: Progress<'_>,
) -> Result<Bridge, Unsolved> {
    let [p, q] = [0, 1].map(|ring| problem.points[ring].len());
    let plane = Plane::of(&problem.points[0], &problem.points[1]);
    let no_strip = || match plane {
        Some(_) => Unsolved::refused(NO_PLANAR_STRIP),
        None => Unsolved::Excluded,
    };
    if plane.as_ref().is_some_and(Plane::is_opposite) {
        return Err(no_strip());
    }
    let (angles, areas) = problem.steps(plane.as_ref());
    let search = |steps: &Steps, limit, add| problem.search(steps, limit, add, progress);
    let free = search(&angles, None, false)?.ok_or_else(no_strip)?;
    let free_degree = problem.max_degree(&free);
    let lower_bound = problem.lower_bound();
    let mut least = lower_bound;
    let best = loop {
        // A strip of this degree is there, so the loop ends.
        if least >= free_degree {
            break free.clone();
        }
        if let Some(path) = search(&angles, Some(least), false)? {
            break path;
        }
        least += 1;
    };
    let under = |limit: u32| -> Result<Path, Unsolved> {
        if limit == least {
            return Ok(best.clone());
        }
        if limit >= free_degree {
            return Ok(free.clone());
        }
        // The limit is above the least one.
        Ok(search(&angles, Some(limit), false)?.unwrap_or_else(|| best.clone()))
    };
    let limit = limit.unwrap_or(least);
    if limit < least {
        return Err(Unsolved::Infeasible { max_degree: limit, least });
    }
    // More than the degree of the best strip of all makes no difference.
    let limit = limit.min(free_degree.max(least));
    let angle = under(limit)?.cost;
    let next = under(limit + 1)?.cost;
    // The least area of all strips with this angle.
    let good = areas.only_where(&angles, angle);
    let chosen = search(&good, Some(limit), true)?.ok_or_else(no_strip)?;
    Ok(Bridge {
        triangles: chosen.triangles(p, q),
        max_degree: problem.max_degree(&chosen),
        min_angle: degrees(angle),
        least_max_degree: least,
        lower_bound,
        next_min_angle: (next < angle).then(|| degrees(next)),
        without_limit: (degrees(free.cost), free_degree),
        is_planar: plane.is_some(),
    })
}

/// The largest minimum angle of a strip between two rings, whatever its degrees; in degrees.
///
/// # Errors
///
/// Excluded edges that each strip needs, more work than [`MAX_STEPS`], or a cancelled `progress`.
pub fn largest_bridge_angle(
    problem: &BridgeProblem,
    progress: Progress<'_>,
) -> Result<f64, Unsolved> {
    let (angles, _) = problem.steps(None);
    let best = problem.search(&angles, None, false, progress)?;
    Ok(degrees(best.ok_or(Unsolved::Excluded)?.cost))
}

/// The angle of a cost, in degrees.
fn degrees(cost: u64) -> f64 {
    // The lowest bit was shifted out; tangents have 36 bits, so it was 0.
    crate::measure::degrees(f64::from_bits(!(cost << 1) & !1))
}

impl BridgeProblem {
    fn search(
        &self,
        steps: &Steps,
        limit: Option<u32>,
        add: bool,
        progress: Progress<'_>,
    ) -> Result<Option<Path>, Unsolved> {
        let capacities = limit.map(|limit| self.capacities(limit));
        let starts = self.starts();
        let search = Search { steps, capacities: capacities.as_ref(), starts: &starts, add };
        if search.table_len() > MAX_TABLE || search.most_steps() > MAX_STEPS {
            let [p, q] = [0, 1].map(|ring| self.points[ring].len());
            return Err(too_large(p, q));
        }
        Ok(search.best(progress)?)
    }

    /// The most edges of the strip at each vertex beyond its first.
    fn capacities(&self, limit: u32) -> Capacities {
        let [x, y] = [0, 1].map(|ring| {
            // All edges of the other ring in one run would come back to the edge they started from.
            let most = self.points[1 - ring].len() as u32 - 1;
            self.external[ring].iter().map(|&own| limit.saturating_sub(own + 1).min(most)).collect()
        });
        let is_possible = self.external.iter().all(|own| own.iter().all(|&own| own < limit));
        Capacities { x, y, is_possible }
    }

    /// The vertices of the x ring, the nearest to the first of the y ring first.
    fn starts(&self) -> Vec<u32> {
        let [x, y] = &self.points;
        let distances: Vec<f64> =
            x.iter().map(|point| (0.5 * *point - 0.5 * y[0]).length()).collect();
        let mut starts: Vec<u32> = (0..x.len() as u32).collect();
        starts.sort_by(|&a, &b| distances[a as usize].total_cmp(&distances[b as usize]));
        starts
    }

    fn max_degree(&self, path: &Path) -> u32 {
        let [p, q] = [0, 1].map(|ring| self.points[ring].len());
        let mut degrees = self.external.concat();
        for step in path.edges(p, q) {
            step.into_iter().for_each(|vertex| degrees[vertex] += 1);
        }
        degrees.into_iter().max().unwrap_or(0)
    }
}
