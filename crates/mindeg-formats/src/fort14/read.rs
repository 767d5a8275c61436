//! Reading fort.14.

use crate::ReadError;
use crate::lists::push;
use crate::numbered::Numbered;
use crate::records::{Records, Words};
use crate::words::{number, words};
use mindeg_mesh::{LineKind, TriMesh};
use std::io::BufRead;

/// Reads a mesh from a fort.14, with its depths and boundary segments.
///
/// Positions lie at z = 0. Vertices may have any numbers; elements have three or four corners. The
/// boundary segments become lines: those of type 1, 11 and 21 islands, which are closed, the others
/// land. The file may end before the segments.
///
/// O(n log n) time and O(n) memory for n bytes, whatever the file says.
///
/// # Errors
///
/// Errors of the input; lines that break the format; elements and boundary segments
/// that name vertices that the file does not have; a file without elements.
///
/// # Example
///
/// ```
/// use mindeg_formats::fort14;
/// use mindeg_mesh::{LineKind, Triangles};
///
/// let file = "bay\n1 3\n1 0 0 2.5\n2 1 0 2.5\n3 0 1 0\n1 3 1 2 3\n1\n2\n2\n1\n2\n0\n0\n";
/// let mesh = fort14::read(file.as_bytes())?;
/// assert_eq!((mesh.name(), mesh.triangles()), (Some("bay"), &[[0, 1, 2]][..]));
/// assert_eq!((mesh.segments(), mesh.line_kind(0)), (&[[0, 1]][..], Some(LineKind::Open)));
///
/// let error = fort14::read(file.replace("3 1 2 3", "3 1 2 4").as_bytes()).unwrap_err();
/// assert_eq!(error.to_string(), "line 6: vertex 4 does not exist; the file has 1 to 3");
/// # Ok::<(), mindeg_formats::ReadError>(())
/// ```
pub fn read(input: impl BufRead) -> Result<TriMesh, ReadError> {
    let mut records = Records::new(input, None);
    let title = records.next_raw()?.map(|title| title.text()).unwrap_or_default();
    let mut sizes = records.expect("the numbers of elements and vertices")?;
    let elements = sizes.count("the number of elements")?;
    let vertices = sizes.count("the number of vertices")?;
    let mut contents = Numbered::default();
    let mut depths = Vec::new();
    for _ in 0..vertices {
        let mut words = records.expect("its last vertex")?;
        let id = words.id()?;
        let mut point = words.point("the depth")?;
        push(&mut depths, point.z)?;
        point.z = 0.0;
        contents.nodes.push(id.into(), point)?;
    }
    for _ in 0..elements {
        let mut words = records.expect("its last element")?;
        words.count("the number of the element")?;
        let count = words.count("the number of corners")?;
        let mut corners = [0; 4];
        let corners = match count {
            3 => &mut corners[..3],
            4 => &mut corners[..],
            _ => return Err(words.problem(format!("the element has {count} corners, not 3 or 4"))),
        };
        for corner in corners.iter_mut() {
            *corner = words.id()?;
        }
        contents.element(words.line, corners, 0)?;
    }
    for is_open in [true, false] {
        let Some(mut words) = records.next()? else { break };
        let boundaries = words.count("the number of boundary segments")?;
        if records.next()?.is_none() {
            break;
        }
        for number in 0..boundaries {
            read_segment(&mut records, &mut contents, is_open, number + 1)?;
        }
    }
    let mesh = contents.into_mesh("zone")?;
    let mesh = if title.is_empty() { mesh } else { mesh.named(title) };
    let is_flat = depths.iter().all(|&depth| depth == 0.0);
    Ok(if is_flat { mesh } else { mesh.with_depths(depths) })
}

/// Whether the second line of a file begins with two whole numbers, as that of a fort.14 does.
pub(crate) fn fits(head: &[u8]) -> bool {
    let mut lines = head.split(|byte| matches!(byte, b'\n' | b'\r')).skip(1);
    let second = lines.find(|line| !line.trim_ascii().is_empty()).unwrap_or_default();
    let sizes: Vec<_> = words(second).take(2).map(number::<u64>).collect();
    matches!(sizes[..], [Some(_), Some(_)])
}

fn read_segment(
    records: &mut Records<impl BufRead>,
    contents: &mut Numbered,
    is_open: bool,
    number: u64,
) -> Result<(), ReadError> {
    let mut head = records.expect("its last boundary segment")?;
    let count = head.count("the number of vertices of the segment")?;
    // Open segments may have a type too.
    let code = if is_open { 0 } else { head.integer("the type of the segment")? };
    let kind = match (is_open, code) {
        (true, _) => LineKind::Open,
        (false, 1 | 11 | 21) => LineKind::Island,
        (false, _) => LineKind::Land,
    };
    let name = name(head).unwrap_or_else(|| format!("{} boundary {number}", kind.name()));
    let mut string = Vec::new();
    for _ in 0..count {
        let mut words = records.expect("the last vertex of a boundary segment")?;
        push(&mut string, (words.id()?, words.line))?;
    }
    if let (LineKind::Island, [first, .., last]) = (kind, &string[..])
        && first.0 != last.0
    {
        let first = *first;
        push(&mut string, first)?;
    }
    Ok(contents.string(&name, Some(kind), string)?)
}

/// The name in parentheses at the end of a comment.
fn name(words: Words<'_>) -> Option<String> {
    let text = words.text();
    let (_, name) = text.strip_suffix(')')?.split_once('(')?;
    (!name.is_empty()).then(|| name.to_owned())
}
