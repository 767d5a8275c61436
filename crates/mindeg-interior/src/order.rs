//! An order of points in which neighbours in the plane are mostly neighbours in memory.

use glam::DVec2;
use mindeg_mesh::Bounds;

/// Steps of the grid on each axis, as a power of 2.
const BITS: u32 = 24;

/// The indices of points in the order of Hilbert's curve; equal positions in the order of their index.
pub(crate) fn along_hilbert_curve(points: &[DVec2]) -> Vec<u32> {
    let Some(bounds) = Bounds::of(points.iter().copied()) else { return Vec::new() };
    let scale = f64::from((1_u32 << BITS) - 1) / bounds.size().max_element();
    let mut keys: Vec<(u64, u32)> = (0..)
        .zip(points)
        .map(|(index, point)| {
            let [x, y] = ((*point - bounds.min) * scale).to_array().map(|x| x as u32);
            (hilbert(x, y), index)
        })
        .collect();
    keys.sort_unstable();
    keys.into_iter().map(|(_, index)| index).collect()
}

/// How far along Hilbert's curve a cell of the grid comes.
fn hilbert(mut x: u32, mut y: u32) -> u64 {
    let mut along = 0;
    for bit in (0..BITS).rev() {
        let (right, upper) = (x >> bit & 1, y >> bit & 1);
        along = along << 2 | u64::from((3 * right) ^ upper);
        if upper == 0 {
            if right == 1 {
                let last = (1 << BITS) - 1;
                (x, y) = (last - x, last - y);
            }
            (x, y) = (y, x);
        }
    }
    along
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_curve_goes_from_neighbour_to_neighbour() {
        let side = 16;
        let cells: Vec<DVec2> = (0..side * side)
            .map(|i| DVec2::new(f64::from(i * 7 % side), f64::from(i / side)))
            .collect();
        let order = along_hilbert_curve(&cells);
        let mut sorted = order.clone();
        sorted.sort_unstable();
        assert!(sorted.into_iter().eq(0..cells.len() as u32));
        let steps = order.windows(2).map(|w| cells[w[0] as usize].distance(cells[w[1] as usize]));
        assert_eq!(steps.fold(0.0, f64::max), 1.0);
    }
}
