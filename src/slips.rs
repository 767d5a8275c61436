//! Guesses at slips in usage: what was likely meant, where the parser can only say what is wrong.

use crate::args::{Arguments, point};
use clap::error::{ContextKind, ContextValue, ErrorKind};
use mindeg_files::{Format, is_domain_name, is_mesh_name};
use std::ffi::OsString;
use std::path::Path;

/// The hint for arguments (the first is the program) that the parser refused, if it can make a
/// guess.
pub(crate) fn guess(error: &clap::Error, arguments: &[OsString]) -> Option<String> {
    let words: Vec<String> =
        arguments.iter().skip(1).map(|word| word.to_string_lossy().into_owned()).collect();
    let command = words.first().map_or("", String::as_str);
    corners_without_quotes(&words)
        .or_else(|| counts_without_commas(command, &words))
        .or_else(|| size_in_two_words(&words))
        .or_else(|| match error.kind() {
            ErrorKind::InvalidSubcommand => file_for_command(error),
            ErrorKind::UnknownArgument => {
                let unknown = text(error, ContextKind::InvalidArg)?;
                renamed(command, &unknown)
                    .or_else(|| absent(&unknown))
                    .or_else(|| one_too_many(command, &unknown))
            }
            ErrorKind::MissingRequiredArgument => output_missing(command, error),
            ErrorKind::InvalidValue => open_without_water(error),
            _ => None,
        })
}

/// `mesh plate.json`
fn output_missing(command: &str, error: &clap::Error) -> Option<String> {
    let Some(ContextValue::Strings(missing)) = error.get(ContextKind::InvalidArg) else {
        return None;
    };
    let example = match command {
        "compare" => "-o report.html, or give --json",
        "view" => "-o view.html",
        _ => "-o mesh.obj",
    };
    let is_output = |argument: &String| argument.starts_with("--output");
    missing.iter().all(is_output).then(|| format!("where to? name a file, such as {example}"))
}

/// `mesh a.json -o a.obj --open`
fn open_without_water(error: &clap::Error) -> Option<String> {
    let is_open = text(error, ContextKind::InvalidArg)?.starts_with("--open");
    let is_empty = text(error, ContextKind::InvalidValue).is_none_or(|value| value.is_empty());
    (is_open && is_empty).then(|| {
        "--open takes the sides that are open water, such as box; --show shows the mesh in a browser".to_owned()
    })
}

/// `--corners 0,0 4,0 3,2`
fn corners_without_quotes(words: &[String]) -> Option<String> {
    let points = after(words, "--corners", |word| point(word).is_some())?;
    Some(format!(
        "--corners takes all corners as one value; put them in quotes: --corners \"{}\"",
        points.join(" ")
    ))
}

/// `degree 3 3 2 2`, `degree 3, 3, 2, 2`, `--intervals 3 3 2 2`
fn counts_without_commas(command: &str, words: &[String]) -> Option<String> {
    let is_count = |word: &str| word.trim_matches(',').parse::<u64>().is_ok();
    let joined = |counts: Vec<&str>| {
        let counts: Vec<&str> = counts.into_iter().map(|count| count.trim_matches(',')).collect();
        counts.join(",")
    };
    if let Some(counts) = after(words, "--intervals", is_count) {
        let counts = joined(counts);
        return Some(format!("join the counts by commas, without spaces: --intervals {counts}"));
    }
    if !["degree", "suggest"].contains(&command) {
        return None;
    }
    let counts = after(words, command, is_count)?;
    let counts = joined(counts);
    Some(format!("join the counts by commas, without spaces: mindeg {command} {counts}"))
}

/// `--rectangle 4 3`, `--rectangle 4 x 3`
fn size_in_two_words(words: &[String]) -> Option<String> {
    let is_part = |word: &str| word == "x" || word.parse::<f64>().is_ok();
    let sizes = after(words, "--rectangle", is_part)?;
    let sizes: Vec<&str> = sizes.into_iter().filter(|&word| word != "x").collect();
    Some(format!("join width and height by an x, without spaces: --rectangle {}", sizes.join("x")))
}

/// The words after `option`, as long as they are like its value, if that is more than one.
fn after<'a>(
    words: &'a [String],
    option: &str,
    is_value: impl Fn(&str) -> bool,
) -> Option<Vec<&'a str>> {
    let place = words.iter().position(|word| word == option)?;
    let values = words[place + 1..].iter().map(String::as_str);
    let values: Vec<&str> = values.take_while(|word| is_value(word)).collect();
    (values.len() > 1).then_some(values)
}

/// `mindeg plate.json`
fn file_for_command(error: &clap::Error) -> Option<String> {
    let word = text(error, ContextKind::InvalidSubcommand)?;
    match extension(&word).as_deref() {
        Some(_) if is_domain_name(word.as_ref()) => Some(format!(
            "{word} is no command; name one before the file, such as mindeg mesh {word} -o mesh.obj"
        )),
        Some(_) if is_mesh_name(word.as_ref()) => Some(format!(
            "{word} is no command; name one before the file, such as mindeg inspect {word}"
        )),
        _ => None,
    }
}

/// Options of an earlier version, and their names today.
const RENAMED: [(&str, &str); 4] = [
    ("--fail-above-degree", "--max-degree"),
    ("--fail-below-angle", "--target-angle"),
    ("--min-angle", "--target-angle"),
    ("--target", "--max-degree"),
];

fn renamed(command: &str, option: &str) -> Option<String> {
    if option == "--open" {
        return has(command, "--show").then(|| "--show shows the mesh in a browser".to_owned());
    }
    if option == "--interior" {
        return inside_anyway(command);
    }
    let renamed = RENAMED.iter().find(|(old, _)| *old == option);
    let today = renamed.map_or(option, |&(_, new)| new);
    if command == "condition" && today == "--target-angle" {
        return Some("condition has --limit, the angle that the boundary shall allow".to_owned());
    }
    renamed?;
    if has(command, today) {
        return Some(format!("{option} is now {today}"));
    }
    let whole = Arguments::whole();
    let names = whole.get_subcommands().map(clap::Command::get_name);
    let takers: Vec<&str> = names.filter(|name| has(name, today)).collect();
    let takers = takers.join(", ");
    Some(format!("{option} is now {today}, which {command} does not take; these do: {takers}"))
}

/// Options of other mesh generators for work that mindeg does not do, and which program does it.
const ABSENT: [(&[&str], &str); 4] = [
    (
        &["--quad", "--quads", "--recombine"],
        "mindeg makes triangles alone; Gmsh joins pairs of them to quads, by a script: Merge \"mesh.msh\"; RecombineMesh; \
         Save \"quads.msh\";",
    ),
    (
        &["--order", "--second-order", "--element-order"],
        "mindeg makes triangles with straight edges, of order 1; Gmsh raises it, by a script: Merge \"mesh.msh\"; SetOrder 2; \
         Save \"second.msh\";",
    ),
    (
        &["--union", "--difference", "--intersection", "--boolean", "--subtract"],
        "mindeg takes outlines as they are; Gmsh's BooleanUnion and BooleanDifference, or shapely, join and cut them, and \
         mindeg reads what they write",
    ),
    (
        &["--boundary-layer", "--boundary-layers"],
        "mindeg makes no boundary layers, only triangles that are about as long as wide; Gmsh has the field BoundaryLayer",
    ),
];

fn absent(option: &str) -> Option<String> {
    let found = ABSENT.iter().find(|(options, _)| options.contains(&option));
    found.map(|(_, why)| (*why).to_owned())
}

/// `tradeoff plate.json --interior`, where points inside need no option.
fn inside_anyway(command: &str) -> Option<String> {
    let why = match command {
        "tradeoff" => "the report of tradeoff has the mesh with points inside anyway",
        "explore" => "the page of explore has the mesh with points inside anyway",
        "verify" => "verify takes any mesh of the domain, with points inside or without",
        _ => return None,
    };
    Some(format!("leave out --interior: {why}"))
}

/// Whether a command has the option.
fn has(command: &str, option: &str) -> bool {
    let whole = Arguments::whole();
    let found = whole.find_subcommand(command);
    let name = option.trim_start_matches('-');
    found.is_some_and(|found| found.get_arguments().any(|known| known.get_long() == Some(name)))
}

/// `mesh plate.json plate.obj`, `mesh a.json b.json`
fn one_too_many(command: &str, word: &str) -> Option<String> {
    if word.starts_with('-') {
        return None;
    }
    // A name such as icon.svg is more likely an output.
    let is_domain =
        is_domain_name(word.as_ref()) && Format::of_path(word.as_ref()) != Some(Format::Svg);
    match (command, extension(word).as_deref()) {
        ("mesh" | "tradeoff" | "degree" | "suggest" | "domain", Some(_)) if is_domain => Some(
            format!("one domain at a time: {word} is a second one; mindeg compare takes several"),
        ),
        ("mesh", Some(_)) if Format::of_path(word.as_ref()).is_some() => {
            Some(format!("give every output with -o: -o {word}"))
        }
        ("convert", Some(_)) | ("tradeoff" | "view", Some("html" | "svg")) => {
            Some(format!("give every output with -o: -o {word}"))
        }
        ("verify", Some(_)) if is_domain => {
            Some(format!("one domain at a time: {word} is a second one"))
        }
        ("inspect" | "view", Some(_)) => {
            Some(format!("one mesh at a time: {word} is a second one"))
        }
        _ => None,
    }
}

fn extension(word: &str) -> Option<String> {
    Path::new(word).extension().map(|name| name.to_string_lossy().to_lowercase())
}

fn text(error: &clap::Error, kind: ContextKind) -> Option<String> {
    match error.get(kind)? {
        ContextValue::String(text) => Some(text.clone()),
        _ => None,
    }
}
