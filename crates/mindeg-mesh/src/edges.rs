//! Edges as pairs of vertices.

/// An edge whichever way it runs: the lesser end first, of indices or of other keys.
#[must_use]
pub fn sorted<T: Ord>([a, b]: [T; 2]) -> [T; 2] {
    if a <= b { [a, b] } else { [b, a] }
}

/// The edges of a triangle, which lies on the left of each.
#[must_use]
pub fn edges_of([a, b, c]: [u32; 3]) -> [[u32; 2]; 3] {
    [[a, b], [b, c], [c, a]]
}
