//! Whether some triangulation keeps degree limits, decided with a proof of either answer, on any domain and on
//! several faces at once.
//!
//! A dynamic program needs chords that cut a polygon in two; round a hole they do not. Here every triangle that
//! a triangulation may have is a variable, and every chord: `rows.rs` says how many of which may hold
//! together, and `search.rs` looks for values that keep all rows, learning a clause from every conflict. A
//! solution is a triangulation (Theorem 22 of docs/theory.md). If there is none, the learned clauses are a proof
//! (Theorem 23) that [`check::refutation`](crate::check::refutation) repeats.
//!
//! Work is counted and not timed, so the answer is the same on every machine.

mod angles;
mod around;
mod candidates;
mod caps;
mod cut;
mod decision;
mod rows;
mod search;

use crate::fill::LoopProblem;
use crate::measure::min_angle_tangent;
use crate::problem::{Domain, Problem};
use crate::progress::Stage;
use crate::visibility;
use candidates::{Candidate, Candidates};
use mindeg_mesh::{Cancelled, Progress};
use rows::Rows;
pub(crate) use search::{Expected, Search};

pub use decision::{Decision, Element, Literal, Refutation, SearchedAngle};

/// The most candidate triangles that a search takes, some 150 MB.
pub const MAX_CANDIDATES: usize = 1_000_000;

/// The most that the dynamic program round one hole takes, some 300 MB. With two holes it has copies, and the limit of a search.
pub(crate) const MAX_AROUND: usize = 4_000_000;

/// The most holes that the program is asked round: for each but one it begins anew at each of many cuts.
pub(crate) const MOST_HOLES: usize = 2;

/// The steps of the first turn of several searches, as a divisor of all; each turn is longer by a part of the one before.
pub(crate) const FIRST_TURN: u64 = 72;
pub(crate) const GROWTH: u64 = 8;

/// The triangles that the triangulations of one face or of several may have.
///
/// # Example
///
/// ```
/// use glam::DVec2;
/// use mindeg_exact::{COVER_STEPS, Cover, Decision, Problem, Progress};
/// use mindeg_mesh::planar::PlanarBoundary;
///
/// // A square with a square hole, one interval to a side.
/// let square = |half: f64| [(-half, -half), (half, -half), (half, half), (-half, half)];
/// let [outer, [a, b, c, d]] = [2.0, 1.0].map(square);
/// let rings = [outer, [a, d, c, b]].map(|ring| ring.map(DVec2::from));
/// let ring = [[0, 1, 4], [1, 7, 4], [1, 2, 7], [2, 6, 7], [2, 3, 6], [3, 5, 6], [3, 0, 5], [0, 4, 5]];
/// let problem = Problem::triangulated(&PlanarBoundary::new(&rings)?, &ring)?;
///
/// let cover = Cover::of(&problem, Progress::NONE)?.expect("the domain is small");
/// // Degree 4 leaves two chords to each vertex, degree 3 one.
/// let four = cover.decide(&[2; 8], &[0.0], &[], COVER_STEPS, Progress::NONE)?;
/// assert!(matches!(four, Decision::Mesh(faces) if faces[0].len() == 8));
/// let three = cover.decide(&[1; 8], &[0.0], &[], COVER_STEPS, Progress::NONE)?;
/// assert!(matches!(three, Decision::Refuted(_)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Cover {
    faces: Vec<Candidates>,
    /// The chords of all triangulations.
    chord_count: u64,
}

impl Cover {
    /// The candidates of a problem; none if they are more than [`MAX_CANDIDATES`].
    ///
    /// # Errors
    ///
    /// A cancelled `progress`.
    pub fn of(problem: &Problem, progress: Progress<'_>) -> Result<Option<Self>, Cancelled> {
        Self::of_at_most(problem, MAX_CANDIDATES, progress)
    }

    /// [`of`](Self::of) with another limit.
    pub(crate) fn of_at_most(
        problem: &Problem,
        most: usize,
        progress: Progress<'_>,
    ) -> Result<Option<Self>, Cancelled> {
        let vertices = Vec::from_iter(0..problem.points().len() as u32);
        Self::among(&[(problem, &vertices)], most, progress)
    }

    /// The candidates of several faces, each with the vertex of the whole at every vertex of its own; none if they
    /// are more than [`MAX_CANDIDATES`].
    ///
    /// # Errors
    ///
    /// A cancelled `progress`.
    pub fn of_faces(
        faces: &[(&Problem, &[u32])],
        progress: Progress<'_>,
    ) -> Result<Option<Self>, Cancelled> {
        Self::among(faces, MAX_CANDIDATES, progress)
    }

    fn among(
        faces: &[(&Problem, &[u32])],
        most: usize,
        progress: Progress<'_>,
    ) -> Result<Option<Self>, Cancelled> {
        let stage = Stage::new(progress, "finding triangles");
        let (mut left, mut chord_count) = (most, 0);
        let mut found = Vec::with_capacity(faces.len());
        for &(problem, vertices) in faces {
            let Some(pairs) = pairs(problem, left, &stage)? else { return Ok(None) };
            let Some(face) = Candidates::new(problem, vertices, pairs, left, &stage)? else {
                return Ok(None);
            };
            left -= face.triangles.len();
            chord_count += face.chord_count;
            found.push(face);
        }
        Ok(Some(Self { faces: found, chord_count }))
    }

    /// The candidates of several loops in space, each with the vertex of the whole at every vertex of its own; none if
    /// they may be more than [`MAX_CANDIDATES`].
    #[must_use]
    pub fn of_loops(loops: &[(&LoopProblem, &[u32])]) -> Option<Self> {
        let triples = loops.iter().map(|(_, vertices)| vertices.len().saturating_pow(3) / 6);
        if triples.fold(0, usize::saturating_add) > MAX_CANDIDATES {
            return None;
        }
        let face =
            |&(problem, vertices): &(&LoopProblem, &[u32])| Candidates::of_loop(problem, vertices);
        let faces: Vec<Candidates> = loops.iter().map(face).collect();
        Some(Self { chord_count: faces.iter().map(|face| face.chord_count).sum(), faces })
    }

    /// A triangulation of a domain with holes that keeps the numbers of chords and has no [`min_angle_tangent`] below
    /// `least_tangent`, if there is one, by a dynamic program over bridges between the rings. None if the domain has no
    /// hole, or if `steps` are too few.
    ///
    /// O(b t D^3) for one hole, b bridges at one vertex, t candidates and at most D chords at a vertex; with each more hole up to b D^2
    /// times as long, and most often b times.
    ///
    /// # Errors
    ///
    /// A cancelled `progress`.
    ///
    /// # Example
    ///
    /// ```
    /// # use glam::DVec2;
    /// # use mindeg_exact::{Cover, Problem, Progress};
    /// # use mindeg_mesh::planar::PlanarBoundary;
    /// # let square = |half: f64| [(-half, -half), (half, -half), (half, half), (-half, half)];
    /// # let [outer, [a, b, c, d]] = [2.0, 1.0].map(square);
    /// # let rings = [outer, [a, d, c, b]].map(|ring| ring.map(DVec2::from));
    /// # let ring = [[0, 1, 4], [1, 7, 4], [1, 2, 7], [2, 6, 7], [2, 3, 6], [3, 5, 6], [3, 0, 5], [0, 4, 5]];
    /// // The square with a square hole.
    /// let problem = Problem::triangulated(&PlanarBoundary::new(&rings)?, &ring)?;
    /// let cover = Cover::of(&problem, Progress::NONE)?.expect("the domain is small");
    /// let decide = |most| cover.decide_around(&problem, &[most; 8], 0.0, &mut 10_000, Progress::NONE);
    /// assert_eq!(decide(2)?.flatten().map(|triangles| triangles.len()), Some(8));
    /// assert_eq!(decide(1)?, Some(None));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn decide_around(
        &self,
        problem: &Problem,
        most_chords: &[u32],
        least_tangent: f64,
        steps: &mut u64,
        progress: Progress<'_>,
    ) -> Result<Option<Option<Vec<[u32; 3]>>>, Cancelled> {
        let [face] = &self.faces[..] else { return Ok(None) };
        let stage = Stage::new(progress, "searching round the hole");
        let next = problem.next();
        if least_tangent <= 0.0 {
            return face.decide(&next, most_chords, steps, &stage);
        }
        let is_wide = |triangle: &Candidate| {
            min_angle_tangent(triangle.corners.map(|v| face.points[v as usize])) >= least_tangent
        };
        face.among(is_wide).decide(&next, most_chords, steps, &stage)
    }

    /// The number of candidate triangles.
    #[must_use]
    pub fn candidate_count(&self) -> usize {
        self.faces.iter().map(|face| face.triangles.len()).sum()
    }

    /// Whether some triangulation of all faces gives no vertex more chords than `most_chords` says, and has no
    /// [`min_angle_tangent`] below that of its face in `least_tangents`. `start` are triangles of each face
    /// that the search tries first; none will do.
    ///
    /// # Errors
    ///
    /// A cancelled `progress`.
    pub fn decide(
        &self,
        most_chords: &[u32],
        least_tangents: &[f64],
        start: &[Vec<[u32; 3]>],
        steps: u64,
        progress: Progress<'_>,
    ) -> Result<Decision, Cancelled> {
        let mut left = steps;
        self.decide_within(most_chords, least_tangents, start, &mut left, progress)
    }

    /// [`decide`](Self::decide), which takes its steps off those that are left: a search that expects a mesh and one
    /// that expects a refutation take turns.
    pub(crate) fn decide_within(
        &self,
        most_chords: &[u32],
        least_tangents: &[f64],
        start: &[Vec<[u32; 3]>],
        left: &mut u64,
        progress: Progress<'_>,
    ) -> Result<Decision, Cancelled> {
        let ends: u64 = most_chords.iter().map(|&most| u64::from(most)).sum();
        if ends < 2 * self.chord_count {
            return Ok(Decision::Refuted(Refutation::at_once()));
        }
        let stage = Stage::new(progress, "searching all triangulations");
        let mut turn = (*left / FIRST_TURN).max(1);
        let mut searches = [(Expected::Mesh, None), (Expected::Refutation, None)];
        while *left > 0 {
            for (expected, search) in &mut searches {
                let begin = || self.search(most_chords, least_tangents, *expected, start);
                let mut own = turn.min(*left);
                *left -= own;
                let found = search.get_or_insert_with(begin).decide(&mut own, &stage)?;
                *left += own;
                if found != Decision::Unknown {
                    return Ok(found);
                }
            }
            turn += turn / GROWTH;
        }
        Ok(Decision::Unknown)
    }

    /// One search, which goes on where it has stopped.
    pub(crate) fn search(
        &self,
        most_chords: &[u32],
        least_tangents: &[f64],
        expected: Expected,
        start: &[Vec<[u32; 3]>],
    ) -> Search<'_> {
        Search::new(Rows::new(&self.faces, most_chords, least_tangents), expected, start)
    }

    /// The tangents of the candidates' minimum angles above one, ascending, each once.
    fn tangents_above(&self, low: f64) -> Vec<f64> {
        let of_face = |face: &Candidates| {
            let tangents = face.triangles.iter().map(|triangle| {
                min_angle_tangent(triangle.corners.map(|v| face.points[v as usize]))
            });
            tangents.filter(|&tangent| low < tangent).collect::<Vec<f64>>()
        };
        let mut tangents: Vec<f64> = self.faces.iter().flat_map(of_face).collect();
        tangents.sort_unstable_by(f64::total_cmp);
        tangents.dedup();
        tangents
    }
}

/// The holes of a domain, from the number of triangles that each of its meshes has.
pub(crate) fn hole_count(problem: &Problem) -> usize {
    match &problem.domain {
        Domain::Convex(_) | Domain::Simple(_) => 0,
        Domain::Rings(mesh) => {
            (mesh.triangles.len() + 2).saturating_sub(problem.points().len()) / 2
        }
    }
}

/// The chords that a triangulation of a problem may have, the smaller end first, ascending; none if more than
/// `most`.
fn pairs(
    problem: &Problem,
    most: usize,
    stage: &Stage<'_>,
) -> Result<Option<Vec<[u32; 2]>>, Cancelled> {
    let mut pairs = match &problem.domain {
        Domain::Convex(_) => {
            let n = problem.points().len() as u32;
            if (n as usize).saturating_pow(2) / 8 > most {
                return Ok(None);
            }
            let is_chord = |&[i, j]: &[u32; 2]| !problem.sides().has_both(i, j);
            (0..n).flat_map(|i| (i + 1..n).map(move |j| [i, j])).filter(is_chord).collect()
        }
        Domain::Simple(mesh) | Domain::Rings(mesh) => {
            match visibility::pairs(mesh, problem.points(), problem.sides(), most, stage)? {
                Some(pairs) => pairs.concat(),
                None => return Ok(None),
            }
        }
    };
    pairs.sort_unstable();
    // Round a hole the same vertex is seen on either side of it once at most; nothing is seen twice.
    pairs.dedup();
    Ok(Some(pairs))
}
