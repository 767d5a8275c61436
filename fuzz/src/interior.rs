//! Interior points: the boundary stays bit for bit, and the triangles fill it.

use crate::hostile::{GridPoint, Hostile, assert_fills, star};
use arbitrary::Arbitrary;
use glam::DVec2;
use mindeg_interior::{Options, Prefer, Size, SizeAt, generate};
use mindeg_mesh::Progress;
use mindeg_mesh::planar::PlanarBoundary;

#[derive(Arbitrary, Debug)]
pub(crate) struct Input {
    radii: Vec<u8>,
    /// Points of a ring that need not be one.
    ring: Option<Vec<GridPoint>>,
    hole: Option<Vec<u8>>,
    growth: Option<Hostile>,
    size_inside: Option<Hostile>,
    sizes: Vec<([Hostile; 2], Hostile)>,
    degrees: Option<(u8, u8, u8)>,
    limits: Vec<(u8, u8)>,
    target: Option<Hostile>,
    prefer_angle: bool,
    fixed: Vec<([Hostile; 2], u8, u8)>,
}

pub(crate) fn run(input: Input) {
    let outer: Vec<DVec2> = match &input.ring {
        Some(ring) => ring.iter().take(30).map(|point| point.0).collect(),
        None => star(&input.radii[..input.radii.len().min(40)], DVec2::ZERO),
    };
    let mut rings = vec![outer];
    if let Some(hole) = &input.hole {
        let hole = &hole[..hole.len().min(8)];
        let mut ring: Vec<DVec2> = star(hole, DVec2::ZERO).into_iter().map(|p| p / 40.0).collect();
        ring.reverse();
        rings.push(ring);
    }
    let count = rings.iter().map(Vec::len).sum::<usize>();
    let place = |[x, y]: [Hostile; 2]| DVec2::new(x.0, y.0);
    let fixed: Vec<DVec2> = input.fixed.iter().take(4).map(|(at, ..)| place(*at)).collect();
    let vertex = |index: u8| u32::from(index) % (count + fixed.len()).max(1) as u32;
    let lines = input
        .fixed
        .iter()
        .take(4)
        .map(|(_, a, b)| vec![vertex(*a), vertex(*b)])
        .collect::<Vec<_>>();
    let Ok((outline, _)) = PlanarBoundary::map(&rings, &fixed, &lines) else { return };
    let n = outline.points().len() as u32;
    let mut options = Options::default();
    options.wanted.max_points = Some(3_000);
    options.wanted.growth = input.growth.map(|growth| growth.0);
    options.wanted.size_inside = input.size_inside.map(|size| size.0);
    let size =
        |&(at, size): &([Hostile; 2], Hostile)| Size::At(SizeAt { at: place(at), size: size.0 });
    options.wanted.sizes = input.sizes.iter().take(3).map(size).collect();
    if let Some((low, high, boundary)) = input.degrees {
        options.wanted.interior_degree = Some(u32::from(low % 8)..=u32::from(high % 12));
        options.wanted.boundary_degree = Some(u32::from(boundary % 8));
    }
    let limit = |&(vertex, limit): &(u8, u8)| (u32::from(vertex) % (n + 1), u32::from(limit % 8));
    options.degree_limits = input.limits.iter().take(4).map(limit).collect();
    options.wanted.target_angle = input.target.map(|target| target.0);
    options.wanted.prefer = input.prefer_angle.then_some(Prefer::Angle);
    options.divisible = vec![input.prefer_angle; lines.len()];
    let found = match generate(&outline, &options, Progress::NONE) {
        Ok(found) => found,
        Err(error) => return assert!(!error.to_string().is_empty()),
    };
    assert_eq!(&found.points[..n as usize], outline.points());
    assert_eq!(&found.points[n as usize..][..fixed.len()], &fixed[..]);
    let boundary: Vec<_> = outline.edges().collect();
    assert_fills(&found.points, &found.triangles, &boundary);
    assert!(found.points.len() <= options.wanted.max_points());
}
