//! A document as JSON, with exact numbers where a node is.
//!
//! The translation of a node is kept as 32-bit floats. Their shortest decimals, such as 4650010
//! for 4650009.8, would put a reader that works in 64 bits elsewhere. So these numbers are written
//! with the digits of a 64-bit float.

use gltf_json::Root;
use serde::Serialize;
use serde_json::Serializer;
use serde_json::ser::{CompactFormatter, Formatter, PrettyFormatter};
use std::io::{self, Write};

/// The document on one line.
pub(super) fn compact(root: &Root) -> io::Result<Vec<u8>> {
    formatted(root, CompactFormatter)
}

/// The document with a line for each value.
pub(super) fn pretty(root: &Root) -> io::Result<Vec<u8>> {
    formatted(root, PrettyFormatter::new())
}

fn formatted(root: &Root, layout: impl Formatter) -> io::Result<Vec<u8>> {
    let mut json = Vec::new();
    let formatter = ExactTranslations { layout, in_translation: false };
    root.serialize(&mut Serializer::with_formatter(&mut json, formatter))?;
    Ok(json)
}

/// Lays a document out as another formatter does, but for the numbers of translations.
struct ExactTranslations<F> {
    layout: F,
    /// Whether the last string was "translation". Each key is a string, so the numbers that
    /// follow are of that key.
    in_translation: bool,
}

impl<F: Formatter> Formatter for ExactTranslations<F> {
    fn write_f32<W: ?Sized + Write>(&mut self, out: &mut W, value: f32) -> io::Result<()> {
        if self.in_translation {
            return self.layout.write_f64(out, f64::from(value));
        }
        self.layout.write_f32(out, value)
    }

    fn write_string_fragment<W: ?Sized + Write>(
        &mut self,
        out: &mut W,
        fragment: &str,
    ) -> io::Result<()> {
        self.in_translation = fragment == "translation";
        self.layout.write_string_fragment(out, fragment)
    }

    fn begin_array<W: ?Sized + Write>(&mut self, out: &mut W) -> io::Result<()> {
        self.layout.begin_array(out)
    }

    fn end_array<W: ?Sized + Write>(&mut self, out: &mut W) -> io::Result<()> {
        self.layout.end_array(out)
    }

    fn begin_array_value<W: ?Sized + Write>(&mut self, out: &mut W, first: bool) -> io::Result<()> {
        self.layout.begin_array_value(out, first)
    }

    fn end_array_value<W: ?Sized + Write>(&mut self, out: &mut W) -> io::Result<()> {
        self.layout.end_array_value(out)
    }

    fn begin_object<W: ?Sized + Write>(&mut self, out: &mut W) -> io::Result<()> {
        self.layout.begin_object(out)
    }

    fn end_object<W: ?Sized + Write>(&mut self, out: &mut W) -> io::Result<()> {
        self.layout.end_object(out)
    }

    fn begin_object_key<W: ?Sized + Write>(&mut self, out: &mut W, first: bool) -> io::Result<()> {
        self.layout.begin_object_key(out, first)
    }

    fn begin_object_value<W: ?Sized + Write>(&mut self, out: &mut W) -> io::Result<()> {
        self.layout.begin_object_value(out)
    }

    fn end_object_value<W: ?Sized + Write>(&mut self, out: &mut W) -> io::Result<()> {
        self.layout.end_object_value(out)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use gltf_json::Node;

    #[test]
    fn translations_have_the_digits_of_64_bits() {
        let far = [4_650_008.1, -3_300_000.7, 1e9];
        let mut root = Root::default();
        root.push(Node {
            name: Some("translation".to_owned()),
            scale: Some([0.1, 1.0, 1.0]),
            translation: Some(far),
            ..Node::default()
        });
        for json in [compact(&root).unwrap(), pretty(&root).unwrap()] {
            let document: serde_json::Value = serde_json::from_slice(&json).unwrap();
            let node = &document["nodes"][0];
            assert_eq!(node["translation"], serde_json::json!(far.map(f64::from)));
            assert_eq!(node["scale"][0], 0.1);
        }
    }
}
