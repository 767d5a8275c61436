//! Transforms of attributes and of style sheets, and the boxes that drawings are fitted into.

use glam::{DAffine2, DVec2};
use svgtypes::{
    Align, Angle, AspectRatio, Length, LengthUnit, TransformListParser, TransformListToken,
    TransformOrigin, ViewBox,
};

use super::super::text::quoted;

/// The product of an attribute's list of transforms.
pub(super) fn of_attribute(text: &str) -> Result<DAffine2, String> {
    let tokens = TransformListParser::from(text);
    product(tokens.map(|token| token.map_err(|error| format!("transform: {error}"))))
}

/// The product of the transforms of a style, whose numbers have units.
pub(super) fn of_style(text: &str) -> Result<DAffine2, String> {
    let functions =
        text.split_inclusive(')').map(str::trim).filter(|it| !matches!(*it, "" | "none"));
    product(functions.map(|function| {
        token(function).ok_or_else(|| {
            format!(
                "transform: {} is not read; give lengths in px and angles in deg",
                quoted(function)
            )
        })
    }))
}

fn token(function: &str) -> Option<TransformListToken> {
    let (name, rest) = function.split_once('(')?;
    let values: Vec<&str> = rest
        .strip_suffix(')')?
        .split(|c: char| c == ',' || c.is_whitespace())
        .filter(|value| !value.is_empty())
        .collect();
    let number = |at: usize| values.get(at)?.parse::<f64>().ok();
    let degrees = |at: usize| Some(values.get(at)?.parse::<Angle>().ok()?.to_degrees());
    let px = |at: usize| in_px(values.get(at)?.parse().ok()?, None);
    // A second value that is left out.
    let or = |at: usize, value: Option<f64>, other: f64| match values.get(at) {
        None => Some(other),
        Some(_) => value,
    };
    use TransformListToken::{Matrix, Rotate, Scale, SkewX, SkewY, Translate};
    let tan = |degrees: f64| libm::tan(degrees.to_radians());
    Some(match (name.trim().to_ascii_lowercase().as_str(), values.len()) {
        ("matrix", 6) => Matrix {
            a: number(0)?,
            b: number(1)?,
            c: number(2)?,
            d: number(3)?,
            e: number(4)?,
            f: number(5)?,
        },
        ("translate", 1 | 2) => Translate { tx: px(0)?, ty: or(1, px(1), 0.0)? },
        ("translatex", 1) => Translate { tx: px(0)?, ty: 0.0 },
        ("translatey", 1) => Translate { tx: 0.0, ty: px(0)? },
        ("scale", 1 | 2) => Scale { sx: number(0)?, sy: or(1, number(1), number(0)?)? },
        ("scalex", 1) => Scale { sx: number(0)?, sy: 1.0 },
        ("scaley", 1) => Scale { sx: 1.0, sy: number(0)? },
        ("rotate", 1) => Rotate { angle: degrees(0)? },
        ("skewx", 1) => SkewX { angle: degrees(0)? },
        ("skewy", 1) => SkewY { angle: degrees(0)? },
        ("skew", 1 | 2) => Matrix {
            a: 1.0,
            b: tan(or(1, degrees(1), 0.0)?),
            c: tan(degrees(0)?),
            d: 1.0,
            e: 0.0,
            f: 0.0,
        },
        _ => return None,
    })
}

fn product(
    tokens: impl Iterator<Item = Result<TransformListToken, String>>,
) -> Result<DAffine2, String> {
    let mut product = DAffine2::IDENTITY;
    for token in tokens {
        product *= match token? {
            TransformListToken::Matrix { a, b, c, d, e, f } => {
                DAffine2::from_cols_array(&[a, b, c, d, e, f])
            }
            TransformListToken::Translate { tx, ty } => {
                DAffine2::from_translation(DVec2::new(tx, ty))
            }
            TransformListToken::Scale { sx, sy } => DAffine2::from_scale(DVec2::new(sx, sy)),
            TransformListToken::Rotate { angle } => rotation(angle),
            TransformListToken::SkewX { angle } => {
                DAffine2::from_cols_array(&[1.0, 0.0, libm::tan(angle.to_radians()), 1.0, 0.0, 0.0])
            }
            TransformListToken::SkewY { angle } => {
                DAffine2::from_cols_array(&[1.0, libm::tan(angle.to_radians()), 0.0, 1.0, 0.0, 0.0])
            }
        };
    }
    Ok(product)
}

/// A rotation by degrees, exact for right angles.
fn rotation(degrees: f64) -> DAffine2 {
    let turned = degrees.rem_euclid(360.0);
    let (sin, cos) = if turned == 0.0 {
        (0.0, 1.0)
    } else if turned == 90.0 {
        (1.0, 0.0)
    } else if turned == 180.0 {
        (0.0, -1.0)
    } else if turned == 270.0 {
        (-1.0, 0.0)
    } else {
        libm::sincos(degrees.to_radians())
    };
    DAffine2::from_cols_array(&[cos, sin, -sin, cos, 0.0, 0.0])
}

/// A `transform-origin`, in a drawing of a size.
pub(super) fn origin(text: &str, drawing: Option<DVec2>) -> Result<DVec2, String> {
    let bad = || {
        let text = quoted(text);
        format!("transform-origin={text} depends on something else; give two numbers")
    };
    let origin: TransformOrigin = text.parse().map_err(|_| bad())?;
    let x = in_px(origin.x_offset, drawing.map(|size| size.x)).ok_or_else(bad)?;
    let y = in_px(origin.y_offset, drawing.map(|size| size.y)).ok_or_else(bad)?;
    Ok(DVec2::new(x, y))
}

/// A length in user units; `None` if it is a share of a whole that has no length, or of a font.
pub(super) fn in_px(length: Length, whole: Option<f64>) -> Option<f64> {
    let unit = match length.unit {
        LengthUnit::None | LengthUnit::Px => 1.0,
        LengthUnit::In => 96.0,
        LengthUnit::Cm => 96.0 / 2.54,
        LengthUnit::Mm => 96.0 / 25.4,
        LengthUnit::Pt => 96.0 / 72.0,
        LengthUnit::Pc => 16.0,
        LengthUnit::Percent => whole? / 100.0,
        LengthUnit::Em | LengthUnit::Ex => return None,
    };
    Some(length.number * unit)
}

/// From the coordinates of a view box to those of a box of a size at the origin.
pub(super) fn fitted(view: ViewBox, ratio: AspectRatio, size: DVec2) -> DAffine2 {
    let own = DVec2::new(view.w, view.h);
    let scale = size / own;
    let (share, scale) = match ratio.align {
        Align::None => (DVec2::ZERO, scale),
        align => {
            use Align::{
                XMaxYMax, XMaxYMid, XMaxYMin, XMidYMax, XMidYMin, XMinYMax, XMinYMid, XMinYMin,
            };
            let x = match align {
                XMinYMin | XMinYMid | XMinYMax => 0.0,
                XMaxYMin | XMaxYMid | XMaxYMax => 1.0,
                _ => 0.5,
            };
            let y = match align {
                XMinYMin | XMidYMin | XMaxYMin => 0.0,
                XMinYMax | XMidYMax | XMaxYMax => 1.0,
                _ => 0.5,
            };
            let scale = if ratio.slice { scale.max_element() } else { scale.min_element() };
            (DVec2::new(x, y), DVec2::splat(scale))
        }
    };
    let moved = (size - own * scale) * share;
    DAffine2::from_translation(moved)
        * DAffine2::from_scale(scale)
        * DAffine2::from_translation(-DVec2::new(view.x, view.y))
}
