//! The first interior points: an equilateral packing that grows from the boundary.
//!
//! Corners between edges of unequal length get the best fan of their limit first. Then
//! points are tried from the boundary inwards, each where it makes an equilateral
//! triangle with what is there, and kept if no point is too near for the size field.

use crate::breaklines::{Breaklines, Piece};
use crate::cells::HAIR;
use crate::edge_tree::EdgeTree;
use crate::goal::Goal;
use crate::near::Near;
use crate::options::{InteriorError, check_room};
use crate::size::SizeField;
use crate::stage::Stage;
use crate::star::{Sector, Stars, allotted};
use crate::triangle::SQRT_3;
use glam::DVec2;
use mindeg_mesh::planar::{PlanarBoundary, orientation};
use std::collections::VecDeque;
use std::f64::consts::PI;

/// The data that the packing works on.
pub(crate) struct Ground<'a> {
    pub(crate) outline: &'a PlanarBoundary,
    pub(crate) stars: &'a Stars,
    pub(crate) goals: &'a [Goal],
    pub(crate) field: &'a SizeField,
    /// Existing interior points with the edges between them, and these as pieces.
    pub(crate) lines: &'a Breaklines,
    pub(crate) pieces: &'a [Piece],
    pub(crate) tree_of_pieces: EdgeTree,
    /// About how many points there will be, of which the share tells that is done.
    pub(crate) about: f64,
    /// The least distance of two points, in sizes.
    pub(crate) spacing: f64,
    /// The minimum angle that fans aim at, in degrees.
    pub(crate) fan_angle: f64,
    /// A vertex that gets fans of so many triangles in all, whatever its angles.
    pub(crate) spokes: Option<(u32, u32)>,
    /// The rounding of the largest coordinate.
    pub(crate) rounding: f64,
    pub(crate) max_points: usize,
}

/// A place to try.
#[derive(Debug, Clone, Copy)]
struct Candidate {
    /// A point of the domain.
    from: DVec2,
    /// The vector to the position, if the size were everywhere as at `from`.
    step: DVec2,
    /// The direction of the packing here.
    direction: DVec2,
    /// No distance from other points of more than this is asked for: over an edge, its ends are there however fast
    /// sizes grow from it.
    most: f64,
}

/// The share of the work on a start that packing takes.
const PACKED: f64 = 0.3;

/// More triangles than this are of no use in any fan, nearly.
const MOST_SPOKES: u32 = 64;

/// Between lines, the ends of spokes keep this share of their length from those of other fans: two fans share the
/// triangle on the edge between them.
const APART: f64 = 0.6;

/// Nearer to a piece of other vertices than this share of its length, no spoke ends: on the piece it would divide it.
const ON_PIECE: f64 = 0.1;

/// The ends of an edge are farther from the point over it than this share of its length, for all rounding.
const TO_ENDS: f64 = 0.98;

/// Nearer to an edge than this share of size or edge length, no point is put.
const CLEARANCE: f64 = 0.45;

impl Ground<'_> {
    /// Interior points and their sizes, without the fixed ones.
    pub(crate) fn pack(
        &self,
        stage: &mut Stage<'_>,
    ) -> Result<(Vec<DVec2>, Vec<f64>), InteriorError> {
        let points = self.outline.points();
        let bounds = self.outline.bounds();
        let mut near = Near::new(bounds);
        let mut sizes = Vec::with_capacity(points.len());
        for vertex in 0..points.len() as u32 {
            near.insert(points[vertex as usize]);
            let before = self.outline.length(self.outline.previous(vertex));
            sizes.push(self.outline.length(vertex).min(before));
        }
        for point in &self.lines.points {
            near.insert(*point);
            sizes.push(self.field.at(*point));
        }
        let given = sizes.len();
        let mut queue = VecDeque::new();
        self.fans(&mut near, &mut sizes, &mut queue)?;
        self.start(&mut queue);
        while let Some(candidate) = queue.pop_front() {
            let Some((place, size)) = self.place(&near, &sizes, candidate) else { continue };
            check_room(place, size, self.rounding)?;
            // Beside a spike that is thinner than the rounding, inside and outside are not told apart.
            if place.clamp(bounds.min, bounds.max) != place {
                let (at, rounding) = (place.to_array(), self.rounding);
                return Err(InteriorError::NoRoom { at, size, rounding });
            }
            near.insert(place);
            sizes.push(size);
            if sizes.len() > self.max_points {
                return Err(InteriorError::TooManyPoints { max: self.max_points });
            }
            if sizes.len() % (1 << 14) == 0 {
                stage.reach(PACKED * (sizes.len() as f64 / self.about).min(1.0))?;
            }
            surround(place, size, candidate.direction, &mut queue);
        }
        Ok((near.points()[given..].to_vec(), sizes.split_off(given)))
    }

    /// The ends of the spokes between frozen edges of unequal length.
    fn fans(
        &self,
        near: &mut Near,
        sizes: &mut Vec<f64>,
        queue: &mut VecDeque<Candidate>,
    ) -> Result<(), InteriorError> {
        for vertex in 0..self.goals.len() as u32 {
            let sectors = self.stars.at(vertex);
            let given = self.spokes.filter(|spokes| spokes.0 == vertex);
            let counts = given.map(|spokes| {
                allotted(sectors, spokes.1).unwrap_or_else(|| vec![1; sectors.len()])
            });
            for (index, sector) in sectors.iter().enumerate() {
                let count = match &counts {
                    Some(counts) => counts[index],
                    None => self.spokes_of(sector, sectors.len() == 1),
                };
                self.fan(sector, count, near, sizes, queue)?;
            }
        }
        Ok(())
    }

    /// The number of triangles that a sector's fan has; 1 where no fan is needed. `is_alone`: no lines meet at its
    /// vertex.
    fn spokes_of(&self, sector: &Sector, is_alone: bool) -> u32 {
        let ratio = sector.lengths[1] / sector.lengths[0];
        let is_corner = (sector.angle / PI - 1.0).abs() > 1.0 / 18.0;
        if is_alone && !is_corner || ratio.max(1.0 / ratio) <= 1.3 {
            return 1;
        }
        let goal = &self.goals[sector.vertex as usize];
        let reachable = goal.limit.min(self.fan_angle);
        let most = goal.fan.unwrap_or(MOST_SPOKES);
        let is_enough = |k: &u32| sector.limit(Some(*k)) >= reachable - 1e-9;
        (1..=most).find(is_enough).unwrap_or(most)
    }

    fn fan(
        &self,
        sector: &Sector,
        count: u32,
        near: &mut Near,
        sizes: &mut Vec<f64>,
        queue: &mut VecDeque<Candidate>,
    ) -> Result<(), InteriorError> {
        let own = sizes.len();
        let is_beside_lines = self.stars.at(sector.vertex).len() > 1;
        let apart = if is_beside_lines { APART } else { 0.3 };
        let place_of = |vertex| self.lines.at(self.outline, vertex);
        let at = place_of(sector.vertex);
        let [first, last] = sector.lengths;
        let along = (place_of(sector.ends[0]) - at) / first;
        for spoke in 1..count {
            let share = f64::from(spoke) / f64::from(count);
            let (sine, cosine) = (libm::sin(sector.angle * share), libm::cos(sector.angle * share));
            let length = first * libm::exp(libm::log(last / first) * share);
            let direction = along.rotate(DVec2::new(cosine, sine));
            let place = at + direction * length;
            let is_free = match near.nearest(place, apart * length) {
                Some((other, _)) => is_beside_lines && other as usize >= own,
                None => true,
            };
            if is_free
                && self.is_inside(place, f64::INFINITY)
                && !self.is_on_piece(place, at, ON_PIECE * length)
            {
                let size = self.field.at(place);
                check_room(place, size, self.rounding)?;
                near.insert(place);
                sizes.push(size);
                surround(place, size, direction, queue);
            }
        }
        Ok(())
    }

    /// The apexes over the boundary edges, then over both sides of fixed pieces; short edges first.
    fn start(&self, queue: &mut VecDeque<Candidate>) {
        let boundary = self.outline.edges().map(|ends| ends.map(|v| self.outline.point(v)));
        let pieces = self.pieces.iter().flat_map(|p| [[p.from, p.to], [p.to, p.from]]);
        let mut edges: Vec<[DVec2; 2]> = boundary.chain(pieces).collect();
        edges.sort_by(|a, b| a[0].distance_squared(a[1]).total_cmp(&b[0].distance_squared(b[1])));
        let fans = std::mem::take(queue);
        // Where sizes grow so fast from each edge that its own ends would be too near.
        let is_fast = self.spacing * (1.0 + self.field.growth_from_edges() * SQRT_3 / 2.0) > 1.0;
        queue.extend(edges.into_iter().map(|[a, b]| Candidate {
            from: a.midpoint(b) + (b - a).perp() * (SQRT_3 / 2.0),
            step: DVec2::ZERO,
            direction: (b - a).normalize_or_zero(),
            most: if is_fast { TO_ENDS * a.distance(b) } else { f64::INFINITY },
        }));
        for point in &self.lines.points {
            surround(*point, self.field.at(*point), DVec2::X, queue);
        }
        queue.extend(fans);
    }

    /// The place of a candidate and its size, if a point may be there.
    fn place(&self, near: &Near, sizes: &[f64], candidate: Candidate) -> Option<(DVec2, f64)> {
        let guess = candidate.from + candidate.step;
        let reach = candidate.step.length();
        let mut place = guess;
        if reach > 0.0 {
            // A cheap check first: most positions round a point are taken.
            let apart = 0.5 * self.spacing;
            if let Some((other, distance)) = near.nearest(guess, HAIR * apart * reach)
                && distance < apart * sizes[other as usize].min(reach)
            {
                return None;
            }
            let between = candidate.from + candidate.step / 2.0;
            place = candidate.from + candidate.step * (self.field.at(between) / reach);
        }
        let travelled = place.distance(candidate.from);
        let within = if reach > 0.0 { travelled * HAIR } else { f64::INFINITY };
        let nearest = self.field.boundary().nearest(place, within);
        if !self.is_inside_by(place, nearest, within) {
            return None;
        }
        let size = self.field.at(place);
        // Points are most often in the way, and soonest found.
        if near.has(place, (self.spacing * size).min(candidate.most)) {
            return None;
        }
        let clear = CLEARANCE * size;
        let boundary = match nearest {
            None if within < clear => self.field.boundary().nearest(place, clear),
            nearest => nearest.filter(|(_, distance)| *distance < clear),
        };
        if let Some((edge, distance)) = boundary {
            let ends = [edge, self.outline.next(edge)].map(|v| self.outline.point(v));
            if is_crowded(place, ends, distance, size) {
                return None;
            }
        }
        if let Some((piece, distance)) = self.tree_of_pieces.nearest(place, clear) {
            let piece = self.pieces[piece as usize];
            if is_crowded(place, [piece.from, piece.to], distance, size) {
                return None;
            }
        }
        Some((place, size))
    }

    /// True if a piece that does not end at `vertex` is the nearest to `x`, and nearer than that.
    fn is_on_piece(&self, x: DVec2, vertex: DVec2, most: f64) -> bool {
        let nearest = self.tree_of_pieces.nearest(x, most);
        let nearest = nearest.map(|(piece, _)| &self.pieces[piece as usize]);
        nearest.is_some_and(|piece| ![piece.from, piece.to].contains(&vertex))
    }

    /// True if `x` lies in the domain. `within`: a distance at which a point inside is known.
    fn is_inside(&self, x: DVec2, within: f64) -> bool {
        self.is_inside_by(x, self.field.boundary().nearest(x, within), within)
    }

    /// The same, given the nearest edge within that distance.
    fn is_inside_by(&self, x: DVec2, nearest: Option<(u32, f64)>, within: f64) -> bool {
        match nearest {
            None => within.is_finite(),
            Some((edge, _)) => is_inside_of(self.outline, edge, x),
        }
    }
}

/// True if `x` lies in the domain, given the boundary edge nearest to it.
pub(crate) fn is_inside_of(outline: &PlanarBoundary, edge: u32, x: DVec2) -> bool {
    let (a, b) = (edge, outline.next(edge));
    let left = |v: u32| orientation(outline.point(v), outline.point(outline.next(v)), x) > 0.0;
    let (from, to) = (outline.point(a), outline.point(b));
    let along = (x - from).dot(to - from);
    let corner = if along <= 0.0 {
        a
    } else if along >= (to - from).length_squared() {
        b
    } else {
        return left(a);
    };
    // Where rings touch, the vertex has several sectors.
    [corner].into_iter().chain(outline.twins(corner)).any(|corner| {
        let before = outline.previous(corner);
        if outline.angle(corner) <= PI {
            left(before) && left(corner)
        } else {
            left(before) || left(corner)
        }
    })
}

/// True if a point is too near to an edge, or sees it under more than 120 degrees.
fn is_crowded(x: DVec2, [a, b]: [DVec2; 2], distance: f64, size: f64) -> bool {
    let length = a.distance(b);
    let (u, v) = (a - x, b - x);
    distance < CLEARANCE * size.min(length) || 2.0 * u.dot(v) < -u.length() * v.length()
}

/// Six positions round a point.
fn surround(from: DVec2, size: f64, direction: DVec2, queue: &mut VecDeque<Candidate>) {
    let sixth = DVec2::new(0.5, SQRT_3 / 2.0);
    let mut turned = direction;
    for _ in 0..6 {
        queue.push_back(Candidate { from, step: turned * size, direction, most: f64::INFINITY });
        turned = turned.rotate(sixth);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples;

    #[test]
    fn the_nearest_edge_tells_what_is_inside() {
        let star: Vec<DVec2> = (0..14)
            .map(|i| DVec2::from_angle(f64::from(i) * PI / 7.0) * [4.0, 0.7][i as usize % 2])
            .collect();
        // Holes that touch a straight side and each other.
        let square = samples::ring(&[[0.0, 0.0], [6.0, 0.0], [6.0, 6.0], [0.0, 6.0]], &[2; 4]);
        let inner = [[2.8, 2.0], [3.0, 2.0], [2.2, 4.0], [2.5, 4.0]].map(DVec2::from);
        let lines = [vec![1, 8, 9, 1], vec![9, 10, 11, 9]];
        let (map, _) = PlanarBoundary::map(&[square], &inner, &lines).unwrap();
        let faces = map.faces(&[[2.9, 1.9], [2.6, 3.5]].map(DVec2::from)).unwrap();
        let border = map.border(&faces, |face| face < 2);
        let outlines =
            [samples::plate_with_hole(), PlanarBoundary::new(&[star]).unwrap(), border.boundary];
        let steps = [(-1.0, 0.05), (-5.0, 0.04), (-1.0, 0.03)];
        for (outline, (low, step)) in outlines.iter().zip(steps) {
            let ends = |[a, b]: [u32; 2]| [a, b].map(|v| outline.point(v));
            // How often a horizontal line to the right crosses the boundary.
            let is_inside = |x: DVec2| {
                let crosses = |edge: &[u32; 2]| {
                    let [a, b] = ends(*edge);
                    let share = (x.y - a.y) / (b.y - a.y);
                    (0.0..1.0).contains(&share) && a.x + share * (b.x - a.x) > x.x
                };
                outline.edges().filter(crosses).count() % 2 == 1
            };
            let to_edge = |x: DVec2, edge: [u32; 2]| {
                let [a, b] = ends(edge);
                let share = ((x - a).dot(b - a) / a.distance_squared(b)).clamp(0.0, 1.0);
                x.distance(a.lerp(b, share))
            };
            for (i, j) in (0..250).flat_map(|i| (0..250).map(move |j| (i, j))) {
                // On no line on which a side lies.
                let x = low + step * DVec2::new(f64::from(i) + 0.37, f64::from(j) + 0.41);
                let edges = outline.edges();
                let nearest = edges.min_by(|a, b| to_edge(x, *a).total_cmp(&to_edge(x, *b)));
                assert_eq!(is_inside_of(outline, nearest.unwrap()[0], x), is_inside(x), "{x}");
            }
        }
    }
}
