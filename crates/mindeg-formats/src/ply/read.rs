//! Reading PLY.

use super::header::{Element, Header, Property};
use crate::ReadError;
use crate::bytes::Bytes;
use crate::dropped;
use crate::face_list::FaceList;
use crate::lists::push;
use crate::numbers::{Numbers, Scalar};
use crate::records::Records;
use glam::DVec3;
use mindeg_mesh::{NonTriangles, TriMesh};
use std::io::BufRead;

/// Reads a mesh from a PLY: ascii, or binary of either byte order.
///
/// Vertices are the rows of `vertex`, with `x`, `y` and `z` (0 where it is missing) of any type;
/// faces are the lists `vertex_indices` or `vertex_index` of `face`. Faces of more than three
/// corners are kept as the mesh's polygons; of fewer, they are left out, with a note. All other
/// properties are passed over; other elements are, too, with a note.
///
/// O(n) time and memory for n bytes, whatever the header says, but for the cutting of polygons.
///
/// # Errors
///
/// Errors of the input; a header or rows that break the format, corners that the
/// file has no vertex for, positions that are not finite, and a file without faces.
///
/// # Example
///
/// ```
/// use mindeg_formats::ply;
///
/// let file = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n\
///             property float z\nelement face 1\nproperty list uchar int vertex_index\n\
///             end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
/// assert_eq!(ply::read(file.as_bytes())?.triangles(), [[0, 1, 2]]);
///
/// let error = ply::read(file.replace("0 1 2", "0 1 3").as_bytes()).unwrap_err();
/// assert_eq!(error.to_string(), "line 13: vertex 3 does not exist; the file has 3, from 0");
/// # Ok::<(), mindeg_formats::ReadError>(())
/// ```
pub fn read(mut input: impl BufRead) -> Result<TriMesh, ReadError> {
    let header = Header::read(&mut input)?;
    let source = match header.encoding {
        Numbers::Text => {
            Source::Text { records: Records::new(input, None).after(header.lines), at: 0 }
        }
        encoding => Source::Binary {
            bytes: Bytes::new(input, header.bytes),
            is_big: encoding == Numbers::BigEndian,
        },
    };
    let mut contents = Contents {
        source,
        vertices: header.count("vertex"),
        positions: Vec::new(),
        rounding: 0.0,
        faces: FaceList::default(),
        short: 0,
        passed_over: Vec::new(),
    };
    let dropped = dropped_of(&header);
    for element in &header.elements {
        match &*element.name {
            "vertex" => contents.take_vertices(element)?,
            "face" => contents.take_faces(element)?,
            _ => contents.pass_over(element)?,
        }
    }
    Ok(contents.into_mesh()?.with_dropped(dropped))
}

/// The kinds of values at vertices and corners that the mesh lacks, by the names that programs give them.
fn dropped_of(header: &Header) -> Vec<&'static str> {
    let properties = || {
        let elements = header.elements.iter().filter(|element| element.count > 0);
        let whole = elements.filter(|element| matches!(&*element.name, "vertex" | "face"));
        whole.flat_map(|element| &element.properties)
    };
    let is_there = |names: &[&str]| properties().any(|it| names.contains(&&*it.name));
    dropped::found([
        (dropped::TEXTURE, is_there(&["s", "u", "texture_u", "texcoord"])),
        (dropped::NORMALS, is_there(&["nx"])),
        (dropped::COLORS, is_there(&["red", "r", "diffuse_red"])),
    ])
}

/// Where the numbers of the rows come from.
enum Source<R> {
    /// The rows, and where in the row the next number is.
    Text {
        records: Records<R>,
        at: usize,
    },
    Binary {
        bytes: Bytes<R>,
        is_big: bool,
    },
}

impl<R: BufRead> Source<R> {
    fn start_row(&mut self, element: &Element) -> Result<(), ReadError> {
        if let Self::Text { records, at } = self {
            records.expect(&format!("the last row of the element {:?}", element.name))?;
            *at = 0;
        }
        Ok(())
    }

    fn number(&mut self, property: &Property, scalar: Scalar) -> Result<f64, ReadError> {
        match self {
            Self::Text { records, at } => {
                let mut words = records.words(*at..);
                let before = words.rest.len();
                let number = words.number(&property.name)?;
                *at += before - words.rest.len();
                Ok(number)
            }
            Self::Binary { bytes, is_big } => {
                let mut number = [0; 8];
                let digits = &mut number[..scalar.len()];
                bytes.fill(digits, &property.name)?;
                Ok(scalar.float(digits, *is_big))
            }
        }
    }

    /// Gives each number of a property to `take`.
    fn numbers(
        &mut self,
        property: &Property,
        mut take: impl FnMut(&Self, f64) -> Result<(), ReadError>,
    ) -> Result<(), ReadError> {
        let mut rest = 1.0;
        if let Some(scalar) = property.list {
            rest = self.number(property, scalar)?;
            if rest < 0.0 || rest.fract() != 0.0 {
                return Err(self.problem(format!("a list has {rest} numbers")));
            }
        }
        while rest > 0.0 {
            let number = self.number(property, property.scalar)?;
            take(self, number)?;
            rest -= 1.0;
        }
        Ok(())
    }

    fn problem(&self, problem: String) -> ReadError {
        match self {
            Self::Text { records, .. } => records.words(..).problem(problem),
            Self::Binary { bytes, .. } => bytes.problem(problem),
        }
    }
}

/// The contents of the rows read so far.
struct Contents<R> {
    source: Source<R>,
    /// How many vertices the header names.
    vertices: u64,
    positions: Vec<DVec3>,
    rounding: f64,
    faces: FaceList,
    /// How many faces have fewer than three corners.
    short: u64,
    passed_over: Vec<String>,
}

impl<R: BufRead> Contents<R> {
    fn take_vertices(&mut self, element: &Element) -> Result<(), ReadError> {
        let axes = ["x", "y", "z"];
        let axis_of = |property: &Property| {
            let axis = axes.iter().position(|axis| *axis == property.name);
            axis.filter(|_| property.list.is_none())
        };
        let has = |axis| element.properties.iter().any(|property| axis_of(property) == Some(axis));
        if element.count > 0 && !(has(0) && has(1)) {
            return Err(ReadError::place("the element vertex", "has no properties x and y"));
        }
        let mut largest = 0.0_f64;
        for _ in 0..element.count {
            self.source.start_row(element)?;
            let mut point = DVec3::ZERO;
            for property in &element.properties {
                let axis = axis_of(property);
                self.source.numbers(property, |source, number| {
                    let Some(axis) = axis else { return Ok(()) };
                    if !number.is_finite() {
                        let what = format!("the coordinate {} is {number}", property.name);
                        return Err(source.problem(what));
                    }
                    if property.scalar == Scalar::Float(4) {
                        largest = largest.max(number.abs());
                    }
                    point[axis] = number;
                    Ok(())
                })?;
            }
            push(&mut self.positions, point)?;
        }
        // Half a unit in the last place of a 32-bit float.
        self.rounding = largest * f64::from(f32::EPSILON) / 2.0;
        Ok(())
    }

    fn take_faces(&mut self, element: &Element) -> Result<(), ReadError> {
        let is_corners = |property: &Property| {
            property.list.is_some() && matches!(&*property.name, "vertex_indices" | "vertex_index")
        };
        if element.count > 0 && !element.properties.iter().any(is_corners) {
            let problem = "has no list vertex_indices or vertex_index";
            return Err(ReadError::place("the element face", problem));
        }
        let mut corners = Vec::new();
        let vertices = self.vertices;
        for _ in 0..element.count {
            self.source.start_row(element)?;
            for property in &element.properties {
                let is_corners = is_corners(property);
                if is_corners {
                    corners.clear();
                }
                self.source.numbers(property, |source, number| {
                    if !is_corners {
                        return Ok(());
                    }
                    if !(number >= 0.0 && number < vertices as f64 && number.fract() == 0.0) {
                        return Err(source.problem(format!(
                            "vertex {number} does not exist; the file has {vertices}, from 0"
                        )));
                    }
                    // More vertices than 32 bits count are refused at the end.
                    Ok(push(&mut corners, number as u32)?)
                })?;
            }
            if corners.len() < 3 {
                self.short += 1;
            } else {
                self.faces.push(&corners)?;
            }
        }
        Ok(())
    }

    fn pass_over(&mut self, element: &Element) -> Result<(), ReadError> {
        if element.properties.is_empty() || element.count == 0 {
            return Ok(());
        }
        for _ in 0..element.count {
            self.source.start_row(element)?;
            for property in &element.properties {
                self.source.numbers(property, |_, _| Ok(()))?;
            }
        }
        self.passed_over.push(format!("{} rows of {:?} are not read", element.count, element.name));
        Ok(())
    }

    fn into_mesh(self) -> Result<TriMesh, ReadError> {
        let mut notes = self.passed_over;
        if self.short > 0 {
            notes.push(format!("faces with fewer than three corners, left out: {}", self.short));
        }
        let mesh = self.faces.into_mesh(self.positions, NonTriangles::default())?;
        Ok(mesh.with_notes(notes).with_rounding(self.rounding))
    }
}
