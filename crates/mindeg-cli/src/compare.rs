//! `mindeg compare`: a domain's mesh beside what other methods give.

use crate::args::CompareArguments;
use crate::bar::Bar;
use crate::domain::{domain, from_file};
use crate::failure::Failure;
use crate::gates::{Gates, NamedTriangle};
use crate::interrupt::clean_up_on_interrupt;
use crate::output::{Outputs, cannot_write};
use mindeg::Domain;
use mindeg_compare::{
    Comparison, IndexEntry, Options, PageLinks, Provenance, compare, shell_word, write_html,
    write_index, write_json, write_linked_html, write_markdown,
};
use std::collections::BTreeSet;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::Duration;

pub(crate) fn run(arguments: &CompareArguments) -> Result<(), Failure> {
    let limit = arguments.time_limit;
    let time_limit = Duration::try_from_secs_f64(limit).map_err(|_| {
        Failure::Input(format!("--time-limit {limit}: give a number of seconds, such as 60"))
    })?;
    let options = Options { time_limit, ..Options::default() };
    let folder = arguments.output.iter().find(|path| is_folder(path));
    clean_up_on_interrupt()?;
    match folder {
        Some(folder) if arguments.output.len() == 1 => run_all(arguments, &options, folder),
        Some(folder) => Err(Failure::Input(format!(
            "{} is a folder and takes every report; give no other -o with it",
            folder.display()
        ))),
        None if arguments.domain.files.len() > 1 => Err(Failure::Input(
            "several domains need a folder for their reports, such as -o reports/".to_owned(),
        )),
        None => run_one(arguments, &options),
    }
}

/// Whether a path is one, or asks to be one by ending in a separator.
fn is_folder(path: &Path) -> bool {
    path.is_dir() || path.as_os_str().to_string_lossy().ends_with(std::path::is_separator)
}

/// One domain, its report in each of the formats asked for.
fn run_one(arguments: &CompareArguments, options: &Options) -> Result<(), Failure> {
    type Writer = fn(&Comparison, &mut dyn Write) -> io::Result<()>;
    let writer = |path: &Path| -> Result<Writer, Failure> {
        let extension = path.extension().map(|name| name.to_string_lossy().to_lowercase());
        match extension.as_deref() {
            Some("html" | "htm") => Ok(|comparison, out| write_html(comparison, out)),
            Some("json") => Ok(|comparison, out| write_json(comparison.report(), out)),
            Some("md") => Ok(|comparison, out| write_markdown(comparison, out)),
            _ => Err(Failure::Input(format!(
                "-o {}: a report ends in .html, .json or .md; a folder ends in /",
                path.display()
            ))),
        }
    };
    let writers: Vec<Writer> =
        arguments.output.iter().map(|path| writer(path)).collect::<Result<_, _>>()?;
    let comparison = compared(&domain(&arguments.domain)?, options, arguments.quiet)?;
    let comparison = comparison.made_by(provenance(arguments.domain.files.first()));
    let mut outputs = Outputs::default();
    for (path, write) in arguments.output.iter().zip(writers) {
        outputs.write(path, |out| write(&comparison, out))?;
    }
    outputs.finish()?;
    say(arguments, &comparison.report().verdict);
    check_gates(&arguments.gates, &comparison)
}

/// Checks mindeg's own mesh, the first method.
fn check_gates(gates: &Gates, comparison: &Comparison) -> Result<(), Failure> {
    let Some((figures, triangles)) = comparison.methods().next() else { return Ok(()) };
    let (Some(max_degree), Some(min_angle)) = (figures.max_degree, figures.min_angle) else {
        return Ok(());
    };
    let highest_vertex = || {
        // With boundary points alone, a vertex has one edge more than triangles.
        let mut degrees = vec![1; comparison.points().len()];
        triangles.as_flattened().iter().for_each(|&vertex| degrees[vertex as usize] += 1);
        (0..).zip(degrees).find(|&(_, degree)| degree == max_degree).map_or(0, |(vertex, _)| vertex)
    };
    let worst_triangle = || {
        let worst = figures.worst_triangles.first();
        let (number, vertices) =
            worst.map_or((0, [0, 1, 2]), |worst| (worst.triangle, worst.vertices));
        NamedTriangle { number, vertices }
    };
    gates.check(max_degree, min_angle, highest_vertex, worst_triangle)
}

/// Every domain, its report in the folder, and an index page. What fails is listed, and the
/// others go on.
fn run_all(arguments: &CompareArguments, options: &Options, folder: &Path) -> Result<(), Failure> {
    let jobs = jobs(arguments)?;
    fs::create_dir_all(folder).map_err(|error| cannot_write(folder, &error))?;
    let mut entries = Vec::new();
    let mut failures = Vec::new();
    let mut gated = Vec::new();
    let pages: Vec<(String, String)> =
        jobs.iter().map(|job| (job.name.clone(), format!("{}.html", job.name))).collect();
    for (place, Job { name, load }) in jobs.into_iter().enumerate() {
        let page = pages[place].1.clone();
        let links = PageLinks {
            index: Some("index.html".to_owned()),
            previous: place.checked_sub(1).and_then(|before| pages.get(before)).cloned(),
            next: pages.get(place + 1).cloned(),
        };
        let written = load().and_then(|domain| {
            let comparison = compared(&domain, options, arguments.quiet)?;
            let comparison = comparison.made_by(provenance(arguments.domain.files.get(place)));
            write_page(&folder.join(&page), |out| write_linked_html(&comparison, &links, out))?;
            Ok(comparison)
        });
        match written {
            Ok(comparison) => {
                if let Err(failure) = check_gates(&arguments.gates, &comparison) {
                    gated.push(format!("{name}: {}", failure.message().unwrap_or_default()));
                }
                entries.push(IndexEntry::compared(&name, &page, comparison.report()));
                say(arguments, &format!("{name}: {}", comparison.report().verdict));
            }
            Err(failure) => {
                let reason = failure.message().unwrap_or("its reader stopped").to_owned();
                entries.push(IndexEntry::failed(&name, &reason));
                failures.push(format!("{name}: {reason}"));
            }
        }
    }
    write_page(&folder.join("index.html"), |out| write_index(&entries, out))?;
    if failures.is_empty() {
        return if gated.is_empty() { Ok(()) } else { Err(Failure::Gate(gated.join("\n"))) };
    }
    Err(Failure::Input(format!(
        "{} of {} domains could not be compared; the index lists them\n{}",
        failures.len(),
        entries.len(),
        failures.join("\n")
    )))
}

/// A domain to be read when its turn comes, and the name of its report.
struct Job<'a> {
    name: String,
    load: Box<dyn Fn() -> Result<Domain, Failure> + 'a>,
}

fn jobs(arguments: &CompareArguments) -> Result<Vec<Job<'_>>, Failure> {
    let described = &arguments.domain;
    if described.files.is_empty() {
        let load = Box::new(|| domain(described));
        return Ok(vec![Job { name: "domain".to_owned(), load }]);
    }
    let mut names = BTreeSet::from(["index".to_owned()]);
    let job = |path: &'_ PathBuf| {
        let stem = path.file_stem().unwrap_or(path.as_os_str()).to_string_lossy();
        let name = if stem == "-" { "domain".to_owned() } else { stem.into_owned() };
        if !names.insert(name.clone()) {
            return Err(Failure::Input(format!(
                "{}: the folder has another {name}.html; rename the file",
                path.display()
            )));
        }
        let path = path.clone();
        Ok(Job { name, load: Box::new(move || from_file(&path, described)) })
    };
    described.files.iter().map(job).collect()
}

fn compared(domain: &Domain, options: &Options, quiet: bool) -> Result<Comparison, Failure> {
    let name = format!(
        "comparing {}, {} s at most for each method",
        domain.name().unwrap_or("methods"),
        options.time_limit.as_secs_f64()
    );
    let comparison = Bar::new(quiet).waiting(name, || compare(domain, options));
    comparison.map_err(|error| Failure::Input(error.to_string()))
}

/// What a report says of its making: the file as it was given, and the command line.
fn provenance(input: Option<&PathBuf>) -> Provenance {
    let words = std::env::args_os().skip(1).map(|word| shell_word(&word.to_string_lossy()));
    let command = [String::from("mindeg")].into_iter().chain(words).collect::<Vec<_>>().join(" ");
    let input = input.filter(|path| path.as_os_str() != "-");
    Provenance {
        input: input.map(|path| path.display().to_string()),
        command: Some(command),
        ..Provenance::default()
    }
}

/// Writes one page of a folder, whole or not at all.
fn write_page(
    path: &Path,
    write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> Result<(), Failure> {
    let mut outputs = Outputs::default();
    outputs.write(path, write)?;
    outputs.finish()
}

fn say(arguments: &CompareArguments, verdict: &str) {
    if !arguments.quiet {
        // A verdict that cannot be shown is no reason to fail: the report is there.
        let _ = writeln!(io::stderr(), "{verdict}");
    }
}
