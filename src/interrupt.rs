//! The cleanup when a signal stops the process: delete the temporary files.
//!
//! Limits: SIGKILL and a power failure cannot be caught. Then `.mindeg-*.part` stays behind.
//! Nothing waits for the disk, so what is left of a file after a power failure is up to the file
//! system. Only Linux tells which signals are to be ignored; elsewhere mindeg handles all.

use crate::bar;
use crate::failure::Failure;
use mindeg_files::{Session, plainly};
use std::fs;
use std::io;
use std::sync::mpsc;
use std::thread;
use std::time::Duration;

/// How long a terminal may take to clear the bar: one that is stopped takes for ever.
const CLEARING: Duration = Duration::from_millis(100);

/// The files that this run has read and is writing.
pub(crate) static SESSION: Session = Session::new("--");

/// From here on, Ctrl-C and its like delete the temporary files before they end the process.
pub(crate) fn clean_up_on_interrupt() -> Result<(), Failure> {
    listen().map_err(|error| Failure::Io(format!("cannot listen for Ctrl-C: {}", plainly(&error))))
}

/// Deletes the temporary files and ends the process.
fn end(process: impl FnOnce()) {
    // Never given back: what would make or rename a file from here on must wait for the end.
    let temporary = SESSION.temporary();
    for path in temporary.iter() {
        // A file renamed or deleted meanwhile no longer exists under this name.
        if fs::remove_file(path).is_err() {
            // The folder of a mesh that is made anew.
            let _ = fs::remove_dir_all(path);
        }
    }
    let (clearing, cleared) = mpsc::channel();
    let cleaner = thread::Builder::new().spawn(move || {
        bar::clear();
        let _ = clearing.send(());
    });
    if cleaner.is_ok() {
        let _ = cleared.recv_timeout(CLEARING);
    }
    process();
}

/// How long cleaning may take before another signal ends the process at once.
#[cfg(unix)]
const CLEANING: Duration = Duration::from_secs(1);

/// A signal that is to be ignored stays so: a run started by nohup outlives its terminal.
#[cfg(unix)]
fn listen() -> io::Result<()> {
    use std::time::Instant;

    use signal_hook::consts::*;
    let ignored = ignored_signals();
    // All that come from outside and end a process that does not hear them.
    let ending =
        [SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGXCPU, SIGUSR1, SIGUSR2, SIGALRM, SIGVTALRM, SIGPROF];
    let heard = ending.into_iter().filter(|signal| ignored >> (signal - 1) & 1 == 0);
    let mut signals = signal_hook::iterator::Signals::new(heard)?;
    // A file that grows beyond what the system allows is then an error of the one who writes it.
    signal_hook::flag::register(SIGXFSZ, std::sync::Arc::default())?;
    thread::Builder::new().spawn(move || {
        let mut first: Option<Instant> = None;
        for signal in signals.forever() {
            match first {
                None => {
                    first = Some(Instant::now());
                    let cleaner = thread::Builder::new().spawn(move || end(|| end_by(signal)));
                    cleaner.map_or_else(|_| end(|| end_by(signal)), drop);
                }
                // A file system that does not answer holds up the cleaning.
                Some(first) if first.elapsed() >= CLEANING => end_by(signal),
                Some(_) => {}
            }
        }
    })?;
    Ok(())
}

/// Ended by the signal, as if nobody had listened: a shell then stops its script, too.
#[cfg(unix)]
fn end_by(signal: i32) {
    let _ = signal_hook::low_level::emulate_default_handler(signal);
    std::process::exit(128 + signal);
}

/// The signals that this process was started to ignore, as bits from SIGHUP's, 1, on; 0 where
/// the system does not say.
#[cfg(unix)]
fn ignored_signals() -> u64 {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok()).unwrap_or_default()
}

/// Without signals that tell which they are, poll the flags ten times a second.
#[cfg(not(unix))]
fn listen() -> io::Result<()> {
    use std::sync::Arc;
    use std::sync::atomic::{AtomicBool, Ordering::Relaxed};

    use signal_hook::consts::{SIGINT, SIGTERM};
    const TICK: Duration = Duration::from_millis(100);
    let stopped = Arc::new(AtomicBool::new(false));
    for signal in [SIGINT, SIGTERM] {
        signal_hook::flag::register(signal, Arc::clone(&stopped))?;
    }
    thread::Builder::new().spawn(move || {
        while !stopped.load(Relaxed) {
            thread::sleep(TICK);
        }
        // The exit code that shells report for a program that Ctrl-C ended.
        end(|| std::process::exit(130));
    })?;
    Ok(())
}
