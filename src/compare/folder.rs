//! Several domains: a page for each in a folder, and an index page.

use super::comparing::{check, compared};
use super::saved_meshes;
use crate::args::CompareArguments;
use crate::domain::{UNNAMED, from_options, parts};
use crate::failure::Failure;
use crate::interrupt::SESSION;
use crate::named_files::summed_up;
use crate::provenance::provenance_of;
use crate::terminal::say;
use mindeg::Domain;
use mindeg_answers::command::{MeshCommand, file_word};
use mindeg_compare::{
    CompareOptions, Comparison, IndexEntry, PageLinks, write_index, write_linked_html,
};
use mindeg_files::{Outputs, cannot_write, write_to};
use std::collections::BTreeSet;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Compares every domain. Domains that fail are listed, and the others go on.
pub(super) fn run(
    arguments: &CompareArguments,
    options: &CompareOptions,
    folder: &Path,
) -> Result<(), Failure> {
    let jobs = jobs(arguments)?;
    // Every input is known before the first page is written.
    arguments.files.iter().for_each(|path| SESSION.note(path, "domain"));
    let index = folder.join("index.html");
    SESSION.refuse_input(&index)?;
    for job in &jobs {
        SESSION.refuse_input(&job.page(folder))?;
        if job.is_part {
            SESSION.refuse_input(&job.domain_file(folder))?;
        }
    }
    fs::create_dir_all(folder).map_err(|error| cannot_write(folder, &error))?;

    let mut entries = Vec::new();
    let mut failures = Vec::new();
    let mut gated = Vec::new();
    let page_of = |job: &Job<'_>| (job.name.clone(), format!("{}.html", job.name));
    let pages: Vec<(String, String)> = jobs.iter().map(page_of).collect();
    for (i, job) in jobs.into_iter().enumerate() {
        let (name, page) = &pages[i];
        let links = PageLinks {
            index: Some("index.html".to_owned()),
            previous: i.checked_sub(1).map(|before| pages[before].clone()),
            next: pages.get(i + 1).cloned(),
        };
        match job.run(arguments, options, folder, &links) {
            Ok(comparison) => {
                if let Err(failure) = check(&arguments.demands.demands(), &comparison) {
                    gated.push(format!("{name}: {}", failure.message().unwrap_or_default()));
                }
                entries.push(IndexEntry::compared(name, page, comparison.report()));
                if !arguments.quiet {
                    say(&format!("{name}: {}", comparison.report().verdict));
                }
            }
            Err(failure) => {
                let reason = failure.message().unwrap_or("its reader stopped");
                entries.push(IndexEntry::failed(name, reason));
                failures.push(failure.of(name));
            }
        }
    }
    let mut outputs = Outputs::new(&SESSION);
    let out = outputs.open(&index)?;
    write_to(&index, out, |out| write_index(&entries, out))?;
    outputs.finish()?;
    if !arguments.quiet {
        let count = entries.len() - failures.len();
        let pages = if count == 1 { "page" } else { "pages" };
        say(&format!("wrote {} and {count} {pages} beside it", index.display()));
    }
    let what = "domains could not be compared; the index lists them";
    summed_up(failures, entries.len(), what)?;
    if gated.is_empty() { Ok(()) } else { Err(Failure::Gate(gated.join("\n"))) }
}

/// A domain, or why there is none, which is told when its turn comes; and the name of its page.
struct Job<'a> {
    name: String,
    /// Whether its file has others, so that no command makes its mesh of that file.
    is_part: bool,
    /// `None` for a domain from options alone.
    file: Option<&'a Path>,
    domain: Result<Domain, Failure>,
}

impl Job<'_> {
    fn page(&self, folder: &Path) -> PathBuf {
        folder.join(format!("{}.html", self.name))
    }

    /// The file of a part, beside its page.
    fn domain_file(&self, folder: &Path) -> PathBuf {
        folder.join(format!("{}.json", self.name))
    }

    /// Compares, and writes either all of the page and the meshes or nothing.
    fn run(
        self,
        arguments: &CompareArguments,
        options: &CompareOptions,
        folder: &Path,
        links: &PageLinks,
    ) -> Result<Comparison, Failure> {
        let (page, file) = (self.page(folder), self.domain_file(folder));
        let domain = self.domain?;
        let mut outputs = Outputs::new(&SESSION);
        let out = outputs.open(&page)?;
        let comparison = compared(&domain, options, arguments.quiet)?;
        let mut made_by = provenance_of(&domain, self.file);
        if self.is_part {
            let out = outputs.open(&file)?;
            write_to(&file, out, |out| out.write_all(domain.to_json().as_bytes()))?;
            let named = domain.clone().named(self.name.as_str());
            let word = file_word(&file.display().to_string());
            made_by.mesh = MeshCommand::of(&[word], named.as_ref().unwrap_or(&domain));
        }
        let comparison = comparison.made_by(made_by);
        if let Some(meshes) = &arguments.save_meshes {
            saved_meshes::save(&meshes.join(&self.name), &comparison, &mut outputs)?;
        }
        let write = |out: &mut (dyn Write + Send)| -> io::Result<()> {
            write_linked_html(&comparison, links, out)
        };
        write_to(&page, out, write)?;
        outputs.finish()?;
        Ok(comparison)
    }
}

fn jobs(arguments: &CompareArguments) -> Result<Vec<Job<'_>>, Failure> {
    if arguments.files.is_empty() {
        let domain = from_options(&arguments.options);
        return Ok(vec![Job { name: UNNAMED.to_owned(), is_part: false, file: None, domain }]);
    }
    let mut names = BTreeSet::from(["index".to_owned()]);
    let job = |path: &'_ PathBuf| {
        let stem = path.file_stem().unwrap_or(path.as_os_str()).to_string_lossy();
        let name = if stem == "-" { UNNAMED } else { &stem }.to_owned();
        // Folders on Windows and macOS do not tell X.html from x.html.
        names.insert(name.to_lowercase()).then_some(name).ok_or_else(|| {
            Failure::Input(format!(
                "{}: the folder has another {stem}.html; rename the file",
                path.display()
            ))
        })
    };
    let names: Vec<String> = arguments.files.iter().map(job).collect::<Result<_, _>>()?;
    let mut jobs = Vec::new();
    for (name, path) in names.into_iter().zip(&arguments.files) {
        let file = Some(path.as_path());
        // Once, as standard input can be read but once.
        match parts(path, &arguments.options).map(|it| it.domains) {
            Ok(parts) => {
                let is_one = parts.len() == 1;
                jobs.extend((1..).zip(parts).map(|(index, part)| {
                    let name = if is_one { name.clone() } else { format!("{name}-{index}") };
                    Job { name, is_part: !is_one, file, domain: Ok(part) }
                }));
            }
            Err(failure) => jobs.push(Job { name, is_part: false, file, domain: Err(failure) }),
        }
    }
    Ok(jobs)
}
