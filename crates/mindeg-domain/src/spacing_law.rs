//! Spacing laws solved for a number of intervals: the parameter of any point in O(1).
//!
//! Each law of [`Spacing`] is rewritten so that neither cancellation nor overflow spoils it: a
//! difference of two hyperbolic tangents, say, as a product of exponentials of negative
//! arguments. Transcendental functions come from the `libm` crate, so the parameters are the
//! same on every machine.
//!
//! Why O(1) suffices to know that all parameters increase: the intervals of every closed form here
//! grow or shrink steadily along the side, or do so up to the middle and mirror there. So the
//! shortest interval is the first, the middle or the last one. If it is at least [`LEAST_SHARE`],
//! the exponents in the formulas stay below about 60, and parameters are off by less than `1e-14`
//! (at most `7e-16` in 60,000 compared with 60-digit arithmetic).
//!
//! Limits: parameters near 1 carry the absolute rounding of numbers near 1, some `1e-16`.

mod curves;

use self::curves::{Crowding, Progression, Stretching};
use crate::error::{DomainError, Place, counted};
use crate::limits::LEAST_SHARE;
use crate::spacing::Spacing;
use mindeg_mesh::number;

/// A spacing law solved for a side: point `i` of `m` intervals lies at `parameter(i)` of the
/// side's length, from exactly 0 at `i = 0` to exactly 1 at `i = m`, strictly increasing.
///
/// O(1) memory and O(1) time per point, except for explicit parameters, which are stored.
///
/// # Example
///
/// ```
/// use mindeg_domain::{Spacing, SpacingLaw};
///
/// // Three intervals of lengths 1, 2 and 4 on a side of length 7.
/// let law = SpacingLaw::solve(&Spacing::Geometric { ratio: 2.0 }, 3, 7.0)?;
/// assert!((law.parameter(1) - 1.0 / 7.0).abs() < 1e-15);
/// assert!((law.parameter(2) - 3.0 / 7.0).abs() < 1e-15);
/// assert_eq!(law.parameter(3), 1.0);
///
/// // The same, given by the first interval.
/// let first = SpacingLaw::solve(&Spacing::FirstLength(1.0), 3, 7.0)?;
/// assert!((first.parameter(2) - 3.0 / 7.0).abs() < 1e-15);
/// # Ok::<(), mindeg_domain::DomainError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct SpacingLaw {
    intervals: u32,
    form: Form,
}

#[derive(Clone, Debug, PartialEq)]
enum Form {
    Uniform,
    Geometric(Progression),
    /// Bump with ratio below 1.
    CrowdedEnds(Stretching),
    /// Bump with ratio above 1.
    CrowdedMiddle(Crowding),
    Beta {
        stretching: Stretching,
        reversed: bool,
    },
    Parameters(Box<[f64]>),
}

impl SpacingLaw {
    /// Solves `spacing` for a side of `intervals` intervals (at least 1; 0 is taken as 1) and
    /// length `side_length` (above 0, in the units of the domain).
    ///
    /// O(1), and O(m) for explicit parameters.
    ///
    /// # Errors
    ///
    /// A ratio, beta, length or parameter outside its range, a number of parameters that does
    /// not fit the intervals, or an interval shorter than [`LEAST_SHARE`](crate::LEAST_SHARE) of the side.
    pub fn solve(spacing: &Spacing, intervals: u32, side_length: f64) -> Result<Self, DomainError> {
        let intervals = intervals.max(1);
        let form = match spacing {
            Spacing::Uniform => Form::Uniform,
            Spacing::Geometric { ratio } => {
                geometric(libm::log(positive("ratio", *ratio)?), intervals)
            }
            Spacing::Bump { ratio } => bump(positive("ratio", *ratio)?),
            Spacing::Beta { beta } => roberts(*beta)?,
            Spacing::FirstLength(length) => {
                let length = positive("first length", *length)?;
                geometric(log_ratio(length, intervals, side_length)?, intervals)
            }
            Spacing::LastLength(length) => {
                let length = positive("last length", *length)?;
                geometric(-log_ratio(length, intervals, side_length)?, intervals)
            }
            Spacing::Parameters(given) => explicit(given, intervals)?,
        };
        let law = Self { intervals, form };
        let (interval, share) = law.shortest();
        if share >= LEAST_SHARE {
            Ok(law)
        } else {
            Err(error(format!(
                "interval {} of {intervals} would be {} of the side's length, less than {LEAST_SHARE:e}; use \
                 fewer intervals or a gentler law",
                interval + 1,
                number(share)
            )))
        }
    }

    /// Whether point `i` of `m` lies at `i/m`.
    pub(crate) fn is_uniform(&self) -> bool {
        self.form == Form::Uniform
    }

    /// The number of intervals m, at least 1.
    pub fn intervals(&self) -> u32 {
        self.intervals
    }

    /// The position of point `i`, as a share of the side from its start: 0 at `i = 0`, 1 from
    /// `i = m` on. O(1).
    pub fn parameter(&self, i: u32) -> f64 {
        let m = self.intervals;
        if i == 0 {
            return 0.0;
        }
        if i >= m {
            return 1.0;
        }
        match &self.form {
            Form::Uniform => f64::from(i) / f64::from(m),
            Form::Geometric(progression) => progression.share(i, m),
            Form::CrowdedEnds(stretching) => mirrored(i, m, |i| stretching.half_share(i, m)),
            Form::CrowdedMiddle(crowding) => mirrored(i, m, |i| crowding.half_share(i, m)),
            Form::Beta { stretching, reversed: false } => stretching.share(i, m),
            Form::Beta { stretching, reversed: true } => 1.0 - stretching.share(m - i, m),
            Form::Parameters(given) => given[i as usize - 1],
        }
    }

    /// The index of the shortest interval from 0 (the first of equals), and its share of the side.
    ///
    /// O(1), and O(m) for explicit parameters.
    pub fn shortest(&self) -> (u32, f64) {
        let last = self.intervals - 1;
        match &self.form {
            Form::Uniform => (0, self.parameter(1)),
            Form::Parameters(_) => self.shortest_of(0..=last),
            // Both ends are equally short; rounding must not prefer the last.
            Form::CrowdedEnds(_) => (0, self.parameter(1)),
            Form::Geometric(_) | Form::CrowdedMiddle(_) | Form::Beta { .. } => {
                self.shortest_of([0, last / 2, last])
            }
        }
    }

    fn shortest_of(&self, intervals: impl IntoIterator<Item = u32>) -> (u32, f64) {
        let share = |i: u32| self.parameter(i + 1) - self.parameter(i);
        intervals
            .into_iter()
            .map(|i| (i, share(i)))
            .reduce(|best, next| if next.1 < best.1 { next } else { best })
            .unwrap_or((0, 1.0))
    }
}

fn error(message: String) -> DomainError {
    Place::key("spacing").error(message)
}

fn positive(what: &'static str, value: f64) -> Result<f64, DomainError> {
    if value > 0.0 && value.is_finite() {
        Ok(value)
    } else {
        Err(error(format!("the {what} is {value:?}; it must be a finite number above 0")))
    }
}

fn geometric(log_ratio: f64, m: u32) -> Form {
    if log_ratio == 0.0 { Form::Uniform } else { Form::Geometric(Progression::new(log_ratio, m)) }
}

/// The logarithm of the ratio for which a geometric series of `m` intervals on a side of length
/// `side_length` starts with `length`.
fn log_ratio(length: f64, m: u32, side_length: f64) -> Result<f64, DomainError> {
    if m == 1 {
        return if (length - side_length).abs() <= 1e-9 * side_length {
            Ok(0.0)
        } else {
            Err(error(format!(
                "the side is a single interval of length {side_length:?}, not {length:?}; use more \
                 intervals or drop the law"
            )))
        };
    }
    let share = length / side_length;
    if share >= 1.0 {
        return Err(error(format!(
            "an interval of length {} leaves nothing of the side's {} for the other {}; give a shorter length \
             or 1 interval",
            number(length),
            number(side_length),
            counted(m as usize - 1, "interval")
        )));
    }
    let even = share * f64::from(m);
    if even == 1.0 {
        return Ok(0.0);
    }
    // The first share falls steadily as the ratio r rises. It lies between 1 - r and 1/m where
    // r < 1, and below r^(1-m) where r > 1: that brackets the root, and bisection ends when the
    // bracket holds no further f64.
    let (mut low, mut high) = if even > 1.0 {
        (libm::log1p(-share), 0.0)
    } else {
        (0.0, -libm::log(share) / f64::from(m - 1))
    };
    loop {
        let middle = low + (high - low) / 2.0;
        if middle <= low || middle >= high {
            return Ok(middle);
        }
        if Progression::new(middle, m).share(1, m) > share {
            low = middle;
        } else {
            high = middle;
        }
    }
}

fn bump(ratio: f64) -> Form {
    if ratio == 1.0 {
        Form::Uniform
    } else if ratio < 1.0 {
        // artanh x = ln(1 + x) - ln(1 - x²)/2, which stays finite where x rounds to 1.
        let width = libm::log1p((1.0 - ratio).sqrt()) - libm::log(ratio) / 2.0;
        Form::CrowdedEnds(Stretching::new(width))
    } else {
        Form::CrowdedMiddle(Crowding::new((ratio - 1.0).sqrt()))
    }
}

fn roberts(beta: f64) -> Result<Form, DomainError> {
    let size = beta.abs();
    if !(size > 1.0 && size.is_finite()) {
        return Err(error(format!(
            "beta is {beta:?}; it must be above 1 (points crowd at the side's start) or below -1 (at \
             its end)"
        )));
    }
    // artanh(1/b) = ln((b + 1)/(b - 1))/2
    let width = libm::log1p(2.0 / (size - 1.0)) / 2.0;
    // The law departs from even spacing by the square of the width: here by less than an ulp.
    Ok(if width < 1e-9 {
        Form::Uniform
    } else {
        Form::Beta { stretching: Stretching::new(width), reversed: beta < 0.0 }
    })
}

/// The parameter of point `i` of a law that mirrors at the middle, from the law of its first
/// half.
fn mirrored(i: u32, m: u32, first_half: impl Fn(u32) -> f64) -> f64 {
    let rest = m - i;
    match i.cmp(&rest) {
        std::cmp::Ordering::Less => first_half(i),
        std::cmp::Ordering::Equal => 0.5,
        std::cmp::Ordering::Greater => 1.0 - first_half(rest),
    }
}

fn explicit(given: &[f64], intervals: u32) -> Result<Form, DomainError> {
    if given.len() as u64 + 1 != u64::from(intervals) {
        return Err(error(format!(
            "{} {} {} intervals, and the side has {intervals}; drop the interval count or make them \
             agree",
            counted(given.len(), "parameter"),
            if given.len() == 1 { "makes" } else { "make" },
            given.len() + 1
        )));
    }
    let mut previous = 0.0;
    for (index, &value) in given.iter().enumerate() {
        let place = || Place::key("spacing").then("parameters").then(index);
        if !(value > 0.0 && value < 1.0) {
            return Err(place().error(format!(
                "parameter {} is {value:?}; parameters are shares of the side, above 0 and below \
                     1",
                index + 1
            )));
        }
        if value <= previous {
            return Err(place().error(format!(
                "parameter {} ({value:?}) is not above the one before ({previous:?}); parameters \
                     must increase",
                index + 1
            )));
        }
        previous = value;
    }
    Ok(Form::Parameters(given.into()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn solve(spacing: Spacing, intervals: u32) -> SpacingLaw {
        SpacingLaw::solve(&spacing, intervals, 1.0).unwrap()
    }

    /// Nodes of a unit line meshed by Gmsh 4.15.2 (`setTransfiniteCurve`, 7 nodes, integration
    /// precision 1e-12), which integrates the same laws numerically.
    #[test]
    fn agrees_with_gmsh() {
        #[rustfmt::skip]
        let table = [
            ("geometric:1.3", [0.078_394_297_5, 0.180_306_882_0, 0.312_793_242_1, 0.485_025_511_0, 0.708_927_461_7]),
            ("bump:0.1", [0.058_668_638_9, 0.214_651_625_2, 0.500_000_000_0, 0.785_348_374_8, 0.941_331_361_1]),
            ("bump:5", [0.272_597_522_6, 0.403_307_460_8, 0.500_000_000_0, 0.596_692_539_2, 0.727_402_477_4]),
            ("beta:1.05", [0.040_990_378_1, 0.112_914_435_1, 0.233_664_022_6, 0.422_099_245_3, 0.685_052_806_9]),
            ("beta:1.5", [0.121_939_222_7, 0.264_522_537_9, 0.427_050_983_3, 0.607_020_896_4, 0.800_017_926_7]),
            ("beta:-1.05", [0.314_947_193_1, 0.577_900_754_7, 0.766_335_977_4, 0.887_085_564_9, 0.959_009_621_9]),
        ];
        for (text, expected) in table {
            let law = solve(text.parse().unwrap(), 6);
            for (i, expected) in (1..).zip(expected) {
                assert!((law.parameter(i) - expected).abs() < 1e-8, "{text}, point {i}");
            }
        }
    }

    /// To first order in r - 1, t = u + (r - 1) m u (u - 1)/2: the rest, of second order, is below
    /// the digits compared.
    #[test]
    fn geometric_is_accurate_next_to_ratio_1() {
        for excess in [f64::EPSILON, -f64::EPSILON, 1e-14, -1e-14] {
            let (m, i) = (1_000_000, 300_000);
            let ratio = 1.0 + excess;
            let law = solve(Spacing::Geometric { ratio }, m);
            let u = f64::from(i) / f64::from(m);
            let expected = (ratio - 1.0) * f64::from(m) * u * (u - 1.0) / 2.0;
            let departure = law.parameter(i) - u;
            assert!((departure - expected).abs() < 1e-15, "{departure:e}, not {expected:e}");
        }
    }

    #[test]
    fn a_given_length_is_met() {
        for (length, side_length, m) in [
            (0.01, 1.0, 20),
            (1e-6, 3.0, 200),
            (0.9, 1.0, 7),
            (0.1, 1.0, 10),
            (0.1 + 1e-12, 1.0, 10),
            (1.0 - 1e-11, 1.0, 2),
            (2e-12, 1.0, 2),
            (1e-9, 1.0, 4_000_000_000),
            (5.0, 20.0, 4),
        ] {
            let first = SpacingLaw::solve(&Spacing::FirstLength(length), m, side_length).unwrap();
            let found = first.parameter(1) * side_length;
            assert!((found - length).abs() < 1e-14 * length, "{found}, not {length}");
            let last = SpacingLaw::solve(&Spacing::LastLength(length), m, side_length).unwrap();
            let found = (1.0 - last.parameter(m - 1)) * side_length;
            assert!((found - length).abs() < 1e-15 * side_length, "{found}, not {length}");
        }
        assert_eq!(
            SpacingLaw::solve(&Spacing::FirstLength(2.0), 1, 2.0).unwrap().parameter(1),
            1.0
        );
    }

    #[test]
    fn refuses_with_the_reason() {
        let least = "of the side's length, less than 1e-12; use fewer intervals or a gentler law";
        for (spacing, m, message) in [
            (
                Spacing::Geometric { ratio: 0.0 },
                3,
                "the ratio is 0.0; it must be a finite number above 0",
            ),
            (
                Spacing::Geometric { ratio: -1.2 },
                3,
                "the ratio is -1.2; it must be a finite number above 0",
            ),
            (
                Spacing::Bump { ratio: f64::NAN },
                3,
                "the ratio is NaN; it must be a finite number above 0",
            ),
            (
                Spacing::FirstLength(f64::INFINITY),
                3,
                "the first length is inf; it must be a finite number above 0",
            ),
            (
                Spacing::Beta { beta: 1.0 },
                3,
                "beta is 1.0; it must be above 1 (points crowd at the side's start) or below -1 (at its end)",
            ),
            (
                Spacing::FirstLength(7.0),
                3,
                "an interval of length 7 leaves nothing of the side's 4 for the other 2 intervals; give a shorter length or 1 interval",
            ),
            (
                Spacing::LastLength(3.0),
                1,
                "the side is a single interval of length 4.0, not 3.0; use more intervals or drop the law",
            ),
            (
                Spacing::Parameters(vec![0.5]),
                3,
                "1 parameter makes 2 intervals, and the side has 3; drop the interval count or make them agree",
            ),
            (
                Spacing::Parameters(vec![0.5, 1.0]),
                3,
                "parameter 2 is 1.0; parameters are shares of the side, above 0 and below 1",
            ),
            (
                Spacing::Parameters(vec![0.5, 0.5]),
                3,
                "parameter 2 (0.5) is not above the one before (0.5); parameters must increase",
            ),
            (
                Spacing::Geometric { ratio: 1.5 },
                5000,
                &format!("interval 1 of 5000 would be 0 {least}"),
            ),
            (
                Spacing::Geometric { ratio: 1e-300 },
                2,
                &format!("interval 2 of 2 would be 0 {least}"),
            ),
            (Spacing::Bump { ratio: 1e300 }, 5, &format!("interval 3 of 5 would be 0 {least}")),
            (
                Spacing::FirstLength(f64::MIN_POSITIVE),
                3,
                &format!("interval 1 of 3 would be 5.563e-309 {least}"),
            ),
        ] {
            let error = SpacingLaw::solve(&spacing, m, 4.0).unwrap_err();
            assert_eq!(error.to_string(), message);
        }
    }

    /// Extreme laws, some of which are refused.
    fn any_law() -> impl Strategy<Value = Spacing> {
        let size = (-30.0..30.0_f64).prop_map(f64::exp);
        prop_oneof![
            Just(Spacing::Uniform),
            size.clone().prop_map(|ratio| Spacing::Geometric { ratio }),
            (-0.2..0.2).prop_map(|excess| Spacing::Geometric { ratio: 1.0 + excess }),
            size.clone().prop_map(|ratio| Spacing::Bump { ratio }),
            (size.clone(), any::<bool>()).prop_map(|(excess, start)| Spacing::Beta {
                beta: if start { 1.0 + excess } else { -1.0 - excess }
            }),
            (0.0..1.0).prop_map(Spacing::FirstLength),
            size.prop_map(Spacing::LastLength),
            proptest::collection::btree_set(1..1_000_000_u32, 0..40).prop_map(|points| {
                Spacing::Parameters(points.into_iter().map(|t| f64::from(t) / 1e6).collect())
            }),
        ]
    }

    proptest! {
        #[test]
        fn parameters_increase_and_the_shortest_interval_is_found(
            spacing in any_law(), m in 1..3000_u32,
        ) {
            let m = if let Spacing::Parameters(given) = &spacing { given.len() as u32 + 1 } else { m };
            if let Ok(law) = SpacingLaw::solve(&spacing, m, 1.0) {
                let points: Vec<f64> = (0..=m).map(|i| law.parameter(i)).collect();
                prop_assert_eq!((points[0], points[m as usize]), (0.0, 1.0));
                let shortest = points.windows(2).map(|t| t[1] - t[0]).fold(1.0, f64::min);
                prop_assert!(shortest > 0.0);
                prop_assert!((law.shortest().1 - shortest).abs() <= 1e-14);
            }
        }

        #[test]
        fn reversing_mirrors_the_points(spacing in any_law(), m in 1..300_u32) {
            let m = if let Spacing::Parameters(given) = &spacing { given.len() as u32 + 1 } else { m };
            let law = SpacingLaw::solve(&spacing, m, 1.0);
            let back = SpacingLaw::solve(&spacing.reversed(), m, 1.0);
            if let (Ok(law), Ok(back)) = (law, back) {
                for i in 0..=m {
                    let there = law.parameter(i) + back.parameter(m - i);
                    prop_assert!((there - 1.0).abs() < 1e-13, "point {}: {}", i, there);
                }
            }
        }
    }
}
