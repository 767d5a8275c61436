//! The connectivity of the faces of any mesh, valid or not.
//!
//! All results come from the star of a vertex, which is its faces and edges, one vertex after the
//! other. A face that encloses nothing joins nothing.

pub(crate) mod boundary;
pub(crate) mod disjoint_sets;
pub(crate) mod faces;
pub(crate) mod stars;
