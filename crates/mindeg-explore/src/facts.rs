//! What the page shows but does not work out.

use mindeg_compare::measure_facts;

use crate::answer::MAX_VERTICES;
use crate::api::{Facts, Measure};
use crate::download::format_facts;

pub(crate) fn facts(max_bytes: usize) -> Facts {
    let measures = measure_facts().into_iter().map(|facts| Measure {
        name: facts.name,
        title: facts.title,
        unit: facts.unit,
        explanation: facts.explanation,
        higher_is_better: facts.higher_is_better,
    });
    Facts {
        measures: measures.collect(),
        formats: format_facts(),
        max_vertices: MAX_VERTICES,
        max_bytes,
    }
}
