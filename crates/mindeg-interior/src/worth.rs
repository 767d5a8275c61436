//! How good the mesh of a disc is, and which of two is better.

use crate::array_mesh::ArrayMesh;
use crate::goal::Weights;
use crate::triangle::min_angle;

/// A triangle with this share of its local limit is good.
pub(crate) const GOOD: f64 = 0.98;
/// Shares that differ by less are alike.
const ALIKE: f64 = 2e-3;

/// How good a mesh is, or a disc of it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Worth {
    /// By how much degrees are out of their ranges, in all, and how many triangles have no corner inside where they should.
    pub(crate) excess: u32,
    /// The shares of the local limits that are below 1, ascending.
    shares: Vec<f64>,
    /// The minimum angle, up to what is enough.
    angle: f64,
    /// The sum of what shapes cost.
    cost: f64,
}

impl Worth {
    pub(crate) fn of(mesh: &ArrayMesh, weights: &Weights, enough: f64) -> Self {
        let mut worth = Self { excess: 0, shares: Vec::new(), angle: enough, cost: 0.0 };
        for (v, vertex) in (0..).zip(&mesh.vertices) {
            if vertex.triangles > 0 {
                worth.excess += weights.excess(mesh, v);
            }
        }
        for (t, triangle) in (0..).zip(&mesh.triangles) {
            if !triangle.is_alive() {
                continue;
            }
            worth.excess += u32::from(weights.is_outside(mesh, t));
            let angle = min_angle(mesh.corners(t));
            let share = angle / weights.local_limit(mesh, t).min(enough);
            worth.angle = worth.angle.min(angle);
            worth.cost += weights.triangle(mesh, t).0;
            if share < GOOD {
                worth.shares.push(share);
            }
        }
        worth.shares.sort_by(f64::total_cmp);
        worth
    }

    /// True if this is better: by degrees, then by the least shares, then by shapes.
    pub(crate) fn is_better(&self, than: &Self) -> bool {
        if self.excess != than.excess {
            return self.excess < than.excess;
        }
        for i in 0..self.shares.len().max(than.shares.len()) {
            let [a, b] = [self, than].map(|w| w.shares.get(i).copied().unwrap_or(GOOD));
            if (a - b).abs() > ALIKE {
                return a > b;
            }
        }
        self.cost < than.cost - 0.5
    }

    /// True if it may replace the other: fewer violations, or as many and no smaller least share and least angle.
    pub(crate) fn is_allowed(&self, before: &Self) -> bool {
        self.excess < before.excess || self.excess == before.excess && self.keeps_angles(before)
    }

    /// True if there is no violation left and angles are good, or where there were violations as good as before.
    pub(crate) fn is_done(&self, before: &Self) -> bool {
        self.is_good() || self.excess == 0 && before.excess > 0 && self.keeps_angles(before)
    }

    /// True if neither the least share nor the least angle is smaller.
    fn keeps_angles(&self, before: &Self) -> bool {
        self.least() >= before.least().min(GOOD) - 1e-9 && self.angle >= before.angle - 1e-9
    }

    /// The least share of a local limit.
    pub(crate) fn least(&self) -> f64 {
        self.shares.first().copied().unwrap_or(1.0)
    }

    pub(crate) fn is_good(&self) -> bool {
        self.excess == 0 && self.shares.is_empty()
    }
}
