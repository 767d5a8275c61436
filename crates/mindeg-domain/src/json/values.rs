//! Values that JSON may leave out, and ranges as pairs.

use serde::de::{Deserialize, Deserializer};

/// A value, or its default for null.
pub(crate) fn or_default<'de, D: Deserializer<'de>, T: Deserialize<'de> + Default>(
    given: D,
) -> Result<T, D::Error> {
    Option::deserialize(given).map(Option::unwrap_or_default)
}

pub(crate) fn is_default<T: Default + PartialEq>(value: &T) -> bool {
    *value == T::default()
}

/// Ranges as pairs `[least, greatest]`.
pub(crate) mod range {
    use std::ops::RangeInclusive;

    use serde::de::{Deserialize, Deserializer};
    use serde::ser::{Serialize, Serializer};

    pub(crate) fn serialize<S: Serializer>(
        range: &Option<RangeInclusive<u32>>,
        to: S,
    ) -> Result<S::Ok, S::Error> {
        range.as_ref().map(|range| [range.start(), range.end()]).serialize(to)
    }

    pub(crate) fn deserialize<'de, D: Deserializer<'de>>(
        given: D,
    ) -> Result<Option<RangeInclusive<u32>>, D::Error> {
        let pair: Option<[u32; 2]> = Option::deserialize(given)?;
        Ok(pair.map(|[least, greatest]| least..=greatest))
    }
}
