//! The purposes of meshes, and the options that serve each.

use mindeg::{Goal, Optimized};
use schemars::JsonSchema;
use serde::Serialize;
use std::str::FromStr;

/// The share of Delaunay's minimum angle that a patch keeps, at least.
pub const KEPT: f64 = 0.95;

/// The goal of the fewest edges: the mesh that the trade-off has at the least degree.
pub const FEWEST: Goal = Goal::Optimize(Optimized::Angle);

/// The purpose of a mesh.
///
/// ```
/// use mindeg_answers::advice::Purpose;
///
/// assert_eq!("solver".parse(), Ok(Purpose::Solver));
/// assert_eq!(Purpose::Solver.options(), ["--interior"]);
/// assert!("game".parse::<Purpose>().is_err());
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Purpose {
    /// Points inside, for large angles.
    Solver,
    /// A first mesh that must keep its points: the least degree that keeps [`KEPT`] of the angle.
    Patch,
    /// The fewest edges at a vertex, and the largest angle with them.
    Fewest,
}

impl Purpose {
    /// All of them, the one that most users have first.
    pub const ALL: [Self; 3] = [Self::Solver, Self::Patch, Self::Fewest];

    /// The word for it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Solver => "solver",
            Self::Patch => "patch",
            Self::Fewest => "fewest",
        }
    }

    /// The mesh for it, in a few words.
    #[must_use]
    pub fn help(self) -> &'static str {
        match self {
            Self::Solver => "points inside, for large angles",
            Self::Patch => "the fewest edges at a vertex that keep 95% of the angle",
            Self::Fewest => "the fewest of all",
        }
    }

    /// The options of `mindeg mesh` that make the mesh for it.
    #[must_use]
    pub fn options(self) -> &'static [&'static str] {
        match self {
            Self::Solver => &["--interior"],
            Self::Patch => &["--keep-angle", "95%"],
            Self::Fewest => &["--optimize", "angle"],
        }
    }

    /// The goal of a mesh of boundary points alone; `None` where points are inside.
    #[must_use]
    pub fn goal(self) -> Option<Goal> {
        match self {
            Self::Solver => None,
            Self::Patch => Some(Goal::KeepAngle(KEPT)),
            Self::Fewest => Some(FEWEST),
        }
    }
}

impl FromStr for Purpose {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let found = Self::ALL.into_iter().find(|purpose| purpose.name() == text);
        found.ok_or_else(|| "give solver, patch or fewest".to_owned())
    }
}
