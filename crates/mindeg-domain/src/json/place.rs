//! The place in a JSON text that an error of the domain is about.

use mindeg_core::BoundaryError;

use super::error::DomainJsonError;
use super::value::{Step, Value};
use crate::constraints::{ConstraintError, ConstraintPlace};
use crate::domain_error::DomainError;
use crate::name::NameError;
use crate::outline::OutlineError;
use crate::placement::PlacementError;
use crate::rectangle::RectangleError;
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
    use Step::{Index, Key};
    let side = |side, key| vec![Key("sides"), Index(side), Key(key)];
    match error {
        DomainError::Outline(error) => outline_paths(error),
        DomainError::SideCount { .. } => vec![vec![Key("sides")]],
        DomainError::Name(error) => vec![match *error {
            NameError::Blank { side: None } | NameError::Character { side: None, .. } => {
                vec![Key("name")]
            }
            NameError::Blank { side: Some(number) }
            | NameError::Character { side: Some(number), .. }
            | NameError::Repeated { second: number, .. } => side(number, "name"),
        }],
        DomainError::Side { side: number, source } => match *source {
            SideError::Size { .. } | SideError::SizeTooSmall { .. } => {
                vec![side(*number, "size"), vec![Key("size")]]
            }
            SideError::Spacing(
                SpacingError::ParameterRange { index, .. }
                | SpacingError::ParameterOrder { index, .. },
            ) => vec![[side(*number, "spacing"), vec![Key("parameters"), Index(index)]].concat()],
            SideError::Spacing(_) => vec![side(*number, "spacing")],
        },
        DomainError::Boundary(
            BoundaryError::NoIntervals { side: number }
            | BoundaryError::TooManyVertices { side: number, .. },
        ) => vec![side(*number, "intervals"), side(*number, "size"), vec![Key("size")]],
        DomainError::Boundary(_) => vec![vec![Key("sides")]],
        DomainError::Placement(PlacementError::Interval { side: number, .. }) => {
            vec![side(*number, "spacing"), vec![Key("sides"), Index(*number)]]
        }
        DomainError::Placement(PlacementError::Corner { corner, .. }) => corner_paths(*corner),
        DomainError::Constraint(error) => vec![constraint_path(error)],
    }
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
        OutlineError::TooFewCorners { .. } | OutlineError::NotSimple { .. } => {
            vec![vec![Key("polygon"), Key("corners")]]
        }
        OutlineError::Coordinate { corner, .. }
        | OutlineError::RepeatedCorner { second: corner, .. }
        | OutlineError::CoincidentCorners { second: corner, .. }
        | OutlineError::NotConvex { corner, .. } => corner_paths(corner),
    }
}

fn corner_paths(corner: usize) -> Vec<Vec<Step>> {
    use Step::{Index, Key};
    vec![vec![Key("polygon"), Key("corners"), Index(corner)], vec![Key("rectangle")]]
}

fn constraint_path(error: &ConstraintError) -> Vec<Step> {
    use Step::{Index, Key};
    let at = |place, key| match place {
        ConstraintPlace::Side(side) => vec![Key("sides"), Index(side), Key(key)],
        ConstraintPlace::Entry(entry) => vec![Key("vertices"), Index(entry), Key(key)],
    };
    match *error {
        ConstraintError::SideCount { .. } => vec![Key("sides")],
        ConstraintError::ExternalDegreeCount { side, .. } => {
            at(ConstraintPlace::Side(side), "outside_degree")
        }
        ConstraintError::ExternalDegree { place, .. } => at(place, "outside_degree"),
        ConstraintError::NoSuchVertex { entry, .. }
        | ConstraintError::RepeatedVertex { second: entry, .. } => {
            at(ConstraintPlace::Entry(entry), "vertex")
        }
        ConstraintError::Capacity { place, .. } => at(place, "max_degree"),
    }
}
