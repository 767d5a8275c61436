//! Moving vertices by a search along a compass, for what no gradient shows: minimum angles.

use crate::array_mesh::ArrayMesh;
use crate::goal::Weights;
use crate::manifold::Manifold;
use crate::smooth::Ring;
use crate::triangle::min_angle;
use glam::DVec2;

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
fn descend<S: Manifold>(
    mesh: &ArrayMesh<S>,
    vertex: u32,
    ring: &Ring<S::Vector>,
    [first, finest]: [f64; 2],
    mut is_better: impl FnMut(S::Vector) -> bool,
) -> S::Site {
    let mut x = mesh.vertices[vertex as usize].at;
    let (start, frame) = (S::position(&x), S::frame(mesh, vertex));
    // A line has the first and the third direction.
    let every = if S::is_on_line(mesh, vertex) { 2 } else { 1 };
    let directions = &COMPASS[..if every == 2 { 4 } else { 8 }];
    let reach = ring.reach(start);
    let mut step = first * reach;
    // How many directions in a row led nowhere better: once these are all, steps get shorter.
    let (mut in_vain, all) = (0, directions.len() / every);
    while step > finest * reach {
        for direction in directions.iter().step_by(every) {
            let by = DVec2::from(*direction) * step;
            match S::moved(mesh, vertex, &x, &frame, by) {
                Some(place) if is_better(S::position(&place)) => (x, in_vain) = (place, 0),
                _ => in_vain += 1,
            }
            if in_vain == all {
                (step, in_vain) = (step / 2.0, 0);
                break;
            }
        }
    }
    x
}

/// Moves a vertex if it may. True if that changes its place.
fn put<S: Manifold>(
    mesh: &mut ArrayMesh<S>,
    vertex: u32,
    x: S::Site,
    ring: &Ring<S::Vector>,
) -> bool {
    let is_moved =
        S::position(&x) != mesh.at(vertex) && S::may_move(mesh, vertex, &ring.triangles, &x);
    if is_moved {
        mesh.move_to(vertex, x);
    }
    is_moved
}

/// Moves a free vertex along a compass to where small angles at it weigh less, without lowering
/// the least. True if it moved.
pub(crate) fn polish<S: Manifold>(
    mesh: &mut ArrayMesh<S>,
    vertex: u32,
    below: f64,
    ring: &mut Ring<S::Vector>,
) -> bool {
    ring.load(mesh, vertex);
    let start = mesh.at(vertex);
    let mut least = ring.min_angle(start);
    if least >= below {
        return false;
    }
    let mut angles = std::mem::take(&mut ring.wanted);
    // The sum of what angles weigh and the least of them, if none is below `least` and they weigh less than `most`.
    let mut weigh = |x: S::Vector, least: f64, most: f64| {
        angles.clear();
        for [b, c] in &ring.edges {
            let angle = min_angle([x, *b, *c]);
            if angle < least {
                return None;
            }
            angles.push(angle);
        }
        let mut sum = 0.0;
        for angle in &angles {
            sum += libm::exp((20.0 - angle) / 1.5);
            if sum >= most {
                return None;
            }
        }
        Some((sum, angles.iter().copied().fold(f64::INFINITY, f64::min)))
    };
    let mut best =
        weigh(start, f64::NEG_INFINITY, f64::INFINITY).map_or(f64::INFINITY, |found| found.0);
    let x = descend(mesh, vertex, ring, [0.1, 2e-3], |place| {
        let better = weigh(place, least, best * (1.0 - 1e-9));
        if let Some(found) = better {
            (best, least) = found;
        }
        better.is_some()
    });
    ring.wanted = angles;
    put(mesh, vertex, x, ring)
}

/// Moves a free vertex along a compass to where what its triangles cost by their shares is least. `finest`: the
/// last step as a share of the shortest edge. True if it moved.
pub(crate) fn settle<S: Manifold>(
    mesh: &mut ArrayMesh<S>,
    vertex: u32,
    weights: &Weights,
    finest: f64,
    ring: &mut Ring<S::Vector>,
) -> bool {
    ring.load(mesh, vertex);
    let wanted = |t: &u32| weights.wanted_sine(mesh, *t);
    ring.wanted.clear();
    ring.wanted.extend(ring.triangles.iter().map(wanted));
    // Sums that are greater already than what is known are not told to their end.
    let cost = |x: S::Vector, below: f64| {
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
    let x = descend(mesh, vertex, ring, [0.16, finest], |place| {
        let sum = cost(place, best * (1.0 - 1e-9));
        if sum.is_finite() {
            best = sum;
        }
        sum.is_finite()
    });
    put(mesh, vertex, x, ring)
}
