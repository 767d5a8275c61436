//! `mindeg view`.

use super::domain::DomainOptions;
use super::goal::GoalArguments;
use super::values::mesh_help;
use super::with_exit_codes;
use clap::Args;
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  mindeg view part.obj -o part.html
  mindeg view assets/domains/wing-panel.json --keep-angle 95% -o wing-panel.html
  mindeg view --rectangle 4x3 --size 0.5 -o plate.html";

/// Show a mesh of any program, or the mesh of a domain, as an HTML page with its figures
///
/// The page is one file that opens without a network. In it the mesh can be moved, zoomed and
/// pointed at, and colored by degree and by any measure of its triangles. A mesh in space is turned. A domain is
/// meshed as by mindeg mesh.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES, after_long_help = with_exit_codes(EXAMPLES))]
pub(crate) struct ViewArguments {
    /// The mesh, or a domain.
    #[arg(
        id = "domain",
        value_name = "MESH|DOMAIN",
        help = mesh_help("; or a domain: JSON, or an outline in any format that mindeg reads; - is standard input")
    )]
    pub(crate) file: Option<PathBuf>,

    #[command(flatten)]
    pub(crate) options: DomainOptions,

    #[command(flatten)]
    pub(crate) goal: GoalArguments,

    /// Put points inside, as mindeg mesh --interior does
    #[arg(long, help_heading = "Goals")]
    pub(crate) interior: bool,

    /// Where to write the page, which ends in .html; - is standard output
    #[arg(short, long, value_name = "FILE", help_heading = "Output")]
    pub(crate) output: PathBuf,

    /// Print JSON: file, vertices, triangles, max_degree, min_angle, max_angle, dropped, least_max_degree, at_least,
    /// angle_limit and share_of_limit, null for a mesh from a file; files
    #[arg(long, help_heading = "Messages")]
    pub(crate) json: bool,

    /// Print no summary and show no progress on standard error
    #[arg(short, long, help_heading = "Messages")]
    pub(crate) quiet: bool,
}
