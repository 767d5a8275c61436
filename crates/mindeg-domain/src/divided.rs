//! Rings divided into boundary points and placed.
//!
//! All sides are checked and divided as given, so that errors name the input. A convex outline with straight
//! sides stays a formula. For any other domain the points are computed and stored, and the sweep of
//! `mindeg_mesh::planar` checks all of them. Then rings that run the wrong way are reversed.

use std::ops::Range;

use glam::DVec2;
use mindeg_mesh::place;
use mindeg_mesh::planar::{PlanarBoundary, Turn, ring_name};

use crate::curve::{Curve, Path};
use crate::error::{DomainError, Place};
use crate::given::{Given, given_sides, sides_of};
use crate::inside::Inside;
use crate::intersection;
use crate::joined::Joined;
use crate::limits::{MAX_STORED_VERTICES, STRAIGHT};
use crate::name;
use crate::outline::{self, Ring};
use crate::placement::Placement;
use crate::rings::Rings;
use crate::side::Side;
use crate::spacing_law::SpacingLaw;
use crate::turning::{Orientation, Turning};

/// Rings whose sides are checked and divided.
pub(crate) struct Divided {
    pub(crate) rings: Rings,
    /// The path of each side.
    paths: Vec<Path>,
    /// The law of each side.
    laws: Vec<SpacingLaw>,
}

/// Placed rings, each the right way round.
pub(crate) struct Placed {
    pub(crate) placement: Placement,
    /// Whether each side is straight.
    pub(crate) straight: Vec<bool>,
    /// The rings that were given the wrong way round.
    pub(crate) turned: Vec<usize>,
    /// The first segment of each side of each line, then the number of segments.
    pub(crate) line_starts: Vec<u32>,
    pub(crate) point_vertices: Vec<u32>,
}

impl Divided {
    pub(crate) fn new(given: &[Ring]) -> Result<Self, DomainError> {
        for (ring, given) in given.iter().enumerate() {
            outline::check_corners(ring, given)?;
        }
        for (ring, Ring { corners, sides }) in given.iter().enumerate() {
            if sides.len() != corners.len() {
                return Err(side_count(ring, corners.len(), sides.len()));
            }
        }
        for side in given_sides(given) {
            if let Some(name) = &side.side.name {
                name::check(name, Place::side(side.at).then("name"), &side.at.side())?;
            }
        }
        let paths = given_sides(given).map(|side| side.path()).collect::<Result<Vec<_>, _>>()?;
        let mut of_sides = paths.iter();
        let mut intervals = Vec::with_capacity(given.len());
        for (ring, given) in given.iter().enumerate() {
            let of_ring = sides_of(ring, given).zip(of_sides.by_ref());
            let of_ring = of_ring.map(|(side, path)| side.intervals(path));
            intervals.push(of_ring.collect::<Result<Vec<u64>, DomainError>>()?);
        }
        let rings = Rings::new(&intervals)?;
        let of_sides = given_sides(given).zip(&paths).zip(rings.sides());
        let laws =
            of_sides.map(|((side, path), intervals)| side.law(&side.side.spacing, intervals, path));
        Ok(Self { laws: laws.collect::<Result<_, _>>()?, rings, paths })
    }

    /// Reverses the rings that run the wrong way, and places all rings and what is inside them.
    pub(crate) fn placed(
        self,
        given: &mut [Ring],
        inside: &mut Inside,
    ) -> Result<Placed, DomainError> {
        let is_line = |side: Given<'_>| side.side.curve == Curve::Line;
        for (side, law) in given_sides(given).zip(&self.laws).filter(|&(side, _)| is_line(side)) {
            Placement::check_intervals(side.start, side.end, law, side.at)?;
        }
        if given.len() > 1 || !inside.is_empty() || !given_sides(given).all(is_line) {
            return self.stored(given, inside);
        }
        let straight = vec![true; self.laws.len()];
        let formula = self.formula(given);
        let turning = Turning { placement: &formula, straight: &straight };
        let Some(orientation) = turning.convex_orientation(0) else {
            return self.stored(given, inside);
        };
        formula.check_corners(|side| turning.at(formula.rings().corner(side)) == Turn::Straight)?;
        if orientation == Orientation::CounterClockwise {
            return Ok(Placed {
                placement: formula,
                straight,
                turned: Vec::new(),
                line_starts: vec![0],
                point_vertices: Vec::new(),
            });
        }
        // Solved in the order given, so that errors name the sides as given.
        let of_sides = given_sides(given).zip(&self.paths).zip(self.rings.sides());
        let laws = of_sides.map(|((side, path), intervals)| {
            side.law(&side.side.spacing.reversed(), intervals, path)
        });
        let mut laws = laws.collect::<Result<Vec<_>, _>>()?;
        laws.reverse();
        let mut intervals: Vec<u64> = self.rings.sides().map(u64::from).collect();
        intervals.reverse();
        turn(&mut given[0]);
        let turned = Self { rings: Rings::new(&[intervals])?, laws, ..self };
        let placement = turned.formula(given);
        let (turned, point_vertices) = (vec![0], Vec::new());
        Ok(Placed { placement, straight, turned, line_starts: vec![0], point_vertices })
    }

    fn formula(&self, given: &[Ring]) -> Placement {
        let corners = given.iter().flat_map(|ring| ring.corners.iter().copied()).collect();
        Placement::straight(self.rings.clone(), corners, self.laws.clone())
    }

    /// The points of all sides, ring by ring.
    pub(crate) fn points(&self, given: &[Ring]) -> Result<Vec<DVec2>, DomainError> {
        let mut points = memory_for(self.rings.vertex_count())?;
        for ((side, path), law) in given_sides(given).zip(&self.paths).zip(&self.laws) {
            side.fill_points(path, law, &mut points);
        }
        Ok(points)
    }

    /// Stores the points one by one, after checking all of them.
    fn stored(self, given: &mut [Ring], inside: &mut Inside) -> Result<Placed, DomainError> {
        let points = self.points(given)?;
        let Self { rings, paths, .. } = self;
        let mut straight = Vec::with_capacity(paths.len());
        for (index, side) in given_sides(given).enumerate() {
            let first = rings.corner(index) as usize;
            let own = &points[first..first + rings.intervals(index) as usize];
            straight.push(match side.side.curve {
                Curve::Line => true,
                _ => is_straight(own, side.end).map_err(|error| error.of_side(side.at))?,
            });
        }
        let mut lengths: Vec<f64> = paths.iter().map(Path::length).collect();
        let of_ring = |ring: Range<u32>| &points[ring.start as usize..ring.end as usize];
        let slices: Vec<&[DVec2]> = rings.rings().map(of_ring).collect();
        let joined = Joined::new(&points, inside)?;
        let (boundary, turned) = PlanarBoundary::map(&slices, &joined.points, &joined.lines)
            .map_err(|faults| intersection::errors(&faults, &points, &rings, &joined))?;
        let of_sides = |ring| rings.ring_sides(ring).map(|side| u64::from(rings.intervals(side)));
        let mut intervals: Vec<Vec<u64>> =
            (0..rings.ring_count()).map(|ring| of_sides(ring).collect()).collect();
        for &ring in &turned {
            turn(&mut given[ring]);
            intervals[ring].reverse();
            let sides = rings.ring_sides(ring);
            lengths[sides.clone()].reverse();
            straight[sides].reverse();
        }
        let placement = Placement::stored(Rings::new(&intervals)?, boundary, lengths);
        let runs = Turning { placement: &placement, straight: &straight }.runs();
        let placement = placement.with_runs(runs);
        let in_mesh = |&vertex: &u32| match points.get(vertex as usize) {
            Some(_) if turned.contains(&rings.ring_of(vertex)) => {
                let ring = rings.ring(rings.ring_of(vertex));
                if vertex == ring.start { vertex } else { ring.start + ring.end - vertex }
            }
            _ => vertex,
        };
        let point_vertices = joined.point_vertices.iter().map(in_mesh).collect();
        Ok(Placed { placement, straight, turned, line_starts: joined.starts, point_vertices })
    }
}

/// The error of a ring whose number of sides is not its number of corners.
pub(crate) fn side_count(ring: usize, corners: usize, sides: usize) -> DomainError {
    let are = if sides == 1 { "side is" } else { "sides are" };
    Place::ring(ring).then("sides").error(format!(
        "{sides} {are} described and {} has {corners}; describe each side once",
        ring_name(ring)
    ))
}

/// Room for points that are stored.
fn memory_for(vertices: u32) -> Result<Vec<DVec2>, DomainError> {
    /// The additional memory of the checks, for each point.
    const BYTES: usize = 48;
    let max = MAX_STORED_VERTICES;
    if vertices > max {
        return Err(Place::default().error(format!(
            "the boundary has {vertices} points; a domain that is not convex with straight sides \
                 takes at most {max}; use fewer intervals"
        )));
    }
    let mut points = Vec::new();
    let count = vertices as usize;
    let is_free = Vec::<[u8; BYTES]>::new()
        .try_reserve_exact(count)
        .and_then(|()| points.try_reserve_exact(count));
    match is_free {
        Ok(()) => Ok(points),
        Err(_) => Err(Place::default().error(format!(
            "not enough memory for a boundary of {vertices} points; use fewer intervals"
        ))),
    }
}

/// Reverses the corners of a ring, but keeps the first corner.
fn turn(ring: &mut Ring) {
    ring.corners[1..].reverse();
    ring.sides.reverse();
    for side in &mut ring.sides {
        *side = std::mem::replace(side, Side::count(1)).reversed();
    }
}

/// Whether the points of a side lie on the line to its end, within [`STRAIGHT`] of its length; such
/// points must be in order on the line.
fn is_straight(points: &[DVec2], end: DVec2) -> Result<bool, DomainError> {
    let [start, own @ ..] = points else { return Ok(true) };
    let chord = end - start;
    let length = chord.length();
    let along = |point: &DVec2| (point - start).dot(chord / length);
    if length == 0.0
        || own
            .iter()
            .any(|point| (point - start).perp_dot(chord).abs() > STRAIGHT * length * length)
    {
        return Ok(false);
    }
    let mut before = 0.0;
    for (index, point) in own.iter().enumerate() {
        let share = along(point);
        if share <= before || share >= length {
            return Err(Place::key("points").then(index).error(format!(
                "point {} at {} is not farther along the straight side than the one before; list the points in the order in \
                 which they lie on it",
                index + 1,
                place(*point)
            )));
        }
        before = share;
    }
    Ok(true)
}
