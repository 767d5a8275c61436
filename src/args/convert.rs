//! `mindeg convert`.

use super::surface::SurfaceArguments;
use super::values::mesh_help;
use super::with_exit_codes;
use clap::Args;
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  mindeg convert part.obj -o part.glb
  mindeg convert part.gltf -o - --format obj > part.obj";

/// Write a mesh of any program in other formats
///
/// Positions, triangles, names and groups stay; normals are made anew.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES, after_long_help = with_exit_codes(EXAMPLES))]
pub(crate) struct ConvertArguments {
    /// The mesh.
    #[arg(value_name = "MESH", help = mesh_help(""))]
    pub(crate) file: PathBuf,

    #[command(flatten)]
    pub(crate) surface: SurfaceArguments,

    /// Print JSON: file, vertices, triangles, max_degree, min_angle, max_angle, dropped, files
    #[arg(long, help_heading = "Messages")]
    pub(crate) json: bool,

    /// Print no summary and show no progress on standard error
    #[arg(short, long, help_heading = "Messages")]
    pub(crate) quiet: bool,
}
