//! The measures of a mesh: its triangles' quality, its angles and its degrees.
//!
//! Limits: each function visits every triangle or vertex again; nothing is kept.

use mindeg_mesh::parallel::{blocks, try_blocks};
use mindeg_mesh::quality::{DegreeHistogram, QualitySummary, TriangleQuality};
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

/// How many vertices have each degree, corners apart from the others.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DegreeHistograms {
    /// The degrees of the corners.
    pub corners: DegreeHistogram,
    /// The degrees of the vertices inside sides.
    pub sides: DegreeHistogram,
}

impl BoundaryMesh {
    /// The measures of all triangles, in the order of [`triangles`](Self::triangles).
    pub fn qualities(&self) -> impl ExactSizeIterator<Item = TriangleQuality> + '_ {
        self.placed_triangles().map(|[a, b, c]| TriangleQuality::of(a, b, c))
    }

    /// The measures of all triangles summed up, as
    /// [`QualitySummary::of`](mindeg_mesh::quality::QualitySummary::of) has them. O(n) time and memory.
    #[must_use]
    pub fn quality_summary(&self) -> QualitySummary {
        let qualities = |range| {
            let triangles = self.placed_triangles_of(range);
            triangles.map(|[a, b, c]| TriangleQuality::of(a, b, c))
        };
        let summary = QualitySummary::of_ranges(self.triangle_count(), qualities);
        summary.expect("a mesh has a triangle")
    }

    /// The minimum and the maximum angle. O(n) time, next to no memory, and much faster than
    /// [`qualities`](Self::qualities).
    #[must_use]
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

    /// How many corners and how many other vertices have each degree. O(n).
    #[must_use]
    pub fn degree_histograms(&self) -> DegreeHistograms {
        let rings = self.rings();
        let corners = (0..rings.side_count()).map(|side| rings.corner(side));
        let corners: DegreeHistogram = corners.map(|corner| self.degree(corner)).collect();
        let in_blocks = blocks(self.vertex_count(), |range| {
            let sides = range.filter(|&vertex| !rings.is_corner(vertex));
            sides.map(|vertex| self.degree(vertex)).collect::<DegreeHistogram>()
        });
        DegreeHistograms { corners, sides: in_blocks.iter().sum() }
    }
}
