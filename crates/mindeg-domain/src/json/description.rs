//! The JSON of a domain: its keys for reading, for writing and for the schema.
//!
//! Limits: checks only the keys, for example keys that exclude each other.
//! [`build`](crate::DomainBuilder::build) checks the rest.

use glam::DVec2;
use mindeg_mesh::planar::InRing;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::choices::{few_corners, has_curve, one_outline, polygon_of_few_corners};
use super::line::LineKeys;
use super::side::{SideKeys, lone_side};
use crate::build::DomainBuilder;
use crate::constraints::{Constraints, SideConstraint, VertexConstraint};
use crate::domain::Domain;
use crate::error::{DomainError, Place};
use crate::inside::{InnerPoint, Inside, Region};
use crate::interior::Interior;
use crate::outline::{Outline, Ring};
use crate::projection::Projection;
use crate::rectangle::Rectangle;
use crate::side::Side;

/// A domain as JSON describes it, or any other format that serde reads; [`domain`](Self::domain) is
/// the domain that it describes.
///
/// # Example
///
/// ```
/// use mindeg_domain::DomainDescription;
///
/// let given = serde_json::json!({"rectangle": {"width": 4, "height": 3}, "size": 0.5});
/// let description: DomainDescription = serde_json::from_value(given)?;
/// assert_eq!(description.domain()?.rings().vertex_count(), 28);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("oneOf" = one_outline(), "if" = polygon_of_few_corners(), "then" = has_curve()))]
pub struct DomainDescription {
    /// The domain's name
    name: Option<String>,
    /// The outline as a rectangle. Its sides run bottom, right, top, left
    pub(super) rectangle: Option<Rectangle>,
    /// The outline as a simple polygon
    polygon: Option<Polygon>,
    /// The outline as all its points, `[x, y]`, which come back bit for bit. They are one side; `sides`
    /// may have one entry with its name, kind and degrees
    #[schemars(with = "Option<Vec<[f64; 2]>>", extend("minItems" = 3))]
    ring: Option<Vec<DVec2>>,
    /// One entry for each side, from the first corner on; may be left out where `size` says it all
    sides: Option<Vec<SideKeys>>,
    /// The target interval length of every side that gives neither `intervals` nor `size` nor its own
    /// points
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub(super) size: Option<f64>,
    /// Rings inside the outline and apart from each other
    holes: Option<Vec<Hole>>,
    /// Lines inside, which every mesh of the domain has as edges
    lines: Option<Vec<LineKeys>>,
    /// Points inside, which every mesh of the domain has as vertices
    points: Option<Vec<InnerPoint>>,
    /// Names and materials of the regions that lines divide the domain into
    regions: Option<Vec<Region>>,
    /// Degree limits of single vertices
    vertices: Option<Vec<VertexKeys>>,
    /// The projection of longitudes and latitudes that gave the coordinates, which are metres then, such as
    /// `EPSG:32635` or `+proj=utm +zone=35 +datum=WGS84`. Formats in degrees get degrees
    projection: Option<String>,
    /// The wanted mesh with interior points. Commands that mesh add points if this is there
    interior: Option<Interior>,
}

/// A simple polygon
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct Polygon {
    /// `[x, y]` of each corner around the polygon, either way round; one or two are enough where sides
    /// are curved
    #[schemars(with = "Vec<[f64; 2]>", extend("minItems" = 1))]
    corners: Vec<DVec2>,
}

/// A hole: `corners` with `sides` or `size`, or a `ring`
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("if" = few_corners(), "then" = has_curve()))]
struct Hole {
    /// `[x, y]` of each corner, either way round
    #[schemars(with = "Option<Vec<[f64; 2]>>", extend("minItems" = 1))]
    corners: Option<Vec<DVec2>>,
    /// Instead: all points of the hole, as one side
    #[schemars(with = "Option<Vec<[f64; 2]>>", extend("minItems" = 3))]
    ring: Option<Vec<DVec2>>,
    /// One entry for each side, from the first corner on
    sides: Option<Vec<SideKeys>>,
    /// The hole's own target interval length, which goes before that of the domain
    #[schemars(extend("exclusiveMinimum" = 0))]
    size: Option<f64>,
}

/// Limits of the degrees of single vertices
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct VertexKeys {
    /// Its index in the mesh: from 0 at the first corner, counter-clockwise, also where the corners are
    /// given clockwise
    vertex: u32,
    /// Its external degree: the number of its edges on the other side of the boundary
    outside_degree: Option<u32>,
    /// Its degree limit: the most edges that it may have, external degree included
    max_degree: Option<u32>,
}

/// The message for a size beside a ring's own points.
const OWN_POINTS: &str = "a \"ring\" has its own points; drop \"size\"";

/// A ring with the constraints of its sides.
type Described = (Ring, Vec<SideConstraint>);

impl DomainDescription {
    /// Builds the described domain.
    ///
    /// # Errors
    ///
    /// Keys that exclude each other, and what [`DomainBuilder::build`] refuses.
    pub fn domain(self) -> Result<Domain, DomainError> {
        self.build(|builder| builder)
    }

    /// The domain of a builder that `with` adds to.
    pub(super) fn build(
        self,
        with: impl FnOnce(DomainBuilder) -> DomainBuilder,
    ) -> Result<Domain, DomainError> {
        let Self { name, rectangle, polygon, ring, sides, size, holes, .. } = self;
        let Self { lines, points, regions, vertices, projection, interior, .. } = self;
        let error = |key, message: &str| Err(Place::key(key).error(message));
        if size.is_some() && ring.is_some() && holes.is_none() && lines.is_none() {
            return error("size", OWN_POINTS);
        }
        let (outline, (Ring { corners, sides }, mut of_sides)) = match (rectangle, polygon, ring) {
            (Some(rectangle), None, None) => (
                Some(Outline::Rectangle(rectangle)),
                with_sides(0, vec![DVec2::ZERO; 4], sides, size)?,
            ),
            (None, Some(polygon), None) => (None, with_sides(0, polygon.corners, sides, size)?),
            (None, None, Some(points)) => (None, of_points(0, points, sides)?),
            (None, None, None) => {
                return Err(Place::default().error(
                    "the outline is missing; give \"rectangle\": {\"width\": w, \"height\": h}, \
                     \"polygon\": {\"corners\": [[x, y], …]} or \"ring\": [[x, y], …]",
                ));
            }
            (Some(_), Some(_), _) => {
                return error(
                    "polygon",
                    "a domain has one outline; drop \"rectangle\" or \"polygon\"",
                );
            }
            (rectangle, ..) => {
                let other = if rectangle.is_some() { "rectangle" } else { "polygon" };
                let message = format!("a domain has one outline; drop \"{other}\" or \"ring\"");
                return error("ring", &message);
            }
        };
        let outline = outline.unwrap_or(Outline::Polygon(corners));
        let mut builder = with(DomainBuilder::new(outline, sides));
        for (hole, given) in holes.unwrap_or_default().into_iter().enumerate() {
            let (ring, constraints) = given.described(hole + 1, size)?;
            builder = builder.hole(ring);
            of_sides.extend(constraints);
        }
        let lines = lines.unwrap_or_default().into_iter().enumerate();
        let inside = Inside {
            lines: lines.map(|(line, given)| given.line(line, size)).collect::<Result<_, _>>()?,
            points: points.unwrap_or_default(),
            regions: regions.unwrap_or_default(),
        };
        let vertices = vertices.unwrap_or_default();
        let is_idle =
            |vertex: &VertexKeys| vertex.max_degree.is_none() && vertex.outside_degree.is_none();
        if let Some(entry) = vertices.iter().position(is_idle) {
            return Err(Place::key("vertices").then(entry).error(
                "give \"outside_degree\" (edges on the other side of the boundary) or \
                 \"max_degree\" (a degree limit), or drop the vertex",
            ));
        }
        let vertex = |given: &VertexKeys| VertexConstraint {
            vertex: given.vertex,
            external_degree: given.outside_degree.unwrap_or(0),
            degree_limit: given.max_degree,
        };
        let vertices = vertices.iter().map(vertex).collect();
        let constraints = Constraints { sides: of_sides, vertices };
        let domain = builder.inside(inside).constraints(constraints).build()?;
        let domain = match name {
            Some(name) => domain.named(name)?,
            None => domain,
        };
        let projection = projection.map(|text| {
            let projection: Result<Projection, String> = text.parse();
            projection.map_err(|problem| Place::key("projection").error(problem))
        });
        let domain = domain.with_projection(projection.transpose()?);
        Ok(match interior {
            Some(interior) => {
                interior.check().map_err(|error| error.inside(Place::key("interior")))?;
                domain.with_interior(interior)
            }
            None => domain,
        })
    }
}

impl Hole {
    fn described(self, ring: usize, size: Option<f64>) -> Result<Described, DomainError> {
        let error = |message: &str| Err(Place::ring(ring).error(message));
        match (self.corners, self.ring) {
            (Some(corners), None) => with_sides(ring, corners, self.sides, self.size.or(size)),
            (None, Some(_)) if self.size.is_some() => {
                Err(Place::ring(ring).then("size").error(OWN_POINTS))
            }
            (None, Some(points)) => of_points(ring, points, self.sides),
            (Some(_), Some(_)) => error("a hole has either \"corners\" or a \"ring\"; drop one"),
            (None, None) => error(
                "the key \"corners\" or \"ring\" is missing; give \"corners\": [[x, y], …] and \
                 \"sides\" or \"size\", or \"ring\": [[x, y], …]",
            ),
        }
    }
}

/// A ring of corners, with the given sides, or with sides from a size.
fn with_sides(
    ring: usize,
    corners: Vec<DVec2>,
    sides: Option<Vec<SideKeys>>,
    size: Option<f64>,
) -> Result<Described, DomainError> {
    let sides = match (sides, size) {
        (Some(given), _) => {
            let side = |(index, side): (usize, SideKeys)| side.side(InRing { ring, index }, size);
            given.into_iter().enumerate().map(side).collect::<Result<Vec<_>, _>>()?
        }
        (None, Some(size)) => vec![(Side::size(size), SideConstraint::default()); corners.len()],
        (None, None) => {
            return Err(Place::ring(ring).error(
                "the sides are missing; give \"sides\": [{\"intervals\": n}, …], or a target \
                 interval length \"size\" for all",
            ));
        }
    };
    let (sides, constraints) = sides.into_iter().unzip();
    Ok((Ring { corners, sides }, constraints))
}

/// A ring of points: its first point, and its single side.
fn of_points(
    ring: usize,
    points: Vec<DVec2>,
    sides: Option<Vec<SideKeys>>,
) -> Result<Described, DomainError> {
    let error = |key, message| Err(Place::ring(ring).then(key).error(message));
    if points.len() < 3 {
        let found = crate::error::counted(points.len(), "point");
        return error("ring", format!("found {found}; a ring needs at least 3"));
    }
    let Ring { corners, sides: own } = Ring::of_points(points);
    let sides = sides.unwrap_or_else(|| vec![SideKeys::default()]);
    let count = sides.len();
    let ([own], Ok([given])) =
        (<[Side; 1]>::try_from(own).expect("one side"), <[SideKeys; 1]>::try_from(sides))
    else {
        return error(
            "sides",
            format!(
                "found {count} sides; a \"ring\" is one side; for several, give corners and the \
                 \"points\" of each side"
            ),
        );
    };
    let (side, constraint) = lone_side(given, own, InRing { ring, index: 0 })?;
    Ok((Ring { corners, sides: vec![side] }, vec![constraint]))
}

impl Domain {
    /// A description of this domain, with the same points, bit for bit.
    ///
    /// Rings run as in the mesh. If a ring was given the wrong way round, its sides have points
    /// instead of a spacing law.
    pub fn description(&self) -> DomainDescription {
        let ring = |ring: usize| {
            let sides = self.rings().ring_sides(ring);
            let corners = self.placement().corners()[sides.clone()].to_vec();
            (corners, sides.map(|side| SideKeys::of(self, ring, side)).collect())
        };
        let (corners, sides) = ring(0);
        let (rectangle, polygon) = match self.outline() {
            Outline::Rectangle(rectangle) => (Some(*rectangle), None),
            Outline::Polygon(_) => (None, Some(Polygon { corners })),
        };
        let holes = (1..self.rings().ring_count()).map(|hole| {
            let (corners, sides) = ring(hole);
            Hole { corners: Some(corners), sides: Some(sides), ..Hole::default() }
        });
        let vertex = |constraint: &VertexConstraint| VertexKeys {
            vertex: constraint.vertex,
            outside_degree: Some(constraint.external_degree).filter(|degree| *degree > 0),
            max_degree: constraint.degree_limit,
        };
        let inside = self.inside();
        let vertices: Vec<_> = self.constraints().vertices.iter().map(vertex).collect();
        DomainDescription {
            name: self.name().map(str::to_owned),
            rectangle,
            polygon,
            sides: Some(sides),
            holes: some(holes.collect()),
            lines: some(inside.lines.iter().map(LineKeys::of).collect()),
            points: some(inside.points.clone()),
            regions: some(inside.regions.clone()),
            vertices: some(vertices),
            projection: self.projection().map(ToString::to_string),
            interior: self.interior().cloned(),
            ..DomainDescription::default()
        }
    }
}

/// A list, if it is not empty.
fn some<T>(list: Vec<T>) -> Option<Vec<T>> {
    Some(list).filter(|list| !list.is_empty())
}
