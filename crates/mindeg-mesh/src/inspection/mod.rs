//! What is to be said of any triangle mesh: how it hangs together, what is wrong with it, how
//! many edges meet at its vertices, and how well its triangles are shaped.
//!
//! Meshes are taken as they come, from any program: with interior vertices, in several parts,
//! closed, or broken. An [`Inspection`] counts and names; it repairs nothing.
//!
//! # What counts as what
//!
//! - *Welding.* Files repeat a vertex where its normal or texture coordinates change, glTF with
//!   flat shading at every triangle. The mesh that is meant is the one in space, so vertices
//!   whose coordinates are all equal count as one, under the number of the first. Nothing is
//!   moved: vertices that are merely close stay apart. [`InspectionOptions::weld`] switches
//!   this off.
//! - *Faces.* A triangle that has three different vertices (after welding). Edges, degrees,
//!   loops and components are those of the faces. The measures of quality are of all
//!   triangles.
//! - *Degree.* The number of edges at a vertex, those on the boundary included.
//! - *Boundary.* Edges with one face; vertices on such edges are boundary vertices, all others
//!   interior. An edge with three faces or more is not manifold; neither is a vertex at which
//!   the faces form several fans, each joined by edges, as where two cones meet at their tips.
//! - *Components.* Sets of faces joined by edges. Parts that touch in a vertex count apart.
//! - *Euler characteristic.* Vertices in faces, less edges, plus faces: 2 for a sphere, 0 for a
//!   torus, 1 for a disk, where the mesh is manifold.
//! - *Duplicate.* A triangle with the same vertices as an earlier one, however it runs.
//! - *Zero area.* A triangle whose corners are on a line, as exactly as f64 has them: to move
//!   each corner by a few units in the last place of its largest coordinate can make it flat.
//! - *Inconsistent winding.* An edge along which its two faces run in the same direction, so
//!   that one is seen from the front and the other from the back.
//!
//! Limits: positions of glTF are 32-bit floats, so a triangle that was flat before it was
//! written may have a tiny area in the file; it shows in the least angles. Self-intersections
//! are not looked for. Of an outline, corners nearer together than a millionth of its size are
//! not told apart.

mod convex_outline;
mod shapes;
mod topology;
mod weld;

pub use convex_outline::{ConvexOutline, NoConvexOutline};

use crate::connectivity::stars::{Stars, is_proper};
use crate::quality::{DegreeHistogram, QualitySummary, TriangleQuality};
use crate::tri_mesh::TriMesh;
use shapes::Shapes;
use std::borrow::Cow;
use topology::Topology;

/// How many triangles [`Inspection::worst_triangles`] holds at most.
pub const WORST: usize = 5;

/// What an [`Inspection`] is to go by.
///
/// # Example
///
/// ```
/// use mindeg_mesh::inspection::InspectionOptions;
///
/// let options = InspectionOptions { pole_degree: 6, ..InspectionOptions::default() };
/// assert!(options.weld);
/// assert_eq!(options.corner_angle, 1.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InspectionOptions {
    /// Whether vertices at the same position count as one. On by default.
    pub weld: bool,
    /// Vertices of a greater degree are poles; 8 by default.
    pub pole_degree: u32,
    /// By how many degrees an outline must turn at a vertex for it to be a corner, 0 to 90; 1
    /// by default. A side may bend as far as an arc that leaves its chord by that angle.
    pub corner_angle: f64,
}

impl Default for InspectionOptions {
    fn default() -> Self {
        Self { weld: true, pole_degree: 8, corner_angle: 1.0 }
    }
}

/// What there is to say of a mesh; the [module](self) defines the terms.
///
/// Vertices and triangles go by their numbers in the mesh, from 0; a welded vertex by that of
/// the first at its position. All lists are in ascending order but for the worst triangles and
/// the poles.
///
/// # Example
///
/// ```
/// use glam::DVec3;
/// use mindeg_mesh::TriMesh;
/// use mindeg_mesh::inspection::{Inspection, InspectionOptions};
///
/// // A square cut in four at its center, one triangle the wrong way round.
/// let points = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [1.0, 1.0]];
/// let points = points.map(|[x, y]| DVec3::new(x, y, 0.0)).to_vec();
/// let mesh = TriMesh::new(points, vec![[0, 1, 4], [1, 2, 4], [4, 2, 3], [3, 4, 0]])?;
/// let inspection = Inspection::of(&mesh, &InspectionOptions::default());
/// assert_eq!((inspection.edge_count, inspection.euler_characteristic), (8, 1));
/// assert_eq!(inspection.interior_degrees.iter().collect::<Vec<_>>(), [(4, 1)]);
/// assert_eq!(inspection.boundary_degrees.iter().collect::<Vec<_>>(), [(3, 4)]);
/// assert_eq!(inspection.inconsistent_edges, [[0, 4], [3, 4]]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Inspection {
    /// The number of vertices in the mesh, used or not.
    pub vertex_count: usize,
    /// How many of them are at the position of an earlier one and were welded to it.
    pub welded_count: usize,
    /// The number of triangles in the mesh.
    pub triangle_count: usize,
    /// How many of them have three different vertices.
    pub face_count: usize,
    /// The number of edges.
    pub edge_count: usize,
    /// The number of edges with one face.
    pub boundary_edge_count: usize,
    /// The number of closed loops that boundary edges form.
    pub boundary_loop_count: usize,
    /// The number of lines of boundary edges that end where an edge is not manifold.
    pub open_boundary_count: usize,
    /// The number of components.
    pub component_count: usize,
    /// Vertices in faces - edges + faces.
    pub euler_characteristic: i64,
    /// Edges with three faces or more, by their vertices.
    pub non_manifold_edges: Vec<[u32; 2]>,
    /// Vertices at which faces form several fans.
    pub non_manifold_vertices: Vec<u32>,
    /// Edges of two faces with inconsistent winding, by their vertices.
    pub inconsistent_edges: Vec<[u32; 2]>,
    /// Triangles that repeat an earlier one.
    pub duplicate_triangles: Vec<u32>,
    /// Triangles without area, among them all that are no faces.
    pub zero_area_triangles: Vec<u32>,
    /// Vertices in no face, without those that are welded to another.
    pub unreferenced_vertices: Vec<u32>,
    /// How many boundary vertices have each degree.
    pub boundary_degrees: DegreeHistogram,
    /// How many interior vertices have each degree.
    pub interior_degrees: DegreeHistogram,
    /// The first of the vertices with the highest degree; `None` if there is no face.
    pub highest_degree: Option<VertexDegree>,
    /// The vertices of a higher degree than [`InspectionOptions::pole_degree`], highest first.
    pub poles: Vec<VertexDegree>,
    /// The measures of all triangles.
    pub quality: QualitySummary,
    /// The triangles with the least angles, worst first; at most [`WORST`].
    pub worst_triangles: Vec<WorstTriangle>,
    /// The outline as a convex polygon, or why it is none.
    pub outline: Result<ConvexOutline, NoConvexOutline>,
}

/// A vertex and its degree.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct VertexDegree {
    /// The vertex.
    pub vertex: u32,
    /// The number of edges at it.
    pub degree: u32,
    /// Whether one of them is a boundary edge.
    pub on_boundary: bool,
}

/// A triangle and its measures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WorstTriangle {
    /// The number of the triangle.
    pub triangle: u32,
    /// Its measures.
    pub quality: TriangleQuality,
}

impl Inspection {
    /// Inspects a mesh. O(n log n) time and O(n) memory for n vertices and triangles.
    #[must_use]
    pub fn of(mesh: &TriMesh, options: &InspectionOptions) -> Self {
        let positions = mesh.positions();
        let vertex_count = positions.len();
        let triangle_count = mesh.triangles().len();
        let first: Vec<u32> = if options.weld {
            weld::first_at_position(positions)
        } else {
            (0..).take(vertex_count).collect()
        };
        let is_welded = |vertex: u32| first[vertex as usize] != vertex;
        let welded_count = (0..).take(vertex_count).filter(|&vertex| is_welded(vertex)).count();
        let triangles = if welded_count == 0 {
            Cow::Borrowed(mesh.triangles())
        } else {
            let weld = |corners: &[u32; 3]| corners.map(|vertex| first[vertex as usize]);
            Cow::Owned(mesh.triangles().iter().map(weld).collect())
        };
        let face_count = triangles.iter().filter(|&&corners| is_proper(corners)).count();
        let mut topology = Topology::new(
            &Stars::new(vertex_count, &triangles),
            triangle_count,
            triangle_count - face_count,
            options.pole_degree,
        );
        topology.isolated.retain(|&vertex| !is_welded(vertex));
        topology.poles.sort_by_key(|pole| (std::cmp::Reverse(pole.degree), pole.vertex));
        let used_count = vertex_count - welded_count - topology.isolated.len();
        let Shapes { quality, worst_triangles, zero_area_triangles } = Shapes::of(mesh);

        let loops = topology.boundary.loops();
        let boundary_loop_count = loops.iter().filter(|boundary| boundary.closed).count();
        let euler_characteristic =
            used_count as i64 - topology.edge_count as i64 + face_count as i64;
        let is_manifold =
            topology.non_manifold_edges.is_empty() && topology.non_manifold_vertices.is_empty();
        let outline = match &loops[..] {
            [outline]
                if is_manifold && topology.component_count == 1 && euler_characteristic == 1 =>
            {
                if outline.vertices.len() == used_count {
                    let corner_angle = options.corner_angle;
                    convex_outline::convex_outline(&outline.vertices, positions, corner_angle)
                } else {
                    Err(NoConvexOutline::InteriorVertices)
                }
            }
            _ => Err(NoConvexOutline::NotADisk),
        };
        Self {
            vertex_count,
            welded_count,
            triangle_count,
            face_count,
            edge_count: topology.edge_count,
            boundary_edge_count: topology.boundary.edge_count(),
            boundary_loop_count,
            open_boundary_count: loops.len() - boundary_loop_count,
            component_count: topology.component_count,
            euler_characteristic,
            non_manifold_edges: topology.non_manifold_edges,
            non_manifold_vertices: topology.non_manifold_vertices,
            inconsistent_edges: topology.inconsistent_edges,
            duplicate_triangles: topology.duplicates,
            zero_area_triangles,
            unreferenced_vertices: topology.isolated,
            boundary_degrees: topology.boundary_degrees,
            interior_degrees: topology.interior_degrees,
            highest_degree: topology.highest,
            poles: topology.poles,
            quality,
            worst_triangles,
            outline,
        }
    }

    /// The degree of `highest_degree`; 0 if there is no face.
    #[must_use]
    pub fn max_degree(&self) -> u32 {
        self.highest_degree.map_or(0, |highest| highest.degree)
    }
}
