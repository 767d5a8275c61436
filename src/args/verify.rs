//! `mindeg verify`.

use super::demands::DemandArguments;
use super::domain::DomainOptions;
use super::tolerance::Tolerance;
use super::values::{angle, mesh_help};
use super::with_exit_codes;
use crate::failure::Failure;
use clap::Args;
use mindeg::Goal;
use mindeg_answers::verify::VerifyDemands;
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  mindeg verify wing-panel.obj assets/domains/wing-panel.json
  mindeg verify plate.stl --rectangle 4x3 --size 0.5 --optimal --json
  mindeg verify remeshed.stl --surface part.stl --tolerance 1%";

/// Check that a mesh of any program is a triangulation of a domain, and whether its maximum degree is
/// the least
///
/// Matches the vertices of the mesh, in any order, to the boundary points of the domain; other vertices
/// are interior points. Names the first defect, or tells the maximum degree, whether a smaller one is
/// possible (with the proof checked by code that has no part in making meshes), the minimum angle and its share of the largest
/// possible. The mesh lies in x and y, or in x and z. Ends with exit code 3 if the mesh is no triangulation, or fails
/// one of the options --max-degree, --target-angle, --keep-angle, --optimal and --preset, or a degree limit of the domain.
///
/// With --surface, the mesh is a remesh in space: all vertices off the boundary have 5 to 7 edges, those on it at most 5, unless a corner proves another degree, no
/// point of one surface is farther from the other than --tolerance (a bound that is proven, not sampled), boundaries
/// likewise, the surface is manifold, and no triangle is turned over or crosses another unless the part has crossings.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES, after_long_help = with_exit_codes(EXAMPLES))]
pub(crate) struct VerifyArguments {
    /// The mesh.
    #[arg(value_name = "MESH", help = mesh_help(""))]
    pub(crate) file: PathBuf,

    /// The domain: JSON, or an outline in any format that mindeg reads; - reads standard input
    #[arg(id = "domain", value_name = "DOMAIN")]
    pub(crate) domain: Option<PathBuf>,

    #[command(flatten)]
    pub(crate) options: DomainOptions,

    #[command(flatten)]
    pub(crate) surface: SurfaceRuleArguments,

    /// How far a vertex may be from its boundary point, in the domain's unit of length. By default a
    /// millionth of the domain's extent, or what 32-bit floats round, whichever is larger; at most a
    /// quarter of the shortest interval. With --surface how far the surfaces may be apart, also as a share of
    /// the part's diagonal; 0.3% by default
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true, help_heading = "Demands")]
    pub(crate) tolerance: Option<Tolerance>,

    /// Fail if the minimum angle is less than this share of the largest possible, such as 95% or 0.95. The
    /// largest is Delaunay's, or with interior points the limit that the boundary sets
    #[arg(long, value_name = "SHARE", value_parser = Goal::share, allow_hyphen_values = true, help_heading = "Demands")]
    pub(crate) keep_angle: Option<f64>,

    /// Fail unless it is proven that no mesh of the same boundary points has a smaller maximum degree
    #[arg(long, help_heading = "Demands")]
    pub(crate) optimal: bool,

    /// Repeat the proof that mindeg degree --proof has written, instead of searching for one
    #[arg(long, value_name = "FILE", help_heading = "Demands")]
    pub(crate) proof: Option<PathBuf>,

    /// Fail unless the recipe makes the same bytes. The recipe is what mindeg mesh --recipe writes; its inputs lie
    /// beside the file or in the current folder
    #[arg(long, conflicts_with_all = [
        "domain", "surface", "rectangle", "corners", "intervals", "size", "spacing", "keep_angle", "optimal", "proof", "tolerance"
    ], help_heading = "Demands")]
    pub(crate) reproduce: bool,

    /// Print JSON: file, domain, valid, defect, plane, reversed, tolerance, farthest, boundary_vertices,
    /// given_points, interior_points, unreferenced_vertices, triangles, max_degree, max_degree_vertex, least_max_degree, at_least, violations,
    /// certified, together, optimal, proof, reason, smaller_degree, min_angle, max_angle, min_angle_triangle, angle_limit, share_of_limit,
    /// failed, passed; for several domains file, valid, parts, failed, passed; with --surface file, part, valid, defects,
    /// vertices, triangles, max_degree, interior_degree, boundary_degree, violations, certified (vertex, degree, allowed, sectors), min_angle,
    /// min_angle_triangle, tolerance, diagonal, to_part, from_part, boundary_to_part, boundary_from_part, features_from_part, crossings, part_crossings, failed, passed;
    /// with --reproduce file, version, command, inputs, differs_at, passed
    #[arg(long, help_heading = "Messages")]
    pub(crate) json: bool,

    /// Show no progress on standard error
    #[arg(short, long, help_heading = "Messages")]
    pub(crate) quiet: bool,

    #[command(flatten)]
    pub(crate) demands: DemandArguments,
}

impl VerifyArguments {
    /// The demands on the mesh.
    pub(crate) fn all_demands(&self) -> VerifyDemands {
        VerifyDemands {
            demands: self.demands.demands(),
            keep_angle: self.keep_angle,
            optimal: self.optimal,
        }
    }

    /// How far a vertex may be from its boundary point.
    pub(crate) fn matching_tolerance(&self) -> Result<Option<f64>, Failure> {
        match self.tolerance {
            None => Ok(None),
            Some(Tolerance::Length(length)) => Ok(Some(length)),
            Some(Tolerance::Share(_)) => Err(Failure::input(
                "--tolerance takes a share with --surface alone; give a length, such as 1e-6",
            )),
        }
    }
}

/// The surface that a mesh must keep.
#[derive(Debug, Args)]
#[command(next_help_heading = "Surface")]
pub(crate) struct SurfaceRuleArguments {
    /// The part that the mesh was made from, in any format that mindeg reads, instead of a domain
    #[arg(long, value_name = "PART", conflicts_with_all = [
        "domain", "rectangle", "corners", "intervals", "size", "spacing", "keep_angle", "optimal", "proof"
    ])]
    pub(crate) surface: Option<PathBuf>,

    /// Edges of the part that turn by more degrees are sharp. The mesh must have sharp edges within the tolerance of them
    #[arg(long, value_name = "ANGLE", value_parser = angle, requires = "surface", allow_hyphen_values = true)]
    pub(crate) feature_angle: Option<f64>,

    /// The boundary edges of the part must be those of the mesh, bit for bit
    #[arg(long, requires = "surface")]
    pub(crate) keep_boundary: bool,

    /// The sharp edges of the part must be edges of the mesh, bit for bit; 40 degrees without --feature-angle
    #[arg(long, requires = "surface")]
    pub(crate) keep_features: bool,
}
