//! The optimiser on any valid mesh, and on its own result: a valid mesh again, its boundary the same,
//! and no worse. Meshes that are not valid are refused.

use crate::hostile::{assert_fills, turn};
use arbitrary::Arbitrary;
use glam::DVec2;
use mindeg_interior::{Improved, Keep, Options, Prefer, improve};
use mindeg_mesh::Progress;
use std::collections::{BTreeMap, BTreeSet};

#[derive(Arbitrary, Debug)]
pub(crate) struct Input {
    /// Each point goes into the triangle that it falls into.
    points: Vec<(u8, u8)>,
    /// Triangles that are left out, so that boundaries are not convex.
    removed: Vec<u8>,
    /// Edges to turn over, where that is possible.
    flips: Vec<u8>,
    keep_vertices: Vec<u8>,
    keep_edges: Vec<u8>,
    degrees: Option<(u8, u8)>,
    prefer_angle: bool,
    /// The change to the mesh, which may make it invalid.
    damage: Option<(u8, u8)>,
}

pub(crate) fn run(input: Input) {
    let (points, mut triangles) = mesh(&input);
    if let Some((triangle, vertex)) = input.damage {
        let t = usize::from(triangle) % triangles.len();
        triangles[t][usize::from(vertex) % 3] = u32::from(vertex / 3);
    }
    let edges: Vec<[u32; 2]> = triangles.iter().flat_map(|t| sides(*t)).collect();
    let keep = Keep {
        vertices: input
            .keep_vertices
            .iter()
            .take(5)
            .map(|v| u32::from(*v) % (points.len() as u32))
            .collect(),
        edges: input
            .keep_edges
            .iter()
            .take(5)
            .map(|e| edges[usize::from(*e) % edges.len()])
            .collect(),
    };
    let mut options = Options::default();
    if let Some((low, high)) = input.degrees {
        options.wanted.interior_degree = Some(3 + u32::from(low % 4)..=6 + u32::from(high % 4));
    }
    options.wanted.prefer = input.prefer_angle.then_some(Prefer::Angle);
    let first = match improve(&points, &triangles, &keep, &options, Progress::NONE) {
        Ok(first) => first,
        Err(error) => {
            assert!(input.damage.is_some(), "a valid mesh is refused: {error}");
            return;
        }
    };
    check(&points, &triangles, &keep, &first, &options);
    let names: BTreeMap<u32, u32> =
        (0..).zip(&first.sources).filter_map(|(new, old)| old.map(|old| (old, new))).collect();
    let kept = Keep {
        vertices: keep.vertices.iter().map(|v| names[v]).collect(),
        edges: keep.edges.iter().map(|e| e.map(|v| names[&v])).collect(),
    };
    let second = improve(&first.points, &first.triangles, &kept, &options, Progress::NONE)
        .expect("its own result is a mesh");
    check(&first.points, &first.triangles, &kept, &second, &options);
}

fn sides([a, b, c]: [u32; 3]) -> [[u32; 2]; 3] {
    [[a, b], [b, c], [c, a]]
}

/// A valid mesh: a square cut into ever more triangles, and what is left of it.
fn mesh(input: &Input) -> (Vec<DVec2>, Vec<[u32; 3]>) {
    let mut points: Vec<DVec2> =
        [(0.0, 0.0), (256.0, 0.0), (256.0, 256.0), (0.0, 256.0)].map(DVec2::from).into();
    let mut triangles = vec![[0, 1, 2], [0, 2, 3]];
    for &(x, y) in input.points.iter().take(60) {
        let at = DVec2::new(f64::from(x), f64::from(y) + 0.5);
        let holds = |t: &[u32; 3]| {
            sides(*t).iter().all(|e| turn(points[e[0] as usize], points[e[1] as usize], at) > 0.0)
        };
        let Some(index) = triangles.iter().position(holds) else { continue };
        let new = points.len() as u32;
        points.push(at);
        let [a, b, c] = triangles[index];
        triangles[index] = [a, b, new];
        triangles.extend([[b, c, new], [c, a, new]]);
    }
    for &flip in input.flips.iter().take(60) {
        let first = usize::from(flip) % triangles.len();
        let [a, b, c] = triangles[first];
        let other =
            |t: &[u32; 3]| sides(*t).iter().position(|e| *e == [b, a]).map(|i| t[(i + 2) % 3]);
        let Some((second, d)) =
            triangles.iter().enumerate().find_map(|(i, t)| Some((i, other(t)?)))
        else {
            continue;
        };
        let at = |v: u32| points[v as usize];
        if turn(at(c), at(a), at(d)) > 0.0 && turn(at(d), at(b), at(c)) > 0.0 {
            triangles[first] = [c, a, d];
            triangles[second] = [d, b, c];
        }
    }
    for &gone in input.removed.iter().take(20) {
        if triangles.len() > 1 {
            let index = usize::from(gone) % triangles.len();
            let triangle = triangles.swap_remove(index);
            // In one fan at each vertex, and no vertex lost.
            if !is_manifold(&triangles, points.len()) {
                triangles.push(triangle);
            }
        }
    }
    (points, triangles)
}

/// Whether every vertex has triangles, and they are one fan.
fn is_manifold(triangles: &[[u32; 3]], count: usize) -> bool {
    let halves: BTreeSet<[u32; 2]> = triangles.iter().flat_map(|t| sides(*t)).collect();
    let mut open = vec![0; count];
    let mut used = vec![false; count];
    for &[a, b] in &halves {
        used[a as usize] = true;
        if !halves.contains(&[b, a]) {
            open[a as usize] += 1;
        }
    }
    used.into_iter().all(|used| used) && open.into_iter().all(|open| open <= 1)
}

fn check(
    points: &[DVec2],
    triangles: &[[u32; 3]],
    keep: &Keep,
    found: &Improved,
    options: &Options,
) {
    let halves: BTreeSet<[u32; 2]> = triangles.iter().flat_map(|t| sides(*t)).collect();
    let names: BTreeMap<u32, u32> =
        (0..).zip(&found.sources).filter_map(|(new, old)| old.map(|old| (old, new))).collect();
    let open = halves.iter().filter(|[a, b]| !halves.contains(&[*b, *a]));
    let boundary: Vec<[u32; 2]> = open.map(|edge| edge.map(|v| names[&v])).collect();
    assert_fills(&found.points, &found.triangles, &boundary);
    let stays = |v: u32| assert_eq!(found.points[names[&v] as usize], points[v as usize]);
    halves.iter().filter(|[a, b]| !halves.contains(&[*b, *a])).flatten().for_each(|v| stays(*v));
    keep.vertices.iter().for_each(|v| stays(*v));
    let new_halves: BTreeSet<[u32; 2]> = found.triangles.iter().flat_map(|t| sides(*t)).collect();
    for [a, b] in &keep.edges {
        let [x, y] = [names[a], names[b]];
        assert!(new_halves.contains(&[x, y]) || new_halves.contains(&[y, x]), "edge {a}-{b}");
    }
    let (before, after) = (&found.before, &found.after);
    match options.wanted.prefer() {
        Prefer::Degree => assert!(after.violations.len() <= before.violations.len()),
        Prefer::Angle => assert!(after.min_angle >= before.min_angle.min(35.0) - 1e-9),
    }
}
