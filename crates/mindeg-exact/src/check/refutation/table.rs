//! The variables of chords and triangles, and the rows that they keep.

use super::candidates::{Candidates, CheckedFace};
use crate::cover::{Element, Literal};
use std::ops::Range;

/// About the most chords that are kept for others that they cross, in all: 64 MB.
const MOST_CROSSING: usize = 1 << 24;

/// A literal: twice its variable, and one more if it is negated.
pub(super) type Code = u32;

/// Rows of literals of which at most so many hold, and what follows from them.
pub(super) struct Table<'a> {
    pub(super) faces: &'a [CheckedFace<'a>],
    pub(super) candidates: Vec<Candidates>,
    /// The variables of the chords of each face, before those of triangles.
    pub(super) chords: Vec<Range<Code>>,
    triangles: Vec<Range<Code>>,
    /// For each chord those that cross it, once they are known, and how many more may be kept.
    pub(super) crossing: Vec<Option<Vec<Code>>>,
    pub(super) space: usize,
    pub(super) rows: Vec<Row>,
    /// The literals of all rows, one after the other.
    pub(super) literals: Vec<Code>,
    /// For each literal the rows that have it: those from its start to the next one's.
    pub(super) row_starts: Vec<u32>,
    pub(super) rows_of: Vec<u32>,
    /// The literals of clauses that follow, one after the other.
    pub(super) words: Vec<Code>,
    /// For each literal the clauses of which it is the first or second one.
    pub(super) watched_by: Vec<Vec<Watch>>,
    /// The clause that followed last, until it is known with which suppositions it is kept.
    pub(super) last: Vec<Code>,
    /// For each literal whether it holds.
    pub(super) holds: Vec<bool>,
    /// For each variable the number of suppositions from which its value follows.
    pub(super) levels: Vec<u32>,
    /// The literals that hold, in order, and how many of them have been counted.
    pub(super) held: Vec<Code>,
    pub(super) counted: usize,
    /// The literals that are supposed to be false, and how many held before.
    pub(super) supposed: Vec<(Code, usize)>,
    /// The rows contradict each other, whatever is supposed.
    pub(super) is_broken: bool,
}

/// A clause: where its literals begin in the list of all, how many they are, and one of them.
#[derive(Clone, Copy)]
pub(super) struct Watch {
    pub(super) start: u32,
    pub(super) len: u32,
    pub(super) other: Code,
}

/// A row: where its literals begin in the list of all, and how many they are.
pub(super) struct Row {
    pub(super) start: u32,
    pub(super) len: u32,
    /// How many may hold, and how many more may.
    pub(super) most: u32,
    pub(super) room: i32,
    /// All literals that do not hold, by exclusive or: if one is left, that one.
    pub(super) rest: Code,
}

impl<'a> Table<'a> {
    pub(super) fn new(faces: &'a [CheckedFace<'a>], most_chords: &[u32]) -> Self {
        let candidates: Vec<Candidates> = faces.iter().map(Candidates::of).collect();
        let mut end = 0;
        let mut next = |count: usize| {
            let start = end;
            end += count as u32;
            start..end
        };
        let chords: Vec<_> = candidates.iter().map(|face| next(face.chords.len())).collect();
        let triangles: Vec<_> = candidates.iter().map(|face| next(face.triangles.len())).collect();
        let variables = end as usize;
        let mut table = Self {
            faces,
            crossing: vec![None; chords.last().map_or(0, |range| range.end as usize)],
            candidates,
            chords,
            triangles,
            space: MOST_CROSSING,
            rows: Vec::new(),
            literals: Vec::new(),
            row_starts: Vec::new(),
            rows_of: Vec::new(),
            words: Vec::new(),
            last: Vec::new(),
            watched_by: vec![Vec::new(); 2 * variables],
            holds: vec![false; 2 * variables],
            levels: vec![0; variables],
            held: Vec::new(),
            counted: 0,
            supposed: Vec::new(),
            is_broken: false,
        };
        let mut chords_at = vec![Vec::new(); most_chords.len()];
        for (face, CheckedFace { vertices, .. }) in faces.iter().enumerate() {
            table.add_sides(face);
            for (ends, variable) in
                table.candidates[face].chords.iter().zip(table.chords[face].clone())
            {
                for &end in ends {
                    chords_at[vertices[end as usize] as usize].push(2 * variable);
                }
            }
        }
        for (chords, &most) in chords_at.iter().zip(most_chords) {
            table.add_row(chords, most);
        }
        table.list_rows();
        table
    }

    /// The rows of the sides of a face.
    fn add_sides(&mut self, face: usize) {
        let Candidates { chords, triangles, sides } = &self.candidates[face];
        let find = |side: &[u32; 2]| sides.binary_search(side).ok();
        let mut of_side = vec![Vec::new(); sides.len()];
        for (chord, variable) in chords.iter().zip(self.chords[face].clone()) {
            let [low, high] = *chord;
            for at in [[low, high], [high, low]].iter().filter_map(find) {
                of_side[at].push(2 * variable + 1);
            }
        }
        for (&[p, q, r], variable) in triangles.iter().zip(self.triangles[face].clone()) {
            for at in [[p, q], [q, r], [r, p]].iter().filter_map(find) {
                of_side[at].push(2 * variable);
            }
        }
        for literals in of_side {
            let negated: Vec<Code> = literals.iter().map(|code| code ^ 1).collect();
            self.add_row(&literals, 1);
            match (literals.len() as u32).checked_sub(1) {
                Some(most) => self.add_row(&negated, most),
                // Nothing lies on a boundary edge.
                None => self.is_broken = true,
            }
        }
    }

    fn add_row(&mut self, literals: &[Code], most: u32) {
        let (start, len) = (self.literals.len() as u32, literals.len() as u32);
        if most < len {
            self.literals.extend(literals);
            let rest = literals.iter().fold(0, |all, code| all ^ code);
            self.rows.push(Row { start, len, most, room: most as i32, rest });
        }
    }

    /// Lists the rows of each literal.
    fn list_rows(&mut self) {
        let codes = self.holds.len();
        let mut ends = vec![0_u32; codes + 1];
        self.literals.iter().for_each(|&code| ends[code as usize] += 1);
        for code in 1..=codes {
            ends[code] += ends[code - 1];
        }
        self.rows_of = vec![0; self.literals.len()];
        for (index, row) in self.rows.iter().enumerate().rev() {
            for &code in &self.literals[row.start as usize..(row.start + row.len) as usize] {
                let end = &mut ends[code as usize];
                *end -= 1;
                self.rows_of[*end as usize] = index as u32;
            }
        }
        self.row_starts = ends;
    }

    /// The number of literals.
    pub(super) fn code_count(&self) -> usize {
        self.holds.len()
    }

    /// The literals of a clause; none if it has one that all triangulations keep. A literal that none keeps is left out.
    pub(super) fn codes(&self, clause: &[Literal]) -> Option<Vec<Code>> {
        let mut codes = Vec::with_capacity(clause.len());
        for &Literal { face, element, is_used } in clause {
            match self.variable(face as usize, element) {
                Some(variable) => codes.push(2 * variable + u32::from(!is_used)),
                // A triangle or chord that is no candidate is absent from every triangulation.
                None if !is_used => return None,
                None => {}
            }
        }
        Some(codes)
    }

    fn variable(&self, face: usize, element: Element) -> Option<u32> {
        let candidates = self.candidates.get(face)?;
        match element {
            Element::Chord(chord) => {
                let at = candidates.chords.binary_search(&chord).ok()?;
                Some(self.chords[face].start + at as u32)
            }
            Element::Triangle(corners) => {
                let at = candidates.triangles.binary_search(&corners).ok()?;
                Some(self.triangles[face].start + at as u32)
            }
        }
    }
}
