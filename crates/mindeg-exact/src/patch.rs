//! A triangulated polygon that changes block by block, for costs of vertices that others share.
//!
//! A block is a disk of triangles: the whole polygon if it has no holes, or a window around one
//! vertex. All other chords stay. So faces with holes, and faces too large for one dynamic program,
//! improve window by window, each by the same program.

use crate::least_cost::{Costs, MOST, least_cost};
use crate::linked::Linked;
use crate::problem::Problem;
use crate::window::{Local, Work};
use glam::DVec2;

/// The cost that changes of a [`Patch`] reduce.
pub trait Cost {
    /// The cost of a vertex with this many chords; never less for more chords. Costs of one patch
    /// should add up to less than 2^30.
    fn vertex(&self, vertex: u32, chords: u32) -> u32;

    /// The cost of a triangle, 0 by default; `None` if the triangle is not allowed.
    fn triangle(&self, corners: [DVec2; 3]) -> Option<u32> {
        let _ = corners;
        Some(0)
    }
}

/// A triangulation of a [`Problem`]'s points, which changes for less [`Cost`].
///
/// # Example
///
/// ```
/// use glam::DVec2;
/// use mindeg_exact::{Block, Cost, Patch, Problem};
/// use mindeg_mesh::planar::PlanarBoundary;
///
/// /// Each chord at vertex 0 costs 1.
/// struct KeepFree;
///
/// impl Cost for KeepFree {
///     fn vertex(&self, vertex: u32, chords: u32) -> u32 {
///         if vertex == 0 { chords } else { 0 }
///     }
/// }
///
/// // A regular octagon, as a fan.
/// let at = |corner: u32| DVec2::from_angle(f64::from(corner) * std::f64::consts::FRAC_PI_4);
/// let points: Vec<DVec2> = (0..8).map(at).collect();
/// let fan: Vec<[u32; 3]> = (1..7).map(|corner| [0, corner, corner + 1]).collect();
/// let problem = Problem::triangulated(&PlanarBoundary::new(&[points])?, &fan)?;
/// let mut patch = Patch::new(&problem);
/// assert_eq!(patch.chords(0), 5);
/// assert!(patch.improve(Block { vertex: 0, skip: 0, size: 8 }, &KeepFree));
/// assert_eq!(patch.chords(0), 0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Patch<'a> {
    work: Work<'a>,
    steps: u64,
}

/// A part of a [`Patch`]: the fan of one vertex, and triangles around it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Block {
    /// The vertex in the middle.
    pub vertex: u32,
    /// Where to begin in a fan of more triangles than the block; counts modulo their number.
    pub skip: u32,
    /// The most triangles. A polygon without holes that has no more is one block.
    pub size: usize,
}

impl<'a> Patch<'a> {
    /// The triangulation that the problem has. O(n log n).
    #[must_use]
    pub fn new(problem: &'a Problem) -> Self {
        Self { work: Work::new(problem, problem.triangulation()), steps: 0 }
    }

    /// Some other triangulation of the problem. O(n log n).
    pub(crate) fn of(problem: &'a Problem, triangles: &[[u32; 3]]) -> Self {
        let mesh = Linked::new(triangles.to_vec()).expect("triangulations have no edge twice");
        Self { work: Work::new(problem, mesh), steps: 0 }
    }

    /// The triangles, counter-clockwise, in no particular order.
    #[must_use]
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.work.mesh.triangles
    }

    /// The chords at a vertex.
    ///
    /// # Panics
    ///
    /// If there is no such vertex.
    #[must_use]
    pub fn chords(&self, vertex: u32) -> u32 {
        self.work.fan_len(vertex) as u32 - 1
    }

    /// The work done so far, in steps of the dynamic program: some nanoseconds each.
    #[must_use]
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// Gives a block the triangulation of least cost, all other chords given: whether that costs
    /// less than the present one, which stays otherwise.
    ///
    /// # Panics
    ///
    /// If there is no such vertex.
    pub fn improve(&mut self, block: Block, cost: &dyn Cost) -> bool {
        let fan_len = self.work.fan_len(block.vertex);
        let mut start = self.work.first_of_fan(block.vertex);
        let mut fan = fan_len;
        if fan_len > block.size {
            fan = (block.size * 2 / 3).max(1);
            // The last place from which a fan of that length begins.
            let skip = block.skip as usize % (fan_len - fan + 1);
            for _ in 0..skip {
                start = self.work.next_of_fan(block.vertex, start);
            }
        }
        let mut steps = 0;
        let solve = |work: &Work<'_>, local: &Local| solve(work, local, cost, &mut steps);
        let (_, changed) = self.work.retriangulate_by(block.vertex, start, fan, block.size, solve);
        self.steps += steps;
        changed.is_some()
    }
}

/// A triangulation of the window that costs less than the present one, if one exists.
fn solve(
    work: &Work<'_>,
    local: &Local,
    cost: &dyn Cost,
    steps: &mut u64,
) -> Option<Vec<[u32; 3]>> {
    let inside = |place: usize| local.chord_counts[place];
    let vertex_cost = |place: usize, chords: u32| {
        let vertex = local.ring[place];
        let outside = work.fan_len(vertex) as u32 - 1 - inside(place);
        cost.vertex(vertex, outside + chords)
    };
    let places = 0..local.ring.len();
    let of_vertices = places.fold(0_u32, |sum, place| {
        let own = vertex_cost(place, inside(place)).saturating_sub(vertex_cost(place, 0));
        sum.saturating_add(own)
    });
    let triangle_cost = |corners: [DVec2; 3]| cost.triangle(corners);
    let of_triangles = local.mesh.triangles.iter().fold(0_u32, |sum, triangle| {
        let corners = triangle.map(|place| local.points[place as usize]);
        sum.saturating_add(cost.triangle(corners).unwrap_or(MOST))
    });
    let present = of_vertices.saturating_add(of_triangles);
    *steps += 16 * local.chords.len() as u64;
    let bound = present.checked_sub(1)?.min(MOST);
    let costs = Costs::new(bound, &local.chords.degrees(), vertex_cost);
    let found = least_cost(&local.chords, &local.points, &costs, &triangle_cost, steps);
    found.map(|(triangles, _)| triangles)
}
