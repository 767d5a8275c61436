//! The domains in `assets/domains/`, which are what users run first.

use std::path::Path;

use mindeg::{BoundaryMesh, Domain, Goal, Progress};
use mindeg_core::{least_max_degree, verify};

/// Files in `assets/domains/`, the intervals of their sides, and the least maximum degree.
const DOMAINS: [(&str, &[u64], u32); 8] = [
    ("boundary-layer-channel", &[40, 16, 40, 16], 4),
    ("dominated-side", &[1000, 3, 5, 2], 114),
    ("figure-1", &[3, 3, 2, 2], 4),
    ("gusset", &[12, 14, 8], 5),
    ("slender-fin", &[100, 1, 100, 1], 4),
    ("survey-parcel", &[23, 15, 17, 19, 15], 5),
    ("unequal-hexagon", &[12, 3, 5, 9, 2, 7], 4),
    ("wing-panel", &[16, 20, 16, 20], 4),
];

/// The files whose domains are not convex or have sides that are not straight: vertices, holes.
const OTHERS: [(&str, u32, usize); 5] = [
    ("great-britain", 391, 0),
    ("half-round-cap", 36, 0),
    ("l-bracket", 71, 0),
    ("plate-with-holes", 140, 3),
    ("step-channel", 197, 0),
];

#[test]
fn every_other_example_domain_makes_its_mesh() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../assets/domains");
    for (name, vertices, holes) in OTHERS {
        let text = std::fs::read_to_string(folder.join(format!("{name}.json"))).unwrap();
        let domain = Domain::from_json(&text).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!(domain.name(), Some(name));
        assert_eq!(domain.rings().vertex_count(), vertices, "{name}");
        assert_eq!(domain.rings().ring_count(), 1 + holes, "{name}");
        assert!(!domain.was_reversed(), "{name}");

        let mesh = mindeg::mesh(&domain, Goal::LeastDegree, Progress::NONE).unwrap().mesh;
        assert_eq!(mesh.triangle_count(), vertices + 2 * holes as u32 - 2, "{name}");
        let area: f64 = mesh.qualities().map(|quality| quality.area).sum();
        assert!((area / domain.placement().area() - 1.0).abs() < 1e-9, "{name}: {area}");
    }
}

#[test]
fn every_example_domain_makes_its_mesh() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../assets/domains");
    let files = std::fs::read_dir(&folder).unwrap();
    let mut files: Vec<_> = files.map(|file| file.unwrap().file_name()).collect();
    files.sort();
    let names = DOMAINS.iter().map(|domain| domain.0).chain(OTHERS.iter().map(|domain| domain.0));
    let mut expected: Vec<String> = names.map(|name| format!("{name}.json")).collect();
    expected.sort();
    assert!(files.iter().map(|file| file.to_string_lossy()).eq(expected), "{files:?}");

    for (name, intervals, max_degree) in DOMAINS {
        let text = std::fs::read_to_string(folder.join(format!("{name}.json"))).unwrap();
        let domain = Domain::from_json(&text).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!(domain.name(), Some(name));
        assert!(!domain.was_reversed(), "{name}");
        assert!(domain.rings().sides().map(u64::from).eq(intervals.iter().copied()), "{name}");

        let mesh = BoundaryMesh::least_degree(&domain).unwrap();
        assert_eq!(mesh.max_degree(), max_degree, "{name}");
        assert_eq!(
            mesh.max_degree(),
            least_max_degree(domain.convex().unwrap().boundary()),
            "{name}"
        );
        assert_eq!(verify(intervals, mesh.triangles()).unwrap().max_degree, max_degree, "{name}");
        let area: f64 = mesh.qualities().map(|quality| quality.area).sum();
        assert!((area / domain.placement().area() - 1.0).abs() < 1e-9, "{name}: {area}");
    }
}
