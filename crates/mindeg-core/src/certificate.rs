//! A proof that no triangulation has a smaller maximum degree, in a form that is easy to check.
//!
//! A certificate is a lower bound with a witness. [`Certificate::check`] tests it against the
//! interval counts alone, in O(k²), and shares no code with the search for certificates. A
//! triangulation proves that the bound is attained; [`verify`](crate::verify()) checks it.

use crate::{Boundary, Cut, Defect, best_cuts, bound};

/// A lower bound on the maximum degree, attained by some triangulation, and its witness.
///
/// # Example
///
/// ```
/// use mindeg_core::{Boundary, Certificate, certificate};
///
/// let certificate = certificate(&Boundary::new(&[30, 2, 4, 2])?);
/// assert_eq!(certificate, Certificate::LongSide { side: 0, max_degree: 7 });
/// assert_eq!(certificate.check(&[30, 2, 4, 2]), Ok(7));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Certificate {
    /// Counting edges gives the bound 2, 3 or 4 (Theorems 3 and 8), and a zig-zag across this
    /// balanced cut attains it.
    BalancedCut {
        /// A cut whose runs differ by at most one interval.
        cut: Cut,
        /// The bound.
        max_degree: u32,
    },
    /// Counting edges gives the bound 4, and the medial triangle of (2,2,2) attains it.
    MedialTriangle,
    /// The vertices that are not on one long side share almost all interior edges (Theorem 4).
    LongSide {
        /// The side, counted from 0.
        side: usize,
        /// The bound.
        max_degree: u32,
    },
    /// No cut is balanced, so degree 4 is impossible and the bound is 5 (Theorems 5 and 10).
    NoBalancedCut {
        /// The least imbalance over all cuts, at least 2.
        least_imbalance: u32,
    },
}

/// The certificate for a boundary. O(k).
pub fn certificate(boundary: &Boundary) -> Certificate {
    let cut = best_cuts(boundary).next().expect("three sides have a cut");
    if cut.is_balanced() {
        Certificate::BalancedCut { cut, max_degree: bound::counting_bound(boundary) }
    } else if bound::is_medial_exception(boundary) {
        Certificate::MedialTriangle
    } else if cut.side_count == 1 {
        // One side has at least two intervals more than all others together, so its bound is at
        // least 5.
        let side = cut.first_side;
        Certificate::LongSide { side, max_degree: bound::side_bound(boundary, side) }
    } else {
        Certificate::NoBalancedCut { least_imbalance: cut.imbalance() }
    }
}

/// The least possible maximum degree D*. O(k).
///
/// ```
/// # use mindeg_core::{Boundary, least_max_degree};
/// assert_eq!(least_max_degree(&Boundary::new(&[1, 1, 1])?), 2);
/// assert_eq!(least_max_degree(&Boundary::new(&[2, 2, 2])?), 4);
/// assert_eq!(least_max_degree(&Boundary::new(&[8, 6, 8, 5])?), 4);
/// assert_eq!(least_max_degree(&Boundary::new(&[12, 9, 4, 4])?), 5);
/// assert_eq!(least_max_degree(&Boundary::new(&[1000, 3, 5, 2])?), 114);
/// # Ok::<(), mindeg_core::Defect>(())
/// ```
pub fn least_max_degree(boundary: &Boundary) -> u32 {
    certificate(boundary).max_degree()
}

impl Certificate {
    /// The least possible maximum degree according to this certificate. O(1).
    pub fn max_degree(&self) -> u32 {
        match *self {
            Self::BalancedCut { max_degree, .. } | Self::LongSide { max_degree, .. } => max_degree,
            Self::MedialTriangle => 4,
            Self::NoBalancedCut { .. } => 5,
        }
    }

    /// Checks the witness against the interval counts and returns the bound it proves. O(k²).
    ///
    /// The check uses the definitions alone: sums of runs, and all cuts for
    /// [`NoBalancedCut`](Self::NoBalancedCut). It does not prove that some triangulation attains
    /// the bound; for that, [`verify`](crate::verify()) one.
    ///
    /// # Errors
    ///
    /// The counts do not describe a polygon, or the witness does not fit them. The message says
    /// what does not fit.
    pub fn check(&self, intervals: &[u64]) -> Result<u32, Defect> {
        let no_polygon = || Defect::new("the interval counts do not describe a polygon");
        let sides = intervals.len();
        // The first vertex of every side, then the total.
        let mut corners = alloc::vec![0_u64];
        let mut total = 0_u64;
        for &count in intervals {
            total = total.checked_add(count).filter(|_| count > 0).ok_or_else(no_polygon)?;
            corners.push(total);
        }
        if sides < 3 || total > u64::from(crate::MAX_VERTICES) {
            return Err(no_polygon());
        }
        let (proven, max_degree) = match *self {
            Self::BalancedCut { cut, max_degree } => {
                if cut.first_side >= sides || !(1..sides).contains(&cut.side_count) {
                    return Err(Defect::new("the cut has a side that does not exist"));
                }
                let run = intervals.iter().cycle().skip(cut.first_side).take(cut.side_count);
                let larger: u64 = run.sum();
                if larger != u64::from(cut.larger) || total - larger != u64::from(cut.smaller) {
                    return Err(Defect::new("the interval sums of the cut's runs are wrong"));
                }
                if larger.abs_diff(total - larger) > 1 {
                    return Err(Defect::new("the runs of the cut differ by more than 1"));
                }
                // The pigeonhole bound of Theorems 3 and 8, case by case.
                let counting = match total {
                    3 => 2,
                    4 => 3,
                    _ => 4,
                };
                (counting, max_degree)
            }
            Self::MedialTriangle if intervals != [2, 2, 2] => {
                return Err(Defect::new("the medial triangle proves a bound for (2,2,2) only"));
            }
            Self::MedialTriangle => (4, 4),
            Self::LongSide { side, max_degree } => {
                let Some(&long) = intervals.get(side) else {
                    return Err(Defect::new("the long side does not exist"));
                };
                // Each of the n-3 interior edges has an end that is not on the side.
                let off_side = total - long - 1;
                ((total - 3).div_ceil(off_side) as u32 + 2, max_degree)
            }
            Self::NoBalancedCut { least_imbalance } => {
                if least_imbalance < 2 {
                    return Err(Defect::new(
                        "the least imbalance is below 2, so a balanced cut exists",
                    ));
                }
                if total < 7 {
                    return Err(Defect::new("this bound needs at least 7 intervals"));
                }
                let ends = |from| (from + 1..sides).map(move |to| (from, to));
                let least = (0..sides)
                    .flat_map(ends)
                    .map(|(from, to)| (2 * (corners[to] - corners[from])).abs_diff(total))
                    .min();
                if least != Some(u64::from(least_imbalance)) {
                    return Err(Defect::new("the least imbalance of the cuts is wrong"));
                }
                (5, 5)
            }
        };
        if proven == max_degree {
            Ok(proven)
        } else {
            Err(Defect::new("the witness proves a different bound"))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_certificate_holds() {
        let cut = |first_side, side_count, larger, smaller| Cut {
            first_side,
            side_count,
            larger,
            smaller,
        };
        for (intervals, expected) in [
            (&[1, 1, 1][..], Certificate::BalancedCut { cut: cut(1, 2, 2, 1), max_degree: 2 }),
            (&[1, 1, 1, 1], Certificate::BalancedCut { cut: cut(0, 2, 2, 2), max_degree: 3 }),
            (&[3, 3, 2, 2], Certificate::BalancedCut { cut: cut(1, 2, 5, 5), max_degree: 4 }),
            (&[2, 2, 2], Certificate::MedialTriangle),
            (&[30, 2, 4, 2], Certificate::LongSide { side: 0, max_degree: 7 }),
            (&[2, 1000, 3, 5], Certificate::LongSide { side: 1, max_degree: 114 }),
            (&[12, 9, 4, 4], Certificate::NoBalancedCut { least_imbalance: 3 }),
        ] {
            let found = certificate(&Boundary::new(intervals).unwrap());
            assert_eq!(found, expected, "{intervals:?}");
            assert_eq!(found.check(intervals), Ok(expected.max_degree()), "{intervals:?}");
        }
    }

    #[test]
    fn a_certificate_need_not_be_the_sharpest() {
        let certificate = Certificate::NoBalancedCut { least_imbalance: 3 };
        assert_eq!(certificate.check(&[5, 1, 1]), Ok(5));
        let certificate = Certificate::LongSide { side: 1, max_degree: 3 };
        assert_eq!(certificate.check(&[5, 1, 1]), Ok(3));
    }

    #[test]
    fn false_certificates_are_refused() {
        let cut = Cut { first_side: 0, side_count: 2, larger: 5, smaller: 5 };
        for (certificate, intervals) in [
            (Certificate::BalancedCut { cut, max_degree: 4 }, &[3, 3, 2, 2][..]),
            (Certificate::BalancedCut { cut, max_degree: 5 }, &[3, 2, 3, 2]),
            (Certificate::BalancedCut { cut, max_degree: 4 }, &[4, 4, 1, 1]),
            (
                Certificate::BalancedCut { cut: Cut { side_count: 4, ..cut }, max_degree: 4 },
                &[3, 2, 3, 2],
            ),
            (
                Certificate::BalancedCut {
                    cut: Cut { larger: 6, smaller: 4, ..cut },
                    max_degree: 4,
                },
                &[3, 3, 2, 2],
            ),
            (
                Certificate::BalancedCut { cut: Cut { first_side: 4, ..cut }, max_degree: 4 },
                &[3, 2, 3, 2],
            ),
            (
                Certificate::BalancedCut { cut: Cut { smaller: 4, ..cut }, max_degree: 4 },
                &[3, 2, 3, 2],
            ),
            (Certificate::MedialTriangle, &[2, 2, 3]),
            (Certificate::LongSide { side: 4, max_degree: 7 }, &[30, 2, 4, 2]),
            (Certificate::LongSide { side: 0, max_degree: 8 }, &[30, 2, 4, 2]),
            (Certificate::NoBalancedCut { least_imbalance: 3 }, &[3, 3, 2, 2]),
            (Certificate::NoBalancedCut { least_imbalance: 0 }, &[3, 2, 3, 2]),
            (Certificate::NoBalancedCut { least_imbalance: 2 }, &[2, 2, 2]),
            (Certificate::NoBalancedCut { least_imbalance: 2 }, &[0, 2, 2]),
            (Certificate::NoBalancedCut { least_imbalance: 2 }, &[7, 2]),
            (Certificate::LongSide { side: 0, max_degree: 11 }, &[10, 0, 2]),
            (Certificate::LongSide { side: 0, max_degree: 5 }, &[u64::MAX, 2, 2]),
            (Certificate::LongSide { side: 0, max_degree: 5 }, &[1 << 32, 1 << 31, 2]),
        ] {
            assert!(certificate.check(intervals).is_err(), "{certificate:?} for {intervals:?}");
        }
    }
}
