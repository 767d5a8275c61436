//! Whether no mesh of the same boundary points has a smaller maximum degree.
//!
//! The solver says what the least is and why. None of that is taken for granted: a bound counts if its
//! proof holds for a checker that shares nothing with the solver, and a smaller degree if a mesh that has
//! it passes.
//!
//! Limits: the search over all triangulations of a polygon is repeated for some hundred vertices.

use std::ops::Range;

use mindeg_core::{certificate, least_degree_triangulation};
use mindeg_domain::{ConvexForm, Domain};
use mindeg_exact::check::CheckedOutline;
use mindeg_exact::check::refutation::{CheckedFace, refutes};
use mindeg_exact::{LowerBound, Reached, Refutation};
use mindeg_mesh::{Progress, TriMesh};

use super::joint::JointCheck;
use super::matching::VerifiedMesh;
use super::proof::Proof;
use super::triangulation::triangulation;
use crate::error::MeshError;
use crate::exact::{self, DegreeAnswer, DegreeBound};
use crate::goal::{Goal, mesh};
use crate::model::JointBound;
use crate::posed::Posed;

/// The steps of a search that is repeated: some seconds.
const MOST_STEPS: u64 = 2_000_000_000;

/// Whether the maximum degree of a mesh is the least possible.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Optimality {
    /// The degree is the least; its proof has been checked.
    Optimal {
        /// Why no mesh has less.
        proof: Proof,
    },
    /// The degree is not the least: a checked mesh has a smaller maximum degree.
    Improvable {
        /// The maximum degree of that mesh.
        reached: u32,
        /// The checked lower bound for every mesh; `None` without a checked bound.
        at_least: Option<u32>,
    },
    /// Unknown whether a mesh of a smaller maximum degree exists.
    Unknown {
        /// Why.
        reason: String,
        /// The checked lower bound for every mesh; `None` without a checked bound.
        at_least: Option<u32>,
    },
}

impl Optimality {
    fn unknown(reason: &str) -> Self {
        Self::Unknown { reason: reason.to_owned(), at_least: None }
    }
}

/// Whether no mesh of a domain's boundary points has a smaller maximum degree than this one. External
/// degrees count, and the domain's degree limits hold.
///
/// O(n) for a convex domain without constraints; else what [`exact::degree`] takes.
///
/// # Errors
///
/// The errors of [`exact::degree`].
pub fn optimality(
    verified: &VerifiedMesh,
    domain: &Domain,
    progress: Progress<'_>,
) -> Result<Optimality, MeshError> {
    let unknown = |reason: &str| Ok(Optimality::unknown(reason));
    if verified.interior_points > 0 {
        return unknown("it has interior points, and the least degree is that of meshes without");
    }
    if !verified.above_limit.is_empty() {
        return unknown("it breaks the degree limits of the domain");
    }
    match domain.convex() {
        Some(form) if !domain.is_constrained() => Ok(of_convex(form, verified.max_degree)),
        _ => of_any(verified, domain, progress),
    }
}

/// [`optimality`] by a proof that no mesh of the domain has a smaller maximum degree, which is repeated by code that
/// shares nothing with the search that made it.
///
/// # Errors
///
/// A domain with lines or points inside, points without a Delaunay triangulation, and a `progress` that cancels.
pub fn optimality_by(
    verified: &VerifiedMesh,
    domain: &Domain,
    refutation: &Refutation,
    progress: Progress<'_>,
) -> Result<Optimality, MeshError> {
    if domain.is_map() {
        return Err(MeshError::refused(
            "the domain has lines or points inside, and a proof in a file is of a domain without; without --proof the proof \
             is found and checked here",
        ));
    }
    let answer = DegreeAnswer {
        reached: verified.max_degree,
        at_least: verified.max_degree,
        reached_by: Reached::Search,
        bounded_by: DegreeBound::Polygon(LowerBound::Refuted(refutation.clone())),
    };
    let keeps_limits = verified.interior_points == 0 && verified.above_limit.is_empty();
    Ok(match checked_proof(&answer, domain, progress)? {
        Some(proof) if keeps_limits => Optimality::Optimal { proof },
        _ => Optimality::unknown("the proof does not hold for this mesh"),
    })
}

/// The proof of an answer's lower bound, if code that shares nothing with the search finds that it holds for the
/// points of a domain; none of a map, whose proof [`optimality`] checks.
///
/// # Errors
///
/// Points without a Delaunay triangulation, and a `progress` that cancels.
pub fn checked_proof(
    answer: &DegreeAnswer,
    domain: &Domain,
    progress: Progress<'_>,
) -> Result<Option<Proof>, MeshError> {
    let DegreeBound::Polygon(bound) = &answer.bounded_by else { return Ok(None) };
    let boundary = domain.boundary()?;
    let rings: Vec<Range<u32>> = domain.rings().rings().collect();
    let outline = CheckedOutline {
        points: boundary.points(),
        rings: &rings,
        side_of: boundary.runs(),
        keeps_clear: Posed::of_any_size(domain, progress)?.problem.keeps_clear(),
    };
    Ok(proof(bound, answer.at_least, &outline, domain))
}

fn of_convex(form: &ConvexForm, max_degree: u32) -> Optimality {
    let boundary = form.boundary();
    let intervals: Vec<u64> = boundary.sides().map(u64::from).collect();
    let certificate = certificate(boundary);
    let bound = certificate.check(&intervals).ok();
    if bound == Some(max_degree) {
        return Optimality::Optimal { proof: Proof::Certificate(certificate) };
    }
    let least = least_degree_triangulation(boundary);
    match mindeg_core::verify(&intervals, least.triangles()) {
        Ok(checked) if checked.max_degree < max_degree => {
            Optimality::Improvable { reached: checked.max_degree, at_least: bound }
        }
        _ => fault(),
    }
}

/// The message where a mesh and a proof contradict each other.
fn fault() -> Optimality {
    Optimality::unknown(
        "the mesh contradicts a proof of mindeg, which is a fault in mindeg; please report it",
    )
}

fn of_any(
    verified: &VerifiedMesh,
    domain: &Domain,
    progress: Progress<'_>,
) -> Result<Optimality, MeshError> {
    let answer = exact::degree(domain, progress)?;
    let max_degree = verified.max_degree;
    if answer.reached < max_degree {
        let least = mesh(domain, Goal::LeastDegree, progress)?.mesh;
        let points = least.points().map(|point| point.extend(0.0)).collect();
        let least = TriMesh::new(points, least.triangles().collect())?;
        let checked = triangulation(&least, domain, None).ok();
        let reached =
            checked.filter(|mesh| mesh.above_limit.is_empty()).map(|mesh| mesh.max_degree);
        if let Some(reached) = reached.filter(|&reached| reached < max_degree) {
            let proof = proof_for(verified, &answer, domain, progress)?;
            let at_least = proof.map(|_| answer.at_least);
            return Ok(Optimality::Improvable { reached, at_least });
        }
        return Ok(fault());
    }
    if answer.at_least > max_degree {
        return Ok(fault());
    }
    if answer.at_least < max_degree {
        let checked = proof_for(verified, &answer, domain, progress)?;
        let at_least = checked.map(|_| answer.at_least);
        let found = format!("none with less than {max_degree} was found");
        let reason = match at_least {
            Some(least) => format!("no mesh has less than {least}, checked, and {found}"),
            None => found,
        };
        return Ok(Optimality::Unknown { reason, at_least });
    }
    let is_search = match &answer.bounded_by {
        DegreeBound::Polygon(bound) => *bound == LowerBound::Exhaustive,
        DegreeBound::Map { bound, .. } => matches!(bound, JointBound::Weights { .. }),
    };
    Ok(match proof_for(verified, &answer, domain, progress)? {
        Some(proof) => Optimality::Optimal { proof },
        None if is_search => Optimality::unknown(&format!(
            "a search finds no mesh with less than {max_degree}, and is too long to be repeated here"
        )),
        None => fault(),
    })
}

/// [`checked_proof`] of a domain that a mesh is a triangulation of.
fn proof_for(
    verified: &VerifiedMesh,
    answer: &DegreeAnswer,
    domain: &Domain,
    progress: Progress<'_>,
) -> Result<Option<Proof>, MeshError> {
    let DegreeBound::Map { bound, rings, .. } = &answer.bounded_by else {
        return checked_proof(answer, domain, progress);
    };
    let boundary = domain.boundary()?;
    let check = JointCheck::new(domain, &boundary, verified);
    Ok(check.and_then(|check| check.proof(bound, rings, answer.at_least)))
}

/// The proof of a lower bound, if it holds.
fn proof(
    bounded_by: &LowerBound,
    bound: u32,
    outline: &CheckedOutline<'_>,
    domain: &Domain,
) -> Option<Proof> {
    match bounded_by {
        LowerBound::Counting => {
            let counted = outline.counting_bound(|vertex| domain.external_degree(vertex));
            (counted >= bound).then_some(Proof::Counting)
        }
        LowerBound::BlockedZigZags(chords) => {
            let holds = bound == 5 && outline.blocks_all_zigzags(chords);
            holds.then_some(Proof::BlockedZigZags { chords: chords.len() })
        }
        LowerBound::Apexes(apexes) => {
            let holds = apexes.max_degree() == bound && outline.bounds_apexes(apexes);
            let (edges, apexes) = (apexes.edges.len(), apexes.apexes.len());
            holds.then_some(Proof::Apexes { edges, apexes })
        }
        LowerBound::Exhaustive => {
            let is_possible = match most_chords(domain, bound.checked_sub(1)?) {
                Some(most) => outline.has_triangulation(&most, MOST_STEPS)?,
                // The boundary edges alone are too many.
                None => false,
            };
            (!is_possible).then_some(Proof::Search)
        }
        LowerBound::NoStrip => {
            (bound == 5 && outline.blocks_all_strips()).then_some(Proof::NoStrip)
        }
        LowerBound::Refuted(refutation) => {
            let most = most_chords(domain, bound.checked_sub(1)?)?;
            let vertices = Vec::from_iter(0..most.len() as u32);
            let face = CheckedFace { outline: *outline, vertices: &vertices, least_tangent: 0.0 };
            let clauses = refutation.clauses.len();
            refutes(&[face], &most, refutation).then_some(Proof::Refuted { clauses })
        }
        _ => None,
    }
}

/// The most chords that a degree limit and the domain's own limits leave to each vertex; none if a vertex has
/// more edges without.
fn most_chords(domain: &Domain, max_degree: u32) -> Option<Vec<u32>> {
    let chords = |vertex: u32| {
        let limit = domain.degree_limit(vertex).map_or(max_degree, |limit| limit.min(max_degree));
        limit.checked_sub(domain.external_degree(vertex).saturating_add(2))
    };
    (0..domain.rings().vertex_count()).map(chords).collect()
}
