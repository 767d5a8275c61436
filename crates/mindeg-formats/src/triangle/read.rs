//! Reading .node, .ele and .poly.

use crate::facts::Source;
use crate::lists::push;
use crate::names::{MARKER, REGION};
use crate::numbered::{Named, Nodes, Numbered};
use crate::records::{Records, Words};
use crate::words::number;
use crate::{Polylines, ReadError};
use glam::DVec3;
use mindeg_mesh::{Line, NamedVertex, TriMesh};
use std::collections::BTreeMap;
use std::io::{self, BufRead, ErrorKind};
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
/// Errors of the inputs; malformed lines; elements and segments that name
/// vertices that the `.node` does not have; files without elements, and files in three dimensions.
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
    let nodes = read_nodes(&mut Rows::new(node));
    contents.nodes = nodes.map_err(|error| error.within("the .node"))?;
    read_ele(ele, &mut contents).map_err(|error| error.within("the .ele"))?;
    if let Some(poly) = poly {
        let poly = Poly::read(poly).map_err(|error| error.within("the .poly"))?;
        let mut segments: BTreeMap<i64, Vec<[Named; 2]>> = BTreeMap::new();
        for &(marker, ends) in poly.segments.iter().filter(|(marker, _)| *marker != Some(0)) {
            push(segments.entry(marker.unwrap_or(1)).or_default(), ends)?;
        }
        for (marker, segments) in segments {
            let name = poly.name(marker);
            for ends in segments {
                contents.string(&name, None, ends)?;
            }
        }
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

/// The contents of a `.poly` beside its segments.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PolyFaces {
    /// A point in each hole.
    pub holes: Vec<DVec3>,
    /// The regions.
    pub regions: Vec<PolyRegion>,
}

/// A region of a `.poly`.
#[derive(Clone, Debug, PartialEq)]
pub struct PolyRegion {
    /// A point in it.
    pub at: DVec3,
    /// "region 7" for the attribute 7.
    pub name: String,
    /// The greatest area of its triangles, if the file gives one above 0.
    pub max_area: Option<f64>,
}

/// Reads the segments of a `.poly`, the points that it lists and no segment names, and the points in its holes and
/// regions. `node` gives the `.node` beside it, for a
/// file that has no vertices of its own.
///
/// Segments in a row with the same marker are a line, which has a name unless its marker is 0, or all have
/// one that no comment names.
///
/// # Errors
///
/// Errors of the inputs; malformed lines; segments that name vertices that do not exist.
pub fn read_lines(
    poly: impl BufRead,
    node: impl FnOnce() -> io::Result<Vec<u8>>,
) -> Result<(Polylines, PolyFaces), ReadError> {
    let mut poly = Poly::read(poly)?;
    let mut nodes = std::mem::take(&mut poly.nodes);
    let has_points = !nodes.positions.is_empty();
    if !has_points {
        const NODE: &str = "the .node beside the .poly";
        let bytes = node().map_err(|error| {
            let problem = format!(
                "the .poly has no vertices of its own, and the .node that has them cannot be read: \
                 {error}"
            );
            ReadError::place(NODE, problem)
        })?;
        nodes = read_nodes(&mut Rows::new(&bytes[..])).map_err(|error| error.within(NODE))?;
    }
    nodes.sort()?;
    let mut segments = Vec::new();
    let mut lines: Vec<Line> = Vec::new();
    let first = poly.segments.first().map(|&(marker, _)| marker.unwrap_or(0));
    let is_first = |marker: Option<i64>| Some(marker.unwrap_or(0)) == first;
    let is_one = poly.segments.iter().all(|&(marker, _)| is_first(marker));
    let mut last = None;
    for &(marker, [a, b]) in &poly.segments {
        let marker = marker.unwrap_or(0);
        push(&mut segments, [nodes.named(a)?, nodes.named(b)?])?;
        let end = segments.len() as u32;
        if let Some(line) = lines.last_mut().filter(|_| last == Some(marker)) {
            line.segments.end = end;
            continue;
        }
        last = Some(marker);
        let is_unnamed = (marker == 0 || is_one) && !poly.names.contains_key(&marker);
        let name = if is_unnamed { String::new() } else { poly.name(marker) };
        push(&mut lines, Line { name, segments: end - 1..end, is_straight: false })?;
    }
    let mut is_named = vec![!has_points; nodes.positions.len()];
    segments.as_flattened().iter().for_each(|&end| is_named[end as usize] = true);
    let alone = (0..).zip(is_named).filter(|(_, is_named)| !is_named);
    let points = alone.map(|(vertex, _)| NamedVertex { name: String::new(), vertex }).collect();
    let positions = nodes.positions;
    Ok((Polylines { positions, segments, lines, points, ..Polylines::default() }, poly.faces))
}

/// The vertices, in two dimensions.
fn read_nodes(rows: &mut Rows<impl BufRead>) -> Result<Nodes, ReadError> {
    let mut head = rows.expect("the number of vertices")?;
    let count = head.count("the number of vertices")?;
    let dimension = if head.is_empty() { 2 } else { head.count("the number of dimensions")? };
    if dimension != 2 {
        let problem = format!(
            "the file has {dimension} dimensions; only triangles in the plane are read, no \
             tetrahedra"
        );
        return Err(head.problem(problem));
    }
    let mut nodes = Nodes::default();
    for _ in 0..count {
        let mut words = rows.expect("its last vertex")?;
        let number = words.id()?;
        nodes.push(number.into(), plane_point(&mut words)?)?;
    }
    Ok(nodes)
}

fn plane_point(words: &mut Words<'_>) -> Result<DVec3, ReadError> {
    Ok(DVec3::new(words.number("x")?, words.number("y")?, 0.0))
}

fn read_ele(ele: impl BufRead, contents: &mut Numbered) -> Result<(), ReadError> {
    let mut rows = Rows::new(ele);
    let mut head = rows.expect("the number of triangles")?;
    let count = head.count("the number of triangles")?;
    let corners = head.count("the number of vertices of a triangle")?;
    if !matches!(corners, 3 | 6) {
        return Err(head.problem(format!("triangles have {corners} vertices, not 3 or 6")));
    }
    for _ in 0..count {
        let mut words = rows.expect("its last triangle")?;
        words.id()?;
        let triangle = [words.id()?, words.id()?, words.id()?];
        for _ in 3..corners {
            words.id()?;
        }
        let attribute = if words.is_empty() { 0 } else { words.number("the attribute")? as i64 };
        contents.element(words.line, &triangle, attribute)?;
    }
    Ok(())
}

/// The contents of a .poly.
struct Poly {
    /// Empty if the .node has them.
    nodes: Nodes,
    /// The marker of each segment, if it has one, and its ends.
    segments: Vec<(Option<i64>, [Named; 2])>,
    faces: PolyFaces,
    names: BTreeMap<i64, String>,
}

impl Poly {
    fn read(input: impl BufRead) -> Result<Self, ReadError> {
        let mut rows = Rows::new(input);
        let nodes = read_nodes(&mut rows)?;
        let mut segments = Vec::new();
        let count = rows.expect("the number of segments")?.count("the number of segments")?;
        for _ in 0..count {
            let mut words = rows.expect("its last segment")?;
            words.id()?;
            let ends = [(words.id()?, words.line), (words.id()?, words.line)];
            let marker = if words.is_empty() { None } else { Some(words.integer("the marker")?) };
            push(&mut segments, (marker, ends))?;
        }
        let mut holes = Vec::new();
        // A file may end before its holes.
        let count = match rows.next()? {
            Some(mut words) => words.count("the number of holes")?,
            None => 0,
        };
        for _ in 0..count {
            let mut words = rows.expect("its last hole")?;
            words.id()?;
            push(&mut holes, plane_point(&mut words)?)?;
        }
        let mut regions = Vec::new();
        let count = match rows.next()? {
            Some(mut words) => words.count("the number of regions")?,
            None => 0,
        };
        for _ in 0..count {
            let mut words = rows.expect("its last region")?;
            words.id()?;
            let at = plane_point(&mut words)?;
            let attribute = words.number("the attribute of a region")?;
            let area =
                if words.is_empty() { None } else { Some(words.number("the maximum area")?) };
            let max_area = area.filter(|area| *area > 0.0);
            push(&mut regions, PolyRegion { at, name: format!("{REGION} {attribute}"), max_area })?;
        }
        Ok(Self { nodes, segments, faces: PolyFaces { holes, regions }, names: rows.names })
    }

    /// The name of a line of segments.
    fn name(&self, marker: i64) -> String {
        self.names.get(&marker).cloned().unwrap_or_else(|| format!("{MARKER} {marker}"))
    }
}

/// The lines of a file without comments, and the names that these give to markers.
struct Rows<R> {
    records: Records<R>,
    names: BTreeMap<i64, String>,
}

impl<R: BufRead> Rows<R> {
    fn new(input: R) -> Self {
        Self { records: Records::new(input, None), names: BTreeMap::new() }
    }

    fn next(&mut self) -> Result<Option<Words<'_>>, ReadError> {
        while let Some(words) = self.records.next()? {
            let end = memchr::memchr(b'#', words.rest).unwrap_or(words.rest.len());
            self.names.extend(name(&words.rest[end..]));
            if !words.rest[..end].is_empty() {
                return Ok(Some(self.records.words(0..end)));
            }
        }
        Ok(None)
    }

    /// The next line, which is to be `what`.
    fn expect(&mut self, what: &str) -> Result<Words<'_>, ReadError> {
        let line = self.records.line() + 1;
        self.next()?.ok_or_else(|| ReadError::line(line, format!("the file ends before {what}")))
    }
}

/// The marker and the name of a comment `# marker 1: inlet`.
fn name(comment: &[u8]) -> Option<(i64, String)> {
    let text = comment.strip_prefix(b"#")?.trim_ascii().strip_prefix(b"marker ")?;
    let colon = memchr::memchr(b':', text)?;
    let name = String::from_utf8_lossy(text[colon + 1..].trim_ascii()).into_owned();
    (!name.is_empty()).then_some((number(text[..colon].trim_ascii())?, name))
}
