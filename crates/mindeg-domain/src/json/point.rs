//! Points and lists of points.

use glam::DVec2;

use super::error::DomainJsonError;
use super::value::Value;

const PAIR: &str = "a pair [x, y] of numbers";

pub(super) fn pair(given: &Value<'_>) -> Result<DVec2, DomainJsonError> {
    match &given.items(PAIR)?[..] {
        [x, y] => Ok(DVec2::new(x.number("a number")?, y.number("a number")?)),
        items => {
            let values = if items.len() == 1 { "value" } else { "values" };
            Err(given.error(format!("found a list of {} {values}, expected {PAIR}", items.len())))
        }
    }
}

/// Many points, fast; slowly where one of them is wrong, to say which.
pub(super) fn points(given: &Value<'_>) -> Result<Vec<DVec2>, DomainJsonError> {
    if let Some(points) = given.read::<Vec<[f64; 2]>>()
        && points.iter().flatten().all(|coordinate| coordinate.is_finite())
    {
        return Ok(points.into_iter().map(DVec2::from).collect());
    }
    given.items("a list of [x, y] pairs of numbers")?.iter().map(pair).collect()
}
