//! `mindeg completions`: a script for a shell.

use crate::args::{Arguments, CompletionsArguments};
use crate::failure::Failure;
use crate::standard_output::print;

pub(crate) fn run(arguments: &CompletionsArguments) -> Result<(), Failure> {
    let mut script = Vec::new();
    clap_complete::generate(arguments.shell, &mut Arguments::whole(), "mindeg", &mut script);
    print(&String::from_utf8_lossy(&script))
}
