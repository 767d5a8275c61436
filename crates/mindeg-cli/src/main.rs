//! The command line: raw arguments, then a validated job, then a run.
//!
//! Paths, standard streams and exit codes live in this crate; everything it computes is in the
//! libraries below it.

mod args;
mod bar;
mod compare;
mod convert;
mod degree;
mod domain;
mod failure;
mod gates;
mod inspect;
mod interrupt;
mod mesh;
mod mesh_file;
mod output;
mod standard_output;
mod suggest;
mod targets;
mod tradeoff;

use args::{Arguments, Command};
use clap::Parser;
use failure::Failure;
use rayon::{ThreadPool, ThreadPoolBuildError, ThreadPoolBuilder};
use std::process::ExitCode;

fn main() -> ExitCode {
    let result = match &Arguments::parse().command {
        Command::Degree(arguments) => degree::run(arguments),
        Command::Suggest(arguments) => suggest::run(arguments),
        Command::Inspect(arguments) => shared(|| inspect::run(arguments)),
        Command::Convert(arguments) => shared(|| convert::run(arguments)),
        Command::Mesh(arguments) => shared(|| mesh::run(arguments)),
        Command::Tradeoff(arguments) => shared(|| tradeoff::run(arguments)),
        Command::Compare(arguments) => shared(|| compare::run(arguments)),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.report(),
    }
}

/// Does work that is shared by all threads.
fn shared(work: impl FnOnce() -> Result<(), Failure> + Send) -> Result<(), Failure> {
    let failed = |error| Failure::Io(format!("cannot start threads: {error}"));
    threads().map_err(failed)?.install(work)
}

/// The threads that share work: as many as there are cores, or this one alone where the system
/// allows no more. Not rayon's own, which are started when first needed, or panic.
fn threads() -> Result<ThreadPool, ThreadPoolBuildError> {
    // As large as that of a main thread.
    let builder = || ThreadPoolBuilder::new().stack_size(8 << 20);
    builder().build().or_else(|_| builder().num_threads(1).use_current_thread().build())
}
