//! Lists that grow with what a file holds, and never with what it says it holds.

use std::collections::TryReserveError;

/// Adds a value to a list; too little memory is an error.
pub(crate) fn push<T>(list: &mut Vec<T>, value: T) -> Result<(), TryReserveError> {
    if list.len() == list.capacity() {
        list.try_reserve(1)?;
    }
    list.push(value);
    Ok(())
}
