/// The weights of a descent over blocks: breakout weights, after Morris 1993.
///
/// A vertex above its limit costs its weight times the square of its excess. Where an excess stays, the weight grows
/// with every round, until the descent leaves the hole; elsewhere it falls slowly. A little
/// [noise](Self::noise) on every chord moves blocks along plateaus.
///
/// ```
/// use mindeg_exact::Breakout;
///
/// let mut weights = Breakout::new(2);
/// weights.end_round(|vertex| vertex == 1);
/// assert!(weights.cost(1, 2) > weights.cost(0, 2));
/// assert_eq!(weights.cost(1, 0), 0);
/// ```
#[derive(Debug, Clone)]
pub struct Breakout(Vec<u32>);

const LEAST: u32 = 1000;
const MOST: u32 = 20_000;
const STEP: u32 = 200;

/// No vertex costs more: the sum over a block of 200 vertices stays below 2^30.
const MOST_COST: u32 = 1 << 22;

/// One more than the largest noise of a chord.
const NOISE: u64 = 13;

impl Breakout {
    /// The triangles of the blocks, round by round.
    pub const SIZES: [usize; 6] = [12, 24, 12, 48, 24, 96];

    /// The same weight for so many vertices.
    #[must_use]
    pub fn new(vertices: usize) -> Self {
        Self(vec![LEAST; vertices])
    }

    /// The cost of an excess at a vertex.
    #[must_use]
    pub fn cost(&self, vertex: usize, excess: u32) -> u32 {
        excess.saturating_mul(excess).saturating_mul(self.0[vertex]).min(MOST_COST)
    }

    /// The cost of a chord, by a random number.
    #[must_use]
    pub const fn noise(random: u64) -> u32 {
        (random % NOISE) as u32
    }

    /// The weights of crowded vertices grow by a step, the others fall by a hundredth.
    pub fn end_round(&mut self, is_crowded: impl Fn(usize) -> bool) {
        for (vertex, weight) in self.0.iter_mut().enumerate() {
            *weight = if is_crowded(vertex) {
                (*weight + STEP).min(MOST)
            } else {
                (*weight - *weight / 100).max(LEAST)
            };
        }
    }
}
