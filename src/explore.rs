//! `mindeg explore`: a page to edit a boundary on.

use crate::args::ExploreArguments;
use crate::browser::open;
use crate::failure::Failure;
use crate::interrupt::{SESSION, clean_up_on_interrupt};
use crate::standard_output::print;
use crate::terminal::say;
use mindeg_explore::{KnownFiles, Server, ServerError, Setup, Source, presets, sources};
use mindeg_files::Input;
use std::fs;
use std::path::Path;

pub(crate) fn run(arguments: &ExploreArguments) -> Result<(), Failure> {
    let mut known = KnownFiles::default();
    let start = arguments.domain.as_deref().map(|path| start(path, &mut known)).transpose()?;
    add_presets(&mut known);
    clean_up_on_interrupt()?;
    let purpose = arguments.purpose.purpose;
    let setup = Setup { port: arguments.port.unwrap_or(0), start, known, purpose };
    let failed = |error: ServerError| Failure::Io(error.to_string());
    let server = Server::new(setup).map_err(failed)?;
    let address = server.address();
    print(&format!("{address}\n"))?;
    if !arguments.no_open && !open(&address) {
        say("No browser was found; open the address yourself.");
    }
    say("Ctrl-C ends it.");
    match server.run().map_err(failed)? {}
}

/// The domain of the command line, or the first of its file.
fn start(path: &Path, known: &mut KnownFiles) -> Result<Source, Failure> {
    let input = Input::of(path);
    let name = input.name();
    let sources = sources(&SESSION, &input)?;
    let count = sources.len();
    let problem = sources.first().and_then(|source| source.message.clone());
    let Some(mut source) = sources.into_iter().find(|source| source.domain.is_some()) else {
        let problem = problem.unwrap_or_else(|| "it holds no polygon".to_owned());
        return Err(Failure::Input(format!("{name}: {problem}")));
    };
    if count > 1 {
        source.notes.push(format!("{name} has {count} domains; {} is shown.", source.name));
    }
    if let (Ok(text), Input::File(_)) = (fs::read_to_string(path), input) {
        known.add(&name, &text);
    }
    Ok(source)
}

/// The files of the presets, where they are: in a folder with mindeg's sources.
fn add_presets(known: &mut KnownFiles) {
    for preset in presets() {
        let path = format!("assets/domains/{}.json", preset.name);
        if let Ok(text) = fs::read_to_string(&path) {
            known.add(&path, &text);
        }
    }
}
