//! The wanted mesh, from JSON text.

use mindeg::{GOALS, Goal, Interior};
use serde_json::{Map, Value};

/// The wanted mesh.
#[derive(Debug, PartialEq)]
pub(crate) enum Wanted {
    /// One of boundary points alone.
    Goal(Goal),
    /// One with points inside.
    Interior(Interior),
}

impl Wanted {
    /// From text: a JSON object with the key of a goal, or with `interior`. `None` without a key.
    pub(crate) fn read(text: &str) -> Result<Option<Self>, String> {
        let keys: Map<String, Value> =
            serde_json::from_str(text).map_err(|error| format!("options: {error}"))?;
        let mut found: Option<(String, Self)> = None;
        for (key, value) in keys {
            if let Some((other, _)) = found {
                return Err(format!("options: {other} and {key} exclude each other; give one"));
            }
            let wanted = if key == "interior" { interior(&value) } else { goal(&key, &value) }?;
            found = Some((key, wanted));
        }
        Ok(found.map(|(_, wanted)| wanted))
    }
}

fn interior(value: &Value) -> Result<Wanted, String> {
    let read = Interior::from_json(&value.to_string());
    read.map(Wanted::Interior).map_err(|error| format!("options: interior: {error}"))
}

fn goal(key: &str, value: &Value) -> Result<Wanted, String> {
    let Some(kind) = GOALS.iter().find(|kind| kind.key == key) else {
        let keys: Vec<&str> = GOALS.iter().map(|kind| kind.key).collect();
        return Err(format!(
            "options: no key is named {key:?}; give {} or interior",
            keys.join(", ")
        ));
    };
    let text = value.as_str().map_or_else(|| value.to_string(), str::to_owned);
    kind.read(&text).map(Wanted::Goal).map_err(|problem| format!("options: {key}: {problem}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn options_are_goals_of_the_table_or_points_inside() {
        let goal = |goal| Ok(Some(Wanted::Goal(goal)));
        assert_eq!(Wanted::read("{}"), Ok(None));
        assert_eq!(Wanted::read(r#"{"max_degree": 5}"#), goal(Goal::MaxDegree(5)));
        assert_eq!(Wanted::read(r#"{"keep_angle": "95%"}"#), goal(Goal::KeepAngle(0.95)));
        assert_eq!(Wanted::read(r#"{"keep_angle": 0.95}"#), goal(Goal::KeepAngle(0.95)));
        let interior = Interior { target_angle: Some(25.0), ..Interior::default() };
        let read = Wanted::read(r#"{"interior": {"target_angle": 25}}"#);
        assert_eq!(read, Ok(Some(Wanted::Interior(interior))));
    }

    #[test]
    fn mistakes_in_options_say_what_to_give() {
        for (text, part) in [
            ("[", "options: "),
            (r#"{"degree": 5}"#, "keep_angle, max_degree, optimize, least_degree or interior"),
            (r#"{"max_degree": 5, "keep_angle": 1}"#, "exclude each other"),
            (r#"{"max_degree": -1}"#, "max_degree: give a whole number"),
            (r#"{"interior": {"angle": 3}}"#, "options: interior: "),
        ] {
            let error = Wanted::read(text).expect_err(text);
            assert!(error.contains(part), "{text}: {error}");
        }
    }
}
