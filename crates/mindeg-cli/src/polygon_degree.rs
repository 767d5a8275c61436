//! `mindeg degree` of a domain that no formula takes: one that is not convex, has holes, or limits
//! degrees.

use crate::failure::Failure;
use crate::interior_report::Limit;
use mindeg::Domain;
use mindeg::exact::{DegreeAnswer, LowerBound, Reached};
use mindeg_answers::words::{self, triangle_count};
use serde::Serialize;

/// What `--json` prints.
#[derive(Serialize)]
pub(crate) struct Answer<'a> {
    intervals: Vec<u32>,
    holes: usize,
    vertices: u32,
    triangles: u32,
    interior_edges: u32,
    /// Null where it is not known: then it is between the next two.
    least_max_degree: Option<u32>,
    at_least: u32,
    reached: u32,
    /// "zig_zag", "windows", "exhaustive" or "closed_form".
    reached_by: &'static str,
    certificate: Proof<'a>,
    /// The limit of the minimum angle with interior points.
    #[serde(skip_serializing_if = "Option::is_none")]
    angle_limit: Option<Limit>,
}

/// Why no mesh has a smaller maximum degree; vertices count from 0.
#[derive(Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
enum Proof<'a> {
    ClosedForm,
    Counting,
    /// None of these chords lies inside, and each zig-zag has one of them.
    BlockedZigZags {
        chords: &'a [[u32; 2]],
    },
    /// Only these vertices see both ends of one of the boundary edges that begin at `edges`, and none
    /// of those is the side of an ear.
    Apexes {
        edges: &'a [u32],
        apexes: &'a [u32],
    },
    Exhaustive,
}

impl<'a> Answer<'a> {
    pub(crate) fn new(
        domain: &Domain,
        answer: &'a DegreeAnswer,
        angle_limit: Option<Limit>,
    ) -> Self {
        let rings = domain.rings();
        let triangles = triangle_count(rings);
        Self {
            intervals: rings.sides().collect(),
            holes: rings.ring_count() - 1,
            vertices: rings.vertex_count(),
            triangles,
            // Every triangle has three sides, and boundary edges have one triangle.
            interior_edges: (3 * u64::from(triangles) - u64::from(rings.vertex_count())) as u32 / 2,
            least_max_degree: answer.least_max_degree(),
            at_least: answer.at_least,
            reached: answer.reached,
            reached_by: match answer.reached_by {
                Reached::ZigZag(_) => "zig_zag",
                Reached::Windows => "windows",
                Reached::ClosedForm => "closed_form",
                _ => "exhaustive",
            },
            certificate: match &answer.bounded_by {
                LowerBound::ClosedForm => Proof::ClosedForm,
                LowerBound::BlockedZigZags(chords) => Proof::BlockedZigZags { chords },
                LowerBound::Apexes(bound) => {
                    Proof::Apexes { edges: &bound.edges, apexes: &bound.apexes }
                }
                LowerBound::Counting => Proof::Counting,
                _ => Proof::Exhaustive,
            },
            angle_limit,
        }
    }

    /// The counts, the degree and the reasons, in lines.
    pub(crate) fn text(&self, domain: &Domain, answer: &DegreeAnswer) -> String {
        let mut rows = vec![("sides", domain.rings().side_count().to_string())];
        if self.holes > 0 {
            rows.push(("holes", self.holes.to_string()));
        }
        rows.extend([
            ("vertices", self.vertices.to_string()),
            ("triangles", self.triangles.to_string()),
            ("interior edges", self.interior_edges.to_string()),
            (
                "least maximum degree",
                match self.least_max_degree {
                    Some(least) => least.to_string(),
                    None => format!("{} to {}", self.at_least, self.reached),
                },
            ),
        ]);
        let rows = rows.into_iter().map(|(name, value)| format!("{name:<21} {value}\n"));
        let mut text: String = rows.collect();
        text.push('\n');
        text.push_str(&words::degree(domain, answer));
        text
    }
}

/// Why a domain has no answer.
pub(crate) fn failed(error: &mindeg::exact::ExactError) -> Failure {
    Failure::Input(error.to_string())
}
