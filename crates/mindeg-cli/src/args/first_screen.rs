//! The help that fits a screen: of a command with many options `-h` shows those that most users need, each in one
//! sentence; `--help` shows all.

use clap::Command;

/// The commands with many options, and the arguments that `-h` shows of them.
const SHOWN: [(&str, &[&str]); 1] = [(
    "mesh",
    &[
        "domain",
        "keep_angle",
        "max_degree",
        "interior",
        "target_angle",
        "growth",
        "rectangle",
        "size",
        "output",
        "preset",
        "json",
    ],
)];

/// The command line with short help.
pub(super) fn shortened(command: Command) -> Command {
    SHOWN.iter().fold(command, |command, &(name, shown)| {
        command.mut_subcommand(name, |command| {
            let command = command.mut_args(|arg| {
                if !shown.contains(&arg.get_id().as_str()) {
                    return arg.hide_short_help(true);
                }
                match arg.get_help().map(ToString::to_string) {
                    Some(text) => arg.help(first_sentence(&text).to_owned()).long_help(text),
                    None => arg,
                }
            });
            let all = format!("All options: mindeg {name} --help");
            let examples = command.get_after_help().map(ToString::to_string).unwrap_or_default();
            let examples: Vec<&str> = examples.lines().take(4).collect();
            command.after_help(format!("{}\n\n{all}", examples.join("\n")))
        })
    })
}

/// A text up to its first full stop or semicolon.
fn first_sentence(text: &str) -> &str {
    let ends = ["; ", ". "].iter().filter_map(|end| text.find(end));
    ends.min().map_or(text, |end| &text[..end])
}

#[cfg(test)]
mod tests {
    use crate::args::Arguments;
    use clap::CommandFactory;

    #[test]
    fn short_help_fits_a_screen_and_long_help_has_every_option() {
        let mut command = super::shortened(Arguments::command());
        command.build();
        for (name, shown) in super::SHOWN {
            let command = command.find_subcommand_mut(name).expect("a command");
            command.set_bin_name(format!("mindeg {name}"));
            let short = command.clone().term_width(80).render_help().to_string();
            assert!(short.lines().count() <= 50, "{short}");
            let long = command.render_long_help().to_string();
            for arg in command.get_arguments() {
                let Some(option) = arg.get_long() else { continue };
                assert!(long.contains(&format!("--{option}")), "{option}");
                let is_shown = shown.contains(&arg.get_id().as_str()) || option == "help";
                assert_eq!(
                    short.contains(&format!("--{option} ")) || short.ends_with(option),
                    is_shown,
                    "{option} {short}"
                );
            }
        }
    }
}
