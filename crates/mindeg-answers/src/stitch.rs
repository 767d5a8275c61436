//! The figures of meshes that were joined.

use crate::numbers::{count, steady_angle};
use mindeg::stitch::Stitched;
use schemars::JsonSchema;
use serde::Serialize;
use std::fmt::Write as _;

/// The figures of meshes that were joined.
///
/// # Example
///
/// ```
/// use mindeg::{Domain, Interior, Progress, Side, interior, stitch::{Gap, stitch}};
/// use mindeg_answers::stitch::StitchAnswer;
///
/// // Two squares, a third of their width apart.
/// let square = |x: f64| {
///     let corners = [[x, 0.0], [x + 3.0, 0.0], [x + 3.0, 3.0], [x, 3.0]];
///     let domain = Domain::polygon(corners, vec![Side::count(6); 4])?;
///     Ok::<_, Box<dyn std::error::Error>>(interior::mesh(&domain, &Interior::default(), Progress::NONE)?.mesh)
/// };
/// let meshes = [square(0.0)?, square(4.0)?];
/// let area = Domain::from_rings([[[2.9, 0.3], [4.1, 0.3], [4.1, 2.7], [2.9, 2.7]]])?;
/// let answer = StitchAnswer::of(&stitch(&meshes, Gap::Within(&area), &Interior::default(), Progress::NONE)?);
/// let given: usize = meshes.iter().map(|mesh| mesh.triangles().len()).sum();
/// assert_eq!(answer.triangles, answer.new_triangles + given);
/// assert!(answer.violations.is_empty());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct StitchAnswer {
    /// The vertices of the mesh.
    pub vertices: usize,
    /// Its triangles.
    pub triangles: usize,
    /// The triangles of the second mesh that overlapped the first one or touched it, and were dropped.
    pub overlapping: usize,
    /// The triangles that were dropped since they were too near it.
    pub near: usize,
    /// The vertices that no given mesh has.
    pub new_vertices: usize,
    /// The triangles that fill the gap.
    pub new_triangles: usize,
    /// Their minimum angle in degrees.
    pub min_angle: f64,
    /// The boundary vertices of given meshes that lie inside now.
    pub joined: usize,
    /// The joined vertices with fewer than 5 or more than 7 edges.
    pub violations: Vec<JoinedVertex>,
}

/// A vertex at which meshes were joined.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct JoinedVertex {
    /// Its index.
    pub vertex: u32,
    /// Where.
    pub position: [f64; 2],
    /// Its edges.
    pub degree: u32,
}

impl StitchAnswer {
    /// The figures.
    #[must_use]
    pub fn of(stitched: &Stitched) -> Self {
        let Stitched { mesh, triangles, vertices, min_angle, joined, dropped } = stitched;
        let row = |&vertex: &u32| {
            let degree = mesh.degrees()[vertex as usize];
            let position = mesh.positions()[vertex as usize].truncate().to_array();
            (!(5..=7).contains(&degree)).then_some(JoinedVertex { vertex, position, degree })
        };
        Self {
            vertices: mesh.positions().len(),
            triangles: mesh.triangles().len(),
            overlapping: dropped.map_or(0, |dropped| dropped.overlapping),
            near: dropped.map_or(0, |dropped| dropped.near),
            new_vertices: vertices.len(),
            new_triangles: triangles.len(),
            min_angle: *min_angle,
            joined: joined.len(),
            violations: joined.iter().filter_map(row).collect(),
        }
    }

    /// The same as text.
    #[must_use]
    pub fn text(&self) -> String {
        let mut text = String::new();
        if self.overlapping > 0 {
            let _ = writeln!(
                text,
                "dropped {} triangles of the second mesh: {} overlapped the first or touched it, {} were too near it",
                count((self.overlapping + self.near) as u64),
                count(self.overlapping as u64),
                count(self.near as u64),
            );
        }
        let _ = writeln!(
            text,
            "{} triangles and {} vertices fill the gap, with a minimum angle of {}; the mesh has {} triangles",
            count(self.new_triangles as u64),
            count(self.new_vertices as u64),
            steady_angle(self.min_angle),
            count(self.triangles as u64),
        );
        let joined = count(self.joined as u64);
        match &self.violations[..] {
            [] => {
                let _ = write!(
                    text,
                    "{joined} vertices of the meshes lie inside now, each with 5 to 7 edges"
                );
            }
            [first, ..] => {
                let _ = write!(
                    text,
                    "{joined} vertices of the meshes lie inside now; {} have fewer than 5 or more than 7 edges, such as vertex {} at \
                     ({}, {}) with {}",
                    count(self.violations.len() as u64),
                    first.vertex,
                    first.position[0],
                    first.position[1],
                    first.degree
                );
            }
        }
        text
    }
}
