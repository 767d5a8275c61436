//! Running the binary.

#[cfg(unix)]
use rustix::process::{Pid, Signal, kill_process, kill_process_group};
use serde_json::Value;
use std::ffi::OsStr;
use std::io::{Read, Write};
#[cfg(unix)]
use std::path::Path;
use std::process::{Child, ChildStdout, Command, ExitStatus, Output, Stdio};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

/// The exit code and the output of a run.
#[derive(Debug)]
pub(crate) struct Run {
    pub(crate) code: Option<i32>,
    pub(crate) output: Vec<u8>,
    pub(crate) errors: String,
}

impl Run {
    /// Standard output as text.
    pub(crate) fn text(&self) -> &str {
        std::str::from_utf8(&self.output).expect("the output is text")
    }

    /// Standard output as JSON, of a run that went well.
    #[track_caller]
    pub(crate) fn json(&self) -> Value {
        assert_eq!(self.code, Some(0), "{}", self.errors);
        serde_json::from_str(self.text()).expect("the output is JSON")
    }

    /// Fails unless the run refused its input with a message that holds all these words.
    #[track_caller]
    pub(crate) fn refuses(&self, words: &[&str]) {
        assert_eq!(self.code, Some(2), "{self:?}");
        assert!(self.output.is_empty(), "{self:?}");
        for word in words {
            assert!(self.errors.contains(word), "{word:?} is missing in: {}", self.errors);
        }
        assert!(!self.errors.contains("panicked"), "{}", self.errors);
    }
}

/// How long a run may take before it counts as one that never ends. Machines can be busy.
const DEADLINE: Duration = Duration::from_secs(300);

/// A started program. It is killed, with all that it started, when it is dropped or does not end.
#[derive(Debug)]
pub(crate) struct Running {
    child: Child,
    ended: bool,
}

impl Running {
    /// Starts a program in a process group of its own.
    pub(crate) fn start(command: &mut Command) -> Self {
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(command, 0);
        Self { child: command.spawn().expect("the program starts"), ended: false }
    }

    pub(crate) fn id(&self) -> u32 {
        self.child.id()
    }

    /// Sends a signal by its number.
    #[cfg(unix)]
    #[track_caller]
    pub(crate) fn send(&self, signal: i32) {
        let signal = Signal::from_named_raw(signal).expect("the signal has a name");
        kill_process(Pid::from_child(&self.child), signal)
            .expect("the program has not been waited for");
    }

    /// The output of the program, to read here.
    pub(crate) fn take_output(&mut self) -> ChildStdout {
        self.child.stdout.take().expect("standard output is piped")
    }

    /// Waits for the end, for as long as a run may take.
    #[track_caller]
    pub(crate) fn status(&mut self) -> ExitStatus {
        let start = Instant::now();
        loop {
            if let Some(status) = self.child.try_wait().expect("it is our child") {
                self.ended = true;
                return status;
            }
            assert!(start.elapsed() < DEADLINE, "the run does not end");
            thread::sleep(Duration::from_millis(2));
        }
    }

    /// Waits for the end, and gives what the program printed where nobody else took it.
    #[track_caller]
    pub(crate) fn output(mut self) -> Output {
        fn all(stream: Option<impl Read + Send + 'static>) -> JoinHandle<Vec<u8>> {
            thread::spawn(move || {
                let mut bytes = Vec::new();
                if let Some(mut stream) = stream {
                    let _ = stream.read_to_end(&mut bytes);
                }
                bytes
            })
        }
        let (out, errors) = (all(self.child.stdout.take()), all(self.child.stderr.take()));
        let status = self.status();
        let joined = |reader: JoinHandle<Vec<u8>>| reader.join().expect("the reader ends");
        Output { status, stdout: joined(out), stderr: joined(errors) }
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        if !self.ended {
            // Not by the program kill: that of procps 4.0.2 takes -12345 for -1, which is every process
            // there is.
            #[cfg(unix)]
            let _ = kill_process_group(Pid::from_child(&self.child), Signal::KILL);
            let _ = self.child.kill();
            let _ = self.child.wait();
        }
    }
}

/// Runs a program to its end, for as long as a run may take.
#[track_caller]
pub(crate) fn output_of(command: &mut Command) -> Output {
    Running::start(command.stdout(Stdio::piped()).stderr(Stdio::piped())).output()
}

/// Runs `mindeg` with these arguments and nothing on standard input.
#[track_caller]
pub(crate) fn mindeg<S: AsRef<OsStr>>(arguments: impl IntoIterator<Item = S>) -> Run {
    mindeg_reading(arguments, b"")
}

/// Runs `mindeg` with these arguments and `input` on standard input.
#[track_caller]
pub(crate) fn mindeg_reading<S: AsRef<OsStr>>(
    arguments: impl IntoIterator<Item = S>,
    input: &[u8],
) -> Run {
    let mut command = Command::new(env!("CARGO_BIN_EXE_mindeg"));
    command.args(arguments).stdin(Stdio::piped());
    run(&mut command, input)
}

/// Runs a program that calls mindeg, in a folder, with nothing on standard input.
#[cfg(unix)]
#[track_caller]
pub(crate) fn shell(folder: &Path, script: &str) -> Run {
    let mut command = Command::new("sh");
    command.args(["-c", script]).current_dir(folder).stdin(Stdio::piped());
    run(command.env("MINDEG", env!("CARGO_BIN_EXE_mindeg")), b"")
}

#[track_caller]
fn run(command: &mut Command, input: &[u8]) -> Run {
    let mut running = Running::start(command.stdout(Stdio::piped()).stderr(Stdio::piped()));
    // A run that refuses its arguments never reads; a closed pipe is then not a failure.
    let _ = running.child.stdin.take().expect("standard input is piped").write_all(input);
    let output = running.output();
    Run {
        code: output.status.code(),
        output: output.stdout,
        errors: String::from_utf8_lossy(&output.stderr).into_owned(),
    }
}

/// Runs `mindeg` with its standard output closed by whoever was to read it: a quiet success.
#[track_caller]
pub(crate) fn ends_quietly_when_nobody_reads<S: AsRef<OsStr>>(
    arguments: impl IntoIterator<Item = S>,
) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_mindeg"));
    command.args(arguments).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut running = Running::start(&mut command);
    drop(running.take_output());
    let output = running.output();
    assert_eq!((output.status.code(), output.stderr), (Some(0), Vec::new()));
}

/// A command that starts a program that no longer ignores the signals that end it: where the
/// tests were started by nohup or in the background of a script, some are ignored, and children
/// inherit that.
#[cfg(unix)]
pub(crate) fn hearing_signals(program: &str) -> Command {
    // Only GNU's env does it. Elsewhere, start the tests without ignored signals.
    if !cfg!(target_os = "linux") {
        return Command::new(program);
    }
    let mut command = Command::new("env");
    command.args(["--default-signal=HUP,INT,QUIT,ALRM,TERM,XCPU,XFSZ,PIPE", program]);
    command
}
