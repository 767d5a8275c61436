//! One color for every degree, the same in all formats.
//!
//! Degrees 2 to 8 have a color each; that of 8 stands for everything above, too. The colors
//! lie on matplotlib's *plasma* (Nathaniel Smith and Stéfan van der Walt, CC0), at 0, 0.25,
//! 0.45, 0.63, 0.78, 0.9 and 1: lightness rises with the degree, so that the order survives
//! color blindness and grey print, and the steps are widest among the low degrees, where
//! meshes of least degree differ.
//!
//! Limits: degrees from 8 upwards look alike.

use std::ops::Range;

use crate::corners::degrees;
use mindeg_mesh::Mesh;

/// The degrees that have a color of their own, from the lowest a vertex of a triangulation
/// can have to the one that stands for all above it.
pub const DISTINCT: std::ops::RangeInclusive<u32> = 2..=8;

const COLORS: [[u8; 3]; 7] = [
    [0x0d, 0x08, 0x87],
    [0x7e, 0x03, 0xa8],
    [0xbf, 0x39, 0x84],
    [0xe7, 0x6e, 0x5b],
    [0xfb, 0x9f, 0x3a],
    [0xfc, 0xce, 0x25],
    [0xf0, 0xf9, 0x21],
];

/// The color of a degree: red, green and blue in sRGB, 0 to 255. Degrees outside
/// [`DISTINCT`] take the color of its nearer end.
///
/// # Example
///
/// ```
/// use mindeg_formats::degree_color;
///
/// assert_ne!(degree_color::srgb(4), degree_color::srgb(5));
/// assert_eq!(degree_color::srgb(9), degree_color::srgb(100));
/// ```
#[must_use]
pub fn srgb(degree: u32) -> [u8; 3] {
    let step = degree.clamp(*DISTINCT.start(), *DISTINCT.end()) - DISTINCT.start();
    COLORS[step as usize]
}

/// The color of a degree as linear light, 0 to 255, which is how glTF keeps vertex colors.
pub(crate) fn linear(degree: u32) -> [u8; 3] {
    srgb(degree).map(|channel| {
        // IEC 61966-2-1.
        let encoded = f64::from(channel) / 255.0;
        let light = if encoded <= 0.04045 {
            encoded / 12.92
        } else {
            libm::pow((encoded + 0.055) / 1.055, 2.4)
        };
        libm::round(light * 255.0) as u8
    })
}

/// The color of each vertex; none if colors are not `wanted`.
pub(crate) fn of_vertices(
    mesh: &dyn Mesh,
    vertices: Range<u32>,
    wanted: bool,
) -> impl Iterator<Item = Option<[u8; 3]>> + use<> {
    let degrees = if wanted { degrees(mesh, vertices.clone()) } else { Vec::new() };
    (0..vertices.len()).map(move |index| degrees.get(index).map(|&degree| srgb(degree)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lightness_rises_with_the_degree() {
        let luminance = |degree| {
            let [r, g, b] = linear(degree).map(f64::from);
            0.2126 * r + 0.7152 * g + 0.0722 * b
        };
        assert!(DISTINCT.map(luminance).is_sorted_by(|a, b| a < b));
    }

    #[test]
    fn degrees_outside_take_the_nearer_end() {
        assert_eq!(srgb(0), srgb(2));
        assert_eq!(srgb(u32::MAX), srgb(8));
    }

    #[test]
    fn linear_light_is_darker_in_the_middle() {
        // By hand: 0xbf / 255 = 0.749, and ((0.749 + 0.055) / 1.055)^2.4 * 255 = 133.
        assert_eq!(linear(4), [133, 10, 59]);
    }
}
