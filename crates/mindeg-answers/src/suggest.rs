//! Changes of interval counts that bring the least maximum degree down.

mod beside;

pub use beside::{SuggestBeside, SuggestPart};

use crate::limit::{LiftAnswer, LimitAnswer};
use crate::model::edge_in_text;
use crate::numbers::significant;
use mindeg::changes::{
    CountChange, CountChanges, count_changes, model_count_changes, own_boundary,
};
use mindeg::{Domain, Intervals, MeshError, Model, Progress};
use mindeg_core::{Boundary, Change, Suggestion, least_max_degree, suggest, suggestions};
use serde::Serialize;

/// The suggestions for a boundary, a domain or a model; sides count from 1, through all rings or edges.
#[derive(Clone, Debug, Serialize)]
pub struct SuggestAnswer {
    /// The intervals of each side.
    pub intervals: Vec<u64>,
    /// The least maximum degree with these; null where it is not known.
    pub least_max_degree: Option<u32>,
    /// No mesh has a smaller maximum degree with these.
    pub at_least: u32,
    /// Some mesh has this one.
    pub reached: u32,
    /// The number of suggestions, of which some may be left out.
    pub suggestion_count: usize,
    /// The suggestions.
    pub suggestions: Vec<SuggestedChange>,
    /// The first smaller degree that no change was found for, though one may lead there.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub open: Option<OpenDegree>,
    /// The limit of the minimum angle with interior points; only for a domain.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub limit: Option<LimitAnswer>,
    /// Changes that lift the limit, each on top of the one before.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub angle_suggestions: Vec<LiftAnswer>,
    /// Such as that sides count from the other end than those of the file.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub notes: Vec<String>,
}

/// A change of counts, and the degree after it.
#[derive(Clone, Debug, Serialize)]
pub struct SuggestedChange {
    /// Null where it is not known.
    least_max_degree: Option<u32>,
    reached: u32,
    /// Intervals added or taken away in all.
    cost: u64,
    /// No change of less cost leads to a degree as small.
    cost_at_least: u64,
    changes: Vec<ChangedSide>,
    /// The counts after the changes.
    intervals: Vec<u64>,
    /// The change in a sentence.
    #[serde(skip)]
    words: String,
}

#[derive(Clone, Debug, Serialize)]
struct ChangedSide {
    /// From 1, as in `intervals`.
    side: usize,
    /// Those of a model's edge.
    #[serde(skip_serializing_if = "Option::is_none")]
    corners: Option<[u32; 2]>,
    by: i64,
    /// The points that a side with points of its own gets.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    points: Vec<[f64; 2]>,
}

/// At most this many added points are named in a sentence.
const MOST_NAMED: usize = 3;

/// A degree that no change was found for.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct OpenDegree {
    max_degree: u32,
    /// No change of less cost leads there.
    cost_at_least: u64,
}

impl SuggestAnswer {
    /// The smallest changes of a convex boundary, by the formula, for every smaller degree or for `wanted`.
    ///
    /// # Errors
    ///
    /// No counts have the wanted degree.
    pub fn of_counts(boundary: &Boundary, wanted: Option<u32>) -> Result<Self, MeshError> {
        let all: Vec<Suggestion> = match wanted {
            None => suggestions(boundary).collect(),
            Some(wanted) => vec![suggest(boundary, wanted).ok_or_else(|| {
                MeshError::Refused(format!(
                    "no counts on {} sides have a least maximum degree of {wanted} or less",
                    boundary.side_count()
                ))
            })?],
        };
        let today = least_max_degree(boundary);
        let suggestions = all.iter().map(|one| SuggestedChange::of_counts(one, boundary)).collect();
        let intervals = boundary.sides().map(u64::from).collect();
        Ok(Self::new(intervals, [today; 2], suggestions))
    }

    /// The smallest changes for any domain: by the formula where it counts the domain's own sides, see
    /// [`own_boundary`]; else those that are found, see [`count_changes`].
    ///
    /// # Errors
    ///
    /// The errors of [`count_changes`], and a wanted degree that no change was found for.
    pub fn of(
        domain: &Domain,
        wanted: Option<u32>,
        effort: f64,
        progress: Progress<'_>,
    ) -> Result<Self, MeshError> {
        if let Some(boundary) = own_boundary(domain) {
            let answer = Self::of_counts(boundary, wanted)?;
            return Ok(Self { notes: domain.notes(), ..answer });
        }
        let intervals = domain.rings().sides().map(u64::from).collect();
        let changes = count_changes(domain, wanted, effort, progress)?;
        let row = |change: &CountChange<Domain>| SuggestedChange::of(change, domain);
        let answer = Self::of_changes("domain", intervals, changes, wanted, row)?;
        Ok(Self { notes: domain.notes(), ..answer })
    }

    /// The smallest changes that are found for a model, see [`model_count_changes`]. Its edges are its sides.
    ///
    /// # Errors
    ///
    /// The errors of [`model_count_changes`], and a wanted degree that no change was found for.
    pub fn of_model(
        model: &Model,
        wanted: Option<u32>,
        effort: f64,
        progress: Progress<'_>,
    ) -> Result<Self, MeshError> {
        let intervals =
            (0..model.edge_count()).map(|edge| u64::from(model.intervals(edge))).collect();
        let changes = model_count_changes(model, wanted, effort, progress)?;
        let row = |change: &CountChange<Model>| SuggestedChange::of_model(change, model);
        Self::of_changes("model", intervals, changes, wanted, row)
    }

    /// The changes that were found for a subject that is called as `what` says.
    fn of_changes<T>(
        what: &str,
        intervals: Vec<u64>,
        changes: CountChanges<T>,
        wanted: Option<u32>,
        row: impl Fn(&CountChange<T>) -> SuggestedChange,
    ) -> Result<Self, MeshError> {
        let CountChanges { at_least, reached, found, floor, open } = changes;
        let mut suggestions: Vec<_> = found.iter().map(row).collect();
        if let Some(wanted) = wanted {
            if wanted < floor {
                return Err(MeshError::Refused(format!(
                    "no counts on this {what} have a least maximum degree below {floor}"
                )));
            }
            if let Some((degree, at_least)) = open {
                return Err(MeshError::Refused(format!(
                    "no change of counts was found for degree {degree}{}",
                    none_of_fewer(at_least, "leads there")
                )));
            }
            if suggestions.is_empty() {
                suggestions.push(SuggestedChange::none([at_least, reached], intervals.clone()));
            }
        }
        let mut answer = Self::new(intervals, [at_least, reached], suggestions);
        answer.open =
            open.map(|(max_degree, cost_at_least)| OpenDegree { max_degree, cost_at_least });
        Ok(answer)
    }

    fn new(
        intervals: Vec<u64>,
        [at_least, reached]: [u32; 2],
        suggestions: Vec<SuggestedChange>,
    ) -> Self {
        Self {
            intervals,
            least_max_degree: (at_least == reached).then_some(reached),
            at_least,
            reached,
            suggestion_count: suggestions.len(),
            suggestions,
            open: None,
            limit: None,
            angle_suggestions: Vec::new(),
            notes: Vec::new(),
        }
    }

    /// The degree and the suggestions, in lines.
    #[must_use]
    pub fn text(&self) -> String {
        let mut text = match self.least_max_degree {
            Some(least) => format!("The least maximum degree is {least}.\n"),
            None => format!("The least maximum degree is at most {}.\n", self.reached),
        };
        text.extend(self.notes.iter().map(|note| format!("{note}\n")));
        if self.suggestion_count == 0 && self.open.is_none() {
            text.push_str("No change of counts brings it down.\n");
        }
        text.extend(self.suggestions.iter().map(|one| one.words.as_str()));
        if let Some(OpenDegree { max_degree, cost_at_least }) = self.open {
            text.push_str(&format!(
                "For {max_degree}: no change was found{}.\n",
                none_of_fewer(cost_at_least, "leads there")
            ));
        }
        text
    }
}

impl SuggestedChange {
    /// A suggestion for a convex boundary.
    fn of_counts(suggestion: &Suggestion, boundary: &Boundary) -> Self {
        let intervals = suggestion.intervals(boundary);
        let words = in_words(suggestion, |side| format!("side {}", side + 1));
        let words = giving(words, &[&intervals]);
        let changes = suggestion.changes.iter().map(|change| ChangedSide::new(change, Vec::new()));
        let (changes, cost) = (changes.collect(), suggestion.cost());
        Self::new(suggestion, true, cost, changes, intervals, &words)
    }

    /// A change that was found for a domain.
    fn of(change: &CountChange<Domain>, domain: &Domain) -> Self {
        let CountChange { suggestion, is_least, at_least, after } = change;
        let counts: Vec<u64> = after.rings().sides().map(u64::from).collect();
        let ring = |ring| &counts[after.rings().ring_sides(ring)];
        let rings: Vec<&[u64]> = (0..after.rings().ring_count()).map(ring).collect();
        let changes: Vec<ChangedSide> =
            suggestion.changes.iter().map(|one| ChangedSide::of(one, domain, after)).collect();
        let words = in_words(suggestion, |side| {
            let points = changes.iter().find(|change| change.side == side + 1);
            let places = points.map_or_else(String::new, ChangedSide::places);
            format!("{}{places}", domain.side_in_text(side))
        });
        let words = giving(words, &rings);
        Self::new(suggestion, *is_least, *at_least, changes, counts, &words)
    }

    /// A change that was found for a model.
    fn of_model(change: &CountChange<Model>, model: &Model) -> Self {
        let CountChange { suggestion, is_least, at_least, after } = change;
        let counts = (0..after.edge_count()).map(|edge| u64::from(after.intervals(edge))).collect();
        let side = |one: &Change| {
            let corners = Some(model.edge_corners(one.side));
            ChangedSide { corners, ..ChangedSide::new(one, Vec::new()) }
        };
        let changes = suggestion.changes.iter().map(side).collect();
        let words = in_words(suggestion, |edge| edge_in_text(model, edge));
        Self::new(suggestion, *is_least, *at_least, changes, counts, &words)
    }

    /// No change, where the degree is small enough.
    fn none([at_least, reached]: [u32; 2], intervals: Vec<u64>) -> Self {
        let none = Suggestion { changes: Vec::new(), max_degree: reached };
        Self::new(&none, at_least == reached, 0, Vec::new(), intervals, "")
    }

    fn new(
        suggestion: &Suggestion,
        is_least: bool,
        cost_at_least: u64,
        changes: Vec<ChangedSide>,
        intervals: Vec<u64>,
        words: &str,
    ) -> Self {
        let (reached, cost) = (suggestion.max_degree, suggestion.cost());
        let or_less = if is_least { "" } else { " or less" };
        let words = match cost_at_least {
            _ if cost == 0 => "No change is needed.\n".to_owned(),
            least if least >= cost => format!("For {reached}{or_less}: {words}.\n"),
            least => format!(
                "For {reached}{or_less}: {words}. Whether a smaller change is enough is not known{}.\n",
                none_of_fewer(least, "is")
            ),
        };
        Self {
            least_max_degree: is_least.then_some(reached),
            reached,
            cost,
            cost_at_least,
            intervals,
            changes,
            words,
        }
    }
}

/// A change in words, with the counts of each ring after it.
fn giving(words: String, rings: &[&[u64]]) -> String {
    let counts = |ring: &&[u64]| ring.iter().map(u64::to_string).collect::<Vec<_>>().join(",");
    words + ", giving " + &rings.iter().map(counts).collect::<Vec<_>>().join("; ")
}

impl ChangedSide {
    fn new(&Change { side, by }: &Change, points: Vec<[f64; 2]>) -> Self {
        Self { side: side + 1, corners: None, by, points }
    }

    fn of(change: &Change, before: &Domain, after: &Domain) -> Self {
        let [old, new] = [before, after].map(|domain| &domain.sides()[change.side]);
        let own = if new.intervals == Intervals::Points { new.curve.points() } else { &[] };
        let added = own.iter().filter(|point| !old.curve.points().contains(point));
        Self::new(change, added.map(|&point| point.into()).collect())
    }

    /// Where its points are, such as " at (0.5, 1)".
    fn places(&self) -> String {
        let place = |[x, y]: &[f64; 2]| format!("({}, {})", significant(*x, 9), significant(*y, 9));
        match self.points.len() {
            1..=MOST_NAMED => {
                format!(" at {}", self.points.iter().map(place).collect::<Vec<_>>().join(" and "))
            }
            _ => String::new(),
        }
    }
}

/// The size that a change has at least, as the end of a sentence; nothing where any change may do.
fn none_of_fewer(at_least: u64, verb: &str) -> String {
    if at_least < 2 {
        return String::new();
    }
    format!("; none of fewer than {at_least} intervals {verb}")
}

/// A suggestion in words, such as "add 7 to side 2 and take 1 from side 4".
#[must_use]
pub fn in_words(suggestion: &Suggestion, name: impl Fn(usize) -> String) -> String {
    let change = |&Change { side, by }: &Change| {
        let (count, side) = (by.unsigned_abs(), name(side));
        if by > 0 { format!("add {count} to {side}") } else { format!("take {count} from {side}") }
    };
    suggestion.changes.iter().map(change).collect::<Vec<_>>().join(" and ")
}
