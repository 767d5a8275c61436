//! The needs of ocean models: open water, and depths.

use super::values::{Length, distance, place, seconds};
use crate::failure::Failure;
use crate::interrupt::SESSION;
use clap::Args;
use mindeg::glam::DVec2;
use mindeg::{DepthRules, Depths, Domain, Interior, OpenWater, Opening, Projection, Size};
use mindeg_answers::numbers::count;
use mindeg_files::Input;
use mindeg_mesh::{LineKind, number, significant};
use std::borrow::Cow;
use std::path::PathBuf;

/// Which parts of the boundary are open water.
#[derive(Clone, Debug, Default, Args)]
#[command(next_help_heading = "Ocean models")]
pub(crate) struct BoundaryKinds {
    /// Sides that are open water, by name, or box: the longest stretch on the box around the domain. The rest is land, and
    /// holes islands. May be repeated
    #[arg(long, value_name = "box|NAME")]
    pub(crate) open: Vec<String>,

    /// The boundary counter-clockwise from one point to another is open water; may be repeated
    #[arg(long, value_name = "x,y", num_args = 2, value_parser = place, allow_hyphen_values = true)]
    pub(crate) open_between: Vec<[f64; 2]>,

    /// All stretches on the box that are at least so long are open; shorter ones are land
    #[arg(long, value_name = "LENGTH", value_parser = distance, allow_hyphen_values = true)]
    pub(crate) least_opening: Option<Length>,
}

/// Domains with the kinds of their sides.
pub(crate) struct Told<'d> {
    pub(crate) domains: Cow<'d, [Domain]>,
    /// The stretches that were asked to be open water.
    pub(crate) openings: Vec<Opening>,
    /// What to say of them once the work is done: an error stands alone.
    pub(crate) notes: Vec<String>,
}

impl BoundaryKinds {
    /// Refuses open water where there is no single domain.
    pub(crate) fn refuse(&self, subject: &str) -> Result<(), Failure> {
        if self.is_empty() {
            return Ok(());
        }
        Err(Failure::Input(format!(
            "--open is for one domain, and there are {subject}: choose one with --feature"
        )))
    }

    fn is_empty(&self) -> bool {
        self.open.is_empty() && self.open_between.is_empty()
    }

    /// Gives domains beside each other these kinds of sides.
    pub(crate) fn told<'d>(&self, domains: &'d [Domain]) -> Result<Told<'d>, Failure> {
        if self.is_empty() && self.least_opening.is_some() {
            return Err(Failure::input(
                "--least-opening is for open water: add --open or --open-between",
            ));
        }
        // Files say what is open water, too.
        let is_open =
            |domain: &Domain| domain.sides().iter().any(|side| side.kind == Some(LineKind::Open));
        if self.is_empty() && !domains.iter().any(is_open) {
            let domains = Cow::Borrowed(domains);
            return Ok(Told { domains, openings: Vec::new(), notes: Vec::new() });
        }
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
        let option = if self.open.is_empty() { "--open-between" } else { "--open" };
        let least = self.least_opening.map(|least| least.value);
        let is_projected = domains.iter().any(|domain| domain.projection().is_some());
        let (new, openings) = Domain::all_with_open_water(domains, &parts, least)
            .map_err(|error| Failure::Input(format!("{option}: {error}")))?;
        let mut notes = Vec::new();
        for ends in self.open_between.chunks_exact(2) {
            let off = |end: &[f64; 2]| {
                let distances =
                    domains.iter().map(|domain| domain.distance_to_boundary((*end).into()));
                length(distances.fold(f64::INFINITY, f64::min), is_projected)
            };
            notes.push(format!(
                "--open-between: the nearest vertices of the boundary are {} and {} from the points",
                off(&ends[0]),
                off(&ends[1])
            ));
        }
        notes.extend(self.of_land(&openings, is_projected));
        Ok(Told { domains: Cow::Owned(new), openings, notes })
    }

    /// A note on stretches that were asked for and are land: all of them, with the options that open them.
    fn of_land(&self, openings: &[Opening], is_projected: bool) -> Option<String> {
        let length = |it: f64| length(it, is_projected);
        let place = |at: DVec2| format!("{},{}", significant(at.x, 7), significant(at.y, 7));
        let stretch = |it: &Opening| {
            let [from, to] = it.ends.map(place);
            format!("{} between {from} {to}", length(it.length))
        };
        let (open, mut land): (Vec<Opening>, Vec<Opening>) =
            openings.iter().cloned().partition(|opening| opening.is_open);
        land.sort_by(|a, b| b.length.total_cmp(&a.length));
        let shorter = match self.least_opening {
            Some(least) => format!("shorter than {}", length(least.value)),
            None => "on the box that is not the longest".to_owned(),
        };
        let count = match land.len() {
            0 => return None,
            1 => format!("1 stretch {shorter} is"),
            several => {
                let shorter = shorter.replace("that is", "that are");
                format!("{} stretches {shorter} are", count(several as u64))
            }
        };
        let open = match &open[..] {
            [] => "no stretch is open water".to_owned(),
            [one] => format!("open water is {}", stretch(one)),
            several => {
                let texts: Vec<String> = several.iter().map(stretch).collect();
                format!("open water is {}", texts.join(", "))
            }
        };
        let all: Vec<String> = land.iter().map(stretch).collect();
        Some(format!(
            "{open}\n{count} land; --least-opening LENGTH opens all that are no shorter, --open-between x,y x,y one:\n  {}",
            all.join("\n  ")
        ))
    }
}

/// A length with its unit, where that is known.
fn length(length: f64, is_projected: bool) -> String {
    match is_projected {
        true if length >= 1000.0 => format!("{}km", number(length / 1000.0)),
        true => format!("{}m", number(length)),
        false => number(length),
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

    /// Sizes by the depth: so many edges on the wave of the M2 tide, 12.42 h, in shallow water
    #[arg(long, value_name = "N", value_parser = above_0, allow_hyphen_values = true)]
    pub(crate) wavelength: Option<f64>,

    /// Sizes by the slope of the depth: 2 pi / N times the depth over its gradient
    #[arg(long, value_name = "N", value_parser = above_0, allow_hyphen_values = true)]
    pub(crate) slope: Option<f64>,

    /// Tells its greatest Courant number; sizes by the depth are at least what 0.5 allows
    #[arg(long, value_name = "SECONDS", value_parser = seconds, allow_hyphen_values = true)]
    pub(crate) time_step: Option<f64>,
}

impl DepthArguments {
    /// The first option that is given.
    pub(crate) fn first_given(&self) -> Option<&'static str> {
        let given = [
            ("--depth", self.depth.is_some()),
            ("--elevation", self.elevation.is_some()),
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
                    Some(option) => Err(without_depths(option)),
                };
            }
        };
        Ok(Some(depths.in_plane_of(projection)))
    }

    /// The wishes for the inside of domains, with the sizes that depths ask for.
    pub(crate) fn over(
        &self,
        depths: Option<&Depths>,
        mut wanted: Interior,
        domains: &[Domain],
    ) -> Result<Interior, Failure> {
        let (Some(rules), Some(depths)) = (self.rules(), depths) else { return Ok(wanted) };
        let sizes = depths.sizes(&rules, domains.iter().flat_map(|it| it.placement().points()));
        if sizes.points.is_empty() {
            return Err(Failure::input(
                "the depths ask for no size: none is above 0 in the box around the domain",
            ));
        }
        wanted.sizes.push(Size::Between(sizes));
        Ok(wanted)
    }

    /// The rules for sizes.
    fn rules(&self) -> Option<DepthRules> {
        let Self { wavelength, slope, time_step, .. } = *self;
        (wavelength.is_some() || slope.is_some()).then_some(DepthRules {
            wavelength,
            slope,
            time_step,
        })
    }
}

/// The error of an option where there are no depths.
pub(super) fn without_depths(option: &str) -> Failure {
    Failure::Input(format!("{option} needs depths: add --depth FILE, or --elevation FILE"))
}

/// A depth of water; a negative one would be land.
pub(super) fn depth(text: &str) -> Result<f64, String> {
    let number = text.trim().parse().ok();
    let number = number.filter(|number: &f64| number.is_finite() && *number >= 0.0);
    number.ok_or_else(|| "give a depth in metres, 0 or more, such as 2".to_owned())
}

fn above_0(text: &str) -> Result<f64, String> {
    let number =
        text.trim().parse().ok().filter(|number: &f64| number.is_finite() && *number > 0.0);
    number.ok_or_else(|| "give a number above 0, such as 30".to_owned())
}
