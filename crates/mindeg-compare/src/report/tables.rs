//! The tables of a report, ready to be written in any format.
//!
//! Limits: where a method has very many different degrees, high ones are put together in
//! ranges; the JSON has each.

use super::metric::SHOWN;
use super::{DefectKind, MethodFigures, Report};
use crate::number_format::{angle, count, percent, seconds, significant};
use std::ops::RangeInclusive;

/// Text in rows and columns; the first column names the row.
pub(crate) struct Table {
    pub(crate) title: String,
    /// What to know in order to read it; may be empty.
    pub(crate) note: String,
    pub(crate) columns: Vec<String>,
    pub(crate) rows: Vec<Vec<String>>,
}

/// More different degrees than these are put together in ranges.
const MAX_DEGREE_ROWS: usize = 16;

const NOTHING: &str = "–";

/// The figures that matter most, a row for each method.
pub(crate) fn overview(report: &Report) -> Table {
    let optimum = report.domain.optimal_max_degree;
    let row = |method: &MethodFigures| {
        let has_mesh = method.max_degree.is_some();
        let busier: u64 = method.vertices_above_optimum.values().sum();
        vec![
            method.method.to_string(),
            text(method.max_degree, count),
            text(has_mesh.then_some(busier), count),
            text(method.min_angle, angle),
            text(method.max_angle, angle),
            text(method.seconds, seconds),
            check(method).to_owned(),
        ]
    };
    Table {
        title: "Overview".to_owned(),
        note: String::new(),
        columns: [
            "Method".to_owned(),
            "Maximum degree".to_owned(),
            format!("Vertices above {}", count(optimum)),
            "Smallest angle".to_owned(),
            "Largest angle".to_owned(),
            "Time".to_owned(),
            "Check".to_owned(),
        ]
        .into(),
        rows: report.methods.iter().map(row).collect(),
    }
}

/// What came of a method, in a word or two.
fn check(method: &MethodFigures) -> &'static str {
    let is_late = method.defects.iter().any(|defect| defect.kind == DefectKind::TimeLimit);
    match (method.valid, method.max_degree) {
        (true, _) => "valid",
        (false, Some(_)) => "not valid",
        (false, None) if is_late => "past the time limit",
        (false, None) => "not possible",
    }
}

/// How many vertices have each degree, a column for each method.
pub(crate) fn degrees(report: &Report) -> Table {
    let methods = with_triangles(report);
    let row = |range: RangeInclusive<u32>| {
        let counts = methods.iter().map(|method| match vertices_in(method, &range) {
            0 => NOTHING.to_owned(),
            vertices => count(vertices),
        });
        [degree_name(&range)].into_iter().chain(counts).collect()
    };
    Table {
        title: "Vertices of each degree".to_owned(),
        note: format!(
            "Degree is the number of edges at a vertex (valence in graphics). Every triangulation \
             of this domain has a vertex of degree {} or more.",
            count(report.domain.optimal_max_degree)
        ),
        columns: header("Degree", &methods),
        rows: degree_ranges(report).into_iter().map(row).collect(),
    }
}

/// The share of triangles with small angles.
pub(crate) fn shares(report: &Report) -> Table {
    let methods = with_triangles(report);
    let angles = methods.first().map(|method| method.share_below_degrees.keys());
    let row = |&below: &u32| {
        let shares = methods.iter().map(|method| percent(method.share_below_degrees[&below]));
        [format!("below {below}°")].into_iter().chain(shares).collect()
    };
    Table {
        title: "Triangles with small angles".to_owned(),
        note: "The share of triangles whose smallest angle is below a bound.".to_owned(),
        columns: header("Smallest angle", &methods),
        rows: angles.into_iter().flatten().map(row).collect(),
    }
}

/// How each measure is spread, a table for each.
pub(crate) fn metrics(report: &Report) -> Vec<Table> {
    let tables = SHOWN.iter().map(|shown| {
        let rows = report.methods.iter().filter_map(|method| {
            let spread = (shown.of)(method.metrics.as_ref()?);
            let values =
                [spread.min, spread.p01, spread.median, spread.mean, spread.p99, spread.max];
            let values = values.map(|value| significant(value, 4));
            Some([method.method.to_string()].into_iter().chain(values).collect())
        });
        Table {
            title: shown.title_with_unit(),
            note: shown.explanation(),
            columns: ["Method", "min", "1%", "median", "mean", "99%", "max"]
                .map(str::to_owned)
                .into(),
            rows: rows.collect(),
        }
    });
    tables.collect()
}

/// The worst triangles, a table for each method.
pub(crate) fn worst(report: &Report) -> Vec<Table> {
    let tables = with_triangles(report).into_iter().map(|method| Table {
        title: format!("Worst triangles: {}", method.method),
        note: String::new(),
        columns: ["Triangle", "Vertices", "Smallest angle", "Largest angle"]
            .map(str::to_owned)
            .into(),
        rows: method
            .worst_triangles
            .iter()
            .map(|worst| {
                let [a, b, c] = worst.vertices;
                vec![
                    worst.triangle.to_string(),
                    format!("{a}, {b}, {c}"),
                    angle(worst.min_angle),
                    angle(worst.max_angle),
                ]
            })
            .collect(),
    });
    tables.collect()
}

/// The degrees that occur, each on its own, or high ones in ranges that double in length.
pub(crate) fn degree_ranges(report: &Report) -> Vec<RangeInclusive<u32>> {
    let mut degrees: Vec<u32> =
        report.methods.iter().flat_map(|method| method.degree_histogram.keys().copied()).collect();
    degrees.sort_unstable();
    degrees.dedup();
    if degrees.len() <= MAX_DEGREE_ROWS {
        return degrees.into_iter().map(|degree| degree..=degree).collect();
    }
    let mut ranges = Vec::new();
    let mut start = 2_u64;
    let mut length = 1_u64;
    while let Some(&next) = degrees.iter().find(|&&degree| u64::from(degree) >= start) {
        // Single degrees up to 8, then 9–16, 17–32 and so on; empty ranges are left out.
        let end = start + length - 1;
        if u64::from(next) <= end {
            ranges.push(start as u32..=end.min(u64::from(u32::MAX)) as u32);
        }
        start = end + 1;
        if start > 8 {
            length = start - 1;
        }
    }
    ranges
}

/// A range of degrees as a row names it.
pub(crate) fn degree_name(degrees: &RangeInclusive<u32>) -> String {
    let (low, high) = (*degrees.start(), *degrees.end());
    if low == high { count(low) } else { format!("{} to {}", count(low), count(high)) }
}

/// How many vertices of a method have a degree in a range.
pub(crate) fn vertices_in(method: &MethodFigures, degrees: &RangeInclusive<u32>) -> u64 {
    method.degree_histogram.range(degrees.clone()).map(|(_, &vertices)| vertices).sum()
}

fn with_triangles(report: &Report) -> Vec<&MethodFigures> {
    report.methods.iter().filter(|method| method.max_degree.is_some()).collect()
}

fn header(first: &str, methods: &[&MethodFigures]) -> Vec<String> {
    [first.to_owned()]
        .into_iter()
        .chain(methods.iter().map(|method| method.method.to_string()))
        .collect()
}

fn text<T>(value: Option<T>, write: impl FnOnce(T) -> String) -> String {
    value.map_or_else(|| NOTHING.to_owned(), write)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::DomainFigures;

    fn report(degrees: &[u32]) -> Report {
        let domain = DomainFigures {
            name: None,
            intervals: vec![],
            corners: vec![],
            vertices: 0,
            triangles: 0,
            interior_edges: 0,
            optimal_max_degree: 4,
        };
        let method = MethodFigures {
            degree_histogram: degrees.iter().map(|&degree| (degree, 1)).collect(),
            ..MethodFigures::default()
        };
        Report { domain, methods: vec![method], trade_off: None, verdict: String::new() }
    }

    #[test]
    fn many_different_degrees_are_put_together() {
        let some: Vec<u32> = (2..17).chain([999]).collect();
        let singles: Vec<_> = some.iter().map(|&degree| degree..=degree).collect();
        assert_eq!(degree_ranges(&report(&some)), singles);

        let many: Vec<u32> = (3..20).chain([64, 65, u32::MAX]).collect();
        let expected = [
            3..=3,
            4..=4,
            5..=5,
            6..=6,
            7..=7,
            8..=8,
            9..=16,
            17..=32,
            33..=64,
            65..=128,
            2_147_483_649..=u32::MAX,
        ];
        let report = report(&many);
        assert_eq!(degree_ranges(&report), expected);
        let counts = expected.map(|range| vertices_in(&report.methods[0], &range));
        assert_eq!(counts, [1, 1, 1, 1, 1, 1, 8, 3, 1, 1, 1]);
    }
}
