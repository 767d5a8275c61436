//! What is left to do when the process is told to stop: delete the temporary files.
//!
//! Limits: nobody is told of SIGKILL or of power that fails. Then `.mindeg-*.part` stays behind;
//! what has its final name is whole even so.

use crate::bar;
use crate::failure::Failure;
use std::fs;
use std::io;
use std::path::PathBuf;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// The temporary files there are.
static TEMPORARY: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// The list of the temporary files. An interrupt waits for as long as it is held: for a file to be
/// made and listed, or for several to get their names, all or none.
pub(crate) fn temporary() -> MutexGuard<'static, Vec<PathBuf>> {
    TEMPORARY.lock().unwrap_or_else(PoisonError::into_inner)
}

/// From here on, Ctrl-C and its like delete the temporary files before they end the process.
pub(crate) fn clean_up_on_interrupt() -> Result<(), Failure> {
    listen().map_err(|error| Failure::Io(format!("cannot listen for Ctrl-C: {error}")))
}

/// Deletes the temporary files and ends the process.
fn end(process: impl FnOnce()) {
    // Never given back: what would make or rename a file from here on must wait for the end.
    let temporary = temporary();
    for path in temporary.iter() {
        // A file renamed or deleted meanwhile is no longer there under this name.
        let _ = fs::remove_file(path);
    }
    bar::clear();
    process();
}

/// A signal that is to be ignored stays so: a run started by nohup outlives its terminal.
#[cfg(unix)]
fn listen() -> io::Result<()> {
    use signal_hook::consts::{SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGXCPU, SIGXFSZ};
    let ignored = ignored_signals();
    let heard = [SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGXCPU]
        .into_iter()
        .filter(|signal| ignored >> (signal - 1) & 1 == 0);
    let mut signals = signal_hook::iterator::Signals::new(heard)?;
    // A file that grows beyond what the system allows is then an error of the one who writes it.
    signal_hook::flag::register(SIGXFSZ, std::sync::Arc::default())?;
    std::thread::Builder::new().spawn(move || {
        if let Some(signal) = signals.forever().next() {
            // Ended by the signal, as if nobody had listened: a shell then stops its script too.
            end(|| {
                let _ = signal_hook::low_level::emulate_default_handler(signal);
                std::process::exit(128 + signal);
            });
        }
    })?;
    Ok(())
}

/// The signals that this process was started to ignore, as bits from SIGHUP's, 1, on; none where
/// the system does not say.
#[cfg(unix)]
fn ignored_signals() -> u64 {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok()).unwrap_or_default()
}

#[cfg(not(unix))]
fn listen() -> io::Result<()> {
    // What shells report for a program that Ctrl-C ended.
    ctrlc::set_handler(|| end(|| std::process::exit(130))).map_err(io::Error::other)
}
