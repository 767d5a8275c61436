//! The viewer of meshes: the style, and the scripts that draw, read off and chart.
//!
//! The reports put these into their pages; a program that makes pages of its own takes them from
//! here, so that all look and work alike.

use super::svg::{self, CURVE_STYLE, DegreeColor};

/// The style of every page.
pub(super) const STYLE: &str = include_str!("page.css");

/// The scripts that draw a scene and read it off, without a document; later ones use earlier ones.
macro_rules! viewer {
    ($($more:literal),*) => {
        concat!(
            include_str!("viewer/numbers.js"),
            include_str!("viewer/scene.js"),
            include_str!("viewer/paint.js"),
            include_str!("viewer/pick.js"),
            include_str!("viewer/pointers.js"),
            include_str!("viewer/charts.js"),
            $(include_str!($more)),*
        )
    };
}

/// The script of a report: the viewer, then the report's own parts.
pub(super) const SCRIPT: &str = viewer!("data.js", "picture.js", "copy.js", "page.js");

/// The same for a mesh in space.
pub(super) const SPACE_SCRIPT: &str = viewer!(
    "viewer/twgl/twgl.js",
    "viewer/space.js",
    "viewer/raster.js",
    "viewer/turning.js",
    "data.js",
    "picture.js",
    "space_picture.js",
    "copy.js",
    "page.js"
);

/// The script that zooms pictures which are there without a script.
pub(super) const ZOOM_SCRIPT: &str = concat!(
    include_str!("viewer/pointers.js"),
    include_str!("copy.js"),
    include_str!("trade_off/page.js")
);

/// The style sheet of the reports, light and dark, for a page that uses their viewer.
///
/// # Example
///
/// ```
/// assert!(mindeg_compare::viewer_style().contains("prefers-color-scheme: dark"));
/// ```
pub fn viewer_style() -> String {
    svg::page_style(&[STYLE, CURVE_STYLE])
}

/// The script that draws and turns meshes in space, after [`viewer_script`].
///
/// ```
/// assert!(mindeg_compare::space_script().contains("class SpaceStage"));
/// ```
pub fn space_script() -> &'static str {
    concat!(
        include_str!("viewer/twgl/twgl.js"),
        include_str!("viewer/space.js"),
        include_str!("viewer/raster.js"),
        include_str!("viewer/turning.js")
    )
}

/// The script of the reports' viewer, for a page or a worker of its own: a classic script.
///
/// It begins with `DEGREE_COLORS`, the colors of degrees from the lowest. It draws a scene, which
/// the beginning of `scene.js` describes.
///
/// # Example
///
/// ```
/// let script = mindeg_compare::viewer_script();
/// assert!(script.starts_with("const DEGREE_COLORS = [{\"from\":2,"));
/// assert!(script.contains("class Painter"));
/// ```
pub fn viewer_script() -> String {
    let colors = svg::degree_scale();
    let listed: Vec<String> = colors
        .iter()
        .map(|DegreeColor { from, color, name }| {
            format!("{{\"from\":{from},\"color\":\"{color}\",\"name\":\"{name}\"}}")
        })
        .collect();
    format!("const DEGREE_COLORS = [{}];\n{}", listed.join(","), viewer!())
}
