//! The least maximum degree in words, with what proves it.

use mindeg::exact::{DegreeAnswer, ExactError, LowerBound, degree};
use mindeg::{Domain, Progress};
use mindeg_answers::words;
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

#[cfg(test)]
mod tests {
    use super::*;

    fn degree_of(domain: &str) -> DegreeShown {
        shown(&Domain::from_json(domain).unwrap(), Progress::NONE).unwrap()
    }

    #[test]
    fn every_proof_has_its_name_and_what_the_page_marks() {
        let rectangle = r#"{"rectangle": {"width": 4, "height": 3}, "size": 0.5}"#;
        assert_eq!(degree_of(rectangle).certificate, "balanced_cut");
        let limited = r#"{"rectangle": {"width": 4, "height": 3}, "size": 0.5,
            "vertices": [{"vertex": 0, "outside_degree": 9}]}"#;
        let shown = degree_of(limited);
        assert_eq!((shown.certificate, shown.at_least), ("counting", 11));

        // An L, in which a zig-zag of degree 4 needs chords beyond it.
        let bent = r#"{"polygon": {"corners": [[0,0],[4,0],[4,2],[2,2],[2,4],[0,4]]}, "sides": [
            {"intervals": 13}, {"intervals": 6}, {"intervals": 6}, {"intervals": 6},
            {"intervals": 6}, {"intervals": 13}]}"#;
        let shown = degree_of(bent);
        assert_eq!((shown.certificate, shown.chords.len()), ("blocked_zig_zags", 50));
        assert!(shown.vertices.is_empty());

        // A U: few vertices see the 60 intervals of its floor.
        let deep = r#"{"polygon": {"corners": [[0,0],[6,0],[6,4],[4,4],[4,2],[2,2],[2,4],[0,4]]},
            "sides": [{"intervals": 2}, {"intervals": 2}, {"intervals": 2}, {"intervals": 2},
            {"intervals": 60}, {"intervals": 2}, {"intervals": 2}, {"intervals": 2}]}"#;
        let shown = degree_of(deep);
        assert_eq!((shown.certificate, shown.reached), ("apexes", 23));
        assert!(shown.chords.is_empty() && !shown.vertices.is_empty());
    }

    #[test]
    fn the_sides_of_the_formula_are_explained_where_they_are_others() {
        let is_explained =
            |domain: &str| degree_of(domain).words.contains("Sides on one line count as one");
        assert!(!is_explained(r#"{"rectangle": {"width": 4, "height": 3}, "size": 0.5}"#));
        let halved = r#"{"polygon": {"corners": [[0,0],[2,0],[4,0],[4,3],[0,3]]}, "size": 0.5}"#;
        assert!(is_explained(halved));
        // As many sides, but others: one fewer below, and one more of the arc's two edges.
        let arched = r#"{"polygon": {"corners": [[2,0],[4,0],[4,3],[0,3],[0,0]]}, "size": 0.5,
            "sides": [{}, {}, {"intervals": 2, "arc": {"through": [2, 4]}}, {}, {}]}"#;
        assert!(is_explained(arched));
    }
}
