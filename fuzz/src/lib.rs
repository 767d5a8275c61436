//! Hostile input for every door into mindeg. A target takes any bytes, makes an input of them and asserts
//! what must hold. `cargo test` runs the seeds; `fuzz/run` has libFuzzer make more (README.md).

mod counts;
mod degree;
mod domain_json;
mod explore;
mod hostile;
mod improve;
mod interior;
mod loops;
mod mesh_files;
mod model;
mod outlines;
mod placement;
mod rings;

use arbitrary::{Arbitrary, Unstructured};

/// Takes any bytes and panics where mindeg breaks a promise.
pub type Target = fn(&[u8]);

/// Each target with the name of its folder of seeds.
pub const TARGETS: [(&str, Target); 12] = [
    ("counts", |bytes| of_any(bytes, counts::run)),
    ("degree", |bytes| of_any(bytes, degree::run)),
    ("domain_json", |bytes| of_any(bytes, domain_json::run)),
    ("explore", explore::run),
    ("improve", |bytes| of_any(bytes, improve::run)),
    ("interior", |bytes| of_any(bytes, interior::run)),
    ("loops", |bytes| of_any(bytes, loops::run)),
    ("mesh_files", mesh_files::run),
    ("model", |bytes| of_any(bytes, model::run)),
    ("outlines", outlines::run),
    ("placement", |bytes| of_any(bytes, placement::run)),
    ("rings", |bytes| of_any(bytes, rings::run)),
];

/// Runs a target on the input that the bytes spell, as libFuzzer does; too few bytes run nothing.
fn of_any<'a, Input: Arbitrary<'a>>(bytes: &'a [u8], run: fn(Input)) {
    if bytes.len() >= Input::size_hint(0).0
        && let Ok(input) = Input::arbitrary_take_rest(Unstructured::new(bytes))
    {
        run(input);
    }
}

#[cfg(test)]
mod tests {
    use super::TARGETS;
    use std::path::{Path, PathBuf};
    use std::sync::mpsc;
    use std::time::Duration;
    use std::{fs, thread};

    /// No seed takes a second where nothing else runs: after this long one hangs.
    const PATIENCE: Duration = Duration::from_secs(300);

    fn seeds(target: &str) -> Vec<PathBuf> {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("seeds").join(target);
        let entries = fs::read_dir(folder).expect("every target has a folder of seeds");
        let mut paths: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
        paths.sort();
        paths
    }

    #[test]
    fn every_seed_passes() {
        let (send, receive) = mpsc::channel();
        let replay = move || {
            for (name, run) in TARGETS {
                for seed in seeds(name) {
                    let _ = send.send(format!("{name}/{}", seed.file_name().unwrap().display()));
                    run(&fs::read(seed).unwrap());
                }
            }
        };
        let replay = thread::spawn(replay);
        let mut running = "nothing".to_owned();
        let end = loop {
            match receive.recv_timeout(PATIENCE) {
                Ok(seed) => running = seed,
                Err(end) => break end,
            }
        };
        assert_eq!(end, mpsc::RecvTimeoutError::Disconnected, "{running} hangs");
        assert!(replay.join().is_ok(), "{running} fails");
    }

    #[test]
    fn bytes_that_are_too_few_are_no_input() {
        for (_, run) in TARGETS {
            run(&[]);
        }
    }
}
