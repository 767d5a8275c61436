//! Draws the figures of `docs/theory.md` into a folder: `theory_figures docs/figures`.
//!
//! Each figure is what the library makes, not what somebody drew.

use std::error::Error;
use std::path::Path;

use mindeg::glam::{DVec2, DVec3};
use mindeg::{BoundaryMesh, Domain, Goal, Mesh, Outline as Shape, Progress, Ring, Side, TriMesh};
use mindeg_core::{Boundary, RingStrip, suggest};
use mindeg_exact::{DegreeRange, LowerBound, Problem, Reached, degree_range};
use mindeg_formats::svg;
use mindeg_interior::limits;
use mindeg_mesh::planar::PlanarBoundary;

fn main() -> Result<(), Box<dyn Error>> {
    let folder = std::env::args().nth(1).ok_or("name the folder to write into")?;
    for (name, figure) in figures()? {
        let mut file = Vec::new();
        svg::write(&*figure, &mut file)?;
        std::fs::write(Path::new(&folder).join(name), file)?;
    }
    Ok(())
}

pub(crate) type Figure = (&'static str, Box<dyn Mesh>);

pub(crate) fn figures() -> Result<Vec<Figure>, Box<dyn Error>> {
    let zig_zag =
        domain("zig-zag", &[[0.0, 0.0], [6.0, 0.0], [6.0, 4.0], [0.0, 4.0]], &[3, 3, 2, 2])?;
    let dominant =
        domain("dominant side", &[[0.0, 0.0], [6.0, 0.0], [4.5, 3.0], [1.5, 3.0]], &[6, 1, 1, 1])?;
    let removal = domain("corner removal", &[[0.0, 0.0], [6.0, 0.0], [3.0, 4.5]], &[4, 3, 3])?;
    let medial = domain("medial triangle", &[[0.0, 0.0], [6.0, 0.0], [3.0, 4.5]], &[2, 2, 2])?;
    Ok(vec![
        ("zig-zag.svg", Box::new(BoundaryMesh::least_degree(&zig_zag)?)),
        ("dominant-side.svg", Box::new(BoundaryMesh::least_degree(&dominant)?)),
        ("corner-removal.svg", Box::new(BoundaryMesh::least_degree(&removal)?)),
        ("medial.svg", Box::new(BoundaryMesh::least_degree(&medial)?)),
        ("zig-zag-of-an-l.svg", Box::new(zig_zag_of_an_l()?)),
        ("apexes.svg", Box::new(apexes()?)),
        ("holes.svg", Box::new(holes()?)),
        ("smallest-change.svg", Box::new(smallest_change()?)),
        ("strip-of-degree-4.svg", Box::new(strip_of_degree_4()?)),
        ("rows.svg", Box::new(rows()?)),
        ("refuted.svg", Box::new(refuted()?)),
        ("bridge.svg", Box::new(bridge()?)),
        ("fan-limit.svg", Box::new(fan_limit()?)),
        ("tent-limit.svg", Box::new(tent_limit()?)),
    ])
}

fn domain(name: &str, corners: &[[f64; 2]], counts: &[u64]) -> Result<Domain, Box<dyn Error>> {
    let sides = counts.iter().copied().map(Side::count).collect();
    Ok(Domain::polygon(corners.iter().copied(), sides)?.named(name)?)
}

/// The domain of `dominant-side.svg` after the smallest change that brings degree 4.
fn smallest_change() -> Result<BoundaryMesh, Box<dyn Error>> {
    let boundary = Boundary::new(&[6, 1, 1, 1])?;
    let change = suggest(&boundary, 4).ok_or("degree 4 can be reached")?;
    assert_eq!((change.cost(), change.max_degree), (2, 4));
    let corners = [[0.0, 0.0], [6.0, 0.0], [4.5, 3.0], [1.5, 3.0]];
    let domain = domain("smallest change", &corners, &change.intervals(&boundary))?;
    Ok(BoundaryMesh::least_degree(&domain)?)
}

/// The strip between rings of 12 and 5 vertices, of degree 3 + 3.
fn bridge() -> Result<TriMesh, Box<dyn Error>> {
    let strip = RingStrip::new(12, 5)?;
    let ring = |count: u32, radius: f64| {
        (0..count).map(move |index| {
            let angle = std::f64::consts::TAU * f64::from(index) / f64::from(count);
            DVec3::new(libm::cos(angle) * radius, libm::sin(angle) * radius, 0.0)
        })
    };
    let points = ring(strip.xs(), 3.0).chain(ring(strip.ys(), 1.0)).collect();
    Ok(TriMesh::new(points, strip.triangles().collect())?
        .named("a strip between 12 and 5 vertices"))
}

/// An L of which the test for degree 4 finds an admissible zig-zag.
fn zig_zag_of_an_l() -> Result<TriMesh, Box<dyn Error>> {
    let corners = [[0.0, 0.0], [4.0, 0.0], [4.0, 2.0], [2.0, 2.0], [2.0, 4.0], [0.0, 4.0]];
    let (answer, mesh) = least_degree(&corners, &[4, 2, 2, 2, 2, 4])?;
    assert!(matches!(answer.reached_by, Reached::ZigZag(_)), "a zig-zag is admissible");
    Ok(mesh.named("zig-zag of an L"))
}

/// A long side whose eight inner edges have three vertices as apexes.
fn apexes() -> Result<TriMesh, Box<dyn Error>> {
    let corners = [[0.0, 0.0], [8.0, 0.0], [8.0, 4.0], [4.0, 2.0], [0.0, 4.0]];
    let (answer, mesh) = least_degree(&corners, &[10, 1, 1, 1, 1])?;
    let LowerBound::Apexes(bound) = &answer.bounded_by else {
        return Err(format!("{:?} is the bound", answer.bounded_by).into());
    };
    assert_eq!((bound.edges.len(), bound.apexes.len()), (8, 3));
    assert_eq!((answer.lower_bound, answer.max_degree), (6, 6));
    Ok(mesh.named("apex bound"))
}

/// The mesh of least degree of a simple polygon, and how it was found.
fn least_degree(
    corners: &[[f64; 2]],
    counts: &[u32],
) -> Result<(DegreeRange, TriMesh), Box<dyn Error>> {
    let (mut points, mut sides, mut starts) = (Vec::new(), Vec::new(), Vec::new());
    for (side, &count) in counts.iter().enumerate() {
        starts.push(points.len() as u32);
        let ends = [corners[side], corners[(side + 1) % corners.len()]].map(DVec2::from);
        let at = |step| ends[0].lerp(ends[1], f64::from(step) / f64::from(count));
        points.extend((0..count).map(at));
        sides.extend((0..count).map(|_| side as u32));
    }
    let boundary = PlanarBoundary::new(&[&points])?.with_sides(starts, sides);
    let delaunay = mindeg_delaunay::triangles(&boundary, &[], &[], Progress::NONE)?;
    let problem = Problem::triangulated(&boundary, &delaunay)?;
    let answer = degree_range(&problem, Progress::NONE)?;
    let points = points.into_iter().map(|point| point.extend(0.0)).collect();
    let mesh = TriMesh::new(points, answer.triangles.clone())?;
    Ok((answer, mesh))
}

/// A square with four holes, of the degree that counting asks for at least.
fn holes() -> Result<BoundaryMesh, Box<dyn Error>> {
    let outline =
        Shape::Polygon([[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]].map(DVec2::from).into());
    let mut builder = Domain::builder(outline, vec![Side::count(6); 4]);
    for center in [[0.5, 0.5], [1.5, 0.5], [0.5, 1.5], [1.5, 1.5]].map(DVec2::from) {
        let corner = |index: u32| {
            let angle = std::f64::consts::TAU * f64::from(index) / 8.0;
            center + 0.25 * DVec2::new(libm::cos(angle), libm::sin(angle))
        };
        builder = builder.hole(Ring::new((0..8).map(corner), vec![Side::count(1); 8]));
    }
    let domain = builder.build()?.named("four holes")?;
    let meshed = mindeg::mesh(&domain, Goal::LeastDegree, Progress::NONE)?;
    assert_eq!((meshed.mesh.triangle_count(), meshed.least_max_degree), (56 + 8 - 2, 5));
    assert!(meshed.is_least_proven, "degree {}", meshed.mesh.max_degree());
    Ok(meshed.mesh)
}

/// A regular polygon with corners on a circle.
fn regular(corners: u32, radius: f64) -> Ring {
    let at = |corner: u32| {
        let angle = std::f64::consts::TAU * f64::from(corner) / f64::from(corners);
        radius * DVec2::new(libm::cos(angle), libm::sin(angle))
    };
    Ring::new((0..corners).map(at), vec![Side::count(1); corners as usize])
}

/// The strip between two rings of nine vertices.
fn strip_of_degree_4() -> Result<BoundaryMesh, Box<dyn Error>> {
    let domain = Domain::of_rings(vec![regular(9, 2.0), regular(9, 1.0)])?;
    let meshed =
        mindeg::mesh(&domain.named("two rings of nine")?, Goal::LeastDegree, Progress::NONE)?;
    assert_eq!((meshed.mesh.max_degree(), meshed.mesh.triangle_count()), (4, 18));
    Ok(meshed.mesh)
}

/// Two triangulations of a triangle with a triangular hole, whose triangles on its lower side differ: that side's row has
/// both of these.
fn rows() -> Result<TriMesh, Box<dyn Error>> {
    let points = [[0.0, 0.0], [6.0, 0.0], [3.0, 5.0], [2.2, 1.2], [3.0, 2.6], [3.8, 1.2]];
    let points = points.map(DVec2::from);
    let boundary = PlanarBoundary::new(&[&points[..3], &points[3..]])?;
    let rest = [[1, 2, 5], [5, 2, 4], [4, 2, 3], [3, 2, 0]];
    let (mut positions, mut triangles) = (Vec::new(), Vec::new());
    for (index, lower) in (0_u32..).zip([[[0, 1, 3], [3, 1, 5]], [[0, 1, 5], [0, 5, 3]]]) {
        let own: Vec<[u32; 3]> = lower.into_iter().chain(rest).collect();
        // A triangulation, or this fails.
        Problem::triangulated(&boundary, &own)?;
        let aside = 7.0 * f64::from(index) * DVec2::X;
        positions.extend(points.iter().map(|&point| (point + aside).extend(0.0)));
        triangles.extend(own.into_iter().map(|corners| corners.map(|vertex| 6 * index + vertex)));
    }
    Ok(TriMesh::new(positions, triangles)?.named("one row of a side, two solutions"))
}

/// Three squares in a rectangle: clauses refute degree 5.
fn refuted() -> Result<TriMesh, Box<dyn Error>> {
    let rectangle = |[x, y]: [f64; 2], width: f64, height: f64| {
        [[x, y], [x + width, y], [x + width, y + height], [x, y + height]].map(DVec2::from)
    };
    let mut rings = vec![rectangle([0.0, 0.0], 12.0, 4.0)];
    for x in [1.0, 5.0, 9.0] {
        let mut hole = rectangle([x, 1.0], 2.0, 2.0);
        hole.reverse();
        rings.push(hole);
    }
    let boundary = PlanarBoundary::new(&rings)?;
    let delaunay = mindeg_delaunay::triangles(&boundary, &[], &[], Progress::NONE)?;
    let answer = degree_range(&Problem::triangulated(&boundary, &delaunay)?, Progress::NONE)?;
    let LowerBound::Refuted(refutation) = &answer.bounded_by else {
        return Err(format!("{:?} is the bound", answer.bounded_by).into());
    };
    assert_eq!((answer.lower_bound, answer.max_degree), (6, 6), "{refutation:?}");
    let points = boundary.points().iter().map(|point| point.extend(0.0)).collect();
    Ok(TriMesh::new(points, answer.triangles)?.named("three squares, degree 6"))
}

/// Four triangles at a right angle between edges of lengths 1 and 16: equal angles, each spoke twice
/// as long as the one before.
fn fan_limit() -> Result<TriMesh, Box<dyn Error>> {
    const TRIANGLES: u32 = 4;
    let spoke = |index: u32| {
        let share = f64::from(index) / f64::from(TRIANGLES);
        let (angle, length) = (share * std::f64::consts::FRAC_PI_2, 16_f64.powf(share));
        DVec3::new(libm::cos(angle) * length, libm::sin(angle) * length, 0.0)
    };
    let points: Vec<_> = std::iter::once(DVec3::ZERO).chain((0..=TRIANGLES).map(spoke)).collect();
    let limit = limits::fan_limit(std::f64::consts::FRAC_PI_2, 1.0, 16.0, Some(TRIANGLES));
    let reached = (points[1] - points[2]).angle_between(-points[2]).to_degrees();
    assert!((reached - limit).abs() < 1e-9, "{reached} is not the limit {limit}");
    let triangles = (1..=TRIANGLES).map(|spoke| [0, spoke, spoke + 1]).collect();
    Ok(TriMesh::new(points, triangles)?.named("fan limit: 1 to 16 at 90°, four triangles"))
}

/// The tents of a strip three intervals long and half an interval wide, with the base angle of
/// 26.565° at which they touch.
fn tent_limit() -> Result<TriMesh, Box<dyn Error>> {
    const INTERVALS: u32 = 3;
    let corners = (0..=INTERVALS).map(|x| DVec2::new(f64::from(x), 0.0));
    let ring: Vec<_> = corners.clone().chain(corners.rev().map(|at| at + 0.5 * DVec2::Y)).collect();
    let limit =
        limits::tent_limit(&PlanarBoundary::new(&[ring])?, 60.0).ok_or("the tents touch")?;
    assert!((limit.angle - libm::atan(0.5).to_degrees()).abs() < 1e-9, "{limit:?}");
    let (mut points, mut triangles) = (Vec::new(), Vec::new());
    for index in 0..INTERVALS {
        let x = f64::from(index);
        for (from, to) in [([x, 0.0], [x + 1.0, 0.0]), ([x + 1.0, 0.5], [x, 0.5])] {
            let (from, to) = (DVec2::from(from), DVec2::from(to));
            let apex = from.midpoint(to) + (to - from).perp() * 0.25;
            let first = points.len() as u32;
            points.extend([from, to, apex].map(|point| point.extend(0.0)));
            triangles.push([first, first + 1, first + 2]);
        }
    }
    Ok(TriMesh::new(points, triangles)?.named("tent limit: base angles of 26.565°"))
}
