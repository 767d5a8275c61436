//! `mindeg tradeoff`.

use super::domain::DomainArguments;
use super::purpose::PurposeArgument;
use super::values::whole_number;
use super::with_exit_codes;
use clap::Args;
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  mindeg tradeoff assets/domains/wing-panel.json
  mindeg tradeoff --rectangle 4x3 --intervals 12,9,4,4 -o curve.html
  mindeg tradeoff assets/domains/plate-with-holes.json --limit 6";

/// Tell how large the minimum angle can be for each maximum degree
///
/// From the least possible degree up to the first one with the largest minimum angle of all,
/// which is that of a Delaunay triangulation. The advised degree is the smallest
/// that keeps 95% of that angle, as with mindeg mesh --keep-angle 95%. Degrees and
/// degree limits are total: edges outside count. Rows are exact where no hole is too much for that; the others say so. Up to 4096 boundary vertices.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES, after_long_help = with_exit_codes(EXAMPLES))]
pub(crate) struct TradeoffArguments {
    #[command(flatten)]
    pub(crate) domain: DomainArguments,

    #[command(flatten)]
    pub(crate) purpose: PurposeArgument,

    /// Where to write a report with the curve and the meshes, by extension .html or .svg, or the
    /// figures, .json; may be repeated
    #[arg(short, long, value_name = "FILE", help_heading = "Report")]
    pub(crate) output: Vec<PathBuf>,

    /// Print at most this many rows: the first, the advised, the last, and others spread evenly
    /// between; 0 prints all
    #[arg(long, value_name = "N", value_parser = whole_number, default_value = "20", allow_hyphen_values = true, help_heading = "Report")]
    pub(crate) limit: u32,

    /// Print JSON instead of a table: points, a list of max_degree, min_angle,
    /// share_of_limit and exact, all of them; angle_limit; advised, the degree for a patch; and advice
    #[arg(long, help_heading = "Messages")]
    pub(crate) json: bool,

    /// Show no progress on standard error
    #[arg(short, long, help_heading = "Messages")]
    pub(crate) quiet: bool,
}
