//! New starts of a disc: its inside packed anew, with each fan at the vertex in the middle and several spacings.

use crate::array_mesh::{ArrayMesh, NONE, Vertex};
use crate::breaklines::Breaklines;
use crate::goal::{Goal, Weights};
use crate::options::Options;
use crate::size::SizeField;
use crate::stage::Stage;
use crate::star::Stars;
use crate::start::Start;
use mindeg_domain::SizeAt;
use mindeg_mesh::Cancelled;
use mindeg_mesh::planar::PlanarBoundary;

/// The data that all starts of a disc begin with.
pub(crate) struct Restart<'a> {
    disc: &'a ArrayMesh,
    options: &'a Options,
    weights: &'a Weights,
    outline: PlanarBoundary,
    stars: Stars,
    goals: Vec<Goal>,
    breaklines: Breaklines,
    sizes: Vec<SizeAt>,
    /// The index in the disc of the outline's vertices, then of fixed ones.
    names: Vec<u32>,
}

/// The starts of a disc one by one.
pub(crate) struct Starts<'a> {
    of: Restart<'a>,
    next: usize,
}

/// Spacing, sizes over those of the rim, and growth over the wanted growth.
const PHASES: [[f64; 3]; 6] = [
    [0.75, 1.0, 1.0],
    [0.7, 0.9, 0.8],
    [0.8, 1.1, 1.0],
    [0.75, 1.0, 1.2],
    [0.7, 0.8, 0.6],
    [0.85, 1.25, 1.0],
];
/// More points make no sense in a disc.
const MOST_POINTS: usize = 1200;

impl<'a> Restart<'a> {
    pub(crate) fn new(disc: &'a ArrayMesh, options: &'a Options, weights: &'a Weights) -> Self {
        let (outline, breaklines, names) = disc.frozen();
        let goal = |v: &u32| disc.goals.get(disc.vertices[*v as usize].goal as usize).copied();
        let goals =
            names.iter().map(|v| goal(v).unwrap_or_else(|| weights.goal_inside())).collect();
        let stars = Stars::new(&outline, &breaklines);
        let sizes = options.wanted.sizes_at().collect();
        Self { disc, options, weights, outline, stars, goals, breaklines, sizes, names }
    }

    pub(crate) fn starts(self) -> Starts<'a> {
        Starts { of: self, next: 0 }
    }

    fn mesh(
        &self,
        phase: [f64; 3],
        spokes: Option<(u32, u32)>,
        stage: &mut Stage<'_>,
    ) -> Option<ArrayMesh> {
        let wanted = &self.options.wanted;
        let mut field =
            SizeField::new(&self.outline, &[], phase[2] * wanted.growth(), &self.sizes, &[]);
        field.scale_mean(phase[1]);
        let start = Start {
            outline: &self.outline,
            stars: &self.stars,
            goals: &self.goals,
            breaklines: &self.breaklines,
            field: &field,
            about: f64::INFINITY,
        };
        let packing = start.packing(phase[0], self.weights.floor, MOST_POINTS, spokes, stage);
        let packed = start.linked(packing.ok()?).ok()?;
        let mut vertices: Vec<Vertex> = self.disc.vertices.clone();
        vertices.iter_mut().for_each(|v| (v.anchor, v.triangles) = (NONE, 0));
        let mut names = self.names.clone();
        for vertex in &packed.vertices[names.len()..] {
            names.push(vertices.len() as u32);
            vertices.push(Vertex { anchor: NONE, triangles: 0, ..*vertex });
        }
        let name = |v: u32| names[v as usize];
        let triangles: Vec<[u32; 3]> =
            packed.triangles.iter().map(|t| t.vertices.map(name)).collect();
        let locked: Vec<[u32; 2]> = self.breaklines.edges.iter().map(|e| e.map(name)).collect();
        ArrayMesh::new(vertices, &triangles, self.disc.goals.clone(), &locked).ok()
    }
}

impl Starts<'_> {
    /// The next start that gives a mesh, if there is one.
    pub(crate) fn next(&mut self, stage: &mut Stage<'_>) -> Result<Option<ArrayMesh>, Cancelled> {
        // The fans at the vertex in the middle, if it stays and all its triangles are here.
        let center = (0..).zip(&self.of.names).find(|(_, v)| **v == 0).map(|(i, _)| i);
        let center = center.filter(|i| self.of.goals.get(*i as usize).is_some());
        let most = center.map_or(0, |i| self.of.goals[i as usize].triangles.min(8));
        let ways = most as usize + 1;
        while self.next < ways * PHASES.len() {
            stage.still()?;
            let (phase, way) = (PHASES[self.next / ways], self.next % ways);
            self.next += 1;
            // First as the packing would, then with most triangles first.
            let spokes = center.filter(|_| way > 0).map(|i| (i, most + 1 - way as u32));
            if let Some(mesh) = self.of.mesh(phase, spokes, stage) {
                return Ok(Some(mesh));
            }
        }
        Ok(None)
    }
}
