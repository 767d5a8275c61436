//! Reading .node, .ele and .poly.

use crate::ReadError;
use crate::facts::Source;
use crate::numbered::Numbered;
use crate::records::{Records, Words};
use crate::words::number;
use mindeg_mesh::TriMesh;
use std::collections::BTreeMap;
use std::io::{BufRead, ErrorKind};
use std::path::Path;

/// The extensions of the vertices, of the triangles, and of the segments with the holes.
pub(super) const EXTENSIONS: [&str; 3] = ["node", "ele", "poly"];

/// Reads a mesh from a `.node` and an `.ele`, and its boundary segments from a `.poly`, if there is
/// one.
///
/// Vertices count from 0 or from 1, as the first one says, or have any numbers; `#` starts a
/// comment. Attributes of vertices are passed over. Of elements with six vertices the corners are
/// taken, and the first attribute makes groups, if the triangles of each follow one another.
/// Segments become lines, one for each marker but 0, in the order of markers.
///
/// O(n log n) time and O(n) memory for n bytes, whatever the files say.
///
/// # Errors
///
/// Errors of the inputs; lines that are not as the format has them; elements and segments that name
/// vertices that the `.node` does not have; files without elements, and such in three dimensions.
/// Places name the file that a line is in.
///
/// # Example
///
/// ```
/// use mindeg_formats::triangle;
///
/// let node = "3 2 0 1 # vertices\n0 0 0 1\n1 1 0 1\n2 0 1 1\n";
/// let ele = "1 3 0\n0 0 1 2\n";
/// let mesh = triangle::read(node.as_bytes(), ele.as_bytes(), None::<&[u8]>)?;
/// assert_eq!(mesh.triangles(), [[0, 1, 2]]);
///
/// let ele = ele.replace("1 2", "1 3");
/// let error = triangle::read(node.as_bytes(), ele.as_bytes(), None::<&[u8]>).unwrap_err();
/// assert_eq!(error.to_string(), "the .ele, line 2: vertex 3 does not exist; the file has 0 to 2");
/// # Ok::<(), mindeg_formats::ReadError>(())
/// ```
pub fn read(
    node: impl BufRead,
    ele: impl BufRead,
    poly: Option<impl BufRead>,
) -> Result<TriMesh, ReadError> {
    let mut contents = Numbered::of_files(["the .ele", "the .poly"]);
    read_node(node, &mut contents).map_err(|error| error.within("the .node"))?;
    read_ele(ele, &mut contents).map_err(|error| error.within("the .ele"))?;
    if let Some(poly) = poly {
        read_poly(poly, &mut contents).map_err(|error| error.within("the .poly"))?;
    }
    contents.into_mesh("region")
}

/// Reads one of the three files and those beside it; the .poly may be missing.
pub(super) fn read_files(source: Source<'_>) -> Result<TriMesh, ReadError> {
    let mut own = Vec::new();
    source.input.read_to_end(&mut own)?;
    let mut own = Some(own);
    let name = Path::new(source.name.file_name().unwrap_or_default());
    let extension = name.extension().map(|name| name.to_string_lossy().to_lowercase());
    let named = EXTENSIONS.into_iter().find(|known| Some(*known) == extension.as_deref());
    let mut file = |extension: &str| {
        // A name with another extension is that of the vertices.
        if named.unwrap_or(EXTENSIONS[0]) == extension
            && let Some(own) = own.take()
        {
            return Ok(own);
        }
        let uri = name.with_extension(extension).to_string_lossy().into_owned();
        (source.beside)(&uri).map_err(|source| ReadError::External { uri, source })
    };
    let [node, ele, poly] = EXTENSIONS.map(&mut file);
    let poly = match poly {
        Err(ReadError::External { source, .. }) if source.kind() == ErrorKind::NotFound => None,
        poly => Some(poly?),
    };
    read(&node?[..], &ele?[..], poly.as_deref())
}

fn read_node(node: impl BufRead, contents: &mut Numbered) -> Result<(), ReadError> {
    let mut records = Records::new(node, Some(b'#'));
    let mut head = records.expect("the number of vertices")?;
    let count = head.count("the number of vertices")?;
    let dimension = head.count("the number of dimensions")?;
    if dimension != 2 {
        let problem = format!(
            "the file has {dimension} dimensions; only triangles in the plane are read, no \
             tetrahedra"
        );
        return Err(head.problem(problem));
    }
    for _ in 0..count {
        let mut words = records.expect("its last vertex")?;
        contents.vertex(words.id()?, [words.number("x")?, words.number("y")?, 0.0].into())?;
    }
    Ok(())
}

fn read_ele(ele: impl BufRead, contents: &mut Numbered) -> Result<(), ReadError> {
    let mut records = Records::new(ele, Some(b'#'));
    let mut head = records.expect("the number of triangles")?;
    let count = head.count("the number of triangles")?;
    let corners = head.count("the number of vertices of a triangle")?;
    if !matches!(corners, 3 | 6) {
        return Err(head.problem(format!("triangles have {corners} vertices, not 3 or 6")));
    }
    for _ in 0..count {
        let mut words = records.expect("its last triangle")?;
        words.id()?;
        let triangle = [words.id()?, words.id()?, words.id()?];
        for _ in 3..corners {
            words.id()?;
        }
        let has_attribute = !words.rest.is_empty();
        let attribute = if has_attribute { words.number("the attribute")? as i64 } else { 0 };
        contents.element(words.line, &triangle, attribute)?;
    }
    Ok(())
}

fn read_poly(poly: impl BufRead, contents: &mut Numbered) -> Result<(), ReadError> {
    let mut records = Records::new(poly, None);
    let mut names = BTreeMap::new();
    let mut expect = |records: &mut Records<_>, what: &str| -> Result<_, ReadError> {
        loop {
            let mut words = records.expect(what)?;
            if words.rest.first() != Some(&b'#') {
                let end = memchr::memchr(b'#', words.rest).unwrap_or(words.rest.len());
                words.rest = &words.rest[..end];
                return Ok(Row { line: words.line, rest: words.rest.to_vec() });
            }
            if let Some((marker, name)) = name(words) {
                names.insert(marker, name);
            }
        }
    };
    let head = expect(&mut records, "the number of vertices")?;
    let vertices = head.words().count("the number of vertices")?;
    for _ in 0..vertices {
        // The .node has them too.
        expect(&mut records, "its last vertex")?;
    }
    let head = expect(&mut records, "the number of segments")?;
    let count = head.words().count("the number of segments")?;
    let mut segments: BTreeMap<i64, Vec<[(u32, u64); 2]>> = BTreeMap::new();
    for _ in 0..count {
        let row = expect(&mut records, "its last segment")?;
        let mut words = row.words();
        words.id()?;
        let ends = [words.id()?, words.id()?].map(|id| (id, row.line));
        let has_marker = !words.rest.trim_ascii().is_empty();
        let marker = if has_marker { words.integer("the marker")? } else { 1 };
        if marker != 0 {
            crate::lists::push(segments.entry(marker).or_default(), ends)?;
        }
    }
    for (marker, segments) in segments {
        let name = names.remove(&marker).unwrap_or_else(|| format!("marker {marker}"));
        for ends in segments {
            contents.string(&name, None, ends)?;
        }
    }
    Ok(())
}

/// A line without its comment.
struct Row {
    line: u64,
    rest: Vec<u8>,
}

impl Row {
    fn words(&self) -> Words<'_> {
        Words { rest: &self.rest, line: self.line }
    }
}

/// The marker and the name of a comment `# marker 1: inlet`.
fn name(words: Words<'_>) -> Option<(i64, String)> {
    let text = words.rest.strip_prefix(b"# marker ")?;
    let colon = memchr::memchr(b':', text)?;
    let name = String::from_utf8_lossy(text[colon + 1..].trim_ascii()).into_owned();
    (!name.is_empty()).then_some((number(&text[..colon])?, name))
}
