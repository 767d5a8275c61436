//! A vertex, edge or side of a boundary, by its ring and its index in the ring.

/// A side, corner, vertex or edge by its ring and its index in the ring, both from 0; messages count
/// it from 1: "side 3", or "side 3 of hole 1".
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct InRing {
    /// The ring; 0 is the outer one, r is hole r.
    pub ring: usize,
    /// The index in the ring.
    pub index: usize,
}

impl InRing {
    /// In words, counted from 1.
    pub fn named(self, kind: &str) -> String {
        format!("{kind} {}", self.named_last())
    }

    /// A side in words.
    pub fn side(self) -> String {
        self.named("side")
    }

    /// A corner in words.
    pub fn corner(self) -> String {
        self.named("corner")
    }

    /// The index without the noun, and the hole, for the last item of a list.
    pub fn named_last(self) -> String {
        let Self { ring, index } = self;
        let hole = if ring > 0 { format!(" of hole {ring}") } else { String::new() };
        format!("{}{hole}", index + 1)
    }
}

/// A vertex or an edge of a boundary, from 0; messages count from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum BoundaryPlace {
    /// On a ring.
    Ring(InRing),
    /// On a line: a vertex, or the edge that begins there.
    Line {
        /// The line.
        line: usize,
        /// The index on the line.
        index: usize,
    },
    /// An inner point that no line has.
    Point(usize),
}

impl BoundaryPlace {
    /// In words, counted from 1: "edge 2 of hole 1", "point 3 of line 2" or "inner point 1".
    pub fn named(self, kind: &str) -> String {
        match self {
            Self::Ring(at) => at.named(kind),
            Self::Line { line, index } => format!("{kind} {} of line {}", index + 1, line + 1),
            Self::Point(index) => format!("inner point {}", index + 1),
        }
    }
}

/// A ring in words: "the outline" or "hole 2".
pub fn ring_name(ring: usize) -> String {
    if ring == 0 { "the outline".to_owned() } else { format!("hole {ring}") }
}
