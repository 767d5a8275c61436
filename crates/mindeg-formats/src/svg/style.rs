//! Sizes, colors and text of a picture.

use crate::degree_color;

/// The most vertices a picture shows.
pub const MAX_VERTICES: u32 = 100_000;

/// The most vertices that are drawn as dots.
pub const MAX_DOTS: u32 = 5_000;

/// The width of the picture and the room round the mesh, in pixels.
pub(super) const WIDTH: f64 = 960.0;
pub(super) const SIDE_MARGIN: f64 = 56.0;
pub(super) const TOP: f64 = 124.0;
pub(super) const BOTTOM: f64 = 104.0;
/// The most a mesh takes from top to bottom.
pub(super) const MAX_HEIGHT: f64 = 640.0;
/// The radius of the largest dots as a share of the mesh's longer extent.
pub(super) const LARGEST_DOT: f64 = 0.0125;
/// A mesh more slender than that is widened for the picture, which says so.
pub(super) const MAX_SLENDERNESS: f64 = 10.0;

/// The colors of what [`Inset::write`](super::Inset::write) draws and of the classes `card`, `title`, `muted`, `key` and
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
.solid{fill:#eef2fb;stroke:#7f8ca3}.inside{fill:#cfd8ea}\
.edge{fill:none;stroke:#7f8ca3;stroke-linecap:round}\
.outline{fill:none;stroke:#2b3440;stroke-width:2;stroke-linejoin:round}\
.ring{stroke:#fff}\
@media(prefers-color-scheme:dark){\
text{fill:#f0f6fc}.card{fill:#0d1117;stroke:#3d444d}.muted,.label{fill:#9198a1}\
.solid{fill:#171e2b;stroke:#66738a}.inside{fill:#2b364a}.face{fill:#171e2b}.shade{fill:#1f2838}.edge{stroke:#66738a}.outline{stroke:#c3ccd8}.ring{stroke:#f0f6fc}}";

pub(super) fn hex(degree: u32) -> String {
    let [red, green, blue] = degree_color::srgb(degree);
    format!("#{red:02x}{green:02x}{blue:02x}")
}
