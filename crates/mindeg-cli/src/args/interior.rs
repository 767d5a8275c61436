//! Interior points: what a mesh is to be like inside.
//!
//! The options are the keys of [`Interior`] that have one value, with the texts of its JSON Schema.

use super::values::target_angle;
use clap::builder::{PossibleValuesParser, TypedValueParser, ValueParser};
use clap::error::{Error, ErrorKind};
use clap::{Arg, ArgMatches, Args, Command, FromArgMatches};
use mindeg::{DomainDescription, Interior};
use serde_json::{Map, Value, json};
use std::sync::LazyLock;

/// Whether there are interior points, and where.
#[derive(Debug, Args)]
#[command(next_help_heading = "Interior points")]
pub(crate) struct InteriorArguments {
    /// Add points inside: the boundary points stay exactly; sizes grow smoothly from the boundary's;
    /// degrees are 5 to 7 inside and at most 5 at the boundary; the minimum angle comes near its
    /// proven limit. Also on if the domain's file has "interior"
    #[arg(long)]
    pub(crate) interior: bool,

    /// Mesh the boundary points alone, also if the domain's file has "interior"
    #[arg(long, conflicts_with = "interior")]
    pub(crate) no_interior: bool,

    #[command(flatten)]
    pub(crate) wanted: Wanted<true>,
}

/// What is wanted inside, as given; with `PLACES` also where points go, not only what an optimiser
/// aims at. What is given here is demanded: if it is not reached, nothing is written.
#[derive(Clone, Debug, Default)]
pub(crate) struct Wanted<const PLACES: bool> {
    given: Map<String, Value>,
    pub(crate) write_anyway: bool,
}

/// What an optimiser aims at.
const AIMS: [&str; 4] = ["interior_degree", "boundary_degree", "target_angle", "prefer"];

/// The keys that are lists of places: for files.
const LISTS: [&str; 2] = ["sizes", "fixed"];

impl<const PLACES: bool> Wanted<PLACES> {
    /// What is wanted, with what the options give in place of what a file gives.
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

    pub(crate) fn target_angle(&self) -> Option<f64> {
        self.over(None).target_angle
    }

    /// The keys that are options here.
    fn keys() -> impl Iterator<Item = &'static Key> {
        KEYS.iter().filter(|key| PLACES || AIMS.contains(&&*key.name))
    }
}

/// A key of [`Interior`] with one value.
struct Key {
    name: String,
    option: String,
    value_name: String,
    schema: Value,
}

static KEYS: LazyLock<Vec<Key>> = LazyLock::new(|| {
    let schema: Map<String, Value> =
        serde_json::from_str(&DomainDescription::schema()).unwrap_or_default();
    let keys = schema.get("$defs").map(|types| types["Interior"]["properties"].clone());
    let keys = keys.and_then(|keys| keys.as_object().cloned()).unwrap_or_default();
    let keys = keys.into_iter().filter(|(name, _)| !LISTS.contains(&&**name));
    let key = |(name, schema): (String, Value)| {
        // The initial of what it is: D for a degree.
        let initial = name.rsplit('_').next().and_then(|last| last.chars().next());
        let value_name = match schema["type"][0].as_str() {
            Some("array") => "A..B".to_owned(),
            _ => initial.map(|initial| initial.to_ascii_uppercase()).into_iter().collect(),
        };
        Key { option: name.replace('_', "-"), value_name, name, schema }
    };
    keys.map(key).collect()
});

/// The option for a key.
fn option(Key { name: key, option, value_name, schema }: &'static Key) -> Arg {
    let text = schema["description"].as_str().unwrap_or_default().replace('\n', " ");
    let text = match &**key {
        "target_angle" => format!("{text}; without interior points it is demanded, not aimed at"),
        _ => text,
    };
    let heading = if AIMS.contains(&&**key) { "Aims" } else { "Interior points" };
    let arg =
        Arg::new(&**key).long(&**option).help(text).help_heading(heading).allow_hyphen_values(true);
    if key == "prefer" {
        let names = PossibleValuesParser::new(["degree", "angle"]);
        return arg.value_name("WHAT").value_parser(names.map(|name| json!(name)));
    }
    if key == "target_angle" {
        let parser = |text: &str| target_angle(text).map(|angle| json!(angle));
        return arg.value_name("A").value_parser(ValueParser::from(parser));
    }
    let parser = move |text: &str| value(key, text);
    arg.value_parser(ValueParser::from(parser)).value_name(&**value_name)
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
        (Err(_), "boundary_degree" | "max_points") => Err("give a whole number".to_owned()),
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
        for Key { name, .. } in Self::keys() {
            let found = matches.try_get_one::<Value>(name);
            let found = found.map_err(|error| Error::raw(ErrorKind::InvalidValue, error))?;
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

    /// An option more is a field of [`Interior`] more, and nothing here.
    #[test]
    fn every_value_of_the_interior_is_an_option() {
        let keys: Vec<String> = Wanted::<true>::keys().map(|key| key.name.clone()).collect();
        let of_json = json!(Interior::default());
        for key in of_json.as_object().expect("an object").keys() {
            assert!(keys.contains(key) || LISTS.contains(&&**key), "{key}");
        }
        assert!(keys.contains(&"max_points".to_owned()));
        assert_eq!(Wanted::<false>::keys().count(), AIMS.len());
    }

    #[test]
    fn options_go_before_a_file() {
        let file = Interior { growth: Some(0.1), boundary_degree: Some(6), ..Interior::default() };
        let given = Map::from_iter([("growth".to_owned(), json!(0.3))]);
        let wanted = Wanted::<true> { given, write_anyway: false }.over(Some(&file));
        assert_eq!((wanted.growth, wanted.boundary_degree), (Some(0.3), Some(6)));
    }
}
