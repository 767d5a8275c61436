//! The methods of a comparison.

use crate::Reference;
use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::{Serialize, Serializer};
use std::borrow::Cow;
use std::fmt::{self, Display, Formatter};

/// How a mesh of a comparison was made. Reports write its name, which [`Display`] gives.
///
/// # Example
///
/// ```
/// use mindeg_compare::{Method, Reference};
///
/// assert_eq!(Method::Reference(Reference::EarClipping).to_string(), "Ear clipping");
/// assert_eq!(Method::Exact { max_degree: 5 }.to_string(), "Exact, degree 5");
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Method {
    /// mindeg's own mesh of least maximum degree.
    #[default]
    LeastDegree,
    /// Another way to triangulate the same points.
    Reference(Reference),
    /// The mesh with the largest minimum angle under a degree limit.
    Exact {
        /// The degree limit.
        max_degree: u32,
    },
    /// mindeg's mesh of the least degree that keeps 95% of Delaunay's minimum angle.
    Kept,
    /// mindeg's mesh of the least degree that is found, with the largest angle that is found with it.
    Fewest,
    /// mindeg's mesh with points inside.
    Inside,
}

impl Method {
    /// Delaunay triangulation, with which all others are compared.
    pub const DELAUNAY: Self = Self::Reference(Reference::Delaunay);

    /// The method in a sentence.
    #[must_use]
    pub fn description(self) -> Cow<'static, str> {
        match self {
            Self::LeastDegree => "The mesh of mindeg mesh without options: the least maximum degree that \
                                  is found, and among the meshes with that degree which mindeg tries the \
                                  one with the largest minimum angle."
                .into(),
            Self::Reference(reference) => reference.description().into(),
            Self::Exact { max_degree } => format!(
                "The largest minimum angle that any triangulation with at most {max_degree} \
                 edges at a vertex has, by exhaustive dynamic programming."
            )
            .into(),
            Self::Kept => "The mesh of mindeg mesh --keep-angle 95%: the smallest maximum degree that is \
                           reached with this share of Delaunay's minimum angle."
                .into(),
            Self::Fewest => "The mesh of mindeg mesh --for fewest: the smallest maximum degree that is \
                             reached, and the largest minimum angle that is reached with it."
                .into(),
            Self::Inside => "The mesh of mindeg mesh --interior: points are packed from the boundary \
                             inwards, then an optimiser moves them and turns edges for degrees and angles."
                .into(),
        }
    }
}

impl Display for Method {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::LeastDegree => formatter.write_str("mindeg"),
            Self::Reference(reference) => formatter.write_str(reference.name()),
            Self::Exact { max_degree } => write!(formatter, "Exact, degree {max_degree}"),
            Self::Kept => formatter.write_str("mindeg, 95% of the angle"),
            Self::Fewest => formatter.write_str("mindeg, fewest edges"),
            Self::Inside => formatter.write_str("mindeg, points inside"),
        }
    }
}

impl Serialize for Method {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl JsonSchema for Method {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        "Method".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        String::json_schema(generator)
    }
}
