use crate::mesh::content;
use crate::run::{mindeg, mindeg_reading};
use serde_json::json;
use std::path::Path;

fn domain(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/domains").join(name);
    path.display().to_string()
}

#[test]
fn points_on_edges_lift_the_limit_and_the_mesh() {
    let folder = tempfile::tempdir().expect("a folder");
    let new = folder.path().join("britain.json").display().to_string();
    let run = mindeg(["condition", &domain("great-britain.json"), "--limit", "30", "-o", &new]);
    assert_eq!(
        run.text(),
        "great-britain: 391 boundary points become 469: 0 dropped, 78 put on edges, 0 sharp corners cut off, 0 holes \
         dropped\nIt moved nowhere. No mesh has a minimum angle above 30.691°, before 15.876°.\n"
    );
    let angle = |domain: &str| {
        let mesh = folder.path().join("mesh.obj").display().to_string();
        let found = mindeg(["mesh", domain, "--interior", "--json", "-o", &mesh]).json();
        found["min_angle"].as_f64().expect("an angle")
    };
    assert!(angle(&domain("great-britain.json")) < 16.0 && angle(&new) >= 30.0);
    // The coast keeps its name, and the file says what the text says.
    let written: serde_json::Value =
        serde_json::from_slice(&std::fs::read(&new).expect("a file")).expect("JSON");
    assert_eq!(written["sides"][0]["name"], "coast");
    let again = mindeg(["condition", &new, "--limit", "30", "--json"]).json();
    assert_eq!((&again["points_before"], &again["points"]), (&json!(469), &json!(469)));
    assert_eq!((&again["left"], &again["changes"]), (&json!([]), &json!([])));
}

/// A wedge of 11 degrees, and a step of a hundredth in its back.
const WEDGE: &[u8] = b"POLYGON ((0 0, 10 -1, 10 0, 10.01 0, 10.01 1, 0 0))";

#[test]
fn nothing_moves_without_a_distance_and_nothing_farther_with_one() {
    let still = mindeg_reading(["condition", "-", "--json"], WEDGE).json();
    assert_eq!((&still["moved"], &still["is_reached"]), (&json!(0.0), &json!(false)));
    assert_eq!(still["left"][0]["at"], json!([0.0, 0.0]));
    let reason =
        "the corner is sharper: give a larger --within, or drop a small island by --least-island";
    assert_eq!(still["left"][0]["reason"], reason);
    // No point more lifts the limit of the tip, which draws none near it.
    assert!(still["points"].as_u64() < Some(60), "{still}");
    let moved = ["condition", "-", "--within", "0.5", "--json"];
    let reached = mindeg_reading(moved, WEDGE).json();
    assert_eq!((&reached["is_reached"], &reached["left"]), (&json!(true), &json!([])));
    let moved = mindeg_reading([&moved[..], &["--growth", "0"]].concat(), WEDGE).json();
    // The rest of the tip is one edge wide, and no mesh of it was found that has more than a little less.
    assert_eq!((&moved["is_reached"], &moved["cut"]), (&json!(false), &json!(1)));
    assert!(moved["left"][0]["angle_limit"].as_f64().expect("an angle") > 24.0);
    assert_eq!(moved["left"][0]["is_proven"], false);
    assert!(moved["moved"].as_f64().expect("a length") <= 0.5);
    assert!(moved["angle_limit"].as_f64().expect("an angle") >= 25.0);
    let kept = ["condition", "-", "--within", "0.5", "--keep", "side 1", "--json"];
    let kept = mindeg_reading(kept, WEDGE).json();
    assert_eq!(kept["left"][0]["reason"], "its points are to stay: --keep fewer");
}

#[test]
fn bad_demands_are_refused_with_what_to_do() {
    let gusset = domain("gusset.json");
    for (more, words) in [
        (["--limit", "50"], &["--limit", "40"][..]),
        (["--within", "-1"], &["--within", "above 0"]),
        (["--growth", "0.1"], &["--growth", "0.35"]),
        (["--keep", "nix"], &["\"nix\" to keep", "flange, free-edge, web"]),
    ] {
        let folder = tempfile::tempdir().expect("a folder");
        let out = folder.path().join("x.json").display().to_string();
        mindeg([&["condition", &gusset, "-o", &out], &more[..]].concat()).refuses(words);
        assert!(content(folder.path()).is_empty());
    }
}

/// Two squares; their border has a step of a hundredth.
const SQUARES: &[u8] = br#"{"type": "FeatureCollection", "features": [
  {"type": "Feature", "properties": {"name": "A"}, "geometry": {"type": "Polygon",
    "coordinates": [[[0, 0], [4, 0], [4, 4], [4.01, 4], [4, 8], [0, 8], [0, 0]]]}},
  {"type": "Feature", "properties": {"name": "B"}, "geometry": {"type": "Polygon",
    "coordinates": [[[4, 0], [8, 0], [8, 8], [4, 8], [4.01, 4], [4, 4], [4, 0]]]}}]}"#;

#[test]
fn a_border_of_a_map_is_changed_once_for_both_regions() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name).display().to_string();
    let (new, changes) = (path("map.json"), path("changes.geojson"));
    let options = ["--within", "0.02", "-o", &new, "--changes", &changes, "--json"];
    let found = mindeg_reading([&["condition", "-"], &options[..]].concat(), SQUARES).json();
    assert_eq!((&found["dropped"], &found["is_reached"]), (&json!(1), &json!(true)));
    let read = |path: &str| -> serde_json::Value {
        serde_json::from_slice(&std::fs::read(path).expect("a file")).expect("JSON")
    };
    let map = read(&new);
    assert_eq!(map["lines"].as_array().map(Vec::len), Some(1));
    assert_eq!(map["lines"][0]["sides"][0]["name"], "A | B");
    let names: Vec<_> = (0..2).map(|region| &map["regions"][region]["name"]).collect();
    assert_eq!(names, ["A", "B"]);
    let features = read(&changes)["features"].clone();
    let kinds: Vec<_> =
        features.as_array().expect("features").iter().map(|it| &it["geometry"]["type"]).collect();
    assert_eq!(
        kinds,
        ["Polygon", "LineString", "Polygon", "LineString", "Point", "Point", "Point"]
    );
    let mesh = path("mesh.msh");
    let meshed = mindeg(["mesh", &new, "--interior", "--json", "-o", &mesh]).json();
    assert!(meshed["min_angle"].as_f64().expect("an angle") > 24.0);
    // A border that is kept keeps its step.
    let kept = ["condition", "-", "--within", "0.02", "--keep", "A | B", "--json"];
    let kept = mindeg_reading(kept, SQUARES).json();
    assert_eq!((&kept["dropped"], &kept["is_reached"]), (&json!(0), &json!(false)));
}

/// How often something is in a text.
fn times(text: &str, of: &str) -> usize {
    text.matches(of).count()
}

/// How far a spit that was cut off was from the new boundary, by the words of its mark, and these.
fn lost(tip: &str) -> Option<(f64, &str)> {
    let tip = tip.split_once("</title>")?.0;
    let length = tip.strip_suffix(" m from the new line")?.rsplit_once(' ')?.1;
    tip.contains(": spit").then(|| (length.parse::<f64>().expect("a length"), tip))
}

#[test]
fn the_picture_of_changes_has_each_of_them_with_its_number_and_magnifies_the_largest() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name).display().to_string();
    let coast = domain("../outlines/saronic.geojson");
    let (drawn, listed) = (path("c.svg"), path("c.geojson"));
    let told = |file: &str| {
        let wanted = ["--size", "2km", "--narrowest", "800m", "--json", "--changes", file];
        mindeg([&["condition", &coast, "--project", "auto"], &wanted[..]].concat()).json()
    };
    let answer = told(&drawn);
    assert_eq!(answer, told(&listed));
    let picture = std::fs::read_to_string(drawn).expect("a picture");
    let map = &picture[..picture.find("<svg x=").expect("something magnified")];
    let all = answer["changes"].as_array().expect("a list");
    assert!(all.len() > 300);
    for (number, change) in (1..).zip(all) {
        let [x, y] = [0, 1].map(|axis| change["degrees"][axis].as_f64().expect("degrees"));
        let tip = format!("<title>{number}: ");
        assert_eq!(times(map, &tip), 1, "{number}");
        let tip = &map[map.find(&tip).expect("it is there")..];
        let tip = &tip[..tip.find("</title>").expect("an end")];
        assert!(tip.contains(&format!("({x}, {y})")), "{tip}");
    }
    // The legend counts what the list has.
    for (key, words) in
        [("dropped", "dropped"), ("spits_cut", "spit cut off"), ("inserted", "put on an edge")]
    {
        assert_eq!(times(&picture, &format!(">{words} × {}<", answer[key])), 1, "{key}");
    }
    // Eight places, among them the spit that lost most.
    assert_eq!((times(&picture, "<svg x="), times(&picture, "class=\"part\"")), (8, 8));
    let most = map.split("<title>").filter_map(lost).max_by(|a, b| a.0.total_cmp(&b.0));
    let number = most.expect("a spit").1.split_once(':').expect("a number").0;
    assert_eq!(times(&picture, &format!(">{number}: spit cut off</text>")), 1);
    let listed = std::fs::read_to_string(&listed).expect("a file");
    let listed: serde_json::Value = serde_json::from_str(&listed).expect("JSON");
    let features = listed["features"].as_array().expect("a list");
    let number: usize = number.parse().expect("a number");
    let spit = features.iter().find(|it| it["properties"]["number"] == number);
    assert_eq!(spit.expect("it is there")["properties"]["kind"], "spit_cut");

    let run = mindeg(["condition", &coast, "--changes", &path("c.png")]);
    assert_eq!(run.code, Some(2));
    assert!(run.errors.contains("changes are drawn to .svg, and listed in .geojson"), "{run:?}");
    // Both commands draw the same.
    let (one, two) = (path("1.svg"), path("2.svg"));
    let wanted = [&coast, "--project", "auto", "--size", "4km", "--changes"];
    mindeg([&["condition"], &wanted[..], &[&one]].concat()).text();
    let mesh = ["mesh", "--interior", "--condition", "-o", &path("m.14")];
    mindeg([&mesh, &wanted[..], &[&two]].concat()).text();
    let bytes = |path: &str| std::fs::read(path).expect("a file");
    assert!(!bytes(&one).is_empty() && bytes(&one) == bytes(&two), "the pictures differ");
}

#[test]
fn one_step_gives_the_mesh_of_two_and_tells_the_changes() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name).display().to_string();
    let coast = domain("../outlines/saronic.geojson");
    let project = [&*coast, "--project", "auto"];
    let (sea, two, one, changes) =
        (path("sea.json"), path("2.14"), path("1.14"), path("c.geojson"));
    mindeg(
        [&["condition"], &project[..], &["--limit", "24", "--size", "4km", "-o", &sea]].concat(),
    )
    .text();
    mindeg(["mesh", &sea, "--interior", "--open", "box", "-o", &two]).text();
    let more = [
        "--interior",
        "--condition=24",
        "--size",
        "4km",
        "--open",
        "box",
        "--json",
        "-o",
        &one,
        "--changes",
        &changes,
    ];
    let told = mindeg([&["mesh"], &project[..], &more].concat()).json();
    let bytes = |path: &str| std::fs::read(path).expect("a file");
    assert!(bytes(&one) == bytes(&two), "the meshes differ");
    assert!(!bytes(&changes).is_empty());
    let conditioned = &told["conditioned"];
    assert!(conditioned["dropped"].as_u64().expect("a count") > 50);
    assert_eq!(conditioned["is_reached"], true);
    assert_eq!(told["limit"]["angle_limit"], conditioned["angle_limit"]);

    // Sizes that the mesh is to have inside divide the coast, too, in both ways.
    let depth = domain("../outlines/saronic-depth.asc");
    let sizes = ["--across", "3", "--min-size", "600m", "--depth", &depth, "--wavelength", "100"];
    let change = ["--size", "4km", "--json"];
    let alone = mindeg([&["condition"], &project[..], &change, &sizes].concat()).json();
    let meshed = ["--interior", "--condition", "-o", &one];
    let told = mindeg([&["mesh"], &project[..], &change, &meshed, &sizes].concat()).json();
    assert_eq!(told["conditioned"]["points"], alone["points"]);
    let coarse = conditioned["points"].as_u64();
    assert!(alone["points"].as_u64() > coarse.map(|it| it * 5 / 4), "{alone}");
    let refused = |more: &[&str]| mindeg([&["condition"], &project[..], more].concat());
    refused(&["--across", "0"]).refuses(&["--across", "more than 0"]);
    refused(&["--slope", "9"]).refuses(&["--slope needs depths: add --depth FILE"]);

    // Without a mesh there is no drawing of its changes.
    let unmet = path("unmet.geojson");
    let demand = ["--condition=24", "--size", "4km", "--changes", &unmet, "--max-degree", "5"];
    let run = mindeg([&["mesh"], &project[..], &["--interior", "-o", &two], &demand].concat());
    assert_eq!(run.code, Some(3), "{run:?}");
    assert!(!std::fs::exists(&unmet).expect("an answer"), "changes of no mesh");
}

#[test]
fn islands_of_a_map_are_conditioned_together() {
    let folder = tempfile::tempdir().expect("a folder");
    let mesh = folder.path().join("states.obj").display().to_string();
    let states = domain("../outlines/states.json");
    let states = [&*states, "--layer", "states", "--name-by", "name"];
    let more = ["--interior", "--condition", "--within", "1", "--json", "-o", &mesh];
    let told = mindeg([&["mesh"], &states[..], &more].concat()).json();
    let angle = |value: &serde_json::Value| value.as_f64().expect("an angle");
    assert_eq!(told["parts"], 8);
    assert!(angle(&told["conditioned"]["angle_limit_before"]) < 10.0);
    assert!(angle(&told["conditioned"]["angle_limit"]) > 25.0 && angle(&told["min_angle"]) > 15.0);
    let told = mindeg([&["condition"], &states[..], &["--within", "1"]].concat());
    let text = told.text();
    assert!(text.starts_with("states: 646 boundary points become"), "{text}");
    let out = folder.path().join("states-domain.json").display().to_string();
    // Before the work, which would tell that nothing has this name.
    let several =
        mindeg([&["condition"], &states[..], &["--keep", "Atlantis", "-o", &out]].concat());
    several.refuses(&["8 parts that share no edge", "mesh --interior --condition"]);
    // A pond behind a cape keeps the cape, which would else be cut off, and the pond be in the sea.
    let land = |name: &str, ring: &str| {
        format!(
            r#"{{"type": "Feature", "properties": {{"name": "{name}"}}, "geometry": {{"type": "Polygon", "coordinates": [[{ring}]]}}}}"#
        )
    };
    let sea = land("sea", "[0, 0], [4, 0], [5, 0.4], [6, 0], [10, 0], [10, 5], [0, 5]");
    let pond = land("pond", "[4.9, 0.1], [5.1, 0.1], [5, 0.2]");
    let both = format!(r#"{{"type": "FeatureCollection", "features": [{sea}, {pond}]}}"#);
    let condition = |map: &str| {
        let run = ["condition", "-", "--within", "1", "--size", "8", "--json"];
        mindeg_reading(run, map.as_bytes()).json()["dropped"].clone()
    };
    assert_eq!([condition(&both), condition(&sea)], [2, 3]);
}

#[test]
fn islands_beside_each_other_go_to_geojson() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("islands.geojson").display().to_string();
    let island = |x: i32| json!([[[x, 0], [x + 4, 0], [x + 4, 1], [x, 1], [x, 0]]]);
    let mouth = json!({"type": "LineString", "coordinates": [[0, 0], [4, 0]]});
    let line = json!({"type": "LineString", "coordinates": [[7, 0.5], [9, 0.5]]});
    let feature = |properties: serde_json::Value, geometry: serde_json::Value| json!({"type": "Feature", "properties": properties, "geometry": geometry});
    let polygon = |x: i32| json!({"type": "Polygon", "coordinates": island(x)});
    let features = [
        feature(json!({"name": "west"}), polygon(0)),
        feature(json!({"name": "east"}), polygon(6)),
        feature(json!({"kind": "open", "name": "mouth"}), mouth),
        feature(json!({"name": "reef"}), line),
    ];
    let map = json!({"type": "FeatureCollection", "features": features}).to_string();
    let told = mindeg_reading(["condition", "-", "-o", &out, "--json"], map.as_bytes()).json();
    let meshed = ["mesh", &out, "--interior", "--json", "-o", &format!("{out}.msh")];
    let meshed = mindeg(meshed).json();
    assert_eq!(meshed["parts"], 2);
    // The mesh has the limit of the new boundary, to the same bits: nothing was rounded.
    assert_eq!(meshed["angle_limit"], told["angle_limit"]);
    let text = std::fs::read_to_string(&out).expect("a file");
    let read: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    let told: Vec<_> = read["features"].as_array().expect("features").iter().collect();
    let names: Vec<_> = told.iter().map(|it| &it["properties"]["name"]).collect();
    let expected =
        ["west", "mouth", "west | outside", "east", "east | outside", "reef"].map(|it| json!(it));
    assert_eq!(names, expected.each_ref());
    assert_eq!(told[1]["properties"], json!({"kind": "open", "name": "mouth"}));
    assert!(told[1]["geometry"]["coordinates"].as_array().expect("points").len() > 2);
    assert_eq!(
        (&told[3]["geometry"]["type"], &told[5]["geometry"]["type"]),
        (&json!("Polygon"), &json!("LineString"))
    );
    let regions = ["condition", "-", "-o", &out];
    mindeg_reading(regions, SQUARES).refuses(&["GeoJSON would lose the regions", "-o DOMAIN.json"]);
}

#[test]
fn conditioning_that_says_nothing_is_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("x.obj").display().to_string();
    let plate = domain("plate-with-holes.json");
    for (more, words) in [
        (&[&*plate, "--within", "1"][..], &["--within", "--condition"][..]),
        (&[&*plate, "--condition"], &["--condition", "--interior"]),
        (&[&*plate, "--condition=41", "--interior"], &["at most 40"]),
        (&[&*domain("../models/bracket.obj"), "--condition"], &["--condition", "a model"]),
    ] {
        mindeg([&["mesh", "-o", &out], more].concat()).refuses(words);
    }
    assert!(content(folder.path()).is_empty());
}

/// A square with a creek, an island behind a strait, and a bay cut in two by a spit.
const NARROWS: &[u8] = br#"{"type": "Polygon", "coordinates": [
  [[0, 0], [40, 0], [40, 9.8], [50, 9.8], [50, 10.2], [40, 10.2], [40, 40], [20.3, 40], [20.3, 30], [20, 30], [20, 40], [0, 40], [0, 0]],
  [[0.5, 10], [0.5, 20], [8, 20], [8, 10], [0.5, 10]]]}"#;

#[test]
fn narrow_water_is_closed_and_narrow_land_cut_off_and_all_are_told() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name).display().to_string();
    let (new, changes) = (path("sea.json"), path("changes.geojson"));
    let options = ["condition", "-", "--narrowest", "1", "-o", &new, "--changes", &changes];
    let run = mindeg_reading(options, NARROWS);
    let text = run.text();
    let line = "1 narrow inlet closed, 1 strait closed, 1 spit of land cut off\nElsewhere it moved nowhere.";
    assert!(text.contains(line), "{text}");
    let read = |path: &str| -> serde_json::Value {
        serde_json::from_slice(&std::fs::read(path).expect("a file")).expect("JSON")
    };
    let features = read(&changes)["features"].clone();
    let kinds: Vec<String> = features
        .as_array()
        .expect("features")
        .iter()
        .filter_map(|it| it["properties"]["kind"].as_str().map(str::to_owned))
        .collect();
    assert_eq!(&kinds[..3], ["inlet_closed", "strait_closed", "spit_cut"]);
    // The island is land of the one ring, also where kinds were told before.
    assert!(read(&new)["holes"].as_array().is_none_or(Vec::is_empty));
    let kinds = [
        "condition",
        "-",
        "--narrowest",
        "1",
        "--open",
        "box",
        "--least-opening",
        "39",
        "-o",
        &new,
    ];
    mindeg_reading(kinds, NARROWS).text();
    let sides = read(&new)["sides"].clone();
    assert!(
        sides.as_array().expect("sides").iter().all(|side| side["kind"] != "island"),
        "{sides}"
    );
    // Nothing narrow is left.
    let again = mindeg(["condition", &new, "--narrowest", "1", "--json"]).json();
    assert_eq!((&again["inlets_closed"], &again["narrow"]), (&json!(0), &json!([])));
}

#[test]
fn a_poor_boundary_is_told_what_lifts_its_limit() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("mesh.obj").display().to_string();
    let hint = "hint: some edges of the boundary leave little room for good triangles; --condition puts 77 points on them";
    let britain = domain("great-britain.json");
    let mesh = ["mesh", &britain, "--interior", "-o", &out];
    let told = mindeg(mesh).errors;
    let (before, _) = told.split_once(hint).unwrap_or_else(|| panic!("{told}"));
    // The answer does not wait for the points to be counted, nor does who reads JSON.
    assert!(before.contains("\nwrote "), "{told}");
    let run = mindeg([&mesh[..], &["--json"]].concat());
    assert!(run.errors.contains("\nwrote ") && !run.errors.contains("hint"), "{run:?}");
    let run = mindeg([&mesh[..], &["--condition=25"]].concat());
    assert!(run.code == Some(0) && !run.errors.contains(hint), "{run:?}");
    // On a large boundary nobody waits for the number.
    let strip = ["mesh", "--rectangle", "100x0.1", "--intervals", "2000,1,200,1", "--interior"];
    let told = mindeg([&strip[..], &["-o", &out]].concat()).errors;
    assert!(told.contains("--condition puts points on edges where they help, and with"), "{told}");
    // No point more or less changes the angle of a corner.
    let tip = b"POLYGON ((0 0, 10 -1, 10 1, 0 0))";
    let run = mindeg_reading(["mesh", "-", "--interior", "-o", &out], tip);
    assert!(run.code == Some(0) && !run.errors.contains("hint"), "{run:?}");
}

/// An island with edges of 0.3, 1.4 from a side with edges of 5.
#[test]
fn edges_that_are_long_beside_others_are_told_what_divides_them() {
    let side = |[x, y]: [i32; 2], [u, v]: [i32; 2]| {
        (0..20).map(move |i| format!("{} {}", x + i * u, y + i * v))
    };
    let outer: Vec<String> = side([0, 0], [5, 0])
        .chain(side([100, 0], [0, 5]))
        .chain(side([100, 100], [-5, 0]))
        .chain(side([0, 100], [0, -5]))
        .collect();
    let corner = |i: i32| {
        let (sin, cos) = f64::from(-30 * i).to_radians().sin_cos();
        format!("{} {}", 52.5 + 0.6 * cos, 2.0 + 0.6 * sin)
    };
    let island: Vec<String> = (0..12).map(corner).collect();
    let [outer, island] = [outer, island].map(|ring| format!("({}, {})", ring.join(", "), ring[0]));
    let sea = format!("POLYGON ({outer}, {island})");
    let folder = tempfile::tempdir().expect("a folder");
    let [new, out] =
        ["new.json", "mesh.obj"].map(|name| folder.path().join(name).display().to_string());
    let hint = "hint: some edges of the boundary leave little room for good triangles; --condition puts 11 points on them, and \
                moves nothing.";
    let run = mindeg_reading(["mesh", "-", "--interior", "-o", &out], sea.as_bytes());
    assert!(run.code == Some(0) && run.errors.contains(hint), "{run:?}");
    let changed = |more: &[&str]| {
        let options = [&["condition", "-", "-o", &new, "--json"], more].concat();
        let changed = mindeg_reading(options, sea.as_bytes()).json();
        (changed["inserted"].clone(), changed["moved"].clone())
    };
    // The limit is above the angle that is asked for.
    assert_eq!(changed(&["--growth", "0"]), (json!(1), json!(0.0)));
    assert_eq!(changed(&[]), (json!(11), json!(0.0)));
    let mesh = ["mesh", &new, "--interior", "-o", &out];
    let run = mindeg(mesh);
    assert!(run.code == Some(0) && !run.errors.contains("hint: some edges"), "{run:?}");
    let run = mindeg([&mesh[..], &["--json"]].concat());
    assert!(run.json()["min_angle"].as_f64() > Some(38.0), "{run:?}");
}

/// A side that nothing moves keeps its law, its curve and its name; another is a list of its points.
#[test]
fn sides_that_stay_are_described_as_they_were() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("new.json").display().to_string();
    let changed = |name: &str, limit: &str| -> serde_json::Value {
        let run = mindeg(["condition", &domain(name), "--limit", limit, "-o", &out]);
        assert_eq!(run.code, Some(0), "{}", run.errors);
        serde_json::from_slice(&std::fs::read(&out).expect("a domain")).expect("JSON")
    };
    let channel = changed("boundary-layer-channel.json", "25");
    let sides = channel["sides"].as_array().expect("a list");
    for (side, name) in sides.iter().zip(["wall", "outlet", "symmetry", "inlet"]) {
        assert_eq!(side["name"], name);
        assert_eq!(side.get("points").is_some(), name == "wall", "{side}");
        assert_eq!(side["spacing"].is_object(), ["outlet", "inlet"].contains(&name), "{side}");
    }
    let bore = &changed("plate-with-holes.json", "35")["holes"][0]["sides"][0];
    assert!(bore["name"] == "left bore" && bore.get("arc").is_some(), "{bore}");
}
