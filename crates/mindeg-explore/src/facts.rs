//! The facts that the page shows but does not work out.

use mindeg::GOALS;
use mindeg_answers::advice::Purpose;
use mindeg_answers::interior_keys::interior_keys;
use mindeg_answers::measures::SHOWN;

use crate::answer::MAX_VERTICES;
use crate::api::Facts;
use crate::download::format_facts;

pub(crate) fn facts(max_bytes: usize, purpose: Option<Purpose>) -> Facts {
    Facts {
        measures: SHOWN.iter().map(Into::into).collect(),
        formats: format_facts(),
        goals: &GOALS,
        interior: interior_keys(),
        max_vertices: MAX_VERTICES,
        max_bytes,
        purpose,
    }
}
