//! Domains with holes to test with, and all triangulations of the small ones, by definition.

pub(crate) use crate::outlines::Random;
use crate::outlines::{on, touch, turn};
use glam::DVec2;
use mindeg_exact::check::CheckedOutline;
use mindeg_exact::check::refutation::CheckedFace;
use mindeg_exact::{Problem, measure};
use mindeg_mesh::check;
use mindeg_mesh::planar::PlanarBoundary;
use std::ops::Range;

/// A domain by its rings, the outer one first, each with the domain on its left.
#[derive(Clone, Debug)]
pub(crate) struct Holed {
    pub(crate) points: Vec<DVec2>,
    pub(crate) rings: Vec<Range<u32>>,
    side_of: Vec<u32>,
    vertices: Vec<u32>,
}

impl Holed {
    /// Rings that may run either way.
    pub(crate) fn new(rings: &[&[(i32, i32)]]) -> Self {
        let (mut points, mut ranges) = (Vec::new(), Vec::new());
        for (index, ring) in rings.iter().enumerate() {
            let mut ring: Vec<DVec2> =
                ring.iter().map(|&(x, y)| DVec2::new(x.into(), y.into())).collect();
            let after = ring.iter().cycle().skip(1);
            let area: f64 = ring.iter().zip(after).map(|(a, b)| a.perp_dot(*b)).sum();
            if (area > 0.0) != (index == 0) {
                ring.reverse();
            }
            ranges.push(points.len() as u32..(points.len() + ring.len()) as u32);
            points.extend(ring);
        }
        let vertices = (0..points.len() as u32).collect();
        let mut domain = Self { points, rings: ranges, side_of: Vec::new(), vertices };
        domain.side_of = domain.boundary().runs().to_vec();
        domain
    }

    fn random(random: &mut Random) -> Option<Self> {
        let ring = |random: &mut Random, radius: u64, center: (i32, i32)| {
            let corners = 3 + random.below(4) as u32;
            let at = |corner: u32| {
                let radius = (radius / 3 + 1 + random.below(radius)) as f64;
                let angle = std::f64::consts::TAU * f64::from(corner) / f64::from(corners);
                let [x, y] = [libm::cos(angle), libm::sin(angle)].map(|it| (it * radius) as i32);
                (center.0 + x, center.1 + y)
            };
            (0..corners).map(at).collect::<Vec<_>>()
        };
        let mut rings = vec![ring(random, 30, (0, 0))];
        for _ in 0..=random.below(3) / 2 {
            let center = [0; 2].map(|_: u32| random.below(16) as i32 - 8);
            rings.push(ring(random, 8, (center[0], center[1])));
        }
        let total: usize = rings.iter().map(Vec::len).sum();
        let slices: Vec<&[(i32, i32)]> = rings.iter().map(Vec::as_slice).collect();
        let slices_of = |ring: &&[(i32, i32)]| {
            ring.iter().map(|&(x, y)| DVec2::new(x.into(), y.into())).collect::<Vec<_>>()
        };
        let mut points: Vec<Vec<DVec2>> = slices.iter().map(slices_of).collect();
        for (index, ring) in points.iter_mut().enumerate() {
            let area: f64 =
                ring.iter().zip(ring.iter().cycle().skip(1)).map(|(a, b)| a.perp_dot(*b)).sum();
            if (area > 0.0) != (index == 0) {
                ring.reverse();
            }
        }
        let borrowed: Vec<&[DVec2]> = points.iter().map(Vec::as_slice).collect();
        (total <= 11 && PlanarBoundary::new(&borrowed).is_ok()).then(|| Self::new(&slices))
    }

    fn boundary(&self) -> PlanarBoundary {
        let ring = |ring: &Range<u32>| &self.points[ring.start as usize..ring.end as usize];
        PlanarBoundary::new(&self.rings.iter().map(ring).collect::<Vec<_>>()).unwrap()
    }

    pub(crate) fn problem(&self) -> Problem {
        let mut first = Vec::new();
        self.visit(&mut |triangles| {
            first = triangles.to_vec();
            false
        });
        Problem::triangulated(&self.boundary(), &first).unwrap()
    }

    /// The domain as the checker takes it.
    pub(crate) fn checked(&self, least_tangent: f64) -> CheckedFace<'_> {
        let (points, rings, side_of) = (&self.points, &self.rings, &self.side_of);
        let outline = CheckedOutline { points, rings, side_of, keeps_clear: true };
        CheckedFace { outline, vertices: &self.vertices, least_tangent }
    }

    /// The chords at every vertex of a triangulation, and the least tangent of an angle.
    pub(crate) fn measured(&self, triangles: &[[u32; 3]]) -> (Vec<u32>, f64) {
        let checked = check::triangulation(&self.boundary(), &[], triangles).unwrap();
        let corners = |triangle: &[u32; 3]| triangle.map(|v| self.points[v as usize]);
        let tangents = triangles.iter().map(|it| measure::min_angle_tangent(corners(it)));
        let chords = checked.degrees.iter().map(|degree| degree - 2).collect();
        (chords, tangents.fold(f64::INFINITY, f64::min))
    }

    pub(crate) fn triangulations(&self) -> Vec<Vec<[u32; 3]>> {
        let mut all = Vec::new();
        self.visit(&mut |triangles| {
            all.push(triangles.to_vec());
            true
        });
        all
    }

    /// Calls `visit` with every triangulation until it is false.
    fn visit(&self, visit: &mut dyn FnMut(&[[u32; 3]]) -> bool) {
        let edges = self.edges();
        let n = self.points.len() as u32;
        let mut may_join = vec![vec![false; n as usize]; n as usize];
        for (a, b) in (0..n).flat_map(|a| (0..n).map(move |b| (a, b))).filter(|(a, b)| a != b) {
            let is_edge = edges.contains(&[a, b]) || edges.contains(&[b, a]);
            may_join[a as usize][b as usize] = is_edge || self.is_visible(a, b);
        }
        let mut state = State { domain: self, may_join, used: Vec::new(), triangles: Vec::new() };
        state.fill(edges, visit);
    }

    fn edges(&self) -> Vec<[u32; 2]> {
        let ring = |ring: &Range<u32>| {
            let Range { start, end } = *ring;
            (start..end).map(move |v| [v, if v + 1 == end { start } else { v + 1 }])
        };
        self.rings.iter().flat_map(ring).collect()
    }

    /// Whether the open segment between two vertices lies in the open interior.
    fn is_visible(&self, a: u32, b: u32) -> bool {
        let [p, q] = [a, b].map(|v| self.points[v as usize]);
        let crosses = self.edges().iter().any(|edge| {
            let ends = edge.map(|v| self.points[v as usize]);
            !edge.contains(&a) && !edge.contains(&b) && touch([p, q], ends)
        });
        let n = self.points.len() as u32;
        let passes = (0..n).any(|v| v != a && v != b && on(self.points[v as usize], [p, q]));
        // The middle lies inside: a ray to the right crosses an odd number of edges.
        let middle = (p + q) / 2.0;
        let is_crossed = |edge: &&[u32; 2]| {
            let [r, s] = edge.map(|v| self.points[v as usize]);
            let (low, high) = if r.y < s.y { (r, s) } else { (s, r) };
            low.y <= middle.y && middle.y < high.y && turn(low, high, middle) > 0.0
        };
        !crosses && !passes && self.edges().iter().filter(is_crossed).count() % 2 == 1
    }
}

/// Some triangles of a domain, and the directed edges that they have.
struct State<'a> {
    domain: &'a Holed,
    may_join: Vec<Vec<bool>>,
    used: Vec<[u32; 2]>,
    triangles: Vec<[u32; 3]>,
}

impl State<'_> {
    /// Puts a triangle on the left of the last open edge, in every way; false to end.
    fn fill(
        &mut self,
        mut open: Vec<[u32; 2]>,
        visit: &mut dyn FnMut(&[[u32; 3]]) -> bool,
    ) -> bool {
        let Some([a, b]) = open.pop() else { return visit(&self.triangles) };
        let at = |v: u32| self.domain.points[v as usize];
        let n = self.domain.points.len() as u32;
        for c in 0..n {
            let is_empty = |&v: &u32| {
                let sides = [[a, b], [b, c], [c, a]];
                [a, b, c].contains(&v)
                    || sides.iter().any(|&[from, to]| turn(at(from), at(to), at(v)) < 0.0)
            };
            let joins = |v: u32| self.may_join[v as usize][c as usize];
            let fits = c != a
                && c != b
                && joins(a)
                && joins(b)
                && turn(at(a), at(b), at(c)) > 0.0
                && (0..n).all(|v| is_empty(&v))
                && [[b, c], [c, a]].iter().all(|&side| self.is_free(side));
            if !fits {
                continue;
            }
            let mut next = open.clone();
            for [from, to] in [[b, c], [c, a]] {
                match next.iter().position(|&edge| edge == [from, to]) {
                    Some(index) => drop(next.remove(index)),
                    None => next.push([to, from]),
                }
            }
            self.used.extend([[a, b], [b, c], [c, a]]);
            self.triangles.push([a, b, c]);
            let goes_on = self.fill(next, visit);
            self.triangles.pop();
            self.used.truncate(self.used.len() - 3);
            if !goes_on {
                return false;
            }
        }
        true
    }

    /// Whether a directed edge is free, and crosses none.
    fn is_free(&self, [a, b]: [u32; 2]) -> bool {
        let at = |v: u32| self.domain.points[v as usize];
        // The domain is not on the right of its boundary.
        !self.used.contains(&[a, b])
            && !self.domain.edges().contains(&[b, a])
            && self.used.iter().all(|&[c, d]| {
                let shares = [a, b].contains(&c) || [a, b].contains(&d);
                shares || !touch([at(a), at(b)], [at(c), at(d)])
            })
    }
}

/// Calls `test` with random domains of one or two holes.
pub(crate) fn for_random(seed: u64, count: usize, mut test: impl FnMut(&Holed, &mut Random)) {
    let mut random = Random(seed);
    let mut done = 0;
    while done < count {
        if let Some(domain) = Holed::random(&mut random) {
            test(&domain, &mut random);
            done += 1;
        }
    }
}
