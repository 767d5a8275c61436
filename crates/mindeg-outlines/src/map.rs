//! Regions that share borders, as maps.
//!
//! Points that are equal, bit for bit, are one vertex, and borders meet at vertices only. Regions that share an edge,
//! directly or over others, are one domain. The borders with no region beyond are its rings; those between two
//! regions are its lines, one for each run of edges between vertices where more than two meet, so that every border
//! is there once. A vertex where regions touch without an edge joins nothing.

mod borders;
mod gaps;
mod inner_point;
mod parts;
mod plane;
mod repair;

use std::collections::BTreeMap;
use std::sync::Arc as Shared;

use glam::DVec2;
use mindeg_domain::{Domain, InnerPoint, Inside, Outline, Region, Ring};

use self::gaps::Gap;
use self::parts::Part;
use self::plane::{Plane, Run};
use super::choice::Polygon;
use super::domain::domain_side;
use super::outline::{Border, DrawnInside, DrawnRing, Feature, key};
use super::sides::Division;
use super::text::{clean, shown};
use crate::error::OutlineError;

/// The name of the part of a border beyond which there is no region.
const OUTSIDE: &str = "outside";

impl Polygon {
    /// The domain inside the outer ring and outside the holes, named by the label. A hole that touches another ring at
    /// vertices is a line around a region without triangles.
    ///
    /// # Errors
    ///
    /// The errors of [`Feature::domain`].
    pub fn domain(&self, division: &Division) -> Result<Domain, OutlineError> {
        if self.touching_place().is_some() {
            return self.map(&DrawnInside::default(), division);
        }
        let name = (!self.label.is_empty()).then(|| self.label.clone());
        Feature { name, ..self.feature.clone() }.domain(division)
    }

    /// The domain with lines and points inside it.
    ///
    /// # Errors
    ///
    /// The errors of [`maps`].
    pub fn map(&self, inside: &DrawnInside, division: &Division) -> Result<Domain, OutlineError> {
        let (found, _) = maps(std::slice::from_ref(self), inside, division, true)?;
        match <[Domain; 1]>::try_from(found) {
            Ok([map]) if !self.label.is_empty() => Ok(map.named(&*self.label)?),
            Ok([map]) => Ok(map),
            Err(parts) if parts.len() > 1 => {
                let told = self.touching_place();
                let at = told.map_or_else(String::new, |at| format!(", as at {}", shown(at)));
                let count = parts.len();
                let problem = format!("rings touch{at}, so that it falls into {count} parts");
                let error = OutlineError::place("", problem).telling(told);
                Err(OutlineError { is_touch: true, ..error })
            }
            Err(_) => self.feature.domain(division),
        }
    }

    /// The first vertex of a ring that another has, too.
    fn touching_place(&self) -> Option<DVec2> {
        let mut rings = BTreeMap::new();
        let drawn_rings = self.feature.rings.iter().enumerate();
        let mut pieces =
            drawn_rings.flat_map(|(ring, drawn)| std::iter::repeat(ring).zip(&drawn.pieces));
        let found =
            pieces.find(|(ring, piece)| rings.entry(key(piece.start)).or_insert(*ring) != ring);
        found.map(|(_, piece)| piece.start)
    }
}

/// The maps of polygons that may share borders, each with its regions, which have the names of the polygons; and notes.
/// Lines and points inside them are lines and points of the maps.
/// Gaps between polygons that are far longer than wide are refused, or kept as holes and noted.
///
/// # Errors
///
/// Polygons that overlap or cross, lines and points outside all of them, and everything that [`Domain`] refuses.
pub fn maps(
    polygons: &[Polygon],
    inside: &DrawnInside,
    division: &Division,
    keeps_gaps: bool,
) -> Result<(Vec<Domain>, Vec<String>), OutlineError> {
    let names: Vec<String> = polygons
        .iter()
        .map(|polygon| {
            let name = polygon.feature.name.as_deref().map(clean).unwrap_or_default();
            if name.is_empty() { polygon.name() } else { name }
        })
        .collect();
    let (mut borders, mut notes) = borders::of_polygons(polygons, &names)?;
    borders.extend_from_slice(&inside.lines);
    let max_areas: Vec<_> = polygons.iter().map(|polygon| polygon.feature.max_area).collect();
    let (domains, gap) = domains(&borders, (&names, &max_areas), &inside.points, division)?;
    match gap {
        Some(gap) if !keeps_gaps => Err(gap.error(&names)),
        gap => {
            notes.extend(gap.map(|gap| gap.error(&names).to_string()));
            Ok((domains, notes))
        }
    }
}

/// The domains of borders between regions with these names, in the order of the regions, and the longest gap between
/// regions, if there is one.
///
/// # Errors
///
/// Borders that cross or touch elsewhere than at ends, regions that overlap, lines outside all regions, and everything
/// else that [`Domain`] refuses.
fn domains(
    borders: &[Border],
    (names, max_areas): (&[String], &[Option<f64>]),
    points: &[InnerPoint],
    division: &Division,
) -> Result<(Vec<Domain>, Option<Gap>), OutlineError> {
    let plane = Plane::new(borders, names)?;
    plane.check_near(points)?;
    let (parts, gap) = parts::parts(&plane, names.len(), points)?;
    let mut own_points = points_of(&parts, points)?.into_iter();
    let mut sides = SideNames { names, known: BTreeMap::new() };
    let domains = parts
        .into_iter()
        .map(|map| {
            let mut ring = |run: &Run| -> Result<Ring, OutlineError> {
                let drawn = plane.drawn(run, |border| sides.of(border));
                let sides = drawn.divided(division)?;
                let corners = sides.iter().map(|side| side.points[0]).collect();
                let sides = sides.into_iter().map(domain_side).collect();
                Ok(Ring { corners, sides })
            };
            let Ring { corners, sides: outer } = ring(&map.outer)?;
            let mut builder = Domain::builder(Outline::Polygon(corners), outer);
            for hole in &map.holes {
                builder = builder.hole(ring(hole)?);
            }
            // The last lines are the rings of holes that touch others.
            let first_hole = map.lines.len() - map.hole_faces.len();
            let lines = map.lines.iter().enumerate().map(|(index, run)| {
                let drawn = plane.drawn(run, |border| sides.of(border));
                let mut line = line(&drawn, run.is_closed(), division)?;
                if let Some(hole) = index.checked_sub(first_hole) {
                    let name = format!("hole {}", map.holes.len() + hole + 1);
                    let unnamed = line.sides.iter_mut().filter(|side| side.name.is_none());
                    unnamed.for_each(|side| side.name = Some(name.clone()));
                }
                Ok::<_, OutlineError>(line)
            });
            let lines = lines.collect::<Result<_, _>>()?;
            let region = |&(region, at): &(u32, DVec2)| Region {
                at,
                name: names.get(region as usize).cloned(),
                max_area: max_areas.get(region as usize).copied().flatten(),
                ..Region::default()
            };
            let hole = |&at: &DVec2| Region { at, hole: true, ..Region::default() };
            let holes = map.hole_faces.iter().map(hole);
            let regions = map.regions.iter().map(region).chain(holes).collect();
            let points = own_points.next().unwrap_or_default();
            let domain = builder.inside(Inside { lines, points, regions }).build();
            domain.map_err(|error| {
                let first = map.regions.first().and_then(|region| names.get(region.0 as usize));
                let place = match (map.regions.len(), first) {
                    // The domain has its name.
                    (1, _) | (_, None) => String::new(),
                    (_, Some(first)) => format!("the map of {first}"),
                };
                OutlineError { place, ..OutlineError::from(error) }
            })
        })
        .collect::<Result<_, _>>()?;
    Ok((domains, gap))
}

/// The points inside or on each part.
fn points_of(parts: &[Part], points: &[InnerPoint]) -> Result<Vec<Vec<InnerPoint>>, OutlineError> {
    let mut of_parts = vec![Vec::new(); parts.len()];
    for point in points {
        let part = parts::part_around(parts, point.at).ok_or_else(|| {
            let problem =
                "this point lies outside all regions; drop it, or draw a region around it";
            OutlineError::place(shown(point.at), problem)
        })?;
        of_parts[part].push(point.clone());
    }
    Ok(of_parts)
}

/// A line of a domain.
fn line(drawn: &DrawnRing, is_closed: bool, division: &Division) -> Result<Ring, OutlineError> {
    let divided =
        if is_closed { drawn.divided(division)? } else { drawn.divided_open(division)? };
    let mut corners: Vec<DVec2> = divided.iter().map(|side| side.points[0]).collect();
    if !is_closed {
        corners.extend(drawn.pieces.last().map(|piece| piece.start));
    }
    Ok(Ring { corners, sides: divided.into_iter().map(domain_side).collect() })
}

/// Names of borders by their regions.
struct SideNames<'a> {
    names: &'a [String],
    known: BTreeMap<[Option<u32>; 2], Shared<str>>,
}

impl SideNames<'_> {
    /// The name that the file gives, or else, of several regions, those on both sides: the one with the lower index first.
    fn of(&mut self, border: &Border) -> Option<Shared<str>> {
        let mut beside = border.beside;
        beside.sort_by_key(|region| region.unwrap_or(u32::MAX));
        let names = self.names;
        let name = |region: Option<u32>| region.map_or(OUTSIDE, |region| &names[region as usize]);
        match beside {
            _ if border.side.is_some() || names.len() == 1 => border.side.clone(),
            [None, None] => None,
            [first, second] => {
                let known = self.known.entry(beside);
                Some(
                    known
                        .or_insert_with(|| format!("{} | {}", name(first), name(second)).into())
                        .clone(),
                )
            }
        }
    }
}

#[cfg(test)]
mod tests;
