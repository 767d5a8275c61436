//! The arguments as they are typed: one file of them a command.

mod bridge;
mod compare;
mod condition;
mod convert;
mod degree;
mod demands;
mod describe;
mod domain;
mod explore;
mod fill;
mod first_screen;
mod goal;
mod improve;
mod inspect;
mod interior;
mod loop_choice;
mod mesh;
mod ocean;
mod purpose;
mod remesh;
mod stitch;
mod surface;
mod tolerance;
mod tradeoff;
mod values;
mod verify;
mod view;

pub(crate) use bridge::BridgeArguments;
pub(crate) use compare::{CompareArguments, ReportFormat};
pub(crate) use condition::{ChangeArguments, ConditionArguments};
pub(crate) use convert::ConvertArguments;
pub(crate) use degree::{Counts, CountsArguments, DegreeArguments, SuggestArguments};
pub(crate) use describe::DescribeArguments;
pub(crate) use domain::{DomainArguments, DomainOptions, OutlineOptions};
pub(crate) use explore::ExploreArguments;
pub(crate) use fill::FillArguments;
pub(crate) use improve::ImproveArguments;
pub(crate) use inspect::InspectArguments;
pub(crate) use interior::with_sizes_of;
pub(crate) use loop_choice::LoopChoice;
pub(crate) use mesh::{MeshArguments, ModelArguments};
pub(crate) use ocean::Told;
pub(crate) use remesh::RemeshArguments;
pub(crate) use stitch::StitchArguments;
pub(crate) use surface::SurfaceArguments;
pub(crate) use tolerance::Tolerance;
pub(crate) use tradeoff::TradeoffArguments;
pub(crate) use values::Length;
pub(crate) use values::point;
pub(crate) use verify::VerifyArguments;
pub(crate) use view::ViewArguments;

use clap::{Args, ColorChoice, Parser, Subcommand};
use clap_complete::Shell;
use std::ffi::OsString;

/// The same for each command; `mindeg --help` has more words.
const SHORT_EXIT_CODES: &str =
    "Exit codes: 0 done, 1 a file failed, 2 bad input, 3 not what was demanded";

const EXIT_CODES: &str = "\
Exit codes:
  0  success (also when the reader of standard output stops early)
  1  something could not be read or written, or does not fit where it goes
  2  bad input: wrong usage, a domain that cannot be meshed, a broken file
  3  a mesh is not what was demanded of it, or does not pass mindeg verify";

/// Examples of a command, and the exit codes in a line, for `--help`.
fn with_exit_codes(examples: &str) -> String {
    format!("{examples}\n\n{SHORT_EXIT_CODES}")
}

const EXAMPLES: &str = "\
Examples:
  mindeg degree 12,9,4,4
  mindeg mesh --rectangle 4x3 --size 0.5 -o plate.obj
  mindeg mesh assets/domains/plate-with-holes.json --interior -o inside.vtu
  mindeg compare assets/domains/wing-panel.json -o wing-panel.html
  mindeg inspect plate.obj";

/// Mesh polygons, maps, models and surfaces whose boundary must stay: for a solver with points inside
/// and large angles, for a patch from its own points with few edges at a vertex; limits are proven.
#[derive(Debug, Parser)]
#[command(name = "mindeg", version, max_term_width = 100)]
#[command(after_help = EXAMPLES, after_long_help = format!("{EXAMPLES}\n\n{EXIT_CODES}"))]
pub(crate) struct Arguments {
    #[command(subcommand)]
    pub(crate) command: Command,

    /// Color messages and help: always, never or auto, on a terminal unless NO_COLOR is set
    #[arg(
        hide_possible_values = true,
        hide_default_value = true,
        long,
        value_name = "WHEN",
        default_value = "auto",
        global = true,
        hide_short_help = true,
        help_heading = "Messages"
    )]
    pub(crate) color: ColorChoice,

    /// With --version: also the commit, the features, the target and the Rust of this build
    #[arg(long, requires = "version", hide_short_help = true, help_heading = "Messages")]
    pub(crate) verbose: bool,
}

impl Command {
    /// The files of the mesh, for a command that makes one.
    pub(crate) fn surface(&self) -> Option<&SurfaceArguments> {
        match self {
            Self::Mesh(arguments) => Some(&arguments.surface),
            Self::Improve(arguments) => Some(&arguments.surface),
            Self::Remesh(arguments) => Some(&arguments.surface),
            Self::Convert(arguments) => Some(&arguments.surface),
            Self::Fill(arguments) => Some(&arguments.surface),
            Self::Bridge(arguments) => Some(&arguments.surface),
            Self::Stitch(arguments) => Some(&arguments.surface),
            _ => None,
        }
    }
}

impl Arguments {
    /// The command line.
    pub(crate) fn whole() -> clap::Command {
        <Self as clap::CommandFactory>::command()
    }

    /// The same command line, for those who ask by these words for all help of a command.
    pub(crate) fn long(words: &[OsString]) -> clap::Command {
        let whole = Self::whole();
        let names = whole.get_subcommands().map(|command| command.get_name().to_owned());
        let asked: Vec<String> =
            names.filter(|name| words.iter().any(|word| word == name.as_str())).collect();
        asked
            .into_iter()
            .fold(whole, |whole, name| whole.mut_subcommand(&name, first_screen::complete))
    }

    /// The same command line, for those who ask for help by `-h`.
    pub(crate) fn short() -> clap::Command {
        first_screen::shortened(Self::whole())
    }
}

/// The commands, in the order in which people need them.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    Mesh(Box<MeshArguments>),
    Degree(DegreeArguments),
    Tradeoff(TradeoffArguments),
    Compare(CompareArguments),
    Suggest(SuggestArguments),
    Domain(DescribeArguments),
    Condition(ConditionArguments),
    Inspect(InspectArguments),
    Verify(VerifyArguments),
    Improve(ImproveArguments),
    Remesh(RemeshArguments),
    Fill(FillArguments),
    Bridge(BridgeArguments),
    Stitch(StitchArguments),
    View(ViewArguments),
    Explore(ExploreArguments),
    Convert(ConvertArguments),
    Formats(FormatsArguments),
    Schema(SchemaArguments),
    Completions(CompletionsArguments),
    Man(ManArguments),
}

const FORMATS: &str = "\
Examples:
  mindeg formats
  mindeg formats | grep -i gmsh";

/// List the formats of files, and the programs whose rules --preset checks
#[derive(Debug, Args)]
#[command(after_help = FORMATS)]
pub(crate) struct FormatsArguments {}

const SCHEMA: &str = "\
Examples:
  mindeg schema > domain.schema.json
  mindeg schema --model > model.schema.json";

/// Print the JSON Schema of a domain, by which editors complete and check its keys
#[derive(Debug, Args)]
#[command(after_help = SCHEMA)]
pub(crate) struct SchemaArguments {
    /// The schema of a model, planar faces in space, instead
    #[arg(long)]
    pub(crate) model: bool,
}

const COMPLETIONS: &str = "\
Examples:
  mindeg completions bash > ~/.local/share/bash-completion/completions/mindeg
  mindeg completions zsh > ~/.zfunc/_mindeg
  mindeg completions fish > ~/.config/fish/completions/mindeg.fish";

/// Print a script that completes mindeg's commands and options in a shell
#[derive(Debug, Args)]
#[command(after_help = COMPLETIONS)]
pub(crate) struct CompletionsArguments {
    /// The shell
    #[arg(value_name = "SHELL")]
    pub(crate) shell: Shell,
}

const MAN: &str = "\
Examples:
  mindeg man > ~/.local/share/man/man1/mindeg.1
  mindeg man mesh | man -l -";

/// Print a page for man, of mindeg or of one of its commands
#[derive(Debug, Args)]
#[command(after_help = MAN)]
pub(crate) struct ManArguments {
    /// The command; mindeg itself without one
    #[arg(value_name = "COMMAND")]
    pub(crate) command: Option<String>,
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn the_arguments_are_well_formed() {
        Arguments::command().debug_assert();
    }

    /// No terminal of 80 columns breaks a line that is broken by hand.
    #[test]
    fn exit_codes_fit_a_terminal() {
        assert!(EXIT_CODES.lines().all(|line| line.len() <= 76), "{EXIT_CODES}");
    }

    #[test]
    fn every_command_has_examples() {
        for command in Arguments::command().get_subcommands() {
            let help = command.get_after_help().expect("a text").to_string();
            assert!(help.contains(&format!("mindeg {}", command.get_name())), "{help}");
        }
    }
}
