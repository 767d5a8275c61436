//! The way from the first triangulations of faces to a small joint degree, and the proof of how small it can be.

use mindeg_mesh::{Cancelled, Progress};

use super::bound::{self, JointBound};
use super::descent::{Descent, LEVEL_STEPS, STEPS_PER_VERTEX};
use super::joint::Joint;
use super::{annealed, polish, search};

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
    if descent.reach(target + 1, steps)? {
        // A short try, then the dearer bound, and only then a long try.
        if !descent.reach(target, steps / 16)? {
            bound = bound::with_weights(descent.joint(), bound, progress)?;
            // Most degrees that a search decides, it decides soon.
            bound = search::close(descent.joint_mut(), bound, limit, effort / 16.0, progress)?;
            let joint = descent.joint_mut();
            if bound.max_degree() <= target
                && joint.max_degree() > target
                && !annealed::reach(joint, target, effort, progress)?
            {
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
    bound = search::close(joint, bound, limit, effort, progress)?;
    polish::polish(joint, progress)?;
    Ok(bound)
}
