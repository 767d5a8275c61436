//! Writing a mesh in any format.

use std::io::Write;

use mindeg_mesh::{Mesh, Positions, Progress};

use crate::facts::Job;
use crate::gltf::Stored;
use crate::{Format, WriteError, WriteOptions};

/// Writes meshes on some positions in one format.
///
/// It is made before there are triangles, so that a format refuses positions that it cannot hold before
/// a mesh is looked for.
///
/// # Example
///
/// ```
/// use mindeg_formats::{Format, WriteOptions, Writer, obj};
/// use mindeg_mesh::Progress;
///
/// let mesh = obj::read("v 0 0 0\nv 2 0 0\nv 2 1 0\nf 1 2 3\n".as_bytes())?;
/// let writer = Writer::new(Format::Glb, WriteOptions::default(), &mesh, 1)?;
/// let mut file = Vec::new();
/// writer.write(&mesh, &mut [("plate.glb", &mut file)], Progress::NONE)?;
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
    /// A writer of meshes with these positions and this number of triangles.
    ///
    /// # Errors
    ///
    /// A mesh that the format cannot hold, as far as that is known before there are triangles: one
    /// that is too large, coordinates beyond 32-bit floats, a mesh in space where the format is
    /// for the plane.
    pub fn new(
        format: Format,
        options: WriteOptions,
        positions: &dyn Positions,
        triangle_count: u32,
    ) -> Result<Self, WriteError> {
        Self::check_size(format, &options, positions.vertex_count(), triangle_count)?;
        let facts = format.facts();
        if facts.in_plane {
            WriteError::unless_in_plane(facts.description, positions)?;
        }
        let stored = (facts.check)(positions, &options)?;
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
        let facts = format.facts();
        let vertices = (facts.description, "vertices");
        WriteError::unless_at_most(facts.max_vertices, vertices, vertex_count.into())?;
        (facts.check_size)(options, vertex_count, triangle_count)
    }

    /// The format.
    #[must_use]
    pub fn format(&self) -> Format {
        self.format
    }

    /// Writes a mesh to the format's [files](Format::files): each a name and where it goes. An OBJ may
    /// have one more, its [material library](Format::material_library), which it then names. Writes
    /// are large: the files need no buffers around them. The bytes do not depend on the threads.
    /// `progress` counts the blocks of text formats, MSH, VTU, VTK, PLY, STL and glTF.
    ///
    /// Gives the names of the lines that the files leave out, since they run inside and the format has a place for
    /// boundaries alone: fort.14.
    ///
    /// # Errors
    ///
    /// Errors of the files, another number of files, and what the format cannot hold.
    pub fn write<W: Write + Send>(
        &self,
        mesh: &dyn Mesh,
        files: &mut [(&str, W)],
        progress: Progress<'_>,
    ) -> Result<Vec<String>, WriteError> {
        let facts = self.format.facts();
        let count = self.format.file_count();
        if files.len() != count && (files.len() != count + 1 || facts.library.is_none()) {
            let (found, format) = (files.len(), facts.description);
            let problem = format!("{format} takes {count} files, and there are {found}");
            return Err(WriteError::Refused(problem));
        }
        let files = files.iter_mut().map(|(name, out)| (*name, out as &mut (dyn Write + Send)));
        let mut files: Vec<_> = files.collect();
        let stage = &format!("writing .{}", self.format.extension());
        let (options, stored) = (&self.options, self.stored.as_ref());
        let job = Job { mesh, options, stored, progress, stage };
        (facts.write)(&job, &mut files)
    }
}

/// Writes a mesh in a format that takes one file.
///
/// Most formats take O(n) time, shared by all threads of rayon's current pool, and the memory of some
/// blocks of the file. Writes are large: `out` needs no buffer around it. Decimals are the shortest
/// that read back as the same f64.
///
/// # Errors
///
/// Errors of `out`, and before the first byte what the format cannot hold.
///
/// # Example
///
/// ```
/// use mindeg_formats::{Format, WriteOptions, obj, write};
///
/// let mesh = obj::read("v 0 0 0\nv 2 0 0\nv 2 1 0\nf 1 2 3\n".as_bytes())?;
/// let mut file = Vec::new();
/// write(Format::Off, &mesh, &WriteOptions::default(), &mut file)?;
/// assert!(String::from_utf8(file)?.ends_with("3 1 0\n0 0 0\n2 0 0\n2 1 0\n3 0 1 2\n"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write(
    format: Format,
    mesh: &dyn Mesh,
    options: &WriteOptions,
    out: impl Write + Send,
) -> Result<(), WriteError> {
    let writer = Writer::new(format, *options, mesh, mesh.triangle_count())?;
    writer.write(mesh, &mut [("", out)], Progress::NONE).map(|_| ())
}
