//! Domains in files of any format that mindeg takes.

use mindeg::{Domain, Progress};
use mindeg_answers::command::file_word;
use mindeg_answers::names::part_name;
use mindeg_files::{
    Content, Division, FileError, Input, Polygon, PolygonFile, ReadOptions, Session, Wanted,
};
use serde_json::value::RawValue;
use std::path::Path;

use crate::answer::MAX_VERTICES;
use crate::api::Source;
use crate::conditioned::divided;
use crate::terms::without_options;
use crate::whole::WholeMap;

/// The most polygons of a file that are given.
const MOST: usize = 200;

/// The note on polygons that are none without a repair, first of all notes.
pub const REPAIRED: &str = "Rings touched or crossed, or polygons overlapped; they were repaired.";

/// The domain of a file, or the maps of its polygons that share edges, then each polygon alone; or the surface or the whole
/// model in it. Where polygons, or maps of them, are refused as they are and not once they are repaired, they are given
/// repaired, with a note. With a size, sides and curves are divided into edges of that length.
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
/// let sources = mindeg_explore::sources(&Session::new(""), &lid, None)?;
/// assert_eq!(sources[0].name, "lid");
/// # Ok::<(), mindeg_files::FileError>(())
/// ```
pub fn sources(
    session: &Session,
    input: &Input<'_>,
    size: Option<f64>,
) -> Result<Vec<Source>, FileError> {
    let refused = |found: &Found| {
        let sources = found.sources.iter();
        let alone = sources.filter(|source| source.message.is_some() && !source.is_solid).count();
        alone + usize::from(found.no_map.is_some())
    };
    let read = |repair| {
        let division = Division { size, ..Division::default() };
        read(session, input, &ReadOptions { repair, division, ..ReadOptions::default() })
    };
    let (mut found, is_repaired) = repaired_if_refused(read, refused)?;
    if is_repaired {
        for source in found.sources.iter_mut().filter(|source| source.message.is_none()) {
            source.notes.insert(0, REPAIRED.to_owned());
            source.map = source.map.take().map(|map| map.with_option("--repair"));
        }
    }
    Ok(found.told())
}

/// The result of `read` without a repair, or with one if that leaves fewer `refused`, and which.
///
/// # Errors
///
/// The error without a repair, if nothing is read with one.
pub fn repaired_if_refused<T, E>(
    mut read: impl FnMut(bool) -> Result<T, E>,
    refused: impl Fn(&T) -> usize,
) -> Result<(T, bool), E> {
    let plain = read(false);
    let least = plain.as_ref().map_or(usize::MAX, &refused);
    if least > 0
        && let Ok(repaired) = read(true)
        && refused(&repaired) < least
    {
        return Ok((repaired, true));
    }
    Ok((plain?, false))
}

/// The content of a file, as the page takes it.
struct Found {
    sources: Vec<Source>,
    /// Why its polygons are no map.
    no_map: Option<String>,
}

impl Found {
    /// The sources; each says why it is alone where that is a fault.
    fn told(mut self) -> Vec<Source> {
        for source in &mut self.sources {
            source.notes.iter_mut().for_each(|note| *note = in_page(note));
            let reason = self
                .no_map
                .iter()
                .map(|reason| without_options(&format!("Each polygon is alone: {reason}.")));
            source.notes.extend(reason);
        }
        self.sources
    }
}

/// A note without options of the terminal, but for the one that the page is started with.
fn in_page(note: &str) -> String {
    let is_in_degrees = note.contains("--project auto makes metres of them");
    let note = without_options(note);
    match is_in_degrees {
        true => format!(
            "{note}; a page that is started by \"mindeg explore FILE --project auto\" has metres"
        ),
        false => note,
    }
}

impl From<Source> for Found {
    fn from(source: Source) -> Self {
        Self { sources: vec![source], no_map: None }
    }
}

/// The same with options.
fn read(session: &Session, input: &Input<'_>, options: &ReadOptions) -> Result<Found, FileError> {
    let name = input.name();
    let content = session.open(input, Wanted::Domain, options, Progress::NONE);
    let content = match content {
        Ok(content) => content,
        Err(error) => {
            // A file with faces, of a format that may hold outlines, too; or a whole model.
            let model = || session.open(input, Wanted::Model, options, Progress::NONE);
            return match session.mesh(input, None, Progress::NONE) {
                Ok(_) => Ok(solid(name).into()),
                Err(_) if matches!(model(), Ok(Content::Model(_))) => Ok(solid(name).into()),
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
            let domain = match options.division.size {
                Some(size) => divided(domain, size).map_err(FileError::wrong)?,
                None => domain,
            };
            let text = match options.division.size {
                Some(_) => domain.to_json(),
                None => text.trim().to_owned(),
            };
            let (name, text) = match (domain.name(), stem(input)) {
                (None, Some(stem)) => (stem.clone(), with_name(&text, &stem)),
                (own, _) => (own.unwrap_or(&name).to_owned(), text),
            };
            let domain = RawValue::from_string(text).ok();
            let notes = Vec::new();
            return Ok(
                Source { name, domain, notes, message: None, is_solid: false, map: None }.into()
            );
        }
        Content::Mesh(_) => return Ok(solid(name).into()),
    };
    let count = polygons.polygons.len();
    if count > MOST {
        polygons.notes.push(format!("The first {MOST} of {count} polygons are given."));
    }
    let (mut sources, no_map) = match maps(&polygons, stem(input).as_deref(), &name) {
        Ok(sources) => (sources, None),
        Err(error) => (Vec::new(), Some(error.to_string())),
    };
    let maps = sources.iter().filter(|source| source.domain.is_some()).count();
    let singly = polygons.polygons.iter().take(MOST - maps);
    sources.extend(singly.map(|polygon| source(&polygons, polygon)));
    Ok(Found { sources, no_map })
}

/// The name of a dropped file without its extension, for a domain without a name: no command names the file.
fn stem(input: &Input<'_>) -> Option<String> {
    let Input::Bytes(name, _) = input else { return None };
    let stem = Path::new(name).file_stem()?.to_str()?;
    let is_plain = stem.chars().all(|c| c.is_alphanumeric() || "-_. ".contains(c));
    is_plain.then(|| stem.to_owned())
}

/// The JSON of a domain with a name in front.
fn with_name(text: &str, name: &str) -> String {
    // A plain name needs no escapes.
    text.replacen('{', &format!("{{\"name\": \"{name}\", "), 1)
}

/// All parts together where there are several, then the maps of polygons that share edges; a polygon that shares none is no map.
fn maps(polygons: &PolygonFile, stem: Option<&str>, file: &str) -> Result<Vec<Source>, FileError> {
    if polygons.polygons.len() < 2 {
        return Ok(Vec::new());
    }
    let (domains, notes) = polygons.maps()?;
    let name = polygons.name().or(stem).unwrap_or("map");
    let whole = Source::whole(name, &[file_word(file)], &domains);
    let parts = domains.iter().enumerate().filter(|(_, domain)| domain.inside().regions.len() > 1);
    let source = |(index, domain): (usize, &Domain)| {
        let name = match &domains[..] {
            [_] => polygons.name().or(stem).map_or_else(|| part_name(index, domain), str::to_owned),
            _ => part_name(index, domain),
        };
        let notes = polygons.notes.iter().chain(&notes).cloned().collect();
        // A part is called as it is listed.
        let called = match &domains[..] {
            [_] => stem.map(str::to_owned),
            _ => Some(name.clone()),
        };
        let called = called.filter(|_| domain.name().is_none());
        let named = called.and_then(|called| domain.clone().named(called).ok());
        Source { name, notes, ..Source::of(named.as_ref().unwrap_or(domain)) }
    };
    Ok(whole.into_iter().chain(parts.take(MOST).map(source)).collect())
}

/// A file that holds a surface, or a whole model, whose mesh is one.
fn solid(name: String) -> Source {
    let message = Some("it is a mesh; a domain is expected".to_owned());
    Source { name, domain: None, notes: Vec::new(), message, is_solid: true, map: None }
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

    /// All parts of a file together, if there are several; the words name the file.
    #[must_use]
    pub fn whole(name: &str, words: &[String], domains: &[Domain]) -> Option<Self> {
        let map = Some(WholeMap::of(name, words, domains)?);
        let (name, notes) = ("the whole map".to_owned(), Vec::new());
        Some(Self { name, domain: None, notes, message: None, is_solid: false, map })
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
            Source { name, domain, notes, message: None, is_solid: false, map: None }
        }
        Err(message) => {
            Source { name, domain: None, notes, message: Some(message), is_solid: false, map: None }
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
            sources(&Session::new(""), &input, None).unwrap()
        };
        for (count, expected) in
            [(MOST, None), (MOST + 2, Some("The first 200 of 202 polygons are given."))]
        {
            let given = drawing(count);
            assert_eq!(given.len(), MOST + 1);
            assert!(given[0].map.is_some() && given[1..].iter().all(|it| it.domain.is_some()));
            let note = given[1].notes.iter().find(|note| note.starts_with("The first"));
            assert_eq!(note.map(String::as_str), expected);
        }
    }

    /// Edges of a circle end on the circle, however few points it had.
    #[test]
    fn a_size_divides_the_curves_of_a_file() {
        let drawing = b"<svg><circle cx='0' cy='0' r='5'/></svg>";
        let input = Input::Bytes("lid.svg", drawing);
        let given = |size| {
            let source = sources(&Session::new(""), &input, size).unwrap().remove(0);
            Domain::from_json(source.domain.unwrap().get()).unwrap()
        };
        assert_eq!(given(None).rings().vertex_count(), 24);
        let fine = given(Some(0.1));
        assert!((310..320).contains(&fine.rings().vertex_count()));
        assert!(fine.placement().points().all(|point| (point.length() - 5.0).abs() < 1e-9));
    }

    #[test]
    fn a_ring_that_crosses_itself_is_repaired_and_a_note_says_so() {
        let given = |ring: &str| {
            let file = format!(r#"{{"type": "Polygon", "coordinates": [{ring}]}}"#);
            let input = Input::Bytes("bow.geojson", file.as_bytes());
            sources(&Session::new(""), &input, None).unwrap()
        };
        let bow = given("[[0, 0], [2, 2], [2, 0], [0, 2], [0, 0]]");
        assert!(!bow.is_empty() && bow.iter().all(|source| source.message.is_none()));
        assert_eq!(bow[0].notes[0], REPAIRED);
        let sound = given("[[0, 0], [2, 0], [2, 2], [0, 2], [0, 0]]");
        assert!(sound[0].domain.is_some() && !sound[0].notes.contains(&REPAIRED.to_owned()));
    }

    #[test]
    fn polygons_that_overlap_are_repaired_as_one_map_or_the_reason_is_told() {
        let given = |squares: &str| {
            let input = Input::Bytes("land.wkt", squares.as_bytes());
            sources(&Session::new(""), &input, None).unwrap()
        };
        let overlapping = "POLYGON((0 0, 5.02 0, 5.02 5, 0 5)) POLYGON((5 0, 10 0, 10 5, 5 5))";
        let sources = given(overlapping);
        let domain = Domain::from_json(sources[0].domain.as_ref().unwrap().get()).unwrap();
        assert_eq!((domain.inside().regions.len(), domain.name()), (2, Some("land")));
        assert_eq!(sources[0].notes[0], REPAIRED);
        assert!(sources[0].notes.len() > 1, "{:?}", sources[0].notes);
        let beside = "POLYGON((0 0, 5 0, 5 5, 0 5)) POLYGON((5 0, 10 0, 10 5, 5 5))";
        assert!(given(beside).iter().all(|source| source.notes.is_empty()));
    }

    #[test]
    fn a_domain_without_a_name_is_called_after_its_dropped_file() {
        let text = r#" {"rectangle": {"width": 4, "height": 3}, "size": 1}"#;
        let given = |text: &str| {
            let input = Input::Bytes("my plate.json", text.as_bytes());
            let sources = sources(&Session::new(""), &input, None).unwrap();
            let domain = Domain::from_json(sources[0].domain.as_ref().unwrap().get()).unwrap();
            assert_eq!(domain.name(), Some(&*sources[0].name));
            sources[0].name.clone()
        };
        assert_eq!(given(text), "my plate");
        assert_eq!(given(&text.replacen('{', r#"{"name": "own", "#, 1)), "own");
    }

    #[test]
    fn a_whole_model_is_a_surface() {
        let cube = r#"{"corners": [[0,0,0], [1,0,0], [1,1,0], [0,1,0], [0,0,1], [1,0,1], [1,1,1], [0,1,1]],
            "faces": [[0,3,2,1], [4,5,6,7], [0,1,5,4], [1,2,6,5], [2,3,7,6], [3,0,4,7]], "size": 0.5}"#;
        let input = Input::Bytes("cube.json", cube.as_bytes());
        let sources = sources(&Session::new(""), &input, None).unwrap();
        assert!(sources[0].is_solid && sources.len() == 1);
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
            let sources = sources(&Session::new(""), &input, None).unwrap();
            let regions = |source: &Source| {
                let Some(domain) = &source.domain else {
                    assert!(source.map.is_some());
                    return (source.name.clone(), 0);
                };
                let domain = Domain::from_json(domain.get()).unwrap();
                (source.name.clone(), domain.inside().regions.len())
            };
            sources.iter().map(regions).collect()
        };
        let listed = |names: &[(&str, usize)]| -> Vec<(String, usize)> {
            names.iter().map(|(name, regions)| ((*name).to_owned(), *regions)).collect()
        };
        let [a, b, c] = [("a", 0), ("b", 1), ("c", 5)];
        assert_eq!(given(&[a, b]), listed(&[("land", 2), ("a", 0), ("b", 0)]));
        let whole = ("the whole map", 0);
        let expected = [whole, ("part 1 (a, …)", 2), ("a", 0), ("b", 0), ("c", 0)];
        assert_eq!(given(&[a, b, c]), listed(&expected));
        assert_eq!(given(&[a, c]), listed(&[whole, ("a", 0), ("c", 0)]));
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
            sources(&Session::new(""), &input, None).unwrap().remove(0)
        };
        assert_eq!(outline(MAX_VERTICES).message, None);
        assert_eq!(
            outline(MAX_VERTICES + 1).message.as_deref(),
            Some("the outline has 100001 points; the page takes up to 100000")
        );
    }
}
