//! The formats, and which of them a file name asks for.

use std::path::Path;

/// A file format.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Wavefront OBJ.
    Obj,
    /// glTF 2.0 in one binary file.
    Glb,
    /// glTF 2.0 as JSON, with a `.bin` beside it.
    Gltf,
    /// A picture.
    Svg,
}

impl Format {
    /// All formats that are written.
    pub const WRITTEN: [Self; 4] = [Self::Obj, Self::Glb, Self::Gltf, Self::Svg];
    /// All formats that are read.
    pub const READ: [Self; 3] = [Self::Obj, Self::Glb, Self::Gltf];

    /// The extension of the format's files, which is also its name.
    #[must_use]
    pub fn extension(self) -> &'static str {
        match self {
            Self::Obj => "obj",
            Self::Glb => "glb",
            Self::Gltf => "gltf",
            Self::Svg => "svg",
        }
    }

    /// What the format is, in a few words.
    #[must_use]
    pub fn description(self) -> &'static str {
        match self {
            Self::Obj => "Wavefront OBJ",
            Self::Glb => "glTF 2.0 in one binary file",
            Self::Gltf => "glTF 2.0 as JSON, with a .bin file beside it",
            Self::Svg => "a picture",
        }
    }

    /// The format that the extension of a file name asks for, in upper or lower case.
    ///
    /// # Example
    ///
    /// ```
    /// use mindeg_formats::Format;
    ///
    /// assert_eq!(Format::of_path("plate.GLB".as_ref()), Some(Format::Glb));
    /// assert_eq!(Format::of_path("plate.txt".as_ref()), None);
    /// ```
    #[must_use]
    pub fn of_path(path: &Path) -> Option<Self> {
        let extension = path.extension()?.to_str()?.to_ascii_lowercase();
        Self::WRITTEN.into_iter().find(|format| format.extension() == extension)
    }
}
