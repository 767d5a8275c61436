//! Counts to triangulations: every candidate passes the checker with the degree that the certificate
//! proves, and any index gives an answer at any size.

use arbitrary::Arbitrary;
use mindeg_core::{
    Boundary, Candidates, RingStrip, certificate, least_degree_triangulation, suggest, verify,
};

#[derive(Arbitrary, Debug)]
pub(crate) struct Input {
    /// A count and how many bits it is shifted up.
    sides: Vec<(u8, u8)>,
    picks: [u32; 4],
    rings: [u32; 2],
    target: u8,
}

/// Up to this many vertices all triangles are checked.
const CHECKED: u32 = 3_000;

pub(crate) fn run(input: Input) {
    let side = |&(count, shift): &(u8, u8)| u64::from(count) << (shift % 40);
    let intervals: Vec<u64> = input.sides.iter().take(40).map(side).collect();
    if let Ok(boundary) = Boundary::new(&intervals) {
        check(&boundary, &intervals, &input);
    } else {
        assert!(verify(&intervals, []).is_err());
        assert!(
            intervals.len() < 3
                || intervals.contains(&0)
                || intervals.iter().sum::<u64>() > u64::from(mindeg_core::MAX_VERTICES)
        );
    }
    if let Ok(strip) = RingStrip::new(input.rings[0], input.rings[1]) {
        for pick in input.picks {
            let triangle = strip.triangle(pick % strip.len());
            assert!(triangle.iter().all(|&v| v < strip.len()));
        }
    }
}

fn check(boundary: &Boundary, intervals: &[u64], input: &Input) {
    let proof = certificate(boundary);
    let degree = proof.max_degree();
    assert_eq!(proof.check(intervals), Ok(degree));
    let triangulation = least_degree_triangulation(boundary);
    assert_eq!(triangulation.max_degree(), degree);
    let (n, triangles) = (triangulation.vertex_count(), triangulation.triangle_count());
    assert_eq!((n, triangles), (boundary.vertex_count(), n - 2));
    for pick in input.picks {
        let triangle = triangulation.triangle(pick % triangles);
        assert!(triangle.iter().all(|&v| v < n));
        assert!(triangle[0] != triangle[1] && triangle[1] != triangle[2]);
        let vertex = pick % n;
        let neighbors = triangulation.neighbors(vertex).take(1_000).count() as u32;
        assert_eq!(neighbors, triangulation.degree(vertex).min(1_000));
        assert!(triangulation.degree(vertex) <= degree);
    }
    if n <= CHECKED {
        for candidate in Candidates::new(boundary).sample(3) {
            let verified = verify(intervals, candidate.triangles());
            assert_eq!(verified.map(|verified| verified.max_degree), Ok(degree));
        }
    }
    if let Some(suggestion) = suggest(boundary, u32::from(input.target)) {
        let changed = suggestion.intervals(boundary);
        // The count is too near the limit to add more.
        let Ok(changed) = Boundary::new(&changed) else {
            assert!(changed.iter().sum::<u64>() > u64::from(mindeg_core::MAX_VERTICES));
            return;
        };
        let reached = mindeg_core::least_max_degree(&changed);
        assert_eq!(reached, suggestion.max_degree);
        assert!(reached <= u32::from(input.target));
    }
}
