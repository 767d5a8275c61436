//! Whether a mesh is a triangulation of a domain, how good it is, and what it fails.

mod proof;

use self::proof::in_words;
use crate::demands::{Demands, WorstPlaces};
use crate::numbers::{count, number, percent, steady_angle};
use mindeg::exact::{self, share_of};
use mindeg::interior::{self, Violation};
use mindeg::quality::TriangleQuality;
use mindeg::verify::{MatchedPlane, MeshDefect, Optimality, VerifiedMesh};
use mindeg::{Domain, Interior, Progress, TriMesh};
use serde::Serialize;

/// Distances up to this many roundings of the largest coordinate are nothing.
const ROUNDINGS: f64 = 4.0;

/// Up to this many boundary points the largest possible angle is worked out.
const MOST_VERTICES: u32 = 1_000_000;

/// The limits that a mesh of a domain must keep.
#[derive(Clone, Copy, Debug, Default)]
pub struct VerifyDemands {
    /// Of any mesh.
    pub demands: Demands,
    /// The share of the largest possible minimum angle that the mesh has, 0 to 1.
    pub keep_angle: Option<f64>,
    /// Whether its maximum degree is proven to be the least.
    pub optimal: bool,
}

/// The verdict on a mesh; docs/verify.md gives the meaning of each key.
#[derive(Clone, Debug, Serialize)]
pub struct VerifyAnswer {
    file: String,
    domain: Option<String>,
    valid: bool,
    defect: Option<MeshDefect>,
    #[serde(flatten)]
    found: Option<Found>,
    /// The demands that the mesh fails, in words.
    pub failed: Vec<String>,
    passed: bool,
}

/// The figures of a mesh that is a triangulation; angles in degrees.
#[derive(Clone, Debug, Serialize)]
struct TogetherVertex {
    vertex: u32,
    share: f64,
}

#[derive(Clone, Debug, Serialize)]
struct Found {
    /// "xy", "floor" or "xz".
    plane: &'static str,
    reversed: bool,
    tolerance: f64,
    farthest: f64,
    /// The distance that rounding alone moves a point of this size: less is written as 0.
    #[serde(skip)]
    rounding: f64,
    boundary_vertices: usize,
    /// The points of the domain inside, on lines too.
    given_points: usize,
    interior_points: usize,
    unreferenced_vertices: usize,
    triangles: usize,
    max_degree: u32,
    max_degree_vertex: u32,
    /// The maximum degree where that is proven to be the least, else null.
    least_max_degree: Option<u32>,
    /// No mesh of the domain's points has a smaller maximum degree; null where no proof was checked.
    at_least: Option<u32>,
    /// The vertices inside whose degree is out of the wanted range, if there are interior points.
    violations: Vec<Violation>,
    /// Of these vertices, the ones where the lines alone are too many.
    certified: Vec<u32>,
    /// Others that no mesh with this share of the angles there brings nearer to their limits.
    together: Vec<TogetherVertex>,
    /// "yes", "no" or "unknown".
    optimal: &'static str,
    proof: Option<Checked>,
    reason: Option<String>,
    smaller_degree: Option<u32>,
    min_angle: f64,
    max_angle: f64,
    min_angle_triangle: usize,
    angle_limit: Option<f64>,
    /// 1 where only rounding keeps the minimum angle from its limit.
    share_of_limit: Option<f64>,
}

/// A proof that holds.
#[derive(Clone, Debug, Serialize)]
struct Checked {
    kind: &'static str,
    text: String,
}

impl VerifyAnswer {
    /// The answer for a mesh with a defect.
    #[must_use]
    pub fn invalid(file: &str, domain: &Domain, defect: MeshDefect) -> Self {
        Self {
            file: file.to_owned(),
            domain: domain.name().map(str::to_owned),
            valid: false,
            defect: Some(defect),
            found: None,
            failed: Vec::new(),
            passed: false,
        }
    }

    /// The answer for a mesh that is a triangulation of a domain.
    #[must_use]
    pub fn of(
        file: &str,
        domain: &Domain,
        mesh: &TriMesh,
        verified: &VerifiedMesh,
        optimality: &Optimality,
        demands: &VerifyDemands,
        progress: Progress<'_>,
    ) -> Self {
        let found = Found::of(verified, domain, optimality, progress);
        let mut failed = found.unmet(verified, demands);
        let preset = demands.demands.preset;
        failed.extend(preset.and_then(|preset| preset.broken_by(&unified(mesh, verified))));
        Self {
            file: file.to_owned(),
            domain: domain.name().map(str::to_owned),
            valid: true,
            defect: None,
            found: Some(found),
            passed: failed.is_empty(),
            failed,
        }
    }

    /// A line a figure; `called` is the domain.
    #[must_use]
    pub fn text(&self, called: &str) -> String {
        let Some(found) = &self.found else { return String::new() };
        let mut text = format!("{} is a triangulation of {}\n", self.file, called);
        let mut row = |name: &str, value: String| {
            text.push_str(&format!("{name:<17} {value}\n"));
        };
        let whole = |number: usize| count(number as u64);
        row(
            "boundary points",
            format!(
                "{}; the farthest vertex is {} off (tolerance {})",
                whole(found.boundary_vertices),
                number(if found.farthest <= found.rounding { 0.0 } else { found.farthest }),
                number(found.tolerance)
            ),
        );
        if found.given_points > 0 {
            row("points inside", format!("{}, of the domain", whole(found.given_points)));
        }
        row("interior points", whole(found.interior_points));
        row("triangles", whole(found.triangles));
        let at = found.max_degree_vertex;
        row("maximum degree", format!("{}, at vertex {at}", found.max_degree));
        if let Some(first) = found.violations.first() {
            let certified = match found.certified.len() {
                0 => String::new(),
                count => format!("; at {} of them no mesh keeps it, checked", whole(count)),
            };
            let together = match found.together.len() {
                0 => String::new(),
                count => {
                    format!("; at {} no mesh with such angles does better, checked", whole(count))
                }
            };
            let count = whole(found.violations.len());
            row(
                "degrees inside",
                format!(
                    "{count} out of range, the first at vertex {}{certified}{together}",
                    first.vertex
                ),
            );
        }
        row(
            "optimal",
            match (&found.proof, &found.reason, found.smaller_degree) {
                (Some(proof), ..) => format!("yes, checked: {}", proof.text),
                (_, _, Some(smaller)) => {
                    format!("no: a mesh with maximum degree {smaller} exists, checked")
                }
                (_, Some(reason), _) => format!("unknown: {reason}"),
                _ => String::new(),
            },
        );
        let of_limit = match (found.share_of_limit, found.angle_limit) {
            (Some(share), Some(limit)) => {
                let of = if found.interior_points > 0 {
                    "limit of the boundary"
                } else {
                    "largest possible"
                };
                format!("; {} of the {of}, {}", percent(share), steady_angle(limit))
            }
            _ => String::new(),
        };
        row(
            "minimum angle",
            format!(
                "{}, in triangle {}{of_limit}",
                steady_angle(found.min_angle),
                found.min_angle_triangle
            ),
        );
        if found.reversed {
            row(
                "note",
                "all triangles are clockwise; seen from the other side they are not".into(),
            );
        }
        match found.unreferenced_vertices {
            0 => {}
            1 => row("note", "1 vertex is in no triangle".into()),
            unused => row("note", format!("{} vertices are in no triangle", whole(unused))),
        }
        text
    }
}

impl Found {
    fn of(
        verified: &VerifiedMesh,
        domain: &Domain,
        optimality: &Optimality,
        progress: Progress<'_>,
    ) -> Self {
        let (optimal, proof, reason, smaller_degree) = match optimality {
            Optimality::Optimal { proof } => {
                let text = in_words(proof, verified.max_degree);
                ("yes", Some(Checked { kind: proof.kind(), text }), None, None)
            }
            Optimality::Improvable { reached, .. } => ("no", None, None, Some(*reached)),
            Optimality::Unknown { reason, .. } => ("unknown", None, Some(reason.clone()), None),
        };
        let at_least = match optimality {
            Optimality::Optimal { .. } => Some(verified.max_degree),
            Optimality::Improvable { at_least, .. } | Optimality::Unknown { at_least, .. } => {
                *at_least
            }
        };
        let is_highest = |degree: &u32| *degree == verified.max_degree;
        let highest = verified.degrees.iter().position(is_highest).unwrap_or(0);
        let quality = |corners: &[u32; 3]| {
            let [a, b, c] = corners.map(|v| verified.points[v as usize]);
            TriangleQuality::of(a, b, c)
        };
        let (mut worst, mut max_angle) = ((0, f64::INFINITY), 0.0_f64);
        for (index, quality) in verified.triangles.iter().map(quality).enumerate() {
            if quality.min_angle < worst.1 {
                worst = (index, quality.min_angle);
            }
            max_angle = max_angle.max(quality.max_angle);
        }
        let limit = angle_limit(verified, domain, progress);
        let boundary_vertices = domain.rings().vertex_count() as usize;
        let together = |&(point, share): &(u32, f64)| TogetherVertex {
            vertex: verified.vertex_of[point as usize],
            share,
        };
        let sizes = verified.points.iter().map(|point| point.abs().max_element());
        let largest = sizes.fold(0.0, f64::max);
        let violation = |point: &u32| Violation {
            vertex: verified.vertex_of[*point as usize],
            at: verified.points[*point as usize],
            degree: verified.degrees[*point as usize],
            is_boundary: (*point as usize) < boundary_vertices,
        };
        let vertices = |points: &[u32]| {
            points.iter().map(|point| verified.vertex_of[*point as usize]).collect::<Vec<_>>()
        };
        Self {
            plane: match verified.plane {
                MatchedPlane::Xy => "xy",
                MatchedPlane::Floor => "floor",
                MatchedPlane::Xz => "xz",
            },
            reversed: verified.is_reversed,
            tolerance: verified.tolerance,
            farthest: verified.farthest,
            rounding: ROUNDINGS * f64::EPSILON * largest,
            boundary_vertices,
            given_points: verified.points.len() - verified.interior_points - boundary_vertices,
            interior_points: verified.interior_points,
            unreferenced_vertices: verified.unused_vertices,
            triangles: verified.triangles.len(),
            max_degree: verified.max_degree,
            max_degree_vertex: verified.vertex_of[highest],
            least_max_degree: at_least.filter(|least| *least == verified.max_degree),
            at_least,
            violations: verified.out_of_range.iter().map(violation).collect(),
            certified: vertices(&verified.certified),
            together: verified.together.iter().map(together).collect(),
            optimal,
            proof,
            reason,
            smaller_degree,
            min_angle: worst.1,
            max_angle,
            min_angle_triangle: worst.0,
            angle_limit: limit,
            share_of_limit: limit.map(|limit| share_of(worst.1, limit)),
        }
    }

    /// The demands that the mesh fails, without those of a preset.
    fn unmet(&self, verified: &VerifiedMesh, demands: &VerifyDemands) -> Vec<String> {
        let mut failed = Vec::new();
        let vertex_of = |point: u32| verified.vertex_of[point as usize];
        if let Some(&point) = verified.above_limit.first() {
            let (vertex, degree) = (vertex_of(point), verified.degrees[point as usize]);
            let more = match verified.above_limit.len() - 1 {
                0 => String::new(),
                1 => ", and 1 vertex more does".to_owned(),
                more => format!(", and {more} vertices more do"),
            };
            failed.push(format!(
                "vertex {vertex} has {degree} edges, more than the domain allows at boundary point \
                 {point}{more}"
            ));
        }
        let triangle = self.min_angle_triangle;
        failed.extend(demands.demands.unmet(self.max_degree, self.min_angle, || {
            let corners = verified.triangles.get(triangle).copied().unwrap_or_default();
            WorstPlaces {
                vertex: Some(self.max_degree_vertex),
                triangle: Some((triangle as u32, corners.map(vertex_of))),
            }
        }));
        match (demands.keep_angle, self.share_of_limit) {
            (Some(share), Some(found)) if found < share => failed.push(format!(
                "triangle {triangle} has an angle of {}, {} of the largest possible minimum; \
                 --keep-angle asks for {}",
                steady_angle(self.min_angle),
                percent(found),
                percent(share)
            )),
            (Some(_), None) => failed.push(
                "the largest possible minimum angle is not known, which --keep-angle asks for"
                    .to_owned(),
            ),
            _ => {}
        }
        let unproven = match (self.smaller_degree, &self.reason) {
            (Some(smaller), _) => format!(
                "its maximum degree is {}, and a mesh with {smaller} exists; --optimal asks for the \
                 least",
                self.max_degree
            ),
            (_, Some(reason)) => format!(
                "--optimal asks for a proof, and whether it is optimal is unknown: {reason}"
            ),
            _ => return failed,
        };
        failed.extend(demands.optimal.then_some(unproven));
        failed
    }
}

/// The largest minimum angle that a mesh like this could have, if its boundary is small enough to tell.
fn angle_limit(verified: &VerifiedMesh, domain: &Domain, progress: Progress<'_>) -> Option<f64> {
    let boundary_points = domain.rings().vertex_count();
    if boundary_points > MOST_VERTICES {
        return None;
    }
    if verified.interior_points == 0 {
        return exact::delaunay_min_angle(domain, progress).ok();
    }
    // Meshes of its kind have at most the boundary degree of this mesh.
    let inside = |vertex: u32| {
        verified.degrees[vertex as usize].saturating_sub(domain.external_degree(vertex))
    };
    let boundary_degree = (0..boundary_points).map(inside).max();
    let wanted = Interior { boundary_degree, ..Interior::default() };
    interior::angle_limit(domain, &wanted).ok().map(|limit| limit.min_angle)
}

/// The mesh with one vertex at each point, under the mesh's own indices.
fn unified(mesh: &TriMesh, verified: &VerifiedMesh) -> TriMesh {
    let triangles =
        verified.triangles.iter().map(|corners| corners.map(|v| verified.vertex_of[v as usize]));
    TriMesh::new(mesh.positions().to_vec(), triangles.collect())
        .expect("positions and triangles are those of a mesh")
}
