//! The change of counts that lifts the limit of the minimum angle.

use mindeg_core::Change;
use mindeg_domain::{Domain, Interior, Intervals, Side};

use super::limit::{AngleLimit, Cause, angle_limit};

/// A change of interval counts, and the limit after it.
#[derive(Clone, Debug, PartialEq)]
pub struct Lift {
    /// The sides to change.
    pub changes: Vec<Change>,
    /// The intervals of these sides after the change.
    pub intervals: Vec<u64>,
    /// The limit after the change, in degrees, at the domain's degree limits.
    pub min_angle: f64,
    /// The feature that decides the limit after the change.
    pub cause: Cause,
    /// The domain after the change.
    pub domain: Domain,
}

/// With more boundary vertices the search for a change is skipped: each try visits all vertices.
const MOST_VERTICES: u32 = 20_000;
/// A change that makes the boundary of more than [`FEW`] vertices this many times longer helps nobody, and takes long to look at.
const MOST_LONGER: u64 = 4;
/// Boundaries up to this number of vertices always count as short.
const FEW: u64 = 1000;
/// The most counts that are tried for one side.
const MOST_TRIES: u32 = 24;
/// A change that brings less than this factor is not worth it.
const WORTH: f64 = 1.02;
/// A larger limit than this, in degrees, is not looked for.
const ENOUGH: f64 = 30.0;

/// The smallest change of the counts of the side or sides that decide a domain's limit which
/// brings it to 30 degrees, or nine tenths of the way to what any such change can bring; none if that is
/// nothing, or for domains of more than 20,000 boundary vertices. Only changes to at most 1,000 boundary
/// vertices, or four times as many as before, are looked at.
///
/// Constraints stay on their vertices' indices. Takes up to about 75 times as long as
/// [`angle_limit`] of the changed domains.
pub fn lift(domain: &Domain, wanted: &Interior, limit: &AngleLimit) -> Option<Lift> {
    if domain.rings().vertex_count() > MOST_VERTICES {
        return None;
    }
    let tried: Vec<Lift> = candidates(domain, &limit.cause)
        .into_iter()
        .filter(|counts| is_short(domain, counts))
        .filter_map(|counts| changed(domain, wanted, &counts))
        .collect();
    let best = tried.iter().map(|lift| lift.min_angle).fold(0.0, f64::max);
    if best < WORTH * limit.min_angle {
        return None;
    }
    let near_best = limit.min_angle + 0.9 * (best - limit.min_angle);
    let enough = near_best.min(ENOUGH.max(WORTH * limit.min_angle));
    let good = tried.into_iter().filter(|lift| lift.min_angle >= enough);
    good.min_by(|a, b| cost(domain, a).total_cmp(&cost(domain, b)))
}

/// How much a change changes: the logarithms of the ratios of counts. To lose points costs more than to
/// get some.
fn cost(domain: &Domain, lift: &Lift) -> f64 {
    let of = |(change, count): (&Change, &u64)| {
        let ratio = *count as f64 / f64::from(domain.rings().intervals(change.side));
        if ratio >= 1.0 { libm::log(ratio) } else { -3.0 * libm::log(ratio) }
    };
    lift.changes.iter().zip(&lift.intervals).map(of).sum()
}

/// Whether the boundary stays short enough with other counts: where an interval is very short beside its
/// neighbour, what would lift the limit is without bound.
fn is_short(domain: &Domain, counts: &[(usize, u64)]) -> bool {
    let vertices = u64::from(domain.rings().vertex_count());
    let more = |(side, count): &(usize, u64)| {
        count.saturating_sub(u64::from(domain.rings().intervals(*side)))
    };
    let more = counts.iter().map(more).fold(0, u64::saturating_add);
    vertices.saturating_add(more) <= FEW.max(MOST_LONGER * vertices)
}

/// Counts to try, each as a list of sides with their new counts.
fn candidates(domain: &Domain, cause: &Cause) -> Vec<Vec<(usize, u64)>> {
    let count = |side: usize| u64::from(domain.rings().intervals(side));
    match cause {
        Cause::Corner { corner, side_before, lengths: [before, after], .. } => {
            let ratio = (before / after).max(after / before);
            let (long, short) =
                if before > after { (*side_before, *corner) } else { (*corner, *side_before) };
            let finer = spread(count(long), (count(long) as f64 * ratio * 1.2).ceil() as u64 + 1);
            let coarser = spread(count(short), (count(short) as f64 / ratio / 1.2).floor() as u64);
            let rings = domain.rings();
            // The side with short intervals may press on its other neighbour as much.
            let other = match rings.next_side(short) == long {
                true => rings.previous_side(short),
                false => rings.next_side(short),
            };
            let length =
                |side: usize, count: u64| domain.placement().side_length(side) / count as f64;
            let alike = |of_long: u64| {
                let of_other = domain.placement().side_length(other) / length(long, of_long);
                let of_other = (of_other.ceil() as u64).max(count(other));
                vec![(long, of_long), (other, of_other)]
            };
            let both: Vec<_> = match other == long || other == short {
                true => Vec::new(),
                false => finer.iter().map(|count| alike(*count)).collect(),
            };
            let finer = finer.into_iter().map(|count| vec![(long, count)]);
            let coarser = coarser.into_iter().map(|count| vec![(short, count)]);
            finer.chain(both).chain(coarser).collect()
        }
        Cause::Vertex { side: None, .. } => Vec::new(),
        Cause::Vertex { side: Some(side), .. } => {
            let finer = spread(count(*side), count(*side).saturating_mul(8));
            finer.into_iter().map(|count| vec![(*side, count)]).collect()
        }
        Cause::Facing { sides, .. } => {
            let mut sides: Vec<usize> = sides.iter().copied().flatten().collect();
            sides.dedup();
            let factor = |step: u32| 1.0 + f64::from(step) / 4.0;
            let times =
                |side: usize, factor: f64| (side, (count(side) as f64 * factor).ceil() as u64);
            let all = |step| sides.iter().map(|side| times(*side, factor(step))).collect();
            (1..=MOST_TRIES).map(all).filter(|counts: &Vec<_>| !counts.is_empty()).collect()
        }
    }
}

/// Counts from one next to `from` to `to`, at most so many as are tried, densest at `from`.
fn spread(from: u64, to: u64) -> Vec<u64> {
    let to = to.max(1);
    let all = from.abs_diff(to);
    let mut steps: Vec<u64> = if all <= u64::from(MOST_TRIES) {
        (1..=all).collect()
    } else {
        let share = |i: u32| f64::from(i) / f64::from(MOST_TRIES);
        let step = |i| libm::round(libm::pow(all as f64, share(i))) as u64;
        (1..=MOST_TRIES).map(step).collect()
    };
    steps.dedup();
    steps.into_iter().map(|step| if to > from { from + step } else { from - step }).collect()
}

/// The domain with other counts, if it is one, and its limit.
fn changed(domain: &Domain, wanted: &Interior, counts: &[(usize, u64)]) -> Option<Lift> {
    let mut sides: Vec<Side> = domain.sides().to_vec();
    for (side, count) in counts {
        sides[*side].intervals = Intervals::Count(*count);
    }
    let changed = domain.with_sides(sides).ok()?;
    let limit = angle_limit(&changed, wanted).ok()?;
    let by = |(side, count): &(usize, u64)| Change {
        side: *side,
        by: *count as i64 - i64::from(domain.rings().intervals(*side)),
    };
    Some(Lift {
        changes: counts.iter().map(by).filter(|change| change.by != 0).collect(),
        intervals: counts
            .iter()
            .filter(|(side, count)| *count != u64::from(domain.rings().intervals(*side)))
            .map(|(_, count)| *count)
            .collect(),
        min_angle: limit.min_angle,
        cause: limit.cause,
        domain: changed,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use mindeg_domain::Spacing;

    fn lifted(width: f64, height: f64, counts: [u64; 4]) -> Option<(AngleLimit, Lift)> {
        let domain = Domain::rectangle(width, height, counts.map(Side::count).into()).unwrap();
        let limit = angle_limit(&domain, &Interior::default()).unwrap();
        let lift = lift(&domain, &Interior::default(), &limit)?;
        let again = angle_limit(&lift.domain, &Interior::default()).unwrap();
        assert_eq!(again.min_angle, lift.min_angle);
        assert!(lift.min_angle > limit.min_angle);
        Some((limit, lift))
    }

    #[test]
    fn counts_that_press_are_changed() {
        // Side 4 is coarse between two fine ones.
        let (limit, lift) = lifted(4.0, 4.0, [16, 16, 16, 2]).unwrap();
        assert_eq!(lift.changes.len(), 1);
        assert_eq!(lift.changes[0].side, 3);
        assert!(lift.changes[0].by > 0 && lift.min_angle > 1.2 * limit.min_angle, "{lift:?}");
        // A fine side between two coarse ones: both get more.
        let (_, lift) = lifted(4.0, 4.0, [2, 16, 2, 2]).unwrap();
        let mut sides: Vec<usize> = lift.changes.iter().map(|change| change.side).collect();
        sides.sort_unstable();
        assert_eq!(sides, [0, 2], "{lift:?}");
        assert!(lift.changes.iter().all(|change| change.by > 0), "{lift:?}");
        // A narrow strip needs shorter intervals on both long sides.
        let (_, lift) = lifted(40.0, 0.2, [100, 1, 100, 1]).unwrap();
        assert_eq!(lift.changes.iter().map(|change| change.side).collect::<Vec<_>>(), [0, 2]);
        // Nothing to gain.
        assert!(lifted(4.0, 4.0, [4; 4]).is_none());
    }

    /// The first layer of a mesh for flow along a wall: what would lift the limit to 30 degrees are hundreds of
    /// thousands of intervals, and each of the 48 changes that were tried took as long.
    #[test]
    fn changes_stay_short_beside_very_short_intervals() {
        let layers = |spacing| Side::count(60).spaced(spacing);
        let sides = vec![
            Side::count(10),
            layers(Spacing::FirstLength(1e-6)),
            Side::count(10),
            layers(Spacing::LastLength(1e-6)),
        ];
        let domain = Domain::rectangle(1.0, 0.1, sides).unwrap();
        let limit = angle_limit(&domain, &Interior::default()).unwrap();
        let found = lift(&domain, &Interior::default(), &limit);
        let longest = found.map_or(0, |lift| lift.domain.rings().vertex_count());
        assert!(longest <= 1000, "{longest}");
    }

    #[test]
    fn counts_to_try_start_beside_what_there_is() {
        assert_eq!(spread(5, 8), [6, 7, 8]);
        assert_eq!(spread(5, 0), [4, 3, 2, 1]);
        assert_eq!(spread(3, 3), [] as [u64; 0]);
        let many = spread(10, 10_000);
        assert!(many.len() <= 24 && many.starts_with(&[11]) && many.ends_with(&[10_000]));
        assert!(many.windows(2).all(|pair| pair[0] < pair[1]));
    }
}
