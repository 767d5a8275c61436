//! From a coast in degrees to the grid of an ocean model.

use crate::mesh::content;
use crate::run::{mindeg, mindeg_reading};
use serde_json::{Value, json};
use std::fs;
use std::path::Path;

fn coast() -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/outlines/saronic.geojson");
    path.display().to_string()
}

/// A fort.14: the points with depths, the triangles, the open segments and the others with their type.
struct Fort14 {
    points: Vec<[f64; 3]>,
    triangles: Vec<[usize; 3]>,
    open: Vec<Vec<usize>>,
    closed: Vec<(u32, Vec<usize>)>,
}

/// Reads a fort.14 as ADCIRC does, by code of its own.
fn fort14(path: &Path) -> Fort14 {
    let text = fs::read_to_string(path).expect("a fort.14");
    let mut lines = text.lines().skip(1).map(|line| line.split('=').next().unwrap_or_default());
    let mut numbers = move || -> Vec<f64> {
        let line = lines.next().expect("a further line");
        line.split_whitespace().map(|word| word.parse().expect("a number")).collect()
    };
    let counts = numbers();
    let points =
        (0..counts[1] as usize).map(|_| numbers()[1..4].try_into().expect("three")).collect();
    let triangles = (0..counts[0] as usize).map(|_| {
        let line = numbers();
        [2, 3, 4].map(|at| line[at] as usize - 1)
    });
    let triangles = triangles.collect();
    let mut segments = || -> Vec<(u32, Vec<usize>)> {
        let (count, total) = (numbers()[0] as usize, numbers()[0] as usize);
        let segments: Vec<_> = (0..count)
            .map(|_| {
                let head = numbers();
                let nodes = (0..head[0] as usize).map(|_| numbers()[0] as usize - 1).collect();
                (head.get(1).map_or(0, |kind| *kind as u32), nodes)
            })
            .collect();
        assert_eq!(
            segments.iter().map(|(_, nodes): &(u32, Vec<usize>)| nodes.len()).sum::<usize>(),
            total
        );
        segments
    };
    let open = segments().into_iter().map(|(_, nodes)| nodes).collect();
    Fort14 { points, triangles, open, closed: segments() }
}

/// Depths of a bowl on a grid of degrees, 500 m at most; dry land in the north.
fn bowl() -> String {
    let mut text =
        "ncols 15\nnrows 12\nxllcenter 22.9\nyllcenter 37.1\ncellsize 0.1\nNODATA_value -9999\n"
            .to_owned();
    for row in (0..12_i32).rev() {
        let depth = |column: i32| {
            if row == 11 { -9999 } else { 500 - 10 * (column - 7).abs() - 20 * (row - 5).abs() }
        };
        let line: Vec<String> = (0..15).map(|column| depth(column).to_string()).collect();
        text += &(line.join(" ") + "\n");
    }
    text
}

#[test]
fn a_coast_in_degrees_becomes_a_grid_with_open_water_islands_and_depths() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name).display().to_string();
    let run = mindeg([
        "condition",
        &coast(),
        "--project",
        "auto",
        "--limit",
        "25",
        "--size",
        "2km",
        "-o",
        &at("sea.json"),
        "--changes",
        &at("changes.geojson"),
        "--json",
    ]);
    let answer = run.json();
    assert_eq!(answer["is_reached"], json!(true));
    assert!(answer["angle_limit"].as_f64().expect("an angle") >= 25.0);
    assert!(
        (1.0..=250.0).contains(&answer["moved"].as_f64().expect("metres")),
        "{}",
        answer["moved"]
    );
    let words = run.errors.clone();
    assert!(
        words.contains("projected degrees by UTM zone 34 north (+proj=utm +zone=34 +datum=WGS84)"),
        "{words}"
    );
    let domain: Value =
        serde_json::from_str(&fs::read_to_string(at("sea.json")).expect("a file")).expect("JSON");
    assert_eq!(domain["projection"], "+proj=utm +zone=34 +datum=WGS84");
    // Every change is in the list, in degrees, on a map with both coasts.
    let changes: Value =
        serde_json::from_str(&fs::read_to_string(at("changes.geojson")).expect("a file"))
            .expect("JSON");
    let features = changes["features"].as_array().expect("a list");
    assert_eq!(features.len(), 2 + answer["changes"].as_array().expect("a list").len());
    assert_eq!(features[0]["properties"]["boundary"], "before");
    // Each says how far the coast moved there, on which ring, and why.
    let rows = answer["changes"].as_array().expect("a list");
    let moved = |row: &Value| row["moved"].as_f64().unwrap_or_else(|| panic!("{row}"));
    let farthest = rows.iter().map(moved).fold(0.0, f64::max);
    assert!((farthest - answer["moved"].as_f64().expect("metres")).abs() < 1e-6, "{farthest}");
    assert!(rows.iter().all(|row| row["ring"].as_u64().is_some_and(|ring| ring < 12)));
    let on_island = rows.iter().find(|row| row["ring"] != 0).expect("an island that changed");
    assert!(on_island["side"].as_str().is_some_and(|side| side.starts_with("hole")), "{on_island}");
    let for_size = "edges there were too short or too long for the size";
    assert!(rows.iter().any(|row| row["kind"] == "dropped" && row["reason"] == for_size));
    assert_eq!(features[2]["properties"]["moved"], rows[0]["moved"]);
    for feature in &features[2..] {
        let [x, y] =
            [0, 1].map(|axis| feature["geometry"]["coordinates"][axis].as_f64().expect("a number"));
        assert!((22.85..24.35).contains(&x) && (37.05..38.15).contains(&y), "{feature}");
    }

    fs::write(at("depth.asc"), bowl()).expect("a file");
    let run = mindeg([
        "mesh",
        &at("sea.json"),
        "--interior",
        "--open",
        "box",
        "--depth",
        &at("depth.asc"),
        "--least-depth",
        "2",
        "--json",
        "-o",
        &at("sea.14"),
    ]);
    let (summary, words) = (run.json(), run.errors.clone());
    assert!(words.contains("has degrees of longitude and latitude"), "{words}");
    assert!(words.contains("depths from "), "{words}");
    let number = |key: &str| summary[key].as_f64().expect("a number");
    assert!(number("min_angle") >= 25.0 && number("share_of_limit") > 0.9999);
    let grid = fort14(Path::new(&at("sea.14")));
    assert_eq!(grid.triangles.len() as u64, summary["triangles"].as_u64().expect("a number"));
    // Degrees: the corner of the box, exactly, and everything within it.
    assert!(grid.points.iter().any(|point| point[..2] == [24.3, 37.1]));
    let depths = grid.points.iter().map(|point| point[2]);
    assert!(depths.clone().all(|depth| (2.0..=500.0).contains(&depth)));
    assert!(depths.fold(0.0, f64::max) > 490.0);
    // Between grid points that are known the depth is bilinear.
    let on_known = |point: &&[f64; 3]| point[1] < 38.0 && point[1] > 37.15;
    for [x, y, depth] in grid.points.iter().filter(on_known) {
        let [column, row] = [x - 22.9, y - 37.1].map(|it| (it / 0.1).max(0.0));
        let bump = |at: f64, top: f64| {
            (at.floor() - top).abs() * (1.0 - at.fract())
                + ((at.floor() + 1.0) - top).abs() * at.fract()
        };
        let expected = 500.0 - 10.0 * bump(column, 7.0) - 20.0 * bump(row, 5.0);
        assert!((depth - expected).abs() < 1e-4, "({x}, {y}): {depth}, not {expected}");
    }
    // Of the box the longest stretch is open, the others are told: every open node is on the box, and the islands are rings of their own.
    assert_eq!(grid.open.len(), 1);
    let told = "open water is 166.8km between 22.9597,37.1 24.3,37.5292\n4";
    assert!(
        words.contains(told)
            && words.contains("stretches on the box that are not the longest are land"),
        "{words}"
    );
    for &node in grid.open.iter().flatten() {
        let [x, y, _] = grid.points[node];
        let off =
            [x - 22.9, x - 24.3, y - 37.1, y - 38.1].map(f64::abs).into_iter().fold(1.0, f64::min);
        assert!(off < 2e-3, "({x}, {y})");
    }
    let islands = grid.closed.iter().filter(|(kind, _)| *kind == 1).count();
    assert_eq!(islands, 6);
    let land = grid.closed.len() - islands;
    assert!(land <= grid.open.len(), "{land} land boundaries");
    // Counter-clockwise triangles also in degrees.
    for triangle in &grid.triangles {
        let [a, b, c] = triangle.map(|node| grid.points[node]);
        assert!((b[0] - a[0]) * (c[1] - a[1]) > (b[1] - a[1]) * (c[0] - a[0]));
    }
    // Where the bottom is steep beside its depth, edges are shorter.
    let finer = mindeg([
        "mesh",
        &at("sea.json"),
        "--interior",
        "--depth",
        &at("depth.asc"),
        "--slope",
        "1500",
        "--json",
        "-o",
        &at("finer.14"),
    ]);
    let finer = finer.json()["triangles"].as_u64().expect("a number");
    assert!(finer > 2 * grid.triangles.len() as u64, "{finer}");
    // A least length instead opens all that are no shorter.
    for (least, count) in [("0", 5), ("30km", 3)] {
        let open = ["--open", "box", "--least-opening", least, "-o", &at("open.14")];
        let run = mindeg([&["mesh", &at("sea.json"), "--interior"], &open[..]].concat());
        assert_eq!(fort14(Path::new(&at("open.14"))).open.len(), count);
        assert_eq!(run.errors.contains("2 stretches shorter than 30km are land"), count == 3);
    }
    // Places are told in degrees, as the file has them.
    let raw = mindeg([
        "mesh",
        &coast(),
        "--project",
        "auto",
        "--interior",
        "--size",
        "2km",
        "-o",
        &at("raw.14"),
    ]);
    assert!(raw.errors.contains(" at longitude 23.456, latitude 37.9733 (limit"));
    // Without its projection the file is in metres.
    mindeg(["mesh", &at("sea.json"), "--interior", "--project", "none", "-o", &at("metres.14")]);
    let metres = fort14(Path::new(&at("metres.14")));
    assert!(metres.points.iter().all(|point| point[0] > 6e5 && point[1] > 4e6));
}

/// Land in the west, and an island: the rest of a box is the sea, as with any program that clips.
#[test]
fn the_sea_of_a_box_needs_no_other_program() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name).display().to_string();
    let land = r#"{"type": "MultiPolygon", "coordinates": [
        [[[20, 35], [23.5, 35], [23.4, 37.6], [23.6, 40], [20, 40], [20, 35]]],
        [[[24.1, 37.4], [24.3, 37.5], [24.2, 37.7], [24.1, 37.4]]]]}"#;
    let conditioned =
        ["condition", "-", "--sea-in", "23,37,25,38", "--project", "auto", "--size", "9km"];
    let run =
        mindeg_reading([&conditioned[..], &["-o", &at("sea.json")]].concat(), land.as_bytes());
    assert_eq!(run.code, Some(0), "{run:?}");
    let run =
        mindeg(["mesh", &at("sea.json"), "--interior", "--open", "east", "-o", &at("sea.14")]);
    assert_eq!(run.code, Some(0), "{run:?}");
    let Fort14 { points, open, closed, .. } = fort14(Path::new(&at("sea.14")));
    let islands = closed.iter().filter(|segment| segment.0 == 1).count();
    assert_eq!((open.len(), islands), (1, 1));
    assert!(open[0].iter().all(|node| (points[*node][0] - 25.0).abs() < 2e-3), "{open:?}");
    let west = points.iter().map(|point| point[0]).fold(f64::INFINITY, f64::min);
    assert!((23.35..23.45).contains(&west), "{west}");
    let run = mindeg_reading(["condition", "-", "--sea-in", "21,37,22,38"], land.as_bytes());
    assert!(run.errors.contains("the box from (21, 37) to (22, 38): polygons cover it"), "{run:?}");
    for corners in ["23,37,25", "25,37,23,38", "a,b,c,d"] {
        let run = mindeg_reading(["condition", "-", "--sea-in", corners], land.as_bytes());
        assert_eq!(run.code, Some(2), "{run:?}");
        assert!(run.errors.contains("give west,south,east,north"), "{run:?}");
    }
}

#[test]
fn grids_of_other_programs_are_refused_with_a_way_in() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name).display().to_string();
    let gdal = "`gdal_translate -of AAIGrid";
    for (name, bytes, words) in [
        ("gebco.nc", &b"\x89HDF\r\n\x1a\n\0"[..], "`nccopy -k classic"),
        ("etopo.tif", b"II*\0\x08\0\0\0", gdal),
    ] {
        fs::write(path(name), bytes).expect("a file");
        for option in ["--depth", "--elevation", "--sizes"] {
            let square = ["mesh", "--rectangle", "4x4", "--size", "1", "--interior"];
            let run = mindeg([&square[..], &[option, &path(name), "-o", &path("x.14")]].concat());
            run.refuses(&[&format!("{}: it is a", path(name)), words, &path(name)]);
        }
    }
    let mut rows =
        b"\x93NUMPY\x01\0\x76\0{'descr': '<f8', 'fortran_order': False, 'shape': (2, 2), }"
            .to_vec();
    rows.resize(10 + 0x76, b' ');
    rows.extend([0; 32]);
    fs::write(path("depth.npy"), rows).expect("a file");
    let array = ["--depth", &path("depth.npy"), "-o", &path("x.14")];
    mindeg([&["mesh", "--rectangle", "4x4", "--size", "1", "--interior"], &array[..]].concat())
        .refuses(&[&path("depth.npy"), "rows of x, y and value", "numpy.savez("]);
    fs::write(path("cut.nc"), b"CDF\x01\0\0\0\0").expect("a file");
    let cut = ["--depth", &path("cut.nc"), "-o", &path("x.14")];
    mindeg([&["mesh", "--rectangle", "4x4", "--size", "1", "--interior"], &cut[..]].concat())
        .refuses(&[&format!("{}: byte 8: the file ends within the header", path("cut.nc"))]);
}

#[test]
fn lengths_with_units_need_metres() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("sea.json").display().to_string();
    for arguments in [
        ["condition", &coast(), "--size", "2km", "-o", &out],
        ["condition", &coast(), "--within", "200m", "-o", &out],
    ] {
        mindeg(arguments).refuses(&["in metres", "look like degrees", "--project auto"]);
    }
    mindeg(["mesh", &coast(), "--interior", "--size", "2km", "-o", "x.14"])
        .refuses(&["--size is in metres"]);
    for command in ["condition", "mesh"] {
        mindeg([command, &coast(), "--size", "2000", "-o", &out])
            .refuses(&["--size is 2000 degrees", "--project auto"]);
    }
    let bad = mindeg(["condition", &coast(), "--project", "EPSG:2154", "-o", &out]);
    bad.refuses(&[
        "EPSG:2154 is not among the projections here",
        "ogr2ogr -t_srs EPSG:2154",
        "without a projection",
    ]);
    let planar =
        b"{\"type\": \"Polygon\", \"coordinates\": [[[4e5, 4e6], [5e5, 4e6], [4e5, 5e6]]]}";
    mindeg_reading(["condition", "-", "--project", "auto"], planar)
        .refuses(&["leave out --project"]);
    let json = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("assets/domains/gusset.json")
        .display()
        .to_string();
    mindeg(["condition", &json, "--project", "auto"])
        .refuses(&["--project", "is a domain in JSON"]);
    mindeg(["mesh", &json, "--interior", "--open", "nix", "-o", &out.replace("json", "14")])
        .refuses(&["--open", "no side is called"]);
    mindeg(["mesh", &json, "--interior", "--slope", "15", "-o", &out.replace("json", "14")])
        .refuses(&["--slope needs depths"]);
    assert!(content(folder.path()).is_empty());
}

/// Water with an island; lines along both say what is open water, and what the island is called.
const WATER: &[u8] = br#"{"type": "FeatureCollection", "features": [
  {"type": "Feature", "geometry": {"type": "Polygon", "coordinates": [
    [[24, 37], [24.5, 37], [24.5, 37.2], [24.5, 37.4], [24, 37.4]], [[24.2, 37.1], [24.2, 37.2], [24.3, 37.2]]]}},
  {"type": "Feature", "properties": {"kind": "open", "name": "strait"},
    "geometry": {"type": "LineString", "coordinates": [[24.5, 37.4], [24.5, 37.2], [24.5, 37]]}},
  {"type": "Feature", "properties": {"kind": "island", "name": "rock"}, "geometry": {"type": "LineString",
    "coordinates": [[24.2, 37.1], [24.2, 37.2], [24.3, 37.2], [24.2, 37.1]]}}]}"#;

#[test]
fn kinds_of_lines_in_geojson_reach_the_mesh_and_come_back() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name).display().to_string();
    let (domain, grid, map) = (path("sea.json"), path("sea.14"), path("sea.geojson"));
    let condition = ["condition", "-", "--project", "auto", "--size", "4km", "-o", &domain];
    mindeg_reading(condition, WATER).text();
    mindeg(["mesh", &domain, "--interior", "-o", &grid, "-o", &map]).text();
    let grid = fort14(Path::new(&grid));
    assert_eq!(grid.open.len(), 1);
    assert!(grid.open[0].iter().all(|node| (grid.points[*node][0] - 24.5).abs() < 1e-3));
    let map: Value = serde_json::from_slice(&fs::read(&map).expect("a map")).expect("JSON");
    let lines = map["features"].as_array().expect("features").iter();
    let told: Vec<[&Value; 2]> = lines
        .map(|feature| &feature["properties"])
        .filter(|properties| properties["kind"].is_string())
        .map(|properties| [&properties["line"], &properties["kind"]])
        .collect();
    assert!(told.contains(&[&json!("strait"), &json!("open")]), "{told:?}");
    assert!(told.contains(&[&json!("rock"), &json!("island")]), "{told:?}");
}

#[test]
fn open_water_of_a_file_leaves_one_land_boundary() {
    let folder = tempfile::tempdir().expect("a folder");
    let [grid, map] =
        ["bay.14", "bay.geojson"].map(|name| folder.path().join(name).display().to_string());
    let bay = r#"{"polygon": {"corners": [[0, 0], [3, 0], [4, 2], [3, 3], [1, 3], [-1, 1]]}, "size": 1,
        "sides": [{}, {}, {"kind": "open"}, {}, {}, {}]}"#;
    let mesh = ["mesh", "-", "--interior", "-o", &grid, "-o", &map];
    mindeg_reading(mesh, bay.as_bytes()).text();
    let grid = fort14(Path::new(&grid));
    let [(0, land)] = &grid.closed[..] else { panic!("{:?}", grid.closed) };
    let ends = |nodes: &[usize]| [nodes[0], *nodes.last().expect("an end")];
    let [from, to] = ends(&grid.open[0]);
    assert_eq!((ends(land), grid.open.len()), ([to, from], 1));
    // Formats with kinds have them, too.
    let map = fs::read_to_string(map).expect("a map");
    assert!(map.contains(r#""kind": "land""#) || map.contains(r#""kind":"land""#), "{map}");
}

#[test]
fn a_projection_that_geojson_names_is_that_of_its_coordinates() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("sea.14").display().to_string();
    // 24 to 25° east and 38 to 39° north in UTM zone 35, with a bend of the coast in the north.
    let ring = [
        [236_632.0, 4_210_028.0],
        [324_411.0, 4_207_637.0],
        [326_876.0, 4_318_597.0],
        [283_249.0, 4_308_598.0],
        [240_318.0, 4_321_000.0],
        [236_632.0, 4_210_028.0],
    ];
    let run = |crs: &str, options: &[&str]| {
        let crs = json!({"type": "name", "properties": {"name": crs}});
        let sea = json!({"type": "Polygon", "crs": crs, "coordinates": [ring]}).to_string();
        let common = ["mesh", "-", "--interior", "--size", "15km", "-o", &out];
        mindeg_reading([&common[..], options].concat(), sea.as_bytes())
    };
    let own = run("urn:ogc:def:crs:EPSG::32635", &["--open-between", "24,38", "25,38", "--json"]);
    assert_eq!(own.json()["projection"], "+proj=utm +zone=35 +datum=WGS84");
    assert!(own.errors.contains("is EPSG:32635: metres, by UTM zone 35 north"), "{}", own.errors);
    let first = fort14(Path::new(&out)).points[0];
    assert!((first[0] - 24.0).abs() < 1e-3 && (first[1] - 38.0).abs() < 1e-3, "{first:?}");
    run("EPSG:32635", &["--project", "auto"]).text();
    run("EPSG:32635", &["--project", "laea"]).refuses(&["says that it is projected already"]);
    // Not known, and none: planar.
    let unknown = run("EPSG:2100", &[]);
    assert!(unknown.errors.contains("is EPSG:2100, which is not known here"), "{}", unknown.errors);
    for options in [&[][..], &["--project", "none"]] {
        let crs = if options.is_empty() { "EPSG:2100" } else { "EPSG:32635" };
        run(crs, options).text();
        assert_eq!(fort14(Path::new(&out)).points[0][..2], ring[0]);
    }
    let square =
        br#"{"type": "Polygon", "crs": {"type": "name", "properties": {"name": "EPSG:32635"}},
        "coordinates": [[[24, 38], [25, 38], [25, 39], [24, 38]]]}"#;
    let degrees = mindeg_reading(["domain", "-", "--project", "auto"], square);
    assert!(degrees.errors.contains("but the coordinates are within those of degrees"));
}

#[test]
fn a_polygon_cut_at_the_antimeridian_is_one_in_the_plane() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("sea.14").display().to_string();
    let west = [[178, -19], [180, -19], [180, -16], [178, -16], [178, -19]];
    let east = [[-180, -19], [-179, -19], [-179, -16], [-180, -16], [-180, -19]];
    let sea = json!({"type": "MultiPolygon", "coordinates": [[west], [east]]}).to_string();
    let mesh = |project: &str| {
        let common = ["mesh", "-", "--interior", "--json", "-o", &out, "--open", "box"];
        mindeg_reading([&common[..], &["--project", project]].concat(), sea.as_bytes())
    };
    let run = mesh("auto");
    assert!(run.errors.contains("joined 1 polygon across 180° of longitude"), "{}", run.errors);
    assert_eq!(run.json()["regions"], Value::Null);
    let grid = fort14(Path::new(&out));
    assert_eq!((grid.open.len(), grid.closed.len()), (1, 0));
    let inside = grid.points.iter().filter(|at| (at[1] + 17.5).abs() < 1.4);
    assert!(
        inside.clone().count() > 20 && inside.clone().all(|at| (178.0..=181.001).contains(&at[0]))
    );
    // As planar coordinates they lie a world apart.
    assert_eq!(mesh("none").json()["parts"], 2);
}

#[test]
fn sides_and_lines_of_a_name_have_a_size_of_their_own() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("sea.14").display().to_string();
    let line = |properties: Value, points: Value| {
        let geometry = json!({"type": "LineString", "coordinates": points});
        json!({"type": "Feature", "properties": properties, "geometry": geometry})
    };
    let ring = json!([[[24, 38], [24.5, 38], [24.5, 38.5], [24, 38.5], [24, 38]]]);
    let polygon = json!({"type": "Polygon", "coordinates": ring});
    let sea = json!({"type": "FeatureCollection", "features": [
        {"type": "Feature", "properties": {}, "geometry": polygon},
        line(json!({"kind": "land", "name": "quay"}), json!([[24.5, 38.5], [24, 38.5]])),
        line(json!({"name": "cable"}), json!([[24.2, 38.25], [24.24, 38.25]]))]});
    let run = |options: &[&str], more: &[&str]| {
        let common = ["mesh", "-", "--interior", "--size", "6km", "-o", &out];
        mindeg_reading([&common[..], options, more].concat(), sea.to_string().as_bytes())
    };
    let projected = ["--project", "auto"];
    let count = |options: &[&str], is_there: &dyn Fn(&[f64; 3]) -> bool| {
        run(options, &projected).text();
        fort14(Path::new(&out)).points.iter().filter(|at| is_there(at)).count()
    };
    let quay = |at: &[f64; 3]| (at[1] - 38.5).abs() < 1e-3;
    let cable = |at: &[f64; 3]| (at[1] - 38.25).abs() < 1e-4 && (24.19..24.25).contains(&at[0]);
    // 43.6 and 3.5 km long.
    assert_eq!(count(&[], &quay), 8);
    assert_eq!(count(&["--size-of", "quay=1km", "--size-of", "cable=500m"], &quay), 45);
    assert_eq!(count(&["--size-of", "cable=500m"], &cable), 8);
    run(&["--size-of", "pipe=900m"], &projected)
        .refuses(&["no side or line is called \"pipe\"; there are cable, east, quay, south, west"]);
    run(&["--size-of", "cable"], &projected).refuses(&["such as river=200m"]);
    run(&["--size-of", "cable=900m"], &["--project", "none"]).text();
    let alone = ["mesh", "-", "--interior", "--size-of", "cable=900m", "-o", &out];
    mindeg_reading(alone, sea.to_string().as_bytes()).refuses(&["--size-of is in metres"]);
}

#[test]
fn lines_inside_are_no_boundaries_of_an_ocean_model() {
    let folder = tempfile::tempdir().expect("a folder");
    let grid = folder.path().join("two.14").display().to_string();
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/outlines/two-materials.geojson");
    let run = mindeg(["mesh", &path.display().to_string(), "--interior", "-o", &grid]);
    let told = "two.14 leaves out lines inside, since the format has boundaries alone: ";
    let words = format!("{}{}", String::from_utf8_lossy(&run.output), run.errors);
    assert!(words.contains(told), "{words}");
    let grid = fort14(Path::new(&grid));
    let beside = |a: usize, b: usize| {
        grid.triangles.iter().filter(|t| t.contains(&a) && t.contains(&b)).count()
    };
    let mut edges = 0;
    for (kind, nodes) in &grid.closed {
        let ring = nodes.iter().chain(nodes.first().filter(|_| *kind == 1)).copied();
        for ends in ring.collect::<Vec<_>>().windows(2) {
            assert_eq!(beside(ends[0], ends[1]), 1);
            edges += 1;
        }
    }
    // All edges of the boundary are there.
    let sides = grid.triangles.iter().flat_map(|t| [[t[0], t[1]], [t[1], t[2]], [t[2], t[0]]]);
    assert_eq!(sides.filter(|[a, b]| beside(*a, *b) == 1).count(), edges);
}

#[test]
fn depths_that_a_format_leaves_out_are_told() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name).display().to_string();
    let terrain = "MESH2D\nE3T 1 1 2 3 1\nND 1 0 0 5\nND 2 1 0 6\nND 3 1 1 7\n";
    fs::write(at("terrain.2dm"), terrain).expect("a file");
    for (name, is_told) in [("surface.obj", true), ("bed.14", false)] {
        let run = mindeg(["convert", &at("terrain.2dm"), "-o", &at(name)]);
        assert_eq!(run.code, Some(0), "{}", run.errors);
        assert_eq!(
            run.errors.contains(&format!("{name} leaves out the depths")),
            is_told,
            "{}",
            run.errors
        );
    }
}

#[test]
fn a_sea_around_a_pole_is_written_in_metres_alone() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name).display().to_string();
    let sea = path("sea.json");
    // A square around the north pole.
    let square = r#"{"polygon": {"corners": [[-1e5, -1e5], [1e5, -1e5], [1e5, 1e5], [-1e5, 1e5]]}, "size": 4e4,
        "projection": "+proj=stere +lat_0=90 +lon_0=0 +datum=WGS84"}"#;
    fs::write(&sea, square).expect("a file");
    for grid in ["sea.14", "sea.geojson", "sea.nc"] {
        mindeg(["mesh", &sea, "--interior", "-o", &path(grid)]).refuses(&[
            grid,
            "around a pole",
            "--project none",
        ]);
        assert!(!Path::new(&path(grid)).exists());
    }
    mindeg(["mesh", &sea, "--interior", "-o", &path("sea.2dm")]).text();
    let plane = ["mesh", &sea, "--interior", "--project", "none", "-o", &path("sea.14")];
    mindeg(plane).text();
    // The mesh is around the pole, and so has triangles on all sides of it.
    let Fort14 { points, triangles, .. } = fort14(Path::new(&path("sea.14")));
    for triangle in triangles {
        let [a, b, c] = triangle.map(|node| points[node]);
        assert!((b[0] - a[0]) * (c[1] - a[1]) > (b[1] - a[1]) * (c[0] - a[0]));
    }
}

#[test]
fn ugrid_of_a_projected_sea_has_degrees_with_their_units() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name).display().to_string();
    let has = |file: &str, words: &str| {
        let bytes = fs::read(path(file)).expect("a file");
        bytes.windows(words.len()).any(|part| part == words.as_bytes())
    };
    let sea = ["mesh", "-", "--interior", "--project"];
    let [degrees, plane] = [path("degrees.nc"), path("plane.nc")];
    let run =
        mindeg_reading([&sea[..], &["auto", "--size", "8km", "-o", &degrees]].concat(), WATER);
    assert!(run.errors.contains("UGRID NetCDF has degrees"), "{}", run.errors);
    for words in ["degrees_east", "degrees_north", "standard_name", "latitude of the nodes"] {
        assert!(has("degrees.nc", words), "{words}");
    }
    let corner = 24.5_f64.to_be_bytes();
    let bytes = fs::read(&degrees).expect("a file");
    assert!(bytes.windows(8).any(|part| part == corner));
    mindeg_reading([&sea[..], &["none", "-o", &plane]].concat(), WATER).text();
    assert!(!has("plane.nc", "degrees_east") && has("plane.nc", "x of the nodes"));
}

#[test]
fn depths_tell_the_time_step_that_the_edges_allow() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name).display().to_string();
    // A square of edges of about 1000 m, 10 m deep.
    let grid = |name: &str, depth: f64, size: u32| {
        let row = format!("{depth} {depth}\n");
        let head = format!("ncols 2\nnrows 2\nxllcenter 0\nyllcenter 0\ncellsize {size}\n");
        fs::write(path(name), head + &row + &row).expect("a file");
    };
    grid("even.asc", 10.0, 4000);
    let sea = ["mesh", "--rectangle", "4000x4000", "--size", "1000", "--interior", "--depth"];
    let mesh =
        |more: &[&str]| mindeg([&sea[..], more, &["-o", &path("sea.14"), "--json"]].concat());
    let step = ["--wavelength", "30", "--time-step", "20"];
    let run = mesh(&[&[path("even.asc").as_str()][..], &step].concat());
    let courant = &run.json()["depths"]["courant"];
    let Fort14 { points, triangles, .. } = fort14(Path::new(&path("sea.14")));
    let sides = triangles.iter().flat_map(|t| [[t[0], t[1]], [t[1], t[2]], [t[2], t[0]]]);
    let length = |[a, b]: [usize; 2]| {
        let [a, b] = [points[a], points[b]];
        (a[0] - b[0]).hypot(a[1] - b[1])
    };
    let shortest = sides.map(length).fold(f64::INFINITY, f64::min);
    let number = |key: &str| courant[key].as_f64().expect("a number");
    let speed = (9.81_f64 * 10.0).sqrt();
    assert!((number("greatest") - 20.0 * speed / shortest).abs() < 1e-6);
    assert!((number("allowed_time_step") - 0.5 * shortest / speed).abs() < 1e-6);
    assert!(run.errors.contains("a time step of 20 s has Courant numbers of"), "{}", run.errors);
    let run = mesh(&[&path("even.asc")]);
    assert!(run.errors.contains("a Courant number of 0.5 allows a time step of"), "{}", run.errors);
    assert!(!run.errors.contains("warning"), "{}", run.errors);

    // Heights for depths, and a grid of a part.
    grid("heights.asc", -10.0, 4000);
    let run = mesh(&[&path("heights.asc")]);
    assert!(run.errors.contains("no vertex has water: give heights, positive up, by --elevation"));
    assert_eq!(run.json()["depths"]["courant"], Value::Null);
    let shore = "ncols 2\nnrows 2\nxllcenter 0\nyllcenter 0\ncellsize 4000\n-10 10\n-10 10\n";
    fs::write(path("shore.asc"), shore).expect("a file");
    let run = mesh(&[&path("shore.asc")]);
    let told = format!(
        "; {} of {} vertices above the water, to which --least-depth gives some",
        run.json()["depths"]["dry"],
        run.json()["vertices"]
    );
    assert!(run.errors.contains(&told), "{}", run.errors);
    let run = mesh(&[&path("shore.asc"), "--least-depth", "1"]);
    assert!(run.json()["depths"]["dry"] == 0 && !run.errors.contains("above the water"));
    grid("half.asc", 10.0, 1000);
    let run = mesh(&[&path("half.asc")]);
    assert!(run.errors.contains("lie beyond the grid and got"), "{}", run.errors);
    // A gap of 3 rows in the middle, in which some vertices are more than a row from any depth.
    let [row, gap] = ["10 10 10 10 10\n", "-9999 -9999 -9999 -9999 -9999\n"];
    let head = "ncols 5\nnrows 5\nxllcenter 0\nyllcenter 0\ncellsize 1000\n";
    let text = [head, row, gap, gap, gap, row].concat();
    fs::write(path("gap.asc"), text).expect("a file");
    let run = mesh(&[&path("gap.asc")]);
    assert!(run.errors.contains("lie in gaps of the grid and got the nearest"), "{}", run.errors);
    let answer = run.json();
    let points = fort14(Path::new(&path("sea.14"))).points;
    let inside = points.iter().filter(|at| at[1] >= 1000.0 && at[1] < 3000.0).count();
    assert_eq!(answer["depths"]["in_gaps"], inside);
    assert_eq!(answer["depths"]["beyond"], 0);
    mesh(&[&path("even.asc"), "--least-depth", "-5"]).refuses(&["0 or more"]);
}

#[test]
fn open_water_is_told_with_its_distances_and_in_json() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name).display().to_string();
    let out = path("sea.14");
    let gr3 = path("sea.gr3");
    let sea = ["mesh", "-", "--interior", "--project", "auto", "--size", "4km", "-o", &out];
    let run = |more: &[&str]| mindeg_reading([&sea[..], more].concat(), WATER);
    let near = run(&["--open-between", "24.01,37", "24.49,37", "--json", "-o", &gr3]);
    // The nearest vertices are the corners, a hundredth of a degree away.
    let told = "the nearest vertices of the boundary are 890.5m and 890.3m from the points";
    assert!(near.errors.contains(told), "{}", near.errors);
    let have = "ADCIRC fort.14 or SCHISM hgrid.gr3 has degrees of longitude";
    assert!(near.errors.contains(have), "{}", near.errors);
    let answer = near.json();
    assert_eq!(answer["projection"], "+proj=utm +zone=35 +datum=WGS84");
    let openings = answer["openings"].as_array().expect("a list");
    assert!(openings.len() == 1 && openings.iter().all(|it| it["is_open"] == true), "{answer}");
    run(&["--open-between", "20,37", "24.5,37"]).refuses(&[
        "(20, 37) is",
        " m from the nearest vertex",
        "x (longitude) first",
    ]);
    run(&["--open-between", "500000,4100000", "24.5,37"])
        .refuses(&["is no longitude and latitude"]);
    run(&["--open", "nowhere"])
        .refuses(&["no side is called \"nowhere\"; there are north, rock, south"]);
}

#[test]
fn names_of_sides_are_told_in_order_and_counted() {
    let corners: Vec<String> = (0..24)
        .map(|corner| {
            let angle = f64::from(corner) * std::f64::consts::TAU / 24.0;
            format!("[{}, {}]", angle.cos(), angle.sin())
        })
        .collect();
    let sides: Vec<&str> =
        (0..24)
            .map(|side| {
                if side == 20 {
                    r#"{"name": "quay", "intervals": 1}"#
                } else {
                    r#"{"intervals": 1}"#
                }
            })
            .collect();
    let domain = format!(
        r#"{{"polygon": {{"corners": [{}]}}, "sides": [{}]}}"#,
        corners.join(", "),
        sides.join(", ")
    );
    let names =
        "quay, side 1, side 2, side 3, side 4, side 5, side 6, side 7, side 8, side 9 and 14 more";
    mindeg_reading(["condition", "-", "--keep", "nix"], domain.as_bytes())
        .refuses(&["there is no side \"nix\" to keep", names]);
    mindeg_reading(["condition", "-", "--open", "nix"], domain.as_bytes())
        .refuses(&["no side is called \"nix\"", names]);
}

#[test]
fn a_grid_in_degrees_is_judged_in_metres() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("north.14").display().to_string();
    // On the ground these are right-angled halves of a square of 1.1 km, in degrees twice as wide as high.
    let grid = "north\n2 4\n1 20 60 5\n2 20.02 60 5\n3 20.02 60.01 5\n4 20 60.01 5\n1 3 1 2 3\n2 3 1 3 4\n0\n0\n0\n0\n";
    fs::write(&path, grid).expect("a file");
    let run = mindeg(["inspect", &path, "--preset", "sms"]);
    assert_eq!(run.code, Some(0), "{}", run.errors);
    assert!(
        run.errors.contains("--preset judges them in metres, by UTM zone 34"),
        "{}",
        run.errors
    );
    let wide = grid.replace("60", "0");
    fs::write(&path, wide.replace("20.02", "20.12")).expect("a file");
    assert_eq!(mindeg(["inspect", &path, "--preset", "sms"]).code, Some(3));
}

#[test]
fn projections_far_from_their_region_are_told() {
    let far = ["condition", "-", "--project", "EPSG:32640"];
    let run = mindeg_reading(far, WATER);
    assert!(run.errors.contains("that is far from its middle: --project auto"), "{}", run.errors);
    let near = mindeg_reading(["condition", "-", "--project", "EPSG:32635"], WATER);
    assert!(!near.errors.contains("far from its middle"), "{}", near.errors);
    for (code, words) in [("4326", "is degrees of longitude"), ("99999", "is no code")] {
        let epsg = format!("EPSG:{code}");
        mindeg_reading(["condition", "-", "--project", &epsg], WATER).refuses(&[words]);
    }
    let folder = tempfile::tempdir().expect("a folder");
    let prj = folder.path().join("coast.prj").display().to_string();
    fs::write(&prj, "GEOGCS[]").expect("a file");
    mindeg(["condition", &prj]).refuses(&["a part of a shapefile"]);
}

/// Two seas with land between them.
const SEAS: &[u8] = br#"{"type": "MultiPolygon", "coordinates": [
  [[[0, 0], [4, 0], [4, 4], [0, 4], [0, 0]]], [[[7, 0], [11, 0], [11, 4], [7, 4], [7, 0]]]]}"#;

#[test]
fn seas_of_several_parts_are_open_on_the_box_around_all() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("seas.14");
    let path = out.display().to_string();
    let mesh = ["mesh", "-", "--size", "1", "--interior", "-o", &path];
    mindeg_reading([&mesh[..], &["--open", "box"]].concat(), SEAS).text();
    let grid = fort14(&out);
    // Each sea has one shore, towards the other one.
    let places =
        |nodes: &[usize]| -> Vec<f64> { nodes.iter().map(|node| grid.points[*node][0]).collect() };
    let shores: Vec<Vec<f64>> = grid.closed.iter().map(|(_, nodes)| places(nodes)).collect();
    assert_eq!((grid.open.len(), shores.len()), (2, 2));
    assert!(shores.iter().all(|shore| shore.iter().all(|x| [4.0, 7.0].contains(x))), "{shores:?}");
    let between = ["--open-between", "11,0", "11,4"];
    mindeg_reading([&mesh[..], &between].concat(), SEAS).text();
    let grid = fort14(&out);
    assert_eq!(grid.open.len(), 1);
    assert!(grid.open[0].iter().all(|node| grid.points[*node][0] == 11.0));
}

#[test]
fn a_grid_in_degrees_is_verified_against_its_projected_domain() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name).display().to_string();
    let [sea, grid] = ["sea.json", "sea.14"].map(path);
    let coast = coast();
    let condition = ["condition", &coast, "--project", "auto", "--limit", "25", "--size", "8km"];
    mindeg([&condition[..], &["-o", &sea]].concat()).text();
    mindeg(["mesh", &sea, "--interior", "-q", "-o", &grid]).text();
    let verified = mindeg(["verify", &grid, &sea, "--json"]).json();
    assert_eq!(verified["valid"], true, "{verified}");
    // A grid of another place is none of the domain.
    let text = fs::read_to_string(&grid).expect("a grid").replace(" 23.", " 24.");
    fs::write(&grid, text).expect("a grid");
    let run = mindeg(["verify", &grid, &sea]);
    assert_eq!(run.code, Some(3), "{}", run.errors);
}

#[test]
fn channels_get_as_many_edges_across_as_asked() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name).display().to_string();
    // Two basins, and a channel of 2 between them whose banks are divided finely.
    let domain = r#"{"polygon": {"corners": [[0, 0], [10, 0], [10, 4], [22, 4], [22, 0], [32, 0], [32, 10], [22, 10], [22, 6],
        [10, 6], [10, 10], [0, 10]]}, "size": 1, "sides": [{}, {"size": 0.4}, {"size": 0.25}, {"size": 0.4}, {}, {}, {},
        {"size": 0.4}, {"size": 0.25}, {"size": 0.4}, {}, {}]}"#;
    fs::write(path("dumbbell.json"), domain).expect("a file");
    let mesh = |more: &[&str]| {
        let run = ["mesh", &path("dumbbell.json"), "--interior", "--json", "-o", &path("mesh.14")];
        let told = mindeg([&run[..], more].concat()).json();
        let Fort14 { points, triangles, .. } = fort14(Path::new(&path("mesh.14")));
        // The triangles that a line across the channel passes through: two to an edge across.
        let passed = [13.03, 15.03, 17.03, 19.03].map(|x| {
            let sides = |corners: &[usize; 3]| corners.map(|corner| points[corner][0] < x);
            let is_passed = |corners: &&[usize; 3]| sides(corners) != [sides(corners)[0]; 3];
            triangles.iter().filter(is_passed).count()
        });
        (*passed.iter().min().expect("four"), told["vertices"].as_u64().expect("a count"))
    };
    let (plain, few) = mesh(&[]);
    let (finer, more) = mesh(&["--across", "8"]);
    let (bounded, _) = mesh(&["--across", "8", "--min-size", "0.5"]);
    assert!(finer >= 16 && plain < 16, "{plain} {finer}");
    assert!(bounded < finer && more > few && more < 3 * few, "{bounded} {few} {more}");
    for wrong in ["0", "-1", "1e9"] {
        let run = ["mesh", &path("dumbbell.json"), "--interior", "--across", wrong];
        mindeg([&run[..], &["-o", &path("x.14")]].concat()).refuses(&["across"]);
    }
}

#[test]
fn depths_of_another_region_are_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name).display().to_string();
    let grid = "ncols 2\nnrows 2\nxllcenter 1000\nyllcenter 1000\ncellsize 1\n5 5\n5 5\n";
    std::fs::write(path("far.asc"), grid).expect("a file");
    let (depth, out) = (path("far.asc"), path("sea.14"));
    let sea = ["mesh", "--rectangle", "4x3", "--size", "1", "--interior", "--depth", &depth, "-o"];
    mindeg([&sea[..], &[&out]].concat()).refuses(&["no vertex of the mesh lies on the grid"]);
    assert!(!Path::new(&out).exists());
}

#[test]
fn a_stretch_of_open_water_and_the_land_of_a_box_are_one_boundary_each() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name).display().to_string();
    let ring = [[20.0, 36.0], [21.0, 36.0], [21.0, 37.0], [20.5, 36.8], [20.0, 37.0]];
    let sea = path("sea.geojson");
    fs::write(&sea, json!({"type": "Polygon", "coordinates": [ring]}).to_string()).expect("a file");
    let out = path("sea.14");
    let counts = |options: &[&str]| {
        let common =
            ["mesh", &sea, "--project", "auto", "--interior", "--size", "15km", "-o", &out];
        mindeg([&common[..], options].concat()).text();
        let grid = fort14(Path::new(&out));
        [grid.open.len(), grid.closed.len()]
    };
    // Around a corner of the box, by points and by the names of its sides; and land alone.
    assert_eq!(counts(&["--open-between", "20.5,36", "21,36.5"]), [1, 1]);
    assert_eq!(counts(&["--open", "south", "--open", "east"]), [1, 1]);
    assert_eq!(counts(&["--open", "south", "--open", "west"]), [1, 1]);
    assert_eq!(counts(&[]), [0, 1]);
    // A part with a name keeps it, from which sizes are told, and is in one boundary with the rest.
    let corners = [[0, 0], [10, 0], [10, 10], [5, 8], [0, 10]];
    let side = |intervals: u32| json!({"intervals": intervals});
    let mouth = json!({"intervals": 5, "name": "mouth"});
    let named = json!({"polygon": {"corners": corners}, "sides": [side(5), mouth, side(3), side(3), side(5)],
        "interior": {"sizes": [{"from": ["mouth"], "size": 2}]}});
    mindeg_reading(
        ["mesh", "-", "--interior", "--open", "box", "-o", &out],
        named.to_string().as_bytes(),
    )
    .text();
    let text = fs::read_to_string(&out).expect("a file");
    assert!(text.contains(" 16 = nodes of open boundary 1 (open, mouth)"), "{text}");
    // A time step is told with depths alone.
    let depths = path("depths.asc");
    let grid = "ncols 2\nnrows 2\nxllcorner 19\nyllcorner 35\ncellsize 2\n50 50\n50 50\n";
    fs::write(&depths, grid).expect("a file");
    let common = ["mesh", &sea, "--project", "auto", "--interior", "--size", "15km", "-o", &out];
    let run = mindeg([&common[..], &["--open", "south"]].concat());
    assert!(run.errors.contains("the mesh has no depths"), "{}", run.errors);
    let run = mindeg([&common[..], &["--depth", &depths, "--time-step", "5"]].concat());
    assert!(run.errors.contains("a time step of 5 s has Courant numbers"), "{}", run.errors);
}

#[test]
fn a_coast_keeps_the_rules_of_telemac_and_fvcom() {
    let folder = tempfile::tempdir().expect("a folder for the files");
    let sea = |name: &str| folder.path().join(name).display().to_string();
    let step =
        ["--project", "auto", "--interior", "--condition=25", "--size", "4km", "--open", "box"];
    let mesh = |out: &str, more: &[&str]| {
        mindeg([&["mesh", &coast(), "-o", out, "--json", "-q"], &step[..], more].concat())
    };
    let run = mesh(&sea("usual.14"), &[]);
    assert_eq!(run.code, Some(0), "{run:?}");
    let inspected = mindeg(["inspect", &sea("usual.14"), "--preset", "telemac"]);
    assert_eq!(inspected.code, Some(3), "{inspected:?}");
    assert!(inspected.errors.contains("has all its corners on the boundary"), "{inspected:?}");
    for preset in ["telemac", "fvcom"] {
        let out = sea(&format!("{preset}.14"));
        let answer = mesh(&out, &["--preset", preset]).json();
        let angle = answer["min_angle"].as_f64().expect("an angle");
        assert!(angle > 24.9 && answer["violations"] == json!([]), "{preset}: {angle}");
        let Fort14 { points, triangles, open, closed } = fort14(Path::new(&out));
        let mut is_inside = vec![true; points.len()];
        let ends = open.iter().chain(closed.iter().map(|segment| &segment.1)).flatten();
        ends.for_each(|node| is_inside[*node] = false);
        assert!(triangles.iter().all(|nodes| nodes.iter().any(|node| is_inside[*node])));
    }
}

/// A country of a file of the world: what is projected is the country alone.
#[test]
fn one_polygon_of_a_file_around_the_globe_is_projected() {
    let world = r#"{"type": "FeatureCollection", "features": [
        {"type": "Feature", "properties": {"name": "here"}, "geometry": {"type": "Polygon",
            "coordinates": [[[24, 38], [25, 38], [25, 39], [24, 38]]]}},
        {"type": "Feature", "properties": {"name": "there"}, "geometry": {"type": "Polygon",
            "coordinates": [[[-156, -38], [-155, -38], [-155, -37], [-156, -38]]]}}]}"#;
    for options in [&[][..], &["--repair"]] {
        let of = |name: &[&str]| {
            let words = [&["domain", "-", "--project", "auto", "--json"], name, options].concat();
            mindeg_reading(&words, world.as_bytes())
        };
        let here = of(&["--feature", "here"]);
        assert_eq!(here.code, Some(0), "{}", here.errors);
        assert!(here.errors.contains("UTM zone 35 north"), "{}", here.errors);
        let all = of(&[]);
        assert!(all.errors.contains("choose a part"), "{}", all.errors);
    }
}

/// They were in metres of the plane, which no map program shows beside such a file.
#[test]
fn faults_of_projected_outlines_are_told_in_degrees() {
    let square =
        |x: f64, y: f64| json!([[x, y], [x + 1.0, y], [x + 1.0, y + 1.0], [x, y + 1.0], [x, y]]);
    let polygon = |rings: &[serde_json::Value]| json!({"type": "Polygon", "coordinates": rings});
    let two = json!({"type": "MultiPolygon", "coordinates": [[square(24.0, 38.0)], [square(24.5, 38.5)]]});
    let bow = json!([[24, 38], [25.5, 39], [25, 38], [24, 39], [24, 38]]);
    let hole = json!([[27, 38], [27.1, 38], [27, 38.1], [27, 38]]);
    for (outline, place) in [
        (polygon(&[bow]), "cross near longitude 24.59"),
        (
            polygon(&[square(24.0, 38.0), hole]),
            "with its first corner at longitude 27, latitude 38;",
        ),
        (two, "error: standard input: longitude 25.00"),
    ] {
        let text = outline.to_string();
        let words = ["mesh", "-", "--interior", "--project", "auto", "-o", "-", "--format", "obj"];
        let run = mindeg_reading(words, text.as_bytes());
        assert_eq!(run.code, Some(2), "{run:?}");
        assert!(run.errors.contains(place), "{}", run.errors);
        // Planar coordinates are the file's own.
        let kept = mindeg_reading(
            ["mesh", "-", "--interior", "-o", "-", "--format", "obj"],
            text.as_bytes(),
        );
        assert!(!kept.errors.contains("longitude 2"), "{}", kept.errors);
    }
}

/// GeoJSON was read as if its edges were straight in degrees, and got points that the domain in JSON does not have.
#[test]
fn a_coast_in_geojson_is_the_one_in_json() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name).display().to_string();
    let ring = [[24.0, 38.0], [29.0, 38.0], [28.8, 38.7], [29.0, 39.5], [24.3, 39.4], [24.0, 38.0]];
    let island = [[26.0, 38.5], [26.1, 39.0], [27.0, 38.6], [26.0, 38.5]];
    let sea =
        json!({"type": "Polygon", "coordinates": [ring.to_vec(), island.to_vec()]}).to_string();
    for plane in ["auto", "stereographic"] {
        let boundary = |coast: &str| -> Vec<[i64; 2]> {
            let changed = ["condition", "-", "--project", plane, "-q", "-o", &at(coast)];
            mindeg_reading(changed, sea.as_bytes()).text();
            let project: &[&str] = if coast == "sea.json" { &[] } else { &["--project", "auto"] };
            let words = ["mesh", &at(coast), "--interior", "-q", "-o", &at("sea.14")];
            mindeg([&words[..], project].concat()).text();
            let Fort14 { points, open, closed, .. } = fort14(Path::new(&at("sea.14")));
            let loops = open.iter().chain(closed.iter().map(|segment| &segment.1));
            let place =
                |node: &usize| [0, 1].map(|axis| (points[*node][axis] * 1e7).round() as i64);
            let mut places: Vec<_> = loops.flatten().map(place).collect();
            places.sort_unstable();
            places.dedup();
            places
        };
        assert_eq!(boundary("sea.json"), boundary("sea.geojson"), "{plane}");
    }
}

/// The list of stretches on the box stood before an error, which scrolled away.
#[test]
fn an_error_stands_alone_without_the_stretches_on_the_box() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("cross.14").display().to_string();
    let cross = "1,0 2,0 2,1 3,1 3,2 2,2 2,3 1,3 1,2 0,2 0,1 1,1";
    let words = ["mesh", "--corners", cross, "--size", "0.5", "--open", "box", "-o", &out];
    let told = "\n3 stretches on the box that are not the longest are land";
    for kind in [&[][..], &["--interior"]] {
        let mesh = |angle: &str| mindeg([&words[..], kind, &["--target-angle", angle]].concat());
        let failed = mesh("59");
        assert!(failed.code != Some(0) && failed.errors.starts_with("error:"), "{failed:?}");
        assert!(!failed.errors.contains("stretches"), "{}", failed.errors);
        let done = mesh("10");
        assert!(done.code == Some(0) && done.errors.contains(told), "{done:?}");
        assert!(done.errors.contains("minimum angle"), "{}", done.errors);
    }
}

/// An index, and the label of one of several, chose only among what a repair had made of the whole world.
#[test]
fn one_repaired_polygon_of_a_file_around_the_globe_is_projected() {
    let ring = |x: f64, y: f64, width: f64| {
        json!([[x, y], [x + width, y], [x + width, y + 1.0], [x, y + 1.0], [x, y]])
    };
    let bow = json!([[-99, 10], [-98, 12], [-98, 10], [-99, 12], [-99, 10]]);
    let feature = |name: Option<&str>, rings: &[serde_json::Value]| {
        let parts: Vec<_> = rings.iter().map(|ring| json!([ring])).collect();
        let geometry = json!({"type": "MultiPolygon", "coordinates": parts});
        json!({"type": "Feature", "properties": {"name": name}, "geometry": geometry})
    };
    let features = [
        feature(Some("there"), &[bow]),
        feature(Some("isles"), &[ring(-150.0, -30.0, 1.0), ring(24.0, 38.0, 1.5)]),
        feature(None, &[ring(24.0, 40.0, 2.0)]),
    ];
    let world = json!({"type": "FeatureCollection", "features": features}).to_string();
    let of = |wanted: &str, command: &[&str]| {
        let words = [command, &["-", "--project", "auto", "--json", "--feature", wanted]].concat();
        mindeg_reading(&words, world.as_bytes())
    };
    for (wanted, zone, label, area) in [
        ("2", "UTM zone 14 north", "there 2", 6.04e9),
        ("isles 2", "UTM zone 35 north", "isles 2", 1.45e10),
        ("5", "UTM zone 35 north", "", 1.87e10),
    ] {
        let one = of(wanted, &["domain", "--repair"]);
        assert!(one.errors.contains(zone), "{wanted}: {}", one.errors);
        let told = &one.json()[0];
        assert_eq!(told["name"].as_str().unwrap_or_default(), label);
        let found = told["area"].as_f64().expect("an area");
        assert!((found / area - 1.0).abs() < 0.02, "{wanted}: {found}");
        let changed = of(wanted, &["condition", "--limit", "20"]);
        assert!(changed.errors.contains(zone), "{wanted}: {}", changed.errors);
        changed.json();
    }
    of("6", &["condition", "--limit", "20"]).refuses(&["an index from 1 to 5: 1 (there 1)"]);
}

/// A ring that crosses itself is two polygons once it is repaired, and an index chooses among these.
#[test]
fn an_index_counts_the_polygons_that_a_repair_makes() {
    let bow = "POLYGON((0 0, 2 2, 2 0, 0 2, 0 0))";
    let of = |index| {
        let words = ["domain", "-", "--repair", "--feature", index];
        mindeg_reading(words, bow.as_bytes())
    };
    assert_eq!(of("2").code, Some(0), "{}", of("2").errors);
    of("3").refuses(&["give a name, or an index from 1 to 2"]);
}

/// SWAN reads numbers from the first lines of Triangle's files.
#[test]
fn the_files_of_triangle_begin_with_their_numbers() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("plate.node");
    let words = ["mesh", "--rectangle", "4x3", "--size", "1", "--interior", "-q", "-o"];
    let run = mindeg([&words[..], &[&file.display().to_string()]].concat());
    assert_eq!(run.code, Some(0), "{}", run.errors);
    for (ending, columns) in [("node", ["2", "0", "1"].as_slice()), ("ele", &["3", "0"])] {
        let text = fs::read_to_string(file.with_extension(ending)).expect("written");
        let words: Vec<&str> = text.lines().next().unwrap().split_whitespace().collect();
        assert!(words[0].parse::<u32>().is_ok() && words[1..].starts_with(columns), "{words:?}");
    }
}
