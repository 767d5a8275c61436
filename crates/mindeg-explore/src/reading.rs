//! Domains in files of any format that mindeg takes.

use mindeg::{Domain, Progress};
use mindeg_answers::names::part_name;
use mindeg_files::{Content, FileError, Input, Polygon, PolygonFile, ReadOptions, Session, Wanted};
use serde_json::value::RawValue;

use crate::answer::MAX_VERTICES;
use crate::api::Source;

/// The most polygons of a file that are given.
const MOST: usize = 200;

/// The note on polygons that are none without a repair, first of all notes.
pub const REPAIRED: &str = "Rings touched or crossed; they were repaired, as --repair does.";

/// The domain of a file, or the maps of its polygons that share edges, then each polygon alone. Where polygons are
/// refused as they are and not once they are repaired, they are given repaired, with a note.
///
/// # Errors
///
/// The error in the file, in a sentence that names the file.
///
/// # Example
///
/// ```
/// use mindeg_files::{Input, Session};
///
/// let lid = Input::Bytes("lid.svg", b"<svg><circle id='lid' cx='5' cy='5' r='2'/></svg>");
/// let sources = mindeg_explore::sources(&Session::new(""), &lid)?;
/// assert_eq!(sources[0].name, "lid");
/// # Ok::<(), mindeg_files::FileError>(())
/// ```
pub fn sources(session: &Session, input: &Input<'_>) -> Result<Vec<Source>, FileError> {
    let plain = read(session, input, &ReadOptions::default());
    let refused = |sources: &[Source]| {
        sources.iter().filter(|source| source.domain.is_none() && !source.is_solid).count()
    };
    let before = plain.as_ref().map_or(usize::MAX, |sources| refused(sources));
    if before == 0 {
        return plain;
    }
    match read(session, input, &ReadOptions { repair: true, ..ReadOptions::default() }) {
        Ok(mut sources) if refused(&sources) < before => {
            for source in sources.iter_mut().filter(|source| source.domain.is_some()) {
                source.notes.insert(0, REPAIRED.to_owned());
            }
            Ok(sources)
        }
        _ => plain,
    }
}

/// The same with options.
fn read(
    session: &Session,
    input: &Input<'_>,
    options: &ReadOptions,
) -> Result<Vec<Source>, FileError> {
    let name = input.name();
    let content = session.open(input, Wanted::Domain, options, Progress::NONE);
    let content = match content {
        Ok(content) => content,
        Err(error) => {
            // A file with faces, of a format that may hold outlines, too.
            return match session.mesh(input, None, Progress::NONE) {
                Ok(_) => Ok(vec![solid(name)]),
                Err(_) => Err(error),
            };
        }
    };
    let mut polygons = match content {
        Content::Polygons(polygons) => polygons,
        Content::Domain(text) | Content::Model(text) => {
            let text = text.strip_prefix('\u{feff}').unwrap_or(&text);
            let domain = Domain::from_json_up_to(text, MAX_VERTICES)
                .map_err(|error| FileError::wrong(format!("{name}: {error}")))?;
            let name = domain.name().unwrap_or(&name).to_owned();
            let domain = RawValue::from_string(text.trim().to_owned()).ok();
            let notes = Vec::new();
            return Ok(vec![Source { name, domain, notes, message: None, is_solid: false }]);
        }
        Content::Mesh(_) => return Ok(vec![solid(name)]),
    };
    let count = polygons.polygons.len();
    if count > MOST {
        polygons.notes.push(format!("The first {MOST} of {count} polygons are given."));
    }
    let mut sources = maps(&polygons);
    let singly = polygons.polygons.iter().take(MOST - sources.len());
    sources.extend(singly.map(|polygon| source(&polygons, polygon)));
    Ok(sources)
}

/// The maps of polygons that share edges; a polygon that shares none is no map.
fn maps(polygons: &PolygonFile) -> Vec<Source> {
    if polygons.polygons.len() < 2 {
        return Vec::new();
    }
    let Ok((domains, notes)) = polygons.maps() else { return Vec::new() };
    let parts = domains.iter().enumerate().filter(|(_, domain)| domain.inside().regions.len() > 1);
    let source = |(index, domain): (usize, &Domain)| {
        let name = match &domains[..] {
            [_] => polygons.name().map_or_else(|| part_name(index, domain), str::to_owned),
            _ => part_name(index, domain),
        };
        let notes = polygons.notes.iter().chain(&notes).cloned().collect();
        Source { name, notes, ..Source::of(domain) }
    };
    parts.take(MOST).map(source).collect()
}

/// A file that holds a surface.
fn solid(name: String) -> Source {
    let message = Some("it is a mesh; a domain is expected".to_owned());
    Source { name, domain: None, notes: Vec::new(), message, is_solid: true }
}

fn source(polygons: &PolygonFile, polygon: &Polygon) -> Source {
    let name = polygon.name();
    let notes = polygons.notes.clone();
    let points: usize = polygon.feature.rings.iter().map(|ring| ring.pieces.len()).sum();
    given(name, notes, points, || polygons.domain(polygon).map_err(|error| error.to_string()))
}

impl Source {
    /// A domain that was read already.
    #[must_use]
    pub fn of(domain: &Domain) -> Self {
        let name = domain.name().unwrap_or("domain").to_owned();
        let points = domain.rings().vertex_count() as usize;
        given(name, Vec::new(), points, || Ok(domain.clone()))
    }
}

/// A domain to start from, unless it has too many points for the page.
fn given(
    name: String,
    notes: Vec<String>,
    points: usize,
    domain: impl FnOnce() -> Result<Domain, String>,
) -> Source {
    let domain = if points > MAX_VERTICES as usize {
        Err(format!("the outline has {points} points; the page takes up to {MAX_VERTICES}"))
    } else {
        domain()
    };
    match domain {
        Ok(domain) => {
            let domain = RawValue::from_string(domain.to_json()).ok();
            Source { name, domain, notes, message: None, is_solid: false }
        }
        Err(message) => {
            Source { name, domain: None, notes, message: Some(message), is_solid: false }
        }
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
            let drawing = format!("<svg>{squares}</svg>");
            let input = Input::Bytes("many.svg", drawing.as_bytes());
            sources(&Session::new(""), &input).unwrap()
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
    fn a_ring_that_crosses_itself_is_repaired_and_a_note_says_so() {
        let given = |ring: &str| {
            let file = format!(r#"{{"type": "Polygon", "coordinates": [{ring}]}}"#);
            let input = Input::Bytes("bow.geojson", file.as_bytes());
            sources(&Session::new(""), &input).unwrap()
        };
        let bow = given("[[0, 0], [2, 2], [2, 0], [0, 2], [0, 0]]");
        assert!(!bow.is_empty() && bow.iter().all(|source| source.domain.is_some()));
        assert_eq!(bow[0].notes[0], REPAIRED);
        let sound = given("[[0, 0], [2, 0], [2, 2], [0, 2], [0, 0]]");
        assert!(sound[0].domain.is_some() && !sound[0].notes.contains(&REPAIRED.to_owned()));
    }

    #[test]
    fn polygons_that_share_edges_come_as_one_map_first() {
        let square = |name: &str, x: u32| {
            let ring: Vec<[u32; 2]> = vec![[x, 0], [x + 1, 0], [x + 1, 1], [x, 1], [x, 0]];
            serde_json::json!({"type": "Feature", "properties": {"name": name},
                "geometry": {"type": "Polygon", "coordinates": [ring]}})
        };
        let given = |squares: &[(&str, u32)]| -> Vec<(String, usize)> {
            let features: Vec<_> = squares.iter().map(|(name, x)| square(name, *x)).collect();
            let file = serde_json::json!({"type": "FeatureCollection", "features": features});
            let file = file.to_string();
            let input = Input::Bytes("land.geojson", file.as_bytes());
            let sources = sources(&Session::new(""), &input).unwrap();
            let regions = |source: &Source| {
                let domain = Domain::from_json(source.domain.as_ref().unwrap().get()).unwrap();
                (source.name.clone(), domain.inside().regions.len())
            };
            sources.iter().map(regions).collect()
        };
        let listed = |names: &[(&str, usize)]| -> Vec<(String, usize)> {
            names.iter().map(|(name, regions)| ((*name).to_owned(), *regions)).collect()
        };
        let [a, b, c] = [("a", 0), ("b", 1), ("c", 5)];
        assert_eq!(given(&[a, b]), listed(&[("land", 2), ("a", 0), ("b", 0)]));
        let expected = [("part 1 (a, …)", 2), ("a", 0), ("b", 0), ("c", 0)];
        assert_eq!(given(&[a, b, c]), listed(&expected));
        assert_eq!(given(&[a, c]), listed(&[("a", 0), ("c", 0)]));
    }

    #[test]
    fn an_outline_of_too_many_points_is_refused_by_their_number() {
        // A square with the teeth of a saw on one side.
        let outline = |count: u32| {
            let teeth = (0..count - 2).map(|x| format!("{x},{}", x % 2));
            let others = [format!("{count},{count}"), format!("0,{count}")];
            let points: Vec<String> = teeth.chain(others).collect();
            let drawing = format!("<svg><polygon points='{}'/></svg>", points.join(" "));
            let input = Input::Bytes("saw.svg", drawing.as_bytes());
            sources(&Session::new(""), &input).unwrap().remove(0)
        };
        assert_eq!(outline(MAX_VERTICES).message, None);
        assert_eq!(
            outline(MAX_VERTICES + 1).message.as_deref(),
            Some("the outline has 100001 points; the page takes up to 100000")
        );
    }
}
