//! The purpose of a mesh: `--for`.

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::{Arg, Args};
use mindeg_answers::advice::Purpose;

/// The option `--for`, for commands that only advise.
#[derive(Clone, Copy, Debug, Args)]
pub(crate) struct PurposeArgument {
    /// What the mesh is for, which decides the advice; without it, the first two are named
    #[arg(id = ID, long = "for", value_name = "PURPOSE", value_parser = parser(), help_heading = "Goals")]
    pub(crate) purpose: Option<Purpose>,
}

/// The identifier of the option.
pub(super) const ID: &str = "for";

/// The option `--for`, for commands that make a mesh.
pub(super) fn option() -> Arg {
    Arg::new(ID)
        .long("for")
        .value_name("PURPOSE")
        .value_parser(parser())
        .help("Make the mesh that is advised")
        .help_heading("Goals")
}

fn parser() -> impl TypedValueParser<Value = Purpose> {
    let values =
        Purpose::ALL.map(|purpose| PossibleValue::new(purpose.name()).help(purpose.help()));
    PossibleValuesParser::new(values).try_map(|word| word.parse::<Purpose>())
}
