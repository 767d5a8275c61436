//! `mindeg mesh --interior`: a domain with points inside.

use super::features::SEPARATE;
use super::ocean::{Ocean, with_depths};
use crate::args::{MeshArguments, Told, with_sizes_of};
use crate::bar::Bar;
use crate::condition::drawn;
use crate::demands::met_or_written_anyway;
use crate::domain::describe::write_texts;
use crate::domain::{Parts, name};
use crate::failure::Failure;
use crate::making::Making;
use mindeg::interior::{self, InteriorError, InteriorMesh};
use mindeg::{Domain, Interior, Projection};
use mindeg_answers::advice::{HINTED, Purpose};
use mindeg_answers::condition::ConditionAnswer;
use mindeg_answers::interior::{
    InteriorAnswer, angles_and_degrees, corners, grading, local_limits, more_on_request,
    unmet_degrees, violations,
};
use mindeg_answers::limit::{Lifting, LimitAnswer};
use mindeg_answers::names::shown;
use mindeg_answers::numbers::{counted, triangles};
use mindeg_answers::on_edges::{is_low, is_tight, with_points_on_edges};
use mindeg_answers::sizes::{coarse_sides, sizes, sizes_beside};
use mindeg_files::PolygonFile;
use mindeg_mesh::{Bounds, TriMesh, significant};
use serde::Serialize;
use std::borrow::Cow;

/// The output of `--json`.
#[derive(Serialize)]
struct Summary<'a> {
    name: Option<&'a str>,
    intervals: Vec<u32>,
    boundary_vertices: usize,
    vertices: usize,
    #[serde(flatten)]
    reached: InteriorAnswer,
    limit: LimitAnswer,
    /// "interior": how the mesh was found.
    found_by: &'static str,
    /// Whether corners ran clockwise.
    reversed: bool,
    /// How many regions a map has, and in how many parts that share no edge.
    #[serde(flatten)]
    map: Option<MapSummary>,
    /// The changes of the boundary, if it was conditioned.
    #[serde(skip_serializing_if = "Option::is_none")]
    conditioned: Option<&'a ConditionAnswer>,
    #[serde(flatten)]
    ocean: Ocean,
}

/// The regions of polygons that are one map.
#[derive(Serialize)]
struct MapSummary {
    regions: usize,
    parts: usize,
}

/// The options for interior points, if these are wanted; refuses options that do not go together.
pub(super) fn wanted(
    arguments: &MeshArguments,
    domain: &Domain,
) -> Result<Option<Interior>, Failure> {
    let options = &arguments.interior;
    let purpose = arguments.goal.purpose;
    let in_file = domain.interior().is_some() && !options.no_interior && purpose.is_none();
    let is_wanted = options.interior || in_file || purpose == Some(Purpose::Solver);
    if !is_wanted {
        return refuse_options(arguments).map(|()| None);
    }
    let from = match (options.interior, purpose) {
        (true, _) => "--interior",
        (_, Some(_)) => "--for solver",
        (_, None) => "\"interior\" in the domain's file",
    };
    arguments.refuse_goals_with_interior(from)?;
    with_sizes(arguments, domain.interior()).map(Some)
}

/// Refuses options for interior points where none are wanted.
pub(super) fn refuse_options(arguments: &MeshArguments) -> Result<(), Failure> {
    let options = &arguments.interior;
    let sizes = (!options.sizes.is_empty()).then(|| "--sizes".to_owned());
    let least_depth = arguments.least_depth.map(|_| "--least-depth");
    let depth = arguments.depth.first_given().or(least_depth).map(str::to_owned);
    let condition = arguments.condition.map(|_| "--condition".to_owned());
    match options.wanted.first_given().or(sizes).or(depth).or(condition) {
        Some(option) => Err(Failure::Input(format!(
            "{option} is for meshes with interior points; add --interior"
        ))),
        None => Ok(()),
    }
}

/// The interior points that the options ask for, in place of those of the file.
fn with_sizes(arguments: &MeshArguments, file: Option<&Interior>) -> Result<Interior, Failure> {
    let wanted = arguments.interior.wanted.over(file);
    Ok(arguments.preset.asked_of(with_sizes_of(wanted, &arguments.interior.sizes)?))
}

/// The domains to mesh: with their boundaries conditioned, if that is wanted, and with their open water.
fn prepared<'d>(
    arguments: &MeshArguments,
    wanted: &Interior,
    domains: &'d [Domain],
) -> Result<(Told<'d>, Option<ConditionAnswer>), Failure> {
    let Some(angle) = arguments.condition else {
        return Ok((arguments.kinds.told(domains)?, None));
    };
    let change = &arguments.change;
    let (size, least) = (arguments.domain.options.size, wanted.least_triangles());
    let demands = change.demands(angle, size, None, least);
    let (new, conditioned) = interior::condition_all(domains, wanted, &demands, &change.keep)
        .map_err(|(_, error)| Failure::input(error))?;
    let answer = ConditionAnswer::of(domains, &new, &conditioned);
    // The coast changes as without open water, so one step gives the mesh of two.
    let told = arguments.kinds.told(&new)?;
    let domains = Cow::Owned(told.domains.into_owned());
    Ok((Told { domains, ..told }, Some(answer)))
}

/// Draws the changes to a file, if that is wanted: once there is a mesh.
fn draw_changes(
    arguments: &MeshArguments,
    changes: Option<&ConditionAnswer>,
    title: &str,
    both: [&[Domain]; 2],
) -> Result<(), Failure> {
    match (changes, &arguments.change.changes) {
        (Some(changes), Some(path)) => write_texts(&[(drawn(changes, title, both, path)?, path)]),
        _ => Ok(()),
    }
}

/// With fewer edges that stay, the sides of a poor boundary are too long to leave room for good triangles.
const FEW_EDGES: usize = 64;

/// The option that makes a poor boundary better: it divides few long sides, or puts points on edges, unless all that is poor is the angle
/// of a corner itself.
fn boundary_hint(
    arguments: &MeshArguments,
    domains: &[Domain],
    wanted: &Interior,
    found: &InteriorMesh,
) -> Option<String> {
    let InteriorMesh { mesh, report, limit, .. } = found;
    let (is_tight, is_low) = (is_tight(report), is_low(limit));
    if is_tight && let Some(size) = dividing_size(mesh) {
        return Some(format!(
            "hint: few long sides leave little room for good triangles; --size {size} divides them."
        ));
    }
    if arguments.condition.is_some() || !is_tight && !is_low {
        return None;
    }
    // To count the points that `--condition` would put on edges of a larger boundary takes seconds, which nobody has asked for.
    if vertices_of_boundary(found) as u64 > HINTED {
        return Some(
            "hint: some edges of the boundary leave little room for good triangles; --condition puts points on edges where they \
             help, and with --within LENGTH moves the boundary, too."
                .to_owned(),
        );
    }
    let put = || with_points_on_edges(domains, wanted, &arguments.change.keep);
    match Bar::new(false).waiting("counting points on edges", put)?.1 {
        0 => is_low.then(|| {
            "hint: points on edges lift no limit here; --condition --within LENGTH may move the boundary, too, and tells each \
             change."
                .to_owned()
        }),
        points => Some(format!(
            "hint: some edges of the boundary leave little room for good triangles; --condition puts {} on them, and moves \
             nothing. mindeg condition does that alone.",
            counted(points as u64, "point")
        )),
    }
}

/// The size that divides few long sides; `None` of many edges, and where it divides none.
fn dividing_size(mesh: &TriMesh) -> Option<String> {
    let (positions, edges) = (mesh.positions(), mesh.segments());
    let size = Bounds::of_space(positions.iter().copied())?.size().max_element() / 10.0;
    let size = significant(size, 1);
    let value: f64 = size.parse().ok()?;
    let is_divided = |&[a, b]: &[u32; 2]| {
        // A side has as many intervals as it is sizes long, rounded.
        positions[a as usize].distance(positions[b as usize]) >= 1.5 * value
    };
    (edges.len() < FEW_EDGES && edges.iter().any(is_divided)).then_some(size)
}

/// How many vertices are on the boundary: those around holes that touch rings, too, which are lines of the domain.
fn vertices_of_boundary(found: &InteriorMesh) -> usize {
    found.mesh.positions().len() - found.report.interior_points
}

/// The text on the changes of a boundary, without a line break at its end.
fn words_on(conditioned: Option<&ConditionAnswer>, name: &str) -> Option<String> {
    conditioned.map(|answer| answer.text(name).trim_end().to_owned())
}

/// Meshes a domain with interior points.
pub(super) fn run(
    arguments: &MeshArguments,
    domain: &Domain,
    wanted: &Interior,
    mut making: Making,
) -> Result<(), Failure> {
    let old = std::slice::from_ref(domain);
    let depths = arguments.depths(domain.projection())?;
    let beside = sizes_beside(old, &wanted.sizes);
    let wanted = &arguments.depth.over(depths.as_ref(), wanted.clone(), old)?;
    let (told, conditioned) = prepared(arguments, wanted, old)?;
    let Told { domains, openings, notes } = told;
    making.tell(notes);
    let domain = &domains[0];
    making.open()?;
    let meshed = making.work(|progress| interior::mesh(domain, wanted, progress));
    let found = meshed.map_err(|error| refused(domain, wanted, &error))?;
    let projection = domain.projection();
    let (mesh, depths) = with_depths(found.mesh, depths.as_ref(), arguments, projection)?;
    let ocean = Ocean::new(&openings, depths, projection);
    let found = InteriorMesh { mesh, ..found };
    let InteriorMesh { mesh, report, limit, .. } = &found;
    let lifting = Lifting::from_limit(domain, wanted, limit.clone(), 1).map_err(Failure::input)?;
    let mut unmet = arguments.demands(wanted.target_angle).unmet_by(mesh, report.min_angle);
    unmet.extend(unmet_degrees(report, wanted, domain.is_constrained(), projection));
    let end = met_or_written_anyway(&unmet, arguments.interior.wanted.write_anyway)?;

    let made = making.write(mesh)?;
    draw_changes(arguments, conditioned.as_ref(), &self::name(domain), [old, &domains])?;
    let summary = Summary {
        name: domain.name(),
        intervals: domain.rings().sides().collect(),
        boundary_vertices: vertices_of_boundary(&found),
        vertices: mesh.positions().len(),
        reached: InteriorAnswer::from(&found),
        limit: lifting.answer(),
        found_by: "interior",
        reversed: domain.was_reversed(),
        map: None,
        conditioned: conditioned.as_ref(),
        ocean,
    };
    let said = || {
        words_on(conditioned.as_ref(), &name(domain))
            .into_iter()
            .chain([text(&name(domain), &found, projection, &lifting, &summary)])
            .chain(summary.ocean.words())
            .chain(beside.clone())
            .chain(domain.notes())
            .chain(more_on_request(&found.report, wanted.target_angle))
            .collect::<Vec<_>>()
            .join("\n")
    };
    let advice = || boundary_hint(arguments, &domains, wanted, &found);
    made.say_and_advise(said, advice, || &summary)?;
    end
}

/// Meshes the polygons of a file as the regions of one mesh.
pub(super) fn run_maps(arguments: &MeshArguments, polygons: &PolygonFile) -> Result<(), Failure> {
    arguments.refuse_goals_with_interior("--interior")?;
    let mut making = Making::new(&arguments.surface, arguments.quiet, arguments.json)?;
    let old = Parts::of(polygons, SEPARATE)?.domains;
    let wanted = with_sizes(arguments, None)?;
    let projection = old.first().and_then(Domain::projection).copied();
    making.unproject(projection.as_ref());
    let depths = arguments.depths(projection.as_ref())?;
    let beside = sizes_beside(&old, &wanted.sizes);
    let wanted = arguments.depth.over(depths.as_ref(), wanted, &old)?;
    let (told, conditioned) = prepared(arguments, &wanted, &old)?;
    let Told { domains, openings, notes } = told;
    making.tell(notes);
    making.open()?;
    let meshed = making.work(|progress| interior::mesh_all(&domains, &wanted, progress));
    let mut found = meshed.map_err(|(index, error)| refused(&domains[index], &wanted, &error))?;
    let (mesh, depths) = with_depths(found.mesh, depths.as_ref(), arguments, projection.as_ref())?;
    let ocean = Ocean::new(&openings, depths, projection.as_ref());
    let name = polygons.name();
    found = InteriorMesh { mesh: mesh.called(name), ..found };
    let InteriorMesh { mesh, report, limit, .. } = &found;
    let mut unmet = arguments.demands(wanted.target_angle).unmet_by(mesh, report.min_angle);
    let is_constrained = domains.iter().any(Domain::is_constrained);
    unmet.extend(unmet_degrees(report, &wanted, is_constrained, projection.as_ref()));
    let end = met_or_written_anyway(&unmet, arguments.interior.wanted.write_anyway)?;

    let made = making.write(mesh)?;
    let title = shown(name.unwrap_or("map"));
    draw_changes(arguments, conditioned.as_ref(), &title, [&old, &domains])?;
    let lifting = Lifting { limit: limit.clone(), steps: Vec::new() };
    let regions = domains.iter().map(Domain::region_count).sum();
    let summary = Summary {
        name,
        intervals: domains.iter().flat_map(|domain| domain.rings().sides()).collect(),
        boundary_vertices: vertices_of_boundary(&found),
        vertices: mesh.positions().len(),
        reached: InteriorAnswer::from(&found),
        limit: lifting.answer(),
        found_by: "interior",
        reversed: false,
        map: Some(MapSummary { regions, parts: domains.len() }),
        conditioned: conditioned.as_ref(),
        ocean,
    };
    let title = || {
        let parts = counted(domains.len() as u64, "part");
        format!(
            "{}: {} in {parts}",
            shown(name.unwrap_or("map")),
            counted(regions as u64, "region")
        )
    };
    let said = || {
        words_on(conditioned.as_ref(), &shown(name.unwrap_or("map")))
            .into_iter()
            .chain([text(&title(), &found, projection.as_ref(), &lifting, &summary)])
            .chain(summary.ocean.words())
            .chain(beside.clone())
            .collect::<Vec<_>>()
            .join("\n")
    };
    let advice = || boundary_hint(arguments, &domains, &wanted, &found);
    made.say_and_advise(said, advice, || &summary)?;
    end
}

/// The reason why the mesh is missing, in the words of the domain.
fn refused(domain: &Domain, wanted: &Interior, error: &InteriorError) -> Failure {
    if let InteriorError::TargetAboveLimit { target, .. } = error
        && let Ok(lifting) = Lifting::of(domain, wanted, 1)
    {
        let words = lifting.text();
        return Failure::Input(format!("a minimum angle of {target}° is impossible. {words}"));
    }
    let option = match error {
        InteriorError::TooManyPoints { .. } => " by --max-points",
        _ => "",
    };
    Failure::Input(format!("{error}{option}"))
}

fn text(
    title: &str,
    found: &InteriorMesh,
    projection: Option<&Projection>,
    lifting: &Lifting,
    summary: &Summary<'_>,
) -> String {
    let report = &found.report;
    let mut lines = vec![
        format!(
            "{}: {} boundary and {} interior vertices, {}, {}",
            title,
            summary.boundary_vertices,
            report.interior_points,
            triangles(report.triangles as u64),
            angles_and_degrees(report),
        ),
        lifting.text(),
        local_limits(report, projection),
        grading(report),
    ];
    lines.extend(sizes(report));
    lines.extend(coarse_sides(found, projection));
    lines.extend(corners(report, projection));
    lines.extend(violations(report, projection).map(|violations| format!("warning: {violations}")));
    lines.join("\n")
}
