//! How large a problem may be.

/// The most boundary vertices of a convex polygon, 4,096.
///
/// Time grows with the cube of the number of vertices and memory with its square.
pub const MAX_VERTICES: u32 = 4096;

/// The most triples of vertices that see each other in another polygon: 4 * 10^9.
///
/// One pass of the dynamic program over 10^9 triples takes 5 to 10 seconds on one core. A coastline
/// of 20,000 vertices has some 10^9, an L of 2,000 has 2.5 * 10^8.
pub const MAX_TRIPLES: u64 = 4_000_000_000;
