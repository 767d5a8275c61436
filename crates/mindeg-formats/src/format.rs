//! The formats, and which of them a file name asks for.

use std::path::{Path, PathBuf};

/// A file format.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Format {
    /// Wavefront OBJ.
    Obj,
    /// glTF 2.0 in one binary file.
    Glb,
    /// glTF 2.0 as JSON, with a `.bin` beside it.
    Gltf,
    /// A picture.
    Svg,
    /// A picture in pixels.
    Png,
    /// Gmsh's MSH, 4.1 or 2.2.
    Msh,
    /// VTK's XML format for unstructured grids.
    Vtu,
    /// VTK's legacy format.
    Vtk,
    /// SU2's native format.
    Su2,
    /// An Abaqus input file.
    Inp,
    /// The Stanford polygon format.
    Ply,
    /// Stereolithography.
    Stl,
    /// The Object File Format of Geomview.
    Off,
    /// Triangle's `.node`, with an `.ele` and a `.poly` beside it.
    Node,
    /// ADCIRC's `fort.14`.
    Fort14,
    /// SMS's `.2dm`.
    Sms2dm,
    /// Arrays of numpy.
    Npz,
}

/// What is known of a format.
struct Facts {
    name: &'static str,
    description: &'static str,
    /// The first is the usual one.
    extensions: &'static [&'static str],
    /// The extensions of all files that are written, if they are several; the first names the
    /// others, or is the one that people name.
    files: &'static [&'static str],
}

impl Format {
    /// All formats that are written.
    pub const WRITTEN: [Self; 17] = [
        Self::Obj,
        Self::Glb,
        Self::Gltf,
        Self::Svg,
        Self::Png,
        Self::Msh,
        Self::Vtu,
        Self::Vtk,
        Self::Su2,
        Self::Inp,
        Self::Ply,
        Self::Stl,
        Self::Off,
        Self::Node,
        Self::Fort14,
        Self::Sms2dm,
        Self::Npz,
    ];

    /// All formats that are read.
    pub const READ: [Self; 13] = [
        Self::Obj,
        Self::Glb,
        Self::Gltf,
        Self::Msh,
        Self::Vtu,
        Self::Vtk,
        Self::Ply,
        Self::Stl,
        Self::Off,
        Self::Node,
        Self::Fort14,
        Self::Sms2dm,
        Self::Npz,
    ];

    #[rustfmt::skip]
    const fn facts(self) -> Facts {
        const fn facts(
            name: &'static str,
            description: &'static str,
            extensions: &'static [&'static str],
            files: &'static [&'static str],
        ) -> Facts {
            Facts { name, description, extensions, files }
        }
        match self {
            Self::Obj => facts("obj", "Wavefront OBJ", &["obj"], &[]),
            Self::Glb => facts("glb", "glTF 2.0 in one binary file", &["glb"], &[]),
            Self::Gltf => facts("gltf", "glTF 2.0 as JSON, with a .bin file beside it", &["gltf"], &["gltf", "bin"]),
            Self::Svg => facts("svg", "a picture", &["svg"], &[]),
            Self::Png => facts("png", "a picture in pixels", &["png"], &[]),
            Self::Msh => facts("msh", "Gmsh MSH", &["msh"], &[]),
            Self::Vtu => facts("vtu", "VTK's XML unstructured grid", &["vtu"], &[]),
            Self::Vtk => facts("vtk", "legacy VTK", &["vtk"], &[]),
            Self::Su2 => facts("su2", "SU2", &["su2"], &[]),
            Self::Inp => facts("inp", "Abaqus input", &["inp"], &[]),
            Self::Ply => facts("ply", "Stanford PLY", &["ply"], &[]),
            Self::Stl => facts("stl", "stereolithography STL", &["stl"], &[]),
            Self::Off => facts("off", "Object File Format", &["off"], &[]),
            Self::Node => facts("node", "Triangle's .node, with .ele and .poly beside it", &["node", "ele", "poly"], &["node", "ele", "poly"]),
            Self::Fort14 => facts("fort14", "ADCIRC fort.14", &["14", "grd"], &[]),
            Self::Sms2dm => facts("2dm", "SMS .2dm", &["2dm"], &[]),
            Self::Npz => facts("npz", "arrays of numpy", &["npz"], &[]),
        }
    }

    /// The short name of the format, as options have it: `obj`, `fort14`.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.facts().name
    }

    /// The usual extension of the format's files.
    #[must_use]
    pub fn extension(self) -> &'static str {
        self.facts().extensions[0]
    }

    /// What the format is, in a few words.
    #[must_use]
    pub fn description(self) -> &'static str {
        self.facts().description
    }

    /// Whether the format is for solvers, which need to know the boundary.
    #[must_use]
    pub fn has_boundary(self) -> bool {
        matches!(self, Self::Msh | Self::Su2 | Self::Inp | Self::Node | Self::Fort14 | Self::Sms2dm)
    }

    /// The format that the extension of a file name asks for, in upper or lower case.
    ///
    /// # Example
    ///
    /// ```
    /// use mindeg_formats::Format;
    ///
    /// assert_eq!(Format::of_path("plate.GLB".as_ref()), Some(Format::Glb));
    /// assert_eq!(Format::of_path("fort.14".as_ref()), Some(Format::Fort14));
    /// assert_eq!(Format::of_path("plate.txt".as_ref()), None);
    /// ```
    #[must_use]
    pub fn of_path(path: &Path) -> Option<Self> {
        let extension = path.extension()?.to_str()?.to_ascii_lowercase();
        let has_extension = |format: &Self| format.facts().extensions.contains(&&*extension);
        Self::WRITTEN.into_iter().chain(Self::READ).find(has_extension)
    }

    /// All files that a mesh at `path` takes: the one that `path` names, then those beside it.
    ///
    /// # Example
    ///
    /// ```
    /// use mindeg_formats::Format;
    ///
    /// let files = Format::Gltf.files("plate.gltf".as_ref());
    /// assert_eq!(files, ["plate.gltf", "plate.bin"].map(std::path::PathBuf::from));
    /// ```
    #[must_use]
    pub fn files(self, path: &Path) -> Vec<PathBuf> {
        match self.facts().files {
            [] => vec![path.to_path_buf()],
            // The name may be in upper case, or one that the option --format gives a format.
            [_, others @ ..] if self == Self::Gltf => {
                let beside = others.iter().map(|extension| path.with_extension(extension));
                std::iter::once(path.to_path_buf()).chain(beside).collect()
            }
            all => all.iter().map(|extension| path.with_extension(extension)).collect(),
        }
    }

    /// The material library beside the file at `path`, for the formats whose meshes with materials
    /// have one: OBJ.
    ///
    /// # Example
    ///
    /// ```
    /// use mindeg_formats::Format;
    ///
    /// let library = Format::Obj.material_library("plate.obj".as_ref());
    /// assert_eq!(library, Some("plate.mtl".into()));
    /// assert_eq!(Format::Glb.material_library("plate.glb".as_ref()), None);
    /// ```
    #[must_use]
    pub fn material_library(self, path: &Path) -> Option<PathBuf> {
        (self == Self::Obj).then(|| path.with_extension("mtl"))
    }

    /// How many files a mesh takes.
    pub(crate) fn file_count(self) -> usize {
        self.facts().files.len().max(1)
    }
}

/// The extensions of some formats in words: `.obj, .glb or .gltf`.
///
/// # Example
///
/// ```
/// use mindeg_formats::{Format, extensions};
///
/// assert_eq!(extensions(&[Format::Obj, Format::Glb, Format::Fort14]), ".obj, .glb or .14");
/// ```
#[must_use]
pub fn extensions(formats: &[Format]) -> String {
    let dotted: Vec<_> = formats.iter().map(|format| format!(".{}", format.extension())).collect();
    match &dotted[..] {
        [] => String::new(),
        [only] => only.clone(),
        [others @ .., last] => format!("{} or {last}", others.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_and_extensions_tell_formats_apart() {
        let mut names: Vec<_> = Format::WRITTEN.iter().map(|format| format.name()).collect();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), Format::WRITTEN.len());
        for format in Format::WRITTEN.into_iter().chain(Format::READ) {
            for extension in format.facts().extensions {
                let path = format!("a.{}", extension.to_uppercase());
                assert_eq!(Format::of_path(path.as_ref()), Some(format), "{path}");
            }
        }
    }

    #[test]
    fn files_beside_share_the_stem() {
        let files = |format: Format, path: &str| {
            let files = format.files(path.as_ref());
            files.iter().map(|file| file.display().to_string()).collect::<Vec<_>>()
        };
        assert_eq!(files(Format::Msh, "a/b.msh"), ["a/b.msh"]);
        assert_eq!(files(Format::Gltf, "a/b.GLTF"), ["a/b.GLTF", "a/b.bin"]);
        assert_eq!(files(Format::Node, "b.1.ele"), ["b.1.node", "b.1.ele", "b.1.poly"]);
    }
}
