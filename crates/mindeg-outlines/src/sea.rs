//! The sea between lands: what polygons leave of a box.

use glam::DVec2;
use mindeg_mesh::{Bounds, percent};
use std::borrow::Cow;
use std::iter::once;

use super::antimeridian::{TURN, running_on};
use super::outline::{DrawnRing, Feature, FillRule, Outlines};
use super::overlay::{Layer, overlay};
use super::text::{counted, shown};
use crate::error::OutlineError;

/// A box across the antimeridian may be given by longitudes of one turn more; latitudes end at the pole.
const ENDS: DVec2 = DVec2::new(540.0, 90.0);

/// Polygons with longitudes from -360 to 360 degrees are found in boxes up to 540.
const TURNS: i32 = 2;

impl Outlines {
    /// The largest part of a box that no polygon covers: the sea, if they are lands. The box has two corners, the lower left one
    /// first. A note tells what else of the box is left.
    ///
    /// # Errors
    ///
    /// A box without an area, beyond the ends of degrees, or covered by polygons; rings too near each other to be told apart in some
    /// seconds.
    ///
    /// # Example
    ///
    /// ```
    /// use mindeg_outlines::{OutlineFormat, read};
    ///
    /// // Land to the left, and an island.
    /// let land = b"MULTIPOLYGON(((-9 -9, 2 -9, 2 9, -9 9, -9 -9)), ((4 1, 5 1, 5 2, 4 1)))";
    /// let alone = |_: &str| Err(std::io::ErrorKind::NotFound.into());
    /// let sea = read(land, OutlineFormat::Wkt, alone)?.sea_in([[0.0, 0.0], [8.0, 3.0]].map(Into::into))?;
    /// assert_eq!(sea.features.len(), 1);
    /// let doubled: Vec<f64> = sea.features[0].rings.iter().map(|ring| ring.doubled_area().abs()).collect();
    /// assert_eq!(doubled, [36.0, 1.0]);
    /// # Ok::<(), mindeg_outlines::OutlineError>(())
    /// ```
    pub fn sea_in(mut self, [low, mut high]: [DVec2; 2]) -> Result<Self, OutlineError> {
        let place = format!("the box from {} to {}", shown(low), shown(high));
        let bad = |problem: String| OutlineError::place(place.clone(), problem);
        if self.is_geographic && low.x > high.x && is_eastward(low.x, high.x) {
            high.x += TURN;
        }
        if !(low.cmplt(high).all() && low.is_finite() && high.is_finite()) {
            return Err(bad(
                "give its lower left corner first, then its upper right one".to_owned()
            ));
        }
        if self.is_geographic && (low.cmplt(-ENDS).any() || high.cmpgt(ENDS).any()) {
            return Err(bad("latitudes end at ±90; a box across the antimeridian may pass ±180, such as from 170 to 190".to_owned()));
        }
        let corners = [low, DVec2::new(high.x, low.y), high, DVec2::new(low.x, high.y)];
        let rim = DrawnRing::of_points(corners);
        let rule = FillRule::EvenOdd;
        let lands = self.lands([low, high])?;
        let lands = lands.iter().map(|rings| Layer { rings: rings.iter().collect(), rule });
        let layers: Vec<Layer<'_>> = once(Layer { rings: vec![&rim], rule }).chain(lands).collect();
        let is_sea = |counted: &[bool]| counted[0] && !counted[1..].contains(&true);
        let parts = overlay(&layers, is_sea).map_err(bad)?.polygons;
        let mut parts: Vec<(f64, Vec<DrawnRing>)> =
            parts.into_iter().map(|(rings, _)| (area(&rings), rings)).collect();
        parts.sort_by(|a, b| b.0.total_cmp(&a.0));
        let mut parts = parts.into_iter();
        let (largest, rings) = parts.next().ok_or_else(|| bad("polygons cover it".to_owned()))?;
        if let Some((second, _)) = parts.next() {
            self.notes.push(format!(
                "left out {} of the box that no polygon covers, with {} of the area of the largest at most",
                counted(parts.len() + 1, "other part"),
                percent(second / largest)
            ));
        }
        self.turn_inside([low.x, high.x]);
        let Self { inside, kinds, notes, is_geographic, projection, .. } = self;
        let mut sea = Self { inside, kinds, notes, is_geographic, projection, ..Self::default() };
        sea.features.push(Feature { rings, ..Feature::default() });
        sea.end_shape();
        sea.clip_inside(0.0)?;
        Ok(sea)
    }

    /// The rings of the polygons in a box. Of longitudes and latitudes, where they are on its turn around the globe.
    fn lands(&self, [low, high]: [DVec2; 2]) -> Result<Vec<Vec<DrawnRing>>, OutlineError> {
        let turns = if self.is_geographic { TURNS } else { 0 };
        let mut lands = Vec::new();
        for land in &self.features {
            let rings = match self.is_geographic {
                true => running_on(land)?,
                false => Cow::Borrowed(&land.rings[..]),
            };
            let Some(own) = Bounds::of(rings.iter().flat_map(DrawnRing::flattened)) else {
                continue;
            };
            for turn in -turns..=turns {
                let by = DVec2::new(f64::from(turn) * TURN, 0.0);
                if (own.min + by).cmplt(high).all() && (own.max + by).cmpgt(low).all() {
                    let mut rings = rings.to_vec();
                    // Adding zero would turn -0 into 0.
                    if turn != 0 {
                        let pieces = rings.iter_mut().flat_map(|ring| &mut ring.pieces);
                        pieces.for_each(|piece| piece.start += by);
                    }
                    lands.push(rings);
                }
            }
        }
        Ok(lands)
    }

    /// Lines and points of longitudes and latitudes, where they are on the turn of a box around the globe.
    fn turn_inside(&mut self, [west, east]: [f64; 2]) {
        if !self.is_geographic {
            return;
        }
        let turn = |x: f64| {
            if x < west && x + TURN <= east {
                TURN
            } else if x > east && x - TURN >= west {
                -TURN
            } else {
                0.0
            }
        };
        for line in &mut self.inside.lines {
            for end in [&mut line.segment.start, &mut line.segment.end] {
                end.x += turn(end.x);
            }
        }
        for point in &mut self.inside.points {
            point.at.x += turn(point.at.x);
        }
    }
}

/// Whether one goes east from one longitude to another of a box: across the antimeridian only the short way, for the long one is more
/// likely west and east swapped.
///
/// ```
/// use mindeg_outlines::is_eastward;
///
/// assert!(is_eastward(23.0, 25.0) && is_eastward(170.0, -170.0));
/// assert!(!is_eastward(25.0, 23.0) && !is_eastward(3.0, 3.0));
/// ```
#[must_use]
pub fn is_eastward(west: f64, east: f64) -> bool {
    west < east || east + TURN - west <= TURN / 2.0
}

/// The area of an outer ring without holes.
fn area(rings: &[DrawnRing]) -> f64 {
    let areas: Vec<f64> = rings.iter().map(|ring| ring.doubled_area().abs() / 2.0).collect();
    areas.first().map_or(0.0, |outer| 2.0 * outer - areas.iter().sum::<f64>())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{OutlineFormat, read};

    fn sea(land: &str, corners: [[f64; 2]; 2]) -> Result<Outlines, OutlineError> {
        let format =
            if land.starts_with('{') { OutlineFormat::GeoJson } else { OutlineFormat::Wkt };
        let alone = |_: &str| Err(std::io::ErrorKind::NotFound.into());
        read(land.as_bytes(), format, alone).unwrap().sea_in(corners.map(Into::into))
    }

    /// Land at two corners that overlaps more land, with a lake in it, an island, and land far away.
    #[test]
    fn the_largest_part_of_a_box_without_land_is_the_sea() {
        let land = "MULTIPOLYGON(((-5 -5, 4 -5, 4 4.1, -5 4.1, -5 -5), (1 1, 2 1, 2 2, 1 1)), ((-1 4, 3 4, 3 30, -1 30, -1 4)), \
                    ((7 3, 8 3, 8 4, 7 3)), ((60 60, 61 60, 61 61, 60 60)))";
        let found = sea(land, [[0.0, 0.0], [10.0, 10.0]]).unwrap();
        let [only] = &found.features[..] else { panic!("{} parts", found.features.len()) };
        let doubled: Vec<f64> = only.rings.iter().map(|ring| ring.doubled_area().abs()).collect();
        assert_eq!(doubled.len(), 2);
        // Without 4 by 4.1 and 3 by 5.9.
        assert!((doubled[0] - 2.0 * (100.0 - 16.4 - 17.7)).abs() < 1e-9, "{doubled:?}");
        // The points of the file stay bit for bit.
        let starts = |ring: &DrawnRing| -> Vec<DVec2> {
            ring.pieces.iter().map(|piece| piece.start).collect()
        };
        assert_eq!(starts(&only.rings[1]), [[7.0, 3.0], [8.0, 3.0], [8.0, 4.0]].map(DVec2::from));
        assert!(starts(&only.rings[0]).contains(&DVec2::new(4.0, 4.1)));
        let [note] = &found.notes[..] else { panic!("{:?}", found.notes) };
        assert!(
            note.starts_with("left out 1 other part of the box that no polygon covers, with 0.8%"),
            "{note}"
        );
        // Nothing is near: the sea is the box.
        let box_alone = sea(land, [[20.0, 31.0], [21.0, 32.0]]).unwrap();
        assert_eq!(starts(&box_alone.features[0].rings[0]).len(), 4);
        assert!(box_alone.notes.is_empty());
    }

    #[test]
    fn lines_and_points_in_the_sea_stay() {
        let given = r#"{"type": "GeometryCollection", "geometries": [
            {"type": "Polygon", "coordinates": [[[0, 0], [4, 0], [4, 4], [0, 4], [0, 0]]]},
            {"type": "LineString", "coordinates": [[3, 2], [9, 2]]},
            {"type": "MultiPoint", "coordinates": [[1, 1], [5, 1]]}]}"#;
        let inside = sea(given, [[-1.0, -1.0], [8.0, 5.0]]).unwrap().inside;
        let ends = |line: &crate::outline::Border| [line.segment.start, line.segment.end];
        let [line] = &inside.lines[..] else { panic!("{inside:?}") };
        assert_eq!(ends(line), [[4.0, 2.0], [8.0, 2.0]].map(DVec2::from));
        let [point] = &inside.points[..] else { panic!("{inside:?}") };
        assert_eq!(point.at, DVec2::new(5.0, 1.0));
    }

    /// Land across the antimeridian ran back around the world, and cut seas anywhere on its latitudes.
    #[test]
    fn land_across_the_antimeridian_is_only_there() {
        let land = r#"{"type": "GeometryCollection", "geometries": [
            {"type": "Polygon", "coordinates": [[[175, 0], [-178, 0], [-178, 9], [175, 9], [175, 0]],
                                                [[179, 1], [-179, 2], [179, 3], [179, 1]]]},
            {"type": "Polygon", "coordinates": [[[-180, -70], [-90, -60], [0, -65], [90, -60], [180, -70], [-180, -70]]]},
            {"type": "LineString", "coordinates": [[-176, 3], [-174, 4]]},
            {"type": "Point", "coordinates": [-175, 7]}]}"#;
        let areas = |corners| -> (Vec<f64>, Outlines) {
            let found = sea(land, corners).unwrap();
            let rings = found.features.iter().flat_map(|part| &part.rings);
            (rings.map(|ring| ring.doubled_area().abs() / 2.0).collect(), found)
        };
        assert_eq!(areas([[-30.0, -5.0], [-20.0, 20.0]]).0, [250.0]);
        for [west, east] in [[170.0, -170.0], [170.0, 190.0], [-190.0, -170.0]] {
            let (areas, found) = areas([[west, -5.0], [east, 20.0]]);
            assert_eq!(areas, [500.0, 63.0], "{west}");
            assert_eq!((found.inside.lines.len(), found.inside.points.len()), (1, 1));
            assert!(
                found.notes[0].starts_with("left out 1 other part"),
                "the lake: {:?}",
                found.notes
            );
        }
        // The land around the pole ends at -60 degrees here.
        let (south, _) = areas([[-91.0, -80.0], [-89.0, -50.0]]);
        assert!(south.len() == 1 && (20.0..20.2).contains(&south[0]), "{south:?}");
    }

    #[test]
    fn boxes_without_a_sea_are_refused() {
        let land = r#"{"type": "Polygon", "coordinates": [[[-20, -20], [20, -20], [20, 20], [-20, 20], [-20, -20]]]}"#;
        for (corners, words) in [
            ([[0.0, 0.0], [1.0, 1.0]], "polygons cover it"),
            ([[0.0, 1.0], [1.0, 0.0]], "lower left corner first"),
            ([[0.0, 80.0], [1.0, 91.0]], "latitudes end at ±90"),
        ] {
            let error = sea(land, corners).unwrap_err().to_string();
            assert!(error.starts_with("the box from (") && error.contains(words), "{error}");
        }
    }
}
