//! The changes, and the places that are left.

use glam::DVec2;

/// A point of the new boundary.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    /// Where it is.
    pub at: DVec2,
    /// The vertex of the old boundary that it is, bit for bit; none for a new point.
    pub of: Option<u32>,
    /// The edge of the old boundary on which it lies or at which it begins; at the end of an open line its last edge.
    pub edge: u32,
}

/// A conditioned boundary.
#[derive(Debug, Clone, PartialEq)]
pub struct Conditioned {
    /// The new rings; the first is the outer one, as before.
    pub rings: Vec<Vec<Point>>,
    /// The new lines, in their order. One that was closed does not have its first point again.
    pub lines: Vec<Vec<Point>>,
    /// All changes, in the order in which they were made.
    pub changes: Vec<BoundaryChange>,
    /// The places that stay below the demanded angle.
    pub left: Vec<Left>,
    /// The places that are narrower than the least width, and stay.
    pub narrow: Vec<Narrow>,
    /// The limit of the old boundary, in degrees.
    pub before: f64,
    /// The limit of the new boundary, in degrees.
    pub after: f64,
    /// The greatest distance of a dropped point from the new boundary, which bounds the distance of both boundaries from each
    /// other, but where something narrow was closed or cut off, or a hole dropped.
    pub moved: f64,
}

/// One change of a boundary.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BoundaryChange {
    /// The change.
    pub kind: ChangeKind,
    /// Where.
    pub at: DVec2,
    /// Why.
    pub why: Why,
    /// The edge of the old boundary there, as in [`Point::edge`]; none for what is narrower than the width.
    pub edge: Option<u32>,
    /// How far the boundary moved there: a dropped or moved point from the new boundary, a new point from the old one. None where
    /// something narrow was closed or cut off, or a hole dropped.
    pub moved: Option<f64>,
}

impl BoundaryChange {
    pub(crate) fn of_edge(kind: ChangeKind, at: DVec2, why: Why, edge: u32) -> Self {
        Self { kind, at, why, edge: Some(edge), moved: None }
    }
}

/// Why a boundary changes at a place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Why {
    /// The edges there were too short or too long for the size.
    Size,
    /// The limit at a vertex there was below the angle.
    Limit,
    /// Edges that face each other were long beside their distance.
    Strait,
    /// Its shores were nearer to each other than a quarter of the size.
    Near,
    /// An edge was long beside others near it.
    Growth,
    /// The triangles of an inlet or a strait one edge wide could not have the angle together.
    Narrow,
    /// It was narrower than the least width.
    Width,
    /// Its area was below the least one.
    Area,
}

/// The kinds of changes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ChangeKind {
    /// A point was dropped.
    Dropped,
    /// A point was put on an edge.
    Inserted,
    /// A point of narrow water was moved.
    Shifted,
    /// A sharp corner was cut off.
    Cut,
    /// A hole was dropped.
    HoleDropped,
    /// A narrow arm of the domain was closed.
    InletClosed,
    /// A narrow place between two wider ones was closed; holes may have joined other rings.
    StraitClosed,
    /// Water that a closed strait cut off was dropped.
    BasinDropped,
    /// A narrow tongue of what is outside was cut off.
    SpitCut,
}

/// A place narrower than the width that stays.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Narrow {
    /// Where.
    pub at: DVec2,
    /// The least distance of the points there that face each other; infinite for a single triangle.
    pub width: f64,
    /// Why.
    pub reason: NarrowReason,
}

/// The reasons why a narrow place stays.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NarrowReason {
    /// Something there is to stay: a point, a line, a side of its own, a corner where names or kinds change, or what lies beyond.
    Kept,
    /// Something outside between wider parts of it: opening it would join two parts of the domain.
    Between,
    /// A part that is nowhere wider, such as an island.
    Everywhere,
}

/// A place that stays below the demanded angle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Left {
    /// Where.
    pub at: DVec2,
    /// The limit there, in degrees; in a narrow place the angle of the best mesh that was found.
    pub limit: f64,
    /// Why.
    pub reason: Reason,
}

/// The reasons why a place stays below the demanded angle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reason {
    /// The boundary turns so sharply there, and may not be moved, or not so far.
    Sharp,
    /// Lines meet there so sharply, or so many. Their place stays.
    Meeting,
    /// Its points are to stay.
    Kept,
    /// The edges there would get too short to tell their points apart.
    Short,
    /// An inlet or a strait about one edge wide: a search found no mesh of it with the angle. That is no proof that there is none.
    Narrow,
}
