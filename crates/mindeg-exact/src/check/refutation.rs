//! A list of clauses as a proof that no triangulation keeps some limits, once more: the chords and triangles from
//! the points alone, and each clause by setting whatever has no choice left.
//!
//! There is one kind of row, *at most so many of these literals hold*; *exactly one* is two rows. Of two chords that
//! cross one holds at most; which cross is found when a chord holds for the first time.
//!
//! Neighbours in the list are alike. The literals of a clause are supposed to be false one after the other, first those
//! that the next clauses have, too: so much need not be taken back. As soon as a contradiction is met, the other
//! literals are not needed, nor are those that the ones before make false; what is left is a shorter clause, which is
//! kept in place of the given one. The two of its literals that became false last are watched.

mod candidates;
mod crossing;
mod propagation;
mod table;

use crate::cover::Refutation;
use table::Table;

pub use candidates::CheckedFace;

/// Whether clauses prove that no triangulation of all faces gives no vertex of the whole more chords than
/// `most_chords` says. O(n³) at worst for the chords and triangles of a face of n vertices, and then what the clauses
/// take.
///
/// # Example
///
/// ```
/// use glam::DVec2;
/// use mindeg_exact::{Element, Literal, Refutation};
/// use mindeg_exact::check::CheckedOutline;
/// use mindeg_exact::check::refutation::{CheckedFace, refutes};
///
/// let points = [(0, 0), (1, 0), (1, 1), (0, 1)].map(|(x, y)| DVec2::new(f64::from(x), f64::from(y)));
/// let (side_of, vertices) = ([0, 1, 2, 3], [0, 1, 2, 3]);
/// let outline = CheckedOutline { points: &points, rings: &[0..4], side_of: &side_of, keeps_clear: true };
/// let square = CheckedFace { outline, vertices: &vertices, least_tangent: 0.0 };
/// // One of the two diagonals is there, and nothing else follows from that.
/// let nothing = Refutation { clauses: vec![vec![]] };
/// assert!(refutes(&[square], &[1, 0, 0, 1], &nothing));
/// assert!(!refutes(&[square], &[1, 0, 1, 0], &nothing));
/// ```
#[must_use]
pub fn refutes(faces: &[CheckedFace<'_>], most_chords: &[u32], refutation: &Refutation) -> bool {
    if refutation.clauses.last().is_none_or(|last| !last.is_empty()) {
        return false;
    }
    if let Some(face) = faces.iter().find(|face| face.vertices.len() != face.outline.points.len()) {
        debug_assert!(face.vertices.is_empty(), "a vertex of the whole for each of the face");
        return false;
    }
    let chord_ends = |face: &CheckedFace<'_>| {
        let (vertices, rings) = (face.vertices.len() as u64, face.outline.rings.len() as u64);
        2 * (vertices + 3 * rings).saturating_sub(6)
    };
    let needed: u64 = faces.iter().map(chord_ends).sum();
    if most_chords.iter().map(|&most| u64::from(most)).sum::<u64>() < needed {
        return true;
    }
    let mut table = Table::new(faces, most_chords);
    // A clause with a literal that holds in every triangulation needs no proof.
    let clauses: Vec<Vec<u32>> =
        refutation.clauses.iter().filter_map(|clause| table.codes(clause)).collect();
    table.set_all_that_has_no_choice();
    by_use(clauses, table.code_count()).iter().all(|clause| table.follows(clause))
        && table.is_broken
}

/// The clauses, each with those literals first that most clauses right after it have, too.
fn by_use(mut clauses: Vec<Vec<u32>>, code_count: usize) -> Vec<Vec<u32>> {
    // For each literal with how many clauses in a row it goes on, and the first of them.
    let mut runs = vec![[0, usize::MAX]; code_count];
    for (at, clause) in clauses.iter_mut().enumerate().rev() {
        clause.sort_unstable();
        clause.dedup();
        for &code in &*clause {
            let [len, first] = runs[code as usize];
            runs[code as usize] = [if first == at + 1 { len + 1 } else { 1 }, at];
        }
        clause.sort_by_key(|&code| std::cmp::Reverse(runs[code as usize][0]));
    }
    clauses
}
