//! `mindeg domain`.

use super::domain::DomainArguments;
use super::with_exit_codes;
use clap::Args;
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  mindeg domain icon.svg
  mindeg domain coast.geojson --repair --feature Chile -o chile.json
  mindeg domain countries.geojson -o 'countries/{name}.json'
  mindeg domain --rectangle 4x3 --size 0.5 -o plate.json";

/// Show what was understood of an outline, and write it as a domain in JSON
///
/// Files are told by their extension, else by their content. The points that a file gives stay as
/// they are; --size divides each side between corners anew, by its length. Curves without --size
/// get a point for every 15 degrees that they turn. Coordinates are taken as they are: longitude
/// and latitude as planar, and y of SVG turned up.
#[derive(Debug, Args)]
#[command(name = "domain", after_help = EXAMPLES, after_long_help = with_exit_codes(EXAMPLES))]
pub(crate) struct DescribeArguments {
    #[command(flatten)]
    pub(crate) domain: DomainArguments,

    /// Where to write the domain in JSON; - is standard output. Several polygons go into a folder,
    /// which ends in /, or to names with {name} or {index}
    #[arg(short, long, value_name = "FILE", help_heading = "Output")]
    pub(crate) output: Option<PathBuf>,

    /// Print what was understood as JSON: a list of index, name, error, rings, sides, vertices,
    /// area, min, max
    #[arg(long, conflicts_with = "output", help_heading = "Messages")]
    pub(crate) json: bool,
}
