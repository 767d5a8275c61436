//! The lines, points and regions inside the rings of a domain.
//!
//! With lines, a domain is a map: they divide it into faces, and every mesh of the domain has their edges.

use glam::DVec2;

use crate::error::{DomainError, Place};
use crate::name;
use crate::outline::Ring;
use crate::sizes::is_size;

/// The lines, points and regions inside the rings of a domain; none by default.
///
/// # Example
///
/// ```
/// use mindeg_domain::{Domain, Inside, Outline, Rectangle, Ring, Side};
///
/// // A rectangle of two regions.
/// let interface = Ring::new([[2.0, 0.0], [2.0, 2.0]], vec![Side::count(3).named("interface")]);
/// let domain = Domain::builder(Outline::Rectangle(Rectangle::new(4.0, 2.0)), vec![Side::count(4); 4])
///     .inside(Inside { lines: vec![interface], ..Inside::default() })
///     .build()?;
/// let faces = domain.faces().expect("the line divides the domain");
/// assert_eq!((faces.count, domain.region_name(1)), (2, "region 2".to_owned()));
/// assert_eq!(domain.boundary().unwrap().segments(), [[2, 16], [16, 17], [17, 10]]);
/// # Ok::<(), mindeg_domain::DomainError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Inside {
    /// The lines, which may end on rings and on each other. A line has one side fewer than corners, or as many
    /// if it is closed. A side with a size may be divided further where a mesh has interior points; all others
    /// keep their intervals.
    pub lines: Vec<Ring>,
    /// Points that every mesh has.
    pub points: Vec<InnerPoint>,
    /// Names and materials of the faces between lines.
    pub regions: Vec<Region>,
}

/// A point that every mesh has
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "json", derive(serde::Serialize, serde::Deserialize, schemars::JsonSchema))]
#[cfg_attr(feature = "json", serde(deny_unknown_fields))]
pub struct InnerPoint {
    /// Where it is, `[x, y]`
    #[cfg_attr(feature = "json", schemars(with = "[f64; 2]"))]
    pub at: DVec2,
    /// Its name
    pub name: Option<String>,
    /// The size of a mesh with interior points there, which grows as from the boundary
    #[cfg_attr(feature = "json", schemars(extend("exclusiveMinimum" = 0)))]
    pub size: Option<f64>,
}

/// A region: the face around a point, with a name and a material, or a hole
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "json", derive(serde::Serialize, serde::Deserialize, schemars::JsonSchema))]
#[cfg_attr(feature = "json", serde(deny_unknown_fields))]
pub struct Region {
    /// Any point inside it, `[x, y]`
    #[cfg_attr(feature = "json", schemars(with = "[f64; 2]"))]
    pub at: DVec2,
    /// Its name, which becomes a group of triangles in mesh files. Regions may share one
    pub name: Option<String>,
    /// The name of its material
    pub material: Option<String>,
    /// The size of a mesh with interior points in it, in place of that far from the boundary
    #[cfg_attr(feature = "json", schemars(extend("exclusiveMinimum" = 0)))]
    pub size: Option<f64>,
    /// The greatest area of its triangles in a mesh with interior points
    #[cfg_attr(feature = "json", schemars(extend("exclusiveMinimum" = 0)))]
    pub max_area: Option<f64>,
    /// Whether it is a hole, which has no triangles
    #[cfg_attr(
        feature = "json",
        serde(
            default,
            deserialize_with = "crate::json::or_default",
            skip_serializing_if = "crate::json::is_default"
        )
    )]
    pub hole: bool,
}

impl Inside {
    /// Whether there is nothing.
    pub fn is_empty(&self) -> bool {
        self.lines.is_empty() && self.points.is_empty() && self.regions.is_empty()
    }

    /// Checks all names, and the sizes of points.
    pub(crate) fn check(&self) -> Result<(), DomainError> {
        for (index, line) in self.lines.iter().enumerate() {
            for (side, given) in line.sides.iter().enumerate() {
                let place = || Place::key("lines").then(index).then("sides").then(side);
                if let Some(name) = &given.name {
                    name::check(name, place().then("name"), &format!("line {}", index + 1))?;
                }
            }
        }
        for (index, InnerPoint { name, size, .. }) in self.points.iter().enumerate() {
            let place = || Place::key("points").then(index);
            if let Some(name) = name {
                name::check(name, place().then("name"), &format!("point {}", index + 1))?;
            }
            if let Some(size) = size.filter(|size| !is_size(*size)) {
                return Err(place()
                    .then("size")
                    .error(format!("the size is {size:?}; it must be a finite number above 0")));
            }
        }
        for (index, Region { name, material, size, max_area, hole, .. }) in
            self.regions.iter().enumerate()
        {
            let whole = || format!("region {}", index + 1);
            let keys = [
                ("name", name.is_some()),
                ("material", material.is_some()),
                ("size", size.is_some()),
                ("max_area", max_area.is_some()),
            ];
            if *hole && let Some((key, _)) = keys.iter().find(|(_, is_given)| *is_given) {
                let message =
                    format!("{} is a hole, which has no triangles; drop its {key}", whole());
                return Err(Place::key("regions").then(index).then(*key).error(message));
            }
            for (key, value) in [("size", size), ("max_area", max_area)] {
                if let Some(value) = value.filter(|value| !is_size(*value)) {
                    return Err(Place::key("regions").then(index).then(key).error(format!(
                        "the {} is {value:?}; it must be a finite number above 0",
                        key.replace("max_", "greatest ")
                    )));
                }
            }
            for (key, text) in [("name", name), ("material", material)] {
                if let Some(text) = text {
                    let place = Place::key("regions").then(index).then(key);
                    name::check(text, place, &whole())?;
                }
            }
        }
        Ok(())
    }
}
