//! The one error of this crate: a sentence.

use alloc::string::String;
use core::fmt;

/// The reason why counts do not describe a boundary, triangles do not triangulate it, or a certificate does not
/// hold. Sides count from 1 in the sentence; triangles and vertices count from 0.
///
/// # Example
///
/// ```
/// use mindeg_core::Boundary;
///
/// let defect = Boundary::new(&[3, 0, 2]).unwrap_err();
/// assert_eq!(defect.to_string(), "side 2 has 0 intervals; every side needs at least 1");
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Defect(String);

impl Defect {
    pub(crate) fn new(sentence: impl Into<String>) -> Self {
        Self(sentence.into())
    }
}

impl fmt::Display for Defect {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl core::error::Error for Defect {}
