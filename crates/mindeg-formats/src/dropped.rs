//! The values at vertices that files have and meshes lack, by one name in all formats.

pub(crate) const TEXTURE: &str = "texture coordinates";
pub(crate) const SECOND_TEXTURE: &str = "second texture coordinates";
/// A mesh has normals: those of its triangles.
pub(crate) const NORMALS: &str = "normals of the file";
pub(crate) const TANGENTS: &str = "tangents";
pub(crate) const COLORS: &str = "colors";
pub(crate) const SKINS: &str = "joints and weights of skins";

/// The kinds that a file has.
pub(crate) fn found<const N: usize>(kinds: [(&'static str, bool); N]) -> Vec<&'static str> {
    kinds.into_iter().filter(|(_, is_there)| *is_there).map(|(kind, _)| kind).collect()
}
