use std::f64::consts::PI;

use glam::DVec2;

use super::super::curve::PieceCurve;
use super::super::outline::{DrawnRing, Outlines};

fn read(body: &str) -> Result<Outlines, String> {
    let text = format!("<svg xmlns='http://www.w3.org/2000/svg'>\n{body}\n</svg>");
    super::read(text.as_bytes()).map_err(|error| error.to_string())
}

/// The only ring of a drawing.
#[track_caller]
fn ring(body: &str) -> DrawnRing {
    let outlines = read(body).unwrap();
    assert_eq!((outlines.features.len(), &outlines.notes[..]), (1, &[][..]), "{body}");
    assert_eq!(outlines.features[0].rings.len(), 1, "{body}");
    outlines.features[0].rings[0].clone()
}

#[test]
fn straight_shapes_are_their_points_with_y_turned_up() {
    for body in [
        "<path d='M1 2H4V4h-3z'/>",
        "<path d='m1,2 3,0 0,2 -3,0 0,-2'/>",
        "<path d='M1 2L4 2 4 4 1 4'/>",
        "<polygon points='1,2 4,2 4,4 1,4'/>",
        "<polyline points='1 2 4 2 4 4 1 4 1 2' fill='none' stroke='red'/>",
        "<rect x='1' y='2' width='3' height='2'/>",
        "<g transform='translate(1 2)'><g><rect width='3' height='2' rx='0'/></g></g>",
        "<rect transform='matrix(1 0 0 1 1 2)' width='3px' height='2'/>",
        "<rect transform='translate(1,2) rotate(-90) rotate(90 0 0) scale(3, 2)' width='1' height='1'/>",
    ] {
        let points = [[1.0, -2.0], [4.0, -2.0], [4.0, -4.0], [1.0, -4.0]].map(DVec2::from);
        assert_eq!(ring(body), DrawnRing::of_points(points), "{body}");
    }
}

#[test]
fn shapes_turn() {
    let points = [[4.0, -2.0], [4.0, -4.0], [1.0, -4.0], [1.0, -2.0]].map(DVec2::from);
    for transform in ["rotate(90)", "rotate(-270)", "rotate(45) rotate(45)"] {
        let turned =
            ring(&format!("<rect transform='{transform}' x='2' y='-4' width='2' height='3'/>"));
        for (found, expected) in turned.flattened().iter().zip(points) {
            assert!(found.distance(expected) < 1e-12, "{transform}: {found}");
        }
        assert_eq!(turned.flattened().len(), 4);
    }
}

#[test]
fn curves_stay_curves() {
    let length = |ring: &DrawnRing| ring.segments().map(|segment| segment.length()).sum::<f64>();
    for (body, expected) in [
        ("<circle cx='5' cy='5' r='2'/>", 4.0 * PI),
        ("<ellipse rx='2' ry='2'/>", 4.0 * PI),
        ("<circle r='1' transform='scale(2)'/>", 4.0 * PI),
        ("<path d='M2 0a2 2 0 0 1-4 0a2,2 0 012,-2 2 2 0 01 2 2z'/>", 4.0 * PI),
        ("<rect width='6' height='4' rx='1'/>", 4.0 + 8.0 + 2.0 * PI),
        ("<rect width='16' height='14' rx='3'/>", 2.0 * 10.0 + 2.0 * 8.0 + 6.0 * PI),
        ("<rect width='6' height='4' rx='9' ry='1'/>", 2.0 * 2.0 + 13.364_893_220_555_3),
        // Two parabolas, one smooth after the other.
        ("<path d='M0 0Q1 1 2 0T4 0z'/>", 4.0 + 2.0 * 2.295_587_149_392_638),
    ] {
        let ring = ring(body);
        assert!((length(&ring) - expected).abs() < 1e-9, "{body}: {}", length(&ring));
    }
    // y is turned, so that what sweeps clockwise on the page runs counter-clockwise no more.
    assert!((ring("<circle r='1'/>").doubled_area() + 24.0 * (PI / 12.0).sin()).abs() < 1e-12);
    let smooth = ring("<path d='M0 0C0 1 1 1 1 0S2-1 2 0z'/>");
    let PieceCurve::Cubic([control, _]) = smooth.pieces[1].curve else { panic!("{smooth:?}") };
    assert_eq!(control, DVec2::new(1.0, 1.0));
}

#[test]
fn the_fill_rule_and_the_order_of_subpaths_make_holes() {
    let rings = |body: &str| {
        let outlines = read(body).unwrap();
        outlines.features.iter().map(|feature| feature.rings.len()).collect::<Vec<_>>()
    };
    let same = "M0 0h9v9h-9zM2 2h5v5h-5z";
    assert_eq!(rings(&format!("<path d='{same}' fill-rule='evenodd'/>")), [2]);
    assert_eq!(rings(&format!("<g style='fill-rule: evenodd'><path d='{same}'/></g>")), [2]);
    assert_eq!(rings(&format!("<path d='{same}'/>")), [1]);
    assert_eq!(rings("<path d='M0 0h9v9h-9zM2 2v5h5v-5zm1 1h1v1h-1zM20 0h1v1z'/>"), [2, 1, 1]);
}

#[test]
fn names_and_what_is_left_out_are_said() {
    let outlines = read(
        "<defs><rect width='1' height='1'/></defs><title>t</title>\
         <path id='a' d='M0 0h1v1z'/><path fill='none' d='M0 0h24v24z'/>\
         <path fill='none' stroke='#000' d='M0 0h1v1'/><path d='M0 0h1'/><use href='#a'/>\
         <g display='none'><path d='M0 0h1v1z'/></g><circle r='0'/><text>x</text>",
    )
    .unwrap();
    assert_eq!(outlines.features.len(), 1);
    assert_eq!(outlines.features[0].name.as_deref(), Some("a"));
    assert_eq!(
        outlines.notes,
        [
            "left out 1 <text>, 1 <use>, 1 hidden element, 1 line without area, 1 open line, 1 shape with neither fill nor stroke, 1 shape without extent"
        ]
    );
}

#[test]
fn points_that_are_given_are_kept_however_near() {
    // A coast of 20,000 units that ends 9 units from its start.
    let points = "0 0 20000 0 20000 20000 0 20000 0 9";
    for shape in ["<polygon points='P'/>", "<path d='M P Z'/>"] {
        let ring = ring(&shape.replace('P', points));
        assert_eq!(ring.pieces.len(), 5, "{shape}");
    }
}

#[test]
fn small_gaps_are_closed() {
    // 0.1 + 0.2 - 0.3 is not 0.
    let outlines = read("<path d='M0 0h.1h.2v1h-.3v-1z'/>").unwrap();
    assert_eq!(outlines.features[0].rings[0].pieces.len(), 5);
    assert_eq!(
        outlines.notes,
        ["closed 1 gap of less than 0.05% of the shape between the ends of closed paths"]
    );
    assert_eq!(ring("<path d='M0 0h.1h.2v1h-.29v-1z'/>").pieces.len(), 6);
}

#[test]
fn errors_say_where_and_what() {
    for (body, message) in [
        ("<path", "line 3: column 1: invalid name token"),
        ("<path d='M0 0 L x'/>", "line 2: <path>: path data: "),
        (
            "<g>\n<rect width='5%' height='1'/></g>",
            "line 3: <rect>: width=\"5%\" depends on something else; give a number",
        ),
        ("<rect width='a' height='1'/>", "line 2: <rect>: width: "),
        ("<g transform='turn(1)'/>", "line 2: <g>: transform: "),
        (
            "<path d='M0 0H1e308V1e308z' transform='scale(10)'/>",
            "line 2: <path>: a coordinate is too large for a 64-bit float",
        ),
        ("", "the whole drawing: no closed shape; convert text"),
        ("<text>x</text>", "the whole drawing: no closed shape, only 1 <text>; convert text"),
    ] {
        let error = read(body).unwrap_err();
        assert!(error.starts_with(message), "{body}: {error}");
    }
    let error = super::read(b"<html/>").unwrap_err().to_string();
    assert_eq!(error, "line 1: the root element is <html>, expected <svg>");
    let bomb = b"<!DOCTYPE svg [<!ENTITY a 'aaa'>]><svg/>";
    let error = super::read(bomb).unwrap_err().to_string();
    assert_eq!(
        error,
        "the document type: the file defines entities, which are not read; save it as plain SVG"
    );
}

/// The areas of all polygons, without their holes.
fn areas(body: &str) -> Vec<f64> {
    let area = |rings: &[DrawnRing]| {
        let of = |ring: &DrawnRing| ring.doubled_area().abs() / 2.0;
        2.0 * of(&rings[0]) - rings.iter().map(of).sum::<f64>()
    };
    read(body).unwrap().features.iter().map(|feature| area(&feature.rings)).collect()
}

#[test]
fn a_drawing_inside_is_fitted_into_its_box() {
    let square = "<rect width='10' height='10'/>";
    for (inner, corners) in [
        ("x='5' y='5' width='20' height='20' viewBox='0 0 10 10'", [[5.0, -5.0], [25.0, -25.0]]),
        ("x='5' y='5' width='20' height='10' viewBox='0 0 10 10'", [[10.0, -5.0], [20.0, -15.0]]),
        (
            "width='20' height='10' viewBox='0 0 10 10' preserveAspectRatio='xMaxYMid'",
            [[10.0, 0.0], [20.0, -10.0]],
        ),
        (
            "width='20' height='10' viewBox='0 0 10 10' preserveAspectRatio='none'",
            [[0.0, 0.0], [20.0, -10.0]],
        ),
        ("width='20' height='20' viewBox='-10 0 20 20'", [[10.0, 0.0], [20.0, -10.0]]),
        ("x='1' y='2' overflow='visible' width='4' height='4'", [[1.0, -2.0], [11.0, -12.0]]),
        // Shapes outside the box are not shown, unless `overflow` says so.
        ("x='1' y='2' width='4' height='5'", [[1.0, -2.0], [5.0, -7.0]]),
        (
            "width='20' height='10' viewBox='0 0 10 10' preserveAspectRatio='xMidYMin slice'",
            [[0.0, 0.0], [20.0, -10.0]],
        ),
        ("width='50%' height='5' viewBox='0 0 20 5'", [[0.0, 0.0], [10.0, -5.0]]),
    ] {
        let body = format!("<svg width='40' height='40'><svg {inner}>{square}</svg></svg>");
        let text = format!("<svg viewBox='0 0 40 40'>{body}</svg>");
        let outlines = super::read(text.as_bytes()).unwrap();
        let [low, high] = corners.map(DVec2::from);
        let points = outlines.features[0].rings[0].flattened();
        let found = points.iter().fold((points[0], points[0]), |(a, b), &p| (a.min(p), b.max(p)));
        assert_eq!(found, (low.min(high), low.max(high)), "{inner}");
    }
    let hidden = read(&format!("<svg width='0' height='5'>{square}</svg>{square}")).unwrap();
    assert_eq!((hidden.features.len(), &*hidden.notes[0]), (1, "left out 1 hidden element"));
    let error = read("<svg viewBox='0 0 1 1'><rect width='1' height='1'/></svg>").unwrap_err();
    assert_eq!(
        error,
        "line 2: <svg>: a drawing inside needs width and height, or a viewBox around it"
    );
}

#[test]
fn transforms_of_styles_and_their_origins_are_applied() {
    let of = |attributes: &str| {
        let text =
            format!("<svg viewBox='0 0 8 6'><rect width='4' height='2' {attributes}/></svg>");
        let outlines = super::read(text.as_bytes()).map_err(|error| error.to_string())?;
        let points = outlines.features[0].rings[0].flattened();
        let (low, high) =
            points.iter().fold((points[0], points[0]), |(a, b), &p| (a.min(p), b.max(p)));
        Ok::<_, String>([low.x, low.y, high.x, high.y])
    };
    for (attributes, expected) in [
        ("style='transform:scale(2)'", [0.0, -4.0, 8.0, 0.0]),
        ("style='transform: translate(1px, 2px) scale(.5,1)'", [1.0, -4.0, 3.0, -2.0]),
        (
            "style='transform: translateX(1px) translatey(2) scaleX(2) scaleY(3)'",
            [1.0, -8.0, 9.0, -2.0],
        ),
        ("style='transform: rotate(0.25turn)'", [-2.0, -4.0, 0.0, 0.0]),
        ("style='transform: matrix(1,0,0,1,3,4)'", [3.0, -6.0, 7.0, -4.0]),
        ("style='transform: none' transform='scale(9)'", [0.0, -2.0, 4.0, 0.0]),
        ("transform='scale(2)' transform-origin='4 2'", [-4.0, -2.0, 4.0, 2.0]),
        ("transform='scale(2)' transform-origin='center'", [-4.0, -1.0, 4.0, 3.0]),
        ("transform='scale(2)' style='transform-origin: 50% 0px'", [-4.0, -4.0, 4.0, 0.0]),
        ("transform-origin='center'", [0.0, -2.0, 4.0, 0.0]),
    ] {
        assert_eq!(of(attributes), Ok(expected), "{attributes}");
    }
    let skewed = of("style='transform: skew(45deg)'").unwrap();
    assert!((skewed[2] - 6.0).abs() < 1e-12);
    for (attributes, message) in [
        (
            "style='transform: translate(10%)'",
            "line 1: <rect>: transform: \"translate(10%)\" is not read;",
        ),
        (
            "style='transform: rotate3d(1,0,0,9deg)'",
            "line 1: <rect>: transform: \"rotate3d(1,0,0,9deg)\" is",
        ),
        (
            "style='rotate: 45deg'",
            "line 1: <rect>: rotate is not read; write it as transform=\"…\"",
        ),
        ("style='transform-box: fill-box'", "line 1: <rect>: transform-box is not read"),
        (
            "transform='scale(2)' transform-origin='2em 0'",
            "line 1: <rect>: transform-origin=\"2em 0\" depends on something else; give two numbers",
        ),
    ] {
        let error = of(attributes).unwrap_err();
        assert!(error.starts_with(message), "{error}");
    }
}

#[test]
fn clips_cut_what_viewers_do_not_show() {
    let square = "<rect width='10' height='10' clip-path='url(#c)'/>";
    for (clip, expected) in [
        ("<rect width='3' height='3'/>", &[9.0][..]),
        ("<rect width='3' height='3'/><rect x='7' width='9' height='1'/>", &[9.0, 3.0]),
        ("<path d='M0 0h4v4h-4zM1 1h2v2h-2z' clip-rule='evenodd'/>", &[12.0]),
        ("<path d='M0 0h4v4h-4zM1 1h2v2h-2z'/>", &[16.0]),
        ("<use href='#r' x='8'/>", &[4.0]),
        // Nothing to cut.
        ("<circle cx='5' cy='5' r='8'/>", &[100.0]),
    ] {
        let defs = "<defs><rect id='r' width='2' height='2'/></defs>";
        let body = format!("{defs}<clipPath id='c'>{clip}</clipPath>{square}");
        assert_eq!(areas(&body), expected, "{clip}");
    }
    let clip = "<clipPath id='c'><rect width='3' height='3'/></clipPath>";
    assert_eq!(
        areas(&format!("{clip}<g clip-path='url(#c)'><rect x='2' width='5' height='9'/></g>")),
        [3.0]
    );
    assert_eq!(
        areas(&format!(
            "{clip}<rect style='clip-path:url(#c)' transform='scale(2)' width='5' height='1'/>"
        )),
        [12.0]
    );
    assert_eq!(areas("<rect width='5' height='1' clip-path='url(#none)'/>"), [5.0]);
    let outlines =
        read(&format!("{clip}{square}<rect x='8' width='1' height='1' clip-path='url(#c)'/>"));
    let outlines = outlines.unwrap();
    assert_eq!(
        (outlines.features.len(), &outlines.notes[..]),
        (1, &["cut 2 shapes by clips".to_owned()][..])
    );
    for (clip, message) in [
        (
            "<clipPath id='c'><text>x</text></clipPath>",
            "line 2: <rect>: the clipPath \"c\" holds more than shapes; cut",
        ),
        (
            "<clipPath id='c' clipPathUnits='objectBoundingBox'/>",
            "line 2: <rect>: the clipPath \"c\" has units of the shape's box; cut the shape with it",
        ),
        (
            "<clipPath id='c'><rect clip-path='url(#c)' width='1' height='1'/></clipPath>",
            "line 2: <rect>: the clipPath \"c\" is cut itself",
        ),
    ] {
        let error = read(&format!("{clip}{square}")).unwrap_err();
        assert!(error.starts_with(message), "{error}");
    }
    let error = read("<rect width='1' height='1' style='clip-path: circle(1px)'/>").unwrap_err();
    assert_eq!(error, "line 2: <rect>: clip-path=\"circle(1px)\" is not read");
}

#[test]
fn what_viewers_do_not_show_is_left_out_and_said() {
    let square = "<rect width='1' height='1'/>";
    for (body, left_out) in [
        ("<mask id='m'/><g mask='url(#m)'>S</g>S", "1 masked element"),
        ("<g opacity='0'>S</g>S", "1 hidden element"),
        (
            "<g visibility='hidden'>S<rect width='1' height='1' visibility='visible'/></g>",
            "1 hidden element",
        ),
        ("<g fill-opacity='0'>S</g>S", "1 shape with neither fill nor stroke"),
        ("<g requiredExtensions='http://x'>S</g>S", "1 element for other programs or languages"),
        (
            "<g systemLanguage='de, fr'>S</g><g systemLanguage='de, en-GB'>S</g>",
            "1 element for other programs or languages",
        ),
    ] {
        let outlines = read(&body.replace('S', square)).unwrap();
        assert_eq!(outlines.features.len(), 1, "{body}");
        assert_eq!(outlines.notes, [format!("left out {left_out}")], "{body}");
    }
}

#[test]
fn a_switch_shows_its_first_child_that_applies() {
    for (children, area) in [
        ("<title>t</title><rect width='2' height='1'/><rect width='3' height='1'/>", 2.0),
        (
            "<foreignObject requiredExtensions='http://ns.adobe.com/x'/><g><rect width='3' height='1'/></g>",
            3.0,
        ),
        (
            "<rect systemLanguage='de' width='2' height='1'/><rect systemLanguage='en' width='4' height='1'/>",
            4.0,
        ),
    ] {
        assert_eq!(areas(&format!("<switch>{children}</switch>")), [area], "{children}");
    }
}

#[test]
fn lengths_in_a_style_are_lengths() {
    let expected = ring("<rect x='1' width='10' height='20'/>");
    for style in ["x:1px;width:10px;height:20px", "x: 1px; width: 3px; width: 10px; height: 20px"] {
        assert_eq!(ring(&format!("<rect width='9' style='{style}'/>")), expected, "{style}");
    }
    // Without a unit viewers take the attribute.
    assert_eq!(ring("<rect x='1' width='10' height='20' style='width:5'/>"), expected);
    assert!((ring("<circle style='r:2px'/>").doubled_area().abs() - 25.0).abs() < 0.2);
    for (body, said) in [
        ("<rect style='width:50%' height='1'/>", "width=\"50%\" depends on something else"),
        ("<path style='d:path(&quot;M0 0h1v1z&quot;)'/>", "d is not read; write it as d=\"…\""),
    ] {
        let error = read(body).unwrap_err();
        assert!(error.contains(said), "{body}: {error}");
    }
    let outlines = read("<rect width='1' height='1'/><rect width='5'/>").unwrap();
    assert_eq!(outlines.notes, ["left out 1 shape without extent"]);
}

#[test]
fn style_sheets_that_move_or_hide_shapes_are_refused() {
    let rect = "<rect class='a' width='1' height='1'/>";
    for (sheet, said) in [
        (".a{transform:scale(3)}", "\"transform: scale(3)\""),
        (".b{fill:red;/* display:none */display : none !important}", "\"display: none\""),
        ("@media print{rect{width:2px}}", "\"width: 2px\""),
        ("rect{fill-rule:evenodd}", "\"fill-rule: evenodd\""),
    ] {
        for body in [
            format!("<style>{sheet}</style>{rect}"),
            format!("<defs><style>{sheet}</style></defs>{rect}"),
        ] {
            let error = read(&body).unwrap_err();
            assert!(error.starts_with("line 2: <style>: the style sheet sets "), "{error}");
            assert!(error.contains(said), "{error}");
        }
    }
    let sheet = ".a{fill:none;stroke-width:2px;display:inline;transform:none} a:hover{fill:red}";
    let outlines = read(&format!("<style>{sheet}</style>{rect}")).unwrap();
    assert_eq!(
        (outlines.features.len(), &*outlines.notes),
        (1, &["left out 1 style sheet".to_owned()][..])
    );
}

#[test]
fn shapes_that_cross_themselves_are_shapes_whatever_their_area_with_signs() {
    let area = |body: &str| {
        let repaired = read(body).unwrap().repaired(None).unwrap();
        let of = |ring: &DrawnRing| ring.doubled_area().abs() / 2.0;
        let rings = repaired
            .features
            .iter()
            .map(|it| of(&it.rings[0]) - it.rings[1..].iter().map(of).sum::<f64>());
        rings.sum::<f64>()
    };
    let bow = "M0 0L4 4L4 0L0 4Z";
    for (body, expected) in [
        (format!("<path d='{bow}'/>"), 8.0),
        (format!("<path d='{bow}'/><path d='M10 0h4v4h-4z'/>"), 24.0),
    ] {
        assert!((area(&body) - expected).abs() < 1e-4, "{body}: {}", area(&body));
    }
    let error = read("<path d='M0 0L4 4L2 2Z'/>").unwrap_err();
    assert!(error.contains("only 1 line without area"), "{error}");
}
