//! The mesh to take, by what it is for: the one advice that the terminal, the reports, the page of
//! `explore` and Python give.
//!
//! Limits: the advice compares minimum angles and degrees alone.

pub use crate::advised::{AdvisedMesh, MOST_POINTS, NoPoints, advised_interior};
pub use crate::purpose::{FEWEST, KEPT, Purpose};

use crate::command::MeshCommand;
use crate::condition::points_of;
use crate::numbers::{counted, number, percent, steady_angle};
use crate::on_edges::{is_poor, mesh_with_points_on_edges};
use mindeg::beside::mesh_parts;
use mindeg::exact::{MAX_VERTICES, share_of};
use mindeg::interior::{self, InteriorMesh};
use mindeg::{Domain, Goal, MeshError, Progress, is_by_formula};
use schemars::JsonSchema;
use serde::Serialize;

/// A hint beside another answer has figures up to this number of points: they take two meshes. Points on edges, which take one more,
/// are tried up to the same number.
pub const HINTED: u64 = 2000;

/// Up to so many vertices of convex domains that are too large for the search, a hint has the figures of the patch: a third of
/// a second.
const WINDOWED: u64 = 50_000;

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
    /// With points inside, and on edges as well, which `--condition` puts there; null unless that is known to bring a larger angle.
    pub conditioned: Option<AdvisedMesh>,
    /// How many points that mesh has on edges; 0 without it.
    pub points_on_edges: usize,
    /// Of boundary points alone, with 95% of the largest minimum angle that they allow; null if it was not made.
    pub patch: Option<AdvisedMesh>,
    /// Of the least maximum degree, with the largest angle that is found; null if it was not made.
    pub fewest: Option<AdvisedMesh>,
}

/// The points of all domains, which may be more than one domain can have.
fn count_of_points(domains: &[Domain]) -> u64 {
    domains.iter().map(|domain| u64::from(points_of(domain))).sum()
}

impl Advice {
    /// The advice without figures.
    pub const UNMEASURED: Self = Self {
        first: Purpose::Solver,
        solver: None,
        no_solver: None,
        conditioned: None,
        points_on_edges: 0,
        patch: None,
        fewest: None,
    };

    /// The advice on a domain, or on the parts of one that share no edge, for which three meshes are made, and a
    /// fourth where the boundary is poor.
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
        match solver {
            Ok(found) if is_poor(&found) => {
                (advice.and_points_on_edges(domains, progress), Some(found))
            }
            solver => (advice, solver.ok()),
        }
    }

    /// The advice for a hint beside another answer, which must not wait for it: with figures where they take little time, and
    /// without the mesh of the fewest edges, which no hint names.
    #[must_use]
    pub fn for_hint(domains: &[Domain], progress: Progress<'_>) -> Self {
        let count = count_of_points(domains);
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
        let fewest = fewest.map(shared);
        Self { first, solver, no_solver, patch, fewest, ..Self::UNMEASURED }
    }

    /// The same with the mesh that has points on edges, too, if there is one with a larger angle: for a boundary of at most 2,000 points
    /// that [`is_poor`]. Time as [`interior::mesh_all`].
    #[must_use]
    pub fn and_points_on_edges(self, domains: &[Domain], progress: Progress<'_>) -> Self {
        let wanted = domains.first().map(advised_interior).unwrap_or_default();
        let Some(solver) = self.solver.filter(|_| count_of_points(domains) <= HINTED) else {
            return self;
        };
        match mesh_with_points_on_edges(domains, &wanted, progress) {
            Some((points, found)) if found.report.min_angle >= WORTH * solver.min_angle => Self {
                conditioned: Some(AdvisedMesh::of_interior(&found.report)),
                points_on_edges: points,
                ..self
            },
            _ => self,
        }
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

    /// The mesh to take for a purpose, with its figures, in a sentence; in two where points on edges bring more.
    #[must_use]
    pub fn sentence(&self, purpose: Purpose) -> String {
        match self.on_edges(&[purpose]) {
            Some(more) => format!("{} {more}", self.as_it_is(purpose)),
            None => self.as_it_is(purpose),
        }
    }

    /// What points on edges bring, in a sentence, if a solver is among the purposes; the second one of [`Self::sentence`].
    #[must_use]
    pub fn on_edges(&self, purposes: &[Purpose]) -> Option<String> {
        let conditioned = self.conditioned.filter(|_| purposes.contains(&Purpose::Solver))?;
        Some(format!(
            "If the boundary may have {} more, condition it: minimum angle {}.",
            counted(self.points_on_edges as u64, "point"),
            steady_angle(conditioned.min_angle)
        ))
    }

    /// The mesh to take for a purpose where the boundary stays as it is, in a sentence.
    #[must_use]
    pub fn as_it_is(&self, purpose: Purpose) -> String {
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

    /// The advice in sentences, a line each.
    #[must_use]
    pub fn text(&self, told: Option<Purpose>) -> String {
        let sentences: Vec<String> =
            self.purposes(told).into_iter().map(|purpose| self.sentence(purpose)).collect();
        sentences.join("\n")
    }

    /// The same as hints of the terminal, each with the command that makes the mesh; `None` of nothing but the mesh that was made.
    #[must_use]
    pub fn hints(&self, command: &MeshCommand, made: Option<AdvisedMesh>) -> Option<String> {
        let hint = |purpose: Purpose| {
            // Small after "hint:".
            let sentence = self.sentence(purpose);
            let words = format!("hint: f{}", sentence.trim_start_matches('F'));
            let more = self.on_edges(&[purpose]).map(|_| command.conditioned());
            let lines = [words, command.advised(purpose)].into_iter().chain(more);
            lines.collect::<Vec<_>>().join("\n")
        };
        let is_made = |purpose| {
            made.zip(self.mesh_for(purpose)).is_some_and(|(made, advised)| made.is_as(&advised))
        };
        let possible = self
            .purposes(None)
            .into_iter()
            .filter(|&purpose| self.is_possible(purpose) && !is_made(purpose));
        let is_measured = self.patch.is_some() || self.solver.is_some();
        let measuring =
            || format!("hint: this takes longer, and measures them:\n{}", command.measuring());
        let measuring = (!is_measured).then(measuring);
        let hints: Vec<String> = possible.map(hint).chain(measuring).collect();
        (!hints.is_empty()).then(|| hints.join("\n"))
    }
}

/// An advice with its words.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct AdviceAnswer {
    /// The same keys as in `mindeg tradeoff --json`.
    #[serde(flatten)]
    pub advice: Advice,
    /// The sentence for each purpose where the boundary stays as it is, in the order of [`Purpose::ALL`].
    pub words: Vec<(Purpose, String)>,
    /// What points on edges bring a solver, in a sentence; null if that is not known to be more.
    pub on_edges: Option<String>,
}

impl AdviceAnswer {
    /// The advice in all its sentences.
    #[must_use]
    pub fn of(advice: Advice) -> Self {
        let words = Purpose::ALL.map(|purpose| (purpose, advice.as_it_is(purpose))).into();
        Self { words, on_edges: advice.on_edges(&Purpose::ALL), advice }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use mindeg::Side;
    use mindeg::interior::InteriorError;

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
        let hints = advice.hints(&MeshCommand::default(), None).unwrap();
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

    /// What a changed boundary brings is a second sentence, with a second command.
    #[test]
    fn points_on_edges_are_named_beside_points_inside() {
        let strip = |at: u32| {
            let y = f64::from(at);
            let ring = [[0.0, y], [10.0, y], [10.0, y + 0.5], [0.0, y + 0.5]];
            Domain::from_rings([ring]).unwrap()
        };
        let advice = Advice::of(&[strip(0)], Progress::NONE).unwrap();
        let (solver, conditioned) = (advice.solver.unwrap(), advice.conditioned.unwrap());
        assert!(solver.min_angle < 6.0 && conditioned.min_angle > 25.0, "{advice:?}");
        assert!(advice.points_on_edges > 4);
        let sentence = advice.sentence(Purpose::Solver);
        let more = format!(
            " If the boundary may have {} points more, condition it: minimum angle ",
            advice.points_on_edges
        );
        assert!(sentence.contains(&more), "{sentence}");
        let hints = advice.hints(&MeshCommand::default(), None).unwrap();
        let commands = "\nmindeg mesh DOMAIN.json --interior -o mesh-points-inside.obj\n\
                        mindeg mesh DOMAIN.json --interior --condition -o mesh-conditioned.obj";
        assert!(hints.contains(commands), "{hints}");
        // Of more than 2,000 points none are tried.
        let before = Advice { conditioned: None, points_on_edges: 0, ..advice.clone() };
        assert_eq!(before.clone().and_points_on_edges(&[strip(0)], Progress::NONE), advice);
        let many: Vec<Domain> = (0..501).map(strip).collect();
        assert_eq!(before.clone().and_points_on_edges(&many, Progress::NONE), before);
        // Nothing is asked of a boundary where triangles are good, or that cannot be better.
        let square = Domain::rectangle(1.0, 1.0, vec![Side::count(4); 4]).unwrap();
        let wedge = Domain::from_rings([[[0.0, 0.0], [10.0, 0.0], [10.0, 1.0]]]).unwrap();
        for domain in [square, wedge] {
            let advice = Advice::of(&[domain], Progress::NONE).unwrap();
            assert_eq!((advice.conditioned, advice.points_on_edges), (None, 0));
        }
    }

    /// Nobody makes the mesh again that was just written.
    #[test]
    fn the_mesh_that_was_made_is_no_hint() {
        let hints = |advice: &Advice, made| advice.hints(&MeshCommand::default(), made);
        let advice = Advice::among(inside(7, 40.0), made(5, 5.0, Some(1.0)), None);
        assert!(hints(&advice, made(4, 1.0, None)).unwrap().contains("--keep-angle"));
        let found = hints(&advice, made(5, 5.0, None)).unwrap();
        assert!(!found.contains("--keep-angle") && found.contains("--interior"), "{found}");
        let reason = NoPoints::Impossible("none".to_owned());
        let advice = Advice::among(Err(reason), made(5, 5.0, Some(1.0)), None);
        assert_eq!(hints(&advice, made(5, 5.0, None)), None);
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
        assert!(large.hints(&MeshCommand::default(), None).unwrap().contains("--interior -o"));
        let none = advice(&own_limit);
        assert_eq!(none.purposes(None), [Purpose::Patch, Purpose::Solver]);
        let reason = "Points inside cannot be put here: the mesh needs more than 50 points;";
        assert!(none.sentence(Purpose::Solver).starts_with(reason));
        assert!(!none.hints(&MeshCommand::default(), None).unwrap().contains("--interior"));
    }

    #[test]
    fn without_figures_the_advice_is_the_same() {
        let hints = Advice::UNMEASURED.hints(&MeshCommand::default(), None).unwrap();
        assert!(hints.ends_with("and measures them:\nmindeg tradeoff DOMAIN.json"), "{hints}");
        assert_eq!(
            Advice::UNMEASURED.text(None),
            "For a solver, put points inside.\nFor a patch that must keep its points, keep 95% of the angle."
        );
    }
}
