//! `mindeg inspect`.

use super::demands::DemandArguments;
use super::values::{format_parser, mesh_help, whole_number};
use super::with_exit_codes;
use clap::Args;
use mindeg_files::Format;
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  mindeg inspect part.obj
  mindeg inspect part.glb --max-degree 8 --target-angle 5
  mindeg inspect part.obj --weld 1e-6
  mindeg inspect - < part.glb --json";

/// Tell what is wrong with any triangle mesh, how many edges meet where, and how well its
/// triangles are shaped
///
/// Takes meshes of any program: with interior vertices, in several parts, closed or broken.
/// Edges and degrees are those of the faces in the file, quads and larger polygons among them; areas
/// and angles are those of the triangles they are cut into. Vertices, faces and triangles are
/// numbered from 0, in the order of the file.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES, after_long_help = with_exit_codes(EXAMPLES))]
pub(crate) struct InspectArguments {
    /// The mesh.
    #[arg(value_name = "MESH", help = mesh_help("; - is standard input"))]
    pub(crate) file: PathBuf,

    /// The format of standard input, where its content does not tell it; mindeg formats lists the names
    #[arg(long, value_name = "FORMAT", value_parser = format_parser(Format::READ), hide_possible_values = true)]
    pub(crate) format: Option<Format>,

    /// Name the vertices with more edges than this, poles
    #[arg(long, value_name = "N", default_value = "8", value_parser = whole_number, allow_hyphen_values = true)]
    pub(crate) poles_above: u32,

    /// By how many degrees a convex outline must turn at its corners, 0 to 90
    #[arg(long, value_name = "A", default_value_t = 1.0, value_parser = parse_corner_angle, allow_hyphen_values = true)]
    pub(crate) corner_angle: f64,

    /// Merge vertices no farther apart than this, in the file's unit of length, and all of a chain
    /// of such vertices; 0 merges vertices with identical coordinates, as without the option
    #[arg(long, value_name = "TOLERANCE", default_value_t = 0.0, value_parser = parse_tolerance, allow_hyphen_values = true, hide_default_value = true)]
    pub(crate) weld: f64,

    /// Do not merge vertices with identical coordinates
    #[arg(long, conflicts_with = "weld")]
    pub(crate) no_weld: bool,

    /// Print JSON: file, vertices, welded_vertices, triangles, quads, polygons, line_segments,
    /// points, not_read, faces, edges, boundary_edges, boundary_loops, open_boundaries, components,
    /// euler_characteristic, closed, manifold, genus, volume, non_manifold_edges, non_manifold_vertices, inconsistent_edges,
    /// duplicate_faces, duplicate_triangles, zero_area_triangles, unreferenced_vertices,
    /// max_degree, degree_histogram, poles, area, min_angle, max_angle, metrics,
    /// share_below_degrees, worst_triangles, outline, no_outline, polygon
    #[arg(long, help_heading = "Messages")]
    pub(crate) json: bool,

    /// Show no progress on standard error
    #[arg(short, long, help_heading = "Messages")]
    pub(crate) quiet: bool,

    #[command(flatten)]
    pub(crate) demands: DemandArguments,
}

fn parse_tolerance(text: &str) -> Result<f64, String> {
    let tolerance =
        text.parse().ok().filter(|tolerance: &f64| *tolerance >= 0.0 && tolerance.is_finite());
    tolerance.ok_or_else(|| "give a length, 0 or more".to_owned())
}

fn parse_corner_angle(text: &str) -> Result<f64, String> {
    let angle = text.parse().ok().filter(|angle| (0.0..=90.0).contains(angle));
    angle.ok_or_else(|| "give degrees from 0 to 90".to_owned())
}
