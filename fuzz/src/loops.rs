//! Loops of meshes in space: filled and joined, with triangles that name the mesh's vertices and
//! degrees within the limit.

use arbitrary::Arbitrary;
use glam::DVec3;
use mindeg::bridge::{BridgeOptions, bridge};
use mindeg::fill::{FillOptions, fill};
use mindeg::{Loops, Progress, TriMesh};
use mindeg_mesh::weld;

#[derive(Arbitrary, Debug)]
pub(crate) struct Input {
    /// Two bands of triangles, or any triangles.
    bands: Option<[Vec<(i8, i8)>; 2]>,
    points: Vec<[i8; 3]>,
    triangles: Vec<[u8; 3]>,
    max_degree: Option<u8>,
    ends: [u8; 2],
}

pub(crate) fn run(input: Input) {
    let meshes: Vec<TriMesh> = match &input.bands {
        Some(bands) => bands.iter().filter_map(|band| self::band(band)).collect(),
        None => any(&input).into_iter().collect(),
    };
    let [a, rest @ ..] = &meshes[..] else { return };
    let max_degree = input.max_degree.map(|limit| u32::from(limit % 16));
    let options = FillOptions { max_degree, max_loop: 60, ..FillOptions::default() };
    if let Ok(filled) = fill(a.clone(), &Loops::of(a), &options, Progress::NONE) {
        let before = a.triangles().len();
        assert_eq!(filled.mesh.triangles()[..before], *a.triangles());
        assert_eq!(filled.mesh.positions(), a.positions());
        // Vertices that had more edges before get no new edge; vertices at one position count as one.
        let (old, new) = (welded_degrees(a), welded_degrees(&filled.mesh));
        let limit = filled.filled.iter().map(|done| done.limit).max().unwrap_or(0);
        assert!(old.iter().zip(&new).all(|(old, new)| *new <= limit.max(*old)));
    }
    let pick = |mesh: &TriMesh, index: u8| usize::from(index) % (Loops::of(mesh).list().len() + 1);
    let other = rest.first();
    let loops_of_b = other.map(Loops::of);
    let ends = [pick(a, input.ends[0]), pick(other.unwrap_or(a), input.ends[1])];
    if let Ok(joined) = bridge(
        (a.clone(), &Loops::of(a)),
        other.zip(loops_of_b.as_ref()),
        ends,
        &BridgeOptions { max_degree, ..BridgeOptions::default() },
        Progress::NONE,
    ) {
        let n = joined.mesh.positions().len() as u32;
        assert!(joined.mesh.triangles().iter().flatten().all(|&v| v < n));
        assert!(max_degree.is_none_or(|limit| joined.strip.max_degree <= limit));
    }
}

fn welded_degrees(mesh: &TriMesh) -> Vec<u32> {
    let first = weld(mesh.positions(), 0.0);
    let triangles = mesh.triangles().iter().map(|triangle| triangle.map(|v| first[v as usize]));
    let welded = TriMesh::new(mesh.positions().to_vec(), triangles.collect());
    welded.expect("the vertices are the mesh's").degrees().to_vec()
}

/// A band around an axis, with two loops.
fn band(heights: &[(i8, i8)]) -> Option<TriMesh> {
    let heights = &heights[..heights.len().min(40)];
    let n = heights.len() as u32;
    let step = std::f64::consts::TAU / f64::from(n);
    let ring = |top: f64| {
        heights.iter().enumerate().map(move |(i, &(low, high))| {
            let angle = step * i as f64;
            let z = f64::from(if top > 0.0 { high } else { low }) / 64.0;
            DVec3::new(angle.cos(), angle.sin(), z + 10.0 * top)
        })
    };
    let points = ring(0.0).chain(ring(1.0)).collect();
    let triangles = (0..n).flat_map(|i| {
        let j = (i + 1) % n;
        [[i, j, n + i], [j, n + j, n + i]]
    });
    TriMesh::new(points, triangles.collect()).ok()
}

fn any(input: &Input) -> Option<TriMesh> {
    let count = input.points.len().min(40) as u8;
    if count == 0 {
        return None;
    }
    let points = input.points.iter().take(40).map(|at| DVec3::from(at.map(f64::from)));
    let triangles = input.triangles.iter().take(60).map(|t| t.map(|v| u32::from(v % count)));
    TriMesh::new(points.collect(), triangles.collect()).ok()
}
