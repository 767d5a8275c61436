//! The least maximum degree of a boundary, why it cannot be less, and how it is reached.

mod beside;
mod words;

pub use beside::DegreeBeside;

use self::words::{certificate_in_words, in_words, map_in_words, region_of};
use crate::condition::points_of;
use crate::limit::LimitAnswer;
use crate::proof::ProofFile;
use mindeg::exact::{DegreeAnswer, DegreeBound, LowerBound, Reached, degree_with};
use mindeg::model::JointBound;
use mindeg::verify::checked_proof;
use mindeg::{Domain, Progress};
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
    /// The number of regions of a map.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub regions: Option<usize>,
    /// The number of vertices.
    pub vertices: u32,
    /// The number of vertices in the mesh joined at periodic sides, which degrees are of.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub joined_vertices: Option<u32>,
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
    /// `formula`, `zig_zag`, `strip`, `windows`, `descent` or `search` (with holes), `exhaustive`, or `joint` (of maps).
    pub reached_by: &'static str,
    /// Why no mesh has less than `at_least`.
    pub certificate: DegreeProof,
    /// The clauses of a refutation, for a file of their own.
    #[serde(skip)]
    pub proof: Option<ProofFile>,
    /// The limit of the minimum angle with interior points, if it was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub limit: Option<LimitAnswer>,
    /// Such as that sides count from the other end than those of the file; they are in the words, too.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub notes: Vec<String>,
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
    /// The sides and lines at one vertex of a map.
    Edges {
        /// The vertex.
        vertex: u32,
        /// Its edges of sides and lines, and those outside.
        edges: u32,
    },
    /// A straight side of a region of a map takes more apexes than the rest of the region has.
    Side {
        /// The name of the region.
        region: String,
        /// The intervals of the side.
        intervals: u32,
    },
    /// The degrees of a map, weighted, are least over all triangulations of each region.
    Weights,
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
        let mut report = Self::without_notes(domain, effort, progress)?;
        report.notes = domain.notes();
        report.words.extend(report.notes.iter().map(|note| format!("{note}\n")));
        Ok(report)
    }

    fn without_notes(
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
        let bounded_by = match &answer.bounded_by {
            DegreeBound::Polygon(bounded_by) => bounded_by,
            DegreeBound::Map { bound, triangles, .. } => {
                return Ok(Self::of_map(domain, &answer, bound, *triangles));
            }
        };
        let is_checked = matches!(bounded_by, LowerBound::Refuted(_))
            && checked_proof(&answer, domain, progress)?.is_some();
        let rings = domain.rings();
        let triangles = rings.triangle_count();
        Ok(Self {
            intervals: rings.sides().map(u64::from).collect(),
            holes: rings.ring_count() - 1,
            regions: None,
            joined_vertices: None,
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
                Reached::Descent => "descent",
                Reached::Windows => "windows",
                Reached::ClosedForm => "formula",
                _ => "exhaustive",
            },
            words: in_words(domain, &answer, bounded_by, is_checked),
            proof: match bounded_by {
                LowerBound::Refuted(refutation) => {
                    Some(ProofFile::new(answer.at_least.saturating_sub(1), refutation))
                }
                _ => None,
            },
            certificate: match bounded_by {
                LowerBound::BlockedZigZags(chords) => {
                    DegreeProof::BlockedZigZags { chords: chords.clone() }
                }
                LowerBound::Apexes(bound) => {
                    DegreeProof::Apexes { edges: bound.edges.clone(), apexes: bound.apexes.clone() }
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
            notes: Vec::new(),
        })
    }

    /// The joint degree of a map.
    fn of_map(domain: &Domain, answer: &DegreeAnswer, bound: &JointBound, triangles: u32) -> Self {
        let (rings, faces) = (domain.rings(), domain.faces());
        let beside = faces.iter().flat_map(|faces| faces.beside.iter().flatten());
        let at_holes = beside.flatten().filter(|face| domain.is_hole(**face)).count() as u32;
        let vertices = points_of(domain);
        let interior_edges = (3 * triangles - rings.vertex_count() - at_holes) / 2;
        // Edges on the boundary have one triangle.
        let edges = interior_edges + rings.vertex_count() + at_holes;
        let joined = domain.periodic().map(|periodic| {
            let lists = periodic.joined();
            let less: usize = lists.iter().map(|list| list.len() - 1).sum();
            let doubled: u32 = lists.iter().map(|list| periodic.doubled(list[0])).sum();
            [vertices - less as u32, edges - doubled / 2]
        });
        Self {
            intervals: rings.sides().map(u64::from).collect(),
            holes: domain.hole_count(),
            regions: Some(domain.region_count()).filter(|_| faces.is_some() || joined.is_none()),
            vertices,
            joined_vertices: joined.map(|[vertices, _]| vertices),
            triangles,
            interior_edges,
            least_max_degree: answer.least_max_degree(),
            at_least: answer.at_least,
            reached: answer.reached,
            reached_by: "joint",
            words: map_in_words(domain, answer, bound, joined.unwrap_or([vertices, edges])),
            proof: None,
            certificate: match bound {
                JointBound::Sum { .. } => DegreeProof::Counting,
                JointBound::Edges { vertex, edges } => {
                    DegreeProof::Edges { vertex: *vertex, edges: *edges }
                }
                JointBound::Side { face, intervals, .. } => {
                    DegreeProof::Side { region: region_of(domain, *face), intervals: *intervals }
                }
                JointBound::Refuted { refutation, .. } => {
                    DegreeProof::Refuted { clauses: refutation.clauses.len(), checked: true }
                }
                _ => DegreeProof::Weights,
            },
            limit: None,
            notes: Vec::new(),
        }
    }

    /// The degree of a convex boundary, by the formula.
    #[must_use]
    pub fn of_counts(boundary: &Boundary) -> Self {
        let certificate = mindeg_core::certificate(boundary);
        let bound = certificate.max_degree();
        Self {
            intervals: boundary.sides().map(u64::from).collect(),
            holes: 0,
            regions: None,
            vertices: boundary.vertex_count(),
            joined_vertices: None,
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
            notes: Vec::new(),
        }
    }

    /// The counts, the degree and the reasons, in lines.
    #[must_use]
    pub fn text(&self) -> String {
        let degree = degree_or_range(self.least_max_degree, [self.at_least, self.reached]);
        let rows = [
            ("sides", self.intervals.len().to_string()),
            ("holes", self.holes.to_string()),
            ("regions", self.regions.unwrap_or_default().to_string()),
            ("vertices", self.vertices.to_string()),
            ("joined vertices", self.joined_vertices.unwrap_or_default().to_string()),
            ("triangles", self.triangles.to_string()),
            ("interior edges", self.interior_edges.to_string()),
            ("least maximum degree", degree),
        ];
        let is_shown = |name: &str| match name {
            "holes" => self.holes > 0,
            "regions" => self.regions.is_some(),
            "joined vertices" => self.joined_vertices.is_some(),
            _ => true,
        };
        let rows = rows.into_iter().filter(|(name, _)| is_shown(name));
        let rows: String = rows.map(|(name, value)| format!("{name:<21} {value}\n")).collect();
        format!("{rows}\n{}", self.words)
    }
}

/// A degree, or what it is between.
pub(crate) fn degree_or_range(least: Option<u32>, [at_least, reached]: [u32; 2]) -> String {
    least.map_or_else(|| format!("{at_least} to {reached}"), |least| least.to_string())
}
