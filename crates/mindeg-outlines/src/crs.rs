//! Coordinate reference systems, as files name them.

use mindeg_domain::Projection;

use super::outline::Outlines;
use super::text::quoted;

impl Outlines {
    /// Takes the reference system that a file names under a key: by a code of EPSG, or by a definition of PROJ's. It is degrees, or
    /// the projection that made the coordinates; a note tells which, or that it is not known.
    pub(super) fn take_reference_system(&mut self, key: &str, name: &str, is_in_degrees: bool) {
        let code = epsg(name);
        if code.is_some_and(Projection::is_of_degrees) || code.is_none() && is_in_degrees {
            return;
        }
        let name = code.map_or_else(|| name.to_owned(), |code| format!("EPSG:{code}"));
        let parsed: Result<Projection, _> = name.parse();
        let told = if code.is_some() { name } else { quoted(&name) };
        self.notes.push(match &parsed {
            _ if is_in_degrees => format!(
                "its {key} is {told}, but the coordinates are within those of degrees of longitude and latitude: left out"
            ),
            Ok(projection) => format!("its {key} is {told}: metres, by {}", projection.name()),
            Err(_) => format!(
                "its {key} is {told}, which is not known here: the coordinates are taken as planar, and of no place on the globe"
            ),
        });
        self.projection = parsed.ok().filter(|_| !is_in_degrees);
    }
}

/// The code of EPSG in a name, such as EPSG:32635 or urn:ogc:def:crs:EPSG::32635.
fn epsg(name: &str) -> Option<u32> {
    let mut words = name.rsplit(':');
    let code = words.next()?.parse().ok()?;
    words.any(|word| word.eq_ignore_ascii_case("epsg")).then_some(code)
}
