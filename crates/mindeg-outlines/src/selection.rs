//! The part of a file that is read.

/// The part of a file that is taken, and how it is named.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Selection {
    /// The layer that is taken: an object of TopoJSON, or a layer of a DXF. Without it the only object, or all layers.
    pub layer: Option<String>,
    /// The property that names polygons: of GeoJSON and TopoJSON, instead of `name` and `id`; `layer` of a DXF makes regions of its
    /// layers.
    pub name_by: Option<String>,
}
