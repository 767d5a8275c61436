//! Spacing laws.

use super::error::DomainJsonError;
use super::value::{ABOVE_0, Value};
use crate::spacing::Spacing;

const SPACING: &str = "\"uniform\", {\"geometric\": {\"ratio\": r}}, {\"bump\": {\"ratio\": c}}, \
                       {\"beta\": {\"beta\": b}}, {\"first_length\": h}, {\"last_length\": h} or \
                       {\"parameters\": [t1, t2, …]}";

pub(super) fn spacing(given: &Value<'_>) -> Result<Spacing, DomainJsonError> {
    if !given.is_object() {
        return match given.text(SPACING)?.as_str() {
            "uniform" => Ok(Spacing::Uniform),
            law => Err(given.error(format!("found the text {law:?}, expected {SPACING}"))),
        };
    }
    let laws = ["geometric", "bump", "beta", "first_length", "last_length", "parameters"];
    let keys = given.object(&laws, SPACING)?;
    let mut named = laws.into_iter().filter_map(|law| Some((law, keys.get(law)?)));
    let (Some((law, value)), None) = (named.next(), named.next()) else {
        return Err(given.error(format!("give exactly one spacing law: {SPACING}")));
    };
    let parameter = |key, wanted| value.object(&[key], wanted)?.need(key)?.number("a number");
    Ok(match law {
        "geometric" => Spacing::Geometric { ratio: parameter("ratio", "{\"ratio\": r}")? },
        "bump" => Spacing::Bump { ratio: parameter("ratio", "{\"ratio\": c}")? },
        "beta" => Spacing::Beta { beta: parameter("beta", "{\"beta\": b}")? },
        "first_length" => Spacing::FirstLength(value.number(ABOVE_0)?),
        "last_length" => Spacing::LastLength(value.number(ABOVE_0)?),
        _ => {
            let list = value.items("a list of numbers above 0 and below 1")?;
            Spacing::Parameters(
                list.iter().map(|t| t.number("a number")).collect::<Result<_, _>>()?,
            )
        }
    })
}
