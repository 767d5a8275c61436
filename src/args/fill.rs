//! `mindeg fill`.

use super::loop_choice::LoopChoice;
use super::surface::SurfaceArguments;
use super::values::{target_angle, whole_number};
use super::with_exit_codes;
use clap::Args;
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  mindeg fill part.obj -o closed.obj
  mindeg fill part.obj -o closed.glb --max-loop 100 --max-degree 8
  mindeg fill part.obj -o closed.obj --interior
  mindeg fill part.obj -o cup.obj --loop 0,0,0";

/// Close the holes of a mesh: each boundary loop by the triangulation of least area under a limit
/// on the total degree of its vertices
///
/// The edges that the mesh has at a vertex count. A vertex that has more than the limit already gets
/// no new edge. Edges that the mesh has are not made again. The mesh itself stays as it is; the new
/// triangles are the group "fill", after all others. Vertices at the same place count as one.
///
/// Loops that run into an edge with three faces or more, whose faces do not agree in orientation,
/// or that bound a single triangle stay open, and the summary says why. --interior adds points inside. New triangles that cross
/// others are counted and named. The rim of a flat sheet stays open unless --loop names it. The outer
/// boundary of a bent open surface is a loop as well: keep it open with --max-loop, or name the loops to
/// fill with --loop.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES, after_long_help = with_exit_codes(EXAMPLES))]
pub(crate) struct FillArguments {
    /// The mesh, in any format that mindeg reads, told by its extension
    #[arg(value_name = "MESH")]
    pub(crate) file: PathBuf,

    #[command(flatten)]
    pub(crate) surface: SurfaceArguments,

    /// Add points inside: edges as long as those of the loop, 5 to 7 at each vertex of the filling and the loop, and a
    /// surface that continues the mesh around it smoothly. --max-degree and --extra-area decide the filling that it begins with
    #[arg(long, help_heading = "Filling")]
    pub(crate) interior: bool,

    /// The largest total degree of a vertex on a loop; without it, for each loop the least that is
    /// possible from 6 up and takes no more than --extra-area
    #[arg(long, value_name = "D", value_parser = whole_number, allow_hyphen_values = true, help_heading = "Filling")]
    pub(crate) max_degree: Option<u32>,

    /// Without --max-degree: how much more area than without a limit a filling may take, such as 5%
    /// or 0.05; inf for the least degree, whatever its area
    #[arg(long, value_name = "SHARE", value_parser = extra, default_value = "5%",
        conflicts_with = "max_degree", allow_hyphen_values = true, help_heading = "Filling")]
    pub(crate) extra_area: f64,

    /// Keep loops of this many vertices or more open; up to 2001
    #[arg(long, value_name = "N", value_parser = whole_number, default_value = "500", allow_hyphen_values = true, help_heading = "Filling")]
    pub(crate) max_loop: u32,

    /// Fill this loop alone: its index from 1 such as 2, a vertex on it such as v17, or a point near it
    /// such as 0,0,1.5. May be repeated
    #[arg(
        long = "loop",
        value_name = "LOOP",
        allow_hyphen_values = true,
        help_heading = "Filling"
    )]
    pub(crate) loops: Vec<LoopChoice>,

    /// Write nothing and end with exit code 3 if a new triangle has an angle below this many degrees, up to 60
    #[arg(long, value_name = "A", value_parser = target_angle, allow_hyphen_values = true, help_heading = "Filling")]
    pub(crate) target_angle: Option<f64>,

    /// Print JSON: file, vertices, triangles, max_degree, filled (loop, vertices, first_vertex,
    /// limit, max_degree, area, area_without_limit, least_limit, area_at_least_limit, degree_without_limit, min_angle,
    /// triangles, vertices_inside, degrees, violations, without_points), left_open (loop, vertices, first_vertex, reason), crossings (pairs of triangles), dropped, files.
    /// Loops are counted from 1, vertices and triangles from 0
    #[arg(long, help_heading = "Messages")]
    pub(crate) json: bool,

    /// Print no summary and show no progress on standard error
    #[arg(short, long, help_heading = "Messages")]
    pub(crate) quiet: bool,
}

/// A share of 0 or more, also as a percentage.
fn extra(text: &str) -> Result<f64, String> {
    let (number, unit) = match text.trim().strip_suffix('%') {
        Some(number) => (number, 100.0),
        None => (text.trim(), 1.0),
    };
    let share = number.trim().parse::<f64>().ok().map(|number| number / unit);
    share
        .filter(|share| *share >= 0.0)
        .ok_or_else(|| "give a share of 0 or more, such as 0.05, or 5%; or inf".to_owned())
}
