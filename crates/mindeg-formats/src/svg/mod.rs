//! A picture of the mesh, as SVG.
//!
//! The outline, every interior edge, the lines inside, the groups in colors where there are several, the vertices
//! colored by degree with a legend that counts them, and along every line of the mesh its name and number of
//! intervals. The picture stands alone: no script, no font of its own, nothing fetched; it brings its background along
//! and turns dark where the reader's system is dark. Lines and dots shrink with the distance between vertices.
//!
//! A mesh in space is seen along the axis that its triangles face most: the one in which their
//! normals are largest on average, weighted by area. Where some triangles then face the eye and others
//! do not, nearer ones are drawn over farther ones, and of a closed solid only those that face the eye.
//!
//! Limits: a mesh of more than [`MAX_VERTICES`] vertices is refused, since its edges would
//! run into one another. Above [`MAX_DOTS`] vertices, edges are drawn without dots. A side
//! too short for its label goes without. Triangles that pass through each other, or lie round each other
//! in a circle, hide each other as a whole. Coordinates are rounded to a hundredth of a pixel.

mod drawing;
mod frame;
mod solid;
mod style;
mod view;

use self::drawing::Drawing;
use self::frame::Frame;
pub use self::style::{MAX_DOTS, MAX_VERTICES, STYLE};
use self::style::{SIDE_MARGIN, WIDTH, hex};
use self::view::View;
use crate::facts::Facts;
use crate::names::xml;
use crate::{WriteError, degree_color, made_by, mesh_name};
use glam::DVec2;
use mindeg_mesh::{Bounds, Mesh};
use std::fmt::Write as _;
use std::io::Write;

pub(crate) const FACTS: Facts = Facts {
    name: "svg",
    description: "a picture",
    extensions: &["svg"],
    leaves_out_depths: false,
    begins: |text| text.starts_with(b"<") && memchr::memmem::find(text, b"<svg").is_some(),
    check_size: |_, vertices, _| check_size(vertices),
    write: |job, files| write(job.mesh, &mut files[0].1).map(|()| Vec::new()),
    ..Facts::NONE
};

/// Writes a picture of a mesh.
///
/// Takes O(n log n) time and O(n) memory for n vertices.
///
/// # Errors
///
/// Too many vertices, before the first byte, and errors of `out`.
///
/// # Example
///
/// ```
/// use mindeg::{BoundaryMesh, Domain};
/// use mindeg_formats::svg;
///
/// let domain = Domain::from_json(
///     r#"{"name": "plate", "rectangle": {"width": 4, "height": 3},
///         "sides": [{"intervals": 3}, {"intervals": 3}, {"intervals": 2}, {"intervals": 2}]}"#,
/// )?;
/// let mut picture = Vec::new();
/// svg::write(&BoundaryMesh::least_degree(&domain)?, &mut picture)?;
/// let picture = String::from_utf8(picture)?;
/// assert!(picture.contains("10 vertices · 8 triangles · maximum degree 4"));
/// assert_eq!(picture.matches("<circle").count(), 10 + 3); // and three in the legend
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write(mesh: &dyn Mesh, mut out: impl Write) -> Result<(), WriteError> {
    check_size(mesh.vertex_count())?;
    let view = View::of(mesh);
    let frame = Frame::of_picture(view.of_box(mesh.bounds()));
    let drawing = Drawing::new(mesh, &frame, view);
    out.write_all(head(mesh, &frame).as_bytes())?;
    drawing.write(&mut out)?;
    out.write_all(drawing.labels().as_bytes())?;
    out.write_all(legend(mesh, &drawing, &frame).as_bytes())?;
    out.write_all(b"</svg>\n")?;
    Ok(out.flush()?)
}

/// A mesh as a part of a larger picture, without title, labels and legend.
///
/// # Example
///
/// ```
/// use glam::DVec2;
/// use mindeg::{BoundaryMesh, Bounds, Domain, Side};
/// use mindeg_formats::svg::Inset;
///
/// let domain = Domain::rectangle(4.0, 3.0, [3, 3, 2, 2].map(Side::count).into())?;
/// let room = Bounds { min: DVec2::splat(20.0), max: DVec2::new(220.0, 190.0) };
/// let inset = Inset::new(domain.placement().bounds(), room);
/// assert_eq!(inset.size().to_array(), [200.0, 150.0]);
///
/// let mut drawing = Vec::new();
/// inset.write(&BoundaryMesh::least_degree(&domain)?, &mut drawing)?;
/// assert_eq!(String::from_utf8(drawing)?.matches("<circle").count(), 10);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Inset {
    frame: Frame,
}

impl Inset {
    /// Fits what lies in `bounds` into a frame of a picture, which is in pixels, y downwards:
    /// as large as it can be, in the middle and at the top.
    #[must_use]
    pub fn new(bounds: Bounds, frame: Bounds) -> Self {
        Self { frame: Frame::new(bounds, frame) }
    }

    /// The size of the fitted mesh, in pixels.
    #[must_use]
    pub fn size(&self) -> DVec2 {
        self.frame.size
    }

    /// Where a point is in the picture, in pixels.
    #[must_use]
    pub fn place(&self, point: DVec2) -> DVec2 {
        self.frame.place(point)
    }

    /// How the picture distorts the mesh, if it does: words such as "height drawn 20
    /// times too large".
    #[must_use]
    pub fn stretch(&self) -> Option<String> {
        self.frame.stretch()
    }

    /// Draws a mesh that lies in the bounds; [`STYLE`] has its colors.
    ///
    /// # Errors
    ///
    /// As [`write()`].
    pub fn write(&self, mesh: &dyn Mesh, mut out: impl Write) -> Result<(), WriteError> {
        check_size(mesh.vertex_count())?;
        Ok(Drawing::new(mesh, &self.frame, View::Z).write(&mut out)?)
    }
}

/// The picture without any text, light, of `width` pixels.
#[cfg(feature = "png")]
pub(crate) fn without_text(mesh: &dyn Mesh, width: f64) -> Result<Vec<u8>, WriteError> {
    check_size(mesh.vertex_count())?;
    let view = View::of(mesh);
    let margin = width / 40.0;
    let room = Bounds { min: DVec2::splat(margin), max: DVec2::splat(width - margin) };
    let frame = Frame::new(view.of_box(mesh.bounds()), room);
    let height = frame.size.y + 2.0 * margin;
    // A viewer's preferences, which are in the second part, reach no pixel.
    let style = STYLE.split("@media").next().unwrap_or_default();
    let mut picture = format!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height:.0}"><style>{style}</style><rect width="100%" height="100%" fill="white"/>"#
    )
    .into_bytes();
    Drawing::new(mesh, &frame, view).write(&mut picture)?;
    picture.extend_from_slice(b"</svg>");
    Ok(picture)
}

/// Refuses a mesh with more vertices than a picture shows. O(1).
pub(crate) fn check_size(vertices: u32) -> Result<(), WriteError> {
    if vertices <= MAX_VERTICES {
        return Ok(());
    }
    Err(WriteError::Refused(format!(
        "an SVG shows {MAX_VERTICES} vertices at most, and this mesh has {vertices}; write OBJ or \
         glTF, or use fewer intervals"
    )))
}

fn head(mesh: &dyn Mesh, frame: &Frame) -> String {
    let name = xml(mesh_name(mesh));
    let mut summary = format!(
        "{} vertices · {} triangles · maximum degree {}",
        mesh.vertex_count(),
        mesh.triangle_count(),
        mesh.max_degree()
    );
    if let Some(stretch) = frame.stretch() {
        summary += " · ";
        summary += &stretch;
    }
    let (height, inner) = (frame.height(), frame.height() - 1.0);
    format!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{height:.0}" viewBox="0 0 {WIDTH} {height:.0}" role="img" aria-labelledby="title summary">
<title id="title">{name}</title>
<desc id="summary">{summary}</desc>
<metadata>{}</metadata>
<style>{STYLE}</style>
<rect class="card" x="0.5" y="0.5" width="{}" height="{inner:.0}" rx="12"/>
<text class="title" x="{SIDE_MARGIN}" y="46">{name}</text>
<text class="muted" x="{SIDE_MARGIN}" y="70">{summary}</text>
"#,
        made_by(mesh),
        WIDTH - 1.0,
    )
}

/// The meaning of the colors, and how many vertices have each.
fn legend(mesh: &dyn Mesh, drawing: &Drawing<'_>, frame: &Frame) -> String {
    let classes = drawing.degree_classes();
    let y = frame.height() - 34.0;
    if classes.is_empty() {
        return format!(
            "<text class=\"muted\" x=\"{SIDE_MARGIN}\" y=\"{y:.0}\">\
             dots only up to {MAX_DOTS} vertices</text>\n"
        );
    }
    let mut text =
        format!("<text class=\"muted\" x=\"{SIDE_MARGIN}\" y=\"{y:.0}\">degree</text>\n");
    let mut x = SIDE_MARGIN + 76.0;
    for (class, count) in classes {
        let above = class == *degree_color::DISTINCT.end() && mesh.max_degree() > class;
        let (degree, count) =
            (format!("{class}{}", if above { "+" } else { "" }), count.to_string());
        let _ = writeln!(
            text,
            r#"<circle class="ring" cx="{x:.0}" cy="{:.0}" r="7" fill="{}"/><text x="{:.0}" y="{y:.0}"><tspan class="key">{degree}</tspan><tspan class="muted" dx="6">× {count}</tspan></text>"#,
            y - 5.0,
            hex(class),
            x + 14.0,
        );
        x += 67.0 + 9.0 * (degree.len() + count.len()) as f64;
    }
    text
}
