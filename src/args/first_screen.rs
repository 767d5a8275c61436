//! The texts of help: by `-h` the options that most users need, each in one sentence, on a screen; `--help` all, without blank lines
//! between options.

use clap::{Arg, ArgAction, Command};

/// Headings, and the arguments below each.
type Groups = [(&'static str, &'static [&'static str])];

/// The arguments that `-h` shows of `mesh`, which has very many, under headings of its own and in this order.
const OF_MESH: &Groups = &[
    ("", &["domain"]),
    ("Mesh", &["interior", "for", "target_angle", "keep_angle", "max_degree", "preset"]),
    ("Sizes", &["rectangle", "size"]),
    ("Output", &["output", "json"]),
];

/// Options that `-h` hides in all other commands: few users need them, and `--help` shows them.
const HIDDEN: [&str; 34] = [
    "feature",
    "proof",
    "format",
    "ascii",
    "msh_version",
    "double",
    "no_fields",
    "degree_colors",
    "boundary_lines",
    "floor",
    "layer",
    "name_by",
    "sea_in",
    "size_of",
    "snap",
    "fill_rule",
    "corner_angle",
    "spacing",
    "corners",
    "write_anyway",
    "weld",
    "no_weld",
    "planar_tolerance",
    "effort",
    "periodic",
    "save_meshes",
    "time_limit",
    "reproduce",
    "sizes",
    "depth",
    "elevation",
    "time_step",
    "slope",
    "wavelength",
];

/// How many examples `-h` shows.
const EXAMPLES: usize = 3;

/// The command line with the help that fits a screen.
pub(super) fn shortened(command: Command) -> Command {
    let names: Vec<String> =
        command.get_subcommands().map(|command| command.get_name().to_owned()).collect();
    names.into_iter().fold(command, |command, name| {
        command.mut_subcommand(&name, |command| {
            let groups = (name == "mesh").then_some(OF_MESH);
            let command = command.mut_args(|arg| {
                let is_json = arg.get_id() == "json";
                let arg = match arg.get_help().map(ToString::to_string) {
                    Some(text) => arg.help(first_sentence(&text, is_json).to_owned()),
                    None => arg,
                };
                let id = arg.get_id().as_str();
                let Some(groups) = groups else {
                    let is_hidden = HIDDEN.contains(&id);
                    return arg.hide_short_help(is_hidden);
                };
                let place = |ids: &[&str]| ids.iter().position(|shown| *shown == id);
                let found = groups.iter().find_map(|(heading, ids)| Some((heading, place(ids)?)));
                match found {
                    Some((heading, place)) if !heading.is_empty() => {
                        arg.help_heading(*heading).display_order(place)
                    }
                    Some(_) => arg,
                    None => arg.hide_short_help(true),
                }
            });
            let is_all = command.get_arguments().all(|arg| !arg.is_hide_short_help_set());
            let examples = command.get_after_help().map(ToString::to_string).unwrap_or_default();
            let mut after = first_examples(&examples);
            if !is_all {
                after += &format!("\n\nAll options: mindeg {name} --help");
            }
            command.after_help(after)
        })
    })
}

/// A command with the help that has all. Clap leaves no blank lines where nothing is for long help alone.
pub(super) fn complete(command: Command) -> Command {
    let about = command.get_long_about().or(command.get_about()).cloned().unwrap_or_default();
    let after = command.get_after_long_help().or(command.get_after_help()).cloned();
    let after = after.unwrap_or_default();
    let command = command.about(about).long_about(None).after_help(after).after_long_help(None);
    // Who reads this has found it.
    let help = Arg::new("help").short('h').long("help").action(ArgAction::HelpShort).hide(true);
    let command = command.disable_help_flag(true).arg(help);
    command.next_line_help(true).mut_args(|arg| {
        let mut text =
            arg.get_long_help().or(arg.get_help()).map(ToString::to_string).unwrap_or_default();
        let values = arg.get_possible_values();
        let explained: Vec<String> = values
            .iter()
            .filter_map(|it| Some(format!("{}: {}", it.get_name(), it.get_help()?)))
            .collect();
        let is_hidden = arg.is_hide_possible_values_set();
        let are_explained = !is_hidden && !explained.is_empty();
        if are_explained {
            text += &format!("; {}", explained.join("; "));
        }
        arg.help(text)
            .long_help(None)
            .hide_short_help(false)
            .hide_possible_values(is_hidden || are_explained)
    })
}

/// The first examples of a text; one that goes on in the next line is one.
fn first_examples(text: &str) -> String {
    let mut count = 0;
    let mut goes_on = true;
    let is_shown = |line: &&str| {
        count += usize::from(!goes_on);
        goes_on = line.ends_with('\\');
        count <= EXAMPLES
    };
    text.lines().take_while(is_shown).collect::<Vec<_>>().join("\n")
}

/// A text up to its first full stop or semicolon; of JSON also without its keys, which follow a colon.
fn first_sentence(text: &str, is_json: bool) -> &str {
    let ends = ["; ", ". ", ": "].iter().take(if is_json { 3 } else { 2 });
    let ends = ends.filter_map(|end| text.find(end));
    ends.min().map_or(text, |end| &text[..end])
}

#[cfg(test)]
mod tests {
    use crate::args::Arguments;

    fn help(name: &str) -> [String; 2] {
        let render = |mut command: clap::Command| {
            command.build();
            let command = command.find_subcommand_mut(name).expect("a command");
            command.set_bin_name(format!("mindeg {name}"));
            command.clone().term_width(80).render_help().to_string()
        };
        [render(Arguments::short()), render(Arguments::long(&[name.into()]))]
    }

    #[test]
    fn the_help_of_mesh_fits_a_screen() {
        let [short, long] = help("mesh");
        assert!(short.lines().count() <= 40, "{short}");
        for (_, ids) in super::OF_MESH {
            for id in *ids {
                assert!(short.to_lowercase().contains(&id.replace('_', "-")), "{id} {short}");
            }
        }
        assert!(!short.contains("--boundary-degree") && long.contains("--boundary-degree"));
    }

    /// The widest that help gets, as in a pipe.
    #[test]
    fn all_help_of_mesh_fits_few_screens() {
        let mut command = Arguments::long(&["mesh".into()]);
        let mesh = command.find_subcommand_mut("mesh").expect("a command");
        let help = mesh.clone().term_width(100).render_help().to_string();
        assert!(help.lines().count() <= 200, "{} lines: {help}", help.lines().count());
    }

    #[test]
    fn long_help_has_every_option_and_no_line_breaks_an_example() {
        for command in Arguments::whole().get_subcommands() {
            let [short, long] = help(command.get_name());
            assert!(short.lines().count() <= 62, "{short}");
            for arg in command.get_arguments() {
                let Some(option) = arg.get_long() else { continue };
                assert!(long.contains(&format!("--{option}")), "{option}");
            }
            let examples = command.get_after_help().expect("examples").to_string();
            for line in examples.lines() {
                assert!(line.chars().count() <= 80 && long.contains(line), "{line}");
            }
        }
    }
}
