//! Reading NPZ.

use super::array::Array;
use super::zip::{Stored, entries};
use crate::ReadError;
use glam::DVec3;
use mindeg_mesh::TriMesh;
use std::io::Read;

/// Reads a mesh from an NPZ: `points`, of two or three columns, and `triangles`, of three.
///
/// Both may be integers or floats of up to 64 bits, in either byte and array order; the numbers of
/// triangles are whole. Other arrays are passed over. The file is held in memory; O(n) time.
///
/// # Errors
///
/// Errors of the input; an archive or arrays that are not as the format has them, or
/// have another shape; coordinates that are not finite, and indices of vertices that are not there.
///
/// # Example
///
/// ```
/// use mindeg_formats::{Format, WriteOptions, npz, obj, write};
///
/// let mesh = obj::read("v 0 0 0\nv 2 0 0\nv 2 1 0\nf 1 2 3\n".as_bytes())?;
/// let mut file = Vec::new();
/// write(Format::Npz, &mesh, &WriteOptions::default(), &mut file)?;
/// assert_eq!(npz::read(&file[..])?.positions(), mesh.positions());
///
/// let error = npz::read(&file[..file.len() - 30]).unwrap_err();
/// assert!(error.to_string().ends_with("the file has no zip directory; it may have been cut off"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn read(mut input: impl Read) -> Result<TriMesh, ReadError> {
    let mut file = Vec::new();
    input.read_to_end(&mut file)?;
    let entries = entries(&file)?;
    let [points, triangles] = ["points", "triangles"].map(|name| array(&entries, name));
    let (points, triangles) = (points?, triangles?);
    let [rows, columns] = points.shape();
    if !matches!(columns, 2 | 3) {
        let problem = format!("has {columns} columns, not 2 or 3");
        return Err(ReadError::place("points", problem));
    }
    let mut positions = Vec::new();
    positions.try_reserve_exact(rows)?;
    for row in 0..rows {
        let z = if columns == 3 { points.float(row, 2) } else { 0.0 };
        positions.push(DVec3::new(points.float(row, 0), points.float(row, 1), z));
    }
    let corners = corners(&triangles, rows)?;
    let largest = positions.iter().map(|p| p.abs().max_element()).fold(0.0, f64::max);
    let mesh = TriMesh::new(positions, corners)?;
    Ok(mesh.with_rounding(largest * points.rounding()))
}

fn array<'a>(entries: &[Stored<'a>], name: &str) -> Result<Array<'a>, ReadError> {
    let is_named = |entry: &&Stored<'_>| entry.name.strip_suffix(".npy") == Some(name);
    let entry = entries.iter().find(is_named).ok_or_else(|| {
        let found: Vec<_> = entries.iter().take(20).map(|entry| &*entry.name).collect();
        let problem = format!(
            "the archive has no such array; a mesh has points and triangles, this one has: {}",
            found.join(", ")
        );
        ReadError::place(name, problem)
    })?;
    let (offset, bytes) = entry.bytes()?;
    Array::new(offset, bytes)
}

fn corners(triangles: &Array<'_>, vertices: usize) -> Result<Vec<[u32; 3]>, ReadError> {
    let [rows, columns] = triangles.shape();
    if columns != 3 {
        return Err(ReadError::place("triangles", format!("has {columns} columns, not 3")));
    }
    let mut corners = Vec::new();
    corners.try_reserve_exact(rows)?;
    for row in 0..rows {
        let mut triangle = [0; 3];
        for (column, corner) in triangle.iter_mut().enumerate() {
            let index = triangles.index(row, column);
            let index = index.and_then(|index| match (index as usize) < vertices {
                true => Ok(index),
                false => Err(index.to_string()),
            });
            *corner = index.map_err(|index| {
                let place = format!("triangles[{row}, {column}]");
                let problem = format!("is {index}; there are {vertices} points, from 0");
                ReadError::place(place, problem)
            })?;
        }
        corners.push(triangle);
    }
    Ok(corners)
}
