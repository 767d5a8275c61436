//! The nearest point of a patch.

use std::sync::OnceLock;

use glam::DVec3;
use mindeg_mesh::parallel::map_all;
use mindeg_mesh::{Bounds, BoxTree};

use crate::features::normal;
use crate::links::Links;

/// The point of a surface that is nearest to another point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Foot {
    /// Where it is.
    pub point: DVec3,
    /// The unit normal there, between the normals at the corners of its triangle.
    pub normal: DVec3,
    /// The triangle that it is on.
    pub triangle: u32,
    /// The shares of the triangle's corners; their sum is 1.
    pub weights: [f64; 3],
    /// How far it is from the other point.
    pub distance: f64,
}

/// A tree for each patch, made when it is needed.
#[derive(Clone, Debug, Default)]
pub(crate) struct PatchTrees(OnceLock<Vec<PatchTree>>);

#[derive(Clone, Debug)]
struct PatchTree {
    /// The triangles of the patch, ascending.
    triangles: Vec<u32>,
    tree: BoxTree,
}

impl PatchTrees {
    /// The triangle of a patch with the nearest point, and that point's weights; see
    /// [`Surface::nearest`](crate::Surface::nearest). `patches` has the patch of each triangle.
    pub(crate) fn nearest(
        &self,
        links: &Links,
        patches: &[u32],
        patch: u32,
        point: DVec3,
        (facing, hint): (Option<DVec3>, u32),
    ) -> (u32, [f64; 3]) {
        let trees = self.0.get_or_init(|| trees(links, patches));
        let PatchTree { triangles, tree } = &trees[patch as usize];
        let corners = |t: u32| links.triangles[t as usize].map(|v| links.points[v as usize]);
        let squared = |t: u32| {
            let at = corners(t);
            on(at, weights(point, at)).distance_squared(point)
        };
        let faces = |t: u32, to: DVec3| normal(links, links.triangles[t as usize]).dot(to) > 0.0;
        let counts = |t: u32| facing.is_none_or(|to| faces(t, to));
        let near = patches.get(hint as usize) == Some(&patch) && counts(hint);
        let within = if near { squared(hint) } else { f64::INFINITY };
        let item = |item: u32| match triangles[item as usize] {
            t if counts(t) => squared(t),
            _ => f64::INFINITY,
        };
        let found = tree.nearest(point, within, item).map(|(item, _)| triangles[item as usize]);
        let any = || tree.nearest(point, f64::INFINITY, |item| squared(triangles[item as usize]));
        // A patch has a triangle, and all distances are finite.
        let triangle = found.or_else(|| Some(triangles[any()?.0 as usize])).unwrap_or(triangles[0]);
        (triangle, weights(point, corners(triangle)))
    }
}

fn trees(links: &Links, patches: &[u32]) -> Vec<PatchTree> {
    let count = patches.iter().map(|patch| patch + 1).max().unwrap_or(0);
    let mut members = vec![Vec::new(); count as usize];
    (0_u32..).zip(patches).for_each(|(t, patch)| members[*patch as usize].push(t));
    map_all(members, |triangles| {
        let around = |t: &u32| {
            let [a, b, c] = links.triangles[*t as usize].map(|v| links.points[v as usize]);
            Bounds { min: a.min(b).min(c), max: a.max(b).max(c) }
        };
        PatchTree { tree: BoxTree::new(triangles.iter().map(around).collect()), triangles }
    })
}

fn on([a, b, c]: [DVec3; 3], [u, v, w]: [f64; 3]) -> DVec3 {
    u * a + v * b + w * c
}

/// The shares of a triangle's corners at its point nearest to `point`: none negative, their sum is 1.
fn weights(point: DVec3, [a, b, c]: [DVec3; 3]) -> [f64; 3] {
    let (ab, ac) = (b - a, c - a);
    let normal = ab.cross(ac);
    let area = normal.length_squared();
    // The areas of the triangles that the foot on the plane forms with the edges, as shares.
    let share = |from: DVec3, to: DVec3| (to - from).cross(point - from).dot(normal) / area;
    let [u, v, w] = [share(b, c), share(c, a), share(a, b)];
    if u >= 0.0 && v >= 0.0 && w >= 0.0 {
        let sum = u + v + w;
        return [u / sum, v / sum, w / sum];
    }
    // Outside: on the nearest of the edges.
    let along = |from: DVec3, to: DVec3| {
        let edge = to - from;
        let t = ((point - from).dot(edge) / edge.length_squared()).clamp(0.0, 1.0);
        (t, point.distance_squared(from.lerp(to, t)))
    };
    let (t_ab, d_ab) = along(a, b);
    let (t_bc, d_bc) = along(b, c);
    let (t_ca, d_ca) = along(c, a);
    if d_ab <= d_bc && d_ab <= d_ca {
        [1.0 - t_ab, t_ab, 0.0]
    } else if d_bc <= d_ca {
        [0.0, 1.0 - t_bc, t_bc]
    } else {
        [t_ca, 0.0, 1.0 - t_ca]
    }
}
