//! The degrees of domains beside each other.

use super::{DegreeReport, degree_or_range};
use crate::names::part_name;
use mindeg::Domain;
use serde::Serialize;

/// The most parts that a text lists.
const LISTED: usize = 20;

/// The least maximum degree of domains beside each other: the greatest of theirs.
#[derive(Clone, Debug, Serialize)]
pub struct DegreeBeside {
    /// How many regions all parts have; several may share a name.
    pub regions: usize,
    /// The number of vertices.
    pub vertices: u64,
    /// The number of triangles of every mesh.
    pub triangles: u64,
    /// The number of interior edges of every mesh.
    pub interior_edges: u64,
    /// Null where it is not known: then it is between the next two.
    pub least_max_degree: Option<u32>,
    /// No mesh has a smaller maximum degree.
    pub at_least: u32,
    /// Some mesh has this one.
    pub reached: u32,
    /// The degree of each domain.
    pub parts: Vec<DegreePart>,
}

/// The degree of one of several domains.
#[derive(Clone, Debug, Serialize)]
pub struct DegreePart {
    /// Its index, from 1, and its first region.
    pub part: String,
    /// Its degree, and why it cannot be less. Vertices count from its first.
    #[serde(flatten)]
    pub report: DegreeReport,
}

impl DegreeBeside {
    /// The degree of domains with these reports, which are in their order.
    #[must_use]
    pub fn of(domains: &[Domain], reports: Vec<DegreeReport>) -> Self {
        let at_least = reports.iter().map(|report| report.at_least).fold(0, u32::max);
        let reached = reports.iter().map(|report| report.reached).fold(0, u32::max);
        let sum =
            |count: fn(&DegreeReport) -> u32| reports.iter().map(|it| u64::from(count(it))).sum();
        Self {
            regions: domains.iter().map(Domain::region_count).sum(),
            vertices: sum(|report| report.vertices),
            triangles: sum(|report| report.triangles),
            interior_edges: sum(|report| report.interior_edges),
            least_max_degree: (at_least == reached).then_some(reached),
            at_least,
            reached,
            parts: domains
                .iter()
                .zip(reports)
                .enumerate()
                .map(|(index, (domain, report))| DegreePart {
                    part: part_name(index, domain),
                    report,
                })
                .collect(),
        }
    }

    /// The counts, the degree of each part and the reasons of those that decide, in lines.
    #[must_use]
    pub fn text(&self) -> String {
        let rows = [
            ("parts", self.parts.len().to_string()),
            ("regions", self.regions.to_string()),
            ("vertices", self.vertices.to_string()),
            ("triangles", self.triangles.to_string()),
            ("interior edges", self.interior_edges.to_string()),
            (
                "least maximum degree",
                degree_or_range(self.least_max_degree, [self.at_least, self.reached]),
            ),
        ];
        let rows: String =
            rows.iter().map(|(name, value)| format!("{name:<21} {value}\n")).collect();
        let mut text = format!("{rows}\n");
        for DegreePart { part, report } in self.parts.iter().take(LISTED) {
            let degree =
                degree_or_range(report.least_max_degree, [report.at_least, report.reached]);
            text.push_str(&format!("{part}: {} vertices, degree {degree}\n", report.vertices));
        }
        if self.parts.len() > LISTED {
            text.push_str(&format!(
                "… {} more parts; --json lists all\n",
                self.parts.len() - LISTED
            ));
        }
        let bound = self.parts.iter().position(|part| part.report.at_least == self.at_least);
        let highest = self.parts.iter().position(|part| part.report.reached == self.reached);
        let mut deciding: Vec<usize> = bound.into_iter().chain(highest).collect();
        deciding.dedup();
        for index in deciding {
            let DegreePart { part, report } = &self.parts[index];
            text.push_str(&format!(
                "\nDecided by {part}, whose vertices count from 0:\n{}",
                report.words
            ));
        }
        text
    }
}
