//! `mindeg improve`.

use super::demands::PresetArgument;
use super::interior::Wanted;
use super::surface::SurfaceArguments;
use super::values::whole_number;
use super::with_exit_codes;
use clap::Args;
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  mindeg improve part.obj -o better.obj
  mindeg improve sea.obj -o sea-better.obj --preset swan
  mindeg improve part.glb -o better.glb --target-angle 28 --json";

/// Improve a planar triangle mesh of any program: degrees and the minimum angle
///
/// The boundary stays bit for bit; so do edges between groups and along lines. Points inside move,
/// come and go: degrees get to 5 to 7 inside and at most 5 at the boundary, and the minimum angle near
/// its proven limit. Sizes stay about as they are. The mesh may lie in any plane of space. Vertices with
/// identical coordinates are merged. The result has no more violations than the input and, with equally
/// many, no smaller minimum angle up to the target. With `--prefer angle` it is the other way round: no
/// smaller minimum angle, and for a larger one more violations.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES, after_long_help = with_exit_codes(EXAMPLES))]
pub(crate) struct ImproveArguments {
    /// The mesh, in any format that mindeg reads, told by its extension
    #[arg(value_name = "MESH")]
    pub(crate) file: PathBuf,

    #[command(flatten)]
    pub(crate) surface: SurfaceArguments,

    /// Print a summary as JSON: file, vertices, triangles, welded_vertices, kept_edges, before, after,
    /// files
    #[arg(long, help_heading = "Messages")]
    pub(crate) json: bool,

    /// Print no summary and show no progress on standard error
    #[arg(short, long, help_heading = "Messages")]
    pub(crate) quiet: bool,

    #[command(flatten)]
    pub(crate) aims: Wanted<false>,

    /// The most edges at a vertex
    #[arg(long, value_name = "D", value_parser = whole_number, allow_hyphen_values = true, help_heading = "Demands")]
    pub(crate) max_degree: Option<u32>,

    #[command(flatten)]
    pub(crate) preset: PresetArgument,
}
