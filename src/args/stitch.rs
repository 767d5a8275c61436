//! `mindeg stitch`.

use super::domain::OutlineOptions;
use super::interior::Wanted;
use super::surface::SurfaceArguments;
use super::with_exit_codes;
use clap::Args;
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  mindeg stitch sea.14 river.14 --within delta.json -o both.14
  mindeg stitch bay.14 sea.14 --project auto -o both.14";

/// Join meshes of the plane by a mesh of the gap between them
///
/// The gap is what an area has outside the meshes. The meshes stay bit for bit: vertices, triangles, names and depths. The new mesh
/// takes their boundary vertices within the area, and points inside; degrees count the triangles of both. Sides of the area give
/// the new boundary names and kinds, land without; depths are between those of the meshes.
///
/// Two meshes that overlap need no area: the first one stays, the second one loses the triangles that overlap it or
/// are too near, and the gap between is filled. The order tells which boundary stays: what they cover may differ by parts of an edge.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES, after_long_help = with_exit_codes(EXAMPLES))]
pub(crate) struct StitchArguments {
    /// The meshes, in any format that mindeg reads, told by its extension
    #[arg(id = "domain", value_name = "MESH", num_args = 2.., required = true)]
    pub(crate) files: Vec<PathBuf>,

    /// The area that holds the gap: a polygon, as mindeg mesh takes it. Its border ends in the meshes. Not for meshes that overlap
    #[arg(long = "within", value_name = "AREA")]
    pub(crate) area: Option<PathBuf>,

    #[command(flatten)]
    pub(crate) surface: SurfaceArguments,

    #[command(flatten)]
    pub(crate) wanted: Wanted<true>,

    #[command(flatten)]
    pub(crate) outline: OutlineOptions,

    /// Print JSON: vertices, triangles, overlapping and near (triangles of the second mesh that went), new_vertices, new_triangles, min_angle of the new triangles, joined (how many vertices of the
    /// meshes lie inside now), violations (those of them with fewer or more edges: vertex, position, degree), files
    #[arg(long, help_heading = "Messages")]
    pub(crate) json: bool,

    /// Print no summary and show no progress on standard error
    #[arg(short, long, help_heading = "Messages")]
    pub(crate) quiet: bool,
}
