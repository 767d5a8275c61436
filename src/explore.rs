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
use mindeg::Domain;
use mindeg_explore::{
    KnownFiles, MAX_BYTES, REPAIRED, Repair, Server, ServerError, Setup, Source, least_repaired,
    presets, sources,
};
use mindeg_files::{Input, Wanted};
use std::fs;
use std::path::Path;

pub(crate) fn run(arguments: &ExploreArguments) -> Result<(), Failure> {
    let mut known = KnownFiles::default();
    let start = start(&arguments.domain, &mut known)?;
    let surface = match &start {
        Some(source) if source.is_solid => surface(&arguments.domain)?,
        _ => Vec::new(),
    };
    add_presets(&mut known);
    clean_up_on_interrupt()?;
    let purpose = arguments.purpose.purpose;
    let setup = Setup { port: arguments.port.unwrap_or(0), start, surface, known, purpose };
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
            let (mut domains, repair) = domains(arguments)?;
            let count = domains.len();
            let mut source = Source::of(&domains.remove(0));
            if repair != Repair::None {
                source.notes.insert(0, REPAIRED.to_owned());
            }
            let more = (repair == Repair::Alone).then(|| "--repair".to_owned());
            let words: Vec<String> = words.into_iter().chain(more).collect();
            // Together, not every mesh of the command line is repaired.
            if let (1, true, Some(domain)) = (count, repair != Repair::Together, &source.domain) {
                known.add(&words, domain.get());
            }
            tell_of_others(&mut source, count);
            source
        }
    };
    match &source.message {
        Some(_) if source.is_solid => Ok(Some(source)),
        Some(problem) => Err(Failure::Input(format!("{}: {problem}", source.name))),
        None => Ok(Some(source)),
    }
}

/// The domains that the arguments describe, repaired where they are none otherwise.
fn domains(arguments: &DomainArguments) -> Result<(Vec<Domain>, Repair), Failure> {
    let read = |repair: Repair| {
        let mut arguments = arguments.clone();
        let outline = &mut arguments.options.outline;
        outline.repair |= repair != Repair::None;
        outline.together = repair == Repair::Together;
        Ok(subject(&arguments, Wanted::Domain, &Bar::new(true))?.parts()?.domains)
    };
    if arguments.file.is_none() {
        return Ok((read(Repair::None)?, Repair::None));
    }
    least_repaired(read, |_| 0)
}

/// The bytes of the file of a surface, unless they are too many for the page.
fn surface(arguments: &DomainArguments) -> Result<Vec<u8>, Failure> {
    let Some(path) = &arguments.file else { return Ok(Vec::new()) };
    let bytes = fs::read(path)
        .map_err(|error| Failure::Io(format!("cannot read {}: {error}", path.display())))?;
    if bytes.len() > MAX_BYTES {
        return Err(Failure::Input(format!(
            "{} has {} MB; the page takes {}; mindeg view shows any surface",
            path.display(),
            bytes.len().div_ceil(1 << 20),
            MAX_BYTES >> 20
        )));
    }
    Ok(bytes)
}

/// The first domain of a file, or the surface in it.
fn of_file(path: &Path, words: &[String], known: &mut KnownFiles) -> Result<Source, Failure> {
    let input = Input::of(path);
    let name = input.name();
    let mut sources = sources(&SESSION, &input)?;
    let count = sources.len();
    if let Some(at) = sources.iter().position(|source| source.is_solid) {
        // The page asks for it under the name of the file alone.
        let name = path.file_name().map_or(name, |name| name.to_string_lossy().into_owned());
        return Ok(Source { name, ..sources.swap_remove(at) });
    }
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
