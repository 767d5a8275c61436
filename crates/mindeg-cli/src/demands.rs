//! What a user demanded of a mesh with interior points, and whether it was reached.

use crate::failure::Failure;
use crate::interior_report::violations;
use mindeg::Interior;
use mindeg::interior::Report;
use mindeg_answers::numbers::steady_angle;

/// The aims that were given; what was left out has a default, which is no demand.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Demands {
    interior_degree: bool,
    boundary_degree: bool,
    target_angle: Option<f64>,
}

impl Demands {
    pub(crate) fn of(wanted: &Interior, has_degree_limits: bool) -> Self {
        Self {
            interior_degree: wanted.interior_degree.is_some(),
            boundary_degree: wanted.boundary_degree.is_some() || has_degree_limits,
            target_angle: wanted.target_angle,
        }
    }

    /// What was demanded and not reached, as a failed gate.
    pub(crate) fn check(&self, report: &Report) -> Result<(), Failure> {
        let mut lacking = Vec::new();
        if let Some(target) = self.target_angle.filter(|target| report.min_angle < *target) {
            lacking.push(format!(
                "the minimum angle reached is {}, below the {target}° demanded",
                steady_angle(report.min_angle)
            ));
        }
        let mut demanded = report.clone();
        demanded.violations.retain(|violation| match violation.is_boundary {
            true => self.boundary_degree,
            false => self.interior_degree,
        });
        lacking.extend(violations(&demanded));
        if lacking.is_empty() { Ok(()) } else { Err(Failure::Gate(lacking.join("; "))) }
    }
}
