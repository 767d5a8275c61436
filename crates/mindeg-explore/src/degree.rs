//! The least maximum degree in words, with what proves it.

use mindeg::exact::{DegreeAnswer, ExactError, LowerBound, degree};
use mindeg::{Domain, Progress};
use mindeg_compare::words;
use mindeg_core::Certificate;

use crate::api::DegreeShown;

/// The degree of a domain.
///
/// # Errors
///
/// Those of [`degree`].
pub(crate) fn shown(domain: &Domain, progress: Progress<'_>) -> Result<DegreeShown, ExactError> {
    if let Some(form) = domain.convex()
        && !domain.is_constrained()
    {
        let boundary = form.boundary();
        let proof = mindeg_core::certificate(boundary);
        let mut words = words::certificate(boundary, &proof);
        if form.first() > 0 || boundary.side_count() != domain.rings().side_count() {
            words.push_str(
                "Sides on one line count as one here, and each edge of a curve as a side.\n",
            );
        }
        let certificate = match proof {
            Certificate::BalancedCut { .. } => "balanced_cut",
            Certificate::MedialTriangle => "medial_triangle",
            Certificate::LongSide { .. } => "long_side",
            Certificate::NoBalancedCut { .. } => "no_balanced_cut",
        };
        let degree = proof.max_degree();
        let (chords, vertices) = (Vec::new(), Vec::new());
        let (at_least, reached) = (degree, degree);
        return Ok(DegreeShown { at_least, reached, words, certificate, chords, vertices });
    }
    let answer = degree(domain, progress)?;
    let DegreeAnswer { reached, at_least, bounded_by, .. } = &answer;
    let (certificate, chords, vertices) = match bounded_by {
        LowerBound::ClosedForm => ("closed_form", Vec::new(), Vec::new()),
        LowerBound::Counting => ("counting", Vec::new(), Vec::new()),
        LowerBound::BlockedZigZags(chords) => ("blocked_zig_zags", chords.clone(), Vec::new()),
        LowerBound::Apexes(bound) => ("apexes", Vec::new(), bound.apexes.clone()),
        _ => ("exhaustive", Vec::new(), Vec::new()),
    };
    let (at_least, reached) = (*at_least, *reached);
    let words = words::degree(domain, &answer);
    Ok(DegreeShown { at_least, reached, words, certificate, chords, vertices })
}
