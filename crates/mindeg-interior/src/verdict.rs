//! Which of several meshes is better, and when one is good enough.

use crate::goal::MOST;
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
const SMALL: usize = 400;
/// The same where a degree is out of its range.
const SMALL_BROKEN: usize = 600;
/// So few triangles and violations are worth further starts of a large mesh, too.
const FEW: usize = 20;
/// After so many starts in a row that brought little, no other is made for them.
const MOST_IN_VAIN: u32 = 2;
/// Starts of smaller meshes hardly differ.
const TINY: usize = 48;
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

/// No limit of a place counts for more than this.
pub(crate) fn counted(options: &Options) -> f64 {
    enough(options).clamp(ENOUGH, MOST)
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
    let limit = limit(&report.limits, options).0.min(report.least_of_edges);
    (report.min_angle / limit.min(enough(options))).min(1.0)
}

/// True if further search is not worth its time.
pub(crate) fn is_enough(report: &InteriorReport, options: &Options) -> bool {
    let wanted = if options.wanted.target_angle.is_some() { 1.0 } else { GOOD_SHARE };
    let degrees = report.violations.is_empty() || options.wanted.prefer() == Prefer::Angle;
    let is_good = degrees && report.outside == 0 && share(report, options) >= wanted;
    is_good || report.triangles > MOST_TRIANGLES
}

/// True if another start takes longer than it is worth, after so many in a row that brought little.
pub(crate) fn is_large(report: &InteriorReport, in_vain: u32) -> bool {
    let left = report.local.below + report.violations.len();
    let most = if report.violations.is_empty() { SMALL } else { SMALL_BROKEN };
    let starts_differ = TINY < report.triangles && report.triangles <= SMALL;
    report.triangles > most && left > FEW || !starts_differ && in_vain >= MOST_IN_VAIN
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
    let (lack, wrong) =
        (1.0 - share(report, options), (report.violations.len() + report.outside) as f64);
    match options.wanted.prefer() {
        Prefer::Degree => [wrong, lack, report.triangles as f64],
        // Shares that differ by less than a hundredth are alike.
        Prefer::Angle => [libm::floor(lack * 100.0), wrong, lack],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::Violation;
    use crate::{generate, samples};
    use glam::DVec2;
    use mindeg_mesh::Progress;

    /// A mesh with these figures; its limit is 45 degrees.
    fn report(triangles: usize, below: usize, violations: usize, min_angle: f64) -> InteriorReport {
        let outline = samples::rectangle(4.0, 3.0, [8, 6, 8, 6]);
        let found = generate(&outline, &Options::default(), Progress::NONE).unwrap();
        let violation = Violation { vertex: 0, at: DVec2::ZERO, degree: 8, is_boundary: false };
        let mut report = found.report;
        (report.triangles, report.min_angle, report.local.below) = (triangles, min_angle, below);
        report.violations = vec![violation; violations];
        report
    }

    #[test]
    fn a_large_mesh_is_begun_anew_only_while_little_is_left_and_starts_pay() {
        for (triangles, below, violations, in_vain, ends) in [
            // Tiny ones until two starts in a row bring little, and small ones always.
            (48, 9, 1, 1, false),
            (48, 9, 1, 2, true),
            (49, 9, 1, 2, false),
            (400, 400, 0, 9, false),
            // Larger ones with few triangles left to be desired, until two starts in a row bring little.
            (401, 21, 0, 0, true),
            (401, 20, 0, 1, false),
            (401, 0, 0, 2, true),
            // With violations up to one and a half times the size.
            (600, 20, 1, 0, false),
            (600, 0, 1, 2, true),
            (601, 20, 1, 0, true),
            (601, 19, 1, 0, false),
        ] {
            let found = is_large(&report(triangles, below, violations, 20.0), in_vain);
            assert_eq!(found, ends, "{triangles} {below} {violations} {in_vain}");
        }
    }

    #[test]
    fn a_gain_is_much_with_a_violation_less_or_a_share_that_counts() {
        let before = report(500, 10, 1, 20.0);
        for (triangles, violations, min_angle, expected) in [
            (500, 0, 19.0, Gain::Much),
            (500, 1, 20.2, Gain::Much),
            (500, 1, 20.05, Gain::Little),
            (499, 1, 20.0, Gain::Little),
            (500, 1, 20.0, Gain::None),
            (500, 2, 30.0, Gain::None),
            (500, 1, 19.9, Gain::None),
        ] {
            let found =
                gain(&report(triangles, 10, violations, min_angle), &before, &Options::default());
            assert_eq!(found, expected, "{triangles} {violations} {min_angle}");
        }
    }

    #[test]
    fn a_mesh_is_enough_near_its_limit_without_violations() {
        let is_enough = |violations, angle, options: &Options| {
            super::is_enough(&report(100, 0, violations, angle), options)
        };
        let [plain, target] = [None, Some(30.0)].map(|target_angle| {
            Options::from(crate::Interior { target_angle, ..crate::Interior::default() })
        });
        assert!(is_enough(0, 34.4, &plain) && !is_enough(0, 34.2, &plain));
        assert!(!is_enough(1, 40.0, &plain));
        assert!(is_enough(0, 30.0, &target) && !is_enough(0, 29.9, &target));
    }
}
