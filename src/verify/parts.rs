//! A mesh of several domains: each part against its domain.

use crate::args::VerifyArguments;
use crate::bar::Bar;
use crate::demands::met;
use crate::domain::Parts;
use crate::failure::Failure;
use crate::making::read_mesh;
use crate::mesh::unsolved;
use crate::standard_output::{print, print_json};
use mindeg::verify;
use mindeg_answers::names::shown;
use mindeg_answers::verify::VerifyAnswer;
use serde::Serialize;

/// The output of `--json`.
#[derive(Serialize)]
struct Answers<'a> {
    file: &'a str,
    valid: bool,
    parts: Vec<VerifyAnswer>,
    failed: Vec<String>,
    passed: bool,
}

pub(super) fn run(
    arguments: &VerifyArguments,
    Parts { name, domains }: &Parts,
) -> Result<(), Failure> {
    if arguments.proof.is_some() {
        return Err(Failure::input(
            "--proof: a file holds the proof of one domain; choose one with --feature",
        ));
    }
    let tolerance = arguments.matching_tolerance()?;
    let bar = Bar::new(arguments.quiet);
    let mesh = read_mesh(&arguments.file, None, &bar)?;
    let file = arguments.file.display().to_string();
    let name = shown(name.as_deref().unwrap_or("the domain")).into_owned();
    let checked = bar.waiting("matching the parts of the mesh", || {
        verify::triangulations(&mesh, domains, tolerance)
    });
    let verified = match checked {
        Ok(verified) => verified,
        Err((part, defect)) => {
            drop(bar);
            let place = part.map_or(String::new(), |part| format!(" in part {}", part + 1));
            let message = format!("{file} is no triangulation of {name}{place}: {defect}");
            if arguments.json {
                let domain = &domains[part.unwrap_or(0)];
                let parts = vec![VerifyAnswer::invalid(&file, domain, defect)];
                let failed = Vec::new();
                print_json(&Answers { file: &file, valid: false, parts, failed, passed: false })?;
            }
            return Err(Failure::Gate(message));
        }
    };
    let demands = arguments.all_demands();
    let parts = bar.work(|progress| {
        let parts = verified.iter().zip(domains).map(|(verified, domain)| {
            let optimality = verify::optimality(verified, domain, progress)
                .map_err(|error| unsolved(&error, "leave out --optimal"))?;
            Ok(VerifyAnswer::of(&file, domain, &mesh, verified, &optimality, &demands, progress))
        });
        parts.collect::<Result<Vec<VerifyAnswer>, Failure>>()
    })?;
    drop(bar);
    let failures = |(part, answer): (usize, &VerifyAnswer)| {
        let of_part = move |failed: &String| format!("part {}: {failed}", part + 1);
        answer.failed.iter().map(of_part).collect::<Vec<_>>()
    };
    let failed: Vec<String> = parts.iter().enumerate().flat_map(failures).collect();
    if arguments.json {
        let passed = failed.is_empty();
        print_json(&Answers { file: &file, valid: true, parts, failed: failed.clone(), passed })?;
    } else {
        let text = |(part, answer): (usize, &VerifyAnswer)| {
            answer.text(&format!("part {} of {name}", part + 1))
        };
        print(&parts.iter().enumerate().map(text).collect::<Vec<_>>().join("\n"))?;
    }
    met(&failed)
}
