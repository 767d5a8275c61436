//! The spacing of a side's points: the laws a user can name.
//!
//! The names and meanings are those of the mesh generators that engineers know: `geometric` is
//! Gmsh's `Progression`, `bump` and `beta` are Gmsh's laws of the same names, `first_length` is the
//! first-cell height of boundary layer meshing. Gmsh integrates a size function numerically; here
//! each law is a closed form (`spacing_law.rs`).
//!
//! Limits: a law is a law along a straight side. An interval shorter than
//! `LEAST_SHARE` of its side is refused, since rounding would spoil it.

use std::str::FromStr;

use crate::error::{DomainError, Place};

/// A spacing law, in the direction of its side (counter-clockwise).
///
/// With `m` intervals, `u = i/m` and `t(u)` the share of the side before point `i`:
///
/// | law | parameter | definition |
/// |---|---|---|
/// | uniform | – | `t = u` |
/// | geometric | ratio `r > 0` | each interval is `r` times the one before: `t = (r^i - 1)/(r^m - 1)` |
/// | bump | ratio `c > 0` | interval length is a parabola along the side, `c` times as long at both ends as in the middle: `t = (1 - tanh((1-2u) w)/tanh w)/2` with `tanh w = √(1-c)`, and `tan` for `tanh` and `c-1` for `1-c` where `c > 1` |
/// | beta | `b > 1` | Roberts' stretching towards the start: `t = 1 - b tanh((1-u) artanh(1/b))`; the closer `b` to 1, the denser. A negative value stretches towards the end, as in Gmsh |
/// | first length, last length | length `h > 0` | the geometric law whose first (last) interval is `h` long |
/// | parameters | `t1 < t2 < …` | the points, in shares of the side |
///
/// An interval may not be shorter than [`LEAST_SHARE`](crate::LEAST_SHARE) of its side.
///
/// # Example
///
/// ```
/// use mindeg_domain::Spacing;
///
/// let spacing: Spacing = "geometric:1.2".parse()?;
/// assert_eq!(spacing, Spacing::Geometric { ratio: 1.2 });
/// # Ok::<(), mindeg_domain::DomainError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "json", derive(serde::Serialize, serde::Deserialize, schemars::JsonSchema))]
#[cfg_attr(feature = "json", serde(rename_all = "snake_case", deny_unknown_fields))]
pub enum Spacing {
    /// All intervals are equally long.
    #[default]
    Uniform,
    /// Each interval is `ratio` times as long as the one before.
    Geometric {
        /// Above 0; below 1 the intervals shrink.
        ratio: f64,
    },
    /// The intervals at both ends are `ratio` times as long as those in the middle.
    Bump {
        /// Above 0; below 1 the points crowd at both ends, above 1 in the middle.
        ratio: f64,
    },
    /// Roberts' stretching.
    Beta {
        /// Above 1: the points crowd at the start. Below -1: at the end.
        beta: f64,
    },
    /// A geometric law given by the length of the first interval, in the units of the domain.
    FirstLength(f64),
    /// A geometric law given by the length of the last interval, in the units of the domain.
    LastLength(f64),
    /// The interior points of the side, strictly increasing in (0, 1).
    Parameters(Vec<f64>),
}

impl Spacing {
    /// The same points seen from the other end of the side.
    ///
    /// # Example
    ///
    /// ```
    /// use mindeg_domain::Spacing;
    ///
    /// assert_eq!(Spacing::FirstLength(0.1).reversed(), Spacing::LastLength(0.1));
    /// assert_eq!(Spacing::Beta { beta: 1.1 }.reversed(), Spacing::Beta { beta: -1.1 });
    /// ```
    pub fn reversed(&self) -> Self {
        match self {
            Self::Uniform => Self::Uniform,
            Self::Geometric { ratio } => Self::Geometric { ratio: 1.0 / ratio },
            Self::Bump { ratio } => Self::Bump { ratio: *ratio },
            Self::Beta { beta } => Self::Beta { beta: -beta },
            Self::FirstLength(length) => Self::LastLength(*length),
            Self::LastLength(length) => Self::FirstLength(*length),
            Self::Parameters(given) => {
                Self::Parameters(given.iter().rev().map(|t| 1.0 - t).collect())
            }
        }
    }
}

/// Reads `uniform`, `geometric:1.2`, `bump:0.2`, `beta:1.05`, `first-length:0.01` or
/// `last-length:0.01`: the notation of the command line. Solving the law checks the value, since
/// that needs the side.
impl FromStr for Spacing {
    type Err = DomainError;

    fn from_str(text: &str) -> Result<Self, DomainError> {
        let unknown = || {
            Place::key("spacing").error(format!(
                    "\"{text}\" is not a spacing law; write uniform, geometric:RATIO, bump:RATIO, \
                     beta:BETA, first-length:LENGTH or last-length:LENGTH (explicit parameters need a \
                     domain file)"
                ))
        };
        let (law, value) = match text.split_once(':') {
            None => (text, None),
            Some((law, value)) => (law, Some(value.trim().parse::<f64>().map_err(|_| unknown())?)),
        };
        match (law.trim(), value) {
            ("uniform", None) => Ok(Self::Uniform),
            ("geometric", Some(ratio)) => Ok(Self::Geometric { ratio }),
            ("bump", Some(ratio)) => Ok(Self::Bump { ratio }),
            ("beta", Some(beta)) => Ok(Self::Beta { beta }),
            ("first-length", Some(length)) => Ok(Self::FirstLength(length)),
            ("last-length", Some(length)) => Ok(Self::LastLength(length)),
            _ => Err(unknown()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reads_the_command_line_notation() {
        for (text, spacing) in [
            ("uniform", Spacing::Uniform),
            ("geometric:1.2", Spacing::Geometric { ratio: 1.2 }),
            ("bump:0.2", Spacing::Bump { ratio: 0.2 }),
            ("beta:-1.05", Spacing::Beta { beta: -1.05 }),
            ("first-length:1e-3", Spacing::FirstLength(1e-3)),
            ("last-length: 2", Spacing::LastLength(2.0)),
        ] {
            assert_eq!(text.parse(), Ok(spacing));
        }
        for text in ["", "Uniform", "uniform:1", "geometric", "geometric:", "bump:a", "beta:1:2"] {
            let error = text.parse::<Spacing>().unwrap_err().to_string();
            assert!(error.starts_with(&format!("\"{text}\" is not a spacing law")), "{error}");
        }
    }
}
