//! The curve of degree and angle of a domain: its best mesh for each degree.

use mindeg_domain::Domain;

use crate::boundary_mesh::BoundaryMesh;
use crate::meshed::{FoundBy, Meshed};

/// A mesh with the largest minimum angle under a degree limit.
#[derive(Clone, Debug, PartialEq)]
pub struct ExactMesh {
    /// The limit on the total degree of every vertex.
    pub max_degree: u32,
    /// The minimum angle of the mesh, in degrees, as the solver compares it: to 36 bits.
    pub min_angle: f64,
    /// Whether no mesh within the limit has a larger one.
    pub is_proven: bool,
    /// The mesh.
    pub mesh: BoundaryMesh,
}

/// The best minimum angle for every degree on a domain; [`trade_off`](crate::exact::trade_off()) finds it.
#[derive(Clone, Debug, PartialEq)]
pub struct TradeOff {
    domain: Domain,
    meshes: Vec<ExactMesh>,
    delaunay_min_angle: f64,
    is_least_proven: bool,
}

impl TradeOff {
    /// A trade-off from the least degree on, which is proven or not.
    pub(crate) fn new(
        domain: &Domain,
        meshes: Vec<ExactMesh>,
        delaunay_min_angle: f64,
        is_least_proven: bool,
    ) -> Self {
        Self { domain: domain.clone(), meshes, delaunay_min_angle, is_least_proven }
    }

    /// The domain.
    pub fn domain(&self) -> &Domain {
        &self.domain
    }

    /// A mesh for every maximum degree, from the least possible one to the first with which the
    /// minimum angle is as large as with any. At least one. Where windows reached them, degrees without
    /// a better mesh than the one before are left out.
    pub fn meshes(&self) -> &[ExactMesh] {
        &self.meshes
    }

    /// The minimum angle of a Delaunay triangulation, in degrees: the largest there is. The last
    /// mesh has it unless degree limits of single vertices rule that out.
    pub fn delaunay_min_angle(&self) -> f64 {
        self.delaunay_min_angle
    }

    /// Whether the least degree and the angles are proven to be the best. If not, some are what windows and
    /// searches reach: too many vertices see each other.
    pub fn is_exact(&self) -> bool {
        self.is_least_proven && self.meshes.iter().all(|exact| exact.is_proven)
    }

    /// Whether no mesh has a smaller maximum degree than the first.
    pub fn is_least_proven(&self) -> bool {
        self.is_least_proven
    }

    /// How much of that a mesh has, 0 to 1; 1 where only rounding keeps them apart.
    pub fn share(&self, exact: &ExactMesh) -> f64 {
        share_of(exact.min_angle, self.delaunay_min_angle)
    }

    /// The mesh of the smallest degree that keeps this share of Delaunay's minimum angle, 0 to 1.
    pub fn keeping(&self, share: f64) -> Option<&ExactMesh> {
        self.meshes.iter().find(|exact| keeps(exact.min_angle, share, self.delaunay_min_angle))
    }

    /// The last mesh, of an exact trade-off that starts at the least maximum degree.
    pub(crate) fn last(&self) -> Meshed {
        self.meshed(self.meshes.len() - 1)
    }

    /// The mesh with this index, of an exact trade-off that starts at the least maximum degree.
    pub(crate) fn meshed(&self, index: usize) -> Meshed {
        Meshed {
            mesh: self.meshes[index].mesh.clone(),
            least_max_degree: self.meshes[0].max_degree,
            is_least_proven: true,
            found_by: FoundBy::Search,
            delaunay_min_angle: Some(self.delaunay_min_angle),
        }
    }
}

/// An angle as a share of the largest, `most`; 1 where only rounding keeps them apart.
pub fn share_of(angle: f64, most: f64) -> f64 {
    /// The most that rounding takes from a share.
    const ROUNDING: f64 = 1e-9;
    let share = angle / most;
    if (share - 1.0).abs() < ROUNDING { 1.0 } else { share }
}

/// Whether an angle has this share of the largest, `most`. Angles are compared to 36 bits; the last of them
/// decides nothing.
pub fn keeps(angle: f64, share: f64, most: f64) -> bool {
    angle >= share * most * (1.0 - 1e-10)
}
