//! `mindeg` meshes polygons, maps, models and surfaces whose boundary must stay: for a solver with points inside and large
//! angles, for a patch from its own points with few edges at a vertex. It proves how good such meshes can be, and reads and
//! writes the files of other programs.
//!
//! ```sh
//! cargo install mindeg-cli
//! mindeg mesh --rectangle 4x3 --size 0.5 --interior -o plate.obj -o plate.svg
//! ```
//!
//! Raw arguments, then a validated job, then a run. Paths, standard streams and exit codes live in this crate; everything
//! it computes is in the libraries below it.

mod args;
mod bar;
mod boundary_loops;
mod bridge;
mod browser;
mod compare;
mod completions;
mod condition;
mod convert;
mod degree;
mod demands;
mod domain;
#[cfg(feature = "explore")]
mod explore;
mod failure;
mod fill;
mod formats;
mod improve;
mod inspect;
mod interrupt;
mod making;
mod man;
mod mesh;
mod named_files;
#[cfg(not(feature = "explore"))]
mod no_explore;
mod provenance;
mod remesh;
mod schema;
mod slips;
mod standard_output;
mod stitch;
mod suggest;
mod terminal;
mod threads;
mod tradeoff;
mod unused;
mod verify;
mod version;
mod view;

use args::{Arguments, Command};
use clap::FromArgMatches;
use clap::error::ErrorKind;
use failure::Failure;
use std::borrow::Cow;
use std::env;
use std::ffi::OsString;
use std::io::{self, Write};
use std::process::ExitCode;
use terminal::safe;
use threads::shared;

fn main() -> ExitCode {
    let words: Vec<OsString> = env::args_os().collect();
    let color = terminal::color_choice(&words);
    terminal::set_color(color);
    let asks = |for_help: &[&str]| words.iter().any(|word| for_help.iter().any(|it| word == it));
    let command = match () {
        () if asks(&["-h"]) => Arguments::short(),
        () if asks(&["--help", "help"]) => Arguments::long(&words),
        () => Arguments::whole(),
    };
    let matches = command.color(color).try_get_matches_from(&words);
    let mut arguments = match matches.and_then(|matches| Arguments::from_arg_matches(&matches)) {
        Ok(arguments) => arguments,
        Err(error) => return without_a_run(&error, &words),
    };
    if let Command::Mesh(mesh) = &mut arguments.command {
        mesh.domain.options.outline.separate = !mesh::is_one_mesh(mesh);
    }
    match run(&arguments.command) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.report(),
    }
}

fn run(command: &Command) -> Result<(), Failure> {
    match command {
        Command::Degree(arguments) => shared(|| degree::run(arguments)),
        Command::Suggest(arguments) => shared(|| suggest::run(arguments)),
        Command::Formats(_) => formats::run(),
        Command::Schema(arguments) => schema::run(arguments),
        Command::Completions(arguments) => completions::run(arguments),
        Command::Man(arguments) => man::run(arguments),
        Command::Inspect(arguments) => shared(|| inspect::run(arguments)),
        Command::Convert(arguments) => shared(|| convert::run(arguments)),
        Command::Condition(arguments) => shared(|| condition::run(arguments)),
        Command::Domain(arguments) => shared(|| domain::describe::run(arguments)),
        Command::Improve(arguments) => shared(|| improve::run(arguments)),
        Command::Remesh(arguments) => shared(|| remesh::run(arguments)),
        Command::Fill(arguments) => shared(|| fill::run(arguments)),
        Command::Bridge(arguments) => shared(|| bridge::run(arguments)),
        Command::Stitch(arguments) => shared(|| stitch::run(arguments)),
        Command::Mesh(arguments) => shared(|| mesh::run(arguments)),
        Command::Tradeoff(arguments) => shared(|| tradeoff::run(arguments)),
        Command::Compare(arguments) => shared(|| compare::run(arguments)),
        #[cfg(feature = "explore")]
        Command::Explore(arguments) => explore::run(arguments),
        #[cfg(not(feature = "explore"))]
        Command::Explore(arguments) => no_explore::run(arguments),
        Command::Verify(arguments) => shared(|| verify::run(arguments)),
        Command::View(arguments) => shared(|| view::run(arguments)),
    }
}

/// Prints the help or the version that was asked for, or what is wrong with the arguments.
fn without_a_run(error: &clap::Error, words: &[OsString]) -> ExitCode {
    if error.kind() == ErrorKind::DisplayVersion && words.iter().any(|word| word == "--verbose") {
        return match standard_output::print(&version::verbose()) {
            Ok(()) => ExitCode::SUCCESS,
            Err(failure) => failure.report(),
        };
    }
    if let Some(message) = slips::guess(error, words) {
        return Failure::Input(message).report();
    }
    let steers = |word: &OsString| matches!(safe(&word.to_string_lossy()), Cow::Owned(_));
    let printed = if error.use_stderr() && words.iter().any(steers) {
        // Without colors, which are escapes as those in a name are.
        writeln!(io::stderr(), "{}", safe(&error.render().to_string()))
    } else {
        error.print()
    };
    match printed.and_then(|()| io::stdout().flush()) {
        Err(failed) if !error.use_stderr() => Failure::from_standard_output(&failed).report(),
        _ => ExitCode::from(if error.use_stderr() { 2 } else { 0 }),
    }
}
