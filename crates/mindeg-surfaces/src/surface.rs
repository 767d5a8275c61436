//! The surface: its triangles with their patches, features and normals.

use glam::DVec3;
use mindeg_mesh::{DisjointSets, weld};

use crate::NONE;
use crate::curves::{CurveSpan, Curves, FeatureCurve, corner_angle};
use crate::fault::SurfaceError;
use crate::features::{FeatureRules, Given, features, normal};
use crate::links::{Links, join_across};
use crate::nearest::{Foot, PatchTrees};

/// Where a vertex is among the features of a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Spot {
    /// Inside a patch.
    Inside {
        /// The patch.
        patch: u32,
    },
    /// On a curve, between its corners.
    Curve {
        /// The curve.
        curve: u32,
        /// How far along it.
        t: f64,
    },
    /// Where curves end or turn, or at a tip.
    Corner,
}

/// A manifold surface of triangles, with or without boundary, with its features.
///
/// Feature edges are those of the boundary, between groups, and sharp ones; they form curves between corners, and
/// bound the patches. Triangles keep their order; vertices are the points that triangles use, in their order, one for
/// each fan of triangles.
///
/// # Example
///
/// ```
/// use glam::DVec3;
/// use mindeg_surfaces::{FeatureRules, Surface};
///
/// let points = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
/// let triangles = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];
/// let surface = Surface::new(&points, &triangles, &[], &FeatureRules::default())?;
/// assert_eq!((surface.patch_count(), surface.curves().len()), (4, 6));
///
/// let above = DVec3::new(0.2, 0.2, -5.0);
/// let foot = surface.nearest(surface.patch(0), above, None, 0);
/// assert_eq!((foot.point, foot.normal, foot.distance), (DVec3::new(0.2, 0.2, 0.0), -DVec3::Z, 5.0));
/// # Ok::<(), mindeg_surfaces::SurfaceError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Surface {
    pub(crate) links: Links,
    pub(crate) curves: Curves,
    pub(crate) patches: Vec<u32>,
    patch_count: u32,
    /// The group of each patch.
    pub(crate) groups: Vec<u32>,
    /// The triangle of the input that each triangle is a part of.
    pub(crate) origins: Vec<u32>,
    /// The normal of each corner of a triangle, as an index of `normals`.
    normal_of: Vec<[u32; 3]>,
    normals: Vec<DVec3>,
    /// The wanted edge length at each vertex; empty where nobody asked.
    pub(crate) sizes: Vec<f64>,
    spots: Vec<Spot>,
    trees: PatchTrees,
}

impl Surface {
    /// The surface of some triangles with its features. `groups` has the group of each triangle, or is empty.
    ///
    /// Points with equal coordinates are one. O(n log n).
    ///
    /// # Errors
    ///
    /// All places where triangles have no area, where more than two share an edge, where two that share an edge face
    /// opposite ways or cover each other; points that are not finite; an index out of range.
    ///
    /// # Panics
    ///
    /// If `groups` is not empty and its length is not that of `triangles`.
    pub fn new(
        points: &[DVec3],
        triangles: &[[u32; 3]],
        groups: &[u32],
        rules: &FeatureRules,
    ) -> Result<Self, SurfaceError> {
        Self::keeping(points, triangles, &Given { groups, ..Given::default() }, rules)
    }

    /// The same with further edges and points that are features.
    ///
    /// # Errors
    ///
    /// The errors of [`new`](Self::new).
    ///
    /// # Panics
    ///
    /// If there are groups, but not one for each triangle; if a given point does not exist.
    ///
    /// # Example
    ///
    /// ```
    /// use glam::DVec3;
    /// use mindeg_surfaces::{FeatureRules, Given, Spot, Surface};
    ///
    /// // A flat square, whose diagonal is kept, and the middle of one side.
    /// let points = [(0., 0.), (1., 0.), (2., 0.), (2., 2.), (0., 2.)].map(|(x, y)| DVec3::new(x, y, 0.0));
    /// let triangles = [[0, 1, 3], [1, 2, 3], [0, 3, 4]];
    /// let given = Given { edges: &[[3, 0]], corners: &[1], ..Given::default() };
    /// let surface = Surface::keeping(&points, &triangles, &given, &FeatureRules::default())?;
    /// assert_eq!((surface.patch_count(), surface.curves().len()), (2, 6));
    /// assert_eq!(surface.spot(1), Spot::Corner);
    /// # Ok::<(), mindeg_surfaces::SurfaceError>(())
    /// ```
    pub fn keeping(
        points: &[DVec3],
        triangles: &[[u32; 3]],
        given: &Given<'_>,
        rules: &FeatureRules,
    ) -> Result<Self, SurfaceError> {
        let Given { groups, edges, corners } = given;
        assert!(groups.is_empty() || groups.len() == triangles.len(), "a group for each triangle");
        let links = Links::new(points, triangles)?;
        // Vertices know the first of the points with equal coordinates.
        let is_plain = edges.is_empty() && corners.is_empty();
        let first = if is_plain { Vec::new() } else { weld(points, 0.0) };
        let edges: Vec<[u32; 2]> = edges.iter().map(|e| e.map(|v| first[v as usize])).collect();
        let mut corners: Vec<u32> = corners.iter().map(|v| first[*v as usize]).collect();
        corners.sort_unstable();
        let bits = features(&links, &Given { edges: &edges, ..*given }, rules);
        let curves = Curves::new(&links, &bits, &corners, rules);
        let (patches, patch_count) = patches(&links, &curves);
        let mut of_patch = vec![0; patch_count as usize];
        for (patch, group) in patches.iter().zip(groups.iter()) {
            of_patch[*patch as usize] = *group;
        }
        let origins = (0..triangles.len() as u32).collect();
        Ok(Self::assembled(links, curves, (patches, of_patch), origins))
    }

    /// The surface of parts that belong together: their normals and vertices' spots follow.
    pub(crate) fn assembled(
        links: Links,
        curves: Curves,
        (patches, groups): (Vec<u32>, Vec<u32>),
        origins: Vec<u32>,
    ) -> Self {
        let (normal_of, normals) = corner_normals(&links, &curves);
        let spots = spots(&links, &curves, &patches);
        let patch_count = groups.len() as u32;
        let trees = PatchTrees::default();
        let sizes = Vec::new();
        Self {
            links,
            curves,
            patches,
            patch_count,
            groups,
            origins,
            normal_of,
            normals,
            sizes,
            spots,
            trees,
        }
    }

    /// The positions of the vertices.
    pub fn points(&self) -> &[DVec3] {
        &self.links.points
    }

    /// The triangles by their vertices.
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.links.triangles
    }

    /// For each triangle its neighbours: number i lies across the edge opposite corner i; [`NONE`] on the boundary.
    pub fn neighbours(&self) -> &[[u32; 3]] {
        &self.links.neighbours
    }

    /// The point of the input that each vertex is; [`NONE`] for vertices that [`refined`](Self::refined) added.
    pub fn inputs(&self) -> &[u32] {
        &self.links.inputs
    }

    /// The number of vertices that were added because several fans of triangles met at a point of the input.
    pub fn split_vertices(&self) -> usize {
        self.links.split_vertices
    }

    /// The triangle of the input that a triangle is, or is a part of.
    pub fn origin(&self, triangle: u32) -> u32 {
        self.origins[triangle as usize]
    }

    /// The number of patches.
    pub fn patch_count(&self) -> u32 {
        self.patch_count
    }

    /// The patch of a triangle.
    pub fn patch(&self, triangle: u32) -> u32 {
        self.patches[triangle as usize]
    }

    /// The group of a patch; 0 if the surface has no groups.
    pub fn group(&self, patch: u32) -> u32 {
        self.groups[patch as usize]
    }

    /// The curves, those with corners first.
    pub fn curves(&self) -> &[FeatureCurve] {
        &self.curves.curves
    }

    /// One curve.
    pub fn curve(&self, curve: u32) -> &FeatureCurve {
        &self.curves.curves[curve as usize]
    }

    /// All edges that are parts of curves.
    pub fn spans(&self) -> &[CurveSpan] {
        &self.curves.spans
    }

    /// The part of a curve that is the edge of a triangle opposite its corner `i`, if that is a feature.
    pub fn span(&self, triangle: u32, i: usize) -> Option<&CurveSpan> {
        self.curves.spans.get(self.curves.span_of[triangle as usize][i] as usize)
    }

    /// Where a vertex is among the features.
    pub fn spot(&self, vertex: u32) -> Spot {
        self.spots[vertex as usize]
    }

    /// The wanted edge length at a vertex; infinity before [`refined`](Self::refined).
    pub fn size(&self, vertex: u32) -> f64 {
        self.sizes.get(vertex as usize).copied().unwrap_or(f64::INFINITY)
    }

    /// The wanted edge length at a foot, between those at the corners of its triangle.
    pub fn size_at(&self, foot: &Foot) -> f64 {
        let corners = self.links.triangles[foot.triangle as usize];
        (0..3).map(|i| foot.weights[i] * self.size(corners[i])).sum()
    }

    /// The unit normal at a corner of a triangle: that of the triangles around the vertex between two features, by
    /// their angles.
    pub fn corner_normal(&self, triangle: u32, i: usize) -> DVec3 {
        self.normals[self.normal_of[triangle as usize][i] as usize]
    }

    /// The unit normal of a triangle.
    pub fn face_normal(&self, triangle: u32) -> DVec3 {
        normal(&self.links, self.links.triangles[triangle as usize])
    }

    /// The point of a patch that is nearest to `point`; of triangles equally near the one of least index.
    ///
    /// If `facing` is given, only triangles count whose normals are within a right angle of it; if there is none, all
    /// do. `hint` is a triangle that may be near: it changes the time, not the result; any number is allowed. O(log n)
    /// for points near the surface. The trees are made at the first question.
    ///
    /// # Panics
    ///
    /// If there is no such patch.
    pub fn nearest(&self, patch: u32, point: DVec3, facing: Option<DVec3>, hint: u32) -> Foot {
        let (triangle, weights) =
            self.trees.nearest(&self.links, &self.patches, patch, point, (facing, hint));
        let corners = self.links.triangles[triangle as usize];
        let on = |i: usize| weights[i] * self.links.points[corners[i] as usize];
        let foot = on(0) + on(1) + on(2);
        let smooth = |i: usize| weights[i] * self.corner_normal(triangle, i);
        let normal = (smooth(0) + smooth(1) + smooth(2)).try_normalize();
        Foot {
            point: foot,
            normal: normal.unwrap_or_else(|| self.face_normal(triangle)),
            triangle,
            weights,
            distance: foot.distance(point),
        }
    }
}

/// The patch of each triangle, in the order of their first triangles, and their number.
fn patches(links: &Links, curves: &Curves) -> (Vec<u32>, u32) {
    let mut patches = vec![NONE; links.triangles.len()];
    let (mut count, mut stack) = (0, Vec::new());
    for start in 0..links.triangles.len() as u32 {
        if patches[start as usize] != NONE {
            continue;
        }
        patches[start as usize] = count;
        stack.push(start);
        while let Some(t) = stack.pop() {
            for (i, &u) in links.neighbours[t as usize].iter().enumerate() {
                if curves.span_of[t as usize][i] == NONE && patches[u as usize] == NONE {
                    patches[u as usize] = count;
                    stack.push(u);
                }
            }
        }
        count += 1;
    }
    (patches, count)
}

/// A unit normal for the triangles around a vertex between two features, each weighted by its angle.
fn corner_normals(links: &Links, curves: &Curves) -> (Vec<[u32; 3]>, Vec<DVec3>) {
    let mut sectors = DisjointSets::new(3 * links.triangles.len());
    let passes = |t: u32, i: usize| curves.span_of[t as usize][i] == NONE;
    join_across(&links.triangles, &links.neighbours, passes, &mut sectors);
    let mut normal_of = vec![[NONE; 3]; links.triangles.len()];
    let mut normals: Vec<DVec3> = Vec::new();
    for (t, &triangle) in links.triangles.iter().enumerate() {
        let face = normal(links, triangle);
        for i in 0..3 {
            // The least corner of a sector comes first.
            let least = sectors.least((3 * t + i) as u32) as usize;
            if least == 3 * t + i {
                normal_of[t][i] = normals.len() as u32;
                normals.push(DVec3::ZERO);
            }
            let index = normal_of[least / 3][least % 3];
            normal_of[t][i] = index;
            normals[index as usize] += corner_angle(links, triangle, i) * face;
        }
    }
    for (t, indices) in normal_of.iter().enumerate() {
        for &index in indices {
            let normal = &mut normals[index as usize];
            // Normals that cancel: the triangle's own is as good.
            let own = || self::normal(links, links.triangles[t]);
            *normal = normal.try_normalize().unwrap_or_else(own);
        }
    }
    (normal_of, normals)
}

fn spots(links: &Links, curves: &Curves, patches: &[u32]) -> Vec<Spot> {
    let mut spots = vec![Spot::Corner; links.points.len()];
    for (triangle, patch) in links.triangles.iter().zip(patches) {
        triangle.iter().for_each(|&v| spots[v as usize] = Spot::Inside { patch: *patch });
    }
    for span in &curves.spans {
        let [from, to] = span.vertices;
        // Where a closed curve ends, its first edge says that t is 0.
        spots[from as usize] = Spot::Curve { curve: span.curve, t: span.range[0] };
        if !curves.curves[span.curve as usize].is_closed() {
            spots[to as usize] = Spot::Curve { curve: span.curve, t: span.range[1] };
        }
    }
    for (spot, is_corner) in spots.iter_mut().zip(&curves.is_corner) {
        if *is_corner {
            *spot = Spot::Corner;
        }
    }
    spots
}
