//! `mindeg degree` of a domain that no formula takes: one that is not convex, has holes, or limits
//! degrees.

use crate::failure::Failure;
use crate::interior_report::Limit;
use mindeg::exact::{DegreeAnswer, LowerBound, Reached};
use mindeg::{Domain, Rings};
use mindeg_compare::number_format::count;
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

/// The triangles of every mesh.
pub(crate) fn triangle_count(rings: &Rings) -> u32 {
    rings.vertex_count() + 2 * (rings.ring_count() as u32 - 1) - 2
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
        text.push_str(&why_not_less(domain, answer));
        text.push_str(&how_reached(answer));
        if self.least_max_degree.is_none() {
            let open = match (self.at_least, self.reached - 1) {
                (least, most) if least == most => format!("degree {least}"),
                (least, most) => format!("a degree from {least} to {most}"),
            };
            text.push_str(&format!(
                "Whether {open} is possible is not known: {}.\n",
                if self.holes > 0 {
                    "with holes, not all meshes are searched"
                } else {
                    "too many of its vertices see each other for a search of all meshes"
                }
            ));
        }
        text
    }
}

/// Why the degree cannot be less, in sentences.
fn why_not_less(domain: &Domain, answer: &DegreeAnswer) -> String {
    let vertices = domain.rings().vertex_count();
    let bound = answer.at_least;
    match &answer.bounded_by {
        LowerBound::BlockedZigZags(chords) => {
            let [from, to] = chords.first().copied().unwrap_or_default();
            format!(
                "No mesh has less than {bound}: from 7 vertices on, a mesh of degree 4 is one of {} zig-zags across \
                 the whole polygon,\nand each of these has a chord that does not lie inside, such as \
                 the one from vertex {from} to vertex {to}.\n",
                count(vertices)
            )
        }
        LowerBound::Apexes(apexes) => format!(
            "No mesh has less than {bound}: {} boundary edges, the first from vertex {} on, are the side of no ear, \
             and only {} vertices\nsee both ends of one of them. A vertex of degree {} is the apex of \
             at most {} of these edges.\n",
            count(apexes.edges.len() as u32),
            apexes.edges.first().copied().unwrap_or_default(),
            count(apexes.apexes.len() as u32),
            bound - 1,
            bound - 4,
        ),
        LowerBound::Counting => format!(
            "No mesh has less than {bound}: the {} edges of every mesh have two ends each, at {} vertices{}, so that \
             one of these\nhas {bound} or more.\n",
            count(edge_count(domain)),
            count(vertices),
            if domain.is_constrained() { " with external edges besides" } else { "" }
        ),
        LowerBound::ClosedForm => {
            "It cannot be less, by the formula for convex domains.\n".to_owned()
        }
        _ => format!(
            "No mesh has less than {bound}: of all triangulations, none {}has a maximum degree of {}.\n",
            if domain.is_constrained() { "that keeps the limits " } else { "" },
            bound.saturating_sub(1)
        ),
    }
}

fn edge_count(domain: &Domain) -> u32 {
    let (triangles, vertices) = (triangle_count(domain.rings()), domain.rings().vertex_count());
    ((3 * u64::from(triangles) + u64::from(vertices)) / 2) as u32
}

/// How the degree is reached, in a sentence.
fn how_reached(answer: &DegreeAnswer) -> String {
    let degree = answer.reached;
    match answer.reached_by {
        Reached::ZigZag(zigzag) => {
            format!("Degree {degree} is reached by the zig-zag from vertex {} on.\n", zigzag.tip)
        }
        Reached::Windows => format!(
            "Degree {degree} is reached by windows of a Delaunay triangulation, each triangulated \
             anew.\n"
        ),
        _ => format!("Degree {degree} is reached by a search over all triangulations.\n"),
    }
}

/// Why a domain has no answer.
pub(crate) fn failed(error: &mindeg::exact::ExactError) -> Failure {
    Failure::Input(error.to_string())
}
