//! From a domain to its JSON text.
//!
//! Every number is the shortest that reads back as the same f64.

use glam::DVec2;
use serde_json::{Map, Value, json};

use crate::constraints::{ExternalDegree, SideConstraint, VertexConstraint};
use crate::curve::{Arc, Curve};
use crate::domain::Domain;
use crate::outline::Outline;
use crate::side::{Intervals, Side};
use crate::spacing::Spacing;
use mindeg_mesh::LineKind;

impl Domain {
    /// The domain as JSON text, which [`Domain::from_json`] reads as the same points, bit for bit.
    ///
    /// Rings run as in the mesh; the sides of one that was given the other way round have their
    /// points in place of a spacing law.
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
        if let Some(interior) = self.interior() {
            keys.insert("interior".to_owned(), super::interior::to_json(interior));
        }
        Value::Object(keys).to_string()
    }

    /// The corners and sides of a ring.
    fn ring_to_json(&self, ring: usize) -> Map<String, Value> {
        let of_ring = self.rings().ring_sides(ring);
        let corners = &self.placement().corners()[of_ring.clone()];
        let constraints = &self.constraints().sides;
        // Points that were worked out the other way round differ in their last bits: so the sides
        // of a turned ring give them one by one, but where all points are formulas anyway.
        let is_formula =
            self.convex().is_some() && self.sides().iter().all(|side| side.curve == Curve::Line);
        let is_turned = self.turned.contains(&ring) && !is_formula;
        let sides = of_ring.map(|index| {
            let own = &self.sides()[index];
            let intervals = self.rings().intervals(index);
            if is_turned && intervals > 1 {
                let corner = self.rings().corner(index);
                let mut points = vec![DVec2::ZERO; intervals as usize - 1];
                self.placement().fill_points(corner + 1, &mut points);
                let (name, kind) = (own.name.clone(), own.kind);
                side(&Side { name, kind, ..Side::points(points) }, constraints.get(index))
            } else {
                side(own, constraints.get(index))
            }
        });
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
    match &side.curve {
        Curve::Line => {}
        Curve::Polyline(points) => {
            let key = if side.intervals == Intervals::Points { "points" } else { "polyline" };
            keys.insert(key.to_owned(), points.iter().copied().map(pair).collect());
        }
        Curve::Cubic(points) => {
            keys.insert("bezier".to_owned(), points.iter().copied().map(pair).collect());
        }
        Curve::Arc(arc) => _ = keys.insert("arc".to_owned(), self::arc(*arc)),
    }
    match (side.intervals, &side.spacing) {
        (Intervals::Points, _) | (_, Spacing::Parameters(_)) => {}
        (Intervals::Count(count), _) => _ = keys.insert("intervals".to_owned(), json!(count)),
        (Intervals::Size(size), _) => _ = keys.insert("size".to_owned(), json!(size)),
    }
    if let Some(spacing) = spacing(&side.spacing) {
        keys.insert("spacing".to_owned(), spacing);
    }
    if let Some(name) = &side.name {
        keys.insert("name".to_owned(), json!(name));
    }
    if let Some(kind) = side.kind {
        let kind = match kind {
            LineKind::Open => "open",
            LineKind::Land => "land",
            LineKind::Island => "island",
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

fn arc(arc: Arc) -> Value {
    match arc {
        Arc::Through(point) => json!({"through": pair(point)}),
        Arc::Center { center, is_clockwise: false } => json!({"center": pair(center)}),
        Arc::Center { center, is_clockwise: true } => {
            json!({"center": pair(center), "clockwise": true})
        }
    }
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

#[cfg(test)]
mod tests {
    use crate::domain::Domain;

    #[test]
    fn what_is_written_is_read_as_the_same_domain() {
        for text in [
            r#"{"name": "a", "rectangle": {"width": 4, "height": 3, "origin": [1, 0.1], "rotation": 30}, "size": 0.3,
                "vertices": [{"vertex": 3, "outside_degree": 2}, {"vertex": 1, "max_degree": 9}]}"#,
            r#"{"rectangle": {"width": 4, "height": 3}, "sides": [
                {"intervals": 3, "spacing": {"geometric": {"ratio": 1.2}}, "name": "bottom", "kind": "open"},
                {"intervals": 3, "spacing": {"bump": {"ratio": 1.2}}, "outside_degree": 1, "max_degree": 8},
                {"intervals": 3, "spacing": {"first_length": 0.1}, "outside_degree": [1, 2, 3, 4], "kind": "land"},
                {"spacing": {"parameters": [0.1, 0.7]}, "kind": "island"}]}"#,
            // Clockwise, with curves of all kinds and holes.
            r#"{"polygon": {"corners": [[0, 0], [0, 6], [6, 6], [6, 0]]}, "sides": [
                {"size": 0.7, "arc": {"through": [-1, 3]}},
                {"intervals": 5, "bezier": [[2, 7], [4, 5.5]], "spacing": {"last_length": 0.1}},
                {"points": [[6.1, 4], [6.3, 2.1]], "name": "x"},
                {"intervals": 4, "polyline": [[4, -0.1], [2, 0.1]], "spacing": {"beta": {"beta": 1.2}}}],
                "holes": [
                    {"corners": [[2, 1]], "sides": [{"intervals": 7, "arc": {"center": [2, 2], "clockwise": true}}]},
                    {"corners": [[4, 4]], "sides": [{"intervals": 7, "arc": {"center": [4, 4.5]}}]},
                    {"ring": [[1, 4], [2, 4.1], [1.5, 4.7]]}]}"#,
        ] {
            let domain = Domain::from_json(text).unwrap();
            let again = Domain::from_json(&domain.to_json()).unwrap();
            assert!(again.placement().points().eq(domain.placement().points()), "{text}");
            let names = |domain: &Domain| -> Vec<String> {
                (0..domain.sides().len()).map(|side| domain.side_name(side)).collect()
            };
            assert_eq!((names(&again), again.name()), (names(&domain), domain.name()), "{text}");
            if domain.turned.is_empty() {
                assert_eq!(again.sides(), domain.sides(), "{text}");
            }
            assert_eq!(again.constraints(), domain.constraints(), "{text}");
            let words: String = domain.to_json().split_whitespace().collect();
            assert!(!words.contains("\"outside_degree\":0"), "{text}");
            assert_eq!(again.rings(), domain.rings(), "{text}");
            assert_eq!(again.to_json(), domain.to_json());
        }
    }
}
