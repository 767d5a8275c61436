//! How a mesh was made, as its file says it: the command, and the digest of each file that was read.
//!
//! One line, such as
//! `mindeg 0.1.0 made by: mindeg mesh plate.json --recipe -o plate.obj; plate.json sha256:9f86…`.
//! Files have no folders in it, and it names no time and no machine: the same command on the same files gives the same
//! line. Bytes that some format does not take stand as `%20`.

use crate::error::FileError;
use sha2::{Digest, Sha256};
use std::ffi::OsString;
use std::fmt::{self, Display, Write};
use std::fs::File;
use std::io::{self, BufRead, BufReader};
use std::path::{Component, Path, PathBuf};

/// The words between the version and the command.
const MADE_BY: &str = " made by: mindeg ";

/// The word before a digest.
const DIGEST: &str = "sha256:";

/// How a mesh was made.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Recipe {
    /// The version of mindeg.
    pub version: String,
    /// The arguments, in which files have no folders.
    pub arguments: Vec<String>,
    /// The files that were read.
    pub inputs: Vec<Ingredient>,
}

/// A file that a mesh was made from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Ingredient {
    /// Its name, without folders.
    pub name: String,
    /// The SHA-256 digest of its bytes, 64 letters.
    pub sha256: String,
}

impl Ingredient {
    /// A file as it is now.
    ///
    /// # Errors
    ///
    /// A name that is not UTF-8 text, and errors of the file.
    pub fn of(path: &Path) -> Result<Self, FileError> {
        let shown = path.display().to_string();
        let name = path.file_name().and_then(|name| name.to_str());
        let name = name.ok_or_else(|| unsayable(&shown))?.to_owned();
        let sha256 = digest(path).map_err(|error| FileError::cannot_read(&shown, &error))?;
        Ok(Self { name, sha256 })
    }
}

impl Recipe {
    /// The recipe of a command. `outputs` are the paths that it writes, `inputs` those that it has read.
    pub(crate) fn new(
        arguments: &[OsString],
        inputs: &[PathBuf],
        outputs: &[PathBuf],
    ) -> Result<Self, FileError> {
        let mut found: Vec<Ingredient> = Vec::new();
        for path in inputs {
            let read = Ingredient::of(path)?;
            match found.iter().find(|other| other.name == read.name) {
                Some(other) if other.sha256 == read.sha256 => {}
                Some(_) => {
                    let name = read.name;
                    return Err(FileError::wrong(format!(
                        "a recipe names files without their folders, and two that differ are called {name}; rename one"
                    )));
                }
                None => found.push(read),
            }
        }
        let paths: Vec<&Path> = inputs.iter().chain(outputs).map(PathBuf::as_path).collect();
        let words = arguments.iter().map(|word| without_folders(word, &paths));
        let recipe = Self {
            version: env!("CARGO_PKG_VERSION").to_owned(),
            arguments: words.collect::<Result<_, _>>()?,
            inputs: found,
        };
        match recipe.arguments.iter().find(|word| !is_plain(word)) {
            Some(word) => Err(FileError::wrong(format!(
                "{word} leads to another folder, and a recipe names none"
            ))),
            None => Ok(recipe),
        }
    }

    /// The recipe in a file of any format, if there is one.
    #[must_use]
    pub fn in_file(bytes: &[u8]) -> Option<Self> {
        let at = find(bytes, MADE_BY.as_bytes())?;
        let before = &bytes[..at];
        let version = before.rsplit(|byte| byte.is_ascii_whitespace()).next()?;
        let version = String::from_utf8(version.to_vec()).ok()?;
        let rest = &bytes[at + MADE_BY.len()..];
        let is_text = |byte: &u8| matches!(byte, b' '..=b'~') && !is_left_out(*byte);
        let length = rest.iter().position(|byte| !is_text(byte)).unwrap_or(rest.len());
        let line = std::str::from_utf8(&rest[..length]).ok()?;
        let (command, inputs) = line.split_once(';')?;
        let arguments = command.split(' ').map(said).collect::<Option<_>>()?;
        let mut found = Vec::new();
        for input in inputs.split(';') {
            let Some((name, digest)) = input.trim_start().split_once(' ') else { break };
            let Some(digest) = digest.strip_prefix(DIGEST).and_then(|digest| digest.get(..64))
            else {
                break;
            };
            found.push(Ingredient { name: said(name)?, sha256: digest.to_owned() });
        }
        Some(Self { version, arguments, inputs: found })
    }

    /// Whether no word leads to another folder, so that the command stays in the one where it runs.
    #[must_use]
    pub fn is_plain(&self) -> bool {
        let names = self.inputs.iter().map(|input| &input.name);
        self.arguments.iter().chain(names).all(|word| is_plain(word))
    }

    /// The command as a shell takes it, but for quotes.
    #[must_use]
    pub fn command(&self) -> String {
        format!("mindeg {}", self.arguments.join(" "))
    }
}

impl Display for Recipe {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let words: Vec<String> = self.arguments.iter().map(|word| sayable(word)).collect();
        write!(f, "mindeg {}{MADE_BY}{};", self.version, words.join(" "))?;
        if self.inputs.is_empty() {
            f.write_str(" no input")?;
        }
        for (index, input) in self.inputs.iter().enumerate() {
            let end = if index == 0 { "" } else { ";" };
            write!(f, "{end} {} {DIGEST}{}", sayable(&input.name), input.sha256)?;
        }
        Ok(())
    }
}

/// The SHA-256 digest of a file in letters.
fn digest(path: &Path) -> io::Result<String> {
    let mut hasher = Sha256::new();
    let mut file = BufReader::new(File::open(path)?);
    loop {
        let bytes = file.fill_buf()?;
        if bytes.is_empty() {
            break;
        }
        hasher.update(bytes);
        let read = bytes.len();
        file.consume(read);
    }
    Ok(hasher.finalize().iter().map(|byte| format!("{byte:02x}")).collect())
}

/// A word in which a path has lost its folders: the whole word, or its end after an option.
fn without_folders(word: &OsString, paths: &[&Path]) -> Result<String, FileError> {
    let word = word.to_str().ok_or_else(|| unsayable(&word.to_string_lossy()))?;
    for path in paths {
        let (Some(text), Some(name)) = (path.to_str(), path.file_name()) else { continue };
        if let Some(option) = word.strip_suffix(text)
            && (option.is_empty() || option.starts_with('-'))
        {
            return Ok(format!("{option}{}", name.to_string_lossy()));
        }
    }
    Ok(word.to_owned())
}

/// Whether a word, or the value of an option, names no folder.
fn is_plain(word: &str) -> bool {
    let value = word.split_once('=').map_or(word, |(_, value)| value);
    let stays = |part: Component<'_>| matches!(part, Component::Normal(_));
    !word.contains(['/', '\\']) && Path::new(value).components().all(stays)
}

fn unsayable(name: &str) -> FileError {
    FileError::wrong(format!("{name} is not UTF-8 text, and a recipe is; give another name"))
}

/// Whether some format, or the line itself, has another use for a byte.
fn is_left_out(byte: u8) -> bool {
    matches!(byte, b'"' | b'&' | b'<' | b'>' | b'\\')
}

/// A word as the line has it.
fn sayable(word: &str) -> String {
    let bytes = word.as_bytes();
    let mut text = String::new();
    for (index, &byte) in bytes.iter().enumerate() {
        let is_code = byte == b'%' && bytes.get(index + 1..index + 3).is_some_and(is_hexadecimal);
        if byte.is_ascii_graphic() && byte != b';' && !is_left_out(byte) && !is_code {
            text.push(char::from(byte));
        } else {
            let _ = write!(text, "%{byte:02X}");
        }
    }
    text
}

/// The word that the line has so.
fn said(text: &str) -> Option<String> {
    let bytes = text.as_bytes();
    let mut word = Vec::new();
    let mut at = 0;
    while let Some(&byte) = bytes.get(at) {
        let code = bytes.get(at + 1..at + 3).filter(|code| byte == b'%' && is_hexadecimal(code));
        let code =
            code.and_then(|code| u8::from_str_radix(std::str::from_utf8(code).ok()?, 16).ok());
        word.push(code.unwrap_or(byte));
        at += if code.is_some() { 3 } else { 1 };
    }
    String::from_utf8(word).ok()
}

fn is_hexadecimal(code: &[u8]) -> bool {
    code.iter().all(u8::is_ascii_hexdigit)
}

fn find(bytes: &[u8], word: &[u8]) -> Option<usize> {
    bytes.windows(word.len()).position(|window| window == word)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn recipe(words: &[&str], inputs: &[&str]) -> Recipe {
        Recipe {
            version: "1.2.3".to_owned(),
            arguments: words.iter().map(|word| (*word).to_owned()).collect(),
            inputs: inputs
                .iter()
                .map(|name| Ingredient { name: (*name).to_owned(), sha256: "0f".repeat(32) })
                .collect(),
        }
    }

    #[test]
    fn a_recipe_is_found_again_in_any_surroundings() {
        for recipe in [
            recipe(&["mesh", "--rectangle", "4x3", "-o", "a.obj"], &[]),
            recipe(
                &["mesh", "my plate.json", "--keep-angle", "95%", "--name=<é;%41%>"],
                &["my plate.json", "b;c"],
            ),
        ] {
            let line = recipe.to_string();
            assert!(line.bytes().all(|byte| byte == b' ' || byte.is_ascii_graphic()), "{line}");
            assert!(!line.bytes().any(is_left_out), "{line}");
            for (before, after) in [
                ("", ""),
                ("# ", "\nv 1 2 3\n"),
                ("<!-- ", " -->"),
                ("{\"generator\":\"", "\",\"x\":1}"),
                ("\0\u{1}", "\0;"),
            ] {
                let file = format!("{before}{line}{after}");
                assert_eq!(Recipe::in_file(file.as_bytes()).as_ref(), Some(&recipe), "{file:?}");
            }
            // In a remark of XML.
            let escaped = line.replace("--", "%2D%2D");
            assert_eq!(Recipe::in_file(escaped.as_bytes()), Some(recipe));
        }
        assert_eq!(Recipe::in_file(b"# mindeg 0.1.0\nv 0 0 0"), None);
        assert_eq!(Recipe::in_file(b"x made by: mindeg \xff"), None);
    }

    #[test]
    fn no_word_leads_elsewhere() {
        for word in
            ["mesh", "plate.json", "-oplate.obj", "--output=plate.obj", "95%", "1,2", "12,9,4,4"]
        {
            assert!(is_plain(word), "{word}");
        }
        for word in ["/etc/x", "../x", "a/b", "-o/x", "--output=/x", "--output=..", "..", "a\\b"] {
            assert!(!is_plain(word), "{word}");
        }
    }

    #[test]
    fn paths_lose_their_folders_and_other_words_stay() {
        let folder = tempfile::tempdir().unwrap();
        let input = folder.path().join("plate.json");
        std::fs::write(&input, "abc").unwrap();
        let output = folder.path().join("plate.obj");
        let words = [
            "mesh".into(),
            input.clone().into_os_string(),
            "--recipe".into(),
            format!("--output={}", output.display()).into(),
        ];
        let made = Recipe::new(&words, std::slice::from_ref(&input), std::slice::from_ref(&output))
            .unwrap();
        assert_eq!(made.arguments, ["mesh", "plate.json", "--recipe", "--output=plate.obj"]);
        // The digest of FIPS 180-2 for "abc".
        let digest = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
        assert_eq!(
            made.inputs,
            [Ingredient { name: "plate.json".to_owned(), sha256: digest.to_owned() }]
        );

        let other = folder.path().join("sub");
        std::fs::create_dir(&other).unwrap();
        std::fs::write(other.join("plate.json"), "other").unwrap();
        let error = Recipe::new(&words, &[input, other.join("plate.json")], &[]).unwrap_err();
        assert!(error.to_string().contains("two that differ are called plate.json"), "{error}");
        let error = Recipe::new(&["--layer".into(), "a/b".into()], &[], &[]).unwrap_err();
        assert!(error.to_string().contains("a/b leads to another folder"), "{error}");
    }
}
