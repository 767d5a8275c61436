//! A mark for each change and for each place that stays.

use super::super::svg::pixel;
use super::lines::{Chain, Nearest, distance_to};
use glam::DVec2;
use mindeg::Bounds;
use mindeg_answers::condition::ConditionAnswer;
use mindeg_answers::numbers::{number, steady_angle};
use mindeg_formats::svg::Inset;
use std::fmt::Write as _;

/// The radius of marks, and of those of a kind that has many.
const RADIUS: f64 = 4.0;
const SMALL_RADIUS: f64 = 1.7;
const MANY: usize = 100;
/// The most numbers beside marks.
const MOST_NUMBERS: usize = 80;
/// The size of a digit.
const DIGIT: DVec2 = DVec2::new(6.2, 11.0);

/// The kinds of marks with their colors and words, in the order in which they are drawn.
pub(super) const KINDS: [(&str, &str, &str); 11] = [
    ("inserted", "#3b9bd9", "put on an edge"),
    ("dropped", "#e08a00", "dropped"),
    ("shifted", "#c4579b", "moved"),
    ("cut", "#00916a", "corner cut off"),
    ("hole_dropped", "#0059a8", "hole dropped"),
    ("inlet_closed", "#8b5cf6", "inlet closed"),
    ("strait_closed", "#8a5a00", "strait closed"),
    ("basin_dropped", "#64748b", "basin dropped"),
    ("spit_cut", "#6aa300", "spit cut off"),
    ("narrow", "#7f8ca3", "narrow, stays"),
    ("left", "#d1242f", "stays below the angle"),
];

/// A mark, with the change that it stands for.
pub(super) struct Mark {
    pub(super) kind: usize,
    /// Its place in the list, from 1; none for places that stay.
    pub(super) number: Option<usize>,
    pub(super) at: DVec2,
    /// How far it is from there to the new boundary, in its own lengths and in pixels.
    pub(super) way: [f64; 2],
    pub(super) radius: f64,
    /// The words below it where it is magnified.
    pub(super) note: String,
    pub(super) tip: String,
}

/// A mark in a picture.
pub(super) struct Drawn {
    pub(super) at: DVec2,
    pub(super) radius: f64,
    pub(super) color: &'static str,
    pub(super) tip: String,
}

pub(super) struct Number {
    pub(super) at: DVec2,
    pub(super) text: String,
}

/// All marks, in the order in which they are drawn.
pub(super) fn marks(
    answer: &ConditionAnswer,
    inset: &Inset,
    new: &[Chain],
    placed: &[Chain],
) -> Vec<Mark> {
    let nearest = Nearest::new(new);
    let words = |at: [f64; 2], degrees: Option<[f64; 2]>| {
        let [x, y] = degrees.unwrap_or(at);
        format!("({x}, {y})")
    };
    let mark = |kind: &str, at: [f64; 2], tip: String| {
        let kind = KINDS.iter().position(|known| known.0 == kind).unwrap_or(0);
        let at = inset.place(at.into());
        Mark { kind, number: None, at, way: [0.0; 2], radius: RADIUS, note: String::new(), tip }
    };
    let changes = (1..).zip(&answer.changes).map(|(place, row)| {
        let mut own = mark(row.kind, row.at, String::new());
        own.number = Some(place);
        own.tip = format!("{place}: {} {}", KINDS[own.kind].2, words(row.at, row.degrees));
        let way = nearest.of(row.at.into()).filter(|_| row.kind != "inserted");
        if let Some((chain, index, distance)) = way {
            let ends = [placed[chain][index], placed[chain][index + 1]];
            own.way = [distance, distance_to(own.at, ends)];
            let unit = if row.degrees.is_some() { " m" } else { "" };
            own.note = format!("moved {}{unit}", number(distance));
            let _ = write!(own.tip, ", {}{unit} from the new line", number(distance));
        }
        own
    });
    let left = answer.left.iter().map(|row| {
        let angle = steady_angle(row.angle_limit);
        let tip = format!("{angle} at {}: {}", words(row.at, row.degrees), row.reason);
        Mark { note: format!("limit {angle}"), ..mark("left", row.at, tip) }
    });
    let narrow = answer.narrow.iter().map(|row| {
        let tip = format!("{}: {}", words(row.at, row.degrees), row.reason);
        mark("narrow", row.at, tip)
    });
    let mut marks: Vec<Mark> = changes.chain(left).chain(narrow).collect();
    marks.sort_by_key(|mark| mark.kind);
    for same in marks.chunk_by_mut(|a, b| a.kind == b.kind) {
        let radius = if same.len() > MANY { SMALL_RADIUS } else { RADIUS };
        same.iter_mut().for_each(|mark| mark.radius = radius);
    }
    marks
}

/// Marks as they are drawn.
pub(super) fn drawn(
    marks: &[&Mark],
    least_radius: f64,
    place: impl Fn(DVec2) -> DVec2,
) -> Vec<Drawn> {
    let one = |mark: &&Mark| Drawn {
        at: place(mark.at).map(pixel),
        radius: mark.radius.max(least_radius),
        color: KINDS[mark.kind].1,
        tip: mark.tip.clone(),
    };
    marks.iter().map(one).collect()
}

/// The numbers of marks that have room beside them: those first that moved the boundary most, and none over another.
pub(super) fn numbers(
    marks: &[&Mark],
    place: impl Fn(DVec2) -> DVec2,
    room: Bounds,
) -> Vec<Number> {
    let mut order: Vec<&&Mark> = marks.iter().filter(|mark| mark.number.is_some()).collect();
    order.sort_by(|a, b| b.way[0].total_cmp(&a.way[0]));
    let mut taken: Vec<Bounds> = Vec::new();
    let mut numbers = Vec::new();
    for mark in order {
        if numbers.len() == MOST_NUMBERS {
            break;
        }
        let text = mark.number.map_or_else(String::new, |number| number.to_string());
        let radius = mark.radius;
        let size = DIGIT * DVec2::new(text.len() as f64, 1.0);
        let at = place(mark.at);
        let corners = [
            at + DVec2::new(radius + 2.0, -size.y / 2.0),
            at + DVec2::new(-radius - 2.0 - size.x, -size.y / 2.0),
            at + DVec2::new(-size.x / 2.0, radius + 2.0),
            at + DVec2::new(-size.x / 2.0, -radius - 2.0 - size.y),
        ];
        let free = corners.into_iter().map(|min| Bounds { min, max: min + size }).find(|own| {
            let is_in_room = contains(room, own.min) && contains(room, own.max);
            is_in_room
                && taken
                    .iter()
                    .all(|other| own.max.cmplt(other.min).any() || own.min.cmpgt(other.max).any())
        });
        if let Some(own) = free {
            taken.push(own);
            // The line on which letters stand.
            numbers.push(Number { at: DVec2::new(own.min.x, own.max.y - 2.0).map(pixel), text });
        }
    }
    numbers
}

/// Whether a point is in a box.
pub(super) fn contains(bounds: Bounds, at: DVec2) -> bool {
    at.cmpge(bounds.min).all() && at.cmple(bounds.max).all()
}
