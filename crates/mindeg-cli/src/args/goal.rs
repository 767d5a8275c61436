//! What a mesh of a domain is to be.

use super::values::whole_number;
use clap::Args;
use mindeg::Goal;

/// By default, the least maximum degree.
#[derive(Debug, Args)]
#[command(next_help_heading = "Goals")]
pub(crate) struct GoalArguments {
    /// Make the mesh with the smallest maximum degree that keeps this share of the minimum angle of
    /// a Delaunay triangulation, such as 95% or 0.95. Exact up to 4096 vertices of a convex boundary;
    /// beyond, the share is kept, and the degree is what was reached
    #[arg(long, value_name = "SHARE", value_parser = Goal::share, allow_hyphen_values = true)]
    pub(crate) keep_angle: Option<f64>,

    /// Make the mesh with the largest minimum angle of all whose vertices have at most this many
    /// edges. Exact up to 4096 vertices of a convex boundary: below a second for 400, half a minute for
    /// 4000; beyond, as large as was reached. A mesh with more is not written, also with --keep-angle or
    /// interior points
    #[arg(long, value_name = "D", value_parser = whole_number, allow_hyphen_values = true)]
    pub(crate) max_degree: Option<u32>,
}
