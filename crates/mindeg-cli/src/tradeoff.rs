//! `mindeg tradeoff`: what every degree buys.

use crate::args::TradeoffArguments;
use crate::bar::Bar;
use crate::domain::domain;
use crate::failure::Failure;
use crate::interrupt::clean_up_on_interrupt;
use crate::mesh::{degrees, unsolved};
use crate::output::Outputs;
use crate::standard_output::{print, print_json};
use mindeg::Progress;
use mindeg::exact::{self, TradeOff};
use mindeg_compare::{
    TradeOffFigures, write_trade_off_html, write_trade_off_json, write_trade_off_svg,
};
use std::fmt::Write as _;
use std::io::{self, Write};
use std::path::Path;

type Writer = fn(&TradeOff, &mut dyn Write) -> io::Result<()>;

pub(crate) fn run(arguments: &TradeoffArguments) -> Result<(), Failure> {
    let writers: Vec<Writer> =
        arguments.output.iter().map(|path| writer(path)).collect::<Result<_, _>>()?;
    let domain = domain(&arguments.domain)?;
    clean_up_on_interrupt()?;
    let bar = Bar::new(arguments.quiet);
    let callback = bar.callback();
    let trade_off = exact::trade_off(&domain, Progress::new(&callback))
        .map_err(|error| unsolved(&error, "take mindeg mesh for the mesh of least degree"))?;
    drop(callback);
    drop(bar);
    let mut outputs = Outputs::default();
    for (path, write) in arguments.output.iter().zip(writers) {
        outputs.write(path, |out| write(&trade_off, out))?;
    }
    outputs.finish()?;
    if arguments.json {
        print_json(&TradeOffFigures::of(&trade_off))
    } else {
        print(&table(&trade_off))
    }
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

fn table(trade_off: &TradeOff) -> String {
    let mut text = String::from("maximum degree  smallest angle  of Delaunay's\n");
    for exact in trade_off.meshes() {
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "{:>14}  {:>14}  {:>12.1}%",
            exact.max_degree,
            degrees(exact.min_angle),
            100.0 * trade_off.share(exact),
        );
    }
    text
}
