//! The ring of boundary vertices: ids `0 … n-1`, counter-clockwise, with 0 after `n-1`.
//!
//! Only this file wraps an id. The checkers share no code with the constructions, so
//! [`verify`](crate::verify()) has its own.

/// A ring of n vertices.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Ring {
    len: u32,
}

impl Ring {
    /// A ring of `len` vertices, at least 1.
    pub(crate) fn new(len: u32) -> Self {
        debug_assert!(len > 0);
        Self { len }
    }

    /// The number of vertices.
    #[inline]
    pub(crate) fn len(self) -> u32 {
        self.len
    }

    /// The vertex `steps` counter-clockwise from `vertex`; both are below the length.
    #[inline]
    pub(crate) fn forward(self, vertex: u32, steps: u32) -> u32 {
        debug_assert!(vertex < self.len && steps < self.len);
        // The sum may not fit in 32 bits.
        let to_end = self.len - vertex;
        if steps < to_end { vertex + steps } else { steps - to_end }
    }

    /// The vertex `steps` clockwise from `vertex`; both are below the length.
    #[inline]
    pub(crate) fn backward(self, vertex: u32, steps: u32) -> u32 {
        debug_assert!(vertex < self.len && steps < self.len);
        if steps <= vertex { vertex - steps } else { self.len - (steps - vertex) }
    }

    /// The counter-clockwise steps from one vertex to another, in `0..len`.
    #[inline]
    pub(crate) fn steps(self, from: u32, to: u32) -> u32 {
        self.backward(to, from)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ids_wrap_in_both_directions() {
        let ring = Ring::new(5);
        for vertex in 0..5 {
            for steps in 0..5 {
                let ahead = ring.forward(vertex, steps);
                assert_eq!(ahead, (vertex + steps) % 5);
                assert_eq!(ring.backward(ahead, steps), vertex);
                assert_eq!(ring.steps(vertex, ahead), steps);
            }
        }
    }

    #[test]
    fn the_largest_ring_does_not_overflow() {
        let ring = Ring::new(crate::MAX_VERTICES);
        let last = crate::MAX_VERTICES - 1;
        assert_eq!(ring.forward(last, last), last - 1);
        assert_eq!(ring.forward(last, 1), 0);
        assert_eq!(ring.backward(0, 1), last);
        assert_eq!(ring.steps(last, 0), 1);
    }

    /// In 64 bits, for the vertices and steps at either end of the largest rings.
    #[test]
    fn the_largest_rings_wrap_as_in_64_bits() {
        for len in crate::MAX_VERTICES - 2..=crate::MAX_VERTICES {
            let ring = Ring::new(len);
            let (middle, wide) = (len / 2, u64::from(len));
            let ends = || (0..60).chain(middle - 30..middle + 30).chain(len - 60..len);
            for (vertex, steps) in
                ends().flat_map(|vertex| ends().map(move |steps| (vertex, steps)))
            {
                let ahead = ring.forward(vertex, steps);
                assert_eq!(u64::from(ahead), (u64::from(vertex) + u64::from(steps)) % wide);
                assert_eq!(ring.backward(ahead, steps), vertex);
                assert_eq!(ring.steps(vertex, ahead), steps);
            }
        }
    }
}
