//! The provenance of a page, and the commands that it advises.

use crate::args::{Arguments, DomainOptions};
use mindeg::Domain;
use mindeg_answers::command::{MeshCommand, file_word, shell_word};
use mindeg_compare::Provenance;
use std::env::args_os;
use std::path::Path;

/// The provenance of a page on a mesh: the file as it was given, and the command line.
pub(crate) fn provenance(input: Option<&Path>) -> Provenance {
    let words = args_os().skip(1).map(|word| shell_word(&word.to_string_lossy()));
    let command = [String::from("mindeg")].into_iter().chain(words).collect::<Vec<_>>().join(" ");
    let input = input.filter(|path| *path != Path::new("-"));
    Provenance {
        input: input.map(|path| path.display().to_string()),
        command: Some(command),
        ..Provenance::default()
    }
}

/// The provenance of a page on a domain, which was read from the file or made of options.
pub(crate) fn provenance_of(domain: &Domain, input: Option<&Path>) -> Provenance {
    Provenance { mesh: mesh_command(domain, input), ..provenance(input) }
}

/// The command that makes meshes of a domain as the command line names it.
pub(crate) fn mesh_command(domain: &Domain, input: Option<&Path>) -> MeshCommand {
    MeshCommand::of(&domain_words(input), domain)
}

/// The words of the command line that name a domain: its file, if there is one, and the options that say how it is read.
pub(crate) fn domain_words(input: Option<&Path>) -> Vec<String> {
    let file = input.map(|path| file_word(&path.display().to_string()));
    // Arguments that were parsed once are parsed again.
    let matches = Arguments::whole().get_matches();
    let options = matches.subcommand().map(|(_, command)| DomainOptions::given(command));
    file.into_iter().chain(options.unwrap_or_default()).collect()
}

/// The command that makes another mesh of a domain that `mindeg mesh` has meshed, into the same files.
pub(crate) fn mesh_command_again(domain: &Domain, input: Option<&Path>) -> MeshCommand {
    let words = args_os().map(|word| word.to_string_lossy().into_owned());
    let words: Vec<String> = words.skip_while(|word| word != "mesh").skip(1).collect();
    mesh_command(domain, input).again(&words)
}
