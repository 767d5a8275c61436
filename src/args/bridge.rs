//! `mindeg bridge`.

use super::loop_choice::LoopChoice;
use super::surface::SurfaceArguments;
use super::values::{target_angle, whole_number};
use super::with_exit_codes;
use clap::Args;
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  mindeg bridge lower.obj upper.obj -o joined.obj
  mindeg bridge lower.obj upper.obj -o joined.glb --from 1 --to v0
  mindeg bridge lower.obj upper.obj -o smooth.obj --interior
  mindeg bridge both.obj -o joined.obj --from 0,0,1 --to 0,0,2";

/// Join two boundary loops, of one mesh or of two, by a strip of triangles
///
/// The strip has the least possible maximum degree, and of all such strips the largest minimum
/// angle. The loops may have different numbers of vertices; without --interior no vertex is added. The edges that the
/// meshes have at the loops count. Of two meshes, the output holds both: the vertices and triangles of the first,
/// those of the second, then the strip as the group "bridge".
///
/// The strip faces as the triangles along both loops do, so both meshes must be the right side out.
/// In a plane one loop must lie inside the other, and the strip does not fold.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES, after_long_help = with_exit_codes(EXAMPLES))]
pub(crate) struct BridgeArguments {
    /// The mesh, in any format that mindeg reads, told by its extension
    #[arg(value_name = "MESH")]
    pub(crate) file: PathBuf,

    /// A second mesh; without it, the bridge joins two loops of the first
    #[arg(value_name = "MESH")]
    pub(crate) other: Option<PathBuf>,

    #[command(flatten)]
    pub(crate) surface: SurfaceArguments,

    /// The loop of the first mesh: its index from 1 such as 2, a vertex on it such as v17, or a point
    /// near it such as 0,0,1.5. Needed if there are several
    #[arg(long, value_name = "LOOP", allow_hyphen_values = true, help_heading = "Strip")]
    pub(crate) from: Option<LoopChoice>,

    /// The loop of the second mesh, or the other one of the first
    #[arg(long, value_name = "LOOP", allow_hyphen_values = true, help_heading = "Strip")]
    pub(crate) to: Option<LoopChoice>,

    /// Put points between the loops where they are far apart: edges about as long as theirs, 5 to 7 at each vertex of the bridge and the
    /// loops, and a tube that continues both ends smoothly. --max-degree decides the strip that it begins with
    #[arg(long, help_heading = "Strip")]
    pub(crate) interior: bool,

    /// The largest total degree of a vertex on the loops; without it, the least that is possible
    #[arg(long, value_name = "D", value_parser = whole_number, allow_hyphen_values = true, help_heading = "Strip")]
    pub(crate) max_degree: Option<u32>,

    /// Write nothing and end with exit code 3 if a triangle of the strip has an angle below this many degrees, up to 60
    #[arg(long, value_name = "A", value_parser = target_angle, allow_hyphen_values = true, help_heading = "Strip")]
    pub(crate) target_angle: Option<f64>,

    /// Print JSON: from and to (loop, vertices, first_vertex), vertices, triangles, strip (its
    /// triangles), max_degree, least_max_degree, at_least, min_angle, next_min_angle,
    /// angle_without_limit, degree_without_limit, planar, vertices_inside, degrees, violations, without_points, crossings (pairs of triangles), dropped, files.
    /// Loops are counted from 1, vertices and triangles from 0
    #[arg(long, help_heading = "Messages")]
    pub(crate) json: bool,

    /// Print no summary and show no progress on standard error
    #[arg(short, long, help_heading = "Messages")]
    pub(crate) quiet: bool,
}
