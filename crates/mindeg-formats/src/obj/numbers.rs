//! Numbers as text, fast where they come again.
//!
//! Limits: what is kept is small, and made for vertices in the order of strips and points in the
//! order of sides.

/// Decimals of one coordinate after another, each after a space.
///
/// The last one is kept: along a side that is parallel to an axis, one coordinate stays the same.
pub(super) struct Decimals<F> {
    last: Option<F>,
    text: Text<LONGEST_DECIMAL>,
    digits: zmij::Buffer,
}

/// How long a decimal can get: a space, a sign, 17 digits with a point, and `e-308`; longer by what
/// makes copying all of it as fast as it gets.
const LONGEST_DECIMAL: usize = 32;

/// A short text. Appending it copies all `N` bytes, which is fast since their number is known, and
/// takes back those too many.
#[derive(Clone, Copy)]
struct Text<const N: usize> {
    bytes: [u8; N],
    len: usize,
}

impl<const N: usize> Text<N> {
    const EMPTY: Self = Self { bytes: [0; N], len: 0 };

    fn push(&mut self, text: &[u8]) {
        self.bytes[self.len..][..text.len()].copy_from_slice(text);
        self.len += text.len();
    }

    fn append_to(&self, buffer: &mut Vec<u8>) {
        let end = buffer.len() + self.len;
        buffer.extend_from_slice(&self.bytes);
        buffer.truncate(end);
    }
}

impl<F: zmij::Float + PartialEq> Decimals<F> {
    pub(super) fn new() -> Self {
        Self { last: None, text: Text::EMPTY, digits: zmij::Buffer::new() }
    }

    /// Appends a finite number that is not -0: the shortest decimal that reads back the same.
    pub(super) fn push(&mut self, value: F, buffer: &mut Vec<u8>) {
        if self.last != Some(value) {
            let number = self.digits.format_finite(value);
            let number = number.strip_suffix(".0").unwrap_or(number);
            self.text = Text::EMPTY;
            self.text.push(b" ");
            self.text.push(number.as_bytes());
            self.last = Some(value);
        }
        self.text.append_to(buffer);
    }
}

/// How long the name of a corner can get: a space, and three numbers of ten digits with slashes.
const LONGEST_CORNER: usize = (1 + 3 * 10 + 2_usize).next_multiple_of(8);

/// How many corners are kept: a power of two.
const KEPT: usize = 8;

/// How the corners of faces are named: by the vertex, and again for its texture coordinates and
/// its normal where there are any.
///
/// Some names are kept: along a strip a vertex is a corner of three triangles or more.
pub(super) struct CornerNames {
    kept: [CornerName; KEPT],
    /// What separates the numbers, in a row.
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
    fn decimals_come_again_as_they_are() {
        let mut decimals = Decimals::new();
        let mut text = Vec::new();
        for value in [0.0, 0.0, 1.5, 1.5, 0.1, 1e300, 1e300, -2.0, -5e-324] {
            decimals.push(value, &mut text);
        }
        assert_eq!(String::from_utf8_lossy(&text), " 0 0 1.5 1.5 0.1 1e+300 1e+300 -2 -5e-324");
    }

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
