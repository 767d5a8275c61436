//! One mesh of any program as an HTML page: the pictures and charts of a comparison for it alone.
//!
//! Limits: flat pictures are thinned above 100,000 triangles, pictures in space above 2 million; the page says so.

use super::Provenance;
use super::html::{Figure, rendered, script_safe};
use super::picture;
use super::scene::{Scene, thinned};
use super::svg;
use super::tables::{self, Table};
use super::titles::Named;
use super::viewer::{SCRIPT, SPACE_SCRIPT, STYLE};
use crate::figures::MethodFigures;
use crate::measure;
use askama::Template;
use glam::{DVec2, DVec3};
use mindeg::quality::Distribution;
use mindeg::quality::TriangleQuality;
use mindeg_answers::measures::{SHOWN, ShownMetric};
use mindeg_answers::numbers::{Column, count, steady_angle};
use mindeg_mesh::{BoundaryLoop, Positions, TriMesh, Triangles};
use std::collections::BTreeMap;
use std::io::{self, Write};

/// The most triangles in the picture: as many as in a comparison of five meshes.
const MAX_DRAWN: usize = 100_000;

/// The same for a mesh in space.
const MAX_DRAWN_IN_SPACE: usize = 2_000_000;

#[derive(Template)]
#[template(path = "view.html")]
struct Page<'a> {
    title: &'a str,
    provenance: &'a Provenance,
    style: String,
    facts: String,
    figures: Table,
    /// Remarks on the mesh and its picture.
    notes: Vec<String>,
    /// Whether all vertices are on one boundary.
    is_ring: bool,
    is_in_space: bool,
    figure: Figure<'a>,
    measures: Table,
    /// The title of each measure, and what it is.
    explanations: Vec<(&'static str, String)>,
    worst: Vec<Table>,
    data: String,
    script: &'static str,
}

/// Writes a mesh as one self-contained HTML page, in which a reader can view and measure it.
///
/// Vertices with identical coordinates count as one, and only those of triangles are shown.
/// A mesh in space is turned. The page asks for nothing else, and scripts from elsewhere do not run in it. The same mesh
/// gives the same bytes. O(n log n) time, O(n) memory.
///
/// # Errors
///
/// The errors of `out`.
///
/// # Example
///
/// ```
/// use glam::DVec3;
/// use mindeg_compare::{Provenance, write_view};
/// use mindeg_mesh::TriMesh;
///
/// let square = vec![DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y];
/// let mesh = TriMesh::new(square, vec![[0, 1, 2], [0, 2, 3]])?.named("square");
/// let mut page = Vec::new();
/// write_view(&mesh, &Provenance::default(), &mut page)?;
/// assert!(String::from_utf8(page)?.contains("<h1>square</h1>"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write_view(mesh: &TriMesh, provenance: &Provenance, mut out: impl Write) -> io::Result<()> {
    let title = mesh.name().or(provenance.title()).unwrap_or("Mesh");
    let (welded, merged) = welded(mesh)?;
    let positions = welded.positions();
    let triangles = welded.triangles();
    let mut vertices = triangles.as_flattened().to_vec();
    vertices.sort_unstable();
    vertices.dedup();
    let loops = welded.boundary_loops();
    let is_ring = match &loops[..] {
        [ring] => ring.closed && ring.vertices.iter().copied().eq(0..welded.vertex_count()),
        _ => false,
    };
    let points: Vec<DVec2> = positions.iter().map(|position| position.truncate()).collect();
    let is_in_space = !is_flat(positions, &vertices);
    let most_drawn = if is_in_space { MAX_DRAWN_IN_SPACE } else { MAX_DRAWN };

    let quality = |corners: [u32; 3]| {
        let [a, b, c] = corners.map(|vertex| positions[vertex as usize]);
        TriangleQuality::in_space(a, b, c)
    };
    let qualities: Vec<_> = triangles.iter().map(|&corners| quality(corners)).collect();
    let degrees = welded.degrees();
    let used_degrees = vertices.iter().map(|&vertex| degrees[vertex as usize]);
    let figures =
        MethodFigures { valid: true, ..measure::measured(used_degrees, &qualities, triangles) };
    let named = || Named { place: 0, name: title.to_owned(), figures: &figures };
    let data = serde_json::to_string(&picture::picture(&Scene {
        outlines: match is_in_space {
            true => Vec::new(),
            false => outlines(&loops, &points, triangles.len()),
        },
        fills_outlines: !is_in_space,
        is_ring,
        points: &points,
        positions: is_in_space.then_some(positions),
        vertices: vertices.clone(),
        at_least: None,
        most_drawn,
        meshes: vec![(named(), triangles)],
        degrees: vec![degrees.to_vec()],
        quality: &quality,
    }))?;

    let page = Page {
        title,
        provenance,
        style: svg::page_style(&[STYLE]),
        facts: format!(
            "{} vertices · {} triangles",
            count(vertices.len() as u64),
            count(triangles.len() as u64)
        ),
        figures: decisive(&figures, vertices.len(), triangles.len()),
        notes: notes(mesh, merged),
        is_ring,
        is_in_space,
        figure: Figure {
            place: 0,
            name: title.to_owned(),
            advised: None,
            described: described(&figures),
            defects: Vec::new(),
            thinned: thinned(triangles.len(), most_drawn),
            has_triangles: true,
            commands: Vec::new(),
        },
        measures: measures(&figures),
        explanations: SHOWN.iter().map(|shown| (shown.title, shown.explanation())).collect(),
        worst: tables::worst(&[named()]),
        data: script_safe(&data),
        script: if is_in_space { SPACE_SCRIPT } else { SCRIPT },
    };
    out.write_all(rendered(&page)?.as_bytes())
}

/// The mesh with every vertex at the position of an earlier one replaced by it, as in an
/// inspection, and how many those are.
fn welded(mesh: &TriMesh) -> io::Result<(TriMesh, u64)> {
    let mut firsts = BTreeMap::new();
    let first = (0_u32..).zip(mesh.positions()).map(|(vertex, &position)| {
        // Adding zero turns -0 into 0, so that equal numbers have equal bits.
        let bits = position.to_array().map(|x| (x + 0.0).to_bits());
        *firsts.entry(bits).or_insert(vertex)
    });
    let first: Vec<u32> = first.collect();
    let triangles = mesh.triangles().iter().map(|corners| corners.map(|v| first[v as usize]));
    let merged = (0..).zip(&first).filter(|&(vertex, &first)| vertex != first).count();
    let welded = TriMesh::new(mesh.positions().to_vec(), triangles.collect());
    Ok((welded.map_err(io::Error::other)?, merged as u64))
}

/// The boundary as lines. Where triangles are thinned out, so are the points of long lines, and
/// short lines are left out.
fn outlines(loops: &[BoundaryLoop], points: &[DVec2], triangles: usize) -> Vec<Vec<DVec2>> {
    let count: usize = loops.iter().map(|boundary| boundary.vertices.len()).sum();
    let step = if triangles > MAX_DRAWN { count.div_ceil(MAX_DRAWN).max(1) } else { 1 };
    let line = |boundary: &BoundaryLoop| {
        let end =
            if boundary.closed { boundary.vertices.first() } else { boundary.vertices.last() };
        // An open line of single steps has its last point already; twice the same does no harm.
        let line = boundary.vertices.iter().step_by(step).chain(end);
        line.map(|&vertex| points[vertex as usize]).collect()
    };
    loops.iter().filter(|boundary| boundary.vertices.len() >= step).map(line).collect()
}

/// The figures under the title.
fn decisive(figures: &MethodFigures, vertices: usize, triangles: usize) -> Table {
    let mut table = tables::decisive("Figures", &[("Value".to_owned(), figures)]);
    let sizes = [("Vertices", vertices), ("Triangles", triangles)];
    let rows = sizes.map(|(name, size)| vec![name.to_owned(), count(size as u64)]);
    table.rows.splice(0..0, rows);
    table
}

fn described(figures: &MethodFigures) -> String {
    let [degree, least] = [figures.max_degree.map(count), figures.min_angle.map(steady_angle)]
        .map(Option::unwrap_or_default);
    format!("maximum degree {degree} · minimum angle {least}")
}

/// Whether all vertices of triangles have one height.
fn is_flat(positions: &[DVec3], vertices: &[u32]) -> bool {
    let mut heights = vertices.iter().map(|&vertex| positions[vertex as usize].z);
    let first = heights.next();
    heights.all(|z| Some(z) == first)
}

fn notes(mesh: &TriMesh, merged: u64) -> Vec<String> {
    let mut notes = Vec::new();
    if merged > 0 {
        notes.push(format!(
            "{} vertices of the file have the coordinates of an earlier one and count as that.",
            count(merged)
        ));
    }
    if mesh.polygons().is_some() {
        notes.push(
            "Quads and larger polygons are shown as the triangles that they are cut into; degrees \
             count the cuts."
                .to_owned(),
        );
    }
    notes
}

/// How each measure is spread, a row for each.
fn measures(figures: &MethodFigures) -> Table {
    let row = |shown: &ShownMetric| {
        let Distribution { min, p01, median, mean, p99, max } = *figures.spread(shown.name)?;
        let values = [min, p01, median, mean, p99, max];
        let column = Column::new(values, 3);
        let numbers = values.map(|value| column.number(value));
        Some([shown.title_with_unit()].into_iter().chain(numbers).collect())
    };
    Table {
        title: "All measures".to_owned(),
        note: String::new(),
        columns: ["Measure", "min", "1%", "median", "mean", "99%", "max"].map(str::to_owned).into(),
        rows: SHOWN.iter().filter_map(row).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The data that the script of a page reads.
    fn data(page: &str) -> serde_json::Value {
        let (_, data) = page.split_once("id=\"data\">").unwrap();
        let (data, _) = data.split_once("</script>").unwrap();
        assert!(!data.contains("NaN") && !data.contains("null,null"), "{data}");
        serde_json::from_str(data).unwrap()
    }

    fn page(mesh: &TriMesh) -> String {
        let mut page = Vec::new();
        write_view(mesh, &Provenance::default(), &mut page).unwrap();
        String::from_utf8(page).unwrap()
    }

    fn mesh(positions: &[[f64; 3]], triangles: &[[u32; 3]]) -> TriMesh {
        let positions = positions.iter().copied().map(DVec3::from).collect();
        TriMesh::new(positions, triangles.to_vec()).unwrap()
    }

    #[test]
    fn any_mesh_has_a_page() {
        let far = 1e300;
        for (positions, triangles) in [
            // Flat, twice the same vertex, far apart.
            (&[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]][..], &[[0, 1, 2]][..]),
            (&[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 0.0, 0.0]], &[[0, 1, 2], [0, 0, 0]]),
            (&[[-far, 0.0, 0.0], [far, 0.0, far], [far, far, 0.0]], &[[0, 1, 2]]),
            // Three triangles at an edge.
            (
                &[[0.0; 3], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]],
                &[[0, 1, 2], [0, 1, 3], [1, 0, 4]],
            ),
        ] {
            let data = data(&page(&mesh(positions, triangles)));
            for metric in data["metrics"].as_array().unwrap() {
                let [low, high] = [0, 1].map(|end| metric["range"][end].as_f64().unwrap());
                assert!(0.0 < low && low < high, "{metric}");
            }
        }
    }

    #[test]
    fn a_flat_triangle_leaves_the_axes_to_the_others() {
        let mut triangles = vec![[0, 1, 2]; 200];
        triangles[7] = [0, 1, 3];
        let corners = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [2.0, 0.0, 0.0]];
        let data = data(&page(&mesh(&corners, &triangles)));
        let angles = &data["metrics"][0];
        assert_eq!(angles["range"], serde_json::json!([22.5, 90.0]), "{angles}");
        assert_eq!(angles["goes_beyond"], serde_json::json!([true, false]));
    }

    #[test]
    fn names_cannot_break_out() {
        let named = mesh(&[[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], &[[0, 1, 2]])
            .named("</script><script>alert(1)</script>");
        assert_eq!(page(&named).matches("</script>").count(), 2);
    }

    #[test]
    fn long_outlines_are_thinned_with_the_triangles() {
        let boundary = |length, closed| BoundaryLoop { vertices: (0..length).collect(), closed };
        let points: Vec<DVec2> = (0..300_000).map(|x| DVec2::new(f64::from(x), 0.0)).collect();
        let loops = [boundary(300_000, true), boundary(4, true), boundary(100_000, false)];
        let lengths =
            |triangles| outlines(&loops, &points, triangles).iter().map(Vec::len).collect();
        let (all, some): (Vec<_>, Vec<_>) = (lengths(MAX_DRAWN), lengths(MAX_DRAWN + 1));
        assert_eq!(all, [300_001, 5, 100_001]);
        // Every fifth, and the last; four are too few.
        assert_eq!(some, [60_001, 20_001]);
        assert_eq!(outlines(&loops, &points, MAX_DRAWN + 1)[1].last(), Some(&points[99_999]));
    }

    #[test]
    fn a_mesh_at_one_height_is_not_in_space() {
        let high = mesh(&[[0.0, 0.0, 5.0], [1.0, 0.0, 5.0], [1.0, 1.0, 5.0]], &[[0, 1, 2]]);
        assert!(data(&page(&high))["positions"].is_null());
        // A vertex of no triangle does not count.
        let flat =
            mesh(&[[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], &[[0, 1, 2]]);
        assert!(data(&page(&flat))["positions"].is_null());
    }

    #[test]
    fn measures_are_those_in_space() {
        // Seen along z it is a right isosceles triangle; in space it is equilateral.
        let tilted = mesh(&[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], &[[0, 1, 2]]);
        let page = page(&tilted);
        assert!(page.contains("minimum angle 60.000°"), "{page}");
        let positions = data(&page)["positions"].as_str().map(str::len);
        // Nine numbers of four bytes.
        assert_eq!(positions, Some(48));
    }

    #[test]
    fn a_vertex_in_the_place_of_another_is_that_one() {
        let corners = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, -0.0, 0.0]];
        let split = mesh(
            &[&corners[..], &[[0.0, 1.0, -0.0], [1.0, 1.0, 0.0]]].concat(),
            &[[0, 1, 2], [3, 5, 4]],
        );
        let (welded, merged) = welded(&split).unwrap();
        assert_eq!((welded.triangles(), merged), (&[[0, 1, 2], [1, 5, 2]][..], 2));
        let page = page(&split);
        assert!(page.contains("4 vertices · 2 triangles") && page.contains("maximum degree 3"));
    }
}
