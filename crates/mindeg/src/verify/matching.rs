//! Finds the vertices of a mesh that are the boundary points of a domain.

use std::borrow::Cow;

use glam::{DVec2, DVec3};
use mindeg_domain::Domain;
use mindeg_mesh::planar::PlanarBoundary;
use mindeg_mesh::weld;
use mindeg_mesh::{TriMesh, number};

use super::defect::{self, MeshDefect};
use super::near::Near;
use crate::boundary_mesh::points_of;

/// How far a vertex may be from its boundary point: this share of a domain's extent.
pub const DEFAULT_TOLERANCE: f64 = 1e-6;

/// How a planar mesh lies in space: where the domain's x and y are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MatchedPlane {
    /// Upright: (x, y, constant).
    Xy,
    /// On the floor, as in files with y up: (x, constant, -y).
    Floor,
    /// On a floor with z up, as Blender turns what has y up: (x, constant, y).
    Xz,
}

impl MatchedPlane {
    pub(super) const ALL: [Self; 3] = [Self::Xy, Self::Floor, Self::Xz];

    /// The point in the domain's plane, and the height above it.
    pub(super) fn place(self, position: DVec3) -> (DVec2, f64) {
        let DVec3 { x, y, z } = position;
        match self {
            Self::Xy => (DVec2::new(x, y), z),
            Self::Floor => (DVec2::new(x, -z), y),
            Self::Xz => (DVec2::new(x, z), -y),
        }
    }
}

/// A mesh that is a triangulation of a domain.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct VerifiedMesh {
    /// The domain's boundary points and those inside as the domain has them, then the others as the mesh has them.
    pub points: Vec<DVec2>,
    /// The vertex of the mesh at each of these: the first, if several are there.
    pub vertex_of: Vec<u32>,
    /// The triangles of the mesh, in its order, by these points and counter-clockwise.
    pub triangles: Vec<[u32; 3]>,
    /// How many points the domain does not have.
    pub interior_points: usize,
    /// How many vertices of the mesh no triangle uses.
    pub unused_vertices: usize,
    /// The number of edges at each point, the domain's external degrees included.
    pub degrees: Vec<u32>,
    /// The largest of them.
    pub max_degree: u32,
    /// The boundary points with more edges than the domain allows there.
    pub above_limit: Vec<u32>,
    /// With interior points: the points inside, on lines too, whose degree is out of the wanted range.
    pub out_of_range: Vec<u32>,
    /// The points of `out_of_range` that no mesh brings into range: the lines there alone are too many.
    pub certified: Vec<u32>,
    /// Others of `out_of_range`, which no mesh with this share of the angles there brings nearer to their limits, alone or with others.
    pub together: Vec<(u32, f64)>,
    /// How the mesh lies in space.
    pub plane: MatchedPlane,
    /// Whether all triangles of the mesh are clockwise.
    pub is_reversed: bool,
    /// How far a vertex may be from its boundary point, in units of length.
    pub tolerance: f64,
    /// How far the farthest one is.
    pub farthest: f64,
}

/// How far a vertex may be from its boundary point.
pub(super) fn tolerance_of(
    mesh: &TriMesh,
    domain: &Domain,
    wanted: Option<f64>,
) -> Result<f64, MeshDefect> {
    let shortest = shortest_interval(domain);
    if let Some(tolerance) = wanted {
        return if tolerance < shortest / 2.0 {
            Ok(tolerance)
        } else {
            Err(MeshDefect::new(
                "tolerance_too_large",
                format!(
                    "a tolerance of {} is too large: the shortest interval is {} long; give less than \
                     half of that",
                    number(tolerance),
                    number(shortest)
                ),
            ))
        };
    }
    let bounds = domain.placement().bounds();
    let largest = bounds.min.abs().max(bounds.max.abs()).max_element();
    // 32-bit floats round by 2^-24 of a number; twice, if it is written once more. A vertex that no
    // triangle has, however far away, says nothing of how the others were rounded.
    let corners = mesh.triangles().iter().flatten();
    let used = corners.map(|&vertex| mesh.positions()[vertex as usize].abs().max_element());
    let used = used.fold(0.0, f64::max) / f64::from(1 << 22);
    let rounding = (2.0 * mesh.rounding()).min(used).max(largest / f64::from(1 << 23));
    let extent = bounds.size().max_element();
    Ok((DEFAULT_TOLERANCE * extent).max(rounding).min(shortest / 4.0))
}

/// The boundary of a domain with lines or points inside, which is stored.
fn stored(domain: &Domain) -> Option<Cow<'_, PlanarBoundary>> {
    if domain.inside().is_empty() { None } else { domain.boundary().ok() }
}

fn shortest_interval(domain: &Domain) -> f64 {
    let points = points_of(domain);
    let length = |vertex: u32| {
        points[vertex as usize].distance(points[domain.rings().next(vertex) as usize])
    };
    let of_rings = (0..domain.rings().vertex_count()).map(length).fold(f64::INFINITY, f64::min);
    let Some(boundary) = stored(domain) else { return of_rings };
    let segments = boundary.segments().iter().map(|ends| ends.map(|end| boundary.point(end)));
    segments.map(|[from, to]| from.distance(to)).fold(of_rings, f64::min)
}

/// The mesh by the domain's points, if it lies in this plane and has a vertex at each.
pub(super) fn matched(
    mesh: &TriMesh,
    domain: &Domain,
    plane: MatchedPlane,
    tolerance: f64,
) -> Result<VerifiedMesh, MeshDefect> {
    const NONE: u32 = u32::MAX;
    let positions = mesh.positions();
    let mut points = points_of(domain);
    points.extend(stored(domain).iter().flat_map(|boundary| boundary.inner_points()));
    let boundary_count = points.len();
    let extent = domain.placement().bounds().size().max_element();

    let first = weld(positions, 0.0);
    let mut is_used = vec![false; positions.len()];
    mesh.triangles().as_flattened().iter().for_each(|&v| is_used[v as usize] = true);
    let used = || (0_u32..).zip(&is_used).filter(|(_, is_used)| **is_used).map(|(v, _)| v);
    let height = |vertex: u32| plane.place(positions[vertex as usize]).1;
    let floor = used().next().map_or(0.0, height);
    if let Some(vertex) = used().find(|&vertex| (height(vertex) - floor).abs() > tolerance) {
        let off = (height(vertex) - floor).abs();
        let off = number(off);
        return Err(MeshDefect::new(
            "not_planar",
            format!(
                "vertex {vertex} is {off} off the plane of the others; a domain is planar, in x and y \
                 or in x and z"
            ),
        ));
    }

    let mut vertex_of = vec![NONE; boundary_count];
    let mut point_of = vec![NONE; positions.len()];
    let mut farthest = 0.0_f64;
    let boundary = points.clone();
    let near = Near::new(&boundary, tolerance, extent);
    let point = |vertex: u32| plane.place(positions[vertex as usize]).0;
    // A point with a vertex at the very place needs no other: what is near it lies inside.
    let mut is_exact = vec![false; boundary_count];
    let nearest = used().filter_map(|vertex| near.nearest(point(vertex)));
    nearest
        .filter(|&(_, distance)| distance == 0.0)
        .for_each(|(at, _)| is_exact[at as usize] = true);
    for vertex in used() {
        let same = first[vertex as usize] as usize;
        if point_of[same] == NONE {
            let point = point(vertex);
            point_of[same] = match near.nearest(point) {
                Some((index, distance)) if distance == 0.0 || !is_exact[index as usize] => {
                    farthest = farthest.max(distance);
                    index
                }
                _ => {
                    points.push(point);
                    points.len() as u32 - 1
                }
            };
            let point = point_of[same] as usize;
            if point == vertex_of.len() {
                vertex_of.push(vertex);
            } else if vertex_of[point] == NONE {
                vertex_of[point] = vertex;
            }
        }
        point_of[vertex as usize] = point_of[same];
    }
    if let Some(missing) = vertex_of.iter().position(|&vertex| vertex == NONE) {
        let places = used().map(|vertex| (vertex, plane.place(positions[vertex as usize]).0));
        return Err(no_vertex(domain, &boundary, missing, places, tolerance));
    }
    let triangles = mesh.triangles().iter().map(|corners| corners.map(|v| point_of[v as usize]));
    let triangles = triangles.collect();
    let unused_vertices = is_used.iter().filter(|is_used| !**is_used).count();
    let interior_points = points.len() - boundary_count;
    Ok(VerifiedMesh {
        points,
        vertex_of,
        triangles,
        interior_points,
        unused_vertices,
        plane,
        tolerance,
        farthest,
        degrees: Vec::new(),
        max_degree: 0,
        above_limit: Vec::new(),
        out_of_range: Vec::new(),
        certified: Vec::new(),
        together: Vec::new(),
        is_reversed: false,
    })
}

/// Why no vertex is at a boundary point.
fn no_vertex(
    domain: &Domain,
    boundary: &[DVec2],
    missing: usize,
    places: impl Iterator<Item = (u32, DVec2)> + Clone,
    tolerance: f64,
) -> MeshDefect {
    let at = boundary[missing];
    let distances = places.clone().map(|(vertex, place)| (vertex, place.distance(at)));
    let nearest = distances.min_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or((0, f64::INFINITY));
    let bounds = |points: &mut dyn Iterator<Item = DVec2>| {
        let none = (DVec2::NAN, DVec2::NAN);
        mindeg_mesh::Bounds::of(points).map_or(none, |bounds| (bounds.min, bounds.size()))
    };
    let [(origin, size), (mesh_origin, mesh_size)] =
        [bounds(&mut boundary.iter().copied()), bounds(&mut places.map(|(_, place)| place))];
    let (vertex, distance) = nearest;
    let hint = match change([origin, mesh_origin], mesh_size / size, tolerance) {
        Some(change) => change,
        None if distance <= 1000.0 * tolerance => {
            "; if the mesh was rounded, give a larger --tolerance".to_owned()
        }
        None => String::new(),
    };
    MeshDefect::new(
        "no_vertex",
        format!(
            "no vertex is at {}, {}: the nearest, vertex {vertex}, is {} \
             away, and {} is the tolerance{hint}",
            place(domain, missing as u32),
            defect::at(at),
            number(distance),
            number(tolerance)
        ),
    )
}

/// A point of the domain in words.
fn place(domain: &Domain, point: u32) -> String {
    match point.checked_sub(domain.rings().vertex_count()) {
        None => {
            let side = domain.side_name(domain.rings().side_of(point));
            format!("boundary point {point} on {side}")
        }
        Some(inner) => match domain.inside().points.get(inner as usize) {
            Some(_) => format!("point {} inside", inner + 1),
            None => format!("point {point}, on a line"),
        },
    }
}

/// A change of the whole mesh, guessed from the least corners of the domain and the mesh and the ratio of their sizes.
fn change([domain, mesh]: [DVec2; 2], ratio: DVec2, tolerance: f64) -> Option<String> {
    let is_scaled = (ratio.x - ratio.y).abs() <= 1e-3 * ratio.x;
    let is_same = (ratio - 1.0).abs().max_element() <= 1e-3;
    if is_scaled && !is_same {
        let by = number(ratio.x);
        return Some(format!(
            "; the mesh is {by} times as large as the domain: is its unit another one?"
        ));
    }
    let moved = mesh - domain;
    let is_moved = is_same && moved.length() > 2.0 * tolerance;
    is_moved.then(|| format!("; the mesh seems to be moved by {}", defect::at(moved)))
}
