//! Chords that cross exclude each other. The rows say so, too, but only once all triangles beside them are excluded.

/// The most chords in all lists: 32 MB.
const MOST: usize = 1 << 23;

/// For each chord that was used those that cross it, as far as there is space.
pub(super) struct Crossing {
    pub(super) lists: Vec<Option<Vec<u32>>>,
    pub(super) left: usize,
}

impl Crossing {
    pub(super) fn new(chords: u32) -> Self {
        Self { lists: vec![None; chords as usize], left: MOST }
    }
}

#[cfg(test)]
mod tests {
    use super::super::Expected;
    use crate::cover::{Cover, Element};
    use crate::problem::Problem;
    use glam::DVec2;
    use mindeg_mesh::Progress;
    use mindeg_mesh::planar::PlanarBoundary;

    #[test]
    fn chords_of_a_convex_polygon_cross_where_their_ends_alternate() {
        let at = |corner: u32| DVec2::from_angle(f64::from(corner) * std::f64::consts::TAU / 9.0);
        let fan: Vec<[u32; 3]> = (1..8).map(|corner| [0, corner, corner + 1]).collect();
        let boundary = PlanarBoundary::new(&[Vec::from_iter((0..9).map(at))]).unwrap();
        let problem = Problem::triangulated(&boundary, &fan).unwrap();
        let cover = Cover::of(&problem, Progress::NONE).unwrap().unwrap();
        let search = cover.search(&[9; 9], &[0.0], Expected::Mesh, &[]);
        let ends = |chord: u32| match search.rows.literal(2 * chord).element {
            Element::Chord(ends) => ends,
            Element::Triangle(_) => unreachable!("chords come first"),
        };
        let alternate = |[a, b]: [u32; 2], [c, d]: [u32; 2]| {
            (a < c && c < b && b < d) || (c < a && a < d && d < b)
        };
        for chord in 0..search.rows.chords {
            let all = (0..search.rows.chords).filter(|&it| alternate(ends(chord), ends(it)));
            assert_eq!(search.rows.crossing(chord), all.collect::<Vec<u32>>());
        }
    }
}
