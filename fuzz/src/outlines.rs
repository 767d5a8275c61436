//! Every reader of outlines: the first byte tells the format and how near points become one in a repair, the rest is
//! the file. What is read is repaired, divided and made into maps as the command line does.

use mindeg_outlines::{Division, DrawnInside, Feature, OutlineFormat, labelled, maps, read};
use std::io;

pub(crate) fn run(file: &[u8]) {
    let Some((&first, bytes)) = file.split_first() else { return };
    let _ = OutlineFormat::of_content(bytes);
    let (format, snap) = (usize::from(first) % 8, usize::from(first) / 8 % 4);
    let format = OutlineFormat::ALL[format];
    let snap = [None, Some(1e-9), Some(0.01), Some(1.0)][snap];
    // The file beside a .poly is made of the same bytes.
    let beside = |extension: &str| match extension {
        "node" => Ok(bytes.to_vec()),
        _ => Err(io::ErrorKind::NotFound.into()),
    };
    let Ok(outlines) = read(bytes, format, beside) else { return };
    let rings = outlines.features.iter().flat_map(|feature| &feature.rings);
    let pieces: usize = rings.map(|ring| ring.pieces.len()).sum();
    // An arc of TopoJSON may be named again and again.
    let may_repeat = bytes.windows(6).any(|key| key == b"\"arcs\"");
    assert!(may_repeat || pieces <= 2 * bytes.len(), "{pieces} pieces of {} bytes", bytes.len());
    if pieces > 10_000 {
        return;
    }
    let repaired = outlines.clone().repaired(None);
    for feature in outlines.features.iter().chain(repaired.iter().flat_map(|it| &it.features)) {
        let segments = feature.rings.iter().flat_map(|ring| ring.segments());
        let length: f64 = segments.map(|segment| segment.length()).sum();
        // The most points there may be take 3 GB.
        for size in [None, Some(length / 100.0), Some(f64::max(1e9, length / 1e6))] {
            if let Ok(domain) = feature.domain(&Division { size, ..Division::default() }) {
                assert!(domain.placement().points().all(|point| point.is_finite()));
            }
        }
    }
    let _ = mapped(&outlines.features, &outlines.inside);
    if let Ok(together) = outlines.repaired_together(None, snap) {
        let rings = || together.features.iter().flat_map(|feature| &feature.rings);
        let is_touch = mapped(&together.features, &together.inside);
        // Curves are repaired by their chords, and lines inside are not repaired.
        if together.inside.is_empty() && !rings().any(|ring| ring.is_curved()) {
            assert_eq!(is_touch, None, "polygons repaired together still meet");
        }
    }
}

/// The message where polygons meet that may not, or nothing.
fn mapped(features: &[Feature], inside: &DrawnInside) -> Option<String> {
    match maps(&labelled(features.to_vec()), inside, &Division::default(), true) {
        Ok((domains, _)) => {
            for domain in domains {
                assert!(domain.placement().points().all(|point| point.is_finite()));
                assert!(domain.placement().area() > 0.0);
            }
            None
        }
        Err(error) => error.is_touch.then(|| error.to_string()),
    }
}
