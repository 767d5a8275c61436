//! The limit of the minimum angle, and changes of interval counts that bring a smaller degree or a larger
//! angle.

use mindeg::changes::{count_changes, own_boundary};
use mindeg::interior::{Cause, Lift};
use mindeg::{Domain, Intervals, Progress};
use mindeg_answers::limit::{Lifting, lift_counts};
use mindeg_answers::numbers::steady_angle;
use mindeg_answers::suggest::in_words;
use mindeg_core::{Change, Suggestion};
use serde_json::value::RawValue;

use crate::api::{ChangeShown, LimitShown};

/// On larger domains no change for the angle is looked for: each that is tried looks at all vertices, and
/// cannot be cancelled.
const LIFTED: u32 = 4000;

/// On larger domains that no formula answers no change for the degree is looked for.
const SEARCHED: u32 = 250;

/// The most changes for the degree.
const MOST: usize = 6;

/// The limit of a domain, and the smallest change that lifts it; `None` for points that are too close together.
pub(crate) fn limit(domain: &Domain) -> Option<Lifting> {
    let wanted = domain.interior().cloned().unwrap_or_default();
    let is_small = domain.rings().vertex_count() <= LIFTED;
    Lifting::of(domain, &wanted, usize::from(is_small)).ok()
}

pub(crate) fn limit_shown(found: &Lifting) -> LimitShown {
    let (vertices, sides) = match &found.limit.cause {
        Cause::Corner { vertex, corner, side_before, .. } => {
            (vec![*vertex], vec![*side_before, *corner])
        }
        Cause::Vertex { vertex, side, .. } => (vec![*vertex], side.iter().copied().collect()),
        Cause::Facing { vertices, sides, .. } => {
            (vertices.to_vec(), sides.iter().copied().flatten().collect())
        }
    };
    LimitShown { limit: found.answer(), words: found.text(), vertices, sides }
}

/// Changes for the degree, the smallest first, then the one for the angle.
pub(crate) fn suggestions(
    domain: &Domain,
    lifted: Option<&Lift>,
    progress: Progress<'_>,
) -> Vec<ChangeShown> {
    let shown = |suggestion: &Suggestion, changed: &Domain, name: &dyn Fn(usize) -> String| {
        let (words, max_degree) = (capital(&in_words(suggestion, name)), suggestion.max_degree);
        Some(ChangeShown {
            words: format!("{words}: degree {max_degree}"),
            max_degree: Some(max_degree),
            min_angle: None,
            domain: json(changed)?,
        })
    };
    let mut found = Vec::new();
    if let Some(boundary) = own_boundary(domain) {
        // Fewer than 4 edges at every vertex: only boundaries of 3 or 4 intervals.
        let changes = mindeg_core::suggestions(boundary);
        let changes = changes.take_while(|change| change.max_degree >= 4).take(MOST);
        let name = |side: usize| format!("side {}", side + 1);
        found.extend(changes.filter_map(|suggestion| {
            shown(&suggestion, &changed(domain, &suggestion.changes)?, &name)
        }));
    } else if domain.rings().vertex_count() <= SEARCHED
        && let Ok(changes) = count_changes(domain, None, 1.0, progress)
    {
        let name = |side: usize| domain.side_in_text(side);
        let changes = changes.found.iter().take(MOST);
        found.extend(changes.filter_map(|change| shown(&change.suggestion, &change.after, &name)));
    }
    found.extend(lifted.and_then(|lift| {
        Some(ChangeShown {
            words: format!(
                "Give {}: with interior points, a minimum angle of up to {}",
                lift_counts(lift),
                steady_angle(lift.min_angle)
            ),
            max_degree: None,
            min_angle: Some(lift.min_angle),
            domain: json(&lift.domain)?,
        })
    }));
    found
}

/// The domain with other counts; `None` if its sides have spacing laws that do not fit them.
fn changed(domain: &Domain, changes: &[Change]) -> Option<Domain> {
    let mut sides = domain.sides().to_vec();
    for change in changes {
        let count = u64::from(domain.rings().intervals(change.side));
        let count = count.checked_add_signed(change.by)?;
        sides[change.side].intervals = Intervals::Count(count);
    }
    domain.with_sides(sides).ok()
}

fn json(domain: &Domain) -> Option<Box<RawValue>> {
    RawValue::from_string(domain.to_json()).ok()
}

fn capital(words: &str) -> String {
    let mut letters = words.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}
