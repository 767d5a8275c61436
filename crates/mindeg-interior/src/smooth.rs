//! Moving free vertices: Newton's method on distortion, and a search along a compass for angles.

use crate::array_mesh::{ArrayMesh, Kind};
use crate::goal::Weights;
use crate::stage::Stage;
use crate::triangle::{SQRT_3, cross, distortion, min_angle};
use glam::DVec2;
use mindeg_mesh::Cancelled;

/// The exponent of distortion in what smoothing minimises. More weighs bad triangles more.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Power {
    One,
    Two,
    Four,
}

// By multiplication: the library's integer powers may differ from machine to machine.
impl Power {
    fn exponent(self) -> f64 {
        match self {
            Self::One => 1.0,
            Self::Two => 2.0,
            Self::Four => 4.0,
        }
    }

    fn of(self, x: f64) -> f64 {
        x * x * self.of_two_less(x)
    }

    fn of_two_less(self, x: f64) -> f64 {
        match self {
            Self::One => 1.0 / x,
            Self::Two => 1.0,
            Self::Four => x * x,
        }
    }
}

/// The two ring points of each triangle at a vertex, so that a move needs no look-ups.
#[derive(Debug, Clone, Default)]
pub(crate) struct Ring {
    edges: Vec<[DVec2; 2]>,
    triangles: Vec<u32>,
    /// The sine of the angle that each triangle should have.
    wanted: Vec<f64>,
}

impl Ring {
    fn load(&mut self, mesh: &ArrayMesh, vertex: u32) {
        mesh.star(vertex, &mut self.triangles);
        self.edges.clear();
        for t in &self.triangles {
            let triangle = &mesh.triangles[*t as usize];
            let corner = triangle.corner(vertex);
            self.edges.push([1, 2].map(|i| mesh.at(triangle.vertices[(corner + i) % 3])));
        }
    }

    fn distortion(&self, x: DVec2, power: Power) -> f64 {
        self.edges.iter().map(|[b, c]| power.of(distortion([x, *b, *c]))).sum()
    }

    fn min_angle(&self, x: DVec2) -> f64 {
        let each = self.edges.iter().map(|[b, c]| min_angle([x, *b, *c]));
        each.fold(f64::INFINITY, f64::min)
    }

    /// The triangles at the vertex loaded last.
    pub(crate) fn triangles(&self) -> &[u32] {
        &self.triangles
    }
}

/// One step of Newton's method on the sum of distortion^power over the triangles at a free vertex.
/// The sum is convex where no triangle is inverted. Returns how far the vertex moved.
pub(crate) fn smooth(mesh: &mut ArrayMesh, vertex: u32, power: Power, ring: &mut Ring) -> f64 {
    ring.load(mesh, vertex);
    step(mesh, vertex, power, ring, |_| true)
}

/// The same for the sum of distortions, if no triangle's minimum angle falls below `kept`, in degrees.
pub(crate) fn round(
    mesh: &mut ArrayMesh,
    vertex: u32,
    kept: impl Fn(&ArrayMesh, u32) -> f64,
    ring: &mut Ring,
) -> f64 {
    ring.load(mesh, vertex);
    let x = mesh.at(vertex);
    // A hair more, so that rounding lowers nothing.
    let least = |(t, [b, c]): (&u32, &[DVec2; 2])| {
        kept(mesh, *t).min(min_angle([x, *b, *c])) * (1.0 + 1e-12)
    };
    let mut wanted = std::mem::take(&mut ring.wanted);
    wanted.clear();
    wanted.extend(ring.triangles.iter().zip(&ring.edges).map(least));
    let each = |ring: &Ring, place: DVec2| {
        let mut all = ring.edges.iter().zip(&wanted);
        all.all(|([b, c], wanted)| min_angle([place, *b, *c]) >= *wanted)
    };
    let moved = step(mesh, vertex, Power::One, ring, |place| each(ring, place));
    ring.wanted = wanted;
    moved
}

/// A step for the vertex that the ring was loaded for, to a place that may be.
fn step(
    mesh: &mut ArrayMesh,
    vertex: u32,
    power: Power,
    ring: &Ring,
    may_be: impl Fn(DVec2) -> bool,
) -> f64 {
    debug_assert_eq!(mesh.vertices[vertex as usize].kind, Kind::Free);
    let x = mesh.at(vertex);
    let (mut before, mut slope) = (0.0, DVec2::ZERO);
    let (mut xx, mut xy, mut yy) = (0.0, 0.0, 0.0);
    let p = power.exponent();
    for [b, c] in &ring.edges {
        // distortion = s / (2 sqrt3 d): s the sum of squares, d the doubled area, linear in x.
        let (u, v) = (*b - x, *c - x);
        let d = cross(u, v);
        if d <= 0.0 {
            return 0.0;
        }
        let s = u.length_squared() + v.length_squared() + b.distance_squared(*c);
        let (ds, dd) = (-2.0 * (u + v), DVec2::new(b.y - c.y, c.x - b.x));
        let unit = 1.0 / (2.0 * SQRT_3 * d);
        let value = s * unit;
        let gradient = (ds - dd * (s / d)) * unit;
        let outer = |a: DVec2, b: DVec2| [a.x * b.x, a.x * b.y + a.y * b.x, a.y * b.y];
        let (mixed, square) = (outer(ds, dd), outer(dd, dd));
        let curve = |diagonal: f64, mixed: f64, square: f64| {
            (diagonal - mixed / d + square * s / (d * d)) * unit
        };
        let low = power.of_two_less(value);
        let (first, second) = (p * low * value, p * (p - 1.0) * low);
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
        let place = x + step * share;
        if place.is_finite() && ring.distortion(place, power) < before && may_be(place) {
            mesh.move_to(vertex, place);
            return step.length() * share;
        }
        share *= 0.4;
    }
    0.0
}

/// Eight directions.
const COMPASS: [[f64; 2]; 8] = {
    let diagonal = std::f64::consts::FRAC_1_SQRT_2;
    [
        [1.0, 0.0],
        [0.0, 1.0],
        [-1.0, 0.0],
        [0.0, -1.0],
        [diagonal, diagonal],
        [-diagonal, diagonal],
        [-diagonal, -diagonal],
        [diagonal, -diagonal],
    ]
};

/// Where a descent along a compass ends: each step goes to a place that `is_better` than all before, and steps get
/// shorter where there is none, from `first` to `finest` times the shortest edge.
fn descend(
    ring: &Ring,
    start: DVec2,
    [first, finest]: [f64; 2],
    mut is_better: impl FnMut(DVec2) -> bool,
) -> DVec2 {
    let reach = ring.edges.iter().map(|[b, _]| b.distance(start)).fold(f64::INFINITY, f64::min);
    let mut x = start;
    let mut step = first * reach;
    while step > finest * reach {
        let mut found = false;
        for direction in COMPASS {
            let place = x + DVec2::from(direction) * step;
            if is_better(place) {
                (x, found) = (place, true);
            }
        }
        if !found {
            step /= 2.0;
        }
    }
    x
}

/// Moves a vertex. True if that changes its place.
fn put(mesh: &mut ArrayMesh, vertex: u32, x: DVec2) -> bool {
    let is_moved = x != mesh.at(vertex);
    if is_moved {
        mesh.move_to(vertex, x);
    }
    is_moved
}

/// Moves a free vertex along a compass to where small angles at it weigh less, without lowering
/// the least. True if it moved.
pub(crate) fn polish(mesh: &mut ArrayMesh, vertex: u32, below: f64, ring: &mut Ring) -> bool {
    ring.load(mesh, vertex);
    let start = mesh.at(vertex);
    let mut least = ring.min_angle(start);
    if least >= below {
        return false;
    }
    let weight = |x: DVec2| {
        let mut least = f64::INFINITY;
        let mut sum = 0.0;
        for [b, c] in &ring.edges {
            let angle = min_angle([x, *b, *c]);
            least = least.min(angle);
            sum += libm::exp((20.0 - angle) / 1.5);
        }
        (sum, least)
    };
    let mut best = weight(start).0;
    let x = descend(ring, start, [0.1, 2e-3], |place| {
        let (sum, angle) = weight(place);
        let is_better = sum < best * (1.0 - 1e-9) && angle >= least;
        if is_better {
            (best, least) = (sum, angle);
        }
        is_better
    });
    put(mesh, vertex, x)
}

/// Moves a free vertex along a compass to where what its triangles cost by their shares is least. `finest`: the
/// last step as a share of the shortest edge. True if it moved.
pub(crate) fn settle(
    mesh: &mut ArrayMesh,
    vertex: u32,
    weights: &Weights,
    finest: f64,
    ring: &mut Ring,
) -> bool {
    ring.load(mesh, vertex);
    let wanted = |t: &u32| weights.wanted_sine(mesh, *t);
    ring.wanted.clear();
    ring.wanted.extend(ring.triangles.iter().map(wanted));
    // Sums that are greater already than what is known are not told to their end.
    let cost = |x: DVec2, below: f64| {
        let mut sum = 0.0;
        for ([b, c], wanted) in ring.edges.iter().zip(&ring.wanted) {
            sum += weights.share([x, *b, *c], *wanted);
            if sum >= below {
                return f64::INFINITY;
            }
        }
        sum
    };
    let start = mesh.at(vertex);
    let mut best = cost(start, f64::INFINITY);
    let x = descend(ring, start, [0.16, finest], |place| {
        let sum = cost(place, best * (1.0 - 1e-9));
        if sum.is_finite() {
            best = sum;
        }
        sum.is_finite()
    });
    put(mesh, vertex, x)
}

/// Smooths all free vertices, those that stopped moving less often.
pub(crate) struct Sweeper {
    is_active: Vec<bool>,
    pub(crate) ring: Ring,
}

/// Below this share of the size, a move does not count.
const STILL: f64 = 3e-3;

impl Sweeper {
    pub(crate) fn new() -> Self {
        Self { is_active: Vec::new(), ring: Ring::default() }
    }

    /// `sweeps` sweeps over all vertices.
    pub(crate) fn run(
        &mut self,
        mesh: &mut ArrayMesh,
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
    pub(crate) fn sweep(
        &mut self,
        mesh: &mut ArrayMesh,
        sweeps: usize,
        stage: &mut Stage<'_>,
        mut go: impl FnMut(&mut ArrayMesh, u32, &mut Ring) -> f64,
    ) -> Result<(), Cancelled> {
        for _ in 0..sweeps {
            stage.still()?;
            let mut moved = false;
            for v in 0..mesh.vertices.len() as u32 {
                let vertex = &mesh.vertices[v as usize];
                if vertex.kind != Kind::Free || vertex.triangles == 0 || !self.is_active[v as usize]
                {
                    continue;
                }
                self.is_active[v as usize] = false;
                let size = vertex.size;
                if go(mesh, v, &mut self.ring) > STILL * size {
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
    use crate::array_mesh::{NONE, Vertex};
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
        for power in [Power::Two, Power::Four] {
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
