//! A domain's mesh: of the candidates with the least maximum degree, the one with the largest minimum
//! angle on the actual points; or any other triangulation, given as a list.
//!
//! Work over every triangle uses all threads, and gives the same results however many
//! there are.
//!
//! Limits: the best of the candidates tried is not the best triangulation of that degree, let alone
//! of any degree.

mod angles;
mod choice;
mod faces;
mod flat;
mod inside;
mod measures;
mod source;

use std::ops::Range;

use glam::DVec2;

use crate::error::MeshError;
use crate::regions::{groups, lines_of_map};
use mindeg_domain::{Domain, Placement, Rings};
use mindeg_mesh::check::{self, CheckError, Checked};
use mindeg_mesh::parallel::{fill_blocks, first_of_blocks};
use mindeg_mesh::planar::PlanarBoundary;
use mindeg_mesh::{Group, Progress};

use self::angles::{cotangents, placed};
use self::faces::{Faces, TriangleList};
pub(crate) use self::flat::first_flat;
pub use self::measures::AngleRange;
#[cfg(feature = "interior")]
pub(crate) use self::source::{lines, periodic_lines};

/// A triangulation of a domain's boundary vertices, and their positions.
///
/// A mesh of [least degree](Self::least_degree) stores nothing per vertex or triangle: both follow
/// from formulas. So a mesh of billions of triangles can be made, asked and written in the memory
/// of a small one. Only a mesh [with given triangles](Self::with_triangles) stores these.
///
/// # Example
///
/// ```
/// use mindeg::{Domain, BoundaryMesh, Side};
///
/// let domain = Domain::rectangle(4.0, 3.0, [3, 3, 2, 2].map(Side::count).into())?;
/// let mesh = BoundaryMesh::least_degree(&domain)?;
/// assert_eq!((mesh.vertex_count(), mesh.triangle_count()), (10, 8));
/// assert_eq!(mesh.max_degree(), 4);
/// assert_eq!(mesh.point(3).to_array(), [4.0, 0.0]);
/// let area: f64 = mesh.qualities().map(|quality| quality.area).sum();
/// assert!((area - 12.0).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct BoundaryMesh {
    domain: Domain,
    triangulation: Faces,
    /// The regions of the domain, which have the triangles in order.
    groups: Vec<Group>,
    /// The degrees of vertices of rings in the mesh joined at periodic sides; none without such sides.
    joined: Vec<u32>,
}

impl BoundaryMesh {
    /// The mesh with the least possible maximum degree that is best on the domain's points.
    ///
    /// The core's constructions leave choices open, all of the same degree
    /// ([`Candidates`](mindeg_core::Candidates)). The mesh takes the candidate with the largest
    /// minimum angle. Of candidates whose cotangents of that angle agree to 1 part in 10⁹ it takes
    /// the first, so that the rounding of mirror images decides nothing.
    ///
    /// O(n) time, shared by all threads; 16 MiB of points at most are kept meanwhile. At most 64
    /// candidates are tried, spread evenly over all, and fewer where they would have more than 2^25
    /// triangles together, but at least two if there are two. A candidate is dropped at a triangle
    /// that is no better than the worst one of the best candidate. Angles are compared by their
    /// cotangents, which take only the four basic operations: so the choice is the same on every
    /// machine, and with any number of threads.
    ///
    /// # Errors
    ///
    /// Points so close that some triangle has no area in f64, and constraints on the domain's
    /// degrees, which the formula ignores.
    pub fn least_degree(domain: &Domain) -> Result<Self, MeshError> {
        Self::of_formula(domain, Progress::NONE)
    }

    /// [`least_degree`](Self::least_degree), with reports to `progress`.
    pub(crate) fn of_formula(domain: &Domain, progress: Progress<'_>) -> Result<Self, MeshError> {
        if domain.is_constrained() {
            return Err(MeshError::Constrained);
        }
        let form = domain.convex().ok_or_else(MeshError::not_convex)?;
        let formula = choice::best_candidate(form, domain.placement(), progress)?;
        let triangulation = Faces::Formula(formula);
        Ok(Self { domain: domain.clone(), triangulation, groups: Vec::new(), joined: Vec::new() })
    }

    /// The mesh with the given triangles, region by region and else in their order; vertices have the indices of the
    /// domain's: those of the rings, then those [inside](Domain::inner_points).
    ///
    /// The domain's constraints on degrees are ignored. O(n log n) time, O(n) memory.
    ///
    /// # Errors
    ///
    /// Triangles that do not triangulate the domain ([`mindeg_mesh::check`] says why), or one that has
    /// no area in f64 or all vertices on one straight side.
    ///
    /// # Example
    ///
    /// ```
    /// use mindeg::{Domain, BoundaryMesh, Side};
    ///
    /// let domain = Domain::rectangle(4.0, 3.0, vec![Side::count(1); 4])?;
    /// let mesh = BoundaryMesh::with_triangles(&domain, vec![[0, 1, 2], [0, 2, 3]])?;
    /// assert_eq!([0, 1, 2, 3].map(|vertex| mesh.degree(vertex)), [3, 2, 3, 2]);
    /// assert!(BoundaryMesh::with_triangles(&domain, vec![[0, 1, 2], [0, 1, 3]]).is_err());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn with_triangles(domain: &Domain, triangles: Vec<[u32; 3]>) -> Result<Self, MeshError> {
        Self::checked(domain, &*domain.boundary()?, triangles)
    }

    /// The mesh with the given triangles, of a domain with this boundary.
    pub(crate) fn checked(
        domain: &Domain,
        boundary: &PlanarBoundary,
        triangles: Vec<[u32; 3]>,
    ) -> Result<Self, MeshError> {
        if let Some(index) = first_flat(boundary, &triangles) {
            let triangle = triangles[index as usize];
            return Err(MeshError::Refused(format!(
                "the triangles are no mesh of the domain: triangle {triangle:?} is flat"
            )));
        }
        let open = lines_of_map(domain, boundary, &triangles)?;
        let inner = boundary.inner_points();
        let checked = match check::triangulation_around(boundary, inner, &open, &triangles) {
            // The triangles hang together: if they do not cover the domain, rounding is why.
            Err(CheckError::NotCounterClockwise { triangle }) => {
                return Err(MeshError::no_area(triangles[triangle]));
            }
            checked => checked?,
        };
        let Checked { degrees, max_degree } = checked;
        let segments = boundary.segments().iter().map(std::slice::from_ref);
        let (triangles, groups) = groups(domain, boundary, segments, triangles);
        let mut joined = Vec::new();
        if let Some(periodic) = domain.periodic() {
            joined.extend(&degrees[..boundary.vertex_count() as usize]);
            periodic.join(&mut joined);
        }
        let list = TriangleList { triangles, degrees, max_degree };
        let triangulation = Faces::List(list);
        let mesh = Self { domain: domain.clone(), triangulation, groups, joined };
        let without_area = first_of_blocks(mesh.triangle_count(), |range| {
            let placed = mesh.triangles_of(range.clone()).zip(mesh.placed_triangles_of(range));
            let mut flat = placed.filter(|&(_, points)| cotangents(points)[0] == f64::INFINITY);
            flat.next().map(|(triangle, _)| triangle)
        });
        match without_area {
            Some(triangle) => Err(MeshError::no_area(triangle)),
            None => Ok(mesh),
        }
    }

    /// The domain.
    pub fn domain(&self) -> &Domain {
        &self.domain
    }

    /// The domain's boundary: sides, corners, counts.
    pub fn rings(&self) -> &Rings {
        self.domain.rings()
    }

    /// The positions of the vertices.
    pub fn placement(&self) -> &Placement {
        self.domain.placement()
    }

    /// The number of vertices n.
    pub fn vertex_count(&self) -> u32 {
        self.triangulation.vertex_count()
    }

    /// The number of triangles: n + 2h - 2 with h holes, if no points are inside and no regions are holes.
    pub fn triangle_count(&self) -> u32 {
        self.triangulation.triangle_count()
    }

    /// The position of a vertex. O(log k) for k sides.
    ///
    /// # Panics
    ///
    /// If `vertex` is not below [`vertex_count`](Self::vertex_count).
    pub fn point(&self, vertex: u32) -> DVec2 {
        match vertex.checked_sub(self.placement().vertex_count()) {
            None => self.placement().point(vertex),
            Some(inner) => self.domain.inner_points()[inner as usize],
        }
    }

    /// The positions of all vertices, ring by ring, then those inside.
    pub fn points(&self) -> impl Iterator<Item = DVec2> + Clone + '_ {
        self.placement().points().chain(self.domain.inner_points().iter().copied())
    }

    /// Writes the positions of the vertices from `first` on into `out`, as many as it holds, with
    /// all threads of rayon's current pool (feature `parallel`). Much faster than one by one.
    ///
    /// # Panics
    ///
    /// If fewer than `out.len()` vertices remain from `first` on.
    ///
    /// # Example
    ///
    /// ```
    /// use mindeg::{BoundaryMesh, Domain, Side, glam::DVec2};
    ///
    /// let domain = Domain::rectangle(4.0, 3.0, vec![Side::count(2); 4])?;
    /// let mesh = BoundaryMesh::least_degree(&domain)?;
    /// let mut points = vec![DVec2::ZERO; mesh.vertex_count() as usize];
    /// mesh.fill_points(0, &mut points);
    /// assert!(mesh.points().eq(points));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn fill_points(&self, first: u32, out: &mut [DVec2]) {
        let left = self.vertex_count().saturating_sub(first) as usize;
        assert!(out.len() <= left, "{} vertices from {first} on do not exist", out.len());
        fill_blocks(out, |before, out| self.fill_some(first + before, out));
    }

    /// The vertices of a side from its first corner to its last, one more than its intervals.
    ///
    /// # Panics
    ///
    /// If the domain has no such side.
    ///
    /// # Example
    ///
    /// ```
    /// use mindeg::{BoundaryMesh, Domain, Side};
    ///
    /// let domain = Domain::rectangle(4.0, 3.0, [3, 3, 2, 2].map(Side::count).into())?;
    /// let mesh = BoundaryMesh::least_degree(&domain)?;
    /// assert!(mesh.side_vertices(1).eq([3, 4, 5, 6]));
    /// assert!(mesh.side_vertices(3).eq([8, 9, 0]));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn side_vertices(&self, side: usize) -> impl Iterator<Item = u32> + Clone + use<> {
        let rings = self.rings();
        let start = rings.corner(side);
        (start..start + rings.intervals(side)).chain([rings.side_end(side)])
    }

    /// The triangle with the given index, counter-clockwise. O(1).
    ///
    /// # Panics
    ///
    /// If `index` is not below [`triangle_count`](Self::triangle_count).
    pub fn triangle(&self, index: u32) -> [u32; 3] {
        self.triangulation.triangle(index)
    }

    /// All triangles, each counter-clockwise; neighbours in this order mostly share an edge, unless
    /// they were [given](Self::with_triangles) otherwise.
    pub fn triangles(&self) -> impl ExactSizeIterator<Item = [u32; 3]> + '_ {
        self.triangles_of(0..self.triangle_count())
    }

    /// The triangles of a range, in order.
    fn triangles_of(&self, range: Range<u32>) -> impl ExactSizeIterator<Item = [u32; 3]> + '_ {
        self.triangulation.triangles_of(range)
    }

    /// Writes the triangles from index `first` on into `out`, as many as it holds, with all
    /// threads of rayon's current pool (feature `parallel`).
    ///
    /// As fast as memory can be written; what is written does not depend on the threads. Memory
    /// that was never touched costs several times as much as the triangles in it: reuse a buffer
    /// rather than allocate one for each call.
    ///
    /// # Panics
    ///
    /// If fewer than `out.len()` triangles remain from `first` on.
    ///
    /// # Example
    ///
    /// ```
    /// use mindeg::{Domain, BoundaryMesh, Side};
    ///
    /// let domain = Domain::rectangle(4.0, 3.0, [3, 3, 2, 2].map(Side::count).into())?;
    /// let mesh = BoundaryMesh::least_degree(&domain)?;
    /// let mut indices = vec![[0; 3]; mesh.triangle_count() as usize];
    /// mesh.fill_triangles(0, &mut indices);
    /// assert!(mesh.triangles().eq(indices));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn fill_triangles(&self, first: u32, out: &mut [[u32; 3]]) {
        let left = self.triangle_count().saturating_sub(first) as usize;
        assert!(out.len() <= left, "{} triangles from {first} on do not exist", out.len());
        fill_blocks(out, |before, out| self.triangulation.fill(first + before, out));
    }

    /// The positions of all triangles' vertices, in the order of [`triangles`](Self::triangles).
    pub fn placed_triangles(&self) -> impl ExactSizeIterator<Item = [DVec2; 3]> + '_ {
        self.placed_triangles_of(0..self.triangle_count())
    }

    fn placed_triangles_of(
        &self,
        range: Range<u32>,
    ) -> impl ExactSizeIterator<Item = [DVec2; 3]> + '_ {
        let mut walk = self.placement().walk();
        let (on_rings, inner) = (self.placement().vertex_count(), self.domain.inner_points());
        placed(self.triangles_of(range), move |vertex| match vertex.checked_sub(on_rings) {
            None => walk.point(vertex),
            Some(inside) => inner[inside as usize],
        })
    }

    /// The number of edges at a vertex, the two along the boundary included. O(1).
    ///
    /// # Panics
    ///
    /// If `vertex` is not below [`vertex_count`](Self::vertex_count).
    pub fn degree(&self, vertex: u32) -> u32 {
        self.triangulation.degree(vertex)
    }

    /// The largest degree. O(1).
    pub fn max_degree(&self) -> u32 {
        self.triangulation.max_degree()
    }

    /// The neighbours of a vertex, counter-clockwise: from the next vertex of its ring to the previous
    /// one; of a vertex inside from any, and of a vertex between holes those of one fan after the other. O(degree) for a mesh of least degree, O(n) for one with given triangles.
    ///
    /// # Panics
    ///
    /// If `vertex` is not below [`vertex_count`](Self::vertex_count).
    ///
    /// # Example
    ///
    /// ```
    /// use mindeg::{BoundaryMesh, Domain, Side};
    ///
    /// let domain = Domain::rectangle(4.0, 3.0, vec![Side::count(1); 4])?;
    /// let mesh = BoundaryMesh::with_triangles(&domain, vec![[0, 1, 2], [0, 2, 3]])?;
    /// assert_eq!(mesh.neighbors(2), [3, 0, 1]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn neighbors(&self, vertex: u32) -> Vec<u32> {
        self.triangulation.neighbors(vertex)
    }

    /// The total degree of a vertex: its degree in this mesh, or in the one that is joined at periodic sides, plus its
    /// external degree. O(log n).
    ///
    /// # Panics
    ///
    /// If `vertex` is not below [`vertex_count`](Self::vertex_count).
    pub fn total_degree(&self, vertex: u32) -> u32 {
        let is_inside = vertex >= self.placement().vertex_count();
        let external = if is_inside { 0 } else { self.domain.external_degree(vertex) };
        let own = self.joined.get(vertex as usize).copied();
        own.unwrap_or_else(|| self.degree(vertex)).saturating_add(external)
    }

    /// The largest total degree. O(1) without constraints, otherwise O(n log n).
    pub fn max_total_degree(&self) -> u32 {
        if !self.domain.is_constrained() && self.joined.is_empty() {
            return self.max_degree();
        }
        (0..self.vertex_count()).map(|vertex| self.total_degree(vertex)).fold(0, u32::max)
    }
}

/// The points of a domain, by vertex.
pub(crate) fn points_of(domain: &Domain) -> Vec<DVec2> {
    let placement = domain.placement();
    let mut points = vec![DVec2::ZERO; placement.vertex_count() as usize];
    fill_blocks(&mut points, |first, points| placement.fill_points(first, points));
    points
}

#[cfg(test)]
mod tests {
    use super::*;
    use mindeg_domain::{
        Constraints, Outline, Rectangle, Side, SideConstraint, Spacing, VertexConstraint,
    };

    #[test]
    fn points_are_the_same_kept_or_not() {
        let domain = Domain::rectangle(4.0, 3.0, [9, 7, 5, 2].map(Side::count).into()).unwrap();
        let mesh = BoundaryMesh::least_degree(&domain).unwrap();
        let one_by_one = mesh.triangles().map(|triangle| triangle.map(|v| mesh.point(v)));
        assert!(mesh.placed_triangles().eq(one_by_one));
    }

    #[test]
    fn a_list_is_as_good_as_the_formula() {
        let domain = Domain::rectangle(4.0, 3.0, [9, 7, 5, 2].map(Side::count).into()).unwrap();
        let formula = BoundaryMesh::least_degree(&domain).unwrap();
        let list = BoundaryMesh::with_triangles(&domain, formula.triangles().collect()).unwrap();
        assert_eq!(list.vertex_count(), formula.vertex_count());
        assert_eq!(list.triangle_count(), formula.triangle_count());
        assert!(list.triangles().eq(formula.triangles()));
        assert!((0..21).all(|index| list.triangle(index) == formula.triangle(index)));
        assert!((0..23).all(|vertex| list.degree(vertex) == formula.degree(vertex)));
        assert!((0..23).all(|vertex| list.neighbors(vertex) == formula.neighbors(vertex)));
        assert!((0..23).all(|vertex| list.neighbors(vertex).len() as u32 == list.degree(vertex)));
        assert_eq!(list.max_degree(), formula.max_degree());
        assert_eq!(list.angle_range(), formula.angle_range());
    }

    #[test]
    fn refuses_what_is_no_mesh_of_the_domain() {
        let square =
            |sides: [u64; 4]| Domain::rectangle(1.0, 1.0, sides.map(Side::count).into()).unwrap();
        let refused = |domain: &Domain, triangles: &[[u32; 3]]| {
            BoundaryMesh::with_triangles(domain, triangles.to_vec()).unwrap_err().to_string()
        };
        let too_few = refused(&square([1; 4]), &[[0, 1, 2]]);
        assert!(
            too_few.starts_with("the triangles are no mesh of the domain: found 1"),
            "{too_few}"
        );
        assert!(
            refused(&square([2, 1, 1, 1]), &[[0, 1, 2], [0, 2, 3], [0, 3, 4]]).contains("flat")
        );

        let limits = vec![SideConstraint { degree_limit: Some(9), ..Default::default() }; 4];
        let limited = constrained(Constraints { sides: limits, vertices: Vec::new() });
        assert_eq!(BoundaryMesh::least_degree(&limited), Err(MeshError::Constrained));
        assert!(BoundaryMesh::with_triangles(&limited, vec![[0, 1, 2], [0, 2, 3]]).is_ok());
    }

    /// The unit square with one interval to a side.
    fn constrained(constraints: Constraints) -> Domain {
        let outline = Outline::Rectangle(Rectangle::new(1.0, 1.0));
        Domain::builder(outline, vec![Side::count(1); 4]).constraints(constraints).build().unwrap()
    }

    #[test]
    fn external_degrees_count_towards_the_total() {
        let total = |vertex, external_degree| {
            let constraint = VertexConstraint { vertex, external_degree, degree_limit: None };
            let constraints = Constraints { sides: Vec::new(), vertices: vec![constraint] };
            let domain = constrained(constraints);
            let mesh = BoundaryMesh::with_triangles(&domain, vec![[0, 1, 2], [0, 2, 3]]).unwrap();
            assert_eq!(
                (mesh.max_degree(), mesh.total_degree(vertex)),
                (3, mesh.degree(vertex) + external_degree)
            );
            mesh.max_total_degree()
        };
        let square = constrained(Constraints::default());
        assert_eq!(BoundaryMesh::least_degree(&square).unwrap().max_total_degree(), 3);
        assert_eq!([total(0, 4), total(1, 4), total(3, 1)], [7, 6, 3]);
    }

    /// Points are apart, and yet a triangle between two slanted sides is too thin for f64.
    #[test]
    fn refuses_a_mesh_with_a_triangle_that_rounding_turns_over() {
        let sides = [(7, 33.65), (2, 2.0575e10), (4, 1018.57), (4, 0.1683)]
            .map(|(m, ratio)| Side::count(m).spaced(Spacing::Geometric { ratio }));
        let origin = DVec2::splat(881.702_365_756_015_1);
        let rectangle = Rectangle { origin, rotation: 30.0, ..Rectangle::new(1.0, 0.308) };
        let domain = Domain::new(Outline::Rectangle(rectangle), sides.into()).unwrap();
        let error = BoundaryMesh::least_degree(&domain).unwrap_err();
        assert!(error.to_string().starts_with("triangle [7, 8, 10] is so thin"), "{error}");

        let formula = mindeg_core::least_degree_triangulation(domain.convex().unwrap().boundary());
        let error =
            BoundaryMesh::with_triangles(&domain, formula.triangles().collect()).unwrap_err();
        assert!(error.to_string().contains("has no area"), "{error}");
    }
}
