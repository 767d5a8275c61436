//! The lines and points inside a domain, in its mesh.

use glam::DVec2;

use super::BoundaryMesh;

impl BoundaryMesh {
    /// [`fill_points`](Self::fill_points) on one thread.
    pub(super) fn fill_some(&self, first: u32, out: &mut [DVec2]) {
        let (rings, inside, points) = self.divided(first, out);
        if !rings.is_empty() {
            self.placement().fill_points(first, rings);
        }
        inside.copy_from_slice(points);
    }

    /// Room for vertices from `first` on, divided into those of rings and those inside, and the points of the latter.
    pub(super) fn divided<'o, T>(
        &self,
        first: u32,
        out: &'o mut [T],
    ) -> (&'o mut [T], &'o mut [T], &[DVec2]) {
        let on_rings = self.placement().vertex_count();
        let left = on_rings.saturating_sub(first) as usize;
        let (rings, inside) = out.split_at_mut(left.min(out.len()));
        let from = first.saturating_sub(on_rings) as usize;
        let points = &self.domain.inner_points()[from..from + inside.len()];
        (rings, inside, points)
    }
}
