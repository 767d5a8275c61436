//! A picture of the mesh, as SVG.
//!
//! The outline, every interior edge, the vertices colored by degree with a legend that
//! counts them, and along every side its name and number of intervals. The picture stands
//! alone: no script, no font of its own, nothing fetched; it brings its background along
//! and turns dark where the reader's system is dark. Lines and dots shrink with the
//! distance between vertices.
//!
//! Limits: a mesh of more than [`MAX_VERTICES`] vertices is refused, since its edges would
//! run into one another. Above [`MAX_DOTS`] vertices, edges are drawn without dots. A side
//! too short for its label goes without. Coordinates are rounded to a hundredth of a pixel.

use super::sections::{Section, write_sections};
use super::{ExportError, GENERATOR, degree_color, mesh_name, side_name};
use crate::{Bounds, Mesh};
use glam::DVec2;
use mindeg_core::Boundary;
use std::fmt::Write as _;
use std::io::{self, Write};
use std::ops::Range;

/// The most vertices a picture shows.
pub const MAX_VERTICES: u32 = 100_000;

/// The most vertices that are drawn as dots.
pub const MAX_DOTS: u32 = 5_000;

/// The width of the picture and the room round the mesh, in pixels.
const WIDTH: f64 = 960.0;
const SIDE_MARGIN: f64 = 56.0;
const TOP: f64 = 124.0;
const BOTTOM: f64 = 104.0;
/// The most a mesh takes from top to bottom.
const MAX_HEIGHT: f64 = 640.0;
/// The radius of the largest dots as a share of the mesh's longer extent.
const LARGEST_DOT: f64 = 0.0125;
/// A mesh more slender than that is widened for the picture, which says so.
const MAX_SLENDERNESS: f64 = 10.0;

/// The colors of what [`Inset::write`] draws and of the classes `card`, `title`, `muted`, `key` and
/// `label`, as a style sheet, on a light background and on a dark one.
pub const STYLE: &str = "\
text{font-family:system-ui,-apple-system,'Segoe UI',Roboto,'DejaVu Sans',sans-serif;\
fill:#1f2328}\
.card{fill:#fff;stroke:#d1d9e0}\
.title{font-size:22px;font-weight:600}\
.muted{font-size:15px;fill:#59636e}\
.key{font-size:15px;font-weight:600}\
.label{font-size:14px;fill:#59636e;text-anchor:middle}\
.face{fill:#eef2fb}.shade{fill:#e0e7f5}\
.edge{fill:none;stroke:#7f8ca3;stroke-linecap:round}\
.outline{fill:none;stroke:#2b3440;stroke-width:2;stroke-linejoin:round}\
.ring{stroke:#fff}\
@media(prefers-color-scheme:dark){\
text{fill:#f0f6fc}.card{fill:#0d1117;stroke:#3d444d}.muted,.label{fill:#9198a1}\
.face{fill:#171e2b}.shade{fill:#1f2838}.edge{stroke:#66738a}.outline{stroke:#c3ccd8}.ring{stroke:#f0f6fc}}";

/// Writes a picture of the mesh.
///
/// Takes O(n log k) time for n vertices on k sides, and the memory of one block.
///
/// # Errors
///
/// [`TooLargeForSvg`](ExportError::TooLargeForSvg) before the first byte, and those of `out`.
///
/// # Example
///
/// ```
/// use mindeg_geometry::export::svg;
/// use mindeg_geometry::{Domain, Mesh};
///
/// let domain = Domain::from_json(
///     r#"{"name": "plate", "rectangle": {"width": 4, "height": 3},
///         "sides": [{"intervals": 3}, {"intervals": 3}, {"intervals": 2}, {"intervals": 2}]}"#,
/// )?;
/// let mut picture = Vec::new();
/// svg::write(&Mesh::least_degree(&domain)?, &mut picture)?;
/// let picture = String::from_utf8(picture)?;
/// assert!(picture.contains("10 vertices · 8 triangles · maximum degree 4"));
/// assert_eq!(picture.matches("<circle").count(), 10 + 3); // and three in the legend
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write(mesh: &Mesh, mut out: impl Write) -> Result<(), ExportError> {
    check_size(mesh.boundary())?;
    let frame = Frame::of_picture(mesh.placement().bounds());
    let out = &mut out;
    out.write_all(head(mesh, &frame).as_bytes())?;
    write_mesh(mesh, &frame, out)?;
    out.write_all(labels(mesh, &frame).as_bytes())?;
    out.write_all(legend(mesh, &frame).as_bytes())?;
    out.write_all(b"</svg>\n")?;
    Ok(out.flush()?)
}

/// A mesh as a part of a larger picture, without title, labels and legend.
///
/// # Example
///
/// ```
/// use glam::DVec2;
/// use mindeg_geometry::export::svg::Inset;
/// use mindeg_geometry::{Bounds, Domain, Mesh, Side};
///
/// let domain = Domain::rectangle(4.0, 3.0, [3, 3, 2, 2].map(Side::count).into())?;
/// let room = Bounds { min: DVec2::splat(20.0), max: DVec2::new(220.0, 190.0) };
/// let inset = Inset::new(domain.placement().bounds(), room);
/// assert_eq!(inset.size().to_array(), [200.0, 150.0]);
///
/// let mut drawing = Vec::new();
/// inset.write(&Mesh::least_degree(&domain)?, &mut drawing)?;
/// assert_eq!(String::from_utf8(drawing)?.matches("<circle").count(), 10);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Inset {
    frame: Frame,
}

impl Inset {
    /// Fits what lies in `bounds` into some room of a picture, which is in pixels, y downwards:
    /// as large as it can be, in the middle and at the top.
    #[must_use]
    pub fn new(bounds: Bounds, room: Bounds) -> Self {
        Self { frame: Frame::new(bounds, room) }
    }

    /// The size of what is fitted, in pixels.
    #[must_use]
    pub fn size(&self) -> DVec2 {
        self.frame.size
    }

    /// What the picture makes larger than it is, if anything: words such as "height drawn 20
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
    pub fn write(&self, mesh: &Mesh, mut out: impl Write) -> Result<(), ExportError> {
        check_size(mesh.boundary())?;
        Ok(write_mesh(mesh, &self.frame, &mut out)?)
    }
}

/// Refuses a boundary whose meshes have more vertices than a picture shows. O(1).
///
/// # Errors
///
/// [`TooLargeForSvg`](ExportError::TooLargeForSvg).
pub fn check_size(boundary: &Boundary) -> Result<(), ExportError> {
    let vertices = boundary.vertex_count();
    if vertices > MAX_VERTICES {
        return Err(ExportError::TooLargeForSvg { vertices, limit: MAX_VERTICES });
    }
    Ok(())
}

fn write_mesh(mesh: &Mesh, frame: &Frame, out: &mut impl Write) -> io::Result<()> {
    out.write_all(outline(mesh, frame, "face").as_bytes())?;
    if mesh.vertex_count() <= MAX_DOTS {
        write_shade(mesh, frame, out)?;
    }
    write_edges(mesh, frame, out)?;
    out.write_all(outline(mesh, frame, "outline").as_bytes())?;
    for (class, _) in degree_classes(mesh) {
        write_dots(mesh, frame, class, out)?;
    }
    Ok(())
}

/// How points of the mesh become points of the picture, whose y runs downwards.
struct Frame {
    /// Pixels to a unit of length in x and in y.
    scale: DVec2,
    /// The upper left corner of the mesh's box, in the mesh and in the picture.
    from: DVec2,
    to: DVec2,
    /// The size of the mesh's box in the picture.
    size: DVec2,
}

impl Frame {
    /// The place of the mesh in a picture of its own.
    fn of_picture(bounds: Bounds) -> Self {
        let min = DVec2::new(SIDE_MARGIN, TOP);
        Self::new(bounds, Bounds { min, max: DVec2::new(WIDTH - SIDE_MARGIN, TOP + MAX_HEIGHT) })
    }

    fn new(bounds: Bounds, room: Bounds) -> Self {
        let length = bounds.size();
        let thinnest = length.max_element() / MAX_SLENDERNESS;
        let drawn = length.max(DVec2::splat(thinnest));
        let size = drawn * (room.size() / drawn).min_element();
        let scale = size / length;
        let to = DVec2::new(room.center().x - size.x / 2.0, room.min.y);
        Self { scale, from: DVec2::new(bounds.min.x, bounds.max.y), to, size }
    }

    fn place(&self, point: DVec2) -> DVec2 {
        self.to + (point - self.from) * self.scale * DVec2::new(1.0, -1.0)
    }

    /// What the picture makes larger than it is, if anything.
    fn stretch(&self) -> Option<String> {
        let DVec2 { x, y } = self.scale;
        let (what, factor) = if x > y { ("width", x / y) } else { ("height", y / x) };
        (factor > 1.0 + 1e-6)
            .then(|| format!("{what} drawn {} times too large", (factor * 10.0).round() / 10.0))
    }

    fn height(&self) -> f64 {
        TOP + self.size.y + BOTTOM
    }
}

/// Pixels between a vertex and the next round the boundary, on the average.
fn spacing(mesh: &Mesh, frame: &Frame) -> f64 {
    let corners = corners(mesh, frame);
    let next = corners.iter().cycle().skip(1);
    let perimeter: f64 = corners.iter().zip(next).map(|(a, b)| a.distance(*b)).sum();
    perimeter / f64::from(mesh.vertex_count())
}

/// The corners in the picture, corner 0 first.
fn corners(mesh: &Mesh, frame: &Frame) -> Vec<DVec2> {
    mesh.placement().corners().iter().map(|&corner| frame.place(corner)).collect()
}

fn head(mesh: &Mesh, frame: &Frame) -> String {
    let name = escaped(mesh_name(mesh.domain()));
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
<metadata>{GENERATOR}</metadata>
<style>{STYLE}</style>
<rect class="card" x="0.5" y="0.5" width="{}" height="{inner:.0}" rx="12"/>
<text class="title" x="{SIDE_MARGIN}" y="46">{name}</text>
<text class="muted" x="{SIDE_MARGIN}" y="70">{summary}</text>
"#,
        WIDTH - 1.0,
    )
}

fn outline(mesh: &Mesh, frame: &Frame, class: &str) -> String {
    let mut points = Vec::new();
    for corner in corners(mesh, frame) {
        if !points.is_empty() {
            points.push(b' ');
        }
        push_point(&mut points, corner);
    }
    let points = String::from_utf8_lossy(&points);
    format!("<polygon class=\"{class}\" points=\"{points}\"/>\n")
}

fn write_items(
    out: &mut impl Write,
    count: u32,
    format: impl Fn(Range<u32>, &mut Vec<u8>) + Sync,
) -> io::Result<()> {
    write_sections(out, &[Section::new(count, 32, format)])
}

/// Every other triangle a shade darker, so that the strips stand out.
fn write_shade(mesh: &Mesh, frame: &Frame, out: &mut impl Write) -> io::Result<()> {
    out.write_all(b"<path class=\"shade\" d=\"")?;
    write_items(out, mesh.triangle_count(), |range, buffer| {
        for i in range.filter(|i| i % 2 == 1) {
            for (v, command) in mesh.triangle(i).into_iter().zip(*b"MLL") {
                buffer.push(command);
                push_point(buffer, frame.place(mesh.point(v)));
            }
            buffer.push(b'Z');
        }
    })?;
    out.write_all(b"\"/>\n")
}

/// Every interior edge once. A triangulation has each of them in two triangles, which run
/// through it in opposite directions, and each boundary edge in one.
fn write_edges(mesh: &Mesh, frame: &Frame, out: &mut impl Write) -> io::Result<()> {
    let width = (0.06 * spacing(mesh, frame)).clamp(0.3, 1.6);
    out.write_all(format!("<path class=\"edge\" stroke-width=\"{width:.2}\" d=\"").as_bytes())?;
    let n = mesh.vertex_count();
    write_items(out, mesh.triangle_count(), |range, buffer| {
        for i in range {
            let [a, b, c] = mesh.triangle(i);
            for (from, to) in [(a, b), (b, c), (c, a)] {
                let interior = to != (from + 1) % n;
                if interior && from < to {
                    buffer.push(b'M');
                    push_point(buffer, frame.place(mesh.point(from)));
                    buffer.push(b'L');
                    push_point(buffer, frame.place(mesh.point(to)));
                }
            }
        }
    })?;
    out.write_all(b"\"/>\n")
}

/// The degree whose color stands for `degree`.
fn degree_class(degree: u32) -> u32 {
    degree.clamp(*degree_color::DISTINCT.start(), *degree_color::DISTINCT.end())
}

/// The degrees with a color that occur, in ascending order, with the number of vertices; none
/// where there are too many vertices for dots.
fn degree_classes(mesh: &Mesh) -> Vec<(u32, usize)> {
    if mesh.vertex_count() > MAX_DOTS {
        return Vec::new();
    }
    let classes = (0..mesh.vertex_count()).map(|v| degree_class(mesh.degree(v)));
    degree_color::DISTINCT
        .map(|class| (class, classes.clone().filter(|&c| c == class).count()))
        .filter(|&(_, count)| count > 0)
        .collect()
}

/// The vertices that have the color of `class`.
fn write_dots(mesh: &Mesh, frame: &Frame, class: u32, out: &mut impl Write) -> io::Result<()> {
    let n = mesh.vertex_count();
    let room = (0.2 * frame.size.min_element()).min(LARGEST_DOT * frame.size.max_element());
    let largest = room.clamp(0.6, 8.0);
    out.write_all(format!("<g fill=\"{}\">\n", hex(class)).as_bytes())?;
    write_items(out, n, |range, buffer| {
        for v in range.filter(|&v| degree_class(mesh.degree(v)) == class) {
            let [before, point, after] =
                [(v + n - 1) % n, v, (v + 1) % n].map(|v| frame.place(mesh.point(v)));
            let nearest = point.distance(before).min(point.distance(after));
            push_dot(buffer, point, (0.3 * nearest).clamp(0.6, largest));
        }
    })?;
    out.write_all(b"</g>\n")
}

/// Names and intervals along the sides, outside, where there is room.
fn labels(mesh: &Mesh, frame: &Frame) -> String {
    let corners = corners(mesh, frame);
    let next = corners.iter().cycle().skip(1);
    let mut text = String::new();
    for (side, (&start, &end)) in corners.iter().zip(next).enumerate() {
        let intervals = mesh.boundary().intervals(side);
        let label = format!("{} · {intervals}", side_name(mesh.domain(), side));
        // A letter is about half as wide as high.
        if start.distance(end) < 8.0 * label.chars().count() as f64 {
            continue;
        }
        let along = (end - start).normalize();
        // Left of the way round in the mesh is inside; in the picture, y is turned over.
        let outward = DVec2::new(-along.y, along.x);
        // Read from left to right, and upwards where the side is upright.
        let upright = along.x.abs() < 1e-6;
        let forward = if upright { along.y < 0.0 } else { along.x > 0.0 };
        // Adding zero turns -0 into 0.
        let DVec2 { x, y } = if forward { along } else { -along } + DVec2::ZERO;
        let at = start.midpoint(end) + 24.0 * outward;
        let _ = writeln!(
            text,
            r#"<text class="label" dy=".35em" transform="matrix({x:.4} {y:.4} {:.4} {x:.4} {:.2} {:.2})">{}</text>"#,
            0.0 - y,
            at.x,
            at.y,
            escaped(&label),
        );
    }
    text
}

/// What the colors mean, and how many vertices have each.
fn legend(mesh: &Mesh, frame: &Frame) -> String {
    let classes = degree_classes(mesh);
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

fn push_dot(buffer: &mut Vec<u8>, center: DVec2, radius: f64) {
    // A ring sets a dot off from the edges; it would drown a small one.
    let ring: &[u8] =
        if radius >= 3.0 { b"<circle class=\"ring\" cx=\"" } else { b"<circle cx=\"" };
    buffer.extend_from_slice(ring);
    push_pixels(buffer, center.x);
    buffer.extend_from_slice(b"\" cy=\"");
    push_pixels(buffer, center.y);
    buffer.extend_from_slice(b"\" r=\"");
    push_pixels(buffer, radius);
    buffer.extend_from_slice(b"\"/>\n");
}

fn push_point(buffer: &mut Vec<u8>, point: DVec2) {
    push_pixels(buffer, point.x);
    buffer.push(b' ');
    push_pixels(buffer, point.y);
}

/// A length in pixels, to a hundredth.
fn push_pixels(buffer: &mut Vec<u8>, pixels: f64) {
    let hundredths = (pixels * 100.0).round();
    let mut digits = zmij::Buffer::new();
    let number = digits.format_finite(hundredths / 100.0);
    buffer.extend_from_slice(number.strip_suffix(".0").unwrap_or(number).as_bytes());
}

fn hex(degree: u32) -> String {
    let [red, green, blue] = degree_color::srgb(degree);
    format!("#{red:02x}{green:02x}{blue:02x}")
}

/// Text as XML can hold it. Names have no control characters; what else XML has no place for
/// is left out.
fn escaped(text: &str) -> String {
    let mut escaped = String::new();
    for c in text.chars() {
        match c {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '\u{fffe}' | '\u{ffff}' => {}
            c => escaped.push(c),
        }
    }
    escaped
}
