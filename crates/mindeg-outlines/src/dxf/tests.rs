use std::f64::consts::PI;

use glam::DVec2;

use super::super::curve::PieceCurve;
use super::super::outline::{DrawnInside, DrawnRing, Outlines};
use super::super::selection::Selection;
use super::super::sides::Division;
use crate::{labelled, maps};

/// A DXF whose entities are given as pairs in one line each, such as `LINE 10=0 20=0`.
fn dxf(entities: &str) -> String {
    let mut text =
        "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n"
            .to_owned();
    for line in entities.lines().map(str::trim).filter(|line| !line.is_empty()) {
        let (name, pairs) = line.split_once(' ').unwrap_or((line, ""));
        text += &format!("  0\n{name}\n");
        for pair in pairs.split(' ').filter(|pair| !pair.is_empty()) {
            text += &format!(" {}\n", pair.replace('=', "\n"));
        }
    }
    text + "0\nENDSEC\n0\nEOF\n"
}

fn read(entities: &str) -> Result<Outlines, String> {
    selected(entities, Selection::default())
}

fn selected(entities: &str, selection: Selection) -> Result<Outlines, String> {
    super::read(dxf(entities).as_bytes(), &selection).map_err(|error| error.to_string())
}

const UNIT: &str = "the drawing's unit ($INSUNITS) is millimeters; coordinates are kept";

#[test]
fn lines_in_any_order_form_rings() {
    let expected = [[0.0, 0.0], [4.0, 0.0], [4.0, 3.0]].map(DVec2::from);
    for entities in [
        "LINE 10=0 20=0 11=4 21=0\nLINE 10=4 20=3 11=0.000001 21=0\nLINE 10=4 20=3 11=4 21=0",
        "LWPOLYLINE 90=3 70=1 10=0 20=0 10=4 20=0 10=4 20=3",
        "LWPOLYLINE 90=4 10=0 20=0 10=4 20=0 10=4 20=3 10=0 20=0",
        "POLYLINE 70=1\nVERTEX 10=0 20=0\nVERTEX 10=4 20=0\nVERTEX 10=4 20=3\nSEQEND",
        "LWPOLYLINE 10=0 20=0 10=4 20=0\nLWPOLYLINE 10=0 20=0 10=4 20=3 10=4 20=0",
    ] {
        let outlines = read(entities).unwrap();
        assert_eq!(outlines.features.len(), 1);
        assert_eq!(outlines.features[0].rings, [DrawnRing::of_points(expected)], "{entities}");
        assert_eq!(outlines.notes, [UNIT]);
    }
}

#[test]
fn arcs_bulges_and_circles_stay_curves() {
    let length = |ring: &DrawnRing| ring.segments().map(|segment| segment.length()).sum::<f64>();
    for (entities, expected) in [
        ("CIRCLE 10=1 20=2 40=3", 6.0 * PI),
        ("ARC 10=0 20=0 40=1 50=90 51=270\nLINE 10=0 20=1 11=0 21=-1", PI + 2.0),
        ("LWPOLYLINE 70=1 10=0 20=0 42=1 10=2 20=0 42=1", 2.0 * PI),
        ("ARC 10=0 20=0 40=1 50=270 51=90 230=-1\nLINE 10=0 20=1 11=0 21=-1", PI + 2.0),
    ] {
        let outlines = read(entities).unwrap();
        let ring = &outlines.features[0].rings[0];
        assert!((length(ring) - expected).abs() < 1e-12, "{entities}");
        assert!(ring.is_curved());
    }
    // The mirrored half circle lies left of the line.
    let outlines =
        read("ARC 10=0 20=0 40=1 50=270 51=90 230=-1\nLINE 10=0 20=1 11=0 21=-1").unwrap();
    let points = outlines.features[0].rings[0].flattened();
    assert!(points.iter().all(|point| point.x < 1e-15), "{points:?}");
    let PieceCurve::Arc(arc) = outlines.features[0].rings[0].pieces[0].curve else { panic!() };
    assert_eq!(arc.center, DVec2::ZERO);
}

#[test]
fn an_extrusion_downwards_mirrors_x() {
    for (entities, middle) in [
        ("CIRCLE 10=5 20=2 40=1", DVec2::new(5.0, 2.0)),
        ("LWPOLYLINE 70=1 10=4 20=2 42=1 10=6 20=2 42=1", DVec2::new(5.0, 2.0)),
        ("LWPOLYLINE 70=1 10=4 20=1 10=6 20=1 10=6 20=3 10=4 20=3", DVec2::new(5.0, 2.0)),
    ] {
        let ring = |extrusion: &str| {
            read(&format!("{entities}{extrusion}")).unwrap().features[0].rings[0].clone()
        };
        let (plain, mirrored) = (ring(""), ring(" 230=-1"));
        assert!((plain.doubled_area() + mirrored.doubled_area()).abs() < 1e-12, "{entities}");
        for point in mirrored.flattened() {
            let from_middle = point - DVec2::new(-middle.x, middle.y);
            assert!(from_middle.length() < 1.5, "{entities}: {point}");
        }
    }
}

#[test]
fn layers_name_polygons_or_sides() {
    let outlines = read("CIRCLE 8=plate 10=0 20=0 40=9\nCIRCLE 8=plate 10=0 20=0 40=1").unwrap();
    assert_eq!(outlines.features[0].name.as_deref(), Some("plate"));
    assert_eq!(outlines.features[0].rings.len(), 2);
    let outlines = read("CIRCLE 8=plate 10=0 20=0 40=9\nCIRCLE 8=hole 10=0 20=0 40=1").unwrap();
    assert_eq!(outlines.features[0].name, None);
    assert_eq!(outlines.features[0].rings[1].pieces[0].side.as_deref(), Some("hole"));
    assert_eq!(read("CIRCLE 8=0 10=0 20=0 40=9").unwrap().features[0].name, None);
}

#[test]
fn what_is_left_out_is_said_and_errors_say_where() {
    let outlines =
        read("TEXT 1=a\nSPLINE\nCIRCLE 10=0 20=0 40=9\nLINE 10=0 20=0 11=1 21=1\nTEXT").unwrap();
    assert_eq!(
        outlines.notes,
        [
            UNIT,
            "left out an open line of 1 piece that ends at (0, 0)",
            "left out 1 SPLINE, 2 TEXTs"
        ]
    );
    // A polyline in space, a mesh, and the faces of a solid.
    for flags in [8, 16, 64] {
        let vertices = "VERTEX 10=0 20=0\nVERTEX 10=9 20=0\nVERTEX 10=0 20=9\nSEQEND";
        let polyline = format!("CIRCLE 10=0 20=0 40=9\nPOLYLINE 70={}\n{vertices}", flags + 1);
        let outlines = read(&polyline).unwrap();
        assert_eq!(outlines.features.len(), 1, "{flags}");
        assert_eq!(outlines.notes, [UNIT, "left out 1 POLYLINE"], "{flags}");
    }
    for (entities, message) in [
        ("SPLINE", "the section ENTITIES: no closed outline, only 1 SPLINE; explode blocks"),
        ("", "the section ENTITIES: no closed outline; explode blocks"),
        ("LINE 10=0 20=0 11=1", "line 15: the LINE has no group code 21"),
        ("LINE 10=0 20=a 11=1", "line 20: found \"a\", expected a finite number"),
        ("CIRCLE x=0", "line 17: found \"x\", expected a group code"),
        ("LINE 10=0 20=0 11=1 21=0", "the point (0, 0): no line closes"),
        ("LINE 10=-1e308 20=0 11=1e308 21=0", "the section ENTITIES: a coordinate is too large"),
    ] {
        let error = read(entities).unwrap_err();
        assert!(error.starts_with(message), "{entities}: {error}");
    }
    assert!(
        super::read(b"AutoCAD Binary DXF\r\n", &Selection::default())
            .unwrap_err()
            .to_string()
            .contains("ASCII")
    );
    assert!(
        super::read(b"0", &Selection::default()).unwrap_err().to_string().contains("within a pair")
    );
}

/// The unchanged file, and the file with entities before those of the plate.
fn plate_and(entities: &str) -> Outlines {
    read(&format!("{entities}\nLWPOLYLINE 8=A 70=1 10=0 20=0 10=4 20=0 10=4 20=3 10=0 20=3"))
        .unwrap()
}

#[test]
fn a_coordinate_of_minus_zero_is_zero() {
    for entities in [
        "LINE 10=0 20=0 11=1 21=0\nLINE 10=1 20=-0 11=0 21=1\nLINE 10=0 20=1 11=0 21=0",
        "LWPOLYLINE 70=1 10=10 20=-0.0 10=0 20=8 10=-5 20=0",
        "LWPOLYLINE 70=1 10=-0.0 20=0 10=1 20=0 10=0 20=1",
    ] {
        assert_eq!(read(entities).unwrap().features[0].rings[0].pieces.len(), 3, "{entities}");
    }
}

#[test]
fn entities_that_viewers_hide_are_no_holes() {
    for (entities, left_out) in [
        ("LWPOLYLINE 67=1 70=1 10=1 20=1 10=2 20=1 10=1 20=2", "1 LWPOLYLINE in paper space"),
        ("CIRCLE 60=1 10=2 20=1 40=0.5", "1 CIRCLE that cannot be seen"),
        (
            "POLYLINE 60=1 70=1\nVERTEX 10=1 20=1\nVERTEX 10=2 20=1\nVERTEX 10=1 20=2\nSEQEND",
            "1 POLYLINE that cannot be seen",
        ),
        // Nobody sees how it lies.
        ("CIRCLE 67=1 10=2 20=1 40=0.5 210=1 230=0", "1 CIRCLE in paper space"),
    ] {
        let outlines = plate_and(entities);
        assert_eq!(outlines.features[0].rings.len(), 1, "{entities}");
        assert_eq!(outlines.notes, [UNIT.to_owned(), format!("left out {left_out}")]);
    }
}

#[test]
fn entities_on_hidden_layers_are_left_out() {
    let plate = dxf(
        "LWPOLYLINE 8=A 70=1 10=0 20=0 10=4 20=0 10=4 20=3 10=0 20=3\nCIRCLE 8=Bore 10=2 20=1 40=0.5",
    );
    for (layer, rings) in [
        ("2\nBORE\n70\n0\n62\n-7", 1),
        ("2\nbore\n70\n1\n62\n7", 1),
        // Locked, and another layer.
        ("2\nbore\n70\n4\n62\n7", 2),
        ("2\nnotes\n70\n1\n62\n-7", 2),
    ] {
        let tables = format!(
            "0\nSECTION\n2\nTABLES\n0\nTABLE\n2\nLAYER\n70\n1\n0\nLAYER\n{layer}\n0\nENDTAB\n0\nENDSEC\n"
        );
        let outlines =
            super::read(format!("{tables}{plate}").as_bytes(), &Selection::default()).unwrap();
        assert_eq!(outlines.features[0].rings.len(), rings, "{layer}");
        let said = "left out 1 CIRCLE on layers that are off or frozen";
        assert_eq!(outlines.notes.iter().any(|note| note == said), rings == 1, "{layer}");
    }
}

#[test]
fn control_points_of_splines_are_no_points() {
    let vertices = "VERTEX 10=1 20=0 70=8\nVERTEX 10=1 20=1 70=8\nVERTEX 10=0 20=1 70=8\nVERTEX 10=0 20=0 70=8";
    let outlines =
        read(&format!("POLYLINE 66=1 70=5\nVERTEX 10=0.5 20=-5 70=16\n{vertices}\nSEQEND"))
            .unwrap();
    assert_eq!(outlines.features[0].rings[0].doubled_area(), 2.0);
    assert_eq!(outlines.notes, [UNIT, "left out 1 control point"]);
}

#[test]
fn tilted_entities_are_refused() {
    for entity in ["CIRCLE 10=5 20=0 40=1", "ARC 10=5 20=0 40=1 50=0 51=90", "LWPOLYLINE 10=5 20=0"]
    {
        let error = read(&format!("{entity} 210=1 220=0 230=0")).unwrap_err();
        let name = entity.split(' ').next().unwrap();
        let expected = format!(
            "line 15: the {name} lies in a tilted plane: its extrusion is (1.0, 0.0, 0.0), expected \
             (0, 0, 1) or (0, 0, -1); turn it into the xy plane, or delete it"
        );
        assert_eq!(error, expected);
    }
    // Rounding of a program, and a line, whose ends are points of the world.
    assert_eq!(
        plate_and("CIRCLE 10=2 20=1 40=0.5 210=1e-16 220=0 230=1").features[0].rings.len(),
        2
    );
    let lines =
        "LINE 10=0 20=0 11=1 21=0 210=1 230=0\nLINE 10=1 20=0 11=0 21=1\nLINE 10=0 20=1 11=0 21=0";
    assert_eq!(read(lines).unwrap().features.len(), 1);
}

#[test]
fn an_arc_all_the_way_round_is_a_circle() {
    for angles in ["50=0 51=360", "50=90 51=450", "50=30 51=30"] {
        let outlines = plate_and(&format!("ARC 10=2 20=1 40=0.5 {angles}"));
        let hole = &outlines.features[0].rings[1];
        assert_eq!(hole.pieces.len(), 1, "{angles}");
        assert!((hole.segment(0).length() - PI).abs() < 1e-12, "{angles}");
    }
}

#[test]
fn names_have_no_codes_that_terminals_obey() {
    let outlines = plate_and("X\u{1b}[31mRED\u{7}\u{202e} 8=a");
    assert_eq!(outlines.notes, [UNIT, "left out 1 X [31mRED"]);
}

/// A matrix with a fibre that has a bore, a plate beside it that shares a side but for rounding, a breakline and a gauge.
const LAYERS: &str = "LWPOLYLINE 8=matrix 70=1 10=0 20=0 10=4 20=0 10=4 20=4 10=0 20=4
    CIRCLE 8=fibre 10=2 20=2 40=1\nCIRCLE 8=Fibre 10=2 20=2 40=0.5
    LINE 8=plate 10=4 20=0 11=6 21=0\nLINE 8=plate 10=6 20=0 11=6 21=4\nLINE 8=plate 10=6 20=4 11=4.000001 21=4
    LINE 8=plate 10=4 20=4 11=4 21=0\nLINE 8=breakline 10=4.5 20=1 11=5 21=2\nPOINT 8=gauge 10=5 20=3\nPOINT 10=0.5 20=0.5";

#[test]
fn lines_inside_that_cross_are_noded_by_a_repair() {
    // Two lines cross each other, one ends on the plate's side without a point, one crosses the border of two regions.
    let drawn = "LWPOLYLINE 8=one 70=1 10=0 20=0 10=2 20=0 10=2 20=2 10=0 20=2
    LWPOLYLINE 8=two 70=1 10=2 20=0 10=4 20=0 10=4 20=2 10=2 20=2
    LINE 8=a 10=0.5 20=0.5 11=1.5 21=1.5\nLINE 8=b 10=0.5 20=1.5 11=1.5 21=0.5
    LINE 8=c 10=1.75 20=0.25 11=4 21=0.25";
    let by_layer = Selection { layer: None, name_by: Some("layer".to_owned()) };
    let drawn = selected(drawn, by_layer).unwrap();
    let mapped = |Outlines { features, inside, .. }: Outlines| {
        maps(&labelled(features), &inside, &Division::default(), true)
    };
    let error = mapped(drawn.clone()).unwrap_err();
    assert!(error.is_touch, "{error}");
    let repaired = drawn.repaired_together(None, None).unwrap();
    let said = repaired.notes.last().cloned().unwrap_or_default();
    // Both lines at their crossing, the border of both regions and the line there, and the outline.
    assert_eq!(said, "added 6 points where lines or points inside meet others or a ring");
    let (found, _) = mapped(repaired).unwrap();
    let [map] = &found[..] else { panic!("{found:?}") };
    let first = map.rings().vertex_count();
    let meets = |at: [f64; 2]| {
        let index = map.inner_points().iter().position(|point| point.to_array() == at).unwrap();
        let vertex = first + index as u32;
        map.inner_segments().iter().filter(|ends| ends.contains(&vertex)).count()
    };
    assert_eq!([meets([1.0, 1.0]), meets([2.0, 0.25])], [4, 4]);
    assert_eq!(map.faces().unwrap().count, 3);
}

#[test]
fn layers_are_the_regions_of_a_map() {
    let by_layer = Selection { layer: None, name_by: Some("layer".to_owned()) };
    let Outlines { features, inside, notes, .. } = selected(LAYERS, by_layer.clone()).unwrap();
    assert_eq!(notes, [UNIT]);
    let names: Vec<_> = features.iter().map(|feature| feature.name.as_deref().unwrap()).collect();
    assert_eq!(names, ["matrix", "fibre", "plate"]);
    let (found, _) = maps(&labelled(features), &inside, &Division::default(), false).unwrap();
    let [map] = &found[..] else { panic!("{found:?}") };
    // The bore is a hole of the fibre.
    assert_eq!((map.faces().unwrap().count, map.rings().ring_count()), (3, 2));
    let names: Vec<String> = (0..3).map(|face| map.region_name(face)).collect();
    assert_eq!(names, ["matrix", "fibre", "plate"]);
    let lines: Vec<String> = map.inner_lines().into_iter().map(|line| line.0.name).collect();
    assert_eq!(lines.len(), 3, "{lines:?}");
    for line in ["breakline", "matrix | fibre", "matrix | plate"] {
        assert!(lines.iter().any(|name| name == line), "{line}: {lines:?}");
    }
    assert_eq!(map.named_vertices().len(), 1);
    assert_eq!(map.inside().points.len(), 2);

    // One layer alone, in any case; and all without layers, as ever.
    let plate = Selection { layer: Some("PLATE".to_owned()), name_by: None };
    let Outlines { features, .. } = selected(LAYERS, plate).unwrap();
    assert_eq!(features.len(), 1);
    assert_eq!(features[0].name.as_deref(), Some("plate"));
    // A polygon in a hole of another layer's leaves that as it is.
    let nested = "CIRCLE 8=a 10=0 20=0 40=3\nCIRCLE 8=a 10=0 20=0 40=2\nCIRCLE 8=b 10=0 20=0 40=2\nCIRCLE 8=c 10=0 20=0 40=1";
    let Outlines { features, .. } = selected(nested, by_layer.clone()).unwrap();
    let rings: Vec<usize> = features.iter().map(|feature| feature.rings.len()).collect();
    assert_eq!(rings, [2, 2, 1]);
    let inside = DrawnInside::default();
    let (found, _) = maps(&labelled(features), &inside, &Division::default(), false).unwrap();
    assert_eq!(found[0].faces().unwrap().count, 3);

    let absent = Selection { layer: Some("steel".to_owned()), name_by: None };
    for (selection, message) in [
        (absent, "no layer is \"steel\"; the file has \"a\", \"b\", \"c\""),
        (
            Selection { layer: None, name_by: Some("use".to_owned()) },
            "a DXF has no property \"use\"; its polygons are named by layer",
        ),
    ] {
        assert_eq!(selected(nested, selection).unwrap_err(), message);
    }
    let open = selected("LINE 8=a 10=0 20=0 11=1 21=0", by_layer).unwrap_err();
    assert_eq!(open, "the section ENTITIES: no line closes; close the boundary");
}
