//! A trade-off as one HTML page that opens from disk, asks for nothing else; its script only zooms.
//!
//! Limits: two dozen meshes at most, evenly chosen.

use super::super::Provenance;
use super::super::html::{SMALL_CURVE, curve_picture, facts, rendered};
use super::super::svg::{self, CURVE_STYLE, DegreeColor, Marks};
use super::super::tables::Table;
use super::super::viewer::{STYLE, ZOOM_SCRIPT};
use super::spread;
use crate::regions::regions;
use askama::Template;
use glam::DVec2;
use mindeg::Bounds;
use mindeg::exact::{ExactMesh, TradeOff};
use mindeg::quality::TriangleQuality;
use mindeg_answers::advice::{Advice, KEPT, Purpose};
use mindeg_answers::numbers::{count, percent, steady_angle};
use mindeg_formats::svg::Inset;
use mindeg_mesh::TriMesh;
use std::io::{self, Write};

const MESHES_STYLE: &str = include_str!("page.css");

/// The most meshes shown.
const MOST_MESHES: usize = 24;

/// The size of the curve on a screen wide enough, in its own pixels.
const WIDE_CURVE: DVec2 = DVec2::new(900.0, 400.0);

/// The space for a mesh, in the picture's own pixels.
const MESH: DVec2 = DVec2::new(480.0, 400.0);
/// Space for the dots on the outline.
const MARGIN: f64 = 9.0;

#[derive(Template)]
#[template(path = "trade_off.html")]
struct Page<'a> {
    title: &'a str,
    provenance: Provenance,
    style: String,
    facts: String,
    headline: &'a str,
    sentences: &'a [String],
    /// What points on edges bring, and its command: below the pictures, which it would push out of a small screen.
    on_edges: Option<[String; 2]>,
    curve: String,
    chosen: String,
    legend: Vec<DegreeColor>,
    /// The size of every mesh's picture.
    size: DVec2,
    /// How the pictures are not to scale, if they are not.
    stretch: Option<String>,
    figures: Vec<Figure>,
    table: Table,
    script: &'static str,
}

/// A mesh with its figures.
struct Figure {
    id: String,
    title: String,
    described: String,
    /// The command that makes it.
    command: String,
    drawing: String,
}

/// Writes a trade-off as one self-contained HTML page with the mesh to take, for a purpose if that is told, and the mesh with
/// points `inside`, if there is one. Beside each mesh is the command that makes it, of the domain that `made_by` names.
///
/// # Errors
///
/// The errors of `out`.
///
/// # Example
///
/// ```
/// use mindeg_compare::{Provenance, write_trade_off_html};
/// use mindeg::{Domain, Progress, Side, exact};
/// use mindeg_answers::advice::Advice;
///
/// let domain = Domain::rectangle(4.0, 3.0, vec![Side::count(10); 4])?.named("plate")?;
/// let advice = Advice::of(std::slice::from_ref(&domain), Progress::NONE).map_err(|(_, error)| error)?;
/// let mut page = Vec::new();
/// write_trade_off_html(&exact::trade_off(&domain, Progress::NONE)?, &advice, None, None, Provenance::default(), &mut page)?;
/// let page = String::from_utf8(page)?;
/// assert!(page.contains("<h1>plate</h1>") && page.contains("id=\"degree-5\""));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write_trade_off_html(
    trade_off: &TradeOff,
    advice: &Advice,
    told: Option<Purpose>,
    inside: Option<&TriMesh>,
    made_by: Provenance,
    mut out: impl Write,
) -> io::Result<()> {
    let domain = trade_off.domain();
    let meshes = trade_off.meshes();
    let shown: Vec<usize> = spread(meshes.len(), MOST_MESHES).collect();
    let chosen = if shown.len() < meshes.len() {
        format!("{} of {}, evenly chosen. ", shown.len(), meshes.len())
    } else {
        String::new()
    };
    let bounds = domain.placement().bounds();
    let space = Bounds { min: DVec2::splat(MARGIN), max: MESH - MARGIN };
    let figure = |&place: &usize| {
        let exact = &meshes[place];
        Ok(Figure {
            id: format!("degree-{}", exact.max_degree),
            title: format!("Degree {}", count(exact.max_degree)),
            described: format!(
                "minimum angle {} · {} of Delaunay's",
                steady_angle(exact.min_angle),
                percent(trade_off.share(exact))
            ),
            command: made_by
                .mesh
                .of_boundary_alone(&["--max-degree", &exact.max_degree.to_string()]),
            drawing: svg::mesh(&exact.mesh, bounds, space)?,
        })
    };
    let is_shown = |degree| shown.iter().any(|&place| meshes[place].max_degree == degree);
    let marks = Marks {
        advised: advised(trade_off).map(|exact| exact.max_degree),
        inside: advice.solver,
        links_inside: inside.is_some(),
        ..Marks::default()
    };
    let verdict = verdict(trade_off, advice, told);
    let [headline, sentences @ ..] = &verdict[..] else { return Ok(()) };
    let on_edges = advice.on_edges(&advice.purposes(told));
    let on_edges = on_edges.map(|sentence| [sentence, made_by.mesh.conditioned()]);
    let mut figures: Vec<Figure> = shown.iter().map(figure).collect::<io::Result<_>>()?;
    if let (Some(mesh), Some(found)) = (inside, advice.solver) {
        figures.insert(
            0,
            Figure {
                id: "points-inside".to_owned(),
                title: "Points inside".to_owned(),
                described: format!(
                    "minimum angle {} · at most {} edges at a vertex",
                    steady_angle(found.min_angle),
                    count(found.max_degree)
                ),
                command: made_by.mesh.advised(Purpose::Solver),
                drawing: svg::mesh(mesh, bounds, space)?,
            },
        );
    }
    // The mesh to take comes first.
    let taken = match (advice.purposes(told).first(), advised(trade_off)) {
        (Some(Purpose::Patch), Some(exact)) => format!("degree-{}", exact.max_degree),
        (Some(Purpose::Fewest), _) => format!("degree-{}", meshes[0].max_degree),
        _ => "points-inside".to_owned(),
    };
    if let Some(place) = figures.iter().position(|figure| figure.id == taken) {
        figures[..=place].rotate_right(1);
    }
    let intervals: Vec<u32> = domain.rings().sides().collect();
    let inset = Inset::new(bounds, space);
    let page = Page {
        title: domain.name().unwrap_or("Domain"),
        provenance: made_by,
        style: svg::page_style(&[STYLE, CURVE_STYLE, MESHES_STYLE]),
        facts: facts(
            &intervals,
            domain.hole_count() as u32,
            regions(domain),
            [meshes[0].mesh.vertex_count(), meshes[0].mesh.triangle_count()],
            meshes[0].max_degree,
            trade_off.is_exact(),
        ),
        headline,
        sentences,
        on_edges,
        curve: curve_picture(trade_off, WIDE_CURVE, "wide", marks, is_shown)?
            + &curve_picture(trade_off, SMALL_CURVE, "narrow", marks, is_shown)?,
        chosen,
        legend: svg::degree_legend(trade_off, inside),
        size: DVec2::new(MESH.x, inset.size().y + 2.0 * MARGIN).round(),
        stretch: inset.stretch(),
        figures,
        table: table(trade_off, advice, inside),
        script: ZOOM_SCRIPT,
    };
    out.write_all(rendered(&page)?.as_bytes())
}

/// The first mesh that keeps enough of Delaunay's minimum angle.
fn advised(trade_off: &TradeOff) -> Option<&ExactMesh> {
    trade_off.keeping(KEPT)
}

/// The advice and the findings from the curve, in sentences; the first is the headline.
fn verdict(trade_off: &TradeOff, advice: &Advice, told: Option<Purpose>) -> Vec<String> {
    let describe = |exact: &ExactMesh| {
        format!(
            "{} ({} of Delaunay's)",
            steady_angle(exact.min_angle),
            percent(trade_off.share(exact))
        )
    };
    let meshes = trade_off.meshes();
    let delaunay = steady_angle(trade_off.delaunay_min_angle());
    let (Some(first), Some(last)) = (meshes.first(), meshes.last()) else { return Vec::new() };
    let (least, most) = (count(first.max_degree), count(last.max_degree));
    let purposes = advice.purposes(told);
    let mut sentences: Vec<String> =
        purposes.iter().map(|purpose| advice.as_it_is(*purpose)).collect();
    sentences.push(format!(
        "Without points inside, degree {least}, the least possible, has at most {}.",
        describe(first)
    ));
    if last.min_angle < trade_off.delaunay_min_angle() {
        sentences.push(format!(
            "More than degree {most}, with {}, does not help: the degree limits of single vertices \
             prevent Delaunay's {delaunay}.",
            describe(last)
        ));
    } else if meshes.len() > 1 {
        sentences.push(format!("Degree {most} has Delaunay's {delaunay} in full."));
    }
    sentences
}

/// The maximum angle of a mesh, in degrees.
fn max_angle(mesh: &TriMesh) -> f64 {
    let angle = |triangle: &[u32; 3]| {
        let [a, b, c] = triangle.map(|vertex| mesh.positions()[vertex as usize]);
        TriangleQuality::in_space(a, b, c).max_angle
    };
    mesh.triangles().iter().map(angle).fold(0.0, f64::max)
}

fn table(trade_off: &TradeOff, advice: &Advice, inside: Option<&TriMesh>) -> Table {
    let row = |exact: &ExactMesh| {
        vec![
            count(exact.max_degree),
            steady_angle(exact.min_angle),
            percent(trade_off.share(exact)),
            steady_angle(exact.mesh.angle_range().max),
        ]
    };
    let with_points = inside.zip(advice.solver).map(|(mesh, found)| {
        vec![
            format!("{}, points inside", count(found.max_degree)),
            steady_angle(found.min_angle),
            found.share_of_delaunay.map_or_else(|| "–".to_owned(), percent),
            steady_angle(max_angle(mesh)),
        ]
    });
    Table {
        title: "What each degree buys".to_owned(),
        note: String::new(),
        columns: ["Maximum degree", "Minimum angle", "Share of Delaunay's", "Maximum angle"]
            .map(str::to_owned)
            .into(),
        rows: with_points.into_iter().chain(trade_off.meshes().iter().map(row)).collect(),
    }
}
