//! A mesh to look at while its boundary changes: points packed and triangulated, as each search begins.

use crate::breaklines::Breaklines;
use crate::generate::{Aims, Generated, SPACING, about_checked, checked, size_field};
use crate::options::{InteriorError, Options};
use crate::stage::Stage;
use crate::start::{Packing, Start};
use crate::verdict::floor;
use mindeg_mesh::Progress;
use mindeg_mesh::planar::PlanarBoundary;

/// A packing that nothing works on. Where it would have more points than `most`, about, edges far from the boundary are longer, but not
/// those of a length that was asked for. O(n log n) for n points.
///
/// ```
/// use mindeg_interior::{Options, draft};
/// use mindeg_mesh::Progress;
/// use mindeg_mesh::planar::PlanarBoundary;
///
/// // The boundary points of a square of 100 by 100.
/// let along = |i: u32| f64::from(i);
/// let sides = (0..100).map(|i| [along(i), 0.0]).chain((0..100).map(|i| [100.0, along(i)]));
/// let back = (0..100).map(|i| [along(100 - i), 100.0]).chain((0..100).map(|i| [0.0, along(100 - i)]));
/// let square: Vec<glam::DVec2> = sides.chain(back).map(Into::into).collect();
/// let outline = PlanarBoundary::new(&[square])?;
/// let points = |most| draft(&outline, &Options::default(), most, Progress::NONE).map(|mesh| mesh.points.len());
/// assert!(points(1000)? < points(10_000)? / 2);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
///
/// As [`generate`](crate::generate()).
pub fn draft(
    outline: &PlanarBoundary,
    options: &Options,
    most: usize,
    progress: Progress<'_>,
) -> Result<Generated<()>, InteriorError> {
    checked(outline, options)?;
    let (breaklines, mut field) = size_field(outline, options, false)?;
    let wanted = about_checked(outline, options, &field)?;
    let about = wanted.min(most as f64);
    // Of a domain between two places that were looked at, nothing is known.
    field.scale_mean((wanted / about).max(1.0).sqrt());
    let Aims { stars, goals, .. } = &Aims::new(outline, &breaklines, options);
    let start = Start { outline, stars, goals, breaklines: &breaklines, field: &field, about };
    let mut stage = Stage::new(progress, "adding interior points");
    stage.section(1.0);
    let most = options.wanted.max_points();
    let packing = start.packing(SPACING, floor(options), most, None, &mut stage)?;
    Ok(Generated::packed(&packing, &breaklines))
}

impl Generated<()> {
    /// A draft: what a search begins with.
    pub(crate) fn packed(packing: &Packing, breaklines: &Breaklines) -> Self {
        Self {
            points: packing.vertices.iter().map(|vertex| vertex.at).collect(),
            triangles: packing.triangles.clone(),
            line_edges: breaklines.edges.clone(),
            report: (),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::generate_showing;
    use crate::samples;

    /// With room for all its points, a draft is what the search begins with, but for how fast sizes grow; with less, it has fewer, with the
    /// same boundary, and all of the area.
    #[test]
    fn a_draft_has_about_as_many_points_as_it_may_have() {
        let corners = [[0.0, 0.0], [60.0, 0.0], [60.0, 40.0], [0.0, 40.0]];
        let outline = PlanarBoundary::new(&[samples::ring(&corners, &[60, 40, 60, 40])]).unwrap();
        let options = Options::default();
        let mut first = None;
        let mut show = |found| first = Some(found);
        generate_showing(&outline, &options, Some(&mut show), Progress::NONE).unwrap();
        let first: Generated<()> = first.unwrap();
        for (most, range) in [(usize::MAX, 0.9..1.1), (1000, 0.3..0.6), (100, 0.1..0.3)] {
            let found = draft(&outline, &options, most, Progress::NONE).unwrap();
            let share = found.points.len() as f64 / first.points.len() as f64;
            assert!(range.contains(&share), "{most}: {share}");
            assert_eq!(found.points[..200], *outline.points());
            let doubled = |t: &[u32; 3]| {
                let [a, b, c] = t.map(|v| found.points[v as usize]);
                (b - a).perp_dot(c - a)
            };
            assert!((found.triangles.iter().map(doubled).sum::<f64>() - 4800.0).abs() < 1e-6);
        }
    }
}
