//! Which of several meshes is better, and when one is good enough.

use crate::limits::Limits;
use crate::options::{InteriorError, Options};
use crate::report::{ENOUGH, InteriorReport};
use mindeg_domain::Prefer;

/// The angle aimed at where neither the boundary nor the user says otherwise, in degrees.
const FLOOR: f64 = 36.0;
/// With at least this share of the limit and no violation, the search ends.
const GOOD_SHARE: f64 = 0.98;
/// Larger meshes with more than [`FEW`] triangles left to be desired are begun once: a further start takes as long as the
/// first, and helps little where each place was worked on.
const SMALL: usize = 300;
/// The same where a degree is out of its range.
const SMALL_BROKEN: usize = 600;
/// So few triangles and violations are worth further starts of a large mesh, too.
const FEW: usize = 20;
/// After so many starts in a row that brought little, no other is made for them.
const MOST_IN_VAIN: u32 = 2;
/// A share greater by this is little.
const LITTLE: f64 = 0.003;
/// Larger meshes are begun once in any case.
const MOST_TRIANGLES: usize = 400_000;

/// The angle that the optimiser aims at.
pub(crate) fn floor(options: &Options) -> f64 {
    options.wanted.target_angle.map_or(FLOOR, |angle| (angle + 1.0).max(FLOOR))
}

/// The angle from which on nothing is left to be desired.
pub(crate) fn enough(options: &Options) -> f64 {
    options.wanted.target_angle.unwrap_or(ENOUGH)
}

/// The proven limit that counts, and the vertex that decides it: angles that are preferred may cost degrees.
fn limit(limits: &Limits, options: &Options) -> (f64, u32) {
    match options.wanted.prefer() {
        Prefer::Degree => (limits.angle(), limits.vertex()),
        Prefer::Angle => (limits.angle_at_any_degree(), limits.vertex_at_any_degree()),
    }
}

/// Refuses a target that is proven impossible.
pub(crate) fn check_target(limits: &Limits, options: &Options) -> Result<(), InteriorError> {
    let (limit, vertex) = limit(limits, options);
    match options.wanted.target_angle {
        Some(target) if target > limit => {
            Err(InteriorError::TargetAboveLimit { target, limit, vertex })
        }
        _ => Ok(()),
    }
}

/// The share reached of what the limit, the target, and sense allow.
fn share(report: &InteriorReport, options: &Options) -> f64 {
    let (limit, _) = limit(&report.limits, options);
    (report.min_angle / limit.min(enough(options))).min(1.0)
}

/// True if further search is not worth its time.
pub(crate) fn is_enough(report: &InteriorReport, options: &Options) -> bool {
    let wanted = if options.wanted.target_angle.is_some() { 1.0 } else { GOOD_SHARE };
    let degrees = report.violations.is_empty() || options.wanted.prefer() == Prefer::Angle;
    let is_good = degrees && share(report, options) >= wanted;
    is_good || report.triangles > MOST_TRIANGLES
}

/// True if another start takes longer than it is worth, after so many in a row that brought little.
pub(crate) fn is_large(report: &InteriorReport, in_vain: u32) -> bool {
    let left = report.local.below + report.violations.len();
    let most = if report.violations.is_empty() { SMALL } else { SMALL_BROKEN };
    report.triangles > most && left > FEW || report.triangles > SMALL && in_vain >= MOST_IN_VAIN
}

/// By how much a mesh is better than another.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Gain {
    /// It is not better.
    None,
    /// By no violation less, and hardly by its share of the limit.
    Little,
    /// By a violation less, or clearly by its share.
    Much,
}

/// Compares a mesh with the one before.
pub(crate) fn gain(after: &InteriorReport, before: &InteriorReport, options: &Options) -> Gain {
    let [new, old] = [after, before].map(|report| rank(report, options));
    let grows = share(after, options) > share(before, options) + LITTLE;
    if new >= old {
        Gain::None
    } else if after.violations.len() < before.violations.len() || grows {
        Gain::Much
    } else {
        Gain::Little
    }
}

/// A key that is less for a better mesh.
pub(crate) fn rank(report: &InteriorReport, options: &Options) -> [f64; 3] {
    let (lack, wrong) = (1.0 - share(report, options), report.violations.len() as f64);
    match options.wanted.prefer() {
        Prefer::Degree => [wrong, lack, report.triangles as f64],
        // Shares that differ by less than a hundredth are alike.
        Prefer::Angle => [libm::floor(lack * 100.0), wrong, lack],
    }
}
