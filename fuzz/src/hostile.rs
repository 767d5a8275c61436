//! Inputs that several targets read from the bytes of the fuzzer, and checks that they share.

use arbitrary::{Arbitrary, Result, Unstructured};
use glam::DVec2;
use robust::{Coord, orient2d};
use std::collections::{BTreeMap, BTreeSet};

/// A number that geometry finds hard: a whole number, or one a few units in the last place beside it, a
/// boundary of the range, or any at all.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hostile(pub(crate) f64);

impl<'a> Arbitrary<'a> for Hostile {
    fn arbitrary(bytes: &mut Unstructured<'a>) -> Result<Self> {
        const EDGES: [f64; 24] = [
            0.0,
            -0.0,
            f64::MIN_POSITIVE,
            5e-324,
            f64::EPSILON,
            1e-300,
            1e-150,
            1e-70,
            1e-16,
            1e-9,
            1e-6,
            0.1,
            1.0 / 3.0,
            0.5,
            1e9,
            4_294_967_294.0,
            9_007_199_254_740_993.0,
            1e70,
            1e150,
            1e300,
            f64::MAX,
            f64::INFINITY,
            f64::NEG_INFINITY,
            f64::NAN,
        ];
        let kind = u8::arbitrary(bytes)?;
        Ok(Self(match kind % 8 {
            0..=3 => f64::from(i8::arbitrary(bytes)?),
            4 => near(f64::from(i8::arbitrary(bytes)?), i8::arbitrary(bytes)?),
            5 => f64::from(i16::arbitrary(bytes)?) / 256.0,
            6 => {
                let edge = EDGES[usize::from(u8::arbitrary(bytes)?) % EDGES.len()];
                if kind >= 128 { -edge } else { edge }
            }
            _ => f64::from_bits(u64::arbitrary(bytes)?),
        }))
    }
}

/// The number so many units in the last place above another, or below.
fn near(mut number: f64, units: i8) -> f64 {
    for _ in 0..units.unsigned_abs().min(4) {
        number = if units > 0 { number.next_up() } else { number.next_down() };
    }
    number
}

/// A point on a small grid, or a few units in the last place beside it: rings of such points touch
/// and nearly touch.
#[derive(Clone, Copy, Debug)]
pub(crate) struct GridPoint(pub(crate) DVec2);

impl<'a> Arbitrary<'a> for GridPoint {
    fn arbitrary(bytes: &mut Unstructured<'a>) -> Result<Self> {
        let [x, y, beside] = <[u8; 3]>::arbitrary(bytes)?;
        let on_grid = |place: u8| f64::from(place % 32) / if place >= 128 { 7.0 } else { 1.0 };
        // Two bits for each coordinate: nothing, above, below.
        let units = |bits: u8| [0, 0, 1, -1][usize::from(bits % 4)];
        // Beside 0 products underflow, and no predicate is exact.
        let place = |at: f64, bits: u8| if at == 0.0 { at } else { near(at, units(bits)) };
        Ok(Self(DVec2::new(place(on_grid(x), beside), place(on_grid(y), beside >> 2))))
    }
}

/// A star-shaped ring, counter-clockwise, with a point in each of many directions: always simple.
pub(crate) fn star(radii: &[u8], center: DVec2) -> Vec<DVec2> {
    let step = std::f64::consts::TAU / radii.len() as f64;
    let point = |(index, &radius): (usize, &u8)| {
        let angle = step * index as f64;
        center + DVec2::from_angle(angle) * (1.0 + f64::from(radius) / 16.0)
    };
    radii.iter().enumerate().map(point).collect()
}

/// Whether the edges of rings have nothing in common but the ends of neighbours, tested pair by pair and
/// exactly: an oracle for sweeps.
pub(crate) fn rings_are_simple(rings: &[Vec<DVec2>]) -> bool {
    let edges: Vec<(usize, usize, [DVec2; 2])> = rings
        .iter()
        .enumerate()
        .flat_map(|(r, ring)| {
            (0..ring.len()).map(move |i| (r, i, [ring[i], ring[(i + 1) % ring.len()]]))
        })
        .collect();
    edges.iter().enumerate().all(|(index, (r, i, [a, b]))| {
        a != b
            && edges[..index].iter().all(|(s, j, [c, d])| {
                let n = rings[*r].len();
                if r == s && (j + 1) % n == *i {
                    // c, d = a, b: they share a point, and may not fold back onto each other.
                    return !is_on([*c, *d], *b) && !is_on([*a, *b], *c);
                }
                if r == s && (i + 1) % n == *j {
                    return !is_on([*a, *b], *d) && !is_on([*c, *d], *a);
                }
                !meet([*a, *b], [*c, *d])
            })
    })
}

/// The sign of the turn from a over b to c, exactly.
pub(crate) fn turn(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    let [a, b, c] = [a, b, c].map(|point| Coord { x: point.x, y: point.y });
    orient2d(a, b, c)
}

fn is_on([a, b]: [DVec2; 2], point: DVec2) -> bool {
    let (low, high) = (a.min(b), a.max(b));
    turn(a, b, point) == 0.0 && point.cmpge(low).all() && point.cmple(high).all()
}

fn meet([a, b]: [DVec2; 2], [c, d]: [DVec2; 2]) -> bool {
    let sides = |p: DVec2, q: DVec2, r: DVec2, s: DVec2| {
        let [x, y] = [turn(p, q, r), turn(p, q, s)];
        (x > 0.0 && y < 0.0) || (x < 0.0 && y > 0.0)
    };
    (sides(a, b, c, d) && sides(c, d, a, b))
        || is_on([a, b], c)
        || is_on([a, b], d)
        || is_on([c, d], a)
        || is_on([c, d], b)
}

/// Fails unless triangles, by position, fill what boundary edges bound: each counter-clockwise, edge to
/// edge, with these boundary edges and no others.
pub(crate) fn assert_fills(points: &[DVec2], triangles: &[[u32; 3]], boundary: &[[u32; 2]]) {
    let mut halves = BTreeMap::new();
    for &[a, b, c] in triangles {
        let [p, q, r] = [a, b, c].map(|v| points[v as usize]);
        assert!(turn(p, q, r) > 0.0, "triangle {a} {b} {c} is not counter-clockwise");
        for half in [[a, b], [b, c], [c, a]] {
            assert!(halves.insert(half, ()).is_none(), "two triangles at {half:?}");
        }
    }
    let open: BTreeSet<[u32; 2]> =
        halves.keys().filter(|[a, b]| !halves.contains_key(&[*b, *a])).copied().collect();
    assert_eq!(open, boundary.iter().copied().collect(), "boundary edges");
}
