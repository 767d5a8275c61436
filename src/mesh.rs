//! `mindeg mesh`: from a domain to files.

mod beside;
mod features;
mod interior;
pub(crate) mod model;
mod ocean;

use crate::args::MeshArguments;
use crate::bar::Bar;
use crate::condition::refuse_degrees;
use crate::demands::{met_or_written_anyway, unmet_by_boundary_mesh};
use crate::domain::{Parts, Subject, name, subject};
use crate::failure::Failure;
use crate::making::{Making, advice_on};
use crate::provenance::mesh_command_again;
use mindeg::MeshError;
use mindeg::{Domain, FoundBy, Goal, Meshed, Progress};
use mindeg_answers::advice::{AdvisedMesh, Purpose};
use mindeg_answers::mesh::{self as words, MeshAnswer};
use mindeg_answers::numbers::steady_angle;
use mindeg_exact::{MAX_VERTICES, Unsolved};
use mindeg_files::{Format, Wanted, is_domain_name, is_mesh_name};
use std::path::{Path, PathBuf};

pub(crate) use features::is_one_mesh;

pub(crate) fn run(arguments: &MeshArguments) -> Result<(), Failure> {
    let output = &arguments.surface.output;
    let (file, options) = (arguments.domain.file.as_deref(), &arguments.domain.options);
    refuse_swapped(file, output)?;
    let subject = opened(arguments)?;
    match subject {
        Subject::Domain(domain) => mesh_of(&domain, arguments, output),
        Subject::Polygons(polygons) if polygons.polygons.len() > 1 => {
            if features::are_one_map(arguments) {
                return interior::run_maps(arguments, &polygons);
            }
            if is_one_mesh(arguments) {
                let parts = Parts::of(&polygons, features::SEPARATE)?;
                return match &parts.domains[..] {
                    [map] => mesh_of(map, arguments, output),
                    _ => {
                        arguments.kinds.refuse("several domains")?;
                        beside::run(&parts, arguments)
                    }
                };
            }
            features::run(arguments, &polygons, |domain, output| mesh_of(domain, arguments, output))
        }
        Subject::Polygons(polygons) => {
            let output = features::outputs_of_one(arguments, &polygons)?;
            mesh_of(&polygons.only()?, arguments, &output)
        }
        Subject::Model(model) => model::run(&model::divided(*model, file, options)?, arguments),
        Subject::Mesh(mesh) => {
            model::run(&model::of_mesh(&mesh, file, options, &arguments.model)?, arguments)
        }
    }
}

/// Refuses `mesh plate.obj -o plate.dxf`, where the domain is there: no mesh is written in its format.
fn refuse_swapped(file: Option<&Path>, output: &[PathBuf]) -> Result<(), Failure> {
    let (Some(file), [domain]) = (file, output) else { return Ok(()) };
    let is_domain = is_domain_name(domain) && Format::of_path(domain).is_none();
    if !is_domain || !is_mesh_name(file) || !domain.exists() {
        return Ok(());
    }
    let (file, domain) = (file.display(), domain.display());
    Err(Failure::Input(format!(
        "{domain} is a domain; swap the two: mindeg mesh {domain} -o {file}"
    )))
}

/// The domain or model that is to be meshed. If its boundary is conditioned, its edges get their lengths so.
fn opened(arguments: &MeshArguments) -> Result<Subject, Failure> {
    let bar = Bar::new(arguments.quiet);
    if arguments.condition.is_none() {
        if let Some(option) = arguments.change.first_given() {
            return Err(Failure::Input(format!(
                "{option} says how a boundary may change: add --condition"
            )));
        }
        let subject = subject(&arguments.domain, Wanted::Model, &bar)?;
        subject.refuse_degrees(arguments.interior.wanted.lengths())?;
        return Ok(subject);
    }
    if arguments.change.changes.is_some() && !is_one_mesh(arguments) {
        return Err(Failure::input(
            "--changes is for one mesh: leave out --separate and names with a pattern",
        ));
    }
    let mut domain = arguments.domain.clone();
    let size = domain.options.size.take();
    // Rings that touch themselves are changed, too.
    domain.options.outline.mends = Some(arguments.change.room(size));
    let subject = subject(&domain, Wanted::Model, &bar)?;
    refuse_degrees(&subject, &arguments.change, size)?;
    subject.refuse_degrees(arguments.interior.wanted.lengths())?;
    match subject {
        Subject::Model(_) | Subject::Mesh(_) => Err(Failure::input(
            "--condition changes the boundary of a domain in the plane, and this is a model; leave it out",
        )),
        subject => Ok(subject),
    }
}

/// Meshes one domain into files.
fn mesh_of(domain: &Domain, arguments: &MeshArguments, output: &[PathBuf]) -> Result<(), Failure> {
    let mut making = Making::to(output, &arguments.surface, arguments.quiet, arguments.json)?;
    making.unproject(domain.projection());
    if let Some(wanted) = interior::wanted(arguments, domain)? {
        return interior::run(arguments, domain, &wanted, making);
    }
    let told = arguments.kinds.told(std::slice::from_ref(domain))?;
    making.tell(told.notes);
    let domain = &told.domains[0];
    // Refuse bad options before the search for the mesh, which can take minutes.
    making.check(domain.placement(), domain.rings().triangle_count())?;
    let goal = arguments.goal.goal();
    making.open()?;
    let (meshed, angles) = making.work(|progress| {
        let meshed = meshed(domain, goal, progress)?;
        let angles = meshed.mesh.measure_angles(progress);
        let angles = angles.map_err(Failure::input)?;
        Ok::<_, Failure>((meshed, angles))
    })?;
    let mesh = &meshed.mesh;
    let demands = arguments.demands(arguments.interior.wanted.target_angle());
    let unmet = unmet_by_boundary_mesh(&demands, mesh, angles.min, making.bar())?;
    let end = met_or_written_anyway(&unmet, arguments.interior.wanted.write_anyway);
    let end = end.map_err(|failure| match demands.target_angle {
        Some(target) if angles.min < target => with_way_out(failure, target, &meshed),
        _ => failure,
    })?;
    if domain.is_map() {
        // It has more vertices than the boundary.
        making.check(mesh, mesh.triangle_count())?;
    }
    let made = making.write_checked(mesh)?;

    let answer = MeshAnswer::of(&meshed, [angles.min, angles.max]);
    let advice = || {
        // Of polygons that are meshed one by one, each would have its own.
        let is_told = !arguments.goal.is_empty() || arguments.separate;
        (!is_told).then(|| advice_on(std::slice::from_ref(domain)))
    };
    let hints = || {
        let file = arguments.domain.file.as_deref();
        let command = || mesh_command_again(domain, file);
        let advice = advice();
        // A patch of the same degree is that mesh.
        let patch = advice.as_ref().and_then(|advice| advice.patch);
        let is_named = patch.is_some_and(|patch| patch.max_degree <= answer.max_degree);
        let more = arguments.goal.is_empty() && !is_named && has_more(&meshed, &answer);
        let more = more.then(|| {
            format!(
                "hint: a search that takes longer may give a larger angle at this degree:\n{}",
                command().advised(Purpose::Fewest)
            )
        });
        let made = Some(AdvisedMesh::of(&meshed));
        let advice = advice.and_then(|advice| advice.hints(&command(), made));
        let lines: Vec<String> = more.into_iter().chain(advice).collect();
        (!lines.is_empty()).then(|| lines.join("\n"))
    };
    made.say_and_advise(|| text(&meshed, goal, &answer), hints, || &answer)?;
    end
}

/// What would reach a minimum angle that the mesh does not have.
fn with_way_out(failure: Failure, target: f64, meshed: &Meshed) -> Failure {
    let Failure::Gate(message) = failure else { return failure };
    let most = meshed.delaunay_min_angle;
    let allowed = most.filter(|most| *most < target).map_or_else(String::new, |most| {
        format!("no mesh of these points alone has more than {}; ", steady_angle(most))
    });
    Failure::Gate(format!("{message}; {allowed}--interior puts points inside"))
}

/// Whether the search for the largest angle, which is left out for its cost, may find a larger one at the same degree.
fn has_more(meshed: &Meshed, answer: &MeshAnswer) -> bool {
    meshed.found_by != FoundBy::Search
        && meshed.mesh.vertex_count() <= MAX_VERTICES
        && answer.share_of_limit.is_some_and(|share| share < 1.0)
}

/// The way to a mesh for a domain that is too large for its limits.
pub(crate) const WITHOUT_CONSTRAINTS: &str = "leave out outside_degree and max_degree";

/// The mesh of a domain.
pub(crate) fn meshed(
    domain: &Domain,
    goal: Goal,
    progress: Progress<'_>,
) -> Result<Meshed, Failure> {
    mindeg::mesh(domain, goal, progress).map_err(|error| unsolved(&error, WITHOUT_CONSTRAINTS))
}

/// Why a domain has no mesh; where it is for its size, `way_out` says what to do.
pub(crate) fn unsolved(error: &MeshError, way_out: &str) -> Failure {
    Failure::Input(match error {
        MeshError::Unsolved(Unsolved::TooManyVertices { vertices }) => format!(
            "the domain has {vertices} boundary vertices; exact work takes at most {MAX_VERTICES}; \
             use fewer intervals, or {way_out}"
        ),
        error => error.to_string(),
    })
}

fn text(meshed: &Meshed, goal: Goal, answer: &MeshAnswer) -> String {
    let domain = meshed.mesh.domain();
    let angles = [answer.min_angle, answer.max_angle];
    let mut lines = vec![format!("{}: {}", name(domain), words::mesh(meshed, angles))];
    lines.extend(words::standing(meshed, goal, answer.min_angle));
    lines.extend(domain.notes());
    lines.join("\n")
}
