//! The figures of a mesh to take, and why there is none.

use mindeg::exact::share_of;
use mindeg::interior::{InteriorError, InteriorReport};
use mindeg::{Domain, Interior, Meshed};
use schemars::JsonSchema;
use serde::Serialize;

/// The most points of a mesh with points inside that is made for an advice, or that the page of `explore` shows.
pub const MOST_POINTS: usize = 300_000;

/// The figures of a mesh to take.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct AdvisedMesh {
    /// The most edges at a vertex.
    pub max_degree: u32,
    /// The minimum angle in degrees.
    pub min_angle: f64,
    /// The minimum angle over Delaunay's, the largest of any mesh without points inside; null where that is not known.
    pub share_of_delaunay: Option<f64>,
}

impl AdvisedMesh {
    /// The figures of a mesh of boundary points.
    #[must_use]
    pub fn of(meshed: &Meshed) -> Self {
        let min_angle = meshed.mesh.angle_range().min;
        Self {
            max_degree: meshed.mesh.max_total_degree(),
            min_angle,
            share_of_delaunay: meshed.delaunay_min_angle.map(|most| share_of(min_angle, most)),
        }
    }

    /// The figures of the mesh of all parts of a domain: the highest degree, and the least angle. None of no part.
    #[must_use]
    pub fn of_all(parts: &[Meshed]) -> Option<Self> {
        if let [meshed] = parts {
            return Some(Self::of(meshed));
        }
        let all: Vec<Self> = parts.iter().map(Self::of).collect();
        let min_angle = all.iter().map(|part| part.min_angle).reduce(f64::min)?;
        let most = parts.iter().map(|part| part.delaunay_min_angle).collect::<Option<Vec<_>>>();
        let most = most.and_then(|most| most.into_iter().reduce(f64::min));
        Some(Self {
            max_degree: all.iter().map(|part| part.max_degree).max()?,
            min_angle,
            share_of_delaunay: most.map(|most| share_of(min_angle, most)),
        })
    }

    /// Whether the figures of two meshes are the same; the boundary alone decides what it shares with Delaunay's.
    pub(crate) fn is_as(&self, other: &Self) -> bool {
        self.max_degree == other.max_degree && self.min_angle == other.min_angle
    }

    /// The figures of a mesh with points inside.
    #[must_use]
    pub fn of_interior(report: &InteriorReport) -> Self {
        let inside = report.interior_degree.as_ref().map_or(0, |range| *range.end());
        Self {
            max_degree: inside.max(*report.boundary_degree.end()),
            min_angle: report.min_angle,
            share_of_delaunay: None,
        }
    }
}

/// Why an advice has no mesh with points inside.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NoPoints {
    /// It is too large to be made for an advice, and is the mesh to take all the same.
    Unmeasured,
    /// There can be none.
    Impossible(String),
}

impl From<&InteriorError> for NoPoints {
    fn from(error: &InteriorError) -> Self {
        match error {
            InteriorError::Cancelled(_) | InteriorError::TooManyPoints { max: MOST_POINTS } => {
                Self::Unmeasured
            }
            error => Self::Impossible(error.to_string()),
        }
    }
}

/// The wishes for points inside a domain, for a mesh that is made for an advice.
#[must_use]
pub fn advised_interior(domain: &Domain) -> Interior {
    let wanted = domain.interior().cloned().unwrap_or_default();
    let most = wanted.max_points.map_or(MOST_POINTS, |most| most.min(MOST_POINTS));
    Interior { max_points: Some(most), ..wanted }
}
