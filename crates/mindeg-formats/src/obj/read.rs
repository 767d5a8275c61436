//! Wavefront OBJ, read with tobj.
//!
//! Positions are read as `f64` and faces by their vertex numbers alone, so that corners that
//! differ in normal or texture coordinate stay one vertex. Faces of more than three corners are
//! split into a fan from their first corner, and counted. Objects and groups become groups.
//!
//! tobj numbers vertices anew, by first use, and forgets those without a face. The reader
//! therefore passes tobj the `v` and `f` lines alone, and after the last of them faces that
//! run over all vertices in the order of the file: how tobj numbers their corners tells which
//! vertex of the file is which. Since lines pass one at a time, errors can name the line.
//!
//! Limits: lines and points are counted and left out, free-form curves and surfaces are
//! passed over. A file with the line ends of old Macintoshes (CR alone) is one long line.

use crate::ReadError;
use glam::DVec3;
use mindeg_mesh::{Group, NonTriangles, TriMesh};
use std::io::{self, BufRead, Read};

/// Reads a mesh from an OBJ.
///
/// O(n) time and memory.
///
/// # Errors
///
/// Those of the input, lines that are not as the format has them, faces with vertices that the
/// file does not define, positions that are not finite, and a file without faces.
///
/// # Example
///
/// ```
/// use mindeg_formats::obj;
///
/// let file = "o roof\nv 0 0 0\nv 4 0 0\nv 4 3 0\nv 0 3 0\nf 1 2 3 4\n";
/// let mesh = obj::read(file.as_bytes())?;
/// assert_eq!(mesh.triangles(), [[0, 1, 2], [0, 2, 3]]);
/// assert_eq!(mesh.non_triangles().quads, 1);
/// assert_eq!(mesh.groups()[0].name, "roof");
///
/// let error = obj::read("v 0 0 0\nf 1 2 3\n".as_bytes()).unwrap_err();
/// assert_eq!(error.to_string(), "line 2: a face names vertex 3, and the file has 1 in all");
/// # Ok::<(), mindeg_formats::ReadError>(())
/// ```
pub fn read(input: impl BufRead) -> Result<TriMesh, ReadError> {
    let options = tobj::LoadOptions {
        single_index: false,
        triangulate: false,
        ignore_points: false,
        ignore_lines: false,
    };
    let mut lines = Lines::new(input);
    let loaded = tobj::load_obj_buf(&mut lines, &options, |_| Err(tobj::LoadError::GenericFailure));
    // There is one model, since tobj starts another at `o`, `g` and `usemtl` only.
    let mesh = match loaded {
        Ok((models, _)) => models.into_iter().next().map(|model| model.mesh).unwrap_or_default(),
        Err(error) => return Err(lines.explain(error)),
    };
    let (faces, vertices) = mesh.indices.split_at(lines.corners);
    let positions =
        vertices.iter().map(|&v| DVec3::from_slice(&mesh.positions[3 * v as usize..])).collect();
    let mut in_file = vec![0; vertices.len()];
    for (number, &vertex) in (0..).zip(vertices) {
        in_file[vertex as usize] = number;
    }
    let mut triangles = Vec::with_capacity(lines.triangles);
    let mut corners = faces.iter().map(|&vertex| in_file[vertex as usize]);
    let mut face = Vec::new();
    // Where all faces have three corners, tobj does not count them.
    for arity in mesh.face_arities.iter().copied().chain(std::iter::repeat(3)).take(lines.faces) {
        face.clear();
        face.extend(corners.by_ref().take(arity as usize));
        triangles.extend(face[1..].windows(2).map(|edge| [face[0], edge[0], edge[1]]));
    }
    lines.end_part();
    let mesh = TriMesh::new(positions, triangles)?;
    Ok(mesh.with_groups(lines.groups).with_non_triangles(lines.non_triangles))
}

/// The lines of an OBJ that tobj is to see, one at a time, and what the others say.
struct Lines<R> {
    input: R,
    /// The line of the file, without its end.
    raw: Vec<u8>,
    /// The line for tobj, and how much of it tobj has taken.
    line: Vec<u8>,
    taken: usize,
    /// How many lines have been read.
    number: u64,
    vertices: u64,
    /// The greatest vertex named by a face, counted from 1, and the line it is in.
    greatest: (u64, u64),
    faces: usize,
    corners: usize,
    triangles: usize,
    groups: Vec<Group>,
    non_triangles: NonTriangles,
    /// At the end of the input: how many vertices the faces over all vertices have named.
    named: Option<u64>,
    error: Option<ReadError>,
}

impl<R: BufRead> Lines<R> {
    fn new(input: R) -> Self {
        Self {
            input,
            raw: Vec::new(),
            line: Vec::new(),
            taken: 0,
            number: 0,
            vertices: 0,
            greatest: (0, 0),
            faces: 0,
            corners: 0,
            triangles: 0,
            groups: vec![Group { name: String::new(), triangles: 0..0 }],
            non_triangles: NonTriangles::default(),
            named: None,
            error: None,
        }
    }

    /// Makes the next line for tobj; an empty one at the end.
    fn advance(&mut self) -> Result<(), ReadError> {
        self.line.clear();
        self.taken = 0;
        while self.named.is_none() {
            if self.read_line()? {
                self.take_line()?;
                if !self.line.is_empty() {
                    return Ok(());
                }
            } else {
                let (vertex, line) = self.greatest;
                if vertex > self.vertices {
                    let all = self.vertices;
                    let problem =
                        format!("a face names vertex {vertex}, and the file has {all} in all");
                    return Err(ReadError::Line { line, problem });
                }
                self.named = Some(0);
            }
        }
        self.name_vertices();
        Ok(())
    }

    /// Reads a line of the file into `raw`; false at the end. A line that ends in a backslash
    /// goes on in the next.
    fn read_line(&mut self) -> io::Result<bool> {
        self.raw.clear();
        while self.input.read_until(b'\n', &mut self.raw)? > 0 {
            self.number += 1;
            while matches!(self.raw.last(), Some(b'\n' | b'\r')) {
                self.raw.pop();
            }
            match self.raw.last_mut() {
                Some(last @ b'\\') => *last = b' ',
                _ => return Ok(true),
            }
        }
        Ok(!self.raw.is_empty())
    }

    /// Counts what the line in `raw` says, and passes vertices and faces on in `line`.
    fn take_line(&mut self) -> Result<(), ReadError> {
        let raw = self.raw.strip_prefix(b"\xef\xbb\xbf").unwrap_or(&self.raw);
        let mut words = raw.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
        let keyword = words.next().unwrap_or_default();
        let words = words.take_while(|word| word[0] != b'#');
        match keyword {
            b"v" => {
                // Three coordinates and perhaps a weight; more than that is a color.
                self.line.push(b'v');
                let mut coordinates = 0;
                for (count, word) in (1..=5).zip(words) {
                    push_word(&mut self.line, word);
                    match count {
                        3 => coordinates = self.line.len(),
                        5 => self.line.truncate(coordinates),
                        _ => {}
                    }
                }
                self.line.push(b'\n');
                self.vertices += 1;
            }
            b"f" => {
                self.line.push(b'f');
                let mut corners = 0;
                for word in words {
                    let end = word.iter().position(|&byte| byte == b'/').unwrap_or(word.len());
                    let problem = match named_vertex(&word[..end], self.vertices) {
                        Ok(vertex) => {
                            self.greatest = self.greatest.max((vertex, self.number));
                            push_word(&mut self.line, &word[..end]);
                            corners += 1;
                            continue;
                        }
                        Err(problem) => problem,
                    };
                    return Err(ReadError::Line { line: self.number, problem });
                }
                self.line.push(b'\n');
                self.take_face(corners);
            }
            b"l" => self.non_triangles.line_segments += words.count().saturating_sub(1) as u64,
            b"p" => self.non_triangles.points += words.count() as u64,
            b"o" | b"g" => {
                let name = raw.trim_ascii_start()[1..].trim_ascii();
                let name = String::from_utf8_lossy(name).into_owned();
                self.end_part();
                // A mesh of more triangles is refused.
                let start = self.triangles as u32;
                self.groups.push(Group { name, triangles: start..start });
            }
            _ => {}
        }
        Ok(())
    }

    /// Counts a face; one that is none is not for tobj.
    fn take_face(&mut self, corners: usize) {
        match corners {
            0 => {}
            1 => self.non_triangles.points += 1,
            2 => self.non_triangles.line_segments += 1,
            3 => {}
            4 => self.non_triangles.quads += 1,
            _ => self.non_triangles.polygons += 1,
        }
        if corners < 3 {
            self.line.clear();
        } else {
            self.faces += 1;
            self.corners += corners;
            self.triangles += corners - 2;
        }
    }

    fn end_part(&mut self) {
        if let Some(part) = self.groups.last_mut() {
            part.triangles.end = self.triangles as u32;
        }
    }

    /// Makes a face over the next vertices that no face of this kind has named.
    fn name_vertices(&mut self) {
        const CORNERS: u64 = 4096;
        let named = self.named.unwrap_or(0);
        let end = self.vertices.min(named + CORNERS);
        if named < end {
            self.line.push(b'f');
            let mut digits = itoa::Buffer::new();
            for vertex in named + 1..=end {
                push_word(&mut self.line, digits.format(vertex).as_bytes());
            }
            self.line.push(b'\n');
            self.named = Some(end);
        }
    }

    /// What to tell about an error of tobj.
    fn explain(self, error: tobj::LoadError) -> ReadError {
        let problem = match error {
            tobj::LoadError::PositionParseError => "a vertex needs three numbers".to_owned(),
            tobj::LoadError::ScalingByZeroError => "a vertex has the weight 0".to_owned(),
            tobj::LoadError::ReadError => "this is not text".to_owned(),
            other => other.to_string(),
        };
        self.error.unwrap_or(ReadError::Line { line: self.number, problem })
    }
}

impl<R: BufRead> BufRead for Lines<R> {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        if self.taken == self.line.len()
            && let Err(error) = self.advance()
        {
            self.error = Some(error);
            return Err(io::ErrorKind::InvalidData.into());
        }
        Ok(&self.line[self.taken..])
    }

    fn consume(&mut self, amount: usize) {
        self.taken += amount;
    }
}

impl<R: BufRead> Read for Lines<R> {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        let read = self.fill_buf()?.read(into)?;
        self.consume(read);
        Ok(read)
    }
}

fn push_word(line: &mut Vec<u8>, word: &[u8]) {
    line.push(b' ');
    line.extend_from_slice(word);
}

/// The vertex that a corner of a face names, counted from 1: a positive number counts from
/// the first vertex, a negative one back from the last so far.
fn named_vertex(word: &[u8], so_far: u64) -> Result<u64, String> {
    let text = String::from_utf8_lossy(word);
    let number: i64 = text
        .parse()
        .map_err(|_| format!("the corner {text:?} of a face is not a vertex number"))?;
    match number {
        0 => Err("a face names vertex 0, and vertices count from 1".to_owned()),
        1.. => Ok(number.unsigned_abs()),
        _ => (so_far + 1)
            .checked_sub(number.unsigned_abs())
            .filter(|&vertex| vertex > 0)
            .ok_or_else(|| {
                format!("a face names vertex {number}, counted back, and there are {so_far} so far")
            }),
    }
}
