//! A document as JSON, with exact numbers where a node is.
//!
//! The translation of a node is kept as 32-bit floats. Their shortest decimals, such as 4650010
//! for 4650009.8, would put a reader that works in 64 bits elsewhere. So these numbers are written
//! with the digits of a 64-bit float.

use gltf_json::Root;
use std::io;

/// The document on one line.
pub(super) fn compact(root: &Root) -> io::Result<Vec<u8>> {
    with_exact_translations(serde_json::to_vec(root)?, root)
}

/// The document with a line for each value.
pub(super) fn pretty(root: &Root) -> io::Result<Vec<u8>> {
    with_exact_translations(serde_json::to_vec_pretty(root)?, root)
}

fn with_exact_translations(mut json: Vec<u8>, root: &Root) -> io::Result<Vec<u8>> {
    // Inside a string its quotes would be escaped.
    const KEY: &[u8] = b"\"translation\":";
    let mut at = 0;
    for translation in root.nodes.iter().filter_map(|node| node.translation) {
        let Some(key) = memchr::memmem::find(&json[at..], KEY) else { break };
        at += key + KEY.len();
        for value in translation {
            let is_digit = |byte: &u8| byte.is_ascii_digit() || b"-+.eE".contains(byte);
            let rest = json[at..].iter();
            let start = at + rest.take_while(|byte| !is_digit(byte)).count();
            let end = start + json[start..].iter().take_while(|byte| is_digit(byte)).count();
            let exact = serde_json::to_vec(&f64::from(value))?;
            at = start + exact.len();
            json.splice(start..end, exact);
        }
    }
    Ok(json)
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
            name: Some("\"translation\":[1,2,3]".to_owned()),
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
