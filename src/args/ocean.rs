//! What ocean models need of a mesh: open water, and depths.

use super::values::{Length, length_with_unit, place, seconds};
use crate::failure::Failure;
use crate::interrupt::SESSION;
use clap::Args;
use mindeg::{DepthRules, Depths, Domain, OpenWater, Projection};
use mindeg_files::Input;
use std::path::PathBuf;

/// Which parts of the boundary are open water.
#[derive(Clone, Debug, Default, Args)]
#[command(next_help_heading = "Ocean models")]
pub(crate) struct BoundaryKinds {
    /// Sides that are open water, by name, or box: those on the box around the domain (of its degrees, if projected).
    /// The others are land, and holes islands. May be repeated
    #[arg(long, value_name = "box|NAME")]
    pub(crate) open: Vec<String>,

    /// The boundary from the vertex nearest to one point to that nearest to another, counter-clockwise, is open
    /// water; in degrees if the domain was projected. May be repeated
    #[arg(long, value_name = "x,y", num_args = 2, value_parser = place, allow_hyphen_values = true)]
    pub(crate) open_between: Vec<[f64; 2]>,

    /// Shorter stretches of open water are land: bays that the box cuts, gaps between capes
    #[arg(long, value_name = "LENGTH", value_parser = length_with_unit, allow_hyphen_values = true)]
    pub(crate) least_opening: Option<Length>,
}

impl BoundaryKinds {
    /// Refuses open water where there is no single domain.
    pub(crate) fn refuse(&self, subject: &str) -> Result<(), Failure> {
        if self.open.is_empty() && self.open_between.is_empty() {
            return Ok(());
        }
        Err(Failure::Input(format!(
            "--open is for one domain, and there are {subject}: choose one with --feature"
        )))
    }

    /// The domain with these kinds of sides.
    pub(crate) fn told(&self, domain: Domain) -> Result<Domain, Failure> {
        let mut domains = vec![domain];
        self.tell(&mut domains)?;
        Ok(domains.swap_remove(0))
    }

    /// Gives domains beside each other these kinds of sides.
    pub(crate) fn tell(&self, domains: &mut Vec<Domain>) -> Result<(), Failure> {
        let part = |name: &String| match &**name {
            "box" => OpenWater::Box,
            name => OpenWater::Side(name.to_owned()),
        };
        let between = |ends: &[[f64; 2]]| OpenWater::Between([ends[0], ends[1]].map(Into::into));
        let parts: Vec<OpenWater> = self
            .open
            .iter()
            .map(part)
            .chain(self.open_between.chunks_exact(2).map(between))
            .collect();
        if parts.is_empty() {
            if self.least_opening.is_some() {
                let problem = "--least-opening is for open water: add --open or --open-between";
                return Err(Failure::input(problem));
            }
            return Ok(());
        }
        let option = if self.open.is_empty() { "--open-between" } else { "--open" };
        let least = self.least_opening.map_or(0.0, |least| least.value);
        *domains = Domain::all_with_open_water(domains, &parts, least)
            .map_err(|error| Failure::Input(format!("{option}: {error}")))?;
        Ok(())
    }
}

/// The depth of the water.
#[derive(Clone, Debug, Default, Args)]
#[command(next_help_heading = "Ocean models")]
pub(crate) struct DepthArguments {
    /// Depths of the vertices, positive down, from an ESRI grid (.asc), classic NetCDF, NPZ or .npy as for --sizes; in degrees if the
    /// domain was projected and the grid is within them
    #[arg(long, value_name = "FILE")]
    pub(crate) depth: Option<PathBuf>,

    /// The same as heights, positive up: those of GEBCO or ETOPO
    #[arg(long, value_name = "FILE", conflicts_with = "depth")]
    pub(crate) elevation: Option<PathBuf>,

    /// The least depth of a vertex; shallower ones, and dry land, get it
    #[arg(long, value_name = "METRES", allow_hyphen_values = true)]
    pub(crate) least_depth: Option<f64>,

    /// Sizes by the depth: so many edges on the wave of the M2 tide, 12.42 h, in shallow water
    #[arg(long, value_name = "N", value_parser = above_0, allow_hyphen_values = true)]
    pub(crate) wavelength: Option<f64>,

    /// Sizes by the slope of the depth: 2 pi / N times the depth over its gradient
    #[arg(long, value_name = "N", value_parser = above_0, allow_hyphen_values = true)]
    pub(crate) slope: Option<f64>,

    /// Sizes by the depth are at least what this time step allows at a Courant number of 0.5
    #[arg(long, value_name = "SECONDS", value_parser = seconds, allow_hyphen_values = true)]
    pub(crate) time_step: Option<f64>,
}

impl DepthArguments {
    /// The first option that is given.
    pub(crate) fn first_given(&self) -> Option<&'static str> {
        let given = [
            ("--depth", self.depth.is_some()),
            ("--elevation", self.elevation.is_some()),
            ("--least-depth", self.least_depth.is_some()),
            ("--wavelength", self.wavelength.is_some()),
            ("--slope", self.slope.is_some()),
            ("--time-step", self.time_step.is_some()),
        ];
        given.into_iter().find_map(|(option, is_given)| is_given.then_some(option))
    }

    /// The depths in the plane of a domain, if a file is given.
    pub(crate) fn read(&self, projection: Option<&Projection>) -> Result<Option<Depths>, Failure> {
        let depths = match (&self.depth, &self.elevation) {
            (Some(path), _) => SESSION.depths(&Input::of(path))?,
            (None, Some(path)) => SESSION.depths(&Input::of(path))?.negated(),
            (None, None) => {
                return match self.first_given() {
                    None => Ok(None),
                    Some(option) => Err(Failure::Input(format!(
                        "{option} needs depths: add --depth FILE, or --elevation FILE"
                    ))),
                };
            }
        };
        Ok(Some(depths.in_plane_of(projection)))
    }

    /// The rules for sizes.
    pub(crate) fn rules(&self) -> Option<DepthRules> {
        let Self { wavelength, slope, time_step, .. } = *self;
        (wavelength.is_some() || slope.is_some()).then_some(DepthRules {
            wavelength,
            slope,
            time_step,
        })
    }
}

fn above_0(text: &str) -> Result<f64, String> {
    let number =
        text.trim().parse().ok().filter(|number: &f64| number.is_finite() && *number > 0.0);
    number.ok_or_else(|| "give a number above 0, such as 30".to_owned())
}
