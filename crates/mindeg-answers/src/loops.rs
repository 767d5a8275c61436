//! Boundary loops that were filled or joined.

use crate::numbers::{number, percent, steady_angle};
use mindeg::bridge::Bridged;
use mindeg::fill::{FIRST_LIMIT, FillOptions, Filled, FilledLoop, PointsInside};
use mindeg::{Loops, MeshLoop};
use serde::Serialize;

/// How many loops a text describes one by one.
const DESCRIBED: usize = 8;

/// A boundary loop by its number, from 1, and its first vertex.
#[derive(Clone, Debug, Serialize)]
pub struct LoopName {
    #[serde(rename = "loop")]
    number: usize,
    vertices: usize,
    first_vertex: u32,
}

impl LoopName {
    /// The loop with this index.
    #[must_use]
    pub fn new(index: usize, found: &MeshLoop) -> Self {
        let first_vertex = found.vertices.first().copied().unwrap_or(0);
        Self { number: index + 1, vertices: found.vertices.len(), first_vertex }
    }

    /// The loop in words.
    #[must_use]
    pub fn text(&self) -> String {
        let Self { number, vertices, first_vertex } = self;
        format!("loop {number} ({vertices} vertices from vertex {first_vertex} on)")
    }
}

/// A mesh whose loops were filled; angles in degrees.
#[derive(Clone, Debug, Serialize)]
pub struct FillAnswer {
    file: String,
    vertices: usize,
    triangles: usize,
    max_degree: u32,
    filled: Vec<FilledLoopAnswer>,
    /// The loops that stay open.
    pub left_open: Vec<OpenLoop>,
    crossings: Vec<[u32; 2]>,
    /// The kinds of values at vertices that files have and the mesh lacks.
    dropped: Vec<&'static str>,
}

/// A loop that was filled.
#[derive(Clone, Debug, Serialize)]
struct FilledLoopAnswer {
    #[serde(flatten)]
    name: LoopName,
    limit: u32,
    max_degree: u32,
    area: f64,
    area_without_limit: f64,
    /// The least possible limit from 6 up and its area, where a higher one was chosen for its area;
    /// else null.
    least_limit: Option<u32>,
    area_at_least_limit: Option<f64>,
    degree_without_limit: u32,
    min_angle: f64,
    /// The first, and the one after the last.
    triangles: [u32; 2],
    /// The vertices inside: the first, and the one after the last; null without any.
    vertices_inside: Option<[u32; 2]>,
    /// The least and the greatest degree of the vertices inside and on the loop, where there are points inside.
    degrees: Option<[u32; 2]>,
    /// Vertices with other degrees than 5 to 7 there.
    violations: Vec<OffVertex>,
    /// Why there are no points inside though they were asked for.
    without_points: Option<String>,
}

/// A vertex whose degree is out of its range.
#[derive(Clone, Copy, Debug, Serialize)]
struct OffVertex {
    vertex: u32,
    degree: u32,
}

/// A loop that stays open, and why.
#[derive(Clone, Debug, Serialize)]
pub struct OpenLoop {
    #[serde(flatten)]
    name: LoopName,
    reason: String,
}

impl OpenLoop {
    /// The loop and the reason in words.
    #[must_use]
    pub fn text(&self) -> String {
        format!("{} stays open: {}", self.name.text(), self.reason)
    }
}

impl FilledLoopAnswer {
    fn of(found: &FilledLoop, loops: &Loops) -> Self {
        let inside = found.inside.as_ref().and_then(|inside| inside.as_ref().ok());
        Self {
            name: LoopName::new(found.index, &loops.list()[found.index]),
            limit: found.limit,
            max_degree: found.max_degree,
            area: found.area,
            area_without_limit: found.without_limit.0,
            least_limit: found.least_limit.map(|(limit, _)| limit),
            area_at_least_limit: found.least_limit.map(|(_, area)| area),
            degree_without_limit: found.without_limit.1,
            min_angle: found.min_angle,
            triangles: [found.triangles.start, found.triangles.end],
            vertices_inside: inside.map(|it| [it.vertices.start, it.vertices.end]),
            degrees: inside.map(|it| it.degrees),
            violations: inside.map_or_else(Vec::new, off_vertices),
            without_points: found.inside.clone().and_then(Result::err),
        }
    }

    /// The loop with its points inside.
    fn text_inside(&self, [first, end]: [u32; 2], [least, most]: [u32; 2]) -> String {
        let (name, area, points) = (self.name.text(), number(self.area), end - first);
        let points = if points == 1 { "1 point".to_owned() } else { format!("{points} points") };
        let angle = steady_angle(self.min_angle);
        let off = off_degree_text(&self.violations);
        format!(
            "{name}: {points} inside, degrees {least} to {most} on it and inside, area {area}, minimum angle {angle}{off}"
        )
    }

    /// The limit, the area, and what the limit costs; `extra_area` is the share that decided the limit, unless the
    /// user gave it.
    fn text(&self, extra_area: Option<f64>) -> String {
        if let (Some(vertices), Some(degrees)) = (self.vertices_inside, self.degrees) {
            return self.text_inside(vertices, degrees);
        }
        let Self { limit, least_limit, area, area_without_limit: least, .. } = self;
        let why = match (extra_area, least_limit) {
            (Some(extra), Some(_)) => {
                format!(", the least that takes at most {} more area than no limit", percent(extra))
            }
            (Some(_), None) if *limit > FIRST_LIMIT => ", the least that is possible".to_owned(),
            _ => String::new(),
        };
        let more = |area: f64| (area / least - 1.0).max(0.0);
        let degree = self.degree_without_limit;
        let cost = if degree == self.max_degree && area <= least || *least == 0.0 {
            "the least without a limit, too".to_owned()
        } else if more(*area) == 0.0 {
            format!("as little as without a limit, where the degree is {degree}")
        } else {
            let more = percent(more(*area));
            format!("{more} more than without a limit, where the degree is {degree}")
        };
        let lower =
            least_limit.zip(self.area_at_least_limit).map_or_else(String::new, |(limit, area)| {
                format!("; --max-degree {limit} takes {} more", percent(more(area)))
            });
        let (name, area) = (self.name.text(), number(*area));
        let without = self.without_points.as_ref();
        let without = without.map_or_else(String::new, |why| format!("; no points inside: {why}"));
        format!("{name}: degree limit {limit}{why}; area {area}, {cost}{lower}{without}")
    }
}

impl FillAnswer {
    /// The answer for a mesh in a file whose loops were filled.
    #[must_use]
    pub fn of(file: &str, result: &Filled, loops: &Loops) -> Self {
        let name = |index: usize| LoopName::new(index, &loops.list()[index]);
        let left = result.left.iter();
        Self {
            file: file.to_owned(),
            vertices: result.mesh.positions().len(),
            triangles: result.mesh.triangles().len(),
            max_degree: result.max_degree,
            filled: result.filled.iter().map(|it| FilledLoopAnswer::of(it, loops)).collect(),
            left_open: left
                .map(|left| OpenLoop { name: name(left.index), reason: left.reason.clone() })
                .collect(),
            crossings: result.crossings.clone(),
            dropped: result.mesh.dropped().to_vec(),
        }
    }

    /// The filled loops, one line each.
    #[must_use]
    pub fn text(&self, options: &FillOptions) -> String {
        let (filled, open) = (self.filled.len(), self.left_open.len());
        let triangles: u32 = self.filled.iter().map(|it| it.triangles[1] - it.triangles[0]).sum();
        let largest = self.filled.iter().map(|it| it.max_degree).max().unwrap_or(0);
        let angle = self.filled.iter().map(|it| it.min_angle).fold(f64::INFINITY, f64::min);
        let plural = if filled == 1 { "loop" } else { "loops" };
        let mut text = format!(
            "{}: filled {filled} {plural} with {triangles} triangles; maximum degree on them {largest}, \
             minimum angle {}",
            self.file,
            steady_angle(angle),
        );
        let extra_area = options.max_degree.is_none().then_some(options.extra_area);
        for found in self.filled.iter().take(DESCRIBED) {
            text += &format!("\n  {}", found.text(extra_area));
        }
        if filled > DESCRIBED {
            text += &format!("\n  and {} more", filled - DESCRIBED);
        }
        for left in self.left_open.iter().take(DESCRIBED) {
            text += &format!("\n  {}", left.text());
        }
        if open > DESCRIBED {
            text += &format!("\n  and {} more stay open", open - DESCRIBED);
        }
        text + &crossing_text(&self.crossings) + &dropped_text(&self.dropped)
    }
}

/// Two loops joined by a bridge; angles in degrees.
#[derive(Clone, Debug, Serialize)]
pub struct BridgeAnswer {
    from: LoopName,
    to: LoopName,
    vertices: usize,
    triangles: usize,
    /// The first triangle of the strip, and the one after the last.
    strip: [u32; 2],
    max_degree: u32,
    least_max_degree: u32,
    at_least: u32,
    min_angle: f64,
    /// The minimum angle with one degree more; null if that is not better.
    next_min_angle: Option<f64>,
    angle_without_limit: f64,
    degree_without_limit: u32,
    planar: bool,
    /// The vertices inside: the first, and the one after the last; null without any.
    vertices_inside: Option<[u32; 2]>,
    /// The least and the greatest degree of the vertices inside and on the loops, where there are points inside.
    degrees: Option<[u32; 2]>,
    /// Vertices with other degrees than 5 to 7 there.
    violations: Vec<OffVertex>,
    /// Why there are no points inside though they were asked for.
    without_points: Option<String>,
    crossings: Vec<[u32; 2]>,
    /// The kinds of values at vertices that files have and the mesh lacks.
    dropped: Vec<&'static str>,
    #[serde(skip)]
    turned_over: Option<f64>,
}

impl BridgeAnswer {
    /// The answer for two loops that were joined.
    #[must_use]
    pub fn of(result: &Bridged, from: LoopName, to: LoopName) -> Self {
        let strip = &result.strip;
        let inside = result.inside.as_ref().and_then(|inside| inside.as_ref().ok());
        Self {
            from,
            to,
            vertices: result.mesh.positions().len(),
            triangles: result.mesh.triangles().len(),
            strip: [result.triangles.start, result.triangles.end],
            max_degree: inside.map_or(strip.max_degree, |it| it.degrees[1]),
            least_max_degree: strip.least_max_degree,
            at_least: strip.lower_bound,
            min_angle: result.min_angle,
            next_min_angle: strip.next_min_angle,
            angle_without_limit: strip.without_limit.0,
            degree_without_limit: strip.without_limit.1,
            planar: strip.is_planar,
            vertices_inside: inside.map(|it| [it.vertices.start, it.vertices.end]),
            degrees: inside.map(|it| it.degrees),
            violations: inside.map_or_else(Vec::new, off_vertices),
            without_points: result.inside.clone().and_then(Result::err),
            crossings: result.crossings.clone(),
            dropped: result.mesh.dropped().to_vec(),
            turned_over: result.turned_over,
        }
    }

    /// The bridge with its points inside.
    fn text_inside(&self, [first, end]: [u32; 2], [least, most]: [u32; 2]) -> String {
        let points = end - first;
        format!(
            "joined {} and {} with {} triangles and {points} point{} inside: degrees {least} to {most} on the loops and inside, minimum \
             angle {}{}",
            self.from.text(),
            self.to.text(),
            self.strip[1] - self.strip[0],
            if points == 1 { "" } else { "s" },
            steady_angle(self.min_angle),
            off_degree_text(&self.violations),
        )
    }

    /// The loops that were joined, and the next step.
    #[must_use]
    pub fn text(&self) -> String {
        if let (Some(vertices), Some(degrees)) = (self.vertices_inside, self.degrees) {
            let text = self.text_inside(vertices, degrees);
            return text + &crossing_text(&self.crossings) + &dropped_text(&self.dropped);
        }
        let optimal = match (self.max_degree, self.least_max_degree, self.at_least) {
            (degree, least, bound) if degree == least && least == bound => {
                "the least possible, as counting proves".to_owned()
            }
            (degree, least, _) if degree == least => {
                "the least possible, found by search".to_owned()
            }
            (_, least, _) => format!("the least possible is {least}"),
        };
        let mut text = format!(
            "joined {} and {} with {} triangles: maximum degree on them {} ({optimal}), minimum angle {}, the \
             largest for this degree",
            self.from.text(),
            self.to.text(),
            self.strip[1] - self.strip[0],
            self.max_degree,
            steady_angle(self.min_angle),
        );
        if let Some(why) = &self.without_points {
            text += &format!("\nno points inside: {why}");
        }
        if let Some(next) = self.next_min_angle {
            let (more, next) = (self.max_degree + 1, steady_angle(next));
            text += &format!("\nhint: --max-degree {more} gives a minimum angle of {next}");
        }
        if let Some(turned) = self.turned_over {
            text += &format!(
                "\nwarning: the strip is twisted; if the triangles of the second mesh were turned over, \
                 its minimum angle would be {}",
                steady_angle(turned)
            );
        }
        text + &crossing_text(&self.crossings) + &dropped_text(&self.dropped)
    }
}

/// The sentence on the kinds of values that files have and a mesh lacks, if there are some.
#[must_use]
pub fn not_in_the_mesh(dropped: &[&str]) -> Option<String> {
    (!dropped.is_empty()).then(|| format!("Not in the mesh: {}.", dropped.join(", ")))
}

/// The same on a line of its own.
fn dropped_text(dropped: &[&str]) -> String {
    not_in_the_mesh(dropped).map_or_else(String::new, |sentence| format!("\n{sentence}"))
}

/// A remark on vertices with other degrees than 5 to 7, after a semicolon; empty if there are none.
fn off_degree_text(violations: &[OffVertex]) -> String {
    match violations {
        [] => String::new(),
        [OffVertex { vertex, degree }] => {
            format!("; vertex {vertex} has {degree} edges, not 5 to 7")
        }
        [OffVertex { vertex, degree }, others @ ..] => format!(
            "; vertex {vertex} has {degree} edges, not 5 to 7, and so have {} more",
            others.len()
        ),
    }
}

/// The vertices with other degrees, as objects.
fn off_vertices(inside: &PointsInside) -> Vec<OffVertex> {
    let off = |&[vertex, degree]: &[u32; 2]| OffVertex { vertex, degree };
    inside.off_degree.iter().map(off).collect()
}

/// A remark on new triangles that cross others, on a line of its own; empty if none do.
fn crossing_text(crossings: &[[u32; 2]]) -> String {
    match crossings {
        [] => String::new(),
        [[new, other]] => format!(
            "\nwarning: a new triangle crosses another one: {new} and {other} (counted from 0)"
        ),
        [[new, other], ..] => format!(
            "\nwarning: {} new triangles cross others, the first {new} and {other} (counted from 0)",
            crossings.len()
        ),
    }
}
