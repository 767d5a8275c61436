//! Gmsh's MSH 4.1 and 2.2 as text, with line elements: what `gmsh -1` writes.
//!
//! The closed loops of the line elements are rings, with the nodes' coordinates bit for bit. A
//! curve of the geometry is a side; the name of its physical group is the side's name. Loops inside
//! others are holes. Triangles and other elements are left out if there are lines.
//!
//! Limits: no binary files; second-order lines are read as lines between their ends.

mod v2;
mod v4;

use std::collections::BTreeMap;
use std::sync::Arc as Shared;

use glam::{DVec2, DVec3};

use super::curve::Curve;
use super::loops::{self, Link};
use super::nesting::{FillRule, polygons};
use super::outline::Outlines;
use super::plane;
use super::text::{at_line, counted, lines, number_at, quoted, text_of, whole_at};
use crate::error::ReadError;

/// Reads the line elements of a text file of version 4.1 or 2.2.
///
/// # Errors
///
/// Binary files and other versions; what is not as the format has it, with its line; elements that
/// refer to nodes that are not there; lines that close no ring.
pub(super) fn read(bytes: &[u8]) -> Result<Outlines, ReadError> {
    // The header of a binary file is text.
    if bytes.starts_with(b"$MeshFormat") {
        let mut header = bytes
            .splitn(3, |&byte| byte == b'\n')
            .nth(1)
            .unwrap_or_default()
            .trim_ascii()
            .split(|&byte| byte == b' ');
        if header.nth(1) == Some(b"1") {
            return Err(at_line(2, "this is a binary file; write text with Mesh.Binary = 0"));
        }
    }
    let mut rows = Rows::new(text_of(bytes)?);
    let mut file = File::default();
    let mut version = None;
    while let Some((line, text)) = rows.try_next() {
        let Some(section) = text.strip_prefix('$') else {
            return Err(at_line(
                line,
                format!("found {}, expected a section such as $Nodes", quoted(text)),
            ));
        };
        match (section, version) {
            ("MeshFormat", _) => version = Some(format_version(&mut rows)?),
            ("PhysicalNames", Some(_)) => physical_names(&mut rows, &mut file)?,
            ("Entities", Some(Version::V4)) => v4::entities(&mut rows, &mut file)?,
            ("Nodes", Some(Version::V4)) => v4::nodes(&mut rows, &mut file)?,
            ("Elements", Some(Version::V4)) => v4::elements(&mut rows, &mut file)?,
            ("Nodes", Some(Version::V2)) => v2::nodes(&mut rows, &mut file)?,
            ("Elements", Some(Version::V2)) => v2::elements(&mut rows, &mut file)?,
            ("Nodes" | "Elements" | "Entities", None) => {
                return Err(at_line(line, format!("${section} stands before $MeshFormat")));
            }
            _ => {}
        }
        rows.skip_to_end_of(section, line)?;
    }
    if version.is_none() {
        return Err(at_line(1, "the section $MeshFormat is missing"));
    }
    file.outlines()
}

#[derive(Clone, Copy)]
enum Version {
    V2,
    V4,
}

/// What the sections hold of lines.
#[derive(Default)]
struct File {
    /// Names of physical groups of curves, by their tags.
    names: BTreeMap<i64, Shared<str>>,
    /// The first physical group of each curve, by the tag of the curve.
    groups: BTreeMap<i64, i64>,
    points: Vec<DVec3>,
    /// The index of a node, by its tag.
    nodes: BTreeMap<i64, u32>,
    lines: Vec<Line>,
    /// How many elements are no lines.
    others: usize,
}

/// A line element.
struct Line {
    /// The line of the text.
    line: u64,
    nodes: [i64; 2],
    curve: i64,
    group: Option<i64>,
}

impl File {
    fn node(&mut self, line: u64, tag: i64, point: DVec3) -> Result<(), ReadError> {
        let index = u32::try_from(self.points.len());
        let index = index.map_err(|_| at_line(line, "the file has more than 4294967295 nodes"))?;
        if self.nodes.insert(tag, index).is_some() {
            return Err(at_line(line, format!("the node {tag} is there twice")));
        }
        self.points.push(point);
        Ok(())
    }

    fn outlines(self) -> Result<Outlines, ReadError> {
        let Self { names, groups, points, nodes, lines, others } = self;
        if lines.is_empty() {
            let others = counted(others, "other element");
            return Err(ReadError::place(
                "$Elements",
                format!(
                    "the file has no line elements, only {others}; mesh the curves with gmsh -1, \
                     and save all elements (Mesh.SaveAll = 1) or a physical group of the curves"
                ),
            ));
        }
        let link = |element: &Line| {
            let node = |tag: i64| {
                nodes.get(&tag).copied().ok_or_else(|| {
                    at_line(element.line, format!("the node {tag} is not in the file"))
                })
            };
            let [a, b] = element.nodes;
            let group = element.group.or_else(|| groups.get(&element.curve).copied());
            let side = group.map(|group| match names.get(&group) {
                Some(name) => Shared::clone(name),
                None => Shared::from(format!("physical {group}")),
            });
            let part_of = element.curve.cast_unsigned();
            Ok(Link { ends: [node(a)?, node(b)?], curve: Curve::Line, side, part_of })
        };
        let links: Vec<Link> = lines.iter().map(link).collect::<Result<_, ReadError>>()?;
        let used = links.iter().flat_map(|link| link.ends).map(|end| points[end as usize].z);
        let mut notes: Vec<String> = plane::check(used)?.into_iter().collect();
        let mut tags = vec![0; points.len()];
        nodes.iter().for_each(|(&tag, &index)| tags[index as usize] = tag);
        let points: Vec<DVec2> = points.iter().map(|point| point.truncate()).collect();
        let (rings, note) =
            loops::rings(&points, &links, |point| format!("node {}", tags[point as usize]))?;
        notes.extend(note);
        let (features, _) = polygons(rings, FillRule::EvenOdd, None)?;
        if others > 0 {
            notes.push(format!("left out {} that are no lines", counted(others, "element")));
        }
        Ok(Outlines { features, notes })
    }
}

/// The lines that are not blank.
struct Rows<'a> {
    rows: Box<dyn Iterator<Item = (u64, &'a str)> + 'a>,
    last: u64,
}

impl<'a> Rows<'a> {
    fn new(text: &'a str) -> Self {
        let rows = lines(text).map(|(line, text)| (line, text.trim()));
        Self { rows: Box::new(rows.filter(|(_, text)| !text.is_empty())), last: 0 }
    }

    fn try_next(&mut self) -> Option<(u64, &'a str)> {
        let row = self.rows.next()?;
        self.last = row.0;
        Some(row)
    }

    fn next(&mut self, what: &str) -> Result<Row<'a>, ReadError> {
        match self.try_next() {
            Some((line, text)) if !text.starts_with('$') => {
                Ok(Row { line, words: text.split_ascii_whitespace() })
            }
            _ => Err(at_line(self.last + 1, format!("the section ends where {what} should be"))),
        }
    }

    fn skip_to_end_of(&mut self, section: &str, start: u64) -> Result<(), ReadError> {
        while let Some((_, text)) = self.try_next() {
            if text.strip_prefix("$End") == Some(section) {
                return Ok(());
            }
        }
        Err(at_line(start, format!("the section has no end: $End{section} is missing")))
    }
}

/// A line of numbers.
struct Row<'a> {
    line: u64,
    words: std::str::SplitAsciiWhitespace<'a>,
}

impl Row<'_> {
    fn whole(&mut self, what: &str) -> Result<i64, ReadError> {
        whole_at(self.line, self.words.next(), what)
    }

    fn point(&mut self) -> Result<DVec3, ReadError> {
        let mut next = |what| number_at(self.line, self.words.next(), what);
        Ok(DVec3::new(next("x coordinate")?, next("y coordinate")?, next("z coordinate")?))
    }
}

fn format_version(rows: &mut Rows<'_>) -> Result<Version, ReadError> {
    let mut row = rows.next("the version")?;
    let version = row.words.next().unwrap_or_default();
    if row.words.next() != Some("0") {
        return Err(at_line(row.line, "this is a binary file; write text with Mesh.Binary = 0"));
    }
    match version {
        "4.1" => Ok(Version::V4),
        "2" | "2.0" | "2.1" | "2.2" => Ok(Version::V2),
        other => Err(at_line(
            row.line,
            format!("found the version {}, expected 4.1 or 2.2", quoted(other)),
        )),
    }
}

fn physical_names(rows: &mut Rows<'_>, file: &mut File) -> Result<(), ReadError> {
    let count = rows.next("the number of names")?.whole("number of names")?;
    for _ in 0..count {
        let Some((line, text)) = rows.try_next().filter(|(_, text)| !text.starts_with('$')) else {
            return Err(at_line(rows.last, "the section ends where a name should be"));
        };
        let mut words = text.splitn(3, char::is_whitespace);
        let dimension = whole_at(line, words.next(), "dimension")?;
        let tag = whole_at(line, words.next(), "tag of the group")?;
        let name = words.next().unwrap_or_default().trim().trim_matches('"');
        if dimension == 1 && !name.trim().is_empty() {
            file.names.insert(tag, name.into());
        }
    }
    Ok(())
}

/// Whether an element type is a line: of two, three or four nodes, and so on. The first two nodes
/// are its ends.
fn is_line(kind: i64) -> bool {
    matches!(kind, 1 | 8 | 26 | 27 | 28)
}
