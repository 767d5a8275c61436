//! `mindeg condition`: a boundary that lets a mesh reach an angle.

use crate::args::{ChangeArguments, ConditionArguments, Length, OutlineOptions, Told};
use crate::bar::Bar;
use crate::domain::{Parts, Subject, UNNAMED, describe, name, opened};
use crate::failure::Failure;
use crate::interrupt::clean_up_on_interrupt;
use crate::standard_output::{print, print_json};
use crate::terminal::say;
use mindeg::Domain;
use mindeg::interior::condition_all;
use mindeg_answers::condition::{ConditionAnswer, as_geojson, has_regions};
use mindeg_answers::names::shown;
use mindeg_compare::write_changes_svg;
use mindeg_files::{Wanted, is_standard_output};
use std::path::Path;

pub(crate) fn run(arguments: &ConditionArguments) -> Result<(), Failure> {
    clean_up_on_interrupt()?;
    let bar = Bar::new(arguments.quiet);
    // Rings that touch themselves are changed here, too.
    let mends = Some(arguments.change.room(arguments.size));
    let outline = OutlineOptions { mends, ..arguments.outline.clone() };
    let subject = opened(&arguments.file, &outline, None, Wanted::Domain, &bar)?;
    let size = arguments.size;
    refuse_degrees(&subject, &arguments.change, size)?;
    subject.refuse_degrees([("--min-size", arguments.min_size)])?;
    let Parts { name: of_all, domains } = subject.parts()?;
    // Each part stays one, so this is known before the work.
    if let Some(path) = &arguments.output {
        refuse_output(path, &domains)?;
    }
    let wanted = arguments.wanted(&domains)?;
    let least = wanted.least_triangles();
    let demands = arguments.change.demands(arguments.limit, size, arguments.growth, least);
    let found = bar.waiting("conditioning the boundary", || {
        condition_all(&domains, &wanted, &demands, &arguments.change.keep)
    });
    let (new, conditioned) = found.map_err(|(_, error)| Failure::input(error))?;
    drop(bar);
    // The coast changes as without open water, as in `mesh`: names that this gives hold no point.
    let Told { domains: new, notes, .. } = arguments.kinds.told(&new)?;
    let answer = ConditionAnswer::of(&domains, &new, &conditioned);
    let written = |path| {
        let outlines = if ends_in(path, "geojson") { as_geojson(&new) } else { None };
        let text = outlines.map_or_else(|| new[0].to_json(), |outlines| outlines.to_string());
        (text, path)
    };
    let domain_file = arguments.output.as_deref().map(written);
    let title = match &domains[..] {
        [domain] => name(domain),
        _ => shown(of_all.as_deref().unwrap_or(UNNAMED)),
    };
    let drawn =
        |path| Ok::<_, Failure>((drawn(&answer, &title, [&domains[..], &new], path)?, path));
    let changes_file = arguments.change.changes.as_deref().map(drawn).transpose()?;
    let files: Vec<_> = changes_file.into_iter().chain(domain_file).collect();
    describe::write_texts(&files)?;
    notes.iter().for_each(|note| say(note));
    if files.iter().any(|(_, path)| is_standard_output(path)) {
        return Ok(());
    }
    if arguments.json { print_json(&answer) } else { print(&answer.text(&title)) }
}

/// Refuses a file that does not hold all domains: JSON has one, and GeoJSON no regions between lines.
fn refuse_output(path: &Path, domains: &[Domain]) -> Result<(), Failure> {
    let (shown, parts, has_regions) = (path.display(), domains.len(), has_regions(domains));
    let meshed = "mindeg mesh --interior --condition meshes them, and --feature chooses polygons";
    Err(Failure::Input(if ends_in(path, "geojson") {
        if !has_regions {
            return Ok(());
        }
        let way = if parts == 1 { "-o DOMAIN.json keeps them" } else { meshed };
        format!("{shown}: GeoJSON would lose the regions that lines divide this map into: {way}")
    } else {
        if parts == 1 {
            return Ok(());
        }
        let file = if has_regions { "--changes CHANGES.geojson" } else { "-o COAST.geojson" };
        format!(
            "{shown}: JSON has one domain, and this map has {parts} parts that share no edge, such as islands: {file} has all \
             new boundaries, {meshed}"
        )
    }))
}

fn ends_in(path: &Path, extension: &str) -> bool {
    path.extension().is_some_and(|name| name.eq_ignore_ascii_case(extension))
}

/// The changes as a file shows them: a picture, or GeoJSON.
pub(crate) fn drawn(
    answer: &ConditionAnswer,
    title: &str,
    [old, new]: [&[Domain]; 2],
    path: &Path,
) -> Result<String, Failure> {
    if !ends_in(path, "svg") {
        return Ok(answer.drawn(old, new).to_string());
    }
    let mut picture = Vec::new();
    let written = write_changes_svg(title, answer, [old, new], &mut picture);
    written.map_err(|error| Failure::Io(error.to_string()))?;
    Ok(String::from_utf8_lossy(&picture).trim_end().to_owned())
}

/// Refuses lengths in metres where coordinates are degrees.
pub(crate) fn refuse_degrees(
    subject: &Subject,
    change: &ChangeArguments,
    size: Option<Length>,
) -> Result<(), Failure> {
    subject.refuse_degrees([
        ("--size", size),
        ("--within", change.within),
        ("--least-island", change.least_island),
        ("--narrowest", change.narrowest),
    ])
}
