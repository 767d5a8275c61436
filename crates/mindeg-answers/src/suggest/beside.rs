//! Changes of counts of domains beside each other.

use super::SuggestAnswer;
use crate::degree::degree_or_range;
use crate::names::part_name;
use mindeg::Domain;
use serde::Serialize;

/// The suggestions for domains beside each other, each of which changes on its own.
#[derive(Clone, Debug, Serialize)]
pub struct SuggestBeside {
    /// The greatest of theirs; null where it is not known.
    pub least_max_degree: Option<u32>,
    /// No mesh of all has a smaller maximum degree.
    pub at_least: u32,
    /// Some mesh of all has this one.
    pub reached: u32,
    /// The suggestions for each domain.
    pub parts: Vec<SuggestPart>,
}

/// The suggestions for one of several domains.
#[derive(Clone, Debug, Serialize)]
pub struct SuggestPart {
    /// Its index, from 1, and its first region.
    pub part: String,
    /// Its suggestions.
    #[serde(flatten)]
    pub answer: SuggestAnswer,
}

impl SuggestBeside {
    /// The suggestions for domains with these answers, which are in their order.
    #[must_use]
    pub fn of(domains: &[Domain], answers: Vec<SuggestAnswer>) -> Self {
        let at_least = answers.iter().map(|answer| answer.at_least).fold(0, u32::max);
        let reached = answers.iter().map(|answer| answer.reached).fold(0, u32::max);
        let part =
            |(index, answer)| SuggestPart { part: part_name(index, &domains[index]), answer };
        Self {
            least_max_degree: (at_least == reached).then_some(reached),
            at_least,
            reached,
            parts: answers.into_iter().enumerate().map(part).collect(),
        }
    }

    /// The degree of all, in a line.
    #[must_use]
    pub fn text(&self) -> String {
        let degree = degree_or_range(self.least_max_degree, [self.at_least, self.reached]);
        let count = self.parts.len();
        format!(
            "The least maximum degree of all {count} parts is {degree}, the greatest of theirs.\n"
        )
    }
}
