//! The tables of a report, ready to be written in any format.
//!
//! A mesh that several methods have appears once. The numbers of a column
//! share their decimals.
//!
//! Limits: where a method has very many different degrees, high ones are put together in
//! ranges; the JSON has each.

use super::Report;
use super::titles::{Named, named};
use crate::advised::advised;
use crate::figures::{DefectKind, MethodFigures};
use crate::{InteriorFigures, Method};
use mindeg::quality::Distribution;
use mindeg_answers::advice::Purpose;
use mindeg_answers::measures::SHOWN;
use mindeg_answers::numbers::{Column, count, milliseconds, number, percent, steady_angle};
use std::ops::RangeInclusive;

/// Text in rows and columns; the first column names the row.
pub(crate) struct Table {
    pub(crate) title: String,
    /// A note on how to read the table; may be empty.
    pub(crate) note: String,
    pub(crate) columns: Vec<String>,
    pub(crate) rows: Vec<Vec<String>>,
}

/// More different degrees than these are put together in ranges.
const MAX_DEGREE_ROWS: usize = 16;

/// Significant digits of the number nearest to zero in a column.
const DIGITS: i32 = 3;

const NOTHING: &str = "–";

/// The figures that decide: a column each for the advised meshes, the mesh of least degree and Delaunay's.
pub(crate) fn choice(report: &Report) -> Table {
    let advised = advised(report).into_iter().map(|(purpose, method)| (Some(purpose), method));
    let others = [Method::LeastDegree, Method::DELAUNAY].map(|method| (None, method));
    let mut columns: Vec<(String, &MethodFigures)> = Vec::new();
    for (purpose, method) in advised.chain(others) {
        let found = report.methods.iter().find(|figures| figures.method == method);
        let Some(figures) = found.filter(|figures| figures.max_degree.is_some()) else { continue };
        if columns.iter().any(|(_, other)| other.method == figures.method) {
            continue;
        }
        let title = match (purpose, figures.method) {
            (Some(Purpose::Solver), _) => "Points inside (for a solver)".to_owned(),
            (Some(Purpose::Patch), _) => {
                format!("Degree {} (for a patch)", count(figures.max_degree.unwrap_or(0)))
            }
            (Some(Purpose::Fewest), Method::Fewest) => "Fewest edges".to_owned(),
            (_, Method::DELAUNAY) => "Delaunay".to_owned(),
            _ => "Least degree".to_owned(),
        };
        columns.push((title, figures));
    }
    decisive("The choice", &columns)
}

/// The figures that decide, a column for each mesh under its title.
pub(crate) fn decisive(title: &str, columns: &[(String, &MethodFigures)]) -> Table {
    let row = |title: &str, of: &dyn Fn(&MethodFigures) -> String| {
        let cells = columns.iter().map(|(_, figures)| of(figures));
        [title.to_owned()].into_iter().chain(cells).collect()
    };
    let median = |figures: &MethodFigures| figures.spread("min_angle").map(|spread| spread.median);
    let angle = |value: Option<f64>| text(value, steady_angle);
    let below = |figures: &MethodFigures, angle| {
        text(figures.share_below_degrees.get(&angle).copied(), percent)
    };
    Table {
        title: title.to_owned(),
        note: String::new(),
        rows: vec![
            row("Maximum degree", &|figures| text(figures.max_degree, count)),
            row("Minimum angle", &|figures| angle(figures.min_angle)),
            row("Median minimum angle", &|figures| angle(median(figures))),
            row("Triangles below 5°", &|figures| below(figures, 5)),
            row("Triangles below 15°", &|figures| below(figures, 15)),
        ],
        columns: header("Figure", columns.iter().map(|(title, _)| title)),
    }
}

/// The figures that matter most, a row for each mesh.
pub(crate) fn overview(report: &Report) -> Table {
    let optimum = report.domain.at_least;
    let named = named(report);
    let row = |Named { name, figures, .. }: &Named| {
        let has_mesh = figures.max_degree.is_some();
        let busier: u64 = figures.vertices_above_least.values().sum();
        vec![
            name.clone(),
            text(figures.max_degree, count),
            text(has_mesh.then_some(busier), count),
            text(figures.min_angle, steady_angle),
            text(figures.max_angle, steady_angle),
            text(figures.seconds, milliseconds),
            check(figures).to_owned(),
        ]
    };
    Table {
        title: "Overview".to_owned(),
        note: String::new(),
        columns: [
            "Mesh".to_owned(),
            "Maximum degree".to_owned(),
            format!("Vertices above {}", count(optimum)),
            "Minimum angle".to_owned(),
            "Maximum angle".to_owned(),
            "Time".to_owned(),
            "Check".to_owned(),
        ]
        .into(),
        rows: named.iter().map(row).collect(),
    }
}

/// Meshes with interior points, a row for each; empty unless asked for.
pub(crate) fn interior(report: &Report) -> Option<Table> {
    let all = &report.interior;
    let row = |figures: &InteriorFigures| {
        let degree = |degree: Option<u32>| text(degree, count);
        let mesh = match &figures.failure {
            Some(failure) => format!("{}: no mesh, {failure}", figures.method),
            None => figures.method.clone(),
        };
        vec![
            mesh,
            text(figures.triangles, |triangles| count(triangles as u64)),
            text(figures.min_angle, steady_angle),
            text(figures.share_of_limit, percent),
            text(figures.max_angle, steady_angle),
            degree(figures.max_interior_degree),
            degree(figures.max_boundary_degree),
            text(figures.violations, |violations| count(violations as u64)),
            text(figures.grading_p99, number),
            text(figures.seconds, milliseconds),
        ]
    };
    (!all.is_empty()).then(|| Table {
        title: "With interior points".to_owned(),
        note: "The same boundary, to which points inside are added. The share is that of the \
               greatest minimum angle that any such mesh can have with at most 5 edges at a boundary \
               vertex. Violations: interior vertices with other degrees than 5 to 7, boundary \
               vertices with more than 5. Grading: the square root of the area ratio of \
               neighbours, 99th percentile."
            .to_owned(),
        columns: [
            "Method",
            "Triangles",
            "Minimum angle",
            "Share of the limit",
            "Maximum angle",
            "Maximum degree inside",
            "At the boundary",
            "Violations",
            "Grading",
            "Time",
        ]
        .map(str::to_owned)
        .into(),
        rows: all.iter().map(row).collect(),
    })
}

/// The sides of the domain: names, intervals, lengths.
pub(crate) fn sides(report: &Report) -> Table {
    let domain = &report.domain;
    let column = Column::new(domain.side_lengths.iter().copied(), DIGITS);
    let rows = domain.intervals.iter().zip(&domain.side_lengths).enumerate().take(MAX_SIDE_ROWS);
    let rows = rows.map(|(side, (&intervals, &length))| {
        let name = domain.side_names.get(side).cloned().flatten();
        vec![
            (side + 1).to_string(),
            name.unwrap_or_else(|| NOTHING.to_owned()),
            count(intervals),
            column.number(length),
        ]
    });
    let note = match domain.intervals.len() {
        sides if sides > MAX_SIDE_ROWS => format!("The first {MAX_SIDE_ROWS} of {sides} sides."),
        _ => String::new(),
    };
    Table {
        title: "Sides".to_owned(),
        note,
        columns: ["Side", "Name", "Intervals", "Length"].map(str::to_owned).into(),
        rows: rows.collect(),
    }
}

/// More sides than these are not listed.
const MAX_SIDE_ROWS: usize = 50;

/// The outcome of a method, in a word or two.
fn check(method: &MethodFigures) -> &'static str {
    let is_late = method.defects.iter().any(|defect| defect.kind == DefectKind::TimeLimit);
    match (method.valid, method.max_degree) {
        (true, _) => "valid",
        (false, Some(_)) => "not valid",
        (false, None) if is_late => "past the time limit",
        (false, None) => "not possible",
    }
}

/// How many vertices have each degree, a column for each mesh.
pub(crate) fn degrees(report: &Report) -> Table {
    let named = named(report);
    let meshes: Vec<&Named> = with_triangles(&named).collect();
    let row = |range: RangeInclusive<u32>| {
        let counts = meshes.iter().map(|mesh| match vertices_in(mesh.figures, &range) {
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
            count(report.domain.at_least)
        ),
        columns: header("Degree", meshes.iter().map(|mesh| &mesh.name)),
        rows: degree_ranges(&named).into_iter().map(row).collect(),
    }
}

/// The share of triangles with small angles.
pub(crate) fn shares(report: &Report) -> Table {
    let named = named(report);
    let meshes: Vec<&Named> = with_triangles(&named).collect();
    let angles = meshes.first().map(|mesh| mesh.figures.share_below_degrees.keys());
    let row = |below: &u32| {
        let share = |mesh: &Named| mesh.figures.share_below_degrees.get(below).copied();
        let shares = meshes.iter().map(|&mesh| text(share(mesh), percent));
        [format!("below {below}°")].into_iter().chain(shares).collect()
    };
    Table {
        title: "Triangles with small angles".to_owned(),
        note: "The share of triangles whose minimum angle is below a bound.".to_owned(),
        columns: header("Minimum angle", meshes.iter().map(|mesh| &mesh.name)),
        rows: angles.into_iter().flatten().map(row).collect(),
    }
}

/// How each measure is spread, a table for each.
pub(crate) fn metrics(report: &Report) -> Vec<Table> {
    let meshes = named(report);
    let tables = SHOWN.iter().map(|shown| {
        let spreads: Vec<(&str, [f64; 6])> = meshes
            .iter()
            .filter_map(|mesh| {
                let Distribution { min, p01, median, mean, p99, max } =
                    *mesh.figures.spread(shown.name)?;
                Some((mesh.name.as_str(), [min, p01, median, mean, p99, max]))
            })
            .collect();
        let columns: [Column; 6] = std::array::from_fn(|column| {
            Column::new(spreads.iter().map(|(_, values)| values[column]), DIGITS)
        });
        let row = |(name, values): &(&str, [f64; 6])| {
            let numbers = columns.iter().zip(values).map(|(column, &value)| column.number(value));
            [(*name).to_owned()].into_iter().chain(numbers).collect()
        };
        Table {
            title: shown.title_with_unit(),
            note: shown.explanation(),
            columns: ["Method", "min", "1%", "median", "mean", "99%", "max"]
                .map(str::to_owned)
                .into(),
            rows: spreads.iter().map(row).collect(),
        }
    });
    tables.collect()
}

/// The worst triangles, a table for each mesh.
pub(crate) fn worst(meshes: &[Named]) -> Vec<Table> {
    let tables = with_triangles(meshes).map(|mesh| {
        let worst = &mesh.figures.worst_triangles;
        let row = |triangle: &mindeg_answers::inspected::ThinTriangle| {
            let [a, b, c] = triangle.vertices;
            vec![
                triangle.triangle.to_string(),
                format!("{a}, {b}, {c}"),
                steady_angle(triangle.min_angle),
                steady_angle(triangle.max_angle),
            ]
        };
        Table {
            title: format!("Worst triangles: {}", mesh.name),
            note: String::new(),
            columns: ["Triangle", "Vertices", "Minimum angle", "Maximum angle"]
                .map(str::to_owned)
                .into(),
            rows: worst.iter().map(row).collect(),
        }
    });
    tables.collect()
}

/// The degrees that occur, each on its own, or high ones in ranges that double in length.
pub(crate) fn degree_ranges<'a, 'b: 'a>(
    meshes: impl IntoIterator<Item = &'a Named<'b>>,
) -> Vec<RangeInclusive<u32>> {
    let degrees = meshes.into_iter().flat_map(|mesh| mesh.figures.degree_histogram.keys().copied());
    let mut degrees: Vec<u32> = degrees.collect();
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

fn with_triangles<'a, 'b>(meshes: &'a [Named<'b>]) -> impl Iterator<Item = &'a Named<'b>> {
    meshes.iter().filter(|mesh| mesh.figures.max_degree.is_some())
}

fn header<'a>(first: &str, others: impl Iterator<Item = &'a String>) -> Vec<String> {
    [first.to_owned()].into_iter().chain(others.cloned()).collect()
}

fn text<T>(value: Option<T>, write: impl FnOnce(T) -> String) -> String {
    value.map_or_else(|| NOTHING.to_owned(), write)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figures::DomainFigures;
    use crate::report::Provenance;

    fn report(degrees: &[u32]) -> Report {
        let domain = DomainFigures {
            name: None,
            intervals: vec![],
            side_lengths: vec![],
            side_names: vec![],
            corners: vec![],
            vertices: 0,
            triangles: 0,
            interior_edges: 0,
            at_least: 4,
            holes: 0,
            regions: None,
            least_max_degree: Some(4),
        };
        let method = MethodFigures {
            degree_histogram: degrees.iter().map(|&degree| (degree, 1)).collect(),
            ..MethodFigures::default()
        };
        Report {
            provenance: Provenance::default(),
            domain,
            purpose: None,
            advice: mindeg_answers::advice::Advice::UNMEASURED,
            methods: vec![method],
            trade_off: None,
            interior: Vec::new(),
            verdict: String::new(),
        }
    }

    #[test]
    fn many_different_degrees_are_put_together() {
        let some: Vec<u32> = (2..17).chain([999]).collect();
        let singles: Vec<_> = some.iter().map(|&degree| degree..=degree).collect();
        assert_eq!(degree_ranges(&named(&report(&some))), singles);

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
        assert_eq!(degree_ranges(&named(&report)), expected);
        let counts = expected.map(|range| vertices_in(&report.methods[0], &range));
        assert_eq!(counts, [1, 1, 1, 1, 1, 1, 8, 3, 1, 1, 1]);
    }
}
