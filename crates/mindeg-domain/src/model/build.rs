//! From corners, faces and divisions to a checked model.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use glam::DVec3;
use mindeg_mesh::{Bounds, Material, number, sorted};

use super::crossing;
use super::faults::{self, coincident, face_error};
use super::{
    Edge, Face, FaceGroup, Model, ModelEdge, ModelFace, ModelParts, PLANAR_SHARE, Pass, Plane,
};
use crate::error::{DomainError, Place};
use crate::limits::{LEAST_ROUNDINGS, MAX_STORED_VERTICES};
use crate::name;
use crate::side::{Intervals, Side};
use crate::spacing::Spacing;
use crate::spacing_law::SpacingLaw;

impl Model {
    /// A model of these parts. O(n log n) for n corners of faces, unless a face has very many edges
    /// above each other.
    ///
    /// # Errors
    ///
    /// The first fault, with its face, edge or corner.
    pub fn new(parts: ModelParts) -> Result<Self, DomainError> {
        let ModelParts { corners, faces, edges, other_edges, planar_tolerance } = parts;
        check_corners(&corners, &faces, &edges)?;
        let extent = faces.iter().flat_map(|face| face.loops.iter().flatten());
        let extent = largest_extent(extent.map(|&corner| corners[corner as usize]));
        let planar_tolerance = planar_tolerance.unwrap_or(PLANAR_SHARE * extent);

        let mut planes = Vec::with_capacity(faces.len());
        let mut loops = Vec::with_capacity(faces.len());
        for (index, face) in faces.iter().enumerate() {
            let plane = plane(&corners, index, face, planar_tolerance)?;
            loops.push(crossing::oriented(&corners, index, face, &plane)?);
            planes.push(plane);
        }
        faults::check_face_twice(&loops)?;

        let mut ends = faults::edges(loops.iter().flatten());
        ends.dedup();
        let laws = laws(&corners, &ends, &edges, other_edges.as_ref())?;
        let used: BTreeSet<u32> = ends.iter().flatten().copied().collect();
        let used: Vec<u32> = used.into_iter().collect();
        let mut next = used.len() as u64;
        let mut model_edges = Vec::with_capacity(ends.len());
        for (ends, (spacing, law, name)) in ends.iter().zip(laws) {
            let first = next;
            next += u64::from(law.intervals()) - 1;
            if next > u64::from(MAX_STORED_VERTICES) {
                return Err(too_many_vertices(next));
            }
            model_edges.push(Edge {
                corners: *ends,
                first: first as u32,
                spacing,
                law,
                name,
                passes: [0; 2],
            });
        }
        let mut groups = Groups::default();
        let mut model_faces = Vec::with_capacity(faces.len());
        for ((face, loops), plane) in faces.into_iter().zip(&loops).zip(planes) {
            let ModelFace { name, group, material, .. } = face;
            let index = model_faces.len();
            let material_name = material.as_ref().map(|material| &*material.name);
            let place = Place::key("faces").then(index);
            for (key, of, name) in [
                ("name", "", name.as_deref()),
                ("group", "the group of ", group.as_deref()),
                ("material", "the material of ", material_name),
            ] {
                if let Some(name) = name {
                    name::check(name, place.clone().then(key), &format!("{of}face {index}"))?;
                }
            }
            let passes = |corners: &Vec<u32>| passes(corners, &ends, &mut model_edges);
            let loops = loops.iter().map(passes).collect();
            // A face with a name and no group is a group of its own.
            let group = group.or_else(|| name.clone());
            model_faces.push(Face { loops, plane, name, group: groups.index(group, material) });
        }
        let groups = groups.sorted(&mut model_faces);
        let mut model = Self {
            name: None,
            corners,
            used,
            edges: model_edges,
            faces: model_faces,
            groups,
            planar_tolerance,
            notes: Vec::new(),
        };
        model.notes = faults::notes(&model);
        Ok(model)
    }
}

impl Model {
    /// The same model with all its edges divided in another way; they keep their names.
    ///
    /// # Errors
    ///
    /// A division that does not fit an edge.
    pub fn divided(self, side: &Side) -> Result<Self, DomainError> {
        self.divided_each(|_, _| side.clone())
    }

    /// The same model with these counts of intervals, one for each edge; edges keep their names and spacings.
    ///
    /// # Errors
    ///
    /// A count that does not fit an edge, such as another one for an edge whose points are given.
    ///
    /// # Panics
    ///
    /// If there are fewer counts than edges.
    pub fn with_intervals(self, counts: &[u64]) -> Result<Self, DomainError> {
        self.divided_each(|index, edge| Side::count(counts[index]).spaced(edge.spacing.clone()))
    }

    fn divided_each(mut self, side: impl Fn(usize, &Edge) -> Side) -> Result<Self, DomainError> {
        let mut next = self.used.len() as u64;
        for (index, edge) in self.edges.iter_mut().enumerate() {
            let side = side(index, edge);
            edge.law = law(&self.corners, edge.corners, &side, &Place::key("size"))?;
            edge.spacing = side.spacing;
            edge.first = next as u32;
            next += u64::from(edge.law.intervals()) - 1;
            if next > u64::from(MAX_STORED_VERTICES) {
                return Err(too_many_vertices(next));
            }
        }
        Ok(self)
    }
}

fn too_many_vertices(vertices: u64) -> DomainError {
    Place::default().error(format!(
        "the model has {vertices} vertices on its edges; the maximum is {MAX_STORED_VERTICES}; \
             give fewer intervals, or a larger size"
    ))
}

fn check_corners(
    corners: &[DVec3],
    faces: &[ModelFace],
    edges: &[ModelEdge],
) -> Result<(), DomainError> {
    if faces.is_empty() {
        let message = "the model has no face; give each face as a loop of corners";
        return Err(Place::key("faces").error(message));
    }
    if let Some(corner) = corners.iter().position(|corner| !corner.is_finite()) {
        return Err(Place::key("corners")
            .then(corner)
            .error(format!("corner {corner} has a coordinate that is not a finite number")));
    }
    let check = |place: Place, name: String, corner: u32| {
        if (corner as usize) < corners.len() {
            return Ok(());
        }
        let last = corners.len().saturating_sub(1);
        let message = format!("{name} names corner {corner}; the model has corners 0 to {last}");
        Err(place.error(message))
    };
    for (index, face) in faces.iter().enumerate() {
        let shortest = face.loops.iter().map(Vec::len).min().unwrap_or(0);
        if shortest < 3 {
            return Err(face_error(
                index,
                format!("has a loop of {shortest} corners; a loop needs at least 3"),
            ));
        }
        for &corner in face.loops.iter().flatten() {
            check(Place::key("faces").then(index), format!("face {index}"), corner)?;
        }
    }
    for (index, edge) in edges.iter().enumerate() {
        for corner in edge.corners {
            check(Place::key("edges").then(index), format!("edge {index}"), corner)?;
        }
    }
    Ok(())
}

/// The largest extent of some points along an axis.
pub(super) fn largest_extent(points: impl Iterator<Item = DVec3>) -> f64 {
    Bounds::of_space(points).map_or(0.0, |bounds| bounds.size().max_element())
}

fn plane(
    corners: &[DVec3],
    index: usize,
    face: &ModelFace,
    tolerance: f64,
) -> Result<Plane, DomainError> {
    let at = |&corner: &u32| corners[corner as usize];
    let outer: Vec<DVec3> = face.loops[0].iter().map(at).collect();
    let plane = Plane::of_loop(&outer)
        .ok_or_else(|| face_error(index, "has no area; remove it or move its corners"))?;
    let mut farthest = (0.0, 0);
    for corner in face.loops.iter().flatten() {
        let distance = plane.distance(at(corner));
        if distance > farthest.0 {
            farthest = (distance, *corner);
        }
    }
    let (distance, corner) = farthest;
    if distance > tolerance {
        return Err(face_error(
            index,
            format!(
                "is not planar: corner {corner} is {} off its plane, and the tolerance is {}; cut \
                 the face in triangles, or raise the tolerance",
                number(distance),
                number(tolerance)
            ),
        ));
    }
    Ok(plane)
}

/// A loop as edges; counts each pass of an edge.
fn passes(corners: &[u32], ends: &[[u32; 2]], edges: &mut [Edge]) -> Vec<Pass> {
    let pass = |(i, &from): (usize, &u32)| {
        let to = corners[(i + 1) % corners.len()];
        // The list has every edge of every face.
        let edge = ends.partition_point(|&ends| ends < [from.min(to), from.max(to)]);
        edges[edge].passes[usize::from(from > to)] += 1;
        Pass { edge: edge as u32, is_upward: from < to }
    };
    corners.iter().enumerate().map(pass).collect()
}

type Division = (Spacing, SpacingLaw, Option<String>);

/// The spacing, its law and the name of every edge, from its lower corner on.
fn laws(
    corners: &[DVec3],
    ends: &[[u32; 2]],
    given: &[ModelEdge],
    other: Option<&Side>,
) -> Result<Vec<Division>, DomainError> {
    let place = |index: usize| Place::key("edges").then(index);
    let mut divisions: BTreeMap<usize, (usize, Side)> = BTreeMap::new();
    for (index, edge) in given.iter().enumerate() {
        let [a, b] = edge.corners;
        let Ok(at) = ends.binary_search(&sorted([a, b])) else {
            return Err(place(index).error(format!(
                "edge {index} joins corners {a} and {b}, but no face has such an edge"
            )));
        };
        let side = edge.side.clone();
        let side = if a < b { side } else { side.reversed() };
        if let Some((first, _)) = divisions.insert(at, (index, side)) {
            let name = edge_name(ends[at]);
            let message = match (given[first].side.intervals, edge.side.intervals) {
                (Intervals::Count(first), Intervals::Count(second)) if first != second => format!(
                    "{name} has {first} intervals in one place and {second} in another; give it one \
                     count"
                ),
                _ => format!("{name} is given twice; give it once"),
            };
            return Err(place(index).error(message));
        }
    }
    for (index, edge) in given.iter().enumerate() {
        if let Some(name) = &edge.side.name {
            name::check(name, place(index).then("name"), &format!("edge {index}"))?;
        }
    }
    let law = |(at, &corners_of): (usize, &[u32; 2])| {
        let own = divisions.get(&at);
        let place = own.map_or_else(|| Place::key("size"), |(index, _)| place(*index));
        let side = own.map(|(_, side)| side).or(other).ok_or_else(|| {
            Place::default().error(format!(
                "{} has no interval count; give \"size\" for all edges, or an entry in \"edges\"",
                edge_name(corners_of)
            ))
        })?;
        let law = law(corners, corners_of, side, &place)?;
        Ok((side.spacing.clone(), law, side.name.clone().filter(|_| own.is_some())))
    };
    ends.iter().enumerate().map(law).collect()
}

fn edge_name([from, to]: [u32; 2]) -> String {
    format!("the edge from corner {from} to corner {to}")
}

/// The law of an edge; `place` is where the description divides it.
fn law(
    corners: &[DVec3],
    ends: [u32; 2],
    side: &Side,
    place: &Place,
) -> Result<SpacingLaw, DomainError> {
    let [from, to] = ends.map(|corner| corners[corner as usize]);
    let length = (to - from).length();
    let name = edge_name(ends);
    let error = |is: String| place.clone().error(format!("{name} {is}"));
    let within = |error: DomainError| error.within(place.clone(), &name);
    if from == to {
        return Err(coincident(ends));
    }
    let intervals = match (&side.spacing, side.intervals) {
        (Spacing::Parameters(given), Intervals::Size(_)) => given.len() as u64 + 1,
        (_, intervals) => intervals.on(length, 0).map_err(within)?,
    };
    let Ok(intervals) = u32::try_from(intervals) else {
        return Err(too_many_vertices(intervals));
    };
    if intervals == 0 {
        return Err(error("has 0 intervals; the minimum is 1".to_owned()));
    }
    let law = SpacingLaw::solve(&side.spacing, intervals, length).map_err(within)?;
    let (_, share) = law.shortest();
    let rounding = from.abs().max(to.abs()).max_element() * f64::EPSILON;
    if share * (to - from).abs().max_element() < LEAST_ROUNDINGS * rounding {
        return Err(error(format!(
            "has intervals of {}, too short for its coordinates; use fewer intervals, or an origin \
             near the model",
            number(share * length)
        )));
    }
    Ok(law)
}

/// The distinct groups of faces, in the order of their first faces.
#[derive(Default)]
struct Groups {
    groups: Vec<FaceGroup>,
    indices: BTreeMap<GroupKey, u32>,
}

/// The names of a group and of its material, and the bits of the material's color.
type GroupKey = (Option<String>, Option<(String, Option<[u32; 4]>)>);

impl Groups {
    fn index(&mut self, name: Option<String>, material: Option<Arc<Material>>) -> u32 {
        let next = self.groups.len() as u32;
        let bits = |material: &Arc<Material>| {
            (material.name.clone(), material.color.map(|color| color.map(f32::to_bits)))
        };
        let key = (name.clone(), material.as_ref().map(bits));
        *self.indices.entry(key).or_insert_with(|| {
            self.groups.push(FaceGroup { name, material });
            next
        })
    }

    /// The groups, with equal names together; the faces get the new indices of their groups.
    fn sorted(self, faces: &mut [Face]) -> Vec<FaceGroup> {
        let mut first_of_name = BTreeMap::new();
        let first = |(group, of): (usize, &FaceGroup)| {
            *first_of_name.entry(of.name.clone()).or_insert(group)
        };
        let first: Vec<usize> = self.groups.iter().enumerate().map(first).collect();
        let mut order: Vec<usize> = (0..first.len()).collect();
        order.sort_by_key(|&group| (first[group], group));
        let mut place = vec![0; order.len()];
        (0..).zip(&order).for_each(|(new, &old)| place[old] = new);
        faces.iter_mut().for_each(|face| face.group = place[face.group as usize]);
        order.into_iter().map(|group| self.groups[group].clone()).collect()
    }
}
