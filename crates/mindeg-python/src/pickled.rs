//! The parts of a mesh that is pickled, beside its points and triangles.

use std::sync::Arc;

use mindeg::{Group, Material, TriMesh};
use mindeg_mesh::{LineKind, NamedVertex, PeriodicLine};
use pyo3::PyResult;

use crate::work::value_error;

/// Names, ranges of triangles and materials.
pub(crate) type PickledGroups = Vec<(String, [u32; 2], Option<PickledMaterial>)>;

/// A name, and a base color if it is known.
pub(crate) type PickledMaterial = (String, Option<[f32; 4]>);

/// A periodic line, the other one, the matrix and the pairs of vertices.
pub(crate) type PickledPeriodic = (u32, u32, [[f64; 4]; 4], Vec<[u32; 2]>);

/// Groups, depths, named vertices and periodic lines.
pub(crate) type PickledParts =
    (PickledGroups, Option<Vec<f64>>, Vec<(String, u32)>, Vec<PickledPeriodic>);

/// A mesh with its name, its lines with their facts, and its other parts.
pub(crate) fn mesh(
    mut mesh: TriMesh,
    name: Option<String>,
    lines: Vec<(String, Vec<[u32; 2]>)>,
    of_lines: (Vec<bool>, Vec<Option<String>>),
    of_mesh: PickledParts,
) -> PyResult<TriMesh> {
    let wrong = |what: &str| value_error(format!("{what} of a pickled mesh do not fit it"));
    let [vertices, triangles] = [mesh.positions().len(), mesh.triangles().len()];
    let (straight, kinds) = of_lines;
    if [straight.len(), kinds.len()] != [lines.len(); 2] {
        return Err(wrong("lines"));
    }
    let (mut all, mut segments) = (Vec::new(), Vec::new());
    for ((name, line), is_straight) in lines.into_iter().zip(straight) {
        let start = segments.len() as u32;
        segments.extend(line);
        all.push(mindeg::Line { name, segments: start..segments.len() as u32, is_straight });
    }
    mesh = mesh.called(name).with_lines(all, segments).map_err(value_error)?;
    let kinds = kinds.iter().map(|kind| kind.as_deref().and_then(LineKind::named));
    mesh = mesh.with_line_kinds(kinds.collect());
    let (groups, depths, named, periodic) = of_mesh;
    let periodic = periodic.into_iter();
    let periodic =
        periodic.map(|(line, of, matrix, vertices)| PeriodicLine { line, of, matrix, vertices });
    mesh = mesh.with_periodic_lines(periodic.collect()).map_err(value_error)?;
    let named = named.into_iter().map(|(name, vertex)| NamedVertex { name, vertex });
    mesh = mesh.with_named_vertices(named.collect()).map_err(value_error)?;
    let mut at = 0;
    let mut all = Vec::new();
    for (name, [start, end], material) in groups {
        if start != at || end <= start || end as usize > triangles {
            return Err(wrong("groups"));
        }
        at = end;
        let material = material.map(|(name, color)| Arc::new(Material { name, color }));
        all.push(Group::new(name, start..end).of_material(material));
    }
    if at as usize == triangles {
        mesh = mesh.with_groups(all);
    } else if at > 0 {
        return Err(wrong("groups"));
    }
    if let Some(depths) = depths {
        if depths.len() != vertices || !depths.iter().all(|depth| depth.is_finite()) {
            return Err(wrong("depths"));
        }
        mesh = mesh.with_depths(depths);
    }
    Ok(mesh)
}
