//! How far a surface may be from another.

use mindeg::TriMesh;
use mindeg_mesh::Bounds;

/// A length, or a share of a part's diagonal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Tolerance {
    Length(f64),
    Share(f64),
}

impl Tolerance {
    /// Of remeshes, where none is given.
    pub(crate) const OF_REMESHES: Self = Self::Share(0.003);

    /// In units of length.
    pub(crate) fn of(self, part: &TriMesh) -> f64 {
        match self {
            Self::Length(length) => length,
            Self::Share(share) => {
                let bounds = Bounds::of_space(part.positions().iter().copied());
                share * bounds.map_or(0.0, |bounds| bounds.size().length())
            }
        }
    }
}

impl std::str::FromStr for Tolerance {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (number, is_share) = match text.trim().strip_suffix('%') {
            Some(number) => (number.trim(), true),
            None => (text.trim(), false),
        };
        let value: Option<f64> = number.parse().ok();
        let value = value.filter(|value| *value >= 0.0 && value.is_finite());
        let value = value.ok_or("give a length, 0 or more, such as 1e-6")?;
        Ok(if is_share { Self::Share(value / 100.0) } else { Self::Length(value) })
    }
}
