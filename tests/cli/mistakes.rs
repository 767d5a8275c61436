//! Mistakes of users in their files and numbers: the whole message, which says what is wrong, where, and
//! what to do. [`slips`](super::slips) has the slips of usage.

use crate::mesh::text;
use crate::pinned;
use crate::run::output_of;
use mindeg_formats::{Format, extensions};
use std::fs;
use std::path::Path;
use std::process::Command;

#[test]
fn pinned_mistakes_are_answered_with_what_and_where_and_what_to_do() {
    pinned::check("tests/cli/mistakes.txt", |input| {
        let folder = tempfile::tempdir().expect("a folder");
        let (files, arguments) = input.rsplit_once("$ ").expect("a command line comes last");
        for (name, content) in files.lines().filter_map(|line| line.split_once(": ")) {
            fs::write(folder.path().join(name), unescaped(content)).expect("a file");
        }
        let (code, mut errors) = run(folder.path(), arguments);
        // The formats' own list, which a new one makes longer.
        for formats in [&Format::WRITTEN[..], &Format::READ[..]] {
            errors = errors.replace(&extensions(formats), "EXTENSIONS");
        }
        format!("exit code {}\n{errors}", code.expect("it is not killed"))
    });
}

/// The bytes of a file's content, in which \n, \\ and \x with two digits are escaped.
fn unescaped(text: &str) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut rest = text;
    while let Some((plain, escaped)) = rest.split_once('\\') {
        bytes.extend(plain.bytes());
        let (byte, length) = match escaped.as_bytes()[0] {
            b'n' => (b'\n', 1),
            b'x' => (u8::from_str_radix(&escaped[1..3], 16).expect("two digits"), 3),
            other => (other, 1),
        };
        bytes.push(byte);
        rest = &escaped[length..];
    }
    bytes.extend(rest.bytes());
    bytes
}

/// The exit code and standard error of a run in a folder. A + stands for a blank within an argument.
fn run(folder: &Path, arguments: &str) -> (Option<i32>, String) {
    let words = arguments.split(' ').map(|word| word.replace('+', " "));
    let mut command = Command::new(env!("CARGO_BIN_EXE_mindeg"));
    let run = output_of(command.args(words).current_dir(text(folder)));
    (run.status.code(), String::from_utf8_lossy(&run.stderr).into_owned())
}
