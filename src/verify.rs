//! `mindeg verify`: whether a mesh is a triangulation of a domain, and how good it is.

mod parts;
mod reproduce;
mod surface;

use crate::args::VerifyArguments;
use crate::bar::Bar;
use crate::demands::met;
use crate::domain::{from_options, in_file, name_in_text};
use crate::failure::Failure;
use crate::interrupt::clean_up_on_interrupt;
use crate::making::read_mesh;
use crate::mesh::unsolved;
use crate::standard_output::{print, print_json};
use mindeg::exact::Refutation;
use mindeg::verify;
use mindeg_answers::proof::ProofFile;
use mindeg_answers::verify::VerifyAnswer;
use mindeg_files::{Wanted, is_domain_name};
use std::path::Path;

pub(crate) fn run(arguments: &VerifyArguments) -> Result<(), Failure> {
    clean_up_on_interrupt()?;
    if arguments.reproduce {
        return reproduce::run(arguments);
    }
    if let Some(part) = &arguments.surface.surface {
        return surface::run(arguments, part);
    }
    check_order(arguments)?;
    let tolerance = arguments.matching_tolerance()?;
    let domain = match &arguments.domain {
        Some(path) => {
            let mut parts = in_file(path, &arguments.options, Wanted::Domain, &Bar::new(true))
                .map_err(|failure| of_two_meshes(arguments, path).unwrap_or(failure))?
                .parts()?;
            if parts.domains.len() > 1 {
                return parts::run(arguments, &parts);
            }
            parts.domains.remove(0)
        }
        None => from_options(&arguments.options)?,
    };
    let proof = arguments.proof.as_deref().map(read_proof).transpose()?;
    let bar = Bar::new(arguments.quiet);
    let mesh = read_mesh(&arguments.file, None, &bar)?;
    let file = arguments.file.display().to_string();
    let checked = bar.waiting("matching the mesh to the domain", || {
        verify::triangulation(&mesh, &domain, tolerance)
    });
    let verified = match checked {
        Ok(verified) => verified,
        Err(defect) if defect.kind == "tolerance_too_large" => {
            return Err(Failure::Input(defect.message));
        }
        Err(defect) => {
            drop(bar);
            let message =
                format!("{file} is no triangulation of {}: {defect}", name_in_text(&domain));
            if arguments.json {
                print_json(&VerifyAnswer::invalid(&file, &domain, defect))?;
            }
            return Err(Failure::Gate(message));
        }
    };
    if let (Some((refuted, _)), Some(path)) = (&proof, &arguments.proof)
        && refuted.checked_add(1) != Some(verified.max_degree)
    {
        return Err(Failure::Input(format!(
            "--proof {}: it refutes degree {refuted}, but the mesh has degree {}; give a proof that refutes degree {}",
            path.display(),
            verified.max_degree,
            verified.max_degree - 1
        )));
    }
    let demands = arguments.all_demands();
    let answer = bar.work(|progress| {
        let optimality = match &proof {
            Some((_, refutation)) => {
                verify::optimality_by(&verified, &domain, refutation, progress)
            }
            None => verify::optimality(&verified, &domain, progress),
        };
        let optimality = optimality.map_err(|error| unsolved(&error, "leave out --optimal"))?;
        Ok::<_, Failure>(VerifyAnswer::of(
            &file,
            &domain,
            &mesh,
            &verified,
            &optimality,
            &demands,
            progress,
        ))
    })?;
    drop(bar);
    if arguments.json {
        print_json(&answer)?;
    } else {
        print(&answer.text(&name_in_text(&domain)))?;
    }
    met(&answer.failed)
}

/// Reads the degree and the clauses that `mindeg degree --proof` has written.
fn read_proof(path: &Path) -> Result<(u32, Refutation), Failure> {
    let fault = |error: &dyn std::fmt::Display| {
        Failure::Input(format!("--proof {}: {error}", path.display()))
    };
    let text = std::fs::read_to_string(path).map_err(|error| fault(&error))?;
    let file: ProofFile = serde_json::from_str(&text).map_err(|error| fault(&error))?;
    let refutation = file.refutation().map_err(|error| fault(&error))?;
    Ok((file.refuted_degree, refutation))
}

/// The way to compare a mesh with a part, where the file of the domain is such a part.
fn of_two_meshes(arguments: &VerifyArguments, part: &Path) -> Option<Failure> {
    read_mesh(part, None, &Bar::new(true)).ok()?;
    let [mesh, part] = [&arguments.file, part].map(|path| path.display().to_string());
    Some(Failure::Input(format!(
        "{part} is a mesh, and a domain is expected; to compare with it: mindeg verify {mesh} --surface {part}"
    )))
}

/// Refuses a domain where the mesh is expected.
fn check_order(arguments: &VerifyArguments) -> Result<(), Failure> {
    if !is_domain_name(&arguments.file) {
        return Ok(());
    }
    let file = arguments.file.display();
    Err(Failure::Input(match &arguments.domain {
        Some(mesh) => {
            let mesh = mesh.display();
            format!("{file} is a domain; swap the two: mindeg verify {mesh} {file}")
        }
        None => {
            format!("{file} is a domain; give the mesh before it: mindeg verify mesh.obj {file}")
        }
    }))
}
