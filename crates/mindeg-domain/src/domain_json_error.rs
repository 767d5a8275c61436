//! What is wrong with a domain's JSON text, and where it stands.
//!
//! Limits: columns count bytes.

use mindeg_core::BoundaryError;

use crate::constraint::ConstraintPlace;
use crate::domain_error::DomainError;
use crate::json_path::Step;
use crate::spacing::SpacingError;

/// What is wrong with a domain's JSON text, and where.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("line {line}, column {column}{}: {message}", if path.is_empty() { String::new() } else { format!(", {path}") })]
pub struct DomainJsonError {
    /// The keys that lead to the place, such as `sides[2].spacing`; empty for the whole text.
    pub path: String,
    /// The line, from 1.
    pub line: usize,
    /// The column, from 1, in bytes: where the wrong value starts, or how far it was read.
    pub column: usize,
    /// What is wrong and what is allowed.
    pub message: String,
}

pub(crate) fn at(path: String, error: &serde_json::Error) -> DomainJsonError {
    let (line, column) = (error.line().max(1), error.column().max(1));
    let message = error.to_string();
    let position = format!(" at line {} column {}", error.line(), error.column());
    let message = message.strip_suffix(&position).unwrap_or(&message);
    let message = match allowed(&path) {
        // What the parser expects it calls by the names of Rust's types.
        Some(allowed) => {
            format!("{}; allowed: {allowed}", message.split(", expected").next().unwrap_or(message))
        }
        None => message.to_owned(),
    };
    DomainJsonError { path, line, column, message }
}

/// What may stand at a path, where the parser's own words do not say it.
fn allowed(path: &str) -> Option<&'static str> {
    let keys = path.rsplit('.').map(|key| key.split('[').next().unwrap_or(key));
    keys.filter_map(|key| match key {
        "intervals" => Some("a whole number, at least 1"),
        "size" | "width" | "height" => Some("a number above 0"),
        "rotation" => Some("a number, in degrees"),
        "rectangle" => {
            Some("{\"width\": w, \"height\": h, \"origin\": [x, y], \"rotation\": degrees}")
        }
        "polygon" => Some("{\"corners\": [[x, y], …]}"),
        "corners" => Some("a list of [x, y] pairs of numbers"),
        "origin" => Some("a pair [x, y] of numbers"),
        "spacing" => Some(
            "\"uniform\", {\"geometric\": {\"ratio\": r}}, {\"bump\": {\"ratio\": c}}, \
             {\"beta\": {\"beta\": b}}, {\"first_length\": h}, {\"last_length\": h} or \
             {\"parameters\": [t1, t2, …]}",
        ),
        "outside_degree" => Some(
            "a whole number; for a side also a list of one for each vertex from its first corner to \
             its last",
        ),
        "max_degree" => Some("a whole number, at least 2"),
        "vertex" => Some("a whole number, the vertex's number in the mesh"),
        "vertices" => {
            Some("a list of {\"vertex\": v, \"outside_degree\": d, \"max_degree\": D}")
        }
        _ => None,
    })
    .next()
}

/// The place in the JSON text that an error of the domain is about.
pub(crate) fn path_of(error: &DomainError) -> Vec<Step> {
    use Step::{Index, Key};
    let corner = |corner| vec![Key("polygon"), Key("corners"), Index(corner)];
    let side = |side, key| vec![Key("sides"), Index(side), Key(key)];
    let vertex = |entry, key| vec![Key("vertices"), Index(entry), Key(key)];
    match *error {
        DomainError::Rectangle { key, .. } => vec![Key("rectangle"), Key(key)],
        DomainError::TooFewCorners { .. } | DomainError::NotSimple { .. } => {
            vec![Key("polygon"), Key("corners")]
        }
        DomainError::Coordinate { corner: c, .. }
        | DomainError::RepeatedCorner { second: c, .. }
        | DomainError::NotConvex { corner: c, .. }
        | DomainError::UnresolvedCorner { corner: c, .. } => corner(c),
        DomainError::SideCount { .. } => vec![Key("sides")],
        DomainError::Name { side: None, .. } => vec![Key("name")],
        DomainError::Name { side: Some(s), .. } | DomainError::RepeatedName { second: s, .. } => {
            side(s, "name")
        }
        DomainError::Size { side: s, .. } => side(s, "size"),
        DomainError::Boundary(
            BoundaryError::NoIntervals { side: s } | BoundaryError::TooManyVertices { side: s, .. },
        ) => side(s, "intervals"),
        DomainError::Boundary(_) => vec![Key("sides")],
        DomainError::Spacing {
            side: s,
            source:
                SpacingError::ParameterRange { index, .. } | SpacingError::ParameterOrder { index, .. },
        } => [side(s, "spacing"), vec![Key("parameters"), Index(index)]].concat(),
        DomainError::Spacing { side: s, .. } | DomainError::UnresolvedInterval { side: s, .. } => {
            side(s, "spacing")
        }
        DomainError::OutsideDegreeCount { side: s, .. }
        | DomainError::OutsideDegree { place: ConstraintPlace::Side(s), .. } => {
            side(s, "outside_degree")
        }
        DomainError::NoRoom { place: ConstraintPlace::Side(s), .. } => side(s, "max_degree"),
        DomainError::NoSuchVertex { entry, .. } => vertex(entry, "vertex"),
        DomainError::RepeatedVertex { second, .. } => vertex(second, "vertex"),
        DomainError::OutsideDegree { place: ConstraintPlace::Entry(entry), .. } => {
            vertex(entry, "outside_degree")
        }
        DomainError::NoRoom { place: ConstraintPlace::Entry(entry), .. } => {
            vertex(entry, "max_degree")
        }
    }
}
