//! Which degree to take.

use mindeg::exact::TradeOff;

use crate::advice::KEPT;
use crate::numbers::{percent, steady_angle};

/// Which degree to take, and what the least costs, in a sentence or two.
///
/// The rule is that of `mindeg mesh --keep-angle 95%`: the smallest degree that keeps [`KEPT`] of the minimum
/// angle of a Delaunay triangulation. `delaunay_max_degree` is the maximum degree of one.
#[must_use]
pub fn trade_off(trade_off: &TradeOff, delaunay_max_degree: Option<u32>) -> String {
    let meshes = trade_off.meshes();
    let kept = meshes.iter().find(|exact| trade_off.share(exact) >= KEPT);
    let (Some(least), Some(taken)) = (meshes.first(), kept.or(meshes.last())) else {
        return String::new();
    };
    let instead = match delaunay_max_degree {
        Some(degree) if degree > taken.max_degree => format!(" instead of {degree}"),
        _ => String::new(),
    };
    let take = format!(
        "Take degree {}: {} of Delaunay's minimum angle, {}, with at most {} edges at a vertex{instead}.",
        taken.max_degree,
        percent(trade_off.share(taken).min(1.0)),
        steady_angle(taken.min_angle),
        taken.max_degree,
    );
    let rest = if least.max_degree == taken.max_degree {
        "No mesh has a smaller maximum degree.".to_owned()
    } else {
        format!(
            "Degree {} keeps {}, {}: degree {} has {:.1} times the minimum angle.",
            least.max_degree,
            percent(trade_off.share(least)),
            steady_angle(least.min_angle),
            taken.max_degree,
            taken.min_angle / least.min_angle,
        )
    };
    // Windows leave it open whether a smaller degree is possible.
    if trade_off.is_exact() || least.max_degree < taken.max_degree {
        format!("{take} {rest}")
    } else {
        take
    }
}

/// The index of the point farthest above the straight line from the first to the last, if one is above it: where
/// a curve of degrees and angles bends most.
#[must_use]
pub fn knee(points: &[(f64, f64)]) -> Option<usize> {
    let (&(first_x, first_y), &(last_x, last_y)) = (points.first()?, points.last()?);
    // Twice the area of the triangle of the three: the farthest has the largest.
    let above = |&(x, y): &(f64, f64)| {
        (y - first_y) * (last_x - first_x) - (x - first_x) * (last_y - first_y)
    };
    let heights = points.iter().map(above).enumerate().filter(|&(_, height)| height > 0.0);
    // Of several, the least degree.
    heights.rev().max_by(|(_, a), (_, b)| a.total_cmp(b)).map(|(row, _)| row)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_knee_is_where_the_curve_bends_most() {
        let curve = |angles: &[f64]| -> Vec<(f64, f64)> {
            (4..).map(f64::from).zip(angles.iter().copied()).collect()
        };
        assert_eq!(knee(&curve(&[0.1, 2.0, 2.05, 2.07])), Some(1));
        assert_eq!(knee(&curve(&[1.0, 2.0, 3.0, 3.0, 3.0])), Some(2));
        for none in [&[][..], &[1.0], &[1.0, 2.0], &[1.0, 2.0, 3.0], &[1.0, 1.1, 3.0]] {
            assert_eq!(knee(&curve(none)), None, "{none:?}");
        }
    }
}
