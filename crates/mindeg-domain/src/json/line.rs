//! Lines inside a domain in JSON.

use glam::DVec2;
use mindeg_mesh::LineKind;
use mindeg_mesh::planar::InRing;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::side::SideKeys;
use crate::constraints::SideConstraint;
use crate::error::{DomainError, Place};
use crate::outline::Ring;
use crate::side::Side;

/// A line inside the domain: `corners` with `sides`, `intervals` or `size`, or all its `points`
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct LineKeys {
    /// `[x, y]` of each corner, from end to end. An end may lie on a side, a hole or another line, which is split there
    /// if it is straight and has no point there
    #[schemars(with = "Option<Vec<[f64; 2]>>")]
    corners: Option<Vec<DVec2>>,
    /// Instead: all points of the line, `[x, y]`, which come back bit for bit
    #[schemars(with = "Option<Vec<[f64; 2]>>")]
    points: Option<Vec<DVec2>>,
    /// Whether it ends where it begins; so does a line of one corner
    closed: Option<bool>,
    /// One entry for each side, from the first corner on
    sides: Option<Vec<SideKeys>>,
    /// The number of intervals of every side that says nothing else. It stays as it is
    #[schemars(range(min = 1))]
    intervals: Option<u64>,
    /// The target interval length of every side that says nothing else, which goes before that of the domain. Interior
    /// points may divide such a side further
    #[schemars(extend("exclusiveMinimum" = 0))]
    size: Option<f64>,
    /// The name of every side without its own, which becomes a group in mesh files
    name: Option<String>,
    /// Which boundary ocean models take it for
    kind: Option<LineKind>,
}

impl LineKeys {
    /// The line that these describe.
    pub(super) fn line(self, index: usize, size: Option<f64>) -> Result<Ring, DomainError> {
        let place = Place::key("lines").then(index);
        let error = |message: &str| Err(place.clone().error(message));
        let ring = match (self.corners, self.points) {
            (Some(corners), None) => {
                let is_closed = self.closed.unwrap_or(corners.len() == 1);
                let count = corners.len().saturating_sub(usize::from(!is_closed));
                let given = self.sides.unwrap_or_else(|| vec![SideKeys::default(); count]);
                let size = match self.intervals {
                    Some(_) => None,
                    None => self.size.or(size),
                };
                let side = |(index, side): (usize, SideKeys)| {
                    let at = InRing { ring: 0, index };
                    let (side, constraint) = side.or_intervals(self.intervals).side(at, size)?;
                    if side.matches.is_some() {
                        let place = Place::side(at).then("match");
                        return Err(
                            place.error("sides of rings alone are periodic; drop \"match\"")
                        );
                    }
                    match constraint == SideConstraint::default() {
                        true => Ok(side),
                        false => Err(Place::side(at).error("degrees are limited at the boundary only; \
                                                           drop \"max_degree\" and \"outside_degree\"")),
                    }
                };
                let sides = given.into_iter().enumerate().map(side).collect::<Result<Vec<_>, _>>();
                let name = format!("line {}", index + 1);
                Ring { corners, sides: sides.map_err(|error| error.within(place.clone(), &name))? }
            }
            (None, Some(points)) => {
                if self.sides.is_some() || self.intervals.is_some() || self.size.is_some() {
                    return error(
                        "a line of \"points\" is divided by them; drop \"sides\", \"intervals\" and \"size\"",
                    );
                }
                match &points[..] {
                    [_, _, _, ..] if self.closed == Some(true) => Ring::of_points(points),
                    [first, between @ .., last] if self.closed != Some(true) => Ring {
                        corners: vec![*first, *last],
                        sides: vec![Side::points(between.to_vec())],
                    },
                    _ => return error("a line needs at least 2 points, and 3 if it is closed"),
                }
            }
            (Some(_), Some(_)) => {
                return error("a line has either \"corners\" or \"points\"; drop one");
            }
            (None, None) => {
                return error(
                    "the key \"corners\" or \"points\" is missing; give \"corners\": [[x, y], …] and \
                     \"intervals\", \"size\" or \"sides\", or \"points\": [[x, y], …]",
                );
            }
        };
        let named = |side: Side| Side {
            name: side.name.or_else(|| self.name.clone()),
            kind: side.kind.or(self.kind),
            ..side
        };
        Ok(Ring { sides: ring.sides.into_iter().map(named).collect(), ..ring })
    }

    /// The description of a line.
    pub(super) fn of(line: &Ring) -> Self {
        let Ring { corners, sides } = line;
        Self {
            corners: Some(corners.clone()),
            closed: (corners.len() > 1 && !line.is_open()).then_some(true),
            sides: Some(sides.iter().cloned().map(SideKeys::of_side).collect()),
            ..Self::default()
        }
    }
}
