//! Meshes as they go into a picture, and which of their triangles do.
//!
//! Limits: of a mesh with more triangles than [`Scene::most_drawn`] at most so many go into the
//! picture. Charts and tables always count all.

use super::titles::Named;
use glam::{DVec2, DVec3};
use mindeg::quality::TriangleQuality;
use mindeg_answers::numbers::count;

/// The most triangles of one mesh in a page with several.
pub(crate) const MAX_DRAWN: usize = 20_000;

/// Meshes that share their points, as they are to be drawn.
pub(crate) struct Scene<'a> {
    /// Lines around what is drawn; a closed one ends where it starts.
    pub(crate) outlines: Vec<Vec<DVec2>>,
    /// Whether what is within the outlines is all surface, so that it can be filled at once.
    pub(crate) fills_outlines: bool,
    /// Whether the vertices are those of one boundary, in order.
    pub(crate) is_ring: bool,
    pub(crate) points: &'a [DVec2],
    /// The positions of the points, of a mesh in space.
    pub(crate) positions: Option<&'a [DVec3]>,
    /// The indices of the vertices that belong to the meshes, ascending.
    pub(crate) vertices: Vec<u32>,
    /// The least maximum degree of any mesh of these vertices, if it is known.
    pub(crate) at_least: Option<u32>,
    /// The most triangles of a mesh in the picture.
    pub(crate) most_drawn: usize,
    /// Each mesh with its triangles.
    pub(crate) meshes: Vec<(Named<'a>, &'a [[u32; 3]])>,
    /// The degrees of all points in each mesh; a mesh may have fewer points than all.
    pub(crate) degrees: Vec<Vec<u32>>,
    /// The measures of a triangle.
    pub(crate) quality: &'a dyn Fn([u32; 3]) -> TriangleQuality,
}

/// The note on a mesh with more than `most_drawn` triangles, the most that a page draws.
pub(crate) fn thinned(triangles: usize, most_drawn: usize) -> Option<String> {
    (triangles > most_drawn).then(|| {
        format!(
            "Thinned out: {} of {} triangles are drawn, the largest and others evenly. Figures \
             and charts count all.",
            count(most_drawn as u64),
            count(triangles as u64)
        )
    })
}

/// The elements of the meshes that the pictures show.
pub(super) struct Shown {
    /// The indices of each mesh's triangles, ascending.
    pub(super) triangles: Vec<Vec<usize>>,
    /// All vertices, or those of the triangles of all meshes and those of maximum degree, ascending.
    pub(super) vertices: Vec<u32>,
}

impl Shown {
    pub(super) fn new(scene: &Scene) -> Self {
        let triangles: Vec<Vec<usize>> =
            scene.meshes.iter().map(|(mesh, all)| drawn_triangles(scene, mesh, all)).collect();
        let drawn = || scene.meshes.iter().map(|&(_, all)| all).zip(&triangles);
        let vertices = if drawn().any(|(all, some)| some.len() < all.len()) {
            let drawn = drawn().flat_map(|(all, some)| some.iter().flat_map(|&n| all[n]));
            let max_degree_vertex = scene.degrees.iter().map(|degrees| max_degree_vertex(degrees));
            let mut vertices: Vec<u32> = drawn.chain(max_degree_vertex).collect();
            vertices.sort_unstable();
            vertices.dedup();
            vertices
        } else {
            scene.vertices.clone()
        };
        Self { triangles, vertices }
    }

    /// The index of a shown vertex.
    pub(super) fn place_of(&self, vertex: u32) -> usize {
        self.vertices.partition_point(|&other| other < vertex)
    }
}

/// The indices of the triangles that are drawn, ascending: all, or the largest, which make up
/// most of the picture, the worst, and others evenly by number.
fn drawn_triangles(scene: &Scene, mesh: &Named, triangles: &[[u32; 3]]) -> Vec<usize> {
    let (count, most) = (triangles.len(), scene.most_drawn);
    if count <= most {
        return (0..count).collect();
    }
    let area = |&triangle: &[u32; 3]| match scene.positions {
        Some(positions) => {
            let [a, b, c] = triangle.map(|vertex| positions[vertex as usize]);
            (b - a).cross(c - a).length()
        }
        None => {
            let [a, b, c] = triangle.map(|vertex| scene.points[vertex as usize]);
            (b - a).perp_dot(c - a).abs()
        }
    };
    let areas: Vec<f64> = triangles.iter().map(area).collect();
    let mut drawn: Vec<usize> = (0..count).collect();
    drawn.select_nth_unstable_by(most / 4, |&a, &b| areas[b].total_cmp(&areas[a]).then(a.cmp(&b)));
    drawn.truncate(most / 4);
    drawn.extend(mesh.figures.worst_triangles.iter().map(|worst| worst.triangle as usize));
    let others = most - drawn.len();
    let even = (0..others as u64).map(|i| i * count as u64 / others as u64);
    drawn.extend(even.map(|triangle| usize::try_from(triangle).expect("an index below `count`")));
    drawn.sort_unstable();
    drawn.dedup();
    drawn
}

/// The first vertex of the largest degree.
pub(super) fn max_degree_vertex(degrees: &[u32]) -> u32 {
    let last_of_max = (0..degrees.len()).rev().max_by_key(|&vertex| degrees[vertex]);
    last_of_max.unwrap_or(0) as u32
}
