//! The curve: the largest minimum angle over the maximum degree.
//!
//! It is a step function, since a degree is a whole number, and it starts from no angle at all,
//! so that heights compare as angles do. The dashed line is Delaunay's angle.
//!
//! Limits: if labels would run into one another, some are left out at even steps.

use super::pixel;
use askama::Template;
use glam::DVec2;
use mindeg::Bounds;
use mindeg::exact::{ExactMesh, TradeOff};
use mindeg_answers::advice::AdvisedMesh;
use mindeg_answers::numbers::{count, percent, significant, steady_angle};

/// Space for numbers left of the axis and below it, and for what reaches over the right end.
const LEFT: f64 = 68.0;
const RIGHT: f64 = 12.0;
const BELOW: f64 = 52.0;

/// How much higher than the highest point the curve's box is: that much holds a name.
const HEADROOM: f64 = 1.2;

/// The least distance of two numbers on the axis of degrees.
const LEAST_STEP: f64 = 30.0;

/// The least distance of two labels.
const APART: f64 = 58.0;

/// The curve of a trade-off as SVG elements, in pixels, y downwards. Its looks are
/// [`CURVE_STYLE`](super::CURVE_STYLE).
#[derive(Template)]
#[template(path = "curve.svg")]
pub(in crate::report) struct Curve {
    left: f64,
    right: f64,
    bottom: f64,
    middle: DVec2,
    numbers_x: f64,
    angle_title_x: f64,
    degree_title_y: f64,
    angles: Vec<Tick>,
    degrees: Vec<Tick>,
    ceiling: f64,
    ceiling_label_x: f64,
    ceiling_label_y: f64,
    ceiling_label: String,
    /// Where Delaunay's own degree is on the ceiling.
    delaunay_x: Option<f64>,
    /// The steps, as SVG's path commands.
    path: String,
    points: Vec<Point>,
    /// The mesh with points inside.
    inside: Option<Inside>,
    point_class: &'static str,
    radius: f64,
    labels: Vec<Label>,
}

/// A number on an axis.
struct Tick {
    at: f64,
    label_at: f64,
    label: String,
}

/// A mesh on the curve.
struct Point {
    x: f64,
    y: f64,
    max_degree: u32,
    title: String,
    is_linked: bool,
    is_advised: bool,
}

/// The mesh with points inside, on no curve.
struct Inside {
    x: f64,
    y: f64,
    title: String,
    /// Its name is beside it, where there is space.
    label_x: f64,
    label_y: f64,
    anchor: &'static str,
    is_linked: bool,
}

/// The marks that a curve shows besides the meshes of a trade-off.
#[derive(Clone, Copy, Default)]
pub(in crate::report) struct Marks {
    /// The degree to take.
    pub(in crate::report) advised: Option<u32>,
    /// The maximum degree of the Delaunay triangulation.
    pub(in crate::report) delaunay: Option<u32>,
    /// The mesh with points inside.
    pub(in crate::report) inside: Option<AdvisedMesh>,
    /// Whether that leads to `#points-inside`.
    pub(in crate::report) links_inside: bool,
}

/// An angle beside its point.
struct Label {
    x: f64,
    y: f64,
    anchor: &'static str,
    text: String,
}

impl Curve {
    /// The curve in some space of a picture. Points whose mesh `is_linked` lead to `#degree-` and its
    /// degree.
    pub(in crate::report) fn new(
        trade_off: &TradeOff,
        space: Bounds,
        marks: Marks,
        is_linked: impl Fn(u32) -> bool,
    ) -> Self {
        let axes = Axes::new(trade_off, space, marks);
        let Bounds { min, max } = axes.space;
        let ceiling = axes.y(trade_off.delaunay_min_angle());
        let delaunay_angle = steady_angle(trade_off.delaunay_min_angle());
        let radius = (0.3 * axes.step).clamp(2.0, 6.0);
        let point = |exact: &ExactMesh| {
            let place = axes.place(exact);
            Point {
                x: pixel(place.x),
                y: pixel(place.y),
                max_degree: exact.max_degree,
                title: format!(
                    "degree {}: {}, {} of Delaunay's",
                    count(exact.max_degree),
                    steady_angle(exact.min_angle),
                    percent(trade_off.share(exact)),
                ),
                is_linked: is_linked(exact.max_degree),
                is_advised: marks.advised == Some(exact.max_degree),
            }
        };
        let points: Vec<Point> = trade_off.meshes().iter().map(point).collect();
        Self {
            left: pixel(min.x),
            right: pixel(max.x),
            bottom: pixel(max.y),
            middle: axes.space.center().map(pixel),
            numbers_x: pixel(min.x - 8.0),
            angle_title_x: pixel(min.x - 54.0),
            degree_title_y: pixel(max.y + 44.0),
            angles: axes.angles(),
            degrees: axes.degrees(),
            ceiling: pixel(ceiling),
            ceiling_label_x: pixel(min.x + 6.0),
            ceiling_label_y: pixel(ceiling - 16.0),
            ceiling_label: match marks.delaunay {
                Some(degree) => format!("Delaunay, degree {}: {delaunay_angle}", count(degree)),
                None => format!("Delaunay: {delaunay_angle}"),
            },
            delaunay_x: marks.delaunay.map(|degree| pixel(axes.x(degree))),
            path: steps(&points),
            points,
            inside: marks.inside.map(|inside| axes.inside(inside, marks.links_inside)),
            // A ring sets a point off from the line; it would drown a small one.
            point_class: if radius < 4.0 { "point" } else { "point ringed" },
            radius: pixel(radius),
            labels: axes.labels(trade_off, marks),
        }
    }
}

/// A level line from each point to the next, then up.
fn steps(points: &[Point]) -> String {
    let commands = points.iter().enumerate().map(|(i, &Point { x, y, .. })| match i {
        0 => format!("M{x} {y}"),
        _ => format!("H{x}V{y}"),
    });
    commands.collect()
}

struct Axes {
    /// The box of the curve itself, in pixels.
    space: Bounds,
    /// The first degree, and the pixels from one to the next.
    first: u32,
    step: f64,
    count: u32,
    /// The angle at the top.
    top: f64,
}

impl Axes {
    fn new(trade_off: &TradeOff, space: Bounds, marks: Marks) -> Self {
        let meshes = trade_off.meshes().iter().map(|exact| exact.max_degree);
        let inside = marks.inside.map(|inside| inside.max_degree);
        let degrees = meshes.chain(marks.delaunay).chain(inside);
        let [first, last] = [degrees.clone().min(), degrees.max()].map(Option::unwrap_or_default);
        let space = Bounds {
            min: space.min + DVec2::new(LEFT, 0.0),
            max: space.max - DVec2::new(RIGHT, BELOW),
        };
        let count = last - first + 1;
        let step = space.size().x / f64::from(count);
        let inside = marks.inside.map_or(0.0, |inside| inside.min_angle);
        let top = HEADROOM * trade_off.delaunay_min_angle().max(inside);
        Self { space, first, step, count, top }
    }

    fn inside(&self, inside: AdvisedMesh, is_linked: bool) -> Inside {
        let (x, y) = (self.x(inside.max_degree), self.y(inside.min_angle));
        let is_left = x > self.space.center().x;
        Inside {
            x: pixel(x),
            y: pixel(y),
            title: format!(
                "points inside: degree {}, {}",
                count(inside.max_degree),
                steady_angle(inside.min_angle)
            ),
            label_x: pixel(x + if is_left { -14.0 } else { 14.0 }),
            label_y: pixel(y + 4.5),
            anchor: if is_left { "end" } else { "start" },
            is_linked,
        }
    }

    fn x(&self, degree: u32) -> f64 {
        self.space.min.x + (f64::from(degree - self.first) + 0.5) * self.step
    }

    fn y(&self, angle: f64) -> f64 {
        self.space.max.y - angle / self.top * self.space.size().y
    }

    fn place(&self, exact: &ExactMesh) -> DVec2 {
        DVec2::new(self.x(exact.max_degree), self.y(exact.min_angle))
    }

    fn angles(&self) -> Vec<Tick> {
        let rise = round_step(self.top / 6.0);
        let tick = |i| {
            let value = f64::from(i) * rise;
            let y = self.y(value);
            Tick {
                at: pixel(y),
                label_at: pixel(y + 4.5),
                label: format!("{}°", significant(value, 3)),
            }
        };
        (0..=(self.top / rise) as u32).map(tick).collect()
    }

    fn degrees(&self) -> Vec<Tick> {
        let apart = round_step(LEAST_STEP / self.step).max(1.0) as u32;
        let degrees = (self.first..self.first + self.count).filter(|d| d.is_multiple_of(apart));
        let label_at = pixel(self.space.max.y + 20.0);
        degrees.map(|d| Tick { at: pixel(self.x(d)), label_at, label: count(d) }).collect()
    }

    /// The angles themselves, below the steps on their right, where no line is: of the advised mesh,
    /// of the first, and of as many others as there is space for. Delaunay's is on its line.
    fn labels(&self, trade_off: &TradeOff, marks: Marks) -> Vec<Label> {
        let is_advised = |exact: &ExactMesh| marks.advised == Some(exact.max_degree);
        let meshes = || trade_off.meshes().iter();
        let others = meshes()
            .filter(|exact| !is_advised(exact) && exact.min_angle < trade_off.delaunay_min_angle());
        let mut taken: Vec<f64> = Vec::new();
        let mut labels = Vec::new();
        for exact in meshes().filter(|exact| is_advised(exact)).chain(others) {
            let DVec2 { x, y } = self.place(exact);
            let has_space = x + APART < self.space.max.x + RIGHT;
            if !has_space || taken.iter().any(|other| (other - x).abs() < APART) {
                continue;
            }
            let text = steady_angle(exact.min_angle);
            // Degrees that change nothing need no second label.
            if labels.iter().any(|label: &Label| label.text == text) {
                continue;
            }
            taken.push(x);
            let is_low = y > self.space.max.y - 24.0;
            labels.push(Label {
                x: pixel(x + 8.0),
                y: pixel(if is_low { y - 9.0 } else { y + 18.0 }),
                anchor: "start",
                text,
            });
        }
        labels
    }
}

/// The least of 1, 2, 5, 10, 20, … times any power of ten that is not below `least`, which is
/// above 0.
fn round_step(least: f64) -> f64 {
    let unit = libm::pow(10.0, libm::floor(libm::log10(least)));
    [1.0, 2.0, 5.0]
        .map(|factor| factor * unit)
        .into_iter()
        .find(|&s| s >= least)
        .unwrap_or(10.0 * unit)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_are_round() {
        for (least, step) in
            [(1.0, 1.0), (1.2, 2.0), (2.5, 5.0), (6.0, 10.0), (0.03, 0.05), (7e-9, 1e-8)]
        {
            assert!((round_step(least) / step - 1.0).abs() < 1e-12, "{least}");
        }
    }
}
