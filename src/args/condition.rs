//! `mindeg condition`.

use super::demands::preset_parser;
use super::domain::OutlineOptions;
use super::interior::with_sizes_of;
use super::ocean::{BoundaryKinds, DepthArguments};
use super::values::{Length, area, distance, length_with_unit};
use super::with_exit_codes;
use crate::failure::Failure;
use clap::Args;
use mindeg::interior::{BoundaryDemands, LEAST_GROWTH};
use mindeg::{Domain, Interior};
use mindeg_answers::preset::Preset;
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  mindeg condition assets/domains/great-britain.json --limit 30 -o britain.json
  mindeg condition assets/domains/great-britain.json --within 5 --size 20 --json
  mindeg mesh britain.json --interior -o britain.14
  mindeg condition assets/outlines/saronic.geojson --project auto --size 2km";

/// Change a boundary by as little as it takes for a mesh with points inside to reach an angle
///
/// A boundary limits the angles of every mesh that keeps it. Points on edges mend what moves nothing: an edge beside
/// a much shorter one, long edges in a strait. Dropped points and cut corners mend the rest, nowhere farther than
/// --within. Corners of sides with a name or a kind stay. Places that stay below the limit are listed, with the reason;
/// the domain is written even so.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES, after_long_help = with_exit_codes(EXAMPLES))]
pub(crate) struct ConditionArguments {
    /// A domain in JSON, or an outline in a format that mindeg formats lists; - reads standard input
    #[arg(id = "domain", value_name = "DOMAIN")]
    pub(crate) file: PathBuf,

    /// The minimum angle that the boundary shall allow, in degrees, at most 40
    #[arg(long, value_name = "ANGLE", value_parser = angle, default_value = "25", allow_hyphen_values = true)]
    pub(crate) limit: f64,

    /// The length that edges should have: shorter ones are joined within --within, longer ones divided; such as 4000 or 4km
    #[arg(long, value_name = "LENGTH", value_parser = length_with_unit, allow_hyphen_values = true)]
    pub(crate) size: Option<Length>,

    /// At least so many edges across channels and beside islands of the mesh. Edges of the boundary get no longer than that takes,
    /// as by --sizes and depths, down to --min-size, without it to an eighth of --size
    #[arg(long, value_name = "A", value_parser = across, allow_hyphen_values = true)]
    pub(crate) across: Option<f64>,

    /// Sizes of a grid or mesh: .asc, classic NetCDF, NPZ, .npy, MSH, VTU; the least of several holds
    #[arg(long, value_name = "FILE")]
    pub(crate) sizes: Vec<PathBuf>,

    /// The least size that counts: sizes asked for below it are raised to it
    #[arg(long, value_name = "S", value_parser = length_with_unit, allow_hyphen_values = true)]
    pub(crate) min_size: Option<Length>,

    /// No edge is longer than 4/3 of another and this times their distance together: a mesh reaches its limits more surely
    /// where lengths change gradually; 0.35 or more, or 0 for no such rule [default: 0.4]
    #[arg(long, value_name = "G", value_parser = growth, allow_hyphen_values = true)]
    pub(crate) growth: Option<f64>,

    /// The program that the mesh is for. One such as telemac wants a corner inside in each triangle, so corners of the
    /// boundary take two triangles
    #[arg(long, value_name = "PROGRAM", value_parser = preset_parser())]
    pub(crate) preset: Option<Preset>,

    #[command(flatten)]
    pub(crate) change: ChangeArguments,

    #[command(flatten)]
    pub(crate) outline: OutlineOptions,

    #[command(flatten)]
    pub(crate) kinds: BoundaryKinds,

    #[command(flatten)]
    pub(crate) depth: DepthArguments,

    /// Where to write the domain in JSON, or its outlines in GeoJSON if it ends in .geojson; - is standard output
    #[arg(short, long, value_name = "FILE", help_heading = None)]
    pub(crate) output: Option<PathBuf>,

    /// Print the changes as JSON: points_before, points, dropped, inserted, shifted, cut, holes_dropped, inlets_closed,
    /// straits_closed, basins_dropped, spits_cut, moved, angle_limit_before, angle_limit, is_reached, and the lists changes, left
    /// and narrow
    #[arg(long, help_heading = None)]
    pub(crate) json: bool,

    /// Show no progress on standard error
    #[arg(short, long, help_heading = None)]
    pub(crate) quiet: bool,
}

/// How a boundary may change.
#[derive(Clone, Debug, Args)]
#[command(next_help_heading = "Conditioning")]
pub(crate) struct ChangeArguments {
    /// How far the boundary may move [default: an eighth of --size, without it nowhere]
    #[arg(long, value_name = "LENGTH", value_parser = distance, allow_hyphen_values = true)]
    pub(crate) within: Option<Length>,

    /// Drop holes with a smaller area, such as 4e6 or 4km2
    #[arg(long, value_name = "AREA", value_parser = area, allow_hyphen_values = true)]
    pub(crate) least_island: Option<Length>,

    /// Close narrower inlets and straits and cut off narrower spits, however far that is; of parts between straits the
    /// largest stays. A bay or cape no deeper than wide stays
    #[arg(long, value_name = "LENGTH", value_parser = length_with_unit, allow_hyphen_values = true)]
    pub(crate) narrowest: Option<Length>,

    /// A side that keeps all its points, by its name, such as "side 3"; may be repeated
    #[arg(long, value_name = "NAME")]
    pub(crate) keep: Vec<String>,

    /// Draw boundaries, changes and places below the limit (.svg), or list them (.geojson)
    #[arg(long, value_name = "FILE", value_parser = changes_file)]
    pub(crate) changes: Option<PathBuf>,
}

impl ChangeArguments {
    /// The first option that is given.
    pub(crate) fn first_given(&self) -> Option<&'static str> {
        let given = [
            ("--within", self.within.is_some()),
            ("--least-island", self.least_island.is_some()),
            ("--narrowest", self.narrowest.is_some()),
            ("--keep", !self.keep.is_empty()),
            ("--changes", self.changes.is_some()),
        ];
        given.into_iter().find_map(|(option, is_given)| is_given.then_some(option))
    }

    /// How far a hole that touches another ring may move away from it before anything else changes: it counts beside the distance
    /// of all other changes, so it is a part of it.
    pub(crate) fn room(&self, size: Option<Length>) -> f64 {
        const SHARE: f64 = 0.25;
        SHARE * self.within.map_or(base(size).within, |it| it.value)
    }

    /// The demands with an angle, a length of edges, a growth, and the least number of triangles at a vertex.
    pub(crate) fn demands(
        &self,
        angle: f64,
        size: Option<Length>,
        growth: Option<f64>,
        least_triangles: u32,
    ) -> BoundaryDemands {
        let base = base(size);
        BoundaryDemands {
            angle,
            within: self.within.map_or(base.within, |it| it.value),
            growth: growth.unwrap_or(base.growth),
            least_triangles,
            narrowest: self.narrowest.map_or(0.0, |it| it.value),
            least_hole: self.least_island.map_or(0.0, |it| it.value),
            ..base
        }
    }
}

/// The demands with a length of edges, if there is one.
fn base(size: Option<Length>) -> BoundaryDemands {
    size.map_or_else(BoundaryDemands::default, |it| BoundaryDemands::of_size(it.value))
}

/// An angle that a boundary can be asked for.
pub(super) fn angle(text: &str) -> Result<f64, String> {
    let angle = text.trim().trim_end_matches('°').parse().ok();
    let angle = angle.filter(|angle| *angle > 0.0 && *angle <= 40.0);
    angle.ok_or_else(|| "give an angle above 0 and at most 40 degrees, such as 25".to_owned())
}

/// A file that can take changes.
fn changes_file(text: &str) -> Result<PathBuf, String> {
    let path = PathBuf::from(text);
    let extension = path.extension().map(|name| name.to_string_lossy().to_lowercase());
    if text == "-" || matches!(extension.as_deref(), Some("svg" | "geojson" | "json")) {
        return Ok(path);
    }
    Err("changes are drawn to .svg, and listed in .geojson or .json".to_owned())
}

impl ConditionArguments {
    /// The wishes for the inside of domains that lie in one plane, in place of those of a single one.
    pub(crate) fn wanted(&self, domains: &[Domain]) -> Result<Interior, Failure> {
        let [first, others @ ..] = domains else { return Ok(Interior::default()) };
        let of_file = first.interior().filter(|_| others.is_empty());
        let mut wanted = of_file.cloned().unwrap_or_default();
        wanted.across = self.across.or(wanted.across);
        wanted.min_size = self.min_size.map(|size| size.value).or(wanted.min_size);
        let mut wanted = with_sizes_of(wanted, &self.sizes)?;
        if let Some(preset) = self.preset {
            wanted = preset.asked_of(wanted);
        }
        let depths = self.depth.read(first.projection())?;
        self.depth.over(depths.as_ref(), wanted, domains)
    }
}

/// A number of edges across a channel.
fn across(text: &str) -> Result<f64, String> {
    let across = text.trim().parse().ok();
    let across = across.ok_or_else(|| "give a number of edges, such as 3".to_owned())?;
    let wanted = Interior { across: Some(across), ..Interior::default() };
    wanted.check().map(|()| across).map_err(|error| error.message)
}

/// A growth that halving edges can reach.
fn growth(text: &str) -> Result<f64, String> {
    let growth = text.trim().parse().ok();
    let growth = growth.filter(|it| *it == 0.0 || (LEAST_GROWTH..100.0).contains(it));
    growth.ok_or_else(|| format!("give 0, or a number from {LEAST_GROWTH} to 100, such as 0.4"))
}
