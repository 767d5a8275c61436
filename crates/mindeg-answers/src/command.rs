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
    /// Whether the words name the files to write.
    writes: bool,
    reads_standard_input: bool,
    inside: &'static [&'static str],
    boundary_alone: &'static [&'static str],
}

/// A command for a domain in a file whose name is not known.
impl Default for MeshCommand {
    fn default() -> Self {
        Self {
            words: vec!["DOMAIN.json".to_owned()],
            writes: false,
            reads_standard_input: false,
            inside: INSIDE,
            boundary_alone: &[],
        }
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
            writes: false,
            reads_standard_input: words.first().is_some_and(|word| word == "-"),
            inside: inside_options(domain),
            boundary_alone: boundary_alone_options(domain),
        }
    }

    /// The same for what was meshed with these words, the files to write among them.
    #[must_use]
    pub fn again(self, words: &[String]) -> Self {
        // They would stand twice, or one beside its contrary.
        let given_anew = ["--interior", "--no-interior", "--write-anyway"];
        let is_kept = |word: &&String| !given_anew.contains(&word.as_str());
        Self { words: words.iter().filter(is_kept).cloned().collect(), writes: true, ..self }
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
        // After the word "--" a word is a file, not an option.
        let end = self.words.iter().position(|word| word == "--").unwrap_or(self.words.len());
        let (words, files) = self.words.split_at(end);
        let mut line = vec!["mindeg mesh".to_owned()];
        line.extend(words.iter().map(|word| shell_word(word)));
        line.extend(options.iter().copied().map(str::to_owned));
        line.extend(files.iter().map(|word| shell_word(word)));
        if !self.writes {
            line.push("-o mesh.obj".to_owned());
        }
        if self.reads_standard_input {
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

    #[test]
    fn what_was_meshed_is_meshed_again_into_the_same_files() {
        for (words, solver, patch) in [
            ("a.json -o b.vtu", "a.json -o b.vtu --interior", "a.json -o b.vtu --keep-angle 95%"),
            ("--no-interior a -o -", "a -o - --interior", "a -o - --keep-angle 95%"),
            ("-o b.vtu -- -a", "-o b.vtu --interior -- -a", "-o b.vtu --keep-angle 95% -- -a"),
        ] {
            let words: Vec<String> = words.split(' ').map(str::to_owned).collect();
            let again = command(&["a.json"], "").again(&words);
            assert_eq!(again.advised(Purpose::Solver), format!("mindeg mesh {solver}"));
            assert_eq!(again.advised(Purpose::Patch), format!("mindeg mesh {patch}"));
        }
        let words = ["-", "-o", "b.vtu"].map(str::to_owned);
        let again = command(&["-"], "").again(&words).advised(Purpose::Solver);
        assert_eq!(again, "mindeg mesh - -o b.vtu --interior < DOMAIN.json");
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
