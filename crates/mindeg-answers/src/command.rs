//! Commands to paste that make a mesh of a domain.

use crate::purpose::Purpose;
use mindeg::Domain;

/// The command that makes meshes of a domain, as its reader named it.
///
/// ```
/// use mindeg::{Domain, Side};
/// use mindeg_answers::advice::Purpose;
/// use mindeg_answers::command::MeshCommand;
///
/// let domain = Domain::rectangle(4.0, 3.0, vec![Side::count(4); 4])?;
/// let words = ["my coast.svg", "--feature", "2"].map(str::to_owned);
/// assert_eq!(
///     MeshCommand::of(&words, &domain).advised(Purpose::Patch),
///     "mindeg mesh 'my coast.svg' --feature 2 --keep-angle 95% -o mesh.obj"
/// );
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MeshCommand {
    /// The file, if there is one, and the options that say how it is read.
    words: Vec<String>,
    inside: &'static [&'static str],
    boundary_alone: &'static [&'static str],
}

/// A command for a domain in a file whose name is not known.
impl Default for MeshCommand {
    fn default() -> Self {
        Self { words: vec!["DOMAIN.json".to_owned()], inside: INSIDE, boundary_alone: &[] }
    }
}

const INSIDE: &[&str] = &["--interior"];

/// The options with which `mindeg mesh` puts points inside. A mesh that misses a demand is written all the same.
#[must_use]
pub fn inside_options(domain: &Domain) -> &'static [&'static str] {
    let demands = domain.interior().is_some_and(|wanted| {
        wanted.target_angle.is_some()
            || wanted.interior_degree.is_some()
            || wanted.boundary_degree.is_some()
    });
    if demands || domain.is_constrained() { &["--interior", "--write-anyway"] } else { INSIDE }
}

/// The options with which it puts none inside.
#[must_use]
pub fn boundary_alone_options(domain: &Domain) -> &'static [&'static str] {
    if domain.interior().is_some() { &["--no-interior"] } else { &[] }
}

impl MeshCommand {
    /// The command for a domain that these words name: its file, or `-` for standard input, and the options that say how
    /// it is read.
    #[must_use]
    pub fn of(words: &[String], domain: &Domain) -> Self {
        Self {
            words: words.to_vec(),
            inside: inside_options(domain),
            boundary_alone: boundary_alone_options(domain),
        }
    }

    /// The command that makes the mesh for a purpose.
    #[must_use]
    pub fn advised(&self, purpose: Purpose) -> String {
        match purpose {
            Purpose::Solver => self.line(self.inside),
            purpose => self.of_boundary_alone(purpose.options()),
        }
    }

    /// The command that makes a mesh without points inside, with these options.
    #[must_use]
    pub fn of_boundary_alone(&self, options: &[&str]) -> String {
        self.line(&[options, self.boundary_alone].concat())
    }

    fn line(&self, options: &[&str]) -> String {
        let words = self.words.iter().map(|word| shell_word(word));
        let options = options.iter().copied().map(str::to_owned);
        let mut line = vec!["mindeg mesh".to_owned()];
        line.extend(words.chain(options));
        line.push("-o mesh.obj".to_owned());
        if self.words.first().is_some_and(|word| word == "-") {
            line.push("< DOMAIN.json".to_owned());
        }
        line.join(" ")
    }
}

/// A file as a command names it: one that begins with a dash would look like an option.
///
/// ```
/// use mindeg_answers::command::file_word;
///
/// assert_eq!(["a.json", "-x", "-"].map(file_word), ["a.json", "./-x", "-"]);
/// ```
#[must_use]
pub fn file_word(path: &str) -> String {
    let folder = if path.starts_with('-') && path != "-" { "./" } else { "" };
    format!("{folder}{path}")
}

/// A word as a POSIX shell reads it back: in quotes where it needs them.
///
/// ```
/// use mindeg_answers::command::shell_word;
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

    fn command(words: &[&str], more: &str) -> MeshCommand {
        let text = format!(r#"{{"rectangle": {{"width": 4, "height": 3}}, "size": 1{more}}}"#);
        let words: Vec<String> = words.iter().map(|&word| word.to_owned()).collect();
        MeshCommand::of(&words, &Domain::from_json(&text).unwrap())
    }

    #[test]
    fn a_command_can_be_pasted() {
        for (input, word) in [("a.json", "a.json"), ("it's.json", r"'it'\''s.json'"), ("", "''")] {
            let line = format!("mindeg mesh {word} --keep-angle 95% -o mesh.obj");
            assert_eq!(command(&[input], "").advised(Purpose::Patch), line);
        }
        assert_eq!(command(&["a"], "").advised(Purpose::Fewest), "mindeg mesh a -o mesh.obj");
        assert_eq!(
            command(&["-", "--repair"], "").advised(Purpose::Solver),
            "mindeg mesh - --repair --interior -o mesh.obj < DOMAIN.json"
        );
    }

    /// `mindeg mesh` writes no mesh that misses a demand, and takes points inside from the domain.
    #[test]
    fn what_the_domain_asks_for_is_told() {
        for (more, inside, fewest) in [
            ("", "--interior", ""),
            (r#", "interior": {}"#, "--interior", " --no-interior"),
            (
                r#", "interior": {"target_angle": 25}"#,
                "--interior --write-anyway",
                " --no-interior",
            ),
            (r#", "vertices": [{"vertex": 1, "max_degree": 4}]"#, "--interior --write-anyway", ""),
        ] {
            let command = command(&["a.json"], more);
            let lines = [Purpose::Solver, Purpose::Fewest].map(|purpose| command.advised(purpose));
            assert_eq!(lines[0], format!("mindeg mesh a.json {inside} -o mesh.obj"), "{more}");
            assert_eq!(lines[1], format!("mindeg mesh a.json{fewest} -o mesh.obj"), "{more}");
        }
    }
}
