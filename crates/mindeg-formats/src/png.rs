//! PNG: the picture of [`svg`](crate::svg) in pixels, for people without a viewer.
//!
//! Needs the feature `png`. The picture has no text: which fonts there are differs from machine to
//! machine, and the same mesh gives the same bytes. Dots have the [colors of their
//! degrees](crate::degree_color).
//!
//! Limits: those of [`svg`](crate::svg).

use crate::facts::Facts;
#[cfg(feature = "png")]
use crate::svg;
#[cfg(feature = "png")]
use mindeg_mesh::Mesh;

pub(crate) const FACTS: Facts = Facts {
    name: "png",
    description: "a picture in pixels",
    extensions: &["png"],
    leaves_out_depths: false,
    has_remarks: false,
    begins: |text| text.starts_with(b"\x89PNG"),
    #[cfg(feature = "png")]
    check_size: |_, vertices, _| svg::check_size(vertices),
    #[cfg(feature = "png")]
    write: |job, files| {
        files[0].1.write_all(&picture(job.mesh)?)?;
        files[0].1.flush()?;
        Ok(Vec::new())
    },
    #[cfg(not(feature = "png"))]
    check_size: |_, _, _| {
        Err(crate::WriteError::Refused(format!(
            "this build of mindeg does not write {}; write .svg, or build it with the feature png",
            FACTS.description
        )))
    },
    ..Facts::NONE
};

/// A picture of a mesh, 1200 pixels wide. Takes O(n log n) time and O(n) memory for n vertices.
#[cfg(feature = "png")]
fn picture(mesh: &dyn Mesh) -> Result<Vec<u8>, crate::WriteError> {
    use resvg::tiny_skia::{Pixmap, Transform};
    use resvg::usvg::{Options, Tree};
    use std::io::{Error, ErrorKind};

    let picture = svg::without_text(mesh, 1200.0)?;
    let tree = Tree::from_data(&picture, &Options::default()).map_err(Error::other)?;
    let size = tree.size().to_int_size();
    let pixels = Pixmap::new(size.width(), size.height());
    let mut pixels = pixels.ok_or_else(|| Error::from(ErrorKind::OutOfMemory))?;
    resvg::render(&tree, Transform::identity(), &mut pixels.as_mut());
    Ok(pixels.encode_png().map_err(Error::other)?)
}
