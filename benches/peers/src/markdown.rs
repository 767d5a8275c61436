//! The section of `benches/results`.

use crate::Row;
use crate::child::{LIMIT, Outcome};
use crate::clock::{ROUNDS, TOO_MUCH};
use crate::input::{CASES, GROWING};
use crate::measure::{Figures, Validity};
use crate::numbers::{exponent, grouped, significant, time};
use crate::shewchuk;
use std::error::Error;
use std::fmt::Write;
use std::process::Command;
use sysinfo::System;

/// The section from its heading on. The first row is mindeg's.
pub(crate) fn section(rows: &[Row]) -> Result<String, Box<dyn Error>> {
    let titles = CASES.map(|case| case.title);
    let limit = LIMIT.as_secs();
    let mut text = introduction()?;

    text += "\n### Time\n\n";
    let columns = [&titles[..], &["growth", "at the end"]].concat();
    table(&mut text, rows, &columns, |row| {
        let times = row.outcomes.iter().map(|outcome| match outcome {
            Outcome::Done { seconds, figures, .. } => doubtful(figures, time(*seconds)),
            Outcome::TooSlow => format!("over {limit} s"),
            Outcome::Failed(_) => "failed".to_owned(),
        });
        times.chain(growth(row)).collect()
    });
    _ = writeln!(
        text,
        "\n*Growth* is the p of time ∝ nᵖ for n points, by least squares over the inputs up to \
         {} that were done in time; *at the end* is p over the last tenfold alone.",
        titles[GROWING - 1]
    );

    text += "\n### Times as long as mindeg\n\n";
    table(&mut text, rows, &titles, |row| {
        row.outcomes.iter().zip(&rows[0].outcomes).map(ratio).collect()
    });

    text += "\n### Largest degree\n\n";
    figures_table(&mut text, rows, |figures| grouped(figures.max_degree.into()));
    text += "\n### Minimum angle in degrees\n\n";
    figures_table(&mut text, rows, |figures| significant(figures.min_angle));
    text += "\nBoth are those of the triangles that are not flat.\n";

    text += "\n### Validity\n\n";
    table(&mut text, rows, &titles, |row| row.outcomes.iter().map(validity).collect());
    text += "\n*and n flat*: n triangles more than there should be have all points on one side; \
             without them the rest is valid. *n missing*: of the triangles that should be there, \
             flat ones not counted.\n";

    text += "\n### Programs\n\n";
    text += "| program | version | licence | called |\n|---|---|---|---|\n";
    for Row { peer, .. } in rows {
        let version = version(peer.package);
        _ = writeln!(text, "| {} | {version} | {} | {} |", peer.name, peer.licence, peer.called);
    }
    Ok(text)
}

fn introduction() -> Result<String, Box<dyn Error>> {
    Ok(format!(
        "## Beside other programs\n\n\
         Printed by `benches/peers/run --triangle` on {date}: {machine}.\n\n\
         **Bias.** We chose these inputs, and they suit us: convex, no points inside, sides with \
         very many points at equal distances. mindeg can do nothing else. The others are made for \
         points all over the plane or for outlines of any shape; few points inside and many on a \
         line is what several of them take badly, and how badly depends on the shape: see the \
         square. On scattered points or concave outlines they do what mindeg cannot do at all. \
         And the least degree is our aim, not theirs: on the same points, a Delaunay \
         triangulation's minimum angle is always the largest.\n\n\
         **How.** Every program runs in a process of its own and takes turns with mindeg; the best \
         of at least {ROUNDS} rounds counts, or of as many as fit into {patience} s. Times are the \
         processor's, all threads together (mindeg's own are limited to one), which on an idle \
         machine are the clock's. A program is given up when its process has taken {limit} s, \
         checks and all. What is timed goes from \
         points to triangles in the program's own types; in mindeg's case it starts before there \
         are points, at corners and counts.\n\n\
         Four sides are those of a rectangle of 4 by 3, or of the square. The triangle, pentagon \
         and octagon are regular, with 1,000 intervals a side. Figures in parentheses: what came \
         out is no triangulation of the boundary.\n",
        date = jiff::Zoned::now().date(),
        machine = machine()?,
        patience = TOO_MUCH.as_secs(),
        limit = LIMIT.as_secs(),
    ))
}

/// A table with a row for each program.
fn table(text: &mut String, rows: &[Row], columns: &[&str], cells: impl Fn(&Row) -> Vec<String>) {
    _ = writeln!(text, "| | {} |", columns.join(" | "));
    _ = writeln!(text, "|---|{}", "--:|".repeat(columns.len()));
    for row in rows {
        _ = writeln!(text, "| {} | {} |", row.peer.name, cells(row).join(" | "));
    }
}

fn figures_table(text: &mut String, rows: &[Row], cell: impl Fn(&Figures) -> String) {
    table(text, rows, &CASES.map(|case| case.title), |row| {
        let cells = row.outcomes.iter().map(|outcome| match outcome {
            Outcome::Done { figures, .. } => doubtful(figures, cell(figures)),
            _ => "–".to_owned(),
        });
        cells.collect()
    });
}

/// The text, in parentheses where it is about no triangulation.
fn doubtful(figures: &Figures, text: String) -> String {
    match figures.validity {
        Validity::Invalid { .. } => format!("({text})"),
        _ => text,
    }
}

/// How often a program's time holds mindeg's; one that was given up, that of mindeg's own row.
fn ratio((outcome, mindeg): (&Outcome, &Outcome)) -> String {
    match (outcome, mindeg) {
        (Outcome::Done { seconds, mindeg_seconds, figures }, _) => {
            doubtful(figures, significant(seconds / mindeg_seconds))
        }
        (Outcome::TooSlow, Outcome::Done { seconds, .. }) => {
            format!("over {}", significant(LIMIT.as_secs_f64() / seconds))
        }
        _ => "–".to_owned(),
    }
}

fn validity(outcome: &Outcome) -> String {
    let figures = match outcome {
        Outcome::Done { figures, .. } => figures,
        Outcome::TooSlow => return "–".to_owned(),
        Outcome::Failed(how) => return how.clone(),
    };
    match &figures.validity {
        Validity::Valid => "valid".to_owned(),
        Validity::ValidBesidesFlat(flat) => format!("and {} flat", grouped(*flat as u64)),
        Validity::Invalid { missing: 0, defect, .. } => defect.clone(),
        Validity::Invalid { flat: 0, missing, .. } => {
            format!("{} missing", grouped(*missing as u64))
        }
        Validity::Invalid { flat, missing, .. } => {
            format!("{} missing, {} flat", grouped(*missing as u64), grouped(*flat as u64))
        }
    }
}

/// The exponents of the time in the number of points: over all growing inputs that were done,
/// and over the last two.
fn growth(row: &Row) -> [String; 2] {
    let points = |from: usize, of_too_slow: Option<f64>| -> Vec<(f64, f64)> {
        let growing = CASES.iter().zip(&row.outcomes).take(GROWING).skip(from);
        let timed = growing.filter_map(|(case, outcome)| {
            let seconds = match outcome {
                Outcome::Done { seconds, .. } => *seconds,
                Outcome::TooSlow => of_too_slow?,
                Outcome::Failed(_) => return None,
            };
            Some((case.vertices() as f64, seconds))
        });
        timed.collect()
    };
    let all = exponent(&points(0, None)).map(|p| format!("{p:.2}"));
    let last = exponent(&points(GROWING - 2, Some(LIMIT.as_secs_f64())));
    let at_the_end = match (&row.outcomes[GROWING - 2], &row.outcomes[GROWING - 1]) {
        (Outcome::Done { .. }, Outcome::TooSlow) => last.map(|p| format!("over {p:.2}")),
        (Outcome::Done { .. }, _) => last.map(|p| format!("{p:.2}")),
        _ => None,
    };
    [all, at_the_end].map(|p| p.unwrap_or_else(|| "–".to_owned()))
}

/// The machine and what it runs on.
fn machine() -> Result<String, Box<dyn Error>> {
    let system = System::new_all()?;
    let processor = system.cpus().first().map_or("", |cpu| cpu.brand()).trim();
    let cores = system.cpus().len();
    let gibibytes = system.total_memory() >> 30;
    let os = System::long_os_version()?;
    let load = System::load_average()?.fifteen;
    let rustc = Command::new("rustc").arg("--version").output()?;
    let rustc = String::from_utf8_lossy(&rustc.stdout);
    let rustc = rustc.split(" (").next().unwrap_or_default();
    Ok(format!(
        "{processor}, {cores} cores (load average {load:.0}), {gibibytes} GiB, {os}, {rustc}"
    ))
}

/// The version of a package in `Cargo.lock`.
fn version(package: &str) -> &'static str {
    if package == shewchuk::PACKAGE {
        return shewchuk::version();
    }
    let name = format!("name = \"{package}\"");
    let mut lines = include_str!("../Cargo.lock").lines().skip_while(|&line| line != name);
    let version = lines.nth(1).and_then(|line| line.strip_prefix("version = \""));
    version.map_or("", |version| version.trim_end_matches('"'))
}
