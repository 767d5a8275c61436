//! Why the maximum degree cannot be less, in a form that is easy to check.
//!
//! A certificate names a lower bound and a witness for it. [`Certificate::check`] tests it
//! against nothing but the interval counts, in O(k²) and without any of the code that found
//! it. That the bound is attained is shown by a triangulation, through
//! [`verify`](crate::verify).

use crate::{Boundary, Cut, best_cuts, bound};
use core::fmt;

/// A lower bound on the maximum degree that some triangulation attains, and its witness.
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
    /// Counting edges gives 2, 3 or 4 (Theorems 3 and 8), and this balanced cut shows that it
    /// is attained.
    BalancedCut {
        /// A cut whose runs differ by at most one interval.
        cut: Cut,
        /// The degree.
        max_degree: u32,
    },
    /// Counting edges gives 4, and the medial triangle of (2,2,2) attains it.
    MedialTriangle,
    /// One side has so many intervals that the vertices off it must share them (Theorem 4).
    LongSide {
        /// The side, counted from 0.
        side: usize,
        /// The degree.
        max_degree: u32,
    },
    /// No cut is balanced, so 4 cannot be had and 5 is the least (Theorems 5 and 10).
    NoBalancedCut {
        /// The least imbalance over all cuts, at least 2.
        least_imbalance: u32,
    },
}

/// The certificate for a boundary. O(k).
#[must_use]
pub fn certificate(boundary: &Boundary) -> Certificate {
    let cut = best_cuts(boundary).next().expect("three sides have a cut");
    if cut.is_balanced() {
        Certificate::BalancedCut { cut, max_degree: bound::counting_bound(boundary) }
    } else if bound::is_medial_exception(boundary) {
        Certificate::MedialTriangle
    } else if cut.side_count == 1 {
        // More than half of the intervals are on one side, by two or more: its bound is 5 at
        // least.
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
/// # Ok::<(), mindeg_core::BoundaryError>(())
/// ```
#[must_use]
pub fn least_max_degree(boundary: &Boundary) -> u32 {
    certificate(boundary).max_degree()
}

/// Why a certificate does not hold for some interval counts.
///
/// # Example
///
/// ```
/// use mindeg_core::Certificate;
///
/// let error = Certificate::MedialTriangle.check(&[2, 2, 3]).unwrap_err();
/// assert_eq!(error.to_string(), "only (2,2,2) has the medial triangle");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CertificateError(&'static str);

impl fmt::Display for CertificateError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.0)
    }
}

impl core::error::Error for CertificateError {}

impl Certificate {
    /// The degree that this certificate says is the least possible.
    #[must_use]
    pub fn max_degree(&self) -> u32 {
        match *self {
            Self::BalancedCut { max_degree, .. } | Self::LongSide { max_degree, .. } => max_degree,
            Self::MedialTriangle => 4,
            Self::NoBalancedCut { .. } => 5,
        }
    }

    /// Checks the witness against the interval counts and gives the bound it proves. O(k²).
    ///
    /// It uses the definitions alone: sums of runs, and for [`NoBalancedCut`](Self::NoBalancedCut)
    /// every cut there is. That some triangulation attains the bound is another matter, and
    /// [`verify`](crate::verify)'s.
    ///
    /// # Errors
    ///
    /// What about the witness is not so, or that the counts are no polygon's.
    pub fn check(&self, intervals: &[u64]) -> Result<u32, CertificateError> {
        let no_polygon = CertificateError("the interval counts are no polygon's");
        let sides = intervals.len();
        // The first vertex of every side, then the total.
        let mut corners = alloc::vec![0_u64];
        let mut total = 0_u64;
        for &count in intervals {
            total = total.checked_add(count).filter(|_| count > 0).ok_or(no_polygon)?;
            corners.push(total);
        }
        if sides < 3 || total > u64::from(crate::MAX_VERTICES) {
            return Err(no_polygon);
        }
        let (proven, max_degree) = match *self {
            Self::BalancedCut { cut, max_degree } => {
                if cut.first_side >= sides || !(1..sides).contains(&cut.side_count) {
                    return Err(CertificateError("the cut names sides that do not exist"));
                }
                let run = intervals.iter().cycle().skip(cut.first_side).take(cut.side_count);
                let larger: u64 = run.sum();
                if larger != u64::from(cut.larger) || total - larger != u64::from(cut.smaller) {
                    return Err(CertificateError("the runs of the cut have other sums"));
                }
                if larger.abs_diff(total - larger) > 1 {
                    return Err(CertificateError("the runs of the cut differ by more than 1"));
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
                return Err(CertificateError("only (2,2,2) has the medial triangle"));
            }
            Self::MedialTriangle => (4, 4),
            Self::LongSide { side, max_degree } => {
                let Some(&long) = intervals.get(side) else {
                    return Err(CertificateError("the long side does not exist"));
                };
                // All n-3 interior edges end at one of the vertices off the side.
                let off_side = total - long - 1;
                ((total - 3).div_ceil(off_side) as u32 + 2, max_degree)
            }
            Self::NoBalancedCut { least_imbalance } => {
                if least_imbalance < 2 {
                    return Err(CertificateError("a cut with that imbalance is balanced"));
                }
                if total < 7 {
                    return Err(CertificateError("below 7 intervals degree 4 needs no cut"));
                }
                let ends = |from| (from + 1..sides).map(move |to| (from, to));
                let least = (0..sides)
                    .flat_map(ends)
                    .map(|(from, to)| (2 * (corners[to] - corners[from])).abs_diff(total))
                    .min();
                if least != Some(u64::from(least_imbalance)) {
                    return Err(CertificateError("the cuts have another least imbalance"));
                }
                (5, 5)
            }
        };
        if proven == max_degree {
            Ok(proven)
        } else {
            Err(CertificateError("the witness proves another bound"))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn certificates_are_found_and_hold() {
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
