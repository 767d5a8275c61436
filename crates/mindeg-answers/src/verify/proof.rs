//! A proof of the least maximum degree in words.

use mindeg::verify::Proof;
use mindeg_core::Certificate;

/// Why no mesh has less.
pub(super) fn in_words(proof: &Proof, degree: u32) -> String {
    let less = degree - 1;
    match proof {
        Proof::Certificate(Certificate::LongSide { side, .. }) => {
            format!("side {} is so long that {less} is too little (theorem 4)", side + 1)
        }
        Proof::Certificate(Certificate::NoBalancedCut { least_imbalance }) => format!(
            "every two runs of sides differ by {least_imbalance} intervals or more, and 4 takes 1 at \
             most (theorem 5)"
        ),
        Proof::Certificate(_) | Proof::Counting => {
            format!("the edges are too many for {less} at every vertex (theorems 3 and 15)")
        }
        Proof::Edges { edges } => format!("a vertex has {edges} edges of sides and lines"),
        Proof::Side { intervals } => format!(
            "a region has a straight side of {intervals} intervals, whose triangles need apexes elsewhere on it"
        ),
        Proof::Weights => format!(
            "a weighted sum of the degrees is too large for {less}, whatever the triangles of each region"
        ),
        Proof::BlockedZigZags { chords } => format!(
            "{chords} chords that do not lie inside block every mesh of degree {less} (theorem 13)"
        ),
        Proof::Apexes { edges, apexes } => {
            format!("{edges} boundary edges have only {apexes} apexes (theorem 14)")
        }
        Proof::NoStrip => {
            format!("{less} takes a strip between both rings, and none lies inside (theorem 21)")
        }
        Proof::Refuted { clauses: 1 } => format!("{less} contradicts itself at once (theorem 23)"),
        Proof::Refuted { clauses } => {
            format!("{less} is refuted by {clauses} clauses (theorem 23)")
        }
        _ => format!("two searches over all meshes, by different code, find none with {less}"),
    }
}
