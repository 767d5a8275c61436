//! From a description to a checked domain.

use glam::DVec2;
use mindeg_mesh::planar::InRing;

use crate::constraints::Constraints;
use crate::divided::{Divided, Placed, side_count};
use crate::domain::Domain;
use crate::error::{DomainError, Place};
use crate::inside::Inside;
use crate::joined;
use crate::matching::{Move, SideMatch};
use crate::noding;
use crate::outline::{Outline, Ring};
use crate::periodic::{self, Periodic};
use crate::rectangle::Rectangle;
use crate::side::Side;
use crate::split::split_sides;
use crate::turning::Turning;

impl Domain {
    /// A domain from its outline and one [`Side`] for each of the outline's sides.
    ///
    /// Corners given clockwise are reversed. Each side stays on its edge (with its spacing law
    /// [reversed](crate::Spacing::reversed)); the first corner stays first, and the side that ended
    /// there now starts there. [`notes`](Self::notes) reports it.
    ///
    /// O(k log k) for k straight sides of a convex outline, and linear in explicit parameters; O(n
    /// log n) for n points of any other outline.
    ///
    /// # Errors
    ///
    /// The first fault, in this order: a measure of the rectangle; the count, magnitude or distance
    /// of corners; the number of sides; their names; their intervals; their spacing laws; points so
    /// close that f64 cannot tell them apart; a boundary that crosses or touches itself.
    pub fn new(outline: Outline, sides: Vec<Side>) -> Result<Self, DomainError> {
        Self::builder(outline, sides).build()
    }

    /// Starts a domain with holes, constraints or a name.
    ///
    /// # Example
    ///
    /// ```
    /// use mindeg_domain::{Domain, Outline, Rectangle, Ring, Side};
    ///
    /// let outline = Outline::Rectangle(Rectangle::new(4.0, 3.0));
    /// let slot = Ring::new([[1.0, 1.0], [3.0, 1.0], [3.0, 2.0]], vec![Side::size(0.5); 3]);
    /// let domain = Domain::builder(outline, vec![Side::count(4); 4]).hole(slot).build()?;
    /// assert_eq!(domain.rings().ring(1), 16..26);
    /// assert_eq!(domain.placement().area(), 11.0);
    /// // A hole runs clockwise in the mesh, from its first corner on.
    /// assert_eq!(domain.placement().corners()[5].to_array(), [3.0, 2.0]);
    /// # Ok::<(), mindeg_domain::DomainError>(())
    /// ```
    pub fn builder(outline: Outline, sides: Vec<Side>) -> DomainBuilder {
        DomainBuilder::new(outline, sides)
    }

    /// The domain inside the first ring and outside the others.
    ///
    /// # Errors
    ///
    /// The errors of [`Domain::new`], and rings that cross, touch or do not nest.
    pub fn of_rings(rings: Vec<Ring>) -> Result<Self, DomainError> {
        let mut rings = rings.into_iter();
        let Ring { corners, sides } = rings.next().unwrap_or_default();
        rings.fold(Self::builder(Outline::Polygon(corners), sides), DomainBuilder::hole).build()
    }

    /// The domain inside the first ring of points and outside the others. Its boundary points are
    /// the given points, bit for bit. Each ring is one side.
    ///
    /// # Errors
    ///
    /// The errors of [`Domain::of_rings`].
    ///
    /// # Example
    ///
    /// ```
    /// use mindeg_domain::Domain;
    ///
    /// let square = |x: f64, size: f64| [[x, x], [x + size, x], [x + size, x + size], [x, x + size]];
    /// let domain = Domain::from_rings([square(0.0, 3.0), square(1.0, 1.0)])?;
    /// assert_eq!(domain.rings().vertex_count(), 8);
    /// assert_eq!(domain.placement().point(5).to_array(), [1.0, 2.0]); // a hole runs clockwise
    /// # Ok::<(), mindeg_domain::DomainError>(())
    /// ```
    pub fn from_rings<R: IntoIterator<Item: Into<DVec2>>>(
        rings: impl IntoIterator<Item = R>,
    ) -> Result<Self, DomainError> {
        Self::of_rings(rings.into_iter().map(Ring::of_points).collect())
    }

    /// [`Domain::new`] for an upright rectangle with its first corner at the origin. Its sides
    /// are bottom, right, top and left.
    ///
    /// # Errors
    ///
    /// The errors of [`Domain::new`].
    pub fn rectangle(width: f64, height: f64, sides: Vec<Side>) -> Result<Self, DomainError> {
        Self::new(Outline::Rectangle(Rectangle::new(width, height)), sides)
    }

    /// [`Domain::new`] for the polygon with the given corners.
    ///
    /// # Errors
    ///
    /// The errors of [`Domain::new`].
    ///
    /// # Example
    ///
    /// ```
    /// use mindeg_domain::{Domain, Side};
    ///
    /// let domain = Domain::polygon([[0.0, 0.0], [4.0, 0.0], [0.0, 3.0]], vec![Side::count(2); 3])?;
    /// assert_eq!(domain.placement().area(), 6.0);
    /// # Ok::<(), mindeg_domain::DomainError>(())
    /// ```
    pub fn polygon(
        corners: impl IntoIterator<Item = impl Into<DVec2>>,
        sides: Vec<Side>,
    ) -> Result<Self, DomainError> {
        let corners = corners.into_iter().map(Into::into).collect();
        Self::new(Outline::Polygon(corners), sides)
    }

    /// The same domain with other sides, one for each [side](Self::sides) in the same order.
    ///
    /// # Errors
    ///
    /// The errors of [`Domain::new`].
    pub fn with_sides(&self, sides: Vec<Side>) -> Result<Self, DomainError> {
        self.rebuilt(sides, self.inside.clone())
    }

    /// The same domain with some sides that are others, moved: the names of each and of the other. The move is a translation
    /// where one fits, else a rotation.
    ///
    /// # Errors
    ///
    /// A name that no side has, or several; sides that do not fit.
    ///
    /// # Example
    ///
    /// ```
    /// use mindeg_domain::{Domain, Side};
    ///
    /// let strip = Domain::rectangle(4.0, 3.0, vec![Side::count(4); 4])?;
    /// let ring = strip.with_periodic(&[("side 2".to_owned(), "side 4".to_owned())])?;
    /// assert_eq!(ring.periodic().map(|periodic| periodic.sides().len()), Some(1));
    /// # Ok::<(), mindeg_domain::DomainError>(())
    /// ```
    pub fn with_periodic(&self, pairs: &[(String, String)]) -> Result<Self, DomainError> {
        let mut domain = self.clone();
        for (name, of) in pairs {
            let is_called = |&side: &usize| domain.side_name(side) == *name;
            let is_indexed = |&side: &usize| domain.rings().in_ring(side).side() == *name;
            let all = 0..domain.sides().len();
            let mut found: Vec<usize> = all.clone().filter(is_called).collect();
            if found.is_empty() {
                found.extend(all.clone().find(is_indexed));
            }
            let [side] = found[..] else {
                let names: Vec<String> =
                    all.map(|side| format!("{:?}", domain.side_name(side))).collect();
                let found = if found.is_empty() { "no side is" } else { "several sides are" };
                let names = names.join(", ");
                let message =
                    format!("{found} called {name:?}; sides are {names}, or \"side 2\" by index");
                return Err(Place::key("sides").error(message));
            };
            let with = |by: Move| {
                let mut sides = domain.sides().to_vec();
                sides[side].matches = Some(SideMatch { of: of.clone(), by });
                domain.with_sides(sides)
            };
            domain = match with(Move::Translation) {
                Ok(domain) => domain,
                Err(error) => with(Move::Rotation).map_err(|_| error)?,
            };
        }
        Ok(domain)
    }

    /// The same domain with other constraints on degrees, as of [`DomainBuilder::constraints`].
    ///
    /// # Errors
    ///
    /// Constraints that do not fit, or that no mesh keeps.
    pub fn with_constraints(&self, constraints: Constraints) -> Result<Self, DomainError> {
        let domain = Self { constraints, ..self.clone() };
        domain.rebuilt(domain.sides().to_vec(), domain.inside.clone())
    }

    pub(crate) fn rebuilt(&self, sides: Vec<Side>, inside: Inside) -> Result<Self, DomainError> {
        let rings = self.rings();
        if sides.len() != rings.side_count() {
            return Err(side_count(0, rings.side_count(), sides.len()));
        }
        let mut sides = sides.into_iter();
        let mut of_ring = |ring| sides.by_ref().take(rings.ring_sides(ring).len()).collect();
        let mut builder = Self::builder(self.outline.clone(), of_ring(0)).inside(inside);
        for ring in 1..rings.ring_count() {
            let corners = self.placement.corners()[rings.ring_sides(ring)].to_vec();
            builder = builder.hole(Ring { corners, sides: of_ring(ring) });
        }
        let domain = builder.constraints(self.constraints.clone()).build()?;
        let (name, interior) = (self.name.clone(), self.interior.clone());
        let (projection, turned) = (self.projection, self.turned.clone());
        Ok(Self { name, interior, projection, turned, ..domain })
    }
}

/// A domain under construction; [`Domain::builder`] starts one.
#[derive(Clone, Debug, PartialEq)]
pub struct DomainBuilder {
    outline: Outline,
    sides: Vec<Side>,
    holes: Vec<Ring>,
    inside: Inside,
    constraints: Constraints,
    max_vertices: u32,
    is_noded: bool,
}

impl DomainBuilder {
    pub(crate) fn new(outline: Outline, sides: Vec<Side>) -> Self {
        let (holes, constraints) = (Vec::new(), Constraints::default());
        let inside = Inside::default();
        let (max_vertices, is_noded) = (u32::MAX, false);
        Self { outline, sides, holes, inside, constraints, max_vertices, is_noded }
    }

    /// Adds a hole. It lies inside the outline, outside all other holes, and touches none of them;
    /// it may run either way round.
    #[must_use]
    pub fn hole(mut self, hole: Ring) -> Self {
        self.holes.push(hole);
        self
    }

    /// Sets lines, points and regions. A line that ends within a straight side gives that side a corner there.
    #[must_use]
    pub fn inside(self, inside: Inside) -> Self {
        Self { inside, ..self }
    }

    /// Gives lines that cross each other corners there, which are refused otherwise. [`Domain::notes`] says where.
    #[must_use]
    pub fn noded(self) -> Self {
        Self { is_noded: true, ..self }
    }

    /// Sets constraints on degrees. Their sides are the sides of the outline and then of each hole, in
    /// the order given, and stay on their edges if a ring is reversed; single vertices have their index
    /// in the mesh, ring after ring.
    #[must_use]
    pub fn constraints(self, constraints: Constraints) -> Self {
        Self { constraints, ..self }
    }

    /// Sets the maximum number of boundary vertices: a domain with more is refused before its points
    /// take time and memory.
    #[must_use]
    pub fn max_vertices(self, max_vertices: u32) -> Self {
        Self { max_vertices, ..self }
    }

    /// Builds the domain.
    ///
    /// # Errors
    ///
    /// The errors of [`Domain::new`]; lines and points that touch or cross each other or the rings elsewhere than at a
    /// vertex, or leave the domain; regions that share a face or lie in none; then constraints that do not fit or that no
    /// mesh keeps.
    pub fn build(self) -> Result<Domain, DomainError> {
        let Self { outline, sides, holes, mut inside, mut constraints, .. } = self;
        let max = self.max_vertices;
        let corners = outline.corners()?;
        let mut given = vec![Ring { corners, sides }];
        given.extend(holes);

        periodic::divide(&mut given)?;
        let mut divided = Divided::new(&given)?;
        inside.check()?;
        let mut splits = Vec::new();
        if self.is_noded {
            splits.extend(noding::node(&mut inside, joined::reach(&divided.points(&given)?))?);
        }
        constraints.check_side_count(divided.rings.side_count())?;
        // A side that is split gets other points, where another line may have ended.
        while inside.lines.iter().any(Ring::is_open) {
            let points = divided.points(&given)?;
            let new = split_sides(&points, &mut given, &mut inside, &mut constraints)?;
            if new.is_empty() {
                break;
            }
            splits.extend(new);
            periodic::divide(&mut given)?;
            divided = Divided::new(&given)?;
        }
        let vertices = divided.rings.vertex_count();
        if vertices > max {
            return Err(Place::default().error(format!(
                "the boundary has {vertices} points; at most {max} are wanted here; use fewer \
                     intervals"
            )));
        }
        let Placed { placement, straight, turned, line_starts, point_vertices } =
            divided.placed(&mut given, &mut inside)?;
        for &ring in &turned {
            constraints.turn_sides(placement.rings().ring_sides(ring));
        }
        let turning = Turning { placement: &placement, straight: &straight };
        let periodic = Periodic::new(&given, placement.rings())?;
        let has_lines = !inside.lines.is_empty() || !inside.points.is_empty();
        let convex = if has_lines || periodic.is_some() { None } else { turning.convex_form() };
        if convex.is_none() {
            placement.check_exactness()?;
        }
        let constraints = constraints.checked(turning, |side| {
            let side = placement.rings().in_ring(side);
            if turned.contains(&side.ring) {
                let sides = placement.rings().ring_sides(side.ring).len();
                InRing { index: sides - 1 - side.index, ..side }
            } else {
                side
            }
        })?;
        let outline = match outline {
            Outline::Rectangle(_) if !turned.contains(&0) && given[0].corners.len() == 4 => outline,
            _ => Outline::Polygon(std::mem::take(&mut given[0].corners)),
        };
        let faces = match placement.boundary() {
            Some(boundary) if !(inside.lines.is_empty() && inside.regions.is_empty()) => {
                Some(joined::faces(boundary, &inside.regions)?.into())
            }
            _ => None,
        };
        let domain = Domain {
            name: None,
            inside,
            line_starts,
            point_vertices,
            faces,
            periodic: periodic.map(Into::into),
            splits,
            outline,
            convex,
            sides: given.into_iter().flat_map(|ring| ring.sides).collect(),
            placement: placement.into(),
            straight,
            constraints,
            interior: None,
            projection: None,
            turned,
        };
        domain.check_unnamed()?;
        Ok(domain)
    }
}
