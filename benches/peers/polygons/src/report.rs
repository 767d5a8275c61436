//! The worth of the programs' triangles, and the tables.

use crate::input::{Input, turn};
use crate::peers::{PEERS, Triangles};
use mindeg_exact::measure::min_angle_tangent;
use mindeg_mesh::check;
use std::collections::BTreeMap;
use std::fmt::Write;
use std::time::Duration;

/// The outcome of one program on one input.
#[derive(Debug)]
pub(crate) enum Answer {
    /// A triangulation of the rings with all their points.
    Valid { max_degree: u32, min_tangent: f64, time: Duration },
    /// Triangles that are none, and why.
    Invalid(String),
    /// No triangles, and why.
    None(String),
}

/// Place of `Delaunay` in [`PEERS`].
const DELAUNAY: usize = 2;

/// Whether the triangles triangulate the rings, whichever way round each is: programs for pictures
/// have the y axis down.
pub(crate) fn judged(input: &Input, triangles: Triangles, time: Duration) -> Answer {
    let mut triangles = match triangles {
        Ok(triangles) => triangles,
        Err(error) => return Answer::None(error.to_string()),
    };
    let exists = |vertex: &u32| (*vertex as usize) < input.points.len();
    let given = triangles.len();
    triangles.retain(|triangle| triangle.iter().all(exists));
    if triangles.len() < given {
        return Answer::Invalid(format!("{} with a lost point", given - triangles.len()));
    }
    let corners = |triangle: &[u32; 3]| triangle.map(|vertex| input.points[vertex as usize]);
    triangles.retain_mut(|triangle| {
        let [a, b, c] = corners(triangle);
        let turn = turn(a, b, c);
        if turn < 0.0 {
            triangle.swap(1, 2);
        }
        turn != 0.0
    });
    let flat = given - triangles.len();
    let boundary = match input.boundary() {
        Ok(boundary) => boundary,
        Err(faults) => return Answer::Invalid(faults.to_string()),
    };
    match check::triangulation(&boundary, &[], &triangles) {
        Ok(checked) => {
            let tangents = triangles.iter().map(|triangle| min_angle_tangent(corners(triangle)));
            let min_tangent = tangents.fold(f64::INFINITY, f64::min);
            Answer::Valid { max_degree: checked.max_degree, min_tangent, time }
        }
        Err(_) if triangles.len() < input.triangle_count() => {
            let missing = input.triangle_count() - triangles.len();
            let flat = if flat > 0 { format!(", {flat} flat") } else { String::new() };
            Answer::Invalid(format!("{missing} missing{flat}"))
        }
        Err(error) => Answer::Invalid(error.to_string()),
    }
}

/// The degrees of all programs, for those who watch.
pub(crate) fn line(answers: &[Answer]) -> String {
    let words = answers.iter().zip(&PEERS).map(|(answer, peer)| match answer {
        Answer::Valid { max_degree, time, .. } => {
            format!("{} {max_degree} in {:.3} s", peer.name, time.as_secs_f64())
        }
        Answer::Invalid(why) | Answer::None(why) => format!("{} ({why})", peer.name),
    });
    words.collect::<Vec<_>>().join("; ")
}

/// The tables, a row for each polygon and one for all icons.
pub(crate) fn tables(
    shapes: &[Input],
    of_shapes: &[Vec<Answer>],
    icons: &[Input],
    of_icons: &[Vec<Answer>],
) -> String {
    let mut text = String::new();
    let mut table =
        |title: &str, cell: &dyn Fn(&Answer, &Answer) -> String, all: &dyn Fn(usize) -> String| {
            let names: Vec<&str> = PEERS.iter().map(|peer| peer.name).collect();
            _ = writeln!(text, "#### {title}\n\n| | points | {} |", names.join(" | "));
            _ = writeln!(text, "|---|--:|{}", "--:|".repeat(PEERS.len()));
            for (input, answers) in shapes.iter().zip(of_shapes) {
                let cells = answers.iter().map(|answer| cell(answer, &answers[DELAUNAY]));
                let cells: Vec<String> = cells.collect();
                _ = writeln!(
                    text,
                    "| {} | {} | {} |",
                    input.name,
                    input.points.len(),
                    cells.join(" | ")
                );
            }
            if !icons.is_empty() {
                let points: usize = icons.iter().map(|icon| icon.points.len()).sum();
                let cells: Vec<String> = (0..PEERS.len()).map(all).collect();
                _ = writeln!(text, "| {} icons | {points} | {} |", icons.len(), cells.join(" | "));
            }
            text.push('\n');
        };
    let column = |at: usize| of_icons.iter().map(move |answers| (&answers[at], &answers[DELAUNAY]));
    table("Largest degree", &degree, &|at| {
        let degrees = column(at).filter_map(|(answer, _)| match answer {
            Answer::Valid { max_degree, .. } => Some(f64::from(*max_degree)),
            _ => None,
        });
        let degrees: Vec<f64> = degrees.collect();
        let mean = degrees.iter().sum::<f64>() / degrees.len() as f64;
        match of_icons.len() - degrees.len() {
            0 => format!("{mean:.2}"),
            failed => format!("{mean:.2}, {failed} not valid"),
        }
    });
    table("Minimum angle, as a share of Delaunay's", &share, &|at| {
        let mut shares: Vec<f64> = column(at).filter_map(|(a, b)| angle_share(a, b)).collect();
        shares.sort_by(f64::total_cmp);
        shares.get(shares.len() / 2).map_or("–".to_owned(), |&median| percent(median))
    });
    table("Times as long as Delaunay, whose own time is in ms", &multiple, &|at| {
        let [own, delaunay] = [at, DELAUNAY].map(|at| column(at).map(|(it, _)| time(it)).sum());
        times_as_long(own, delaunay, at == DELAUNAY)
    });
    let mut reasons = BTreeMap::<&str, Vec<String>>::new();
    for (input, answers) in shapes.iter().zip(of_shapes).chain(icons.iter().zip(of_icons)) {
        for (answer, peer) in answers.iter().zip(&PEERS) {
            if let Answer::Invalid(why) = answer {
                reasons.entry(peer.name).or_default().push(format!("{}: {why}", input.name));
            }
        }
    }
    text += "Not valid:\n\n";
    for (name, reasons) in &reasons {
        _ = writeln!(text, "- {name}: {}", reasons.join("; "));
    }
    text += "\n| program | called |\n|---|---|\n";
    for peer in &PEERS {
        _ = writeln!(text, "| {} | {} |", peer.name, peer.called);
    }
    text
}

fn degree(answer: &Answer, _: &Answer) -> String {
    match answer {
        Answer::Valid { max_degree, .. } => max_degree.to_string(),
        Answer::Invalid(_) => "not valid".to_owned(),
        Answer::None(_) => "–".to_owned(),
    }
}

fn angle_share(answer: &Answer, delaunay: &Answer) -> Option<f64> {
    match (answer, delaunay) {
        (Answer::Valid { min_tangent, .. }, Answer::Valid { min_tangent: best, .. }) => {
            Some(min_tangent / best)
        }
        _ => None,
    }
}

fn share(answer: &Answer, delaunay: &Answer) -> String {
    angle_share(answer, delaunay).map_or("–".to_owned(), percent)
}

fn percent(share: f64) -> String {
    match 100.0 * share {
        percent if percent >= 9.95 => format!("{percent:.0} %"),
        percent => format!("{percent:.1} %"),
    }
}

fn time(answer: &Answer) -> Duration {
    if let Answer::Valid { time, .. } = answer { *time } else { Duration::ZERO }
}

fn multiple(answer: &Answer, delaunay: &Answer) -> String {
    times_as_long(time(answer), time(delaunay), std::ptr::eq(answer, delaunay))
}

fn times_as_long(own: Duration, delaunay: Duration, is_delaunay: bool) -> String {
    if own.is_zero() {
        return "–".to_owned();
    }
    let ratio = own.as_secs_f64() / delaunay.as_secs_f64();
    match if is_delaunay { 1000.0 * own.as_secs_f64() } else { ratio } {
        value if is_delaunay => format!("{value:.2} ms"),
        value if value < 9.95 => format!("{value:.1}"),
        value => format!("{value:.0}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec2;

    #[test]
    fn triangles_that_are_no_triangulation_are_named() {
        // A square with a point in the middle of its bottom.
        let points = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];
        let input = Input {
            name: String::new(),
            points: points.map(DVec2::from).to_vec(),
            rings: std::iter::once(0..5).collect(),
            side_of: vec![0, 0, 1, 2, 3],
            in_holes: Vec::new(),
        };
        for (triangles, expected) in [
            (&[[0, 1, 4], [1, 3, 4], [1, 2, 3]][..], "4"),
            // Clockwise.
            (&[[0, 4, 1], [4, 3, 1], [1, 3, 2]], "4"),
            (&[[0, 1, 4], [1, 3, 4], [1, 2, 3], [0, 2, 1]], "4"),
            (&[[0, 1, 2], [0, 2, 3], [0, 3, 4]], "1 missing, 1 flat"),
            (&[[0, 1, 4], [1, 3, 4], [1, 2, u32::MAX]], "1 with a lost point"),
            (&[[0, 1, 4], [1, 2, 4], [1, 2, 3]], "two triangles lie on the same side of edge 1-2"),
        ] {
            let text = match judged(&input, Ok(triangles.to_vec()), Duration::ZERO) {
                Answer::Valid { max_degree, .. } => max_degree.to_string(),
                Answer::Invalid(why) | Answer::None(why) => why,
            };
            assert!(text.starts_with(expected), "{triangles:?}: {text}");
        }
        assert!(matches!(judged(&input, Err("no".into()), Duration::ZERO), Answer::None(_)));
    }
}
