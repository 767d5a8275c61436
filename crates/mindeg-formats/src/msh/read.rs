//! Reading MSH.

pub(super) mod values;

use std::collections::HashMap;
use std::io::Read;

use mindeg_mesh::{NamedVertex, TriMesh};

use super::parts::{end_part, next_part, skip};
use super::periodic::Links;
use super::shapes::{Shape, known_shape};
use super::surfaces::{PhysicalGroups, Surfaces, only_named, physical_name};
use crate::lists::push;
use crate::numbered::Nodes;
use crate::numbers::Numbers;
use crate::runs::{Elements, Polylines};
use crate::scanner::Scanner;
use crate::{MshVersion, ReadError};

/// Reads a mesh from MSH 4.1, or any 2.x, in text or binary of either byte order.
///
/// Triangles and quadrilaterals become faces, those of each surface a group under the name of its
/// physical group; line elements become lines, those of each curve one, under the name of its
/// physical group, else `physical 3` or `curve 3`; points with a name of a physical group become named vertices. Nodes keep the order of the file, also those that
/// no element has. Of elements of higher order the corners are taken; points are counted, volumes
/// are noted.
///
/// O(n log n) time, and memory for the file and the mesh, whatever the file says of its size.
///
/// # Errors
///
/// Errors of the input; other versions; parts that break the format, by line or byte;
/// elements of nodes that the file does not have; a file without faces.
///
/// # Example
///
/// ```
/// use mindeg_formats::msh;
///
/// let file = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 0\n2 1 0 0\n9 0 1 0\n\
///             $EndNodes\n$Elements\n2\n1 1 2 7 7 1 2\n2 2 2 1 1 1 2 9\n$EndElements\n";
/// let mesh = msh::read(file.as_bytes())?;
/// assert_eq!((mesh.triangles(), mesh.segments()), (&[[0, 1, 2]][..], &[[0, 1]][..]));
///
/// let error = msh::read(file.replace("1 2 9\n", "1 2 4\n").as_bytes()).unwrap_err();
/// assert_eq!(error.to_string(), "line 13: node 4 does not exist");
/// # Ok::<(), mindeg_formats::ReadError>(())
/// ```
pub fn read(mut input: impl Read) -> Result<TriMesh, ReadError> {
    let mut file = Vec::new();
    input.read_to_end(&mut file)?;
    contents(&file, Contents::default())?.into_mesh()
}

/// Reads the line elements of an MSH, as [`read()`] does, but that faces are none of the mesh: a line for each
/// curve, without a name where its physical group has none and it is in no group; and the surfaces, by their faces, or by the
/// curves that MSH 4.1 says bound them.
///
/// # Errors
///
/// As [`read()`], but a file may have no faces; surfaces whose curves the file does not have.
pub fn read_lines(mut input: impl Read) -> Result<Polylines, ReadError> {
    let mut file = Vec::new();
    input.read_to_end(&mut file)?;
    let contents = contents(&file, Contents { lines_alone: true, ..Contents::default() })?;
    let has_no_faces = contents.elements.faces.face_count() == 0;
    let mut surfaces = contents.surfaces.outlines(&contents.elements.segments.by_thing())?;
    let line_of = contents.elements.segments.line_of_thing();
    let periodic = contents.periodic.lines(&line_of, contents.nodes.as_ref());
    let positions = contents.nodes.map(|nodes| nodes.positions).unwrap_or_default();
    let file = contents.elements.into_polylines(positions);
    let mut points = contents.points;
    if contents.version == MshVersion::V2 && has_no_faces {
        surfaces.extend(only_named(&contents.physical_names, &file.segments)?);
        // It does not say which points lie in a surface, and which are centers of arcs.
        points.retain(|point| !point.name.is_empty());
    }
    let left_groups = contents.groups.left(&contents.physical_names);
    Ok(Polylines { surfaces, periodic, points, left_groups, ..file })
}

fn contents(file: &[u8], mut contents: Contents) -> Result<Contents, ReadError> {
    let mut scanner = Scanner::new(file);
    let encoding = format(&mut scanner, &mut contents)?;
    loop {
        scanner.encoding = Numbers::Text;
        let Some(name) = next_part(&mut scanner) else { break };
        let start = scanner.offset();
        match name {
            b"PhysicalNames" => contents.take_physical_names(&mut scanner)?,
            b"Entities" if contents.version == MshVersion::V4 => {
                scanner.encoding = encoding;
                contents.surfaces.take_entities(
                    &mut scanner,
                    &contents.physical_names,
                    &mut contents.groups,
                )?;
            }
            b"Nodes" => match contents.version {
                MshVersion::V4 => {
                    scanner.encoding = encoding;
                    contents.take_nodes_4(&mut scanner)?;
                }
                MshVersion::V2 => contents.take_nodes_2(&mut scanner, encoding)?,
            },
            b"Elements" => match contents.version {
                MshVersion::V4 => {
                    scanner.encoding = encoding;
                    contents.take_elements_4(&mut scanner)?;
                }
                MshVersion::V2 => contents.take_elements_2(&mut scanner, encoding)?,
            },
            b"Periodic" => {
                if contents.version == MshVersion::V4 {
                    scanner.encoding = encoding;
                }
                contents.periodic.take(&mut scanner, contents.version)?;
            }
            b"NodeData" if contents.values.as_ref().is_some_and(Vec::is_empty) => {
                contents.take_values(&mut scanner, encoding)?;
            }
            _ => {
                skip(&mut scanner, name, start)?;
                continue;
            }
        }
        end_part(&mut scanner, name)?;
    }
    Ok(contents)
}

/// The contents of the parts read so far.
#[derive(Default)]
struct Contents {
    version: MshVersion,
    /// Whether curves without a physical group have no name.
    lines_alone: bool,
    /// Where it is wanted, the first data with one number at each node, with the tags of the nodes.
    values: Option<Vec<(u64, f64)>>,
    /// By dimension and tag.
    physical_names: HashMap<(i64, i64), String>,
    groups: PhysicalGroups,
    nodes: Option<Nodes>,
    elements: Elements,
    /// The points that are elements; those without a name have an empty one.
    points: Vec<NamedVertex>,
    surfaces: Surfaces,
    periodic: Links,
}

/// Reads up to the end of `$MeshFormat`, and says how numbers are stored.
fn format(scanner: &mut Scanner<'_>, contents: &mut Contents) -> Result<Numbers, ReadError> {
    loop {
        match next_part(scanner) {
            Some(b"MeshFormat") => break,
            Some(name) => skip(scanner, name, scanner.offset())?,
            None => return Err(scanner.problem("$MeshFormat is missing; is it a mesh of Gmsh?")),
        }
    }
    let version: f64 = scanner.parsed("the version", "a number")?;
    contents.version = match version {
        4.1 => MshVersion::V4,
        2.0..3.0 => MshVersion::V2,
        _ => {
            let problem = format!("MSH {version} is not read; save it as 4.1 or 2.2");
            return Err(scanner.problem(problem));
        }
    };
    let kind = scanner.int("the kind of file")?;
    let size = scanner.int("the size of numbers")?;
    if size != 8 {
        return Err(scanner.problem(format!("numbers of {size} bytes are not read, only of 8")));
    }
    scanner.line();
    let encoding =
        match kind {
            0 => Numbers::Text,
            1 => match scanner.take(4, "the byte order")? {
                [1, 0, 0, 0] => Numbers::LittleEndian,
                [0, 0, 0, 1] => Numbers::BigEndian,
                _ => return Err(scanner.problem(
                    "the 4-byte integer 1 after the version is missing; cannot tell the byte order",
                )),
            },
            _ => return Err(scanner.problem(format!("the kind of file is {kind}, not 0 or 1"))),
        };
    end_part(scanner, b"MeshFormat")?;
    Ok(encoding)
}

impl Contents {
    /// Dimension, tag and name in quotation marks, one a line.
    fn take_physical_names(&mut self, scanner: &mut Scanner<'_>) -> Result<(), ReadError> {
        let count = scanner.size("the number of physical names")?;
        for _ in 0..count {
            let dimension = scanner.int("a dimension")?;
            let tag = scanner.int("a physical tag")?;
            let line = scanner.line().unwrap_or_default().trim_ascii();
            let name = line.strip_prefix(b"\"").and_then(|name| name.strip_suffix(b"\""));
            let name = String::from_utf8_lossy(name.unwrap_or(line)).into_owned();
            self.physical_names.insert((dimension, tag), name);
        }
        Ok(())
    }

    fn nodes(&mut self, scanner: &Scanner<'_>) -> Result<&mut Nodes, ReadError> {
        if self.nodes.is_some() {
            return Err(scanner.problem("$Nodes are there twice"));
        }
        Ok(self.nodes.get_or_insert_default())
    }

    fn take_nodes_4(&mut self, scanner: &mut Scanner<'_>) -> Result<(), ReadError> {
        let nodes = self.nodes(scanner)?;
        let blocks = scanner.size("the number of blocks")?;
        for what in ["the number of nodes", "the least tag", "the greatest tag"] {
            scanner.size(what)?;
        }
        for _ in 0..blocks {
            let dimension = scanner.int("the dimension of a block")?;
            scanner.int("the entity of a block")?;
            let is_parametric = scanner.int("whether nodes are parametric")? != 0;
            let count = scanner.size("the number of nodes of a block")?;
            let parameters = if is_parametric { dimension.clamp(0, 3) } else { 0 };
            for _ in 0..count {
                nodes.push_number(scanner.size("the tag of a node")?)?;
            }
            for _ in 0..count {
                push(&mut nodes.positions, scanner.point()?)?;
                for _ in 0..parameters {
                    scanner.double("a parameter of a node")?;
                }
            }
        }
        nodes.sort().map_err(|error| error.or_at(|problem| scanner.problem(problem)))
    }

    fn take_nodes_2(
        &mut self,
        scanner: &mut Scanner<'_>,
        encoding: Numbers,
    ) -> Result<(), ReadError> {
        let nodes = self.nodes(scanner)?;
        let count = scanner.size("the number of nodes")?;
        scanner.line();
        scanner.encoding = encoding;
        for _ in 0..count {
            let tag = scanner.int("the number of a node")?;
            let tag = u64::try_from(tag).map_err(|_| {
                scanner.problem(format!("the number of a node is {tag}; it cannot be negative"))
            })?;
            nodes.push_number(tag)?;
            push(&mut nodes.positions, scanner.point()?)?;
        }
        nodes.sort().map_err(|error| error.or_at(|problem| scanner.problem(problem)))
    }

    fn take_elements_4(&mut self, scanner: &mut Scanner<'_>) -> Result<(), ReadError> {
        let blocks = scanner.size("the number of blocks")?;
        for what in ["the number of elements", "the least tag", "the greatest tag"] {
            scanner.size(what)?;
        }
        for _ in 0..blocks {
            let dimension = scanner.int("the dimension of a block")?;
            let entity = scanner.int("the entity of a block")?;
            let element_type = scanner.int("the type of a block's elements")?;
            let shape = known_shape(scanner, element_type)?;
            let count = scanner.size("the number of elements of a block")?;
            let physical = self.groups.of.get(&(dimension, entity)).copied();
            for _ in 0..count {
                let start = scanner.offset();
                scanner.size("the tag of an element")?;
                self.take_element(scanner, shape, (entity, physical), start, |scanner| {
                    scanner.size("a node of an element")
                })?;
            }
        }
        Ok(())
    }

    fn take_elements_2(
        &mut self,
        scanner: &mut Scanner<'_>,
        encoding: Numbers,
    ) -> Result<(), ReadError> {
        let count = scanner.size("the number of elements")?;
        scanner.line();
        scanner.encoding = encoding;
        let mut left = count;
        while left > 0 {
            // A text has a type for each, bytes one for a block.
            let start = scanner.offset();
            let (element_type, in_block, tags) = if encoding == Numbers::Text {
                scanner.int("the number of an element")?;
                let element_type = scanner.int("the type of an element")?;
                (element_type, 1, scanner.int("the number of tags")?)
            } else {
                let element_type = scanner.int("the type of a block's elements")?;
                let in_block = scanner.int("the number of elements of a block")?;
                (element_type, in_block, scanner.int("the number of tags")?)
            };
            let shape = known_shape(scanner, element_type)?;
            let in_block = u64::try_from(in_block).ok().filter(|&count| 0 < count && count <= left);
            let in_block = in_block.ok_or_else(|| {
                scanner.problem(format!("a block must have 1 to {left} elements"))
            })?;
            for _ in 0..in_block {
                if encoding != Numbers::Text {
                    scanner.int("the number of an element")?;
                }
                // Physical, then elementary; then perhaps partitions.
                let mut known = [None; 2];
                let mut places = known.iter_mut();
                for _ in 0..tags {
                    let tag = scanner.int("a tag of an element")?;
                    if let Some(place) = places.next() {
                        *place = Some(tag);
                    }
                }
                let physical = known[0].filter(|&tag| tag != 0).map(i64::saturating_abs);
                let entity = known[1].or(physical).unwrap_or(0);
                if let Some(physical) = physical {
                    self.groups.add((shape.dimension.into(), entity), physical);
                }
                self.take_element(scanner, shape, (entity, physical), start, |scanner| {
                    let node = scanner.int("a node of an element")?;
                    // A negative one does not exist.
                    Ok(u64::try_from(node).unwrap_or(u64::MAX))
                })?;
            }
            left -= in_block;
        }
        Ok(())
    }

    /// Reads the nodes of an element, which begins at an offset.
    fn take_element(
        &mut self,
        scanner: &mut Scanner<'_>,
        shape: Shape,
        (entity, physical): (i64, Option<i64>),
        start: usize,
        node: impl Fn(&mut Scanner<'_>) -> Result<u64, ReadError>,
    ) -> Result<(), ReadError> {
        let Some(nodes) = &self.nodes else {
            return Err(scanner.problem_at(start, "the elements come before the nodes"));
        };
        self.elements.are_straightened |= (1..shape.nodes).contains(&shape.corners);
        let mut corners = [0; 4];
        for index in 0..shape.nodes {
            let tag = node(scanner)?;
            if let Some(corner) = corners[..shape.corners].get_mut(index) {
                *corner = nodes
                    .index(tag)
                    .ok_or_else(|| scanner.problem(format!("node {tag} does not exist")))?;
            }
        }
        let named =
            physical.map(|tag| physical_name(&self.physical_names, shape.dimension.into(), tag));
        let name = |dimension: i64, kind: &str| match &named {
            Some(name) => name.clone(),
            None if dimension == 1 && !self.lines_alone => format!("{kind} {entity}"),
            None => String::new(),
        };
        match (shape.dimension, &corners[..shape.corners]) {
            (0, &[vertex]) => {
                self.elements.points += 1;
                push(&mut self.points, NamedVertex { name: name(0, "point"), vertex })?;
            }
            (1, &[a, b]) => self.elements.segments.push(entity, [a, b], || name(1, "curve"))?,
            (2, corners) => {
                if self.lines_alone {
                    self.surfaces.add_face(entity, || name(2, "surface"), corners)?;
                }
                self.elements.faces.push(corners)?;
                // Surfaces without a name are one.
                let surface = if physical.is_some() { entity } else { i64::MIN };
                let end = self.elements.faces.triangle_count();
                self.elements.groups.push(surface, end, || name(2, "surface"))?;
            }
            _ => self.elements.volumes += 1,
        }
        Ok(())
    }

    fn into_mesh(self) -> Result<TriMesh, ReadError> {
        let line_of = self.elements.segments.line_of_thing();
        let periodic = self.periodic.lines(&line_of, self.nodes.as_ref());
        let positions = self.nodes.map(|nodes| nodes.positions).unwrap_or_default();
        let mesh = self.elements.into_mesh(positions, "surfaces", "volume elements")?;
        let named = self.points.into_iter().filter(|point| !point.name.is_empty());
        Ok(mesh.with_named_vertices(named.collect())?.with_periodic_lines(periodic)?)
    }
}
