//! Outlines in degrees of longitude and latitude, projected to a plane in metres.
//!
//! An edge runs straight in degrees, as RFC 7946 has it, unless the file says otherwise, and the short way around the globe. So a ring across the
//! antimeridian needs no cut, and one around a pole no seam.

mod box_sides;
mod touching;

use std::iter::once;
use std::str::FromStr;
use std::sync::Arc as Shared;

use glam::DVec2;
use mindeg_domain::{GlobeRegion, InnerPoint, Projection};

use super::curve::{PieceCurve, Segment};
use super::outline::{Border, DrawnInside, DrawnRing, Outlines, Piece};
use super::text::{counted, shown};
use crate::error::OutlineError;
use box_sides::{BoxSides, NEAR, turned};
use touching::node_touching;

/// An edge of degrees gets points in the plane until their line is nowhere farther from it than this share of its length.
const MOST_BENT: f64 = 1e-4;
/// Pages show the world again and again beside itself: what is drawn on such a copy has longitudes of more than a turn.
const MOST_LONGITUDE: f64 = 1080.0;
/// A given projection whose lengths are less than half of those on the ground, or more than twice, is refused: its region is another one.
const LEAST_SCALE: f64 = 0.5;
const MOST_SCALE: f64 = 2.0;
/// A given projection that changes lengths by more than this share is told to be a bad one here.
const MOST_OFF: f64 = 0.02;

/// The projection that is wanted for degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ProjectionChoice {
    /// UTM near the middle of its zone, else stereographic: [`Projection::of_region`].
    Auto,
    /// The UTM zone of the region.
    Utm,
    /// Lambert's azimuthal equal-area projection about the middle of the region.
    Laea,
    /// The stereographic projection about the middle of the region.
    Stereographic,
    /// A given one.
    Given(Projection),
    /// None: degrees are taken as planar coordinates.
    None,
}

impl FromStr for ProjectionChoice {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        Ok(match text {
            "auto" => Self::Auto,
            "utm" => Self::Utm,
            "laea" => Self::Laea,
            "stereographic" => Self::Stereographic,
            "none" => Self::None,
            definition => Self::Given(definition.parse().map_err(|problem| {
                format!("{problem}; or give auto, utm, laea, stereographic or none")
            })?),
        })
    }
}

impl ProjectionChoice {
    /// The projection for points in degrees of longitude and latitude.
    ///
    /// # Errors
    ///
    /// Points that are no degrees, or lie in no region for which the projection is made.
    pub fn of(
        self,
        points: impl Iterator<Item = DVec2> + Clone,
    ) -> Result<Option<Projection>, String> {
        if self == Self::None {
            return Ok(None);
        }
        points.clone().try_for_each(expect_degrees)?;
        let region = GlobeRegion::of(points).ok_or_else(|| {
            "the points lie all around the globe, and one plane holds less than half of it: choose a part".to_owned()
        })?;
        match self {
            Self::Auto | Self::None => Projection::of_region(&region),
            Self::Utm => Projection::utm(&region),
            Self::Laea => Projection::equal_area(&region),
            Self::Stereographic => Projection::stereographic(&region),
            Self::Given(projection) => Ok(projection),
        }
        .map(Some)
    }
}

impl Outlines {
    /// Whether the coordinates are taken for degrees of longitude and latitude, which are not projected.
    #[must_use]
    pub fn is_in_degrees(&self) -> bool {
        self.is_geographic
    }

    /// Projects degrees of longitude and latitude to metres; a note says how. Edges that bend get points. Sides along the
    /// box around all degrees get the names south, east, north and west, if they have none.
    ///
    /// # Errors
    ///
    /// Coordinates that are no degrees, curves, and a region for which the projection is not made.
    ///
    /// # Example
    ///
    /// ```
    /// use mindeg_outlines::{OutlineFormat, ProjectionChoice, read};
    ///
    /// let text = br#"{"type": "Polygon", "coordinates": [[[24, 38], [25, 38], [25, 39], [24, 39], [24, 38]]]}"#;
    /// let alone = |_: &str| Err(std::io::ErrorKind::NotFound.into());
    /// let degrees = read(text, OutlineFormat::GeoJson, alone)?;
    /// let plane = degrees.projected(ProjectionChoice::Auto)?;
    /// assert_eq!(plane.projection.map(|it| it.name()).as_deref(), Some("UTM zone 35 north"));
    /// let ring = &plane.features[0].rings[0];
    /// assert_eq!(ring.pieces[0].side.as_deref(), Some("south"));
    /// assert!((ring.segment(0).length() > 5000.0) && ring.pieces.len() > 4);
    /// # Ok::<(), mindeg_outlines::OutlineError>(())
    /// ```
    pub fn projected(mut self, choice: ProjectionChoice) -> Result<Self, OutlineError> {
        let wrong = |problem: String| OutlineError::place("", problem);
        if choice == ProjectionChoice::None {
            (self.is_geographic, self.projection) = (false, None);
            return Ok(self);
        }
        if let Some(own) = self.projection {
            return match choice {
                ProjectionChoice::Auto => Ok(self),
                ProjectionChoice::Given(wanted) if wanted == own => Ok(self),
                _ => Err(wrong(format!(
                    "the file says that it is projected already, by {} ({own}): leave out --project",
                    own.name()
                ))),
            };
        }
        let rings = || self.features.iter().flat_map(|feature| &feature.rings);
        rings().flat_map(|ring| ring.segments()).try_for_each(check)?;
        self.inside.lines.iter().map(|line| line.segment).try_for_each(check)?;
        self.inside.points.iter().try_for_each(|point| expect_degrees(point.at).map_err(wrong))?;
        let starts = || rings().flat_map(|ring| ring.pieces.iter().map(|piece| piece.start));
        let choice = match (choice, self.straight_in) {
            (ProjectionChoice::Auto, Some(own)) => ProjectionChoice::Given(own),
            _ => choice,
        };
        let Some(projection) = choice.of(starts()).map_err(wrong)? else {
            return Ok(self);
        };
        // Holes may reach past the box: a repair cuts them there.
        let outer = self.features.iter().filter_map(|feature| feature.rings.first());
        let on_outer = outer.flat_map(|ring| ring.pieces.iter().map(|piece| piece.start));
        let sides = BoxSides::of(on_outer);
        let scales = starts().chain(sides.inside(&self.features));
        let scales = scales.map(|point| projection.scale(point));
        let scales: Vec<f64> = scales.filter(|scale| !scale.is_nan()).collect();
        if let ProjectionChoice::Given(_) = choice
            && scales.iter().any(|scale| !(LEAST_SCALE..=MOST_SCALE).contains(scale))
        {
            let place = starts().next().map_or_else(String::new, |at| format!(" {}", shown(at)));
            return Err(wrong(format!(
                "{} is not for a region here{place}: it makes lengths less than half of those on the ground, or more \
                 than twice; choose another one, or auto, which finds one",
                projection.name()
            )));
        }
        let scales = scales.into_iter().filter(|scale| scale.is_finite());
        let [least, most] = scales.fold([f64::INFINITY, 0.0], |[least, most], it| {
            [f64::min(least, it), f64::max(most, it)]
        });
        node_touching(&sides, &mut self.features);
        let is_straight = self.straight_in == Some(projection);
        let mut projecting = Projecting { projection, is_straight, sides, added: 0, named: 0 };
        for ring in self.features.iter_mut().flat_map(|feature| &mut feature.rings) {
            *ring = projecting.ring(ring)?;
        }
        self.inside = projecting.inside(&self.inside)?;
        let Projecting { added, named, .. } = projecting;
        let mut note = format!(
            "projected degrees by {} ({projection}): lengths in the plane are {least:.4} to {most:.4} of those on the ground",
            projection.name()
        );
        if let ProjectionChoice::Given(_) = choice
            && (least < 1.0 - MOST_OFF || most > 1.0 + MOST_OFF)
        {
            note += "; that is far from its middle: --project auto finds one for this region";
        }
        if added > 0 {
            note += &format!("; put {} on edges that bend", counted(added, "point"));
        }
        if named > 0 {
            note += "; called sides on the box of degrees south, east, north and west";
        }
        self.notes.push(note);
        (self.is_geographic, self.projection) = (false, Some(projection));
        Ok(self)
    }
}

/// Refuses an edge that is not of degrees.
fn check(edge: Segment) -> Result<(), OutlineError> {
    if edge.curve != PieceCurve::Line {
        return Err(OutlineError::place("", "curves are not projected; only straight edges are"));
    }
    let ends = [edge.start, edge.end];
    ends.into_iter()
        .try_for_each(expect_degrees)
        .map_err(|problem| OutlineError::place("", problem))
}

fn expect_degrees(at: DVec2) -> Result<(), String> {
    if at.x.abs() <= MOST_LONGITUDE && at.y.abs() <= 90.0 {
        return Ok(());
    }
    if at.x.abs() <= 90.0 && at.y.abs() <= 180.0 {
        return Err(format!(
            "{} is no longitude and latitude in degrees, but the other way round it would be: GeoJSON has the longitude first",
            shown(at)
        ));
    }
    Err(format!(
        "{} is no longitude and latitude in degrees: the file seems to be projected already; leave out --project",
        shown(at)
    ))
}

fn is_pole(point: DVec2) -> bool {
    point.y.abs() > 90.0 - NEAR
}

/// A ring without the poles that end a seam: in degrees a pole is an edge, and a seam leaves it by the meridian by which it came.
/// Of others one point stays.
fn without_seams(pieces: &[Piece]) -> Vec<Piece> {
    let Some(first) = pieces.iter().position(|piece| !is_pole(piece.start)) else {
        return Vec::new();
    };
    let mut kept: Vec<Piece> = Vec::with_capacity(pieces.len());
    let around = pieces.iter().cycle().skip(first).take(pieces.len() + 1);
    let mut pole: Option<&Piece> = None;
    for (index, piece) in around.enumerate() {
        if is_pole(piece.start) {
            pole = Some(piece);
            continue;
        }
        let is_seam = |before: &Piece| turned(piece.start.x - before.start.x).abs() < NEAR;
        if let (Some(pole), Some(before)) = (pole.take(), kept.last())
            && !is_seam(before)
        {
            kept.push(pole.clone());
        }
        if index < pieces.len() {
            kept.push(piece.clone());
        }
    }
    kept
}

/// The ends of an edge, each with a longitude from -180 to 180. All meridians meet at a pole: an edge there follows its own.
fn along(ends: [DVec2; 2]) -> [DVec2; 2] {
    let mut ends = ends.map(|end| DVec2::new(turned(end.x), end.y));
    let longitudes = ends.map(|end| end.x);
    for (end, other) in ends.iter_mut().zip([longitudes[1], longitudes[0]]) {
        if is_pole(*end) {
            end.x = other;
        }
    }
    ends
}

struct Projecting {
    projection: Projection,
    /// Whether edges do not bend in its plane.
    is_straight: bool,
    sides: BoxSides,
    added: usize,
    named: usize,
}

impl Projecting {
    fn ring(&mut self, ring: &DrawnRing) -> Result<DrawnRing, OutlineError> {
        let pieces = without_seams(&ring.pieces);
        // A ring that goes all around has its ends on one meridian, by two longitudes. What has one longitude alone has no
        // area, such as an island that rounded coordinates made a point: that is for a repair, or for who proves the ring.
        if let Some(Piece { start, .. }) = pieces.first()
            && pieces.iter().all(|piece| turned(piece.start.x - start.x).abs() < NEAR)
            && pieces.iter().any(|piece| (piece.start.x - start.x).abs() > 1.0)
        {
            return Err(OutlineError::place(
                "",
                format!(
                    "a ring has no points off the meridian of {}°, and edges go the short way around the globe: put points on \
                 those that go all around, or choose a part",
                    start.x
                ),
            ));
        }
        let mut projected: Vec<Piece> = Vec::with_capacity(pieces.len());
        for (index, piece) in pieces.iter().enumerate() {
            let ends = along([piece.start, pieces[(index + 1) % pieces.len()].start]);
            let of_box =
                self.sides.name(ends).filter(|_| piece.side.is_none() && ends[0] != ends[1]);
            self.named += usize::from(of_box.is_some());
            let side = of_box.map(Shared::from).or(piece.side.clone());
            let start = self.place(ends[0])?;
            if projected.last().is_some_and(|before| before.start == start) {
                projected.pop();
            }
            projected.push(Piece { start, side: side.clone(), ..piece.clone() });
            projected.extend(
                self.bends(ends)
                    .into_iter()
                    .map(|start| Piece { side: side.clone(), ..Piece::line(start) }),
            );
        }
        while projected.len() > 1
            && projected.first().map(|it| it.start) == projected.last().map(|it| it.start)
        {
            projected.pop();
        }
        Ok(DrawnRing { pieces: projected })
    }

    /// Lines and points in the plane.
    fn inside(&mut self, inside: &DrawnInside) -> Result<DrawnInside, OutlineError> {
        let mut projected = DrawnInside::default();
        for line in &inside.lines {
            let ends = along([line.segment.start, line.segment.end]);
            let [start, end] = [self.place(ends[0])?, self.place(ends[1])?];
            let bends = self.bends(ends);
            let points: Vec<DVec2> = once(start).chain(bends).chain([end]).collect();
            let edges = Border::through(&points, line.side.clone(), line.begins_side);
            projected.lines.extend(edges);
        }
        for point in &inside.points {
            let at = self.place(along([point.at; 2])[0])?;
            projected.points.push(InnerPoint { at, ..point.clone() });
        }
        Ok(projected)
    }

    /// The place of a point in the plane.
    fn place(&self, degrees: DVec2) -> Result<DVec2, OutlineError> {
        let place = self.projection.to_plane(degrees);
        if place.is_finite() {
            return Ok(place);
        }
        let problem = format!(
            "{} has no place in {}: it is too far from the middle; choose another projection",
            shown(degrees),
            self.projection.name()
        );
        Err(OutlineError::place("", problem))
    }

    /// Points between the ends of an edge, where it bends.
    fn bends(&mut self, mut ends: [DVec2; 2]) -> Vec<DVec2> {
        if self.is_straight {
            return Vec::new();
        }
        // The short way round.
        ends[1].x = ends[0].x + turned(ends[1].x - ends[0].x);
        let mut points = Vec::new();
        let places = ends.map(|end| self.projection.to_plane(DVec2::new(turned(end.x), end.y)));
        let most = MOST_BENT * places[0].distance(places[1]);
        self.bend(ends, places, most, &mut points);
        self.added += points.len();
        points
    }

    /// Points on an edge of degrees until the plane's edges are at most as far from it as `most`; the same both ways round.
    fn bend(&self, degrees: [DVec2; 2], plane: [DVec2; 2], most: f64, points: &mut Vec<DVec2>) {
        let middle = degrees[0].midpoint(degrees[1]);
        let at = self.projection.to_plane(DVec2::new(turned(middle.x), middle.y));
        let is_bent = at.distance(plane[0].midpoint(plane[1])) > most;
        if !is_bent || plane[0].distance(plane[1]) < 1.0 {
            return;
        }
        self.bend([degrees[0], middle], [plane[0], at], most, points);
        points.push(at);
        self.bend([middle, degrees[1]], [at, plane[1]], most, points);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{OutlineFormat, read};

    fn projected(rings: &str, choice: &str) -> Result<(Outlines, Option<Projection>), String> {
        let text = format!(r#"{{"type": "Polygon", "coordinates": {rings}}}"#);
        let alone = |_: &str| Err(std::io::ErrorKind::NotFound.into());
        let outlines = read(text.as_bytes(), OutlineFormat::GeoJson, alone).unwrap();
        let plane =
            outlines.projected(choice.parse().unwrap()).map_err(|error| error.to_string())?;
        let projection = plane.projection;
        Ok((plane, projection))
    }

    #[test]
    fn the_scale_is_looked_at_inside_and_swapped_coordinates_are_told() {
        // Around the pole a polar projection is true to scale at 70 degrees, and shorter at the pole.
        let ring: Vec<[f64; 2]> = (0..36).map(|i| [f64::from(10 * i) - 175.0, 72.0]).collect();
        let across = format!("[{:?}]", [[0.0, 72.0], [90.0, 72.0], [170.0, 72.0], [-90.0, 72.0]]);
        for rings in [format!("[{ring:?}]"), across] {
            let (outlines, _) = projected(&rings, "EPSG:3413").unwrap();
            assert!(outlines.notes[0].contains("are 0.9"), "{:?}", outlines.notes);
        }
        let wide = "[[[-20, 0], [20, 0], [20, 60], [-20, 60]]]";
        let (outlines, _) = projected(wide, "+proj=stere +lat_0=30 +lon_0=0").unwrap();
        assert!(outlines.notes[0].contains("are 1.0000 to 1.1"), "{:?}", outlines.notes);
        // A zone a quarter of the globe away, and the other pole.
        for code in ["EPSG:32616", "EPSG:3031"] {
            let error = projected("[[[177, 18], [179, 18], [179, 20]]]", code).unwrap_err();
            assert!(error.contains("is not for a region here (177, 18)"), "{error}");
        }
        let swapped = projected("[[[36, 120], [37, 120], [37, 121]]]", "auto").unwrap_err();
        assert!(swapped.contains("GeoJSON has the longitude first"), "{swapped}");
    }

    #[test]
    fn an_island_past_the_box_leaves_its_sides_their_names() {
        let sea = "[[20, 36], [22, 36], [22, 38], [20, 38]]";
        let past = "[[21.9, 36.9], [22.3, 36.9], [22.3, 37.1], [21.9, 37.1]]";
        let (outlines, _) = projected(&format!("[{sea}, {past}]"), "auto").unwrap();
        let pieces = &outlines.features[0].rings[0].pieces;
        let is_named = |name: &str| pieces.iter().any(|piece| piece.side.as_deref() == Some(name));
        assert!(["south", "east", "north", "west"].into_iter().all(is_named));
    }

    #[test]
    fn an_island_on_the_box_is_no_sea_beside_it() {
        for shift in [0.0, 159.0] {
            let ring = |points: &[[f64; 2]]| {
                let at = |x: f64| if x + shift > 180.0 { x + shift - 360.0 } else { x + shift };
                let points: Vec<[f64; 2]> = points.iter().map(|[x, y]| [at(*x), *y]).collect();
                format!("{points:?}")
            };
            let sea = ring(&[[20.0, 36.0], [22.0, 36.0], [22.0, 38.0], [20.0, 38.0]]);
            for (island, holes) in [
                ([[22.0, 37.0], [22.0, 37.3], [21.8, 37.1]], 0),
                ([[21.0, 38.0], [21.5, 38.0], [21.2, 37.5]], 0),
                ([[22.0, 37.0], [21.8, 37.1], [21.7, 36.9]], 1),
            ] {
                let rings = format!("[{sea}, {}]", ring(&island));
                let (outlines, _) = projected(&rings, "auto").unwrap();
                let repaired = outlines.repaired(None).unwrap();
                assert_eq!(repaired.features.len(), 1, "{shift} {island:?}: {:?}", repaired.notes);
                assert_eq!(repaired.features[0].rings.len(), 1 + holes);
            }
        }
    }

    #[test]
    fn edges_bend_with_their_parallel_and_get_names() {
        let (outlines, projection) =
            projected("[[[22.5, 35.5], [28, 35.5], [28, 40.5], [25, 39], [22.5, 40.5]]]", "auto")
                .unwrap();
        let projection = projection.unwrap();
        assert_eq!(projection.to_string(), "+proj=utm +zone=35 +datum=WGS84");
        let ring = &outlines.features[0].rings[0];
        let mut south = 0;
        for (piece, segment) in ring.pieces.iter().zip(ring.segments()) {
            let [a, b] = [segment.start, segment.end].map(|end| projection.to_degrees(end));
            if piece.side.as_deref() == Some("south") {
                south += 1;
                assert!((a.y - 35.5).abs() < 1e-10 && (b.y - 35.5).abs() < 1e-10, "{a} {b}");
                // The chord stays near the parallel.
                let middle = projection.to_degrees(segment.start.midpoint(segment.end));
                assert!((middle.y - 35.5).abs() < MOST_BENT * 5.5, "{middle}");
            }
        }
        // Points on it for what it bends, not for each of its parts: it is as good with a tenth of them.
        assert!((8..=16).contains(&south), "{south}");
        let mut names: Vec<_> = ring.pieces.iter().map(|piece| piece.side.as_deref()).collect();
        names.dedup();
        assert_eq!(names, [Some("south"), Some("east"), None, Some("west")]);
        assert!(
            outlines.notes[0].starts_with("projected degrees by UTM zone 35 north"),
            "{:?}",
            outlines.notes
        );
        assert!(!outlines.is_in_degrees());
    }

    #[test]
    fn the_antimeridian_and_the_poles_are_ordinary_places() {
        let area = |outlines: &Outlines| outlines.features[0].rings[0].doubled_area().abs() / 2e6;
        // The same square of two degrees, on and off the antimeridian.
        let across = "[[[179, -17], [-179, -17], [-179, -19], [179, -19]]]";
        let (across, _) = projected(across, "laea").unwrap();
        let beside = "[[[19, -17], [21, -17], [21, -19], [19, -19]]]";
        let (beside, _) = projected(beside, "laea").unwrap();
        assert!(
            (area(&across) / area(&beside) - 1.0).abs() < 1e-6,
            "{} {}",
            area(&across),
            area(&beside)
        );
        // And drawn on a copy of the world, two turns further east.
        let copy = "[[[739, -17], [741, -17], [741, -19], [739, -19]]]";
        assert!((area(&projected(copy, "laea").unwrap().0) / area(&beside) - 1.0).abs() < 1e-6);
        // A cap with the seam that planar programs draw along the pole: 2 pi R^2 (1 - sin 70).
        let cap = "[[[-180, 70], [-90, 70], [0, 70], [90, 70], [180, 70], [180, 90], [-180, 90]]]";
        let (cap, projection) = projected(cap, "laea").unwrap();
        assert!(projection.unwrap().to_string().starts_with("+proj=laea +lat_0=90"));
        assert!((area(&cap) / 15.4e6 - 1.0).abs() < 0.01, "{}", area(&cap));
        // A part of it with its corner at the pole, and a box around the globe without points on its way.
        let (part, _) = projected("[[[0, 80], [30, 80], [30, 90], [0, 90]]]", "laea").unwrap();
        let whole =
            2.0 * std::f64::consts::PI * 6371.0_f64.powi(2) * (1.0 - 80_f64.to_radians().sin());
        assert!((area(&part) / (whole / 12.0) - 1.0).abs() < 0.02, "{} {whole}", area(&part));
        let box_ = projected("[[[-180, -80], [180, -80], [180, 80], [-180, 80]]]", "auto");
        assert!(box_.unwrap_err().contains("put points on"));
        let whole = "[[[-180, -80], [-60, -80], [60, -80], [60, 80], [-60, 80], [-180, 80]]]";
        assert!(projected(whole, "auto").unwrap_err().contains("choose a part"));
        assert!(
            projected(&whole.replace("80", "8000"), "auto")
                .unwrap_err()
                .contains("leave out --project")
        );
    }

    #[test]
    fn a_point_of_a_neighbour_on_an_edge_stays_on_it() {
        let text = r#"{"type": "MultiPolygon", "coordinates": [[[[5, 52], [9, 54], [5, 54]]], [[[5, 52], [9, 52], [9, 54], [7, 53]]]]}"#;
        let alone = |_: &str| Err(std::io::ErrorKind::NotFound.into());
        let outlines = read(text.as_bytes(), OutlineFormat::GeoJson, alone).unwrap();
        let outlines = outlines.projected(ProjectionChoice::Auto).unwrap();
        let projection = outlines.projection;
        let at = projection.unwrap().to_plane(DVec2::new(7.0, 53.0));
        for feature in &outlines.features {
            assert!(feature.rings[0].pieces.iter().any(|piece| piece.start == at));
        }
        let repaired = outlines.repaired_together(None, None).unwrap();
        assert!(
            repaired.notes.iter().all(|note| !note.contains("overlap")),
            "{:?}",
            repaired.notes
        );
    }

    #[test]
    fn a_ring_that_rounding_made_a_point_is_left_to_a_repair() {
        let land = "[[5, 52], [6, 52], [6, 53], [5, 53]]";
        for lost in
            ["[[5.6, 52.4], [5.6, 52.4], [5.6, 52.4]]", "[[5.6, 52.4], [5.6, 52.5], [5.6, 52.4]]"]
        {
            let (outlines, _) = projected(&format!("[{land}, {lost}]"), "auto").unwrap();
            let repaired = outlines.repaired(None).unwrap();
            assert_eq!(repaired.features[0].rings.len(), 1, "{lost}");
        }
    }

    #[test]
    fn shared_edges_bend_alike_both_ways_round() {
        let of = |rings: &str| projected(rings, "+proj=stere +lat_0=0 +lon_0=180").unwrap().0;
        let points = |outlines: &Outlines| -> Vec<[u64; 2]> {
            let pieces = &outlines.features[0].rings[0].pieces;
            pieces.iter().map(|piece| [piece.start.x.to_bits(), piece.start.y.to_bits()]).collect()
        };
        let mut one = points(&of("[[[170, 50], [-170, 51], [180, 60]]]"));
        let mut other = points(&of("[[[180, 60], [-170, 51], [170, 50]]]"));
        one.sort_unstable();
        other.sort_unstable();
        assert!(one.len() > 10);
        assert_eq!(one, other);
    }
}
