//! Triangulations of a disc searched by their degrees, with the shapes that its points have in second place: between two moves triangles may
//! be turned over, so that no hill of shapes stands between two sets of degrees. Points are put right at the end.
//!
//! The moves are the bistellar ones: an edge is turned, a point is put on an edge or taken away. They reach every triangulation.
//! Hundreds of them are tried in the time of one trial that smooths.

use crate::array_mesh::{ArrayMesh, Kind, NONE, Triangle, Vertex};
use crate::goal::Weights;
use crate::sketch::{DEGREE, Effort, Sketch, TURNED, about_log};
use glam::DVec2;
use mindeg_mesh::Random;

/// The heat at the start and at the end.
const HEAT: [f64; 2] = [5.0, 0.3];
/// The heat stays as it is for so many moves.
const MOVES_OF_HEAT: u32 = 64;

/// Another triangulation of the disc whose degrees are less out of their ranges, after random moves; `None` if
/// none was found, or if its points cannot be put right. With it comes the number of moves that were made.
pub(crate) fn redrawn(
    disc: &ArrayMesh,
    weights: &Weights,
    effort: Effort,
    random: &mut Random,
) -> (Option<ArrayMesh>, u64) {
    let mut sketch = Sketch::new(disc, weights, effort);
    let before = sketch.excess;
    let mut heat = HEAT[0];
    let moves = effort.moves.saturating_mul(disc.triangles.len() as u32);
    for step in 0..moves {
        // Of searches that come to something, nineteen in twenty are better by then.
        if step == moves / 2 && sketch.excess >= before {
            return (None, step.into());
        }
        if step.is_multiple_of(MOVES_OF_HEAT) {
            let share = f64::from(step) / f64::from(moves);
            sketch.turned = TURNED[0] + share * (TURNED[1] - TURNED[0]);
            heat = HEAT[0] * libm::exp(share * libm::log(HEAT[1] / HEAT[0]));
        }
        sketch.try_move(heat, random);
    }
    (if sketch.excess < before { sketch.into_mesh() } else { None }, moves.into())
}

impl Sketch<'_> {
    fn try_move(&mut self, heat: f64, random: &mut Random) {
        let at = random.below(3 * self.triangles.len());
        let (triangle, corner) = ((at / 3) as u32, at % 3);
        if !self.triangles[triangle as usize].is_alive() {
            return;
        }
        let most = -heat * about_log(random.unit().max(1e-300));
        match random.below(16) {
            0 => self.split(triangle, corner, most),
            1..=2 => self.remove(triangle, corner, most),
            3..=6 => self.relocate(triangle, corner, random.unit(), random.below(3), most),
            _ => self.flip(triangle, corner, most),
        }
    }

    fn flip(&mut self, triangle: u32, corner: usize, most: f64) {
        let Some((other, opposite, [c, a, b, d])) = self.quad(triangle, corner) else { return };
        let counts = [(a, -1), (b, -1), (c, 1), (d, 1)];
        let (degrees, excess) = self.change(&counts);
        let [one, two] = [[c, a, d], [c, d, b]];
        // Most end here: new shapes cost nothing at best.
        let most = most + self.shape_of(triangle) + self.shape_of(other) - degrees;
        let first = if most < 0.0 { return } else { self.shape(one) };
        if first > most || first + self.shape(two) > most {
            return;
        }
        let is_chord = !self.is_free(c) && !self.is_free(d);
        if self.are_joined(c, d, triangle) || is_chord && !self.is_visible(c, d) {
            return;
        }
        let [left, right] = [(triangle, corner), (other, opposite)].map(|at| self.beside(at));
        // Across b-c, c-a; across a-d, d-b.
        let ([bc, ca], [ad, db]) = (left, right);
        self.put(triangle, made(one, [ad.0, other, ca.0], [ad.1, false, ca.1]));
        self.put(other, made(two, [db.0, bc.0, triangle], [db.1, bc.1, false]));
        self.relink(ad.0, other, triangle);
        self.relink(bc.0, triangle, other);
        self.count(&counts, excess);
    }

    /// Puts a vertex on the middle of an edge.
    fn split(&mut self, triangle: u32, corner: usize, most: f64) {
        let Some((other, opposite, [c, a, b, d])) = self.quad(triangle, corner) else { return };
        let m = self.push_vertex(Vertex {
            at: self.at(a).midpoint(self.at(b)),
            size: (self.vertices[a as usize].size + self.vertices[b as usize].size) / 2.0,
            anchor: NONE,
            goal: NONE,
            triangles: 0,
            kind: Kind::Free,
        });
        let counts = [(c, 1), (d, 1)];
        let (mut degrees, mut excess) = self.change(&counts);
        let own = self.excess_of(m, 4);
        degrees += DEGREE * f64::from(own * own);
        excess += own as i32;
        let shapes = [[c, a, m], [c, m, b], [d, b, m], [d, m, a]].map(|t| self.shape(t));
        let change = shapes.iter().sum::<f64>() - self.shape_of(triangle) - self.shape_of(other);
        if degrees + change + self.effort.vertex > most {
            self.unused[1].push(m);
            return;
        }
        let [left, right] = [(triangle, corner), (other, opposite)].map(|at| self.beside(at));
        let ([bc, ca], [ad, db]) = (left, right);
        let [third, fourth] = [0, 1].map(|_| self.push_triangle());
        self.put(triangle, made([c, a, m], [fourth, third, ca.0], [false, false, ca.1]));
        self.put(third, made([c, m, b], [other, bc.0, triangle], [false, bc.1, false]));
        self.put(other, made([d, b, m], [third, fourth, db.0], [false, false, db.1]));
        self.put(fourth, made([d, m, a], [triangle, ad.0, other], [false, ad.1, false]));
        self.relink(bc.0, triangle, third);
        self.relink(ad.0, other, fourth);
        self.vertices[m as usize].triangles = 4;
        self.count(&counts, excess);
    }

    /// Takes a vertex with three or four triangles away; of four, the first two become one, and the others.
    fn remove(&mut self, triangle: u32, corner: usize, most: f64) {
        let m = self.triangles[triangle as usize].vertices[corner];
        if !self.is_free(m) || self.vertices[m as usize].triangles > 4 {
            return;
        }
        let Some((star, count)) = self.star::<4>(m, triangle) else { return };
        // The rim, with the triangle across each edge that begins there.
        let mut rim = [(NONE, NONE, false); 4];
        for (i, t) in star[..count].iter().enumerate() {
            let t = &self.triangles[*t as usize];
            let own = t.corner(m);
            rim[i] = (t.vertices[(own + 1) % 3], t.neighbours[own], t.labels[own]);
        }
        let at = |i: usize| rim[i % count].0;
        let own = self.excess_of(m, count as u32);
        let mut counts = [(at(0), -1), (at(1), -1), (at(2), -1), (at(2), 0)];
        let (first, second) = ([at(0), at(1), at(2)], [at(0), at(2), at(3)]);
        if count == 4 {
            counts = [(at(1), -1), (at(3), -1), (at(0), 0), (at(2), 0)];
        }
        let (degrees, excess) = self.change(&counts);
        let degrees = degrees - DEGREE * f64::from(own * own);
        let old: f64 = star[..count].iter().map(|t| self.shape_of(*t)).sum();
        let new = self.shape(first) + if count == 4 { self.shape(second) } else { 0.0 };
        if degrees + new - old - self.effort.vertex > most {
            return;
        }
        if count == 4 {
            let [a, b] = [at(0), at(2)];
            let is_chord = !self.is_free(a) && !self.is_free(b);
            if self.are_joined(a, b, star[0]) || is_chord && !self.is_visible(a, b) {
                return;
            }
        }
        let [keep, other] = [star[0], star[1]];
        if count == 4 {
            // keep: 0 1 2, other: 0 2 3.
            self.put(keep, made(first, [rim[1].1, other, rim[0].1], [rim[1].2, false, rim[0].2]));
            self.put(other, made(second, [rim[2].1, rim[3].1, keep], [rim[2].2, rim[3].2, false]));
            self.relink(rim[1].1, star[1], keep);
            self.relink(rim[2].1, star[2], other);
            self.relink(rim[3].1, star[3], other);
        } else {
            let labels = [rim[1].2, rim[2].2, rim[0].2];
            self.put(keep, made(first, [rim[1].1, rim[2].1, rim[0].1], labels));
            self.relink(rim[1].1, star[1], keep);
            self.relink(rim[2].1, star[2], keep);
        }
        for t in &star[if count == 4 { 2 } else { 1 }..count] {
            self.triangles[*t as usize].vertices[0] = NONE;
            self.unused[0].push(*t);
        }
        self.vertices[m as usize].triangles = 0;
        if m as usize >= self.mesh.vertices.len() {
            self.unused[1].push(m);
        }
        self.count(&counts, excess - own as i32);
    }

    /// The triangles across the two edges at a corner, with the labels of these.
    fn beside(&self, (triangle, corner): (u32, usize)) -> [(u32, bool); 2] {
        let t = &self.triangles[triangle as usize];
        [1, 2].map(|i| (t.neighbours[(corner + i) % 3], t.labels[(corner + i) % 3]))
    }

    /// Moves a free vertex towards the middle of its neighbours.
    fn relocate(&mut self, triangle: u32, corner: usize, share: f64, way: usize, most: f64) {
        let v = self.triangles[triangle as usize].vertices[corner];
        if !self.is_free(v) {
            return;
        }
        let Some((star, count)) = self.star::<12>(v, triangle) else { return };
        let (mut sum, mut before) = (DVec2::ZERO, 0.0);
        for index in &star[..count] {
            let t = &self.triangles[*index as usize];
            sum += self.at(t.vertices[(t.corner(v) + 1) % 3]);
            before += self.shape_of(*index);
        }
        let old = self.at(v);
        let t = &self.triangles[triangle as usize];
        let [b, c] = [1, 2].map(|i| self.at(t.vertices[(corner + i) % 3]));
        self.vertices[v as usize].at = match way {
            0 => old.lerp(sum / count as f64, 1.5 * share),
            1 => old.lerp(b, share),
            _ => b.midpoint(c) + (c - b).perp() * (1.5 * share),
        };
        let mut left = most + before;
        for t in &star[..count] {
            left -= self.shape(self.triangles[*t as usize].vertices);
            if left < 0.0 {
                self.vertices[v as usize].at = old;
                return;
            }
        }
        star[..count].iter().for_each(|t| self.rate(*t));
    }
}

fn made(vertices: [u32; 3], neighbours: [u32; 3], labels: [bool; 3]) -> Triangle {
    Triangle { neighbours, labels, ..Triangle::new(vertices, ()) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::array_mesh::tests::grid;
    use crate::goal::Goal;
    use crate::options::Options;
    use std::collections::BTreeSet;

    const EFFORT: Effort = Effort { moves: 0, shape: 1.0, vertex: 0.0 };

    #[test]
    fn random_moves_keep_the_triangulation() {
        let (mesh, weights) = (grid(6), Weights::local(&Options::default(), 36.0));
        let (mut most, mut least) = (0, usize::MAX);
        for seed in 0..20 {
            let effort = Effort { vertex: if seed % 2 == 0 { 0.0 } else { 60.0 }, ..EFFORT };
            let mut sketch = Sketch::new(&mesh, &weights, effort);
            let mut random = Random::new(seed);
            for _ in 0..400 {
                sketch.try_move(40.0, &mut random);
            }
            let alive: Vec<u32> = (0..sketch.triangles.len() as u32)
                .filter(|t| sketch.triangles[*t as usize].is_alive())
                .collect();
            let (mut edges, mut counts) = (BTreeSet::new(), vec![0; sketch.vertices.len()]);
            for &t in &alive {
                let own = sketch.triangles[t as usize];
                assert_eq!(sketch.shape_of(t), sketch.shape(own.vertices));
                for i in 0..3 {
                    let ends = [1, 2].map(|j| own.vertices[(i + j) % 3]);
                    assert!(edges.insert(ends), "{ends:?} twice");
                    counts[own.vertices[i] as usize] += 1;
                    if own.neighbours[i] != NONE {
                        let other = sketch.triangles[own.neighbours[i] as usize];
                        let back = (0..3).find(|j| other.neighbours[*j] == t).unwrap();
                        let across = [2, 1].map(|j| other.vertices[(back + j) % 3]);
                        assert_eq!((across, other.labels[back]), (ends, own.labels[i]));
                    }
                }
            }
            // Edges between vertices that stay cross no edge that stays.
            let is_inside = |[a, b]: &[u32; 2]| edges.contains(&[*b, *a]);
            for ends in edges.iter().filter(|ends| is_inside(ends)) {
                let stays = ends.iter().all(|v| !sketch.is_free(*v));
                assert!(!stays || sketch.is_visible(ends[0], ends[1]), "{ends:?}");
            }
            let used = (0..).zip(&sketch.vertices).filter(|(_, v)| v.triangles > 0);
            let excess: u32 = used.map(|(v, own)| sketch.excess_of(v, own.triangles)).sum();
            assert_eq!(sketch.excess, excess);
            assert!(sketch.vertices.iter().zip(&counts).all(|(v, count)| v.triangles == *count));
            assert!(edges.contains(&[8, 9]) && edges.contains(&[9, 8]));
            (most, least) = (most.max(alive.len()), least.min(alive.len()));
        }
        assert!(least < mesh.triangles.len() && most > mesh.triangles.len(), "{least} {most}");
    }

    #[test]
    fn searches_that_are_no_better_by_half_of_their_moves_end_there() {
        let (mut mesh, weights) = (grid(6), Weights::local(&Options::default(), 36.0));
        mesh.goals.push(Goal { least: 1, ..weights.goal_inside() });
        for vertex in mesh.vertices.iter_mut().filter(|v| v.kind == Kind::Boundary) {
            vertex.goal = 0;
        }
        let effort = Effort { moves: 10, ..EFFORT };
        let found = redrawn(&mesh, &weights, effort, &mut Random::new(1));
        assert_eq!((found.0.is_none(), found.1), (true, 10 * 72 / 2));
    }
}
