//! The goal of a mesh, and the only module that decides between formula, search and windows.
//!
//! [`GOALS`] tells front ends what there is to know of each goal: options, keys, refusals and choices
//! come from it.

mod share;

use mindeg_core::Boundary;
use mindeg_domain::Domain;
use mindeg_exact::{MAX_VERTICES, Unsolved};
use mindeg_mesh::Progress;

use crate::boundary_mesh::BoundaryMesh;
use crate::degree_first::degree_first;
use crate::error::MeshError;
use crate::exact;
use crate::keep_angle::keep_angle;
use crate::map;
use crate::meshed::{FoundBy, Meshed};
use crate::posed::Posed;
use crate::searched::Searched;
use crate::windowed::{SHARES, within};

/// Up to this many chords between different sides, times the least maximum degree, the search for the
/// best mesh of least degree takes less than about half a second on one core.
const LITTLE_WORK: u64 = 150_000;

/// Up to this many triples of vertices that see each other, the same search takes about as long on a
/// polygon that is not convex.
const FEW_TRIPLES: u64 = 1_000_000;

/// The goal of a mesh.
///
/// In JSON, `"least_degree"`, or the key and the value of a row of [`GOALS`], such as `{"keep_angle": 0.95}`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "json", derive(serde::Deserialize, serde::Serialize))]
#[cfg_attr(feature = "json", serde(rename_all = "snake_case"))]
pub enum Goal {
    /// The least maximum degree, at any size.
    ///
    /// Where few chords join different sides, or a convex domain
    /// [is constrained](Domain::is_constrained), the mesh with the largest minimum angle of all with that
    /// degree, by the solver. Else, of a convex domain, the best of at most 64 candidates that the
    /// construction gives; of any other, one whose angle costs little to find: no mesh that windows reach at this degree has a larger
    /// one.
    ///
    /// Where too many vertices see each other, the least degree that windows reach.
    #[default]
    LeastDegree,
    /// The least maximum degree of all meshes that have this share, 0 to 1, of the minimum angle of a
    /// Delaunay triangulation: exactly where [`MaxDegree`](Self::MaxDegree) is, else as low as windows
    /// reach.
    KeepAngle(f64),
    /// No total degree above a limit, and the largest minimum angle within it: exactly up to
    /// [`MAX_VERTICES`] boundary vertices of a convex domain, for polygons in which few vertices see each
    /// other, and with holes where searches decide; beyond that, as large as windows reach.
    MaxDegree(u32),
    /// The least maximum degree as the limit of [`MaxDegree`](Self::MaxDegree), also where
    /// [`LeastDegree`](Self::LeastDegree) leaves the search out for its cost.
    Optimize(Optimized),
}

/// The measure that a mesh of least degree is the best in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "json", derive(serde::Deserialize, serde::Serialize))]
#[cfg_attr(feature = "json", serde(rename_all = "snake_case"))]
pub enum Optimized {
    /// The minimum angle of all triangles.
    Angle,
}

/// A kind of goal, as front ends offer it.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "json", derive(serde::Serialize))]
pub struct GoalKind {
    /// The key in JSON and Python.
    pub key: &'static str,
    /// The value that goes with the key.
    pub value: GoalValue,
    /// The mesh that it asks for, in sentences; the first is enough where there is little room.
    pub help: &'static str,
    /// The words of a choice between goals, with `{}` for the value; `None` where a curve or another control
    /// offers it.
    pub choice: Option<&'static str>,
    /// Whether models take it.
    pub models: bool,
    /// The option of `mindeg mesh --interior` to give instead, and what it does; `None` for a goal that holds with
    /// interior points.
    pub instead: Option<&'static str>,
    #[cfg_attr(feature = "json", serde(skip))]
    read: fn(&str) -> Result<Goal, String>,
}

/// The value of a goal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "json", derive(serde::Serialize))]
#[cfg_attr(feature = "json", serde(rename_all = "snake_case"))]
pub enum GoalValue {
    /// None.
    Nothing,
    /// A share, 0 to 1, or a percentage.
    Share,
    /// A number of edges.
    Degree,
    /// This word.
    Word(&'static str),
}

/// All goals. Of several that are given together, the first decides, and a maximum degree is demanded besides.
pub static GOALS: [GoalKind; 4] = [
    GoalKind {
        key: "keep_angle",
        value: GoalValue::Share,
        help: "Make the mesh with the smallest maximum degree that keeps this share of Delaunay's minimum angle, \
               such as 95% or 0.95. Beyond 4096 vertices the degree is what was \
               reached",
        choice: Some("the least that keeps {} % of the angle"),
        models: true,
        instead: Some("--target-angle A asks for a minimum angle"),
        read: |text| Goal::share(text).map(Goal::KeepAngle),
    },
    GoalKind {
        key: "max_degree",
        value: GoalValue::Degree,
        help: "Make the mesh with the largest minimum angle of all whose vertices have at most this many edges; \
               beyond 4096 vertices what was reached. One with more is never written",
        choice: None,
        models: true,
        instead: None,
        read: |text| match text.trim().parse() {
            Ok(limit) => Ok(Goal::MaxDegree(limit)),
            Err(_) => Err("give a whole number of 0 or more, such as 5".to_owned()),
        },
    },
    GoalKind {
        key: "optimize",
        value: GoalValue::Word("angle"),
        help: "Make the mesh with the largest minimum angle within --max-degree, or else of the least possible \
               maximum degree, also where that costs too much for the default",
        choice: None,
        models: false,
        instead: Some("--prefer angle puts the minimum angle first"),
        read: |text| match text {
            "angle" => Ok(Goal::Optimize(Optimized::Angle)),
            _ => Err("give angle".to_owned()),
        },
    },
    GoalKind {
        key: "least_degree",
        value: GoalValue::Nothing,
        help: "Make the mesh with the least possible maximum degree, which is the default",
        choice: Some("the least degree"),
        models: true,
        instead: None,
        read: |_| Ok(Goal::LeastDegree),
    },
];

impl GoalKind {
    /// The goal of this kind with a value as people write it.
    ///
    /// # Errors
    ///
    /// A sentence that says what to write instead.
    pub fn read(&self, value: &str) -> Result<Goal, String> {
        (self.read)(value)
    }

    /// The option of the command line.
    pub fn option(&self) -> String {
        format!("--{}", self.key.replace('_', "-"))
    }
}

impl Goal {
    /// The kind, and the value as [`GoalKind::read`] takes it.
    pub fn kind_and_value(self) -> (&'static GoalKind, String) {
        let (key, value) = match self {
            Self::LeastDegree => ("least_degree", String::new()),
            Self::KeepAngle(share) => ("keep_angle", share::percentage(share)),
            Self::MaxDegree(limit) => ("max_degree", limit.to_string()),
            Self::Optimize(Optimized::Angle) => ("optimize", "angle".to_owned()),
        };
        let kind = GOALS.iter().find(|kind| kind.key == key);
        (kind.expect("each goal has a row, as a test holds"), value)
    }

    /// Why a subject does not take this goal, and which goals models take; `of` takes it.
    pub(crate) fn refused(self, of: &str, subject: &str) -> MeshError {
        let others = GOALS.iter().filter(|kind| kind.models && kind.value != GoalValue::Nothing);
        let instead = others.map(GoalKind::option).collect::<Vec<_>>().join(" or ");
        let option = self.kind_and_value().0.option();
        MeshError::Refused(format!("{option} is for {of}; for {subject} give {instead}"))
    }

    /// The share for [`KeepAngle`](Self::KeepAngle) that people write as `0.95` or as `95%`.
    ///
    /// # Errors
    ///
    /// A sentence that says what to write instead.
    pub fn share(text: &str) -> Result<f64, String> {
        share::read(text)
    }
}

/// The mesh of a domain that a goal asks for.
///
/// # Errors
///
/// Points so close together that triangles have no area; limits of degrees that no mesh keeps; a
/// domain with limits of single vertices that is too large for the solver; and a `progress` callback
/// that cancels.
///
/// # Example
///
/// ```
/// use mindeg::{Domain, Goal, Progress, Side, mesh};
///
/// let domain = Domain::rectangle(4.0, 3.0, [12, 9, 4, 4].map(Side::count).into())?;
/// let least = mesh(&domain, Goal::LeastDegree, Progress::NONE)?;
/// let kept = mesh(&domain, Goal::KeepAngle(0.95), Progress::NONE)?;
/// assert_eq!((least.mesh.max_degree(), kept.mesh.max_degree()), (5, 6));
/// assert!(kept.mesh.angle_range().min >= 0.95 * kept.delaunay_min_angle.unwrap());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn mesh(domain: &Domain, goal: Goal, progress: Progress<'_>) -> Result<Meshed, MeshError> {
    if domain.is_map() {
        return match goal {
            Goal::LeastDegree => map::least_degree(domain, progress),
            Goal::KeepAngle(share) => map::keep_angle(domain, share, progress),
            Goal::MaxDegree(limit) => map::max_degree(domain, limit, progress),
            Goal::Optimize(Optimized::Angle) => map::optimize(domain, progress),
        };
    }
    match goal {
        Goal::LeastDegree => least_degree(domain, progress),
        Goal::KeepAngle(share) => keep_angle(domain, share, progress),
        Goal::MaxDegree(limit) => max_degree(domain, limit, progress),
        Goal::Optimize(Optimized::Angle) => optimize(domain, progress),
    }
}

/// The least maximum degree where the formula gives it.
fn least_by_formula(domain: &Domain) -> Option<u32> {
    let form = domain.convex().filter(|_| !domain.is_constrained())?;
    Some(mindeg_core::least_max_degree(form.boundary()))
}

/// Whether the mesh of [`Goal::LeastDegree`] comes from the formula, in time linear in its vertices: the
/// domain is convex and unconstrained, and too large for a search of about half a second. O(k) for k sides.
pub fn is_by_formula(domain: &Domain) -> bool {
    domain.convex().is_some_and(|form| {
        let boundary = form.boundary();
        let is_cheap = boundary.vertex_count() <= MAX_VERTICES && work(boundary) <= LITTLE_WORK;
        !is_cheap && !domain.is_constrained()
    })
}

fn least_degree(domain: &Domain, progress: Progress<'_>) -> Result<Meshed, MeshError> {
    if is_by_formula(domain) {
        return formula(domain, progress);
    }
    let posed = Posed::new(domain, progress)?;
    if domain.convex().is_some() || posed.is_within(FEW_TRIPLES, progress)? {
        best_of_least_degree(&posed, progress)
    } else {
        degree_first(&posed, progress)
    }
}

/// The mesh of least degree with the largest minimum angle.
fn best_of_least_degree(posed: &Posed<'_>, progress: Progress<'_>) -> Result<Meshed, MeshError> {
    let trade_off = exact::exact_trade_off(posed, |_, _| true, progress)?;
    if trade_off.meshes().is_empty() {
        return formula(posed.domain(), progress);
    }
    Ok(trade_off.meshed(0))
}

fn formula(domain: &Domain, progress: Progress<'_>) -> Result<Meshed, MeshError> {
    let form = domain.convex().ok_or_else(MeshError::not_convex)?;
    Ok(Meshed {
        mesh: BoundaryMesh::of_formula(domain, progress)?,
        least_max_degree: mindeg_core::least_max_degree(form.boundary()),
        is_least_proven: true,
        found_by: FoundBy::Formula,
        delaunay_min_angle: None,
    })
}

/// The mesh that has the least degree as its limit.
fn optimize(domain: &Domain, progress: Progress<'_>) -> Result<Meshed, MeshError> {
    if let Some(least) = least_by_formula(domain) {
        return max_degree(domain, least, progress);
    }
    let found = least_degree(domain, progress)?;
    let best = max_degree(domain, found.mesh.max_total_degree(), progress)?;
    Ok(best.with_bound_of(&found))
}

fn max_degree(domain: &Domain, limit: u32, progress: Progress<'_>) -> Result<Meshed, MeshError> {
    // Refused at once, at any size.
    if let Some(least) = least_by_formula(domain).filter(|least| limit < *least) {
        return Err(Unsolved::Infeasible { max_degree: limit, least }.into());
    }
    let posed = Posed::of_any_size(domain, progress)?;
    if posed.has_best_angles(progress)? {
        let answer = exact::degree(domain, progress)?;
        return Ok(Meshed {
            mesh: exact::best_mesh(&posed, limit, progress)?.mesh,
            least_max_degree: answer.at_least,
            is_least_proven: answer.least_max_degree().is_some(),
            found_by: FoundBy::Search,
            delaunay_min_angle: posed.delaunay_min_angle,
        });
    }
    if let Some(searched) = Searched::new(&posed, progress)? {
        return searched.max_degree(limit);
    }
    if let Some(meshed) = within(&posed, SHARES, limit, progress)? {
        return Ok(meshed);
    }
    if least_by_formula(domain).is_some() {
        // The formula reaches degrees that no window reaches, for example round a dominant side.
        return formula(domain, progress);
    }
    let meshed = degree_first(&posed, progress)?;
    let (reached, at_least) = (meshed.mesh.max_total_degree(), meshed.least_max_degree);
    if reached <= limit {
        Ok(meshed)
    } else {
        Err(MeshError::not_reached(limit, reached, at_least))
    }
}

/// How many chords join vertices that are not on one side, times the least maximum degree. O(k).
fn work(boundary: &Boundary) -> u64 {
    let pairs = |vertices: u64| vertices * (vertices - 1) / 2;
    let on_sides: u64 = boundary.sides().map(|intervals| pairs(u64::from(intervals) + 1)).sum();
    let chords = pairs(boundary.vertex_count().into()) - on_sides;
    chords.saturating_mul(mindeg_core::least_max_degree(boundary).into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_are_numbers_or_percentages() {
        for (text, share) in
            [("0.95", 0.95), ("95%", 0.95), (" 95 %", 0.95), ("1", 1.0), ("0%", 0.0)]
        {
            assert_eq!(Goal::share(text), Ok(share), "{text}");
        }
        for (text, words) in [
            ("95", "for 95 percent write 0.95 or 95%"),
            ("101%", "from 0% to 100%"),
            ("200", "give a share from 0 to 1"),
            ("-0.1", "give a share from 0 to 1"),
            ("NaN", "give a share from 0 to 1"),
            ("", "give a share from 0 to 1"),
        ] {
            assert!(Goal::share(text).is_err_and(|error| error.contains(words)), "{text}");
        }
    }

    #[test]
    fn every_goal_is_read_back_from_its_option() {
        for (kind, text) in GOALS.iter().zip(["95%", "5", "angle", ""]) {
            let goal = kind.read(text).unwrap();
            let (found, value) = goal.kind_and_value();
            assert_eq!((found.key, &*value), (kind.key, text));
        }
    }

    #[test]
    fn shares_are_read_back() {
        for (share, text) in [(0.95, "95%"), (1.0, "100%"), (0.0, "0%"), (0.123, "0.123")] {
            assert_eq!(share::percentage(share), text);
        }
        assert_eq!(share::percentage(1.0 / 3.0).parse(), Ok(1.0 / 3.0));
    }

    #[test]
    fn work_counts_the_chords_that_join_different_sides() {
        for intervals in [&[3, 4, 5][..], &[1, 1, 1, 1], &[7, 1, 2, 3], &[9, 2, 2, 2, 4]] {
            let boundary = Boundary::new(intervals).unwrap();
            let side_of: Vec<usize> =
                (0..intervals.len()).flat_map(|k| vec![k; intervals[k] as usize]).collect();
            let n = side_of.len();
            // The sides of the edge that begins at a vertex and of the edge that ends there.
            let sides = |v: usize| [side_of[v], side_of[(v + n - 1) % n]];
            let joins = |a: usize, b: usize| !sides(a).iter().any(|side| sides(b).contains(side));
            let chords =
                (0..n).flat_map(|a| (0..a).map(move |b| (a, b))).filter(|&(a, b)| joins(a, b));
            let degree = mindeg_core::least_max_degree(&boundary);
            assert_eq!(work(&boundary), chords.count() as u64 * u64::from(degree), "{intervals:?}");
        }
    }
}
