//! `mindeg degree`: the answer from the counts alone.

use crate::angle_limit::Lifting;
use crate::args::{Counts, DegreeArguments};
use crate::bar::Bar;
use crate::domain::{counts_of, file_with_size};
use crate::failure::Failure;
use crate::interior_report::Limit;
use crate::polygon_degree::{Answer, failed};
use crate::standard_output::{print, print_json};
use mindeg::exact::degree;
use mindeg::{Domain, Goal, Progress};
use mindeg_answers::advice::shell_word;
use mindeg_answers::numbers::steady_angle;
use mindeg_answers::words;
use mindeg_core::{Boundary, Certificate, certificate, suggest};
use serde::Serialize;
use std::fmt::Write;

/// What `--json` prints.
#[derive(Serialize)]
struct ConvexAnswer<'a> {
    intervals: &'a [u64],
    vertices: u32,
    triangles: u32,
    interior_edges: u32,
    least_max_degree: u32,
    certificate: Proof,
    /// The limit of the minimum angle with interior points; only for a domain.
    #[serde(skip_serializing_if = "Option::is_none")]
    angle_limit: Option<Limit>,
}

/// A certificate in the words of the JSON output; sides count from 1, as in the text.
#[derive(Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
enum Proof {
    BalancedCut { first_side: usize, side_count: usize, larger: u32, smaller: u32, bound: u32 },
    MedialTriangle { bound: u32 },
    LongSide { side: usize, bound: u32 },
    NoBalancedCut { least_imbalance: u32, bound: u32 },
}

pub(crate) fn run(arguments: &DegreeArguments) -> Result<(), Failure> {
    let (intervals, domain) = &match &arguments.counts {
        Counts::Given(counts) => (counts.clone(), None),
        Counts::Domain(path) => {
            let domain = file_with_size(path, &arguments.file)?;
            if domain.convex().is_none() || domain.is_constrained() {
                return of_any(&domain, arguments);
            }
            let (counts, domain) = counts_of(domain)?;
            (counts, Some(domain))
        }
    };
    let boundary = Boundary::new(intervals).map_err(|error| Failure::Input(error.to_string()))?;
    let certificate = certificate(&boundary);
    let vertices = boundary.vertex_count();
    let lifting =
        domain.as_ref().and_then(|domain| Lifting::of(domain, arguments.boundary_degree, 1));
    if arguments.json {
        return print_json(&ConvexAnswer {
            intervals,
            vertices,
            triangles: mindeg_core::bound::triangle_count(&boundary),
            interior_edges: mindeg_core::bound::interior_edge_count(&boundary),
            least_max_degree: certificate.max_degree(),
            certificate: proof(&certificate),
            angle_limit: lifting.as_ref().map(Lifting::json),
        });
    }
    let mut text = text(&boundary, &certificate);
    if let Some(form) = domain.as_ref().and_then(Domain::convex)
        && (form.first() > 0 || boundary.side_count() != domain_sides(domain.as_ref()))
    {
        let _ = writeln!(
            text,
            "Sides on one line count as one here, and each edge of a curve as a side; side 1 begins at \
             vertex {}.",
            form.first()
        );
    }
    if let (Some(domain), Counts::Domain(path)) = (domain, &arguments.counts) {
        text.extend(higher_degree(domain, &path.display().to_string()));
    }
    text.extend(lifting.as_ref().map(Lifting::text));
    print(&text)
}

/// The answer for a domain that no formula takes.
fn of_any(domain: &Domain, arguments: &DegreeArguments) -> Result<(), Failure> {
    let bar = Bar::new(arguments.json);
    let callback = bar.callback();
    let found = degree(domain, Progress::new(&callback)).map_err(|error| failed(&error))?;
    drop(callback);
    drop(bar);
    let lifting = Lifting::of(domain, arguments.boundary_degree, 1);
    let answer = Answer::new(domain, &found, lifting.as_ref().map(Lifting::json));
    if arguments.json {
        return print_json(&answer);
    }
    let mut text = answer.text(domain, &found);
    if let Counts::Domain(path) = &arguments.counts {
        text.extend(higher_degree(domain, &path.display().to_string()));
    }
    text.extend(lifting.as_ref().map(Lifting::text));
    print(&text)
}

/// What one or two degrees more bring on a domain, if that is much and found in about half a second.
fn higher_degree(domain: &Domain, file: &str) -> Option<String> {
    // A domain without a mesh says so when it is meshed.
    let meshed = mindeg::mesh(domain, Goal::LeastDegree, Progress::NONE).ok()?;
    let higher = meshed.higher_degree?;
    Some(format!(
        "Hint: degree {} has a minimum angle of {}, degree {} of {}:\n\
         mindeg mesh {} --max-degree {} -o mesh.obj\n",
        meshed.least_max_degree,
        steady_angle(meshed.mesh.angle_range().min),
        higher.max_degree,
        steady_angle(higher.min_angle),
        shell_word(file),
        higher.max_degree,
    ))
}

fn domain_sides(domain: Option<&Domain>) -> usize {
    domain.map_or(0, |domain| domain.rings().side_count())
}

fn proof(certificate: &Certificate) -> Proof {
    let bound = certificate.max_degree();
    match *certificate {
        Certificate::BalancedCut { cut, .. } => Proof::BalancedCut {
            first_side: cut.first_side + 1,
            side_count: cut.side_count,
            larger: cut.larger,
            smaller: cut.smaller,
            bound,
        },
        Certificate::MedialTriangle => Proof::MedialTriangle { bound },
        Certificate::LongSide { side, .. } => Proof::LongSide { side: side + 1, bound },
        Certificate::NoBalancedCut { least_imbalance } => {
            Proof::NoBalancedCut { least_imbalance, bound }
        }
    }
}

fn text(boundary: &Boundary, certificate: &Certificate) -> String {
    let vertices = boundary.vertex_count();
    let degree = certificate.max_degree();
    let mut text = String::new();
    let counts = [
        ("sides", boundary.side_count() as u64),
        ("vertices", vertices.into()),
        ("triangles", mindeg_core::bound::triangle_count(boundary).into()),
        ("interior edges", mindeg_core::bound::interior_edge_count(boundary).into()),
        ("least maximum degree", degree.into()),
    ];
    for (name, count) in counts {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{name:<21} {count}");
    }
    text.push('\n');
    text.push_str(&words::certificate(boundary, certificate));
    if degree > 4
        && let Some(suggestion) = suggest(boundary, degree - 1)
    {
        let _ = writeln!(
            text,
            "Hint: {} and it is {}; mindeg suggest tells more.",
            words::suggestion(&suggestion),
            suggestion.max_degree
        );
    }
    text
}
