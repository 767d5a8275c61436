//! Periodic sides of domains, where the file says which curves are others, moved.

use glam::DVec2;
use mindeg_domain::{Domain, Move, Side, SideMatch};
use mindeg_mesh::PeriodicLine;

use crate::error::OutlineError;

/// The ends of sides whose lengths and directions differ by a smaller share of their length are the same.
const SAME: f64 = 1e-9;

/// The points of a curve, each with the point that is moved there.
#[derive(Clone, Debug, PartialEq)]
pub struct PeriodicCurve(Vec<[DVec2; 2]>);

impl PeriodicCurve {
    pub(super) fn new(line: &PeriodicLine, points: &[DVec2]) -> Self {
        Self(line.vertices.iter().map(|pair| pair.map(|vertex| points[vertex as usize])).collect())
    }

    fn of(&self, at: DVec2) -> Option<DVec2> {
        self.0.iter().find(|[own, _]| *own == at).map(|[_, of]| *of)
    }
}

/// The domain with the sides that are of these curves matched to others of their ring.
///
/// # Errors
///
/// Sides that do not fit those that they match.
pub fn with_periodic_sides(
    domain: Domain,
    curves: &[PeriodicCurve],
) -> Result<Domain, OutlineError> {
    if curves.is_empty() {
        return Ok(domain);
    }
    let (rings, corners) = (domain.rings(), domain.placement().corners());
    let ends = |side: usize| [side, rings.next_side(side)].map(|corner| corners[corner]);
    let mut sides: Vec<Side> = domain.sides().to_vec();
    for (side, changed) in sides.iter_mut().enumerate() {
        let [start, end] = ends(side);
        let ring = rings.ring_sides(rings.in_ring(side).ring);
        let found = curves.iter().find_map(|curve| {
            let wanted = [curve.of(end)?, curve.of(start)?];
            ring.clone().find(|&other| other != side && ends(other) == wanted)
        });
        let Some(other) = found else { continue };
        let name = domain.sides()[other].name.clone();
        let is_own = |name: &String| {
            ring.clone().filter(|&side| domain.sides()[side].name.as_ref() == Some(name)).count()
                == 1
        };
        let of = name.filter(is_own).unwrap_or_else(|| rings.in_ring(other).side());
        let [to, from] = ends(other);
        let is_parallel = (end - start - (to - from)).length() <= SAME * (end - start).length();
        let by = if is_parallel { Move::Translation } else { Move::Rotation };
        changed.matches = Some(SideMatch { of, by });
    }
    Ok(domain.with_sides(sides)?)
}
