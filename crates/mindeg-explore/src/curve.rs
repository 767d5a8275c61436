//! What every degree brings.

use mindeg::exact::TradeOff;
use mindeg_answers::words;

use crate::api::{CurvePoint, CurveShown};

/// The curve of a domain; `delaunay_max_degree` is the maximum degree of a Delaunay triangulation.
pub(crate) fn shown(trade_off: &TradeOff, delaunay_max_degree: Option<u32>) -> CurveShown {
    let point = |exact: &mindeg::exact::ExactMesh| CurvePoint {
        max_degree: exact.max_degree,
        min_angle: exact.min_angle,
        share: trade_off.share(exact).min(1.0),
    };
    let points: Vec<CurvePoint> = trade_off.meshes().iter().map(point).collect();
    let place = |point: &CurvePoint| (f64::from(point.max_degree), point.min_angle);
    CurveShown {
        knee: words::knee(&points.iter().map(place).collect::<Vec<_>>()),
        is_exact: trade_off.is_exact(),
        delaunay_min_angle: trade_off.delaunay_min_angle(),
        delaunay_max_degree,
        words: words::trade_off(trade_off, delaunay_max_degree),
        points,
    }
}
