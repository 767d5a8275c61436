//! Meshes of maps from their points alone: the faces between lines are one problem, in which degrees count all of them.
//!
//! Limits: those of [models](crate::model); a face with points or lines inside, or one that touches itself, is improved by
//! flips, and proofs know no more of it than the number of its edges.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

use mindeg_domain::Domain;
use mindeg_mesh::Progress;
use mindeg_mesh::planar::{Border, PlanarBoundary, Turn, straight_runs, turn};

use crate::boundary_mesh::BoundaryMesh;
use crate::error::MeshError;
use crate::meshed::{FoundBy, Meshed};
use crate::model::bound::{JointBound, cheap};
use crate::model::face::PlaneFace;
use crate::model::joint::Joint;
use crate::model::solve::solve;
use crate::trade_off::{ExactMesh, TradeOff, keeps};
use crate::windowed::SHARES;

/// The work that one degree may take, as a share of that of a model: below a second.
const WORK: f64 = 0.0625;

/// Where several meshes are tried, the share of the work of one.
const TRY: f64 = 0.125;

/// A mesh that keeps limits of single vertices is looked for up to so many degrees above one that does not.
const MORE: u32 = 3;

/// A mesh of a map, and what is known of its degrees.
pub(crate) struct MapMesh {
    pub(crate) mesh: BoundaryMesh,
    /// Why no mesh, or none whose angles are as large as was asked for, has a smaller maximum degree.
    pub(crate) bound: JointBound,
    /// No mesh has a smaller maximum degree, whatever its angles and the limits of single vertices.
    at_least: u32,
    /// Whether no vertex is above its own limit.
    keeps_limits: bool,
    /// The rings of each face that is no hole, the outer one first, by vertices.
    pub(crate) rings: Vec<Vec<Vec<u32>>>,
    /// The minimum angle of the Delaunay triangulations of all faces, in degrees.
    delaunay_min_angle: f64,
}

impl MapMesh {
    pub(crate) fn max_degree(&self) -> u32 {
        self.mesh.max_total_degree()
    }

    fn meshed(self, share: f64) -> Meshed {
        Meshed {
            least_max_degree: self.at_least,
            is_least_proven: self.at_least == self.max_degree(),
            found_by: FoundBy::Windows { share },
            delaunay_min_angle: Some(self.delaunay_min_angle),
            mesh: self.mesh,
        }
    }
}

/// The mesh of a map whose angles are at least `share` of the minimum angle of Delaunay triangulations of its faces. The
/// work on its degree ends at `limit`; `effort` is how long to look for each degree. Limits of single vertices count
/// where they are below `limit`, so they need one.
///
/// # Errors
///
/// A face whose points are too close to triangulate; a `progress` that cancels.
fn mesh_map(
    domain: &Domain,
    share: f64,
    limit: u32,
    effort: f64,
    progress: Progress<'_>,
) -> Result<MapMesh, MeshError> {
    let Posed { mut joint, vertices: of_face, numbers } = posed(domain, progress)?;
    joint.keep_least(share);
    let delaunay_min_angle = libm::atan(joint.delaunay_tangent()).to_degrees();
    let any = cheap(&joint);
    // A vertex that may have two edges less than all others has two from the start.
    let mut limits: BTreeMap<u32, u32> = BTreeMap::new();
    for (vertex, own) in vertex_limits(domain).filter(|(_, own)| *own < limit) {
        let least = limits.entry(numbers[vertex as usize]).or_insert(own);
        *least = own.min(*least);
    }
    limits.iter().for_each(|(&vertex, own)| joint.raise(vertex, limit - own));
    let is_limited = !limits.is_empty();
    let bound = solve(&mut joint, limit, WORK * effort, progress)?;
    let at_least = if share > 0.0 || is_limited { any.max_degree() } else { bound.max_degree() };
    // A bound with limits says nothing of meshes without.
    let bound = match if is_limited { any } else { bound } {
        JointBound::Edges { vertex, edges } => {
            let own = numbers.iter().position(|&number| number == vertex).unwrap_or_default();
            JointBound::Edges { vertex: own as u32, edges }
        }
        bound => bound,
    };
    let mut triangles = Vec::new();
    let mut rings = Vec::with_capacity(joint.face_count());
    for (face, own) in joint.triangles.iter().enumerate() {
        let (vertices, boundary) = (&of_face[face], &joint.face(face).boundary);
        let of_map = |triangle: &[u32; 3]| triangle.map(|place| vertices[place as usize]);
        triangles.extend(own.iter().map(of_map));
        let ring = |ring: Range<u32>| vertices[ring.start as usize..ring.end as usize].to_vec();
        rings.push(boundary.rings().map(ring).collect());
    }
    let mesh = BoundaryMesh::with_triangles(domain, triangles)?;
    let keeps_limits = vertex_limits(domain).all(|(vertex, own)| mesh.total_degree(vertex) <= own);
    Ok(MapMesh { mesh, bound, at_least, keeps_limits, rings, delaunay_min_angle })
}

/// The limits of single vertices, with these.
fn vertex_limits(domain: &Domain) -> impl Iterator<Item = (u32, u32)> {
    let on_rings = if domain.is_constrained() { domain.rings().vertex_count() } else { 0 };
    (0..on_rings).filter_map(|vertex| Some((vertex, domain.degree_limit(vertex)?)))
}

/// The mesh of the least degree that is found with a share of Delaunay's minimum angle, down to a limit, and that keeps
/// the limits of single vertices.
///
/// # Errors
///
/// The errors of [`mesh_map`], and limits that no mesh is found to keep.
fn lowest(
    domain: &Domain,
    share: f64,
    limit: u32,
    effort: f64,
    progress: Progress<'_>,
) -> Result<MapMesh, MeshError> {
    let free = mesh_map(domain, share, limit, effort, progress)?;
    if free.keeps_limits {
        return Ok(free);
    }
    let least = free.at_least.max(limit);
    for degree in least..=free.max_degree().max(least) + MORE {
        let kept = mesh_map(domain, share, degree, effort, progress)?;
        if kept.keeps_limits && kept.max_degree() <= degree {
            return Ok(MapMesh { bound: free.bound, at_least: free.at_least, ..kept });
        }
    }
    Err(MeshError::LimitsNotReached)
}

/// The mesh of the least degree that is found, with a larger angle if short tries find one.
pub(crate) fn least_degree(domain: &Domain, progress: Progress<'_>) -> Result<Meshed, MeshError> {
    larger(domain, least(domain, 0, 1.0, progress)?, TRY, progress)
}

/// The mesh of the least degree that is found, with the angle of [`max_degree`].
pub(crate) fn optimize(domain: &Domain, progress: Progress<'_>) -> Result<Meshed, MeshError> {
    larger(domain, least(domain, 0, 1.0, progress)?, 1.0, progress)
}

/// A mesh of the degree of one that was found, with a larger angle if tries find it; `effort` is how long to look with less than all
/// of the angle.
fn larger(
    domain: &Domain,
    found: MapMesh,
    effort: f64,
    progress: Progress<'_>,
) -> Result<Meshed, MeshError> {
    let limit = found.max_degree();
    // Where all of the angle goes with this degree, that shows soon.
    let larger = match within(domain, [1.0], limit, 1.0, progress)? {
        None => within(domain, wider().skip(1), limit, effort, progress)?,
        all => all,
    };
    let found = found.meshed(0.0);
    Ok(match larger {
        Some(larger) => larger.with_bound_of(&found),
        None => found,
    })
}

/// The mesh of the least degree that is found, down to a limit.
///
/// # Errors
///
/// The errors of [`mesh_map`].
pub(crate) fn least(
    domain: &Domain,
    limit: u32,
    effort: f64,
    progress: Progress<'_>,
) -> Result<MapMesh, MeshError> {
    let mut best = lowest(domain, 0.0, limit, effort, progress)?;
    // A search that aims far below what is possible may end above what one for the next degree reaches.
    while best.max_degree() > best.at_least.max(limit) + 1 {
        let next = mesh_map(domain, 0.0, best.max_degree() - 1, effort, progress)?;
        if next.max_degree() >= best.max_degree() || !next.keeps_limits {
            break;
        }
        best.mesh = next.mesh;
    }
    Ok(best)
}

/// The mesh of the least degree that is found with a share of Delaunay's minimum angle, 0 to 1.
pub(crate) fn keep_angle(
    domain: &Domain,
    share: f64,
    progress: Progress<'_>,
) -> Result<Meshed, MeshError> {
    let kept = lowest(domain, share, 0, 1.0, progress)?;
    let at_least = kept.at_least;
    // The first is the mesh that the trade-off has at its degree.
    let enough = || SHARES.into_iter().filter(|&more| more > share).chain([share]);
    let first = kept.max_degree();
    let mut best = within(domain, enough(), first, 1.0, progress)?;
    // A search that aims far below what is possible may end above what one for the next degree reaches.
    let mut degree = best.as_ref().map_or(first, |best| best.mesh.max_total_degree());
    while degree > at_least {
        let Some(lower) = within(domain, enough(), degree - 1, 1.0, progress)? else { break };
        degree = lower.mesh.max_total_degree();
        best = Some(lower);
    }
    Ok(best.unwrap_or_else(|| kept.meshed(share)))
}

/// The mesh with the largest share of Delaunay's minimum angle that is found within a degree limit.
pub(crate) fn max_degree(
    domain: &Domain,
    limit: u32,
    progress: Progress<'_>,
) -> Result<Meshed, MeshError> {
    if let Some(meshed) = within(domain, wider(), limit, 1.0, progress)? {
        return Ok(meshed);
    }
    let found = least(domain, limit, 1.0, progress)?;
    if found.max_degree() <= limit {
        return Ok(found.meshed(0.0));
    }
    Err(MeshError::not_reached(limit, found.max_degree(), found.at_least))
}

/// The mesh with the largest of some shares, which fall, that is found within a degree limit; `effort` is how long to look
/// with each.
fn within(
    domain: &Domain,
    shares: impl IntoIterator<Item = f64>,
    limit: u32,
    effort: f64,
    progress: Progress<'_>,
) -> Result<Option<Meshed>, MeshError> {
    for share in shares {
        let found = mesh_map(domain, share, limit, effort, progress)?;
        if found.max_degree() <= limit && found.keeps_limits {
            return Ok(Some(found.meshed(share)));
        }
    }
    Ok(None)
}

/// The shares that are tried for a larger angle.
fn wider() -> impl Iterator<Item = f64> {
    SHARES.into_iter().filter(|&share| share > 0.0)
}

/// The angle that [`max_degree`] reaches at each degree from the least on.
pub(crate) fn trade_off(
    domain: &Domain,
    mut is_enough: impl FnMut(f64, f64) -> bool,
    progress: Progress<'_>,
) -> Result<TradeOff, MeshError> {
    let mut meshes = Vec::<ExactMesh>::new();
    let mut found = optimize(domain, progress)?;
    let least = found.mesh.max_total_degree();
    let most = found.delaunay_min_angle.unwrap_or(0.0);
    for limit in degrees(domain, least, progress)? {
        if limit > least {
            found = self::max_degree(domain, limit, progress)?;
        }
        let min_angle = found.mesh.measure_angles(progress)?.min;
        if meshes.last().is_none_or(|last| !keeps(last.min_angle, 1.0, min_angle)) {
            let mesh = found.mesh.clone();
            meshes.push(ExactMesh { max_degree: limit, min_angle, is_proven: false, mesh });
        }
        if keeps(min_angle, 1.0, most) || is_enough(min_angle, most) {
            break;
        }
    }
    Ok(TradeOff::new(domain, meshes, most, false))
}

/// The degrees of a trade-off from the least on: all up to that with which Delaunay's angle is kept, or those with which some
/// shares are, where these are fewer.
fn degrees(
    domain: &Domain,
    least: u32,
    progress: Progress<'_>,
) -> Result<BTreeSet<u32>, MeshError> {
    let kept = |share| match lowest(domain, share, 0, TRY, progress) {
        Ok(found) => Ok(Some(found.max_degree())),
        // With limits of single vertices, no mesh may have such an angle.
        Err(MeshError::LimitsNotReached) => Ok(None),
        Err(error) => Err(error),
    };
    let highest = kept(1.0)?.unwrap_or(least + MORE);
    if highest <= least + SHARES.len() as u32 {
        return Ok((least..=highest.max(least)).collect());
    }
    let some = wider().map(kept).collect::<Result<Vec<_>, _>>()?;
    Ok(some.into_iter().flatten().filter(|degree| *degree > least).chain([least]).collect())
}

/// The minimum angle of the Delaunay triangulations of all faces, in degrees.
pub(crate) fn delaunay_min_angle(
    domain: &Domain,
    progress: Progress<'_>,
) -> Result<f64, MeshError> {
    Ok(libm::atan(posed(domain, progress)?.joint.delaunay_tangent()).to_degrees())
}

/// The faces of a map, triangulated.
struct Posed {
    joint: Joint,
    /// For each face its vertices, by those of the domain.
    vertices: Vec<Vec<u32>>,
    /// For each vertex of the domain the one that it is in the joint problem.
    numbers: Vec<u32>,
}

/// For each vertex of a domain its number in the mesh that is joined at periodic sides, in the order of the least vertices.
fn numbers(domain: &Domain, count: u32) -> Vec<u32> {
    let Some(periodic) = domain.periodic() else { return (0..count).collect() };
    let mut next = 0..;
    let mut numbers: Vec<u32> = Vec::with_capacity(count as usize);
    for vertex in 0..count {
        let known = numbers.get(periodic.vertex(vertex) as usize).copied();
        numbers.push(known.or_else(|| next.next()).unwrap_or_default());
    }
    numbers
}

fn posed(domain: &Domain, progress: Progress<'_>) -> Result<Posed, MeshError> {
    let boundary = domain.boundary()?;
    let on_rings = boundary.vertex_count();
    let computed;
    let faces = match domain.faces() {
        Some(faces) => faces,
        None => {
            computed = boundary.faces(&[])?;
            &computed
        }
    };
    let numbers = numbers(domain, on_rings + boundary.inner_points().len() as u32);
    let number = |vertex: u32| numbers[vertex as usize];
    let mut edges = vec![0; numbers.iter().max().map_or(0, |&last| last as usize + 1)];
    for vertex in (0..boundary.edge_count()).flat_map(|edge| boundary.ends(edge)) {
        edges[number(vertex) as usize] += 1;
    }
    if let Some(periodic) = domain.periodic() {
        for vertex in (0..on_rings).filter(|&vertex| periodic.vertex(vertex) == vertex) {
            edges[number(vertex) as usize] -= periodic.doubled(vertex);
        }
    }
    for vertex in 0..if domain.is_constrained() { on_rings } else { 0 } {
        let total = &mut edges[number(vertex) as usize];
        *total = u32::saturating_add(*total, domain.external_degree(vertex));
    }
    let borders = (0..).zip(boundary.face_borders(faces));
    let borders: Vec<Border> =
        borders.filter(|(face, _)| !domain.is_hole(*face)).map(|(_, border)| border).collect();
    let face = |face: usize| {
        let mut border = borders[face].clone();
        let runs = runs(&boundary, &border);
        border.vertices.iter_mut().for_each(|vertex| *vertex = number(*vertex));
        Ok(PlaneFace::of_border(border, runs))
    };
    let joint = Joint::new(borders.len(), face, edges, Some(0.0), progress)?;
    let vertices = borders.into_iter().map(|border| border.vertices).collect();
    Ok(Posed { joint, vertices, numbers })
}

/// The straight run of each edge of a face: where two edges of rings meet, as the domain has it.
fn runs(map: &PlanarBoundary, border: &Border) -> Vec<u32> {
    let Border { boundary, edges, .. } = border;
    straight_runs(boundary.rings(), |ring| {
        let turn_at = |place: u32| {
            let (before, after) = (boundary.previous(place), boundary.next(place));
            let runs = [before, place].map(|edge| map.runs().get(edges[edge as usize] as usize));
            match runs {
                [Some(before), Some(after)] if before == after => Turn::Straight,
                [Some(_), Some(_)] => Turn::Back,
                _ => {
                    let [before, at, after] = [before, place, after].map(|v| boundary.point(v));
                    turn([before, at], [at, after])
                }
            }
        };
        boundary.ring(ring).map(|place| (place, turn_at(place))).collect()
    })
}
