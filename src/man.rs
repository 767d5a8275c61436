//! `mindeg man`: a page for man.

use crate::args::{Arguments, ManArguments};
use crate::failure::Failure;
use crate::standard_output::print;
use clap_mangen::Man;

pub(crate) fn run(arguments: &ManArguments) -> Result<(), Failure> {
    let mut program = Arguments::whole();
    // Gives each command its whole name.
    program.build();
    let page = match &arguments.command {
        None => program,
        Some(name) => {
            let found = program.find_subcommand(name).cloned();
            let found = found.ok_or_else(|| {
                Failure::Input(format!("no command is named {name}; mindeg --help lists all"))
            })?;
            found.name(format!("mindeg-{name}"))
        }
    };
    let mut text = Vec::new();
    let page = Man::new(page).source(concat!("mindeg ", env!("CARGO_PKG_VERSION")));
    page.render(&mut text)
        .map_err(|error| Failure::Io(format!("cannot make the page: {error}")))?;
    print(&String::from_utf8_lossy(&text))
}
