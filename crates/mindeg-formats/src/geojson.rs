//! GeoJSON, for maps: each triangle a polygon, each line and named vertex a feature of its own.
//!
//! Properties: `region`, the name of a triangle's group; `line` and `kind` of a line; `point`. Numbers are the shortest
//! decimals that read back as the same.
//!
//! Limits: for meshes in the plane, in whatever coordinates the mesh has; RFC 7946 takes degrees of longitude and
//! latitude, which the mesh of a projected domain gets again. Files of many triangles are large: 150 bytes each. Meshes are not read from it.

use std::ops::Range;

use glam::DVec3;
use mindeg_mesh::{Mesh, NamedVertex, filled};

use crate::boundary::{MarkedChain, MarkedChains, chain_vertices};
use crate::corners::{Corners, triangles};
use crate::decimals::Decimals;
use crate::facts::Facts;
use crate::mesh_name;
use crate::sections::Section;
use crate::tables::NamedRuns;

pub(crate) const FACTS: Facts = Facts {
    name: "geojson",
    description: "GeoJSON",
    extensions: &["geojson"],
    in_plane: true,
    in_degrees: true,
    write: |job, files| job.write(files, [sections(job.mesh)]),
    ..Facts::NONE
};

/// About how many bytes a triangle takes.
const TRIANGLE_LEN: u32 = 150;

/// The file from front to back.
fn sections(mesh: &dyn Mesh) -> Vec<Section<'_>> {
    let name = string(mesh_name(mesh));
    let made_by = mesh.made_by().map(|how| format!("\"made_by\":\"{how}\",")).unwrap_or_default();
    let head =
        format!("{{\"type\":\"FeatureCollection\",\"name\":{name},{made_by}\"features\":[\n");
    let mut sections = vec![Section::bytes(head), polygons(mesh)];
    let chains = MarkedChains::of(mesh);
    for chain in chains.chains {
        let line = string(&chains.names[chain.name as usize]);
        let kind = match chain.kind.map(|kind| format!("{kind:?}").to_lowercase()) {
            Some(kind) => format!(",\"kind\":\"{kind}\""),
            None => String::new(),
        };
        sections.push(line_string(mesh, chain, format!("\"line\":{line}{kind}")));
    }
    sections.extend(mesh.named_vertices().iter().map(|point| named_point(mesh, point)));
    sections.push(Section::bytes("\n]}\n"));
    sections
}

fn polygons(mesh: &dyn Mesh) -> Section<'_> {
    let groups = NamedRuns::of_groups(mesh);
    let names: Vec<String> = groups.names.iter().map(|name| string(name)).collect();
    Section::new(mesh.triangle_count(), TRIANGLE_LEN, move |range, buffer| {
        let mut corners = Corners::new(mesh);
        let of_range = range.clone().zip(groups.of(range.clone())).zip(triangles(mesh, range));
        for ((index, group), triangle) in of_range {
            if index > 0 {
                buffer.extend_from_slice(b",\n");
            }
            let name = names.get(group as usize).filter(|name| *name != "\"\"");
            let region = name.map(|name| format!("\"region\":{name}")).unwrap_or_default();
            let [a, b, c] = corners.positions(triangle);
            feature(&region, "Polygon", "[[", &[a, b, c, a], "]]", buffer);
        }
    })
}

fn line_string(mesh: &dyn Mesh, chain: MarkedChain, properties: String) -> Section<'_> {
    let count = chain.segments.len() as u32 + 1;
    Section::new(1, 40_u32.saturating_mul(count), move |_, buffer| {
        let mut corners = Corners::new(mesh);
        let vertices = chain_vertices(mesh, &chain, 0..count);
        let points: Vec<DVec3> = vertices.iter().map(|vertex| corners.position(*vertex)).collect();
        buffer.extend_from_slice(b",\n");
        feature(&properties, "LineString", "[", &points, "]", buffer);
    })
}

fn named_point<'a>(mesh: &'a dyn Mesh, point: &NamedVertex) -> Section<'a> {
    let (name, at): (_, Range<u32>) = (string(&point.name), point.vertex..point.vertex + 1);
    Section::new(1, TRIANGLE_LEN, move |_, buffer| {
        let at = filled(at.clone(), DVec3::ZERO, |first, out| mesh.fill_positions(first, out));
        buffer.extend_from_slice(b",\n");
        feature(&format!("\"point\":{name}"), "Point", "", &at, "", buffer);
    })
}

fn feature(
    properties: &str,
    kind: &str,
    before: &str,
    points: &[DVec3],
    after: &str,
    buffer: &mut Vec<u8>,
) {
    let head = "{\"type\":\"Feature\",\"properties\":{";
    let middle = format!("}},\"geometry\":{{\"type\":\"{kind}\",\"coordinates\":{before}");
    [head, properties, &middle].iter().for_each(|text| buffer.extend_from_slice(text.as_bytes()));
    for (index, point) in points.iter().enumerate() {
        buffer.extend_from_slice(if index > 0 { b",[" } else { b"[" });
        Decimals::default().push_first(point.x, buffer);
        buffer.push(b',');
        Decimals::default().push_first(point.y, buffer);
        buffer.push(b']');
    }
    buffer.extend_from_slice(after.as_bytes());
    buffer.extend_from_slice(b"}}");
}

/// A name as a string of JSON.
fn string(name: &str) -> String {
    serde_json::Value::from(name).to_string()
}
