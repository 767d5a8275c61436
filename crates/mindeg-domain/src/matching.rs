//! The description of a side that is another one, moved.

/// The side that another one is moved to: it has the points of that one, moved.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "json", derive(serde::Serialize, serde::Deserialize, schemars::JsonSchema))]
#[cfg_attr(feature = "json", serde(deny_unknown_fields))]
pub struct SideMatch {
    /// The name of the other side of the same ring, or "side 4" by its index; sides of one name in a row are one
    pub of: String,
    /// How the other side is moved here
    #[cfg_attr(
        feature = "json",
        serde(
            default,
            deserialize_with = "crate::json::or_default",
            skip_serializing_if = "crate::json::is_default"
        )
    )]
    pub by: Move,
}

/// How one side is moved to another, so that the end of each is where the other begins
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "json", derive(serde::Serialize, serde::Deserialize, schemars::JsonSchema))]
#[cfg_attr(feature = "json", serde(rename_all = "snake_case"))]
pub enum Move {
    /// All points by the same distance
    #[default]
    Translation,
    /// About the only point that brings the corners together
    Rotation,
}
