//! One name for one thing in the JSON of all commands.

use crate::run::mindeg;
use serde_json::Value;
use std::collections::BTreeSet;

/// Names that a thing had in one command and not in others.
const RETIRED: [&str; 13] = [
    "angle_share",
    "boundary_degrees",
    "boundary_points",
    "lower_bound",
    "merged_vertices",
    "min_angle_limit",
    "off_degree",
    "optimal_max_degree",
    "out_of_range",
    "outside_5_to_7",
    "place",
    "point",
    "proven",
];

fn keys(value: &Value, into: &mut BTreeSet<String>) {
    match value {
        Value::Object(object) => {
            for (key, value) in object {
                into.insert(key.clone());
                keys(value, into);
            }
        }
        Value::Array(values) => values.iter().for_each(|value| keys(value, into)),
        _ => {}
    }
}

#[test]
fn a_thing_has_one_name_in_the_json_of_all_commands() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name).display().to_string();
    let asset = |name: &str| format!("{}/assets/{name}", env!("CARGO_MANIFEST_DIR"));
    let (plate, inside) = (at("plate.obj"), at("inside.obj"));
    let (cube, even) = (asset("models/cube.json"), at("even.obj"));
    let (solid, scan) = (at("cube.obj"), asset("meshes/scan.obj"));
    let [lower, upper] = ["lower", "upper"].map(|name| asset(&format!("meshes/{name}.obj")));
    let rectangle = ["--rectangle", "4x3", "--size", "1"];
    // Each makes or judges a mesh; the files of the first ones serve the others.
    let of_meshes: [(&[&str], &[&str]); 11] = [
        (&["mesh", "-o", &plate], &rectangle),
        (&["mesh", "--interior", "-o", &inside], &rectangle),
        (&["mesh", &cube, "-o", &solid], &[]),
        (&["mesh", &cube, "--interior", "--intervals", "2", "-o", &at("filled.obj")], &[]),
        (&["inspect", &inside], &[]),
        (&["verify", &plate], &rectangle),
        (&["improve", &inside, "-o", &at("improved.obj")], &[]),
        (&["remesh", &solid, "--size", "0.5", "-o", &even], &[]),
        (&["verify", &even, "--surface", &solid, "--tolerance", "5%"], &[]),
        (&["bridge", &lower, &upper, "-o", &at("joined.obj")], &[]),
        (&["convert", &plate, "-o", &at("plate.vtu")], &[]),
    ];
    let mut all = BTreeSet::new();
    for (command, more) in of_meshes {
        let run = mindeg([command, more, &["--json"]].concat());
        let answer = run.json();
        let shown = answer.get("after").unwrap_or(&answer);
        for key in ["triangles", "max_degree", "min_angle"] {
            assert!(shown[key].is_number(), "{command:?} has no {key}: {answer}");
        }
        assert_eq!(run.text().trim_end().lines().count(), 1, "{command:?}");
        keys(&answer, &mut all);
    }
    let others: [(&[&str], &[&str]); 6] = [
        (&["fill", &scan, "--max-loop", "15", "-o", &at("closed.obj")], &[]),
        (&["degree"], &rectangle),
        (&["tradeoff"], &rectangle),
        (&["suggest"], &rectangle),
        (&["compare"], &rectangle),
        (&["condition", &asset("domains/gusset.json")], &[]),
    ];
    for (command, more) in others {
        keys(&mindeg([command, more, &["--json"]].concat()).json(), &mut all);
    }
    let retired: Vec<&str> = RETIRED.into_iter().filter(|name| all.contains(*name)).collect();
    assert!(retired.is_empty(), "{retired:?}");
    for name in ["violations", "interior_degree", "boundary_degree", "least_max_degree", "at_least"]
    {
        assert!(all.contains(name), "{name} in {all:?}");
    }
}
