//! Domains as JSON text, which engineers write by hand and keep beside their meshes.
//!
//! Unknown keys are refused, so that a misspelt key is not ignored. Every error gives its position
//! in the text, even an error that shows only after all of it is read.
//!
//! Limits: JSON has no comments and no infinities. The whole text is held in memory.

mod choices;
mod description;
mod error;
mod fault;
mod forms;
mod guess;
mod line;
mod model;
mod reader;
mod schema;
mod side;
mod syntax;
mod text;
mod values;

pub use self::description::DomainDescription;
pub use self::error::DomainJsonError;
pub use self::model::ModelDescription;
pub(crate) use self::values::{is_default, or_default, range};

use crate::build::DomainBuilder;
use crate::domain::Domain;
use crate::error::Place;
use crate::interior::Interior;
use crate::model::Model;

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
    /// `docs/domains.md` explains every key, and `mindeg schema` prints the JSON Schema.
    ///
    /// The value `null` counts as left out. Several constraints on one vertex combine: external
    /// degrees add up, and the least degree limit holds.
    ///
    /// # Errors
    ///
    /// Text that is not JSON, unknown keys or wrong values, and everything that
    /// [`DomainBuilder::build`](crate::DomainBuilder::build) refuses; each with its path, line and column.
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

    /// [`Domain::from_json`] with a maximum number of boundary vertices; a domain with more is refused
    /// before its points take time and memory.
    ///
    /// # Errors
    ///
    /// The errors of [`Domain::from_json`], and too many vertices.
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
        Self::of_json(text, |builder| builder.max_vertices(max_vertices))
    }

    /// [`Domain::from_json`] of a domain in which lines that cross each other get a corner there.
    ///
    /// # Errors
    ///
    /// The errors of [`Domain::from_json`] but for such lines.
    pub fn from_json_noded(text: &str) -> Result<Self, DomainJsonError> {
        Self::of_json(text, DomainBuilder::noded)
    }

    fn of_json(
        text: &str,
        with: impl FnOnce(DomainBuilder) -> DomainBuilder,
    ) -> Result<Self, DomainJsonError> {
        let description: DomainDescription =
            reader::read(text).map_err(|error| guess::explained(text, error))?;
        description.build(with).map_err(|error| text::located(text, error))
    }

    /// The domain as JSON text. [`Domain::from_json`] reads back the same points, bit for bit.
    ///
    /// Rings run as in the mesh. If a ring was given the wrong way round, its sides have points
    /// instead of a spacing law. Every number is the shortest that reads back as the same f64.
    ///
    /// # Example
    ///
    /// ```
    /// use mindeg_domain::{Domain, Side};
    ///
    /// let corners = [[0.0, 0.0], [0.1 + 0.2, 0.0], [0.0, 1.0 / 3.0]];
    /// let domain = Domain::polygon(corners, vec![Side::count(2).named("a"), Side::size(0.1), Side::count(1)])?;
    /// let again = Domain::from_json(&domain.to_json()).unwrap();
    /// assert!(again.placement().points().eq(domain.placement().points()));
    /// assert_eq!(again.sides(), domain.sides());
    /// # Ok::<(), mindeg_domain::DomainError>(())
    /// ```
    pub fn to_json(&self) -> String {
        let mut json = serde_json::json!(self.description());
        drop_nulls(&mut json);
        json.to_string()
    }
}

/// Leaves out the keys without a value.
fn drop_nulls(json: &mut serde_json::Value) {
    match json {
        serde_json::Value::Array(items) => items.iter_mut().for_each(drop_nulls),
        serde_json::Value::Object(keys) => {
            keys.retain(|_, value| !value.is_null());
            keys.values_mut().for_each(drop_nulls);
        }
        _ => {}
    }
}

impl Model {
    /// Whether a JSON text is an object with the key `faces`, which makes it a model.
    pub fn is_model_json(text: &str) -> bool {
        text::has(text, &Place::key("faces"))
    }

    /// Reads a model from JSON text.
    ///
    /// ```json
    /// {
    ///   "name": "wedge",
    ///   "corners": [[0, 0, 0], [4, 0, 0], [0, 3, 0], [0, 0, 2]],
    ///   "size": 0.5,
    ///   "materials": [{"name": "steel", "color": [0.6, 0.6, 0.65]}],
    ///   "edges": [
    ///     {"corners": [0, 1], "intervals": 8, "spacing": {"geometric": {"ratio": 1.2}}, "name": "toe"}
    ///   ],
    ///   "faces": [
    ///     [0, 2, 1], [0, 1, 3], [1, 2, 3],
    ///     {"corners": [0, 3, 2], "name": "back", "group": "walls", "material": "steel"}
    ///   ]
    /// }
    /// ```
    ///
    /// `docs/domains.md` explains every key, and `mindeg schema --model` prints the JSON Schema. The
    /// value `null` counts as left out.
    ///
    /// # Errors
    ///
    /// Text that is not JSON, unknown keys or wrong values, and everything that [`Model::new`]
    /// refuses; each with its path, line and column.
    ///
    /// # Example
    ///
    /// ```
    /// use mindeg_domain::Model;
    ///
    /// let model = Model::from_json(
    ///     r#"{"corners": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]],
    ///         "faces": [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]], "size": 0.25}"#,
    /// )?;
    /// assert!(model.is_closed());
    /// assert_eq!(model.face_size(0), 4 + 4 + 6);
    /// # Ok::<(), mindeg_domain::DomainJsonError>(())
    /// ```
    pub fn from_json(text: &str) -> Result<Self, DomainJsonError> {
        let description: ModelDescription = reader::read(text)?;
        description.model().map_err(|error| text::located(text, error))
    }
}

impl Interior {
    /// The settings for interior points, from the JSON text of a domain's key `"interior"` alone.
    ///
    /// # Errors
    ///
    /// Text that is not JSON, and unknown keys or wrong values.
    pub fn from_json(text: &str) -> Result<Self, DomainJsonError> {
        reader::read(text)
    }
}

#[cfg(test)]
mod messages;
#[cfg(test)]
mod tests;
