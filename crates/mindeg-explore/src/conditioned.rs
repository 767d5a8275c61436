//! The boundary of the page, divided, or changed by as little as it takes for a mesh with points inside to reach an angle.

use mindeg::interior::{BoundaryDemands, condition};
use mindeg::{Domain, Intervals, Progress};
use mindeg_answers::command::domain_stem;
use mindeg_answers::condition::ConditionAnswer;
use serde::{Deserialize, Serialize};
use serde_json::value::RawValue;

use crate::answer::understood;
use crate::command::{KnownFiles, with_domain};
use crate::terms::without_options;

/// The wishes for a boundary.
#[derive(Clone, Copy, Debug, Deserialize)]
pub(crate) struct Asked {
    /// The minimum angle that it shall allow, in degrees.
    angle: f64,
    /// The length of its edges; as it is, if not given.
    size: Option<f64>,
    /// How far it may move; by default as far as the command lets it.
    within: Option<f64>,
}

/// A changed boundary.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct ConditionedShown {
    domain: Box<RawValue>,
    /// The changes, in sentences.
    words: String,
    /// The command that makes the same domain.
    command: String,
}

/// The domain of a request with the boundary that is wished for.
///
/// # Errors
///
/// Why there is none, in a sentence.
pub(crate) fn conditioned(
    asked: &Asked,
    body: &[u8],
    known: &KnownFiles,
    _: Progress<'_>,
) -> Result<ConditionedShown, String> {
    let (request, domain) = understood(body).map_err(|(message, _)| message)?;
    let Asked { angle, size, within } = *asked;
    let base = size.map_or_else(BoundaryDemands::default, BoundaryDemands::of_size);
    let demands = BoundaryDemands { angle, within: within.unwrap_or(base.within), ..base };
    let wanted = domain.interior().cloned().unwrap_or_default();
    let (changed, found) =
        condition(&domain, &wanted, &demands, &[]).map_err(|error| error.to_string())?;
    let json = RawValue::from_string(changed.to_json()).map_err(|error| error.to_string())?;
    let file = format!("{}-conditioned.json", domain_stem(&domain));
    let mut options = vec!["--limit".to_owned(), angle.to_string()];
    for (option, length) in [("--size", size), ("--within", within)] {
        options.extend(length.iter().flat_map(|length| [option.to_owned(), length.to_string()]));
    }
    options.extend(["-o".to_owned(), file]);
    let command = with_domain("condition", request.domain.get(), known, &options);
    let name = domain.name().unwrap_or("the boundary").to_owned();
    let answer = ConditionAnswer::of(&[domain], &[changed], &[found]);
    Ok(ConditionedShown { domain: json, words: without_options(&answer.text(&name)), command })
}

/// A domain with all sides divided into edges of a length, as `--size` divides them.
///
/// # Errors
///
/// Why there is none, in a sentence.
pub(crate) fn divided(domain: Domain, size: f64) -> Result<Domain, String> {
    let mut sides = domain.sides().to_vec();
    sides.iter_mut().for_each(|side| side.intervals = Intervals::Size(size));
    domain.with_sides(sides).map_err(|error| error.to_string())
}

/// The domain of a request, divided so.
///
/// # Errors
///
/// The errors of [`divided`].
pub(crate) fn divided_json(size: f64, body: &[u8]) -> Result<Box<RawValue>, String> {
    let (_, domain) = understood(body).map_err(|(message, _)| message)?;
    RawValue::from_string(divided(domain, size)?.to_json()).map_err(|error| error.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two edges half a unit from each other, ten units long.
    const STRAIT: &str =
        r#"{"domain": {"name": "strait", "ring": [[0, 0], [10, 0], [10, 0.5], [0, 0.5]]}}"#;

    #[test]
    fn a_boundary_is_changed_and_the_command_does_the_same() {
        let asked = Asked { angle: 25.0, size: None, within: None };
        let found =
            conditioned(&asked, STRAIT.as_bytes(), &KnownFiles::default(), Progress::NONE).unwrap();
        let domain = mindeg::Domain::from_json(found.domain.get()).unwrap();
        assert!(domain.rings().vertex_count() > 4, "{}", found.words);
        assert!(found.words.starts_with("strait: 4 boundary points become "), "{}", found.words);
        assert!(!found.words.contains(" --"), "{}", found.words);
        let line = "mindeg condition - --limit 25 -o strait-conditioned.json <<'END'\n{";
        assert!(found.command.starts_with(line), "{}", found.command);
        // Edges of a length are divided by it.
        let asked = Asked { size: Some(0.1), within: Some(0.02), ..asked };
        let found =
            conditioned(&asked, STRAIT.as_bytes(), &KnownFiles::default(), Progress::NONE).unwrap();
        let finer = mindeg::Domain::from_json(found.domain.get()).unwrap();
        assert!(
            found.command.contains(" --limit 25 --size 0.1 --within 0.02 -o "),
            "{}",
            found.command
        );
        assert!(finer.rings().vertex_count() > 150, "{}", found.words);
    }

    #[test]
    fn sides_are_divided_as_the_command_line_divides_them() {
        for (domain, count) in [
            (r#"{"ring": [[0, 0], [10, 0], [10, 0.5], [0, 0.5]]}"#, 42),
            (
                r#"{"rectangle": {"width": 10, "height": 0.5}, "sides": [{"points": [[3, 0]]}, {"intervals": 9}, {"size": 3}, {}], "size": 1}"#,
                42,
            ),
        ] {
            let divided =
                divided_json(0.5, format!(r#"{{"domain": {domain}}}"#).as_bytes()).unwrap();
            let divided = mindeg::Domain::from_json(divided.get()).unwrap();
            assert_eq!(divided.rings().vertex_count(), count, "{domain}");
        }
    }

    #[test]
    fn what_cannot_be_is_refused_in_words() {
        let asked = Asked { angle: 60.0, size: None, within: None };
        let refused =
            conditioned(&asked, STRAIT.as_bytes(), &KnownFiles::default(), Progress::NONE)
                .unwrap_err();
        assert!(refused.contains("above 0 and at most 40"), "{refused}");
    }
}
