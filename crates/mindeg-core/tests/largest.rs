//! Triangulations of the largest boundaries, n = 2^32 - 2 and slightly less: by windows, since all
//! triangles would take too long.

use mindeg_core::{Boundary, MAX_VERTICES, Triangulation, certificate, least_degree_triangulation};

const WIDTH: u32 = 400;

/// Some vertices or triangles at both ends and in between, up to `count`.
fn windows(count: u32) -> impl Iterator<Item = u32> {
    let starts = (0..8).map(move |part| (u64::from(count) * part / 8) as u32);
    let last = count.saturating_sub(WIDTH);
    starts.chain([last]).flat_map(move |start| start..start.saturating_add(WIDTH).min(count))
}

fn check(sides: &[u64]) {
    let boundary = Boundary::new(sides).unwrap();
    let proof = certificate(&boundary);
    assert_eq!(proof.check(sides), Ok(proof.max_degree()), "{sides:?}");
    let triangulation = least_degree_triangulation(&boundary);
    assert_eq!(triangulation.max_degree(), proof.max_degree());
    let n = boundary.vertex_count();
    assert_eq!(triangulation.triangle_count(), n - 2);
    check_triangles(&triangulation, n);
    check_vertices(&triangulation, n);
}

fn check_triangles(triangulation: &Triangulation, n: u32) {
    let mut filled = [[0; 3]; 7];
    for index in windows(n - 2) {
        let triangle = triangulation.triangle(index);
        let [a, b, c] = triangle;
        // Counter-clockwise on the ring: one step round visits them in this order.
        let steps =
            |from: u32, to: u32| (u64::from(to) + u64::from(n) - u64::from(from)) % u64::from(n);
        assert!([a, b, c].iter().all(|&v| v < n), "{triangle:?}");
        assert!(0 < steps(a, b) && steps(a, b) < steps(a, c), "{triangle:?}");
        // The same triangle from its three vertices.
        for [v, left, right] in [[a, b, c], [b, c, a], [c, a, b]] {
            if triangulation.degree(v) < 50 {
                let around: Vec<u32> = triangulation.neighbors(v).collect();
                assert!(
                    around.windows(2).any(|pair| pair == [left, right]),
                    "{triangle:?}: {around:?}"
                );
            }
        }
        if index % 97 == 0 {
            let room = filled.len().min((n - 2 - index) as usize);
            triangulation.fill_triangles(index, &mut filled[..room]);
            let one_by_one = (index..).map(|index| triangulation.triangle(index));
            assert!(filled[..room].iter().copied().eq(one_by_one.take(room)), "{index}");
        }
    }
}

fn check_vertices(triangulation: &Triangulation, n: u32) {
    for vertex in windows(n) {
        let degree = triangulation.degree(vertex);
        assert!((2..=triangulation.max_degree()).contains(&degree), "{vertex}: {degree}");
        if degree < 50 {
            let around: Vec<u32> = triangulation.neighbors(vertex).collect();
            assert_eq!(around.len() as u32, degree);
            let [next, previous] = [
                if vertex + 1 == n { 0 } else { vertex + 1 },
                if vertex == 0 { n - 1 } else { vertex - 1 },
            ];
            assert_eq!([around[0], around[around.len() - 1]], [next, previous]);
        }
    }
}

#[test]
fn the_largest_boundaries_have_their_triangulations() {
    const MOST: u64 = MAX_VERTICES as u64;
    for total in MOST - 1..=MOST {
        let half = total / 2;
        for sides in [
            // A zig-zag, a dominant side, a corner strip, and sides of every size.
            vec![half, total - half - 1, 1],
            vec![total - 2, 1, 1],
            vec![total - 7, 3, 2, 2],
            vec![total / 4, total / 4, total / 4, total - 3 * (total / 4)],
            vec![total / 3, total / 3 + 7, total - 2 * (total / 3) - 7],
            vec![half - 1000, half - 5000, 3000, total - 2 * half + 3000],
            vec![3 * (total / 8), 2 * (total / 8), total / 8, total - 6 * (total / 8)],
        ] {
            assert_eq!(sides.iter().sum::<u64>(), total);
            check(&sides);
        }
    }
}
