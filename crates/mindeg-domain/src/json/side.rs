//! Sides in JSON: their curves, their division and their names.

use glam::DVec2;
use mindeg_mesh::LineKind;
use mindeg_mesh::planar::InRing;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::constraints::{ExternalDegree, SideConstraint};
use crate::curve::{Arc, Curve};
use crate::domain::Domain;
use crate::error::{DomainError, Place};
use crate::matching::SideMatch;
use crate::side::{Intervals, Side};
use crate::spacing::Spacing;

/// A side
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct SideKeys {
    /// The number of intervals, at least 1
    #[schemars(range(min = 1))]
    intervals: Option<u64>,
    /// Instead: a target interval length above 0; the side gets its length divided by this, rounded,
    /// but at least 1
    #[schemars(extend("exclusiveMinimum" = 0))]
    size: Option<f64>,
    /// How the points are spread
    spacing: Option<Spacing>,
    /// Its name, which becomes a group in mesh files. Sides, holes and lines may share one
    name: Option<String>,
    /// Which boundary ocean models take it for
    kind: Option<LineKind>,
    /// The external degree of its vertices, which counts their edges on the other side of the boundary
    /// and none of the boundary itself: one number for all vertices that are not corners, or a list of
    /// one for each from the side's first corner to its last
    outside_degree: Option<ExternalDegree>,
    /// The degree limit of each of its vertices, corners included: the most edges that they may have,
    /// external degree included
    #[schemars(range(min = 2))]
    max_degree: Option<u32>,
    /// The side's own points between its corners, `[x, y]`, which come back bit for bit; none for one
    /// interval. The side is straight if all are within 1e-9 of its length from the line between its
    /// corners
    #[schemars(with = "Option<Vec<[f64; 2]>>")]
    points: Option<Vec<DVec2>>,
    /// It runs through these points, `[x, y]`, and is divided by its length
    #[schemars(with = "Option<Vec<[f64; 2]>>")]
    polyline: Option<Vec<DVec2>>,
    /// It runs along a circle
    arc: Option<ArcKeys>,
    /// It runs along the cubic Bézier curve with these two control points
    #[schemars(with = "Option<[[f64; 2]; 2]>")]
    bezier: Option<[DVec2; 2]>,
    /// Instead of its own curve and division: the side of the same ring that this one is, moved; a mesh joined there is
    /// periodic, and degrees are those of the joined mesh
    #[serde(rename = "match")]
    matches: Option<SideMatch>,
}

/// An arc: `through` a point or about a `center`
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct ArcKeys {
    /// A point that the arc goes through, `[x, y]`
    #[schemars(with = "Option<[f64; 2]>")]
    through: Option<DVec2>,
    /// Instead: its center, `[x, y]`, counter-clockwise about which it runs
    #[schemars(with = "Option<[f64; 2]>")]
    center: Option<DVec2>,
    /// Whether it runs clockwise about its center
    clockwise: Option<bool>,
}

/// The number of intervals of a side or an edge.
pub(super) fn intervals(
    place: &Place,
    (count, size): (Option<u64>, Option<f64>),
    spacing: &Spacing,
    default_size: Option<f64>,
) -> Result<Intervals, DomainError> {
    let error = |message| Err(place.clone().error(message));
    match (count, size, spacing) {
        (Some(_), Some(_), _) => error("give either \"intervals\" or \"size\", not both"),
        (None, Some(_), Spacing::Parameters(_)) => {
            error("\"parameters\" say how many intervals there are; drop \"size\"")
        }
        (Some(count), None, _) => Ok(Intervals::Count(count)),
        (None, Some(size), _) => Ok(Intervals::Size(size)),
        (None, None, Spacing::Parameters(given)) => Ok(Intervals::Count(given.len() as u64 + 1)),
        (None, None, _) => match default_size {
            Some(size) => Ok(Intervals::Size(size)),
            None => {
                error("give \"intervals\" (a whole number) or \"size\" (a target interval length)")
            }
        },
    }
}

/// The single side of a ring of points.
pub(super) fn lone_side(
    given: SideKeys,
    own: Side,
    at: InRing,
) -> Result<(Side, SideConstraint), DomainError> {
    if let Some(key) = given.dividing_keys().chain(given.running_keys()).next() {
        let message = format!("a \"ring\" has its own points; drop {key:?}");
        return Err(Place::side(at).then(key).error(message));
    }
    if given.matches.is_some() {
        let message = "a \"ring\" is one side, and a side that matches another needs a ring of several; give corners";
        return Err(Place::side(at).then("match").error(message));
    }
    let SideKeys { name, kind, outside_degree, max_degree, .. } = given;
    let external_degree = outside_degree.unwrap_or_default();
    let constraint = SideConstraint { external_degree, degree_limit: max_degree };
    Ok((Side { name, kind, ..own }, constraint))
}

impl SideKeys {
    fn dividing_keys(&self) -> impl Iterator<Item = &'static str> {
        let given = [
            ("intervals", self.intervals.is_some()),
            ("size", self.size.is_some()),
            ("spacing", self.spacing.is_some()),
        ];
        given.into_iter().filter(|(_, is_given)| *is_given).map(|(key, _)| key)
    }

    fn running_keys(&self) -> impl Iterator<Item = &'static str> {
        let given = [
            ("points", self.points.is_some()),
            ("polyline", self.polyline.is_some()),
            ("arc", self.arc.is_some()),
            ("bezier", self.bezier.is_some()),
        ];
        given.into_iter().filter(|(_, is_given)| *is_given).map(|(key, _)| key)
    }

    /// The side that these describe.
    pub(super) fn side(
        self,
        at: InRing,
        default_size: Option<f64>,
    ) -> Result<(Side, SideConstraint), DomainError> {
        let place = Place::side(at);
        let error = |message| Err(place.clone().error(message));
        let ways: Vec<_> = self.running_keys().collect();
        if let [one, other, ..] = ways[..] {
            return error(format!("a side runs one way: give either {one:?} or {other:?}"));
        }
        if let (Some(_), Some(key)) =
            (&self.matches, ways.iter().copied().chain(self.dividing_keys()).next())
        {
            return error(format!(
                "the side has the curve and points of the one it matches; drop {key:?}"
            ));
        }
        if let (Some(_), Some(key)) = (&self.points, self.dividing_keys().next()) {
            return error(format!("\"points\" say how many intervals there are; drop {key:?}"));
        }
        let spacing = self.spacing.unwrap_or_default();
        let curve = match (self.polyline, self.arc, self.bezier) {
            (Some(points), ..) => Curve::Polyline(points),
            (_, Some(arc), _) => Curve::Arc(arc.arc(&place)?),
            (.., Some(controls)) => Curve::Cubic(controls),
            _ => Curve::Line,
        };
        let side = match self.points {
            Some(points) => Side::points(points),
            None if self.matches.is_some() => Side::count(1),
            None => {
                let given = (self.intervals, self.size);
                let intervals = intervals(&place, given, &spacing, default_size)?;
                Side { curve, intervals, spacing, ..Side::count(1) }
            }
        };
        let side = Side { name: self.name, kind: self.kind, matches: self.matches, ..side };
        let external_degree = self.outside_degree.unwrap_or_default();
        Ok((side, SideConstraint { external_degree, degree_limit: self.max_degree }))
    }

    /// The same keys, with a number of intervals if nothing else divides the side.
    pub(super) fn or_intervals(self, intervals: Option<u64>) -> Self {
        let is_divided = self.points.is_some()
            || self.matches.is_some()
            || self.dividing_keys().next().is_some();
        if is_divided { self } else { Self { intervals, ..self } }
    }

    /// The description of a side of a domain.
    pub(super) fn of(domain: &Domain, ring: usize, index: usize) -> Self {
        let side = domain.sides()[index].clone();
        let constraint = domain.constraints().sides.get(index).cloned().unwrap_or_default();
        let outside = Some(constraint.external_degree);
        let outside_degree = outside.filter(|degree| *degree != ExternalDegree::default());
        let max_degree = constraint.degree_limit;
        // Points computed in the other direction differ in their last bits. So the sides of a
        // reversed ring list their points, unless all points are formulas anyway.
        let is_formula = domain.convex().is_some()
            && domain.sides().iter().all(|side| side.curve == Curve::Line);
        let count = domain.rings().intervals(index);
        if domain.turned.contains(&ring) && !is_formula && count > 1 && side.matches.is_none() {
            let mut points = vec![DVec2::ZERO; count as usize - 1];
            domain.placement().fill_points(domain.rings().corner(index) + 1, &mut points);
            let Side { name, kind, .. } = side;
            let points = Some(points);
            return Self { points, name, kind, outside_degree, max_degree, ..Self::default() };
        }
        Self { outside_degree, max_degree, ..Self::of_side(side) }
    }

    /// The description of a side without constraints.
    pub(super) fn of_side(side: Side) -> Self {
        let Side { curve, intervals, spacing, name, kind, matches } = side;
        let given = Self { name, kind, matches, ..Self::default() };
        if given.matches.is_some() {
            return given;
        }
        let given = match curve {
            Curve::Line => given,
            Curve::Polyline(points) if intervals == Intervals::Points => {
                Self { points: Some(points), ..given }
            }
            Curve::Polyline(points) => Self { polyline: Some(points), ..given },
            Curve::Cubic(controls) => Self { bezier: Some(controls), ..given },
            Curve::Arc(arc) => Self { arc: Some(ArcKeys::from(arc)), ..given },
        };
        let given = match (intervals, &spacing) {
            (Intervals::Points, _) | (_, Spacing::Parameters(_)) => given,
            (Intervals::Count(count), _) => Self { intervals: Some(count), ..given },
            (Intervals::Size(size), _) => Self { size: Some(size), ..given },
        };
        Self { spacing: Some(spacing).filter(|spacing| *spacing != Spacing::Uniform), ..given }
    }
}

impl ArcKeys {
    fn arc(self, side: &Place) -> Result<Arc, DomainError> {
        let place = side.clone().then("arc");
        match (self.through, self.center, self.clockwise) {
            (Some(point), None, None) => Ok(Arc::Through(point)),
            (Some(_), None, Some(_)) => Err(place
                .then("clockwise")
                .error("\"through\" says which way the arc runs; drop \"clockwise\"")),
            (None, Some(center), way) => {
                Ok(Arc::Center { center, is_clockwise: way.unwrap_or_default() })
            }
            _ => Err(place.error("give exactly one of \"through\": [x, y] and \"center\": [x, y]")),
        }
    }
}

impl From<Arc> for ArcKeys {
    fn from(arc: Arc) -> Self {
        match arc {
            Arc::Through(point) => Self { through: Some(point), ..Self::default() },
            Arc::Center { center, is_clockwise } => Self {
                center: Some(center),
                clockwise: is_clockwise.then_some(true),
                ..Self::default()
            },
        }
    }
}
