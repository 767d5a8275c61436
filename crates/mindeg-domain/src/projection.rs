//! Projections of longitudes and latitudes to a plane in metres, and back.
//!
//! A domain that was drawn in degrees remembers its projection as PROJ writes it, so that formats in degrees get
//! degrees again. Transverse Mercator and the stereographic projection keep angles, so a mesh has the angles that
//! its plane shows; Lambert's azimuthal projection keeps areas. The ellipsoid is that of WGS84 or GRS80, which differ
//! by a tenth of a millimetre; the datums of these two are taken for one.
//!
//! The crates with projections call the platform's functions, which differ in their last bits between machines; these
//! formulas call `libm`. Tests compare them with such a crate.

mod azimuthal;
mod ellipsoid;
mod region;
mod transverse_mercator;

use std::fmt;
use std::str::FromStr;

use glam::DVec2;

use self::azimuthal::Azimuthal;
use self::ellipsoid::Ellipsoid;
pub use self::region::GlobeRegion;
use self::region::{GlobeRegion as Region, wrapped};
use self::transverse_mercator::TransverseMercator;

/// A projection between degrees of longitude and latitude and metres of a plane.
///
/// Its text is a definition of PROJ's, such as `+proj=utm +zone=35 +datum=WGS84`; an EPSG code is read, too.
///
/// # Example
///
/// ```
/// use mindeg_domain::Projection;
/// use glam::DVec2;
///
/// let utm: Projection = "EPSG:32635".parse()?;
/// assert_eq!(utm.to_string(), "+proj=utm +zone=35 +datum=WGS84");
/// let athens = utm.to_plane(DVec2::new(23.7275, 37.9838));
/// assert_eq!(athens.round().to_array(), [212582.0, 4209072.0]);
/// let again = utm.to_degrees(athens);
/// assert!(again.distance(DVec2::new(23.7275, 37.9838)) < 1e-12);
/// # Ok::<(), String>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Projection {
    kind: Kind,
    ellipsoid: Ellipsoid,
}

/// The kind of a projection, with its parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    Utm { zone: u8, is_south: bool },
    Stereographic { center: DVec2, true_latitude: Option<f64> },
    EqualArea { center: DVec2, false_origin: DVec2 },
}

/// How far from the zone's middle meridian UTM is chosen, in degrees of longitude.
const UTM_REACH: f64 = 5.0;
/// UTM is defined up to here.
const UTM_LATITUDE: f64 = 84.0;

impl Projection {
    /// Whether a code of EPSG is that of longitudes and latitudes, which are no plane.
    #[must_use]
    pub fn is_of_degrees(code: u32) -> bool {
        matches!(code, 4326 | 4258 | 4269 | 4979)
    }

    /// The UTM zone of a region, on its hemisphere.
    ///
    /// # Errors
    ///
    /// A region that goes around a pole, or farther than 84° of latitude or 30° from the middle of the zone.
    pub fn utm(region: &Region) -> Result<Self, String> {
        let [longitude, reach] = region.longitudes()?;
        let zone = libm::floor((longitude + 180.0) / 6.0).clamp(0.0, 59.0) as u8 + 1;
        let middle = middle_of(zone);
        let farthest = wrapped(longitude - middle).abs() + reach;
        if farthest > 30.0 || region.latitudes().into_iter().any(|it| it.abs() > UTM_LATITUDE) {
            return Err(format!(
                "the region reaches {farthest:.0}° from the middle meridian of UTM zone {zone}, and its latitudes from \
                 {:.0}° to {:.0}°; UTM is for 30° and latitudes up to 84°: choose stereographic",
                region.latitudes()[0],
                region.latitudes()[1]
            ));
        }
        let is_south = region.latitudes()[0] + region.latitudes()[1] < 0.0;
        Ok(Self { kind: Kind::Utm { zone, is_south }, ellipsoid: Ellipsoid::WGS84 })
    }

    /// The stereographic projection about the middle of a region, which keeps angles.
    ///
    /// # Errors
    ///
    /// A region wider than half of the globe.
    pub fn stereographic(region: &Region) -> Result<Self, String> {
        let center = region.center()?;
        let kind = Kind::Stereographic { center, true_latitude: None };
        Ok(Self { kind, ellipsoid: Ellipsoid::WGS84 })
    }

    /// Lambert's azimuthal projection about the middle of a region, which keeps areas.
    ///
    /// # Errors
    ///
    /// A region wider than half of the globe.
    pub fn equal_area(region: &Region) -> Result<Self, String> {
        let kind = Kind::EqualArea { center: region.center()?, false_origin: DVec2::ZERO };
        Ok(Self { kind, ellipsoid: Ellipsoid::WGS84 })
    }

    /// UTM where it keeps lengths to about 0.4 %, which is within 5° of the zone's middle meridian; elsewhere the
    /// stereographic projection.
    ///
    /// # Errors
    ///
    /// A region wider than half of the globe.
    pub fn of_region(region: &Region) -> Result<Self, String> {
        let is_near = |zone: u8| {
            let [longitude, reach] = region.longitudes().ok()?;
            Some(wrapped(longitude - middle_of(zone)).abs() + reach <= UTM_REACH)
        };
        match Self::utm(region) {
            Ok(utm @ Self { kind: Kind::Utm { zone, .. }, .. }) if is_near(zone) == Some(true) => {
                Ok(utm)
            }
            _ => Self::stereographic(region),
        }
    }

    /// Metres of a point given in degrees of longitude and latitude.
    #[must_use]
    pub fn to_plane(&self, degrees: DVec2) -> DVec2 {
        let radians = DVec2::new(degrees.x.to_radians(), degrees.y.to_radians());
        match self.kind {
            Kind::Utm { zone, is_south } => {
                TransverseMercator::new(&self.ellipsoid, middle_of(zone)).forward(radians)
                    + utm_origin(is_south)
            }
            Kind::Stereographic { center, true_latitude } => {
                Azimuthal::stereographic(&self.ellipsoid, center, true_latitude).forward(radians)
            }
            Kind::EqualArea { center, false_origin } => {
                Azimuthal::equal_area(&self.ellipsoid, center).forward(radians) + false_origin
            }
        }
    }

    /// Degrees of longitude and latitude of a point given in metres. Longitudes are within half a turn of the middle of the
    /// projection, so that they go on across the antimeridian: about 180° E, from 0 to 360.
    #[must_use]
    pub fn to_degrees(&self, plane: DVec2) -> DVec2 {
        let middle = match self.kind {
            Kind::Utm { zone, .. } => middle_of(zone),
            Kind::Stereographic { center, .. } | Kind::EqualArea { center, .. } => center.x,
        };
        let radians = match self.kind {
            Kind::Utm { is_south, .. } => TransverseMercator::new(&self.ellipsoid, middle)
                .inverse(plane - utm_origin(is_south)),
            Kind::Stereographic { center, true_latitude } => {
                Azimuthal::stereographic(&self.ellipsoid, center, true_latitude).inverse(plane)
            }
            Kind::EqualArea { center, false_origin } => {
                Azimuthal::equal_area(&self.ellipsoid, center).inverse(plane - false_origin)
            }
        };
        let longitude = wrapped(radians.x.to_degrees());
        let turn = if longitude - middle > 180.0 {
            -360.0
        } else if longitude - middle < -180.0 {
            360.0
        } else {
            0.0
        };
        DVec2::new(longitude + turn, radians.y.to_degrees())
    }

    /// A place in degrees as a sentence has it, to a tenth of a metre: "longitude 24.5, latitude 38.25".
    #[must_use]
    pub fn in_words(degrees: DVec2) -> String {
        let [x, y] = degrees.to_array().map(|it| (it * 1e6).round() / 1e6);
        format!("longitude {x}, latitude {y}")
    }

    /// A length in the plane over that on the ground, at a point given in degrees, along the meridian.
    #[must_use]
    pub fn scale(&self, degrees: DVec2) -> f64 {
        const STEP: f64 = 1e-4;
        let ends = [-STEP, STEP].map(|step| DVec2::new(degrees.x, degrees.y + step));
        let [a, b] = ends.map(|end| self.to_plane(end));
        let ground =
            self.ellipsoid.meridian_radius(degrees.y.to_radians()) * (2.0 * STEP).to_radians();
        a.distance(b) / ground
    }

    /// Its name among people: "UTM zone 35 north".
    #[must_use]
    pub fn name(&self) -> String {
        match self.kind {
            Kind::Utm { zone, is_south } => {
                format!("UTM zone {zone} {}", if is_south { "south" } else { "north" })
            }
            Kind::Stereographic { center, .. } => {
                format!("a stereographic projection about {}", place(center))
            }
            Kind::EqualArea { center, .. } => {
                format!("Lambert's equal-area projection about {}", place(center))
            }
        }
    }
}

/// A place in degrees, for people: "158° W, 61° N".
fn place(degrees: DVec2) -> String {
    let [east, north] = [("E", "W"), ("N", "S")];
    let of = |value: f64, (plus, minus)| {
        format!("{}° {}", value.abs(), if value < 0.0 { minus } else { plus })
    };
    format!("{}, {}", of(degrees.x, east), of(degrees.y, north))
}

/// The longitude of a UTM zone's middle meridian.
fn middle_of(zone: u8) -> f64 {
    f64::from(zone) * 6.0 - 183.0
}

fn utm_origin(is_south: bool) -> DVec2 {
    DVec2::new(500_000.0, if is_south { 10_000_000.0 } else { 0.0 })
}

impl fmt::Display for Projection {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.kind {
            Kind::Utm { zone, is_south } => {
                write!(f, "+proj=utm +zone={zone}{}", if is_south { " +south" } else { "" })?;
            }
            Kind::Stereographic { center, true_latitude } => {
                write!(f, "+proj=stere +lat_0={} +lon_0={}", center.y, center.x)?;
                if let Some(latitude) = true_latitude {
                    write!(f, " +lat_ts={latitude}")?;
                }
            }
            Kind::EqualArea { center, false_origin } => {
                write!(f, "+proj=laea +lat_0={} +lon_0={}", center.y, center.x)?;
                if false_origin != DVec2::ZERO {
                    write!(f, " +x_0={} +y_0={}", false_origin.x, false_origin.y)?;
                }
            }
        }
        let is_grs80 = self.ellipsoid == Ellipsoid::GRS80;
        f.write_str(if is_grs80 { " +ellps=GRS80" } else { " +datum=WGS84" })
    }
}

impl FromStr for Projection {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let trimmed = text.trim();
        match trimmed.split_once(':') {
            Some((authority, code)) if authority.eq_ignore_ascii_case("epsg") => of_epsg(code),
            None if trimmed.bytes().all(|digit| digit.is_ascii_digit()) && !trimmed.is_empty() => {
                of_epsg(trimmed)
            }
            _ => of_definition(trimmed),
        }
    }
}

/// The projections of EPSG codes that are of these kinds.
fn of_epsg(code: &str) -> Result<Projection, String> {
    let number: u32 = code
        .trim()
        .parse()
        .map_err(|_| format!("EPSG:{code}: give a number, such as EPSG:32635"))?;
    let utm = |zone: u32, is_south, ellipsoid| {
        Ok(Projection { kind: Kind::Utm { zone: zone as u8, is_south }, ellipsoid })
    };
    let polar = |latitude: f64, longitude: f64, true_latitude: f64| {
        let center = DVec2::new(longitude, latitude);
        let kind = Kind::Stereographic { center, true_latitude: Some(true_latitude) };
        Ok(Projection { kind, ellipsoid: Ellipsoid::WGS84 })
    };
    match number {
        32601..=32660 => utm(number - 32600, false, Ellipsoid::WGS84),
        32701..=32760 => utm(number - 32700, true, Ellipsoid::WGS84),
        25828..=25838 => utm(number - 25800, false, Ellipsoid::GRS80),
        3035 => {
            let (center, false_origin) =
                (DVec2::new(10.0, 52.0), DVec2::new(4_321_000.0, 3_210_000.0));
            Ok(Projection {
                kind: Kind::EqualArea { center, false_origin },
                ellipsoid: Ellipsoid::GRS80,
            })
        }
        3413 => polar(90.0, -45.0, 70.0),
        3995 => polar(90.0, 0.0, 71.0),
        3031 => polar(-90.0, 0.0, -71.0),
        _ if Projection::is_of_degrees(number) => Err(format!(
            "EPSG:{number} is degrees of longitude and latitude, no plane; give the projection that makes metres of them"
        )),
        ..1024 | 32768.. => Err(format!("EPSG:{number} is no code: they are from 1024 to 32767")),
        _ => Err(format!(
            "EPSG:{number} is not among the projections here: UTM (EPSG:32601 to 32660, 32701 to 32760, 25828 to 25838), \
             EPSG:3035, 3413, 3995 and 3031; where there is such a code, ogr2ogr -t_srs EPSG:{number} OUT.geojson IN makes a file in metres, to be \
             given without a projection"
        )),
    }
}

fn of_definition(text: &str) -> Result<Projection, String> {
    let mut kind = "";
    let (mut zone, mut is_south, mut ellipsoid) = (None, false, Ellipsoid::WGS84);
    let (mut center, mut origin, mut true_latitude) = (DVec2::ZERO, DVec2::ZERO, None);
    for word in text.split_whitespace() {
        let (key, value) = word.split_once('=').unwrap_or((word, ""));
        let number = |from: f64, to: f64| {
            let number = value.parse().ok().filter(|number| (from..=to).contains(number));
            number.ok_or_else(|| format!("{key} is {value}; give a number from {from} to {to}"))
        };
        match key {
            "+proj" => kind = value,
            "+zone" => {
                let zones = value.parse().ok().filter(|zone| (1..=60).contains(zone));
                zone =
                    Some(zones.ok_or_else(|| format!("+zone is {value}; give one from 1 to 60"))?);
            }
            "+south" => is_south = true,
            "+lat_0" => center.y = number(-90.0, 90.0)?,
            "+lon_0" => center.x = number(-180.0, 180.0)?,
            "+lat_ts" => true_latitude = Some(number(-90.0, 90.0)?),
            "+x_0" => origin.x = number(-1e9, 1e9)?,
            "+y_0" => origin.y = number(-1e9, 1e9)?,
            "+datum" | "+ellps" if value == "WGS84" => {}
            "+ellps" if value == "GRS80" => ellipsoid = Ellipsoid::GRS80,
            "+units" if value == "m" => {}
            "+k" | "+k_0" if value.parse() == Ok(1.0) => {}
            "+no_defs" | "+type" => {}
            _ => return Err(format!("{word} is not known here; {FORMS}")),
        }
    }
    let kind = match (kind, zone) {
        ("utm", Some(zone)) => Kind::Utm { zone, is_south },
        ("utm", None) => return Err("+proj=utm needs a +zone, such as +zone=35".to_owned()),
        ("stere", _) if origin == DVec2::ZERO => {
            if true_latitude.is_some() && center.y.abs() != 90.0 {
                return Err(
                    "+lat_ts is for a pole; leave it out, or give +lat_0=90 or -90".to_owned()
                );
            }
            Kind::Stereographic { center, true_latitude }
        }
        ("laea", _) => Kind::EqualArea { center, false_origin: origin },
        _ => return Err(format!("{text:?} is not a projection here; {FORMS}")),
    };
    Ok(Projection { kind, ellipsoid })
}

/// The form of a definition.
const FORMS: &str = "give EPSG:32635 or the like, or \"+proj=utm +zone=35 +datum=WGS84\", \
     \"+proj=stere +lat_0=38 +lon_0=25 +datum=WGS84\" or \"+proj=laea +lat_0=38 +lon_0=25 +datum=WGS84\"";

#[cfg(test)]
mod tests;
