//! The least maximum degree of a boundary, why it cannot be less, and how it is reached.

use crate::limit::LimitAnswer;
use crate::numbers::count;
use crate::proof::ProofFile;
use mindeg::exact::{DegreeAnswer, LowerBound, Reached, degree_with};
use mindeg::verify::checked_proof;
use mindeg::{Domain, Progress, Rings};
use mindeg_core::{Boundary, Certificate};
use serde::Serialize;

/// The least maximum degree of all meshes of some boundary points.
#[derive(Clone, Debug, Serialize)]
pub struct DegreeReport {
    /// The intervals of each side. Where the formula answers, sides on one line count as one, and each edge of
    /// a curve as a side.
    pub intervals: Vec<u64>,
    /// The number of holes.
    pub holes: usize,
    /// The number of vertices.
    pub vertices: u32,
    /// The number of triangles of every mesh.
    pub triangles: u32,
    /// The number of interior edges of every mesh.
    pub interior_edges: u32,
    /// Null where it is not known: then it is between the next two.
    pub least_max_degree: Option<u32>,
    /// No mesh has a smaller maximum degree.
    pub at_least: u32,
    /// Some mesh has this one.
    pub reached: u32,
    /// `formula`, `zig_zag`, `strip`, `windows`, `search` (with holes) or `exhaustive`.
    pub reached_by: &'static str,
    /// Why no mesh has less than `at_least`.
    pub certificate: DegreeProof,
    /// The clauses of a refutation, for a file of their own.
    #[serde(skip)]
    pub proof: Option<ProofFile>,
    /// The limit of the minimum angle with interior points, if it was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub limit: Option<LimitAnswer>,
    /// Why it cannot be less, and how it is reached: sentences with their line breaks.
    #[serde(skip)]
    pub words: String,
}

/// Why no mesh has a smaller maximum degree. Sides count from 1, as in the words; vertices from 0.
#[derive(Clone, Debug, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum DegreeProof {
    /// Edges are counted, and a zig-zag across this cut reaches the bound.
    BalancedCut {
        /// The first side of the larger run.
        first_side: usize,
        /// How many sides the larger run has.
        side_count: usize,
        /// The intervals of the larger run.
        larger: u32,
        /// The intervals of the smaller run.
        smaller: u32,
        /// The degree.
        bound: u32,
    },
    /// The triangle through the three midpoints.
    MedialTriangle {
        /// The degree.
        bound: u32,
    },
    /// The vertices off one long side share almost all interior edges.
    LongSide {
        /// The side.
        side: usize,
        /// The degree.
        bound: u32,
    },
    /// No two runs of sides are alike.
    NoBalancedCut {
        /// By how many intervals they differ at least.
        least_imbalance: u32,
        /// The degree.
        bound: u32,
    },
    /// The edges have too many ends.
    Counting,
    /// No chord of this list lies inside, and each zig-zag has one of them.
    BlockedZigZags {
        /// The chords.
        chords: Vec<[u32; 2]>,
    },
    /// Only these vertices see both ends of one of the boundary edges that begin at `edges`, and none
    /// of those is the side of an ear.
    Apexes {
        /// The first vertices of the edges.
        edges: Vec<u32>,
        /// The vertices.
        apexes: Vec<u32>,
    },
    /// All triangulations were searched.
    Exhaustive,
    /// Degree 4 takes a strip between both rings, and none lies inside.
    NoStrip,
    /// Clauses lead to a contradiction, each of which follows from those before.
    Refuted {
        /// Their number.
        clauses: usize,
        /// Whether code that shares nothing with the search has repeated them.
        checked: bool,
    },
}

impl DegreeReport {
    /// The degree of a domain.
    ///
    /// # Errors
    ///
    /// The errors of [`degree_with`].
    pub fn of(domain: &Domain, progress: Progress<'_>) -> Result<Self, mindeg::MeshError> {
        Self::with_effort(domain, 1.0, progress)
    }

    /// [`of`](Self::of) with `effort` times the default steps of searches.
    ///
    /// # Errors
    ///
    /// The errors of [`degree_with`].
    pub fn with_effort(
        domain: &Domain,
        effort: f64,
        progress: Progress<'_>,
    ) -> Result<Self, mindeg::MeshError> {
        if let Some(form) = domain.convex().filter(|_| !domain.is_constrained()) {
            let mut report = Self::of_counts(form.boundary());
            if form.first() > 0 || report.intervals.len() != domain.rings().side_count() {
                report.words.push_str(&format!(
                    "Sides on one line count as one here, and each edge of a curve as a side; side 1 \
                     begins at vertex {}.\n",
                    form.first()
                ));
            }
            return Ok(report);
        }
        let answer = degree_with(domain, effort, progress)?;
        let is_checked = matches!(answer.bounded_by, LowerBound::Refuted(_))
            && checked_proof(&answer, domain, progress)?.is_some();
        let rings = domain.rings();
        let triangles = triangle_count(rings);
        Ok(Self {
            intervals: rings.sides().map(u64::from).collect(),
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
                Reached::Strip => "strip",
                Reached::Search => "search",
                Reached::Windows => "windows",
                Reached::ClosedForm => "formula",
                _ => "exhaustive",
            },
            words: in_words(domain, &answer, is_checked),
            proof: match &answer.bounded_by {
                LowerBound::Refuted(refutation) => {
                    Some(ProofFile::new(answer.at_least.saturating_sub(1), refutation))
                }
                _ => None,
            },
            certificate: match answer.bounded_by {
                LowerBound::BlockedZigZags(chords) => DegreeProof::BlockedZigZags { chords },
                LowerBound::Apexes(bound) => {
                    DegreeProof::Apexes { edges: bound.edges, apexes: bound.apexes }
                }
                LowerBound::Counting => DegreeProof::Counting,
                LowerBound::NoStrip => DegreeProof::NoStrip,
                LowerBound::Refuted(refutation) => {
                    let clauses = refutation.clauses.len();
                    DegreeProof::Refuted { clauses, checked: is_checked }
                }
                _ => DegreeProof::Exhaustive,
            },
            limit: None,
        })
    }

    /// The degree of a convex boundary, by the formula.
    #[must_use]
    pub fn of_counts(boundary: &Boundary) -> Self {
        let certificate = mindeg_core::certificate(boundary);
        let bound = certificate.max_degree();
        Self {
            intervals: boundary.sides().map(u64::from).collect(),
            holes: 0,
            vertices: boundary.vertex_count(),
            triangles: mindeg_core::bound::triangle_count(boundary),
            interior_edges: mindeg_core::bound::interior_edge_count(boundary),
            least_max_degree: Some(bound),
            at_least: bound,
            reached: bound,
            reached_by: "formula",
            words: certificate_in_words(boundary, &certificate),
            proof: None,
            certificate: match certificate {
                Certificate::BalancedCut { cut, .. } => DegreeProof::BalancedCut {
                    first_side: cut.first_side + 1,
                    side_count: cut.side_count,
                    larger: cut.larger,
                    smaller: cut.smaller,
                    bound,
                },
                Certificate::MedialTriangle => DegreeProof::MedialTriangle { bound },
                Certificate::LongSide { side, .. } => {
                    DegreeProof::LongSide { side: side + 1, bound }
                }
                Certificate::NoBalancedCut { least_imbalance } => {
                    DegreeProof::NoBalancedCut { least_imbalance, bound }
                }
            },
            limit: None,
        }
    }

    /// The counts, the degree and the reasons, in lines.
    #[must_use]
    pub fn text(&self) -> String {
        let degree = match self.least_max_degree {
            Some(least) => least.to_string(),
            None => format!("{} to {}", self.at_least, self.reached),
        };
        let rows = [
            ("sides", self.intervals.len().to_string()),
            ("holes", self.holes.to_string()),
            ("vertices", self.vertices.to_string()),
            ("triangles", self.triangles.to_string()),
            ("interior edges", self.interior_edges.to_string()),
            ("least maximum degree", degree),
        ];
        let rows = rows.into_iter().filter(|(name, _)| *name != "holes" || self.holes > 0);
        let rows: String = rows.map(|(name, value)| format!("{name:<21} {value}\n")).collect();
        format!("{rows}\n{}", self.words)
    }
}

/// Why the least maximum degree of a convex domain cannot be less and how it is reached, in sentences
/// that end in a new line.
fn certificate_in_words(boundary: &Boundary, certificate: &Certificate) -> String {
    let vertices = boundary.vertex_count();
    let sides = boundary.side_count();
    match *certificate {
        Certificate::BalancedCut { .. } if vertices == 3 => {
            "There is only one triangle.\n".to_owned()
        }
        Certificate::BalancedCut { cut, max_degree } => {
            let run = |first: usize, count: usize| match count {
                1 => format!("side {}", first % sides + 1),
                _ => format!("sides {} to {}", first % sides + 1, (first + count - 1) % sides + 1),
            };
            let larger = run(cut.first_side, cut.side_count);
            let smaller = run(cut.first_side + cut.side_count, sides - cut.side_count);
            format!(
                "It cannot be less: any triangulation of {vertices} boundary points has a vertex \
                 of degree {max_degree} or more\n(counting edges: theorem 3 of docs/theory.md).\n\
                 It is reached by a zig-zag between {larger} ({} intervals) and {smaller} ({}).\n",
                cut.larger, cut.smaller
            )
        }
        Certificate::MedialTriangle => "\
It cannot be less: any triangulation of 6 boundary points has a vertex of degree 4 or more
(counting edges: theorem 3 of docs/theory.md).
It is reached by the triangle through the three midpoints.\n"
            .to_owned(),
        Certificate::LongSide { side, max_degree } => {
            let intervals = boundary.intervals(side);
            let off_side = vertices - intervals - 1;
            let edges = mindeg_core::bound::interior_edge_count(boundary);
            format!(
                "It cannot be less: each of the {edges} interior edges ends at one of the \
                 {off_side} vertices off side {}\n({intervals} intervals), so one of these has \
                 {} of them besides two boundary edges\n(theorem 4 of docs/theory.md).\n\
                 It is reached by sharing that side out evenly among them.\n",
                side + 1,
                max_degree - 2,
            )
        }
        Certificate::NoBalancedCut { least_imbalance } => format!(
            "It cannot be less: degree 4 needs two runs of consecutive sides whose intervals \
             differ by at most 1,\nand here every two differ by {least_imbalance} or more \
             (theorem 5 of docs/theory.md).\n\
             It is reached by a corner strip and a zig-zag across the rest.\n"
        ),
    }
}

/// Why the least maximum degree of any domain cannot be less and how it is reached, or what is not known, in
/// sentences that end in a new line.
fn in_words(domain: &Domain, answer: &DegreeAnswer, is_checked: bool) -> String {
    let mut text = why_not_less(domain, answer, is_checked);
    text.push_str(&how_reached(answer));
    if answer.least_max_degree().is_none() {
        let open = match (answer.at_least, answer.reached - 1) {
            (least, most) if least == most => format!("degree {least}"),
            (least, most) => format!("a degree from {least} to {most}"),
        };
        text.push_str(&format!(
            "Whether {open} is possible is not known: {}.\n",
            if domain.rings().ring_count() > 1 {
                "the search of all meshes with holes took too many steps"
            } else {
                "too many of its vertices see each other for a search of all meshes"
            }
        ));
    }
    text
}

/// The number of triangles of every mesh of some rings without further points.
#[must_use]
pub fn triangle_count(rings: &Rings) -> u32 {
    rings.vertex_count() + 2 * (rings.ring_count() as u32 - 1) - 2
}

/// Why the degree cannot be less, in sentences.
fn why_not_less(domain: &Domain, answer: &DegreeAnswer, is_checked: bool) -> String {
    /// The tolerance of docs/theory.md, section 8.
    const STRAIGHT: &str = "A chord passes a vertex if it turns there by less than 1e-9 radians.\n";
    let vertices = domain.rings().vertex_count();
    let bound = answer.at_least;
    match &answer.bounded_by {
        LowerBound::BlockedZigZags(chords) => {
            let [from, to] = chords.first().copied().unwrap_or_default();
            format!(
                "No mesh has less than {bound}: from 7 vertices on, a mesh of degree 4 is one of {} zig-zags across \
                 the whole polygon,\nand each of these has a chord that does not lie inside or passes a vertex, such \
                 as the one from vertex {from} to vertex {to}.\n{STRAIGHT}",
                count(vertices)
            )
        }
        LowerBound::Apexes(apexes) => format!(
            "No mesh has less than {bound}: {} boundary edges, the first from vertex {} on, are the side of no ear, \
             and only {} vertices\nsee both ends of one of them. A vertex of degree {} is the apex of \
             at most {} of these edges.\n{STRAIGHT}",
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
        LowerBound::NoStrip => format!(
            "No mesh has less than {bound}: with a hole, a mesh of degree 4 is a strip between two rings of as many \
             vertices,\nand no strip here lies inside (theorem 21 of docs/theory.md).\n"
        ),
        LowerBound::Refuted(refutation) => format!(
            "No mesh has less than {bound}: degree {}{} is refuted by {}, {}\n(theorem 23 of docs/theory.md).\n{STRAIGHT}",
            bound.saturating_sub(1),
            if domain.is_constrained() { " with the limits" } else { "" },
            match refutation.clauses.len() {
                1 => "one clause".to_owned(),
                clauses => format!("{} clauses", count(clauses as u32)),
            },
            if is_checked {
                "checked"
            } else {
                "which the checker does not confirm; please report it"
            }
        ),
        LowerBound::ClosedForm => {
            "It cannot be less, by the formula for convex domains.\n".to_owned()
        }
        _ => format!(
            "No mesh has less than {bound}: of all triangulations, none {}has a maximum degree of {}.\n{STRAIGHT}",
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
        Reached::Strip => {
            format!("Degree {degree} is reached by the strip between the two rings.\n")
        }
        _ => format!("Degree {degree} is reached by a search over all triangulations.\n"),
    }
}
