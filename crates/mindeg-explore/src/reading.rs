//! Domains in files of any format that mindeg takes.

use std::io;
use std::path::Path;

use mindeg::Domain;
use mindeg_outlines::{Division, Outlines, Polygon, format_of, labelled, read};
use serde_json::value::RawValue;

use crate::answer::MAX_VERTICES;
use crate::api::Source;

/// The most polygons of a file that are given.
const MOST: usize = 200;

/// The domain or the polygons of a file; the name tells its format where it has one.
///
/// # Errors
///
/// What is wrong with the file, in a sentence that names it.
///
/// # Example
///
/// ```
/// let svg = b"<svg><circle id='lid' cx='5' cy='5' r='2'/></svg>";
/// let sources = mindeg_explore::sources("lid.svg", svg)?;
/// assert_eq!(sources[0].name, "lid");
/// # Ok::<(), String>(())
/// ```
pub fn sources(name: &str, bytes: &[u8]) -> Result<Vec<Source>, String> {
    let failed = |error: String| format!("{name}: {error}");
    if bytes.trim_ascii().is_empty() {
        return Err(failed("the file is empty; a domain is expected".to_owned()));
    }
    let format = format_of(Some(Path::new(name)), bytes);
    let Some(format) = format.map_err(|error| failed(error.to_string()))? else {
        let text = std::str::from_utf8(bytes)
            .map_err(|error| failed(format!("the file is not UTF-8 text: {error}")))?;
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let domain = Domain::from_json_up_to(text, MAX_VERTICES)
            .map_err(|error| failed(error.to_string()))?;
        let name = domain.name().unwrap_or(name).to_owned();
        let domain = RawValue::from_string(text.trim().to_owned()).ok();
        return Ok(vec![Source { name, domain, notes: Vec::new(), message: None }]);
    };
    // A page gives one file at a time.
    let alone = |_: &str| Err(io::Error::other("the page takes one file; mindeg mesh reads both"));
    let outlines = read(bytes, format, alone).map_err(|error| failed(error.to_string()))?;
    let Outlines { features, mut notes, .. } = outlines;
    let count = features.len();
    if count > MOST {
        notes.push(format!("The first {MOST} of {count} polygons are given."));
    }
    let polygons = labelled(features).into_iter().take(MOST);
    Ok(polygons.map(|polygon| source(&polygon, &notes)).collect())
}

fn source(polygon: &Polygon, notes: &[String]) -> Source {
    let name = polygon.name();
    let notes = notes.to_vec();
    let points: usize = polygon.feature.rings.iter().map(|ring| ring.pieces.len()).sum();
    let domain = if points > MAX_VERTICES as usize {
        Err(format!("the outline has {points} points; the page takes up to {MAX_VERTICES}"))
    } else {
        polygon.domain(&Division::default()).map_err(|error| error.to_string())
    };
    match domain {
        Ok(domain) => {
            let domain = RawValue::from_string(domain.to_json()).ok();
            Source { name, domain, notes, message: None }
        }
        Err(message) => Source { name, domain: None, notes, message: Some(message) },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_polygons_of_many_are_given() {
        let drawing = |count: usize| {
            let square = |place: usize| format!("<rect x='{}' width='1' height='1'/>", 2 * place);
            let squares: String = (0..count).map(square).collect();
            sources("many.svg", format!("<svg>{squares}</svg>").as_bytes()).unwrap()
        };
        for (count, expected) in
            [(MOST, None), (MOST + 2, Some("The first 200 of 202 polygons are given."))]
        {
            let given = drawing(count);
            assert_eq!(given.len(), MOST);
            assert!(given.iter().all(|source| source.domain.is_some()));
            let note = given[0].notes.iter().find(|note| note.starts_with("The first"));
            assert_eq!(note.map(String::as_str), expected);
        }
    }

    #[test]
    fn an_outline_of_too_many_points_is_refused_by_their_number() {
        // A square with the teeth of a saw on one side.
        let outline = |count: u32| {
            let teeth = (0..count - 2).map(|x| format!("{x},{}", x % 2));
            let others = [format!("{count},{count}"), format!("0,{count}")];
            let points: Vec<String> = teeth.chain(others).collect();
            let drawing = format!("<svg><polygon points='{}'/></svg>", points.join(" "));
            sources("saw.svg", drawing.as_bytes()).unwrap().remove(0)
        };
        assert_eq!(outline(MAX_VERTICES).message, None);
        assert_eq!(
            outline(MAX_VERTICES + 1).message.as_deref(),
            Some("the outline has 20001 points; the page takes up to 20000")
        );
    }
}
