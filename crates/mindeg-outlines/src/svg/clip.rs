//! Clips: regions outside which nothing of an element is shown.

use mindeg_mesh::planar::orientation;

use super::super::outline::DrawnRing;
use super::super::outline::FillRule;
use super::super::overlay::{Layer, overlay};

/// The union of shapes.
#[derive(Clone, Debug)]
pub(super) struct Clip(pub(super) Vec<(Vec<DrawnRing>, FillRule)>);

impl Clip {
    /// The rings that remain of a shape; `None` if nothing is cut.
    pub(super) fn cut(
        &self,
        rings: &[DrawnRing],
        rule: FillRule,
    ) -> Result<Option<Vec<DrawnRing>>, String> {
        if self.shows(rings) {
            return Ok(None);
        }
        let clips = self.0.iter().map(|(rings, rule)| (&rings[..], *rule));
        let layers: Vec<Layer<'_>> = ([(rings, rule)].into_iter().chain(clips))
            .map(|(rings, rule)| Layer { rings: rings.iter().collect(), rule })
            .collect();
        let left = overlay(&layers, |inside| inside[0] && inside[1..].contains(&true))?;
        Ok(Some(left.polygons.into_iter().flat_map(|(rings, _)| rings).collect()))
    }

    /// Whether a shape lies inside one convex ring, which clips most often are.
    fn shows(&self, rings: &[DrawnRing]) -> bool {
        let [(clip, _)] = &self.0[..] else { return false };
        let [clip] = &clip[..] else { return false };
        let corners = clip.flattened();
        let count = corners.len();
        let turn = if clip.doubled_area() < 0.0 { -1.0 } else { 1.0 };
        let edge = |i: usize| [corners[i], corners[(i + 1) % count]];
        let is_left =
            |point| (0..count).all(|i| turn * orientation(edge(i)[0], edge(i)[1], point) >= 0.0);
        corners.iter().copied().all(is_left)
            && rings.iter().flat_map(DrawnRing::flattened).all(is_left)
    }
}
