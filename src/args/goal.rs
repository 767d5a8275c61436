//! The goal of a domain's mesh: an option for each row of [`GOALS`].

use super::purpose;
use clap::builder::{PossibleValuesParser, TypedValueParser, ValueParser};
use clap::error::{Error, ErrorKind};
use clap::{Arg, ArgAction, ArgMatches, Args, Command, FromArgMatches};
use mindeg::{GOALS, Goal, GoalKind, GoalValue};
use mindeg_answers::advice::Purpose;

/// The goals that are given, in the order of the table; by default, the least maximum degree.
#[derive(Clone, Debug, Default)]
pub(crate) struct GoalArguments {
    given: Vec<Goal>,
    /// The purpose of the mesh, if that is told in place of a goal.
    pub(crate) purpose: Option<Purpose>,
}

impl GoalArguments {
    /// The goal that decides.
    pub(crate) fn goal(&self) -> Goal {
        let of_purpose = self.purpose.and_then(Purpose::goal);
        self.given.first().copied().or(of_purpose).unwrap_or_default()
    }

    /// Whether neither a goal nor a purpose is given.
    pub(crate) fn is_empty(&self) -> bool {
        self.given.is_empty() && self.purpose.is_none()
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
            arg.value_name(word)
                .hide_possible_values(true)
                .value_parser(words.try_map(|word| kind.read(&word)))
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
        let goals = Self::all().filter(|kind| !is_demand(kind)).map(|kind| kind.key);
        command.arg(purpose::option().conflicts_with_all(goals)).args(Self::all().map(option))
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
        let purpose = matches.try_get_one::<Purpose>(purpose::ID).ok().flatten().copied();
        Ok(Self { given, purpose })
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}
