//! Triangle, Jonathan Shewchuk's program, in a Python of its own.
//!
//! Its licence forbids selling it, so nothing here links to it: whoever may use it names, in the
//! variable `TRIANGLE_PYTHON`, an interpreter that has `shewchuk.requirements.txt` installed.

use crate::child::LIMIT;
use crate::clock::Clock;
use crate::input::Input;
use crate::peer::Triangles;
use std::error::Error;
use std::ffi::OsString;
use std::fmt;
use std::io::Write;
use std::os::unix::process::ExitStatusExt;
use std::process::{Command, Stdio};
use std::time::Duration;

/// How the system ends a process that has used up its time.
const SIGKILL: i32 = 9;
const SIGXCPU: i32 = 24;

/// Triangle was not done within the limit.
#[derive(Debug)]
pub(crate) struct TooSlow;

impl fmt::Display for TooSlow {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("not done within the limit")
    }
}

impl Error for TooSlow {}

const PYTHON: &str = "TRIANGLE_PYTHON";

pub(crate) const PACKAGE: &str = "triangle";

/// The interpreter that has Triangle, if there is one.
pub(crate) fn python() -> Option<OsString> {
    std::env::var_os(PYTHON)
}

/// The version of the Python package.
pub(crate) fn version() -> &'static str {
    let pinned = include_str!("../shewchuk.requirements.txt").lines();
    pinned.filter_map(|line| line.strip_prefix("triangle==")).next().unwrap_or_default()
}

pub(crate) fn run(input: &Input, clock: &mut Clock<'_>) -> Triangles {
    let python = python().ok_or_else(|| format!("{PYTHON} is not set"))?;
    let points: Vec<u8> =
        input.points.iter().flat_map(|p| [p.x, p.y]).flat_map(f64::to_le_bytes).collect();
    let answer = clock.take(|| ask(&python, &points))?;
    let ids = answer.chunks_exact(4).map(|id| u32::from_le_bytes([id[0], id[1], id[2], id[3]]));
    let ids: Vec<u32> = ids.collect();
    Ok(ids.chunks_exact(3).map(|of| [of[0], of[1], of[2]]).collect())
}

/// The best time of several runs, and the bytes of the triangles.
fn ask(python: &OsString, points: &[u8]) -> Result<(Duration, Vec<u8>), Box<dyn Error>> {
    let mut child = Command::new(python)
        .args(["-I", "-c", include_str!("../shewchuk.py"), &LIMIT.as_secs().to_string()])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()?;
    // It reads everything before it writes anything.
    child.stdin.take().ok_or("no standard input")?.write_all(points)?;
    let output = child.wait_with_output()?;
    // It has a limit of its own, since this process' does not count what a child takes.
    if matches!(output.status.signal(), Some(SIGKILL | SIGXCPU)) {
        return Err(TooSlow.into());
    }
    if !output.status.success() {
        return Err(output.status.to_string().into());
    }
    let (seconds, triangles) = output.stdout.split_first_chunk().ok_or("no answer")?;
    Ok((Duration::try_from_secs_f64(f64::from_le_bytes(*seconds))?, triangles.to_vec()))
}
