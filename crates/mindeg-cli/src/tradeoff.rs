//! `mindeg tradeoff`: what every degree buys.

use crate::args::TradeoffArguments;
use crate::bar::Bar;
use crate::domain::subject;
use crate::failure::Failure;
use crate::interrupt::{SESSION, clean_up_on_interrupt};
use crate::making::wrote;
use crate::mesh::unsolved;
use crate::standard_output::{print, print_json};
use crate::suggest::{left_out, spread};
use crate::terminal::say;
use mindeg::beside::each;
use mindeg::exact::{self, TradeOff};
use mindeg_answers::numbers::{steady_angle, steady_percent};
use mindeg_answers::trade_off::TradeOffAnswer;
use mindeg_compare::{write_trade_off_html, write_trade_off_json, write_trade_off_svg};
use mindeg_files::{Outputs, Wanted, write_to};
use std::fmt::Write as _;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Writes a trade-off that is drawn, or the figures of all.
type Writer = fn(&TradeOff, &TradeOffAnswer, &mut dyn Write) -> io::Result<()>;

pub(crate) fn run(arguments: &TradeoffArguments) -> Result<(), Failure> {
    let writers: Vec<Writer> =
        arguments.output.iter().map(|path| writer(path)).collect::<Result<_, _>>()?;
    let parts = subject(&arguments.domain, Wanted::Domain, &Bar::new(true))?.parts()?;
    if let (true, Some(page)) =
        (parts.domains.len() > 1, arguments.output.iter().find(|path| draws(path)))
    {
        return Err(Failure::Input(format!(
            "-o {}: a picture shows one domain, and the file has {} parts that share no edge; choose one with --feature, \
             or write the figures to a .json",
            page.display(),
            parts.domains.len()
        )));
    }
    clean_up_on_interrupt()?;
    // Refuse outputs that cannot be written before the work, which can take minutes.
    let mut outputs = Outputs::new(&SESSION);
    let open = |path: &PathBuf| outputs.open(path);
    let opened: Vec<_> = arguments.output.iter().map(open).collect::<Result<_, _>>()?;

    let trade_offs = Bar::new(arguments.quiet)
        .work(|progress| each(&parts.domains, "searching for angles", progress, exact::trade_off))
        .map_err(|(index, error)| {
            let failure = unsolved(&error, "take mindeg mesh for the mesh of least degree");
            parts.failure((index, failure))
        })?;
    let answer = match &trade_offs[..] {
        [one] => TradeOffAnswer::of(one),
        all => TradeOffAnswer::of_all(all),
    };
    for ((path, out), write) in arguments.output.iter().zip(opened).zip(writers) {
        write_to(path, out, |out| write(&trade_offs[0], &answer, out))?;
    }
    outputs.finish()?;
    let files: Vec<_> = arguments.output.iter().map(|path| path.display().to_string()).collect();
    if let Some(line) = wrote(&files).filter(|_| !arguments.quiet) {
        say(&line);
    }
    if arguments.json { print_json(&answer) } else { print(&table(&answer, arguments.limit)) }
}

fn writer(path: &Path) -> Result<Writer, Failure> {
    match extension(path).as_deref() {
        Some("html" | "htm") => Ok(|drawn, _, out| write_trade_off_html(drawn, out)),
        Some("svg") => Ok(|drawn, _, out| write_trade_off_svg(drawn, out)),
        Some("json") => Ok(|_, answer, out| write_trade_off_json(answer, out)),
        _ => Err(Failure::Input(format!(
            "-o {}: a trade-off ends in .html, .svg or .json",
            path.display()
        ))),
    }
}

fn extension(path: &Path) -> Option<String> {
    path.extension().map(|name| name.to_string_lossy().to_lowercase())
}

/// Whether a report draws the domain.
fn draws(path: &Path) -> bool {
    extension(path).as_deref() != Some("json")
}

fn table(answer: &TradeOffAnswer, limit: u32) -> String {
    let mut text = String::from("maximum degree   minimum angle  of Delaunay's\n");
    let points = &answer.points;
    let advised = points.iter().position(|point| Some(point.max_degree) == answer.advised);
    let rows = spread(points.len(), limit, advised);
    for &row in &rows {
        let point = &points[row];
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "{:>14}  {:>14}  {:>13}{}",
            point.max_degree,
            steady_angle(point.min_angle),
            steady_percent(point.share_of_delaunay),
            if advised == Some(row) { "  advised" } else { "" },
        );
    }
    text.push_str(&left_out(rows.len(), points.len()));
    if let Some(question) = answer.open_question() {
        let _ = writeln!(
            text,
            "{question} All meshes are searched only\nwithout holes, and where few vertices see each \
             other."
        );
    }
    text
}
