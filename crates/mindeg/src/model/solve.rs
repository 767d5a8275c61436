//! The way from the first triangulations of faces to a small joint degree, and the proof of how small it can be.

use mindeg_mesh::{Cancelled, Progress};

use super::bound::{self, JointBound};
use super::descent::{Descent, LEVEL_STEPS, STEPS_PER_VERTEX};
use super::joint::Joint;
use super::{annealed, polish, search};

/// The shares of the effort for a search by clauses and for annealing. Most degrees that one of them decides, it decides soon, so
/// they take turns; where annealing is needed, a search has no grip.
const TURNS: [[f64; 2]; 2] = [[1.0 / 16.0, 1.0 / 4.0], [1.0 / 4.0, 3.0 / 4.0]];

/// Brings the joint degree down, as far as the bound or `limit`, and then improves angles. `effort` is how long to look
/// for each degree.
pub(crate) fn solve(
    joint: &mut Joint,
    limit: u32,
    effort: f64,
    progress: Progress<'_>,
) -> Result<JointBound, Cancelled> {
    let mut bound = bound::cheap(joint);
    let target = bound.max_degree().max(limit);
    let most = LEVEL_STEPS.max(STEPS_PER_VERTEX * joint.totals.len() as u64);
    let steps = (most as f64 * effort.max(0.0)) as u64;
    let mut descent = Descent::new(joint, progress);
    let mut is_searched = false;
    if descent.reach(target + 1, steps)? {
        // A short try, then the dearer bound, and only then a long try.
        if !descent.reach(target, steps / 16)? {
            bound = bound::with_weights(descent.joint(), bound, progress)?;
            bound = in_turns(descent.joint_mut(), bound, limit, effort, progress)?;
            is_searched = true;
            if bound.max_degree() <= target {
                descent.reach(target, steps / 4)?;
            }
        }
    } else {
        let mut degree = descent.joint().max_degree();
        while degree > target + 2 && descent.reach(degree - 1, steps / 4)? {
            degree = descent.joint().max_degree();
        }
        bound = bound::with_weights(descent.joint(), bound, progress)?;
    }
    drop(descent);
    if !is_searched {
        bound = search::close(joint, bound, limit, effort, progress)?;
    }
    polish::polish(joint, progress)?;
    Ok(bound)
}

/// Decides whether the degree at the bound is possible, one above which has been reached, as far as the effort suffices.
fn in_turns(
    joint: &mut Joint,
    mut bound: JointBound,
    limit: u32,
    effort: f64,
    progress: Progress<'_>,
) -> Result<JointBound, Cancelled> {
    let target = bound.max_degree().max(limit);
    for [of_search, of_annealing] in TURNS {
        bound = search::close(joint, bound, limit, effort * of_search, progress)?;
        if joint.max_degree() <= target
            || bound.max_degree() > target
            || annealed::reach(joint, target, effort * of_annealing, progress)?
        {
            break;
        }
    }
    Ok(bound)
}
