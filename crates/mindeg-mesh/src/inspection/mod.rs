//! The contents of a triangle mesh: how its faces connect, its defects, the degrees of its
//! vertices, and the quality of its triangles.
//!
//! Meshes may come from any program: with interior vertices, in several components, closed, or
//! broken. An [`Inspection`] counts and names; it repairs nothing.
//!
//! # Definitions
//!
//! - *Welding.* Files repeat a vertex where its normal or texture coordinates change, glTF with
//!   flat shading at every triangle. An inspection wants the mesh in space, so vertices with equal
//!   coordinates count as one, with the index of the first. With a tolerance in
//!   [`InspectionOptions::weld`], vertices no farther apart than it count as one too; then all
//!   vertices of a chain of near vertices become one, however long it is. No position changes.
//! - *Faces.* The polygons of the mesh, or its triangles if it has no other polygons. Corners that
//!   repeat the previous one (after welding) count once, and a path along an edge and straight back
//!   does not count; a face needs at least three remaining corners. Edges, degrees, loops,
//!   components and duplicates refer to the faces. The measures of quality refer to all triangles,
//!   with their corners before welding.
//! - *Degree.* The number of edges at a vertex, boundary edges included.
//! - *Boundary.* Edges with one face; vertices on such edges are boundary vertices, all others
//!   interior. An edge with three faces or more is not manifold; neither is a vertex at which
//!   the faces form several fans, each joined by edges, as where two cones meet at their tips.
//! - *Components.* Sets of faces joined by edges. Faces that touch only in a vertex count apart.
//! - *Euler characteristic.* Vertices in faces, minus edges, plus faces: 2 for a sphere, 0 for a
//!   torus, 1 for a disk, if the mesh is manifold.
//! - *Duplicate.* A face with the corners of an earlier face, in the same order or the reverse.
//! - *Zero area.* A triangle whose corners are exactly on one line or at one point; no tolerance
//!   applies. A triangle that was flat before its corners were rounded may have a tiny area; its
//!   minimum angle shows it.
//! - *Inconsistent winding.* An edge along which its two faces run in the same direction, so that
//!   one face shows its front and the other its back.
//!
//! Limits: does not look for self-intersections. A face that touches itself is a face like others.

mod convex_outline;
mod shapes;
mod topology;

pub use convex_outline::{FoundOutline, NoConvexOutline};
pub use topology::VertexDegree;

use crate::connectivity::faces::Faces;
use crate::quality::{DegreeHistogram, QualitySummary, WorstTriangles};
use crate::tri_mesh::TriMesh;
use crate::weld;
use shapes::shapes;
use topology::Topology;

/// The maximum length of [`Inspection::worst_triangles`].
pub const WORST: usize = 5;

/// The choices of an [`Inspection`].
///
/// # Example
///
/// ```
/// use mindeg_mesh::inspection::InspectionOptions;
///
/// let options = InspectionOptions { pole_degree: 6, ..InspectionOptions::default() };
/// assert_eq!(options.weld, Some(0.0));
/// assert_eq!(options.corner_angle, 1.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InspectionOptions {
    /// The largest distance of two vertices that count as one, in units of length; 0, the default,
    /// means equal coordinates only, `None` means that no two vertices count as one.
    pub weld: Option<f64>,
    /// Vertices of a greater degree are poles; 8 by default.
    pub pole_degree: u32,
    /// By how many degrees an outline must turn at a vertex for it to be a corner, 0 to 90; 1 by
    /// default. A side may bend as far as an arc that leaves its chord by that angle. A value below
    /// 0.001 counts as 0.001.
    pub corner_angle: f64,
}

impl Default for InspectionOptions {
    fn default() -> Self {
        Self { weld: Some(0.0), pole_degree: 8, corner_angle: 1.0 }
    }
}

/// The findings on a mesh; the [module](self) defines the terms.
///
/// Vertices, faces and triangles have their indices in the mesh; a welded vertex has the index of
/// the vertex that replaces it. All lists are in ascending order, except the worst triangles and
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
    /// The number of vertices that count as one with an earlier vertex.
    pub welded_count: usize,
    /// The number of triangles in the mesh.
    pub triangle_count: usize,
    /// The number of faces.
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
    /// Faces that repeat an earlier one: indices of polygons, or of triangles if the mesh has no
    /// other polygons.
    pub duplicate_faces: Vec<u32>,
    /// Triangles without area.
    pub zero_area_triangles: Vec<u32>,
    /// Vertices in no face, without the vertices that are welded to another.
    pub unreferenced_vertices: Vec<u32>,
    /// The number of boundary vertices of each degree.
    pub boundary_degrees: DegreeHistogram,
    /// The number of interior vertices of each degree.
    pub interior_degrees: DegreeHistogram,
    /// The first of the vertices with the highest degree; `None` if the mesh has no face.
    pub highest_degree: Option<VertexDegree>,
    /// The vertices of a higher degree than [`InspectionOptions::pole_degree`], highest first.
    pub poles: Vec<VertexDegree>,
    /// The measures of all triangles.
    pub quality: QualitySummary,
    /// The triangles with the least minimum angles, at most [`WORST`].
    pub worst_triangles: WorstTriangles,
    /// The volume inside, positive if triangles are counter-clockwise seen from outside, in cubed
    /// units of length; `None` if the mesh is not closed and consistently wound, or if f64
    /// overflows.
    pub volume: Option<f64>,
    /// The outline as a convex polygon, or why it is not one.
    pub outline: Result<FoundOutline, NoConvexOutline>,
}

impl Inspection {
    /// Inspects a mesh. O(n log n) time and O(n) memory for n vertices and triangles, except for
    /// welding with a tolerance near the rounding of the coordinates.
    pub fn of(mesh: &TriMesh, options: &InspectionOptions) -> Self {
        let positions = mesh.positions();
        let vertex_count = positions.len();
        let merged = options.weld.map(|tolerance| weld(positions, tolerance));
        let is_welded =
            |vertex: u32| merged.as_ref().is_some_and(|merged| merged[vertex as usize] != vertex);
        let welded_count = (0..).take(vertex_count).filter(|&vertex| is_welded(vertex)).count();
        let faces = Faces::new(
            mesh.triangles(),
            mesh.polygons(),
            merged.as_deref().filter(|_| welded_count > 0),
        );
        let mut topology = Topology::new(vertex_count, &faces, options.pole_degree);
        topology.isolated.retain(|&vertex| !is_welded(vertex));
        topology.poles.sort_by_key(|pole| (std::cmp::Reverse(pole.degree), pole.vertex));
        let face_count = topology.face_count;
        let used_count = vertex_count - welded_count - topology.isolated.len();
        let (quality, worst_triangles, zero_area_triangles) = shapes(mesh, WORST);

        let loops = topology.boundary.loops();
        let boundary_loop_count = loops.iter().filter(|boundary| boundary.closed).count();
        let euler_characteristic =
            used_count as i64 - topology.edge_count as i64 + face_count as i64;
        let mut inspection = Self {
            vertex_count,
            welded_count,
            triangle_count: mesh.triangles().len(),
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
            duplicate_faces: topology.duplicates,
            zero_area_triangles,
            unreferenced_vertices: topology.isolated,
            boundary_degrees: topology.boundary_degrees,
            interior_degrees: topology.interior_degrees,
            highest_degree: topology.highest,
            poles: topology.poles,
            quality,
            worst_triangles,
            volume: None,
            outline: Err(NoConvexOutline::NotADisk),
        };
        if inspection.has_inside() {
            inspection.volume = Some(volume(mesh)).filter(|volume| volume.is_finite());
        }
        let is_disk = inspection.is_manifold()
            && inspection.component_count == 1
            && euler_characteristic == 1;
        if let ([outline], true) = (&loops[..], is_disk) {
            inspection.outline = if outline.vertices.len() == used_count {
                let points: Vec<_> =
                    outline.vertices.iter().map(|&v| positions[v as usize]).collect();
                // A welded vertex may be as far away as the vertices that it is merged with.
                let weld = options.weld.filter(|_| welded_count > 0).unwrap_or(0.0);
                let rounding = mesh.rounding().max(weld);
                convex_outline::convex_outline(&points, rounding, options.corner_angle)
                    .map(|found| found.named(&outline.vertices))
            } else {
                Err(NoConvexOutline::InteriorVertices)
            };
        }
        inspection
    }

    fn has_inside(&self) -> bool {
        self.is_closed() && self.is_manifold() && self.inconsistent_edges.is_empty()
    }

    /// Whether every edge has at least two faces.
    pub fn is_closed(&self) -> bool {
        self.boundary_edge_count == 0 && self.face_count > 0
    }

    /// Whether no edge has more than two faces, and faces form one fan at every vertex.
    pub fn is_manifold(&self) -> bool {
        self.non_manifold_edges.is_empty() && self.non_manifold_vertices.is_empty()
    }

    /// The number of handles of all components together: 0 for a sphere, 1 for a torus; `None` if
    /// the mesh is not closed, manifold and consistently wound.
    pub fn genus(&self) -> Option<u64> {
        let doubled = 2 * self.component_count as i64 - self.euler_characteristic;
        self.has_inside().then_some(doubled.max(0) as u64 / 2)
    }

    /// The degree of `highest_degree`; 0 if the mesh has no face.
    pub fn max_degree(&self) -> u32 {
        self.highest_degree.map_or(0, |highest| highest.degree)
    }
}

/// The signed volume of a closed mesh, by tetrahedra from its first vertex.
fn volume(mesh: &TriMesh) -> f64 {
    let positions = mesh.positions();
    let origin = positions.first().copied().unwrap_or_default();
    let of = |corners: &[u32; 3]| {
        let [a, b, c] = corners.map(|vertex| positions[vertex as usize] - origin);
        a.dot(b.cross(c))
    };
    mesh.triangles().iter().map(of).sum::<f64>() / 6.0
}
