//! The views and parts that a request can ask for.

use serde::{Deserialize, Serialize};

/// A mesh of the domain.
#[derive(Clone, Copy, Debug, Default, Deserialize, Eq, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum View {
    /// The mesh of the goal.
    #[default]
    Wanted,
    /// The mesh of the least maximum degree.
    Least,
    /// A Delaunay triangulation of the boundary points.
    Delaunay,
    /// With interior points.
    Interior,
}

/// Something to answer: `"wanted"`, `"curve"` and so on.
#[derive(Clone, Copy, Debug, Deserialize, Eq, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Part {
    /// The mesh of the goal.
    Wanted,
    /// The mesh of least degree.
    Least,
    /// A Delaunay triangulation.
    Delaunay,
    /// The mesh with interior points.
    Interior,
    /// The meshes to take by what they are for.
    Advice,
    /// The degree in words, with what proves it.
    Degree,
    /// The limit of the minimum angle with interior points.
    Limit,
    /// The largest minimum angle for every maximum degree.
    Curve,
    /// Changes of interval counts.
    Suggestions,
    /// The command line that makes the mesh of [`Request::view`](crate::Request::view).
    Command,
}

impl Part {
    /// All but the mesh with interior points and the advice, which needs it.
    pub(crate) fn usual() -> Vec<Self> {
        use Part::*;
        vec![Wanted, Least, Delaunay, Degree, Limit, Curve, Suggestions, Command]
    }
}
