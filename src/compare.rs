//! `mindeg compare`: a domain's mesh beside what other methods give.

mod comparing;
mod folder;
mod saved_meshes;

use crate::args::{CompareArguments, ReportFormat};
use crate::domain::{from_options, parts};
use crate::failure::Failure;
use crate::interrupt::{SESSION, clean_up_on_interrupt};
use crate::making::wrote;
use crate::provenance::provenance_of;
use crate::terminal::say;
use comparing::{check, compared};
use mindeg::Domain;
use mindeg_compare::{CompareOptions, Comparison, write_html, write_json, write_markdown};
use mindeg_files::{Outputs, is_standard_output, write_to};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

pub(crate) fn run(arguments: &CompareArguments) -> Result<(), Failure> {
    let options = CompareOptions {
        time_limit: arguments.time_limit,
        interior: arguments.interior,
        purpose: arguments.purpose.purpose,
        ..CompareOptions::default()
    };
    clean_up_on_interrupt()?;
    match arguments.output.iter().find(|path| is_folder(path)) {
        Some(folder) if arguments.output.len() == 1 && !arguments.json => {
            folder::run(arguments, &options, folder)
        }
        Some(folder) => Err(Failure::Input(format!(
            "{} is a folder and takes every report; give no other -o and no --json with it",
            folder.display()
        ))),
        None if arguments.files.len() > 1 => Err(Failure::input(
            "several domains need a folder for their reports, such as -o reports/",
        )),
        None => run_one(arguments, &options),
    }
}

/// Whether a path is one, or asks to be one by ending in a separator.
fn is_folder(path: &Path) -> bool {
    path.is_dir() || path.as_os_str().to_string_lossy().ends_with(std::path::is_separator)
}

/// One domain, its report in each of the formats asked for.
fn run_one(arguments: &CompareArguments, options: &CompareOptions) -> Result<(), Failure> {
    let mut reports = arguments.output.clone();
    let mut formats: Vec<ReportFormat> =
        reports.iter().map(|path| format(path, arguments.format)).collect::<Result<_, _>>()?;
    if arguments.json {
        reports.push(PathBuf::from("-"));
        formats.push(ReportFormat::Json);
    }
    if reports.iter().filter(|path| is_standard_output(path)).count() > 1 {
        return Err(Failure::input("standard output takes one report, or the one of --json"));
    }
    let domain = match arguments.files.first() {
        Some(path) => only(path, arguments)?,
        None => from_options(&arguments.options)?,
    };
    // Refuse outputs that cannot be written before the work, which can take minutes.
    let mut outputs = Outputs::new(&SESSION);
    let opened: Vec<Box<dyn Write + Send>> =
        reports.iter().map(|path| outputs.open(path)).collect::<Result<_, _>>()?;

    let comparison = compared(&domain, options, arguments.quiet)?;
    let file = arguments.files.first().map(PathBuf::as_path);
    let comparison = comparison.made_by(provenance_of(&domain, file));
    let mut written: Vec<PathBuf> = Vec::new();
    if let Some(folder) = &arguments.save_meshes {
        written = saved_meshes::save(folder, &comparison, &mut outputs)?;
    }
    let mut all_taken = true;
    for ((path, format), out) in reports.iter().zip(formats).zip(opened) {
        match write_to(path, out, |out| write(format, &comparison, out)).map_err(Failure::from) {
            // This reader has left; the other outputs have other readers.
            Err(Failure::ClosedPipe) => all_taken = false,
            written => written?,
        }
    }
    outputs.finish()?;
    written.extend(reports.into_iter().filter(|path| !is_standard_output(path)));
    if !arguments.quiet {
        say(&comparison.report().verdict);
        let files: Vec<_> = written.iter().map(|path| path.display().to_string()).collect();
        wrote(&files).iter().for_each(|line| say(line));
    }
    check(&arguments.demands.demands(), &comparison)?;
    if all_taken { Ok(()) } else { Err(Failure::ClosedPipe) }
}

/// The domain of a file. One with several parts has a report for each.
fn only(path: &Path, arguments: &CompareArguments) -> Result<Domain, Failure> {
    let mut parts = parts(path, &arguments.options)?.domains;
    match (parts.pop(), parts.len()) {
        (Some(domain), 0) => Ok(domain),
        (_, others) => Err(Failure::Input(format!(
            "{} has {} parts that share no edge, and a report is of one; give a folder, such as -o reports/, for a report of \
             each, or choose one with --feature",
            path.display(),
            others + 1
        ))),
    }
}

/// The format of the report at `path`; `given` is for standard output.
fn format(path: &Path, given: Option<ReportFormat>) -> Result<ReportFormat, Failure> {
    if is_standard_output(path) {
        return given.ok_or_else(|| Failure::input("-o -: give --format html, json or md"));
    }
    ReportFormat::of_path(path).ok_or_else(|| {
        Failure::Input(format!(
            "-o {}: a report ends in .html, .json or .md; a folder ends in /",
            path.display()
        ))
    })
}

fn write(format: ReportFormat, comparison: &Comparison, out: &mut dyn Write) -> io::Result<()> {
    match format {
        ReportFormat::Html => write_html(comparison, out),
        ReportFormat::Json => write_json(comparison.report(), out),
        ReportFormat::Md => write_markdown(comparison, out),
    }
}
