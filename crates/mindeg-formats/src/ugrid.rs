//! NetCDF by the conventions CF-1.8 and UGRID-1.0: a mesh that xarray, uxarray and models read.
//!
//! The file is classic NetCDF with offsets of 64 bits. Nodes and faces count from 0. Lines are the boundary edges, each
//! with the number of its name (`boundary_id`), groups the numbers of the faces (`face_region`); `flag_meanings`
//! has the names, with underscores for blanks. Depths are positive downwards.
//!
//! Coordinates that are known to be degrees have their names and units by CF.
//!
//! Limits: for meshes in the plane. It is not read.

use mindeg_mesh::{Mesh, filled};

use crate::corners::{positions, segments, triangles};
use crate::facts::Facts;
use crate::names::{one_line, word};
use crate::numbers::Numbers;
use crate::sections::Section;
use crate::tables::NamedRuns;
use crate::{WriteError, made_by, mesh_name};

/// The most bytes of a variable.
const MAX_BYTES: u32 = u32::MAX - 3;
const BIG: Numbers = Numbers::BigEndian;

pub(crate) const FACTS: Facts = Facts {
    name: "ugrid",
    description: "UGRID NetCDF",
    extensions: &["nc"],
    leaves_out_depths: false,
    has_boundary: true,
    in_degrees: true,
    begins: |bytes| matches!(bytes, [b'C', b'D', b'F', 1 | 2 | 5, ..]),
    max_vertices: MAX_BYTES / 8,
    in_plane: true,
    check_size: |_, _, triangles| {
        WriteError::unless_at_most(MAX_BYTES / 12, ("UGRID", "triangles"), triangles.into())
    },
    write: |job, files| job.write(files, [sections(job.mesh)?]),
    ..Facts::NONE
};

/// The value of an attribute.
enum Value {
    Text(String),
    Whole(Vec<i32>),
}

/// An array of the file. Its section has all its bytes.
struct Variable<'a> {
    name: &'static str,
    /// Indices of the file's dimensions.
    dimensions: Vec<u32>,
    attributes: Vec<(&'static str, Value)>,
    is_float: bool,
    values: Section<'a>,
}

/// The dimensions of the file.
const NODE: u32 = 0;
const FACE: u32 = 1;
const THREE: u32 = 2;
const EDGE: u32 = 3;
const TWO: u32 = 4;

/// The file from front to back.
fn sections(mesh: &dyn Mesh) -> Result<Vec<Section<'_>>, WriteError> {
    let edges = mesh.lines().last().map_or(0, |line| line.segments.end);
    WriteError::unless_at_most(MAX_BYTES / 8, ("UGRID", "edges of lines"), edges.into())?;
    let mut dimensions =
        vec![("node", mesh.vertex_count()), ("face", mesh.triangle_count()), ("three", 3)];
    if edges > 0 {
        dimensions.extend([("boundary_edge", edges), ("two", 2)]);
    }
    let variables = variables(mesh, edges);
    let length = header(mesh, &dimensions, &variables, 0).len() as u64;
    let mut all = vec![Section::bytes(header(mesh, &dimensions, &variables, length))];
    all.extend(variables.into_iter().map(|variable| variable.values));
    Ok(all)
}

fn variables(mesh: &dyn Mesh, edges: u32) -> Vec<Variable<'_>> {
    let (vertices, count) = (mesh.vertex_count(), mesh.triangle_count());
    let mut topology = vec![
        ("cf_role", text("mesh_topology")),
        ("topology_dimension", Value::Whole(vec![2])),
        ("node_coordinates", text("node_x node_y")),
        ("face_node_connectivity", text("face_nodes")),
    ];
    if edges > 0 {
        topology.push(("boundary_node_connectivity", text("boundary_nodes")));
    }
    let indices =
        |role: &str| vec![("cf_role", text(role)), ("start_index", Value::Whole(vec![0]))];
    let coordinate = |name, axis: usize, long_name: &str, [degrees, units]: [&str; 2]| {
        let values = move |range| positions(mesh, range).map(move |point| [point[axis]]);
        let attributes = match mesh.is_in_degrees() {
            true => vec![
                ("standard_name", text(degrees)),
                ("long_name", Value::Text(format!("{degrees} of the nodes"))),
                ("units", text(units)),
            ],
            false => vec![("long_name", text(long_name))],
        };
        Variable::floats(name, &[NODE], attributes, BIG.records(0..vertices, values))
    };
    let mut all = vec![
        Variable::whole("mesh2d", &[], topology, BIG.repeated(1, [0_i32])),
        coordinate("node_x", 0, "x of the nodes", ["longitude", "degrees_east"]),
        coordinate("node_y", 1, "y of the nodes", ["latitude", "degrees_north"]),
        Variable::whole("face_nodes", &[FACE, THREE], indices("face_node_connectivity"), {
            BIG.records(0..count, |range| triangles(mesh, range).into_iter())
        }),
    ];
    let groups = NamedRuns::of_groups(mesh);
    if groups.names.iter().any(|name| !name.is_empty()) {
        let attributes = flags(&groups, "face");
        let values = move |range| groups.of(range).map(|group| [group + 1]);
        let values = BIG.records(0..count, values);
        all.push(Variable::whole("face_region", &[FACE], attributes, values));
    }
    if edges > 0 {
        let ends = BIG.records(0..edges, |range| segments(mesh, range).into_iter());
        let attributes = indices("boundary_node_connectivity");
        all.push(Variable::whole("boundary_nodes", &[EDGE, TWO], attributes, ends));
        let lines = NamedRuns::of_lines(mesh);
        let attributes = flags(&lines, "boundary");
        let values = move |range| lines.of(range).map(|line| [line + 1]);
        let values = BIG.records(0..edges, values);
        all.push(Variable::whole("boundary_id", &[EDGE], attributes, values));
    }
    let depths = |range| filled(range, 0.0, |first, out| mesh.fill_depths(first, out));
    if mesh.has_depths() {
        let attributes = vec![
            ("long_name", text("depth")),
            ("positive", text("down")),
            ("units", text("m")),
            ("mesh", text("mesh2d")),
            ("location", text("node")),
        ];
        let values = move |range| depths(range).into_iter().map(|depth| [depth + 0.0]);
        let values = BIG.records(0..vertices, values);
        all.push(Variable::floats("depth", &[NODE], attributes, values));
    }
    all
}

fn text(text: &str) -> Value {
    Value::Text(text.to_owned())
}

/// The names of runs by their numbers from 1.
fn flags(runs: &NamedRuns, location: &str) -> Vec<(&'static str, Value)> {
    let meanings: Vec<String> = runs.names.iter().map(|name| word(name)).collect();
    vec![
        ("flag_values", Value::Whole((1..=meanings.len() as i32).collect())),
        ("flag_meanings", Value::Text(meanings.join(" "))),
        ("mesh", text("mesh2d")),
        ("location", text(location)),
    ]
}

impl<'a> Variable<'a> {
    fn whole(
        name: &'static str,
        dimensions: &[u32],
        attributes: Vec<(&'static str, Value)>,
        values: Section<'a>,
    ) -> Self {
        Self { name, dimensions: dimensions.to_vec(), attributes, is_float: false, values }
    }

    fn floats(
        name: &'static str,
        dimensions: &[u32],
        attributes: Vec<(&'static str, Value)>,
        values: Section<'a>,
    ) -> Self {
        Self { is_float: true, ..Self::whole(name, dimensions, attributes, values) }
    }
}

/// The tags of lists, and the types of values, as classic NetCDF numbers them.
const DIMENSIONS: u32 = 10;
const VARIABLES: u32 = 11;
const ATTRIBUTES: u32 = 12;
const CHAR: u32 = 2;
const INT: u32 = 4;
const DOUBLE: u32 = 6;

/// The head of the file, whose variables follow from `start` on.
fn header(
    mesh: &dyn Mesh,
    dimensions: &[(&str, u32)],
    variables: &[Variable<'_>],
    mut start: u64,
) -> Vec<u8> {
    let mut bytes = b"CDF\x02".to_vec();
    // No dimension grows.
    put(&mut bytes, &[0, DIMENSIONS, dimensions.len() as u32]);
    for (name, length) in dimensions {
        put_name(&mut bytes, name);
        put(&mut bytes, &[*length]);
    }
    let of_file = [
        ("Conventions", text("CF-1.8 UGRID-1.0")),
        ("title", Value::Text(one_line(mesh_name(mesh)))),
        ("source", text(made_by(mesh))),
    ];
    put_attributes(&mut bytes, &of_file);
    put(&mut bytes, &[VARIABLES, variables.len() as u32]);
    for variable in variables {
        let length = variable.values.byte_len();
        put_name(&mut bytes, variable.name);
        put(&mut bytes, &[variable.dimensions.len() as u32]);
        put(&mut bytes, &variable.dimensions);
        put_attributes(&mut bytes, &variable.attributes);
        put(&mut bytes, &[if variable.is_float { DOUBLE } else { INT }, length as u32]);
        bytes.extend_from_slice(&start.to_be_bytes());
        start += length;
    }
    bytes
}

fn put(bytes: &mut Vec<u8>, numbers: &[u32]) {
    numbers.iter().for_each(|number| bytes.extend_from_slice(&number.to_be_bytes()));
}

/// Letters with their number, filled up to whole words of four.
fn put_name(bytes: &mut Vec<u8>, name: &str) {
    put(bytes, &[name.len() as u32]);
    bytes.extend_from_slice(name.as_bytes());
    bytes.resize(bytes.len().next_multiple_of(4), 0);
}

fn put_attributes(bytes: &mut Vec<u8>, attributes: &[(&str, Value)]) {
    put(bytes, &[ATTRIBUTES, attributes.len() as u32]);
    for (name, value) in attributes {
        put_name(bytes, name);
        match value {
            Value::Text(text) => {
                put(bytes, &[CHAR]);
                put_name(bytes, text);
            }
            Value::Whole(numbers) => {
                put(bytes, &[INT, numbers.len() as u32]);
                numbers.iter().for_each(|number| bytes.extend_from_slice(&number.to_be_bytes()));
            }
        }
    }
}
