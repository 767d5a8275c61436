//! From a domain to its JSON text.
//!
//! Every number is the shortest that reads back as the same f64.

use glam::DVec2;
use serde_json::{Map, Value, json};

use crate::constraints::{ExternalDegree, SideConstraint, VertexConstraint};
use crate::curve::{Arc, Curve};
use crate::domain::Domain;
use crate::outline::Outline;
use crate::side::{Intervals, Side, SideKind};
use crate::spacing::Spacing;

impl Domain {
    /// The domain as JSON text, which [`Domain::from_json`] reads as the same points, bit for bit.
    ///
    /// Rings run as in the mesh, also where they were given the other way round.
    ///
    /// # Example
    ///
    /// ```
    /// use mindeg_domain::{Domain, Side};
    ///
    /// let corners = [[0.0, 0.0], [0.1 + 0.2, 0.0], [0.0, 1.0 / 3.0]];
    /// let domain = Domain::polygon(corners, vec![Side::count(2).named("a"), Side::size(0.1), Side::count(1)])?;
    /// let again = Domain::from_json(&domain.to_json()).unwrap();
    /// assert!(again.placement().points().eq(domain.placement().points()));
    /// assert_eq!(again.sides(), domain.sides());
    /// # Ok::<(), mindeg_domain::DomainError>(())
    /// ```
    #[must_use]
    pub fn to_json(&self) -> String {
        let mut keys = Map::new();
        if let Some(name) = self.name() {
            keys.insert("name".to_owned(), json!(name));
        }
        let mut rings = (0..self.rings().ring_count()).map(|ring| self.ring_to_json(ring));
        let mut outer = rings.next().unwrap_or_default();
        let sides = outer.remove("sides");
        match self.outline() {
            Outline::Rectangle(rectangle) => {
                let mut of_rectangle = Map::new();
                of_rectangle.insert("width".to_owned(), json!(rectangle.width));
                of_rectangle.insert("height".to_owned(), json!(rectangle.height));
                if rectangle.origin != DVec2::ZERO {
                    of_rectangle.insert("origin".to_owned(), pair(rectangle.origin));
                }
                if rectangle.rotation != 0.0 {
                    of_rectangle.insert("rotation".to_owned(), json!(rectangle.rotation));
                }
                keys.insert("rectangle".to_owned(), Value::Object(of_rectangle));
            }
            Outline::Polygon(_) => {
                keys.insert("polygon".to_owned(), Value::Object(outer));
            }
        }
        keys.extend(sides.map(|sides| ("sides".to_owned(), sides)));
        let holes: Vec<Value> = rings.map(Value::Object).collect();
        if !holes.is_empty() {
            keys.insert("holes".to_owned(), Value::Array(holes));
        }
        let vertices: Vec<Value> = self.constraints().vertices.iter().map(vertex).collect();
        if !vertices.is_empty() {
            keys.insert("vertices".to_owned(), Value::Array(vertices));
        }
        Value::Object(keys).to_string()
    }

    /// The corners and sides of a ring.
    fn ring_to_json(&self, ring: usize) -> Map<String, Value> {
        let of_ring = self.rings().ring_sides(ring);
        let corners = &self.placement().corners()[of_ring.clone()];
        let constraints = &self.constraints().sides;
        let sides = of_ring.map(|index| side(&self.sides()[index], constraints.get(index)));
        let mut keys = Map::new();
        keys.insert("corners".to_owned(), corners.iter().copied().map(pair).collect());
        keys.insert("sides".to_owned(), sides.collect());
        keys
    }
}

fn pair(point: DVec2) -> Value {
    json!([point.x, point.y])
}

fn side(side: &Side, constraint: Option<&SideConstraint>) -> Value {
    let mut keys = Map::new();
    match (side.intervals, &side.spacing) {
        // The points, or the parameters, say how many there are.
        (Intervals::Points, _) | (_, Spacing::Parameters(_)) => {}
        (Intervals::Count(count), _) => _ = keys.insert("intervals".to_owned(), json!(count)),
        (Intervals::Size(size), _) => _ = keys.insert("size".to_owned(), json!(size)),
    }
    if let Some((key, curve)) = curve(side) {
        keys.insert(key.to_owned(), curve);
    }
    if let Some(spacing) = spacing(&side.spacing) {
        keys.insert("spacing".to_owned(), spacing);
    }
    if let Some(name) = &side.name {
        keys.insert("name".to_owned(), json!(name));
    }
    if let Some(kind) = side.kind {
        let kind = match kind {
            SideKind::Open => "open",
            SideKind::Land => "land",
            SideKind::Island => "island",
        };
        keys.insert("kind".to_owned(), json!(kind));
    }
    if let Some(constraint) = constraint {
        match &constraint.external_degree {
            ExternalDegree::Inside(0) => {}
            ExternalDegree::Inside(degree) => {
                keys.insert("outside_degree".to_owned(), json!(degree));
            }
            ExternalDegree::Each(degrees) => {
                keys.insert("outside_degree".to_owned(), json!(degrees));
            }
        }
        if let Some(limit) = constraint.degree_limit {
            keys.insert("max_degree".to_owned(), json!(limit));
        }
    }
    Value::Object(keys)
}

/// None for a straight side.
fn curve(side: &Side) -> Option<(&'static str, Value)> {
    Some(match &side.curve {
        Curve::Line => return None,
        Curve::Arc(Arc::Through(point)) => ("arc", json!({"through": pair(*point)})),
        Curve::Arc(Arc::Center { center, is_clockwise }) => {
            ("arc", json!({"center": pair(*center), "clockwise": is_clockwise}))
        }
        Curve::Cubic(controls) => ("bezier", controls.iter().copied().map(pair).collect()),
        Curve::Polyline(points) => {
            let key = if side.intervals == Intervals::Points { "points" } else { "polyline" };
            (key, points.iter().copied().map(pair).collect())
        }
    })
}

/// None for the law that is the default.
fn spacing(spacing: &Spacing) -> Option<Value> {
    Some(match spacing {
        Spacing::Uniform => return None,
        Spacing::Geometric { ratio } => json!({"geometric": {"ratio": ratio}}),
        Spacing::Bump { ratio } => json!({"bump": {"ratio": ratio}}),
        Spacing::Beta { beta } => json!({"beta": {"beta": beta}}),
        Spacing::FirstLength(length) => json!({"first_length": length}),
        Spacing::LastLength(length) => json!({"last_length": length}),
        Spacing::Parameters(parameters) => json!({"parameters": parameters}),
    })
}

fn vertex(constraint: &VertexConstraint) -> Value {
    let mut keys = Map::new();
    keys.insert("vertex".to_owned(), json!(constraint.vertex));
    if constraint.external_degree > 0 {
        keys.insert("outside_degree".to_owned(), json!(constraint.external_degree));
    }
    if let Some(limit) = constraint.degree_limit {
        keys.insert("max_degree".to_owned(), json!(limit));
    }
    Value::Object(keys)
}
