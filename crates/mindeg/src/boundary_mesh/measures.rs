//! The measures of a mesh: its triangles' quality and its angles.
//!
//! Limits: each function visits every triangle again; nothing is kept.

use mindeg_mesh::parallel::try_blocks;
use mindeg_mesh::quality::TriangleQuality;
use mindeg_mesh::{Cancelled, Progress};

use super::BoundaryMesh;
use super::angles::cotangents;

/// The minimum and the maximum angle of a mesh, in degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AngleRange {
    /// In (0, 60].
    pub min: f64,
    /// In [60, 180).
    pub max: f64,
}

impl BoundaryMesh {
    /// The measures of all triangles, in the order of [`triangles`](Self::triangles).
    pub fn qualities(&self) -> impl ExactSizeIterator<Item = TriangleQuality> + '_ {
        self.placed_triangles().map(|[a, b, c]| TriangleQuality::of(a, b, c))
    }

    /// The minimum and the maximum angle. O(n) time, next to no memory, and much faster than
    /// [`qualities`](Self::qualities).
    pub fn angle_range(&self) -> AngleRange {
        self.measure_angles(Progress::NONE).expect("nothing cancels the work")
    }

    /// [`angle_range`](Self::angle_range), with reports to `progress`.
    ///
    /// # Errors
    ///
    /// [`Cancelled`].
    pub fn measure_angles(&self, progress: Progress<'_>) -> Result<AngleRange, Cancelled> {
        let counter = progress.counter("measuring the angles", self.triangle_count().into());
        let worse = |[of_least, of_greatest]: [f64; 2], [least, greatest]: [f64; 2]| {
            [of_least.max(least), of_greatest.min(greatest)]
        };
        let extremes = [f64::NEG_INFINITY, f64::INFINITY];
        let in_blocks = try_blocks(self.triangle_count(), |range| {
            let count = range.len();
            let of_block = self.placed_triangles_of(range).map(cotangents).fold(extremes, worse);
            counter.add(count)?;
            Ok::<_, Cancelled>(of_block)
        })?;
        let [least, greatest] = in_blocks.into_iter().fold(extremes, worse);
        let degrees = |cotangent: f64| libm::atan2(1.0, cotangent).to_degrees();
        Ok(AngleRange { min: degrees(least), max: degrees(greatest) })
    }
}
