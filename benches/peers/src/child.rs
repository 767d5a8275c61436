//! One program on one input, in a process of its own: what it does to the process, running on for
//! ever or overflowing the stack, it does to no other.

use crate::clock::Clock;
use crate::input::{Case, Input};
use crate::measure::{Figures, measure};
use crate::peer::{self, Peer};
use crate::shewchuk::TooSlow;
use cpu_time::ProcessTime;
use serde::{Deserialize, Serialize};
use std::error::Error;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::process::Command;
use std::thread;
use std::time::Duration;

/// The processor time after which a program is given up.
pub(crate) const LIMIT: Duration = Duration::from_secs(60);

/// The outcome of running a program.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) enum Outcome {
    /// Triangles, right or wrong.
    Done {
        seconds: f64,
        /// mindeg's on the same input in the same process.
        mindeg_seconds: f64,
        figures: Figures,
    },
    /// It was not done within the limit.
    TooSlow,
    /// It refused, or crashed.
    Failed(String),
}

/// Runs a program in this process and prints the outcome as JSON.
pub(crate) fn run(peer: &Peer, case: &Case) -> Result<(), Box<dyn Error>> {
    let input = case.input()?;
    thread::spawn(|| {
        let start = ProcessTime::now();
        while start.elapsed() < LIMIT {
            thread::sleep(Duration::from_millis(100));
        }
        print(&Outcome::TooSlow);
        std::process::exit(0);
    });
    let outcome = catch_unwind(AssertUnwindSafe(|| outcome(peer, &input)))
        .unwrap_or_else(|_| Outcome::Failed("panicked".to_owned()));
    print(&outcome);
    Ok(())
}

fn outcome(peer: &Peer, input: &Input) -> Outcome {
    // Its own row says it when mindeg fails.
    let mindeg = || drop(peer::mindeg(input));
    let mut clock = Clock::new(&mindeg);
    match (peer.run)(input, &mut clock) {
        Ok(triangles) => {
            let (seconds, mindeg_seconds) = clock.seconds();
            Outcome::Done { seconds, mindeg_seconds, figures: measure(input, triangles) }
        }
        Err(error) if error.is::<TooSlow>() => Outcome::TooSlow,
        Err(error) => Outcome::Failed(error.to_string()),
    }
}

fn print(outcome: &Outcome) {
    match serde_json::to_string(outcome) {
        Ok(line) => println!("{line}"),
        Err(error) => eprintln!("{error}"),
    }
}

/// Runs a program in a child process.
pub(crate) fn spawn(peer: &Peer, case: &Case) -> Result<Outcome, Box<dyn Error>> {
    let output = Command::new(std::env::current_exe()?)
        .args([peer.id, case.id])
        // One core for everybody.
        .env("RAYON_NUM_THREADS", "1")
        .output()?;
    let stdout = String::from_utf8_lossy(&output.stdout);
    let answer = stdout.lines().last().and_then(|line| serde_json::from_str(line).ok());
    Ok(answer.unwrap_or_else(|| {
        let stderr = String::from_utf8_lossy(&output.stderr);
        let stack = stderr.contains("has overflowed its stack");
        let how = if stack { "stack overflow".to_owned() } else { output.status.to_string() };
        Outcome::Failed(how)
    }))
}
