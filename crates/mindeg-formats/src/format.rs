//! The formats, and which of them a file name asks for.

use std::path::{Path, PathBuf};

use crate::facts::Facts;
use mindeg_mesh::Mesh;

/// Makes the list of formats: each a variant, its summary, and the facts that its module states.
macro_rules! formats {
    ($($(#[$doc:meta])* $format:ident => $facts:path,)*) => {
        /// A file format.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        pub enum Format {
            $($(#[$doc])* $format,)*
        }

        impl Format {
            /// All formats that are written, which are all there are.
            pub const WRITTEN: [Self; [$($facts.name),*].len()] = [$(Self::$format),*];

            pub(crate) const fn facts(self) -> &'static Facts {
                match self {
                    $(Self::$format => &$facts,)*
                }
            }
        }
    };
}

formats! {
    /// Wavefront OBJ.
    Obj => crate::obj::FACTS,
    /// glTF 2.0 in one binary file.
    Glb => crate::gltf::glb::FACTS,
    /// glTF 2.0 as JSON, with a `.bin` beside it.
    Gltf => crate::gltf::FACTS,
    /// A picture.
    Svg => crate::svg::FACTS,
    /// A picture in pixels.
    Png => crate::png::FACTS,
    /// Gmsh's MSH, 4.1 or 2.2.
    Msh => crate::msh::FACTS,
    /// VTK's XML format for unstructured grids.
    Vtu => crate::vtu::FACTS,
    /// VTK's legacy format.
    Vtk => crate::vtk::FACTS,
    /// SU2's native format.
    Su2 => crate::su2::FACTS,
    /// An Abaqus input file.
    Inp => crate::inp::FACTS,
    /// The Stanford polygon format.
    Ply => crate::ply::FACTS,
    /// Stereolithography.
    Stl => crate::stl::FACTS,
    /// The Object File Format of Geomview.
    Off => crate::off::FACTS,
    /// Triangle's `.node`, with an `.ele` and a `.poly` beside it.
    Node => crate::triangle::FACTS,
    /// ADCIRC's `fort.14`.
    Fort14 => crate::fort14::FACTS,
    /// TELEMAC's SELAFIN.
    Slf => crate::slf::FACTS,
    /// NetCDF by the UGRID conventions.
    Ugrid => crate::ugrid::FACTS,
    /// SMS's `.2dm`.
    Sms2dm => crate::sms2dm::FACTS,
    /// Arrays of numpy.
    Npz => crate::npz::FACTS,
    /// Features of GeoJSON.
    GeoJson => crate::geojson::FACTS,
}

impl Format {
    /// All formats that are read.
    pub const READ: [Self; Self::read_count()] = {
        let mut read = [Self::Obj; Self::read_count()];
        let (mut index, mut count) = (0, 0);
        while index < Self::WRITTEN.len() {
            if Self::WRITTEN[index].facts().read.is_some() {
                read[count] = Self::WRITTEN[index];
                count += 1;
            }
            index += 1;
        }
        read
    };

    const fn read_count() -> usize {
        let (mut index, mut count) = (0, 0);
        while index < Self::WRITTEN.len() {
            count += Self::WRITTEN[index].facts().read.is_some() as usize;
            index += 1;
        }
        count
    }

    /// The short name of the format, for options: `obj`, `fort14`.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.facts().name
    }

    /// The usual extension of the format's files.
    #[must_use]
    pub fn extension(self) -> &'static str {
        self.facts().extensions[0]
    }

    /// All extensions that ask for the format, without dots; the first is the usual one.
    #[must_use]
    pub fn extensions(self) -> &'static [&'static str] {
        self.facts().extensions
    }

    /// The name of the format in a sentence.
    #[must_use]
    pub fn description(self) -> &'static str {
        self.facts().description
    }

    /// Whether the mesh has depths and a file of this format leaves them out. O(n) time; pictures have no place for numbers
    /// and leave out nothing.
    #[must_use]
    pub fn leaves_out_depths(self, mesh: &dyn Mesh) -> bool {
        self.facts().leaves_out_depths && mesh.has_depths()
    }

    /// Whether solvers, which need to know the boundary, read the format.
    #[must_use]
    pub fn has_boundary(self) -> bool {
        self.facts().has_boundary
    }

    /// Whether the format holds meshes in the plane alone.
    #[must_use]
    pub fn is_planar(self) -> bool {
        self.facts().in_plane
    }

    /// Whether a file has a place for [how its mesh was made](mindeg_mesh::Triangles::made_by).
    #[must_use]
    pub fn has_remarks(self) -> bool {
        self.facts().has_remarks
    }

    /// Whether the format wants degrees of longitude and latitude where the plane is a projection of them.
    #[must_use]
    pub fn in_degrees(self) -> bool {
        self.facts().in_degrees
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
        Self::WRITTEN.into_iter().find(has_extension)
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
            [own, others @ ..] if self.facts().extensions == [*own] => {
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
        self.facts().library.map(|extension| path.with_extension(extension))
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
        for format in Format::WRITTEN {
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
