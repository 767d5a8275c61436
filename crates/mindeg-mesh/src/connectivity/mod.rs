//! How the triangles of any mesh hang together, sound or not.
//!
//! Everything is read off the star of a vertex, the triangles and edges there, one vertex after
//! the other. A triangle that names a vertex twice joins nothing and is passed over.

pub(crate) mod boundary;
pub(crate) mod disjoint_sets;
pub(crate) mod stars;
