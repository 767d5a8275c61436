//! Interior points: what a mesh is to be like inside.
//!
//! The options are the keys of [`Interior`] that have one value, with the texts of its JSON Schema.

use super::values::{Length, length_with_unit, target_angle};
use crate::failure::Failure;
use crate::interrupt::SESSION;
use clap::builder::{PossibleValuesParser, TypedValueParser, ValueParser};
use clap::error::{Error, ErrorKind};
use clap::{Arg, ArgMatches, Args, Command, FromArgMatches};
use mindeg::{Interior, Size};
use mindeg_answers::interior_keys::{InteriorKey, KeyValue, interior_keys};
use mindeg_files::Input;
use serde_json::{Map, Value, json};
use std::path::PathBuf;
use std::sync::LazyLock;

/// Whether there are interior points, and where.
#[derive(Debug, Args)]
#[command(next_help_heading = "Interior points")]
pub(crate) struct InteriorArguments {
    /// Add points inside; the boundary stays exactly, sizes grow smoothly from it, and the minimum angle comes near its
    /// proven limit. Also on if the domain's file has "interior"
    #[arg(long)]
    pub(crate) interior: bool,

    /// Add none, also if the domain's file has "interior"
    #[arg(long, conflicts_with = "interior")]
    pub(crate) no_interior: bool,

    /// Sizes of a grid or mesh: .asc, classic NetCDF, NPZ, .npy, MSH, VTU; the least of several holds
    #[arg(long, value_name = "FILE")]
    pub(crate) sizes: Vec<PathBuf>,

    #[command(flatten)]
    pub(crate) wanted: Wanted<true>,
}

/// Wishes with the sizes of files, too.
pub(crate) fn with_sizes_of(mut wanted: Interior, files: &[PathBuf]) -> Result<Interior, Failure> {
    for path in files {
        wanted.sizes.push(Size::Between(SESSION.sizes(&Input::of(path))?));
    }
    Ok(wanted)
}

/// Wishes for the mesh inside, as given; with `PLACES` also where points go, not only what an optimiser
/// aims at. Options given here are demands: if a mesh misses one, nothing is written.
#[derive(Clone, Debug, Default)]
pub(crate) struct Wanted<const PLACES: bool> {
    given: Map<String, Value>,
    /// The lengths among them that were given with a unit.
    metric: Vec<String>,
    pub(crate) write_anyway: bool,
}

/// The keys that are lengths.
const LENGTHS: [(&str, &str); 3] =
    [("size_inside", "--size-inside"), ("min_size", "--min-size"), ("max_size", "--max-size")];

/// The aims of an optimiser.
const AIMS: [&str; 5] =
    ["interior_degree", "boundary_degree", "boundary_corners", "target_angle", "prefer"];

impl<const PLACES: bool> Wanted<PLACES> {
    /// The wishes of a file, with those of the options in their place.
    pub(crate) fn over(&self, file: Option<&Interior>) -> Interior {
        let file = file.cloned().unwrap_or_default();
        let Value::Object(mut keys) = json!(file) else { return file };
        keys.extend(self.given.clone());
        // Each value was read as one of these.
        serde_json::from_value(Value::Object(keys)).unwrap_or(file)
    }

    /// The first option here that has no meaning without interior points.
    pub(crate) fn first_given(&self) -> Option<String> {
        let key = self.given.keys().find(|key| *key != "target_angle")?;
        Some(format!("--{}", key.replace('_', "-")))
    }

    /// The lengths that are given, with their options.
    pub(crate) fn lengths(&self) -> [(&'static str, Option<Length>); 3] {
        LENGTHS.map(|(key, option)| {
            let value = self.given.get(key).and_then(Value::as_f64);
            let is_metric = self.metric.iter().any(|metric| metric == key);
            (option, value.map(|value| Length { value, is_metric }))
        })
    }

    pub(crate) fn target_angle(&self) -> Option<f64> {
        self.over(None).target_angle
    }

    /// The keys that are options here.
    fn keys() -> impl Iterator<Item = &'static InteriorKey> {
        KEYS.iter().filter(|it| PLACES || AIMS.contains(&&*it.name))
    }
}

/// The key of a length with its unit, until it is told apart from one without.
const METRES: &str = "metres";

static KEYS: LazyLock<Vec<InteriorKey>> = LazyLock::new(interior_keys);

/// The option for a key.
fn option(key: &'static InteriorKey) -> Arg {
    let name = &*key.name;
    let text = match name {
        "target_angle" => {
            format!("{}; without interior points it is demanded, not aimed at", key.text)
        }
        _ => key.text.clone(),
    };
    let heading = if AIMS.contains(&name) { "Aims" } else { "Interior points" };
    let arg = Arg::new(name).long(name.replace('_', "-")).help(text).help_heading(heading);
    let arg = arg.value_name(value_name(key)).allow_hyphen_values(true);
    if key.value == KeyValue::Choice {
        let words = PossibleValuesParser::new(key.choices.iter().map(|word| &**word));
        return arg.hide_possible_values(true).value_parser(words.map(|word| json!(word)));
    }
    arg.value_parser(ValueParser::from(move |text: &str| match name {
        "target_angle" => target_angle(text).map(|angle| json!(angle)),
        _ if LENGTHS.iter().any(|length| length.0 == name) => match length_with_unit(text) {
            Ok(length) if length.is_metric => Ok(json!({ METRES: length.value })),
            _ => value(name, text),
        },
        _ => value(name, text),
    }))
}

/// The name of the value in the help, such as D for a degree.
fn value_name(key: &InteriorKey) -> String {
    let initial = key.name.rsplit('_').next().and_then(|last| last.chars().next());
    match key.value {
        KeyValue::Range => "A..B".to_owned(),
        KeyValue::Choice => key.choices.join("|"),
        _ => initial.map(|initial| initial.to_ascii_uppercase()).into_iter().collect(),
    }
}

/// The value of a key in a text: a number, or a range such as 5..7.
fn value(key: &str, text: &str) -> Result<Value, String> {
    let whole = |text: &str| text.trim().parse::<u64>().ok();
    let number = |text: &str| text.trim().trim_end_matches('°').parse::<f64>().ok();
    let range = text.split_once("..").or_else(|| text.split_once('-'));
    let range = range.and_then(|(least, greatest)| {
        Some([whole(least)?, whole(greatest.strip_prefix('=').unwrap_or(greatest))?])
    });
    let value = match (whole(text), number(text), range) {
        (Some(whole), ..) => json!(whole),
        (_, Some(number), _) if number.is_finite() => json!(number),
        (.., Some(range)) => json!(range),
        _ => json!(text),
    };
    let wanted: Result<Interior, _> = serde_json::from_value(json!({ key: value.clone() }));
    match (wanted, key) {
        (Ok(wanted), _) => wanted.check().map(|()| value).map_err(|error| error.message),
        (Err(_), "interior_degree") => {
            Err("give the least and the greatest degree, such as 5..7".to_owned())
        }
        (Err(_), "boundary_degree" | "boundary_corners" | "max_points") => {
            Err("give a whole number".to_owned())
        }
        (Err(_), _) => Err("give a number".to_owned()),
    }
}

impl<const PLACES: bool> Args for Wanted<PLACES> {
    fn augment_args(command: Command) -> Command {
        let write_anyway = Arg::new("write_anyway")
            .long("write-anyway")
            .action(clap::ArgAction::SetTrue)
            .help_heading("Aims")
            .help("Write the mesh also if it is not what was demanded; the exit code is 3 all the same");
        command.args(Self::keys().map(option)).arg(write_anyway)
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl<const PLACES: bool> FromArgMatches for Wanted<PLACES> {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, Error> {
        let mut wanted = Self { write_anyway: matches.get_flag("write_anyway"), ..Self::default() };
        for InteriorKey { name, .. } in Self::keys() {
            let found = matches.try_get_one::<Value>(name);
            let found = found.map_err(|error| Error::raw(ErrorKind::InvalidValue, error))?;
            let metres = found.and_then(|value| value.get(METRES));
            wanted.metric.extend(metres.map(|_| name.clone()));
            let found = metres.or(found);
            wanted.given.extend(found.map(|value| (name.clone(), value.clone())));
        }
        Ok(wanted)
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_of_degrees_are_read() {
        for text in ["5..7", "5..=7", "5-7", " 5 .. 7 "] {
            assert_eq!(value("interior_degree", text), Ok(json!([5, 7])), "{text}");
        }
        for text in ["", "5", "5..", "a..b", "5,7", "-1..7", "7..9"] {
            assert!(value("interior_degree", text).is_err(), "{text}");
        }
    }

    #[test]
    fn growths_are_read() {
        assert_eq!(value("growth", "0.3"), Ok(json!(0.3)));
        for text in ["0", "-0.5", "nan", "inf", "x"] {
            assert!(value("growth", text).is_err(), "{text}");
        }
    }

    #[test]
    fn options_go_before_a_file() {
        let file = Interior { growth: Some(0.1), boundary_degree: Some(6), ..Interior::default() };
        let given = Map::from_iter([("growth".to_owned(), json!(0.3))]);
        let wanted = Wanted::<true> { given, ..Wanted::default() }.over(Some(&file));
        assert_eq!((wanted.growth, wanted.boundary_degree), (Some(0.3), Some(6)));
    }
}
