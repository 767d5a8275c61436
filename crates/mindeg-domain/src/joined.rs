//! Lines and points joined to the rings and to each other: the vertices of the boundary that they become.
//!
//! A corner of a line that is near a vertex is that vertex. An end that lies within a straight side makes a corner of
//! that side.

use glam::DVec2;
use mindeg_mesh::Bounds;
use mindeg_mesh::planar::{BoundaryFault, BoundaryPlace, Faces, PlanarBoundary};

use crate::error::{DomainError, Place, counted};
use crate::given::sides_of;
use crate::inside::{Inside, Region};
use crate::outline::{self, Ring};

/// Corners nearer to a vertex than this share of the domain's extent are that vertex.
const SAME: f64 = 1e-9;

/// The inner points and lines of a boundary.
#[derive(Default)]
pub(crate) struct Joined {
    /// The points of [`Inside::points`] that are no boundary points, then those of lines.
    pub(crate) points: Vec<DVec2>,
    /// The indices of the former.
    pub(crate) given: Vec<usize>,
    /// The vertex of each of [`Inside::points`].
    pub(crate) point_vertices: Vec<u32>,
    /// The vertices of each line.
    pub(crate) lines: Vec<Vec<u32>>,
    /// The first segment of each side of each line, then the number of segments.
    pub(crate) starts: Vec<u32>,
}

/// A line, divided.
pub(crate) struct Chain {
    pub(crate) points: Vec<DVec2>,
    /// The indices of the corners.
    corners: Vec<usize>,
}

impl Chain {
    pub(crate) fn new(line: usize, given: &Ring) -> Result<Self, DomainError> {
        let within = |error: DomainError| error.within(place(line), &format!("line {}", line + 1));
        check_counts(given).map_err(within)?;
        let mut chain = Self { points: Vec::new(), corners: Vec::new() };
        for side in sides_of(0, given) {
            chain.corners.push(chain.points.len());
            chain.points.extend(side.points().map_err(within)?);
        }
        if given.is_open() {
            chain.corners.push(chain.points.len());
            chain.points.extend(given.corners.last());
        }
        Ok(chain)
    }
}

pub(crate) fn place(line: usize) -> Place {
    Place::key("lines").then(line)
}

/// Checks the number of corners and sides, and that corners are apart.
fn check_counts(line: &Ring) -> Result<(), DomainError> {
    let Ring { corners, sides } = line;
    if sides.is_empty() || sides.len() > corners.len() || sides.len() + 1 < corners.len() {
        let corners = counted(corners.len(), "corner");
        let sides = counted(sides.len(), "side");
        return Err(Place::key("sides").error(format!(
            "found {corners} and {sides}; a line has one side from each corner to the next, and one more if \
             it is closed"
        )));
    }
    outline::check_positions(0, corners, !line.is_open())
}

/// Vertices in the order of x, to find one near a point.
pub(crate) struct Lookup {
    points: Vec<(DVec2, u32)>,
    reach: f64,
}

impl Lookup {
    pub(crate) fn new(points: impl Iterator<Item = DVec2>, reach: f64) -> Self {
        let mut points: Vec<(DVec2, u32)> = points.zip(0..).collect();
        points.sort_unstable_by(|a, b| a.0.x.total_cmp(&b.0.x).then(a.1.cmp(&b.1)));
        Self { points, reach }
    }

    /// The nearest vertex near a point of which something holds; of several at one place the least.
    pub(crate) fn near(&self, at: DVec2, holds: impl Fn(u32) -> bool) -> Option<u32> {
        let from = self.points.partition_point(|(point, _)| point.x < at.x - self.reach);
        let near = self.points[from..].iter().take_while(|(point, _)| point.x <= at.x + self.reach);
        let near = near.map(|&(point, vertex)| (point.distance(at), vertex));
        let near = near.filter(|&(distance, vertex)| distance <= self.reach && holds(vertex));
        near.min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1))).map(|(_, vertex)| vertex)
    }
}

pub(crate) fn reach(ring_points: &[DVec2]) -> f64 {
    let bounds = Bounds::of(ring_points.iter().copied());
    SAME * bounds.map_or(0.0, |bounds| bounds.size().max_element())
}

impl Joined {
    /// Divides lines and joins them; moves their corners to the vertices that they are near.
    pub(crate) fn new(ring_points: &[DVec2], inside: &mut Inside) -> Result<Self, DomainError> {
        let chains = inside.lines.iter().enumerate().map(|(line, given)| Chain::new(line, given));
        let chains = chains.collect::<Result<Vec<_>, _>>()?;
        let own: Vec<DVec2> = inside.points.iter().map(|point| point.at).collect();
        let of_chains = chains.iter().flat_map(|chain| chain.points.iter().copied());
        let all: Vec<DVec2> =
            ring_points.iter().copied().chain(own.iter().copied()).chain(of_chains).collect();
        let lookup = Lookup::new(all.iter().copied(), reach(ring_points));
        let mut joined = Self { starts: vec![0], ..Self::default() };
        let (first, given) = (ring_points.len(), ring_points.len() + own.len());
        // For each candidate, the vertex that it is; first those that are no corners of lines.
        let mut vertex_of: Vec<Option<u32>> = (0..first as u32).map(Some).collect();
        vertex_of.resize(all.len(), None);
        for (index, point) in inside.points.iter_mut().enumerate() {
            let at_boundary = lookup.near(point.at, |other| (other as usize) < first);
            if let Some(vertex) = at_boundary {
                point.at = ring_points[vertex as usize];
            } else {
                joined.points.push(point.at);
                joined.given.push(index);
            }
            let vertex = at_boundary.unwrap_or((first + joined.points.len() - 1) as u32);
            vertex_of[first + index] = Some(vertex);
            joined.point_vertices.push(vertex);
        }
        let is_own = |other: u32| (first..given).contains(&(other as usize));
        let mut is_corner = vec![false; all.len()];
        let firsts: Vec<usize> = chains
            .iter()
            .scan(given, |next, chain| {
                *next += chain.points.len();
                Some(*next - chain.points.len())
            })
            .collect();
        for (first, chain) in firsts.iter().zip(&chains) {
            chain.corners.iter().for_each(|corner| is_corner[first + corner] = true);
        }
        for index in given..all.len() {
            if !is_corner[index] {
                let own = lookup.near(all[index], is_own);
                let own = own
                    .and_then(|own| vertex_of[own as usize])
                    .filter(|own| *own as usize >= first);
                if let Some(vertex) = own {
                    // Points of lines stay where they are.
                    joined.points[vertex as usize - first] = all[index];
                    vertex_of[index] = own;
                } else {
                    vertex_of[index] = Some((first + joined.points.len()) as u32);
                    joined.points.push(all[index]);
                }
            }
        }
        for index in given..all.len() {
            if is_corner[index] {
                let near = lookup.near(all[index], |other| vertex_of[other as usize].is_some());
                vertex_of[index] = match near {
                    Some(other) => vertex_of[other as usize],
                    None => {
                        joined.points.push(all[index]);
                        Some((ring_points.len() + joined.points.len() - 1) as u32)
                    }
                };
            }
        }
        for (point, vertex) in inside.points.iter_mut().zip(&joined.point_vertices) {
            if let Some(inner) = (*vertex as usize).checked_sub(first) {
                point.at = joined.points[inner];
            }
        }
        for ((first, chain), line) in firsts.iter().zip(&chains).zip(&mut inside.lines) {
            let vertices = vertex_of[*first..*first + chain.points.len()].iter().flatten();
            let mut vertices: Vec<u32> = vertices.copied().collect();
            for (corner, index) in line.corners.iter_mut().zip(&chain.corners) {
                let vertex = vertices[*index] as usize;
                *corner = match vertex.checked_sub(ring_points.len()) {
                    None => ring_points[vertex],
                    Some(inner) => joined.points[inner],
                };
            }
            if !line.is_open() {
                vertices.push(vertices[0]);
            }
            let before = joined.starts[joined.starts.len() - 1];
            let last = vertices.len() - 1;
            let ends = chain.corners[1..].iter().copied().chain((!line.is_open()).then_some(last));
            joined.starts.extend(ends.map(|end| before + end as u32));
            joined.lines.push(vertices);
        }
        Ok(joined)
    }
}

/// The faces of a boundary with lines, those of the regions first.
pub(crate) fn faces(boundary: &PlanarBoundary, regions: &[Region]) -> Result<Faces, DomainError> {
    let at: Vec<DVec2> = regions.iter().map(|region| region.at).collect();
    let error = |region: usize, message: &str| {
        let message =
            format!("region {} at {} {message}", region + 1, mindeg_mesh::place(at[region]));
        Place::key("regions").then(region).then("at").error(message)
    };
    let inner = boundary.inner_points().len();
    let faces = boundary.faces(&at).map_err(|faults| {
        let region = |place: &BoundaryPlace| match place {
            BoundaryPlace::Point(index) => index.checked_sub(inner),
            _ => None,
        };
        let places = match faults.first() {
            BoundaryFault::SamePoint(places) => places,
            BoundaryFault::Touch { vertex, .. } => [vertex; 2],
            BoundaryFault::NotFinite(place) => [place; 2],
            fault => return Place::key("regions").error(fault.to_string()),
        };
        if let [Some(one), Some(other)] = places.each_ref().map(region)
            && one != other
        {
            let (first, second) = (one.min(other) + 1, one.max(other));
            let message = format!("is at the point of region {first}; drop one of them");
            return error(second, &message);
        }
        match places.iter().rev().find_map(region) {
            Some(region) => {
                error(region, "is no point inside a region; move it off sides, lines and points")
            }
            None => Place::key("regions").error(faults.to_string()),
        }
    })?;
    for (region, face) in faces.around.iter().enumerate() {
        let Some(face) = face else {
            return Err(error(region, "lies outside the domain; move it inside, or drop it"));
        };
        if *face != region as u32 {
            let message = format!(
                "lies in the same face as region {}; drop one of them, or draw a line between them",
                face + 1
            );
            return Err(error(region, &message));
        }
    }
    let hole = |face: Option<u32>| {
        face.filter(|&face| regions.get(face as usize).is_some_and(|region| region.hole))
    };
    let has_region = |face: &Option<u32>| face.is_some() && hole(*face).is_none();
    for (edge, beside) in (0..).zip(&faces.beside) {
        let Some(region) = beside.iter().find_map(|face| hole(*face)) else { continue };
        if !beside.iter().any(has_region) {
            let place = boundary.place_of_edge(edge);
            let hint = match place {
                BoundaryPlace::Ring(at) if at.ring == 0 => "draw the outline around the hole",
                BoundaryPlace::Ring(_) => "drop the inner one of the two holes",
                _ => "drop this edge, or make one of its sides a region",
            };
            let message = format!(
                "is a hole, and {} has no region on either side; {hint}",
                place.named("edge")
            );
            return Err(error(region as usize, &message));
        }
    }
    for (point, face) in faces.points.iter().enumerate() {
        if let Some(region) = hole(*face) {
            let message =
                format!("is a hole around point {}; move the point, or drop it", point + 1);
            return Err(error(region as usize, &message));
        }
    }
    Ok(faces)
}
