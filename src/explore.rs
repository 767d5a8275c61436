//! `mindeg explore`: a page to edit a boundary on.

use crate::args::{DomainArguments, ExploreArguments, Length};
use crate::bar::Bar;
use crate::browser::open;
use crate::domain::subject;
use crate::failure::Failure;
use crate::interrupt::{SESSION, clean_up_on_interrupt};
use crate::provenance::domain_words;
use crate::standard_output::print;
use crate::terminal::say;
use mindeg::Domain;
use mindeg_answers::names::{part_name, shown};
use mindeg_explore::{
    Divide, KnownFiles, MAX_BYTES, REPAIRED, Server, ServerError, Setup, Source, presets,
    repaired_if_refused, sources,
};
use mindeg_files::{Input, Wanted};
use std::ffi::OsStr;
use std::fs;
use std::path::Path;

pub(crate) fn run(arguments: &ExploreArguments) -> Result<(), Failure> {
    let mut known = KnownFiles::default();
    let (start, choices) = start(&arguments.domain, &mut known)?;
    let offer = offer(start.as_ref(), &choices);
    let surface = match &start {
        Some(source) if source.is_solid => surface(&arguments.domain)?,
        _ => Vec::new(),
    };
    add_presets(&mut known);
    clean_up_on_interrupt()?;
    let purpose = arguments.purpose.purpose;
    let port = arguments.port.unwrap_or(0);
    let divide = divider(&arguments.domain);
    let setup = Setup { port, start, choices, divide: Some(divide), surface, known, purpose };
    let failed = |error: ServerError| Failure::Io(error.to_string());
    let server = Server::new(setup).map_err(failed)?;
    let address = server.address();
    print(&format!("{address}\n"))?;
    if !arguments.no_open && !open(&address) {
        say("No browser was found; open the address yourself.");
    }
    offer.iter().for_each(|offer| say(offer));
    say("Ctrl-C ends it.");
    match server.run().map_err(failed)? {}
}

/// What else a file of several polygons has, and how to choose; the page offers them by name.
fn offer(start: Option<&Source>, choices: &[Source]) -> Option<String> {
    let others = choices.len().checked_sub(1)?;
    let start = start?;
    Some(format!(
        "The page begins with {} and offers {others} more of the file by name; --feature chooses one here.",
        shown(&start.name)
    ))
}

/// The domain of the command line, or the first of its file; then all, if there are several.
fn start(
    arguments: &DomainArguments,
    known: &mut KnownFiles,
) -> Result<(Option<Source>, Vec<Source>), Failure> {
    let file = arguments.file.as_deref();
    let words = domain_words(file);
    let (source, choices) = match file {
        None if words.is_empty() => return Ok((None, Vec::new())),
        // Without options, rings that cross are repaired, too.
        Some(file) if words.len() == 1 => {
            let size = arguments.options.size.map(|size| size.value);
            of_file(file, &words, size, known)?
        }
        _ => {
            let (domains, is_repaired) = domains(arguments)?;
            let several = domains.len() > 1;
            let source = |(part, domain): (usize, &Domain)| {
                let called = part_name(part, domain);
                let called = (several && domain.name().is_none()).then_some(called);
                let named = called.and_then(|called| domain.clone().named(called).ok());
                let mut source = Source::of(named.as_ref().unwrap_or(domain));
                if is_repaired {
                    source.notes.insert(0, REPAIRED.to_owned());
                }
                source
            };
            let mut sources: Vec<Source> = domains.iter().enumerate().map(source).collect();
            let more = is_repaired && !arguments.options.outline.repair;
            let more = more.then(|| "--repair".to_owned());
            let words: Vec<String> = words.into_iter().chain(more).collect();
            if let ([_], Some(domain)) = (&sources[..], &sources[0].domain) {
                known.add(&words, domain.get());
            }
            let first = sources[0].clone();
            let name = file.and_then(Path::file_stem).map_or("map".into(), OsStr::to_string_lossy);
            sources.splice(..0, Source::whole(&name, &words, &domains));
            (first, sources)
        }
    };
    let choices = if choices.len() > 1 { choices } else { Vec::new() };
    match &source.message {
        Some(_) if source.is_solid => Ok((Some(source), Vec::new())),
        Some(problem) => Err(Failure::Input(format!("{}: {problem}", source.name))),
        None => Ok((Some(source), choices)),
    }
}

/// Reads the same anew, with a length for all edges.
fn divider(arguments: &DomainArguments) -> Divide {
    let arguments = arguments.clone();
    Divide::new(move |size| {
        let mut arguments = arguments.clone();
        arguments.options.size = Some(Length { value: size, is_metric: false });
        arguments.options.intervals = None;
        let read = start(&arguments, &mut KnownFiles::default());
        let (first, all) =
            read.map_err(|failure| failure.message().unwrap_or_default().to_owned())?;
        Ok(if all.is_empty() { first.into_iter().collect() } else { all })
    })
}

/// The domains that the arguments describe, repaired where they are none otherwise, and whether they are.
fn domains(arguments: &DomainArguments) -> Result<(Vec<Domain>, bool), Failure> {
    let read = |repair: bool| {
        let mut arguments = arguments.clone();
        arguments.options.outline.repair |= repair;
        Ok(subject(&arguments, Wanted::Domain, &Bar::new(true))?.parts()?.domains)
    };
    if arguments.file.is_none() {
        return Ok((read(false)?, false));
    }
    repaired_if_refused(read, |_| 0)
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

/// The first domain of a file, or the surface in it; then all domains.
fn of_file(
    path: &Path,
    words: &[String],
    size: Option<f64>,
    known: &mut KnownFiles,
) -> Result<(Source, Vec<Source>), Failure> {
    let input = Input::of(path);
    let name = input.name();
    let mut sources = sources(&SESSION, &input, size)?;
    let count = sources.len();
    if let Some(at) = sources.iter().position(|source| source.is_solid) {
        // The page asks for it under the name of the file alone.
        let name = path.file_name().map_or(name, |name| name.to_string_lossy().into_owned());
        known.add_surface(&name, &path.display().to_string());
        return Ok((Source { name, ..sources.swap_remove(at) }, Vec::new()));
    }
    let problem = sources.iter().find_map(|source| source.message.clone());
    sources.retain(|source| source.message.is_none());
    let Some(source) = sources.iter().find(|source| source.domain.is_some()).cloned() else {
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
    Ok((source, sources))
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
