//! The output of `mindeg verify`.

use crate::domain::name_in_text;
use mindeg::Domain;
use mindeg::exact::share_of;
use mindeg::verify::{MatchedPlane, MeshDefect, Optimality, Proof, VerifiedMesh};
use mindeg_answers::numbers::{count, four_digits, percent, steady_angle};
use serde::Serialize;
use std::borrow::Cow;

/// The output of `--json`; docs/verify.md gives the meaning of each key.
#[derive(Serialize)]
pub(super) struct Report<'a> {
    file: &'a str,
    domain: Option<&'a str>,
    valid: bool,
    defect: Option<Flaw>,
    #[serde(flatten)]
    found: Option<Found>,
    failed: &'a [String],
    passed: bool,
    #[serde(skip)]
    called: Cow<'a, str>,
}

/// The first defect.
#[derive(Serialize)]
struct Flaw {
    kind: &'static str,
    message: String,
}

/// The figures of a mesh that is a triangulation; angles in degrees.
#[derive(Serialize)]
struct Found {
    /// "xy", "floor" or "xz".
    plane: &'static str,
    reversed: bool,
    tolerance: f64,
    farthest: f64,
    boundary_vertices: usize,
    interior_points: usize,
    unreferenced_vertices: usize,
    triangles: usize,
    max_degree: u32,
    max_degree_vertex: u32,
    /// "yes", "no" or "unknown".
    optimal: &'static str,
    proof: Option<Checked>,
    reason: Option<String>,
    smaller_degree: Option<u32>,
    min_angle: f64,
    max_angle: f64,
    min_angle_triangle: usize,
    angle_limit: Option<f64>,
    share_of_limit: Option<f64>,
}

/// A proof that holds.
#[derive(Serialize)]
struct Checked {
    kind: &'static str,
    text: String,
}

/// The angles of a mesh, in degrees.
pub(super) struct Angles {
    pub(super) min: f64,
    /// The triangle with the minimum angle.
    pub(super) triangle: usize,
    pub(super) max: f64,
    /// The largest minimum angle that a mesh can have, where it was worked out.
    pub(super) limit: Option<f64>,
}

impl Angles {
    /// The share of the limit that the minimum angle has; 1 where only rounding keeps them apart.
    pub(super) fn share(&self) -> Option<f64> {
        self.limit.map(|limit| share_of(self.min, limit))
    }
}

/// The first vertex of maximum degree, as the mesh counts.
pub(super) fn highest_vertex(verified: &VerifiedMesh) -> u32 {
    let is_highest = |degree: &u32| *degree == verified.max_degree;
    let point = verified.degrees.iter().position(is_highest).unwrap_or(0);
    verified.vertex_of[point]
}

impl<'a> Report<'a> {
    pub(super) fn invalid(file: &'a str, domain: &'a Domain, defect: &MeshDefect) -> Self {
        Self {
            file,
            domain: domain.name(),
            valid: false,
            defect: Some(Flaw { kind: defect.kind, message: defect.to_string() }),
            found: None,
            failed: &[],
            passed: false,
            called: name_in_text(domain),
        }
    }

    pub(super) fn of(
        file: &'a str,
        domain: &'a Domain,
        verified: &VerifiedMesh,
        optimality: &Optimality,
        angles: Angles,
        failed: &'a [String],
    ) -> Self {
        let share = angles.share();
        let (optimal, proof, reason, smaller_degree) = match optimality {
            Optimality::Optimal { proof } => {
                let text = in_words(proof, verified.max_degree);
                ("yes", Some(Checked { kind: proof.kind(), text }), None, None)
            }
            Optimality::Improvable { reached, .. } => ("no", None, None, Some(*reached)),
            Optimality::Unknown { reason } => ("unknown", None, Some(reason.clone()), None),
        };
        let found = Found {
            plane: match verified.plane {
                MatchedPlane::Xy => "xy",
                MatchedPlane::Floor => "floor",
                MatchedPlane::Xz => "xz",
            },
            reversed: verified.is_reversed,
            tolerance: verified.tolerance,
            farthest: verified.farthest,
            boundary_vertices: verified.points.len() - verified.interior_points,
            interior_points: verified.interior_points,
            unreferenced_vertices: verified.unused_vertices,
            triangles: verified.triangles.len(),
            max_degree: verified.max_degree,
            max_degree_vertex: highest_vertex(verified),
            optimal,
            proof,
            reason,
            smaller_degree,
            min_angle: angles.min,
            max_angle: angles.max,
            min_angle_triangle: angles.triangle,
            angle_limit: angles.limit,
            share_of_limit: share,
        };
        Self {
            file,
            domain: domain.name(),
            valid: true,
            defect: None,
            found: Some(found),
            failed,
            passed: failed.is_empty(),
            called: name_in_text(domain),
        }
    }

    /// A line a figure.
    pub(super) fn text(&self) -> String {
        let Some(found) = &self.found else { return String::new() };
        let mut text = format!("{} is a triangulation of {}\n", self.file, self.called);
        let mut row = |name: &str, value: String| {
            text.push_str(&format!("{name:<17} {value}\n"));
        };
        let whole = |number: usize| count(number as u64);
        row(
            "boundary points",
            format!(
                "{}; the farthest vertex is {} off (tolerance {})",
                whole(found.boundary_vertices),
                four_digits(found.farthest),
                four_digits(found.tolerance)
            ),
        );
        row("interior points", whole(found.interior_points));
        row("triangles", whole(found.triangles));
        let at = found.max_degree_vertex;
        row("maximum degree", format!("{}, at vertex {at}", found.max_degree));
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

/// Why no mesh has less.
fn in_words(proof: &Proof, degree: u32) -> String {
    use mindeg_core::Certificate;
    let less = degree - 1;
    match proof {
        Proof::Certificate(Certificate::LongSide { side, .. }) => {
            format!("side {} is so long that {less} is too little (theorem 4)", side + 1)
        }
        Proof::Certificate(Certificate::NoBalancedCut { least_imbalance }) => format!(
            "every two runs of sides differ by {least_imbalance} intervals or more, and 4 takes 1 at \
             most (theorem 5)"
        ),
        Proof::Certificate(_) | Proof::Counting => {
            format!("the edges are too many for {less} at every vertex (theorems 3 and 15)")
        }
        Proof::BlockedZigZags { chords } => format!(
            "{chords} chords that do not lie inside block every mesh of degree {less} (theorem 13)"
        ),
        Proof::Apexes { edges, apexes } => {
            format!("{edges} boundary edges have only {apexes} apexes (theorem 14)")
        }
        _ => format!("two searches over all meshes, by different code, find none with {less}"),
    }
}
