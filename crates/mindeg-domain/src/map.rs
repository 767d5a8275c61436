//! Domains as maps: the faces that lines divide them into, and the lines as those of a mesh.

use std::ops::Range;

use glam::DVec2;
use mindeg_mesh::planar::{Border, Faces, PlanarBoundary};
use mindeg_mesh::{Line, LineKind, NamedVertex};

use crate::domain::Domain;
use crate::error::{DomainError, Place};
use crate::inside::Inside;
use crate::joined;
use crate::name;
use crate::side::{Intervals, Side};

impl Domain {
    /// The lines, points and regions inside the rings.
    pub fn inside(&self) -> &Inside {
        &self.inside
    }

    /// Whether degrees count more than the triangles of one polygon: lines or points are inside, which every mesh has, or
    /// sides are periodic.
    pub fn is_map(&self) -> bool {
        !self.inner_points().is_empty()
            || !self.inner_segments().is_empty()
            || self.periodic.is_some()
    }

    /// The points inside that every mesh has, of points and of lines: vertices after those of the rings.
    pub fn inner_points(&self) -> &[DVec2] {
        self.placement.boundary().map_or(&[], PlanarBoundary::inner_points)
    }

    /// The edges of all lines inside, by vertices, line after line.
    pub fn inner_segments(&self) -> &[[u32; 2]] {
        self.placement.boundary().map_or(&[], PlanarBoundary::segments)
    }

    /// The same domain with other lines, points and regions.
    ///
    /// # Errors
    ///
    /// The errors of [`DomainBuilder::build`](crate::DomainBuilder::build).
    pub fn with_inside(&self, inside: Inside) -> Result<Self, DomainError> {
        self.rebuilt(self.sides().to_vec(), inside)
    }

    /// The faces that lines divide the domain into, if it has lines or regions: those of
    /// [`Inside::regions`] first, in their order.
    pub fn faces(&self) -> Option<&Faces> {
        self.faces.as_deref()
    }

    /// The name of a line inside: that of the side, or one by the line's index from 1, such as "line 2".
    pub fn line_name(&self, line: usize, side: &Side) -> String {
        side.name.clone().unwrap_or_else(|| line_name(line))
    }

    /// The names of the sides and lines of domains, sorted, each once.
    pub fn names_of(domains: &[Self]) -> Vec<String> {
        let of = |domain: &Self| -> Vec<String> {
            let sides = (0..domain.sides().len()).map(|side| domain.side_name(side));
            let lines = domain.line_sides().map(|(line, side, _)| domain.line_name(line, side));
            sides.chain(lines).collect()
        };
        let mut names: Vec<String> = domains.iter().flat_map(of).collect();
        names.sort_unstable();
        names.dedup();
        names
    }

    /// The name of the region that is a face: "region 3" if it has none.
    pub fn region_name(&self, face: u32) -> String {
        let given = self.inside.regions.get(face as usize).and_then(|region| region.name.clone());
        given.unwrap_or_else(|| format!("region {}", face + 1))
    }

    /// The material of the region that is a face.
    pub fn region_material(&self, face: u32) -> Option<&str> {
        self.inside.regions.get(face as usize)?.material.as_deref()
    }

    /// Whether the region that is a face is a hole, which has no triangles.
    pub fn is_hole(&self, face: u32) -> bool {
        self.inside.regions.get(face as usize).is_some_and(|region| region.hole)
    }

    /// How many regions there are that are no holes: faces, of which several may share a name; one without lines.
    pub fn region_count(&self) -> usize {
        let is_open = |face: &u32| !self.is_hole(*face);
        self.faces().map_or(1, |faces| (0..faces.count as u32).filter(is_open).count())
    }

    /// How many holes there are: rings, and regions that are holes.
    pub fn hole_count(&self) -> usize {
        let regions = self.faces().map_or(0, |faces| faces.count - self.region_count());
        self.rings().ring_count() - 1 + regions
    }

    /// The boundary around the regions that are not holes, if one is. O(n log n).
    pub fn border(&self) -> Option<Border> {
        let has_holes = self.inside.regions.iter().any(|region| region.hole);
        let (faces, boundary) = (self.faces()?, self.placement.boundary()?);
        has_holes.then(|| boundary.border(faces, |face| self.is_hole(face)))
    }

    /// The area of the domain without holes, in square units. O(n log n).
    pub fn area(&self) -> f64 {
        self.border().map_or_else(|| self.placement.area(), |border| border.boundary.area())
    }

    /// The lines as lines of a mesh, over the [segments](mindeg_mesh::planar::PlanarBoundary::segments) of the
    /// boundary, with their kinds: one for each run of sides of one name.
    pub fn inner_lines(&self) -> Vec<(Line, Option<LineKind>)> {
        let mut lines: Vec<(Line, Option<LineKind>)> = Vec::new();
        let mut of_last = None;
        for (index, side, segments) in self.line_sides() {
            let name = self.line_name(index, side);
            let is_same_line = of_last.replace(index) == Some(index);
            match lines.last_mut().filter(|_| is_same_line) {
                Some((before, kind)) if before.name == name && *kind == side.kind => {
                    before.segments.end = segments.end;
                    before.is_straight = false;
                }
                _ => lines.push((Line { name, segments, is_straight: false }, side.kind)),
            }
        }
        lines
    }

    /// The points inside that have names, as named vertices of a mesh.
    pub fn named_vertices(&self) -> Vec<NamedVertex> {
        let points = self.inside.points.iter().zip(&self.point_vertices);
        points
            .filter_map(|(point, &vertex)| Some(NamedVertex { name: point.name.clone()?, vertex }))
            .collect()
    }

    /// For each segment of the lines, whether a mesh with interior points may divide it.
    pub fn divisible_segments(&self) -> Vec<bool> {
        self.line_sides()
            .flat_map(|(_, side, segments)| {
                segments.map(|_| matches!(side.intervals, Intervals::Size(_)))
            })
            .collect()
    }

    /// Checks that no side, line or region without a name gets that of another.
    pub(crate) fn check_unnamed(&self) -> Result<(), DomainError> {
        let sides = self.sides().iter().enumerate().filter(|(_, side)| side.name.is_none());
        let sides =
            sides.map(|(side, _)| (Place::side(self.rings().in_ring(side)), self.side_name(side)));
        let lines = self.inside.lines.iter().enumerate();
        let unnamed = lines.filter(|(_, line)| line.sides.iter().any(|side| side.name.is_none()));
        let unnamed = unnamed.map(|(line, _)| (joined::place(line), line_name(line)));
        let all = self.sides().iter().chain(self.inside.lines.iter().flat_map(|line| &line.sides));
        name::check_unnamed(all.filter_map(|side| side.name.as_deref()), sides.chain(unnamed))?;
        let regions = &self.inside.regions;
        let count = self.faces.as_ref().map_or(0, |faces| faces.count);
        let unnamed =
            (0..count).filter(|face| regions.get(*face).is_none_or(|region| region.name.is_none()));
        let unnamed =
            unnamed.map(|face| (Place::key("regions").then(face), self.region_name(face as u32)));
        name::check_unnamed(regions.iter().filter_map(|region| region.name.as_deref()), unnamed)
    }

    /// The sides of all lines inside, each with the index of its line and the indices of its
    /// [edges](Self::inner_segments).
    pub fn line_sides(&self) -> impl Iterator<Item = (usize, &Side, Range<u32>)> {
        let lines = self.inside.lines.iter().enumerate();
        let sides =
            lines.flat_map(|(index, line)| line.sides.iter().map(move |side| (index, side)));
        let segments = self.line_starts.windows(2).map(|ends| ends[0]..ends[1]);
        sides.zip(segments).map(|((index, side), segments)| (index, side, segments))
    }
}

/// The name of a line that has none.
fn line_name(line: usize) -> String {
    format!("line {}", line + 1)
}
