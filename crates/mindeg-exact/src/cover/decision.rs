//! The answers of searches: a mesh, or a proof that there is none.

/// The answer of a search.
#[derive(Clone, Debug, PartialEq)]
pub enum Decision {
    /// These triangles of each face keep the limits.
    Mesh(Vec<Vec<[u32; 3]>>),
    /// No triangulation keeps the limits.
    Refuted(Refutation),
    /// The steps did not suffice.
    Unknown,
}

/// A proof that no triangulation keeps some limits: clauses of which each follows from the rows and the clauses
/// before it by unit propagation. The last one is empty.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Refutation {
    /// The clauses. Of the literals of each, one or more hold in every triangulation that keeps the limits.
    pub clauses: Vec<Vec<Literal>>,
}

impl Refutation {
    /// The empty clause alone, which the rows refute at once.
    #[must_use]
    pub(crate) fn at_once() -> Self {
        Self { clauses: vec![Vec::new()] }
    }
}

/// One statement on a triangulation: it has a chord or triangle, or lacks it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Literal {
    /// The face; 0 in a domain.
    pub face: u32,
    /// The chord or triangle.
    pub element: Element,
    /// Whether the triangulation has it.
    pub is_used: bool,
}

/// A chord or triangle, by its vertices on the face.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Element {
    /// A chord, the smaller end first.
    Chord([u32; 2]),
    /// A triangle, counter-clockwise from its smallest vertex.
    Triangle([u32; 3]),
}

/// The triangulation with the largest minimum angle that searches find within a degree limit.
#[derive(Clone, Debug, PartialEq)]
pub struct SearchedAngle {
    /// The triangles, counter-clockwise.
    pub triangles: Vec<[u32; 3]>,
    /// Their minimum angle, in degrees.
    pub min_angle: f64,
    /// Whether no triangulation within the limit has a larger one: the searches have refuted the next
    /// candidate's angle, or none is larger.
    pub is_largest: bool,
}
