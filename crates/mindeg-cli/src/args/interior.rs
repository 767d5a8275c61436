//! Interior points: what a mesh is to be like inside.

use super::values::{length, target_angle, whole_number};
use clap::{Args, ValueEnum};
use mindeg::{Interior, Prefer};
use std::ops::RangeInclusive;

/// Whether there are interior points, and where.
#[derive(Debug, Args)]
#[command(next_help_heading = "Interior points")]
pub(crate) struct InteriorArguments {
    /// Add points inside: the boundary points stay exactly; sizes grow smoothly from the boundary's;
    /// degrees are 5 to 7 inside and at most 5 at the boundary; the minimum angle comes near its
    /// proven limit. Also on if the domain's file has "interior"
    #[arg(long)]
    pub(crate) interior: bool,

    /// Mesh the boundary points alone, also if the domain's file has "interior"
    #[arg(long, conflicts_with = "interior")]
    pub(crate) no_interior: bool,

    /// How fast the size grows from the boundary: change of size per distance [default: 0.5]
    #[arg(long, value_name = "G", value_parser = growth, allow_hyphen_values = true)]
    pub(crate) growth: Option<f64>,

    /// The size far from the boundary [default: a mean of the boundary's intervals]
    #[arg(long, value_name = "S", value_parser = length, allow_hyphen_values = true)]
    pub(crate) size_inside: Option<f64>,

    #[command(flatten)]
    pub(crate) aims: Aims,
}

/// What an optimiser aims at. What is given here is demanded: if it is not reached, nothing is
/// written.
#[derive(Debug, Args)]
#[command(next_help_heading = "Aims")]
pub(crate) struct Aims {
    /// The degrees of interior vertices, a range around 6 such as 5..7 [default: 5..7]
    #[arg(long, value_name = "A..B", value_parser = degrees, allow_hyphen_values = true)]
    pub(crate) interior_degree: Option<RangeInclusive<u32>>,

    /// The most edges of a boundary vertex; at a reflex corner 2 + round(angle / 60°), if that is
    /// more [default: 5]
    #[arg(long, value_name = "D", value_parser = whole_number, allow_hyphen_values = true)]
    pub(crate) boundary_degree: Option<u32>,

    /// The minimum angle in degrees. With interior points the default is as much as the boundary allows,
    /// up to about 35; without, it is demanded of the mesh, not aimed at
    #[arg(long, value_name = "A", value_parser = target_angle, allow_hyphen_values = true)]
    pub(crate) target_angle: Option<f64>,

    /// Which aim wins where one costs the other [default: degree]
    #[arg(long, value_name = "WHAT")]
    pub(crate) prefer: Option<Preference>,

    /// Write the mesh also if it is not what was demanded; the exit code is 3 all the same
    #[arg(long)]
    pub(crate) write_anyway: bool,
}

/// Which aim wins.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Preference {
    /// Degrees within their limits
    Degree,
    /// The minimum angle, at any degree
    Angle,
}

impl InteriorArguments {
    /// The first option here that has no meaning without interior points.
    pub(crate) fn first_given(&self) -> Option<&'static str> {
        let given = [
            ("--growth", self.growth.is_some()),
            ("--size-inside", self.size_inside.is_some()),
            ("--interior-degree", self.aims.interior_degree.is_some()),
            ("--boundary-degree", self.aims.boundary_degree.is_some()),
            ("--prefer", self.aims.prefer.is_some()),
        ];
        given.into_iter().find(|(_, is_given)| *is_given).map(|(name, _)| name)
    }

    /// What is wanted, with what the options give in place of what a file gives.
    pub(crate) fn over(&self, file: Option<&Interior>) -> Interior {
        let file = file.cloned().unwrap_or_default();
        let wanted = Interior {
            growth: self.growth.or(file.growth),
            size_inside: self.size_inside.or(file.size_inside),
            ..file
        };
        self.aims.over(wanted)
    }
}

impl Aims {
    /// What is wanted, with what the options give in its place.
    pub(crate) fn over(&self, wanted: Interior) -> Interior {
        let prefer = self.prefer.map(|prefer| match prefer {
            Preference::Degree => Prefer::Degree,
            Preference::Angle => Prefer::Angle,
        });
        Interior {
            interior_degree: self.interior_degree.clone().or(wanted.interior_degree),
            boundary_degree: self.boundary_degree.or(wanted.boundary_degree),
            target_angle: self.target_angle.or(wanted.target_angle),
            prefer: prefer.or(wanted.prefer),
            ..wanted
        }
    }
}

fn growth(text: &str) -> Result<f64, String> {
    let growth = text.trim().parse().ok().filter(|growth: &f64| *growth > 0.0);
    growth
        .filter(|growth| growth.is_finite())
        .ok_or_else(|| "give a number above 0, such as 0.3; less grows slower".to_owned())
}

fn degrees(text: &str) -> Result<RangeInclusive<u32>, String> {
    let ends = text.split_once("..").or_else(|| text.split_once('-'));
    let range = ends.and_then(|(least, greatest)| {
        let greatest = greatest.strip_prefix('=').unwrap_or(greatest);
        Some(least.trim().parse().ok()?..=greatest.trim().parse().ok()?)
    });
    range.ok_or_else(|| "give the least and the greatest degree, such as 5..7".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_of_degrees_are_read() {
        for text in ["5..7", "5..=7", "5-7", " 5 .. 7 "] {
            assert_eq!(degrees(text), Ok(5..=7), "{text}");
        }
        for text in ["", "5", "5..", "a..b", "5,7", "-1..7"] {
            assert!(degrees(text).is_err(), "{text}");
        }
    }

    #[test]
    fn growths_are_read() {
        assert_eq!(growth("0.3"), Ok(0.3));
        for text in ["0", "-0.5", "nan", "inf", "x"] {
            assert!(growth(text).is_err(), "{text}");
        }
    }
}
