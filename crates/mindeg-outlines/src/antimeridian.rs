//! Polygons across the antimeridian, cut there, as RFC 7946 asks of GeoJSON.
//!
//! TopoJSON of whole worlds often has rings that run from 180° of longitude to -180°. In the plane such an edge runs back
//! around the world. Here it goes the short way: the ring is cut where it meets the antimeridian, and the polygon is closed
//! along it on both sides. A ring around a pole is closed along the pole.

mod joining;

use std::borrow::Cow;
use std::collections::BTreeSet;

use glam::DVec2;
use mindeg_mesh::listed;

use crate::curve::Segment;
use crate::error::OutlineError;
use crate::nesting::polygons;
use crate::outline::{Border, DrawnRing, Feature, FillRule, Outlines};
use crate::text::counted;

/// The longitude of the antimeridian.
const HALF_TURN: f64 = 180.0;
pub(super) const TURN: f64 = 2.0 * HALF_TURN;

/// Points nearer to the antimeridian, in degrees, are on it: rounding.
const NEAR: f64 = 1e-9;

/// An edge is taken to cross the antimeridian if its longitudes differ by more.
const LONGEST: f64 = 270.0;

/// How many polygons the note names.
const NAMED: usize = 5;

impl Outlines {
    /// The polygons that cross the antimeridian in a few words, which a repair cuts; `None` without one.
    #[must_use]
    pub fn across_antimeridian(&self) -> Option<String> {
        let (mut count, mut names) = (0, BTreeSet::new());
        for feature in self.features.iter().filter(|it| self.is_geographic && crosses(it)) {
            count += 1;
            names.extend(feature.name.clone());
        }
        (count > 0).then(|| told(count, names))
    }

    /// Cuts the polygons and lines that cross the antimeridian, if coordinates are longitudes and latitudes, and notes which polygons.
    pub(super) fn cut_at_antimeridian(&mut self) -> Result<(), OutlineError> {
        if !self.is_geographic {
            return Ok(());
        }
        let (mut count, mut names) = (0, BTreeSet::new());
        self.each_shape(|features| {
            let mut all = Vec::with_capacity(features.len());
            for feature in features {
                match cut(&feature)? {
                    None => all.push(feature),
                    Some(parts) => {
                        count += 1;
                        names.extend(feature.name);
                        all.extend(parts);
                    }
                }
            }
            Ok::<_, OutlineError>(all)
        })?;
        let lines = std::mem::take(&mut self.inside.lines);
        self.inside.lines = lines.into_iter().flat_map(parts_of).collect();
        if count > 0 {
            self.notes.push(format!("cut {} along 180° of longitude", told(count, names)));
        }
        Ok(())
    }

    /// Puts other polygons in place of those of each shape.
    fn each_shape<E>(
        &mut self,
        mut change: impl FnMut(Vec<Feature>) -> Result<Vec<Feature>, E>,
    ) -> Result<(), E> {
        let mut features = std::mem::take(&mut self.features).into_iter();
        let mut start = 0;
        for shape in &mut self.shapes {
            self.features.extend(change(features.by_ref().take(shape.end - start).collect())?);
            start = std::mem::replace(&mut shape.end, self.features.len());
        }
        self.features.extend(features);
        Ok(())
    }
}

/// A number of polygons with the first names.
fn told(count: usize, names: BTreeSet<String>) -> String {
    let polygons = counted(count, "polygon");
    if names.is_empty() { polygons } else { format!("{polygons} ({})", listed(names, NAMED, ", ")) }
}

/// Whether a ring of a polygon crosses the antimeridian.
fn crosses(feature: &Feature) -> bool {
    feature
        .rings
        .iter()
        .map(points_of)
        .any(|points| !points.iter().all(is_on) && edges(&points).any(|[a, b]| is_across(a, b)))
}

fn points_of(ring: &DrawnRing) -> Vec<DVec2> {
    ring.pieces.iter().map(|piece| piece.start).collect()
}

/// Where a part of a ring ends at the antimeridian: on its east or west side, at a latitude.
#[derive(Clone, Copy)]
struct End {
    /// Whether the part lies at longitudes just below 180°.
    is_below: bool,
    latitude: f64,
}

impl End {
    fn point(self) -> DVec2 {
        DVec2::new(if self.is_below { HALF_TURN } else { -HALF_TURN }, self.latitude)
    }
}

/// The parts of a polygon that crosses the antimeridian.
fn cut(feature: &Feature) -> Result<Option<Vec<Feature>>, OutlineError> {
    if !crosses(feature) {
        return Ok(None);
    }
    let (mut closed, mut open) = (Vec::new(), Vec::new());
    for ring in &feature.rings {
        match runs(&points_of(ring)) {
            Runs::Whole(ring) => closed.push(ring),
            Runs::Open(runs) => open.extend(runs),
        }
    }
    closed.extend(joined(open));
    for ring in &mut closed {
        ring.dedup();
    }
    let rings = closed.into_iter().map(DrawnRing::of_points).collect();
    let (parts, _) = polygons(rings, FillRule::EvenOdd, feature.name.as_deref())?;
    let max_area = feature.max_area;
    Ok(Some(parts.into_iter().map(|part| Feature { max_area, ..part }).collect()))
}

/// The parts of an edge of a line on either side of the antimeridian.
fn parts_of(edge: Border) -> Vec<Border> {
    let Segment { start, end, curve } = edge.segment;
    if !is_across(start, end) {
        return vec![edge];
    }
    let latitude = crossing(start, end);
    let on = |is_below| End { is_below, latitude }.point();
    let parts = [[start, on(start.x > 0.0)], [on(end.x > 0.0), end]].into_iter();
    let parts = parts.filter(|[start, end]| start != end);
    parts
        .map(|[start, end]| Border { segment: Segment { start, end, curve }, ..edge.clone() })
        .collect()
}

fn edges(ring: &[DVec2]) -> impl Iterator<Item = [DVec2; 2]> + '_ {
    ring.iter().zip(ring.iter().cycle().skip(1)).map(|(&a, &b)| [a, b])
}

fn is_on(point: &DVec2) -> bool {
    point.x.abs() >= HALF_TURN - NEAR
}

/// Whether the short way between two points crosses the antimeridian. Along a pole it does not: there a polygon of the plane
/// has its edge.
fn is_across(a: DVec2, b: DVec2) -> bool {
    let is_pole = a.y.abs() == 90.0 && a.y == b.y;
    (a.x - b.x).abs() > LONGEST && !is_pole
}

/// A ring, cut.
enum Runs {
    /// It only touches the antimeridian: a closed ring.
    Whole(Vec<DVec2>),
    /// Points between two ends.
    Open(Vec<(End, Vec<DVec2>, End)>),
}

/// Cuts a ring where it crosses the antimeridian.
fn runs(ring: &[DVec2]) -> Runs {
    let Some(first) = ring.iter().position(|point| !is_on(point)) else {
        return Runs::Whole(ring.to_vec());
    };
    let rotated = || ring[first..].iter().chain(&ring[..=first]).copied();
    // The points since the last cut, and those on the antimeridian since the last one that is not.
    let (mut own, mut on): (Vec<DVec2>, Vec<DVec2>) = (vec![ring[first]], Vec::new());
    let mut cuts: Vec<(Vec<DVec2>, [End; 2])> = Vec::new();
    let mut last = ring[first];
    for point in rotated().skip(1) {
        if is_on(&point) {
            on.push(point);
            continue;
        }
        // The side of the antimeridian from which one comes, and to which one goes.
        let side = |inner: DVec2, at: DVec2| (at.x > 0.0) != is_across(inner, at);
        let ends = match (&on[..], is_across(last, point)) {
            (&[from, ..], _) => {
                let to = on[on.len() - 1];
                Some([(side(last, from), from.y), (side(point, to), to.y)])
            }
            ([], true) => {
                let latitude = crossing(last, point);
                Some([(last.x > 0.0, latitude), (point.x > 0.0, latitude)])
            }
            ([], false) => None,
        };
        let ends = ends.map(|ends| ends.map(|(is_below, latitude)| End { is_below, latitude }));
        match ends {
            Some([from, to]) if from.is_below != to.is_below => {
                cuts.push((std::mem::take(&mut own), [from, to]));
            }
            Some([End { is_below, .. }, _]) => {
                own.extend(on.iter().map(|at| End { is_below, latitude: at.y }.point()));
            }
            None => {}
        }
        on.clear();
        own.push(point);
        last = point;
    }
    // The last point is the first again.
    own.pop();
    let Some((before_first, _)) = cuts.first_mut() else { return Runs::Whole(own) };
    own.append(before_first);
    *before_first = own;
    let count = cuts.len();
    let ends: Vec<[End; 2]> = cuts.iter().map(|cut| cut.1).collect();
    let run = |(index, (points, [end, _])): (usize, (Vec<DVec2>, [End; 2]))| {
        (ends[(index + count - 1) % count][1], points, end)
    };
    Runs::Open(cuts.into_iter().enumerate().map(run).collect())
}

/// The rings of a polygon whose longitudes run on past 180° where it crosses the antimeridian. What goes around a pole does not
/// close so: that polygon is cut.
pub(super) fn running_on(feature: &Feature) -> Result<Cow<'_, [DrawnRing]>, OutlineError> {
    if !crosses(feature) {
        return Ok(Cow::Borrowed(&feature.rings));
    }
    let ring = |ring: &DrawnRing| ring_running_on(ring).filter(|it| it.1).map(|it| it.0);
    if let Some(rings) = feature.rings.iter().map(ring).collect() {
        return Ok(Cow::Owned(rings));
    }
    Ok(cut(feature)?.into_iter().flatten().flat_map(|part| part.rings).collect())
}

/// A ring whose longitudes run on past 180° where it crosses the antimeridian, and whether it closes so; `None` without points.
fn ring_running_on(ring: &DrawnRing) -> Option<(DrawnRing, bool)> {
    let first = ring.pieces.first()?.start;
    let mut ring = ring.clone();
    let (mut last, mut turns) = (first, 0.0);
    let mut turn = |to: DVec2| {
        if is_across(last, to) {
            turns += TURN.copysign(last.x - to.x);
        }
        last = to;
        turns
    };
    for piece in &mut ring.pieces {
        piece.start.x += turn(piece.start);
    }
    let closes = turn(first) == 0.0;
    Some((ring, closes))
}

/// The latitude at which the short way between two points crosses the antimeridian; the same both ways round.
fn crossing(a: DVec2, b: DVec2) -> f64 {
    let (below, above) = if a.x > b.x { (a, b) } else { (b, a) };
    let share = (HALF_TURN - below.x) / (above.x + TURN - below.x);
    below.y + (above.y - below.y) * share
}

/// Closed rings of runs: along the antimeridian, from each first crossing to the next one north, each second one is inside.
fn joined(runs: Vec<(End, Vec<DVec2>, End)>) -> Vec<Vec<DVec2>> {
    // Each run has two ends: 2 * run is its first.
    let ends: Vec<End> = runs.iter().flat_map(|(start, _, end)| [*start, *end]).collect();
    let sorted = |is_below: bool| {
        let mut own: Vec<usize> =
            (0..ends.len()).filter(|&end| ends[end].is_below == is_below).collect();
        own.sort_by(|&a, &b| ends[a].latitude.total_cmp(&ends[b].latitude).then(a.cmp(&b)));
        own
    };
    let mut sides = [sorted(true), sorted(false)];
    let mut partner = vec![0; ends.len()];
    let mut pole = None;
    if sides[0].len() % 2 == 1 {
        // An odd number: a pole is inside, the nearer one.
        let sum: f64 = ends.iter().map(|end| end.latitude).sum();
        let outermost = sides
            .each_mut()
            .map(|side| if sum < 0.0 { side.remove(0) } else { side.pop().unwrap_or_default() });
        let [below, above] = outermost;
        (partner[below], partner[above]) = (above, below);
        pole = Some((outermost, 90.0_f64.copysign(sum)));
    }
    for pair in sides.iter().flat_map(|side| side.chunks_exact(2)) {
        (partner[pair[0]], partner[pair[1]]) = (pair[1], pair[0]);
    }
    let mut is_used = vec![false; runs.len()];
    let mut rings = Vec::new();
    for first in 0..runs.len() {
        let (mut ring, mut at) = (Vec::new(), 2 * first);
        while !std::mem::replace(&mut is_used[at / 2], true) {
            let points = &runs[at / 2].1;
            ring.push(ends[at].point());
            if at % 2 == 0 {
                ring.extend(points);
            } else {
                ring.extend(points.iter().rev());
            }
            let end = at ^ 1;
            ring.push(ends[end].point());
            at = partner[end];
            if let Some((_, latitude)) = pole.filter(|(outermost, _)| outermost.contains(&end)) {
                ring.extend([end, at].map(|end| End { latitude, ..ends[end] }.point()));
            }
        }
        if !ring.is_empty() {
            rings.push(ring);
        }
    }
    rings
}

#[cfg(test)]
mod tests {
    use crate::{OutlineFormat, Outlines, read};

    #[test]
    fn lines_are_cut_too() {
        let text = "POLYGON((170 0,180 0,180 9,170 9)) POLYGON((-180 0,-170 0,-170 9,-180 9)) \
                    LINESTRING(178 2,-179 5) LINESTRING(180 7,-176 7)";
        let alone = |_: &str| Err(std::io::ErrorKind::NotFound.into());
        let mut outlines = read(text.as_bytes(), OutlineFormat::Wkt, alone).unwrap();
        outlines.is_geographic = true;
        outlines.cut_at_antimeridian().unwrap();
        let ends = |it: &crate::outline::Border| {
            [it.segment.start, it.segment.end].map(|at| at.to_array())
        };
        let found: Vec<_> = outlines.inside.lines.iter().map(ends).collect();
        let expected = [
            [[178.0, 2.0], [180.0, 4.0]],
            [[-180.0, 4.0], [-179.0, 5.0]],
            [[-180.0, 7.0], [-176.0, 7.0]],
        ];
        assert_eq!(found, expected);
    }

    /// The points of the rings of a polygon.
    type Polygon = Vec<Vec<[f64; 2]>>;

    /// The rings of all polygons of GeoJSON after the cut, each counter-clockwise from its least point.
    fn cut(rings: &str) -> (Vec<Polygon>, Vec<String>) {
        let text = format!(
            r#"{{"type": "Feature", "id": "it", "geometry": {{"type": "Polygon", "coordinates": {rings}}}}}"#
        );
        let alone = |_: &str| Err(std::io::ErrorKind::NotFound.into());
        let mut outlines: Outlines = read(text.as_bytes(), OutlineFormat::GeoJson, alone).unwrap();
        let told = outlines.across_antimeridian();
        outlines.cut_at_antimeridian().unwrap();
        assert_eq!(told.is_some(), !outlines.notes.is_empty());
        assert_eq!(outlines.across_antimeridian(), None);
        let names: Vec<_> = outlines.features.iter().map(|it| it.name.as_deref()).collect();
        assert!(names.iter().all(|name| *name == Some("it")), "{names:?}");
        assert_eq!(outlines.shapes.last().unwrap().end, outlines.features.len());
        let points = |ring: &crate::DrawnRing| {
            let mut points: Vec<[f64; 2]> =
                ring.pieces.iter().map(|piece| piece.start.to_array()).collect();
            if ring.doubled_area() < 0.0 {
                points.reverse();
            }
            let least =
                (0..points.len()).min_by(|&a, &b| points[a].partial_cmp(&points[b]).unwrap());
            points.rotate_left(least.unwrap());
            points
        };
        let mut found: Vec<Vec<_>> =
            outlines.features.iter().map(|it| it.rings.iter().map(points).collect()).collect();
        found.sort_by(|a, b| a.partial_cmp(b).unwrap());
        (found, outlines.notes)
    }

    #[test]
    fn polygons_are_cut_where_they_cross_the_antimeridian() {
        for (rings, expected) in [
            // Edges that cross between points, and a point on the antimeridian.
            (
                "[[[178, 0], [-178, 0], [-178, 2], [180, 4], [178, 2]]]",
                vec![
                    vec![vec![[-180.0, 0.0], [-178.0, 0.0], [-178.0, 2.0], [-180.0, 4.0]]],
                    vec![vec![[178.0, 0.0], [180.0, 0.0], [180.0, 4.0], [178.0, 2.0]]],
                ],
            ),
            // An edge of no length from one name of a point to the other; and one along the antimeridian.
            (
                "[[[180, 1], [178, 1], [178, 3], [-180, 3], [-178, 2], [-180, 1.5], [-180, 1]]]",
                vec![
                    vec![vec![[-180.0, 1.5], [-178.0, 2.0], [-180.0, 3.0]]],
                    vec![vec![[178.0, 1.0], [180.0, 1.0], [180.0, 3.0], [178.0, 3.0]]],
                ],
            ),
            // It touches from one side, under the name of the other.
            (
                "[[[-180, 1], [180, 2], [178, 2], [178, 1]]]",
                vec![vec![vec![[178.0, 1.0], [180.0, 1.0], [180.0, 2.0], [178.0, 2.0]]]],
            ),
            // A hole across it, and one beside it.
            (
                "[[[170, 0], [-170, 0], [-170, 9], [170, 9]], [[179, 4], [-179, 4], [-179, 5], [179, 5]],
                  [[171, 1], [171, 2], [172, 2]]]",
                vec![
                    vec![vec![
                        [-180.0, 0.0],
                        [-170.0, 0.0],
                        [-170.0, 9.0],
                        [-180.0, 9.0],
                        [-180.0, 5.0],
                        [-179.0, 5.0],
                        [-179.0, 4.0],
                        [-180.0, 4.0],
                    ]],
                    vec![
                        vec![
                            [170.0, 0.0],
                            [180.0, 0.0],
                            [180.0, 4.0],
                            [179.0, 4.0],
                            [179.0, 5.0],
                            [180.0, 5.0],
                            [180.0, 9.0],
                            [170.0, 9.0],
                        ],
                        vec![[171.0, 1.0], [172.0, 2.0], [171.0, 2.0]],
                    ],
                ],
            ),
            // Around a pole: down to it; and a band between two rings around it.
            (
                "[[[-180, -70], [-90, -60], [0, -65], [90, -60], [180, -70]]]",
                vec![vec![vec![
                    [-180.0, -90.0],
                    [180.0, -90.0],
                    [180.0, -70.0],
                    [90.0, -60.0],
                    [0.0, -65.0],
                    [-90.0, -60.0],
                    [-180.0, -70.0],
                ]]],
            ),
            (
                "[[[-170, 70], [0, 70], [170, 70]], [[-170, 80], [0, 80], [170, 80]]]",
                vec![vec![vec![
                    [-180.0, 70.0],
                    [-170.0, 70.0],
                    [0.0, 70.0],
                    [170.0, 70.0],
                    [180.0, 70.0],
                    [180.0, 80.0],
                    [170.0, 80.0],
                    [0.0, 80.0],
                    [-170.0, 80.0],
                    [-180.0, 80.0],
                ]]],
            ),
        ] {
            let (found, notes) = cut(rings);
            assert_eq!(found, expected, "{rings}");
            assert_eq!(notes, ["cut 1 polygon (it) along 180° of longitude"]);
        }
    }

    #[test]
    fn polygons_of_the_plane_stay() {
        for ring in [
            // The whole world; Antarctica with its edge along the pole; wide boxes.
            "[[-180, -90], [180, -90], [180, 90], [-180, 90]]",
            "[[-180, -90], [180, -90], [180, -70], [0, -60], [-180, -70]]",
            "[[-180, -50], [180, -50], [180, 50], [-180, 50]]",
            "[[-130, -50], [130, -50], [130, 50], [-130, 50]]",
            // No longitudes.
            "[[-181, 0], [180, 0], [170, 2], [-170, 2]]",
        ] {
            let (found, notes) = cut(&format!("[{ring}]"));
            assert!(notes.is_empty(), "{ring}: {notes:?}");
            assert_eq!(found.len(), 1);
        }
    }
}
