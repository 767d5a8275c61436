//! `mindeg verify --reproduce`: a file made anew from its recipe, and its bytes compared.
//!
//! The command of a recipe comes from a file, which may come from anywhere: it runs in a folder of its own, which holds
//! nothing but its inputs, makes a mesh and no other file, and none of its words leads to another folder.

use crate::args::{Arguments, VerifyArguments};
use crate::bar::Bar;
use crate::failure::Failure;
use crate::interrupt::SESSION;
use crate::standard_output::{print, print_json};
use clap::Parser;
use mindeg_files::{Format, Ingredient, Recipe};
use serde::Serialize;
use std::fs;
use std::iter;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use tempfile::TempDir;

/// The output of `--json`.
#[derive(Serialize)]
struct Summary<'a> {
    file: String,
    version: &'a str,
    command: String,
    inputs: Vec<&'a str>,
    /// The first byte that differs; null if none does.
    differs_at: Option<usize>,
    passed: bool,
}

pub(super) fn run(arguments: &VerifyArguments) -> Result<(), Failure> {
    let file = &arguments.file;
    let shown = file.display();
    let cannot =
        |what: &str, error: &dyn std::fmt::Display| Failure::Io(format!("cannot {what}: {error}"));
    let read = |path: &Path| {
        fs::read(path).map_err(|error| cannot(&format!("read {}", path.display()), &error))
    };
    let bytes = read(file)?;
    let Some(recipe) = Recipe::in_file(&bytes) else {
        return Err(Failure::Input(format!(
            "{shown} does not say how it was made; mindeg mesh --recipe writes files that do"
        )));
    };
    let output = output_like(file, &recipe)?;
    let inputs =
        recipe.inputs.iter().map(|input| near(file, input)).collect::<Result<Vec<_>, _>>()?;

    let folder =
        TempDir::with_prefix(".mindeg-").map_err(|error| cannot("make a folder", &error))?;
    SESSION.temporary().push(folder.path().to_path_buf());
    for (path, input) in inputs.iter().zip(&recipe.inputs) {
        let copied = fs::copy(path, folder.path().join(&input.name));
        copied.map_err(|error| cannot(&format!("copy {}", path.display()), &error))?;
    }
    let program = std::env::current_exe().map_err(|error| cannot("find this program", &error))?;
    let mut command = Command::new(program);
    command.args(&recipe.arguments).arg("--quiet").current_dir(folder.path());
    command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::piped());
    let bar = Bar::new(arguments.quiet);
    let ran = bar.waiting("making the mesh anew", || command.output());
    drop(bar);
    let ran = ran.map_err(|error| cannot("run this program", &error))?;
    let made = folder.path().join(&output);
    // A mesh that failed a gate may have been written all the same.
    if !made.exists() {
        let errors = String::from_utf8_lossy(&ran.stderr);
        return Err(Failure::Gate(format!("{shown}: its recipe makes no mesh: {}", errors.trim())));
    }
    let differing = first_difference(file, &made, &read)?;
    if arguments.json {
        print_json(&Summary {
            file: shown.to_string(),
            version: &recipe.version,
            command: recipe.command(),
            inputs: recipe.inputs.iter().map(|input| &*input.name).collect(),
            differs_at: differing.as_ref().map(|(_, at)| *at),
            passed: differing.is_none(),
        })?;
    }
    let version = env!("CARGO_PKG_VERSION");
    match differing {
        None if arguments.json => Ok(()),
        None => print(&format!(
            "{shown}: made anew, and all {} bytes are the same\n{}\n",
            bytes.len(),
            recipe.command()
        )),
        Some((path, at)) => Err(Failure::Gate(format!(
            "{}: made anew, it differs from byte {at} on; {}",
            path.display(),
            if recipe.version == version {
                "it was changed after it was made, or another build made it".to_owned()
            } else {
                format!("mindeg {} made it, and this is mindeg {version}", recipe.version)
            }
        ))),
    }
}

/// The output of the recipe that became the file: the one of its name, or the only one of its format.
fn output_like(file: &Path, recipe: &Recipe) -> Result<PathBuf, Failure> {
    let refused = |problem: &str| {
        Failure::Input(format!("{}: its recipe {problem}, so it is not run", file.display()))
    };
    if !recipe.is_plain() {
        return Err(refused("leads to other folders"));
    }
    let words = iter::once("mindeg").chain(recipe.arguments.iter().map(String::as_str));
    let parsed =
        Arguments::try_parse_from(words).map_err(|_| refused("is no command of this mindeg"))?;
    let surface = parsed.command.surface().ok_or_else(|| refused("makes no mesh"))?;
    let outputs = &surface.output;
    let plain = |path: &PathBuf| path.file_name() == Some(path.as_os_str());
    if !outputs.iter().all(plain) {
        return Err(refused("writes to other folders"));
    }
    if let Some(same) = outputs.iter().find(|output| file.file_name() == output.file_name()) {
        return Ok(same.clone());
    }
    let mut alike = outputs.iter().filter(|output| output.extension() == file.extension());
    match (alike.next(), alike.next()) {
        (Some(only), None) => Ok(only.clone()),
        _ => Err(refused("makes no file of that name")),
    }
}

/// Where an input is, with the digest that the recipe tells.
fn near(file: &Path, input: &Ingredient) -> Result<PathBuf, Failure> {
    let beside = file.with_file_name(&input.name);
    let path = if beside.is_file() { beside } else { PathBuf::from(&input.name) };
    if !path.is_file() {
        return Err(Failure::Input(format!(
            "{} was made from {}, which is neither beside it nor in this folder",
            file.display(),
            input.name
        )));
    }
    if Ingredient::of(&path)?.sha256 != input.sha256 {
        return Err(Failure::Gate(format!(
            "{} was made from a file {} with other bytes than {}: its digest was {}",
            file.display(),
            input.name,
            path.display(),
            input.sha256
        )));
    }
    Ok(path)
}

/// The first of the files of a mesh that differs, and the first byte in it.
fn first_difference(
    file: &Path,
    made: &Path,
    read: &dyn Fn(&Path) -> Result<Vec<u8>, Failure>,
) -> Result<Option<(PathBuf, usize)>, Failure> {
    let of = |path: &Path| match Format::of_path(path) {
        Some(format) => {
            format.files(path).into_iter().chain(format.material_library(path)).collect()
        }
        None => vec![path.to_owned()],
    };
    for (old, new) in of(file).into_iter().zip(of(made)) {
        // Not every mesh has a library of materials.
        if !new.exists() && new != made {
            continue;
        }
        let (old_bytes, new_bytes) = (read(&old)?, read(&new)?);
        if old_bytes != new_bytes {
            let same = old_bytes.iter().zip(&new_bytes).take_while(|(a, b)| a == b).count();
            return Ok(Some((old, same)));
        }
    }
    Ok(None)
}
