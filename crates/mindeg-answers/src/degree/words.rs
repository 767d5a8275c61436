//! Why a degree cannot be less and how it is reached, in sentences.

use crate::names::shown;
use crate::numbers::count;
use mindeg::Domain;
use mindeg::exact::{DegreeAnswer, LowerBound, Reached};
use mindeg::model::JointBound;
use mindeg_core::{Boundary, Certificate};

/// Why the least maximum degree of a convex domain cannot be less and how it is reached, in sentences
/// that end in a new line.
pub(super) fn certificate_in_words(boundary: &Boundary, certificate: &Certificate) -> String {
    let vertices = boundary.vertex_count();
    let sides = boundary.side_count();
    match *certificate {
        Certificate::BalancedCut { .. } if vertices == 3 => {
            "There is only one triangle.\n".to_owned()
        }
        Certificate::BalancedCut { cut, max_degree } => {
            let run = |first: usize, count: usize| match count {
                1 => format!("side {}", first % sides + 1),
                _ => format!("sides {} to {}", first % sides + 1, (first + count - 1) % sides + 1),
            };
            let larger = run(cut.first_side, cut.side_count);
            let smaller = run(cut.first_side + cut.side_count, sides - cut.side_count);
            format!(
                "It cannot be less: any triangulation of {vertices} boundary points has a vertex \
                 of degree {max_degree} or more\n(counting edges: theorem 3 of docs/theory.md).\n\
                 It is reached by a zig-zag between {larger} ({} intervals) and {smaller} ({}).\n",
                cut.larger, cut.smaller
            )
        }
        Certificate::MedialTriangle => "\
It cannot be less: any triangulation of 6 boundary points has a vertex of degree 4 or more
(counting edges: theorem 3 of docs/theory.md).
It is reached by the triangle through the three midpoints.\n"
            .to_owned(),
        Certificate::LongSide { side, max_degree } => {
            let intervals = boundary.intervals(side);
            let off_side = vertices - intervals - 1;
            let edges = mindeg_core::bound::interior_edge_count(boundary);
            format!(
                "It cannot be less: each of the {edges} interior edges ends at one of the \
                 {off_side} vertices off side {}\n({intervals} intervals), so one of these has \
                 {} of them besides two boundary edges\n(theorem 4 of docs/theory.md).\n\
                 It is reached by sharing that side out evenly among them.\n",
                side + 1,
                max_degree - 2,
            )
        }
        Certificate::NoBalancedCut { least_imbalance } => format!(
            "It cannot be less: degree 4 needs two runs of consecutive sides whose intervals \
             differ by at most 1,\nand here every two differ by {least_imbalance} or more \
             (theorem 5 of docs/theory.md).\n\
             It is reached by a corner strip and a zig-zag across the rest.\n"
        ),
    }
}

/// Why the least maximum degree of any domain cannot be less and how it is reached, or what is not known, in
/// sentences that end in a new line.
pub(super) fn in_words(
    domain: &Domain,
    answer: &DegreeAnswer,
    bounded_by: &LowerBound,
    is_checked: bool,
) -> String {
    let mut text = why_not_less(domain, answer.at_least, bounded_by, is_checked);
    text.push_str(&how_reached(answer));
    if answer.least_max_degree().is_none() {
        let open = match (answer.at_least, answer.reached - 1) {
            (least, most) if least == most => format!("degree {least}"),
            (least, most) => format!("a degree from {least} to {most}"),
        };
        text.push_str(&format!(
            "Whether {open} is possible is not known: {}.\n",
            if domain.rings().ring_count() > 1 {
                "the search of all meshes takes a number of steps, which --effort multiplies, and at most \
                 1,000,000 possible triangles"
            } else {
                "too many of its vertices see each other for a search of all meshes"
            }
        ));
    }
    text
}

/// Why the degree cannot be less, in sentences.
fn why_not_less(domain: &Domain, bound: u32, bounded_by: &LowerBound, is_checked: bool) -> String {
    /// The tolerance of docs/theory.md, section 8.
    const STRAIGHT: &str = "A chord passes a vertex if it turns there by less than 1e-9 radians.\n";
    let vertices = domain.rings().vertex_count();
    match bounded_by {
        LowerBound::BlockedZigZags(chords) => {
            let [from, to] = chords.first().copied().unwrap_or_default();
            format!(
                "No mesh has less than {bound}: from 7 vertices on, a mesh of degree 4 is one of {} zig-zags across \
                 the whole polygon,\nand each of these has a chord that does not lie inside or passes a vertex, such \
                 as the one from vertex {from} to vertex {to}.\n{STRAIGHT}",
                count(vertices)
            )
        }
        LowerBound::Apexes(apexes) => format!(
            "No mesh has less than {bound}: {} boundary edges, the first from vertex {} on, are the side of no ear, \
             and only {} vertices\nsee both ends of one of them. A vertex of degree {} is the apex of \
             at most {} of these edges.\n{STRAIGHT}",
            count(apexes.edges.len() as u32),
            apexes.edges.first().copied().unwrap_or_default(),
            count(apexes.apexes.len() as u32),
            bound - 1,
            bound - 4,
        ),
        LowerBound::Counting => {
            counting(bound, [vertices, edge_count(domain)], domain.is_constrained())
        }
        LowerBound::NoStrip => format!(
            "No mesh has less than {bound}: with a hole, a mesh of degree 4 is a strip between two rings of as many \
             vertices,\nand no strip here lies inside (theorem 21 of docs/theory.md).\n"
        ),
        LowerBound::Refuted(refutation) => format!(
            "No mesh has less than {bound}: degree {}{} is refuted by {}, {}\n(theorem 23 of docs/theory.md).\n{STRAIGHT}",
            bound.saturating_sub(1),
            if domain.is_constrained() { " with the limits" } else { "" },
            counted(refutation.clauses.len() as u32, "clause"),
            if is_checked {
                "checked"
            } else {
                "which the checker does not confirm; please report it"
            }
        ),
        LowerBound::ClosedForm => {
            "It cannot be less, by the formula for convex domains.\n".to_owned()
        }
        _ => format!(
            "No mesh has less than {bound}: of all triangulations, none {}has a maximum degree of {}.\n{STRAIGHT}",
            if domain.is_constrained() { "that keeps the limits " } else { "" },
            bound.saturating_sub(1)
        ),
    }
}

/// The degree of a map in words, with its vertices and edges: why it cannot be less, and how it is reached.
pub(super) fn map_in_words(
    domain: &Domain,
    answer: &DegreeAnswer,
    bound: &JointBound,
    [vertices, edges]: [u32; 2],
) -> String {
    let (reached, least) = (answer.reached, answer.at_least);
    let why = match bound {
        JointBound::Sum { .. } => counting(least, [vertices, edges], domain.is_constrained()),
        JointBound::Edges { vertex, edges } => format!(
            "No mesh has less than {least}: vertex {vertex} has {} of sides and lines{}.\n",
            counted(*edges, "edge"),
            if domain.is_constrained() { ", external edges included" } else { "" }
        ),
        JointBound::Side { face, intervals, .. } => format!(
            "No mesh has less than {least}: {} has a straight side of {intervals} intervals, whose triangles need \
             apexes elsewhere on it.\n",
            shown(&region_of(domain, *face))
        ),
        JointBound::Refuted { refutation, .. } => format!(
            "No mesh has less than {least}: degree {} is refuted by {}, checked\n(theorem 23 of docs/theory.md).\n",
            least.saturating_sub(1),
            counted(refutation.clauses.len() as u32, "clause")
        ),
        _ => format!(
            "No mesh has less than {least}: a weighted sum of the degrees is too large, whatever the triangles of each \
             region.\n"
        ),
    };
    let how = if reached == least {
        "It is reached by a search over all regions together.\n".to_owned()
    } else {
        format!(
            "Degree {reached} is reached by a search over all regions together. Whether less is possible is not known: \
             --effort 10 looks ten times as long.\n"
        )
    };
    format!("{why}{how}")
}

/// The name of a face of a map, counted without holes.
pub(super) fn region_of(domain: &Domain, face: u32) -> String {
    let count = domain.faces().map_or(0, |faces| faces.count) as u32;
    let region = (0..count).filter(|face| !domain.is_hole(*face)).nth(face as usize);
    domain.region_name(region.unwrap_or(face))
}

/// A number of things.
fn counted(number: u32, thing: &str) -> String {
    match number {
        1 => format!("one {thing}"),
        number => format!("{} {thing}s", count(number)),
    }
}

/// Why the edges are too many.
fn counting(bound: u32, [vertices, edges]: [u32; 2], is_constrained: bool) -> String {
    format!(
        "No mesh has less than {bound}: the {} edges of every mesh have two ends each, at {} vertices{}, so that \
         one of these\nhas {bound} or more.\n",
        count(edges),
        count(vertices),
        if is_constrained { " with external edges besides" } else { "" }
    )
}

fn edge_count(domain: &Domain) -> u32 {
    let (triangles, vertices) = (domain.rings().triangle_count(), domain.rings().vertex_count());
    ((3 * u64::from(triangles) + u64::from(vertices)) / 2) as u32
}

/// How the degree is reached, in a sentence.
fn how_reached(answer: &DegreeAnswer) -> String {
    let degree = answer.reached;
    match answer.reached_by {
        Reached::ZigZag(zigzag) => {
            format!("Degree {degree} is reached by the zig-zag from vertex {} on.\n", zigzag.tip)
        }
        Reached::Windows => format!(
            "Degree {degree} is reached by windows of a Delaunay triangulation, each triangulated \
             anew.\n"
        ),
        Reached::Descent => format!(
            "Degree {degree} is reached by windows of a Delaunay triangulation, each triangulated \
             anew many times.\n"
        ),
        Reached::Strip => {
            format!("Degree {degree} is reached by the strip between the two rings.\n")
        }
        _ => format!("Degree {degree} is reached by a search over all triangulations.\n"),
    }
}
