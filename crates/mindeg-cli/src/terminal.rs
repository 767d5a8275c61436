//! What is said on standard error: colored as clap colors its own errors, and wrapped on words to
//! the width of a terminal.

use anstream::AutoStream;
use clap::ColorChoice;
use clap::builder::styling::Styles;
use std::ffi::OsString;
use std::io::{self, Write};
use terminal_size::{Width, terminal_size_of};

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
    let text = wrapped(&format!("error: {message}"));
    let text = text.strip_prefix("error:").unwrap_or(&text);
    // With standard error closed too there is nobody left to tell.
    let _ = writeln!(AutoStream::auto(io::stderr()), "{style}error:{style:#}{text}");
}

/// Says what a run has done. That it cannot be shown is no reason to fail.
pub(crate) fn say(text: &str) {
    let _ = writeln!(io::stderr(), "{}", wrapped(text));
}

/// Wraps a text to the terminal; it stays as it is where standard error is none.
fn wrapped(text: &str) -> String {
    match terminal_size_of(io::stderr()) {
        Some((Width(width), _)) => wrap(text, usize::from(width).min(WIDEST)),
        None => text.to_owned(),
    }
}

/// Wraps each line of a text on spaces.
fn wrap(text: &str, width: usize) -> String {
    let options = textwrap::Options::new(width)
        // A path or a list of counts stays in one piece, to be copied.
        .break_words(false)
        .word_splitter(textwrap::WordSplitter::NoHyphenation);
    textwrap::fill(text, options)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_wraps_between_words() {
        let long = "the least-degree mesh /a/long/path/of/a/file.obj has\ntwo lines";
        let lines = "the\nleast-degree\nmesh\n/a/long/path/of/a/file.obj\nhas\ntwo lines";
        assert_eq!(wrap(long, 12), lines);
        assert_eq!(wrap(long, 100), long);
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
