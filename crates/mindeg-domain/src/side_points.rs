//! The points of a straight side, by closed forms: no point is stored.

use glam::DVec2;

use crate::spacing_law::SpacingLaw;

/// The points of one straight side.
#[derive(Clone, Copy)]
pub(crate) struct SidePoints<'a> {
    /// The vertex where the side starts.
    pub(crate) first: u32,
    pub(crate) start: DVec2,
    pub(crate) span: DVec2,
    pub(crate) law: &'a SpacingLaw,
}

impl SidePoints<'_> {
    /// Point `i`, below the number of intervals.
    pub(crate) fn point(&self, i: u32) -> DVec2 {
        self.start + self.law.parameter(i) * self.span
    }

    /// Fills `out` with the points from index `first` on.
    pub(crate) fn fill<T>(&self, first: u32, out: &mut [T], of: impl Fn(DVec2) -> T) {
        let indexed = (first..).zip(out);
        if self.law.is_uniform() {
            // The same formula, without a call: the compiler computes several points at a time.
            let intervals = f64::from(self.law.intervals());
            indexed.for_each(|(i, out)| {
                *out = of(self.start + f64::from(i) / intervals * self.span);
            });
        } else {
            indexed.for_each(|(i, out)| *out = of(self.point(i)));
        }
    }

    /// The index of the vertex on the side; `None` if it is elsewhere or at the side's end.
    pub(crate) fn index(&self, vertex: u32) -> Option<u32> {
        vertex.checked_sub(self.first).filter(|&index| index < self.law.intervals())
    }
}
