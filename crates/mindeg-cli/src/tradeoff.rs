//! `mindeg tradeoff`: what every degree buys.

use crate::args::TradeoffArguments;
use crate::bar::Bar;
use crate::domain::domain;
use crate::failure::Failure;
use crate::interrupt::{SESSION, clean_up_on_interrupt};
use crate::making::wrote;
use crate::mesh::unsolved;
use crate::standard_output::{print, print_json};
use crate::suggest::{left_out, spread};
use crate::terminal::say;
use mindeg::exact::{self, TradeOff};
use mindeg_answers::numbers::{steady_angle, steady_percent};
use mindeg_answers::trade_off::TradeOffAnswer;
use mindeg_compare::{write_trade_off_html, write_trade_off_json, write_trade_off_svg};
use mindeg_files::{Outputs, write_to};
use std::fmt::Write as _;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

type Writer = fn(&TradeOff, &mut dyn Write) -> io::Result<()>;

pub(crate) fn run(arguments: &TradeoffArguments) -> Result<(), Failure> {
    let writers: Vec<Writer> =
        arguments.output.iter().map(|path| writer(path)).collect::<Result<_, _>>()?;
    let domain = domain(&arguments.domain)?;
    clean_up_on_interrupt()?;
    // Refuse outputs that cannot be written before the work, which can take minutes.
    let mut outputs = Outputs::new(&SESSION);
    let open = |path: &PathBuf| outputs.open(path);
    let opened: Vec<_> = arguments.output.iter().map(open).collect::<Result<_, _>>()?;

    let trade_off = Bar::new(arguments.quiet)
        .work(|progress| exact::trade_off(&domain, progress))
        .map_err(|error| unsolved(&error, "take mindeg mesh for the mesh of least degree"))?;
    for ((path, out), write) in arguments.output.iter().zip(opened).zip(writers) {
        write_to(path, out, |out| write(&trade_off, out))?;
    }
    outputs.finish()?;
    let files: Vec<_> = arguments.output.iter().map(|path| path.display().to_string()).collect();
    if let Some(line) = wrote(&files).filter(|_| !arguments.quiet) {
        say(&line);
    }
    let answer = TradeOffAnswer::of(&trade_off);
    if arguments.json { print_json(&answer) } else { print(&table(&answer, arguments.limit)) }
}

fn writer(path: &Path) -> Result<Writer, Failure> {
    let extension = path.extension().map(|name| name.to_string_lossy().to_lowercase());
    match extension.as_deref() {
        Some("html" | "htm") => Ok(|trade_off, out| write_trade_off_html(trade_off, out)),
        Some("svg") => Ok(|trade_off, out| write_trade_off_svg(trade_off, out)),
        Some("json") => Ok(|trade_off, out| write_trade_off_json(trade_off, out)),
        _ => Err(Failure::Input(format!(
            "-o {}: a trade-off ends in .html, .svg or .json",
            path.display()
        ))),
    }
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
