//! `mindeg degree`: the answer from the counts alone, and for a domain the limit of the angle.

use crate::args::DegreeArguments;
use crate::bar::Bar;
use crate::domain::{Counted, Parts, Subject, counted};
use crate::failure::Failure;
use crate::interrupt::{SESSION, clean_up_on_interrupt};
use crate::making::advice_on;
use crate::mesh::model;
use crate::provenance::mesh_command;
use crate::standard_output::{print, print_json};
use mindeg::beside::each;
use mindeg::changes::own_boundary;
use mindeg::model::mesh_model;
use mindeg::{Domain, Goal, Interior, MeshError, Model};
use mindeg_answers::degree::{DegreeBeside, DegreeReport};
use mindeg_answers::limit::Lifting;
use mindeg_answers::model::ModelAnswer;
use mindeg_answers::names::part_name;
use mindeg_answers::suggest::in_words;
use mindeg_core::{Boundary, suggest};
use mindeg_files::{Outputs, Wanted, write_to};
use std::path::Path;

/// On larger domains the limit of the angle is not worked out: it takes all points in memory.
const MOST_VERTICES: u32 = 1_000_000;

pub(crate) fn run(arguments: &DegreeArguments) -> Result<(), Failure> {
    let (file, options) = (arguments.counts.path(), &arguments.counts.options);
    let (mut report, domain) = match counted(&arguments.counts, Wanted::Model)? {
        Counted::Counts(counts) => {
            let boundary = Boundary::new(&counts).map_err(Failure::input)?;
            (DegreeReport::of_counts(&boundary), None)
        }
        Counted::Subject(Subject::Model(found)) => {
            return of_model(arguments, &model::divided(*found, file, options)?);
        }
        Counted::Subject(Subject::Mesh(mesh)) => {
            let found = model::of_mesh(&mesh, file, options, &arguments.model)?;
            return of_model(arguments, &found);
        }
        Counted::Subject(subject) => {
            let mut parts = subject.parts()?;
            if parts.domains.len() > 1 {
                return beside(arguments, &parts);
            }
            let domain = parts.domains.remove(0);
            let bar = Bar::new(arguments.json);
            let found = bar.work(|progress| {
                DegreeReport::with_effort(&domain, arguments.model.effort, progress)
            });
            (found.map_err(Failure::input)?, Some(domain))
        }
    };
    if let Some(path) = &arguments.proof {
        write_proof(path, &report)?;
    }
    let lifting = domain.as_ref().and_then(|domain| lifting(domain, arguments.boundary_degree, 1));
    if arguments.json {
        report.limit = lifting.as_ref().map(Lifting::answer);
        return print_json(&report);
    }
    let mut text = report.text();
    // Where the formula merges sides, those that it changes are not the domain's.
    if domain.as_ref().is_none_or(|domain| own_boundary(domain).is_some()) {
        text.extend(fewer(&report));
    }
    text.extend(lifting.map(|found| format!("With interior points: {}\n", found.text())));
    print(&text)?;
    let Some(domain) = &domain else { return Ok(()) };
    print_advice(std::slice::from_ref(domain), domain, arguments.counts.path())
}

/// The degree of a whole model, over all its faces.
fn of_model(arguments: &DegreeArguments, found: &Model) -> Result<(), Failure> {
    let (bar, effort) = (Bar::new(arguments.json), arguments.model.effort);
    let meshed = bar.work(|progress| mesh_model(found, Goal::default(), effort, progress));
    let meshed = meshed.map_err(|error| model::bad(arguments.counts.path(), &error))?;
    drop(bar);
    let answer = ModelAnswer::of(found, &meshed);
    if arguments.json {
        return print_json(&answer);
    }
    print(&(answer.text() + "\n"))
}

/// The degrees of several domains beside each other.
fn beside(arguments: &DegreeArguments, parts: &Parts) -> Result<(), Failure> {
    if arguments.proof.is_some() {
        return Err(Failure::input(
            "--proof: a file holds the proof of one domain; choose one with --feature",
        ));
    }
    let domains = &parts.domains;
    let bar = Bar::new(arguments.json);
    let found = bar.work(|progress| {
        each(domains, "searching for degrees", progress, |domain, progress| {
            let mut report = DegreeReport::with_effort(domain, arguments.model.effort, progress)?;
            let lifting = lifting(domain, arguments.boundary_degree, 1);
            report.limit = lifting.as_ref().map(Lifting::answer);
            Ok::<_, MeshError>((report, lifting))
        })
    });
    let found = found.map_err(|(index, error)| parts.failure((index, Failure::input(error))))?;
    drop(bar);
    let (reports, liftings): (Vec<_>, Vec<_>) = found.into_iter().unzip();
    let answer = DegreeBeside::of(domains, reports);
    if arguments.json {
        return print_json(&answer);
    }
    let mut text = answer.text();
    let known =
        liftings.iter().enumerate().filter_map(|(part, found)| Some((part, found.as_ref()?)));
    let least = known.min_by(|(_, a), (_, b)| a.limit.min_angle.total_cmp(&b.limit.min_angle));
    text.extend(least.map(|(part, found)| {
        let part = part_name(part, &domains[part]);
        format!("With interior points, {part} decides: {}\n", found.text())
    }));
    print(&text)?;
    print_advice(domains, &parts.whole(), arguments.counts.path())
}

/// Writes the clauses that refute a smaller degree.
fn write_proof(path: &Path, report: &DegreeReport) -> Result<(), Failure> {
    let Some(proof) = &report.proof else {
        return Err(Failure::input(if report.regions.is_some() {
            "--proof: a file holds clauses on one polygon, and this is a map; mindeg verify finds and checks its proof"
        } else {
            "--proof: no clauses prove this degree; the answer without --proof says what does"
        }));
    };
    clean_up_on_interrupt()?;
    let mut outputs = Outputs::new(&SESSION);
    let out = outputs.open(path)?;
    write_to(path, out, |out| Ok(serde_json::to_writer(out, proof)?))?;
    Ok(outputs.finish()?)
}

/// The limit of a domain's minimum angle with interior points, at a boundary degree, and up to `steps` changes
/// that lift it; `None` for a large domain.
pub(crate) fn lifting(
    domain: &Domain,
    boundary_degree: Option<u32>,
    steps: usize,
) -> Option<Lifting> {
    if domain.rings().vertex_count() > MOST_VERTICES {
        return None;
    }
    let wanted = domain.interior().cloned().unwrap_or_default();
    let boundary_degree = boundary_degree.or(wanted.boundary_degree);
    Lifting::of(domain, &Interior { boundary_degree, ..wanted }, steps).ok()
}

/// The change of counts that brings the degree down, where the formula answers.
fn fewer(report: &DegreeReport) -> Option<String> {
    if report.reached_by != "formula" || report.reached <= 4 {
        return None;
    }
    let suggestion = suggest(&Boundary::new(&report.intervals).ok()?, report.reached - 1)?;
    let words = in_words(&suggestion, |side| format!("side {}", side + 1));
    Some(format!("hint: {words} and it is {}; mindeg suggest tells more.\n", suggestion.max_degree))
}

/// Prints which meshes to take of the parts of a domain, which are called as `whole` is; that can take longer to find than the degree.
fn print_advice(parts: &[Domain], whole: &Domain, file: Option<&Path>) -> Result<(), Failure> {
    // A domain without a mesh says so when it is meshed.
    let hints = advice_on(parts).hints(&mesh_command(whole, file), None);
    hints.map_or(Ok(()), |hints| print(&(hints + "\n")))
}
