//! Rings that touch and nearly touch, on a grid and one unit in the last place beside it: what is taken is
//! what a test of every pair of edges takes, and all judges agree.

use crate::hostile::{GridPoint, rings_are_simple, turn};
use arbitrary::Arbitrary;
use glam::DVec2;
use mindeg::exact::degree;
use mindeg::{Domain, Goal, Progress, mesh};
use mindeg_mesh::check;

#[derive(Arbitrary, Debug)]
pub(crate) struct Input {
    /// Larger or smaller than a grid of 32, by a power of two, and away from the origin.
    scale: i8,
    offset: u8,
    outer: Vec<GridPoint>,
    holes: Vec<Vec<GridPoint>>,
}

pub(crate) fn run(input: Input) {
    let scale = f64::from(input.scale / 8).exp2();
    let offset = f64::from(input.offset / 16) * 1000.0;
    let place = |point: &GridPoint| (point.0 + offset) * scale;
    let rings: Vec<Vec<DVec2>> = [&input.outer]
        .into_iter()
        .chain(input.holes.iter().take(3))
        .map(|ring| ring.iter().take(24).map(place).collect())
        .collect();
    let domain = Domain::from_rings(rings.clone());
    let domain = match domain {
        Ok(domain) => domain,
        Err(error) => {
            let problem = error.to_string();
            // A single ring without a crossing is a domain, as long as no edge is too short.
            let is_ring = rings.len() == 1 && rings[0].len() >= 3;
            let is_long = |ring: &[DVec2]| {
                (0..ring.len()).all(|i| ring[i].distance(ring[(i + 1) % ring.len()]) > 1e-6)
            };
            let has_area = |ring: &[DVec2]| {
                (0..ring.len()).any(|i| turn(ring[0], ring[i], ring[(i + 1) % ring.len()]) != 0.0)
            };
            assert!(
                !(is_ring && is_long(&rings[0]) && has_area(&rings[0]) && rings_are_simple(&rings)),
                "a simple ring is refused: {problem}"
            );
            return;
        }
    };
    assert!(rings_are_simple(&rings), "rings that meet are taken");
    let boundary = domain.boundary().expect("a domain of rings has been proven");
    // Points too close for triangles with area are not a fault of the mesh; wrong triangles are.
    if let Ok(meshed) = mesh(&domain, Goal::LeastDegree, Progress::NONE) {
        let triangles: Vec<_> = meshed.mesh.triangles().collect();
        let checked = check::triangulation(&boundary, &[], &triangles).expect("a triangulation");
        assert_eq!(checked.max_degree, meshed.mesh.max_degree());
        assert!(checked.max_degree >= meshed.least_max_degree);
        let answer = degree(&domain, Progress::NONE).expect("what has a mesh has a degree");
        assert!(answer.at_least <= checked.max_degree);
        assert!(answer.at_least <= answer.reached);
        if meshed.is_least_proven {
            assert!(answer.reached >= meshed.least_max_degree);
        }
    }
}
