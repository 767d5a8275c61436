//! Commands that interval counts alone can answer.

use super::domain::DomainOptions;
use super::mesh::ModelArguments;
use super::values::{IntervalCounts, whole_number};
use super::with_exit_codes;
use clap::Args;
use std::path::{Path, PathBuf};
use std::str::FromStr;

const DEGREE: &str = "\
Examples:
  mindeg degree 12,9,4,4
  mindeg degree assets/domains/wing-panel.json --json
  mindeg degree assets/models/bracket.obj --size 5";

/// Tell the least possible maximum degree, and why it cannot be less
///
/// The degree of a vertex is the number of edges at it, boundary edges included (its valence).
/// Interval counts alone are those of a convex outline; the faces of a model are meshed together. For a domain, also the minimum angle that no mesh with interior points can exceed, and what decides
/// it.
#[derive(Debug, Args)]
#[command(after_help = DEGREE, after_long_help = with_exit_codes(DEGREE))]
pub(crate) struct DegreeArguments {
    #[command(flatten)]
    pub(crate) counts: CountsArguments,

    /// The most edges of a boundary vertex, for the limit of the minimum angle with interior points
    /// [default: 5]
    #[arg(long, value_name = "D", value_parser = whole_number, allow_hyphen_values = true, help_heading = "Answer")]
    pub(crate) boundary_degree: Option<u32>,

    #[command(flatten)]
    pub(crate) model: ModelArguments,

    /// Write the clauses that refute a smaller degree to a JSON file, which mindeg verify --proof repeats
    #[arg(long, value_name = "FILE", help_heading = "Answer")]
    pub(crate) proof: Option<PathBuf>,

    /// Print JSON: intervals, holes, vertices, triangles, interior_edges, least_max_degree (null if
    /// not known), at_least, reached, reached_by, certificate (sides counted from 1); for a domain limit, with
    /// angle_limit, which interior points cannot exceed, and the change that lifts it, and notes, such as on reversed corners; of a
    /// model what mindeg mesh prints
    #[arg(long, help_heading = "Messages")]
    pub(crate) json: bool,
}

const SUGGEST: &str = "\
Examples:
  mindeg suggest 30,2,4,2
  mindeg suggest 30,2,4,2 --max-degree 5 --json
  mindeg suggest assets/domains/dominated-side.json --limit 5
  mindeg suggest assets/domains/gusset.json
  mindeg suggest assets/models/bracket.obj --size 5";

/// Suggest the least change of interval counts that brings the least maximum degree down
///
/// Least means the fewest intervals added or taken away in all. Of changes of the same size, one
/// that adds is preferred. A domain with holes, without a convex outline or with lines inside is searched: the answer
/// says what is proven; so are the edges of a model. A side with points of its own keeps them and gets more on its longest edges. For a domain, also changes that lift the limit of the minimum angle with interior points.
#[derive(Debug, Args)]
#[command(after_help = SUGGEST, after_long_help = with_exit_codes(SUGGEST))]
pub(crate) struct SuggestArguments {
    #[command(flatten)]
    pub(crate) counts: CountsArguments,

    /// The degree to come down to; without it, every lower degree that a least change leads to
    #[arg(long, value_name = "D", value_parser = whole_number, allow_hyphen_values = true, help_heading = "Answer")]
    pub(crate) max_degree: Option<u32>,

    #[command(flatten)]
    pub(crate) model: ModelArguments,

    /// Print at most this many suggestions: the first, the last, and others spread evenly between;
    /// 0 prints all
    #[arg(long, value_name = "N", value_parser = whole_number, default_value = "20", allow_hyphen_values = true, help_heading = "Answer")]
    pub(crate) limit: u32,

    /// Print JSON: intervals, least_max_degree (null if not known), at_least, reached, suggestion_count, and suggestions, a
    /// list of least_max_degree, reached, cost, cost_at_least (no change of less cost is enough), changes (side
    /// counted from 1 through all rings, corners of a model's edge, by, and the points that are added to points of its own) and intervals; open, a smaller degree that no change was found for, with
    /// cost_at_least; for a domain limit, angle_suggestions and notes; parts, where there are several
    #[arg(long, help_heading = "Messages")]
    pub(crate) json: bool,
}

/// Interval counts, or a domain as every command takes it.
#[derive(Debug, Args)]
pub(crate) struct CountsArguments {
    /// The intervals of each side, counter-clockwise, such as 3,3,2,2; or the file of a domain, as mindeg
    /// mesh takes it; - reads a domain from standard input
    #[arg(id = "domain", value_name = "INTERVALS|DOMAIN")]
    pub(crate) counts: Option<Counts>,

    #[command(flatten)]
    pub(crate) options: DomainOptions,
}

impl CountsArguments {
    /// The file of the domain.
    pub(crate) fn path(&self) -> Option<&Path> {
        match &self.counts {
            Some(Counts::Domain(path)) => Some(path),
            _ => None,
        }
    }
}

/// Interval counts, or the file that has them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Counts {
    /// As typed.
    Given(Vec<u64>),
    /// In a domain's file, or standard input for `-`.
    Domain(PathBuf),
}

impl FromStr for Counts {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let counts = text.parse::<IntervalCounts>();
        let path = Path::new(text);
        let is_file = || {
            // A missing file is told by the letters that its name ends in.
            let ending = path.extension().unwrap_or_default().to_string_lossy();
            let is_name = ending.starts_with(|c: char| c.is_ascii_alphabetic());
            is_name || text == "-" || text.contains(std::path::is_separator) || path.is_file()
        };
        match counts {
            Ok(counts) => Ok(Self::Given(counts.0)),
            Err(_) if is_file() => Ok(Self::Domain(path.to_path_buf())),
            Err(error) => Err(error),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_are_told_from_files() {
        assert_eq!("3,3,2".parse(), Ok(Counts::Given(vec![3, 3, 2])));
        for file in ["-", "no/such", "none.json", "none.JSON", "none.geojson"] {
            assert_eq!(file.parse(), Ok(Counts::Domain(file.into())));
        }
        for wrong in ["3,three,3", "", "none", "1,2,2.5"] {
            assert!(wrong.parse::<Counts>().unwrap_err().starts_with("side "), "{wrong}");
        }
    }
}
