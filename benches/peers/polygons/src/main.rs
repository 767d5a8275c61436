//! mindeg beside other programs, on polygons of any shape: degree, minimum angle, time, validity.
//!
//! Prints Markdown for `benches/results`. The arguments are folders of ring files, one polygon each,
//! with a line `x y` a point and an empty line between rings: every file of `outlines` is an input of
//! its own, and all files of `icons` together are one. `run` makes these files.

mod input;
mod peers;
mod report;

use cpu_time::ProcessTime;
use input::{Input, generated};
use peers::{PEERS, Triangles};
use report::{Answer, judged};
use std::error::Error;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::time::{Duration, Instant};

/// Programs take turns until each has had so many rounds, or so much time on one input.
const ROUNDS: u32 = 5;
const ENOUGH: Duration = Duration::from_millis(500);

fn main() -> Result<(), Box<dyn Error>> {
    let mut shapes = generated();
    let mut icons = Vec::new();
    for folder in std::env::args().skip(1) {
        let inputs = input::read_folder(Path::new(&folder))?;
        if folder.ends_with("icons") { icons = inputs } else { shapes.extend(inputs) }
    }
    let answers_of = |inputs: &[Input]| -> Result<Vec<Vec<Answer>>, Box<dyn Error>> {
        inputs.iter().map(answers).collect()
    };
    let (of_shapes, of_icons) = (answers_of(&shapes)?, answers_of(&icons)?);
    print!("{}", report::tables(&shapes, &of_shapes, &icons, &of_icons));
    Ok(())
}

/// The triangles that every program makes of an input.
fn answers(input: &Input) -> Result<Vec<Answer>, Box<dyn Error>> {
    let mut best = [Duration::MAX; PEERS.len()];
    let mut spent = [Duration::ZERO; PEERS.len()];
    let mut results: Vec<Triangles> = PEERS.iter().map(|_| Err("not run".into())).collect();
    for _ in 0..ROUNDS {
        for (at, peer) in PEERS.iter().enumerate() {
            if spent[at] < ENOUGH {
                let mut own = None;
                let (watch, start) = (Instant::now(), ProcessTime::now());
                let run = || (peer.run)(input, &mut own);
                results[at] = catch_unwind(AssertUnwindSafe(run))
                    .unwrap_or_else(|_| Err("it panicked".into()));
                // Some say how long they took, where the rest of the work is ours.
                let time = own.unwrap_or(start.elapsed());
                best[at] = best[at].min(time);
                spent[at] += watch.elapsed();
            }
        }
    }
    let judged = results.into_iter().zip(best).map(|(result, time)| judged(input, result, time));
    let answers: Vec<Answer> = judged.collect();
    eprintln!("{}: {}", input.name, report::line(&answers));
    Ok(answers)
}
