//! Places of a boundary, in degrees and in words, and its shortest edge.

use crate::numbers;
use mindeg::glam::DVec2;
use mindeg::{Domain, Projection};
use mindeg_mesh::number;
use schemars::JsonSchema;
use serde::Serialize;

/// An edge below this share of the median length is told.
const SHORT: f64 = 0.2;

/// The shortest edge of a boundary.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ShortestEdge {
    /// Its length.
    pub length: f64,
    /// Half of all edges are at least so long.
    pub median: f64,
    /// Its middle.
    pub at: [f64; 2],
    /// The same in degrees of longitude and latitude, if the domain was projected.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub degrees: Option<[f64; 2]>,
}

impl ShortestEdge {
    /// That of all domains; none if they have no edges. O(n log n) for n edges.
    pub(super) fn of(domains: &[Domain]) -> Option<Self> {
        let edges = domains.iter().flat_map(|domain| {
            let point = |vertex| domain.placement().point(vertex);
            let next = |vertex| domain.rings().next(vertex);
            let vertices = 0..domain.rings().vertex_count();
            vertices.map(move |vertex| (domain, point(vertex), point(next(vertex))))
        });
        let mut edges: Vec<(f64, &Domain, DVec2)> =
            edges.map(|(domain, a, b)| (a.distance(b), domain, a.midpoint(b))).collect();
        edges.sort_by(|a, b| a.0.total_cmp(&b.0));
        let median = edges.get(edges.len() / 2)?.0;
        let &(length, domain, at) = edges.first()?;
        Some(Self { length, median, at: at.to_array(), degrees: degrees(domain, at) })
    }

    /// A sentence on it, if it is much shorter than most.
    pub(super) fn words(&self) -> Option<String> {
        let unit = if self.degrees.is_some() { " m" } else { "" };
        let [length, median] = [self.length, self.median].map(number);
        let place = place_in_words(self.degrees, self.at);
        (self.length < SHORT * self.median).then(|| {
            format!(
                "The shortest edge is {length}{unit} long at {place}, half of all {median}{unit} or more; a solver's time step \
                 depends on it.\n"
            )
        })
    }
}

/// A place as a sentence has it.
pub(crate) fn place_in_words(degrees: Option<[f64; 2]>, at: [f64; 2]) -> String {
    match (degrees, at) {
        (Some(degrees), _) => Projection::in_words(degrees.into()),
        (None, at) => numbers::place(at),
    }
}

/// A place of the plane as a sentence has it: in degrees if the domain was projected.
pub(crate) fn placed(projection: Option<&Projection>, at: DVec2) -> String {
    let degrees = projection.map(|projection| projection.to_degrees(at).to_array());
    place_in_words(degrees, at.to_array())
}

/// Degrees of longitude and latitude, to nine decimals, of a point of a projected domain.
pub(super) fn degrees(domain: &Domain, at: DVec2) -> Option<[f64; 2]> {
    const DECIMALS: f64 = 1e9;
    let degrees = domain.projection()?.to_degrees(at);
    Some(degrees.to_array().map(|it| (it * DECIMALS).round() / DECIMALS))
}

/// The point, in degrees if there are any.
pub(super) fn place(domain: &Domain, at: DVec2) -> [f64; 2] {
    degrees(domain, at).unwrap_or(at.to_array())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_edge_that_is_much_shorter_than_most_is_told_with_its_place() {
        let square = |short: f64| {
            let ring = [[0.0, 0.0], [4.0, 0.0], [4.0, short], [4.0, 4.0], [0.0, 4.0]];
            ShortestEdge::of(&[Domain::from_rings([ring]).unwrap()]).unwrap()
        };
        let found = square(0.01);
        assert_eq!((found.length, found.median, found.at), (0.01, 4.0, [4.0, 0.005]));
        let words = found.words().unwrap();
        assert!(
            words
                .starts_with("The shortest edge is 0.01 long at (4, 0.005), half of all 4 or more"),
            "{words}"
        );
        assert!(words.ends_with("or more; a solver's time step depends on it.\n"), "{words}");
        let degrees = Some([24.123_456_789, -37.000_000_1]);
        assert_eq!(place_in_words(degrees, [0.0; 2]), "longitude 24.123457, latitude -37");
        assert_eq!(square(1.0).words(), None);
        assert_eq!(ShortestEdge::of(&[]), None);
    }
}
