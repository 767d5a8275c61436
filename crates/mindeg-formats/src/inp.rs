//! Abaqus input files, which CalculiX and others read too.
//!
//! Nodes, `S3` elements in an element set for each group, and a node set for each name of lines and vertices, with each node
//! once: readers such as meshio keep the last set of a name alone. Numbers count from 1, and no line of a set has
//! more than 16. Names become labels: a letter first, then letters, digits, `-` and `_`, at most 80.
//!
//! Limits: written, not read. For a plane problem, replace `S3` by `CPS3` or `CPE3`.

use std::collections::HashSet;

use mindeg_mesh::{ByName, Mesh};

use crate::boundary::{MarkedChains, chain_vertices};
use crate::corners::{positions, triangles};
use crate::decimals::Decimals;
use crate::facts::Facts;
use crate::names::{Names, one_line};
use crate::sections::Section;
use crate::{made_by, mesh_name};

/// The most numbers in a line.
const WIDTH: u32 = 16;

/// The longest label is of 80 letters; this leaves some for a number.
const LABEL: usize = 72;

pub(crate) const FACTS: Facts = Facts {
    name: "inp",
    description: "Abaqus input",
    extensions: &["inp"],
    has_boundary: true,
    begins: |text| text.starts_with(b"*"),
    write: |job, files| job.write(files, [sections(job.mesh)]),
    ..Facts::NONE
};

/// The file from front to back.
fn sections(mesh: &dyn Mesh) -> Vec<Section<'_>> {
    let name = mesh_name(mesh);
    let mut sections = vec![
        Section::bytes(format!("*HEADING\n{}\n** {}\n*NODE\n", heading(name), made_by(mesh))),
        Section::new(mesh.vertex_count(), 52, move |range, buffer| {
            let mut axes = [0; 3].map(|_| Decimals::new());
            for (vertex, point) in range.clone().zip(positions(mesh, range)) {
                push_number(vertex, buffer);
                for (decimals, value) in axes.iter_mut().zip(point.to_array()) {
                    buffer.push(b',');
                    decimals.push(value, buffer);
                }
                buffer.push(b'\n');
            }
        }),
    ];
    let mut groups: Vec<_> =
        mesh.groups().iter().map(|group| (group.label(), group.triangles.clone())).collect();
    if groups.is_empty() {
        groups.push((name, 0..mesh.triangle_count()));
    }
    let mut sets = Names::folding_case();
    for (group, of_group) in groups {
        let set = sets.of(if group.is_empty() { name } else { group }, label);
        sections.push(Section::bytes(format!("*ELEMENT, TYPE=S3, ELSET={set}\n")));
        sections.push(Section::of(of_group, 44, move |range, buffer| {
            for (index, triangle) in range.clone().zip(triangles(mesh, range)) {
                push_number(index, buffer);
                for vertex in triangle {
                    buffer.extend_from_slice(b", ");
                    push_number(vertex, buffer);
                }
                buffer.push(b'\n');
            }
        }));
    }
    let mut sets = Names::folding_case();
    for (name, nodes) in node_sets(mesh) {
        let set = sets.of(&name, label);
        sections.push(Section::bytes(format!("*NSET, NSET={set}\n")));
        sections.push(Section::new(nodes.len() as u32, 12, move |range, buffer| {
            for index in range {
                push_number(nodes[index as usize], buffer);
                let is_last = index % WIDTH == WIDTH - 1 || index as usize + 1 == nodes.len();
                buffer.extend_from_slice(if is_last { b"\n" } else { b", " });
            }
        }));
    }
    sections
}

/// The vertices of each name of lines and vertices, each once, along the lines.
fn node_sets(mesh: &dyn Mesh) -> Vec<(String, Vec<u32>)> {
    let MarkedChains { chains, names, .. } = MarkedChains::of(mesh);
    let points = mesh.named_vertices();
    let of_chains = chains.iter().map(|chain| &*names[chain.name as usize]);
    let by_name = ByName::new(of_chains.chain(points.iter().map(|point| &*point.name)));
    let vertices = |item: usize| match chains.get(item) {
        Some(chain) => {
            let all = 0..(chain.segments.len() as u32).saturating_add(1);
            chain_vertices(mesh, chain, all)
        }
        None => vec![points[item - chains.len()].vertex],
    };
    let nodes = |items: Vec<usize>| {
        let mut known = HashSet::new();
        let all = items.into_iter().flat_map(vertices);
        all.filter(|vertex| known.insert(*vertex)).collect()
    };
    let sets = by_name.items().into_iter().map(nodes);
    by_name.names.iter().cloned().zip(sets).collect()
}

/// The number of the node or element with an index.
fn push_number(index: u32, buffer: &mut Vec<u8>) {
    buffer.extend_from_slice(itoa::Buffer::new().format(u64::from(index) + 1).as_bytes());
}

/// A name as the line of a heading: a line that begins with `*` would be a keyword.
fn heading(name: &str) -> String {
    let line = one_line(name);
    let line = line.trim_start();
    if line.starts_with('*') { format!("_{line}") } else { line.to_owned() }
}

/// A name as a label.
fn label(name: &str) -> String {
    let is_kept = |letter: char| letter.is_ascii_alphanumeric() || matches!(letter, '-' | '_');
    let letters = name.chars().map(|letter| if is_kept(letter) { letter } else { '_' });
    let begins = name.starts_with(|letter: char| letter.is_ascii_alphabetic());
    let prefix = if begins { "" } else { "S_" };
    prefix.chars().chain(letters).take(LABEL).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sections::write_sections;

    #[test]
    fn labels_begin_with_a_letter() {
        assert_eq!(label("root rib, 2"), "root_rib__2");
        assert_eq!(label("3"), "S_3");
        assert_eq!(label("Ärmel"), "S__rmel");
        assert_eq!(label(&"a".repeat(100)).len(), LABEL);
    }

    #[test]
    fn a_heading_is_no_keyword() {
        assert_eq!(heading("*NODE"), "_*NODE");
        assert_eq!(heading(" **\n*NODE"), "_** *NODE");
        assert_eq!(heading("plate"), "plate");
    }

    #[test]
    fn sets_of_different_names_are_different() {
        let file = "v 0 0 0\nv 2 0 0\nv 2 1 0\nf 1 2 3\no a,b\nl 1 2\no a b\nl 2 3\no a,b\nl 3 1\n";
        let mesh = crate::obj::read(file.as_bytes()).unwrap();
        let mut file = Vec::new();
        write_sections(&mut file, &sections(&mesh)).unwrap();
        let file = String::from_utf8(file).unwrap();
        let sets: Vec<_> =
            file.lines().filter_map(|line| line.strip_prefix("*NSET, NSET=")).collect();
        assert_eq!(sets, ["a_b", "a_b_2"]);
        assert!(file.contains("=a_b\n1, 2, 3\n*NSET, NSET=a_b_2\n2, 3\n"), "{file}");
    }
}
