//! The boundaries that all programs are given.

use Outline::{Rectangle, Regular};
use glam::DVec2;
use mindeg::{Domain, DomainError, Side};
use mindeg_core::{Boundary, Defect};

/// A boundary to triangulate.
pub(crate) struct Case {
    /// For the command line.
    pub(crate) id: &'static str,
    /// For the tables.
    pub(crate) title: &'static str,
    outline: Outline,
    sides: &'static [u64],
}

enum Outline {
    Rectangle(f64, f64),
    /// In the unit circle.
    Regular,
}

/// The cases; those that the growth with the number of points is taken from come first.
#[rustfmt::skip]
pub(crate) const CASES: [Case; 9] = [
    Case { id: "4x100", title: "4 × 100", outline: Rectangle(4.0, 3.0), sides: &[100; 4] },
    Case { id: "4x10000", title: "4 × 10⁴", outline: Rectangle(4.0, 3.0), sides: &[10_000; 4] },
    Case { id: "4x100000", title: "4 × 10⁵", outline: Rectangle(4.0, 3.0), sides: &[100_000; 4] },
    Case { id: "square", title: "square, 4 × 10⁵", outline: Rectangle(1.0, 1.0), sides: &[100_000; 4] },
    Case { id: "uneven", title: "1000, 800, 100, 100", outline: Rectangle(4.0, 3.0), sides: &[1000, 800, 100, 100] },
    Case { id: "one-side", title: "10⁵, 1, 1, 1", outline: Rectangle(4.0, 3.0), sides: &[100_000, 1, 1, 1] },
    Case { id: "triangle", title: "triangle", outline: Regular, sides: &[1000; 3] },
    Case { id: "pentagon", title: "pentagon", outline: Regular, sides: &[1000; 5] },
    Case { id: "octagon", title: "octagon", outline: Regular, sides: &[1000; 8] },
];

/// The number of cases, from the first on, that differ in the number of points alone.
pub(crate) const GROWING: usize = 3;

/// The input of a program: it takes the parts that it needs.
pub(crate) struct Input {
    pub(crate) intervals: Vec<u64>,
    pub(crate) corners: Vec<DVec2>,
    pub(crate) boundary: Boundary,
    /// All boundary points, counter-clockwise from the first corner.
    pub(crate) points: Vec<DVec2>,
}

impl Case {
    pub(crate) fn vertices(&self) -> u64 {
        self.sides.iter().sum()
    }

    pub(crate) fn input(&self) -> Result<Input, DomainError> {
        let intervals = self.sides.to_vec();
        let corners = match self.outline {
            Rectangle(width, height) => {
                let corners = [[0.0, 0.0], [width, 0.0], [width, height], [0.0, height]];
                corners.map(DVec2::from).to_vec()
            }
            Regular => regular(self.sides.len()),
        };
        let domain = domain(&corners, &intervals)?;
        let points = domain.placement().points().collect();
        Ok(Input {
            intervals,
            corners,
            boundary: domain.convex().expect("the cases are convex").boundary().clone(),
            points,
        })
    }
}

impl Input {
    /// The domain, made anew: making it is part of the work that is timed.
    pub(crate) fn domain(&self) -> Result<Domain, DomainError> {
        domain(&self.corners, &self.intervals)
    }

    /// The boundary, made anew.
    pub(crate) fn new_boundary(&self) -> Result<Boundary, Defect> {
        Boundary::new(&self.intervals)
    }

    /// The boundary edges, counter-clockwise.
    pub(crate) fn ring(&self) -> impl Iterator<Item = [usize; 2]> + use<> {
        let count = self.points.len();
        (0..count).map(move |from| [from, (from + 1) % count])
    }
}

fn domain(corners: &[DVec2], intervals: &[u64]) -> Result<Domain, DomainError> {
    let sides = intervals.iter().copied().map(Side::count).collect();
    Domain::polygon(corners.to_vec(), sides)
}

/// The corners of a regular polygon in the unit circle.
fn regular(sides: usize) -> Vec<DVec2> {
    let turn = std::f64::consts::TAU / sides as f64;
    (0..sides).map(|corner| DVec2::from_angle(turn * corner as f64)).collect()
}
