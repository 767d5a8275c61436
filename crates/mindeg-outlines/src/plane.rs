//! Points in space that should lie in a plane of equal z.

use crate::error::ReadError;

/// A note if all z are one number other than 0.
///
/// # Errors
///
/// Two different z.
pub(super) fn check(mut z: impl Iterator<Item = f64>) -> Result<Option<String>, ReadError> {
    let Some(first) = z.next() else { return Ok(None) };
    if let Some(other) = z.find(|&other| other != first) {
        return Err(ReadError::place(
            "the whole file",
            format!(
                "the points do not lie in a plane of equal z: found z = {first:?} and z = \
                 {other:?}; turn the outline into the plane z = 0"
            ),
        ));
    }
    Ok((first != 0.0).then(|| format!("left out the height z = {first:?} of all points")))
}
