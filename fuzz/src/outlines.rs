//! Every reader of outlines: the first byte tells the format, the rest is the file. What is read is
//! repaired and divided as the command line does.

use mindeg_outlines::{Division, OutlineFormat, read};
use std::io;

pub(crate) fn run(file: &[u8]) {
    let Some((&first, bytes)) = file.split_first() else { return };
    let _ = OutlineFormat::of_content(bytes);
    let format = OutlineFormat::ALL[usize::from(first) % OutlineFormat::ALL.len()];
    // The file beside a .poly is made of the same bytes.
    let beside = |extension: &str| match extension {
        "node" => Ok(bytes.to_vec()),
        _ => Err(io::ErrorKind::NotFound.into()),
    };
    let Ok(outlines) = read(bytes, format, beside) else { return };
    let rings = outlines.features.iter().flat_map(|feature| &feature.rings);
    let pieces: usize = rings.map(|ring| ring.pieces.len()).sum();
    assert!(pieces <= 2 * bytes.len(), "{pieces} pieces of {} bytes", bytes.len());
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
}
