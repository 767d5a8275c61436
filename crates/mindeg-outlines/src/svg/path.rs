//! Path data: subpaths of lines and curves in absolute coordinates.

use glam::{DAffine2, DVec2};
use svgtypes::{PathParser, PathSegment};

use super::super::curve::{EllipseArc, PieceCurve};
use super::super::outline::{DrawnRing, Piece};
use super::arc::{self, Ends};

/// A gap between the ends of a closed subpath below this share of its size comes from adding up
/// relative coordinates that a program rounded: icons of 16 units have three decimals.
const GAP: f64 = 5e-4;

/// One run of the pen.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Subpath {
    pub(super) start: DVec2,
    /// Each curve with its end.
    pub(super) curves: Vec<(PieceCurve, DVec2)>,
    /// Whether it ends where it starts, or is told to.
    pub(super) is_closed: bool,
    /// Whether positions are sums of relative coordinates.
    pub(super) is_summed: bool,
}

impl Subpath {
    pub(super) fn at(start: DVec2) -> Self {
        Self { start, curves: Vec::new(), is_closed: false, is_summed: false }
    }

    /// A closed subpath of straight lines.
    pub(super) fn polygon(points: &[DVec2]) -> Option<Self> {
        let (&start, rest) = points.split_first()?;
        let curves = rest.iter().map(|&point| (PieceCurve::Line, point)).collect();
        Some(Self { curves, is_closed: true, ..Self::at(start) })
    }

    fn end(&self) -> DVec2 {
        self.curves.last().map_or(self.start, |&(_, end)| end)
    }

    /// The subpath as a ring in the coordinates that the transform leads to. A subpath that does
    /// not end at its start is closed by a line.
    pub(super) fn ring(&self, transform: &DAffine2) -> DrawnRing {
        let place = |point: DVec2| transform.transform_point2(point);
        let along = |vector: DVec2| transform.transform_vector2(vector);
        let mut pieces = Vec::with_capacity(self.curves.len() + 1);
        let mut start = self.start;
        for &(curve, end) in &self.curves {
            // A line to where the pen is draws nothing.
            if curve != PieceCurve::Line || start != end {
                let curve = match curve {
                    PieceCurve::Line => PieceCurve::Line,
                    PieceCurve::Cubic(controls) => PieceCurve::Cubic(controls.map(place)),
                    PieceCurve::Arc(arc) => PieceCurve::Arc(EllipseArc {
                        center: place(arc.center),
                        axes: arc.axes.map(along),
                        ..arc
                    }),
                };
                pieces.push(Piece { curve, ..Piece::line(place(start)) });
            }
            start = end;
        }
        if start != self.start && !self.has_small_gap() {
            pieces.push(Piece::line(place(start)));
        }
        DrawnRing { pieces }
    }

    /// Whether the ends are so near each other that they should be one point, but for rounding.
    pub(super) fn has_small_gap(&self) -> bool {
        if !self.is_summed {
            return false;
        }
        let size = self.curves.iter().map(|&(_, end)| (end - self.start).abs().max_element());
        let size = size.fold(0.0, f64::max);
        let gap = (self.end() - self.start).abs().max_element();
        gap > 0.0 && gap <= GAP * size
    }
}

/// The subpaths of path data.
pub(super) fn subpaths(data: &str) -> Result<Vec<Subpath>, String> {
    let mut pen = Pen::default();
    for segment in PathParser::from(data) {
        pen.draw(segment.map_err(|error| format!("path data: {error}"))?);
    }
    let mut subpaths: Vec<Subpath> =
        pen.subpaths.into_iter().filter(|subpath| !subpath.curves.is_empty()).collect();
    for subpath in &mut subpaths {
        subpath.is_closed |= subpath.end() == subpath.start;
    }
    Ok(subpaths)
}

#[derive(Default)]
struct Pen {
    at: DVec2,
    subpaths: Vec<Subpath>,
    /// The last control point of the curve before, for curves that go on smoothly.
    control: Option<Control>,
}

#[derive(Clone, Copy)]
enum Control {
    Cubic(DVec2),
    Quadratic(DVec2),
}

impl Pen {
    fn draw(&mut self, segment: PathSegment) {
        let base = if segment.is_abs() { DVec2::ZERO } else { self.at };
        let point = |x: f64, y: f64| base + DVec2::new(x, y);
        let control = self.control.take();
        let is_summed = !segment.is_abs();
        match segment {
            PathSegment::MoveTo { x, y, .. } => {
                self.at = point(x, y);
                self.subpaths.push(Subpath::at(self.at));
            }
            PathSegment::LineTo { x, y, .. } => self.to(PieceCurve::Line, point(x, y)),
            PathSegment::HorizontalLineTo { x, .. } => {
                self.to(PieceCurve::Line, DVec2::new(base.x + x, self.at.y));
            }
            PathSegment::VerticalLineTo { y, .. } => {
                self.to(PieceCurve::Line, DVec2::new(self.at.x, base.y + y));
            }
            PathSegment::CurveTo { x1, y1, x2, y2, x, y, .. } => {
                self.cubic(point(x1, y1), point(x2, y2), point(x, y));
            }
            PathSegment::SmoothCurveTo { x2, y2, x, y, .. } => {
                let first = match control {
                    Some(Control::Cubic(control)) => 2.0 * self.at - control,
                    _ => self.at,
                };
                self.cubic(first, point(x2, y2), point(x, y));
            }
            PathSegment::Quadratic { x1, y1, x, y, .. } => {
                self.quadratic(point(x1, y1), point(x, y));
            }
            PathSegment::SmoothQuadratic { x, y, .. } => {
                let middle = match control {
                    Some(Control::Quadratic(control)) => 2.0 * self.at - control,
                    _ => self.at,
                };
                self.quadratic(middle, point(x, y));
            }
            PathSegment::EllipticalArc {
                rx, ry, x_axis_rotation, large_arc, sweep, x, y, ..
            } => {
                let ends = Ends {
                    radii: DVec2::new(rx, ry),
                    rotation: x_axis_rotation,
                    is_large: large_arc,
                    sweeps: sweep,
                };
                let end = point(x, y);
                self.to(arc::between(self.at, end, ends), end);
            }
            PathSegment::ClosePath { .. } => {
                if let Some(subpath) = self.subpaths.last_mut() {
                    subpath.is_closed = true;
                    self.at = subpath.start;
                    // A segment that follows without a move starts here.
                    self.subpaths.push(Subpath::at(self.at));
                }
            }
        }
        if let Some(subpath) = self.subpaths.last_mut() {
            subpath.is_summed |= is_summed && !subpath.curves.is_empty();
        }
    }

    fn to(&mut self, curve: PieceCurve, end: DVec2) {
        self.at = end;
        if let Some(subpath) = self.subpaths.last_mut() {
            subpath.curves.push((curve, end));
        }
    }

    fn cubic(&mut self, first: DVec2, second: DVec2, end: DVec2) {
        let is_point = [first, second, end] == [self.at; 3];
        let curve = if is_point { PieceCurve::Line } else { PieceCurve::Cubic([first, second]) };
        self.to(curve, end);
        self.control = Some(Control::Cubic(second));
    }

    fn quadratic(&mut self, middle: DVec2, end: DVec2) {
        // The same curve as a cubic.
        let toward = |from: DVec2| from + (middle - from) * (2.0 / 3.0);
        self.cubic(toward(self.at), toward(end), end);
        self.control = Some(Control::Quadratic(middle));
    }
}
