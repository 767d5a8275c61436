//! The place in a JSON text that an error of the domain is about.

use super::error::DomainJsonError;
use super::value::{Step, Value};
use crate::constraint_error::{ConstraintError, ConstraintPlace};
use crate::curve::CurveError;
use crate::domain_error::DomainError;
use crate::intersection::{IntersectionError, PointPlace};
use crate::name::NameError;
use crate::outline::OutlineError;
use crate::placement_error::PlacementError;
use crate::rectangle::RectangleError;
use crate::rings::{InRing, RingsError};
use crate::side::SideError;
use crate::spacing::SpacingError;

/// An error of the domain that a text describes, with its place in the text.
pub(super) fn located(text: &Value<'_>, error: &DomainError) -> DomainJsonError {
    let mut paths = paths(error);
    loop {
        if let Some(value) = paths.iter().find_map(|path| text.at(path)) {
            return value.error(error.to_string());
        }
        // What is wrong is a value that was left out: its object is the place.
        paths[0].pop();
    }
}

/// The paths of the values that an error may be about, the likeliest first. At least one.
fn paths(error: &DomainError) -> Vec<Vec<Step>> {
    use Step::Key;
    match error {
        DomainError::Outline(error) => outline_paths(error),
        DomainError::SideCount { ring, .. } => vec![in_ring(*ring, vec![Key("sides")])],
        DomainError::Name(error) => vec![match *error {
            NameError::Blank { side: None } | NameError::Character { side: None, .. } => {
                vec![Key("name")]
            }
            NameError::Blank { side: Some(side) }
            | NameError::Character { side: Some(side), .. }
            | NameError::Repeated { second: side, .. } => side_path(side, "name"),
        }],
        DomainError::Side { side, source } => match *source {
            SideError::Size { .. } | SideError::SizeTooSmall { .. } => size_paths(*side),
            SideError::Spacing(
                SpacingError::ParameterRange { index, .. }
                | SpacingError::ParameterOrder { index, .. },
            ) => {
                let parameter = vec![Key("parameters"), Step::Index(index)];
                vec![[side_path(*side, "spacing"), parameter].concat()]
            }
            SideError::OutOfOrder { index, .. } => own_point_paths(*side, index),
            SideError::SpacedPoints | SideError::Spacing(_) => vec![side_path(*side, "spacing")],
            SideError::Curve(CurveError::Coordinate { index, .. }) => {
                [own_point_paths(*side, index)[..2].to_vec(), curve_paths(*side)].concat()
            }
            SideError::NoPoints | SideError::Curve(_) => curve_paths(*side),
        },
        DomainError::Rings(
            RingsError::NoIntervals { side } | RingsError::TooManyVertices { side, .. },
        ) => [vec![side_path(*side, "intervals")], size_paths(*side)].concat(),
        DomainError::Rings(RingsError::TooFewVertices { ring, .. }) => {
            vec![in_ring(*ring, vec![Key("sides")])]
        }
        DomainError::Rings(_)
        | DomainError::TooManyVertices { .. }
        | DomainError::TooManyStored { .. }
        | DomainError::NoMemory { .. } => {
            vec![vec![]]
        }
        DomainError::Intersection(error) => intersection_paths(error),
        DomainError::Placement(PlacementError::Interval { side, .. }) => {
            vec![side_path(*side, "spacing"), sides_path(*side)]
        }
        DomainError::Placement(PlacementError::Corner { corner, .. }) => corner_paths(*corner),
        DomainError::Constraint(error) => vec![constraint_path(error)],
    }
}

/// A path within the object that has a ring's sides.
fn in_ring(ring: usize, path: Vec<Step>) -> Vec<Step> {
    match ring.checked_sub(1) {
        None => path,
        Some(hole) => [vec![Step::Key("holes"), Step::Index(hole)], path].concat(),
    }
}

fn sides_path(side: InRing) -> Vec<Step> {
    in_ring(side.ring, vec![Step::Key("sides"), Step::Index(side.index)])
}

fn side_path(side: InRing, key: &'static str) -> Vec<Step> {
    [sides_path(side), vec![Step::Key(key)]].concat()
}

/// A side's own size, or the one for all.
fn size_paths(side: InRing) -> Vec<Vec<Step>> {
    let size = || vec![Step::Key("size")];
    vec![side_path(side, "size"), in_ring(side.ring, size()), size()]
}

/// A point that a side gives itself: among its own, or in a ring of points.
fn own_point_paths(side: InRing, index: usize) -> Vec<Vec<Step>> {
    let own = [side_path(side, "points"), vec![Step::Index(index)]].concat();
    vec![own, in_ring(side.ring, vec![Step::Key("ring"), Step::Index(index + 1)]), sides_path(side)]
}

fn curve_paths(side: InRing) -> Vec<Vec<Step>> {
    let of_side = ["points", "polyline", "arc", "bezier"].map(|key| side_path(side, key));
    let ring = in_ring(side.ring, vec![Step::Key("ring")]);
    of_side.into_iter().chain([ring, sides_path(side)]).collect()
}

fn outline_paths(error: &OutlineError) -> Vec<Vec<Step>> {
    use Step::Key;
    match *error {
        OutlineError::Rectangle(
            RectangleError::Measure { key, .. }
            | RectangleError::Short { key, .. }
            | RectangleError::Thin { key, .. },
        ) => vec![vec![Key("rectangle"), Key(key)]],
        OutlineError::Rectangle(RectangleError::Coordinate { .. }) => vec![vec![Key("rectangle")]],
        OutlineError::TooFewCorners { ring: 0, .. } => vec![vec![Key("polygon"), Key("corners")]],
        OutlineError::TooFewCorners { ring, .. } => vec![in_ring(ring, vec![Key("corners")])],
        OutlineError::Coordinate { corner, .. }
        | OutlineError::RepeatedCorner { second: corner, .. }
        | OutlineError::CoincidentCorners { second: corner, .. } => corner_paths(corner),
    }
}

fn corner_paths(corner: InRing) -> Vec<Vec<Step>> {
    use Step::{Index, Key};
    let path = vec![Key("corners"), Index(corner.index)];
    match corner.ring {
        0 => {
            let ring = vec![Key("ring"), Index(corner.index)];
            vec![[vec![Key("polygon")], path].concat(), ring, vec![Key("rectangle")]]
        }
        ring => {
            vec![in_ring(ring, path), in_ring(ring, vec![Key("ring"), Index(corner.index)])]
        }
    }
}

fn intersection_paths(error: &IntersectionError) -> Vec<Vec<Step>> {
    let point = |point: &PointPlace| match point.index {
        0 => corner_paths(point.side),
        index => own_point_paths(point.side, index as usize - 1),
    };
    let hole = |hole: usize| vec![in_ring(hole, Vec::new())];
    let mut paths = match error {
        IntersectionError::RepeatedPoint { second: at, .. }
        | IntersectionError::Touch { point: at, .. }
        | IntersectionError::FoldsBack { point: at } => point(at),
        IntersectionError::Crossing { second, .. } => match second.index {
            0 => vec![sides_path(second.side)],
            index => own_point_paths(second.side, index as usize - 1),
        },
        IntersectionError::HoleOutside { hole: at, .. }
        | IntersectionError::HoleInHole { hole: at, .. }
        | IntersectionError::HoleAround { hole: at } => hole(*at),
        IntersectionError::Other(_) => Vec::new(),
    };
    // What no value of its own describes, one value for all sides does.
    paths.push(vec![Step::Key("polygon")]);
    paths
}

fn constraint_path(error: &ConstraintError) -> Vec<Step> {
    use Step::{Index, Key};
    let at = |place, key| match place {
        ConstraintPlace::Side(side) => side_path(side, key),
        ConstraintPlace::Entry(entry) => vec![Key("vertices"), Index(entry), Key(key)],
    };
    match *error {
        ConstraintError::SideCount { .. } => vec![Key("sides")],
        ConstraintError::ExternalDegreeCount { side, .. } => side_path(side, "outside_degree"),
        ConstraintError::ExternalDegree { place, .. } => at(place, "outside_degree"),
        ConstraintError::NoSuchVertex { entry, .. }
        | ConstraintError::RepeatedVertex { second: entry, .. } => {
            at(ConstraintPlace::Entry(entry), "vertex")
        }
        ConstraintError::Capacity { place, .. } => at(place, "max_degree"),
    }
}
