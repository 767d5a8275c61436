//! `mindeg compare`.

use super::demands::DemandArguments;
use super::domain::DomainOptions;
use super::purpose::PurposeArgument;
use super::with_exit_codes;
use clap::{Args, ValueEnum};
use std::path::{Path, PathBuf};
use std::time::Duration;

const EXAMPLES: &str = "\
Examples:
  mindeg compare assets/domains/wing-panel.json -o wing-panel.html
  mindeg compare --rectangle 4x3 --size 0.5 --json
  mindeg compare assets/domains/wing-panel.json --interior -o wing-panel.md
  mindeg compare assets/domains/*.json -o reports/ --save-meshes meshes/";

/// Compare the least-degree mesh with a Delaunay triangulation, ear clipping and a fan
///
/// All methods get the same boundary points. Each result is checked before it is shown, and none
/// is repaired. The report begins with a verdict that is computed from the figures.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES, after_long_help = with_exit_codes(EXAMPLES))]
pub(crate) struct CompareArguments {
    /// Files of domains, as mindeg mesh takes them; - reads one from standard input
    #[arg(id = "domain", value_name = "DOMAIN")]
    pub(crate) files: Vec<PathBuf>,

    #[command(flatten)]
    pub(crate) options: DomainOptions,

    #[command(flatten)]
    pub(crate) purpose: PurposeArgument,

    /// Where to write the report, by extension .html, .json or .md; - is standard output. May be
    /// given several times. A folder takes an HTML report for each domain and an index page;
    /// several domains need one
    #[arg(
        short,
        long,
        value_name = "FILE",
        required_unless_present = "json",
        help_heading = "Report"
    )]
    pub(crate) output: Vec<PathBuf>,

    /// The format of the report on standard output
    #[arg(long, value_name = "FORMAT", help_heading = "Report")]
    pub(crate) format: Option<ReportFormat>,

    /// Write every method's mesh as an OBJ into this folder; with several domains, into a folder
    /// for each
    #[arg(long, value_name = "FOLDER", help_heading = "Report")]
    pub(crate) save_meshes: Option<PathBuf>,

    /// Also compare the mesh with points inside with a Delaunay refinement of the same boundary, also on domains of more
    /// than 1000 boundary points
    #[arg(long, help_heading = "Report")]
    pub(crate) interior: bool,

    /// How long each method may take, in seconds; the report lists one that takes longer as such
    #[arg(long, value_name = "SECONDS", default_value = "60", value_parser = seconds, allow_hyphen_values = true, help_heading = "Report")]
    pub(crate) time_limit: Duration,

    /// Print the report as JSON on standard output
    #[arg(long, help_heading = "Messages")]
    pub(crate) json: bool,

    /// Print no verdicts and show no progress on standard error
    #[arg(short, long, help_heading = "Messages")]
    pub(crate) quiet: bool,

    #[command(flatten)]
    pub(crate) demands: DemandArguments,
}

fn seconds(text: &str) -> Result<Duration, String> {
    let seconds = text.trim().parse().ok().and_then(|s| Duration::try_from_secs_f64(s).ok());
    seconds.ok_or_else(|| "give a number of seconds from 0 on, such as 60".to_owned())
}

/// The format of a report.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum ReportFormat {
    /// A page for a browser
    Html,
    /// The figures
    Json,
    /// Markdown
    Md,
}

impl ReportFormat {
    /// The format that the extension of a file name asks for, in upper or lower case.
    pub(crate) fn of_path(path: &Path) -> Option<Self> {
        match path.extension()?.to_str()?.to_ascii_lowercase().as_str() {
            "html" | "htm" => Some(Self::Html),
            "json" => Some(Self::Json),
            "md" => Some(Self::Md),
            _ => None,
        }
    }
}
