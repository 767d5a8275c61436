//! Outlines whose rings cross or touch themselves or each other, as polygons that do not.
//!
//! The polygons of a shape (a multi-polygon, an element of an SVG, the rings of a file without polygons)
//! are those of all points that a fill rule counts as inside; they do not overlap. A hole may touch another
//! ring of its polygon at vertices.

use mindeg_mesh::{number, place};
use std::collections::BTreeSet;

use glam::DVec2;

use super::curve::{PieceCurve, norm};
use super::nesting::contains;
use super::outline::FillRule;
use super::outline::{DrawnRing, Feature, Outlines, Shape, key};
use super::overlay::crossings::meeting;
use super::overlay::{Layer, Overlay, overlay};
use super::text::counted;
use crate::error::OutlineError;

/// The share of the shorter neighbouring edge by which a vertex moves at most.
const SHARE_MOVED: f64 = 0.25;

/// The most edges to examine in order to move vertices of all polygons.
const MOST_LOOKED_AT: usize = 100_000_000;

impl Outlines {
    /// The polygons of the points inside, by the given rule or the file's own: that of each element in
    /// an SVG, else even-odd. Notes tell what was done.
    ///
    /// # Errors
    ///
    /// Rings too many or too near each other to be told apart in some seconds.
    ///
    /// # Example
    ///
    /// ```
    /// use mindeg_outlines::{FillRule, OutlineFormat, read};
    ///
    /// // A pentagram winds twice round its middle.
    /// let star = b"POLYGON((0 3, 2 -3, -3 1, 3 1, -2 -3))";
    /// let alone = |_: &str| Err(std::io::ErrorKind::NotFound.into());
    /// let outlines = read(star, OutlineFormat::Wkt, alone)?;
    /// let tips = outlines.clone().repaired(None)?;
    /// assert_eq!(tips.features.len(), 5);
    /// let whole = outlines.repaired(Some(FillRule::NonZero))?;
    /// assert_eq!(whole.features.len(), 1);
    /// # Ok::<(), mindeg_outlines::OutlineError>(())
    /// ```
    pub fn repaired(mut self, rule: Option<FillRule>) -> Result<Self, OutlineError> {
        self.cut_at_antimeridian()?;
        let Self { features, inside, periodic, kinds, notes, shapes, projection, .. } = self;
        let mut repaired = Self { inside, periodic, kinds, notes, projection, ..Self::default() };
        let mut features = features.into_iter();
        let mut start = 0;
        for shape in shapes {
            let Shape { end, rule: own, is_of_polygons, without_effect } = shape;
            let of_shape: Vec<Feature> = features.by_ref().take(end - start).collect();
            let whose = match &of_shape[..] {
                [first, ..] if first.name.is_some() => first.name.clone().unwrap_or_default(),
                [_] => format!("polygon {end}"),
                _ => format!("polygons {} to {end}", start + 1),
            };
            start = end;
            let mut rings: Vec<(&DrawnRing, Option<&str>)> = of_shape
                .iter()
                .flat_map(|it| it.rings.iter().map(|ring| (ring, it.name.as_deref())))
                .collect();
            rings.extend(without_effect.iter().map(|ring| (ring, None)));
            let rule = rule.unwrap_or(own);
            let has_one_name = of_shape.windows(2).all(|pair| pair[0].name == pair[1].name);
            let done = if is_of_polygons && has_one_name {
                without_holes(&of_shape, rule)
            } else {
                let layer = Layer { rings: rings.iter().map(|&(ring, _)| ring).collect(), rule };
                overlay(&[layer], |inside| inside[0])
            }
            .map_err(|problem| OutlineError::place(&*whose, problem))?;
            repaired.notes.extend(note(&whose, &of_shape, &done));
            repaired.features.extend(done.polygons.into_iter().map(|(polygon, follows)| {
                let name = follows.and_then(|ring| rings[ring].1).map(str::to_owned);
                Feature { name, rings: polygon, ..Feature::default() }
            }));
            repaired.end_shape();
        }
        repaired.clip_inside(0.0)?;
        Ok(repaired)
    }

    /// The same polygons without holes that touch other rings: where one does at a vertex, the vertex of the hole moves a
    /// little into the hole: by a quarter of its shorter edge there, and by `within`, at most. For a change of the boundary, which
    /// such rings would hold; meshes take them as they are. A note tells how many moved, how far, and where the
    /// farthest was: in metres and degrees if they were projected.
    #[must_use]
    pub fn with_parted_holes(mut self, within: f64) -> Self {
        let moves = part_holes(&mut self.features, within);
        let farthest = moves.iter().max_by(|a, b| a.0.total_cmp(&b.0));
        if let Some((far, at)) = farthest {
            let vertices = match moves.len() {
                1 => "1 vertex".to_owned(),
                count => format!("{count} vertices"),
            };
            let degrees = self.projection.map(|projection| projection.to_degrees(*at));
            let unit = if degrees.is_some() { " m" } else { "" };
            self.notes.push(format!(
                "moved {vertices} of touching holes by {}{unit} at most, at {}",
                number(*far),
                place(degrees.unwrap_or(*at))
            ));
        }
        self
    }
}

/// The polygons of the points of each polygon's outer ring that none of its holes has: whichever way these run, overlap, or reach
/// past it.
fn without_holes(polygons: &[Feature], rule: FillRule) -> Result<Overlay, String> {
    let rings = || polygons.iter().flat_map(|polygon| &polygon.rings);
    let layers: Vec<Layer<'_>> = rings().map(|ring| Layer { rings: vec![ring], rule }).collect();
    let is_in = |mut counted: &[bool]| {
        let mut around = 0;
        for polygon in polygons {
            let (own, others) = counted.split_at(polygon.rings.len());
            let is_around =
                own.split_first().is_some_and(|(outer, holes)| *outer && !holes.contains(&true));
            around += usize::from(is_around);
            counted = others;
        }
        around % 2 == 1
    };
    let mut done = overlay(&layers, is_in)?;
    // All have one name.
    done.polygons.iter_mut().for_each(|polygon| polygon.1 = Some(0));
    Ok(done)
}

fn note(whose: &str, before: &[Feature], done: &Overlay) -> Option<String> {
    let mut said = Vec::new();
    if done.added > 0 {
        said.push(format!("added {} where edges meet", counted(done.added, "point")));
    }
    if done.repeated > 0 {
        said.push(format!("dropped {}", counted(done.repeated, "repeated point")));
    }
    if done.dropped > 0 {
        let bound = if done.dropped == 1 { "bounds" } else { "bound" };
        said.push(format!("dropped {} that {bound} no area", counted(done.dropped, "edge")));
    }
    let after = done.polygons.len();
    if after != before.len() {
        said.push(format!("made {} of {}", counted(after, "polygon"), before.len()));
    }
    let holes: usize = before.iter().map(|feature| feature.rings.len().saturating_sub(1)).sum();
    let left: usize = done.polygons.iter().map(|(rings, _)| rings.len().saturating_sub(1)).sum();
    if left < holes {
        said.push(format!("made {} of {holes}", counted(left, "hole")));
    }
    (!said.is_empty()).then(|| format!("repaired {whose}: {}", said.join("; ")))
}

/// Moves the vertices of holes that other rings of their polygon have, too. Tells how far each went, and from where.
fn part_holes(features: &mut [Feature], within: f64) -> Vec<(f64, DVec2)> {
    let (mut moves, mut looked_at) = (Vec::new(), 0);
    for polygon in 0..features.len() {
        let mut taken = BTreeSet::new();
        for ring in 0..features[polygon].rings.len() {
            for index in 0..features[polygon].rings[ring].pieces.len() {
                let point = features[polygon].rings[ring].pieces[index].start;
                if !taken.contains(&key(point)) || looked_at > MOST_LOOKED_AT {
                    continue;
                }
                let rings = features.iter().flat_map(|feature| &feature.rings);
                let edges: Vec<[DVec2; 2]> = rings.flat_map(edges).collect();
                looked_at += edges.len();
                let ring = &mut features[polygon].rings[ring];
                if let Some(moved) = moved_inside(ring, index, &edges, within) {
                    moves.push((norm(moved - point), point));
                    ring.pieces[index].start = moved;
                }
            }
            let drawn = &features[polygon].rings[ring];
            taken.extend(drawn.pieces.iter().map(|piece| key(piece.start)));
        }
    }
    moves
}

/// The straight edges of a ring, and chords of its curves.
fn edges(ring: &DrawnRing) -> Vec<[DVec2; 2]> {
    let points = ring.flattened();
    let next = points.iter().copied().cycle().skip(1);
    points.iter().copied().zip(next).map(|(a, b)| [a, b]).collect()
}

/// A point a little inside the ring, beside one of its vertices, so that its pieces there meet no other
/// edge; `None` if they are curved or nothing is free.
fn moved_inside(
    ring: &DrawnRing,
    index: usize,
    edges: &[[DVec2; 2]],
    within: f64,
) -> Option<DVec2> {
    let count = ring.pieces.len();
    let [before, after] = [index + count - 1, index + 1].map(|at| &ring.pieces[at % count]);
    let here = &ring.pieces[index];
    if before.curve != PieceCurve::Line || here.curve != PieceCurve::Line || count < 3 {
        return None;
    }
    let point = here.start;
    let [back, forth] = [before.start, after.start].map(|end| end - point);
    let shorter = norm(back).min(norm(forth));
    let [back_unit, forth_unit] = [back / norm(back), forth / norm(forth)];
    // Inside is left of the ring if it runs counter-clockwise.
    let left = if ring.doubled_area() > 0.0 { 1.0 } else { -1.0 };
    let turn = left * (-back).perp_dot(forth);
    let middle = back_unit + forth_unit;
    let straight = left * forth_unit.perp();
    let direction = match middle.length() {
        0.0 => straight,
        length if turn < 0.0 => -middle / length,
        length => middle / length,
    };
    let points = ring.flattened();
    let ends = [before.start, after.start];
    let is_own =
        |edge: &[DVec2; 2]| edge.contains(&point) && ends.iter().any(|end| edge.contains(end));
    let reach = DVec2::splat(SHARE_MOVED * shorter);
    let low = point.min(ends[0]).min(ends[1]) - reach;
    let high = point.max(ends[0]).max(ends[1]) + reach;
    let near: Vec<[DVec2; 2]> = (edges.iter().copied())
        .filter(|[a, b]| a.min(*b).cmple(high).all() && a.max(*b).cmpge(low).all())
        .collect();
    let mut step = within.min(SHARE_MOVED * shorter);
    for _ in 0..30 {
        let moved = point + direction * step;
        let is_free = |end: DVec2| {
            let triangle = [point, end, moved];
            near.iter().all(|&edge| {
                let is_beside = is_own(&edge) || meeting([end, moved], edge).is_empty();
                is_beside && edge[0] != moved && !contains(&triangle, &edge[..1])
            })
        };
        if moved != point && contains(&points, &[moved]) && ends.into_iter().all(is_free) {
            return Some(moved);
        }
        step /= 2.0;
    }
    None
}

#[cfg(test)]
mod tests {
    use super::super::outline::Piece;
    use super::*;

    type Points = Vec<[f64; 2]>;

    /// The rings of each polygon after the repair of one ring or more, and the notes.
    fn repaired(rings: &[&[[f64; 2]]]) -> (Vec<Vec<Points>>, Vec<String>) {
        repaired_by(rings, None)
    }

    fn repaired_by(
        rings: &[&[[f64; 2]]],
        rule: Option<FillRule>,
    ) -> (Vec<Vec<Points>>, Vec<String>) {
        shown_of(outlines_of(rings).repaired(rule).unwrap())
    }

    fn outlines_of(rings: &[&[[f64; 2]]]) -> Outlines {
        let ring = |points: &&[[f64; 2]]| DrawnRing {
            pieces: points.iter().map(|&point| Piece::line(point.into())).collect(),
        };
        let feature = Feature { rings: rings.iter().map(ring).collect(), ..Feature::default() };
        let mut outlines = Outlines { features: vec![feature], ..Outlines::default() };
        outlines.end_shape();
        outlines
    }

    fn shown_of(outlines: Outlines) -> (Vec<Vec<Points>>, Vec<String>) {
        let points =
            |ring: &DrawnRing| ring.pieces.iter().map(|piece| piece.start.to_array()).collect();
        let rings = |feature: &Feature| feature.rings.iter().map(points).collect();
        (outlines.features.iter().map(rings).collect(), outlines.notes)
    }

    #[test]
    fn simple_rings_stay_as_they_are() {
        let square: &[[f64; 2]] = &[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
        let hole: &[[f64; 2]] = &[[1.0, 1.0], [2.0, 1.0], [1.0, 2.0]];
        let (features, notes) = repaired(&[square, hole]);
        assert_eq!(features, [[square.to_vec(), hole.to_vec()]]);
        assert!(notes.is_empty());
    }

    #[test]
    fn holes_take_away_what_they_have_however_they_lie() {
        let box_of = |x: f64, y: f64, size: f64| {
            vec![[x, y], [x + size, y], [x + size, y + size], [x, y + size]]
        };
        let outer = box_of(0.0, 0.0, 10.0);
        let island = box_of(2.0, 2.0, 4.0);
        for (other, area, count) in [
            // The same once more, as it is and the other way round; one that overlaps; one inside; one past the border.
            (island.clone(), 84.0, 1),
            (island.iter().rev().copied().collect(), 84.0, 1),
            (box_of(4.0, 4.0, 4.0), 72.0, 1),
            (box_of(3.0, 3.0, 1.0), 84.0, 1),
            (box_of(8.0, 4.0, 4.0), 76.0, 1),
        ] {
            for rule in [None, Some(FillRule::EvenOdd), Some(FillRule::NonZero)] {
                let (features, notes) = repaired_by(&[&outer, &island, &other], rule);
                assert_eq!((features.len(), features[0].len()), (1, 1 + count), "{other:?}");
                let found = features[0].iter().map(|ring| {
                    let points: Vec<DVec2> = ring.iter().copied().map(DVec2::from).collect();
                    mindeg_mesh::planar::doubled_area(&points).abs() / 2.0
                });
                let areas: Vec<f64> = found.collect();
                let left = areas[0] - areas[1..].iter().sum::<f64>();
                assert!((left - area).abs() < 1e-9, "{other:?} {rule:?}: {left}");
                assert!(notes[0].ends_with("made 1 hole of 2"), "{notes:?}");
            }
        }
    }

    #[test]
    fn repeated_points_and_spikes_are_dropped() {
        let triangle = vec![[0.0, 0.0], [4.0, 0.0], [0.0, 3.0]];
        for (points, note) in [
            (
                &[[0.0, 0.0], [4.0, 0.0], [4.0, 0.0], [4.0, 0.0], [0.0, 3.0], [0.0, 0.0]][..],
                "dropped 3 repeated points",
            ),
            // There and back along the same line, along a bent one, and farther than one came.
            (
                &[[0.0, 0.0], [4.0, 0.0], [9.0, 1.0], [4.0, 0.0], [0.0, 3.0]],
                "dropped 1 edge that bounds no area",
            ),
            (
                &[
                    [0.0, 0.0],
                    [4.0, 0.0],
                    [9.0, 1.0],
                    [9.0, 2.0],
                    [9.0, 1.0],
                    [4.0, 0.0],
                    [0.0, 3.0],
                ],
                "dropped 2 edges that bound no area",
            ),
            (
                &[[0.0, 0.0], [9.0, 0.0], [4.0, 0.0], [0.0, 3.0]],
                "added 1 point where edges meet; dropped 1 edge that bounds no area",
            ),
            (
                &[[0.0, 0.0], [4.0, 0.0], [0.0, 3.0], [0.0, 7.0]],
                "added 1 point where edges meet; dropped 1 edge that bounds no area",
            ),
        ] {
            let (features, notes) = repaired(&[points]);
            assert_eq!(features, [[triangle.clone()]], "{points:?}");
            assert_eq!(notes, [format!("repaired polygon 1: {note}")]);
        }
        // The tip is the first point.
        let (features, _) = repaired(&[&[[-2.0, 0.0], [4.0, 0.0], [0.0, 3.0], [0.0, 0.0]]]);
        assert_eq!(features, [[triangle]]);
        let (features, notes) = repaired(&[&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]]]);
        assert!(features.is_empty(), "{features:?}, {notes:?}");
    }

    #[test]
    fn a_ring_that_touches_itself_from_outside_becomes_two_polygons() {
        let ring: &[[f64; 2]] =
            &[[0.0, 0.0], [2.0, 1.0], [4.0, 0.0], [4.0, 2.0], [2.0, 1.0], [0.0, 2.0]];
        let (features, notes) = repaired(&[ring]);
        let left = vec![[0.0, 0.0], [2.0, 1.0], [0.0, 2.0]];
        let right = vec![[2.0, 1.0], [4.0, 0.0], [4.0, 2.0]];
        assert_eq!(features, [[left], [right]]);
        assert_eq!(notes, ["repaired polygon 1: made 2 polygons of 1"]);
    }

    #[test]
    fn a_ring_that_touches_itself_from_inside_gets_a_hole_which_may_move_away() {
        // A square with a triangular bay that closes at (2, 0).
        let ring: &[[f64; 2]] = &[
            [0.0, 0.0],
            [2.0, 0.0],
            [1.0, 2.0],
            [3.0, 2.0],
            [2.0, 0.0],
            [4.0, 0.0],
            [4.0, 4.0],
            [0.0, 4.0],
        ];
        let outlines = outlines_of(&[ring]).repaired(None).unwrap();
        assert_eq!(outlines.notes, Vec::<String>::new());
        let outer = vec![[0.0, 0.0], [2.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
        let touching = vec![[2.0, 0.0], [1.0, 2.0], [3.0, 2.0]];
        assert_eq!(shown_of(outlines.clone()).0, [[outer.clone(), touching]]);
        let (features, notes) = shown_of(outlines.with_parted_holes(f64::INFINITY));
        let [rings] = &features[..] else { panic!("{features:?}") };
        let [outside, hole] = &rings[..] else { panic!("{rings:?}") };
        // A repair keeps the projection.
        let mut near = outlines_of(&[ring]);
        near.projection = "EPSG:32635".parse().ok();
        let near = near.repaired(None).unwrap().with_parted_holes(0.125);
        let (features, near_notes) = shown_of(near);
        assert_eq!(features[0][1][0], [2.0, 0.125]);
        let told = "moved 1 vertex of touching holes by 0.125 m at most, at (22.51";
        assert!(near_notes[0].starts_with(told), "{near_notes:?}");
        assert_eq!(*outside, outer);
        assert_eq!(hole[1..], [[1.0, 2.0], [3.0, 2.0]]);
        assert_eq!(hole[0][0], 2.0);
        assert!(hole[0][1] > 0.5 && hole[0][1] < 0.6, "{hole:?}");
        assert_eq!(notes, ["moved 1 vertex of touching holes by 0.559 at most, at (2, 0)"]);
    }

    #[test]
    fn a_ring_that_crosses_itself_is_parted_there() {
        let ring: &[[f64; 2]] = &[[0.0, 0.0], [4.0, 4.0], [4.0, 0.0], [0.0, 4.0]];
        let (features, notes) = repaired(&[ring]);
        let right = vec![[2.0, 2.0], [4.0, 4.0], [4.0, 0.0]];
        assert_eq!(features, [[vec![[0.0, 0.0], [2.0, 2.0], [0.0, 4.0]]], [right]]);
        assert_eq!(
            notes,
            ["repaired polygon 1: added 2 points where edges meet; made 2 polygons of 1"]
        );
    }

    #[test]
    fn a_ring_joined_to_its_hole_by_a_cut_is_parted() {
        let ring: &[[f64; 2]] = &[
            [0.0, 0.0],
            [4.0, 0.0],
            [4.0, 4.0],
            [3.0, 3.0],
            [3.0, 1.0],
            [1.0, 1.0],
            [3.0, 3.0],
            [4.0, 4.0],
            [0.0, 4.0],
        ];
        let (features, _) = repaired(&[ring]);
        let outer = vec![[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
        assert_eq!(features, [[outer, vec![[3.0, 3.0], [3.0, 1.0], [1.0, 1.0]]]]);
    }

    #[test]
    fn holes_that_touch_from_a_reflex_vertex_move_inside() {
        let outer: &[[f64; 2]] = &[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [2.0, 2.0], [0.0, 4.0]];
        let hole: &[[f64; 2]] = &[[1.0, 2.5], [1.5, 0.5], [2.5, 0.5], [3.0, 2.5], [2.0, 2.0]];
        let outlines = outlines_of(&[outer, hole]).repaired(None).unwrap();
        let (features, _) = shown_of(outlines.with_parted_holes(f64::INFINITY));
        let moved = features[0][1][4];
        assert!(moved[0] == 2.0 && moved[1] < 2.0 && moved[1] > 1.5, "{moved:?}");
    }

    #[test]
    fn a_vertex_moves_along_the_middle_of_its_angle() {
        let ring =
            |points: &[[f64; 2]]| DrawnRing::of_points(points.iter().copied().map(DVec2::from));
        let beside =
            |ring: &DrawnRing, index: usize| moved_inside(ring, index, &edges(ring), f64::INFINITY);
        // A square, a straight vertex, a reflex one: the vertex 1, and where it goes.
        let half = 0.5_f64.sqrt();
        for (points, shorter, direction) in [
            (&[[0.0, 0.0], [4.0, 0.0], [4.0, 8.0], [0.0, 8.0]][..], 4.0, [-half, half]),
            (&[[0.0, 0.0], [6.0, 0.0], [8.0, 0.0], [8.0, 8.0], [0.0, 8.0]], 2.0, [0.0, 1.0]),
            (&[[0.0, 4.0], [4.0, 4.0], [4.0, 0.0], [8.0, 8.0], [0.0, 8.0]], 4.0, [half, half]),
        ] {
            let expected = DVec2::from(points[1]) + DVec2::from(direction) * SHARE_MOVED * shorter;
            let moved = beside(&ring(points), 1).unwrap();
            assert!(moved.distance(expected) < 1e-12, "{points:?}: {moved}, {expected}");
            let mut back = points.to_vec();
            back.reverse();
            let turned = beside(&ring(&back), points.len() - 2).unwrap();
            assert!(turned.distance(expected) < 1e-12, "{back:?}: {turned}");
        }
        // Something in the way: the step is halved until the way is free.
        let crowded = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [3.6, 0.3], [0.0, 4.0]];
        let moved = beside(&ring(&crowded), 1).unwrap();
        assert!(moved.distance(DVec2::new(4.0, 0.0)) < 0.5, "{moved}");
        assert!(contains(&ring(&crowded).flattened(), &[moved]));
    }

    #[test]
    fn two_arcs_that_touch_a_ring_are_no_spike() {
        use crate::curve::{EllipseArc, PieceCurve};
        let turn = std::f64::consts::PI;
        let arc = |start: f64| {
            let axes = [DVec2::X, DVec2::Y];
            let arc = EllipseArc { center: DVec2::new(-1.0, 0.0), axes, start, sweep: turn };
            Piece { curve: PieceCurve::Arc(arc), ..Piece::line(arc.point(start)) }
        };
        // A triangle from (0, 0), and a circle of two arcs that begins there, too.
        let mut pieces = vec![Piece::line(DVec2::ZERO)];
        pieces.extend([[4.0, 0.0], [4.0, 3.0]].map(|point| Piece::line(point.into())));
        pieces.extend([arc(0.0), arc(turn)]);
        pieces[3].start = DVec2::ZERO;
        let feature = Feature { rings: vec![DrawnRing { pieces }], ..Feature::default() };
        let mut outlines = Outlines { features: vec![feature], ..Outlines::default() };
        outlines.end_shape();
        let outlines = outlines.repaired(None).unwrap();
        let counts: Vec<usize> =
            outlines.features.iter().map(|feature| feature.rings[0].pieces.len()).collect();
        assert_eq!(counts, [3, 2], "{outlines:?}");
    }
}
