//! The proofs that checkers confirm.

/// Why no mesh has a smaller maximum degree; docs/theory.md has the theorems.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Proof {
    /// The certificate of a convex domain, from its interval counts.
    Certificate(mindeg_core::Certificate),
    /// The sum of the degrees.
    Counting,
    /// The sides and lines at one vertex of a map.
    Edges {
        /// Their edges.
        edges: u32,
    },
    /// A straight side of a face of a map has too few apexes.
    Side {
        /// Its intervals.
        intervals: u32,
    },
    /// The degrees of a map, weighted.
    Weights,
    /// Chords that do not lie inside block every zig-zag.
    BlockedZigZags {
        /// Their number.
        chords: usize,
    },
    /// Too few vertices can be apexes of some boundary edges.
    Apexes {
        /// The number of edges.
        edges: usize,
        /// The number of apexes.
        apexes: usize,
    },
    /// A search over all triangulations, done twice by different code.
    Search,
    /// Degree 4 takes a strip between two rings, and none is a triangulation.
    NoStrip,
    /// Clauses, each of which follows from those before.
    Refuted {
        /// Their number.
        clauses: usize,
    },
}

impl Proof {
    /// A name of the kind, which stays the same over versions.
    pub fn kind(&self) -> &'static str {
        use mindeg_core::Certificate;
        match self {
            Self::Certificate(Certificate::BalancedCut { .. }) => "balanced_cut",
            Self::Certificate(Certificate::MedialTriangle) => "medial_triangle",
            Self::Certificate(Certificate::LongSide { .. }) => "long_side",
            Self::Certificate(Certificate::NoBalancedCut { .. }) => "no_balanced_cut",
            Self::Counting => "counting",
            Self::Edges { .. } => "edges",
            Self::Side { .. } => "side",
            Self::Weights => "weights",
            Self::BlockedZigZags { .. } => "blocked_zig_zags",
            Self::Apexes { .. } => "apexes",
            Self::Search => "search",
            Self::NoStrip => "no_strip",
            Self::Refuted { .. } => "refuted",
        }
    }
}
