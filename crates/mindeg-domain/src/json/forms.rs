//! Values that have several forms in JSON, or another form than in Rust.

use std::fmt;

use serde::de::value::SeqAccessDeserializer;
use serde::de::{Deserialize, Deserializer, Error, SeqAccess, Unexpected, Visitor};

use crate::constraints::ExternalDegree;
use crate::interior::SizeAt;

impl From<[f64; 3]> for SizeAt {
    fn from([x, y, size]: [f64; 3]) -> Self {
        Self { at: [x, y].into(), size }
    }
}

impl From<SizeAt> for [f64; 3] {
    fn from(SizeAt { at, size }: SizeAt) -> Self {
        [at.x, at.y, size]
    }
}

/// A whole number, or a list instead.
struct NumberOr<T, L> {
    expected: &'static str,
    number: fn(u32) -> T,
    list: fn(L) -> T,
}

impl<'de, T, L: Deserialize<'de>> Visitor<'de> for NumberOr<T, L> {
    type Value = T;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.expected)
    }

    fn visit_u64<E: Error>(self, number: u64) -> Result<T, E> {
        match u32::try_from(number) {
            Ok(number) => Ok((self.number)(number)),
            Err(_) => Err(E::invalid_value(Unexpected::Unsigned(number), &self)),
        }
    }

    fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<T, A::Error> {
        L::deserialize(SeqAccessDeserializer::new(list)).map(self.list)
    }
}

impl<'de> Deserialize<'de> for ExternalDegree {
    fn deserialize<D: Deserializer<'de>>(given: D) -> Result<Self, D::Error> {
        given.deserialize_any(NumberOr {
            expected: "a whole number, or for a side a list of one whole number for each vertex from \
                       its first corner to its last",
            number: Self::Inside,
            list: Self::Each,
        })
    }
}
