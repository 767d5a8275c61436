//! The options that describe a domain.

use super::values::{
    Corners, IntervalCounts, Length, RectangleSize, angle, box_corners, length_with_unit,
    named_length,
};
use clap::parser::ValueSource;
use clap::{ArgMatches, Args};
use mindeg::Spacing;
use mindeg_files::{FillRule, ProjectionChoice};
use std::path::PathBuf;

/// One domain, from a file or from options.
#[derive(Clone, Debug, Args)]
pub(crate) struct DomainArguments {
    /// A domain in JSON or outlines, as mindeg formats lists them; - reads standard input. mesh also takes models: OBJ
    /// with faces, .glb, .gltf, or JSON with "faces"
    #[arg(id = "domain", value_name = "DOMAIN", help_heading = None)]
    pub(crate) file: Option<PathBuf>,

    #[command(flatten)]
    pub(crate) options: DomainOptions,
}

/// A domain without a file; with a file, what replaces what it gives for its sides.
#[derive(Clone, Debug, Args)]
#[command(next_help_heading = "Domain")]
pub(crate) struct DomainOptions {
    /// A rectangle with these side lengths; sides 1 to 4 are its bottom, right, top and left
    #[arg(long, value_name = "WxH", conflicts_with_all = ["domain", "corners"], allow_hyphen_values = true)]
    pub(crate) rectangle: Option<RectangleSize>,

    /// A convex polygon with these corners, in quotes, such as "0,0 4,0 3,2"
    #[arg(long, value_name = "x,y x,y …", conflicts_with = "domain", allow_hyphen_values = true)]
    pub(crate) corners: Option<Corners>,

    /// The intervals of each side, counter-clockwise, such as 3,3,2,2
    #[arg(long, value_name = "a,b,…", conflicts_with = "size", allow_hyphen_values = true)]
    pub(crate) intervals: Option<IntervalCounts>,

    /// The length that the intervals of every side should have; 2km where coordinates are metres
    #[arg(long, value_name = "S", value_parser = length_with_unit, allow_hyphen_values = true)]
    pub(crate) size: Option<Length>,

    /// How the intervals of every side are spaced: uniform, geometric:RATIO, bump:RATIO,
    /// beta:BETA, first-length:LENGTH or last-length:LENGTH
    #[arg(long, value_name = "LAW", value_parser = spacing)]
    pub(crate) spacing: Option<Spacing>,

    /// A side is another one moved, such as right=left or "side 2=side 4": the mesh is periodic there, and its degrees
    /// are those of the joined mesh. May be repeated
    #[arg(long, value_name = "SIDE=SIDE", value_parser = matched)]
    pub(crate) periodic: Vec<(String, String)>,

    #[command(flatten)]
    pub(crate) outline: OutlineOptions,
}

impl DomainOptions {
    /// The options of a command line, as words. They name the same domain to any command.
    pub(crate) fn given(command: &ArgMatches) -> Vec<String> {
        let all = Self::augment_args(clap::Command::new("domain"));
        let is_given = |id| command.value_source(id) == Some(ValueSource::CommandLine);
        let mut words = Vec::new();
        for option in all.get_arguments().filter(|option| is_given(option.get_id().as_str())) {
            let name = format!("--{}", option.get_long().unwrap_or_default());
            if !option.get_action().takes_values() {
                words.push(name);
                continue;
            }
            for value in command.get_raw(option.get_id().as_str()).into_iter().flatten() {
                let value = value.to_string_lossy();
                // A value that begins with a dash would look like an option.
                if value.starts_with('-') {
                    words.push(format!("{name}={value}"));
                } else {
                    words.extend([name.clone(), value.into_owned()]);
                }
            }
        }
        words
    }

    /// Whether there is nothing but interval counts, of an outline that is not told.
    pub(crate) fn are_counts(&self) -> bool {
        let has_outline = self.rectangle.is_some() || self.corners.is_some();
        let is_placed = self.size.is_some() || self.spacing.is_some() || !self.periodic.is_empty();
        self.intervals.is_some() && !has_outline && !is_placed
    }

    /// Whether an option divides the sides.
    pub(crate) fn divides(&self) -> bool {
        self.intervals.is_some() || self.size.is_some() || self.spacing.is_some()
    }
}

/// How the outlines of a file that is not JSON become domains.
#[derive(Clone, Debug, Args)]
#[command(next_help_heading = "Outlines")]
pub(crate) struct OutlineOptions {
    /// The polygon of a file with several, by its name or its index from 1
    #[arg(long, value_name = "NAME|INDEX", requires = "domain")]
    pub(crate) feature: Option<String>,

    /// The layer of a file with several: an object of TopoJSON, or a layer of DXF
    #[arg(long, value_name = "LAYER", requires = "domain")]
    pub(crate) layer: Option<String>,

    /// The property that names polygons, not name or id; layer makes regions of layers of DXF
    #[arg(long, value_name = "PROPERTY", requires = "domain")]
    pub(crate) name_by: Option<String>,

    /// The sea between lands: the largest part of this box that no polygon covers
    #[arg(long, value_name = "W,S,E,N", value_parser = box_corners, requires = "domain", allow_hyphen_values = true)]
    pub(crate) sea_in: Option<[f64; 4]>,

    /// Make metres of degrees: auto, utm, laea, stereographic, EPSG:N or a definition of PROJ's; none takes them as planar.
    /// The domain remembers it: formats in degrees get degrees again
    #[arg(long, value_name = "PROJECTION", requires = "domain", allow_hyphen_values = true)]
    pub(crate) project: Option<ProjectionChoice>,

    /// The size of sides and lines of a name, such as river=200m; may be repeated
    #[arg(long, value_name = "NAME=S", value_parser = named_length, requires = "domain")]
    pub(crate) size_of: Vec<(String, Length)>,

    /// Part rings that cross or touch, drop what has no area, give crossing lines a point there
    #[arg(long, requires = "domain")]
    pub(crate) repair: bool,

    /// How near --repair makes points of regions one [default: as near as rounding parts them]
    #[arg(long, value_name = "LENGTH", value_parser = length_with_unit, requires = "repair", allow_hyphen_values = true)]
    pub(crate) snap: Option<Length>,

    /// Rings that touch are repaired unasked, and holes parted from them by this distance at most
    #[arg(skip)]
    pub(crate) mends: Option<f64>,

    /// Whether each polygon is wanted by itself
    #[arg(skip)]
    pub(crate) separate: bool,

    /// How --repair finds the inside: evenodd or nonzero [default: the SVG's own, else evenodd]
    #[arg(long, value_name = "RULE", requires = "repair")]
    pub(crate) fill_rule: Option<FillRule>,

    /// A side of an outline ends where it turns by more than this, in degrees
    #[arg(
        long, value_name = "ANGLE", value_parser = angle, default_value = "30",
        allow_hyphen_values = true
    )]
    pub(crate) corner_angle: f64,
}

/// The names of a side and of the one that it matches.
fn matched(text: &str) -> Result<(String, String), String> {
    match text.split_once('=') {
        Some((side, of)) if !side.trim().is_empty() && !of.trim().is_empty() => {
            Ok((side.trim().to_owned(), of.trim().to_owned()))
        }
        _ => {
            Err("write the names of two sides, such as right=left or \"side 2=side 4\"".to_owned())
        }
    }
}

fn spacing(text: &str) -> Result<Spacing, String> {
    let laws = [
        ("geometric", "a ratio", "geometric:1.2"),
        ("bump", "a ratio", "bump:0.2"),
        ("beta", "a number", "beta:1.05"),
        ("first-length", "a length", "first-length:0.01"),
        ("last-length", "a length", "last-length:0.01"),
    ];
    text.parse().map_err(|_| {
        let law = text.split([':', '=', ' ']).next().unwrap_or_default();
        match laws.into_iter().find(|&(name, ..)| name == law) {
            Some((name, what, example)) => format!("{name} takes {what}, such as {example}"),
            None => "write uniform, geometric:RATIO, bump:RATIO, beta:BETA, first-length:LENGTH \
                     or last-length:LENGTH; explicit parameters need a domain file"
                .to_owned(),
        }
    })
}
