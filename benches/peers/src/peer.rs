//! The programs, each called in the way that suits it best.
//!
//! Timed is the program's own work on its own types; converting points before and triangles after
//! is not, where nothing else is said.

use crate::clock::Clock;
use crate::input::Input;
use crate::shewchuk;
use i_triangle::float::triangulation::{RawTriangulation, Triangulation};
use i_triangle::float::unchecked::UncheckedTriangulatable;
use mindeg::BoundaryMesh;
use mindeg_compare::Reference;
use mindeg_core::least_degree_triangulation;
use std::collections::{HashMap, HashSet};
use std::error::Error;

/// A program to run.
pub(crate) struct Peer {
    /// For the command line.
    pub(crate) id: &'static str,
    /// For the tables.
    pub(crate) name: &'static str,
    /// The package that it comes from.
    pub(crate) package: &'static str,
    /// Under which licence.
    pub(crate) licence: &'static str,
    /// How it is called.
    pub(crate) called: &'static str,
    /// Its triangles, and the time they take on the clock.
    pub(crate) run: fn(&Input, &mut Clock<'_>) -> Triangles,
}

/// The triangles' vertices, or why there are none.
pub(crate) type Triangles = Result<Vec<[u32; 3]>, Box<dyn Error>>;

const FREE: &str = "MIT or Apache-2.0";

/// mindeg as its users call it, which the others are measured by, comes first.
pub(crate) const PEERS: [Peer; 12] = [
    Peer {
        id: "mindeg",
        name: "mindeg",
        package: "mindeg-geometry",
        licence: FREE,
        called: "`BoundaryMesh::least_degree` from corners and counts, which computes the points and \
                 chooses the plan that looks best on them; then all triangles into a new list",
        run: |input, clock| clock.time(|| mindeg(input)),
    },
    Peer {
        id: "mindeg-first",
        name: "mindeg, not choosing",
        package: "mindeg-core",
        licence: FREE,
        called: "`least_degree_triangulation` from counts, then `fill_triangles` into a new list; \
                 never looks at a point",
        run: |input, clock| clock.time(|| mindeg_without_choosing(input)),
    },
    Peer {
        id: "spade-bisect",
        name: "spade, ring bisected",
        package: "spade",
        licence: FREE,
        called: "points inserted every 2^j-th first, each with a neighbour as the hint, the \
                 boundary as constraints, faces outside dropped; timed with it are the checks of \
                 coordinates and reading the faces out",
        run: |input, clock| {
            let domain = input.domain()?;
            let boundary = domain.boundary()?;
            let run = || Reference::Delaunay.triangulate_without_limit(&domain, &boundary);
            Ok(clock.time(run)?)
        },
    },
    Peer {
        id: "spade-bulk",
        name: "spade, bulk load",
        package: "spade",
        licence: FREE,
        called: "`bulk_load_cdt` with the boundary as constraints, which takes a copy of both that is \
                 timed with it; faces outside dropped",
        run: spade_bulk_load,
    },
    Peer {
        id: "triangle",
        name: "Triangle",
        package: shewchuk::PACKAGE,
        licence: "not free for commercial use",
        called: "Shewchuk's C through its Python binding: divide and conquer, the boundary as \
                 segments (`-p`), points and segments not copied back (`-N -P -B`)",
        run: shewchuk::run,
    },
    Peer {
        id: "delaunator",
        name: "delaunator",
        package: "delaunator",
        licence: "ISC",
        called: "`triangulate`; knows no constraints",
        run: delaunator,
    },
    Peer {
        id: "cdt",
        name: "cdt",
        package: "cdt",
        licence: FREE,
        called: "`triangulate_contours` with the boundary as the contour",
        run: cdt,
    },
    Peer {
        id: "i-triangle",
        name: "i_triangle",
        package: "i_triangle",
        licence: FREE,
        called: "`unchecked_triangulate`, which keeps the points inside sides",
        run: |input, clock| i_triangle(input, clock, |raw| raw.to_triangulation()),
    },
    Peer {
        id: "i-triangle-delaunay",
        name: "i_triangle, Delaunay",
        package: "i_triangle",
        licence: FREE,
        called: "the same, then `into_delaunay`",
        run: |input, clock| i_triangle(input, clock, |raw| raw.into_delaunay().to_triangulation()),
    },
    Peer {
        id: "earcut",
        name: "earcut",
        package: "earcut",
        licence: FREE,
        called: "`Earcut::earcut`",
        run: |input, clock| ear_clipping(input, clock, |_, _| ()),
    },
    Peer {
        id: "earcut-refine",
        name: "earcut, refined",
        package: "earcut",
        licence: FREE,
        called: "`Earcut::earcut`, then `refine`: flips towards Delaunay",
        run: |input, clock| ear_clipping(input, clock, earcut::refine),
    },
    Peer {
        id: "lyon",
        name: "lyon",
        package: "lyon_tessellation",
        licence: FREE,
        called: "`FillTessellator::tessellate_with_ids`, intersections off; single precision",
        run: lyon,
    },
];

/// From corners and counts to the list of triangles of the plan chosen.
pub(crate) fn mindeg(input: &Input) -> Triangles {
    Ok(BoundaryMesh::least_degree(&input.domain()?)?.triangles().collect())
}

fn mindeg_without_choosing(input: &Input) -> Triangles {
    let triangulation = least_degree_triangulation(&input.new_boundary()?);
    let mut triangles = vec![[0; 3]; triangulation.triangle_count() as usize];
    triangulation.fill_triangles(0, &mut triangles);
    Ok(triangles)
}

fn spade_bulk_load(input: &Input, clock: &mut Clock<'_>) -> Triangles {
    use spade::{ConstrainedDelaunayTriangulation, Point2, RefinementParameters, Triangulation};
    let points: Vec<Point2<f64>> = input.points.iter().map(|p| p.to_array().into()).collect();
    let ring: Vec<[usize; 2]> = input.ring().collect();
    let load = || {
        ConstrainedDelaunayTriangulation::<Point2<f64>>::bulk_load_cdt(points.clone(), ring.clone())
    };
    let mut loaded = clock.time(load)?;
    // spade's own way to tell which faces are outside.
    let nothing_but =
        RefinementParameters::new().exclude_outer_faces(true).with_max_additional_vertices(0);
    let outside: HashSet<_> = loaded.refine(nothing_but).excluded_faces.into_iter().collect();
    let inside = loaded.inner_faces().filter(|face| !outside.contains(&face.fix()));
    Ok(inside.map(|face| face.vertices().map(|vertex| vertex.fix().index() as u32)).collect())
}

fn delaunator(input: &Input, clock: &mut Clock<'_>) -> Triangles {
    let points: Vec<delaunator::Point> =
        input.points.iter().map(|p| delaunator::Point { x: p.x, y: p.y }).collect();
    Ok(threes(&clock.time(|| delaunator::triangulate(&points)).triangles))
}

fn cdt(input: &Input, clock: &mut Clock<'_>) -> Triangles {
    let points: Vec<(f64, f64)> = input.points.iter().map(|p| (p.x, p.y)).collect();
    let ring: [Vec<usize>; 1] = [(0..points.len()).chain([0]).collect()];
    let triangles = clock.time(|| cdt::triangulate_contours(&points, &ring))?;
    Ok(triangles.into_iter().map(|(a, b, c)| [a, b, c].map(|vertex| vertex as u32)).collect())
}

fn i_triangle(
    input: &Input,
    clock: &mut Clock<'_>,
    finish: impl Fn(RawTriangulation<[f64; 2]>) -> Triangulation<[f64; 2], u32>,
) -> Triangles {
    let points: Vec<[f64; 2]> = input.points.iter().map(|p| p.to_array()).collect();
    let (mesh, grid) = clock.time(|| {
        let raw = points.unchecked_triangulate();
        let grid = raw.adapter.clone();
        (finish(raw), grid)
    });
    // It sorts the points, and rounds them to a grid.
    let on_grid = |point| grid.int_to_float(&grid.float_to_int(point)).map(f64::to_bits);
    let ids: HashMap<[u64; 2], u32> = points.iter().map(on_grid).zip(0..).collect();
    let vertex = |&index: &u32| {
        let point = mesh.points[index as usize].map(f64::to_bits);
        ids.get(&point).copied().unwrap_or(u32::MAX)
    };
    Ok(threes(&mesh.indices.iter().map(vertex).collect::<Vec<_>>()))
}

fn ear_clipping(
    input: &Input,
    clock: &mut Clock<'_>,
    finish: impl Fn(&mut [u32], &[[f64; 2]]),
) -> Triangles {
    let points: Vec<[f64; 2]> = input.points.iter().map(|p| p.to_array()).collect();
    let indices: Vec<u32> = clock.time(|| {
        let mut indices = Vec::new();
        earcut::Earcut::new().earcut_slice(&points, &[], &mut indices);
        finish(&mut indices, &points);
        indices
    });
    Ok(threes(&indices))
}

fn lyon(input: &Input, clock: &mut Clock<'_>) -> Triangles {
    use lyon_tessellation::math::{Point, point};
    use lyon_tessellation::path::{EndpointId, polygon::IdPolygon};
    use lyon_tessellation::{
        BuffersBuilder, FillOptions, FillTessellator, FillVertex, VertexBuffers,
    };
    let points: Vec<Point> = input.points.iter().map(|p| point(p.x as f32, p.y as f32)).collect();
    let ids: Vec<EndpointId> = (0..points.len() as u32).map(EndpointId).collect();
    let polygon = IdPolygon { points: &ids, closed: true };
    let options = FillOptions::default().with_intersections(false);
    let buffers = clock.time(|| {
        let mut buffers: VertexBuffers<u32, u32> = VertexBuffers::new();
        let vertex = |vertex: FillVertex<'_>| vertex.as_endpoint_id().map_or(u32::MAX, |id| id.0);
        let mut builder = BuffersBuilder::new(&mut buffers, vertex);
        let positions = (&points[..], &[][..]);
        FillTessellator::new()
            .tessellate_with_ids(polygon.iter(), &positions, None, &options, &mut builder)
            .map(|()| buffers)
    })?;
    let vertices = buffers.indices.iter().map(|&index| buffers.vertices[index as usize]);
    Ok(threes(&vertices.collect::<Vec<_>>()))
}

/// A list of vertices as triangles.
fn threes<T: Copy + TryInto<u32>>(vertices: &[T]) -> Vec<[u32; 3]> {
    let id = |vertex: T| vertex.try_into().unwrap_or(u32::MAX);
    vertices.chunks_exact(3).map(|of| [id(of[0]), id(of[1]), id(of[2])]).collect()
}
