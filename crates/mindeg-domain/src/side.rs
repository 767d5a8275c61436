//! One side of a domain: its curve and its division.
//!
//! Limits: the number of intervals from a size is a rounded quotient of 64-bit floats.

use glam::DVec2;
use mindeg_core::MAX_VERTICES;
use mindeg_mesh::LineKind;
use mindeg_mesh::number;

use crate::curve::Curve;
use crate::error::{DomainError, Place};
use crate::matching::SideMatch;
use crate::spacing::Spacing;

/// One side of a ring: its curve from its corner to the next, and its division.
#[derive(Clone, Debug, PartialEq)]
pub struct Side {
    /// The curve of the side.
    pub curve: Curve,
    /// The number of intervals.
    pub intervals: Intervals,
    /// The spacing of the points, in the direction of the side.
    pub spacing: Spacing,
    /// A name, for the groups of mesh files.
    pub name: Option<String>,
    /// The kind of boundary.
    pub kind: Option<LineKind>,
    /// The side of the same ring that this one is, moved. In a [`Domain`](crate::Domain) its curve and division are
    /// then those of that side.
    pub matches: Option<SideMatch>,
}

/// The number of intervals of a side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Intervals {
    /// This number, at least 1.
    Count(u64),
    /// The number that gives intervals of about this length: the side's length divided by it,
    /// rounded, at least 1.
    Size(f64),
    /// One interval from each point of a [`Curve::Polyline`] to the next: these points are the
    /// boundary's, bit for bit. One interval if the side has no points.
    Points,
}

impl Side {
    /// A side of `intervals` even intervals.
    pub fn count(intervals: u64) -> Self {
        Self {
            curve: Curve::Line,
            intervals: Intervals::Count(intervals),
            spacing: Spacing::Uniform,
            name: None,
            kind: None,
            matches: None,
        }
    }

    /// A side of even intervals of about the length `size`.
    pub fn size(size: f64) -> Self {
        Self { intervals: Intervals::Size(size), ..Self::count(1) }
    }

    /// A side with points at the given parameters, strictly increasing in (0, 1).
    pub fn parameters(parameters: Vec<f64>) -> Self {
        Self::count(parameters.len() as u64 + 1).spaced(Spacing::Parameters(parameters))
    }

    /// A side with the given boundary points, bit for bit, between its two corners.
    ///
    /// # Example
    ///
    /// ```
    /// use glam::DVec2;
    /// use mindeg_domain::{Domain, Side};
    ///
    /// let own = [[3.0, 0.1], [1.0, 0.1]].map(DVec2::from);
    /// let sides = vec![Side::points(own.to_vec()), Side::count(1), Side::count(1)];
    /// let domain = Domain::polygon([[4.0, 0.0], [0.0, 0.0], [2.0, -1.0]], sides)?;
    /// assert_eq!(domain.placement().points().skip(1).take(2).collect::<Vec<_>>(), own);
    /// # Ok::<(), mindeg_domain::DomainError>(())
    /// ```
    pub fn points(points: Vec<DVec2>) -> Self {
        let curve = Curve::Polyline(points);
        Self { curve, intervals: Intervals::Points, ..Self::count(1) }
    }

    /// The same side along another curve.
    #[must_use]
    pub fn along(self, curve: Curve) -> Self {
        Self { curve, ..self }
    }

    /// The same side with another spacing law.
    #[must_use]
    pub fn spaced(self, spacing: Spacing) -> Self {
        Self { spacing, ..self }
    }

    /// The same side with a name.
    #[must_use]
    pub fn named(self, name: impl Into<String>) -> Self {
        Self { name: Some(name.into()), ..self }
    }

    /// The same side as another one, moved.
    #[must_use]
    pub fn matching(self, other: SideMatch) -> Self {
        Self { matches: Some(other), ..self }
    }

    /// The same side from its end to its start.
    pub(crate) fn reversed(self) -> Self {
        Self { curve: self.curve.reversed(), spacing: self.spacing.reversed(), ..self }
    }
}

impl Intervals {
    /// The number of intervals of a side of some length with `points` of its own.
    pub(crate) fn on(self, length: f64, points: usize) -> Result<u64, DomainError> {
        match self {
            Self::Count(count) => Ok(count),
            Self::Points => Ok(points as u64 + 1),
            Self::Size(size) if size > 0.0 && size.is_finite() => {
                let intervals = (length / size).round().max(1.0);
                if intervals > f64::from(MAX_VERTICES) {
                    return Err(Place::key("size").error(format!(
                        "the size {size:?} makes {} intervals, and a boundary has at most \
                         {MAX_VERTICES} vertices; give a larger size",
                        number(intervals)
                    )));
                }
                Ok(intervals as u64)
            }
            Self::Size(size) => Err(Place::key("size")
                .error(format!("the size is {size:?}; it must be a finite number above 0"))),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_size_gives_the_nearest_count() {
        for (size, count) in [(1.0, 4), (1.1, 4), (1.2, 3), (100.0, 1), (0.5, 8)] {
            assert_eq!(Intervals::Size(size).on(4.0, 0), Ok(count), "{size}");
        }
        assert_eq!(Intervals::Size(1.0).on(4_294_967_294.0, 0), Ok(u64::from(MAX_VERTICES)));
        let message = |size: f64| Intervals::Size(size).on(4.0, 0).unwrap_err().to_string();
        assert_eq!(message(0.0), "the size is 0.0; it must be a finite number above 0");
        assert_eq!(
            message(1e-300),
            "the size 1e-300 makes 4e300 intervals, and a boundary has at most 4294967294 vertices; give a larger size"
        );
    }
}
