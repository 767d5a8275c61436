//! Material libraries: the `.mtl` beside an `.obj`. Of a material the diffuse color (`Kd`) and the
//! opacity (`d`, or `Tr`) are read and written.

use std::collections::HashMap;
use std::io;
use std::sync::Arc;

use mindeg_mesh::{Group, Material, Triangles};

use crate::GENERATOR;
use crate::materials::Materials;
use crate::names::{Names, word};

/// The material of faces without one, where others have one: the format cannot say "none".
pub(super) const NONE: &str = "none";

/// The materials of a mesh under the names that an OBJ can hold.
pub(super) struct NamedMaterials {
    materials: Materials,
    names: Vec<String>,
    /// Whether some groups have a material and others have none.
    has_none: bool,
}

impl NamedMaterials {
    pub(super) fn of<T: Triangles + ?Sized>(mesh: &T) -> Self {
        let materials = Materials::of(mesh);
        let has_none = !materials.list.is_empty() && materials.of_group.contains(&None);
        let mut names = Names::default();
        if has_none {
            names.distinct(NONE.to_owned());
        }
        let name = |name: &str| names.distinct(word(name));
        let names = materials.list.iter().map(|material| &*material.name).map(name).collect();
        Self { materials, names, has_none }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.names.is_empty()
    }

    /// The name of the material that a group uses, by the group's index; none in a mesh without
    /// materials.
    pub(super) fn of_group(&self, group: usize) -> Option<&str> {
        match self.materials.of_group.get(group)? {
            Some(index) => Some(&self.names[*index]),
            None => self.has_none.then_some(NONE),
        }
    }

    /// The text of the library.
    pub(super) fn library(&self) -> String {
        let mut text = format!("# {GENERATOR}\n");
        if self.has_none {
            text += &format!("newmtl {NONE}\n");
        }
        for (name, material) in self.names.iter().zip(&self.materials.list) {
            text += &format!("newmtl {name}\n");
            if let Some([red, green, blue, opacity]) = material.color {
                text += &format!("Kd {red} {green} {blue}\nd {opacity}\n");
            }
        }
        text
    }
}

/// The materials that the groups of a file use, as they are read.
#[derive(Default)]
pub(super) struct UsedMaterials {
    names: Vec<String>,
    indices: HashMap<String, usize>,
    /// For each group the index of its material.
    of_group: Vec<Option<usize>>,
    /// The material of the faces to come.
    current: Option<usize>,
}

impl UsedMaterials {
    pub(super) fn is_empty(&self) -> bool {
        self.names.is_empty()
    }

    /// The faces from here on are of this material; of none, if the name is empty. Whether that is
    /// another one than before.
    pub(super) fn take(&mut self, name: String) -> bool {
        let next = self.names.len();
        let index = (!name.is_empty()).then(|| {
            *self.indices.entry(name).or_insert_with_key(|name| {
                self.names.push(name.clone());
                next
            })
        });
        std::mem::replace(&mut self.current, index) != index
    }

    /// A group starts.
    pub(super) fn start_group(&mut self) {
        self.of_group.push(self.current);
    }

    /// The last group, which has no faces yet, is of the present material.
    pub(super) fn change_group(&mut self) {
        self.of_group.pop();
        self.start_group();
    }

    pub(super) fn give_to(self, groups: &mut [Group], colors: &HashMap<String, [f32; 4]>) {
        let material = |name: String| {
            let color = colors.get(&name).copied();
            let is_none = name == NONE && color.is_none();
            (!is_none).then(|| Arc::new(Material { name, color }))
        };
        let materials: Vec<_> = self.names.into_iter().map(material).collect();
        for (group, index) in groups.iter_mut().zip(self.of_group) {
            group.material = index.and_then(|index| materials[index].clone());
        }
    }
}

/// The contents of some libraries.
#[derive(Default)]
pub(super) struct Libraries {
    /// The colors of materials, by name. The first definition of a name counts.
    pub(super) colors: HashMap<String, [f32; 4]>,
    /// The parts that are not read, and why.
    pub(super) notes: Vec<String>,
}

impl Libraries {
    /// Reads what a line `mtllib` names: a file whose name may hold blanks, or several files.
    pub(super) fn read(
        &mut self,
        names: &str,
        mut beside: impl FnMut(&str) -> io::Result<Vec<u8>>,
    ) {
        match beside(names) {
            Err(_) if names.split_ascii_whitespace().nth(1).is_some() => {
                for name in names.split_ascii_whitespace() {
                    let bytes = beside(name);
                    self.take(name, bytes);
                }
            }
            bytes => self.take(names, bytes),
        }
    }

    fn take(&mut self, name: &str, bytes: io::Result<Vec<u8>>) {
        let found = bytes.map_err(|error| error.to_string()).and_then(|bytes| colors(&bytes));
        match found {
            Ok(found) => found.into_iter().for_each(|(name, color)| {
                self.colors.entry(name).or_insert(color);
            }),
            Err(problem) => self.notes.push(format!(
                "the material library {name:?} is not read, so its materials have no colors: {problem}"
            )),
        }
    }
}

/// The colors of the materials in a library, by name. The first definition of a name counts.
fn colors(text: &[u8]) -> Result<HashMap<String, [f32; 4]>, String> {
    let mut colors = HashMap::new();
    let mut material = Definition::default();
    for (line, number) in text.split(|&byte| byte == b'\n' || byte == b'\r').zip(1..) {
        let line = String::from_utf8_lossy(line);
        let mut words = line.split_ascii_whitespace();
        let keyword = words.next().unwrap_or_default();
        let values = || -> Result<Vec<f32>, String> {
            let number_of = |word: &str| word.parse().ok().filter(|value: &f32| value.is_finite());
            let values = words.filter(|word| *word != "-halo").map(number_of);
            let values: Option<Vec<f32>> = values.collect();
            values
                .filter(|values| !values.is_empty())
                .ok_or_else(|| format!("line {number}: {keyword} has no numbers: {}", line.trim()))
        };
        match keyword {
            "newmtl" => {
                material.end(&mut colors);
                let name = line.trim_start().strip_prefix("newmtl").unwrap_or_default().trim();
                material = Definition { name: name.to_owned(), ..Definition::default() };
            }
            // Spectral and XYZ colors are not read.
            "Kd" if !line.contains("spectral") && !line.contains("xyz") => {
                let values = values()?;
                let channel = |i: usize| values.get(i).copied().unwrap_or(values[0]);
                material.diffuse = Some([0, 1, 2].map(channel));
            }
            "d" => material.opacity = Some(values()?[0]),
            "Tr" => material.transparency = Some(values()?[0]),
            _ => {}
        }
    }
    material.end(&mut colors);
    Ok(colors)
}

/// A material of a library.
#[derive(Default)]
struct Definition {
    name: String,
    diffuse: Option<[f32; 3]>,
    opacity: Option<f32>,
    transparency: Option<f32>,
}

impl Definition {
    fn end(&self, colors: &mut HashMap<String, [f32; 4]>) {
        let Some([red, green, blue]) = self.diffuse else { return };
        let opacity = self.opacity.or(self.transparency.map(|value| 1.0 - value)).unwrap_or(1.0);
        let color = [red, green, blue, opacity].map(|value| value.clamp(0.0, 1.0));
        colors.entry(self.name.clone()).or_insert(color);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn libraries_give_colors() {
        let text = "# a comment\nnewmtl blue steel\nNs 250\nKd 0.1 0.2 0.8\r\nd 0.5\nnewmtl glass\n\
                    Tr 0.75\nKd 1\nnewmtl odd\nKd spectral file.rfl 1\nnewmtl glass\nKd 0 0 0\n";
        let colors = colors(text.as_bytes()).unwrap();
        assert_eq!(colors["blue steel"], [0.1, 0.2, 0.8, 0.5]);
        assert_eq!(colors["glass"], [1.0, 1.0, 1.0, 0.25]);
        assert_eq!(colors.len(), 2);
    }

    #[test]
    fn a_bad_number_is_named() {
        let error = colors(b"newmtl a\nKd red").unwrap_err();
        assert_eq!(error, "line 2: Kd has no numbers: Kd red");
        assert!(colors(b"newmtl a\nd").is_err());
    }
}
