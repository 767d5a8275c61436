//! `mindeg improve`: degrees and the minimum angle of any planar mesh.

use crate::args::ImproveArguments;
use crate::demands::met_or_written_anyway;
use crate::failure::Failure;
use crate::making::Making;
use mindeg::interior::{self, ImprovedMesh};
use mindeg_answers::demands::Demands;
use mindeg_answers::interior::{
    InteriorAnswer, angles_and_degrees, corners, grading, local_limits, unmet_degrees, violations,
};
use mindeg_answers::numbers::steady_angle;
use serde::Serialize;

/// The output of `--json`.
#[derive(Serialize)]
struct Summary {
    file: String,
    vertices: usize,
    triangles: usize,
    /// Vertices at the position of an earlier vertex.
    welded_vertices: usize,
    /// Edges inside that stayed, since groups meet there or lines run along them.
    kept_edges: usize,
    before: InteriorAnswer,
    after: InteriorAnswer,
}

pub(crate) fn run(arguments: &ImproveArguments) -> Result<(), Failure> {
    let mut making = Making::new(&arguments.surface, arguments.quiet, arguments.json)?;
    let mesh = making.read(&arguments.file)?;
    making.tell_dropped([&mesh]);
    let file = arguments.file.display().to_string();
    making.open()?;
    let wanted = arguments.preset.asked_of(arguments.aims.over(None));
    let improved = making.work(|progress| interior::improve(&mesh, &wanted, progress));
    let improved = improved.map_err(|error| Failure::Input(format!("{file}: {error}")))?;
    let demands = Demands {
        max_degree: arguments.max_degree,
        target_angle: wanted.target_angle,
        preset: arguments.preset.preset,
    };
    let mut unmet = demands.unmet_by(&improved.mesh, improved.after.min_angle);
    unmet.extend(unmet_degrees(&improved.after, &wanted, false, None));
    let end = met_or_written_anyway(&unmet, arguments.aims.write_anyway)?;

    let made = making.write(&improved.mesh)?;
    let summary = || Summary {
        file: file.clone(),
        vertices: improved.mesh.positions().len(),
        triangles: improved.mesh.triangles().len(),
        welded_vertices: improved.merged,
        kept_edges: improved.kept_edges,
        before: InteriorAnswer::from(&improved.before),
        after: InteriorAnswer::from(&improved.after),
    };
    made.say(|| text(&file, &improved), summary)?;
    end
}

fn text(file: &str, improved: &ImprovedMesh) -> String {
    let ImprovedMesh { before, after, merged, kept_edges, .. } = improved;
    let wrong = |report: &interior::InteriorReport| match report.violations.len() {
        0 => "no degree out of range".to_owned(),
        1 => "1 degree out of range".to_owned(),
        count => format!("{count} degrees out of range"),
    };
    let line = |when: &str, report: &interior::InteriorReport| {
        format!(
            "  {when:<7} {} triangles, {}, {}",
            report.triangles,
            angles_and_degrees(report),
            wrong(report)
        )
    };
    let mut lines = vec![
        format!(
            "{file}: the boundary allows a minimum angle of at most {}",
            steady_angle(after.limits.angle())
        ),
        line("before:", before),
        line("after:", after),
        local_limits(after, None),
        grading(after),
    ];
    lines.extend(corners(after, None));
    let mut note = |count: u64, text: &str| {
        if count > 0 {
            lines.push(format!("{count} {text}"));
        }
    };
    note(*merged as u64, "vertices at the place of an earlier one were merged with it.");
    note(
        *kept_edges as u64,
        "edges inside were kept, since groups meet there or lines run along them.",
    );
    lines.extend(violations(after, None).map(|violations| format!("warning: {violations}")));
    lines.join("\n")
}
