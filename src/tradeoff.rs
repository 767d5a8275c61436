//! `mindeg tradeoff`: what every degree buys.

use crate::args::TradeoffArguments;
use crate::bar::Bar;
use crate::domain::subject;
use crate::failure::Failure;
use crate::interrupt::{SESSION, clean_up_on_interrupt};
use crate::making::wrote;
use crate::mesh::unsolved;
use crate::provenance::provenance_of;
use crate::standard_output::{print, print_json};
use crate::suggest::{left_out, spread};
use crate::terminal::say;
use mindeg::beside::each;
use mindeg::exact::{self, TradeOff};
use mindeg::{Domain, TriMesh};
use mindeg_answers::advice::{Advice, AdvisedMesh, Purpose};
use mindeg_answers::numbers::{counted, percent, steady_angle};
use mindeg_answers::trade_off::TradeOffAnswer;
use mindeg_compare::{write_trade_off_html, write_trade_off_json, write_trade_off_svg};
use mindeg_files::{Outputs, Wanted, write_to};
use std::fmt::Write as _;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// The figures of all trade-offs, and of one also the mesh with points inside.
struct Found {
    answer: TradeOffAnswer,
    told: Option<Purpose>,
    inside: Option<TriMesh>,
}

/// Writes a trade-off that is drawn, or the figures of all.
type Writer = fn(&TradeOff, &Found, Option<&Path>, &mut dyn Write) -> io::Result<()>;

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
    let told = arguments.purpose.purpose;
    let (advice, inside) = advice(&parts.domains, arguments.quiet);
    let answer = match &trade_offs[..] {
        [one] => TradeOffAnswer::of(one),
        all => TradeOffAnswer::of_all(all),
    };
    let answer = answer.with_advice(advice);
    let found = Found { answer, told, inside };
    let input = arguments.domain.file.as_deref();
    for ((path, out), write) in arguments.output.iter().zip(opened).zip(writers) {
        write_to(path, out, |out| write(&trade_offs[0], &found, input, out))?;
    }
    outputs.finish()?;
    let files: Vec<_> = arguments.output.iter().map(|path| path.display().to_string()).collect();
    if let Some(line) = wrote(&files).filter(|_| !arguments.quiet) {
        say(&line);
    }
    if arguments.json {
        print_json(&found.answer)
    } else {
        print(&table(&found.answer, arguments.limit, told))
    }
}

fn writer(path: &Path) -> Result<Writer, Failure> {
    match extension(path).as_deref() {
        Some("html" | "htm") => Ok(|drawn, found, input, out| {
            let advice = found.answer.advice.clone().unwrap_or(Advice::UNMEASURED);
            let inside = found.inside.as_ref();
            let made_by = provenance_of(drawn.domain(), input);
            write_trade_off_html(drawn, &advice, found.told, inside, made_by, out)
        }),
        Some("svg") => Ok(|drawn, _, _, out| write_trade_off_svg(drawn, out)),
        Some("json") => Ok(|_, found, _, out| write_trade_off_json(&found.answer, out)),
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

/// The meshes to take, and the one with points inside.
fn advice(domains: &[Domain], quiet: bool) -> (Advice, Option<TriMesh>) {
    let found = Bar::new(quiet).work(|progress| Advice::with_mesh(domains, progress));
    let Ok((advice, inside)) = found else { return (Advice::UNMEASURED, None) };
    (advice, inside.map(|found| found.mesh))
}

fn table(answer: &TradeOffAnswer, limit: u32, told: Option<Purpose>) -> String {
    let mut text = String::from("maximum degree   minimum angle  of Delaunay's\n");
    let points = &answer.points;
    let patch = points.iter().position(|point| Some(point.max_degree) == answer.advised);
    let taken = match told {
        None | Some(Purpose::Patch) => patch.map(|row| (row, "  for a patch")),
        Some(Purpose::Fewest) => Some((0, "  fewest edges")),
        Some(Purpose::Solver) => None,
    };
    let rows = spread(points.len(), limit, taken.map(|taken| taken.0));
    for &row in &rows {
        let point = &points[row];
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "{:>14}  {:>14}  {:>13}{}",
            point.max_degree,
            steady_angle(point.min_angle),
            percent(point.share_of_limit),
            taken.filter(|taken| taken.0 == row).map_or("", |taken| taken.1),
        );
    }
    if let Some(advice) = &answer.advice {
        let on_edges = counted(advice.points_on_edges as u64, "point");
        let rows = [
            (advice.solver, "with points inside".to_owned()),
            (advice.conditioned, format!("with {on_edges} on edges, too")),
        ];
        for (mesh, words) in rows {
            let Some(AdvisedMesh { max_degree, min_angle, share_of_delaunay }) = mesh else {
                continue;
            };
            let share = share_of_delaunay.map_or_else(|| "–".to_owned(), percent);
            let angle = steady_angle(min_angle);
            let _ = writeln!(text, "{max_degree:>14}  {angle:>14}  {share:>13}  {words}");
        }
    }
    text.push_str(&left_out(rows.len(), points.len()));
    if let Some(question) = answer.open_question() {
        let _ = writeln!(text, "{question}");
    }
    text.extend(answer.advice.as_ref().map(|advice| advice.text(told) + "\n"));
    text
}
