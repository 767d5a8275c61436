//! The goal of a domain's mesh: an option for each row of [`GOALS`].

use clap::builder::{PossibleValuesParser, TypedValueParser, ValueParser};
use clap::error::{Error, ErrorKind};
use clap::{Arg, ArgAction, ArgMatches, Args, Command, FromArgMatches};
use mindeg::{GOALS, Goal, GoalKind, GoalValue};

/// The goals that are given, in the order of the table; by default, the least maximum degree.
#[derive(Clone, Debug, Default)]
pub(crate) struct GoalArguments {
    given: Vec<Goal>,
}

impl GoalArguments {
    /// The goal that decides.
    pub(crate) fn goal(&self) -> Goal {
        self.given.first().copied().unwrap_or_default()
    }

    /// The maximum degree that is demanded.
    pub(crate) fn max_degree(&self) -> Option<u32> {
        self.given.iter().find_map(|goal| match goal {
            Goal::MaxDegree(limit) => Some(*limit),
            _ => None,
        })
    }

    /// The kinds of the goals that are given.
    pub(crate) fn kinds(&self) -> impl Iterator<Item = &'static GoalKind> {
        self.given.iter().map(|goal| goal.kind_and_value().0)
    }

    /// The kinds that are options: all but the default.
    fn all() -> impl Iterator<Item = &'static GoalKind> {
        let default = Goal::default().kind_and_value().0;
        GOALS.iter().filter(|kind| kind.key != default.key)
    }
}

/// Whether a kind is also a demand on the mesh of another goal.
fn is_demand(kind: &GoalKind) -> bool {
    kind.key == "max_degree"
}

/// The option for a kind.
fn option(kind: &'static GoalKind) -> Arg {
    let read = |text: &str| kind.read(text);
    let arg = Arg::new(kind.key)
        .long(kind.key.replace('_', "-"))
        .help(kind.help)
        .help_heading("Goals")
        .allow_hyphen_values(true);
    let arg = match kind.value {
        GoalValue::Nothing => arg.action(ArgAction::SetTrue),
        GoalValue::Share => arg.value_name("SHARE").value_parser(ValueParser::from(read)),
        GoalValue::Degree => arg.value_name("D").value_parser(ValueParser::from(read)),
        GoalValue::Word(word) => {
            let words = PossibleValuesParser::new([word]);
            arg.value_name("WHAT").value_parser(words.try_map(|word| kind.read(&word)))
        }
    };
    if is_demand(kind) {
        return arg;
    }
    let others = GoalArguments::all().filter(|it| it.key != kind.key && !is_demand(it));
    arg.conflicts_with_all(others.map(|other| other.key))
}

impl Args for GoalArguments {
    fn augment_args(command: Command) -> Command {
        command.args(Self::all().map(option))
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl FromArgMatches for GoalArguments {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, Error> {
        let mut given = Vec::new();
        for kind in Self::all() {
            let wrong =
                |problem: &dyn ToString| Error::raw(ErrorKind::InvalidValue, problem.to_string());
            if kind.value != GoalValue::Nothing {
                let found = matches.try_get_one::<Goal>(kind.key).map_err(|error| wrong(&error))?;
                given.extend(found);
            } else if matches.get_flag(kind.key) {
                given.push(kind.read("").map_err(|error| wrong(&error))?);
            }
        }
        Ok(Self { given })
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}
