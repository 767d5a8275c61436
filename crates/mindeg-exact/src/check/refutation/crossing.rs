//! Of two chords that cross, a triangulation has one at most.

use super::table::{Code, Table};

impl Table<'_> {
    /// Excludes the chords that cross one that holds; whether none of them does.
    pub(super) fn exclude_crossing(&mut self, code: Code) -> bool {
        let own = code as usize / 2;
        if code % 2 == 1 || own >= self.crossing.len() {
            return true;
        }
        let crossing = self.crossing[own].take().unwrap_or_else(|| {
            let found = self.find_crossing(code / 2);
            self.space = self.space.saturating_sub(found.len());
            found
        });
        let is_kept = crossing.iter().all(|&other| self.set(other ^ 1));
        if self.space > 0 {
            self.crossing[own] = Some(crossing);
        }
        is_kept
    }

    /// The chords that cross one: each has its ends on both sides of the other.
    pub(super) fn find_crossing(&self, own: u32) -> Vec<Code> {
        let face = self.chords.partition_point(|chords| chords.end <= own);
        let (outline, chords) = (&self.faces[face].outline, &self.candidates[face].chords);
        let first = self.chords[face].start;
        let [a, b] = chords[(own - first) as usize];
        let sign = |turn: f64| i8::from(turn > 0.0) - i8::from(turn < 0.0);
        let side_of = |vertex: u32| sign(outline.turn(a, b, vertex));
        let sides: Vec<i8> = (0..outline.points.len() as u32).map(side_of).collect();
        let crosses = |&[c, d]: &[u32; 2]| {
            let parts = sides[c as usize] * sides[d as usize] < 0;
            parts && sign(outline.turn(c, d, a)) * sign(outline.turn(c, d, b)) < 0
        };
        (first..).zip(chords).filter(|(_, chord)| crosses(chord)).map(|(it, _)| 2 * it).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::super::candidates::CheckedFace;
    use super::*;
    use crate::check::CheckedOutline;
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
        let mut table = Table::new(&faces, &[7; 7]);
        let chords = table.candidates[0].chords.clone();
        assert_eq!(chords.len(), 14);
        for (own, &[a, b]) in (0..).zip(&chords) {
            table.supposed.push((2 * own, 0));
            assert!(table.exclude_crossing(2 * own));
            for (other, &[c, d]) in chords.iter().enumerate() {
                let alternate = (a < c && c < b && b < d) || (c < a && a < d && d < b);
                assert_eq!(table.holds[2 * other + 1], alternate, "{a}-{b}, {c}-{d}");
            }
            table.back_to(0);
        }
    }
}
