//! Domains as JSON text: what engineers write by hand and keep beside their meshes.
//!
//! Keys that are not the format's are refused, so that a misspelt one is not passed over. Every
//! error says where in the text it is, also those that show only when all of it is read.
//!
//! Limits: JSON has no comments and no infinities. The whole text is held in memory.

mod constraint;
mod description;
mod error;
mod guess;
mod interior;
mod model;
mod place;
mod point;
mod ring;
mod side;
mod spacing;
mod syntax;
mod value;
mod write;

pub use self::error::DomainJsonError;

use self::value::Value;
use crate::domain::Domain;

impl Domain {
    /// Reads a domain from JSON text.
    ///
    /// ```json
    /// {
    ///   "name": "plate",
    ///   "rectangle": {"width": 4, "height": 3, "origin": [0, 0], "rotation": 0},
    ///   "size": 0.5,
    ///   "sides": [
    ///     {"intervals": 12, "name": "bottom"},
    ///     {"size": 0.25, "spacing": {"geometric": {"ratio": 1.2}}},
    ///     {"spacing": {"parameters": [0.25, 0.5, 0.75]}},
    ///     {}
    ///   ]
    /// }
    /// ```
    ///
    /// | key | value |
    /// |---|---|
    /// | `name` | optional: the domain's name |
    /// | `rectangle` | `width`, `height`, and optionally `origin`, the corner where the bottom starts, and `rotation` in degrees about it. Sides run bottom, right, top, left |
    /// | `polygon` | instead: `corners`, a list of `[x, y]` pairs around a simple polygon; one or two are enough where sides are curved |
    /// | `ring` | instead: a list of `[x, y]` pairs, all points of the boundary, which come back bit for bit. They are one side; `sides` may have one entry with its name, kind and degrees |
    /// | `holes` | optional: a list of `{"corners": [[x, y], …], "sides": […], "size": h}` or `{"ring": [[x, y], …]}`, as for the outline; a hole's size goes before that of the domain |
    /// | `sides` | one entry for each side, from the first corner on; may be left out where `size` says it all |
    /// | `size` | optional: the target interval length of every side that gives neither `intervals` nor `size` nor `parameters` |
    /// | `vertices` | optional: constraints on single vertices, each `{"vertex": v, "outside_degree": d, "max_degree": D}` with one of the last two or both. Vertices have the indices of the mesh: from 0 at the first corner, counter-clockwise, also where the corners are given clockwise |
    /// | `interior` | optional: what is wanted of a mesh with interior points, see below |
    ///
    /// and in each side, all optional:
    ///
    /// | key | value |
    /// |---|---|
    /// | `intervals` | a whole number, at least 1 |
    /// | `size` | instead: a target length, above 0, that the side's length is divided by |
    /// | `spacing` | `"uniform"`, `{"geometric": {"ratio": r}}`, `{"bump": {"ratio": c}}`, `{"beta": {"beta": b}}`, `{"first_length": h}`, `{"last_length": h}` or `{"parameters": [t1, …]}`; see [`Spacing`](crate::Spacing) |
    /// | `points` | instead: the side's own points between its corners, `[[x, y], …]`, which come back bit for bit. The side is straight if all of them are within 1e-9 of its length from the line between its corners |
    /// | `arc` | the side runs along a circle: `{"through": [x, y]}`, or `{"center": [x, y]}` counter-clockwise about the center, with `"clockwise": true` the other way |
    /// | `bezier` | it runs along a cubic Bézier curve with these two control points: `[[x, y], [x, y]]` |
    /// | `polyline` | it runs through these points, `[[x, y], …]`, and is divided by its length |
    /// | `name` | the side's name; no two sides may have the same |
    /// | `kind` | `"open"`, `"land"` or `"island"`: what kind of boundary ocean models take it for |
    /// | `outside_degree` | the external degree of its vertices, which counts their edges on the other side of the boundary and none of the boundary itself: one number for all vertices that are not corners, or a list of one for each from the side's first corner to its last |
    /// | `max_degree` | the degree limit of each of its vertices, corners included: the most edges that they may have, external degree included |
    ///
    /// and in `interior`, all optional:
    ///
    /// | key | value |
    /// |---|---|
    /// | `growth` | how fast the size grows from the boundary: change of size per distance |
    /// | `size_inside` | the size far from the boundary |
    /// | `sizes` | a list of `[x, y, h]`: the size is at most h at this place, and grows from there |
    /// | `interior_degree` | the least and the greatest degree of interior vertices, such as `[5, 7]` |
    /// | `boundary_degree` | the greatest degree of boundary vertices |
    /// | `target_angle` | the minimum angle in degrees |
    /// | `prefer` | `"degree"` or `"angle"`: which wins where one costs the other |
    /// | `fixed` | `points`, a list of `[x, y]`, and `segments`, a list of lines: each a list of ends, which are `[x, y]` or the index of a fixed point |
    ///
    /// The value `null` counts as left out. Constraints on one vertex in several places count
    /// together: external degrees add up, and the least degree limit holds.
    ///
    /// # Errors
    ///
    /// Text that is no JSON, keys or values that are not the format's, and everything that
    /// [`Domain::constrained`] refuses; each with its path, line and column.
    ///
    /// # Example
    ///
    /// ```
    /// use mindeg_domain::Domain;
    ///
    /// let domain = Domain::from_json(
    ///     r#"{
    ///         "rectangle": {"width": 4, "height": 3},
    ///         "sides": [
    ///             {"intervals": 3, "spacing": {"geometric": {"ratio": 1.2}}, "name": "bottom"},
    ///             {"size": 0.5}, {"intervals": 3}, {"intervals": 2}
    ///         ]
    ///     }"#,
    /// )?;
    /// assert_eq!(domain.rings().sides().collect::<Vec<_>>(), [3, 6, 3, 2]);
    ///
    /// let error = Domain::from_json(r#"{"rectangle": {"width": 4, "hight": 3}}"#).unwrap_err();
    /// assert_eq!(error.path, "rectangle.hight");
    /// assert_eq!((error.line, error.column), (1, 37));
    /// # Ok::<(), mindeg_domain::DomainJsonError>(())
    /// ```
    pub fn from_json(text: &str) -> Result<Self, DomainJsonError> {
        Self::from_json_up_to(text, u32::MAX)
    }

    /// [`Domain::from_json`] of a domain with at most so many boundary vertices; others are refused before
    /// their points take time and memory.
    ///
    /// # Errors
    ///
    /// As [`Domain::from_json`], and more vertices.
    ///
    /// # Example
    ///
    /// ```
    /// use mindeg_domain::Domain;
    ///
    /// let text = r#"{"rectangle": {"width": 4, "height": 3}, "size": 0.001}"#;
    /// let error = Domain::from_json_up_to(text, 1000).unwrap_err();
    /// assert_eq!(
    ///     error.to_string(),
    ///     "line 1, column 1: the boundary has 14000 points; at most 1000 are wanted here; use fewer intervals"
    /// );
    /// # Ok::<(), mindeg_domain::DomainJsonError>(())
    /// ```
    pub fn from_json_up_to(text: &str, max_vertices: u32) -> Result<Self, DomainJsonError> {
        // A mark that some Windows programs put before UTF-8 text.
        let text = Value::document(text.strip_prefix('\u{feff}').unwrap_or(text))?;
        let (builder, name, interior) = description::description(&text)?;
        let domain = builder.max_vertices(max_vertices).build().and_then(|domain| match name {
            Some(name) => domain.named(name),
            None => Ok(domain),
        });
        let domain = domain.map(|domain| match interior {
            Some(interior) => domain.with_interior(interior),
            None => domain,
        });
        domain.map_err(|error| place::located(&text, &error))
    }
}

#[cfg(test)]
mod messages;
#[cfg(test)]
mod tests;
