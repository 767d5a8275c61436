//! Narrow places and limits in turn, until nothing changes: what lifts a limit may make a place narrow, and what closes one may
//! leave a sharp corner.

use crate::chains::{Chains, is_closed};
use crate::changes::{BoundaryChange, Conditioned, Point};
use crate::demands::{BoundaryDemands, Given, Hold};
use crate::error::ConditionError;
use crate::narrow::{Narrowed, Rules, narrowed};
use crate::past::Past;
use crate::round::{Round, checked, of_wide};
use mindeg_mesh::planar::PlanarBoundary;

/// So many rounds at most; hardly a coast takes more than three.
const ROUNDS: usize = 8;

/// A boundary between two changes, and what its edges and vertices are of the given one.
struct Stage {
    boundary: PlanarBoundary,
    /// The given vertex that each vertex is.
    vertices: Vec<Option<u32>>,
    /// The first point of each edge, as one of the given boundary.
    edges: Vec<Point>,
}

impl Stage {
    fn first(boundary: &PlanarBoundary) -> Self {
        let all = boundary.vertex_count() + boundary.inner_points().len() as u32;
        let vertices = (0..all).map(Some).collect();
        let first = |edge: u32| {
            let of = boundary.ends(edge)[0];
            Point { at: boundary.point(of), of: Some(of), edge }
        };
        let edges = (0..boundary.edge_count()).map(first).collect();
        Self { boundary: boundary.clone(), vertices, edges }
    }

    /// A new boundary, proven, with its rings, lines and vertices as points of this one.
    fn next(
        &self,
        (boundary, own): (PlanarBoundary, Vec<Point>),
        rings: &[Vec<Point>],
        lines: &[Vec<Point>],
    ) -> Self {
        let vertices = own.iter().map(|point| self.given_vertex(point)).collect();
        let of_line = |(line, points): (usize, &Vec<Point>)| {
            let edges = points.len() - usize::from(!is_closed(self.boundary.line(line)));
            points[..edges].to_vec()
        };
        let of_lines = lines.iter().enumerate().flat_map(of_line);
        let firsts = rings.iter().flatten().copied().chain(of_lines);
        let edges = firsts.map(|point| self.given(point)).collect();
        Self { boundary, vertices, edges }
    }

    fn given_vertex(&self, point: &Point) -> Option<u32> {
        self.vertices[point.of? as usize]
    }

    fn given_edge(&self, edge: u32) -> u32 {
        self.edges[edge as usize].edge
    }

    fn given(&self, point: Point) -> Point {
        Point { of: self.given_vertex(&point), edge: self.given_edge(point.edge), ..point }
    }

    /// The rules of the given boundary for this one: a new point may go.
    fn told<'a, H, D, S>(
        &'a self,
        given: &'a Given<'_, H, D, S>,
    ) -> Given<
        'a,
        impl Fn(u32) -> Hold + use<'a, H, D, S>,
        impl Fn(u32) -> [bool; 2] + use<'a, H, D, S>,
        impl Fn(u32) -> bool + use<'a, H, D, S>,
    >
    where
        H: Fn(u32) -> Hold,
        D: Fn(u32) -> [bool; 2],
        S: Fn(u32) -> bool,
    {
        let hold = |edge: u32| {
            let hold = (given.hold)(self.given_edge(edge));
            let is_new = self.edges[edge as usize].of.is_none();
            if is_new && hold < Hold::Edge { Hold::Free } else { hold }
        };
        Given {
            hold,
            has_domain: |edge| (given.has_domain)(self.given_edge(edge)),
            is_straight: |edge| (given.is_straight)(self.given_edge(edge)),
            size_at: given.size_at,
            marks: given.marks,
        }
    }

    /// The past of the vertices of other rings, and of these lines, from that of the vertices of this one.
    fn past(&self, rings: &[Vec<Point>], past: &[Past]) -> Vec<Past> {
        let on_rings = self.boundary.vertex_count() as usize;
        let of_ring = |ring: &Vec<Point>| -> Vec<Past> {
            let own = |(point, next): (&Point, &Point)| {
                let Some(of) = point.of else { return Past::default() };
                let is_edge = next.of == Some(self.boundary.next(of));
                let mut own = past[of as usize].clone();
                if !is_edge {
                    own.dropped.clear();
                }
                own
            };
            ring.iter().zip(ring.iter().cycle().skip(1)).map(own).collect()
        };
        rings.iter().flat_map(of_ring).chain(past[on_rings..].iter().cloned()).collect()
    }
}

/// [`crate::condition_map`] with a least width.
pub(crate) fn of_narrow<H, D, S>(
    boundary: &PlanarBoundary,
    demands: &BoundaryDemands,
    given: &Given<'_, H, D, S>,
) -> Result<Conditioned, ConditionError>
where
    H: Fn(u32) -> Hold,
    D: Fn(u32) -> [bool; 2],
    S: Fn(u32) -> bool,
{
    let before = Chains::new(boundary, given, demands.least_triangles).limit_of_all();
    let mut stage = Stage::first(boundary);
    let mut last: Option<(Conditioned, Vec<Past>)> = None;
    let mut round = 0;
    loop {
        round += 1;
        let told = stage.told(given);
        let Given { hold, has_domain, marks, .. } = &told;
        let rules = Rules { width: demands.narrowest, hold, has_domain, marks };
        let Narrowed { rings, changes, narrow } = narrowed(&stage.boundary, &rules)?;
        let is_wide = changes.is_empty();
        let mut earlier = None;
        let mut past = None;
        if let Some((found, own)) = last {
            if is_wide || round > ROUNDS {
                return Ok(Conditioned { narrow, ..found });
            }
            past = Some(stage.past(&rings, &own));
            earlier = Some(found);
        }
        let mut wide = None;
        if !is_wide {
            let (_, lines) = Chains::new(&stage.boundary, &told, demands.least_triangles).points();
            let proven = checked(&stage.boundary, &rings, &lines)?;
            wide = Some(stage.next(proven, &rings, &lines));
        }
        drop(told);
        stage = wide.unwrap_or(stage);
        let Round { found, past, checked: proven } =
            of_wide(&stage.boundary, demands, &stage.told(given), past.as_deref())?;
        let given_chains = |chains: &[Vec<Point>]| -> Vec<Vec<Point>> {
            let chain =
                |chain: &Vec<Point>| chain.iter().map(|point| stage.given(*point)).collect();
            chains.iter().map(chain).collect()
        };
        let (rings, lines) = (given_chains(&found.rings), given_chains(&found.lines));
        let given_change = |change: &BoundaryChange| {
            let edge = change.edge.map(|edge| stage.given_edge(edge));
            BoundaryChange { edge, ..*change }
        };
        let made = found.changes.iter().map(given_change);
        let (known, moved) = earlier.map_or((Vec::new(), 0.0), |it| (it.changes, it.moved));
        let changes = known.into_iter().chain(changes).chain(made).collect();
        let moved = found.moved.max(moved);
        let next = stage.next(proven, &found.rings, &found.lines);
        last = Some((Conditioned { rings, lines, changes, narrow, before, moved, ..found }, past));
        stage = next;
    }
}
