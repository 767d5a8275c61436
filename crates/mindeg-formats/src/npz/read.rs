//! Reading NPZ.

use super::array::{Array, texts};
use super::zip::{archive, entry};
use crate::ReadError;
use crate::raster::Raster;
use crate::runs::{Runs, Segments};
use glam::{DVec2, DVec3};
use mindeg_mesh::{NamedVertex, TriMesh};
use std::io::{Cursor, Read};
use zip::ZipArchive;

/// Reads a mesh from an NPZ: `points`, of two or three columns, and `triangles`, of three.
///
/// Both may be integers or floats of up to 64 bits, in either byte and array order; the numbers of
/// triangles are whole. Lines, groups and named vertices are read as mindeg writes them, where the numbers and the names are there;
/// other arrays are passed over. The file is held in memory; O(n) time.
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
    let corners = indices("triangles", &triangles, rows)?;
    let largest = positions.iter().map(|p| p.abs().max_element()).fold(0.0, f64::max);
    let mut mesh = TriMesh::new(positions, corners)?.with_rounding(largest * points.rounding());
    let mut note = None;
    let mut elements = Named { file: &file, archive: &mut archive };
    if let Some((groups, names)) = elements.pair("triangle_groups", "triangle_names")? {
        let mut runs = Runs::default();
        let count = mesh.triangles().len();
        length("triangle_groups", &groups, count)?;
        for triangle in 0..count {
            let (of, name) = named("triangle_groups", &groups, triangle, &names)?;
            runs.push(of, triangle + 1, || name.to_owned())?;
        }
        (mesh, note) = runs.give_to(mesh, "groups");
    }
    if let Some((groups, names)) = elements.pair("segment_groups", "segment_names")?
        && let Some(ends) = elements.array("segments")?
    {
        let ends = indices("segments", &ends, rows)?;
        let mut segments = Segments::default();
        length("segment_groups", &groups, ends.len())?;
        for (segment, ends) in ends.into_iter().enumerate() {
            let (of, name) = named("segment_groups", &groups, segment, &names)?;
            segments.push(of, ends, || name.to_owned())?;
        }
        let (lines, segments) = segments.into_lines();
        mesh = mesh.with_lines(lines, segments)?;
    }
    if let Some((vertices, names)) = elements.pair("named_points", "point_names")? {
        let mut points = Vec::new();
        length("named_points", &vertices, names.len())?;
        for (point, name) in names.into_iter().enumerate() {
            let vertex = index(&vertices, [0, point], rows)
                .map_err(|problem| ReadError::place(format!("named_points[{point}]"), problem))?;
            points.push(NamedVertex { vertex, name });
        }
        mesh = mesh.with_named_vertices(points)?;
    }
    Ok(mesh.with_notes(note.into_iter().collect()))
}

/// The arrays of names and of what has them.
struct Named<'f, 'a> {
    file: &'f [u8],
    archive: &'a mut ZipArchive<Cursor<&'f [u8]>>,
}

impl<'f> Named<'f, '_> {
    fn array(&mut self, name: &str) -> Result<Option<Array<'f>>, ReadError> {
        let found = entry(self.file, self.archive, &format!("{name}.npy"))?;
        found.map(|(offset, bytes)| Array::new(offset, bytes)).transpose()
    }

    /// An array of numbers and one of names, if both are there.
    fn pair(
        &mut self,
        numbers: &str,
        names: &str,
    ) -> Result<Option<(Array<'f>, Vec<String>)>, ReadError> {
        let Some((offset, bytes)) = entry(self.file, self.archive, &format!("{names}.npy"))? else {
            return Ok(None);
        };
        let Some(numbers) = self.array(numbers)? else { return Ok(None) };
        let names =
            texts(offset, &bytes).map_err(|error| ReadError::place(names, error.to_string()))?;
        Ok(Some((numbers, names)))
    }
}

/// Checks the length of an array of one dimension.
fn length(name: &str, array: &Array<'_>, expected: usize) -> Result<(), ReadError> {
    match array.shape() {
        [1, length] if length == expected => Ok(()),
        [rows, columns] => {
            let problem = format!("has the shape ({rows}, {columns}), expected {expected} numbers");
            Err(ReadError::place(name, problem))
        }
    }
}

/// The index of the name of an item and the name; -1 and an empty one of an item without.
fn named<'n>(
    array: &str,
    groups: &Array<'_>,
    item: usize,
    names: &'n [String],
) -> Result<(i64, &'n str), ReadError> {
    let wrong = |found: String| {
        let problem =
            format!("is {found}; there are {} names, from 0, and -1 is none", names.len());
        ReadError::place(format!("{array}[{item}]"), problem)
    };
    match groups.index(0, item) {
        Ok(index) => {
            let name = names.get(index as usize).ok_or_else(|| wrong(index.to_string()))?;
            Ok((i64::from(index), name))
        }
        Err(none) if none == "-1" => Ok((-1, "")),
        Err(found) => Err(wrong(found)),
    }
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

/// An array with rows of indices of vertices.
fn indices<const N: usize>(
    name: &str,
    array: &Array<'_>,
    vertices: usize,
) -> Result<Vec<[u32; N]>, ReadError> {
    let [rows, columns] = array.shape();
    if columns != N {
        return Err(ReadError::place(name, format!("has {columns} columns, not {N}")));
    }
    let mut all = Vec::new();
    all.try_reserve_exact(rows)?;
    for row in 0..rows {
        let mut indices = [0; N];
        for (column, found) in indices.iter_mut().enumerate() {
            *found = index(array, [row, column], vertices)
                .map_err(|problem| ReadError::place(format!("{name}[{row}, {column}]"), problem))?;
        }
        all.push(indices);
    }
    Ok(all)
}

/// The index of a vertex, or why it is none.
fn index(array: &Array<'_>, [row, column]: [usize; 2], vertices: usize) -> Result<u32, String> {
    let index = array.index(row, column);
    let index = index.and_then(|index| match (index as usize) < vertices {
        true => Ok(index),
        false => Err(index.to_string()),
    });
    index.map_err(|index| format!("is {index}; there are {vertices} points, from 0"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::npz::array::head;
    use crate::npz::zip::Archive;
    use crate::{Format, WriteOptions, write};
    use mindeg_mesh::{Group, Line};

    fn square() -> TriMesh {
        let points = vec![DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y];
        TriMesh::new(points, vec![[0, 1, 2], [0, 2, 3]]).unwrap()
    }

    fn file(mesh: &TriMesh) -> Vec<u8> {
        let mut file = Vec::new();
        write(Format::Npz, mesh, &WriteOptions::default(), &mut file).unwrap();
        file
    }

    #[test]
    fn names_are_read_again() {
        let line =
            |name: &str, segments| Line { name: name.to_owned(), segments, is_straight: false };
        let named = |vertex, name: &str| NamedVertex { vertex, name: name.to_owned() };
        let mesh = square()
            .with_groups(vec![
                Group::new("água".to_owned(), 0..1),
                Group::new("b".to_owned(), 1..2),
            ])
            .with_lines(vec![line("side", 0..2), line("", 2..3)], vec![[0, 1], [1, 2], [0, 2]])
            .and_then(|mesh| mesh.with_named_vertices(vec![named(3, "gauge"), named(0, "g")]))
            .unwrap();
        let read = read(&file(&mesh)[..]).unwrap();
        let parts = |mesh: &TriMesh| {
            let groups =
                mesh.groups().iter().map(|group| (group.name.clone(), group.triangles.clone()));
            let lines = mindeg_mesh::Triangles::lines(mesh).to_vec();
            let named = mindeg_mesh::Triangles::named_vertices(mesh).to_vec();
            (groups.collect::<Vec<_>>(), lines, named)
        };
        assert_eq!(parts(&read), parts(&mesh));
        assert_eq!(file(&read), file(&mesh));
    }

    #[test]
    fn names_that_do_not_fit_are_told() {
        let names: Vec<u8> = ['a', 'b'].iter().flat_map(|c| u32::from(*c).to_le_bytes()).collect();
        let numbers =
            |numbers: &[i32]| numbers.iter().flat_map(|n| n.to_le_bytes()).collect::<Vec<u8>>();
        let read = |groups: (Vec<u8>, Vec<u8>), kind: &str, names: &[u8]| {
            let mut written = Vec::new();
            let mut archive = Archive::new(&mut written);
            let points: Vec<u8> =
                [0.0_f64, 0.0, 1.0, 0.0, 0.0, 1.0].iter().flat_map(|x| x.to_le_bytes()).collect();
            let triangles = numbers(&[0, 1, 2]);
            for (name, head, body) in [
                ("points.npy", head("<f8", 3, Some(2)), &points[..]),
                ("triangles.npy", head("<i4", 1, Some(3)), &triangles),
                ("triangle_groups.npy", groups.0, &groups.1),
                ("triangle_names.npy", head(kind, 2, None), names),
            ] {
                let len = (head.len() + body.len()) as u64;
                archive
                    .entry(name, len, |mut out| {
                        std::io::Write::write_all(&mut out, &head)?;
                        std::io::Write::write_all(&mut out, body)
                    })
                    .unwrap();
            }
            archive.finish().unwrap();
            super::read(&written[..])
                .map(|mesh| mesh.groups().first().map(|group| group.name.clone()))
        };
        let of = |index: i32| (head("<i4", 1, None), numbers(&[index]));
        assert_eq!(read(of(1), "<U1", &names).unwrap().as_deref(), Some("b"));
        assert_eq!(read(of(-1), "<U1", &names).unwrap().as_deref(), Some(""));
        let big: Vec<u8> =
            names.chunks(4).flat_map(|letter| letter.iter().rev().copied()).collect();
        assert_eq!(read(of(0), ">U1", &big).unwrap().as_deref(), Some("a"));
        for (groups, kind, names, problem) in [
            (
                of(2),
                "<U1",
                &names[..],
                "triangle_groups[0]: is 2; there are 2 names, from 0, and -1 is none",
            ),
            (of(0), "<i4", &names, "expected text"),
            (of(0), "<U2", &names, "is not what its shape"),
            (of(0), "<U99999999999999999999", &names, "expected text"),
            (
                of(0),
                "<U1",
                &[0, 0, 0, 0, 0, 216, 0, 0],
                "text 1 has letters that Unicode does not know",
            ),
            (
                (head("<i4", 2, None), numbers(&[0, 0])),
                "<U1",
                &names,
                "triangle_groups: has the shape (1, 2), expected 1 numbers",
            ),
        ] {
            let error = read(groups, kind, names).unwrap_err().to_string();
            assert!(error.contains(problem), "{error}");
        }
    }
}
