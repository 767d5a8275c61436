//! `mindeg inspect`.

use super::values::whole_number;
use super::with_exit_codes;
use crate::gates::Gates;
use clap::Args;
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  mindeg inspect part.obj
  mindeg inspect part.glb --fail-above-degree 8 --fail-below-angle 5
  mindeg inspect part.gltf --json";

/// Tell what is wrong with any triangle mesh, how many edges meet where, and how well its
/// triangles are shaped
///
/// Takes meshes of any program: with interior vertices, in several parts, closed or broken.
/// Quads and larger polygons of an OBJ are measured as the triangles of a fan from their first
/// corner. Vertices and triangles are numbered from 0, in the order of the file.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES, after_long_help = with_exit_codes(EXAMPLES))]
pub(crate) struct InspectArguments {
    /// The mesh, by extension .obj, .glb or .gltf (with the files it names in its folder)
    #[arg(value_name = "MESH")]
    pub(crate) file: PathBuf,

    /// Name the vertices with more edges than this, poles
    #[arg(long, value_name = "N", default_value = "8", value_parser = whole_number, allow_hyphen_values = true)]
    pub(crate) poles_above: u32,

    /// By how many degrees a convex outline must turn at its corners, 0 to 90
    #[arg(long, value_name = "A", default_value_t = 1.0, value_parser = parse_corner_angle, allow_hyphen_values = true)]
    pub(crate) corner_angle: f64,

    /// Do not merge vertices with identical coordinates
    #[arg(long)]
    pub(crate) no_weld: bool,

    /// Print JSON: file, vertices, welded_vertices, triangles, quads, polygons, line_segments,
    /// points, faces, edges, boundary_edges, boundary_loops, open_boundaries, components,
    /// euler_characteristic, non_manifold_edges, non_manifold_vertices, inconsistent_edges,
    /// duplicate_triangles, zero_area_triangles, unreferenced_vertices, max_degree,
    /// degree_histogram, poles, area, min_angle, max_angle, metrics, share_below_degrees,
    /// worst_triangles, outline, no_outline
    #[arg(long)]
    pub(crate) json: bool,

    /// Show no progress on standard error
    #[arg(short, long)]
    pub(crate) quiet: bool,

    #[command(flatten)]
    pub(crate) gates: Gates,
}

fn parse_corner_angle(text: &str) -> Result<f64, String> {
    let angle = text.parse().ok().filter(|angle| (0.0..=90.0).contains(angle));
    angle.ok_or_else(|| "give degrees from 0 to 90".to_owned())
}
