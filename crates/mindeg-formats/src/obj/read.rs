//! Reading OBJ.

use super::library::{Libraries, UsedMaterials};
use super::references::{Numbered, Unknown, leading_number};
use super::words::Words;
use crate::ReadError;
use crate::dropped;
use crate::face_list::FaceList;
use crate::lines::Lines;
use crate::lists::push;
use crate::runs::Polylines;
use glam::DVec3;
use mindeg_mesh::{Group, Line, NonTriangles, TriMesh};
use std::collections::HashMap;
use std::io::{self, BufRead};

/// Reads a mesh from an OBJ.
///
/// Positions are read as `f64`, and divided by their weight where there is one (`v x y z w`).
/// Vertices keep the order of the file, also those that nothing names; corners of faces that
/// differ in texture coordinate or normal alone are one vertex. Faces of more than three corners
/// are kept as the mesh's polygons. Objects (`o`) and groups (`g`) become groups, and name the lines
/// (`l`) in them. Faces of one group with different materials (`usemtl`) are groups of one name; of
/// the materials only the names are read. Points (`p`) are counted.
///
/// A face of two corners counts as a line, a face or line of one as a point. Vertex colors,
/// texture coordinates, and free-form curves and surfaces are passed over. Lines end in
/// LF, CR LF or CR, and may hold 16 MiB.
///
/// O(n) time and memory, but for the cutting of polygons.
///
/// # Errors
///
/// Errors of the input, an over-long line and too little memory among them; lines that are not as
/// the format has them; faces, lines and points with vertices that the file does not define;
/// positions that are not finite; and a file without faces. A texture coordinate or normal that is
/// not there is not an error.
///
/// # Example
///
/// ```
/// use mindeg_formats::obj;
///
/// let file = "o roof\nv 0 0 0\nv 4 0 0\nv 4 3 0\nv 0 3 0\nf 1 2 3 4\no eaves\nl 1 2\n";
/// let mesh = obj::read(file.as_bytes())?;
/// assert_eq!(mesh.triangles(), [[0, 1, 2], [0, 2, 3]]);
/// assert_eq!(mesh.polygons().map(|polygons| polygons.corners(0)), Some(&[0, 1, 2, 3][..]));
/// assert_eq!(mesh.groups()[0].name, "roof");
/// assert_eq!(mesh.segments(), [[0, 1]]);
///
/// let error = obj::read("v 0 0 0\nf 1 2 3\n".as_bytes()).unwrap_err();
/// assert_eq!(error.to_string(), "line 2: vertex 3 does not exist; the file has 1");
/// # Ok::<(), mindeg_formats::ReadError>(())
/// ```
pub fn read(input: impl BufRead) -> Result<TriMesh, ReadError> {
    let contents = contents(input)?;
    let notes = contents.notes();
    Ok(contents.into_mesh(&HashMap::new())?.with_notes(notes))
}

/// [`read()`], with the colors of materials.
///
/// `beside` gives the libraries (`mtllib`), by the names in the file. A library that cannot be read
/// is not an error: a note says so, and its materials have only names.
///
/// # Errors
///
/// As [`read()`].
///
/// # Example
///
/// ```
/// use mindeg_formats::obj;
///
/// let file = "mtllib roof.mtl\nv 0 0 0\nv 4 0 0\nv 4 3 0\nusemtl slate\nf 1 2 3\n";
/// let library = |_: &str| Ok(b"newmtl slate\nKd 0.2 0.2 0.25\n".to_vec());
/// let mesh = obj::read_with_libraries(file.as_bytes(), library)?;
/// let material = mesh.groups()[0].material.as_ref().unwrap();
/// assert_eq!((&*material.name, material.color), ("slate", Some([0.2, 0.2, 0.25, 1.0])));
/// # Ok::<(), mindeg_formats::ReadError>(())
/// ```
pub fn read_with_libraries(
    input: impl BufRead,
    mut beside: impl FnMut(&str) -> io::Result<Vec<u8>>,
) -> Result<TriMesh, ReadError> {
    let mut contents = contents(input)?;
    let mut notes = contents.notes();
    let mut libraries = Libraries::default();
    // Nothing is looked for that no face uses.
    if !contents.materials.is_empty() {
        let names = std::mem::take(&mut contents.libraries);
        names.iter().for_each(|name| libraries.read(name, &mut beside));
    }
    notes.append(&mut libraries.notes);
    Ok(contents.into_mesh(&libraries.colors)?.with_notes(notes))
}

/// Reads the lines of an OBJ as [`read()`] does, whether or not it has faces; those of no object and no group
/// have no name.
///
/// # Errors
///
/// As [`read()`], but a file may have no faces.
pub fn read_lines(input: impl BufRead) -> Result<Polylines, ReadError> {
    let contents = contents(input)?;
    contents.check()?;
    let Contents { positions, segments, lines, .. } = contents;
    let others = contents.faces.face_count();
    Ok(Polylines { positions, segments, lines, others, ..Polylines::default() })
}

fn contents(input: impl BufRead) -> Result<Contents, ReadError> {
    let mut lines = Lines::new(input).with_continued_lines();
    let mut contents = Contents::default();
    contents.start_group(String::new());
    while let Some((number, line)) = lines.next()? {
        contents.number = number;
        contents.take_line(line)?;
    }
    Ok(contents)
}

/// The contents of the lines read so far.
#[derive(Default)]
struct Contents {
    /// The number of the line.
    number: u64,
    positions: Vec<DVec3>,
    vertices: Numbered,
    texture_coordinates: Numbered,
    normals: Numbered,
    has_colors: bool,
    /// The first texture coordinate and the first normal that were counted back too far.
    missing: [Option<Unknown>; 2],
    /// The vertices of the element in the line.
    corners: Vec<u32>,
    faces: FaceList,
    groups: Vec<Group>,
    materials: UsedMaterials,
    /// The names of the material libraries.
    libraries: Vec<String>,
    lines: Vec<Line>,
    /// Whether the last line is of the last group.
    line_is_open: bool,
    segments: Vec<[u32; 2]>,
    non_triangles: NonTriangles,
    /// How many faces and lines have too few corners, and the first line with one.
    short: u64,
    first_short: u64,
}

impl Contents {
    fn problem(&self, problem: impl Into<String>) -> ReadError {
        ReadError::line(self.number, problem)
    }

    fn take_line(&mut self, line: &[u8]) -> Result<(), ReadError> {
        let mut words = Words(line);
        match words.next() {
            Some([b'v']) => self.take_vertex(words),
            Some([b'v', b't']) => {
                self.texture_coordinates.count += 1;
                Ok(())
            }
            Some([b'v', b'n']) => {
                self.normals.count += 1;
                Ok(())
            }
            Some([b'f']) => {
                self.take_corners(words)?;
                self.take_face()
            }
            Some([b'l']) => {
                self.take_corners(words)?;
                self.take_polyline()
            }
            Some([b'p']) => {
                self.take_corners(words)?;
                self.non_triangles.points += self.corners.len() as u64;
                Ok(())
            }
            Some([b'o' | b'g']) => {
                self.end_group();
                self.start_group(words.text());
                Ok(())
            }
            Some(b"usemtl") => {
                self.use_material(words.text());
                Ok(())
            }
            Some(b"mtllib") => Ok(push(&mut self.libraries, words.text())?),
            _ => Ok(()),
        }
    }

    /// Three coordinates and perhaps a weight. Where more numbers follow, they are a color.
    fn take_vertex(&mut self, mut words: Words<'_>) -> Result<(), ReadError> {
        let mut point = [0.0; 3];
        for (found, coordinate) in point.iter_mut().enumerate() {
            let word = words.next().ok_or_else(|| {
                self.problem(format!("a vertex has three coordinates; found {found}"))
            })?;
            *coordinate = self.coordinate(word)?;
        }
        let mut point = DVec3::from_array(point);
        match (words.next(), words.next()) {
            (None, _) => {}
            (Some(_), Some(_)) => self.has_colors = true,
            (Some(weight), None) => point /= self.coordinate(weight)?,
        }
        if !point.is_finite() {
            return Err(self.problem("a vertex divided by its weight is not finite"));
        }
        push(&mut self.positions, point)?;
        self.vertices.count += 1;
        Ok(())
    }

    fn coordinate(&self, word: &[u8]) -> Result<f64, ReadError> {
        let number = std::str::from_utf8(word).ok().and_then(|word| word.parse::<f64>().ok());
        number.filter(|number| number.is_finite()).ok_or_else(|| {
            let word = String::from_utf8_lossy(word);
            self.problem(format!("the coordinate {word:?} is not a finite number"))
        })
    }

    /// Reads the vertices that an element names.
    fn take_corners(&mut self, words: Words<'_>) -> Result<(), ReadError> {
        self.corners.clear();
        for word in words {
            let (vertex, rest) = leading_number(word).ok_or_else(|| self.no_corner(word))?;
            let vertex = self.vertices.index(vertex, self.number);
            let vertex = vertex.map_err(|unknown| self.problem(unknown.message("vertex")))?;
            if let [b'/', rest @ ..] = rest {
                let rest = self.take_reference(0, rest).ok_or_else(|| self.no_corner(word))?;
                match rest {
                    [] => {}
                    [b'/', rest @ ..] if self.take_reference(1, rest) == Some(b"") => {}
                    _ => return Err(self.no_corner(word)),
                }
            } else if !rest.is_empty() {
                return Err(self.no_corner(word));
            }
            // A greater one does not exist, which is found out at the end.
            push(&mut self.corners, vertex as u32)?;
        }
        if self.corners.is_empty() {
            return Err(self.problem("a face, line or point names no vertex"));
        }
        Ok(())
    }

    /// Notes the texture coordinate (0) or normal (1) that a corner names, if it names one, and
    /// returns the rest of the text; `None` if it does not begin with a number.
    fn take_reference<'a>(&mut self, kind: usize, text: &'a [u8]) -> Option<&'a [u8]> {
        if matches!(text, [] | [b'/', ..]) {
            return Some(text);
        }
        let (number, rest) = leading_number(text)?;
        let defined = [&mut self.texture_coordinates, &mut self.normals];
        let [texture_coordinates, normals] = defined;
        let defined = if kind == 0 { texture_coordinates } else { normals };
        if let Err(unknown) = defined.index(number, self.number) {
            self.missing[kind].get_or_insert(unknown);
        }
        Some(rest)
    }

    fn no_corner(&self, word: &[u8]) -> ReadError {
        let word = String::from_utf8_lossy(word);
        self.problem(format!(
            "the corner {word:?} is not a vertex number, nor several with / between them"
        ))
    }

    fn take_face(&mut self) -> Result<(), ReadError> {
        if let [_, _, _, ..] = self.corners[..] {
            return Ok(self.faces.push(&self.corners)?);
        }
        // A single corner is noted with the lines.
        if self.corners.len() == 2 {
            self.note_short();
        }
        self.take_polyline()
    }

    fn take_polyline(&mut self) -> Result<(), ReadError> {
        if self.corners.len() < 2 {
            self.note_short();
            self.non_triangles.points += 1;
            return Ok(());
        }
        // More segments than 32 bits count are refused at the end.
        let start = self.segments.len() as u32;
        for segment in self.corners.windows(2) {
            push(&mut self.segments, [segment[0], segment[1]])?;
        }
        let end = self.segments.len() as u32;
        match self.lines.last_mut() {
            Some(line) if self.line_is_open => line.segments.end = end,
            _ => {
                let name = self.groups.last().map(|group| group.name.clone()).unwrap_or_default();
                push(&mut self.lines, Line { name, segments: start..end, is_straight: false })?;
                self.line_is_open = true;
            }
        }
        Ok(())
    }

    fn note_short(&mut self) {
        if self.short == 0 {
            self.first_short = self.number;
        }
        self.short += 1;
    }

    fn start_group(&mut self, name: String) {
        let start = self.faces.triangle_count() as u32;
        self.groups.push(Group::new(name, start..start));
        self.materials.start_group();
        self.line_is_open = false;
    }

    /// The faces from here on are of a material; of none, if the name is empty.
    fn use_material(&mut self, name: String) {
        if !self.materials.take(name) {
            return;
        }
        let is_empty = |group: &Group| group.triangles.start == self.faces.triangle_count() as u32;
        if self.groups.last().is_some_and(is_empty) {
            self.materials.change_group();
            return;
        }
        self.end_group();
        // The lines of the object go on.
        let line_is_open = self.line_is_open;
        let name = self.groups.last().map_or_else(String::new, |group| group.name.clone());
        self.start_group(name);
        self.line_is_open = line_is_open;
    }

    fn end_group(&mut self) {
        // More triangles than 32 bits count are refused at the end.
        let end = self.faces.triangle_count() as u32;
        if let Some(group) = self.groups.last_mut() {
            group.triangles.end = end;
        }
    }

    /// Notes about the file that the mesh does not show.
    fn notes(&self) -> Vec<String> {
        let mut notes = Vec::new();
        if self.short > 0 {
            notes.push(format!(
                "faces with fewer than three corners and lines with fewer than two: {} (the first \
                 in line {}); they count as lines and points",
                self.short, self.first_short
            ));
        }
        let kinds = [("texture coordinate", &self.texture_coordinates), ("normal", &self.normals)];
        for ((what, defined), missing) in kinds.into_iter().zip(self.missing) {
            if let Some(unknown) = missing.or(defined.unknown()) {
                notes.push(format!("line {}: {}", unknown.line, unknown.message(what)));
            }
        }
        notes
    }

    /// Refuses vertices that are not there, and more segments than 32 bits count.
    fn check(&self) -> Result<(), ReadError> {
        if let Some(unknown) = self.vertices.unknown() {
            let problem = unknown.message("vertex");
            return Err(ReadError::line(unknown.line, problem));
        }
        if u32::try_from(self.segments.len()).is_err() {
            return Err(self.problem("the file has too many lines to be numbered in 32 bits"));
        }
        Ok(())
    }

    fn into_mesh(mut self, colors: &HashMap<String, [f32; 4]>) -> Result<TriMesh, ReadError> {
        self.check()?;
        let dropped = dropped::found([
            (dropped::TEXTURE, self.texture_coordinates.count > 0),
            (dropped::NORMALS, self.normals.count > 0),
            (dropped::COLORS, self.has_colors),
        ]);
        self.lines
            .iter_mut()
            .filter(|line| line.name.is_empty())
            .for_each(|line| line.name = "line".into());
        self.end_group();
        self.non_triangles.line_segments = self.segments.len() as u64;
        self.materials.give_to(&mut self.groups, colors);
        let mesh = self.faces.into_mesh(self.positions, self.non_triangles)?;
        let mesh = mesh.with_dropped(dropped);
        Ok(mesh.with_groups(self.groups).with_lines(self.lines, self.segments)?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn notes_tell_what_the_mesh_does_not() {
        let square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\n";
        let short = "faces with fewer than three corners and lines with fewer than two: ";
        let short = |rest| format!("{short}{rest}; they count as lines and points");
        for (lines, expected) in [
            ("f 1/1/1 2//1 3/1 4", vec![]),
            ("f 1 2\n\nf 1 2 3\nf 3\nl 2", vec![short("3 (the first in line 7)")]),
            (
                "f 1 2 3\nf 1/1/1 2/9/1 3/2/7",
                vec![
                    "line 8: texture coordinate 9 does not exist; the file has 1".to_owned(),
                    "line 8: normal 7 does not exist; the file has 1".to_owned(),
                ],
            ),
            (
                "f 1/-2/0 2 3",
                vec![
                    "line 7: texture coordinate -2 does not exist; the file has 1 up to this line"
                        .to_owned(),
                    "line 7: normal 0 does not exist; numbers start at 1".to_owned(),
                ],
            ),
            // Defined after it is named.
            ("f 1/2 2/1 3/1\nvt 1 1", vec![]),
        ] {
            let mesh = read(format!("{square}{lines}\n").as_bytes()).unwrap();
            assert_eq!(mesh.notes(), expected, "{lines:?}");
        }
    }
}
