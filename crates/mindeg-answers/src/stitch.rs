//! What joining meshes did.

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
/// use mindeg::{Domain, Interior, Progress, TriMesh, glam::DVec3, stitch::stitch};
/// use mindeg_answers::stitch::StitchAnswer;
///
/// // Two triangles that point at each other.
/// let triangle = |corners: [[f64; 2]; 3]| {
///     let points = corners.map(|[x, y]| DVec3::new(x, y, 0.0)).to_vec();
///     TriMesh::new(points, vec![[0, 1, 2]])
/// };
/// let meshes = [
///     triangle([[0.0, 0.0], [2.0, 1.0], [0.0, 2.0]])?,
///     triangle([[5.0, 0.0], [5.0, 2.0], [3.0, 1.0]])?,
/// ];
/// let area = Domain::from_rings([[[1.5, 0.5], [3.5, 0.5], [3.5, 1.5], [1.5, 1.5]]])?;
/// let answer = StitchAnswer::of(&stitch(&meshes, &area, &Interior::default(), Progress::NONE)?);
/// assert_eq!(answer.triangles, answer.new_triangles + 2);
/// assert_eq!(answer.joined, 0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct StitchAnswer {
    /// The vertices of the mesh.
    pub vertices: usize,
    /// Its triangles.
    pub triangles: usize,
    /// The vertices that no given mesh has.
    pub new_vertices: usize,
    /// The triangles that fill the gap.
    pub new_triangles: usize,
    /// Their minimum angle in degrees.
    pub min_angle: f64,
    /// The boundary vertices of given meshes that lie inside now.
    pub joined: usize,
    /// Those of them with fewer than 5 or more than 7 edges.
    pub outside_5_to_7: Vec<JoinedVertex>,
}

/// A vertex at which meshes were joined.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct JoinedVertex {
    /// Its index.
    pub vertex: u32,
    /// Where.
    pub at: [f64; 2],
    /// Its edges.
    pub degree: u32,
}

impl StitchAnswer {
    /// The figures.
    #[must_use]
    pub fn of(stitched: &Stitched) -> Self {
        let Stitched { mesh, triangles, vertices, min_angle, joined } = stitched;
        let row = |&vertex: &u32| {
            let degree = mesh.degrees()[vertex as usize];
            let at = mesh.positions()[vertex as usize].truncate().to_array();
            (!(5..=7).contains(&degree)).then_some(JoinedVertex { vertex, at, degree })
        };
        Self {
            vertices: mesh.positions().len(),
            triangles: mesh.triangles().len(),
            new_vertices: vertices.len(),
            new_triangles: triangles.len(),
            min_angle: *min_angle,
            joined: joined.len(),
            outside_5_to_7: joined.iter().filter_map(row).collect(),
        }
    }

    /// The same as text.
    #[must_use]
    pub fn text(&self) -> String {
        let mut text = format!(
            "{} triangles and {} vertices fill the gap, with a minimum angle of {}; the mesh has {} triangles\n",
            count(self.new_triangles as u64),
            count(self.new_vertices as u64),
            steady_angle(self.min_angle),
            count(self.triangles as u64),
        );
        let joined = count(self.joined as u64);
        match &self.outside_5_to_7[..] {
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
                    count(self.outside_5_to_7.len() as u64),
                    first.vertex,
                    first.at[0],
                    first.at[1],
                    first.degree
                );
            }
        }
        text
    }
}
