//! The box around all points in degrees, whose longitudes go on across the antimeridian.

use glam::DVec2;

use crate::nesting::contains;
use crate::outline::{DrawnRing, Feature};

/// The scale is looked at in so many places across the box, where they lie inside.
const LATTICE: u32 = 13;
/// Coordinates nearer to each other, in degrees, are one.
pub(super) const NEAR: f64 = 1e-9;

/// A longitude from -180, which is left out, to 180.
pub(super) fn turned(longitude: f64) -> f64 {
    let turned = longitude - 360.0 * libm::ceil((longitude - 180.0) / 360.0);
    if longitude.abs() < 180.0 { longitude } else { turned }
}

/// The box around all points in degrees.
pub(super) struct BoxSides {
    /// Longitudes count from here.
    origin: f64,
    least: DVec2,
    most: DVec2,
}

impl BoxSides {
    pub(super) fn of(points: impl Iterator<Item = DVec2>) -> Self {
        let mut sides =
            Self { origin: f64::NAN, least: DVec2::INFINITY, most: DVec2::NEG_INFINITY };
        for point in points {
            if sides.origin.is_nan() {
                sides.origin = point.x;
            }
            let at = sides.place(point);
            sides.least = sides.least.min(at);
            sides.most = sides.most.max(at);
        }
        sides
    }

    pub(super) fn place(&self, point: DVec2) -> DVec2 {
        DVec2::new(turned(point.x - self.origin), point.y)
    }

    /// Places all over the box that lie in a polygon, in degrees.
    pub(super) fn inside(&self, features: &[Feature]) -> Vec<DVec2> {
        let share = |index: u32| (f64::from(index) + 0.5) / f64::from(LATTICE);
        let at = |x, y| self.least + (self.most - self.least) * DVec2::new(share(x), share(y));
        let places = (0..LATTICE).flat_map(|y| (0..LATTICE).map(move |x| at(x, y)));
        let ring = |drawn: &DrawnRing| -> Vec<DVec2> {
            drawn.pieces.iter().map(|piece| self.place(piece.start)).collect()
        };
        let polygons: Vec<Vec<Vec<DVec2>>> =
            features.iter().map(|feature| feature.rings.iter().map(ring).collect()).collect();
        let is_in = |place: &DVec2| {
            let around = |rings: &Vec<Vec<DVec2>>| {
                rings.iter().filter(|ring| contains(ring, std::slice::from_ref(place))).count()
            };
            polygons.iter().any(|rings| around(rings) % 2 == 1)
        };
        let degrees = |place: DVec2| DVec2::new(turned(place.x + self.origin), place.y);
        places.filter(is_in).map(degrees).collect()
    }

    /// The name of the side on which both ends of an edge lie.
    pub(super) fn name(&self, ends: [DVec2; 2]) -> Option<&'static str> {
        let [a, b] = ends.map(|end| self.place(end));
        let is_on = |axis: usize, side: DVec2| {
            (a[axis] - side[axis]).abs() < NEAR && (b[axis] - side[axis]).abs() < NEAR
        };
        [
            ("south", 1, self.least),
            ("east", 0, self.most),
            ("north", 1, self.most),
            ("west", 0, self.least),
        ]
        .into_iter()
        .find_map(|(name, axis, side)| is_on(axis, side).then_some(name))
    }
}
