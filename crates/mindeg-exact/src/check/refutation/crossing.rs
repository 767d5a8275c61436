//! Of two chords that cross, a triangulation has one at most.

use super::{Code, Table};

impl Table<'_> {
    /// Excludes the chords that cross one that holds; whether none of them does.
    pub(super) fn exclude_crossing(&mut self, code: Code) -> bool {
        let Some(own) = self.chord_of[code] else { return true };
        let crossing = match self.crossing[own].take() {
            Some(known) => known,
            None => {
                let found = self.find_crossing(own);
                self.space = self.space.saturating_sub(found.len());
                found
            }
        };
        let is_kept = crossing.iter().all(|&other| self.set(other as usize ^ 1));
        if self.space > 0 {
            self.crossing[own] = Some(crossing);
        }
        is_kept
    }

    /// The chords that cross one: each has its ends on both sides of the other.
    fn find_crossing(&self, own: usize) -> Vec<u32> {
        let (face, [a, b], _) = self.chords[own];
        let outline = &self.faces[face as usize].outline;
        let parts = |from: u32, to: u32, ends: [u32; 2]| {
            let [one, other] = ends.map(|end| outline.turn(from, to, end));
            (one > 0.0 && other < 0.0) || (one < 0.0 && other > 0.0)
        };
        let crosses = |&&(other, [c, d], _): &&(u32, [u32; 2], Code)| {
            other == face && parts(a, b, [c, d]) && parts(c, d, [a, b])
        };
        self.chords.iter().filter(crosses).map(|&(.., code)| code as u32).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::super::{CheckedFace, CheckedOutline, Table};
    use glam::DVec2;

    #[test]
    fn a_chord_excludes_those_that_alternate_with_it_and_no_others() {
        let at = |corner: u32| DVec2::from_angle(f64::from(corner) * std::f64::consts::TAU / 7.0);
        let points: Vec<DVec2> = (0..7).map(at).collect();
        let vertices: Vec<u32> = (0..7).collect();
        let ring = 0..7;
        let outline = CheckedOutline {
            points: &points,
            rings: std::slice::from_ref(&ring),
            side_of: &vertices,
            keeps_clear: true,
        };
        let faces = [CheckedFace { outline, vertices: &vertices, least_tangent: 0.0 }];
        let mut table = Table::of(&faces);
        table.add_face(0, &faces[0], &mut vec![Vec::new(); 7]);
        for own in 0..table.chords.len() {
            let (_, [a, b], code) = table.chords[own];
            assert!(table.exclude_crossing(code));
            for &(_, [c, d], other) in &table.chords {
                let alternate = (a < c && c < b && b < d) || (c < a && a < d && d < b);
                assert_eq!(table.holds[other + 1], alternate, "{a}-{b}, {c}-{d}");
            }
            table.back_to(0);
        }
    }
}
