//! Options that would do nothing for what they are given with: all are refused here.

use crate::args::Arguments;
use crate::failure::Failure;
use Taken::{Corners, Counts, Domain, FromMesh, Model, Polygons};
use clap::ArgMatches;
use clap::parser::ValueSource;
use mindeg_files::ProjectionChoice;
use std::env::args_os;

/// What a command has been given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Taken {
    /// Interval counts alone.
    Counts,
    /// `--rectangle` or `--corners`.
    Corners,
    /// A domain in JSON.
    Domain,
    /// The polygons of a file of another format.
    Polygons,
    /// A model in JSON.
    Model,
    /// A mesh whose polygons are the faces of a model.
    FromMesh,
}

/// Options that do something for some of these alone.
struct Group {
    /// The commands, all if none is named.
    commands: &'static [&'static str],
    options: &'static [&'static str],
    takers: &'static [Taken],
    /// What they are for.
    purpose: &'static str,
}

const GROUPS: [Group; 8] = [
    Group {
        commands: &[],
        options: &[
            "feature",
            "layer",
            "name_by",
            "sea_in",
            "project",
            "size_of",
            "snap",
            "fill_rule",
            "corner_angle",
        ],
        takers: &[Polygons],
        purpose: "outlines such as GeoJSON or SVG",
    },
    Group {
        commands: &[],
        options: &["repair", "separate"],
        takers: &[Domain, Polygons],
        purpose: "outlines and domains in the plane",
    },
    Group {
        commands: &[],
        options: &["periodic"],
        takers: &[Corners, Domain, Polygons],
        purpose: "the sides of a domain in the plane",
    },
    Group {
        commands: &["mesh"],
        options: &[
            "open",
            "open_between",
            "least_opening",
            "depth",
            "elevation",
            "least_depth",
            "wavelength",
            "slope",
            "time_step",
            "sizes",
        ],
        takers: &[Corners, Domain, Polygons],
        purpose: "a domain in the plane",
    },
    Group {
        commands: &["degree"],
        options: &["proof", "boundary_degree"],
        takers: &[Corners, Domain, Polygons],
        purpose: "a domain",
    },
    Group {
        commands: &[],
        options: &["merge_coplanar", "planar_tolerance"],
        takers: &[FromMesh],
        purpose: "models whose faces are the polygons of a mesh, such as OBJ or glTF",
    },
    Group {
        commands: &["mesh"],
        options: &["effort"],
        takers: &[Model, FromMesh],
        purpose: "models",
    },
    Group {
        commands: &["degree", "suggest"],
        options: &["effort"],
        takers: &[Corners, Domain, Polygons, Model, FromMesh],
        purpose: "what is searched, and counts alone have a formula",
    },
];

impl Taken {
    /// Refuses the options of the command line that do nothing for this, which a file of this name has.
    pub(crate) fn refuse_unused(self, name: &str) -> Result<(), Failure> {
        // Arguments that were parsed once are parsed again; a test's are none.
        let Ok(matches) = Arguments::whole().try_get_matches_from(args_os()) else {
            return Ok(());
        };
        let Some((command, given)) = matches.subcommand() else { return Ok(()) };
        for group in GROUPS {
            let is_of = group.commands.is_empty() || group.commands.contains(&command);
            if !is_of || group.takers.contains(&self) {
                continue;
            }
            if let Some(id) = group.options.iter().find(|id| self.is_idle(id, given)) {
                let (option, purpose) = (id.replace('_', "-"), group.purpose);
                let taken = match self {
                    Counts => "these are interval counts alone".to_owned(),
                    Corners => "--rectangle and --corners are a domain".to_owned(),
                    Domain => format!("{name} is a domain in JSON"),
                    Polygons => format!("{name} has outlines"),
                    Model => format!("{name} is a model in JSON"),
                    FromMesh => format!("{name} is a model"),
                };
                return Err(Failure::Input(format!("--{option} is for {purpose}; {taken}")));
            }
        }
        Ok(())
    }

    /// Whether an option was typed, and has no other meaning for this.
    fn is_idle(self, id: &str, given: &ArgMatches) -> bool {
        let is_typed = given.try_contains_id(id).is_ok()
            && given.value_source(id) == Some(ValueSource::CommandLine);
        // A domain in JSON can remember a projection, which `none` takes from it.
        let is_none = self == Domain
            && given
                .try_get_one::<ProjectionChoice>(id)
                .is_ok_and(|choice| choice == Some(&ProjectionChoice::None));
        is_typed && !is_none
    }
}
