//! A region of the globe, of which a projection is made.

use glam::DVec2;

/// The farthest that a region may reach from the centre of an azimuthal projection, in degrees.
const AZIMUTHAL_REACH: f64 = 90.0;

/// The region that some points in degrees are in, on the globe: neither the antimeridian nor a pole is special.
///
/// # Example
///
/// ```
/// use mindeg_domain::{GlobeRegion, Projection};
/// use glam::DVec2;
///
/// let fiji = [[177.0, -18.5], [-179.5, -16.0]].map(DVec2::from);
/// let region = GlobeRegion::of(fiji).expect("two points");
/// assert_eq!(Projection::of_region(&region)?.to_string(), "+proj=utm +zone=60 +south +datum=WGS84");
/// # Ok::<(), String>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct GlobeRegion {
    points: Vec<DVec2>,
    /// The direction of its middle, from the centre of the globe.
    middle: [f64; 3],
}

impl GlobeRegion {
    /// The region around some points; none without a point, or for points all around the globe.
    pub fn of(points: impl IntoIterator<Item = DVec2>) -> Option<Self> {
        let points: Vec<DVec2> = points.into_iter().collect();
        let (mut least, mut most) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for direction in points.iter().map(|point| direction(*point)) {
            for axis in 0..3 {
                least[axis] = least[axis].min(direction[axis]);
                most[axis] = most[axis].max(direction[axis]);
            }
        }
        let middle = [0, 1, 2].map(|axis| (least[axis] + most[axis]) / 2.0);
        let is_told = middle.iter().map(|it| it * it).sum::<f64>() > 1e-6;
        is_told.then_some(Self { points, middle })
    }

    /// The middle in degrees, to half a degree, so that its projection has a short definition.
    pub(super) fn center(&self) -> Result<DVec2, String> {
        let [x, y, z] = self.middle;
        let halves = |radians: f64| libm::round(radians.to_degrees() * 2.0) / 2.0 + 0.0;
        let center = DVec2::new(
            halves(libm::atan2(y, x)),
            halves(libm::atan2(z, libm::sqrt(x * x + y * y))),
        );
        let own = direction(center);
        let nearest = self
            .points
            .iter()
            .map(|point| direction(*point).iter().zip(own).map(|(a, b)| a * b).sum::<f64>());
        let farthest = libm::acos(nearest.fold(1.0, f64::min).clamp(-1.0, 1.0)).to_degrees();
        if farthest < AZIMUTHAL_REACH {
            return Ok(center);
        }
        Err(format!(
            "the region reaches {farthest:.0}° around the globe from its middle, and one plane holds less than \
             {AZIMUTHAL_REACH}°: choose a part of it, or --project none"
        ))
    }

    /// The longitude in the middle, and how far the points reach from it.
    pub(super) fn longitudes(&self) -> Result<[f64; 2], String> {
        let center = libm::atan2(self.middle[1], self.middle[0]).to_degrees();
        let (mut least, mut most) = (0.0_f64, 0.0_f64);
        for point in &self.points {
            let offset = wrapped(point.x - center);
            (least, most) = (least.min(offset), most.max(offset));
        }
        if most - least > 180.0 {
            return Err("the region goes around a pole or half of the globe: choose stereographic"
                .to_owned());
        }
        Ok([wrapped(center + (least + most) / 2.0), (most - least) / 2.0])
    }

    pub(super) fn latitudes(&self) -> [f64; 2] {
        let latitudes = self.points.iter().map(|point| point.y);
        latitudes.fold([90.0, -90.0], |[least, most], it| [f64::min(least, it), f64::max(most, it)])
    }
}

/// The direction of a point in degrees from the centre of a globe.
fn direction(degrees: DVec2) -> [f64; 3] {
    let [longitude, latitude] = [degrees.x.to_radians(), degrees.y.to_radians()];
    let radius = libm::cos(latitude);
    [radius * libm::cos(longitude), radius * libm::sin(longitude), libm::sin(latitude)]
}

/// Degrees from -180 to 180.
pub(super) fn wrapped(degrees: f64) -> f64 {
    if degrees.abs() <= 180.0 { degrees } else { degrees - 360.0 * libm::round(degrees / 360.0) }
}
