//! The open water, the land and the islands of a coastal model, as kinds of sides.

use std::ops::Range;

use glam::DVec2;
use mindeg_mesh::{Bounds, LineKind, number};

use crate::build::DomainBuilder;
use crate::domain::Domain;
use crate::error::{DomainError, Place};
use crate::on_box::BOX_SIDES;
use crate::opening::{Asked, Opening, openings};
use crate::outline::{Outline, Ring};
use crate::side::{Intervals, Side};

/// A part of the outer boundary that is open water.
#[derive(Clone, Debug, PartialEq)]
pub enum OpenWater {
    /// The edges on the sides of the box around the domain; if it was projected, also of the box around its degrees.
    Box,
    /// The sides of a name.
    Side(String),
    /// The boundary from the vertex nearest to the first point to that nearest to the second, with the domain on the left, on the
    /// ring that both lie nearest to; points are in degrees if the domain was projected.
    Between([DVec2; 2]),
}

/// An end of open water is no farther from the boundary than this share of the size of all domains.
const FAR: f64 = 0.1;

impl Domain {
    /// The same points, with sides that are open water, land or island. Sides end where open water does, and rings begin there.
    ///
    /// Sides that have no name are called open, land or island, so that a file has few long boundaries; with [`OpenWater::Box`] so
    /// are those that have their name from the box around degrees. Other names stay, and so does a kind, but for open water.
    /// Of the stretches that are on the box the longest is open: a box cuts bays and straits, too. With a `least_length` all
    /// stretches are open that are no shorter. The others are land; all are told.
    ///
    /// # Errors
    ///
    /// A part that the boundary does not have; a domain with limits of degrees, whose sides would have to be split.
    ///
    /// # Example
    ///
    /// ```
    /// use mindeg_domain::{Domain, LineKind, OpenWater};
    ///
    /// // A bay with its mouth in the south.
    /// let bay = Domain::from_rings([[[0.0, 0.0], [4.0, 0.0], [3.0, 2.0], [1.0, 1.5]]])?;
    /// let (bay, openings) = bay.with_open_water(&[OpenWater::Box], None)?;
    /// assert!(openings.len() == 1 && openings[0].is_open && openings[0].length == 4.0);
    /// let sides: Vec<_> = bay.sides().iter().map(|side| (side.name.as_deref(), side.kind)).collect();
    /// assert_eq!(sides[0], (Some("open"), Some(LineKind::Open)));
    /// assert!(sides[1..].iter().all(|side| *side == (Some("land"), Some(LineKind::Land))));
    /// # Ok::<(), mindeg_domain::DomainError>(())
    /// ```
    pub fn with_open_water(
        &self,
        parts: &[OpenWater],
        least_length: Option<f64>,
    ) -> Result<(Self, Vec<Opening>), DomainError> {
        let all = Self::all_with_open_water(std::slice::from_ref(self), parts, least_length)?;
        let (mut new, openings) = all;
        Ok((new.swap_remove(0), openings))
    }

    /// [`with_open_water`](Self::with_open_water) of domains beside each other, such as seas that land parts: the box is that around all, sides of a
    /// name are open wherever they are, and the stretch between two points is on the one that is nearest to them. The
    /// others have land and islands alone. Each has its own longest stretch.
    ///
    /// # Errors
    ///
    /// A part that no domain has; those of [`with_open_water`](Self::with_open_water).
    pub fn all_with_open_water(
        domains: &[Self],
        parts: &[OpenWater],
        least_length: Option<f64>,
    ) -> Result<(Vec<Self>, Vec<Opening>), DomainError> {
        let bounds = domains.iter().map(|domain| domain.placement().bounds());
        let whole = Bounds::of(bounds.flat_map(|bounds| [bounds.min, bounds.max]));
        let size = whole.map_or(0.0, |whole| whole.size().length());
        let has_box = parts.contains(&OpenWater::Box);
        let of_box = if has_box { Self::edges_on_box(domains) } else { Vec::new() };
        let none = |domain: &Self| vec![Asked::default(); domain.rings().vertex_count() as usize];
        let mut asked: Vec<Vec<Asked>> = domains.iter().map(none).collect();
        for part in parts {
            let nearest = match part {
                OpenWater::Between(ends) => {
                    ends.iter().try_for_each(|end| Self::check_end(domains, *end, size))?;
                    let distances = domains.iter().map(|domain| domain.distance_of(ends));
                    distances.enumerate().min_by(|a, b| a.1.total_cmp(&b.1)).map(|it| it.0)
                }
                _ => None,
            };
            let mut is_anywhere = false;
            for (index, (domain, asked)) in domains.iter().zip(&mut asked).enumerate() {
                if nearest.is_some_and(|nearest| nearest != index) {
                    continue;
                }
                let edges = match part {
                    OpenWater::Box => of_box[index].clone(),
                    OpenWater::Side(name) => {
                        domain.edges_of_sides(|side| domain.side_name(side) == *name)
                    }
                    OpenWater::Between(ends) => domain.edges_between(ends),
                };
                is_anywhere |= !edges.is_empty();
                for edge in edges {
                    let edge = &mut asked[edge as usize];
                    match part {
                        OpenWater::Box => edge.is_of_box = true,
                        OpenWater::Side(_) | OpenWater::Between(_) => edge.by_place = true,
                    }
                }
            }
            if !is_anywhere {
                return Err(nowhere(part, domains));
            }
        }
        for (domain, asked) in domains.iter().zip(&mut asked) {
            let is_open = |edge: u32| {
                domain.sides()[domain.rings().side_of(edge)].kind == Some(LineKind::Open)
            };
            (0..).zip(asked).for_each(|(edge, own)| own.is_given = is_open(edge));
        }
        let lost = if has_box { &BOX_SIDES[..] } else { &[] };
        let mut found = Vec::new();
        let mut opened = |(domain, mut asked): (&Self, Vec<Asked>)| {
            found.extend(openings(domain, &mut asked, least_length));
            let is_open: Vec<bool> = asked.into_iter().map(Asked::is_open).collect();
            domain.opened(&is_open, domain.projection.map_or(&[], |_| lost))
        };
        let new: Result<_, _> = domains.iter().zip(asked).map(&mut opened).collect();
        Ok((new?, found))
    }

    /// The domain with open edges: whether each one is. Some names of sides are lost.
    fn opened(&self, is_open: &[bool], lost: &[&str]) -> Result<Self, DomainError> {
        let rings = self.rings();
        let mut new: Vec<Ring> = Vec::new();
        let mut is_split = false;
        for ring in 0..rings.ring_count() {
            let mut own = Ring::default();
            for side in rings.ring_sides(ring) {
                let given = &self.sides()[side];
                let first = rings.corner(side);
                let edges = first..first + rings.intervals(side);
                let mark = |edge: u32| is_open[edge as usize];
                let mut starts: Vec<u32> = vec![first];
                starts.extend(edges.clone().skip(1).filter(|edge| mark(*edge) != mark(edge - 1)));
                is_split |= starts.len() > 1;
                for (at, &start) in starts.iter().enumerate() {
                    let end = starts.get(at + 1).copied().unwrap_or(edges.end);
                    let part = match starts.len() {
                        1 => given.clone(),
                        _ => {
                            let points = (start + 1..end).map(|it| self.placement().point(it));
                            let side = Side::points(points.collect());
                            let is_single = side.intervals == Intervals::Points && end == start + 1;
                            let side = if is_single { Side::count(1) } else { side };
                            Side { name: given.name.clone(), kind: given.kind, ..side }
                        }
                    };
                    own.corners.push(self.placement().point(start));
                    own.sides.push(told(part, ring > 0, mark(start), lost));
                }
            }
            if !self.is_constrained() {
                begin_with_a_stretch(&mut own);
            }
            new.push(own);
        }
        if is_split && self.is_constrained() {
            return Err(Place::default().error(
                "open water would split sides of a domain with limits of degrees: give its sides a \"kind\" in JSON",
            ));
        }
        if self.is_constrained() {
            return self.with_sides(new.into_iter().flat_map(|ring| ring.sides).collect());
        }
        self.of_new_rings(new)
    }

    fn of_new_rings(&self, rings: Vec<Ring>) -> Result<Self, DomainError> {
        let mut rings = rings.into_iter();
        let Ring { corners, sides } = rings.next().unwrap_or_default();
        let builder: DomainBuilder = Self::builder(Outline::Polygon(corners), sides);
        let builder = rings.fold(builder, DomainBuilder::hole).inside(self.inside().clone());
        let domain = builder.build()?;
        Ok(Self {
            name: self.name.clone(),
            interior: self.interior.clone(),
            projection: self.projection,
            ..domain
        })
    }

    /// The vertex of a ring that is nearest to a point, and how far that is, squared.
    fn nearest(&self, ring: Range<u32>, point: DVec2) -> (u32, f64) {
        let point = self.projection.map_or(point, |projection| projection.to_plane(point));
        let distance = |vertex: u32| self.placement().point(vertex).distance_squared(point);
        let all = ring.clone().map(|vertex| (vertex, distance(vertex)));
        all.min_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or((ring.start, f64::INFINITY))
    }

    /// How far the nearest vertex of the boundary is from a point, which is in degrees if the domain was projected.
    #[must_use]
    pub fn distance_to_boundary(&self, point: DVec2) -> f64 {
        let distances = self.rings().rings().map(|ring| self.nearest(ring, point).1);
        libm::sqrt(distances.fold(f64::INFINITY, f64::min))
    }

    /// The ring that two points lie nearest to together, the vertices there that are nearest to them, and how far these are, squared.
    fn nearest_ring(&self, ends: &[DVec2; 2]) -> Option<(Range<u32>, [u32; 2], f64)> {
        let of = |ring: Range<u32>| {
            let [a, b] = ends.map(|end| self.nearest(ring.clone(), end));
            (ring, [a.0, b.0], a.1 + b.1)
        };
        self.rings().rings().map(of).min_by(|a, b| a.2.total_cmp(&b.2))
    }

    /// Refuses an end of open water that is no place of a domain, or far from all.
    fn check_end(domains: &[Self], end: DVec2, size: f64) -> Result<(), DomainError> {
        let wrong = |problem: String| Err(Place::default().error(problem));
        let is_projected = domains.iter().any(|domain| domain.projection.is_some());
        if is_projected && (end.x.abs() > 360.0 || end.y.abs() > 90.0) {
            return wrong(format!(
                "({}, {}) is no longitude and latitude, and the domain was drawn in degrees: give those",
                end.x, end.y
            ));
        }
        let distances = domains.iter().map(|domain| domain.distance_to_boundary(end));
        let distance = distances.fold(f64::INFINITY, f64::min);
        if distance > size * FAR {
            let unit = if is_projected { " m" } else { "" };
            return wrong(format!(
                "({}, {}) is {}{unit} from the nearest vertex of the boundary, more than a tenth of the size of all domains: give points on the \
                 boundary, x (longitude) first",
                end.x,
                end.y,
                number(distance)
            ));
        }
        Ok(())
    }

    /// How far the boundary is from two points together, squared.
    fn distance_of(&self, ends: &[DVec2; 2]) -> f64 {
        self.nearest_ring(ends).map_or(f64::INFINITY, |found| found.2)
    }

    /// The first vertices of the edges of some sides.
    pub(crate) fn edges_of_sides(&self, is_wanted: impl Fn(usize) -> bool) -> Vec<u32> {
        let rings = self.rings();
        let sides = (0..rings.side_count()).filter(|side| is_wanted(*side));
        sides
            .flat_map(|side| rings.corner(side)..rings.corner(side) + rings.intervals(side))
            .collect()
    }

    /// The first vertices of the edges between two points.
    fn edges_between(&self, ends: &[DVec2; 2]) -> Vec<u32> {
        let Some((ring, [from, to], _)) = self.nearest_ring(ends) else { return Vec::new() };
        let count = ring.len() as u32;
        let steps = (to + count - from) % count;
        (0..steps).map(|step| ring.start + (from - ring.start + step) % count).collect()
    }
}

/// The refusal of a part that no domain has.
fn nowhere(part: &OpenWater, domains: &[Domain]) -> DomainError {
    let message = match part {
        OpenWater::Box => "no side is on the box around the domain: name one, or give two points between which the boundary is \
             open"
            .to_owned(),
        OpenWater::Between([a, b]) => {
            format!("({}, {}) and ({}, {}) are nearest to one point of the boundary", a.x, a.y, b.x, b.y)
        }
        OpenWater::Side(name) => {
            let of = |domain: &Domain| -> Vec<String> {
                (0..domain.rings().side_count()).map(|side| domain.side_name(side)).collect()
            };
            let mut names: Vec<String> = domains.iter().flat_map(of).collect();
            names.sort_unstable();
            names.dedup();
            format!("no side is called {name:?}; there are {}", first_names(&names))
        }
    };
    Place::default().error(message)
}

/// The first of sorted names, and how many more there are. Names that say something come before those that only count sides.
#[must_use]
pub fn first_names(names: &[String]) -> String {
    const MOST: usize = 10;
    let number = |name: &str| name.rsplit(' ').next().and_then(|word| word.parse::<u32>().ok());
    let mut names: Vec<&String> = names.iter().collect();
    names.sort_by_key(|name| {
        let own = number(name);
        let start =
            own.map_or(name.as_str(), |_| name.trim_end_matches(|c: char| c.is_ascii_digit()));
        (own.is_some(), start, own)
    });
    let first: Vec<&str> = names.iter().take(MOST).map(|name| name.as_str()).collect();
    let first = first.join(", ");
    match names.len().saturating_sub(MOST) {
        0 => first,
        more => format!("{first} and {more} more"),
    }
}

/// Turns a ring so that it begins where its kind changes, or else where its names do: no stretch is in two parts.
fn begin_with_a_stretch(ring: &mut Ring) {
    let differ = |a: &Side, b: &Side| a.kind != b.kind;
    let has_one_kind = ring.sides.windows(2).all(|pair| !differ(&pair[0], &pair[1]));
    let differ = |a: &Side, b: &Side| differ(a, b) || has_one_kind && a.name != b.name;
    let (Some(first), Some(last)) = (ring.sides.first(), ring.sides.last()) else { return };
    if differ(first, last) {
        return;
    }
    if let Some(at) = ring.sides.windows(2).position(|pair| differ(&pair[0], &pair[1])) {
        ring.sides.rotate_left(at + 1);
        ring.corners.rotate_left(at + 1);
    }
}

/// A side with its kind, and with the name of its kind if it has none, or one that is lost.
fn told(side: Side, is_hole: bool, is_open: bool, lost: &[&str]) -> Side {
    let kind = match side.kind {
        _ if is_open => LineKind::Open,
        Some(kind) => kind,
        None if is_hole => LineKind::Island,
        None => LineKind::Land,
    };
    let name = side.name.clone().filter(|name| !lost.contains(&&**name));
    Side { name: name.or(Some(kind.name().to_owned())), kind: Some(kind), ..side }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The names, kinds and lengths of sides.
    fn sides(domain: &Domain) -> Vec<(String, LineKind, u32)> {
        let side = |side: usize| {
            let own = &domain.sides()[side];
            (own.name.clone().unwrap(), own.kind.unwrap(), domain.rings().intervals(side))
        };
        (0..domain.sides().len()).map(side).collect()
    }

    fn bay() -> Domain {
        let outer = vec![[0.0, 0.0], [2.0, 0.0], [4.0, 0.0], [4.0, 3.0], [3.0, 2.9], [0.0, 3.0]];
        let island = vec![[1.0, 1.0], [1.0, 2.0], [2.0, 1.5]];
        Domain::from_rings([outer, island]).unwrap()
    }

    #[test]
    fn open_water_is_found_on_the_box_by_name_and_between_points() {
        let open = LineKind::Open;
        let (land, island) = (LineKind::Land, ("island".to_owned(), LineKind::Island, 3));
        let told = |name: &str, kind, count| (name.to_owned(), kind, count);
        let (found, _) = bay().with_open_water(&[OpenWater::Box], Some(0.0)).unwrap();
        assert_eq!(
            sides(&found),
            [told("land", land, 2), told("open", open, 1), told("open", open, 3), island.clone()]
        );
        let sorted = |domain: &Domain| {
            let mut points: Vec<_> =
                domain.placement().points().map(|it| it.to_array().map(f64::to_bits)).collect();
            points.sort_unstable();
            points
        };
        assert_eq!(sorted(&found), sorted(&bay()));
        // From the upper left corner counter-clockwise to the lower right one.
        let between = OpenWater::Between([[-0.1, 3.2], [4.1, 0.2]].map(DVec2::from));
        let (found, _) = bay().with_open_water(&[between], None).unwrap();
        assert_eq!(
            sides(&found),
            [told("land", land, 3), told("open", open, 1), told("open", open, 2), island]
        );
        let named = Side { name: Some("strait".to_owned()), ..Side::count(2) };
        let domain = Domain::rectangle(
            2.0,
            1.0,
            vec![Side::count(2), named, Side::count(2), Side::count(1)],
        )
        .unwrap();
        // Between points it passes by sides with and without names: one stretch, and the names stay.
        let around = OpenWater::Between([[0.0, 0.0], [1.0, 1.0]].map(DVec2::from));
        let (found, openings) = domain.with_open_water(&[around], None).unwrap();
        let open_sides = |domain: &Domain| -> Vec<String> {
            sides(domain).into_iter().filter(|side| side.1 == open).map(|side| side.0).collect()
        };
        assert_eq!((openings.len(), &*open_sides(&found).join(" ")), (1, "open strait open"));
        let (found, _) = domain.with_open_water(&[OpenWater::Box], None).unwrap();
        assert!(open_sides(&found).contains(&"strait".to_owned()));
        let strait = OpenWater::Side("strait".to_owned());
        let (found, _) = domain.with_open_water(&[strait], None).unwrap();
        assert!(sides(&found).contains(&told("strait", open, 2)), "{:?}", sides(&found));
        assert_eq!(sides(&found).iter().filter(|side| side.1 == open).count(), 1);
    }

    #[test]
    fn several_domains_are_open_on_the_box_around_all() {
        let square = |x: f64, y: f64| {
            let ring = [[x, y], [x + 1.0, y], [x + 1.0, y + 1.0], [x, y + 1.0]];
            Domain::from_rings([ring]).unwrap()
        };
        // The one in the middle is on no side of the box around all.
        let domains = [square(0.0, 0.0), square(2.0, 2.0), square(4.0, 4.0)];
        let open = |parts: &[OpenWater]| -> Vec<u32> {
            let (found, _) = Domain::all_with_open_water(&domains, parts, None).unwrap();
            let of = |domain: &Domain| -> u32 {
                let sides = sides(domain).into_iter();
                sides.filter(|side| side.1 == LineKind::Open).map(|side| side.2).sum()
            };
            assert!(found.iter().flat_map(sides).all(|side| ["open", "land"].contains(&&*side.0)));
            found.iter().map(of).collect()
        };
        assert_eq!(open(&[OpenWater::Box]), [2, 0, 2]);
        let between = OpenWater::Between([[2.1, 1.9], [3.1, 1.9]].map(DVec2::from));
        assert_eq!(open(&[between]), [0, 1, 0]);
        let nix = [OpenWater::Side("nix".to_owned())];
        let error = Domain::all_with_open_water(&domains, &nix, None).unwrap_err().to_string();
        assert!(error.contains("no side is called \"nix\""), "{error}");
    }

    #[test]
    fn short_stretches_are_closed() {
        // One stretch around the first point, 10 long.
        let found = |least| bay().with_open_water(&[OpenWater::Box], Some(least)).unwrap().0;
        let open = |domain: &Domain| -> u32 {
            sides(domain).iter().filter(|side| side.1 == LineKind::Open).map(|side| side.2).sum()
        };
        assert_eq!([open(&found(9.9)), open(&found(10.1))], [4, 0]);
        let between = |ends: [[f64; 2]; 2]| OpenWater::Between(ends.map(DVec2::from));
        let parts = [between([[0.0, 0.0], [2.0, 0.0]]), between([[4.0, 0.0], [4.0, 3.0]])];
        assert_eq!(open(&bay().with_open_water(&parts, Some(2.5)).unwrap().0), 1);
    }

    #[test]
    fn of_a_box_the_longest_stretch_is_open_and_all_are_told() {
        // Mouths of 2, 3 and 1 in the south, in the east, and in the north.
        let corners = [[0.0, 0.0], [2.0, 0.0], [3.0, 1.0], [4.0, 1.0], [4.0, 4.0], [3.0, 3.0]];
        let ring = [&corners[..], &[[2.0, 4.0], [1.0, 4.0], [0.5, 2.0]]].concat();
        let sea = Domain::from_rings([ring]).unwrap();
        let told = |parts: &[OpenWater], least| -> Vec<(f64, bool)> {
            let (domain, openings) = sea.with_open_water(parts, least).unwrap();
            let open = sides(&domain).iter().filter(|side| side.1 == LineKind::Open).count();
            assert_eq!(open, openings.iter().filter(|opening| opening.is_open).count());
            openings.iter().map(|opening| (opening.length, opening.is_open)).collect()
        };
        let of_box = told(&[OpenWater::Box], None);
        assert_eq!(of_box, [(3.0, true), (1.0, false), (2.0, false)]);
        let all = told(&[OpenWater::Box], Some(0.0));
        assert_eq!(all, [(3.0, true), (1.0, true), (2.0, true)]);
        assert!(told(&[OpenWater::Box], Some(1.5))[1..] == [(1.0, false), (2.0, true)]);
        // A stretch between two points is open, and the box has its longest one beside it.
        let north = OpenWater::Between([[2.0, 4.0], [1.0, 4.0]].map(DVec2::from));
        let both = told(&[OpenWater::Box, north], None);
        assert_eq!(both, [(3.0, true), (1.0, true), (2.0, false)]);
        // The longest of the box stays the one, also where it was named by points.
        let east = OpenWater::Between([[4.0, 1.0], [4.0, 4.0]].map(DVec2::from));
        assert_eq!(told(&[OpenWater::Box, east], None), of_box);
        let (_, openings) = sea.with_open_water(&[OpenWater::Box], None).unwrap();
        assert_eq!(openings[1].ends, [[2.0, 4.0], [1.0, 4.0]].map(DVec2::from));
    }

    #[test]
    fn points_beside_an_island_open_its_shore_and_open_sides_of_a_file_are_one_stretch() {
        let open = |domain: &Domain| -> Vec<(String, u32)> {
            let sides = sides(domain).into_iter().filter(|side| side.1 == LineKind::Open);
            sides.map(|side| (side.0, side.2)).collect()
        };
        let between = OpenWater::Between([[0.9, 0.9], [1.0, 2.1]].map(DVec2::from));
        let (found, openings) = bay().with_open_water(&[between], None).unwrap();
        assert_eq!((open(&found), openings.len()), (vec![("open".to_owned(), 1)], 1));
        assert_eq!(openings[0].ends, [[1.0, 1.0], [1.0, 2.0]].map(DVec2::from));
        // Two names beside each other, and a stretch over the ring's start.
        let side = |name: &str, kind| Side { kind, ..Side::count(2).named(name.to_owned()) };
        let [water, land] = [LineKind::Open, LineKind::Land].map(Some);
        let given =
            [side("west", water), side("quay", land), side("north", water), side("far", water)];
        let domain = Domain::rectangle(2.0, 1.0, given.to_vec()).unwrap();
        let (found, openings) = domain.with_open_water(&[], Some(100.0)).unwrap();
        assert_eq!(openings.len(), 1);
        assert!(openings[0].is_open);
        let names: Vec<_> = open(&found).into_iter().map(|side| side.0).collect();
        assert_eq!(names, ["north", "far", "west"]);
    }

    #[test]
    fn parts_that_are_not_there_are_refused() {
        let diamond =
            Domain::from_rings([[[0.0, -1.0], [1.0, 0.0], [0.0, 1.0], [-1.0, 0.0]]]).unwrap();
        let [near, far] = [DVec2::new(1.05, 0.0), DVec2::new(5.0, 5.0)];
        for (part, words) in [
            (OpenWater::Box, "no side is on the box"),
            (OpenWater::Side("nix".to_owned()), "there are side 1"),
            (OpenWater::Between([near; 2]), "nearest to one point"),
            (OpenWater::Between([near, far]), "(5, 5) is 6.403 from the nearest vertex"),
        ] {
            let error = diamond.with_open_water(&[part], None).unwrap_err().to_string();
            assert!(error.contains(words), "{error}");
        }
    }
}
