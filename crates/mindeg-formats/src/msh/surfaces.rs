//! The surfaces of a file by the edges around them.

use std::collections::{BTreeMap, BTreeSet, HashMap, TryReserveError};

use mindeg_mesh::sorted;

use crate::ReadError;
use crate::lists::push;
use crate::names::PHYSICAL;
use crate::runs::PlaneSurface;
use crate::scanner::Scanner;

/// Which physical group each entity is in, by dimension and tag: the first one.
#[derive(Default)]
pub(super) struct PhysicalGroups {
    pub(super) of: HashMap<(i64, i64), i64>,
    /// Groups with an entity that another one has already.
    left: BTreeSet<(i64, i64)>,
}

impl PhysicalGroups {
    /// An entity is in a group.
    pub(super) fn add(&mut self, entity: (i64, i64), physical: i64) {
        if *self.of.entry(entity).or_insert(physical) != physical {
            self.left.insert((entity.0, physical));
        }
    }

    /// The names of the groups of points, curves and surfaces that have not all that the file puts into them.
    pub(super) fn left(&self, names: &HashMap<(i64, i64), String>) -> Vec<String> {
        let seen = self.left.iter().filter(|(dimension, _)| *dimension < 3);
        seen.map(|(dimension, physical)| physical_name(names, *dimension, *physical)).collect()
    }
}

/// The surfaces of a file so far.
#[derive(Default)]
pub(super) struct Surfaces {
    curves: BTreeSet<i64>,
    /// By tag.
    surfaces: BTreeMap<i64, Parts>,
}

/// A surface as the file describes it.
#[derive(Default)]
struct Parts {
    name: String,
    /// The tags of curves; an embedded one may be among them, under a tag that no curve has.
    bounding: Vec<i64>,
    /// The edges of all its faces.
    edges: Vec<[u32; 2]>,
}

impl Surfaces {
    /// Reads `$Entities`: the physical tags of each, and the curves and surfaces.
    pub(super) fn take_entities(
        &mut self,
        scanner: &mut Scanner<'_>,
        names: &HashMap<(i64, i64), String>,
        groups: &mut PhysicalGroups,
    ) -> Result<(), ReadError> {
        let mut counts = [0; 4];
        for count in &mut counts {
            *count = scanner.size("the number of entities")?;
        }
        for (dimension, count) in (0..).zip(counts) {
            for _ in 0..count {
                let tag = scanner.int("the tag of an entity")?;
                for _ in 0..if dimension == 0 { 3 } else { 6 } {
                    scanner.double("the box of an entity")?;
                }
                for _ in 0..scanner.size("the number of physical tags")? {
                    // Negative where the group runs the other way.
                    let physical = scanner.int("a physical tag")?.saturating_abs();
                    groups.add((dimension, tag), physical);
                }
                let mut bounding = Vec::new();
                if dimension > 0 {
                    for _ in 0..scanner.size("the number of bounding entities")? {
                        let tag = scanner.int("the tag of a bounding entity")?.saturating_abs();
                        push(&mut bounding, tag)?;
                    }
                }
                match dimension {
                    1 => {
                        self.curves.insert(tag);
                    }
                    2 => {
                        let physical = groups.of.get(&(2, tag));
                        let name = physical.map(|physical| physical_name(names, 2, *physical));
                        let name = name.unwrap_or_default();
                        self.surfaces.insert(tag, Parts { name, bounding, edges: Vec::new() });
                    }
                    _ => {}
                }
            }
        }
        Ok(())
    }

    /// Adds a face; `name` is called for a new surface.
    pub(super) fn add_face(
        &mut self,
        surface: i64,
        name: impl FnOnce() -> String,
        corners: &[u32],
    ) -> Result<(), TryReserveError> {
        let new = || Parts { name: name(), ..Parts::default() };
        let edges = &mut self.surfaces.entry(surface).or_insert_with(new).edges;
        for (index, &corner) in corners.iter().enumerate() {
            push(edges, [corner, corners[(index + 1) % corners.len()]])?;
        }
        Ok(())
    }

    /// The edges around each surface, from the segments of each curve.
    pub(super) fn outlines(
        self,
        segments: &HashMap<i64, Vec<[u32; 2]>>,
    ) -> Result<Vec<PlaneSurface>, ReadError> {
        let Self { curves, surfaces } = self;
        let mut found = Vec::new();
        for (tag, Parts { name, bounding, edges }) in surfaces {
            let mut edges = edges;
            if edges.is_empty() {
                for curve in bounding.iter().filter(|curve| curves.contains(curve)) {
                    let own = segments.get(curve).ok_or_else(|| {
                        let problem = format!(
                            "curve {curve} bounds it and has no line elements; put all its curves into physical \
                             groups, or save all elements (gmsh -save_all)"
                        );
                        ReadError::place(surface_name(tag, &name), problem)
                    })?;
                    edges.extend_from_slice(own);
                }
            }
            let edges = around(edges);
            if !edges.is_empty() {
                found.push(PlaneSurface { name, edges });
            }
        }
        Ok(found)
    }
}

/// The name of a physical group by dimension and tag.
pub(super) fn physical_name(
    names: &HashMap<(i64, i64), String>,
    dimension: i64,
    tag: i64,
) -> String {
    match names.get(&(dimension, tag)) {
        Some(name) if !name.trim().is_empty() => name.clone(),
        _ => format!("{PHYSICAL} {tag}"),
    }
}

/// The only surface that a file names without saying where it is: all lines bound it that do not end within it.
///
/// # Errors
///
/// Several names.
pub(super) fn only_named(
    names: &HashMap<(i64, i64), String>,
    segments: &[[u32; 2]],
) -> Result<Option<PlaneSurface>, ReadError> {
    let of_surfaces = names.iter().filter(|((dimension, _), _)| *dimension == 2);
    let mut names: Vec<&str> = of_surfaces.map(|(_, name)| &**name).collect();
    if names.len() < 2 {
        let surface = |name: &&str| {
            let edges = around(segments.to_vec());
            (!edges.is_empty()).then(|| PlaneSurface { name: (*name).to_owned(), edges })
        };
        return Ok(names.first().and_then(surface));
    }
    names.sort_unstable();
    let problem = format!(
        "the file names {} surfaces ({}), and MSH 2.2 without faces does not say where they are; save it as MSH 4.1 \
         (gmsh -1 -format msh4), or with its faces (gmsh -2)",
        names.len(),
        names.join(", ")
    );
    Err(ReadError::place("$PhysicalNames", problem))
}

fn surface_name(tag: i64, name: &str) -> String {
    if name.is_empty() { format!("surface {tag}") } else { format!("surface {tag} ({name})") }
}

/// The edges that come an odd number of times, without chains that end within the surface. O(n log n).
fn around(edges: Vec<[u32; 2]>) -> Vec<[u32; 2]> {
    let mut counts: HashMap<[u32; 2], u32> = HashMap::new();
    edges.iter().for_each(|&edge| *counts.entry(sorted(edge)).or_default() += 1);
    let mut kept = edges;
    kept.retain(|&[a, b]| {
        // The first of them stays.
        let count = counts.get_mut(&sorted([a, b])).map_or(0, std::mem::take);
        a != b && count % 2 == 1
    });
    let mut at: HashMap<u32, Vec<usize>> = HashMap::new();
    for (index, edge) in kept.iter().enumerate() {
        edge.iter().for_each(|end| at.entry(*end).or_default().push(index));
    }
    let mut is_dropped = vec![false; kept.len()];
    let ends = kept.iter().flatten().copied().filter(|end| at[end].len() == 1);
    let mut ends: Vec<u32> = ends.collect();
    while let Some(end) = ends.pop() {
        let mut open = at[&end].iter().copied().filter(|&index| !is_dropped[index]);
        let (Some(index), None) = (open.next(), open.next()) else { continue };
        is_dropped[index] = true;
        ends.extend(kept[index].iter().filter(|other| **other != end));
    }
    let mut dropped = is_dropped.into_iter();
    kept.retain(|_| dropped.next() == Some(false));
    kept
}
