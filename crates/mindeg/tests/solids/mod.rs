//! Solids to mesh, as corners and faces, and what their meshes must be.
#![allow(dead_code, unreachable_pub, reason = "each test takes some of it")]

use mindeg::glam::DVec3;
use mindeg::{Model, ModelEdge, ModelFace, ModelParts, Side};

/// A solid of corners and loops.
#[derive(Clone, Debug, Default)]
pub struct Solid {
    pub corners: Vec<DVec3>,
    pub faces: Vec<Vec<Vec<u32>>>,
    pub edges: Vec<ModelEdge>,
}

impl Solid {
    pub fn model(&self, side: Side) -> Model {
        let face =
            |loops: &Vec<Vec<u32>>| ModelFace { loops: loops.clone(), ..ModelFace::default() };
        Model::new(ModelParts {
            corners: self.corners.clone(),
            faces: self.faces.iter().map(face).collect(),
            edges: self.edges.clone(),
            other_edges: Some(side),
            planar_tolerance: None,
        })
        .unwrap()
    }

    /// A prism over a counter-clockwise outline in the XY plane.
    pub fn prism(outline: &[[f64; 2]], height: f64) -> Self {
        Self::plate(outline, &[], height)
    }

    /// A prism with holes, whose outlines run counter-clockwise, too.
    pub fn plate(outline: &[[f64; 2]], holes: &[Vec<[f64; 2]>], height: f64) -> Self {
        let mut solid = Self::default();
        let (mut bottom, mut top) = (Vec::new(), Vec::new());
        for (index, ring) in [outline].into_iter().chain(holes.iter().map(|h| &h[..])).enumerate() {
            let n = ring.len() as u32;
            let first = solid.corners.len() as u32;
            for z in [0.0, height] {
                solid.corners.extend(ring.iter().map(|&[x, y]| DVec3::new(x, y, z)));
            }
            let low: Vec<u32> = (first..first + n).collect();
            let high: Vec<u32> = (first + n..first + 2 * n).collect();
            for i in 0..n as usize {
                let j = (i + 1) % n as usize;
                let wall = if index == 0 {
                    vec![low[i], low[j], high[j], high[i]]
                } else {
                    vec![low[j], low[i], high[i], high[j]]
                };
                solid.faces.push(vec![wall]);
            }
            bottom.push(low.into_iter().rev().collect());
            top.push(high);
        }
        solid.faces.extend([bottom, top]);
        solid
    }

    pub fn block(x: f64, y: f64, z: f64) -> Self {
        Self::prism(&[[0.0, 0.0], [x, 0.0], [x, y], [0.0, y]], z)
    }

    pub fn l_block() -> Self {
        let outline = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]];
        Self::prism(&outline, 1.0)
    }

    /// A gable house, 5 by 4, walls 3 high and ridge 5 high.
    pub fn house() -> Self {
        let mut solid =
            Self::prism(&[[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [2.0, 5.0], [0.0, 3.0]], 5.0);
        // Upright: y up to z up.
        for corner in &mut solid.corners {
            *corner = DVec3::new(corner.x, -corner.z, corner.y);
        }
        solid
    }

    /// The truncated icosahedron: 12 pentagons, 20 hexagons.
    pub fn truncated_icosahedron() -> Self {
        let phi = (1.0 + 5.0_f64.sqrt()) / 2.0;
        let mut tips = Vec::new();
        for (a, b) in [(1.0, phi), (1.0, -phi), (-1.0, phi), (-1.0, -phi)] {
            tips.extend([DVec3::new(0.0, a, b), DVec3::new(a, b, 0.0), DVec3::new(b, 0.0, a)]);
        }
        let is_edge = |i: usize, j: usize| i != j && (tips[i].distance(tips[j]) - 2.0).abs() < 1e-9;
        let mut solid = Self::default();
        let mut index = std::collections::BTreeMap::new();
        for (i, j) in (0..12).flat_map(|i| (0..12).map(move |j| (i, j))) {
            if is_edge(i, j) {
                index.insert((i, j), solid.corners.len() as u32);
                solid.corners.push(tips[i].lerp(tips[j], 1.0 / 3.0));
            }
        }
        // The neighbours of a tip in order around it.
        for i in 0..12 {
            let mut ring: Vec<usize> = (0..12).filter(|&j| is_edge(i, j)).collect();
            let first = ring[0];
            let u = (tips[first] - tips[i]).reject_from(tips[i]).normalize();
            let v = tips[i].normalize().cross(u);
            let angle = |j: usize| {
                let at = tips[j] - tips[i];
                at.dot(v).atan2(at.dot(u)).rem_euclid(std::f64::consts::TAU - 1e-9)
            };
            ring.sort_by(|&a, &b| angle(a).total_cmp(&angle(b)));
            solid.faces.push(vec![ring.iter().map(|&j| index[&(i, j)]).collect()]);
            for k in 0..ring.len() {
                let (a, b) = (ring[k], ring[(k + 1) % ring.len()]);
                if i < a && i < b {
                    let hexagon = [(i, a), (a, i), (a, b), (b, a), (b, i), (i, b)];
                    solid.faces.push(vec![hexagon.map(|pair| index[&pair]).to_vec()]);
                }
            }
        }
        solid
    }

    /// Gives every edge a count of its own, from its index among all in ascending order.
    pub fn with_counts(mut self, count: impl Fn(usize) -> u64) -> Self {
        let model = self.model(Side::count(1));
        self.edges = (0..model.edge_count())
            .map(|edge| ModelEdge {
                corners: model.edge_corners(edge),
                side: Side::count(count(edge)),
            })
            .collect();
        self
    }

    /// The volume by the corners of the faces, each a fan of signed areas: exact but for rounding.
    pub fn volume(&self) -> f64 {
        let at = |corner: u32| self.corners[corner as usize];
        let of_loop = |corners: &Vec<u32>| {
            let fan = corners[1..].windows(2);
            fan.map(|edge| at(corners[0]).dot(at(edge[0]).cross(at(edge[1])))).sum::<f64>() / 6.0
        };
        let of_face = |loops: &Vec<Vec<u32>>| {
            let outer = of_loop(&loops[0]);
            // A hole takes away from what its face adds, whichever way it runs.
            loops[1..].iter().fold(outer, |sum, hole| sum - of_loop(hole).abs() * sum.signum())
        };
        self.faces.iter().map(of_face).sum()
    }
}
