//! `mindeg explore`: a page to edit a boundary on.

use crate::args::{DomainArguments, ExploreArguments};
use crate::bar::Bar;
use crate::browser::open;
use crate::domain::subject;
use crate::failure::Failure;
use crate::interrupt::{SESSION, clean_up_on_interrupt};
use crate::provenance::domain_words;
use crate::standard_output::print;
use crate::terminal::say;
use mindeg_explore::{KnownFiles, REPAIRED, Server, ServerError, Setup, Source, presets, sources};
use mindeg_files::{Input, Wanted};
use std::fs;
use std::path::Path;

pub(crate) fn run(arguments: &ExploreArguments) -> Result<(), Failure> {
    let mut known = KnownFiles::default();
    let start = start(&arguments.domain, &mut known)?;
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
fn start(arguments: &DomainArguments, known: &mut KnownFiles) -> Result<Option<Source>, Failure> {
    let file = arguments.file.as_deref();
    let words = domain_words(file);
    let source = match file {
        None if words.is_empty() => return Ok(None),
        // Without options, rings that cross are repaired, too.
        Some(file) if words.len() == 1 => of_file(file, &words, known)?,
        _ => {
            let mut domains = subject(arguments, Wanted::Domain, &Bar::new(true))?.parts()?.domains;
            let count = domains.len();
            let mut source = Source::of(&domains.remove(0));
            if let (1, Some(domain)) = (count, &source.domain) {
                known.add(&words, domain.get());
            }
            tell_of_others(&mut source, count);
            source
        }
    };
    match source.message {
        Some(problem) => Err(Failure::Input(format!("{}: {problem}", source.name))),
        None => Ok(Some(source)),
    }
}

/// The first domain of a file.
fn of_file(path: &Path, words: &[String], known: &mut KnownFiles) -> Result<Source, Failure> {
    let input = Input::of(path);
    let name = input.name();
    let sources = sources(&SESSION, &input)?;
    let count = sources.len();
    let problem = sources.first().and_then(|source| source.message.clone());
    let Some(mut source) = sources.into_iter().find(|source| source.domain.is_some()) else {
        let problem = problem.unwrap_or_else(|| "it holds no polygon".to_owned());
        return Err(Failure::Input(format!("{name}: {problem}")));
    };
    if let (Ok(text), Input::File(_)) = (fs::read_to_string(path), input) {
        known.add(words, &text);
        let is_as_it_was = source.notes.first().is_none_or(|note| note != REPAIRED);
        if let (1, true, Some(domain)) = (count, is_as_it_was, &source.domain) {
            known.add(words, domain.get());
        }
    }
    tell_of_others(&mut source, count);
    Ok(source)
}

fn tell_of_others(source: &mut Source, count: usize) {
    if count > 1 {
        source.notes.push(format!("The file has {count} domains; {} is shown.", source.name));
    }
}

/// The files of the presets, where they are: in a folder with mindeg's sources.
fn add_presets(known: &mut KnownFiles) {
    for preset in presets() {
        let path = format!("assets/domains/{}.json", preset.name);
        if let Ok(text) = fs::read_to_string(&path) {
            known.add(&[path], &text);
        }
    }
}
