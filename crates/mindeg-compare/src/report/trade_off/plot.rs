//! The curve: the largest smallest angle over the maximum degree.
//!
//! It is a step function, since a degree is a whole number, and it starts from no angle at all,
//! so that heights compare as angles do. The dashed line is Delaunay's angle.
//!
//! Limits: of labels that would run into one another, only every so many are there.

use crate::number_format::{count, percent, significant, steady_angle};
use glam::DVec2;
use mindeg::Bounds;
use mindeg::exact::{ExactMesh, TradeOff};
use std::fmt::Write;

/// Room for numbers left of the axis and below it, and for a name right of the ceiling.
const LEFT: f64 = 72.0;
const RIGHT: f64 = 76.0;
const BELOW: f64 = 52.0;

/// How much higher than the highest point the plot is.
const HEADROOM: f64 = 1.15;

/// The least distance of two labels.
const APART: f64 = 58.0;

/// Draws the curve into some room of a picture, in pixels, y downwards. Its classes are `axis`,
/// `grid`, `curve`, `point`, `ringed`, `ceiling`, and of text `tick` and `value`. `wrap` may put the marker
/// of a point, by its place in the list, into a link.
pub(super) fn plot(
    trade_off: &TradeOff,
    room: Bounds,
    wrap: impl Fn(usize, String) -> String,
) -> String {
    let axes = Axes::new(trade_off, room);
    let mut svg = axes.grid();
    let [left, right] = [axes.room.min.x, axes.room.max.x];
    let ceiling = axes.y(trade_off.delaunay_min_angle());
    // Writing to a string cannot fail.
    let _ = writeln!(
        svg,
        r#"<path class="ceiling" d="M{left:.1} {ceiling:.1}H{right:.1}"/>
<text class="tick" x="{x:.1}" y="{:.1}">Delaunay</text><text class="tick" x="{x:.1}" y="{:.1}">{}</text>"#,
        ceiling - 2.0,
        ceiling + 14.0,
        steady_angle(trade_off.delaunay_min_angle()),
        x = right + 8.0,
    );
    let mut curve = String::new();
    for (place, exact) in trade_off.meshes().iter().enumerate() {
        let DVec2 { x, y } = axes.place(exact);
        let _ = match place {
            0 => write!(curve, "M{x:.1} {y:.1}"),
            _ => write!(curve, "H{x:.1}V{y:.1}"),
        };
    }
    let _ = writeln!(svg, r#"<path class="curve" d="{curve}H{right:.1}"/>"#);
    let radius = (0.3 * axes.step).clamp(2.0, 6.0);
    // A ring sets a point off from the line; it would drown a small one.
    let class = if radius < 4.0 { "point" } else { "point ringed" };
    for (place, exact) in trade_off.meshes().iter().enumerate() {
        let DVec2 { x, y } = axes.place(exact);
        let marker = format!(
            r#"<circle class="{class}" cx="{x:.1}" cy="{y:.1}" r="{radius:.1}"><title>degree {}: {}, {} of Delaunay's</title></circle>"#,
            count(exact.max_degree),
            steady_angle(exact.min_angle),
            percent(trade_off.share(exact)),
        );
        let _ = writeln!(svg, "{}", wrap(place, marker));
    }
    svg += &axes.values(trade_off);
    svg
}

struct Axes {
    /// The box of the plot itself, in pixels.
    room: Bounds,
    /// The first degree, and the pixels from one to the next.
    first: u32,
    step: f64,
    count: u32,
    /// The angle at the top.
    top: f64,
}

impl Axes {
    fn new(trade_off: &TradeOff, room: Bounds) -> Self {
        let degrees = trade_off.meshes().iter().map(|exact| exact.max_degree);
        let [first, last] = [degrees.clone().min(), degrees.max()].map(Option::unwrap_or_default);
        let room = Bounds {
            min: room.min + DVec2::new(LEFT, 0.0),
            max: room.max - DVec2::new(RIGHT, BELOW),
        };
        let count = last - first + 1;
        let step = room.size().x / f64::from(count);
        Self { room, first, step, count, top: HEADROOM * trade_off.delaunay_min_angle() }
    }

    fn x(&self, degree: u32) -> f64 {
        self.room.min.x + (f64::from(degree - self.first) + 0.5) * self.step
    }

    fn y(&self, angle: f64) -> f64 {
        self.room.max.y - angle / self.top * self.room.size().y
    }

    fn place(&self, exact: &ExactMesh) -> DVec2 {
        DVec2::new(self.x(exact.max_degree), self.y(exact.min_angle))
    }

    /// Both axes with their numbers and names.
    fn grid(&self) -> String {
        let Bounds { min, max } = self.room;
        let mut svg = String::new();
        let rise = round_step(self.top / 6.0);
        for i in 0..=(self.top / rise) as u32 {
            let value = f64::from(i) * rise;
            let y = self.y(value);
            let _ = writeln!(
                svg,
                r#"<path class="grid" d="M{:.1} {y:.1}H{:.1}"/><text class="tick" text-anchor="end" x="{:.1}" y="{:.1}">{}°</text>"#,
                min.x,
                max.x,
                min.x - 8.0,
                y + 4.5,
                significant(value, 3),
            );
        }
        let apart = round_step(f64::from(self.count) / 16.0).max(1.0) as u32;
        for degree in (self.first..self.first + self.count).filter(|d| d.is_multiple_of(apart)) {
            let _ = writeln!(
                svg,
                r#"<text class="tick" text-anchor="middle" x="{:.1}" y="{:.1}">{}</text>"#,
                self.x(degree),
                max.y + 20.0,
                count(degree),
            );
        }
        let _ = writeln!(
            svg,
            r#"<path class="axis" d="M{:.1} {:.1}H{:.1}"/>
<text class="tick" text-anchor="middle" x="{:.1}" y="{:.1}">maximum degree</text>
<text class="tick" text-anchor="middle" transform="translate({:.1} {:.1}) rotate(-90)">smallest angle</text>"#,
            min.x,
            max.y,
            max.x,
            self.room.center().x,
            max.y + 44.0,
            min.x - 60.0,
            self.room.center().y,
        );
        svg
    }

    /// The angles themselves, below the steps on their right, where no line is; the last one above
    /// the point where there is no room to its right.
    fn values(&self, trade_off: &TradeOff) -> String {
        let mut svg = String::new();
        let mut free_from = f64::NEG_INFINITY;
        let last = self.x(self.first + self.count - 1);
        for exact in trade_off.meshes() {
            let DVec2 { x, y } = self.place(exact);
            let is_last = x == last;
            if !is_last && (x < free_from || x > last - APART) {
                continue;
            }
            free_from = x + APART;
            let is_low = y > self.room.max.y - 24.0;
            let (anchor, x, y) = if is_last && x + APART > self.room.max.x {
                ("end", x + 4.0, y - 12.0)
            } else {
                ("start", x + 8.0, if is_low { y - 9.0 } else { y + 18.0 })
            };
            let _ = writeln!(
                svg,
                r#"<text class="value" text-anchor="{anchor}" x="{x:.1}" y="{y:.1}">{}</text>"#,
                steady_angle(exact.min_angle),
            );
        }
        svg
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
