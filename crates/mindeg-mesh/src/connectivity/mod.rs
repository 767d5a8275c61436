//! How the faces of any mesh hang together, sound or not.
//!
//! Everything is read off the star of a vertex, the faces and edges there, one vertex after the
//! other. A face that encloses nothing joins nothing.

pub(crate) mod boundary;
pub(crate) mod disjoint_sets;
pub(crate) mod faces;
pub(crate) mod stars;
