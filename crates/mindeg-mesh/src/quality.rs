//! The quality of a triangle: the Verdict library's measures, and the height.
//!
//! Names and definitions are those of the Verdict geometric quality library (Stimpson, Ernst,
//! Knupp, Pébay, Thompson, "The Verdict Library Reference Manual", Sandia National
//! Laboratories, 2007), which VTK, ParaView and Cubit use. `minimum_height` is the measure that
//! Liu (2005) lists beside the angles. For a triangle with edge lengths `x <= y <= z` and area
//! `A`:
//!
//! | field | formula | unit | range, best first |
//! |---|---|---|---|
//! | `area` | A; negative in the plane where the triangle is clockwise | length² | any |
//! | `min_angle` | the angle opposite x | degrees | 60 to 0 |
//! | `max_angle` | the angle opposite z | degrees | 60 to 180 |
//! | `minimum_height` | 2A/z | length | above 0 |
//! | `edge_ratio` | z/x | 1 | 1 to ∞ |
//! | `aspect_ratio` | z (x+y+z)/(4√3 A) | 1 | 1 to ∞ |
//! | `radius_ratio` | circumradius/(2 inradius) = xyz (x+y+z)/(16 A²) | 1 | 1 to ∞ |
//! | `scaled_jacobian` | 4A/(√3 yz); negative as the area is | 1 | 1 to 0 (-1 where clockwise) |
//! | `shape` | 4√3 A/(x²+y²+z²) | 1 | 1 to 0 |
//!
//! [`METRICS`] has the same table for programs.
//!
//! A triangle without area, or with a coordinate that is not finite, gets the worst value of
//! every measure: area, height, minimum angle, scaled Jacobian and shape 0, maximum angle 180,
//! ratios infinite (Verdict ends them at 1e30); the edge ratio is z/x where x is not 0. Other
//! programs give a triangle with two equal corners other maximum angles: VTK 0, others 90.
//! No measure is ever NaN.
//!
//! Limits: if the area or height of a triangle is beyond the range of f64, it becomes 0 or
//! infinity; the other measures do not depend on size. A triangle with a height below 1e-150 of its
//! longest edge is measured as a flat triangle.

use glam::{DVec2, DVec3};

pub use crate::summary::{ANGLES, DegreeHistogram, Distribution, QualitySummary};
pub use crate::worst::{WorstTriangle, WorstTriangles};

/// The measures of one triangle; see the [module's table](self) for formulas, units and ranges.
///
/// # Example
///
/// ```
/// use mindeg_mesh::quality::TriangleQuality;
///
/// let quality = TriangleQuality::of([0.0, 0.0].into(), [4.0, 0.0].into(), [0.0, 3.0].into());
/// assert_eq!(quality.area, 6.0);
/// assert_eq!(quality.max_angle, 90.0);
/// assert!((quality.minimum_height - 2.4).abs() < 1e-15);
/// assert!((quality.radius_ratio - 1.25).abs() < 1e-15);
///
/// // Clockwise in the plane: turned over.
/// let inverted = TriangleQuality::of([0.0, 0.0].into(), [0.0, 3.0].into(), [4.0, 0.0].into());
/// assert_eq!(inverted.area, -6.0);
/// assert_eq!(inverted.shape, quality.shape);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TriangleQuality {
    /// The area, in square units of length; negative where a triangle in the plane is clockwise.
    pub area: f64,
    /// The minimum angle, in degrees: 60 (equilateral) to 0.
    pub min_angle: f64,
    /// The maximum angle, in degrees: 60 (equilateral) to 180.
    pub max_angle: f64,
    /// The least of the three heights, in units of length.
    pub minimum_height: f64,
    /// The longest edge over the shortest: 1 to ∞.
    pub edge_ratio: f64,
    /// The longest edge over 2√3 inradii: 1 to ∞.
    pub aspect_ratio: f64,
    /// The circumradius over 2 inradii: 1 to ∞.
    pub radius_ratio: f64,
    /// The sine of the minimum angle over that of 60 degrees: 1 to 0, negative where the area is.
    pub scaled_jacobian: f64,
    /// 2 over the condition number (in the Frobenius norm) of the map that makes the triangle
    /// from an equilateral one: 1 to 0.
    pub shape: f64,
}

/// The name and definition of a measure, and the function that reads it from a [`TriangleQuality`].
///
/// # Example
///
/// ```
/// use mindeg_mesh::quality::METRICS;
///
/// let shape = METRICS.iter().find(|metric| metric.name == "shape").unwrap();
/// assert_eq!(shape.formula, "4√3 A/(x²+y²+z²)");
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Metric {
    /// The name of the field, and the key in reports.
    pub name: &'static str,
    /// The formula, for edge lengths x <= y <= z and area A.
    pub formula: &'static str,
    /// The unit: `length²`, `length`, `degrees` or `1`.
    pub unit: &'static str,
    /// The value for an equilateral triangle; `None` if it depends on size.
    pub best: Option<f64>,
    /// The value for a triangle without area.
    pub worst: f64,
    /// Reads the measure.
    pub of: fn(&TriangleQuality) -> f64,
}

/// All measures, in the order of [`TriangleQuality`]'s fields.
#[rustfmt::skip]
pub const METRICS: [Metric; 9] = [
    Metric { name: "area", formula: "A", unit: "length²", best: None, worst: 0.0, of: |q| q.area },
    Metric { name: "min_angle", formula: "angle opposite x", unit: "degrees", best: Some(60.0), worst: 0.0, of: |q| q.min_angle },
    Metric { name: "max_angle", formula: "angle opposite z", unit: "degrees", best: Some(60.0), worst: 180.0, of: |q| q.max_angle },
    Metric { name: "minimum_height", formula: "2A/z", unit: "length", best: None, worst: 0.0, of: |q| q.minimum_height },
    Metric { name: "edge_ratio", formula: "z/x", unit: "1", best: Some(1.0), worst: f64::INFINITY, of: |q| q.edge_ratio },
    Metric { name: "aspect_ratio", formula: "z (x+y+z)/(4√3 A)", unit: "1", best: Some(1.0), worst: f64::INFINITY, of: |q| q.aspect_ratio },
    Metric { name: "radius_ratio", formula: "xyz (x+y+z)/(16 A²)", unit: "1", best: Some(1.0), worst: f64::INFINITY, of: |q| q.radius_ratio },
    Metric { name: "scaled_jacobian", formula: "4A/(√3 yz)", unit: "1", best: Some(1.0), worst: 0.0, of: |q| q.scaled_jacobian },
    Metric { name: "shape", formula: "4√3 A/(x²+y²+z²)", unit: "1", best: Some(1.0), worst: 0.0, of: |q| q.shape },
];

const SQRT_3: f64 = 1.732_050_807_568_877_2;

/// The area of a triangle in space, in square units of length: half the cross product of its edges at the first corner.
/// [`TriangleQuality::in_space`] takes the two shorter edges, which matters for needles alone.
#[must_use]
pub fn area_in_space([a, b, c]: [DVec3; 3]) -> f64 {
    0.5 * (b - a).cross(c - a).length()
}

impl TriangleQuality {
    /// The measures of a triangle in the plane; area and scaled Jacobian are negative if it is
    /// clockwise.
    pub fn of(a: DVec2, b: DVec2, c: DVec2) -> Self {
        let (quality, normal) = measure(a.extend(0.0), b.extend(0.0), c.extend(0.0));
        if normal.z < 0.0 {
            let (area, scaled_jacobian) = (-quality.area, -quality.scaled_jacobian);
            Self { area, scaled_jacobian, ..quality }
        } else {
            quality
        }
    }

    /// The measures of a triangle in space, where it has no orientation: no measure is negative.
    pub fn in_space(a: DVec3, b: DVec3, c: DVec3) -> Self {
        measure(a, b, c).0
    }

    /// The worst value of every measure, except the edge ratio if it is finite.
    pub(crate) fn without_area(edge_ratio: f64) -> Self {
        Self {
            area: 0.0,
            min_angle: 0.0,
            max_angle: 180.0,
            minimum_height: 0.0,
            edge_ratio: if edge_ratio.is_finite() { edge_ratio } else { f64::INFINITY },
            aspect_ratio: f64::INFINITY,
            radius_ratio: f64::INFINITY,
            scaled_jacobian: 0.0,
            shape: 0.0,
        }
    }
}

/// The minimum angle of some triangles in space, in degrees; infinite without any.
#[must_use]
pub fn min_angle(positions: &[DVec3], triangles: &[[u32; 3]]) -> f64 {
    let angle = |corners: &[u32; 3]| {
        let [a, b, c] = corners.map(|vertex| positions[vertex as usize]);
        TriangleQuality::in_space(a, b, c).min_angle
    };
    triangles.iter().map(angle).fold(f64::INFINITY, f64::min)
}

/// The measures of a triangle, and a vector along its normal.
fn measure(a: DVec3, b: DVec3, c: DVec3) -> (TriangleQuality, DVec3) {
    // Scaled by powers of two to a size of about 1, exactly, so that no difference or product of
    // lengths overflows or vanishes.
    let shrink = if largest_coordinate([a, b, c]) < HUGE { 0 } else { 2 };
    let [a, b, c] = [a, b, c].map(|point| point * libm::ldexp(1.0, -shrink));
    let edges = [c - b, a - c, b - a];
    let size = edges.map(|edge| edge.abs().max_element()).into_iter().fold(0.0, f64::max);
    let exponent = libm::frexp(size).1.clamp(-1000, 1000);
    let edges = edges.map(|edge| edge * libm::ldexp(1.0, -exponent));
    let exponent = exponent + shrink;

    let mut order = [0, 1, 2];
    let squares = edges.map(|edge| edge.length_squared());
    order.sort_by(|&i, &j| squares[i].total_cmp(&squares[j]));
    let [shortest, _, longest] = order;
    let [x, y, z] = order.map(|i| squares[i].sqrt());
    // Twice the area, from the two shorter edges: the cross product of two long and almost
    // parallel edges would cancel.
    let normal = edges[(longest + 1) % 3].cross(edges[(longest + 2) % 3]);
    let double_area = normal.length();
    // Also refuses NaN.
    if !(double_area > 0.0 && size.is_finite()) {
        return (TriangleQuality::without_area(z / x), DVec3::ZERO);
    }
    let angle_opposite = |edge: usize| {
        let dot = -edges[(edge + 1) % 3].dot(edges[(edge + 2) % 3]);
        libm::atan2(double_area, dot).to_degrees()
    };
    let perimeter = x + y + z;
    let quality = TriangleQuality {
        area: libm::ldexp(double_area / 2.0, 2 * exponent),
        min_angle: angle_opposite(shortest),
        max_angle: angle_opposite(longest),
        minimum_height: libm::ldexp(double_area / z, exponent),
        edge_ratio: z / x,
        aspect_ratio: z * perimeter / (2.0 * SQRT_3 * double_area),
        radius_ratio: (x * y * z / double_area) * (perimeter / double_area) / 4.0,
        scaled_jacobian: 2.0 / SQRT_3 * double_area / (y * z),
        shape: 2.0 * SQRT_3 * double_area / (squares[0] + squares[1] + squares[2]),
    };
    (quality, normal)
}

/// Whether the corners of a triangle with these measures are on one line, exactly.
///
/// Exact for corners whose coordinates, other than zeros, are not smaller than 1e-140 of the
/// largest one; smaller ones may be taken for 0.
pub(crate) fn is_flat(corners: [DVec3; 3], quality: &TriangleQuality) -> bool {
    // Rounding explains heights below this share of the coordinates.
    const ROUNDING: f64 = 64.0 * f64::EPSILON;
    let largest = largest_coordinate(corners);
    if quality.minimum_height > ROUNDING * largest {
        return false;
    }
    // At a size of about 1, products stay in range.
    let exponent = libm::frexp(largest).1;
    let scaled = corners.map(|p| p.to_array().map(|x| libm::ldexp(x, -exponent)));
    // The components of twice the area as a vector, seen along each axis.
    [[0, 1], [1, 2], [2, 0]].iter().all(|axes| {
        let [a, b, c] = scaled.map(|p| robust::Coord { x: p[axes[0]], y: p[axes[1]] });
        robust::orient2d(a, b, c) == 0.0
    })
}

/// Differences of smaller coordinates than this stay in range.
const HUGE: f64 = f64::MAX / 4.0;

fn largest_coordinate(points: [DVec3; 3]) -> f64 {
    points.into_iter().map(|point| point.abs().max_element()).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Triangles with their measures by VTK 9.7.2's `vtkMeshQuality`, which calls Verdict: area,
    /// angles, edge, aspect and radius ratio, scaled Jacobian, shape.
    #[rustfmt::skip]
    #[expect(clippy::type_complexity, clippy::approx_constant, reason = "a table of what VTK prints")]
    const BY_VERDICT: [(&str, [[f64; 3]; 3], [f64; 8]); 12] = [
        ("equilateral", [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [1.0, 1.7320508075688772, 0.0]], [1.7320508075688772, 59.99999999999999, 60.00000000000001, 1.0, 0.9999999999999999, 0.9999999999999998, 1.0, 1.0]),
        ("right isosceles", [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], [0.5, 45.00000000000001, 90.0, 1.4142135623730951, 1.3938468501173515, 1.2071067811865475, 0.8164965809277261, 0.8660254037844385]),
        ("3-4-5", [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 3.0, 0.0]], [6.0, 36.86989764584401, 90.0, 1.6666666666666667, 1.4433756729740643, 1.25, 0.6928203230275509, 0.831384387633061]),
        ("30-60-90", [[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [-1.0, 2.4641016151377544, 0.0]], [3.4641016151377544, 29.999999999999993, 90.0, 1.9999999999999998, 1.5773502691896253, 1.3660254037844384, 0.577350269189626, 0.75]),
        ("needle", [[0.0, 0.0, 0.0], [10.0, -0.005, 0.0], [10.0, 0.005, 0.0]], [0.05, 0.0572957747418006, 89.97135211263078, 1000.0001249999921, 577.6390886978724, 500.2501875625118, 0.0011547002497041892, 0.0017320495085317456]),
        ("cap", [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.5, 0.01, 0.0]], [0.005, 1.1457628381748262, 177.70847432365025, 1.9996001199600142, 57.740799844419634, 1250.6250374975, 0.023089393350610443, 0.023090931976654808]),
        ("obtuse", [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [5.0, 1.0, 0.0]], [2.0, 11.309932474020195, 135.0, 3.6055512754639896, 3.8687650191207914, 4.738250115787373, 0.22645540682891915, 0.31491832864888675]),
        ("sliver of a fin", [[0.0, 0.0, 0.0], [200.0, 1.0, 0.0], [0.0, 1.0, 0.0]], [100.0, 0.28647651027845283, 90.0, 200.00249998437516, 115.76089763993554, 100.25187812107427, 0.005773430524465746, 0.008660037536905963]),
        ("survey coordinates", [[500000.0, 4650000.0, 0.0], [500010.5, 4650002.25, 0.0], [500003.75, 4650009.5, 0.0]], [45.65625, 56.36426700444946, 64.4955674296512, 1.084047616882575, 1.047558716395608, 1.0051636741554602, 0.9613758993794981, 0.9954863217380526]),
        ("a tenth of a millimetre", [[0.0, 0.0, 0.0], [0.0001, 0.0, 0.0], [3e-05, 7e-05, 0.0]], [3.5e-09, 45.0, 68.1985905136482, 1.3130643285972254, 1.1347105293677127, 1.058387522294373, 0.8164965809277261, 0.9472152853892298]),
        ("scalene in space", [[0.0, 0.0, 0.0], [1.0, 2.0, 2.0], [3.0, 0.0, 1.0]], [4.031128874149275, 58.193899980621495, 63.61220003875701, 1.0540925533894598, 1.037423657506474, 1.002934590958048, 0.9813067629253165, 0.9974457174120671]),
        ("slanted needle in space", [[1.0, 1.0, 1.0], [4.0, 5.0, 6.0], [4.001, 5.002, 6.0]], [0.0056789083457998634, 0.013012236336285283, 134.0831109999785, 3162.973442822501, 2542.8836983158526, 3065.718527817522, 0.0002622398414426151, 0.0003933597329807977]),
    ];

    #[test]
    fn agrees_with_verdict() {
        for (name, points, expected) in BY_VERDICT {
            let [a, b, c] = points.map(DVec3::from);
            let quality = TriangleQuality::in_space(a, b, c);
            let found = METRICS.iter().filter(|metric| metric.name != "minimum_height");
            for (metric, expected) in found.zip(expected) {
                let value = (metric.of)(&quality);
                // Verdict takes angles from their cosines, which lose digits as the sine shrinks.
                let tolerance = match metric.unit {
                    "degrees" => (1e-15 / expected.to_radians().sin()).to_degrees(),
                    _ => 1e-11 * expected,
                };
                let name = format!("{name}: {} is {value}, not {expected}", metric.name);
                assert!((value - expected).abs() <= tolerance, "{name}");
            }
        }
    }

    #[test]
    fn heights_and_orientation() {
        let [a, b, c] = [[0.0, 0.0], [4.0, 0.0], [1.0, 2.0]].map(DVec2::from);
        let upright = TriangleQuality::of(a, b, c);
        assert_eq!((upright.area, upright.minimum_height), (4.0, 2.0));
        assert_eq!(upright, TriangleQuality::of(b, c, a));
        let [area, scaled_jacobian] = [-upright.area, -upright.scaled_jacobian];
        let inverted = TriangleQuality { area, scaled_jacobian, ..upright };
        assert_eq!(TriangleQuality::of(a, c, b), inverted);
        assert_eq!(TriangleQuality::in_space(a.extend(7.0), c.extend(7.0), b.extend(7.0)), upright);
    }

    #[test]
    fn measures_of_shape_do_not_depend_on_size() {
        let triangle = [[0.0, 0.0], [4.0, 0.0], [1.0, 2.0]];
        let at = |scale: f64| {
            let [a, b, c] = triangle.map(|[x, y]| DVec2::new(x * scale, y * scale));
            TriangleQuality::of(a, b, c)
        };
        let unit = at(1.0);
        for exponent in [-1060, -600, -100, 100, 600, 1020] {
            let scale = libm::ldexp(1.0, exponent);
            let area = libm::ldexp(unit.area, 2 * exponent);
            let minimum_height = libm::ldexp(unit.minimum_height, exponent);
            assert_eq!(at(scale), TriangleQuality { area, minimum_height, ..unit }, "2^{exponent}");
        }
    }

    #[test]
    fn the_largest_coordinates_have_their_shape() {
        let at = |x: f64, y: f64| DVec2::new(x, y);
        let huge = TriangleQuality::of(at(1e308, 0.0), at(0.0, 1e308), at(-1e308, 0.0));
        let unit = TriangleQuality::of(at(1.0, 0.0), at(0.0, 1.0), at(-1.0, 0.0));
        assert!((huge.max_angle - 90.0).abs() < 1e-13 && (huge.min_angle - 45.0).abs() < 1e-13);
        assert!((huge.minimum_height / 1e308 - 1.0).abs() < 1e-15, "{huge:?}");
        assert_eq!((huge.area, unit.area), (f64::INFINITY, 1.0));
    }

    #[test]
    fn a_triangle_without_area_has_the_worst_values() {
        let (nan, infinity) = (f64::NAN, f64::INFINITY);
        for (points, edge_ratio) in [
            ([[0.0, 0.0], [1.0, 1.0], [3.0, 3.0]], 3.0),
            ([[0.0, 0.0], [0.0, 0.0], [1.0, 0.0]], infinity),
            ([[5.0, 5.0]; 3], infinity),
            ([[0.0, nan], [1.0, 0.0], [0.0, 1.0]], infinity),
            ([[0.0, infinity], [1.0, 0.0], [0.0, 1.0]], infinity),
        ] {
            let [a, b, c] = points.map(DVec2::from);
            let quality = TriangleQuality::of(a, b, c);
            assert!(
                (quality.edge_ratio - edge_ratio).abs() < 1e-15 || quality.edge_ratio == edge_ratio
            );
            for metric in METRICS.iter().filter(|metric| metric.name != "edge_ratio") {
                assert_eq!((metric.of)(&quality), metric.worst, "{}, {points:?}", metric.name);
            }
        }
    }

    #[test]
    fn an_equilateral_triangle_is_the_best() {
        let corner = |i: u32| {
            let angle = f64::from(120 * i).to_radians();
            DVec2::new(libm::cos(angle), libm::sin(angle))
        };
        let quality = TriangleQuality::of(corner(0), corner(1), corner(2));
        for metric in METRICS {
            if let Some(best) = metric.best {
                let value = (metric.of)(&quality);
                assert!((value / best - 1.0).abs() < 1e-15, "{} is {value}", metric.name);
            }
        }
    }
}
