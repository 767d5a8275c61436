//! The open water and the depths of an ocean model, and the time step that they allow.

use crate::condition::place_in_words;
use crate::numbers::{count, number, percent};
use mindeg::glam::DVec2;
use mindeg::{Depths, Opening, Projection};
use mindeg_mesh::TriMesh;
use serde::Serialize;

/// Gravity, in m/s².
const GRAVITY: f64 = 9.81;
/// The Courant number that is safe, with which sizes are made, too.
const SAFE: f64 = 0.5;
/// Of more vertices than this share without a depth of their own a warning tells.
const MANY_WITHOUT: f64 = 0.05;

/// A stretch of the boundary that was asked to be open water.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct OpeningRow {
    /// Its length, in the unit of the domain.
    pub length: f64,
    /// Where it begins and ends, counter-clockwise; in degrees if the domain was projected.
    pub ends: [[f64; 2]; 2],
    /// Whether it is open water; else it is land.
    pub is_open: bool,
}

impl From<&Opening> for OpeningRow {
    fn from(opening: &Opening) -> Self {
        let ends = opening.ends.map(|end| end.to_array());
        Self { length: opening.length, ends, is_open: opening.is_open }
    }
}

/// The depths of a mesh, in metres, positive down.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct DepthsAnswer {
    /// The least depth of a vertex.
    pub least: f64,
    /// The greatest.
    pub greatest: f64,
    /// How many vertices were shallower than the least depth asked for, and got it.
    pub raised: usize,
    /// How many vertices lie beyond the grid of depths, and have the nearest.
    pub beyond: usize,
    /// How many vertices lie in gaps of the grid, more than a cell from any depth, and have the nearest.
    pub in_gaps: usize,
    /// How many vertices are above the water.
    pub dry: usize,
    /// Whether all depths of the grid at the vertices are above the water.
    pub is_dry: bool,
    /// The number of vertices.
    vertices: usize,
    /// The time step that the edges allow; null where no edge has water.
    pub courant: Option<CourantAnswer>,
}

/// The edge that a wave passes soonest: the Courant number is the way of the wave in a time step over the length of the edge.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CourantAnswer {
    /// The greatest time step, in seconds, with a Courant number of 0.5 at most.
    pub allowed_time_step: f64,
    /// The time step that was asked for.
    pub time_step: Option<f64>,
    /// The greatest Courant number with that.
    pub greatest: Option<f64>,
    /// The edge that decides: its length, the depth of its deeper end, and its middle.
    pub edge: f64,
    /// See `edge`.
    pub depth: f64,
    /// See `edge`.
    pub at: [f64; 2],
    /// The same in degrees of longitude and latitude, if the domain was projected.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub degrees: Option<[f64; 2]>,
}

impl DepthsAnswer {
    /// The depths of the vertices of a mesh on a grid, those below `least` raised to it, and what there is to say of them.
    /// `None` if all vertices lie beyond the grid. O(n) time.
    #[must_use]
    pub fn of(
        mesh: TriMesh,
        depths: &Depths,
        least: Option<f64>,
        time_step: Option<f64>,
        projection: Option<&Projection>,
    ) -> Option<(TriMesh, Self)> {
        let points: Vec<DVec2> = mesh.positions().iter().map(|point| point.truncate()).collect();
        let beyond = points.iter().filter(|point| depths.is_beyond(**point)).count();
        if beyond == points.len() {
            return None;
        }
        let is_in_gap = |point: &&DVec2| !depths.is_beyond(**point) && depths.is_in_gap(**point);
        let given: Vec<f64> = points.iter().map(|point| depths.at(*point)).collect();
        let limit = least.unwrap_or(f64::NEG_INFINITY);
        let raised = given.iter().filter(|depth| **depth < limit).count();
        let is_dry =
            given.iter().all(|depth| *depth <= 0.0) && given.iter().any(|depth| *depth < 0.0);
        let values: Vec<f64> = given.into_iter().map(|depth| depth.max(limit)).collect();
        let answer = Self {
            least: values.iter().copied().fold(f64::INFINITY, f64::min),
            greatest: values.iter().copied().fold(f64::NEG_INFINITY, f64::max),
            raised,
            beyond,
            in_gaps: points.iter().filter(is_in_gap).count(),
            dry: values.iter().filter(|depth| **depth < 0.0).count(),
            is_dry,
            vertices: points.len(),
            courant: CourantAnswer::of(&points, mesh.triangles(), &values, time_step, projection),
        };
        Some((mesh.with_depths(values), answer))
    }

    /// The same as text, without a line break at its end.
    #[must_use]
    pub fn text(&self) -> String {
        let depths = [self.least, self.greatest].map(number);
        let mut words = format!("depths from {} to {} m", depths[0], depths[1]);
        if self.raised > 0 {
            words +=
                &format!("; {} shallower, which got the least depth", count(self.raised as u64));
        }
        if self.dry > 0 && !self.is_dry {
            words += &format!(
                "; {} of {} vertices above the water, to which --least-depth gives some",
                count(self.dry as u64),
                count(self.vertices as u64)
            );
        }
        let without = [
            (self.beyond, "beyond the grid", "a grid of the whole region"),
            (self.in_gaps, "in gaps of the grid", "a grid without gaps"),
        ];
        let share = |vertices: usize| vertices as f64 / self.vertices as f64;
        let (many, few): (Vec<_>, Vec<_>) = without
            .into_iter()
            .filter(|(vertices, ..)| *vertices > 0)
            .partition(|(vertices, ..)| share(*vertices) > MANY_WITHOUT);
        for (vertices, place, _) in few {
            words += &format!("; {} {place}, which got the nearest depth", count(vertices as u64));
        }
        words.extend(self.courant.as_ref().map(CourantAnswer::text));
        for (vertices, place, need) in many {
            words += &format!(
                "\nwarning: {} of {} vertices, {}, lie {place} and got the nearest depth: give {need}",
                count(vertices as u64),
                count(self.vertices as u64),
                percent(share(vertices))
            );
        }
        if self.is_dry {
            words += "\nwarning: no vertex has water: give heights, positive up, by --elevation, and depths, positive down, by --depth";
        }
        words
    }
}

impl CourantAnswer {
    fn of(
        points: &[DVec2],
        triangles: &[[u32; 3]],
        depths: &[f64],
        time_step: Option<f64>,
        projection: Option<&Projection>,
    ) -> Option<Self> {
        let edges = triangles.iter().flat_map(|[a, b, c]| [[*a, *b], [*b, *c], [*c, *a]]);
        let timed = edges.map(|ends| {
            let [a, b] = ends.map(|end| end as usize);
            let (edge, depth) = (points[a].distance(points[b]), depths[a].max(depths[b]).max(0.0));
            (edge / libm::sqrt(GRAVITY * depth), edge, depth, points[a].midpoint(points[b]))
        });
        let (time, edge, depth, at) = timed.min_by(|a, b| a.0.total_cmp(&b.0))?;
        if !time.is_finite() {
            return None;
        }
        Some(Self {
            allowed_time_step: SAFE * time,
            time_step,
            greatest: time_step.map(|step| step / time),
            edge,
            depth,
            at: at.to_array(),
            degrees: projection.map(|projection| {
                projection.to_degrees(at).to_array().map(|it| (it * 1e6).round() / 1e6)
            }),
        })
    }

    fn text(&self) -> String {
        let place = place_in_words(self.degrees, self.at);
        let [edge, depth, allowed] = [self.edge, self.depth, self.allowed_time_step].map(number);
        let edge = format!("an edge of {edge} m in {depth} m of water at {place}");
        match (self.time_step, self.greatest) {
            (Some(step), Some(greatest)) => format!(
                "\na time step of {} s has Courant numbers of {} at most, the greatest on {edge}; {SAFE} allows {allowed} s",
                number(step),
                number(greatest)
            ),
            _ => {
                format!("\na Courant number of {SAFE} allows a time step of {allowed} s, by {edge}")
            }
        }
    }
}
