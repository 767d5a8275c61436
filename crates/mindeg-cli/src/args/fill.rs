//! `mindeg fill`.

use super::loop_choice::LoopChoice;
use super::surface::SurfaceArguments;
use super::values::whole_number;
use super::with_exit_codes;
use clap::Args;
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  mindeg fill part.obj -o closed.obj
  mindeg fill part.obj -o closed.glb --max-loop 100 --max-degree 8
  mindeg fill part.obj -o cup.obj --loop 0,0,0";

/// Close the holes of a mesh: each boundary loop by the triangulation of least area under a limit
/// on the total degree of its vertices
///
/// The edges that the mesh has at a vertex count. A vertex that has more than the limit already gets
/// no new edge. Edges that the mesh has are not made again. The mesh itself stays as it is; the new
/// triangles are the group "fill", after all others. Vertices at the same place count as one.
///
/// Loops that run into an edge with three faces or more, whose faces do not agree in orientation,
/// or that bound a single triangle stay open, and the summary says why. New triangles that cross
/// others are counted and named. The outer boundary of an open surface is a loop as well: keep it
/// open with --max-loop, or name the loops to fill with --loop.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES, after_long_help = with_exit_codes(EXAMPLES))]
pub(crate) struct FillArguments {
    /// The mesh, by extension .obj, .glb or .gltf (with the files it names in its folder)
    #[arg(value_name = "MESH")]
    pub(crate) file: PathBuf,

    #[command(flatten)]
    pub(crate) surface: SurfaceArguments,

    /// The largest total degree of a vertex on a loop; without it, for each loop the least that is
    /// possible from 6 up
    #[arg(long, value_name = "D", value_parser = whole_number, allow_hyphen_values = true)]
    pub(crate) max_degree: Option<u32>,

    /// Keep loops of this many vertices or more open; up to 2001
    #[arg(long, value_name = "N", value_parser = whole_number, default_value = "500", allow_hyphen_values = true)]
    pub(crate) max_loop: u32,

    /// Fill this loop alone: its number such as 2, a vertex on it such as v17, or a point near it
    /// such as 0,0,1.5. May be given several times
    #[arg(long = "loop", value_name = "LOOP", allow_hyphen_values = true)]
    pub(crate) loops: Vec<LoopChoice>,

    /// Print JSON: file, vertices, triangles, max_degree, filled (loop, vertices, first_vertex,
    /// limit, max_degree, area, area_without_limit, next_area, degree_without_limit, min_angle,
    /// triangles), left_open (loop, vertices, first_vertex, reason), crossings (pairs of triangles), files.
    /// Loops are counted from 1, vertices and triangles from 0
    #[arg(long)]
    pub(crate) json: bool,

    /// Print no summary and show no progress on standard error
    #[arg(short, long)]
    pub(crate) quiet: bool,
}
