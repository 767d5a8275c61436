//! A list of clauses as a proof that no triangulation keeps some limits, once more: the chords and triangles from
//! the points alone, and each clause by setting whatever has no choice left.
//!
//! There is one kind of row, *at most so many of these literals hold*; *exactly one* is two rows. Of two chords that
//! cross one holds at most; which cross is found when a chord holds for the first time. Clauses are many and long, so two
//! literals of each are watched that are not false, or were false last.

mod crossing;

use super::CheckedOutline;
use crate::cover::{Element, Literal, Refutation};
use crate::measure::min_angle_tangent;
use glam::DVec2;
use std::collections::BTreeMap;

/// About the most chords that are kept for others that they cross, in all: 64 MB.
const MOST_CROSSING: usize = 1 << 24;

/// A face as the checker takes it.
#[derive(Clone, Copy, Debug)]
pub struct CheckedFace<'a> {
    /// The outline, with the outer ring first.
    pub outline: CheckedOutline<'a>,
    /// For each vertex of the face that of the whole.
    pub vertices: &'a [u32],
    /// No triangle has a smaller [`min_angle_tangent`].
    pub least_tangent: f64,
}

/// Whether clauses prove that no triangulation of all faces gives no vertex of the whole more chords than
/// `most_chords` says. O(n³) for the chords and triangles of a face of n vertices, and then what the clauses take.
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
    let mut table = Table::of(faces);
    let mut chords_at = vec![Vec::new(); most_chords.len()];
    for (index, face) in (0..).zip(faces) {
        table.add_face(index, face, &mut chords_at);
    }
    for (chords, &most) in chords_at.into_iter().zip(most_chords) {
        table.add_row(chords, most);
    }
    table.set_all_that_has_no_choice();
    refutation.clauses.iter().all(|clause| table.holds(clause)) && table.is_broken
}

/// A literal: twice its variable, and one more if it is negated.
type Code = usize;

/// Rows of literals of which at most so many hold, and what follows from them.
struct Table<'a> {
    faces: &'a [CheckedFace<'a>],
    variables: BTreeMap<(u32, Element), Code>,
    /// The chords, with their faces and codes.
    chords: Vec<(u32, [u32; 2], Code)>,
    /// For each literal the index of its chord, if it is that a chord holds, and those that cross it, once they are known.
    chord_of: Vec<Option<usize>>,
    crossing: Vec<Option<Vec<u32>>>,
    /// How many more of those may be kept.
    space: usize,
    rows: Vec<Row>,
    clauses: Vec<Vec<Code>>,
    /// For each literal the clauses of which it is the first or second one.
    watched_by: Vec<Vec<u32>>,
    /// For each literal the rows that have it.
    rows_of: Vec<Vec<u32>>,
    /// For each literal whether it holds.
    holds: Vec<bool>,
    /// The literals that hold, in order, and how many of them have been counted.
    held: Vec<Code>,
    counted: usize,
    /// The rows contradict each other, whatever is assumed.
    is_broken: bool,
}

struct Row {
    literals: Vec<u32>,
    most: u32,
    count: u32,
}

impl<'a> Table<'a> {
    fn of(faces: &'a [CheckedFace<'a>]) -> Self {
        Self {
            faces,
            variables: BTreeMap::new(),
            chords: Vec::new(),
            chord_of: Vec::new(),
            crossing: Vec::new(),
            space: MOST_CROSSING,
            rows: Vec::new(),
            clauses: Vec::new(),
            watched_by: Vec::new(),
            rows_of: Vec::new(),
            holds: Vec::new(),
            held: Vec::new(),
            counted: 0,
            is_broken: false,
        }
    }

    /// The variables and rows of a face; adds its chords to those at the vertices of the whole.
    fn add_face(&mut self, index: u32, face: &CheckedFace<'_>, chords_at: &mut [Vec<Code>]) {
        let outline = &face.outline;
        let n = outline.points.len() as u32;
        let is_boundary = |a: u32, b: u32| outline.next(a) == b || outline.next(b) == a;
        // For each vertex the larger ones that it is joined to.
        let mut joined = vec![Vec::new(); n as usize];
        // For each directed edge the triangles on its left.
        let mut left_of = BTreeMap::<[u32; 2], Vec<Code>>::new();
        for low in 0..n {
            left_of.insert([low, outline.next(low)], Vec::new());
            for high in low + 1..n {
                if is_boundary(low, high) {
                    joined[low as usize].push(high);
                } else if outline.is_admissible([low, high]) {
                    joined[low as usize].push(high);
                    let code = self.add_variable(index, Element::Chord([low, high]));
                    self.chord_of[code] = Some(self.chords.len());
                    self.chords.push((index, [low, high], code));
                    self.crossing.push(None);
                    for end in [low, high] {
                        chords_at[face.vertices[end as usize] as usize].push(code);
                    }
                    left_of.insert([low, high], vec![code + 1]);
                    left_of.insert([high, low], vec![code + 1]);
                }
            }
        }
        for a in 0..n {
            for (at, &b) in joined[a as usize].iter().enumerate() {
                for &c in &joined[a as usize][at + 1..] {
                    if joined[b as usize].binary_search(&c).is_err() {
                        continue;
                    }
                    let turn = outline.turn(a, b, c);
                    let corners = if turn > 0.0 { [a, b, c] } else { [a, c, b] };
                    let [p, q, r] = corners;
                    let sides = [[p, q], [q, r], [r, p]];
                    let is_kept = turn != 0.0
                        && sides.iter().all(|side| left_of.contains_key(side))
                        && !outline.has_ring_in(corners)
                        && face.is_wide(corners);
                    if is_kept {
                        let code = self.add_variable(index, Element::Triangle(corners));
                        for side in sides {
                            left_of.entry(side).or_default().push(code);
                        }
                    }
                }
            }
        }
        for literals in left_of.into_values() {
            let negated = literals.iter().map(|code| code ^ 1).collect::<Vec<_>>();
            let most = literals.len() as u32;
            self.add_row(literals, 1);
            match most.checked_sub(1) {
                Some(most) => self.add_row(negated, most),
                // Nothing lies on a boundary edge.
                None => self.is_broken = true,
            }
        }
    }

    fn add_variable(&mut self, face: u32, element: Element) -> Code {
        let code = self.holds.len();
        self.variables.insert((face, element), code);
        self.holds.extend([false; 2]);
        self.chord_of.extend([None; 2]);
        self.rows_of.extend([Vec::new(), Vec::new()]);
        self.watched_by.extend([Vec::new(), Vec::new()]);
        code
    }

    fn add_row(&mut self, literals: Vec<Code>, most: u32) {
        let row = self.rows.len() as u32;
        literals.iter().for_each(|&code| self.rows_of[code].push(row));
        let counted = literals.iter().filter(|&&code| self.holds[code]).count() as u32;
        let literals = literals.into_iter().map(|code| code as u32).collect();
        self.rows.push(Row { literals, most, count: counted });
    }

    /// Sets what the rows leave no choice for.
    fn set_all_that_has_no_choice(&mut self) {
        for row in 0..self.rows.len() {
            self.is_broken |= !self.complete(row);
        }
        self.is_broken |= !self.follow();
    }

    /// Sets the rest of a row to false if it is full; whether it is not too full.
    fn complete(&mut self, row: usize) -> bool {
        let Row { literals, most, count } = &self.rows[row];
        if count == most {
            for &code in literals {
                let code = code as usize;
                if !self.holds[code] && !self.holds[code ^ 1] {
                    self.holds[code ^ 1] = true;
                    self.held.push(code ^ 1);
                }
            }
        }
        count <= most
    }

    /// Sets what follows from the clauses that watch a literal that has become false; whether none is broken.
    fn follow_clauses(&mut self, lost: Code) -> bool {
        let mut at = 0;
        while let Some(&index) = self.watched_by[lost].get(at) {
            let clause = &mut self.clauses[index as usize];
            if clause[0] == lost {
                clause.swap(0, 1);
            }
            let is_open = |code: &Code| !self.holds[*code ^ 1];
            if let Some(other) = clause[2..].iter().position(is_open)
                && !self.holds[clause[0]]
            {
                clause.swap(1, other + 2);
                self.watched_by[lost].swap_remove(at);
                let watched = self.clauses[index as usize][1];
                self.watched_by[watched].push(index);
                continue;
            }
            let first = clause[0];
            if !self.set(first) {
                return false;
            }
            at += 1;
        }
        true
    }

    /// Lets a literal hold; false if its negation does.
    fn set(&mut self, code: Code) -> bool {
        if !self.holds[code] && !self.holds[code ^ 1] {
            self.holds[code] = true;
            self.held.push(code);
        }
        self.holds[code]
    }

    /// Sets what follows from what holds; whether no row is broken.
    fn follow(&mut self) -> bool {
        while let Some(&code) = self.held.get(self.counted) {
            self.counted += 1;
            for at in 0..self.rows_of[code].len() {
                let row = self.rows_of[code][at] as usize;
                self.rows[row].count += 1;
            }
            for at in 0..self.rows_of[code].len() {
                let row = self.rows_of[code][at] as usize;
                if !self.complete(row) {
                    return false;
                }
            }
            if !self.exclude_crossing(code) || !self.follow_clauses(code ^ 1) {
                return false;
            }
        }
        true
    }

    /// Whether a clause follows; it is a row from then on.
    fn holds(&mut self, clause: &[Literal]) -> bool {
        if self.is_broken {
            return true;
        }
        let mut literals = Vec::new();
        for &Literal { face, element, is_used } in clause {
            match self.variables.get(&(face, element)) {
                Some(&code) => literals.push(code + usize::from(!is_used)),
                // A triangle or chord that is no candidate is absent from every triangulation.
                None if !is_used => return true,
                None => {}
            }
        }
        literals.sort_unstable();
        literals.dedup();
        let root = self.held.len();
        let mut is_contradiction = false;
        for &code in &literals {
            is_contradiction |= !self.set(code ^ 1);
        }
        is_contradiction = is_contradiction || !self.follow();
        self.back_to(root);
        if !is_contradiction {
            return false;
        }
        // A literal that is false at the root no longer matters.
        literals.retain(|code| !self.holds[code ^ 1]);
        match literals[..] {
            [] => self.is_broken = true,
            [code] => self.is_broken = !self.set(code) || !self.follow(),
            [first, second, ..] => {
                for code in [first, second] {
                    self.watched_by[code].push(self.clauses.len() as u32);
                }
                self.clauses.push(literals);
            }
        }
        true
    }

    /// Takes back what has been assumed.
    fn back_to(&mut self, root: usize) {
        for (at, code) in self.held.drain(root..).enumerate() {
            self.holds[code] = false;
            if root + at < self.counted {
                for &row in &self.rows_of[code] {
                    self.rows[row as usize].count -= 1;
                }
            }
        }
        self.counted = self.counted.min(root);
    }
}

impl CheckedFace<'_> {
    fn is_wide(&self, corners: [u32; 3]) -> bool {
        let points = corners.map(|corner| self.outline.points[corner as usize]);
        self.least_tangent <= 0.0 || min_angle_tangent(points) >= self.least_tangent
    }
}

impl CheckedOutline<'_> {
    /// Whether a hole lies in a triangle whose sides do not cross it.
    fn has_ring_in(&self, corners: [u32; 3]) -> bool {
        let [a, b, c] = corners;
        let [p, q, r] = corners.map(|corner| self.points[corner as usize]);
        let (low, high) = (p.min(q).min(r), p.max(q).max(r));
        let is_in = |vertex: u32| {
            let point: DVec2 = self.points[vertex as usize];
            point.cmpge(low).all()
                && point.cmple(high).all()
                && [[a, b], [b, c], [c, a]]
                    .iter()
                    .all(|&[from, to]| self.turn(from, to, vertex) > 0.0)
        };
        self.rings
            .iter()
            .skip(1)
            .any(|ring| ring.clone().find(|vertex| !corners.contains(vertex)).is_some_and(is_in))
    }
}
