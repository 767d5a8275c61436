//! Compares domains and writes the reports, in the form `mindeg compare` has:
//!
//! ```text
//! cargo run -p mindeg-compare --example compare -- \
//!     compare DOMAIN.json -o report.html -o report.json -o report.md
//! cargo run -p mindeg-compare --example compare -- compare DOMAIN.json … -o FOLDER/
//! ```

use mindeg_compare::{
    Comparison, IndexEntry, Options, compare, write_html, write_index, write_json, write_markdown,
};
use mindeg_geometry::Domain;
use std::error::Error;
use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::time::Duration;

fn main() -> Result<(), Box<dyn Error>> {
    let mut options = Options::default();
    let (mut domains, mut outputs) = (Vec::new(), Vec::new());
    let mut arguments = std::env::args().skip(2);
    while let Some(argument) = arguments.next() {
        match &*argument {
            "-o" => outputs.extend(arguments.next().map(PathBuf::from)),
            "--time-limit" => {
                let seconds = arguments.next().unwrap_or_default().parse()?;
                options.time_limit = Duration::from_secs_f64(seconds);
            }
            _ => domains.push(PathBuf::from(argument)),
        }
    }
    match (&domains[..], &outputs[..]) {
        ([domain], outputs) if outputs.iter().all(|output| output.extension().is_some()) => {
            let comparison = compared(domain, &options)?;
            outputs.iter().try_for_each(|output| write(&comparison, output))
        }
        (domains, [folder]) => write_all(domains, folder, &options),
        _ => Err("several domains need one folder: -o FOLDER/".into()),
    }
}

fn compared(domain: &Path, options: &Options) -> Result<Comparison, Box<dyn Error>> {
    Ok(compare(&Domain::from_json(&fs::read_to_string(domain)?)?, options)?)
}

fn write(comparison: &Comparison, output: &Path) -> Result<(), Box<dyn Error>> {
    let file = File::create(output)?;
    match output.extension().and_then(|extension| extension.to_str()) {
        Some("html") => write_html(comparison, file)?,
        Some("json") => write_json(comparison.report(), file)?,
        Some("md") => write_markdown(comparison, file)?,
        _ => return Err("an output ends in .html, .json or .md".into()),
    }
    Ok(())
}

/// A page for each domain, and an index of them; a domain that fails is listed with its error.
fn write_all(domains: &[PathBuf], folder: &Path, options: &Options) -> Result<(), Box<dyn Error>> {
    fs::create_dir_all(folder)?;
    let mut entries = Vec::new();
    for domain in domains {
        let name = domain.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        match compared(domain, options) {
            Ok(comparison) => {
                let page = format!("{name}.html");
                write(&comparison, &folder.join(&page))?;
                entries.push(IndexEntry::compared(name, &page, comparison.report()));
            }
            Err(error) => entries.push(IndexEntry::failed(name, error.to_string())),
        }
    }
    Ok(write_index(&entries, File::create(folder.join("index.html"))?)?)
}
