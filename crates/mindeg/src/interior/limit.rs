//! The proven limit of the minimum angle on a domain, and the feature that decides it.

use std::fmt;

use mindeg_domain::{Domain, InRing, Interior};
use mindeg_interior::InteriorError;
use mindeg_interior::limits::{Limits, TentLimit};
use mindeg_mesh::{number, steady_angle};

use super::posed::Posed;

/// The greatest minimum angle that any mesh of a domain's boundary can have, however many interior
/// points it has, and what decides. Angles are in degrees.
#[derive(Clone, Debug, PartialEq)]
pub struct AngleLimit {
    /// The limit for meshes whose boundary vertices keep their degree limits.
    pub min_angle: f64,
    /// The feature that decides the limit.
    pub cause: Cause,
    /// The limit with any degree.
    pub min_angle_at_any_degree: f64,
    /// The feature that decides the limit with any degree.
    pub cause_at_any_degree: Cause,
}

/// The feature that decides a limit. Sides and corners are counted from 0 here and from 1 in text.
#[derive(Clone, Debug, PartialEq)]
pub enum Cause {
    /// A corner between intervals of different lengths, or a sharp one.
    Corner {
        /// The side that begins there, which is the corner's index too.
        corner: usize,
        /// The name of the feature, such as "corner 3".
        name: String,
        /// The side that ends there.
        side_before: usize,
        /// The vertex.
        vertex: u32,
        /// The interior angle in degrees.
        angle: f64,
        /// The lengths of the interval before and of the one after.
        lengths: [f64; 2],
    },
    /// A vertex within a side or line, between intervals of different lengths.
    Vertex {
        /// The side; none of a line beside a hole.
        side: Option<usize>,
        /// Its name.
        name: String,
        /// The vertex.
        vertex: u32,
        /// The lengths of the interval before and of the one after.
        lengths: [f64; 2],
    },
    /// Two intervals that face each other nearer than they are long.
    Facing {
        /// Their sides; none of a line beside a hole.
        sides: [Option<usize>; 2],
        /// The names of these.
        names: [String; 2],
        /// The first vertex of each.
        vertices: [u32; 2],
    },
}

/// The proven limit of a domain. O(n log n) time and O(n) memory for n boundary vertices.
///
/// # Errors
///
/// Boundary points that coincide or cross once rounded, or that are too large or small to work with.
///
/// # Example
///
/// ```
/// use mindeg::{Domain, Interior, Side, interior};
///
/// let domain = Domain::rectangle(4.0, 3.0, [12, 9, 2, 9].map(Side::count).into())?;
/// let limit = interior::angle_limit(&domain, &Interior::default())?;
/// let cause = limit.cause.to_string();
/// assert_eq!(cause, "corner 3 (vertex 21), where intervals of 0.3333 and 2 meet at 90.000°");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn angle_limit(domain: &Domain, wanted: &Interior) -> Result<AngleLimit, InteriorError> {
    let posed = Posed::new(domain)?;
    let (boundary, options) = (posed.boundary(), posed.options(domain, wanted)?);
    let found = options.limits(boundary, |_| 0);
    Ok(AngleLimit::new(domain, &posed, &found))
}

impl AngleLimit {
    pub(super) fn new(domain: &Domain, posed: &Posed<'_>, limits: &Limits) -> Self {
        let cause = |angle: f64, vertex: u32| match limits.tent {
            Some(tent) if tent.angle <= angle => Cause::of_tent(domain, posed, &tent),
            _ => Cause::of_fan(domain, posed, vertex),
        };
        Self {
            min_angle: limits.angle(),
            cause: cause(limits.angle(), limits.with_degree_limit.vertex),
            min_angle_at_any_degree: limits.angle_at_any_degree(),
            cause_at_any_degree: cause(limits.angle_at_any_degree(), limits.any_degree.vertex),
        }
    }
}

impl AngleLimit {
    /// The same, with vertices counted from another index on.
    pub(super) fn of_vertices_from(mut self, first: u32) -> Self {
        for cause in [&mut self.cause, &mut self.cause_at_any_degree] {
            match cause {
                Cause::Corner { vertex, .. } | Cause::Vertex { vertex, .. } => *vertex += first,
                Cause::Facing { vertices, .. } => vertices.iter_mut().for_each(|it| *it += first),
            }
        }
        self
    }
}

impl Cause {
    fn of_tent(domain: &Domain, posed: &Posed<'_>, tent: &TentLimit) -> Self {
        let [first, second] = tent.edges.map(|edge| named(domain, posed.edge(edge)));
        let (sides, names) = ([first.0, second.0], [first.1, second.1]);
        Self::Facing { sides, names, vertices: tent.edges.map(|vertex| posed.vertex(vertex)) }
    }

    fn of_fan(domain: &Domain, posed: &Posed<'_>, vertex: u32) -> Self {
        let (rings, boundary) = (domain.rings(), posed.boundary());
        let lengths = [boundary.previous(vertex), vertex].map(|edge| boundary.length(edge));
        let angle = boundary.angle(vertex).to_degrees();
        let (side, name) = named(domain, posed.edge(vertex));
        let vertex = posed.vertex(vertex);
        if let Some(side) = side
            && rings.is_corner(vertex)
        {
            let InRing { ring, index } = rings.in_ring(side);
            let hole = if ring > 0 { format!(" of hole {ring}") } else { String::new() };
            let name = format!("corner {}{hole}", index + 1);
            let side_before = rings.previous_side(side);
            Self::Corner { corner: side, name, side_before, vertex, angle, lengths }
        } else {
            Self::Vertex { side, name, vertex, lengths }
        }
    }
}

/// The side of an edge of a domain's boundary, none of a line; and its name.
fn named(domain: &Domain, edge: u32) -> (Option<usize>, String) {
    match edge.checked_sub(domain.rings().vertex_count()) {
        None => {
            let side = domain.rings().side_of(edge);
            (Some(side), domain.side_in_text(side))
        }
        Some(segment) => {
            let lines = domain.inner_lines();
            let own = lines.into_iter().find(|(line, _)| line.segments.contains(&segment));
            (None, own.map_or_else(String::new, |(line, _)| line.name))
        }
    }
}

impl fmt::Display for Cause {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Corner { name, vertex, angle, lengths: [before, after], .. } => write!(
                f,
                "{name} (vertex {vertex}), where intervals of {} and {} meet at {}",
                number(*before),
                number(*after),
                steady_angle(*angle)
            ),
            Self::Vertex { name, vertex, lengths: [before, after], .. } => write!(
                f,
                "vertex {vertex} on {name}, where intervals of {} and {} meet",
                number(*before),
                number(*after)
            ),
            Self::Facing { names: [first, second], vertices: [v, w], .. } => write!(
                f,
                "the gap between {first} at vertex {v} and {second} at vertex {w}, narrow for its \
                 intervals"
            ),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use mindeg_domain::Side;

    fn limit(width: f64, height: f64, sides: [Side; 4]) -> AngleLimit {
        let domain = Domain::rectangle(width, height, sides.into()).unwrap();
        angle_limit(&domain, &Interior::default()).unwrap()
    }

    #[test]
    fn the_place_that_decides_is_named() {
        for (found, angle, cause) in [
            (
                limit(100.0, 40.0, [1000, 3, 5, 2].map(Side::count)),
                7.68,
                "corner 1 (vertex 0), where intervals of 20 and 0.1 meet at 90.000°",
            ),
            (
                limit(40.0, 0.2, [100, 1, 100, 1].map(Side::count)),
                26.57,
                "the gap between side 1 at vertex 97 and side 3 at vertex 103, narrow for its \
                 intervals",
            ),
            (
                limit(
                    4.0,
                    4.0,
                    [
                        Side::parameters(vec![0.24, 0.25, 0.5, 0.75]),
                        Side::count(4),
                        Side::count(4),
                        Side::count(4),
                    ],
                ),
                24.8,
                "vertex 2 on side 1, where intervals of 0.04 and 1 meet",
            ),
        ] {
            assert_eq!(found.cause.to_string(), cause);
            assert!((found.min_angle - angle).abs() < 0.4, "{found:?}");
            assert!(found.min_angle <= found.min_angle_at_any_degree);
        }
    }

    #[test]
    fn a_corner_of_a_hole_is_named_with_its_hole() {
        let domain = Domain::from_json(
            r#"{"rectangle": {"width": 40, "height": 40}, "size": 4, "holes": [
                {"corners": [[10, 10], [14, 10], [14, 14], [10, 14]], "size": 4},
                {"corners": [[22, 22], [30, 22], [30, 30], [22, 30]],
                 "sides": [{"intervals": 2}, {"intervals": 200}, {"intervals": 2}, {"intervals": 2}]}]}"#,
        );
        let found = angle_limit(&domain.unwrap(), &Interior::default()).unwrap();
        let Cause::Corner { name, .. } = &found.cause else { unreachable!("{found:?}") };
        assert!(name == "corner 2 of hole 2" || name == "corner 3 of hole 2", "{found:?}");
    }

    #[test]
    fn degree_limits_of_the_domain_count() {
        use mindeg_domain::{Constraints, Outline, Rectangle, VertexConstraint};
        let sides = [8, 2, 8, 2].map(Side::count).to_vec();
        let outline = Outline::Rectangle(Rectangle::new(4.0, 4.0));
        let plain = Domain::new(outline.clone(), sides.clone()).unwrap();
        let limited =
            |limit| VertexConstraint { vertex: 0, external_degree: 0, degree_limit: Some(limit) };
        let constraints = Constraints { vertices: vec![limited(2)], ..Constraints::default() };
        let tight = Domain::builder(outline, sides).constraints(constraints).build().unwrap();
        let angle = |domain| angle_limit(domain, &Interior::default()).unwrap().min_angle;
        assert!(angle(&tight) < 0.9 * angle(&plain));
    }
}
