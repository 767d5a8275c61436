//! The mesh to take, by what it is for: the one advice that the terminal, the reports, the page of
//! `explore` and Python give.
//!
//! Limits: the advice compares minimum angles and degrees alone.

pub use crate::purpose::{FEWEST, KEPT, Purpose};

use crate::command::MeshCommand;
use crate::numbers::{number, percent, steady_angle};
use mindeg::beside::mesh_parts;
use mindeg::exact::{MAX_VERTICES, share_of};
use mindeg::interior::{self, InteriorError, InteriorMesh, InteriorReport};
use mindeg::{Domain, Goal, Interior, MeshError, Meshed, Progress, is_by_formula};
use schemars::JsonSchema;
use serde::Serialize;

/// A hint beside another answer has figures up to so many vertices: they take two meshes.
const HINTED: usize = 2000;

/// Up to so many vertices of convex domains that are too large for the search, a hint has the figures of the patch: a third of
/// a second.
const WINDOWED: usize = 50_000;

/// The most points of a mesh with points inside that is made for an advice, or that the page of `explore` shows.
pub const MOST_POINTS: usize = 200_000;

/// Points inside that bring less than so many times the angle bring too little.
const WORTH: f64 = 1.05;

/// The meshes to choose from, and the one to take unless told what it is for.
///
/// # Example
///
/// ```
/// use mindeg::{Domain, Progress, Side};
/// use mindeg_answers::advice::{Advice, Purpose};
///
/// let domain = Domain::rectangle(4.0, 3.0, [12, 9, 4, 4].map(Side::count).into())?;
/// let advice = Advice::of(&[domain], Progress::NONE).map_err(|(_, error)| error)?;
/// assert_eq!(advice.first, Purpose::Solver);
/// assert_eq!(advice.patch.unwrap().max_degree, 6);
/// assert!(advice.sentence(Purpose::Patch).starts_with("For a patch that must keep its points, take degree 6:"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Advice {
    /// The mesh to take unless told what it is for: `solver`, or `patch` where points inside bring no larger angle.
    pub first: Purpose,
    /// With points inside; null if it was not made.
    pub solver: Option<AdvisedMesh>,
    /// Why there can be no points inside; null if there can.
    pub no_solver: Option<String>,
    /// Of boundary points alone, with 95% of the largest minimum angle that they allow; null if it was not made.
    pub patch: Option<AdvisedMesh>,
    /// Of the least maximum degree, with the largest angle that is found; null if it was not made.
    pub fewest: Option<AdvisedMesh>,
}

/// The figures of a mesh to take.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct AdvisedMesh {
    /// The most edges at a vertex.
    pub max_degree: u32,
    /// The minimum angle in degrees.
    pub min_angle: f64,
    /// The minimum angle over Delaunay's, the largest of any mesh without points inside; null where that is not known.
    pub share_of_delaunay: Option<f64>,
}

impl AdvisedMesh {
    /// The figures of a mesh of boundary points.
    #[must_use]
    pub fn of(meshed: &Meshed) -> Self {
        let min_angle = meshed.mesh.angle_range().min;
        Self {
            max_degree: meshed.mesh.max_total_degree(),
            min_angle,
            share_of_delaunay: meshed.delaunay_min_angle.map(|most| share_of(min_angle, most)),
        }
    }

    /// The figures of the mesh of all parts of a domain: the highest degree, and the least angle. None of no part.
    #[must_use]
    pub fn of_all(parts: &[Meshed]) -> Option<Self> {
        if let [meshed] = parts {
            return Some(Self::of(meshed));
        }
        let all: Vec<Self> = parts.iter().map(Self::of).collect();
        let min_angle = all.iter().map(|part| part.min_angle).reduce(f64::min)?;
        let most = parts.iter().map(|part| part.delaunay_min_angle).collect::<Option<Vec<_>>>();
        let most = most.and_then(|most| most.into_iter().reduce(f64::min));
        Some(Self {
            max_degree: all.iter().map(|part| part.max_degree).max()?,
            min_angle,
            share_of_delaunay: most.map(|most| share_of(min_angle, most)),
        })
    }

    /// The figures of a mesh with points inside.
    #[must_use]
    pub fn of_interior(report: &InteriorReport) -> Self {
        let inside = report.interior_degree.as_ref().map_or(0, |range| *range.end());
        Self {
            max_degree: inside.max(*report.boundary_degree.end()),
            min_angle: report.min_angle,
            share_of_delaunay: None,
        }
    }
}

/// Why an advice has no mesh with points inside.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NoPoints {
    /// It is too large to be made for an advice, and is the mesh to take all the same.
    Unmeasured,
    /// There can be none.
    Impossible(String),
}

impl From<&InteriorError> for NoPoints {
    fn from(error: &InteriorError) -> Self {
        match error {
            InteriorError::Cancelled(_) | InteriorError::TooManyPoints { max: MOST_POINTS } => {
                Self::Unmeasured
            }
            error => Self::Impossible(error.to_string()),
        }
    }
}

/// The wishes for points inside a domain, for a mesh that is made for an advice.
#[must_use]
pub fn advised_interior(domain: &Domain) -> Interior {
    let wanted = domain.interior().cloned().unwrap_or_default();
    let most = wanted.max_points.map_or(MOST_POINTS, |most| most.min(MOST_POINTS));
    Interior { max_points: Some(most), ..wanted }
}

impl Advice {
    /// The advice without figures.
    pub const UNMEASURED: Self =
        Self { first: Purpose::Solver, solver: None, no_solver: None, patch: None, fewest: None };

    /// The advice on a domain, or on the parts of one that share no edge, for which three meshes are made.
    ///
    /// # Errors
    ///
    /// The errors of [`mindeg::mesh`] for the mesh of least degree, with the index of the part. Other meshes that cannot be made are left out.
    pub fn of(domains: &[Domain], progress: Progress<'_>) -> Result<Self, (usize, MeshError)> {
        Ok(Self::with_mesh(domains, progress)?.0)
    }

    /// The same, and the mesh with points inside, if there is one.
    ///
    /// # Errors
    ///
    /// The errors of [`Advice::of`].
    pub fn with_mesh(
        domains: &[Domain],
        progress: Progress<'_>,
    ) -> Result<(Self, Option<InteriorMesh>), (usize, MeshError)> {
        let fewest = mesh_parts(domains, FEWEST, progress)?;
        Ok(Self::beside(domains, AdvisedMesh::of_all(&fewest), progress))
    }

    /// The same, with the mesh of the fewest edges if it is there.
    fn beside(
        domains: &[Domain],
        fewest: Option<AdvisedMesh>,
        progress: Progress<'_>,
    ) -> (Self, Option<InteriorMesh>) {
        let patch = mesh_parts(domains, Goal::KeepAngle(KEPT), progress).ok();
        let wanted = domains.first().map(advised_interior).unwrap_or_default();
        let solver = interior::mesh_all(domains, &wanted, progress).map_err(|(_, error)| error);
        let advice = Self::among(
            solver
                .as_ref()
                .map(|found| AdvisedMesh::of_interior(&found.report))
                .map_err(Into::into),
            patch.as_deref().and_then(AdvisedMesh::of_all),
            fewest,
        );
        (advice, solver.ok())
    }

    /// The advice for a hint beside another answer, which must not wait for it: with figures where they take little time, and
    /// without the mesh of the fewest edges, which no hint names.
    #[must_use]
    pub fn for_hint(domains: &[Domain], progress: Progress<'_>) -> Self {
        let points =
            |domain: &Domain| domain.rings().vertex_count() as usize + domain.inner_points().len();
        let count = domains.iter().map(points).sum::<usize>();
        if count > HINTED {
            // Windows alone give the patch of a large convex domain.
            let is_quick = |domain: &Domain| {
                is_by_formula(domain) && domain.rings().vertex_count() > MAX_VERTICES
            };
            if count > WINDOWED || !domains.iter().all(is_quick) {
                return Self::UNMEASURED;
            }
            let patch = mesh_parts(domains, Goal::KeepAngle(KEPT), progress).ok();
            let patch = patch.as_deref().and_then(AdvisedMesh::of_all);
            return Self::among(Err(NoPoints::Unmeasured), patch, None);
        }
        Self::beside(domains, None, progress).0
    }

    /// The advice where meshes were made already: with points inside, that keeps its points, and of least degree.
    #[must_use]
    pub fn among(
        solver: Result<AdvisedMesh, NoPoints>,
        patch: Option<AdvisedMesh>,
        fewest: Option<AdvisedMesh>,
    ) -> Self {
        let brings_little = |patch: AdvisedMesh| match &solver {
            Ok(solver) => solver.min_angle < WORTH * patch.min_angle,
            Err(why) => *why != NoPoints::Unmeasured,
        };
        let first = if patch.is_some_and(brings_little) { Purpose::Patch } else { Purpose::Solver };
        let largest = patch.and_then(|patch| Some(patch.min_angle / patch.share_of_delaunay?));
        let shared = |mesh: AdvisedMesh| AdvisedMesh {
            share_of_delaunay: largest.map(|most| share_of(mesh.min_angle, most)),
            ..mesh
        };
        let (solver, no_solver) = match solver {
            Ok(solver) => (Some(shared(solver)), None),
            Err(NoPoints::Unmeasured) => (None, None),
            Err(NoPoints::Impossible(reason)) => (None, Some(reason)),
        };
        Self { first, solver, no_solver, patch, fewest: fewest.map(shared) }
    }

    /// Whether there can be a mesh for a purpose.
    #[must_use]
    pub fn is_possible(&self, purpose: Purpose) -> bool {
        purpose != Purpose::Solver || self.no_solver.is_none()
    }

    /// The figures of the mesh for a purpose.
    #[must_use]
    pub fn mesh_for(&self, purpose: Purpose) -> Option<AdvisedMesh> {
        match purpose {
            Purpose::Solver => self.solver,
            Purpose::Patch => self.patch,
            Purpose::Fewest => self.fewest,
        }
    }

    /// The purposes to name: the one that was told, or else the first two.
    #[must_use]
    pub fn purposes(&self, told: Option<Purpose>) -> Vec<Purpose> {
        match (told, self.first) {
            (Some(purpose), _) => vec![purpose],
            (None, Purpose::Patch) => vec![Purpose::Patch, Purpose::Solver],
            (None, _) => vec![Purpose::Solver, Purpose::Patch],
        }
    }

    /// The mesh to take for a purpose, with its figures, in a sentence.
    #[must_use]
    pub fn sentence(&self, purpose: Purpose) -> String {
        if let (Purpose::Solver, Some(reason)) = (purpose, &self.no_solver) {
            return format!("Points inside cannot be put here: {}.", reason.trim_end_matches('.'));
        }
        let figures = self.mesh_for(purpose);
        let take = match (purpose, figures) {
            (Purpose::Solver, _) if self.first == Purpose::Patch && figures.is_some() => {
                "For a solver, points inside bring little here".to_owned()
            }
            (Purpose::Solver, _) => "For a solver, put points inside".to_owned(),
            (Purpose::Patch, Some(mesh)) => {
                format!("For a patch that must keep its points, take degree {}", mesh.max_degree)
            }
            (Purpose::Patch, None) => {
                "For a patch that must keep its points, keep 95% of the angle".to_owned()
            }
            (Purpose::Fewest, Some(mesh)) => {
                format!("For the fewest edges at a vertex, take degree {}", mesh.max_degree)
            }
            (Purpose::Fewest, None) => {
                "For the fewest edges at a vertex, take the least degree".to_owned()
            }
        };
        let Some(AdvisedMesh { max_degree, min_angle, share_of_delaunay }) = figures else {
            return format!("{take}.");
        };
        let angle = steady_angle(min_angle);
        match (purpose, share_of_delaunay) {
            (Purpose::Solver, share) => {
                let times = match share {
                    Some(share) if share >= WORTH => {
                        format!(", {} times what the boundary points alone allow", number(share))
                    }
                    _ => String::new(),
                };
                format!(
                    "{take}: minimum angle {angle}{times}; at most {max_degree} edges at a vertex."
                )
            }
            (_, None) => format!("{take}: minimum angle {angle}."),
            (_, Some(share)) => {
                let share = if share < 1.0 { percent(share) } else { "all".to_owned() };
                format!("{take}: minimum angle {angle}, {share} of what its points allow.")
            }
        }
    }

    /// A sentence without its first letter, which stands small after "hint:".
    fn rest(&self, purpose: Purpose) -> String {
        self.sentence(purpose).trim_start_matches('F').to_owned()
    }

    /// The advice in sentences, a line each.
    #[must_use]
    pub fn text(&self, told: Option<Purpose>) -> String {
        let sentences: Vec<String> =
            self.purposes(told).into_iter().map(|purpose| self.sentence(purpose)).collect();
        sentences.join("\n")
    }

    /// The same as hints of the terminal, each with the command that makes the mesh.
    #[must_use]
    pub fn hints(&self, command: &MeshCommand) -> String {
        let hint = |purpose: Purpose| {
            format!("hint: f{}\n{}", self.rest(purpose), command.advised(purpose))
        };
        let possible = self.purposes(None).into_iter().filter(|&purpose| self.is_possible(purpose));
        let is_measured = self.patch.is_some() || self.solver.is_some();
        let measuring =
            || format!("hint: this takes longer, and measures them:\n{}", command.measuring());
        let measuring = (!is_measured).then(measuring);
        possible.map(hint).chain(measuring).collect::<Vec<_>>().join("\n")
    }
}

/// An advice with its words.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct AdviceAnswer {
    /// The same keys as in `mindeg tradeoff --json`.
    #[serde(flatten)]
    pub advice: Advice,
    /// The sentence for each purpose, in the order of [`Purpose::ALL`].
    pub words: Vec<(Purpose, String)>,
}

impl AdviceAnswer {
    /// The advice in all its sentences.
    #[must_use]
    pub fn of(advice: Advice) -> Self {
        let words = Purpose::ALL.map(|purpose| (purpose, advice.sentence(purpose))).into();
        Self { advice, words }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn inside(max_degree: u32, min_angle: f64) -> Result<AdvisedMesh, NoPoints> {
        Ok(AdvisedMesh { max_degree, min_angle, share_of_delaunay: None })
    }

    fn made(max_degree: u32, min_angle: f64, share: Option<f64>) -> Option<AdvisedMesh> {
        Some(AdvisedMesh { max_degree, min_angle, share_of_delaunay: share })
    }

    #[test]
    fn points_inside_come_first_where_they_bring_a_larger_angle() {
        let advice = Advice::among(inside(7, 40.0), made(5, 5.0, Some(1.0)), made(4, 1.0, None));
        assert_eq!(
            advice.text(None),
            "For a solver, put points inside: minimum angle 40.000°, 8 times what the boundary points alone \
             allow; at most 7 edges at a vertex.\n\
             For a patch that must keep its points, take degree 5: minimum angle 5.000°, all of what its points \
             allow."
        );
        assert_eq!(
            advice.text(Some(Purpose::Fewest)),
            "For the fewest edges at a vertex, take degree 4: minimum angle 1.000°, 20% of what its points allow."
        );
        let hints = advice.hints(&MeshCommand::default());
        assert!(hints.ends_with(
            "allow.\nmindeg mesh DOMAIN.json --keep-angle 95% -o mesh-keep-angle-95.obj"
        ));
        let advice = Advice::among(inside(5, 26.0), made(4, 26.0, Some(0.96)), None);
        assert_eq!(advice.purposes(None), [Purpose::Patch, Purpose::Solver]);
        assert!(
            advice
                .sentence(Purpose::Solver)
                .starts_with("For a solver, points inside bring little here:")
        );
    }

    /// Where a mesh with points inside is merely too large to be measured, it is the mesh to take.
    #[test]
    fn points_inside_come_first_unless_there_can_be_none() {
        let too_large = InteriorError::TooManyPoints { max: MOST_POINTS };
        let own_limit = InteriorError::TooManyPoints { max: 50 };
        let advice = |error: &InteriorError| {
            Advice::among(Err(error.into()), made(4, 26.0, Some(1.0)), None)
        };
        let large = advice(&too_large);
        assert_eq!(large.purposes(None), [Purpose::Solver, Purpose::Patch]);
        assert_eq!(large.sentence(Purpose::Solver), "For a solver, put points inside.");
        assert!(large.hints(&MeshCommand::default()).contains("--interior -o"));
        let none = advice(&own_limit);
        assert_eq!(none.purposes(None), [Purpose::Patch, Purpose::Solver]);
        let reason = "Points inside cannot be put here: the mesh needs more than 50 points;";
        assert!(none.sentence(Purpose::Solver).starts_with(reason));
        assert!(!none.hints(&MeshCommand::default()).contains("--interior"));
    }

    #[test]
    fn without_figures_the_advice_is_the_same() {
        let hints = Advice::UNMEASURED.hints(&MeshCommand::default());
        assert!(hints.ends_with("and measures them:\nmindeg tradeoff DOMAIN.json"), "{hints}");
        assert_eq!(
            Advice::UNMEASURED.text(None),
            "For a solver, put points inside.\nFor a patch that must keep its points, keep 95% of the angle."
        );
    }
}
