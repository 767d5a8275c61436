//! Meshes beside each other, and the mesh of the gap between them.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

use glam::DVec2;
use mindeg_condition::BoundaryDemands;
use mindeg_domain::{Constraints, Domain, Interior, Projection, Ring, Side, VertexConstraint};
use mindeg_mesh::planar::PlanarBoundary;
use mindeg_mesh::{Group, Line, LineKind, Positions, Progress, TriMesh, Triangles};

use super::depths::depths_between;
use super::gap::{self, Corner, Step, shown};
use super::overlap::Dropped;
use super::proof::{self, boundary_of, prove};
use crate::error::MeshError;
use crate::interior;

/// The name of the group of new triangles.
pub const STITCH: &str = "stitch";

/// The name of new boundary edges that nothing names.
const LAND: &str = LineKind::Land.name();
const ISLAND: &str = LineKind::Island.name();
const OPEN: &str = LineKind::Open.name();

/// The edges that a vertex may have where the gap meets a mesh.
const MOST_EDGES: u32 = 7;

/// The name and the kind of new boundary.
pub(super) type Told = (Option<String>, Option<LineKind>);

/// Meshes that were joined.
#[derive(Clone, Debug)]
pub struct Stitched {
    /// The mesh.
    pub mesh: TriMesh,
    /// The new triangles.
    pub triangles: Range<u32>,
    /// The new vertices.
    pub vertices: Range<u32>,
    /// The minimum angle of the new triangles, in degrees.
    pub min_angle: f64,
    /// The vertices of the given meshes at which the gap ended, and that lie inside now.
    pub joined: Vec<u32>,
    /// The triangles that the second mesh lost to the first.
    pub dropped: Option<Dropped>,
}

/// New vertices and triangles.
#[derive(Default)]
pub(super) struct New {
    /// In the plane of the gap.
    points: Vec<DVec2>,
    triangles: Vec<[u32; 3]>,
    lines: Vec<(String, Option<LineKind>, Vec<[u32; 2]>)>,
    pub(super) min_angle: Option<f64>,
}

/// The meshes beside each other, and what the border of the gap has besides them.
pub(super) struct Joining {
    pub(super) whole: TriMesh,
    /// The vertices in the plane of the gap.
    pub(super) points: Vec<DVec2>,
    /// The boundary vertex after each, with the mesh on the left.
    pub(super) next: BTreeMap<u32, u32>,
    /// The other points of the gap's border.
    free: Vec<DVec2>,
    /// The names and kinds of the border's edges that are of no mesh.
    told: Vec<Told>,
    projection: Option<Projection>,
    /// The name of sides along meshes, which nothing else has.
    kept: String,
}

impl Joining {
    pub(super) fn new(
        whole: TriMesh,
        free: Vec<DVec2>,
        told: Vec<Told>,
        projection: Option<&Projection>,
    ) -> Result<Self, MeshError> {
        let points = in_plane(&whole, projection);
        let next = boundary_of(whole.triangles(), &points)?;
        let names: BTreeSet<&String> = told.iter().filter_map(|told| told.0.as_ref()).collect();
        let mut kept = "mesh".to_owned();
        while names.contains(&kept) || kept == LAND || kept == ISLAND {
            kept.push('+');
        }
        Ok(Self { whole, points, next, free, told, projection: projection.copied(), kept })
    }

    fn at(&self, corner: Corner) -> DVec2 {
        match corner {
            Corner::Mesh(vertex) => self.points[vertex as usize],
            Corner::Area(vertex) => self.free[vertex as usize],
        }
    }

    /// The rings of each part of the gap, the outer one first.
    pub(super) fn parts(&self, rings: Vec<Vec<Step>>) -> Vec<Vec<Vec<Step>>> {
        let area = |ring: &Vec<Step>| -> f64 {
            let at = |index: usize| self.at(ring[index % ring.len()].0);
            (0..ring.len()).map(|i| at(i).perp_dot(at(i + 1))).sum()
        };
        let (outers, holes): (Vec<_>, Vec<_>) =
            rings.into_iter().partition(|ring| area(ring) > 0.0);
        let mut gaps: Vec<Vec<Vec<Step>>> = outers.into_iter().map(|ring| vec![ring]).collect();
        for hole in holes {
            let point = self.at(hole[0].0);
            let around = gaps.iter_mut().filter(|gap| {
                let ring: Vec<DVec2> = gap[0].iter().map(|step| self.at(step.0)).collect();
                gap::winds(&PlanarBoundary::of_mesh(&[ring]), point)
            });
            if let Some(gap) = around.min_by(|a, b| area(&a[0]).total_cmp(&area(&b[0]))) {
                gap.push(hole);
            }
        }
        gaps
    }

    /// Meshes one part of the gap.
    pub(super) fn fill(
        &self,
        rings: &[Vec<Step>],
        wanted: &Interior,
        new: &mut New,
        progress: Progress<'_>,
    ) -> Result<(), MeshError> {
        let points = |ring: &Vec<Step>| ring.iter().map(|step| self.at(step.0)).collect();
        let places: Vec<Vec<DVec2>> = rings.iter().map(points).collect();
        PlanarBoundary::new(&places).map_err(|faults| {
            let fault = faults.first();
            let corners = proof::places(&fault, rings);
            let at = |step: &Step| shown(self.at(step.0));
            let place = corners.first().map_or_else(|| fault.to_string(), at);
            MeshError::Refused(format!(
                "the gap crosses itself or a mesh near {place}: its border is too near a corner of the meshes; move the border of \
                 the area"
            ))
        })?;
        // A hole of the area that meets no mesh is an island.
        let is_island = |(index, ring): (usize, &Vec<Step>)| {
            index > 0 && ring.iter().all(|step| step.1.is_some())
        };
        let sides = rings.iter().enumerate().map(|ring| self.ring_of(ring.1, is_island(ring)));
        let domain = Domain::of_rings(sides.collect());
        let domain = domain.map_err(MeshError::refused)?;
        let has_kept = rings.iter().flatten().any(|step| step.1.is_none());
        let kept: Vec<String> = has_kept.then(|| self.kept.clone()).into_iter().collect();
        let demands = BoundaryDemands::default();
        let (domain, _) = interior::condition(&domain, &Interior::default(), &demands, &kept)?;
        let known: BTreeMap<[u64; 2], u32> = rings
            .iter()
            .flatten()
            .filter_map(|step| match step.0 {
                Corner::Mesh(vertex) => Some((bits(self.at(step.0)), vertex)),
                Corner::Area(_) => None,
            })
            .collect();
        let boundary = domain.boundary()?.into_owned();
        let given = |vertex: u32| known.get(&bits(boundary.point(vertex))).copied();
        let degrees = self.whole.degrees();
        let constraint = |vertex: u32| {
            let external_degree = degrees[given(vertex)? as usize].saturating_sub(2);
            let least = if boundary.angle(vertex) < std::f64::consts::PI { 2 } else { 3 };
            let degree_limit = Some(MOST_EDGES.max(external_degree + least));
            Some(VertexConstraint { vertex, external_degree, degree_limit })
        };
        let vertices = (0..boundary.vertex_count()).filter_map(constraint).collect();
        let domain = domain
            .with_constraints(Constraints { vertices, ..Constraints::default() })
            .map_err(MeshError::refused)?;
        let found = interior::mesh(&domain, wanted, progress)?;
        let first = self.points.len() + new.points.len();
        let mut added = Vec::new();
        let numbers: Vec<u32> = found
            .mesh
            .positions()
            .iter()
            .map(|point| {
                known.get(&bits(point.truncate())).copied().unwrap_or_else(|| {
                    added.push(point.truncate());
                    (first + added.len() - 1) as u32
                })
            })
            .collect();
        let number = |vertex: u32| numbers[vertex as usize];
        new.points.extend(added);
        new.triangles.extend(found.mesh.triangles().iter().map(|corners| corners.map(number)));
        for (index, line) in found.mesh.lines().iter().enumerate() {
            if line.name != self.kept {
                let own = line.segments.start as usize..line.segments.end as usize;
                let segments = found.mesh.segments()[own].iter().map(|ends| ends.map(number));
                let kind = found.mesh.line_kind(index);
                new.lines.push((line.name.clone(), kind, segments.collect()));
            }
        }
        let least = new.min_angle.unwrap_or(f64::INFINITY).min(found.report.min_angle);
        new.min_angle = Some(least);
        Ok(())
    }

    /// A ring with sides: along meshes, and as its border has them.
    fn ring_of(&self, steps: &[Step], is_island: bool) -> Ring {
        let (own_name, own_kind) =
            if is_island { (ISLAND, LineKind::Island) } else { (LAND, LineKind::Land) };
        let told = |border: Option<u32>| match border {
            None => (self.kept.clone(), None),
            Some(edge) => {
                let (name, kind) = &self.told[edge as usize];
                (name.clone().unwrap_or_else(|| own_name.to_owned()), kind.or(Some(own_kind)))
            }
        };
        let count = steps.len();
        let begins = |at: usize| told(steps[at].1) != told(steps[(at + count - 1) % count].1);
        let first = (0..count).find(|at| begins(*at)).unwrap_or(0);
        let mut ring = Ring::default();
        let mut inner: Vec<Vec<DVec2>> = Vec::new();
        for step in 0..count {
            let at = (first + step) % count;
            let point = self.at(steps[at].0);
            match inner.last_mut() {
                Some(side) if !begins(at) => side.push(point),
                _ => {
                    ring.corners.push(point);
                    inner.push(Vec::new());
                    let (name, kind) = told(steps[at].1);
                    ring.sides.push(Side { kind, ..Side::count(1).named(name) });
                }
            }
        }
        for (side, points) in ring.sides.iter_mut().zip(inner) {
            *side = Side { name: side.name.take(), kind: side.kind, ..Side::points(points) };
        }
        ring
    }

    /// The whole mesh, proven.
    pub(super) fn with(self, new: New) -> Result<Stitched, MeshError> {
        let Self { whole, points, next, projection, .. } = &self;
        let origin = whole.positions().first().map_or(0.0, |point| point.x);
        let degrees = |at: DVec2| match projection {
            Some(projection) => {
                let degrees = projection.to_degrees(at);
                DVec2::new(beside(degrees.x, origin), degrees.y)
            }
            None => at,
        };
        let z = whole.positions().first().map_or(0.0, |point| point.z);
        let mut positions = whole.positions().to_vec();
        positions.extend(new.points.iter().map(|point| degrees(*point).extend(z)));
        let mut triangles = whole.triangles().to_vec();
        triangles.extend(&new.triangles);
        let flat: Vec<DVec2> = positions.iter().map(|point| point.truncate()).collect();
        let boundary = boundary_of(&triangles, &flat)?;
        prove(&flat, &triangles, &boundary)?;
        let first = points.len() as u32;
        let vertices = first..first + new.points.len() as u32;
        let start = whole.triangles().len() as u32;
        let mut groups = whole.groups().to_vec();
        groups.push(Group::new(STITCH, start..triangles.len() as u32));
        // Where the gap has covered it, boundary is none any more.
        let is_covered = |ends: &[u32; 2]| {
            let runs = |map: &BTreeMap<u32, u32>, [from, to]: [u32; 2]| map.get(&from) == Some(&to);
            let both = [*ends, [ends[1], ends[0]]];
            both.iter().any(|ends| runs(next, *ends))
                && !both.iter().any(|ends| runs(&boundary, *ends))
        };
        let mut lines: Vec<OwnLine> = Vec::new();
        for (index, line) in whole.lines().iter().enumerate() {
            let own = line.segments.start as usize..line.segments.end as usize;
            let left: Vec<[u32; 2]> =
                whole.segments()[own].iter().copied().filter(|ends| !is_covered(ends)).collect();
            for piece in left.chunk_by(|a, b| a[1] == b[0]) {
                lines.push((line.name.clone(), whole.line_kind(index), piece.to_vec()));
            }
        }
        lines.extend(new.lines);
        let lines = with_whole_stretches(lines, &boundary);
        let (mut of_lines, mut kinds, mut segments) = (Vec::new(), Vec::new(), Vec::new());
        for (name, kind, own) in lines {
            let from = segments.len() as u32;
            segments.extend(own);
            of_lines.push(Line { name, segments: from..segments.len() as u32, is_straight: false });
            kinds.push(kind);
        }
        let mut depths = vec![0.0; points.len()];
        whole.fill_depths(0, &mut depths);
        let mesh = TriMesh::new(positions, triangles)?
            .with_groups(groups)
            .with_lines(of_lines, segments)?
            .with_line_kinds(kinds)
            .with_named_vertices(whole.named_vertices().to_vec())?;
        let mesh = mesh.called(whole.name());
        let mesh = match whole.has_depths() {
            true => mesh.with_depths(depths_between(depths, &flat, &new.triangles)),
            false => mesh,
        };
        let joined = next.keys().copied().filter(|vertex| !boundary.contains_key(vertex)).collect();
        let min_angle = new.min_angle.unwrap_or(60.0);
        let triangles = start..mesh.triangles().len() as u32;
        Ok(Stitched { mesh, triangles, vertices, min_angle, joined, dropped: None })
    }
}

type OwnLine = (String, Option<LineKind>, Vec<[u32; 2]>);

/// Lines with each stretch of open water along the boundary as one, from behind what is not open: called as all of it was, or else
/// "open".
fn with_whole_stretches(lines: Vec<OwnLine>, boundary: &BTreeMap<u32, u32>) -> Vec<OwnLine> {
    let runs = |[from, to]: [u32; 2]| boundary.get(&from) == Some(&to);
    let (mut open, mut rest): (BTreeMap<u32, String>, Vec<OwnLine>) = Default::default();
    for (name, kind, segments) in lines {
        let mut other = Vec::new();
        for [a, b] in segments {
            match [[a, b], [b, a]].into_iter().find(|ends| runs(*ends)) {
                Some([from, _]) if kind == Some(LineKind::Open) => {
                    open.insert(from, name.clone());
                }
                _ => other.push([a, b]),
            }
        }
        if !other.is_empty() {
            rest.push((name, kind, other));
        }
    }
    let before: BTreeMap<u32, u32> = boundary.iter().map(|(from, to)| (*to, *from)).collect();
    let mut left: BTreeSet<u32> = open.keys().copied().collect();
    while let Some(&any) = left.first() {
        let mut first = any;
        while let Some(at) = before.get(&first).filter(|at| **at != any && open.contains_key(at)) {
            first = *at;
        }
        let along = std::iter::successors(Some(first), |from| boundary.get(from).copied());
        let along: Vec<u32> = along.take_while(|from| left.remove(from)).collect();
        let name = &open[&first];
        let is_one = along.iter().all(|from| open[from] == *name);
        let name = if is_one { name.clone() } else { OPEN.to_owned() };
        let segments = along.iter().map(|from| [*from, boundary[from]]).collect();
        rest.push((name, Some(LineKind::Open), segments));
    }
    rest
}

/// The longitude that is nearest to another one.
pub(super) fn beside(longitude: f64, other: f64) -> f64 {
    longitude + 360.0 * ((other - longitude) / 360.0).round()
}

/// The vertices of a mesh in the plane of a projection, if there is one.
pub(super) fn in_plane(mesh: &TriMesh, projection: Option<&Projection>) -> Vec<DVec2> {
    let plane = |at: DVec2| projection.map_or(at, |projection| projection.to_plane(at));
    mesh.positions().iter().map(|point| plane(point.truncate())).collect()
}

fn bits(at: DVec2) -> [u64; 2] {
    at.to_array().map(f64::to_bits)
}
