//! The command line that makes a mesh of the page.

use mindeg::{Domain, Goal};
use mindeg_answers::advice::FEWEST;
use mindeg_answers::command::{
    FEWEST_EDGES, LEAST_DEGREE, POINTS_INSIDE, boundary_alone_options, domain_stem, inside_options,
    mesh_stem, shell_word,
};
use mindeg_files::Format;
use serde_json::Value;

use crate::api::{Request, View};

/// The line that ends a domain within a command. No line of JSON can be this word.
const END: &str = "END";

/// Files that a command may name instead of holding the domain itself.
#[derive(Clone, Debug, Default)]
pub struct KnownFiles {
    domains: Vec<(Vec<String>, Value)>,
    /// The name of the file of a surface, and its path.
    surface: Option<(String, String)>,
}

impl KnownFiles {
    /// Adds a file that is read as this domain in JSON, by the words of a command that name it: the file, and the options
    /// that say how it is read. Other text is ignored.
    pub fn add(&mut self, words: &[String], text: &str) {
        if let Ok(domain) = serde_json::from_str(text) {
            self.domains.push((words.to_vec(), domain));
        }
    }

    /// Adds the path of the file of a surface, which the page knows by its name.
    pub fn add_surface(&mut self, name: &str, path: &str) {
        self.surface = Some((name.to_owned(), path.to_owned()));
    }

    /// The path of a surface's file; its name where no path is known.
    pub(crate) fn surface<'a>(&'a self, name: &'a str) -> &'a str {
        let known = self.surface.as_ref().filter(|(known, _)| known == name);
        known.map_or(name, |(_, path)| path)
    }

    /// The words for the file that holds a domain.
    fn with(&self, domain: &str) -> Option<&[String]> {
        let domain: Value = serde_json::from_str(domain).ok()?;
        self.domains.iter().find(|(_, known)| is_same(known, &domain)).map(|(words, _)| &words[..])
    }
}

/// Whether two values are the same as the page has them: its numbers are no longer 1.0 where they are whole.
fn is_same(one: &Value, other: &Value) -> bool {
    match (one, other) {
        (Value::Number(one), Value::Number(other)) => one.as_f64() == other.as_f64(),
        (Value::Array(one), Value::Array(other)) => {
            one.len() == other.len()
                && one.iter().zip(other).all(|(one, other)| is_same(one, other))
        }
        (Value::Object(one), Value::Object(other)) => {
            let is_there = |(key, one)| other.get(key).is_some_and(|other| is_same(one, other));
            one.len() == other.len() && one.iter().all(is_there)
        }
        (one, other) => one == other,
    }
}

/// The stem of the file names of a mesh: the domain's name, and which mesh it is.
pub(crate) fn file_stem(domain: &Domain, view: View, goal: Goal) -> String {
    match (view, goal) {
        (View::Interior, _) => mesh_stem(domain, POINTS_INSIDE),
        (View::Delaunay, _) => mesh_stem(domain, "delaunay"),
        (View::Least, _) => mesh_stem(domain, LEAST_DEGREE),
        (View::Wanted, FEWEST) => mesh_stem(domain, FEWEST_EDGES),
        (View::Wanted, goal) => {
            let (kind, value) = goal.kind_and_value();
            mesh_stem(domain, &format!("{} {value}", kind.key))
        }
    }
}

/// The command that writes the mesh of a view, ready for a POSIX shell.
pub(crate) fn command(request: &Request, domain: &Domain, known: &KnownFiles) -> String {
    let text = request.domain.get();
    if request.view == View::Delaunay {
        let stem = domain_stem(domain);
        let (page, folder) = (format!("{stem}.html"), format!("{stem}-compared"));
        let words = ["-o", &page, "--save-meshes", &folder].map(str::to_owned);
        return with_domain("compare", text, known, &words);
    }
    let format = request.format().unwrap_or(Format::Obj);
    let stem = file_stem(domain, request.view, request.goal);
    let mut words = options(request, domain);
    words.extend(["-o".to_owned(), format!("{stem}.{}", format.extension())]);
    with_domain("mesh", text, known, &words)
}

/// A command on a domain in JSON: it names the file, where one is known that no option reads twice, or holds the domain.
pub(crate) fn with_domain(
    command: &str,
    domain: &str,
    known: &KnownFiles,
    options: &[String],
) -> String {
    let is_twice = |word: &String| word.starts_with("--") && options.contains(word);
    let file = known.with(domain).filter(|words| !words.iter().any(is_twice));
    let standard_input = ["-".to_owned()];
    let input = file.unwrap_or(&standard_input).iter().map(|word| shell_word(word));
    let words = ["mindeg".to_owned(), command.to_owned()].into_iter();
    let line = words.chain(input).chain(options.iter().cloned()).collect::<Vec<_>>().join(" ");
    match file {
        Some(_) => line,
        None => format!("{line} <<'{END}'\n{}\n{END}", domain.trim()),
    }
}

/// The options that tell `mindeg mesh` which mesh is wanted.
fn options(request: &Request, domain: &Domain) -> Vec<String> {
    let words = |options: &[&str]| options.iter().copied().map(str::to_owned).collect::<Vec<_>>();
    if request.view == View::Interior {
        return words(inside_options(domain));
    }
    let mut options = Vec::new();
    if request.view == View::Wanted && request.goal != Goal::default() {
        let (kind, value) = request.goal.kind_and_value();
        options.extend([kind.option(), value].into_iter().filter(|word| !word.is_empty()));
    }
    options.extend(words(boundary_alone_options(domain)));
    options
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn commands_name_a_known_file_or_hold_the_domain() {
        let text = r#"{"name": "A b/c", "rectangle": {"width": 4, "height": 3}, "size": 0.5}"#;
        let command = |body: String, known: &KnownFiles| {
            let request: Request = serde_json::from_str(&body).unwrap();
            command(&request, &Domain::from_json(text).unwrap(), known)
        };
        let body =
            format!(r#"{{"domain": {text}, "goal": {{"keep_angle": 0.95}}, "format": "fort14"}}"#);
        assert_eq!(
            command(body.clone(), &KnownFiles::default()),
            format!(
                "mindeg mesh - --keep-angle 95% -o a-b-c-keep-angle-95.14 <<'END'\n{text}\nEND"
            )
        );
        let mut known = KnownFiles::default();
        let words = ["my plate.json", "--size", "1"].map(str::to_owned);
        known.add(&words, &text.replace("0.5", "0.50"));
        assert_eq!(
            command(body, &known),
            "mindeg mesh 'my plate.json' --size 1 --keep-angle 95% -o a-b-c-keep-angle-95.14"
        );
    }

    /// JavaScript writes 4.0 as 4.
    #[test]
    fn a_known_file_is_found_by_the_numbers_that_the_page_sends() {
        let mut known = KnownFiles::default();
        let domain = |ring: &str| format!(r#"{{"name": "a", "holes": [{{"ring": {ring}}}]}}"#);
        known.add(&["a.csv".to_owned()], &domain("[[4.0, 0.5], [1e2, -0.0]]"));
        assert!(known.with(&domain("[[4, 0.5], [100, 0]]")).is_some());
        for other in ["[[4, 0.5], [100, 1]]", "[[4, 0.5]]", "[[4, 0.5], [100, \"0\"]]"] {
            assert_eq!(known.with(&domain(other)), None, "{other}");
        }
        assert_eq!(known.with(r#"{"name": "a"}"#), None);
    }

    /// `mindeg mesh` writes no mesh that misses a demand, but the page shows one.
    #[test]
    fn a_mesh_that_may_miss_a_demand_is_written_anyway() {
        for (more, is_anyway) in [
            ("", false),
            (r#", "interior": {}"#, false),
            (r#", "interior": {"target_angle": 25}"#, true),
            (r#", "vertices": [{"vertex": 1, "max_degree": 4}]"#, true),
        ] {
            let text = format!(r#"{{"rectangle": {{"width": 4, "height": 3}}, "size": 1{more}}}"#);
            let body = format!(r#"{{"domain": {text}, "view": "interior"}}"#);
            let request = serde_json::from_str(&body).unwrap();
            let options = options(&request, &Domain::from_json(&text).unwrap());
            let expected: &[&str] =
                if is_anyway { &["--interior", "--write-anyway"] } else { &["--interior"] };
            assert_eq!(options, expected, "{more}");
        }
    }
}
