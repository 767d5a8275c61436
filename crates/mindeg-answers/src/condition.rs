//! The changes that conditioning made to a boundary.

mod geojson;
mod places;

pub use geojson::{as_geojson, has_regions};
pub use places::ShortestEdge;
pub(crate) use places::{place_in_words, placed};

use crate::numbers::{count, number, steady_angle};
use mindeg::Domain;
use mindeg::glam::DVec2;
use mindeg::interior::{
    BoundaryChange, ChangeKind, Conditioned, Narrow, NarrowReason, Reason, Why,
};
use places::degrees;
use schemars::JsonSchema;
use serde::Serialize;
use std::fmt::Write as _;

/// The changes of a boundary, and the limits of its minimum angle before and after; angles are in degrees.
///
/// # Example
///
/// ```
/// use mindeg::{Domain, Interior};
/// use mindeg::interior::{BoundaryDemands, condition};
/// use mindeg_answers::condition::ConditionAnswer;
///
/// let strait = Domain::from_rings([[[0.0, 0.0], [10.0, 0.0], [10.0, 0.5], [0.0, 0.5]]])?;
/// let (domain, conditioned) = condition(&strait, &Interior::default(), &BoundaryDemands::default(), &[])?;
/// let answer = ConditionAnswer::of(&[strait], &[domain], &[conditioned]);
/// assert!(answer.is_reached && answer.inserted > 4 && answer.dropped == 0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(description = "The changes of a boundary.")]
pub struct ConditionAnswer {
    /// Points of the boundary and of lines inside before.
    pub points_before: u32,
    /// The same after.
    pub points: u32,
    /// Points that were dropped.
    pub dropped: usize,
    /// Points that were put on edges.
    pub inserted: usize,
    /// Points of narrow water that were moved.
    pub shifted: usize,
    /// Sharp corners that were cut off.
    pub cut: usize,
    /// Holes that were dropped.
    pub holes_dropped: usize,
    /// Narrow arms of the domain that were closed.
    pub inlets_closed: usize,
    /// Narrow places between wider ones that were closed.
    pub straits_closed: usize,
    /// Parts that closed straits cut off, which were dropped.
    pub basins_dropped: usize,
    /// Narrow tongues of what is outside that were cut off.
    pub spits_cut: usize,
    /// The largest distance of the old boundary and the new one from each other, at most.
    pub moved: f64,
    /// The shortest edge of the new boundary, which decides the time step of a solver.
    pub shortest_edge: Option<ShortestEdge>,
    /// No mesh of the old boundary has a greater minimum angle.
    pub angle_limit_before: f64,
    /// No mesh of the new boundary has a greater minimum angle.
    pub angle_limit: f64,
    /// Whether no place is known that stays below the demanded angle.
    pub is_reached: bool,
    /// All changes, in the order in which they were made.
    pub changes: Vec<ChangeRow>,
    /// The places that stay below the demanded angle.
    pub left: Vec<LeftRow>,
    /// The places that are narrower than the least width, and stay.
    pub narrow: Vec<NarrowRow>,
}

/// One change.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ChangeRow {
    /// `dropped`, `inserted`, `shifted`, `cut`, `hole_dropped`, `inlet_closed`, `strait_closed`, `basin_dropped` or `spit_cut`.
    pub kind: &'static str,
    /// Where.
    pub at: [f64; 2],
    /// The same in degrees of longitude and latitude, if the domain was projected.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub degrees: Option<[f64; 2]>,
    /// The ring of the old boundary, from 0, the outer one, on; null on a line inside, and where something was narrow.
    pub ring: Option<usize>,
    /// The side of that ring; null where the ring is.
    pub side: Option<String>,
    /// How far the boundary moved there; null where something narrow was closed or cut off, or a hole dropped.
    pub moved: Option<f64>,
    /// Why.
    pub reason: &'static str,
}

/// A place that stays below the demanded angle.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct LeftRow {
    /// Where.
    pub at: [f64; 2],
    /// The same in degrees of longitude and latitude, if the domain was projected.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub degrees: Option<[f64; 2]>,
    /// The limit there; if that is not proven, the angle of the best mesh that a search found.
    pub angle_limit: f64,
    /// Whether no mesh has a greater angle there.
    pub is_proven: bool,
    /// Why, and what to do.
    pub reason: &'static str,
}

/// A narrow place that stays.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct NarrowRow {
    /// Where.
    pub at: [f64; 2],
    /// The same in degrees of longitude and latitude, if the domain was projected.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub degrees: Option<[f64; 2]>,
    /// How narrow: the least distance of its points that face each other.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub width: Option<f64>,
    /// Why.
    pub reason: &'static str,
}

impl ConditionAnswer {
    /// The figures of conditioned domains: those before, those after, and what was done to each.
    #[must_use]
    pub fn of(before: &[Domain], after: &[Domain], conditioned: &[Conditioned]) -> Self {
        let changes = || {
            let of_each = before.iter().zip(conditioned);
            of_each.flat_map(|(domain, one)| one.changes.iter().map(move |it| (domain, it)))
        };
        let left_over = || conditioned.iter().flat_map(|one| &one.left);
        let count = |kind| changes().filter(|change| change.1.kind == kind).count();
        let least = |limit: fn(&Conditioned) -> f64| {
            conditioned.iter().map(limit).fold(f64::INFINITY, f64::min)
        };
        let degrees = |at: DVec2| degrees(before.first()?, at);
        let change = |(domain, change): (&Domain, &BoundaryChange)| {
            let kind = match change.kind {
                ChangeKind::Dropped => "dropped",
                ChangeKind::Inserted => "inserted",
                ChangeKind::Shifted => "shifted",
                ChangeKind::Cut => "cut",
                ChangeKind::HoleDropped => "hole_dropped",
                ChangeKind::InletClosed => "inlet_closed",
                ChangeKind::StraitClosed => "strait_closed",
                ChangeKind::BasinDropped => "basin_dropped",
                ChangeKind::SpitCut => "spit_cut",
            };
            let at = change.at.to_array();
            let rings = domain.rings();
            let side = change.edge.filter(|edge| *edge < rings.vertex_count());
            let side = side.map(|edge| rings.side_of(edge));
            ChangeRow {
                kind,
                at,
                degrees: degrees(change.at),
                ring: side.map(|side| rings.in_ring(side).ring),
                side: side.map(|side| domain.side_name(side)),
                moved: change.moved,
                reason: why_changed(change.why),
            }
        };
        let left = |left: &mindeg::interior::Left| {
            let reason = match left.reason {
                Reason::Sharp => {
                    "the corner is sharper: give a larger --within, or drop a small island by --least-island"
                }
                Reason::Meeting => {
                    "lines meet there so sharply, or so many, and their place stays: move them in the file"
                }
                Reason::Kept => "its points are to stay: --keep fewer",
                Reason::Short => "its edges would get too short: give a larger --within",
                Reason::Narrow => {
                    "an inlet or strait one edge wide: give a larger --within, or close it by --narrowest"
                }
            };
            let at = left.at.to_array();
            let is_proven = left.reason != Reason::Narrow;
            LeftRow { at, degrees: degrees(left.at), angle_limit: left.limit, is_proven, reason }
        };
        let narrow = |narrow: &Narrow| NarrowRow {
            at: narrow.at.to_array(),
            degrees: degrees(narrow.at),
            width: Some(narrow.width).filter(|width| width.is_finite()),
            reason: why_narrow(narrow.reason),
        };
        Self {
            points_before: before.iter().map(points_of).sum(),
            points: after.iter().map(points_of).sum(),
            dropped: count(ChangeKind::Dropped),
            inserted: count(ChangeKind::Inserted),
            shifted: count(ChangeKind::Shifted),
            cut: count(ChangeKind::Cut),
            holes_dropped: count(ChangeKind::HoleDropped),
            inlets_closed: count(ChangeKind::InletClosed),
            straits_closed: count(ChangeKind::StraitClosed),
            basins_dropped: count(ChangeKind::BasinDropped),
            spits_cut: count(ChangeKind::SpitCut),
            moved: conditioned.iter().map(|one| one.moved).fold(0.0, f64::max),
            shortest_edge: ShortestEdge::of(after),
            angle_limit_before: least(|one| one.before),
            angle_limit: least(|one| one.after),
            is_reached: left_over().next().is_none(),
            changes: changes().map(change).collect(),
            left: left_over().map(left).collect(),
            narrow: conditioned.iter().flat_map(|one| &one.narrow).map(narrow).collect(),
        }
    }

    /// The same as text, with at most ten of the places that are left.
    #[must_use]
    pub fn text(&self, name: &str) -> String {
        let plural = |number: usize, one: &str, many: &str| {
            format!("{} {}", count(number as u64), if number == 1 { one } else { many })
        };
        let mut text = format!(
            "{name}: {} boundary points become {}: {} dropped, {} put on edges, {} cut off, {} dropped\n",
            count(self.points_before),
            count(self.points),
            count(self.dropped as u64),
            count(self.inserted as u64),
            plural(self.cut, "sharp corner", "sharp corners"),
            plural(self.holes_dropped, "hole", "holes"),
        );
        let narrow = [
            (self.inlets_closed, "narrow inlet closed", "narrow inlets closed"),
            (self.straits_closed, "strait closed", "straits closed"),
            (self.basins_dropped, "basin behind them dropped", "basins behind them dropped"),
            (self.spits_cut, "spit of land cut off", "spits of land cut off"),
        ];
        if self.shifted > 0 {
            let _ = writeln!(
                text,
                "{} moved",
                plural(self.shifted, "point of narrow water", "points of narrow water")
            );
        }
        let narrow = narrow.into_iter().filter(|row| row.0 > 0);
        let narrow: Vec<String> = narrow.map(|(n, one, many)| plural(n, one, many)).collect();
        if !narrow.is_empty() {
            let _ = writeln!(text, "{}", narrow.join(", "));
        }
        for reason in [NarrowReason::Kept, NarrowReason::Between, NarrowReason::Everywhere] {
            let why = why_narrow(reason);
            let stay = self.narrow.iter().filter(|row| row.reason == why).count();
            if stay > 0 {
                let stay = plural(stay, "narrow place stays", "narrow places stay");
                let _ = writeln!(text, "{stay}: {why}");
            }
        }
        let it = if narrow.is_empty() { "It" } else { "Elsewhere it" };
        let moved = if self.moved > 0.0 {
            // A projected domain is in metres.
            let is_metric = self.changes.iter().any(|row| row.degrees.is_some());
            let unit = if is_metric { " m" } else { "" };
            format!("{it} moved by {}{unit} at most", number(self.moved))
        } else {
            format!("{it} moved nowhere")
        };
        let _ = writeln!(
            text,
            "{moved}. No mesh has a minimum angle above {}, before {}.",
            steady_angle(self.angle_limit),
            steady_angle(self.angle_limit_before)
        );
        text.extend(self.shortest_edge.as_ref().and_then(ShortestEdge::words));
        let (proven, searched): (Vec<&LeftRow>, Vec<&LeftRow>) =
            self.left.iter().partition(|row| row.is_proven);
        if !proven.is_empty() {
            let stay = plural(proven.len(), "place stays", "places stay");
            let _ = writeln!(text, "{stay} below the angle:");
            list(&mut text, &proven);
        }
        if !searched.is_empty() {
            let places = plural(searched.len(), "place", "places");
            let _ = writeln!(
                text,
                "In {places} a search found no mesh of the angle, which does not prove that there is none:"
            );
            list(&mut text, &searched);
        }
        text
    }
}

/// Writes the first places that are left.
fn list(text: &mut String, rows: &[&LeftRow]) {
    for row in rows.iter().take(MOST_LEFT) {
        let place = place_in_words(row.degrees, row.at);
        let _ = writeln!(text, "  at {place}: {}; {}", steady_angle(row.angle_limit), row.reason);
    }
    if rows.len() > MOST_LEFT {
        let _ = writeln!(text, "  and {} more; --json lists all", rows.len() - MOST_LEFT);
    }
}

/// Why a boundary changed at a place.
fn why_changed(why: Why) -> &'static str {
    match why {
        Why::Size => "edges there were too short or too long for the size",
        Why::Limit => "the limit of the angle at a vertex there was too small",
        Why::Strait => "edges that face each other were long beside their distance",
        Why::Near => "its shores were nearer to each other than a quarter of the size",
        Why::Growth => "an edge was long beside others near it",
        Why::Narrow => "an inlet or strait one edge wide",
        Why::Width => "narrower than the least width",
        Why::Area => "smaller than the least area",
    }
}

/// Why a narrow place stays.
fn why_narrow(reason: NarrowReason) -> &'static str {
    match reason {
        NarrowReason::Kept => "something there stays, or the boundary would touch itself",
        NarrowReason::Between => "land between two waters, which would join",
        NarrowReason::Everywhere => "nowhere wider; --least-island drops small islands",
    }
}

/// The points of rings and lines, and those inside.
pub(crate) fn points_of(domain: &Domain) -> u32 {
    domain.rings().vertex_count() + domain.inner_points().len() as u32
}

/// The places that the text names.
const MOST_LEFT: usize = 10;

#[cfg(test)]
mod tests {
    use super::*;
    use mindeg::Interior;
    use mindeg::interior::{BoundaryDemands, condition};

    #[test]
    fn what_is_proven_and_what_a_search_found_are_told_apart() {
        let strait =
            Domain::from_rings([[[0.0, 0.0], [10.0, 0.0], [10.0, 0.5], [0.0, 0.5]]]).unwrap();
        let (domain, mut conditioned) =
            condition(&strait, &Interior::default(), &BoundaryDemands::default(), &[]).unwrap();
        let text = |conditioned: &Conditioned| {
            let answer = ConditionAnswer::of(
                std::slice::from_ref(&strait),
                std::slice::from_ref(&domain),
                std::slice::from_ref(conditioned),
            );
            (answer.is_reached, answer.text("strait"))
        };
        assert!(text(&conditioned).0);
        let left =
            |x: f64, reason| mindeg::interior::Left { at: DVec2::new(x, 0.0), limit: 20.0, reason };
        conditioned.left = vec![left(1.0, Reason::Narrow), left(2.0, Reason::Sharp)];
        let (is_reached, text) = text(&conditioned);
        assert!(!is_reached);
        let sharp = "1 place stays below the angle:\n  at (2, 0): 20.000°; the corner is sharper";
        assert!(text.contains(sharp), "{text}");
        let narrow = "In 1 place a search found no mesh of the angle, which does not prove that there is \
                      none:\n  at (1, 0): 20.000°; an inlet or strait";
        assert!(text.contains(narrow), "{text}");
    }
}
