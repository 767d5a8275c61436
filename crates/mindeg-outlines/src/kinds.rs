//! Lines along polygons that say which kind of boundary is there: open water, land or island.

use std::collections::BTreeMap;
use std::sync::Arc as Shared;

use glam::DVec2;
use mindeg_domain::{Domain, Inside, Side};
use mindeg_mesh::{LineKind, sorted};

use super::outline::{Outlines, SideKinds, key};
use super::text::{clean, quoted};
use crate::error::OutlineError;

/// A line along the boundary of polygons.
pub(super) struct MarkedLine {
    pub(super) points: Vec<DVec2>,
    /// The name of the sides there; that of the kind without one.
    pub(super) name: Option<String>,
    pub(super) kind: LineKind,
    /// Where the file has it.
    pub(super) place: String,
}

impl Outlines {
    /// Gives the edges of polygons that lie along lines the names and kinds of these.
    pub(super) fn mark(&mut self, lines: Vec<MarkedLine>) -> Result<(), OutlineError> {
        if lines.is_empty() {
            return Ok(());
        }
        // Two polygons may share an edge.
        let mut edges: BTreeMap<_, Vec<[usize; 3]>> = BTreeMap::new();
        for (feature, of_feature) in self.features.iter().enumerate() {
            for (ring, of_ring) in of_feature.rings.iter().enumerate() {
                for (piece, segment) in of_ring.segments().enumerate() {
                    let ends = [key(segment.start), key(segment.end)];
                    edges.entry(sorted(ends)).or_default().push([feature, ring, piece]);
                }
            }
        }
        for MarkedLine { points, name, kind, place } in lines {
            let name = name.map(|name| clean(&name)).filter(|name| !name.is_empty());
            let name: Shared<str> = name.unwrap_or_else(|| kind.name().to_owned()).into();
            if self.kinds.0.insert(name.to_string(), kind).is_some_and(|other| other != kind) {
                let problem = format!("lines of two kinds are called {}", quoted(&name));
                return Err(OutlineError::place(place, problem));
            }
            for ends in points.windows(2) {
                let Some(pieces) = edges.get(&sorted([key(ends[0]), key(ends[1])])) else {
                    let [from, to] = [ends[0], ends[1]].map(|DVec2 { x, y }| format!("({x}, {y})"));
                    let problem = format!(
                        "the line has a kind, and from {from} to {to} it is no edge of a polygon; draw it with the points of \
                         the boundary"
                    );
                    return Err(OutlineError::place(place, problem));
                };
                for &[feature, ring, piece] in pieces {
                    let side = &mut self.features[feature].rings[ring].pieces[piece].side;
                    if side.as_ref().is_some_and(|other| *other != name) {
                        let DVec2 { x, y } = ends[0];
                        let problem = format!(
                            "the line lies on another one with a kind, at ({x}, {y}); drop one of them"
                        );
                        return Err(OutlineError::place(place, problem));
                    }
                    *side = Some(Shared::clone(&name));
                }
            }
        }
        Ok(())
    }
}

/// The domain with these kinds of its sides and lines.
///
/// # Errors
///
/// The errors of [`Domain::with_inside`].
pub fn with_kinds(domain: Domain, kinds: &SideKinds) -> Result<Domain, OutlineError> {
    let kind = |side: &Side| kinds.0.get(side.name.as_ref()?).copied();
    let told = |side: &Side| Side { kind: kind(side).or(side.kind), ..side.clone() };
    let lines = || domain.inside().lines.iter();
    let is_told = domain.sides().iter().any(|side| kind(side).is_some());
    let mut new = domain.clone();
    if is_told {
        new = new.with_sides(domain.sides().iter().map(told).collect())?;
    }
    if lines().flat_map(|line| &line.sides).any(|side| kind(side).is_some()) {
        let mut inside: Inside = domain.inside().clone();
        for side in inside.lines.iter_mut().flat_map(|line| &mut line.sides) {
            *side = told(side);
        }
        new = new.with_inside(inside)?;
    }
    Ok(new)
}

#[cfg(test)]
mod tests {
    use super::super::{Division, OutlineFormat, read};
    use super::*;

    fn read_with(lines: &str) -> Result<Outlines, String> {
        let text = format!(
            r#"{{"type": "FeatureCollection", "features": [
                {{"type": "Feature", "geometry": {{"type": "Polygon",
                  "coordinates": [[[0, 0], [4, 0], [8, 0], [8, 8], [0, 8]], [[2, 2], [3, 2], [2, 3]]]}}}}, {lines}]}}"#
        );
        let alone = |_: &str| Err(std::io::ErrorKind::NotFound.into());
        read(text.as_bytes(), OutlineFormat::GeoJson, alone).map_err(|error| error.to_string())
    }

    fn line(properties: &str, kind: &str, coordinates: &str) -> String {
        format!(
            r#"{{"type": "Feature", "properties": {{{properties}}},
                "geometry": {{"type": "{kind}", "coordinates": {coordinates}}}}}"#
        )
    }

    #[test]
    fn lines_along_polygons_give_sides_names_and_kinds() {
        let west = line(r#""kind": "open""#, "LineString", "[[0, 0], [0, 8]]");
        let south = line(
            r#""kind": "land", "name": "quay""#,
            "MultiLineString",
            "[[[4, 0], [0, 0]], [[4, 0], [8, 0]]]",
        );
        let rock = line(
            r#""kind": "island", "line": "rock""#,
            "LineString",
            "[[2, 2], [3, 2], [2, 3], [2, 2]]",
        );
        let road = line(r#""kind": "road""#, "LineString", "[[1, 1], [2, 1]]");
        let outlines = read_with(&[west, south, rock, road].join(",")).unwrap();
        assert_eq!(outlines.inside.lines.len(), 1);
        // A repair keeps them.
        for outlines in [outlines.clone(), outlines.repaired(None).unwrap()] {
            let domain = outlines.features[0].domain(&Division::default()).unwrap();
            let domain = with_kinds(domain, &outlines.kinds).unwrap();
            let told = |side: &Side| (side.name.clone().unwrap_or_default(), side.kind);
            let mut told: Vec<_> = domain.sides().iter().map(told).collect();
            told.sort_by(|a, b| a.0.cmp(&b.0));
            told.dedup();
            let [open, land, island] = [LineKind::Open, LineKind::Land, LineKind::Island].map(Some);
            let expected = [("", None), ("open", open), ("quay", land), ("rock", island)];
            assert_eq!(told, expected.map(|(name, kind)| (name.to_owned(), kind)));
        }
    }

    #[test]
    fn lines_that_cannot_be_are_refused_with_the_place() {
        let open = |at: &str| line(r#""kind": "open""#, "LineString", at);
        let named = |kind: &str, at: &str| {
            line(&format!(r#""kind": "{kind}", "name": "a""#), "LineString", at)
        };
        for (lines, words) in [
            (
                open("[[0, 0], [8, 0]]"),
                "features[1].geometry.coordinates: the line has a kind, and from (0, 0) to (8, 0) it is no",
            ),
            (
                named("open", "[[0, 0], [4, 0]]") + "," + &named("land", "[[4, 0], [8, 0]]"),
                "lines of two kinds are called \"a\"",
            ),
            (
                open("[[0, 0], [4, 0]]") + "," + &named("land", "[[0, 0], [4, 0]]"),
                "features[2].geometry.coordinates: the line lies on another one",
            ),
            (open("[[0, \"a\"]]"), "features[1].geometry.coordinates[0]: found the text"),
        ] {
            let error = read_with(&lines).unwrap_err();
            assert!(error.contains(words), "{error}");
        }
    }
}
