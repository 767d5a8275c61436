//! The surface that a mesh in space lies on: where its vertices are on it, and samples of it that the mesh stays near to.

use crate::space::Space;
use crate::surface::kept::sizes_beside;
use crate::surface::walk::walk;
use glam::DVec3;
use mindeg_mesh::{Bounds, BoxTree};
use mindeg_surfaces::{Foot, NONE, Surface};
use std::fmt;

/// The part of the reference that a vertex moves on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum On {
    /// Inside a patch.
    Patch(u32),
    /// At `t` along a curve.
    Curve { curve: u32, t: f64 },
    /// At a vertex of the reference.
    Corner(u32),
}

/// Where a vertex is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Site {
    pub(crate) at: DVec3,
    /// The unit normal of the reference; zero where patches meet.
    pub(crate) normal: DVec3,
    /// A triangle of the reference that is near.
    pub(crate) near: u32,
    pub(crate) on: On,
}

impl Site {
    pub(crate) fn of_foot(foot: &Foot, patch: u32) -> Self {
        Self { at: foot.point, normal: foot.normal, near: foot.triangle, on: On::Patch(patch) }
    }
}

/// A refined surface with what guards need.
#[derive(Debug)]
pub(crate) struct Reference {
    pub(crate) surface: Surface,
    /// How far the mesh and the surface may be from each other, in units of length.
    pub(crate) tolerance: f64,
    /// The wanted edge length where nothing asks for less.
    pub(crate) size: f64,
    pub(crate) witnesses: Vec<Witness>,
    tree: BoxTree,
    /// Whether the samples of each curve stay.
    is_kept: Vec<bool>,
    /// The wanted edge length at each vertex of the surface.
    sizes: Vec<f64>,
}

/// A point of a patch that the mesh of that patch stays near to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Witness {
    pub(crate) at: DVec3,
    pub(crate) patch: u32,
}

/// A walk that ends within so many sizes has found the foot.
const NEAR: f64 = 0.3;
/// Witnesses are about so many sizes apart.
const APART: f64 = 0.2;

impl Reference {
    /// `is_kept`: whether the samples of each curve stay.
    pub(crate) fn new(surface: Surface, size: f64, tolerance: f64, is_kept: Vec<bool>) -> Self {
        let witnesses = witnesses(&surface, APART * size);
        let boxes = witnesses.iter().map(|w| Bounds { min: w.at, max: w.at }).collect();
        let sizes = sizes_beside(&surface, &is_kept);
        Self { surface, tolerance, size, witnesses, tree: BoxTree::new(boxes), is_kept, sizes }
    }

    /// True if the samples of a curve stay.
    pub(crate) fn keeps(&self, curve: u32) -> bool {
        self.is_kept[curve as usize]
    }

    /// The wanted edge length at a vertex of the surface.
    pub(crate) fn size_of(&self, vertex: u32) -> f64 {
        self.sizes[vertex as usize]
    }

    /// The wanted edge length at a foot.
    pub(crate) fn size_at(&self, foot: &Foot) -> f64 {
        let corners = self.surface.triangles()[foot.triangle as usize];
        (0..3).map(|i| foot.weights[i] * self.size_of(corners[i])).sum()
    }

    /// Appends the witnesses in a box.
    pub(crate) fn witnesses_in(&self, bounds: Bounds<DVec3>, found: &mut Vec<u32>) {
        self.tree.meet(bounds, found);
    }

    /// The foot of a point on a patch, on triangles that face `normal` if one is near.
    pub(crate) fn foot(&self, patch: u32, point: DVec3, normal: DVec3, near: u32) -> Foot {
        if let Some(foot) = walk(&self.surface, patch, point, normal, near, NEAR * self.size) {
            return foot;
        }
        let facing = (normal != DVec3::ZERO).then_some(normal);
        let foot = self.surface.nearest(patch, point, facing, near);
        if facing.is_some() && foot.distance > self.size {
            return self.surface.nearest(patch, point, None, near);
        }
        foot
    }

    /// The point of a curve at `t`.
    pub(crate) fn on_curve(&self, curve: u32, t: f64, near: u32) -> Site {
        let line = self.surface.curve(curve);
        let t = line.wrapped(t);
        Site { at: line.at(t), normal: DVec3::ZERO, near, on: On::Curve { curve, t } }
    }

    /// Where a site is along a curve: an end of it if it is a corner, that nearer to `t` if it is both.
    pub(crate) fn along(&self, site: &Site, curve: u32, t: Option<f64>) -> Option<f64> {
        let line = self.surface.curve(curve);
        match site.on {
            On::Curve { curve: own, t } => (own == curve).then_some(t),
            On::Patch(_) => None,
            On::Corner(vertex) => {
                let [first, last] = line.ends()?.map(|end| end == vertex);
                let is_near_first = t.is_none_or(|t| t < 0.5 * line.length());
                match (first, last) {
                    (true, true) => Some(if is_near_first { 0.0 } else { line.length() }),
                    (true, false) => Some(0.0),
                    (false, true) => Some(line.length()),
                    (false, false) => None,
                }
            }
        }
    }
}

/// The vertices of a surface, then the centroids of its triangles, one for each patch in a cell of a grid.
fn witnesses(surface: &Surface, cell: f64) -> Vec<Witness> {
    let triangles = || (0_u32..).zip(surface.triangles());
    let at = |v: u32| surface.points()[v as usize];
    let vertices = triangles().flat_map(|(t, corners)| corners.map(|v| (surface.patch(t), at(v))));
    let middle = |corners: &[u32; 3]| corners.map(at).iter().sum::<DVec3>() / 3.0;
    let centroids = triangles().map(|(t, corners)| (surface.patch(t), middle(corners)));
    let low = surface.points().iter().fold(DVec3::INFINITY, |low, p| low.min(*p));
    let index = |x: f64| libm::floor(x / cell) as i64;
    let mut keyed: Vec<(u32, [i64; 3], usize, DVec3)> = vertices
        .chain(centroids)
        .enumerate()
        .map(|(order, (patch, p))| (patch, (p - low).to_array().map(index), order, p))
        .collect();
    keyed.sort_unstable_by_key(|(patch, cell, order, _)| (*patch, *cell, *order));
    keyed.dedup_by_key(|(patch, cell, ..)| (*patch, *cell));
    keyed.into_iter().map(|(patch, _, _, at)| Witness { at, patch }).collect()
}

/// The space of meshes on a reference.
#[derive(Clone, Copy)]
pub(crate) struct OnSurface<'a>(pub(crate) &'a Reference);

impl fmt::Debug for OnSurface<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("OnSurface")
    }
}

impl PartialEq for OnSurface<'_> {
    fn eq(&self, other: &Self) -> bool {
        std::ptr::eq(self.0, other.0)
    }
}

/// The curve that an edge is a part of, or none.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct CurveLabel(pub(crate) u32);

impl Default for CurveLabel {
    fn default() -> Self {
        Self(NONE)
    }
}

impl Space for OnSurface<'_> {
    type Vector = DVec3;
    type Site = Site;
    type Label = CurveLabel;
    type Patch = u32;

    const IS_PLANE: bool = false;

    fn position(site: &Site) -> DVec3 {
        site.at
    }
}
