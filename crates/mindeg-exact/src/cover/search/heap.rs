//! The variables in the order in which the search decides them: chords first, then the more active.

/// A binary heap whose entries can be raised.
pub(super) struct Heap {
    /// Variables below this are of chords.
    chords: u32,
    activities: Vec<f64>,
    entries: Vec<u32>,
    /// For each variable its index in `entries`, or [`ABSENT`].
    indices: Vec<u32>,
}

const ABSENT: u32 = u32::MAX;

impl Heap {
    pub(super) fn new(variables: u32, chords: u32) -> Self {
        Self {
            chords,
            activities: vec![0.0; variables as usize],
            entries: (0..variables).collect(),
            indices: (0..variables).collect(),
        }
    }

    /// Takes the first variable out for which `is_free` is true, and all before it.
    pub(super) fn pop(&mut self, is_free: impl Fn(u32) -> bool) -> Option<u32> {
        while let Some(&first) = self.entries.first() {
            self.indices[first as usize] = ABSENT;
            let last = self.entries.pop().unwrap_or(first);
            if last != first {
                self.put(0, last);
                self.sink(0);
            }
            if is_free(first) {
                return Some(first);
            }
        }
        None
    }

    /// Puts a variable back that may have been taken out.
    pub(super) fn put_back(&mut self, variable: u32) {
        if self.indices[variable as usize] == ABSENT {
            self.entries.push(variable);
            self.rise(self.entries.len() - 1, variable);
        }
    }

    /// Adds to the activity of a variable, which it returns.
    pub(super) fn raise(&mut self, variable: u32, by: f64) -> f64 {
        self.activities[variable as usize] += by;
        let index = self.indices[variable as usize];
        if index != ABSENT {
            self.rise(index as usize, variable);
        }
        self.activities[variable as usize]
    }

    /// Multiplies all activities.
    pub(super) fn scale(&mut self, by: f64) {
        self.activities.iter_mut().for_each(|activity| *activity *= by);
    }

    /// Whether a variable comes before another.
    pub(super) fn is_before(&self, a: u32, b: u32) -> bool {
        let key = |variable: u32| (variable < self.chords, self.activities[variable as usize]);
        key(a) > key(b) || (key(a) == key(b) && a < b)
    }

    fn put(&mut self, index: usize, variable: u32) {
        self.entries[index] = variable;
        self.indices[variable as usize] = index as u32;
    }

    fn rise(&mut self, mut index: usize, variable: u32) {
        while index > 0 {
            let above = self.entries[(index - 1) / 2];
            if !self.is_before(variable, above) {
                break;
            }
            self.put(index, above);
            index = (index - 1) / 2;
        }
        self.put(index, variable);
    }

    fn sink(&mut self, mut index: usize) {
        let variable = self.entries[index];
        while let Some(&left) = self.entries.get(2 * index + 1) {
            let (mut below, mut first) = (2 * index + 1, left);
            if let Some(&right) = self.entries.get(below + 1)
                && self.is_before(right, left)
            {
                (below, first) = (below + 1, right);
            }
            if !self.is_before(first, variable) {
                break;
            }
            self.put(index, first);
            index = below;
        }
        self.put(index, variable);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn chords_come_first_and_the_active_before_others() {
        let mut heap = Heap::new(6, 3);
        for (variable, by) in [(1, 2.0), (4, 9.0), (2, 3.0), (5, 9.0), (1, 2.0)] {
            heap.raise(variable, by);
        }
        let order =
            |heap: &mut Heap| std::iter::from_fn(|| heap.pop(|v| v != 0)).collect::<Vec<_>>();
        assert_eq!(order(&mut heap), [1, 2, 4, 5, 3]);
        [3, 5, 2, 2, 4].into_iter().for_each(|variable| heap.put_back(variable));
        heap.raise(5, 1.0);
        heap.scale(0.5);
        assert_eq!(order(&mut heap), [2, 5, 4, 3]);
    }
}
