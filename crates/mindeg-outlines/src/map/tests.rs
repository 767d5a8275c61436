use std::collections::{BTreeMap, BTreeSet};

use proptest::prelude::*;

use super::*;
use crate::curve::{PieceCurve, Segment};
use crate::{OutlineFormat, Outlines, labelled, read};

fn outlines(wkt: &str) -> Outlines {
    let alone = |_: &str| Err(std::io::ErrorKind::NotFound.into());
    read(wkt.as_bytes(), OutlineFormat::Wkt, alone).unwrap()
}

/// The polygons of a text in WKT.
fn polygons(wkt: &str) -> Vec<Polygon> {
    labelled(outlines(wkt).features)
}

/// The maps of polygons in WKT.
fn of_wkt(wkt: &str, size: Option<f64>) -> Result<Vec<Domain>, String> {
    let polygons = polygons(wkt);
    let division = Division { size, ..Division::default() };
    maps(&polygons, &DrawnInside::default(), &division, false)
        .map(|found| found.0)
        .map_err(|error| error.to_string())
}

/// The points of each line.
fn lines(domain: &Domain) -> Vec<Vec<[f64; 2]>> {
    let boundary = domain.boundary().unwrap();
    let at = |vertex: u32| boundary.point(vertex).to_array();
    (0..boundary.line_count())
        .map(|line| {
            let edges = boundary.line(line);
            [at(edges[0][0])].into_iter().chain(edges.iter().map(|edge| at(edge[1]))).collect()
        })
        .collect()
}

#[test]
fn regions_that_share_edges_are_one_domain() {
    // Two squares side by side, of opposite directions, with a bend in their border; and one that touches at a corner.
    let wkt = "POLYGON((0 0, 2 0, 2.1 1, 2 2, 0 2)) POLYGON((4 2, 4 0, 2 0, 2.1 1, 2 2))
               POLYGON((4 2, 5 2, 5 3, 4 3))";
    let [map, alone] = &of_wkt(wkt, None).unwrap()[..] else { panic!("two domains") };
    assert_eq!(lines(map), [[[2.0, 0.0], [2.1, 1.0], [2.0, 2.0]]]);
    assert_eq!(map.rings().vertex_count(), 6);
    let names: Vec<String> = (0..2).map(|face| map.region_name(face)).collect();
    assert_eq!(names, ["polygon 1", "polygon 2"]);
    assert_eq!(map.inner_lines()[0].0.name, "polygon 1 | polygon 2");
    let first = |domain: &Domain| domain.sides()[0].name.clone().unwrap();
    assert_eq!(first(map), "polygon 1 | outside");
    assert_eq!(
        (first(alone).as_str(), alone.region_name(0).as_str()),
        ("polygon 3 | outside", "polygon 3")
    );
    // Divided anew, the border has the same points on both sides and keeps its ends.
    let divided = of_wkt(wkt, Some(0.5)).unwrap();
    assert_eq!(lines(&divided[0])[0].len(), 5);
    assert_eq!(divided[0].divisible_segments(), [false; 4]);
}

#[test]
fn a_region_that_fills_the_hole_of_another_has_a_closed_line() {
    let wkt = "POLYGON((0 0, 9 0, 9 9, 0 9), (3 3, 6 3, 6 6, 3 6), (1 1, 2 1, 2 2)) POLYGON((3 3, 6 3, 6 6, 3 6))
               POLYGON((1.6 1.2, 1.8 1.2, 1.8 1.4))";
    let [map, island] = &of_wkt(wkt, None).unwrap()[..] else { panic!("two domains") };
    assert_eq!(lines(map).iter().map(Vec::len).collect::<Vec<_>>(), [5]);
    assert_eq!((map.faces().unwrap().count, map.rings().ring_count()), (2, 2));
    assert_eq!(island.rings().vertex_count(), 3);
}

#[test]
fn a_polygon_that_touches_itself_from_outside_is_two_domains() {
    let wkt = "POLYGON((0 0, 2 1, 4 0, 4 2, 2 1, 0 2)) POLYGON((0 2, 2 1, 4 2, 2 3))";
    let [map] = &of_wkt(wkt, None).unwrap()[..] else { panic!("one domain") };
    assert_eq!(map.faces().unwrap().count, 3);
    let alone = of_wkt("POLYGON((0 0, 2 1, 4 0, 4 2, 2 1, 0 2))", None).unwrap();
    assert_eq!(alone.iter().map(|it| it.rings().vertex_count()).collect::<Vec<_>>(), [3, 3]);
}

#[test]
fn faults_name_both_regions_and_the_place() {
    for (wkt, message) in [
        (
            "POLYGON((0 0, 4 0, 4 4, 0 4)) POLYGON((2 2, 6 2, 6 6, 2 6))",
            "(4, 2): a border of polygon 1 meets one of polygon 2 there",
        ),
        (
            "POLYGON((0 0, 4 0, 4 4, 0 4)) POLYGON((1 1, 2 1, 2 2))",
            "the edge from (1, 1) to (2, 1): polygon 2 and polygon 1 overlap there",
        ),
        (
            "POLYGON((0 0, 4 0, 4 4, 0 4)) POLYGON((0 0, 4 0, 4 4, 0 4))",
            "the edge from (0, 0) to (4, 0): polygon 1 and polygon 2 overlap there",
        ),
        (
            "POLYGON((0 0, 4 0, 4 4, 0 4)) POLYGON((4 1, 6 1, 6 3, 4 3))",
            "(4, 1): a border of polygon 1 meets one of polygon 2 there",
        ),
        (
            "POLYGON((0 0, 4 0, 4 4, 0 4), (5 5, 6 5, 6 6))",
            "the edge from (5, 5) to (6, 5): a hole of polygon 1 lies outside it",
        ),
        (
            "POLYGON((0 0, 4 0, 9 1, 4 0, 4 4))",
            "the edge from (9, 1) to (4, 0): polygon 1 runs along it twice",
        ),
        (
            "POLYGON((0 0, 4 0, 2 4)) POLYGON((0 0, 2 -4, 4 0, 2 -0.001))",
            "(4, 0): a gap 0.0005 wide and 4 long is between polygon 1 and polygon 2; --repair --snap 0.001 closes",
        ),
        // Open at both ends; and at one.
        (
            "POLYGON((0 0, 4 0, 4 4, 0 4)) POLYGON((4.0005 1, 8 0, 8 4, 4.0005 5))",
            "(4, 4): a gap 0.0005 wide and 3 long is between polygon 1 and polygon 2; --repair --snap 0.001 closes",
        ),
        (
            "POLYGON((0 0, 4 0, 4 4, 0 4)) POLYGON((4 0, 8 0, 8 4, 4.0005 2))",
            "(4, 0): a gap 0.0005 wide and 2 long is between polygon 1 and polygon 2; --repair --snap 0.001 closes",
        ),
    ] {
        let error = of_wkt(wkt, None).unwrap_err();
        assert!(error.starts_with(message), "{wkt}: {error}");
    }
}

#[test]
fn curved_borders_are_the_same_from_both_sides() {
    // A disk in a square, whose border is given once with either region on its left.
    let drawn = |text: &str| {
        let alone = |_: &str| Err(std::io::ErrorKind::NotFound.into());
        read(text.as_bytes(), OutlineFormat::Svg, alone).unwrap().features
    };
    let mut features =
        drawn("<svg><path d='M0 0h9v9h-9zM2 4a2 2 0 0 0 4 0a2 2 0 0 0 -4 0'/></svg>");
    features.extend(drawn("<svg><path d='M6 4a2 2 0 0 1 -4 0a2 2 0 0 1 4 0'/></svg>"));
    let found = maps(&labelled(features), &DrawnInside::default(), &Division::default(), false);
    let (found, _) = found.unwrap();
    assert_eq!((found.len(), found[0].faces().unwrap().count), (1, 2));
    assert_eq!(lines(&found[0])[0].len(), 25);
}

/// The cells of a grid as regions: the labels of the cells, and the borders between cells that differ.
fn borders_of(cells: &[Vec<Option<u32>>]) -> Vec<Border> {
    let size = cells.len() as i32;
    let at = |x: i32, y: i32| {
        let inside = (0..size).contains(&x) && (0..size).contains(&y);
        if inside { cells[y as usize][x as usize] } else { None }
    };
    let mut borders = Vec::new();
    let mut add = |start: [i32; 2], end: [i32; 2], left: Option<u32>, right: Option<u32>| {
        if left != right {
            let [start, end] = [start, end].map(|[x, y]| DVec2::new(x.into(), y.into()));
            let segment = Segment { start, end, curve: PieceCurve::Line };
            borders.push(Border { segment, side: None, begins_side: false, beside: [left, right] });
        }
    };
    for y in 0..=size {
        for x in 0..=size {
            add([x, y], [x + 1, y], at(x, y), at(x, y - 1));
            add([x, y], [x, y + 1], at(x - 1, y), at(x, y));
        }
    }
    borders
}

/// The sets of cells that hang together over edges, where `joins` says so.
fn sets(
    cells: &[Vec<Option<u32>>],
    joins: impl Fn(u32, u32) -> bool,
) -> Vec<BTreeSet<(usize, usize)>> {
    let size = cells.len();
    let mut left: BTreeSet<(usize, usize)> = (0..size)
        .flat_map(|x| (0..size).map(move |y| (x, y)))
        .filter(|&(x, y)| cells[y][x].is_some())
        .collect();
    let mut sets = Vec::new();
    while let Some(first) = left.pop_first() {
        let (mut set, mut open) = (BTreeSet::from([first]), vec![first]);
        while let Some((x, y)) = open.pop() {
            let around = [(x + 1, y), (x.wrapping_sub(1), y), (x, y + 1), (x, y.wrapping_sub(1))];
            for next in around {
                let label = |(x, y): (usize, usize)| cells[y][x].unwrap();
                if left.contains(&next) && joins(label((x, y)), label(next)) {
                    left.remove(&next);
                    set.insert(next);
                    open.push(next);
                }
            }
        }
        sets.push(set);
    }
    sets
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    /// Domains, faces and areas are those of the cells, however regions lie in each other.
    #[test]
    fn cells_of_a_grid_become_their_maps(
        cells in (2..6_usize).prop_flat_map(|size| {
            let row = prop::collection::vec(prop::option::weighted(0.8, 0..3_u32), size);
            prop::collection::vec(row, size)
        }),
    ) {
        let names = ["a", "b", "c"].map(str::to_owned);
        let found = domains(&borders_of(&cells), (&names, &[]), &[], &Division::default());
        let components = sets(&cells, |_, _| true);
        let faces = sets(&cells, |one, other| one == other);
        let found = found.map_err(|error| TestCaseError::fail(format!("{error} {cells:?}")))?.0;
        prop_assert_eq!(found.len(), components.len(), "{:?}", cells);
        let mut of_label: BTreeMap<String, usize> = BTreeMap::new();
        for domain in &found {
            let regions = &domain.inside().regions;
            let (holes, regions): (Vec<_>, Vec<_>) = regions.iter().partition(|region| region.hole);
            let count = domain.faces().map_or(1, |faces| faces.count) - holes.len();
            let first = regions[0].at;
            let cell = (first.x.floor() as usize, first.y.floor() as usize);
            let own = components.iter().find(|set| set.contains(&cell)).unwrap();
            // A hole that is a face has all cells inside it, those of another map too that only touches this one.
            let other = |x: usize, y: usize| (!own.contains(&(x, y))).then_some(0);
            let size = 0..cells.len();
            let others: Vec<Vec<_>> =
                size.clone().map(|y| size.clone().map(|x| other(x, y)).collect()).collect();
            let others = sets(&others, |_, _| true);
            let cells_of = |hole: &&Region| {
                let cell = hole.at.floor().to_array().map(|it| it as usize);
                others.iter().find(|set| set.contains(&cell.into())).unwrap().len()
            };
            let area = own.len() + holes.iter().map(cells_of).sum::<usize>();
            prop_assert_eq!(domain.placement().area(), area as f64, "{:?}", cells);
            prop_assert_eq!(count, faces.iter().filter(|face| face.is_subset(own)).count());
            prop_assert_eq!(count, regions.len());
            for region in regions {
                let [x, y] = region.at.floor().to_array().map(|it| it as usize);
                prop_assert_eq!(Some(names[cells[y][x].unwrap() as usize].clone()), region.name.clone());
                *of_label.entry(region.name.clone().unwrap()).or_default() += 1;
            }
        }
        prop_assert_eq!(of_label.values().sum::<usize>(), faces.len());
    }
}

/// The maps of polygons in WKT after their repair, with its note.
fn repaired(wkt: &str, snap: Option<f64>) -> (Vec<Domain>, String) {
    let alone = |_: &str| Err(std::io::ErrorKind::NotFound.into());
    let outlines = read(wkt.as_bytes(), OutlineFormat::Wkt, alone).unwrap();
    let mut outlines = outlines.repaired_together(None, snap).unwrap();
    let note = outlines.notes.remove(0);
    let inside = DrawnInside::default();
    let found = maps(&labelled(outlines.features), &inside, &Division::default(), true);
    (found.unwrap_or_else(|error| panic!("{wkt}: {error}")).0, note)
}

/// Twice the area of each region of the domains, exactly for small whole numbers: by the triangles to the origin.
fn doubled_areas(domains: &[Domain]) -> BTreeMap<String, f64> {
    let mut areas = BTreeMap::new();
    for domain in domains {
        let (boundary, faces) = (domain.boundary().unwrap(), domain.faces().unwrap());
        for (edge, beside) in (0..).zip(&faces.beside) {
            let [a, b] = boundary.ends(edge).map(|end| boundary.point(end));
            for (face, sign) in beside.iter().zip([1.0, -1.0]) {
                if let Some(face) = face.filter(|&face| !domain.is_hole(face)) {
                    *areas.entry(domain.region_name(face)).or_default() += sign * a.perp_dot(b);
                }
            }
        }
    }
    areas
}

#[test]
fn a_repair_keeps_borders_shared() {
    // The second overlaps the first by a strip, the third leaves a gap to the second and lacks its point.
    let wkt = "POLYGON((0 0, 4 0, 4 4, 0 4)) POLYGON((3 0, 8 0, 8 2, 8 4, 3 4))
               POLYGON((8.001 0, 9 0, 9 4, 8.001 4))";
    let (domains, note) = repaired(wkt, Some(0.01));
    let [map] = &domains[..] else { panic!("{domains:?}") };
    let areas: Vec<f64> = doubled_areas(&domains).into_values().collect();
    assert_eq!(areas, [32.0, 32.0, 8.0]);
    assert_eq!(lines(map).len(), 2);
    for words in ["points nearer than 0.01 as one", "moved 2 points by 0.001", "an area of 4,"] {
        assert!(note.contains(words), "{note}");
    }
    // Without a distance the gap stays.
    let (domains, _) = repaired(wkt, None);
    assert_eq!(domains.len(), 2);
    // A street of some width is none.
    assert_eq!(
        of_wkt("POLYGON((0 0, 4 0, 4 4, 0 4)) POLYGON((4.005 0, 8 0, 8 4, 4.005 4))", None)
            .unwrap()
            .len(),
        2
    );
    let (_, note) = repaired("POLYGON((0 0, 4 0, 4 4)) POLYGON((4 0, 8 0, 4 4))", None);
    assert!(note.ends_with("nothing to do"), "{note}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    /// Rectangles laid over each other in order: each keeps the cells that none before it covers.
    #[test]
    fn overlaps_go_to_the_first(
        rectangles in prop::collection::vec((0..6_i32, 0..6_i32, 1..4_i32, 1..4_i32), 1..7),
    ) {
        let mut owners = vec![vec![None; 10]; 10];
        let mut wkt = String::new();
        for (index, &(x, y, width, height)) in (0_u32..).zip(&rectangles) {
            let (right, top) = (x + width, y + height);
            wkt += &format!("POLYGON(({x} {y}, {right} {y}, {right} {top}, {x} {top})) ");
            for (row, cells) in owners.iter_mut().enumerate() {
                for (column, owner) in cells.iter_mut().enumerate() {
                    let is_inside = (x..right).contains(&(column as i32)) && (y..top).contains(&(row as i32));
                    *owner = owner.or(is_inside.then_some(index));
                }
            }
        }
        let (domains, _) = repaired(&wkt, None);
        let components = sets(&owners, |_, _| true);
        prop_assert_eq!(domains.len(), components.len(), "{}", wkt);
        let cells = owners.iter().flatten().flatten().count();
        let areas = doubled_areas(&domains);
        prop_assert_eq!(areas.values().sum::<f64>(), 2.0 * cells as f64, "{}", wkt);
    }
}

#[test]
fn holes_that_touch_are_regions_without_triangles() {
    // A hole at a corner of the outline, one that touches it, and one apart.
    let wkt = "POLYGON((0 0,8 0,8 8,0 8),(0 0,2 1,1 2),(2 1,3 2,3 1),(5 5,6 5,6 6))";
    let [polygon] = &polygons(wkt)[..] else { panic!("one polygon") };
    let domain = polygon.domain(&Division::default()).unwrap();
    assert_eq!(domain.area(), 64.0 - 1.5 - 0.5 - 0.5);
    assert_eq!((domain.rings().ring_count(), domain.inside().lines.len()), (3, 1));
    assert!(domain.sides().iter().all(|side| side.name.is_none()));
    // A hole, whether it touches or not.
    let lines = domain.inner_lines();
    assert_eq!(lines.iter().map(|(line, _)| &*line.name).collect::<Vec<_>>(), ["hole 3"]);
}

#[test]
fn rings_that_touch_and_part_a_polygon_are_named() {
    // The hole touches the outline twice.
    let wkt = "POLYGON((0 0,8 0,8 8,0 8),(0 0,4 3,8 8,3 4))";
    let error = polygons(wkt)[0].domain(&Division::default()).unwrap_err();
    assert!(error.is_touch, "{error}");
    let words = "rings touch, as at (0, 0), so that it falls into 2 parts";
    assert!(error.to_string().ends_with(words), "{error}");
}

#[test]
fn a_line_along_another_edge_is_refused_with_the_place_and_dropped_by_a_repair() {
    for line in ["LINESTRING(4 0,4 4)", "LINESTRING(1 1,2 1) LINESTRING(2 1,1 1)"] {
        let wkt = format!("POLYGON((0 0,4 0,4 4,0 4)) POLYGON((4 0,8 0,8 4,4 4)) {line}");
        let outlines = outlines(&wkt);
        let mapped = |outlines: Outlines| {
            let polygons = labelled(outlines.features);
            maps(&polygons, &outlines.inside, &Division::default(), false).map(|found| found.0)
        };
        let error = mapped(outlines.clone()).unwrap_err();
        assert!(error.is_touch && error.to_string().contains("runs along another one"), "{error}");
        for repaired in [outlines.clone().repaired(None), outlines.repaired_together(None, None)] {
            assert_eq!(mapped(repaired.unwrap()).unwrap().len(), 1);
        }
    }
}

/// The point of an island in a lake was taken for one in the lake.
#[test]
fn points_belong_to_the_island_that_they_are_on() {
    let wkt = "POLYGON((0 0,9 0,9 9,0 9),(2 2,2 7,7 7,7 2)) POLYGON((4 4,5 4,5 5,4 5)) \
               MULTIPOINT(4.5 4.5, 1 1, 5 5) LINESTRING(4.2 4.2,4.4 4.2)";
    let outlines = outlines(wkt);
    let polygons = labelled(outlines.features);
    let (maps, _) = maps(&polygons, &outlines.inside, &Division::default(), false).unwrap();
    let counts = |map: &Domain| (map.inside().points.len(), map.inside().lines.len());
    assert!(maps.iter().map(counts).eq([(1, 0), (2, 1)]));
}

/// A ring of lines took the region's name from what it encloses.
#[test]
fn what_lines_enclose_has_the_name_of_its_region() {
    let squares = "POLYGON((0 0,4 0,4 4,0 4)) POLYGON((4 0,8 0,8 4,4 4))";
    let closed = "LINESTRING(1 1,3 1,3 3,1 3,1 1)";
    let at_a_border = "LINESTRING(4 4,3 3,2 3.5,4 4)";
    for line in [closed, at_a_border] {
        let outlines = outlines(&format!("{squares} {line}"));
        let polygons = labelled(outlines.features);
        let (maps, notes) = maps(&polygons, &outlines.inside, &Division::default(), false).unwrap();
        let names: Vec<_> = maps[0].inside().regions.iter().map(|own| own.name.clone()).collect();
        assert_eq!(
            names,
            ["polygon 1", "polygon 1", "polygon 2"].map(|name| Some(name.to_owned())),
            "{notes:?}"
        );
    }
}

/// The point made triangles without an angle where rounding parts it from the border, and was told to lie outside where it does not.
#[test]
fn what_lies_on_a_border_without_a_vertex_is_refused_with_the_place() {
    let squares = "POLYGON((0 0,1 0.1,1.4 1.4,0 2)) POLYGON((1 0.1,3 0,3 2,1.4 1.4))";
    let edge = "lies on the edge from (";
    // The end of the last line is on the border, bit for bit.
    for (inside, words) in [
        ("POINT(1.12 0.49)", edge),
        ("POINT(0 1)", edge),
        ("LINESTRING(1.12 0.49,0.5 0.5)", "has no"),
        ("LINESTRING(1.24 0.88,0.5 0.5)", "one of them has no point there"),
    ] {
        let outlines = outlines(&format!("{squares} {inside}"));
        let polygons = labelled(outlines.features);
        let error = maps(&polygons, &outlines.inside, &Division::default(), false).unwrap_err();
        assert!(error.is_touch, "{error}");
        assert!(error.to_string().contains(words), "{error}");
    }
}
