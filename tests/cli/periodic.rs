//! Periodic sides, from a domain to files and back.

use crate::run::mindeg;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;
use tempfile::tempdir;

/// A rectangle that is a torus once it is joined; the sides that are moved have other divisions than uniform ones.
const TORUS: &str = r#"{"polygon": {"corners": [[0, 0], [4, 0], [4.25, 3], [0.25, 3]]}, "sides": [
    {"intervals": 9, "name": "bottom", "spacing": {"bump": {"ratio": 0.5}}},
    {"name": "right", "match": {"of": "left"}},
    {"name": "top", "match": {"of": "bottom"}},
    {"intervals": 7, "name": "left"}]}"#;

fn text(path: &Path) -> &str {
    path.to_str().expect("a path in ASCII")
}

/// The points and triangles of an OBJ.
fn mesh_of(obj: &str) -> (Vec<[f64; 2]>, Vec<[u32; 3]>) {
    let numbers = |line: &str| -> Vec<f64> {
        let words = line.split_whitespace().skip(1).map(|word| word.split('/').next());
        words.flatten().map(|word| word.parse().expect("a number")).collect()
    };
    let of = |start: &'static str| obj.lines().filter(move |line| line.starts_with(start));
    let points = of("v ").map(numbers).map(|own| [own[0], own[1]]).collect();
    let corner = |own: &f64| *own as u32 - 1;
    let triangles = of("f ").map(numbers);
    (points, triangles.map(|own| [corner(&own[0]), corner(&own[1]), corner(&own[2])]).collect())
}

/// The degrees of a mesh that is joined where points differ by a multiple of the torus' two moves; none of the vertices is on a
/// boundary then.
fn degrees_on_torus(points: &[[f64; 2]], triangles: &[[u32; 3]]) -> BTreeMap<[i64; 2], u32> {
    let key = |vertex: u32| {
        // The coordinates along both sides, of which whole ones are the same.
        let [x, y] = points[vertex as usize];
        let along = [(x - y / 12.0) / 4.0, y / 3.0];
        along.map(|share| ((share * 1e9).round() as i64).rem_euclid(1_000_000_000))
    };
    // Two edges between the same vertices are apart if they pass other triangles: count half-edges by triangle.
    let mut halves: BTreeMap<[i64; 2], u32> = BTreeMap::new();
    for vertex in triangles.as_flattened() {
        *halves.entry(key(*vertex)).or_default() += 1;
    }
    halves
}

#[test]
fn degrees_count_on_the_joined_mesh_and_points_match() {
    let folder = tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name);
    let (domain, mesh) = (at("torus.json"), at("torus.obj"));
    fs::write(&domain, TORUS).expect("a file");
    for (interior, inside) in [(&["--interior"][..], true), (&[][..], false)] {
        let run =
            mindeg([&["mesh", text(&domain), "-o", text(&mesh), "--json"], interior].concat());
        let made = run.json();
        let (points, triangles) = mesh_of(&fs::read_to_string(&mesh).expect("an OBJ"));
        let degrees = degrees_on_torus(&points, &triangles);
        // Every point of a moved side is the other, moved: with one rounding.
        let boundary = &points[..32];
        let moved =
            |from: usize, dx: f64, dy: f64| [boundary[from][0] + dx, boundary[from][1] + dy];
        assert!((1..7).all(|i| boundary[9 + i] == moved(32 - i, 4.0, 0.0)), "{boundary:?}");
        assert!((1..9).all(|i| boundary[16 + i] == moved(9 - i, 0.25, 3.0)), "{boundary:?}");
        let greatest = degrees.values().copied().max().expect("vertices");
        if inside {
            assert!(degrees.values().all(|degree| (5..=7).contains(degree)), "{degrees:?}");
            assert_eq!(made["violations"].as_array().map(Vec::len), Some(0), "{made}");
            // A closed surface of genus 1 has six edges at a vertex in the mean.
            assert_eq!(degrees.values().sum::<u32>() as usize, 6 * degrees.len());
        } else {
            assert_eq!(made["max_degree"], greatest, "{made}");
            let degree = mindeg(["degree", text(&domain), "--json"]).json();
            assert_eq!(degree["reached"], greatest);
            // One vertex of all corners, 8 and 6 of the sides, 6 edges each in the mean.
            assert_eq!(degrees.len(), 15);
            assert!(degree["at_least"].as_u64() >= Some(6), "{degree}");
        }
        let verified = mindeg(["verify", text(&mesh), text(&domain), "--json"]).json();
        assert_eq!(verified["max_degree"], greatest, "{verified}");
    }
}

/// The pairs of `$Periodic`, by curve.
fn pairs(msh: &str) -> BTreeSet<Vec<String>> {
    let (_, rest) = msh.split_once("$Periodic\n").expect("periodic curves");
    let (own, _) = rest.split_once("$EndPeriodic").expect("an end");
    own.lines().map(|line| line.split_whitespace().map(str::to_owned).collect()).collect()
}

#[test]
fn gmsh_files_keep_periodic_curves() {
    let folder = tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name);
    let domain = at("torus.json");
    fs::write(&domain, TORUS).expect("a file");
    for version in ["2.2", "4.1"] {
        let (mesh, again) = (at("torus.msh"), at("again.msh"));
        let options = ["--msh-version", version, "--ascii"];
        mindeg(
            [&["mesh", text(&domain), "--interior", "-q", "-o", text(&mesh)], &options[..]]
                .concat(),
        )
        .text();
        let written = fs::read_to_string(&mesh).expect("an MSH");
        let own = pairs(&written);
        // Corners of the right side are those of the left.
        assert!(own.contains(&vec!["10".to_owned(), "1".to_owned()]), "{own:?}");
        mindeg([&["convert", text(&mesh), "-q", "-o", text(&again)], &options[..]].concat()).text();
        let converted = fs::read_to_string(&again).expect("an MSH");
        assert_eq!(pairs(&converted), own);
        // A recipe adds a remark and takes nothing away.
        let told = at("told.msh");
        let recipe = ["mesh", text(&domain), "--interior", "--recipe", "-q", "-o", text(&told)];
        mindeg([&recipe[..], &options[..]].concat()).text();
        assert_eq!(pairs(&fs::read_to_string(&told).expect("an MSH")), own);
        // As an outline of its curves, with its points.
        let outline = at("outline.json");
        mindeg(["domain", text(&mesh), "-o", text(&outline)]).text();
        let read = fs::read_to_string(&outline).expect("a domain");
        assert_eq!(read.matches("\"match\"").count(), 2, "{read}");
    }
}

#[test]
fn sides_are_matched_by_an_option() {
    let rectangle = ["--rectangle", "4x3", "--size", "0.5"];
    let degree =
        |more: &[&str]| mindeg([&["degree", "--json"], &rectangle[..], more].concat()).json();
    let plain = degree(&[]);
    let joined = degree(&["--periodic", "side 2=side 4", "--periodic", "side 3=side 1"]);
    assert!(joined["reached"].as_u64() > plain["reached"].as_u64(), "{joined}");
    mindeg([&["degree"], &rectangle[..], &["--periodic", "right=side 4"]].concat())
        .refuses(&["no side is called \"right\"", "\"side 2\""]);
    mindeg([&["degree"], &rectangle[..], &["--periodic", "side 2=side 1"]].concat())
        .refuses(&["--periodic", "of one length"]);
}
