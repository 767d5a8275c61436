//! From a polygon of a file to a domain.

use mindeg_domain::{Domain, DomainError, OutlineError, Ring, Side};
use thiserror::Error;

use super::outline::Feature;
use super::sides::{DividedSide, Division, SizeTooSmall};

/// Why a polygon of a file is no domain.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum FeatureError {
    /// A size that makes too many points.
    #[error(transparent)]
    Size(#[from] SizeTooSmall),
    /// Rings that are not those of a domain.
    #[error(transparent)]
    Domain(#[from] DomainError),
}

impl FeatureError {
    /// Whether rings cross, touch or repeat points, which [`Outlines::repaired`] may mend.
    ///
    /// [`Outlines::repaired`]: super::Outlines::repaired
    #[must_use]
    pub fn is_touch(&self) -> bool {
        use OutlineError::{CoincidentCorners, RepeatedCorner};
        match self {
            Self::Domain(DomainError::Intersection(_)) => true,
            Self::Domain(DomainError::Outline(error)) => {
                matches!(error, CoincidentCorners { .. } | RepeatedCorner { .. })
            }
            _ => false,
        }
    }
}

impl Feature {
    /// The domain inside the outer ring and outside the holes.
    ///
    /// # Errors
    ///
    /// A size that makes too many points; rings that cross or touch, and everything else that
    /// [`Domain::of_rings`] refuses.
    pub fn domain(&self, division: &Division) -> Result<Domain, FeatureError> {
        let mut rings = Vec::with_capacity(self.rings.len());
        for ring in &self.rings {
            rings.push(domain_ring(ring.divided(division)?));
        }
        let domain = Domain::of_rings(rings)?;
        match &self.name {
            Some(name) => Ok(domain.named(clean(name))?),
            None => Ok(domain),
        }
    }
}

fn domain_ring(sides: Vec<DividedSide>) -> Ring {
    let mut ring = Ring::default();
    for side in sides {
        let count = if side.is_line { side.points.len() as u64 } else { 1 };
        let corners = if side.is_line { &side.points[..1] } else { &side.points };
        for &corner in corners {
            ring.corners.push(corner);
            ring.sides.push(Side::count(count));
        }
    }
    ring
}

/// A name without the characters that a domain refuses.
fn clean(name: &str) -> String {
    let is_refused = |c: char| {
        c.is_control()
            || matches!(c, '\u{2028}' | '\u{2029}' | '\u{61c}' | '\u{200e}' | '\u{200f}')
            || matches!(c, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
    };
    name.replace(is_refused, " ").trim().to_owned()
}
