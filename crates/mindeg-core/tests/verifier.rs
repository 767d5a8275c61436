//! Compares the verifier with an oracle that uses geometry alone: exact areas and exact separating
//! lines on a strictly convex lattice polygon with collinear side points.

use mindeg_core::{Boundary, Candidates, verify};
use proptest::prelude::*;
use std::collections::BTreeSet;

type Point = (i64, i64);

/// Boundary points with corners on a parabola, which is convex and counter-clockwise. The scale
/// makes every point an integer.
fn points(sides: &[u64]) -> Vec<Point> {
    let scale: i64 = sides.iter().map(|&count| count as i64).product();
    let corner = |side: usize| {
        let x = (side % sides.len()) as i64;
        (x * scale, x * x * scale)
    };
    let side = |(side, &count): (usize, &u64)| {
        let ((ax, ay), (bx, by)) = (corner(side), corner(side + 1));
        let count = count as i64;
        (0..count)
            .map(move |step| (ax + (bx - ax) / count * step, ay + (by - ay) / count * step))
            .collect::<Vec<Point>>()
    };
    sides.iter().enumerate().flat_map(side).collect()
}

/// Twice the area of a triangle, positive when it is counter-clockwise.
fn area(a: Point, b: Point, c: Point) -> i64 {
    (b.0 - a.0) * (c.1 - a.1) - (b.1 - a.1) * (c.0 - a.0)
}

/// Whether all of `other` lies beyond the line along an edge of `one`. The insides of two convex
/// figures are disjoint if and only if this holds for an edge of one of them.
fn an_edge_separates(one: [Point; 3], other: [Point; 3]) -> bool {
    (0..3).any(|edge| other.iter().all(|&p| area(one[edge], one[(edge + 1) % 3], p) <= 0))
}

/// Whether the triangles tile the polygon: n - 2 disjoint triangles of positive area, with its
/// area in total.
///
/// A tiling that uses fewer vertices has fewer triangles, so the count excludes vertices inside
/// edges.
fn tiles(sides: &[u64], triangles: &[[u32; 3]]) -> bool {
    let points = points(sides);
    let n = points.len();
    if triangles.len() != n - 2 || triangles.iter().flatten().any(|&v| v as usize >= n) {
        return false;
    }
    let placed: Vec<[Point; 3]> =
        triangles.iter().map(|triangle| triangle.map(|v| points[v as usize])).collect();
    let areas = || placed.iter().map(|&[a, b, c]| area(a, b, c));
    let whole: i64 = (1..n - 1).map(|v| area(points[0], points[v], points[v + 1])).sum();
    areas().all(|area| area > 0)
        && areas().sum::<i64>() == whole
        && (0..placed.len()).all(|i| {
            (0..i).all(|j| {
                an_edge_separates(placed[i], placed[j]) || an_edge_separates(placed[j], placed[i])
            })
        })
}

/// The largest number of edges at a vertex, from a set of all edges.
fn max_degree(vertices: u32, triangles: &[[u32; 3]]) -> u32 {
    let ends = |&[a, b, c]: &[u32; 3]| [(a, b), (b, a), (b, c), (c, b), (c, a), (a, c)];
    let edges: BTreeSet<(u32, u32)> = triangles.iter().flat_map(ends).collect();
    let degree = |vertex| edges.iter().filter(|&&(from, _)| from == vertex).count() as u32;
    (0..vertices).map(degree).max().unwrap()
}

fn agree(sides: &[u64], triangles: &[[u32; 3]]) -> bool {
    let verified = verify(sides, triangles.iter().copied());
    assert_eq!(verified.is_ok(), tiles(sides, triangles), "{sides:?}: {triangles:?}");
    let Ok(verified) = verified else { return false };
    let vertices = sides.iter().sum::<u64>() as u32;
    assert_eq!(verified.max_degree, max_degree(vertices, triangles), "{sides:?}: {triangles:?}");
    true
}

/// Every list of n - 2 triangles in ascending order, repeats included.
fn check_every_list(sides: &[u64], valid: usize) {
    let vertices = sides.iter().sum::<u64>() as u32;
    let mut every = Vec::new();
    for a in 0..vertices {
        for b in a + 1..vertices {
            every.extend((b + 1..vertices).map(|c| [a, b, c]));
        }
    }
    let len = vertices as usize - 2;
    let mut choice = vec![0; len];
    let mut accepted = 0;
    loop {
        let list: Vec<[u32; 3]> = choice.iter().map(|&index| every[index]).collect();
        accepted += usize::from(agree(sides, &list));
        let Some(step) = choice.iter().rposition(|&index| index + 1 < every.len()) else { break };
        let next = choice[step] + 1;
        choice[step..].fill(next);
    }
    assert_eq!(accepted, valid, "{sides:?}");
}

#[test]
fn exactly_the_triangulations_are_accepted() {
    // On a strictly convex polygon, Catalan numbers.
    check_every_list(&[1, 1, 1], 1);
    check_every_list(&[1, 1, 1, 1], 2);
    check_every_list(&[2, 1, 1], 1);
    check_every_list(&[1, 1, 1, 1, 1], 5);
    check_every_list(&[1, 2, 2], 2);
    check_every_list(&[1; 6], 14);
    check_every_list(&[2, 2, 2], 4);
    check_every_list(&[1, 1, 3, 1], 4);
}

/// One change to a list of triangles. Most changes make it invalid.
#[derive(Clone, Debug)]
enum Edit {
    Rotate(usize),
    Reverse(usize),
    Drop(usize),
    Repeat(usize),
    Overwrite(usize, usize),
    Reorder(usize, usize),
    Rename(usize, usize, u32),
    SwapDiagonal(usize, usize),
}

fn edits() -> impl Strategy<Value = Edit> {
    let index = || any::<usize>();
    prop_oneof![
        1 => index().prop_map(Edit::Rotate),
        1 => index().prop_map(Edit::Reverse),
        1 => index().prop_map(Edit::Drop),
        1 => index().prop_map(Edit::Repeat),
        1 => (index(), index()).prop_map(|(to, from)| Edit::Overwrite(to, from)),
        1 => (index(), index()).prop_map(|(a, b)| Edit::Reorder(a, b)),
        1 => (index(), index(), any::<u32>()).prop_map(|(at, i, v)| Edit::Rename(at, i, v)),
        6 => (index(), index()).prop_map(|(a, b)| Edit::SwapDiagonal(a, b)),
    ]
}

fn apply(edit: Edit, vertices: u32, list: &mut Vec<[u32; 3]>) {
    let len = list.len();
    if len == 0 {
        return;
    }
    match edit {
        Edit::Rotate(at) => list[at % len].rotate_left(1),
        Edit::Reverse(at) => list[at % len].reverse(),
        Edit::Drop(at) => drop(list.remove(at % len)),
        Edit::Repeat(at) => list.push(list[at % len]),
        Edit::Overwrite(to, from) => list[to % len] = list[from % len],
        Edit::Reorder(a, b) => list.swap(a % len, b % len),
        Edit::Rename(at, corner, v) => list[at % len][corner % 3] = v % (vertices + 1),
        Edit::SwapDiagonal(a, corner) => {
            // In the quadrilateral p q r s with diagonal p r, replace the diagonal by q s.
            let [r, p, q] = {
                let mut triangle = list[a % len];
                triangle.rotate_left(corner % 3);
                triangle
            };
            let across = |t: &[u32; 3]| (0..3).find(|&i| (t[i], t[(i + 1) % 3]) == (p, r));
            if let Some((b, i)) = list.iter().enumerate().find_map(|(b, t)| Some((b, across(t)?))) {
                let s = list[b][(i + 2) % 3];
                list[a % len] = [p, q, s];
                list[b] = [q, r, s];
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn the_verifier_and_the_oracle_agree_on_edited_lists(
        sides in prop::collection::vec(1_u64..5, 3..7),
        candidate in any::<prop::sample::Index>(),
        swaps in prop::collection::vec((any::<usize>(), any::<usize>()), 0..20),
        edits in prop::collection::vec(edits(), 0..4),
    ) {
        let boundary = Boundary::new(&sides).unwrap();
        let vertices = boundary.vertex_count();
        let candidates: Vec<_> = Candidates::new(&boundary).sample(8).collect();
        let mut list: Vec<[u32; 3]> = candidate.get(&candidates).triangles().collect();
        // A walk through valid lists, far from the ones that this crate builds.
        for (a, corner) in swaps {
            let before = list.clone();
            apply(Edit::SwapDiagonal(a, corner), vertices, &mut list);
            if !agree(&sides, &list) {
                list = before;
            }
        }
        for edit in edits {
            apply(edit, vertices, &mut list);
            agree(&sides, &list);
        }
    }
}
