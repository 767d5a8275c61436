//! Meshes joined by a mesh of the gap between them, or where they overlap.

use crate::mesh::content;
use crate::run::mindeg;
use serde_json::{Value, json};
use std::fs;
use std::path::Path;

const OCEAN: &str = r#"{"polygon": {"corners": [[0, 0], [10, 0], [10, 4], [10, 6], [10, 10], [0, 10]]}, "sides": [
    {"size": 1, "name": "south", "kind": "open"}, {"size": 0.7, "name": "shore", "kind": "land"},
    {"size": 0.5, "name": "mouth", "kind": "open"}, {"size": 0.7, "name": "shore", "kind": "land"},
    {"size": 1, "name": "north", "kind": "land"}, {"size": 1, "name": "west", "kind": "land"}]}"#;
const RIVER: &str = r#"{"polygon": {"corners": [[13, 4.4], [20, 4.2], [20, 5.8], [13, 5.6]]}, "sides": [
    {"size": 0.4, "name": "bank", "kind": "land"}, {"size": 0.4, "name": "inflow", "kind": "open"},
    {"size": 0.4, "name": "bank", "kind": "land"}, {"size": 0.4, "name": "end", "kind": "open"}]}"#;
const DELTA: &str = "POLYGON ((9.8 3.8, 13.2 4.3, 13.2 5.7, 9.8 6.2))";

/// The meshes of the ocean and of the river, with depths of 10 and 2, in a folder.
fn meshes(folder: &Path, river: &str) -> [String; 3] {
    let path = |name: &str| folder.join(name).display().to_string();
    let grid = |depth: f64| {
        format!(
            "ncols 2\nnrows 2\nxllcorner -1\nyllcorner -1\ncellsize 30\n{depth} {depth}\n{depth} {depth}\n"
        )
    };
    for (name, json, depth) in [("ocean", OCEAN, 10.0), ("river", river, 2.0)] {
        let [domain, depths] = ["json", "asc"].map(|end| path(&format!("{name}.{end}")));
        fs::write(&domain, json).expect("a file");
        fs::write(&depths, grid(depth)).expect("a file");
        let out = path(&format!("{name}.14"));
        mindeg(["mesh", &domain, "--interior", "--depth", &depths, "-o", &out]).text();
    }
    let area = path("delta.wkt");
    fs::write(&area, DELTA).expect("a file");
    [path("ocean.14"), path("river.14"), area]
}

/// The nodes and the elements of a fort.14, without their numbers; nodes of elements count from 1.
fn lists(path: &str) -> [Vec<Vec<f64>>; 2] {
    let text = fs::read_to_string(path).expect("a grid");
    let mut lines = text.lines().skip(1);
    let numbers = |line: &str| -> Vec<f64> {
        line.split_whitespace().map_while(|word| word.parse().ok()).skip(1).collect()
    };
    let head = lines.next().expect("counts");
    let mut counts = head.split_whitespace().map(|word| word.parse::<usize>().unwrap_or(0));
    let [elements, nodes] = [0; 2].map(|_: usize| counts.next().expect("a count"));
    let nodes = lines.by_ref().take(nodes).map(numbers).collect();
    [nodes, lines.take(elements).map(numbers).collect()]
}

#[test]
fn a_gap_is_filled_and_the_meshes_stay() {
    let folder = tempfile::tempdir().expect("a folder");
    let [ocean, river, area] = meshes(folder.path(), RIVER);
    let out = folder.path().join("both.14").display().to_string();
    let run = mindeg(["stitch", &ocean, &river, "--within", &area, "--json", "-o", &out]);
    let told = run.json();
    assert_eq!((&told["joined"], &told["violations"]), (&json!(5), &json!([])));
    assert!(told["min_angle"].as_f64().expect("an angle") > 28.0);
    let [[a, ta], [b, tb], [both, all]] = [&ocean, &river, &out].map(|path| lists(path));
    assert_eq!(both[..a.len()], a);
    assert_eq!(both[a.len()..a.len() + b.len()], b);
    assert_eq!(all[..ta.len()], ta);
    let moved: Vec<Vec<f64>> = tb
        .iter()
        .map(|row| {
            row.iter()
                .enumerate()
                .map(|(i, it)| if i > 0 { it + a.len() as f64 } else { *it })
                .collect()
        })
        .collect();
    assert_eq!(all[ta.len()..ta.len() + tb.len()], moved);
    // Depths lie between, and rise towards the river.
    let new = &both[a.len() + b.len()..];
    assert!(new.iter().all(|node| (2.0..=10.0).contains(&node[2])));
    let mean =
        |nodes: Vec<&Vec<f64>>| nodes.iter().map(|node| node[2]).sum::<f64>() / nodes.len() as f64;
    let (west, east): (Vec<_>, Vec<_>) = new.iter().partition(|node| node[0] < 11.5);
    assert!(mean(west) > mean(east) + 2.0);
    // The mouth is no boundary any more; the others keep their names, and the new banks are land.
    let text = fs::read_to_string(&out).expect("a grid");
    let has = |name: &str| text.contains(&format!("({name})"));
    assert!(!has("mouth") && !has("end") && !has("mesh"));
    assert!(["south", "shore", "inflow", "bank", "land"].into_iter().all(has));
    let inspected = mindeg(["inspect", &out]);
    assert!(inspected.text().contains("nothing wrong found"), "{}", inspected.text());
}

#[test]
fn what_cannot_be_stitched_is_refused_with_the_place() {
    let folder = tempfile::tempdir().expect("a folder");
    let overlapping = RIVER.replace("[13, 4.4]", "[9, 4.4]").replace("[13, 5.6]", "[9, 5.6]");
    let other = tempfile::tempdir().expect("a folder");
    let [ocean, river, area] = meshes(folder.path(), RIVER);
    let [_, on_ocean, _] = meshes(other.path(), &overlapping);
    let path = |name: &str, text: &str| {
        let path = folder.path().join(name).display().to_string();
        fs::write(&path, text).expect("a file");
        path
    };
    let half = path("half.wkt", "POLYGON ((9.8 3.8, 11 4.3, 11 5.7, 9.8 6.2))");
    let zigzag =
        path("zigzag.wkt", "POLYGON ((9.8 3.7, 10.2 3.75, 9.9 3.8, 13.2 4.3, 13.2 5.7, 9.8 6.2))");
    let steep = path("steep.obj", "v 13 4 0\nv 14 4 0\nv 13 5 1\nf 1 2 3\n");
    // Along y = 6, where the shore has a vertex.
    let high = path("high.wkt", "POLYGON ((9.8 3.8, 13.2 4.3, 13.2 6, 9.8 6))");
    // Of the river it has one vertex, of the ocean an edge.
    let corner = path("corner.wkt", "POLYGON ((9.8 4.3, 12.9 4.3, 13.2 4.2, 13.1 4.6, 9.8 5.1))");
    let inside = path("inside.wkt", "POLYGON ((1 1, 2 1, 2 2, 1 2))");
    let out = folder.path().join("x.14").display().to_string();
    let before = content(folder.path());
    for (other, area, words) in [
        (&on_ocean, &area, &["meshes 1 and 2 overlap", "near (10, "][..]),
        (&ocean, &area, &["meshes 1 and 2 overlap", "near ("]),
        (&on_ocean, &inside, &["meshes 1 and 2 overlap", "without it, the second one"]),
        (&river, &inside, &["no gap"]),
        (
            &river,
            &corner,
            &["the area has the boundary vertex at (13, 4.4) and no edge of that mesh"],
        ),
        (&river, &half, &["stays apart"]),
        (&river, &zigzag, &["crosses the boundary edge at (10, ", "several times"]),
        (&river, &high, &["through the boundary vertex at (10, 6)"]),
        (&steep, &area, &["is not flat"]),
    ] {
        mindeg(["stitch", &ocean, other, "--within", area, "-o", &out]).refuses(words);
    }
    for (other, words) in [
        (&river, &["do not overlap", "--within"][..]),
        (&ocean, &["nothing is left to join", "other order"]),
        (&steep, &["is not flat"]),
    ] {
        mindeg(["stitch", &ocean, other, "-o", &out]).refuses(words);
    }
    mindeg(["stitch", &ocean, &on_ocean, &river, "-o", &out]).refuses(&["two meshes are joined"]);
    assert_eq!(content(folder.path()), before);
}

#[test]
fn a_hole_of_the_area_is_an_island() {
    let folder = tempfile::tempdir().expect("a folder");
    let [ocean, river, _] = meshes(folder.path(), RIVER);
    let area = folder.path().join("island.wkt").display().to_string();
    let rings = "(9.8 3.7, 13.2 4.3, 13.2 5.7, 9.8 6.2), (11 4.9, 11.4 5, 11 5.1)";
    fs::write(&area, format!("POLYGON ({rings})")).expect("an area");
    let out = folder.path().join("both.14").display().to_string();
    mindeg(["stitch", &ocean, &river, "--within", &area, "-o", &out]).text();
    let text = fs::read_to_string(&out).expect("a mesh");
    assert!(text.contains(" 1 = nodes of island boundary"), "{text}");
}

#[test]
fn meshes_beside_the_antimeridian_are_joined_across_it() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name).display().to_string();
    let polygon = |name: &str, ring: [[f64; 2]; 4]| {
        let text = json!({"type": "Polygon", "coordinates": [ring]}).to_string();
        let file = path(&format!("{name}.geojson"));
        fs::write(&file, text).expect("a file");
        file
    };
    let mesh = |name: &str, ring| {
        let [file, out] = [polygon(name, ring), path(&format!("{name}.14"))];
        let size = ["--size", "15km", "-o", &out];
        mindeg([&["mesh", &file, "--project", "auto", "--interior"][..], &size].concat()).text();
        out
    };
    let ocean = mesh("ocean", [[179.0, -17.0], [180.0, -17.0], [180.0, -16.0], [179.0, -16.0]]);
    let river = mesh("river", [[-179.7, -16.6], [-179.2, -16.6], [-179.2, -16.4], [-179.7, -16.4]]);
    let ring = [[179.95, -16.65], [-179.6, -16.65], [-179.6, -16.35], [179.95, -16.35]];
    let area = polygon("area", ring);
    let out = path("both.14");
    let planar = ["both sides of the antimeridian", "--project auto"];
    mindeg(["stitch", &ocean, &river, "--within", &area, "-o", &out]).refuses(&planar);
    let metres = path("metres.2dm");
    mindeg(["convert", &ocean, "-o", &metres]).text();
    let text = fs::read_to_string(&metres).expect("a mesh").replace(" 179", " 179000");
    fs::write(&metres, text).expect("a mesh");
    mindeg(["stitch", &metres, &river, "--within", &area, "--project", "auto", "-o", &out])
        .refuses(&["a mesh is not in degrees", "in the coordinates of the meshes"]);
    let run =
        mindeg(["stitch", &ocean, &river, "--within", &area, "--project", "auto", "-o", &out]);
    run.text();
    let [[old, first], [nodes, triangles]] = [&*ocean, &*out].map(lists);
    assert_eq!((&nodes[..old.len()], &triangles[..first.len()]), (&old[..], &first[..]));
    // Longitudes go on from the first mesh, and no triangle runs around the globe.
    let longitudes = nodes.iter().map(|node| node[0]);
    let most = longitudes.fold(0.0, f64::max);
    assert!((most - 180.8).abs() < 1e-6, "{most}");
    for corners in triangles {
        let own = corners[1..].iter().map(|node| nodes[*node as usize - 1][0]);
        let [low, high] =
            own.fold([f64::INFINITY, 0.0], |[low, high], it| [low.min(it), high.max(it)]);
        assert!(high - low < 0.5, "{low} {high}");
    }
}

/// Joins two meshes that overlap: the first one is the start of the result, and what the summary tells holds there.
fn overlapped(meshes: [&str; 2], out: &str, more: &[&str]) -> Value {
    let run = [&["stitch", meshes[0], meshes[1], "--json", "-o", out][..], more].concat();
    let told = mindeg(run).json();
    let [[a, ta], [b, tb], [all, tall]] = [meshes[0], meshes[1], out].map(lists);
    assert_eq!((&all[..a.len()], &tall[..ta.len()]), (&a[..], &ta[..]));
    let count = |key: &str| told[key].as_u64().expect("a count") as usize;
    let [overlapping, near, new] = ["overlapping", "near", "new_triangles"].map(count);
    assert!(overlapping > 0 && near > 0 && new > 0);
    assert_eq!(tall.len(), ta.len() + tb.len() - overlapping - near + new);
    // The other vertices of the second mesh stay bit for bit, in their order.
    let left = &all[a.len()..all.len() - count("new_vertices")];
    let mut of_second = b.iter();
    assert!(left.iter().all(|node| of_second.any(|other| other == node)));
    assert_eq!(told["violations"], json!([]));
    let inspected = mindeg(["inspect", out]);
    assert!(inspected.text().contains("nothing wrong found"), "{}", inspected.text());
    told
}

#[test]
fn meshes_that_overlap_are_joined_and_the_first_one_stays() {
    let folder = tempfile::tempdir().expect("a folder");
    let overlapping = RIVER.replace("[13, 4.4]", "[9, 4.4]").replace("[13, 5.6]", "[9, 5.6]");
    let [ocean, river, _] = meshes(folder.path(), &overlapping);
    let out = folder.path().join("both.14").display().to_string();
    for (order, least) in [([&*ocean, &*river], 35.0), ([&*river, &*ocean], 35.0)] {
        let told = overlapped(order, &out, &[]);
        assert!(told["min_angle"].as_f64().expect("an angle") > least, "{told}");
        let text = fs::read_to_string(&out).expect("a grid");
        let has = |name: &str| text.contains(&format!("({name})"));
        // The new banks are the river's, and what lies inside now has no name any more.
        assert!(["south", "shore", "inflow", "bank"].into_iter().all(has) && !has("land"));
        assert!(!has("end") && !has("mesh"));
        let [nodes, _] = lists(&out);
        assert!(nodes.iter().all(|node| (2.0..=10.0).contains(&node[2])));
    }
}

#[test]
fn a_fine_mesh_in_a_sea_takes_the_place_of_the_coarse_one() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name).display().to_string();
    let saronic =
        concat!(env!("CARGO_MANIFEST_DIR"), "/assets/outlines/saronic.geojson").to_owned();
    let [sea, bay, out] = ["sea.14", "bay.14", "both.14"].map(path);
    let mesh = |file: &str, more: &[&str], out: &str| {
        let run =
            ["mesh", file, "--project", "auto", "--interior", "--open", "box", "-q", "-o", out];
        mindeg([&run[..], more].concat()).text();
    };
    mesh(&saronic, &["--condition=25", "--size", "5km"], &sea);
    // A box over the open boundary in the south, and one around an island and a cape.
    for [[west, south], [east, north]] in
        [[[23.45, 37.05], [23.75, 37.3]], [[23.5, 37.3], [23.9, 37.55]]]
    {
        let file = path("bay.geojson");
        let ring =
            json!([[[west, south], [east, south], [east, north], [west, north], [west, south]]]);
        fs::write(&file, json!({"type": "Polygon", "coordinates": ring}).to_string())
            .expect("a file");
        mesh(&file, &["--size", "1500m"], &bay);
        let told = overlapped([&bay, &sea], &out, &["--project", "auto"]);
        assert!(told["min_angle"].as_f64().expect("an angle") > 30.0, "{told}");
    }
    let run = mindeg(["stitch", &bay, &sea, "-o", &out]);
    assert!(run.errors.contains("look like degrees"), "{}", run.errors);
}

#[test]
fn a_mesh_in_a_hole_an_island_in_the_gap_and_degrees() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name).display().to_string();
    let put = |name: &str, text: &str| {
        fs::write(path(name), text).expect("a file");
        path(name)
    };
    let square = |from: f64, to: f64, size: f64| {
        format!(r#""corners": [[{from}, {from}], [{to}, {from}], [{to}, {to}], [{from}, {to}]]"#)
            + &format!(r#", "sides": [{0}, {0}, {0}, {0}]"#, format!(r#"{{"size": {size}}}"#))
    };
    let polygon = |square: String| {
        square
            .replacen("\"corners\": ", "\"polygon\": {\"corners\": ", 1)
            .replacen("]], ", "]]}, ", 1)
    };
    let frame = format!(
        "{{{}, \"holes\": [{{{}}}]}}",
        polygon(square(0.0, 12.0, 1.0)),
        square(3.0, 9.0, 0.8)
    );
    let core = format!("{{{}}}", polygon(square(5.0, 7.0, 0.5)));
    let mesh = |name: &str, text: &str, more: &[&str]| {
        let (domain, out) = (put(name, text), path(&format!("{name}.14")));
        mindeg([&["mesh", &*domain, "--interior", "-o", &*out][..], more].concat()).text();
        out
    };
    let stitched = |meshes: [&str; 2], area: &str, more: &[&str]| {
        let out = path("out.14");
        let first = ["stitch", meshes[0], meshes[1], "--within", area, "--json", "-o", &*out];
        let told = mindeg([&first[..], more].concat()).json();
        assert_eq!(told["violations"], json!([]));
        let inspected = mindeg(["inspect", &out, "--json"]).json();
        let angle = told["min_angle"].as_f64().expect("an angle");
        let loops = inspected["boundary_loops"].as_u64();
        (told["joined"].as_u64().expect("a count"), loops.expect("a count"), angle)
    };
    let around = put("around.wkt", "POLYGON ((2.5 2.5, 9.5 2.5, 9.5 9.5, 2.5 9.5))");
    let both = [mesh("frame.json", &frame, &[]), mesh("core.json", &core, &[])];
    let (joined, loops, angle) = stitched([&both[0], &both[1]], &around, &[]);
    assert!((joined, loops) == (48, 1) && angle > 35.0, "{joined} {loops} {angle}");

    let [ocean, river, _] = meshes(folder.path(), RIVER);
    let island = DELTA.replace("))", "), (11.4 4.9, 11.4 5.2, 11.7 5.1))");
    let (joined, loops, angle) = stitched([&ocean, &river], &put("island.wkt", &island), &[]);
    assert!((joined, loops) == (5, 2) && angle > 28.0, "{joined} {loops} {angle}");

    let geojson = |ring: &str| format!(r#"{{"type": "Polygon", "coordinates": [[{ring}]]}}"#);
    let auto = ["--project", "auto"];
    let of = |name: &str, ring: &str, size: &str| {
        mesh(name, &geojson(ring), &[&auto[..], &["--size", size]].concat())
    };
    let west = of(
        "west.geojson",
        "[24, 37], [24.3, 37], [24.3, 37.1], [24.3, 37.2], [24.3, 37.3], [24, 37.3]",
        "3km",
    );
    let east =
        of("east.geojson", "[24.4, 37.11], [24.7, 37.11], [24.7, 37.19], [24.4, 37.19]", "2km");
    let area = geojson("[24.29, 37.08], [24.41, 37.105], [24.41, 37.195], [24.29, 37.22]");
    let (joined, loops, angle) = stitched([&west, &east], &put("area.geojson", &area), &auto);
    assert!((joined, loops) == (5, 1) && angle > 32.0, "{joined} {loops} {angle}");
}

#[test]
fn fans_of_the_given_meshes_count() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name).display().to_string();
    // The middle of a straight boundary has 6 edges already: one more makes it 7, and two triangles fill its half-plane.
    let fan =
        [[0.0, 0.0], [0.0, 1.0], [-0.6, 0.8], [-1.0, 0.3], [-1.0, -0.3], [-0.6, -0.8], [0.0, -1.0]];
    let ends = [[0.0, 2.0], [0.0, -2.0]];
    let triangles = [[1, 2, 3], [1, 3, 4], [1, 4, 5], [1, 5, 6], [1, 6, 7], [2, 8, 3], [7, 6, 9]];
    for (name, turn) in [("west.obj", 1.0), ("east.obj", -1.0)] {
        let points = fan.iter().chain(&ends).map(|[x, y]| [turn * (x - 2.0), turn * y]);
        let mut text: String = points.map(|[x, y]| format!("v {x} {y} 0\n")).collect();
        text.extend(triangles.map(|[a, b, c]| format!("f {a} {b} {c}\n")));
        fs::write(path(name), text).expect("a file");
    }
    fs::write(path("gap.wkt"), "POLYGON ((-2.2 -1.5, 2.2 -1.5, 2.2 1.5, -2.2 1.5))")
        .expect("a file");
    let out = path("both.14");
    let run =
        [&path("west.obj"), &path("east.obj"), "--within", &path("gap.wkt"), "--json", "-o", &out];
    let told = mindeg([&["stitch"], &run[..]].concat()).json();
    assert_eq!((&told["joined"], &told["violations"]), (&json!(2), &json!([])));
    let [_, elements] = lists(&out);
    let around = |node: f64| elements.iter().filter(|element| element[1..].contains(&node)).count();
    assert_eq!([around(1.0), around(10.0)], [7, 7]);
}
