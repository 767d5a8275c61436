//! `mindeg formats`: the formats of files, and the rules of programs, once.

use crate::failure::Failure;
use crate::standard_output::print;
use crate::terminal;
use mindeg_answers::preset::PRESETS;
use mindeg_files::{Format, OutlineFormat, WriteOptions, Writer};

pub(crate) fn run() -> Result<(), Failure> {
    let dotted = |extensions: &[&str]| {
        extensions.iter().map(|extension| format!(".{extension}")).collect::<Vec<_>>().join(" ")
    };
    let row = |first: &str, files: &[&str], way: &str, what: &str| {
        terminal::row(&format!("  {first:<8}{:<27}{way:<9}", dotted(files)), what)
    };
    let mut text = String::from("Meshes, by the name that --format takes\n");
    for format in Format::WRITTEN {
        let way = if Format::READ.contains(&format) { "in, out" } else { "out" };
        let is_built = Writer::check_size(format, &WriteOptions::default(), 3, 1).is_ok();
        let missing = if is_built { "" } else { "; not in this build" };
        let what = format!("{}{missing}", format.description());
        text += &row(format.name(), format.extensions(), way, &what);
    }
    text += "\nOutlines, which become domains\n";
    text += &row("", &["json"], "in, out", "a domain or a model, which mindeg schema describes");
    for format in OutlineFormat::ALL {
        text += &row("", format.extensions(), "in", format.name());
    }
    text += "\nPrograms, whose rules --preset checks\n";
    for preset in &PRESETS {
        text += &terminal::row(&format!("  {:<8}", preset.name), preset.description);
    }
    print(&text)
}
