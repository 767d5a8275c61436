//! The sides of rings and lines as given, and their division.

use glam::DVec2;
use mindeg_mesh::planar::InRing;

use crate::curve::{Curve, Path};
use crate::error::{DomainError, Place};
use crate::limits::MAX_STORED_VERTICES;
use crate::outline::Ring;
use crate::placement::Placement;
use crate::side::{Intervals, Side};
use crate::spacing::Spacing;
use crate::spacing_law::SpacingLaw;

/// A side between its corners.
#[derive(Clone, Copy)]
pub(crate) struct Given<'a> {
    pub(crate) at: InRing,
    pub(crate) start: DVec2,
    pub(crate) end: DVec2,
    pub(crate) side: &'a Side,
}

/// The sides of all rings.
pub(crate) fn given_sides(given: &[Ring]) -> impl Iterator<Item = Given<'_>> {
    given.iter().enumerate().flat_map(|(ring, given)| sides_of(ring, given))
}

/// The sides of a ring or line.
pub(crate) fn sides_of(ring: usize, given: &Ring) -> impl Iterator<Item = Given<'_>> {
    let Ring { corners, sides } = given;
    sides.iter().enumerate().map(move |(index, side)| Given {
        at: InRing { ring, index },
        start: corners[index],
        end: corners[(index + 1) % corners.len()],
        side,
    })
}

impl Given<'_> {
    /// The points of a side of a line, without its end.
    pub(crate) fn points(&self) -> Result<Vec<DVec2>, DomainError> {
        let path = self.path()?;
        let count = u32::try_from(self.intervals(&path)?).ok();
        let count = count.filter(|count| (1..=MAX_STORED_VERTICES).contains(count));
        let Some(intervals) = count else {
            let message = format!("a line has 1 to {MAX_STORED_VERTICES} intervals on each side");
            return Err(Place::key("intervals").error(message).of_side(self.at));
        };
        let law = self.law(&self.side.spacing, intervals, &path)?;
        if self.side.curve == Curve::Line {
            Placement::check_intervals(self.start, self.end, &law, self.at)?;
        }
        let mut points = Vec::new();
        self.fill_points(&path, &law, &mut points);
        Ok(points)
    }

    pub(crate) fn fill_points(&self, path: &Path, law: &SpacingLaw, points: &mut Vec<DVec2>) {
        points.push(self.start);
        match self.side.intervals {
            Intervals::Points => points.extend_from_slice(self.side.curve.points()),
            _ => points.extend((1..law.intervals()).map(|i| path.point(law.parameter(i)))),
        }
    }

    pub(crate) fn path(&self) -> Result<Path, DomainError> {
        Path::new(&self.side.curve, self.start, self.end).map_err(|error| error.of_side(self.at))
    }

    pub(crate) fn intervals(&self, path: &Path) -> Result<u64, DomainError> {
        let points = match &self.side.curve {
            Curve::Polyline(points) => points.len(),
            _ => 0,
        };
        let Side { intervals, spacing, .. } = self.side;
        if *intervals == Intervals::Points && *spacing != Spacing::Uniform {
            let message =
                "the side has its own points, so a spacing law has nothing to say; drop the law";
            return Err(Place::key("spacing").error(message).of_side(self.at));
        }
        intervals.on(path.length(), points).map_err(|error| error.of_side(self.at))
    }

    pub(crate) fn law(
        &self,
        spacing: &Spacing,
        intervals: u32,
        path: &Path,
    ) -> Result<SpacingLaw, DomainError> {
        SpacingLaw::solve(spacing, intervals, path.length()).map_err(|error| error.of_side(self.at))
    }
}
