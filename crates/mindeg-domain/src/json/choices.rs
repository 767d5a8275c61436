//! The conditions of the JSON Schema on keys that depend on each other.

use serde_json::{Value, json};

/// One of the three outlines, and no other.
pub(super) fn one_outline() -> Value {
    let outlines = ["rectangle", "polygon", "ring"].map(|key| {
        let is_null = json!({"properties": {key: {"type": "null"}}});
        json!({"required": [key], "not": is_null})
    });
    json!(outlines)
}

/// A ring of one or two corners, whose sides cannot all be straight.
pub(super) fn few_corners() -> Value {
    let corners = json!({"type": "array", "maxItems": 2});
    json!({"type": "object", "properties": {"corners": corners}, "required": ["corners"]})
}

/// The same of the outline, whose sides are beside its corners.
pub(super) fn polygon_of_few_corners() -> Value {
    json!({"properties": {"polygon": few_corners()}, "required": ["polygon"]})
}

/// A side that need not be straight.
pub(super) fn has_curve() -> Value {
    let curves = ["points", "polyline", "arc", "bezier"].map(|key| json!({"required": [key]}));
    json!({"properties": {"sides": {"contains": {"anyOf": curves}}}, "required": ["sides"]})
}
