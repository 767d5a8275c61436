//! From a description to a checked domain.
//!
//! All sides are checked and divided as they were given, so that errors name what was given. A
//! convex outline with straight sides stays a formula. Of any other domain the points are computed
//! and stored, and the sweep of `simple.rs` checks all of them. Then rings that run the wrong way are
//! turned.
//!
//! Limits: a domain whose points are stored has at most
//! [`MAX_STORED_VERTICES`](crate::MAX_STORED_VERTICES).

use std::ops::Range;

use glam::DVec2;

use crate::constraints::Constraints;
use crate::domain::Domain;
use crate::domain_error::DomainError;
use crate::intersection;
use crate::limits::MAX_STORED_VERTICES;
use crate::name;
use crate::outline::{self, Outline, OutlineError, Ring};
use crate::placement::{Placement, SidePoints};
use crate::rings::{InRing, Rings};
use crate::side::{Side, SideError};
use crate::spacing_law::SpacingLaw;
use crate::turning::{Orientation, Turn, Turning};

/// A domain in the making; [`Domain::builder`] starts one.
#[derive(Clone, Debug, PartialEq)]
pub struct DomainBuilder {
    outline: Outline,
    sides: Vec<Side>,
    holes: Vec<Ring>,
    constraints: Constraints,
}

impl DomainBuilder {
    pub(crate) fn new(outline: Outline, sides: Vec<Side>) -> Self {
        Self { outline, sides, holes: Vec::new(), constraints: Constraints::default() }
    }

    /// With another hole. It lies inside the outline, outside all other holes, and touches none of
    /// them; either way round.
    #[must_use]
    pub fn hole(mut self, hole: Ring) -> Self {
        self.holes.push(hole);
        self
    }

    /// With constraints on degrees. Their sides are those of the outline and then those of each hole,
    /// in the order given; single vertices are those of the mesh, ring after ring.
    #[must_use]
    pub fn constraints(self, constraints: Constraints) -> Self {
        Self { constraints, ..self }
    }

    /// The domain.
    ///
    /// # Errors
    ///
    /// See [`Domain::new`] and [`Domain::constrained`].
    pub fn build(self) -> Result<Domain, DomainError> {
        let Self { outline, sides, holes, mut constraints } = self;
        let corners = outline.corners().map_err(OutlineError::from)?;
        let mut given = vec![Ring { corners, sides }];
        given.extend(holes);

        let divided = Divided::new(&given)?;
        constraints.check_side_count(divided.rings.side_count())?;
        let Placed { placement, straight, turned } = divided.placed(&mut given)?;
        for &ring in &turned {
            constraints.turn_sides(placement.rings().ring_sides(ring));
        }
        let turning = Turning { placement: &placement, straight: &straight };
        let constraints = constraints.checked(turning).map_err(|error| {
            error.with_side(|side| {
                if turned.contains(&side.ring) {
                    let sides = placement.rings().ring_sides(side.ring).len();
                    InRing { index: sides - 1 - side.index, ..side }
                } else {
                    side
                }
            })
        })?;
        let outline = match outline {
            Outline::Rectangle(_) if !turned.contains(&0) => outline,
            _ => Outline::Polygon(std::mem::take(&mut given[0].corners)),
        };
        Ok(Domain {
            name: None,
            outline,
            convex: turning.convex_form(),
            sides: given.into_iter().flat_map(|ring| ring.sides).collect(),
            placement,
            straight,
            constraints,
            interior: None,
            turned,
        })
    }
}

/// Rings whose sides are checked and divided.
struct Divided {
    rings: Rings,
    /// The law of each side.
    laws: Vec<SpacingLaw>,
}

/// Rings in place, each the right way round.
struct Placed {
    placement: Placement,
    /// Whether each side is straight.
    straight: Vec<bool>,
    /// The rings that were given the other way round.
    turned: Vec<usize>,
}

impl Divided {
    fn new(given: &[Ring]) -> Result<Self, DomainError> {
        for (ring, Ring { corners, .. }) in given.iter().enumerate() {
            outline::check_corners(ring, corners)?;
        }
        for (ring, Ring { corners, sides }) in given.iter().enumerate() {
            if sides.len() != corners.len() {
                let (corners, sides) = (corners.len(), sides.len());
                return Err(DomainError::SideCount { ring, corners, sides });
            }
        }
        name::check_all(given_sides(given).map(|side| (side.at, side.side.name.as_deref())))?;
        let intervals = |ring, given| {
            let on = |side: Given<'_>| side.intervals();
            sides_of(ring, given).map(on).collect::<Result<Vec<u64>, DomainError>>()
        };
        let intervals = given.iter().enumerate().map(|(ring, given)| intervals(ring, given));
        let rings = Rings::new(&intervals.collect::<Result<Vec<_>, _>>()?)?;
        let laws =
            given_sides(given).zip(rings.sides()).map(|(side, intervals)| side.law(intervals));
        Ok(Self { laws: laws.collect::<Result<_, _>>()?, rings })
    }

    /// Turns the rings that run the wrong way, and places all.
    fn placed(self, given: &mut [Ring]) -> Result<Placed, DomainError> {
        for (side, law) in given_sides(given).zip(&self.laws) {
            Placement::check_intervals(side.start, side.end, law, side.at)?;
        }
        let straight = vec![true; self.laws.len()];
        let formula = self.formula(given);
        let turning = Turning { placement: &formula, straight: &straight };
        let convex = if given.len() == 1 { turning.convex_orientation(0) } else { None };
        let Some(orientation) = convex else { return self.stored(given, straight) };
        formula.check_corners(|side| turning.at(formula.rings().corner(side)) == Turn::Straight)?;
        if orientation == Orientation::CounterClockwise {
            return Ok(Placed { placement: formula, straight, turned: Vec::new() });
        }
        turn(&mut given[0]);
        let turned = Self::new(given).map_err(|error| match error {
            DomainError::Side { side, source } => {
                let index = straight.len() - 1 - side.index;
                DomainError::Side { side: InRing { index, ..side }, source }
            }
            error => error,
        })?;
        Ok(Placed { placement: turned.formula(given), straight, turned: vec![0] })
    }

    fn formula(&self, given: &[Ring]) -> Placement {
        let corners = given.iter().flat_map(|ring| ring.corners.iter().copied()).collect();
        Placement::straight(self.rings.clone(), corners, self.laws.clone())
    }

    /// The points one by one, after all of them are checked.
    fn stored(self, given: &mut [Ring], mut straight: Vec<bool>) -> Result<Placed, DomainError> {
        let Self { rings, laws } = self;
        let mut points = memory_for(rings.vertex_count())?;
        for (side, law) in given_sides(given).zip(&laws) {
            let on_side = SidePoints { first: 0, start: side.start, span: side.span(), law };
            points.extend((0..law.intervals()).map(|i| on_side.point(i)));
        }
        let mut lengths: Vec<f64> = given_sides(given).map(|side| side.length()).collect();
        let mut intervals: Vec<Vec<u64>> = Vec::with_capacity(given.len());
        let mut turned = Vec::new();
        let orientations = intersection::orientations(&points, &rings)?;
        for (ring, orientation) in orientations.into_iter().enumerate() {
            let sides = rings.ring_sides(ring);
            let of_sides = sides.clone().map(|side| u64::from(rings.intervals(side)));
            if (orientation == Orientation::CounterClockwise) == (ring == 0) {
                intervals.push(of_sides.collect());
                continue;
            }
            intervals.push(of_sides.rev().collect());
            turn(&mut given[ring]);
            lengths[sides.clone()].reverse();
            straight[sides].reverse();
            let Range { start, end } = rings.ring(ring);
            points[start as usize + 1..end as usize].reverse();
            turned.push(ring);
        }
        let placement = Placement::stored(Rings::new(&intervals)?, points, lengths);
        Ok(Placed { placement, straight, turned })
    }
}

/// Room for points that are stored.
fn memory_for(vertices: u32) -> Result<Vec<DVec2>, DomainError> {
    /// What the checks take besides, for each point.
    const BYTES: usize = 48;
    let max = MAX_STORED_VERTICES;
    if vertices > max {
        return Err(DomainError::TooManyStored { vertices, max });
    }
    let mut points = Vec::new();
    let count = vertices as usize;
    let is_free = Vec::<[u8; BYTES]>::new()
        .try_reserve_exact(count)
        .and_then(|()| points.try_reserve_exact(count));
    match is_free {
        Ok(()) => Ok(points),
        Err(_) => Err(DomainError::NoMemory { vertices }),
    }
}

/// Gives the corners of a ring in the other order, from the same first corner.
fn turn(ring: &mut Ring) {
    ring.corners[1..].reverse();
    ring.sides.reverse();
    for side in &mut ring.sides {
        *side = std::mem::replace(side, Side::count(1)).reversed();
    }
}

/// A side between its corners.
#[derive(Clone, Copy)]
struct Given<'a> {
    at: InRing,
    start: DVec2,
    end: DVec2,
    side: &'a Side,
}

/// The sides of all rings.
fn given_sides(given: &[Ring]) -> impl Iterator<Item = Given<'_>> {
    given.iter().enumerate().flat_map(|(ring, given)| sides_of(ring, given))
}

/// The sides of a ring.
fn sides_of(ring: usize, given: &Ring) -> impl Iterator<Item = Given<'_>> {
    let Ring { corners, sides } = given;
    sides.iter().enumerate().map(move |(index, side)| Given {
        at: InRing { ring, index },
        start: corners[index],
        end: corners[(index + 1) % corners.len()],
        side,
    })
}

impl Given<'_> {
    fn span(&self) -> DVec2 {
        self.end - self.start
    }

    fn length(&self) -> f64 {
        self.end.distance(self.start)
    }

    fn error(&self, source: impl Into<SideError>) -> DomainError {
        DomainError::Side { side: self.at, source: source.into() }
    }

    fn intervals(&self) -> Result<u64, DomainError> {
        self.side.intervals.on(self.length()).map_err(|source| self.error(source))
    }

    fn law(&self, intervals: u32) -> Result<SpacingLaw, DomainError> {
        SpacingLaw::solve(&self.side.spacing, intervals, self.length())
            .map_err(|source| self.error(source))
    }
}
