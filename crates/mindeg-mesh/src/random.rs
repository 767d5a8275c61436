/// Numbers that look random and are the same on every machine: SplitMix64 (Steele, Lea and Flood, 2014).
///
/// Searches try their steps in an order of such numbers; their results depend on the seed alone.
///
/// ```
/// use mindeg_mesh::Random;
///
/// let mut random = Random::new(7);
/// let (first, second) = (random.bits(), random.bits());
/// assert_ne!(first, second);
/// assert_eq!(Random::new(7).bits(), first);
/// assert!(random.below(6) < 6 && random.unit() < 1.0);
/// ```
#[derive(Debug, Clone)]
pub struct Random(u64);

/// 2^64 over the golden ratio: the step from state to state.
const STEP: u64 = 0x9e37_79b9_7f4a_7c15;

impl Random {
    /// The sequence of a seed.
    #[must_use]
    pub const fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// The number for some indices, whatever was drawn before.
    #[must_use]
    pub fn at(indices: &[u64]) -> u64 {
        indices.iter().fold(STEP, |state, &index| Self(state ^ index).bits())
    }

    /// The next 64 bits.
    pub const fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(STEP);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number from 0 up to but not 1.
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// An index of so many items, of which there are fewer than 2^53; 0 if there is none.
    pub fn below(&mut self, count: usize) -> usize {
        (self.unit() * count as f64) as usize
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The first numbers of seed 1234567, as the authors' program prints them.
    #[test]
    fn numbers_are_those_of_splitmix64() {
        let mut random = Random::new(1_234_567);
        let expected =
            [6_457_827_717_110_365_317, 3_203_168_211_198_807_973, 9_817_491_932_198_370_423];
        assert_eq!([(); 3].map(|()| random.bits()), expected);
        assert_eq!(Random::at(&[0]), Random::new(STEP).bits());
    }
}
