//! docs/domains.md and docs/models.md explain the keys of the JSON Schema. Whether documents keep to the
//! schema, tests/formats/schemas.py asks another library.

use std::path::Path;

use mindeg_domain::{DomainDescription, ModelDescription};
use serde_json::{Value, json};

/// The table rows of all keys, object by object.
fn rows(schema: &Value) -> String {
    let mut rows = String::from("| of | key | value |\n|---|---|---|\n");
    let definitions = schema["$defs"].as_object().unwrap();
    let objects = definitions.iter().map(|(name, object)| (name.as_str(), object));
    for (name, object) in [("the whole", schema)].into_iter().chain(objects) {
        let alternatives = object["oneOf"].as_array().map_or(&[][..], Vec::as_slice);
        for object in [object].into_iter().chain(alternatives) {
            let Some(properties) = object["properties"].as_object() else { continue };
            let required = object["required"].as_array().map_or(&[][..], Vec::as_slice);
            for (key, value) in properties {
                let text = [&value["description"], &object["description"]];
                let text = text.iter().find_map(|text| text.as_str()).unwrap();
                let text = text.replace("\n", " ");
                let must = if required.contains(&json!(key)) && alternatives.is_empty() {
                    "needed: "
                } else {
                    ""
                };
                rows += &format!("| {} | `{key}` | {must}{text} |\n", words(name));
            }
        }
    }
    rows
}

/// The name of a type as words.
fn words(name: &str) -> String {
    let name = name.trim_end_matches("Keys");
    let mut words = String::new();
    for letter in name.chars() {
        if letter.is_uppercase() && !words.is_empty() {
            words.push(' ');
        }
        words.extend(letter.to_lowercase());
    }
    words
}

/// Each page ends with the table of all keys, made from the schema. With `MINDEG_BLESS=1` this test writes it.
#[test]
fn the_pages_have_every_key_and_no_other() {
    const HEAD: &str = "\n## All keys\n\n";
    for (page, text) in
        [("domains", DomainDescription::schema()), ("models", ModelDescription::schema())]
    {
        let path = Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("../../docs")
            .join(page)
            .with_extension("md");
        let page = std::fs::read_to_string(&path).unwrap();
        let (before, _) = page.split_once(HEAD).unwrap_or((&page, ""));
        let expected = format!("{before}{HEAD}{}", rows(&serde_json::from_str(&text).unwrap()));
        if std::env::var_os("MINDEG_BLESS").is_some() {
            std::fs::write(&path, &expected).unwrap();
            continue;
        }
        assert_eq!(page, expected, "run this test with MINDEG_BLESS=1");
    }
}

/// There is one outline, few corners have a curve between them, and degrees inside are around 6: by the schema and by the reader.
#[test]
fn the_schema_has_the_choices_of_the_reader() {
    let schema: Value = serde_json::from_str(&DomainDescription::schema()).unwrap();
    let outlines = schema["oneOf"].as_array().unwrap().iter();
    let outlines: Vec<&Value> = outlines.map(|outline| &outline["required"][0]).collect();
    assert_eq!(outlines, ["rectangle", "polygon", "ring"]);
    let hole = &schema["$defs"]["Hole"];
    assert_eq!(schema["if"]["properties"]["polygon"], hole["if"]);
    assert_eq!(
        (&schema["then"], &hole["if"]["properties"]["corners"]["maxItems"]),
        (&hole["then"], &json!(2))
    );
    let degrees = &schema["$defs"]["Interior"]["properties"]["interior_degree"]["prefixItems"];
    assert_eq!((&degrees[0]["maximum"], &degrees[1]["minimum"]), (&json!(6), &json!(6)));
    let square = json!([[0, 0], [9, 0], [9, 9], [0, 9]]);
    let rectangle = json!({"width": 4, "height": 3});
    for wrong in [
        json!({}),
        json!({"ring": square, "rectangle": rectangle}),
        json!({"ring": square, "polygon": {"corners": square}}),
        json!({"polygon": {"corners": [[0, 0], [1, 0]]}, "size": 1}),
        json!({"ring": square, "holes": [{"corners": [[1, 1], [2, 2]], "size": 1}]}),
        json!({"rectangle": rectangle, "size": 1, "interior": {"interior_degree": [7, 5]}}),
    ] {
        assert!(mindeg_domain::Domain::from_json(&wrong.to_string()).is_err(), "{wrong}");
    }
}

/// Rings of two points, rectangles of no width and sizes that are none are refused by the schema and by the reader.
#[test]
fn the_schema_has_the_bounds_of_the_reader() {
    let schema: Value = serde_json::from_str(&DomainDescription::schema()).unwrap();
    let square = json!([[0, 0], [9, 0], [9, 9], [0, 9]]);
    for (keys, bound, value, wrong) in [
        ("/properties/ring", "minItems", 3, json!({"ring": [[0, 0], [1, 0]]})),
        (
            "/properties/size",
            "exclusiveMinimum",
            0,
            json!({"polygon": {"corners": square}, "size": -1}),
        ),
        (
            "/$defs/Polygon/properties/corners",
            "minItems",
            1,
            json!({"polygon": {"corners": []}, "size": 1}),
        ),
        (
            "/$defs/Hole/properties/ring",
            "minItems",
            3,
            json!({"ring": square, "holes": [{"ring": [[1, 1], [2, 2]]}]}),
        ),
        (
            "/$defs/Hole/properties/size",
            "exclusiveMinimum",
            0,
            json!({"ring": square, "holes": [{"corners": [[1, 1], [2, 1], [2, 2]], "size": 0}]}),
        ),
        (
            "/$defs/Rectangle/properties/width",
            "exclusiveMinimum",
            0,
            json!({"rectangle": {"width": 0, "height": 1}, "size": 1}),
        ),
        (
            "/$defs/Rectangle/properties/height",
            "exclusiveMinimum",
            0,
            json!({"rectangle": {"width": 1, "height": -1}, "size": 1}),
        ),
    ] {
        assert_eq!(schema.pointer(keys).unwrap()[bound], value, "{keys}");
        assert!(mindeg_domain::Domain::from_json(&wrong.to_string()).is_err(), "{wrong}");
    }
}
