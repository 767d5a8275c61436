//! Numbers of vertices as text, fast where they come again.
//!
//! Limits: the cache is small, and made for vertices in the order of strips.

use crate::decimals::Text;

/// How long the name of a corner can get: a space, and three numbers of ten digits with slashes.
const LONGEST_CORNER: usize = (1 + 3 * 10 + 2_usize).next_multiple_of(8);

/// How many corners are kept: a power of two.
const KEPT: usize = 8;

/// How the corners of faces are named: by the vertex, and again for its texture coordinates and
/// its normal if the mesh has them.
///
/// Some names are kept: along a strip a vertex is a corner of three triangles or more.
pub(super) struct CornerNames {
    kept: [CornerName; KEPT],
    /// The separators before each of the numbers.
    separators: &'static [&'static [u8]],
}

#[derive(Clone, Copy)]
struct CornerName {
    /// The vertex as the file numbers it, from 1; 0 for none yet.
    number: u32,
    text: Text<LONGEST_CORNER>,
}

impl CornerNames {
    pub(super) fn new(texture_coordinates: bool, normals: bool) -> Self {
        let nobody = CornerName { number: 0, text: Text::EMPTY };
        let separators: &[&[u8]] = match (texture_coordinates, normals) {
            (true, true) => &[b" ", b"/", b"/"],
            (true, false) => &[b" ", b"/"],
            (false, true) => &[b" ", b"//"],
            (false, false) => &[b" "],
        };
        Self { kept: [nobody; KEPT], separators }
    }

    /// Appends a face with these vertices, counted from 0.
    pub(super) fn push_face(&mut self, vertices: [u32; 3], buffer: &mut Vec<u8>) {
        buffer.push(b'f');
        for vertex in vertices {
            self.name(vertex + 1).append_to(buffer);
        }
        buffer.push(b'\n');
    }

    fn name(&mut self, number: u32) -> &Text<LONGEST_CORNER> {
        let name = &mut self.kept[number as usize % KEPT];
        if name.number != number {
            let mut digits = itoa::Buffer::new();
            let digits = digits.format(number).as_bytes();
            name.number = number;
            name.text = Text::EMPTY;
            for separator in self.separators {
                name.text.push(separator);
                name.text.push(digits);
            }
        }
        &name.text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faces_have_room_for_the_longest_names() {
        let mut names = CornerNames::new(true, true);
        let last = u32::MAX - 1;
        let mut text = Vec::new();
        for face in [[0, 7, 8], [8, 16, 0], [last - 8, last - 16, last], [last, 0, last - 8]] {
            names.push_face(face, &mut text);
        }
        let expected = "\
f 1/1/1 8/8/8 9/9/9
f 9/9/9 17/17/17 1/1/1
f 4294967287/4294967287/4294967287 4294967279/4294967279/4294967279 4294967295/4294967295/4294967295
f 4294967295/4294967295/4294967295 1/1/1 4294967287/4294967287/4294967287
";
        assert_eq!(String::from_utf8(text), Ok(expected.to_owned()));
    }
}
