//! Points put right after the triangulation was made without regard to where they are.

use crate::array_mesh::{ArrayMesh, Kind};
use crate::smooth::Ring;
use crate::triangle::{cross, is_proper};
use glam::DVec2;

/// Sweeps over the mesh at most.
const SWEEPS: usize = 60;

/// Moves free vertices until no triangle is turned over or flat: into the kernel of their star where it has one, otherwise to the
/// middle of their neighbours. False if that does not end.
pub(crate) fn untangle(mesh: &mut ArrayMesh) -> bool {
    let mut ring = Ring::default();
    let mut kernel = Vec::new();
    for _ in 0..SWEEPS {
        let mut is_done = true;
        for v in 0..mesh.vertices.len() as u32 {
            let vertex = &mesh.vertices[v as usize];
            if vertex.kind != Kind::Free || vertex.triangles == 0 {
                continue;
            }
            ring.load(mesh, v);
            let x = vertex.at;
            if ring.edges.iter().all(|[b, c]| is_proper([x, *b, *c])) {
                continue;
            }
            is_done = false;
            let place = middle_of_kernel(&ring.edges, &mut kernel).unwrap_or_else(|| {
                ring.edges.iter().map(|edge| edge[0]).sum::<DVec2>() / ring.edges.len() as f64
            });
            mesh.move_to(v, place);
        }
        if is_done {
            break;
        }
    }
    mesh.check().is_ok()
}

/// The middle of the points that see all edges of a ring from their left; `None` if there are none.
fn middle_of_kernel(edges: &[[DVec2; 2]], polygon: &mut Vec<DVec2>) -> Option<DVec2> {
    let (mut low, mut high) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
    for [b, _] in edges {
        (low, high) = (low.min(*b), high.max(*b));
    }
    polygon.clear();
    polygon.extend([low, DVec2::new(high.x, low.y), high, DVec2::new(low.x, high.y)]);
    let mut cut = Vec::new();
    for [b, c] in edges {
        let side = |p: DVec2| cross(*c - *b, p - *b);
        cut.clear();
        for i in 0..polygon.len() {
            let (p, q) = (polygon[i], polygon[(i + 1) % polygon.len()]);
            let (s, t) = (side(p), side(q));
            if s >= 0.0 {
                cut.push(p);
            }
            if s * t < 0.0 {
                cut.push(p.lerp(q, s / (s - t)));
            }
        }
        std::mem::swap(polygon, &mut cut);
    }
    if polygon.len() < 3 {
        return None;
    }
    Some(polygon.iter().sum::<DVec2>() / polygon.len() as f64)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::array_mesh::tests::grid;

    #[test]
    fn vertices_come_back_to_where_no_triangle_is_turned_over() {
        let mut mesh = grid(6);
        for v in [16, 17, 23, 24, 30, 32] {
            mesh.vertices[v].at = DVec2::new(-3.0, v as f64);
        }
        assert!(mesh.check().is_err());
        assert!(untangle(&mut mesh));
        mesh.check().unwrap();
    }

    #[test]
    fn triangles_of_vertices_that_stay_are_not_put_right() {
        let mut mesh = grid(3);
        mesh.vertices[5].at = DVec2::new(-3.0, 0.5);
        mesh.vertices[5].kind = Kind::Fixed;
        assert!(!untangle(&mut mesh));
    }

    #[test]
    fn the_kernel_of_a_ring_is_where_all_its_edges_are_seen() {
        let ring = |points: &[[f64; 2]]| -> Vec<[DVec2; 2]> {
            let at = |i: usize| DVec2::from(points[i % points.len()]);
            (0..points.len()).map(|i| [at(i), at(i + 1)]).collect()
        };
        // An arrow: only the part before its notch sees all of it.
        let arrow = ring(&[[0.0, 0.0], [4.0, 2.0], [0.0, 4.0], [2.0, 2.0]]);
        let middle = middle_of_kernel(&arrow, &mut Vec::new()).unwrap();
        assert!(middle.x > 2.0 && arrow.iter().all(|[b, c]| is_proper([middle, *b, *c])));
        // A ring of three notches that no point sees.
        let none = ring(&[
            [0.0, 0.0],
            [5.0, 0.0],
            [5.0, 5.0],
            [0.0, 5.0],
            [0.0, 4.0],
            [4.0, 4.0],
            [4.0, 1.0],
            [0.0, 1.0],
        ]);
        assert!(middle_of_kernel(&none, &mut Vec::new()).is_none());
    }
}
