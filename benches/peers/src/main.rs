//! mindeg beside other programs, on the same boundaries.
//!
//! Without arguments, prints Markdown for `benches/results`; how it gets on goes to standard
//! error. With a program and an input, as `spade-bulk 4x100`, runs just these and prints what came
//! of it as JSON. The script `run` also sets up Triangle, if asked to.
//!
//! Bias: see the first lines of what it prints.

mod child;
mod clock;
mod input;
mod markdown;
mod measure;
mod numbers;
mod peer;
mod shewchuk;

use child::Outcome;
use input::CASES;
use peer::{PEERS, Peer};
use std::error::Error;

/// The outcome of one program on all inputs.
struct Row {
    peer: &'static Peer,
    outcomes: Vec<Outcome>,
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match &arguments[..] {
        [] => compare(),
        [peer, case] => {
            let peer = PEERS.iter().find(|known| known.id == peer).ok_or_else(usage)?;
            let case = CASES.iter().find(|known| known.id == case).ok_or_else(usage)?;
            child::run(peer, case)
        }
        _ => Err(usage().into()),
    }
}

fn usage() -> String {
    let peers = PEERS.map(|peer| peer.id).join(" ");
    let cases = CASES.map(|case| case.id).join(" ");
    format!("name nothing, or one of: {peers}; and one of: {cases}")
}

fn compare() -> Result<(), Box<dyn Error>> {
    let has_triangle = shewchuk::python().is_some();
    let mut rows = Vec::new();
    for peer in PEERS.iter().filter(|peer| has_triangle || peer.package != shewchuk::PACKAGE) {
        let mut outcomes = Vec::new();
        for case in &CASES {
            let outcome = child::spawn(peer, case)?;
            eprintln!("{}, {}: {outcome:?}", case.title, peer.name);
            outcomes.push(outcome);
        }
        rows.push(Row { peer, outcomes });
    }
    print!("{}", markdown::section(&rows)?);
    Ok(())
}
