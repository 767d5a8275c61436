//! Commands to paste that make a mesh of a domain, and the names of their files.

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
///     "mindeg mesh 'my coast.svg' --feature 2 --keep-angle 95% -o mesh-keep-angle-95.obj"
/// );
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MeshCommand {
    /// The file, if there is one, and the options that say how it is read.
    words: Vec<String>,
    /// The words for the domain alone.
    domain: Vec<String>,
    /// The stem of the names of the files to write, unless the words name them.
    stem: Option<String>,
    reads_standard_input: bool,
    inside: &'static [&'static str],
    boundary_alone: &'static [&'static str],
}

/// A command for a domain in a file whose name is not known.
impl Default for MeshCommand {
    fn default() -> Self {
        Self {
            words: vec!["DOMAIN.json".to_owned()],
            domain: vec!["DOMAIN.json".to_owned()],
            stem: Some("mesh".to_owned()),
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
            domain: words.to_vec(),
            stem: Some(domain_stem(domain)),
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
        Self { words: words.iter().filter(is_kept).cloned().collect(), stem: None, ..self }
    }

    /// The command that makes the mesh for a purpose.
    #[must_use]
    pub fn advised(&self, purpose: Purpose) -> String {
        match purpose {
            Purpose::Solver => self.line(self.inside, POINTS_INSIDE),
            Purpose::Fewest => {
                self.line(&[purpose.options(), self.boundary_alone].concat(), FEWEST_EDGES)
            }
            Purpose::Patch => self.of_boundary_alone(purpose.options()),
        }
    }

    /// The command that makes the mesh with points inside and on edges.
    #[must_use]
    pub fn conditioned(&self) -> String {
        self.line(&[self.inside, &["--condition"]].concat(), "conditioned")
    }

    /// The command that measures the meshes to choose from.
    #[must_use]
    pub fn measuring(&self) -> String {
        let words: Vec<String> = self.domain.iter().map(|word| shell_word(word)).collect();
        self.reading(format!("mindeg tradeoff {}", words.join(" ")))
    }

    /// The command that makes a mesh without points inside, with these options.
    #[must_use]
    pub fn of_boundary_alone(&self, options: &[&str]) -> String {
        let which = if options.is_empty() { LEAST_DEGREE.to_owned() } else { options.join(" ") };
        self.line(&[options, self.boundary_alone].concat(), &which)
    }

    fn line(&self, options: &[&str], which: &str) -> String {
        // After the word "--" a word is a file, not an option.
        let end = self.words.iter().position(|word| word == "--").unwrap_or(self.words.len());
        let (words, files) = self.words.split_at(end);
        let mut line = vec!["mindeg mesh".to_owned()];
        line.extend(words.iter().map(|word| shell_word(word)));
        line.extend(options.iter().copied().map(str::to_owned));
        line.extend(files.iter().map(|word| shell_word(word)));
        line.extend(self.stem.as_ref().map(|stem| format!("-o {stem}-{}.obj", plain(which))));
        self.reading(line.join(" "))
    }

    fn reading(&self, line: String) -> String {
        if self.reads_standard_input { line + " < DOMAIN.json" } else { line }
    }
}

/// The mesh with points inside, in words for the name of its file.
pub const POINTS_INSIDE: &str = "points inside";

/// The mesh of the fewest edges at a vertex, in words for the name of its file.
pub const FEWEST_EDGES: &str = "fewest edges";

/// The mesh of least degree, in words for the name of its file.
pub const LEAST_DEGREE: &str = "least degree";

/// The stem of the file of one of the meshes of a domain: the domain's name, and which mesh it is.
///
/// ```
/// use mindeg::{Domain, Side};
/// use mindeg_answers::command::{POINTS_INSIDE, mesh_stem};
///
/// let domain = Domain::rectangle(4.0, 3.0, vec![Side::count(4); 4])?.named("My plate (2)")?;
/// assert_eq!(mesh_stem(&domain, POINTS_INSIDE), "my-plate-2-points-inside");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn mesh_stem(domain: &Domain, which: &str) -> String {
    format!("{}-{}", domain_stem(domain), plain(which))
}

/// A domain's name in small letters, digits and dashes; `mesh` where nothing of it is left.
#[must_use]
pub fn domain_stem(domain: &Domain) -> String {
    let stem = plain(domain.name().unwrap_or_default());
    if stem.is_empty() { "mesh".to_owned() } else { stem.chars().take(60).collect() }
}

/// A text in small letters, digits and dashes.
fn plain(text: &str) -> String {
    let words = text.split(|c: char| !c.is_ascii_alphanumeric()).filter(|word| !word.is_empty());
    words.map(str::to_ascii_lowercase).collect::<Vec<_>>().join("-")
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
            let line = format!("mindeg mesh {word} --keep-angle 95% -o mesh-keep-angle-95.obj");
            assert_eq!(command(&[input], "").advised(Purpose::Patch), line);
        }
        let fewest = command(&["a"], r#", "name": "A b""#).advised(Purpose::Fewest);
        assert_eq!(fewest, "mindeg mesh a --optimize angle -o a-b-fewest-edges.obj");
        let command = command(&["-", "--repair"], "");
        assert_eq!(
            command.advised(Purpose::Solver),
            "mindeg mesh - --repair --interior -o mesh-points-inside.obj < DOMAIN.json"
        );
        assert_eq!(
            command.of_boundary_alone(&["--max-degree", "5"]),
            "mindeg mesh - --repair --max-degree 5 -o mesh-max-degree-5.obj < DOMAIN.json"
        );
        assert_eq!(command.measuring(), "mindeg tradeoff - --repair < DOMAIN.json");
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
            let expected = format!("mindeg mesh a.json {inside} -o mesh-points-inside.obj");
            assert_eq!(lines[0], expected, "{more}");
            let expected =
                format!("mindeg mesh a.json --optimize angle{fewest} -o mesh-fewest-edges.obj");
            assert_eq!(lines[1], expected, "{more}");
        }
    }
}
