//! The contents of a file of outlines: polygons with holes, whose boundary may be curved.

use std::collections::{BTreeMap, HashSet};
use std::str::FromStr;
use std::sync::Arc as Shared;

use glam::DVec2;
use mindeg_domain::{InnerPoint, Projection};
use mindeg_mesh::LineKind;
use mindeg_mesh::planar::{doubled_area, orientation};

use super::curve::{PieceCurve, Segment};
use super::periodic::PeriodicCurve;
use super::text::quoted;

/// The contents of a file of outlines.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Outlines {
    /// The polygons, in the order of the file.
    pub features: Vec<Feature>,
    /// Lines and points inside the polygons.
    pub inside: DrawnInside,
    /// Curves that are others, moved.
    pub periodic: Vec<PeriodicCurve>,
    /// The kinds of sides that lines along the polygons give.
    pub kinds: SideKinds,
    /// The reader's omissions and changes, as sentences for the user.
    pub notes: Vec<String>,
    /// The shapes that the file draws, in the order of the polygons.
    pub(super) shapes: Vec<Shape>,
    /// Whether coordinates are longitudes and latitudes.
    pub(super) is_geographic: bool,
    /// The projection in whose plane edges between degrees are straight, if the file says so; without it they are in degrees.
    pub(super) straight_in: Option<Projection>,
    /// The projection that made the coordinates, as the file says, or [`projected`](Self::projected).
    pub projection: Option<Projection>,
}

/// The kinds of sides, by the names that the sides have.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SideKinds(pub(super) BTreeMap<String, LineKind>);

/// A line or curve between two points, with the regions beside it. One with a region on neither side is a line
/// inside a region.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Border {
    pub(super) segment: Segment,
    /// The name that the file gives.
    pub(super) side: Option<Shared<str>>,
    /// Whether the file begins a side at its start, whatever the angle.
    pub(super) begins_side: bool,
    /// The regions on the left and on the right.
    pub(super) beside: [Option<u32>; 2],
}

impl Border {
    /// The edges of a line inside through points, without those of no length.
    pub(super) fn through(
        points: &[DVec2],
        side: Option<Shared<str>>,
        begins_side: bool,
    ) -> impl Iterator<Item = Self> + '_ {
        let edges = points.windows(2).filter(|ends| ends[0] != ends[1]);
        edges.enumerate().map(move |(index, ends)| Self {
            segment: Segment { start: ends[0], end: ends[1], curve: PieceCurve::Line },
            side: side.clone(),
            begins_side: begins_side && index == 0,
            beside: [None; 2],
        })
    }
}

/// Lines and points that lie in polygons.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DrawnInside {
    pub(super) lines: Vec<Border>,
    /// Points that every mesh has.
    pub points: Vec<InnerPoint>,
}

impl DrawnInside {
    /// Whether there is nothing.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.lines.is_empty() && self.points.is_empty()
    }

    /// Adds a line through points; one of a single place is none.
    pub(super) fn add_line(&mut self, points: &[DVec2], name: Option<&str>) {
        self.lines.extend(Border::through(points, name.map(Shared::from), true));
    }

    pub(super) fn add_point(&mut self, at: DVec2, name: Option<&str>) {
        self.points.push(InnerPoint { at, name: name.map(str::to_owned), size: None });
    }

    /// Drops points where there is one already.
    pub(super) fn drop_repeated_points(&mut self) {
        let mut places = HashSet::new();
        self.points.retain(|point| places.insert(key(point.at)));
    }
}

/// Which points are inside.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FillRule {
    /// Points that the rings wind around an odd number of times.
    EvenOdd,
    /// Points whose total winding number is not zero.
    NonZero,
}

impl FillRule {
    /// Whether a point with this winding number is inside.
    pub(super) fn counts(self, winding: i64) -> bool {
        match self {
            Self::EvenOdd => winding % 2 != 0,
            Self::NonZero => winding != 0,
        }
    }
}

impl FromStr for FillRule {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text {
            "evenodd" => Ok(Self::EvenOdd),
            "nonzero" => Ok(Self::NonZero),
            other => Err(format!("found {}, expected evenodd or nonzero", quoted(other))),
        }
    }
}

/// Rings that one fill rule turned into polygons.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Shape {
    /// The index after that of its last polygon.
    pub(super) end: usize,
    pub(super) rule: FillRule,
    /// Whether the file gives polygons, each an outer ring and its holes, and no rings alone.
    pub(super) is_of_polygons: bool,
    /// The rings that bound no polygon, as long as rings do not cross.
    pub(super) without_effect: Vec<DrawnRing>,
}

/// One polygon: an outer ring and its holes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Feature {
    /// The name that the file gives. The parts of a multi-polygon have the same name.
    pub name: Option<String>,
    /// The outer ring first, then the holes. They may run either way round.
    pub rings: Vec<DrawnRing>,
    /// The greatest area of its triangles in a mesh with interior points.
    pub max_area: Option<f64>,
}

/// A closed curve: piece after piece, the last one back to the start of the first.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DrawnRing {
    /// The pieces; each ends where the next one starts.
    pub pieces: Vec<Piece>,
}

/// A piece of a ring: a straight line or a curve without a break.
#[derive(Clone, Debug, PartialEq)]
pub struct Piece {
    /// Where it starts.
    pub start: DVec2,
    /// How it runs on to the start of the next piece.
    pub curve: PieceCurve,
    /// The name of the side that it belongs to.
    pub side: Option<Shared<str>>,
    /// Whether the file begins a side here, whatever the angle.
    pub begins_side: bool,
}

impl Outlines {
    /// Makes one shape of the polygons that belong to no shape.
    pub(super) fn end_shape(&mut self) {
        let (end, without_effect) = (self.features.len(), Vec::new());
        let rule = FillRule::EvenOdd;
        self.shapes.push(Shape { end, rule, is_of_polygons: true, without_effect });
    }
}

impl Feature {
    /// If all pieces belong to sides of one name, makes it the name of the polygon and of no side.
    pub(super) fn name_by_side(&mut self) {
        let mut pieces = self.rings.iter().flat_map(|ring| &ring.pieces);
        let Some(first) = pieces.next().and_then(|piece| piece.side.clone()) else { return };
        if pieces.any(|piece| piece.side.as_deref() != Some(&*first)) {
            return;
        }
        let pieces = self.rings.iter_mut().flat_map(|ring| &mut ring.pieces);
        pieces.for_each(|piece| piece.side = None);
        self.name = Some(first.to_string());
    }
}

impl Piece {
    /// A straight piece without a name.
    #[must_use]
    pub fn line(start: DVec2) -> Self {
        Self { start, curve: PieceCurve::Line, side: None, begins_side: false }
    }
}

impl DrawnRing {
    /// A ring of straight pieces. A last point that repeats the first is left out.
    pub fn of_points(points: impl IntoIterator<Item = DVec2>) -> Self {
        let mut pieces: Vec<Piece> = points.into_iter().map(Piece::line).collect();
        if pieces.len() > 1 && pieces[0].start == pieces[pieces.len() - 1].start {
            pieces.pop();
        }
        Self { pieces }
    }

    /// The pieces with their ends, from the first on.
    pub fn segments(&self) -> impl ExactSizeIterator<Item = Segment> + '_ {
        (0..self.pieces.len()).map(|index| self.segment(index))
    }

    /// One piece with its ends.
    ///
    /// # Panics
    ///
    /// If the ring has no such piece.
    #[must_use]
    pub fn segment(&self, index: usize) -> Segment {
        let Piece { start, curve, .. } = self.pieces[index];
        Segment { start, end: self.pieces[(index + 1) % self.pieces.len()].start, curve }
    }

    /// Whether a piece is curved.
    #[must_use]
    pub fn is_curved(&self) -> bool {
        self.pieces.iter().any(|piece| piece.curve != PieceCurve::Line)
    }

    /// The ring as points: the start of each piece, and points along the curves.
    #[must_use]
    pub fn flattened(&self) -> Vec<DVec2> {
        let mut points = Vec::with_capacity(self.pieces.len());
        for segment in self.segments() {
            points.push(segment.start);
            let count = segment.intervals_by_turning();
            let inner = (1..count).map(|i| segment.point(f64::from(i) / f64::from(count)));
            points.extend(inner);
        }
        points
    }

    /// Whether all its points are on one line, exactly. A ring that crosses itself may cover much where its area, with
    /// the signs of its turns, is 0.
    pub(super) fn is_flat(&self) -> bool {
        let points = self.flattened();
        let Some(&origin) = points.first() else { return true };
        let Some(&other) = points.iter().find(|&&point| point != origin) else { return true };
        points.iter().all(|&point| orientation(origin, other, point) == 0.0)
    }

    /// Twice the area, positive if the ring runs counter-clockwise.
    #[must_use]
    pub fn doubled_area(&self) -> f64 {
        doubled_area(&self.flattened())
    }
}

/// A point as a key: equal points have equal keys.
pub(super) fn key(point: DVec2) -> (u64, u64) {
    // Adding 0 turns -0 into 0, whose bits differ.
    ((point.x + 0.0).to_bits(), (point.y + 0.0).to_bits())
}
