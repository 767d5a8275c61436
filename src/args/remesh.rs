//! `mindeg remesh`.

use super::demands::PresetArgument;
use super::surface::SurfaceArguments;
use super::tolerance::Tolerance;
use super::values::{angle, length, target_angle, whole_number};
use super::with_exit_codes;
use clap::Args;
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  mindeg remesh part.stl -o part.glb
  mindeg remesh scan.ply -o even.ply --vertices 5000 --feature-angle 180
  mindeg remesh part.stl -o part.obj --size 2 --tolerance 0.3% --json
  mindeg remesh dirty.stl -o clean.ply --repair --curvature";

/// Mesh a surface in space anew: 5 to 7 edges at every vertex, features kept, the distance proven
///
/// The part is any manifold surface of triangles, closed or open. Its features, which are its boundary, borders between groups and
/// edges that turn by more than --feature-angle, become curves on which vertices lie; corners stay where they are.
/// Off the boundary degrees get to 5 to 7, at most 5 on it, and angles near 39 degrees or better. Groups, their materials,
/// lines along edges and named points stay. How far the surfaces are apart is bounded by code of its own, both ways, and stands in the summary.
///
/// With --tolerance, a mesh whose distance is not proven to be within it is not written, and the run ends with exit code
/// 3; so does one that crosses itself where the part does not, or has a triangle that is turned over.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES, after_long_help = with_exit_codes(EXAMPLES))]
pub(crate) struct RemeshArguments {
    /// The part, in any format that mindeg reads, told by its extension
    #[arg(value_name = "PART")]
    pub(crate) file: PathBuf,

    #[command(flatten)]
    pub(crate) surface: SurfaceArguments,

    /// The edge length where neither curvature nor near features ask for less; without it the lesser of the
    /// mean edge and a twentieth of the diagonal
    #[arg(long, value_name = "S", value_parser = length, allow_hyphen_values = true, help_heading = "Surface")]
    pub(crate) size: Option<f64>,

    /// About this many vertices, instead of a size
    #[arg(long, value_name = "N", value_parser = whole_number, conflicts_with = "size", allow_hyphen_values = true, help_heading = "Surface")]
    pub(crate) vertices: Option<u32>,

    /// How far the surfaces may be apart, both ways: a length, or a share of the part's diagonal such as 0.3%, which is
    /// tried, not demanded, without this, --size and --vertices
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true, help_heading = "Surface")]
    pub(crate) tolerance: Option<Tolerance>,

    /// Edges that turn by more than this many degrees are features; at 180 none is
    #[arg(long, value_name = "ANGLE", value_parser = angle, default_value = "40", allow_hyphen_values = true, help_heading = "Surface")]
    pub(crate) feature_angle: f64,

    /// Keep the edges of the boundary bit for bit
    #[arg(long, help_heading = "Surface")]
    pub(crate) keep_boundary: bool,

    /// Keep all other feature edges bit for bit
    #[arg(long, help_heading = "Surface")]
    pub(crate) keep_features: bool,

    /// Make edges up to three times as long where the surface is flat
    #[arg(long, help_heading = "Surface")]
    pub(crate) curvature: bool,

    /// Mend the part first: weld points, drop faces without area or twice and those too many at an edge, turn faces over, fill holes
    /// with a rim below five sizes. The distance is that from the part after it
    #[arg(long, help_heading = "Surface")]
    pub(crate) repair: bool,

    /// Aim at this minimum angle in degrees, up to 60, instead of 35, and end with exit code 3 if it is not reached
    #[arg(long, value_name = "A", value_parser = target_angle, allow_hyphen_values = true, help_heading = "Demands")]
    pub(crate) target_angle: Option<f64>,

    #[command(flatten)]
    pub(crate) preset: PresetArgument,

    /// Write the mesh even if it is not what was demanded; the exit code stays 3
    #[arg(long, help_heading = "Demands")]
    pub(crate) write_anyway: bool,

    /// Print JSON: file, vertices, triangles, size, tolerance, diagonal, max_degree, interior_degree, boundary_degree, violations
    /// (vertex, position, degree, on_boundary, curves), certified (vertex, degree, allowed, sectors), min_angle, min_angle_triangle, corner_limits (vertex, position, sectors, limit), curves, corners,
    /// patches, to_part, from_part, curves_to_part, curves_from_part (at_least, at_most, position), crossings, part_crossings,
    /// repairs (welded_points, flat_faces, doubled_faces, crowded_faces, turned_faces, split_points, filled_holes, fill_faces),
    /// dropped, defects (kind, message), files
    #[arg(long, help_heading = "Messages")]
    pub(crate) json: bool,

    /// Print no summary and show no progress on standard error
    #[arg(short, long, help_heading = "Messages")]
    pub(crate) quiet: bool,
}
