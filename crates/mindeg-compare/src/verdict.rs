//! What the figures say, in sentences.
//!
//! Every sentence is a consequence of the figures, and the one that speaks against mindeg comes
//! first where there is one.
//!
//! Limits: it speaks of the maximum degree and the smallest angle alone. Whether degree or
//! angle matters more is the reader's to know.

use crate::Method;
use crate::number_format::{angle, count, significant};
use crate::report::{DomainFigures, MethodFigures};

/// Angles closer than this, relatively, are the same: a smallest angle of a millionth of a
/// degree, rounded in f64, is known to about eight digits.
const SAME: f64 = 1e-8;

/// A smallest angle, in degrees, below which meshers commonly ask for better.
const GOOD_ANGLE: f64 = 20.0;

/// The verdict, sentence by sentence; the first can stand alone.
pub(crate) fn verdict(domain: &DomainFigures, methods: &[MethodFigures]) -> Vec<String> {
    let find = |wanted| methods.iter().find(|method| method.method == wanted);
    let Some(mindeg) = find(Method::LeastDegree) else { return Vec::new() };
    let mut sentences = match find(Method::DELAUNAY) {
        Some(delaunay) => against_delaunay(domain, mindeg, delaunay),
        None => Vec::new(),
    };
    let others = methods
        .iter()
        .filter(|method| ![Method::LeastDegree, Method::DELAUNAY].contains(&method.method));
    sentences.extend(others.map(|method| in_short(domain, method)));
    sentences
}

fn against_delaunay(
    domain: &DomainFigures,
    mindeg: &MethodFigures,
    delaunay: &MethodFigures,
) -> Vec<String> {
    let Some((own_angle, own_degree)) = outcome(mindeg) else {
        return vec![format!("mindeg has no valid mesh here: {}.", reasons(mindeg))];
    };
    let Some((angle_there, degree_there)) = outcome(delaunay) else {
        return vec![format!(
            "There is no Delaunay triangulation to compare with: {}. mindeg has at most {} at a \
             vertex, the least possible, and a smallest angle of {}.",
            reasons(delaunay),
            edges(own_degree),
            angle(own_angle)
        )];
    };
    let difference = (angle_there - own_angle) / angle_there.max(own_angle);
    let same_angle = difference.abs() <= SAME;
    let same_degree = own_degree == degree_there;
    let mut sentences = Vec::new();
    if same_angle && same_degree {
        sentences.push(format!(
            "mindeg and Delaunay are level: both have at most {} at a vertex, the least \
             possible, and a smallest angle of {}.",
            edges(own_degree),
            angle(own_angle)
        ));
    } else {
        sentences.push(if same_angle {
            format!(
                "mindeg and Delaunay have the same smallest angle, {}: the lower degree costs no \
                 angle here.",
                angle(own_angle)
            )
        } else if difference > 0.0 {
            format!(
                "Delaunay has the larger smallest angle: {} against {} for mindeg, {}.",
                angle(angle_there),
                angle(own_angle),
                factor(angle_there / own_angle)
            )
        } else {
            format!(
                "Something is wrong: mindeg's smallest angle, {}, is larger than Delaunay's, {}, \
                 and no triangulation of the same points can have that. Please report this \
                 domain.",
                angle(own_angle),
                angle(angle_there)
            )
        });
        sentences.push(if same_degree {
            format!(
                "Degree does not speak for mindeg here: both have at most {} at a vertex, the \
                 least possible.",
                edges(own_degree)
            )
        } else {
            let busier: u64 = delaunay.vertices_above_optimum.values().sum();
            format!(
                "mindeg has the smaller maximum degree: at most {} at a vertex, the least \
                 possible, against {} in Delaunay, where {} of {} vertices {} more than {}.",
                edges(own_degree),
                count(degree_there),
                count(busier),
                count(domain.vertices),
                if busier == 1 { "has" } else { "have" },
                count(domain.optimal_max_degree)
            )
        });
    }
    if angle_there < GOOD_ANGLE {
        sentences.push(format!(
            "No triangulation of these boundary points alone has a smallest angle above {}; to \
             do better, change the intervals or add points inside.",
            angle(angle_there)
        ));
    }
    if let Some(ties) = delaunay.ties.filter(|&ties| ties > 0) {
        sentences.push(format!(
            "The Delaunay triangulation is one of several: across {} of its {} interior edge{} \
             four points lie on one circle and either diagonal will do, so its degrees are \
             arbitrary among ties; its smallest angle is not.",
            count(ties),
            count(domain.interior_edges),
            if domain.interior_edges == 1 { "" } else { "s" }
        ));
    }
    sentences
}

/// A method other than the two that matter.
fn in_short(domain: &DomainFigures, method: &MethodFigures) -> String {
    let name = method.method;
    let Some((smallest, degree)) = outcome(method) else {
        let gives = if method.max_degree.is_some() { "no valid triangulation" } else { "nothing" };
        return format!("{name} gives {gives} here: {}.", reasons(method));
    };
    let busier: u64 = method.vertices_above_optimum.values().sum();
    let busier = match busier {
        0 => "the least possible".to_owned(),
        1 => format!("1 vertex has more than {}", count(domain.optimal_max_degree)),
        _ => format!(
            "{} vertices have more than {}",
            count(busier),
            count(domain.optimal_max_degree)
        ),
    };
    format!(
        "{name}: at most {} at a vertex ({busier}), smallest angle {}.",
        edges(degree),
        angle(smallest)
    )
}

/// Smallest angle and maximum degree of a method that has a valid mesh.
fn outcome(method: &MethodFigures) -> Option<(f64, u32)> {
    method.min_angle.zip(method.max_degree).filter(|_| method.valid)
}

fn reasons(method: &MethodFigures) -> String {
    let messages: Vec<&str> = method.defects.iter().map(|defect| &*defect.message).collect();
    if messages.is_empty() { "no reason is known".into() } else { messages.join("; ") }
}

fn edges(degree: u32) -> String {
    format!("{} edges", count(degree))
}

/// How much larger something is that is `ratio` times another.
fn factor(ratio: f64) -> String {
    if ratio < 1.5 {
        format!("{}% larger", significant((ratio - 1.0) * 100.0, 2))
    } else {
        format!("{} times as large", significant(ratio, 2))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Reference;
    use crate::report::{DefectKind, MethodDefect};

    const FAN: Method = Method::Reference(Reference::Fan);

    fn domain() -> DomainFigures {
        DomainFigures {
            name: None,
            intervals: vec![10, 10, 10, 10],
            corners: vec![[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0]],
            vertices: 40,
            triangles: 38,
            interior_edges: 37,
            optimal_max_degree: 4,
        }
    }

    fn method(method: Method, degree: u32, smallest: f64) -> MethodFigures {
        MethodFigures {
            method,
            max_degree: Some(degree),
            vertices_above_optimum: (5..=degree).map(|degree| (degree, 1)).collect(),
            min_angle: Some(smallest),
            valid: true,
            ..MethodFigures::default()
        }
    }

    fn failed(method: Method, max_degree: Option<u32>, messages: &[&str]) -> MethodFigures {
        let defect = |message: &&str| MethodDefect {
            kind: DefectKind::NoTriangles,
            count: None,
            message: (*message).to_owned(),
        };
        MethodFigures {
            method,
            max_degree,
            min_angle: max_degree.map(|_| 0.0),
            defects: messages.iter().map(defect).collect(),
            ..MethodFigures::default()
        }
    }

    #[track_caller]
    fn check(methods: &[MethodFigures], expected: &[&str]) {
        assert_eq!(verdict(&domain(), methods), expected);
    }

    #[test]
    fn delaunay_comes_first_where_its_angle_is_larger() {
        for (own, there, first) in [
            (
                20.5,
                45.0,
                "Delaunay has the larger smallest angle: 45° against 20.5° for mindeg, 2.2 times as large.",
            ),
            (
                3.0,
                36.0,
                "Delaunay has the larger smallest angle: 36° against 3° for mindeg, 12 times as large.",
            ),
            (
                30.0,
                33.0,
                "Delaunay has the larger smallest angle: 33° against 30° for mindeg, 10% larger.",
            ),
            (
                30.0,
                30.0003,
                "Delaunay has the larger smallest angle: 30° against 30° for mindeg, 0.001% larger.",
            ),
        ] {
            check(
                &[method(Method::LeastDegree, 4, own), method(Method::DELAUNAY, 6, there)],
                &[
                    first,
                    "mindeg has the smaller maximum degree: at most 4 edges at a vertex, the least possible, against 6 in Delaunay, where 2 of 40 vertices have more than 4.",
                ],
            );
        }
        check(
            &[method(Method::LeastDegree, 4, 25.0), method(Method::DELAUNAY, 5, 30.0)],
            &[
                "Delaunay has the larger smallest angle: 30° against 25° for mindeg, 20% larger.",
                "mindeg has the smaller maximum degree: at most 4 edges at a vertex, the least possible, against 5 in Delaunay, where 1 of 40 vertices has more than 4.",
            ],
        );
    }

    #[test]
    fn says_so_when_mindeg_gains_nothing() {
        check(
            &[method(Method::LeastDegree, 4, 25.0), method(Method::DELAUNAY, 4, 30.0)],
            &[
                "Delaunay has the larger smallest angle: 30° against 25° for mindeg, 20% larger.",
                "Degree does not speak for mindeg here: both have at most 4 edges at a vertex, the least possible.",
            ],
        );
        check(
            &[method(Method::LeastDegree, 4, 30.0), method(Method::DELAUNAY, 4, 30.000_000_000_1)],
            &[
                "mindeg and Delaunay are level: both have at most 4 edges at a vertex, the least possible, and a smallest angle of 30°.",
            ],
        );
    }

    #[test]
    fn says_so_when_the_lower_degree_is_free() {
        check(
            &[method(Method::LeastDegree, 4, 30.0), method(Method::DELAUNAY, 5, 30.0)],
            &[
                "mindeg and Delaunay have the same smallest angle, 30°: the lower degree costs no angle here.",
                "mindeg has the smaller maximum degree: at most 4 edges at a vertex, the least possible, against 5 in Delaunay, where 1 of 40 vertices has more than 4.",
            ],
        );
    }

    #[test]
    fn an_angle_above_delaunays_is_reported_as_a_fault() {
        check(
            &[method(Method::LeastDegree, 4, 30.0), method(Method::DELAUNAY, 4, 29.0)],
            &[
                "Something is wrong: mindeg's smallest angle, 30°, is larger than Delaunay's, 29°, and no triangulation of the same points can have that. Please report this domain.",
                "Degree does not speak for mindeg here: both have at most 4 edges at a vertex, the least possible.",
            ],
        );
    }

    #[test]
    fn tells_the_limit_and_the_ties() {
        let delaunay = MethodFigures { ties: Some(7), ..method(Method::DELAUNAY, 4, 12.5) };
        check(
            &[method(Method::LeastDegree, 4, 12.5), delaunay],
            &[
                "mindeg and Delaunay are level: both have at most 4 edges at a vertex, the least possible, and a smallest angle of 12.5°.",
                "No triangulation of these boundary points alone has a smallest angle above 12.5°; to do better, change the intervals or add points inside.",
                "The Delaunay triangulation is one of several: across 7 of its 37 interior edges four points lie on one circle and either diagonal will do, so its degrees are arbitrary among ties; its smallest angle is not.",
            ],
        );
        let delaunay = MethodFigures { ties: Some(0), ..method(Method::DELAUNAY, 4, 25.0) };
        check(
            &[method(Method::LeastDegree, 4, 25.0), delaunay],
            &[
                "mindeg and Delaunay are level: both have at most 4 edges at a vertex, the least possible, and a smallest angle of 25°.",
            ],
        );
    }

    #[test]
    fn without_a_valid_method_there_is_nothing_to_conclude() {
        check(
            &[method(Method::LeastDegree, 4, 25.0), failed(Method::DELAUNAY, None, &["too slow"])],
            &[
                "There is no Delaunay triangulation to compare with: too slow. mindeg has at most 4 edges at a vertex, the least possible, and a smallest angle of 25°.",
            ],
        );
        check(
            &[
                failed(Method::LeastDegree, Some(4), &["it folds"]),
                method(Method::DELAUNAY, 4, 25.0),
            ],
            &["mindeg has no valid mesh here: it folds."],
        );
    }

    #[test]
    fn the_others_are_told_in_short() {
        let pair = || [method(Method::LeastDegree, 4, 25.0), method(Method::DELAUNAY, 4, 25.0)];
        let level = "mindeg and Delaunay are level: both have at most 4 edges at a vertex, the least possible, and a smallest angle of 25°.";
        for (other, told) in [
            (
                method(FAN, 4, 1.0),
                "Fan: at most 4 edges at a vertex (the least possible), smallest angle 1°.",
            ),
            (
                method(FAN, 5, 1.0),
                "Fan: at most 5 edges at a vertex (1 vertex has more than 4), smallest angle 1°.",
            ),
            (
                method(FAN, 6, 0.001),
                "Fan: at most 6 edges at a vertex (2 vertices have more than 4), smallest angle 0.001°.",
            ),
            (failed(FAN, None, &["too slow"]), "Fan gives nothing here: too slow."),
            (
                failed(FAN, Some(9), &["1 flat", "2 missing"]),
                "Fan gives no valid triangulation here: 1 flat; 2 missing.",
            ),
        ] {
            let [mindeg, delaunay] = pair();
            check(&[mindeg, delaunay, other], &[level, told]);
        }
        check(&[], &[]);
    }
}
