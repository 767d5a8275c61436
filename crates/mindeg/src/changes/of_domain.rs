//! Domains with other counts of their sides.

use glam::DVec2;
use mindeg_core::{Boundary, Change};
use mindeg_domain::{Constraints, Domain, ExternalDegree, SideConstraint};
use mindeg_mesh::Progress;

use super::side::{own_points, with_intervals};
use super::{CountChanges, Divided, found};
use crate::degree::degree_decided;
use crate::error::MeshError;

/// The smallest changes of counts that are found for every smaller degree, or for `wanted` alone. `effort` is how long to look,
/// as a multiple of the default work of some seconds.
///
/// Of changes of the same size the first that is found is taken: one that adds before one that removes, of few sides
/// before one of many.
///
/// # Errors
///
/// A domain with degrees of single vertices, which other counts would move; the errors of
/// [`degree`](crate::exact::degree).
///
/// # Example
///
/// ```
/// use mindeg::{Domain, Progress, Ring, Side, changes::count_changes};
///
/// // Degree 4 takes rings of as many vertices: here 8 and 7.
/// let square = |half: f64| [(-half, -half), (half, -half), (half, half), (-half, half)];
/// let ring = |half, counts: [u64; 4]| Ring::new(square(half), counts.map(Side::count).into());
/// let domain = Domain::of_rings(vec![ring(2.0, [2, 2, 2, 2]), ring(1.0, [2, 1, 2, 2])])?;
/// let changes = count_changes(&domain, None, 1.0, Progress::NONE)?;
/// assert_eq!((changes.reached, changes.floor), (5, 4));
/// assert_eq!(changes.found[0].suggestion.max_degree, 4);
/// assert_eq!(changes.found[0].suggestion.cost(), 1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn count_changes(
    domain: &Domain,
    wanted: Option<u32>,
    effort: f64,
    progress: Progress<'_>,
) -> Result<CountChanges<Domain>, MeshError> {
    if constrains_vertices(domain.constraints()) {
        return Err(MeshError::refused(
            "the domain gives outside_degree or max_degree of single vertices, which other counts would move; mindeg \
             degree, mesh and tradeoff keep to them",
        ));
    }
    if domain.periodic().is_some() {
        return Err(MeshError::refused(
            "the domain has periodic sides, whose counts change with those of others; mindeg degree and mesh count on the joined \
             mesh",
        ));
    }
    found(domain, wanted, effort, progress)
}

/// The boundary whose counts formulas change: where its sides are those of the domain, all of them straight, and none
/// keeps points. Elsewhere the formulas count otherwise, and [`count_changes`] is to look.
pub fn own_boundary(domain: &Domain) -> Option<&Boundary> {
    let form = domain.convex().filter(|_| !domain.is_constrained())?;
    let has_own_count = |side| domain.is_straight(side) && !domain.keeps_points(side);
    let is_own = form.first() == 0
        && form.boundary().sides().eq(domain.rings().sides())
        && (0..domain.sides().len()).all(has_own_count);
    is_own.then(|| form.boundary())
}

/// Whether degrees are given vertex by vertex.
fn constrains_vertices(constraints: &Constraints) -> bool {
    let each = |side: &SideConstraint| matches!(side.external_degree, ExternalDegree::Each(_));
    !constraints.vertices.is_empty() || constraints.sides.iter().any(each)
}

impl Divided for Domain {
    const TRY: usize = 1;

    fn counts(&self) -> Vec<u64> {
        self.rings().sides().map(u64::from).collect()
    }

    fn vertex_count(&self) -> u32 {
        self.rings().vertex_count()
    }

    fn length(&self, side: usize) -> f64 {
        self.placement().side_length(side)
    }

    fn keeps_points(&self, side: usize) -> bool {
        own_points(&self.sides()[side]).is_some_and(|own| !own.is_empty())
    }

    fn together(&self) -> Vec<Vec<usize>> {
        (0..self.rings().ring_count()).map(|ring| self.rings().ring_sides(ring).collect()).collect()
    }

    /// Without a hole an ear is left out only of few vertices; with several, the mean of the degrees is above 4. Lines
    /// and points inside may join rings, or make small triangles.
    fn floor(&self) -> u32 {
        match self.rings().ring_count() - 1 {
            _ if self.is_map() => 2,
            0 => {
                let own = self.sides().iter().filter_map(own_points).map(<[_]>::len);
                let stay = self.rings().side_count() + own.sum::<usize>();
                stay.clamp(3, 5) as u32 - 1
            }
            1 => 4,
            _ => 5,
        }
    }

    /// Two rings of as many vertices for degree 4, and enough vertices for the sum of the degrees.
    fn least_size(&self, target: u32) -> u64 {
        if self.is_map() {
            return 0;
        }
        let rings = self.rings();
        let vertices = u64::from(rings.vertex_count());
        match (rings.ring_count() as u64, target) {
            (2, 4) => {
                rings.rings().map(|ring| ring.len() as u64).reduce(u64::abs_diff).unwrap_or(0)
            }
            (ring_count @ 3.., 5..) => {
                (6 * (ring_count - 2)).div_ceil(u64::from(target) - 4).saturating_sub(vertices)
            }
            _ => 0,
        }
    }

    fn is_excluded(&self, target: u32, by: &[Change]) -> bool {
        let rings = self.rings();
        let vertices = |ring: usize| {
            let own = by.iter().filter(|change| rings.ring_sides(ring).contains(&change.side));
            rings.ring(ring).len() as i64 + own.map(|change| change.by).sum::<i64>()
        };
        match (rings.ring_count(), target) {
            _ if self.is_map() => false,
            (2, 4) => vertices(0) != vertices(1),
            (count @ 3.., 5..) => {
                let all: i64 = (0..count).map(vertices).sum();
                (i64::from(target) - 4) * all < 6 * (count as i64 - 2)
            }
            _ => false,
        }
    }

    fn with_counts(&self, counts: &[u64]) -> Option<Self> {
        let mut sides = self.sides().to_vec();
        for (side, (new, old)) in counts.iter().zip(self.rings().sides()).enumerate() {
            if *new != u64::from(old) {
                sides[side] = with_intervals(&sides[side], ends(self, side), *new);
            }
        }
        // Rings that touch or have too few vertices are no domain.
        self.with_sides(sides).ok()
    }

    fn degree(
        &self,
        wanted: Option<u32>,
        effort: f64,
        progress: Progress<'_>,
    ) -> Result<[u32; 2], MeshError> {
        let answer = degree_decided(self, wanted, effort, progress)?;
        Ok([answer.at_least, answer.reached])
    }
}

/// The points where a side begins and ends.
fn ends(domain: &Domain, side: usize) -> [DVec2; 2] {
    let rings = domain.rings();
    let own = rings.ring_sides(rings.in_ring(side).ring);
    let next = if side + 1 == own.end { own.start } else { side + 1 };
    [side, next].map(|corner| domain.placement().corners()[corner])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_sides_that_the_formula_has_too_are_its_own() {
        let boundary_of = |outline: &str| {
            let domain = Domain::from_json(&format!("{{{outline}}}")).unwrap();
            own_boundary(&domain).map(Boundary::side_count)
        };
        let of_corners = |corners: &str| {
            boundary_of(&format!(r#""polygon": {{"corners": {corners}}}, "size": 1"#))
        };
        assert_eq!(of_corners("[[0,0],[4,0],[4,3],[0,3]]"), Some(4));
        // The formula merges the two sides below; no side has the merged count.
        assert_eq!(of_corners("[[0,0],[2,0],[4,0],[4,3],[0,3]]"), None);
        assert_eq!(of_corners("[[2,0],[4,0],[4,3],[0,3],[0,0]]"), None);
        // One side of seven points, and four sides of which one keeps its points.
        assert_eq!(boundary_of(r#""ring": [[0,0],[1,0],[3,0],[4,0],[4,3],[0,3]]"#), None);
        let kept = r#""rectangle": {"width": 4, "height": 3},
            "sides": [{"points": [[1, 0]]}, {"intervals": 1}, {"intervals": 1}, {"intervals": 1}]"#;
        assert_eq!(boundary_of(kept), None);
    }
}
