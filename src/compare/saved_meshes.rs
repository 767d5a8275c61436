//! The meshes of a comparison, as files.

use crate::failure::Failure;
use mindeg_compare::Comparison;
use mindeg_files::{Outputs, SurfaceOptions, cannot_write, obj, write_to};
use mindeg_mesh::TriMesh;
use std::fs;
use std::path::{Path, PathBuf};

/// Writes the mesh of every method that gave one as an OBJ into a folder, which is made if need
/// be: each is named after its method. Gives the files.
pub(super) fn save(
    folder: &Path,
    comparison: &Comparison,
    outputs: &mut Outputs<'_>,
) -> Result<Vec<PathBuf>, Failure> {
    fs::create_dir_all(folder).map_err(|error| cannot_write(folder, &error))?;
    let mut files = Vec::new();
    for (method, triangles) in comparison.methods().filter(|(_, list)| !list.is_empty()) {
        let path = folder.join(format!("{}.obj", file_stem(&method.method.to_string())));
        let points =
            comparison.points(method.method).iter().map(|point| point.extend(0.0)).collect();
        let mesh = TriMesh::new(points, triangles.to_vec())
            .map_err(|error| Failure::Input(format!("{}: {error}", method.method)))?
            .named(method.method.to_string());
        let out = outputs.open(&path)?;
        write_to(&path, out, |out| obj::write(&mesh, &SurfaceOptions::default(), out))?;
        files.push(path);
    }
    Ok(files)
}

/// The name of a method as a file's: "Exact, degree 4" becomes "exact-degree-4".
fn file_stem(name: &str) -> String {
    let words = name.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty());
    words.map(str::to_lowercase).collect::<Vec<_>>().join("-")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_methods_become_names_of_files() {
        for (name, stem) in [
            ("mindeg", "mindeg"),
            ("Exact, degree 4", "exact-degree-4"),
            ("Ear clipping", "ear-clipping"),
        ] {
            assert_eq!(file_stem(name), stem);
        }
    }
}
