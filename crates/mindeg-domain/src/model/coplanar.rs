//! Merges neighbouring faces in one plane into one face.
//!
//! A region grows from its largest face over edges with exactly two faces that run in opposite
//! directions. A face joins if all its corners are near the plane of that first face and it faces
//! the same way; so a finely divided cylinder does not become one face bit by bit.

use std::collections::{BTreeMap, VecDeque};

use glam::DVec3;

use super::{ModelFace, Plane};

/// A corner between two edges vanishes if they turn by less, as a sine.
const STRAIGHT: f64 = 1e-5;

/// No region.
const NONE: usize = usize::MAX;

/// The faces with regions in one plane merged, in the order of their first faces.
pub(super) fn merged(corners: &[DVec3], faces: Vec<ModelFace>, tolerance: f64) -> Vec<ModelFace> {
    let edges = HalfEdges::new(&faces);
    let planes: Vec<_> = faces.iter().map(|face| plane(corners, face)).collect();
    let area = |face: usize| doubled_area(corners, &faces[face].loops[0]).length();
    let mut order: Vec<usize> = (0..faces.len()).collect();
    order.sort_by(|&a, &b| area(b).total_cmp(&area(a)).then(a.cmp(&b)));

    let mut region_of = vec![NONE; faces.len()];
    let mut regions: Vec<Vec<usize>> = Vec::new();
    for seed in order {
        let Some(seed_plane) = planes[seed].filter(|_| region_of[seed] == NONE) else { continue };
        let region = regions.len();
        region_of[seed] = region;
        let mut members = vec![seed];
        let mut open = VecDeque::from([seed]);
        while let Some(face) = open.pop_front() {
            for other in edges.neighbours(&faces[face]) {
                let is_alike = region_of[other] == NONE
                    && faces[other].group == faces[seed].group
                    && faces[other].material == faces[seed].material;
                let is_near =
                    |&corner: &u32| seed_plane.distance(corners[corner as usize]) <= tolerance;
                let faces_same_way =
                    || planes[other].is_some_and(|at| at.normal.dot(seed_plane.normal) > 0.5);
                if is_alike && faces_same_way() && faces[other].loops.iter().flatten().all(is_near)
                {
                    region_of[other] = region;
                    members.push(other);
                    open.push_back(other);
                }
            }
        }
        members.sort_unstable();
        regions.push(members);
    }
    let mut result = Vec::new();
    for (index, face) in faces.iter().enumerate() {
        let Some(members) = regions.get(region_of[index]) else {
            // A face without area: its error names it.
            result.push(face.clone());
            continue;
        };
        let loops = if members.len() > 1 { outline(&faces, members, &edges) } else { None };
        match loops {
            Some(mut loops) if members[0] == index => {
                put_largest_first(&mut loops, corners);
                result.push(ModelFace { loops, ..face.clone() });
            }
            Some(_) => {}
            None => result.push(face.clone()),
        }
    }
    remove_straight_corners(corners, &mut result);
    result
}

/// Twice the area of a loop, along its normal.
fn doubled_area(corners: &[DVec3], of: &[u32]) -> DVec3 {
    let at = |i: usize| corners[of[i % of.len()] as usize] - corners[of[0] as usize];
    (0..of.len()).map(|i| at(i).cross(at(i + 1))).sum()
}

fn half_edges(face: &ModelFace) -> impl Iterator<Item = [u32; 2]> + '_ {
    face.loops.iter().flat_map(|corners| {
        corners.iter().zip(corners.iter().cycle().skip(1)).map(|(&from, &to)| [from, to])
    })
}

/// The faces of every half-edge, in ascending order.
struct HalfEdges(Vec<([u32; 2], usize)>);

impl HalfEdges {
    fn new(faces: &[ModelFace]) -> Self {
        let of_face = |(index, face)| half_edges(face).map(move |edge| (edge, index));
        let mut edges: Vec<_> = faces.iter().enumerate().flat_map(of_face).collect();
        edges.sort_unstable();
        Self(edges)
    }

    /// The only face with this half-edge.
    fn face(&self, edge: [u32; 2]) -> Option<usize> {
        let at = self.0.partition_point(|&(other, _)| other < edge);
        match &self.0[at..] {
            [(first, _), (second, _), ..] if *first == edge && *second == edge => None,
            [(first, face), ..] if *first == edge => Some(*face),
            _ => None,
        }
    }

    /// The opposite face of an edge with two faces that run in opposite directions.
    fn across(&self, [from, to]: [u32; 2]) -> Option<usize> {
        self.face([from, to]).and(self.face([to, from]))
    }

    fn neighbours<'a>(&'a self, face: &'a ModelFace) -> impl Iterator<Item = usize> + 'a {
        half_edges(face).filter_map(|edge| self.across(edge))
    }
}

/// The loops around some faces; `None` if they pass a corner twice.
fn outline(faces: &[ModelFace], members: &[usize], edges: &HalfEdges) -> Option<Vec<Vec<u32>>> {
    let is_within =
        |edge| edges.across(edge).is_some_and(|face| members.binary_search(&face).is_ok());
    let mut next = BTreeMap::new();
    for &member in members {
        for [from, to] in half_edges(&faces[member]) {
            if !is_within([from, to]) && next.insert(from, to).is_some() {
                return None;
            }
        }
    }
    let mut loops = Vec::new();
    while let Some((first, mut at)) = next.pop_first() {
        let mut corners = vec![first];
        while at != first {
            corners.push(at);
            at = next.remove(&at)?;
        }
        loops.push(corners);
    }
    (!loops.is_empty()).then_some(loops)
}

/// Removes the corners where only two edges of all faces meet, on one line.
fn remove_straight_corners(corners: &[DVec3], faces: &mut [ModelFace]) {
    let mut ends: Vec<[u32; 2]> =
        faces.iter().flat_map(half_edges).flat_map(|[a, b]| [[a, b], [b, a]]).collect();
    ends.sort_unstable();
    ends.dedup();
    let is_straight = |corner: u32| {
        let first = ends.partition_point(|&[from, _]| from < corner);
        let own: Vec<u32> = ends[first..]
            .iter()
            .take(3)
            .filter(|[from, _]| *from == corner)
            .map(|e| e[1])
            .collect();
        let &[a, b] = &own[..] else { return false };
        let [a, at, b] = [a, corner, b].map(|corner| corners[corner as usize]);
        let (before, after) = (at - a, b - at);
        let sine = before.cross(after).length() / (before.length() * after.length());
        sine <= STRAIGHT && before.dot(after) > 0.0
    };
    for face in faces {
        for corners in &mut face.loops {
            corners.retain(|&corner| !is_straight(corner));
        }
    }
}

/// Puts the loop with the largest area first.
pub(super) fn put_largest_first(loops: &mut [Vec<u32>], corners: &[DVec3]) {
    let area = |of: &[u32]| doubled_area(corners, of).length_squared();
    let mut largest = 0;
    for (index, corners_of) in loops.iter().enumerate() {
        if area(corners_of) > area(&loops[largest]) {
            largest = index;
        }
    }
    loops[..=largest].rotate_right(1);
}

/// The plane of a face, if it has area.
fn plane(corners: &[DVec3], face: &ModelFace) -> Option<Plane> {
    let at = |&corner: &u32| corners[corner as usize];
    Plane::of_loop(&face.loops[0].iter().map(at).collect::<Vec<_>>())
}
