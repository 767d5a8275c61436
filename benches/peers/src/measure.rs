//! How good a list of triangles is that somebody else made.

use crate::input::Input;
use mindeg::quality::TriangleQuality;
use mindeg_core::verify;
use serde::{Deserialize, Serialize};

/// The measures of a peer's triangles.
///
/// Degree and angle are those of the triangles that are not flat.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Figures {
    pub(crate) validity: Validity,
    pub(crate) max_degree: u32,
    /// In degrees.
    pub(crate) min_angle: f64,
}

/// Whether the triangles triangulate the boundary.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) enum Validity {
    Valid,
    /// There are flat triangles, and without them the rest is valid.
    ValidBesidesFlat(usize),
    /// `flat` triangles are flat, `missing` of the right number are not there, and the first
    /// defect that the check names in the others.
    Invalid {
        flat: usize,
        missing: usize,
        defect: String,
    },
}

/// The figures of a list of triangles, whichever way round each is: programs for pictures have the
/// y axis down.
pub(crate) fn measure(input: &Input, mut triangles: Vec<[u32; 3]>) -> Figures {
    let count = input.points.len();
    let exists = |&vertex: &u32| (vertex as usize) < count;
    triangles.iter_mut().for_each(turn_counter_clockwise);
    let given = triangles.len();
    // A corner that names no vertex is for the check to report.
    triangles
        .retain(|triangle| !(triangle.iter().all(exists) && input.boundary.is_flat(*triangle)));
    let flat = given - triangles.len();
    let validity = match verify(&input.intervals, triangles.iter().copied()) {
        Ok(_) if flat == 0 => Validity::Valid,
        Ok(_) => Validity::ValidBesidesFlat(flat),
        Err(defect) => Validity::Invalid {
            flat,
            missing: (count - 2).saturating_sub(triangles.len()),
            defect: defect.to_string(),
        },
    };
    triangles.retain(|triangle| triangle.iter().all(exists));
    let angle = |triangle: &[u32; 3]| {
        let [a, b, c] = triangle.map(|vertex| input.points[vertex as usize]);
        TriangleQuality::of(a, b, c).min_angle
    };
    Figures {
        validity,
        max_degree: max_degree(input, &triangles),
        min_angle: triangles.iter().map(angle).fold(f64::INFINITY, f64::min),
    }
}

/// In a convex polygon, three vertices are counter-clockwise when their ids go down once only.
fn turn_counter_clockwise(triangle: &mut [u32; 3]) {
    let [a, b, c] = *triangle;
    if u32::from(b < a) + u32::from(c < b) + u32::from(a < c) == 2 {
        triangle.swap(1, 2);
    }
}

/// The most neighbours of a vertex, its two on the boundary included.
fn max_degree(input: &Input, triangles: &[[u32; 3]]) -> u32 {
    let ring = input.ring().map(|edge| edge.map(|vertex| vertex as u32));
    let sides = triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    let mut edges: Vec<[u32; 2]> = ring.chain(sides).map(|[a, b]| [a.min(b), a.max(b)]).collect();
    edges.sort_unstable();
    edges.dedup();
    let mut degrees = vec![0; input.points.len()];
    for vertex in edges.into_iter().flatten() {
        degrees[vertex as usize] += 1;
    }
    degrees.into_iter().max().unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use mindeg_core::Boundary;

    /// A rectangle with its bottom halved.
    fn halved() -> Input {
        let points = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 1.0], [0.0, 1.0]];
        let intervals = vec![2, 1, 1, 1];
        let boundary = Boundary::new(&intervals).unwrap();
        Input { intervals, corners: Vec::new(), boundary, points: points.map(Into::into).to_vec() }
    }

    #[test]
    fn lists_of_triangles_are_judged() {
        let invalid = |flat, missing, defect: &str| Validity::Invalid {
            flat,
            missing,
            defect: defect.to_owned(),
        };
        for (triangles, validity, max_degree) in [
            (&[[0, 1, 4], [1, 3, 4], [1, 2, 3]][..], Validity::Valid, 4),
            // Clockwise.
            (&[[0, 4, 1], [4, 3, 1], [1, 3, 2]], Validity::Valid, 4),
            (&[[0, 1, 4], [1, 3, 4], [1, 2, 3], [0, 1, 2]], Validity::ValidBesidesFlat(1), 4),
            (&[[0, 1, 2], [0, 2, 4], [2, 3, 4]], invalid(1, 1, "found 2 triangles, expected 3"), 4),
            (
                &[[0, 1, 4], [1, 3, 4], [1, 2, 9]],
                invalid(0, 0, "triangle 2 has vertex 9, which does not exist"),
                4,
            ),
            (&[], invalid(0, 3, "found 0 triangles, expected 3"), 2),
        ] {
            let figures = measure(&halved(), triangles.to_vec());
            assert_eq!((figures.validity, figures.max_degree), (validity, max_degree));
        }
        let figures = measure(&halved(), vec![[0, 1, 4], [1, 3, 4], [1, 2, 3]]);
        assert!((figures.min_angle - 45.0).abs() < 1e-12);
    }
}
