//! `mindeg mesh`.

use super::condition::{ChangeArguments, angle};
use super::demands::PresetArgument;
use super::domain::DomainArguments;
use super::goal::GoalArguments;
use super::interior::InteriorArguments;
use super::ocean::{BoundaryKinds, DepthArguments, depth, without_depths};
use super::surface::SurfaceArguments;
use super::values::length;
use super::with_exit_codes;
use crate::failure::Failure;
use clap::Args;
use mindeg::{Depths, GoalKind, Projection};
use mindeg_answers::demands::Demands;

const EXAMPLES: &str = "\
Examples:
  mindeg mesh assets/domains/plate-with-holes.json --interior -o plate.vtu
  mindeg mesh --rectangle 4x3 --size 0.5 -o plate.obj
  mindeg mesh assets/domains/wing-panel.json --keep-angle 95% -o wing.glb
  mindeg mesh --corners \"0,0 4,0 3,2\" --intervals 8,5,7 -o wedge.gltf
  mindeg mesh assets/models/bracket.obj --size 5 -o bracket.glb
  mindeg mesh - -o - --format obj < domain.json | zstd > mesh.obj.zst";

/// Mesh a domain, a map or a model and write it to files
///
/// For a solver take --interior: angles get larger; for a patch that must keep its points, --keep-angle 95%.
/// By default a mesh has no points inside, the least possible maximum degree and, where half a second finds it, the
/// largest minimum angle of all such meshes; elsewhere the best of at most 64, as the summary says. Vertices are
/// numbered counter-clockwise from the first corner. A mesh that misses a demand is not written. Each file appears whole
/// or not at all; a .gltf is two files.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES, after_long_help = with_exit_codes(EXAMPLES))]
pub(crate) struct MeshArguments {
    #[command(flatten)]
    pub(crate) goal: GoalArguments,

    #[command(flatten)]
    pub(crate) interior: InteriorArguments,

    #[command(flatten)]
    pub(crate) domain: DomainArguments,

    /// Mesh each polygon by itself, into a file in the folder of -o, not as a region of one mesh
    #[arg(long, requires = "domain", help_heading = "Outlines")]
    pub(crate) separate: bool,

    /// Change the boundary first by as little as allows this minimum angle, 25° without =ANGLE, as mindeg condition
    /// does, with --size for the length of its edges. Needs --interior
    #[arg(long, value_name = "ANGLE", value_parser = angle, num_args = 0..=1, require_equals = true,
        default_missing_value = "25", help_heading = "Conditioning")]
    pub(crate) condition: Option<f64>,

    #[command(flatten)]
    pub(crate) change: ChangeArguments,

    #[command(flatten)]
    pub(crate) kinds: BoundaryKinds,

    #[command(flatten)]
    pub(crate) depth: DepthArguments,

    /// The least depth of a vertex; shallower ones, and dry land, get it
    #[arg(long, value_name = "METRES", value_parser = depth, allow_hyphen_values = true,
        help_heading = "Ocean models")]
    pub(crate) least_depth: Option<f64>,

    #[command(flatten)]
    pub(crate) surface: SurfaceArguments,

    #[command(flatten)]
    pub(crate) preset: PresetArgument,

    /// Print JSON; its keys: name, intervals, vertices, triangles, max_degree, least_max_degree,
    /// at_least, min_angle, max_angle, angle_limit, share_of_limit, found_by, reversed, files, and where they apply
    /// regions, parts, conditioned, openings, depths and projection
    #[arg(long, help_heading = "Messages")]
    pub(crate) json: bool,

    /// Print no summary and show no progress on standard error
    #[arg(short, long, help_heading = "Messages")]
    pub(crate) quiet: bool,

    #[command(flatten)]
    pub(crate) model: ModelArguments,
}

impl MeshArguments {
    /// The demands on a mesh whose points are to have this minimum angle.
    pub(crate) fn demands(&self, target_angle: Option<f64>) -> Demands {
        Demands { max_degree: self.goal.max_degree(), target_angle, preset: self.preset.preset }
    }

    /// The depths in the plane of a domain, if a file is given.
    pub(crate) fn depths(
        &self,
        projection: Option<&Projection>,
    ) -> Result<Option<Depths>, Failure> {
        let depths = self.depth.read(projection)?;
        match self.least_depth {
            Some(_) if depths.is_none() => Err(without_depths("--least-depth")),
            _ => Ok(depths),
        }
    }

    /// Refuses goals that have no meaning with interior points, which `from` asks for.
    pub(crate) fn refuse_goals_with_interior(&self, from: &str) -> Result<(), Failure> {
        let with_another = |kind: &GoalKind| Some((kind.option(), kind.instead?));
        match self.goal.kinds().find_map(with_another) {
            None => Ok(()),
            Some((option, instead)) => Err(Failure::Input(format!(
                "{option} is for meshes of boundary points alone; with {from}, {instead}"
            ))),
        }
    }
}

/// Options of whole models alone: an OBJ with faces, a glTF, or JSON with "faces".
#[derive(Debug, Args)]
#[command(next_help_heading = "Models")]
pub(crate) struct ModelArguments {
    /// Merge neighbouring faces of one group in one plane to one face; always done for glTF
    #[arg(long)]
    pub(crate) merge_coplanar: bool,

    /// How far a corner may be from its face's plane [default: 1e-5 of the largest extent]
    #[arg(long, value_name = "LENGTH", value_parser = length, allow_hyphen_values = true)]
    pub(crate) planar_tolerance: Option<f64>,

    /// How long to look for a smaller degree: a multiple of the default, seconds
    #[arg(long, value_name = "FACTOR", value_parser = factor, default_value = "1",
        allow_hyphen_values = true)]
    pub(crate) effort: f64,
}

fn factor(text: &str) -> Result<f64, String> {
    let factor = text.trim().parse().ok().filter(|factor| (0.0..=1e6).contains(factor));
    factor.ok_or_else(|| "give a factor from 0 to 1000000, such as 10".to_owned())
}
