//! Moving vertices by Newton's method on distortion.

use crate::array_mesh::ArrayMesh;
use crate::manifold::{Manifold, Slope};
use crate::space::Vector;
use crate::stage::Stage;
use crate::triangle::{SQRT_3, distortion, min_angle};
use glam::DVec2;
use mindeg_mesh::Cancelled;

/// The exponent of distortion in what smoothing minimises. More weighs bad triangles more.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Power {
    /// The sum of qualities grows, each one over a distortion: bad triangles weigh less.
    MinusOne,
    Two,
    Four,
}

// By multiplication: the library's integer powers may differ from machine to machine.
impl Power {
    fn exponent(self) -> f64 {
        match self {
            Self::MinusOne => -1.0,
            Self::Two => 2.0,
            Self::Four => 4.0,
        }
    }

    fn of(self, x: f64) -> f64 {
        match self {
            Self::MinusOne => -1.0 / x,
            _ => x * x * self.of_two_less(x),
        }
    }

    fn of_two_less(self, x: f64) -> f64 {
        match self {
            Self::MinusOne => -1.0 / (x * x * x),
            Self::Two => 1.0,
            Self::Four => x * x,
        }
    }
}

/// The two ring points of each triangle at a vertex, so that a move needs no look-ups.
#[derive(Debug, Clone)]
pub(crate) struct Ring<V: Vector = DVec2> {
    /// The other two corners of each triangle.
    pub(crate) edges: Vec<[V; 2]>,
    pub(crate) triangles: Vec<u32>,
    /// The sine of the angle that each triangle should have.
    pub(crate) wanted: Vec<f64>,
}

impl<V: Vector> Default for Ring<V> {
    fn default() -> Self {
        Self { edges: Vec::new(), triangles: Vec::new(), wanted: Vec::new() }
    }
}

impl<V: Vector> Ring<V> {
    pub(crate) fn load<S: Manifold<Vector = V>>(&mut self, mesh: &ArrayMesh<S>, vertex: u32) {
        mesh.star(vertex, &mut self.triangles);
        self.edges.clear();
        for t in &self.triangles {
            let triangle = &mesh.triangles[*t as usize];
            let corner = triangle.corner(vertex);
            self.edges.push([1, 2].map(|i| mesh.at(triangle.vertices[(corner + i) % 3])));
        }
    }

    pub(crate) fn distortion(&self, x: V, power: Power) -> f64 {
        self.edges.iter().map(|[b, c]| power.of(distortion([x, *b, *c]))).sum()
    }

    pub(crate) fn min_angle(&self, x: V) -> f64 {
        let each = self.edges.iter().map(|[b, c]| min_angle([x, *b, *c]));
        each.fold(f64::INFINITY, f64::min)
    }

    /// The length of the shortest edge from the vertex to its ring.
    pub(crate) fn reach(&self, x: V) -> f64 {
        self.edges.iter().map(|[b, _]| (*b - x).length()).fold(f64::INFINITY, f64::min)
    }

    /// The triangles at the vertex loaded last.
    pub(crate) fn triangles(&self) -> &[u32] {
        &self.triangles
    }
}

/// One step of Newton's method on the sum of distortion^power over the triangles at a free vertex.
/// The sum is convex where no triangle is inverted. Returns how far the vertex moved.
pub(crate) fn smooth<S: Manifold>(
    mesh: &mut ArrayMesh<S>,
    vertex: u32,
    power: Power,
    ring: &mut Ring<S::Vector>,
) -> f64 {
    ring.load(mesh, vertex);
    if S::is_on_line(mesh, vertex) {
        return step_on_line(mesh, vertex, power, ring);
    }
    step(mesh, vertex, power, ring, |_| true)
}

/// The same for the sum of qualities, if no triangle's minimum angle falls below `kept`, in degrees.
pub(crate) fn round<S: Manifold>(
    mesh: &mut ArrayMesh<S>,
    vertex: u32,
    kept: impl Fn(&ArrayMesh<S>, u32) -> f64,
    ring: &mut Ring<S::Vector>,
) -> f64 {
    ring.load(mesh, vertex);
    let x = mesh.at(vertex);
    // A hair more, so that rounding lowers nothing.
    let least = |(t, [b, c]): (&u32, &[S::Vector; 2])| {
        kept(mesh, *t).min(min_angle([x, *b, *c])) * (1.0 + 1e-12)
    };
    let mut wanted = std::mem::take(&mut ring.wanted);
    wanted.clear();
    wanted.extend(ring.triangles.iter().zip(&ring.edges).map(least));
    let each = |ring: &Ring<S::Vector>, place: S::Vector| {
        let mut all = ring.edges.iter().zip(&wanted);
        all.all(|([b, c], wanted)| min_angle([place, *b, *c]) >= *wanted)
    };
    let moved = step(mesh, vertex, Power::MinusOne, ring, |place| each(ring, place));
    ring.wanted = wanted;
    moved
}

/// A step for the vertex that the ring was loaded for, to a place that may be.
fn step<S: Manifold>(
    mesh: &mut ArrayMesh<S>,
    vertex: u32,
    power: Power,
    ring: &Ring<S::Vector>,
    may_be: impl Fn(S::Vector) -> bool,
) -> f64 {
    debug_assert!(mesh.vertices[vertex as usize].kind.is_movable());
    let (x, frame) = (mesh.at(vertex), S::frame(mesh, vertex));
    let (mut before, mut slope) = (0.0, DVec2::ZERO);
    let (mut xx, mut xy, mut yy) = (0.0, 0.0, 0.0);
    let p = power.exponent();
    for [b, c] in &ring.edges {
        // distortion = s / (2 sqrt3 d): s the sum of squares, d the doubled area, linear in x.
        let Some(slope_of) = S::slope(&frame, x, *b, *c) else { return 0.0 };
        let Slope { squares: s, doubled: d, of_squares: ds, of_doubled: dd } = slope_of;
        let unit = 1.0 / (2.0 * SQRT_3 * d);
        let value = s * unit;
        let gradient = (ds - dd * (s / d)) * unit;
        let outer = |a: DVec2, b: DVec2| [a.x * b.x, a.x * b.y + a.y * b.x, a.y * b.y];
        let (mixed, square) = (outer(ds, dd), outer(dd, dd));
        let curve = |diagonal: f64, mixed: f64, square: f64| {
            (diagonal - mixed / d + square * s / (d * d)) * unit
        };
        let low = power.of_two_less(value);
        // Where the power is concave, its tangent lies above it: what lowers the tangents lowers the sum.
        let (first, second) = (p * low * value, (p * (p - 1.0) * low).max(0.0));
        before += low * value * value;
        slope += gradient * first;
        // The mixed terms: ds dd^T + dd ds^T.
        xx +=
            first * curve(4.0, 2.0 * mixed[0], 2.0 * square[0]) + second * gradient.x * gradient.x;
        xy += first * curve(0.0, mixed[1], square[1]) + second * gradient.x * gradient.y;
        yy +=
            first * curve(4.0, 2.0 * mixed[2], 2.0 * square[2]) + second * gradient.y * gradient.y;
    }
    let determinant = xx * yy - xy * xy;
    if !(determinant > 0.0 && determinant.is_finite()) {
        return 0.0;
    }
    let step = DVec2::new(xy * slope.y - yy * slope.x, xy * slope.x - xx * slope.y) / determinant;
    let mut share = 1.0;
    for _ in 0..5 {
        let from = &mesh.vertices[vertex as usize].at;
        if let Some(site) = S::moved(mesh, vertex, from, &frame, step * share) {
            let place = S::position(&site);
            if ring.distortion(place, power) < before
                && may_be(place)
                && S::may_move(mesh, vertex, &ring.triangles, &site)
            {
                mesh.move_to(vertex, site);
                return step.length() * share;
            }
        }
        share *= 0.4;
    }
    0.0
}

/// The same along a line, by differences.
fn step_on_line<S: Manifold>(
    mesh: &mut ArrayMesh<S>,
    vertex: u32,
    power: Power,
    ring: &Ring<S::Vector>,
) -> f64 {
    let (x, frame) = (mesh.at(vertex), S::frame(mesh, vertex));
    let reach = ring.reach(x);
    let from = mesh.vertices[vertex as usize].at;
    let site = |step: f64| S::moved(mesh, vertex, &from, &frame, DVec2::new(step, 0.0));
    let value = |site: &S::Site| ring.distortion(S::position(site), power);
    let h = 1e-3 * reach;
    let (Some(left), Some(right)) = (site(-h), site(h)) else { return 0.0 };
    let [low, before, high] = [value(&left), value(&from), value(&right)];
    let slope = (high - low) / (2.0 * h);
    let curve = (high - 2.0 * before + low) / (h * h);
    let newton = if curve > 0.0 { -slope / curve } else { -slope.signum() * 0.1 * reach };
    let mut step = newton.clamp(-0.4 * reach, 0.4 * reach);
    for _ in 0..4 {
        if let Some(site) = site(step)
            && value(&site) < before
            && S::may_move(mesh, vertex, &ring.triangles, &site)
        {
            mesh.move_to(vertex, site);
            return step.abs();
        }
        step *= 0.4;
    }
    0.0
}

/// Smooths all free vertices, those that stopped moving less often.
pub(crate) struct Sweeper<V: Vector = DVec2> {
    is_active: Vec<bool>,
    pub(crate) ring: Ring<V>,
}

/// Below this share of the size, a move does not count.
const STILL: f64 = 3e-3;

impl<V: Vector> Sweeper<V> {
    pub(crate) fn new() -> Self {
        Self { is_active: Vec::new(), ring: Ring::default() }
    }

    /// `sweeps` sweeps over all vertices.
    pub(crate) fn run<S: Manifold<Vector = V>>(
        &mut self,
        mesh: &mut ArrayMesh<S>,
        power: Power,
        sweeps: usize,
        stage: &mut Stage<'_>,
    ) -> Result<(), Cancelled> {
        self.start(mesh.vertices.len(), true);
        self.sweep(mesh, sweeps, stage, |mesh, v, ring| smooth(mesh, v, power, ring))
    }

    /// Begins with all vertices of a mesh, or with none.
    pub(crate) fn start(&mut self, vertices: usize, is_active: bool) {
        self.is_active.clear();
        self.is_active.resize(vertices, is_active);
    }

    /// The next sweep goes over these vertices, too.
    pub(crate) fn wake(&mut self, vertices: &[u32]) {
        vertices.iter().for_each(|v| self.is_active[*v as usize] = true);
    }

    /// `sweeps` sweeps with moves that tell how far they went.
    pub(crate) fn sweep<S: Manifold<Vector = V>>(
        &mut self,
        mesh: &mut ArrayMesh<S>,
        sweeps: usize,
        stage: &mut Stage<'_>,
        mut go: impl FnMut(&mut ArrayMesh<S>, u32, &mut Ring<V>) -> f64,
    ) -> Result<(), Cancelled> {
        for _ in 0..sweeps {
            stage.still()?;
            let mut moved = false;
            for v in 0..mesh.vertices.len() as u32 {
                let vertex = &mesh.vertices[v as usize];
                let is_waiting = self.is_active[v as usize];
                if !vertex.kind.is_movable() || vertex.triangles == 0 || !is_waiting {
                    continue;
                }
                self.is_active[v as usize] = false;
                let (size, before) = (vertex.size, vertex.at);
                let survey = S::survey(mesh, &[v], true);
                let distance = go(mesh, v, &mut self.ring);
                if survey.is_some_and(|survey| distance > 0.0 && !S::keeps(mesh, &survey, &[v])) {
                    mesh.move_to(v, before);
                } else if distance > STILL * size {
                    moved = true;
                    for t in self.ring.triangles() {
                        let vertices = mesh.triangles[*t as usize].vertices;
                        vertices.iter().for_each(|u| self.is_active[*u as usize] = true);
                    }
                }
            }
            if !moved {
                break;
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::array_mesh::{Kind, NONE, Vertex};
    use crate::compass::polish;
    use mindeg_mesh::Progress;

    /// A free vertex, the last one, in a ring of others.
    fn star(ring: &[[f64; 2]], center: [f64; 2]) -> ArrayMesh {
        let vertex = |at: &[f64; 2], kind| Vertex {
            at: (*at).into(),
            size: 1.0,
            anchor: NONE,
            goal: NONE,
            triangles: 0,
            kind,
        };
        let mut vertices: Vec<Vertex> = ring.iter().map(|at| vertex(at, Kind::Boundary)).collect();
        vertices.push(vertex(&center, Kind::Free));
        let n = ring.len() as u32;
        let triangles: Vec<[u32; 3]> = (0..n).map(|i| [i, (i + 1) % n, n]).collect();
        ArrayMesh::new(vertices, &triangles, Vec::new(), &[]).unwrap()
    }

    const UNEVEN: [[f64; 2]; 5] = [[2.0, 0.1], [0.9, 1.7], [-1.1, 1.2], [-1.4, -0.8], [0.3, -1.5]];

    /// Newton's step from differences of the sum itself.
    fn newton(ring: &Ring, x: DVec2, power: Power) -> DVec2 {
        let h = 1e-4;
        let at = |i: f64, j: f64| ring.distortion(x + h * DVec2::new(i, j), power);
        let slope =
            DVec2::new(at(1.0, 0.0) - at(-1.0, 0.0), at(0.0, 1.0) - at(0.0, -1.0)) / (2.0 * h);
        let middle = 2.0 * at(0.0, 0.0);
        let xx = (at(1.0, 0.0) + at(-1.0, 0.0) - middle) / (h * h);
        let yy = (at(0.0, 1.0) + at(0.0, -1.0) - middle) / (h * h);
        let xy = (at(1.0, 1.0) + at(-1.0, -1.0) - at(1.0, -1.0) - at(-1.0, 1.0)) / (4.0 * h * h);
        let determinant = xx * yy - xy * xy;
        -DVec2::new(yy * slope.x - xy * slope.y, xx * slope.y - xy * slope.x) / determinant
    }

    #[test]
    fn a_step_is_newtons() {
        for (power, start) in [(Power::Two, [0.25, 0.15]), (Power::Four, [0.2, 0.1])] {
            let mut mesh = star(&UNEVEN, start);
            let mut ring = Ring::default();
            ring.load(&mesh, 5);
            let expected = newton(&ring, start.into(), power);
            let moved = smooth(&mut mesh, 5, power, &mut ring);
            let step = mesh.at(5) - DVec2::from(start);
            assert!(step.distance(expected) < 1e-4 * expected.length(), "{step} {expected}");
            assert!((moved - step.length()).abs() < 1e-12);
        }
    }

    #[test]
    fn sweeps_end_where_the_distortion_is_least() {
        for power in [Power::MinusOne, Power::Two, Power::Four] {
            let mut mesh = star(&UNEVEN, [1.0, 0.4]);
            let mut stage = Stage::new(Progress::NONE, "smoothing");
            Sweeper::new().run(&mut mesh, power, 50, &mut stage).unwrap();
            let mut ring = Ring::default();
            ring.load(&mesh, 5);
            let end = mesh.at(5);
            let least = ring.distortion(end, power);
            for direction in 0..16 {
                let around = DVec2::from_angle(f64::from(direction) / 16.0 * std::f64::consts::TAU);
                assert!(ring.distortion(end + 0.02 * around, power) > least, "{direction}");
            }
        }
    }

    #[test]
    fn a_vertex_is_polished_to_the_largest_small_angle() {
        let hexagon: Vec<[f64; 2]> = (0..6)
            .map(|i| DVec2::from_angle(f64::from(i) / 3.0 * std::f64::consts::PI).to_array())
            .collect();
        let mut mesh = star(&hexagon, [0.5, -0.2]);
        let mut ring = Ring::default();
        assert!(!polish(&mut mesh, 6, 1.0, &mut ring), "no angle is below one degree");
        assert!(polish(&mut mesh, 6, 60.0, &mut ring));
        let end = mesh.at(6);
        assert!(end.length() < 0.01 && ring.min_angle(end) > 59.0, "{end}");
    }
}
