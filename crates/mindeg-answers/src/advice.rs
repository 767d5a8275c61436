//! The advised mesh, and the command that makes it.
//!
//! The rule is that of `mindeg mesh --keep-angle 95%`: the smallest degree whose best mesh keeps
//! [`KEPT`] of Delaunay's minimum angle.

/// The share of Delaunay's minimum angle that the advised mesh keeps, at least.
pub const KEPT: f64 = 0.95;

/// The command that makes a mesh as advised from `input`, ready for a POSIX shell.
///
/// ```
/// assert_eq!(
///     mindeg_answers::advice::advised_command("my wing.json"),
///     "mindeg mesh 'my wing.json' --keep-angle 95% -o mesh.obj"
/// );
/// ```
#[must_use]
pub fn advised_command(input: &str) -> String {
    // A file name that begins with a dash would look like an option.
    let folder = if input.starts_with('-') { "./" } else { "" };
    let input = shell_word(&format!("{folder}{input}"));
    format!("mindeg mesh {input} --keep-angle 95% -o mesh.obj")
}

/// A word as a POSIX shell reads it back: in quotes where it needs them.
///
/// ```
/// use mindeg_answers::advice::shell_word;
///
/// assert_eq!(["--size", "0,0 4,0", "it's"].map(shell_word), ["--size", "'0,0 4,0'", r"'it'\''s'"]);
/// ```
#[must_use]
pub fn shell_word(word: &str) -> String {
    let is_plain = |c: char| c.is_alphanumeric() || "-_./+,:@%=".contains(c);
    if !word.is_empty() && word.chars().all(is_plain) {
        word.to_owned()
    } else {
        format!("'{}'", word.replace('\'', r"'\''"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_command_can_be_pasted() {
        for (input, word) in
            [("a.json", "a.json"), ("it's.json", r"'it'\''s.json'"), ("-x", "./-x"), ("", "''")]
        {
            let command = format!("mindeg mesh {word} --keep-angle 95% -o mesh.obj");
            assert_eq!(advised_command(input), command);
        }
    }
}
