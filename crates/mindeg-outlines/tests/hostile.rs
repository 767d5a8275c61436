//! The readers of outlines on files that hold no outlines: they say why, and never panic.

use mindeg_outlines::{self as outlines, Division, OutlineFormat};
use proptest::prelude::*;

/// A small valid file of each format, and some that are almost.
const FILES: [(OutlineFormat, &str); 14] = [
    (
        OutlineFormat::GeoJson,
        r#"{"type":"FeatureCollection","features":[{"type":"Feature","id":3,"properties":{"name":"a"},"geometry":{"type":"MultiPolygon","coordinates":[[[[0,0],[4,0],[4,3],[0,0]],[[2,0.5],[3,0.5],[3,1]]],[[[9,9],[10,9],[9,10]]]]}}]}"#,
    ),
    (
        OutlineFormat::Wkt,
        "SRID=4326;POLYGON Z((0 0 1, 4 0 1, 4 3 1),(1 1 1,2 1 1,1 2 1))\nPOINT(1 2)",
    ),
    (
        OutlineFormat::Svg,
        "<svg xmlns='http://www.w3.org/2000/svg'><g transform='rotate(30) scale(2 -1)'><path id='p' d='M0 0h9v9c1 2 3 4-9 0zm2 2a1 1 0 0 1 2 0q-1 5 -2 0t1 1s1 2 3 4z' fill-rule='evenodd'/><rect width='4' height='3' rx='1'/><circle r='2mm'/><polygon points='0,0 1,0 1,1'/></g></svg>",
    ),
    (OutlineFormat::Csv, "x;y\n0;0\n4,5;0\n0;3\n\n1;1\n2;1\n1;2\n"),
    (OutlineFormat::Csv, "0 0\n4 0\n0 3\n"),
    (OutlineFormat::Obj, "v 0 0 0\nv 4 0 0\nv 4 3 0\no a\nl 1 2\no b\nl 2 3 -3\n"),
    (
        OutlineFormat::Msh,
        "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n1 5 \"in\"\n$EndPhysicalNames\n$Entities\n0 1 0 0\n7 0 0 0 1 1 0 1 -5 0\n$EndEntities\n$Nodes\n1 3 1 3\n1 7 0 3\n1\n2\n3\n0 0 0\n4 0 0\n0 3 0\n$EndNodes\n$Elements\n1 3 1 3\n1 7 1 3\n1 1 2\n2 2 3\n3 3 1\n$EndElements\n",
    ),
    (
        OutlineFormat::Msh,
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 0\n2 4 0 0\n3 0 3 0\n$EndNodes\n$Elements\n4\n9 15 2 0 1 1\n1 1 2 5 7 1 2\n2 1 2 5 8 2 3\n3 1 2 6 9 3 1\n$EndElements\n",
    ),
    (
        OutlineFormat::Poly,
        "7 2 0 1\n1 0 0 1\n2 4 0 1\n3 4 4 1\n4 0 4 1\n5 1 1 2\n6 2 1 2\n7 1 2 2\n7 1\n1 1 2 1\n2 2 3 9\n3 3 4 1\n4 4 1 1\n5 5 6 2\n6 6 7 2\n7 7 5 2\n1\n1 1.25 1.25\n",
    ),
    (
        OutlineFormat::Dxf,
        "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\na\n70\n1\n10\n0\n20\n0\n42\n0.5\n10\n4\n20\n0\n10\n4\n20\n3\n0\nCIRCLE\n8\nb\n10\n3\n20\n1\n40\n0.25\n0\nENDSEC\n0\nEOF\n",
    ),
    (
        OutlineFormat::Dxf,
        "0\nSECTION\n2\nENTITIES\n0\nPOLYLINE\n70\n1\n0\nVERTEX\n10\n0\n20\n0\n0\nVERTEX\n10\n1\n20\n0\n0\nVERTEX\n10\n0\n20\n1\n0\nSEQEND\n0\nARC\n10\n5\n20\n5\n40\n1\n50\n0\n51\n180\n0\nLINE\n10\n4\n20\n5\n11\n6\n21\n5\n0\nENDSEC\n0\nEOF\n",
    ),
    // Rings that touch themselves and each other, run to and fro, and cross.
    (OutlineFormat::Wkt, "POLYGON((0 0,2 0,1 2,3 2,2 0,4 0,4 4,0 4,0 6,0 4),(1 3,2 3,2 4,1 3))"),
    (OutlineFormat::Wkt, "POLYGON((0 0,4 4,4 0,0 4),(1 1,9 1,9 2))"),
    (OutlineFormat::Csv, "0 0\n4 0\n4 0\n2 0\n0 0\n0 0\n\n1 1\n\n2 2\n3 3\n"),
];

/// No file stands beside these.
fn alone(_: &str) -> std::io::Result<Vec<u8>> {
    Err(std::io::ErrorKind::NotFound.into())
}

/// Coordinates of -0, which CAD programs write, where others of the file are 0.
#[test]
fn minus_zero_is_zero_in_all_formats() {
    let dxf = "0\nSECTION\n2\nENTITIES\n0\nLINE\n10\n0\n20\n0\n11\n1\n21\n0\n0\nLINE\n10\n1\n20\n-0\n11\n-0.0\n21\n1\n0\nLINE\n10\n0\n20\n1\n11\n-0\n21\n-0\n0\nENDSEC\n";
    for (format, text) in [
        (
            OutlineFormat::GeoJson,
            r#"{"type":"Polygon","coordinates":[[[-0.0,0],[1,-0],[-0.0,1],[0,-0.0]]]}"#,
        ),
        (OutlineFormat::Wkt, "POLYGON((-0 0, 1 -0.0, 0 1, 0 -0))"),
        (OutlineFormat::Svg, "<svg><path d='M-0 0L1-0L-0 1L0 0'/></svg>"),
        (OutlineFormat::Csv, "-0 0\n1 -0.0\n0 1\n0 0\n"),
        (OutlineFormat::Obj, "v 0 -0 0\nv 1 0 -0\nv -0 1 0\nl 1 2 3 1\n"),
        (OutlineFormat::Poly, "3 2 0 0\n1 -0 0\n2 1 -0\n3 0 1\n3 0\n1 1 2\n2 2 3\n3 3 1\n"),
        (
            OutlineFormat::Msh,
            "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 -0 0 -0\n2 1 -0 0\n3 0 1 0\n$EndNodes\n$Elements\n3\n1 1 2 5 7 1 2\n2 1 2 5 7 2 3\n3 1 2 5 7 3 1\n$EndElements\n",
        ),
        (OutlineFormat::Dxf, dxf),
    ] {
        let outlines = outlines::read(text.as_bytes(), format, alone).unwrap();
        assert_eq!(outlines.features[0].rings[0].pieces.len(), 3, "{text}");
        assert!(outlines.features[0].domain(&Division::default()).is_ok(), "{text}");
    }
}

/// Reads, repairs and divides as the command line does, and ignores the result.
fn use_all(bytes: &[u8], format: OutlineFormat) {
    let Ok(outlines) = outlines::read(bytes, format, alone) else { return };
    // The amount that is read is proportional to the file.
    let rings = outlines.features.iter().flat_map(|feature| &feature.rings);
    let pieces: usize = rings.map(|ring| ring.pieces.len()).sum();
    assert!(pieces <= bytes.len(), "{pieces} pieces of {} bytes", bytes.len());
    let repaired = outlines.clone().repaired(None);
    for feature in outlines.features.iter().chain(repaired.iter().flat_map(|it| &it.features)) {
        let segments = feature.rings.iter().flat_map(|ring| ring.segments());
        let length: f64 = segments.map(|segment| segment.length()).sum();
        // A size far from that of the file, but not millions of points, which take their time.
        for size in [None, Some(length / 100.0), Some((length / 10_000.0).max(1e9))] {
            let _ = feature.domain(&Division { size, ..Division::default() });
        }
    }
}

#[test]
fn the_files_are_valid() {
    for (format, text) in FILES {
        let outlines = outlines::read(text.as_bytes(), format, alone).unwrap();
        assert!(!outlines.features.is_empty(), "{text}");
        assert_eq!(OutlineFormat::of_content(text.as_bytes()), Some(format), "{text}");
        use_all(text.as_bytes(), format);
    }
}

#[test]
fn files_that_end_anywhere_are_read_or_refused() {
    for (format, text) in FILES {
        for end in 0..text.len() {
            use_all(&text.as_bytes()[..end], format);
        }
    }
}

/// A change of a file: bytes at an offset replaced by others.
fn edit() -> impl Strategy<Value = (prop::sample::Index, usize, Vec<u8>)> {
    let words = prop::sample::select(vec![
        "",
        "-",
        ".",
        "0",
        "1e308",
        "-1e-308",
        "nan",
        "4294967296",
        "-9223372036854775808",
        "99999999999999999999",
        "(",
        ")",
        "[",
        "{",
        "\n",
        "\r\n",
        " ",
        "z",
        "M",
        "\u{e9}",
        "$",
        "\"",
        "<g>",
        "18446744073709551615",
    ]);
    let bytes = prop_oneof![
        4 => words.prop_map(|word| word.as_bytes().to_vec()),
        1 => prop::collection::vec(any::<u8>(), 0..4),
    ];
    (any::<prop::sample::Index>(), 0_usize..6, bytes)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    #[test]
    fn changed_files_are_read_or_refused(
        file in 0..FILES.len(),
        edits in prop::collection::vec(edit(), 1..5),
    ) {
        let (format, text) = FILES[file];
        let mut bytes = text.as_bytes().to_vec();
        for (at, length, word) in edits {
            let start = at.index(bytes.len() + 1);
            let end = (start + length).min(bytes.len());
            bytes.splice(start..end, word);
        }
        use_all(&bytes, format);
        let _ = outlines::OutlineFormat::of_content(&bytes);
    }

    #[test]
    fn any_bytes_are_read_or_refused(
        format in prop::sample::select(OutlineFormat::ALL.to_vec()),
        bytes in prop::collection::vec(any::<u8>(), 0..200),
    ) {
        use_all(&bytes, format);
        let _ = outlines::OutlineFormat::of_content(&bytes);
    }

    /// Files of the words of a format in any order reach deeper than bytes.
    #[test]
    fn any_words_are_read_or_refused(
        file in 0..FILES.len(),
        picks in prop::collection::vec((any::<prop::sample::Index>(), prop::sample::select(vec!["", " ", "\n", ","])), 0..60),
    ) {
        let (format, text) = FILES[file];
        let words: Vec<&str> = text.split_inclusive([' ', '\n', ',', '(', ')', '[', ']', '\'', '"']).collect();
        let text: String =
            picks.iter().flat_map(|(pick, space)| [*pick.get(&words), *space]).collect();
        use_all(text.as_bytes(), format);
    }
}

#[test]
fn deep_and_long_files_end() {
    let deep = [
        (OutlineFormat::Svg, "<svg>".to_owned() + &"<g>".repeat(100_000)),
        (
            OutlineFormat::Svg,
            format!("<svg>{}{}</svg>", "<g>".repeat(20_000), "</g>".repeat(20_000)),
        ),
        (OutlineFormat::GeoJson, "[".repeat(100_000)),
        (
            OutlineFormat::GeoJson,
            "{\"type\":\"GeometryCollection\",\"geometries\":[".repeat(10_000),
        ),
        (OutlineFormat::Wkt, "GEOMETRYCOLLECTION(".repeat(100_000)),
        (OutlineFormat::Wkt, "(".repeat(100_000)),
        (OutlineFormat::Poly, "999999999999 2 0 0\n1 0 0\n".to_owned()),
        (
            OutlineFormat::Msh,
            "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 1 1 1\n1 1 0 999999999999\n1\n"
                .to_owned(),
        ),
    ];
    for (format, text) in deep {
        use_all(text.as_bytes(), format);
    }
    // Squares inside each other, and one whose every vertex is a spike.
    let squares: String =
        (1..8_000).map(|i| format!("-{i} -{i}\n{i} -{i}\n{i} {i}\n-{i} {i}\n\n")).collect();
    assert_eq!(
        outlines::read(squares.as_bytes(), OutlineFormat::Csv, alone).unwrap().features.len(),
        4_000
    );
    let spikes: String =
        (0..1_000).map(|i| format!("{} 0\n", if i % 2 == 0 { 0 } else { i })).collect();
    use_all(spikes.as_bytes(), OutlineFormat::Csv);
}
