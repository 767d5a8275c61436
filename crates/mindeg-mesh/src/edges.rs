//! Edges as pairs of vertices.

/// An edge whichever way it runs: the lesser vertex first.
#[must_use]
pub fn sorted([a, b]: [u32; 2]) -> [u32; 2] {
    [a.min(b), a.max(b)]
}

/// The edges of a triangle, which lies on the left of each.
#[must_use]
pub fn edges_of([a, b, c]: [u32; 3]) -> [[u32; 2]; 3] {
    [[a, b], [b, c], [c, a]]
}
