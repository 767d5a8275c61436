//! Stars and combs with constraints and every goal: a triangulation within its limits, or a reason.

use crate::hostile::star;
use arbitrary::Arbitrary;
use glam::DVec2;
use mindeg::exact::{DegreeBound, LowerBound, degree};
use mindeg::{Constraints, Domain, Goal, Outline, Progress, Side, VertexConstraint, mesh};
use mindeg_exact::check::CheckedOutline as Checked;
use mindeg_mesh::check;

#[derive(Arbitrary, Debug)]
pub(crate) struct Input {
    radii: Vec<(u8, u8)>,
    hole: Option<Vec<u8>>,
    limits: Vec<(u8, u8, u8)>,
    goal: u8,
}

pub(crate) fn run(input: Input) {
    let radii: Vec<u8> = input.radii.iter().take(14).map(|(radius, _)| *radius).collect();
    if radii.len() < 3 {
        return;
    }
    let counts =
        input.radii.iter().take(14).map(|(_, count)| Side::count(u64::from(count % 4) + 1));
    let mut builder =
        Domain::builder(Outline::Polygon(star(&radii, DVec2::ZERO)), counts.collect());
    if let Some(hole) = input.hole.as_ref().filter(|hole| hole.len() >= 3) {
        let hole: Vec<u8> = hole.iter().take(7).copied().collect();
        let mut ring: Vec<DVec2> =
            star(&hole, DVec2::ZERO).into_iter().map(|point| point / 40.0).collect();
        ring.reverse();
        builder = builder.hole(mindeg::Ring::of_points(ring));
    }
    let Ok(plain) = builder.clone().build() else { return };
    let n = plain.rings().vertex_count();
    let vertices = input.limits.iter().take(6).map(|&(vertex, limit, external)| VertexConstraint {
        vertex: u32::from(vertex) % n,
        external_degree: u32::from(external % 4),
        degree_limit: (limit % 8 > 0).then_some(u32::from(limit % 8) + 2),
    });
    let constraints = Constraints { vertices: vertices.collect(), ..Constraints::default() };
    let Ok(domain) = builder.constraints(constraints).build() else { return };
    // Convex stars at a distance of a few roundings may be too close to one another.
    let Ok(boundary) = domain.boundary() else { return };
    let rings: Vec<_> = domain.rings().rings().collect();

    let goal = match input.goal % 4 {
        0 => Goal::LeastDegree,
        1 => Goal::MaxDegree(u32::from(input.goal / 4) % 12),
        _ => Goal::KeepAngle(f64::from(input.goal / 4) / 63.0),
    };
    let meshed = mesh(&domain, goal, Progress::NONE);
    let answer = degree(&domain, Progress::NONE);
    if let Ok(meshed) = &meshed {
        let triangles: Vec<_> = meshed.mesh.triangles().collect();
        let checked = check::triangulation(&boundary, &[], &triangles).expect("a triangulation");
        let total = |vertex: u32| checked.degrees[vertex as usize] + domain.external_degree(vertex);
        let max_total = (0..n).map(total).max().unwrap_or(0);
        assert_eq!(max_total, meshed.mesh.max_total_degree());
        for vertex in 0..n {
            assert!(domain.degree_limit(vertex).is_none_or(|limit| total(vertex) <= limit));
        }
        if let Goal::MaxDegree(limit) = goal {
            assert!(max_total <= limit);
        }
        assert!(max_total >= meshed.least_max_degree);
        let answer = answer.as_ref().expect("what has a mesh has a degree");
        assert!(answer.at_least <= max_total, "{answer:?} but {max_total}");
    }
    let Ok(answer) = answer else { return };
    assert!(answer.at_least <= answer.reached);
    let outline = Checked {
        points: boundary.points(),
        rings: &rings,
        side_of: boundary.runs(),
        // A chord that blocks without the tolerance blocks with it.
        keeps_clear: true,
    };
    match answer.bounded_by {
        DegreeBound::Polygon(LowerBound::BlockedZigZags(chords)) => {
            assert!(outline.blocks_all_zigzags(&chords));
        }
        DegreeBound::Polygon(LowerBound::Apexes(bound)) => assert!(outline.bounds_apexes(&bound)),
        _ => {}
    }
}
