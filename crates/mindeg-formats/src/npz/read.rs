//! Reading NPZ.

use super::array::Array;
use super::zip::{archive, entry};
use crate::ReadError;
use crate::field::Raster;
use glam::{DVec2, DVec3};
use mindeg_mesh::TriMesh;
use std::io::{Cursor, Read};
use zip::ZipArchive;

/// Reads a mesh from an NPZ: `points`, of two or three columns, and `triangles`, of three.
///
/// Both may be integers or floats of up to 64 bits, in either byte and array order; the numbers of
/// triangles are whole. Other arrays are passed over. The file is held in memory; O(n) time.
///
/// # Errors
///
/// Errors of the input; an archive or arrays that break the format, or
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
    let mut archive = archive(&file)?;
    let arrays = ["points", "triangles"].map(|name| array(&file, &mut archive, name));
    let [points, triangles] = arrays;
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

/// Reads a grid from an NPZ: `values`, a row for each y, with `origin` and `spacing`, each x and y.
pub(crate) fn read_raster(file: &[u8]) -> Result<Raster, ReadError> {
    let mut archive = archive(file)?;
    let mut found = |name: &str| match entry(file, &mut archive, &format!("{name}.npy"))? {
        Some((offset, bytes)) => Array::new(offset, bytes),
        None => Err(ReadError::place(
            name,
            "the archive has no such array; a grid has values, origin and spacing",
        )),
    };
    let [values, origin, spacing] = [found("values")?, found("origin")?, found("spacing")?];
    let pair = |array: &Array<'_>, name: &str| match array.shape() {
        [1, 2] => Ok(DVec2::new(array.float(0, 0), array.float(0, 1))),
        _ => Err(ReadError::place(name, "it should be two numbers, of x and y")),
    };
    let (origin, spacing) = (pair(&origin, "origin")?, pair(&spacing, "spacing")?);
    if !(origin.is_finite() && spacing.is_finite() && spacing.min_element() > 0.0) {
        return Err(ReadError::place("spacing", "it and the origin are finite, and it is above 0"));
    }
    let [rows, columns] = values.shape();
    let at = (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column)));
    let values = at.map(|(row, column)| values.float(row, column)).collect();
    Ok(Raster { origin, spacing, columns, values })
}

fn array<'a>(
    file: &'a [u8],
    archive: &mut ZipArchive<Cursor<&[u8]>>,
    name: &str,
) -> Result<Array<'a>, ReadError> {
    let Some((offset, bytes)) = entry(file, archive, &format!("{name}.npy"))? else {
        let found: Vec<_> = archive.file_names().take(20).collect();
        let problem = format!(
            "the archive has no such array; a mesh has points and triangles, this one has: {}",
            found.join(", ")
        );
        return Err(ReadError::place(name, problem));
    };
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
