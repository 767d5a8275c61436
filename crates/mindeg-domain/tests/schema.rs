//! The JSON Schema and the reader agree: on every example, on errors, and on the keys that
//! docs/domains.md and docs/models.md explain.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::path::{Path, PathBuf};

use mindeg_domain::{Domain, DomainDescription, Model, ModelDescription};
use serde_json::{Value, json};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn schema(text: &str) -> Value {
    serde_json::from_str(text).unwrap()
}

/// The documents in a folder of assets.
fn documents(folder: &str) -> Vec<(PathBuf, Value)> {
    let files = std::fs::read_dir(root().join("assets").join(folder)).unwrap();
    let files = files.map(|file| file.unwrap().path());
    let files = files.filter(|path| path.extension().is_some_and(|ending| ending == "json"));
    let text = |path: &PathBuf| std::fs::read_to_string(path).unwrap();
    files.map(|path| (path.clone(), serde_json::from_str(&text(&path)).unwrap())).collect()
}

#[test]
fn every_example_keeps_to_the_schema() {
    for (folder, text, least) in
        [("domains", DomainDescription::schema(), 10), ("models", ModelDescription::schema(), 3)]
    {
        let validator = jsonschema::validator_for(&schema(&text)).unwrap();
        let documents = documents(folder);
        assert!(documents.len() >= least, "{folder}");
        for (path, document) in documents {
            let faults: Vec<_> = validator.iter_errors(&document).map(|e| e.to_string()).collect();
            assert!(faults.is_empty(), "{}: {faults:?}", path.display());
        }
    }
}

/// A domain's JSON with every key that exists.
#[test]
fn what_is_written_keeps_to_the_schema() {
    let validator = jsonschema::validator_for(&schema(&DomainDescription::schema())).unwrap();
    let text = r#"{"name": "a", "rectangle": {"width": 9, "height": 9, "origin": [0, 0], "rotation": 360},
        "sides": [{"intervals": 3, "spacing": {"bump": {"ratio": 2}}, "name": "b", "kind": "open"},
            {"size": 1, "outside_degree": 1, "max_degree": 9}, {"spacing": {"parameters": [0.5]}},
            {"intervals": 2, "outside_degree": [1, 2, 3], "spacing": {"first_length": 1}}],
        "holes": [{"ring": [[4, 4], [5, 4], [4, 5]]},
            {"corners": [[6, 6]], "sides": [{"intervals": 9, "arc": {"center": [6, 6.5], "clockwise": true}}]},
            {"corners": [[2, 6], [3, 6]], "sides": [{"intervals": 3, "bezier": [[2, 7], [3, 7]]},
                {"intervals": 3, "polyline": [[2.5, 5.5]]}]}],
        "vertices": [{"vertex": 1, "max_degree": 9, "outside_degree": 1}],
        "interior": {"growth": 0.3, "size_inside": 2, "sizes": [[4, 6, 0.1]], "interior_degree": [5, 7],
            "boundary_degree": 6, "target_angle": 20, "prefer": "angle", "max_points": 1000,
            "fixed": {"points": [[4, 7]], "segments": [[0, [5, 7]]]}}}"#;
    for text in [text.to_owned(), Domain::from_json(text).unwrap().to_json()] {
        let faults: Vec<_> =
            validator.iter_errors(&schema(&text)).map(|error| error.to_string()).collect();
        assert!(faults.is_empty(), "{faults:?}");
    }
}

#[test]
fn what_the_schema_refuses_the_reader_refuses() {
    let validator = jsonschema::validator_for(&schema(&DomainDescription::schema())).unwrap();
    let plate = |key: &str, value: Value| {
        let mut plate = json!({"rectangle": {"width": 4, "height": 3}, "size": 1});
        plate[key] = value;
        plate
    };
    let with_side = |side: Value| plate("sides", json!([side, {}, {}, {}]));
    let wrong = [
        json!([]),
        json!({"rectangle": {"width": 4}}),
        plate("hight", json!(3)),
        plate("size", json!("1")),
        plate("rectangle", json!([4, 3])),
        plate("vertices", json!([{"max_degree": 4}])),
        plate("holes", json!([{"corners": [[1, 1], [2]]}])),
        plate("interior", json!({"growth": 0})),
        plate("interior", json!({"target_angle": 60})),
        plate("interior", json!({"boundary_degree": 3})),
        plate("interior", json!({"sizes": [[1, 1]]})),
        plate("interior", json!({"interior_degree": [5]})),
        plate("interior", json!({"prefer": "speed"})),
        with_side(json!({"intervals": 2.9})),
        with_side(json!({"intervals": 0})),
        with_side(json!({"spacing": "even"})),
        with_side(json!({"spacing": {"bump": 2}})),
        with_side(json!({"spacing": {"bump": {"ratio": 2}, "beta": {"beta": 2}}})),
        with_side(json!({"kind": "water"})),
        with_side(json!({"outside_degree": -1})),
        with_side(json!({"bezier": [[1, 1]]})),
    ];
    for document in wrong {
        assert!(!validator.is_valid(&document), "the schema takes {document}");
        assert!(Domain::from_json(&document.to_string()).is_err(), "the reader takes {document}");
    }
    let validator = jsonschema::validator_for(&schema(&ModelDescription::schema())).unwrap();
    let wrong = [
        json!({"corners": [[0, 0, 0]]}),
        json!({"corners": [[0, 0]], "faces": [[0, 0, 0]]}),
        json!({"corners": [[0, 0, 0]], "faces": [{"holes": []}]}),
        json!({"corners": [[0, 0, 0]], "faces": [["a"]]}),
        json!({"corners": [[0, 0, 0]], "faces": [], "edges": [{"corners": [0]}]}),
        json!({"corners": [[0, 0, 0]], "faces": [], "materials": [{"name": "a", "color": [2, 0, 0]}]}),
    ];
    for document in wrong {
        assert!(!validator.is_valid(&document), "the schema takes {document}");
        assert!(Model::from_json(&document.to_string()).is_err(), "the reader takes {document}");
    }
}

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
        let path = root().join("docs").join(page).with_extension("md");
        let page = std::fs::read_to_string(&path).unwrap();
        let (before, _) = page.split_once(HEAD).unwrap_or((&page, ""));
        let expected = format!("{before}{HEAD}{}", rows(&schema(&text)));
        if std::env::var_os("MINDEG_BLESS").is_some() {
            std::fs::write(&path, &expected).unwrap();
            continue;
        }
        assert_eq!(page, expected, "run this test with MINDEG_BLESS=1");
    }
}
