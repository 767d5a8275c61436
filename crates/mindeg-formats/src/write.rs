//! Writing a mesh in any format.

use std::io::Write;

use mindeg_mesh::{Mesh, Positions};

use crate::gltf::Stored;
use crate::sections::{self, Section, write_sections};
use crate::{
    Format, WriteError, WriteOptions, fort14, glb, gltf, inp, msh, npz, obj, off, ply, sms2dm, stl,
    su2, svg, triangle, vtk, vtu,
};

/// Writes meshes on some positions in one format.
///
/// It is made before there are triangles, so that what a format cannot hold is refused before a
/// mesh is looked for.
///
/// # Example
///
/// ```
/// use mindeg_formats::{Format, WriteOptions, Writer, obj};
///
/// let mesh = obj::read("v 0 0 0\nv 2 0 0\nv 2 1 0\nf 1 2 3\n".as_bytes())?;
/// let writer = Writer::new(Format::Glb, WriteOptions::default(), &mesh, 1)?;
/// let mut file = Vec::new();
/// writer.write(&mesh, &mut [("plate.glb", &mut file)])?;
/// assert!(file.starts_with(b"glTF"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Writer {
    format: Format,
    options: WriteOptions,
    /// How glTF stores the positions.
    stored: Option<Stored>,
}

impl Writer {
    /// A writer of meshes with these positions and so many triangles.
    ///
    /// # Errors
    ///
    /// What the format cannot hold, as far as that is known before there are triangles: a mesh
    /// that is too large, coordinates beyond 32-bit floats, a mesh in space where the format is
    /// for the plane.
    pub fn new(
        format: Format,
        options: WriteOptions,
        positions: &dyn Positions,
        triangle_count: u32,
    ) -> Result<Self, WriteError> {
        Self::check_size(format, &options, positions.vertex_count(), triangle_count)?;
        let mut stored = None;
        match format {
            Format::Glb | Format::Gltf => {
                stored = Some(Stored::new(positions, options.surface.plane)?);
            }
            Format::Ply => ply::check(positions, &options)?,
            Format::Stl => stl::check(positions, options.surface.plane)?,
            Format::Fort14 => fort14::check(positions)?,
            Format::Node => triangle::check(positions)?,
            Format::Su2 => {
                WriteError::unless_in_plane(format, positions)?;
            }
            _ => {}
        }
        Ok(Self { format, options, stored })
    }

    /// Refuses what a format cannot hold for its size alone. O(1).
    ///
    /// # Errors
    ///
    /// A mesh that is too large, or a format that is not written.
    pub fn check_size(
        format: Format,
        options: &WriteOptions,
        vertex_count: u32,
        triangle_count: u32,
    ) -> Result<(), WriteError> {
        match format {
            Format::Png if cfg!(not(feature = "png")) => {
                Err(WriteError::NotBuilt { format, feature: "png" })
            }
            Format::Svg | Format::Png => svg::check_size(vertex_count),
            Format::Vtk => vtk::check_size(vertex_count),
            Format::Msh => msh::check_size(options, vertex_count, triangle_count),
            Format::Glb => glb::check_size(vertex_count, triangle_count, &options.surface),
            _ => Ok(()),
        }
    }

    /// The format.
    #[must_use]
    pub fn format(&self) -> Format {
        self.format
    }

    /// Writes a mesh to the format's [files](Format::files): each a name and where it goes. An OBJ may
    /// have one more, its [material library](Format::material_library), which it then names. Writes
    /// are large: the files need no buffers around them. The bytes do not depend on the threads.
    ///
    /// # Errors
    ///
    /// Those of the files, and what the format cannot hold.
    ///
    /// # Panics
    ///
    /// If the number of files is not that of the format.
    pub fn write<W: Write>(
        &self,
        mesh: &dyn Mesh,
        files: &mut [(&str, W)],
    ) -> Result<(), WriteError> {
        let library = files.get(1).map(|(name, _)| (*name).to_owned());
        let has_library = self.format == Format::Obj && library.is_some();
        let count = self.format.file_count() + usize::from(has_library);
        assert_eq!(files.len(), count, "as many as Format::files has");
        if let Some(contents) = self.contents(mesh, library.as_deref()) {
            for ((_, out), sections) in files.iter_mut().zip(contents) {
                write_sections(out, &sections)?;
                out.flush()?;
            }
            return Ok(());
        }
        let surface = &self.options.surface;
        match (self.format, &self.stored, files) {
            (Format::Svg, _, [(_, out)]) => svg::write(mesh, out),
            (Format::Glb, Some(stored), [(_, out)]) => {
                glb::write_stored(mesh, stored, surface, out)
            }
            (Format::Gltf, Some(stored), [(_, document), (name, binary)]) => {
                Ok(gltf::write_stored(mesh, stored, surface, name, document, binary)?)
            }
            #[cfg(feature = "png")]
            (Format::Png, _, [(_, out)]) => crate::png::write(mesh, out),
            (Format::Npz, _, [(_, out)]) => Ok(npz::write(mesh, self.options.fields, out)?),
            _ => Err(WriteError::NotWritten(self.format)),
        }
    }

    /// About how many bytes go to each of the format's [files](Format::files), found in a few
    /// milliseconds.
    ///
    /// # Errors
    ///
    /// [`WriteError::TooLargeForGlb`].
    pub fn expected_lens(&self, mesh: &dyn Mesh) -> Result<Vec<u64>, WriteError> {
        if let Some(contents) = self.contents(mesh, None) {
            return Ok(contents.iter().map(|file| sections::estimated_len(file)).collect());
        }
        let surface = &self.options.surface;
        Ok(match (self.format, &self.stored) {
            (Format::Glb, Some(stored)) => vec![glb::file_len(mesh, stored, surface)?],
            (Format::Gltf, Some(stored)) => gltf::file_lens(mesh, stored, surface).into(),
            (Format::Npz, _) => vec![npz::file_len(mesh, self.options.fields)],
            // A picture is small.
            _ => vec![0; self.format.file_count()],
        })
    }

    /// What each of the format's files holds, from front to back, where that is made of sections.
    /// `library` is the name of an OBJ's material library, if it has one.
    fn contents<'a>(
        &'a self,
        mesh: &'a dyn Mesh,
        library: Option<&str>,
    ) -> Option<Vec<Vec<Section<'a>>>> {
        Some(match self.format {
            Format::Obj => {
                let files = obj::sections(mesh, &self.options.surface, library);
                match library {
                    Some(_) => vec![files.object, files.library],
                    None => vec![files.object],
                }
            }
            Format::Msh => vec![msh::sections(mesh, &self.options)],
            Format::Vtu => vec![vtu::sections(mesh, &self.options)],
            Format::Su2 => vec![su2::sections(mesh)],
            Format::Inp => vec![inp::sections(mesh)],
            Format::Vtk => vec![vtk::sections(mesh, &self.options)],
            Format::Ply => vec![ply::sections(mesh, &self.options)],
            Format::Stl => vec![stl::sections(mesh, self.options.surface.plane)],
            Format::Off => vec![off::sections(mesh, self.options.surface.plane)],
            Format::Sms2dm => vec![sms2dm::sections(mesh)],
            Format::Fort14 => vec![fort14::sections(mesh)],
            Format::Node => triangle::sections(mesh).into(),
            _ => return None,
        })
    }
}
