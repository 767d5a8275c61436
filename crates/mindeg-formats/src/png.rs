//! PNG: the picture of [`svg`](crate::svg) in pixels, for people without a viewer.
//!
//! Needs the feature `png`. The picture has no text: which fonts there are differs from machine to
//! machine, and the same mesh gives the same bytes. Dots have the [colors of their
//! degrees](crate::degree_color).
//!
//! Limits: those of [`svg`](crate::svg).

use crate::{WriteError, svg};
use mindeg_mesh::Mesh;
use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree};
use std::io::{self, Write};

/// The width of the picture in pixels; the height is at most as much.
const WIDTH: f64 = 1200.0;

/// Writes a picture of a mesh, 1200 pixels wide.
///
/// Takes O(n log n) time and O(n) memory for n vertices.
///
/// # Errors
///
/// [`TooLargeForSvg`](WriteError::TooLargeForSvg) before the first byte, and those of `out`.
///
/// # Example
///
/// ```
/// use mindeg_formats::{obj, png};
///
/// let mesh = obj::read("v 0 0 0\nv 2 0 0\nv 2 1 0\nf 1 2 3\n".as_bytes())?;
/// let mut picture = Vec::new();
/// png::write(&mesh, &mut picture)?;
/// assert!(picture.starts_with(b"\x89PNG"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write(mesh: &dyn Mesh, mut out: impl Write) -> Result<(), WriteError> {
    let picture = svg::without_text(mesh, WIDTH)?;
    let tree = Tree::from_data(&picture, &Options::default()).map_err(io::Error::other)?;
    let size = tree.size().to_int_size();
    let pixels = Pixmap::new(size.width(), size.height());
    let mut pixels = pixels.ok_or_else(|| io::Error::from(io::ErrorKind::OutOfMemory))?;
    resvg::render(&tree, Transform::identity(), &mut pixels.as_mut());
    let png = pixels.encode_png().map_err(io::Error::other)?;
    out.write_all(&png)?;
    Ok(out.flush()?)
}
