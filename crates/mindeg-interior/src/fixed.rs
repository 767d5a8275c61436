//! Lines and points inside a domain; segments that may be divided are, as the size field wants.

use crate::breaklines::Breaklines;
use crate::near::Near;
use crate::options::Options;
use crate::size::SizeField;
use glam::DVec2;
use mindeg_domain::SizeAt;
use mindeg_mesh::planar::PlanarBoundary;

/// Divides the segments that may be divided.
pub(crate) fn breaklines(
    outline: &PlanarBoundary,
    options: &Options,
    field: &SizeField,
) -> Breaklines {
    let mut lines = Breaklines { points: outline.inner_points().to_vec(), edges: Vec::new() };
    let vertices = outline.points().len();
    for (segment, &[a, b]) in outline.segments().iter().enumerate() {
        let (from, to) = (outline.point(a), outline.point(b));
        let mut last = a;
        if options.is_divisible(segment) {
            for share in divisions(from, to, field) {
                lines.points.push(from.lerp(to, share));
                let point = (vertices + lines.points.len() - 1) as u32;
                lines.edges.push([last, point]);
                last = point;
            }
        }
        lines.edges.push([last, b]);
    }
    lines
}

/// Where to divide a segment, as shares of it: pieces about as long as the size wants.
fn divisions(from: DVec2, to: DVec2, field: &SizeField) -> Vec<f64> {
    let length = from.distance(to);
    // The number of sizes that go into the segment up to each step, by the trapezoid rule.
    let mut shares = vec![0.0];
    let mut counts = vec![0.0];
    let mut share: f64 = 0.0;
    let least = 1e-6;
    while share < 1.0 {
        let size = field.at(from.lerp(to, share)).max(least * length);
        let step = (0.25 * size / length).min(1.0 - share);
        let middle = field.at(from.lerp(to, share + step / 2.0)).max(least * length);
        let last = counts[counts.len() - 1];
        counts.push(last + step * length / middle);
        share = if 1.0 - share - step < 1e-12 { 1.0 } else { share + step };
        shares.push(share);
    }
    let total = counts[counts.len() - 1];
    let pieces = libm::round(total).max(1.0);
    let mut at = 0;
    (1..pieces as u64)
        .map(|i| {
            let wanted = total * i as f64 / pieces;
            while counts[at + 1] < wanted {
                at += 1;
            }
            let part = (wanted - counts[at]) / (counts[at + 1] - counts[at]);
            shares[at] + (shares[at + 1] - shares[at]) * part
        })
        .collect()
}

/// Sizes where inner points are nearer to each other or to the boundary than the size field wants.
pub(crate) fn crowded(
    outline: &PlanarBoundary,
    lines: &Breaklines,
    field: &SizeField,
) -> Vec<SizeAt> {
    // Fixed points lie inside.
    let mut near = Near::new(outline.bounds());
    outline.points().iter().for_each(|p| near.insert(*p));
    let mut sizes = Vec::new();
    for point in &lines.points {
        let size = field.at(*point);
        if let Some((_, distance)) = near.nearest(*point, 0.7 * size) {
            sizes.push(SizeAt { at: *point, size: distance });
        } else if let Some((_, distance)) = field.boundary().nearest(*point, 0.5 * size) {
            sizes.push(SizeAt { at: *point, size: distance * 1.2 });
        }
        near.insert(*point);
    }
    sizes
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Interior;
    use crate::asked::Asked;
    use crate::samples;

    #[test]
    fn pieces_of_a_segment_are_as_long_as_the_size_wants() {
        let outline = samples::rectangle(40.0, 20.0, [40, 20, 40, 20]);
        let at_most_2 = |places: &[SizeAt]| {
            let wanted = Interior { size_inside: Some(2.0), ..Interior::default() };
            let asked = Asked::new(&outline, &wanted.into());
            SizeField::new(&outline, &[], 1.2, &[], places).asking(asked.into())
        };
        let field = at_most_2(&[]);
        // In the middle of the plate, one size.
        let [from, to] = [[10.0, 10.0], [30.0, 10.0]].map(DVec2::from);
        let shares = divisions(from, to, &field);
        assert_eq!(shares.len(), 9);
        for (i, share) in (1..).zip(&shares) {
            assert!((share - f64::from(i) / 10.0).abs() < 1e-9, "{shares:?}");
        }
        // Towards a small size at one end, every piece has the same share of the sizes along it.
        let places = [SizeAt { at: to, size: 0.1 }];
        let field = at_most_2(&places);
        let shares = divisions(from, to, &field);
        let ends: Vec<f64> = [0.0].into_iter().chain(shares).chain([1.0]).collect();
        let sizes = |from_share: f64, to_share: f64| -> f64 {
            let steps = 1000;
            let step = (to_share - from_share) / f64::from(steps);
            let at = |i: i32| from.lerp(to, from_share + (f64::from(i) + 0.5) * step);
            (0..steps).map(|i| step * 20.0 / field.at(at(i))).sum()
        };
        let total = sizes(0.0, 1.0);
        assert_eq!(ends.len() - 1, total.round() as usize);
        for pair in ends.windows(2) {
            let share = sizes(pair[0], pair[1]) * (ends.len() - 1) as f64 / total;
            assert!((share - 1.0).abs() < 0.05, "{pair:?} {share} {total}");
        }
        // Shorter than the size: one piece.
        assert!(divisions(from, from + DVec2::X, &field).is_empty());
    }
}
