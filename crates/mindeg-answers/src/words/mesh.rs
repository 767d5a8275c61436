//! What is proven of a mesh, and what a higher degree would bring.

use mindeg::{FoundBy, Goal, HigherDegree, Meshed};

use crate::numbers::steady_angle;

/// The size of a mesh, its degree and its angles, the least and the greatest in degrees, in a line.
#[must_use]
pub fn mesh(meshed: &Meshed, angles: [f64; 2]) -> String {
    let mesh = &meshed.mesh;
    let total = if mesh.domain().is_constrained() { "total " } else { "" };
    let [min, max] = angles.map(steady_angle);
    format!(
        "{} vertices, {} triangles, maximum {total}degree {} ({} {}), angles {min} to {max}",
        mesh.vertex_count(),
        mesh.triangle_count(),
        mesh.max_total_degree(),
        if meshed.is_least_proven { "least possible" } else { "no mesh has less than" },
        meshed.least_max_degree,
    )
}

/// What is proven of a mesh, where the first line does not say it.
#[must_use]
pub fn standing(meshed: &Meshed, goal: Goal, min_angle: f64) -> Option<String> {
    let (max_degree, least) = (meshed.mesh.max_total_degree(), meshed.least_max_degree);
    let kept = meshed.delaunay_min_angle.map(|most| {
        let share = 100.0 * min_angle / most;
        format!("{share:.0}% of Delaunay's minimum angle, {}", steady_angle(most))
    });
    match (meshed.found_by, goal, kept) {
        (FoundBy::Formula, Goal::LeastDegree, _) => Some(
            "It is the best of the candidates that were tried; --keep-angle 95% trades degree for \
             angle at this size."
                .to_owned(),
        ),
        (FoundBy::Formula, _, _) => Some(
            "No window reached the limit; the formula did. A larger minimum angle may be possible."
                .to_owned(),
        ),
        (FoundBy::Search, Goal::KeepAngle(share), Some(kept)) => {
            let percent = 100.0 * share;
            Some(format!("It has {kept}. No smaller degree keeps {percent:.0}%."))
        }
        (FoundBy::Windows { share }, _, Some(kept)) => {
            let percent = 100.0 * share;
            let gap = if max_degree == least {
                "no degree is smaller".to_owned()
            } else if meshed.is_least_proven && goal == Goal::LeastDegree {
                "no mesh has less".to_owned()
            } else if share == 0.0 {
                format!("whether a degree from {least} on is possible is not known")
            } else {
                format!(
                    "whether a degree from {least} on is possible with {percent:.0}% is not known"
                )
            };
            Some(format!("It has {kept}. Degree {max_degree} was reached; {gap}."))
        }
        (FoundBy::Exhaustive | FoundBy::ZigZag, _, Some(kept)) => {
            Some(format!("It has {kept}; more may be possible with this degree."))
        }
        (_, _, _) => None,
    }
}

/// What a higher degree would bring, and the option to copy.
#[must_use]
pub fn higher_degree(min_angle: f64, higher: &HigherDegree) -> String {
    format!(
        "Hint: degree {} has a minimum angle of {}, {:.1} times as much: add --max-degree {}",
        higher.max_degree,
        steady_angle(higher.min_angle),
        higher.min_angle / min_angle,
        higher.max_degree,
    )
}
