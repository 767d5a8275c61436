//! The command line: raw arguments, then a validated job, then a run.
//!
//! Paths, standard streams and exit codes live in this crate; everything it computes is in the
//! libraries below it.

mod args;
mod bar;
mod compare;
mod degree;
mod domain;
mod failure;
mod gates;
mod inspect;
mod interrupt;
mod mesh;
mod output;
mod room;
mod standard_output;
mod suggest;
mod tradeoff;
mod watched;

use args::{Arguments, Command};
use clap::Parser;
use std::process::ExitCode;

fn main() -> ExitCode {
    let result = match Arguments::parse().command {
        Command::Degree(arguments) => degree::run(&arguments),
        Command::Inspect(arguments) => inspect::run(&arguments),
        Command::Mesh(arguments) => mesh::run(&arguments),
        Command::Tradeoff(arguments) => tradeoff::run(&arguments),
        Command::Compare(arguments) => compare::run(&arguments),
        Command::Suggest(arguments) => suggest::run(&arguments),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.report(),
    }
}
