//! The messages on standard error: colored as clap colors its own errors, and wrapped on words to
//! the width of a terminal.

use anstream::AutoStream;
use clap::ColorChoice;
use clap::builder::styling::Styles;
use mindeg_answers::names::{safe_lines, shown};
use std::borrow::Cow;
use std::ffi::OsString;
use std::io::{self, Write};
use std::sync::LazyLock;
use terminal_size::{Height, Width, terminal_size_of};

/// The widest lines, as in the help.
const WIDEST: usize = 100;

/// The `--color` among the arguments as they are typed: errors in them are colored by it, too.
pub(crate) fn color_choice(arguments: &[OsString]) -> ColorChoice {
    let mut texts = arguments.iter().map(|text| text.to_string_lossy());
    let mut choice = ColorChoice::Auto;
    while let Some(text) = texts.next() {
        let value = match &*text {
            "--" => break,
            "--color" => texts.next(),
            text => text.strip_prefix("--color=").map(|value| value.to_owned().into()),
        };
        choice = value.and_then(|value| value.parse().ok()).unwrap_or(choice);
    }
    choice
}

/// From here on, errors are colored like this.
pub(crate) fn set_color(choice: ColorChoice) {
    match choice {
        ColorChoice::Auto => anstream::ColorChoice::Auto,
        ColorChoice::Always => anstream::ColorChoice::Always,
        ColorChoice::Never => anstream::ColorChoice::Never,
    }
    .write_global();
}

/// Says why a run ends.
pub(crate) fn say_error(message: &str) {
    let style = *Styles::styled().get_error();
    let text = wrapped(&safe(&format!("error: {message}")));
    let text = text.strip_prefix("error:").unwrap_or(&text);
    // With standard error closed too there is nobody left to tell.
    let _ = writeln!(AutoStream::auto(io::stderr()), "{style}error:{style:#}{text}");
}

/// Prints what a run has done. An error while printing does not fail the run.
pub(crate) fn say(text: &str) {
    let _ = writeln!(io::stderr(), "{}", wrapped(&safe(text)));
}

/// A text of several lines in which nothing steers a terminal: names come from files, and files from
/// anywhere. Characters that would are shown as escapes. All that the command line prints passes here.
pub(crate) fn safe(text: &str) -> Cow<'_, str> {
    static BROKEN: LazyLock<Vec<String>> = LazyLock::new(|| broken_names(std::env::args_os()));
    on_one_line(text, &BROKEN)
}

/// The text with its own line breaks alone: those of these names are escaped, too.
fn on_one_line<'a>(text: &'a str, broken: &[String]) -> Cow<'a, str> {
    let safe = safe_lines(text);
    broken.iter().fold(safe, |text, name| {
        // The text has escapes in place of other control characters of the name.
        let name = safe_lines(name);
        match text.contains(&*name) {
            true => Cow::Owned(text.replace(&*name, &shown(&name))),
            false => text,
        }
    })
}

/// The names of files and folders among arguments that have a line break, without extensions: the files beside a
/// file have others.
fn broken_names(arguments: impl Iterator<Item = OsString>) -> Vec<String> {
    let mut names = Vec::new();
    for argument in arguments {
        let argument = argument.to_string_lossy();
        let parts = argument.split(std::path::is_separator).filter(|part| part.contains('\n'));
        names.extend(parts.map(|part| {
            let stem = part.rsplit_once('.').map_or(part, |(stem, _)| stem);
            if stem.contains('\n') { stem.to_owned() } else { part.to_owned() }
        }));
    }
    names
}

/// Wraps a text to the terminal; leaves it unchanged if standard error is not a terminal.
fn wrapped(text: &str) -> String {
    let size = terminal_size_of(io::stderr());
    size.map_or_else(|| text.to_owned(), |size| wrap(text, width(size)))
}

/// The width of lines on a terminal of this size.
fn width((Width(width), _): (Width, Height)) -> usize {
    usize::from(width).min(WIDEST)
}

/// A row of a table, whose last cell goes on below itself where the terminal that shows the table ends; without a terminal
/// after 80 letters.
pub(crate) fn row(start: &str, last: &str) -> String {
    let options = textwrap::Options::new(terminal_size_of(io::stdout()).map_or(80, width));
    let indent = " ".repeat(start.chars().count());
    textwrap::fill(last, options.initial_indent(start).subsequent_indent(&indent)) + "\n"
}

/// Wraps each line of a text on spaces, but for commands: those are to be copied.
fn wrap(text: &str, width: usize) -> String {
    let options = textwrap::Options::new(width)
        // A path or a list of counts stays in one piece, to be copied, too.
        .break_words(false)
        .word_splitter(textwrap::WordSplitter::NoHyphenation);
    let wrapped = |line: &str| match line.starts_with("mindeg ") {
        true => line.to_owned(),
        false => textwrap::fill(line, &options),
    };
    text.split('\n').map(wrapped).collect::<Vec<_>>().join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_wraps_between_words() {
        let long = "the least-degree mesh /a/long/path/of/a/file.obj has\ntwo lines";
        let lines = "the\nleast-degree\nmesh\n/a/long/path/of/a/file.obj\nhas\ntwo lines";
        assert_eq!(wrap(long, 12), lines);
        let hint = "hint: take it\nmindeg tradeoff a.json\nwrote a.obj";
        assert_eq!(
            wrap(hint, 9),
            hint.replace("hint: take it", "hint:\ntake it").replace("wrote a.obj", "wrote\na.obj")
        );
        assert_eq!(wrap(long, 100), long);
    }

    #[test]
    fn nothing_in_a_text_steers_a_terminal() {
        let name = "a\u{1b}[31mb\u{7}\0\u{9b}c\u{202e}d\r\ne\tf\u{2028}";
        assert_eq!(safe(name), "a\\u{1b}[31mb\\u{7}\\u{0}\\u{9b}c\\u{202e}d\\r\ne\tf\\u{2028}");
        assert!(shown(name).contains("d\\r\\ne") && !shown(name).contains('\n'));
        assert!(matches!(safe("Côte d'Ivoire °\n"), Cow::Borrowed(_)));
    }

    #[test]
    fn a_line_break_in_a_name_ends_no_line() {
        let words = ["mindeg", "a\nb/c\nd.obj", "plain.obj", "e.f\ng"].map(OsString::from);
        let broken = broken_names(words.into_iter());
        assert_eq!(broken, ["a\nb", "c\nd", "e.f\ng"]);
        let text = "a\nb/c\nd.bin: no\nplain.obj\ne.f\ng";
        assert_eq!(on_one_line(text, &broken), "a\\nb/c\\nd.bin: no\nplain.obj\ne.f\\ng");
    }

    #[test]
    fn the_color_is_found_among_wrong_arguments() {
        for (arguments, choice) in [
            (&["mesh", "--color", "never", "--wrong"][..], ColorChoice::Never),
            (&["--color=always"], ColorChoice::Always),
            (&["--color"], ColorChoice::Auto),
            (&["--color=pink"], ColorChoice::Auto),
            (&["mesh", "--", "--color=always"], ColorChoice::Auto),
        ] {
            let arguments: Vec<OsString> = arguments.iter().map(Into::into).collect();
            assert_eq!(color_choice(&arguments), choice, "{arguments:?}");
        }
    }
}
