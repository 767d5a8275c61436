//! Arrays of numbers as base64 of their little-endian bytes.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use mindeg::glam::DVec2;

pub(crate) fn f64s(points: impl Iterator<Item = DVec2>) -> String {
    packed(points.flat_map(|point| point.to_array().map(f64::to_le_bytes)))
}

pub(crate) fn u32s(numbers: impl Iterator<Item = u32>) -> String {
    packed(numbers.map(u32::to_le_bytes))
}

pub(crate) fn f32s(numbers: impl Iterator<Item = f64>) -> String {
    packed(numbers.map(|number| (number as f32).to_le_bytes()))
}

fn packed<const N: usize>(numbers: impl Iterator<Item = [u8; N]>) -> String {
    STANDARD.encode(numbers.flatten().collect::<Vec<u8>>())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_packed_little_endian_at_their_width() {
        // 1.0 is 3ff0… or 3f80…, 2.0 is 4000….
        assert_eq!(f64s([DVec2::new(1.0, 2.0)].into_iter()), "AAAAAAAA8D8AAAAAAAAAQA==");
        assert_eq!(f32s([1.0, 2.0].into_iter()), "AACAPwAAAEA=");
        assert_eq!(u32s([1, 258].into_iter()), "AQAAAAIBAAA=");
    }
}
