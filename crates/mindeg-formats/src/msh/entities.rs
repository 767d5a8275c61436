//! The entities and physical groups that a mesh is written as.

use std::collections::HashMap;
use std::ops::Range;

use glam::DVec3;
use mindeg_mesh::{Bounds, Mesh, NamedVertex};

use crate::corners::{Corners, segments};
use crate::mesh_name;
use crate::names::{MARKER, Names, PHYSICAL, numbers, quoted};

/// The entities of a mesh: a point for each named vertex, a curve for each line, a surface for each group.
pub(super) struct Entities {
    pub(super) points: Vec<Entity>,
    pub(super) curves: Vec<Entity>,
    pub(super) surfaces: Vec<Entity>,
    /// Dimension, physical tag and name.
    pub(super) physical_names: Vec<(i32, i32, String)>,
}

/// One entity; its tag is its index in the list and one more.
pub(super) struct Entity {
    pub(super) physical: i32,
    /// The vertex of a point, the segments of a curve, the triangles of a surface.
    pub(super) elements: Range<u32>,
}

impl Entities {
    /// O(g) for g lines, groups and named vertices.
    pub(super) fn of(mesh: &dyn Mesh) -> Self {
        let mut physical_names = Vec::new();
        let mut physical =
            Physical { tags: HashMap::new(), names: &mut physical_names, of: Default::default() };
        let lines = mesh.lines();
        let curve = |line: &mindeg_mesh::Line| Entity {
            physical: physical.tag(1, &line.name),
            elements: line.segments.clone(),
        };
        let curves = lines.iter().map(curve).collect();
        let mut surface = |name: &str, elements: Range<u32>| {
            let name = if name.is_empty() { mesh_name(mesh) } else { name };
            Entity { physical: physical.tag(2, name), elements }
        };
        let mut surfaces: Vec<Entity> = mesh
            .groups()
            .iter()
            .map(|group| surface(group.label(), group.triangles.clone()))
            .collect();
        if surfaces.is_empty() {
            surfaces.push(surface("", 0..mesh.triangle_count()));
        }
        let named = mesh.named_vertices();
        let point = |named: &NamedVertex| Entity {
            physical: physical.tag(0, &named.name),
            elements: named.vertex..named.vertex + 1,
        };
        let points = named.iter().map(point).collect();
        let mut all = Self { points, curves, surfaces, physical_names };
        all.renumber();
        all
    }

    /// Gives physical groups that are called by a number that tag. Tags have 31 bits.
    fn renumber(&mut self) {
        let names = self.physical_names.iter().map(|(_, _, name)| &**name);
        let tags = numbers(names, &[MARKER, PHYSICAL], 1..=i32::MAX.into());
        let new = |tag: i32| tags[tag as usize - 1] as i32;
        let entities = [&mut self.points, &mut self.curves, &mut self.surfaces];
        for entity in entities.into_iter().flatten() {
            entity.physical = new(entity.physical);
        }
        for (_, tag, _) in &mut self.physical_names {
            *tag = new(*tag);
        }
    }

    /// How many segments the curves have.
    pub(super) fn segment_count(&self) -> u32 {
        self.curves.last().map_or(0, |curve| curve.elements.end)
    }

    pub(super) fn element_count(&self, mesh: &dyn Mesh) -> u64 {
        let points = self.points.len() as u64;
        u64::from(self.segment_count()) + u64::from(mesh.triangle_count()) + points
    }
}

/// Physical groups, one for each dimension and name.
struct Physical<'a> {
    tags: HashMap<(i32, String), i32>,
    names: &'a mut Vec<(i32, i32, String)>,
    /// The names of points, of curves, and of surfaces.
    of: [Names; 3],
}

impl Physical<'_> {
    /// The tags count from 1, in the order of the groups.
    fn tag(&mut self, dimension: u8, name: &str) -> i32 {
        let name = self.of[usize::from(dimension)].of(name, quoted);
        let dimension = i32::from(dimension);
        let next = self.names.len() as i32 + 1;
        *self.tags.entry((dimension, name)).or_insert_with_key(|(dimension, name)| {
            self.names.push((*dimension, next, name.clone()));
            next
        })
    }
}

/// The smallest box around some segments. O(1) for a straight line, else O(n).
pub(super) fn bounds_of_line(mesh: &dyn Mesh, line: &mindeg_mesh::Line) -> Bounds<DVec3> {
    const BLOCK: u32 = 1 << 12;
    let mut corners = Corners::new(mesh);
    let mut bounds: Option<Bounds<DVec3>> = None;
    let Range { start, end } = line.segments;
    let mut add = |range: Range<u32>| {
        for vertex in segments(mesh, range).into_iter().flatten() {
            let point = corners.position(vertex);
            let at = Bounds { min: point, max: point };
            bounds = Some(bounds.map_or(at, |bounds| bounds.union(at)));
        }
    };
    if line.is_straight && end - start > 2 {
        add(start..start + 1);
        add(end - 1..end);
    } else {
        let starts = (start..end).step_by(BLOCK as usize);
        starts.for_each(|start| add(start..start.saturating_add(BLOCK).min(end)));
    }
    bounds.unwrap_or(Bounds { min: DVec3::ZERO, max: DVec3::ZERO })
}
