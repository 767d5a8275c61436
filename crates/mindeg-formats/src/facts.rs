//! The facts of a format, which its module states in one value. [`Format`](crate::Format) lists them.

use std::io::{self, BufRead, Write};
use std::path::Path;

use mindeg_mesh::{Mesh, Positions, Progress, TriMesh};

use crate::gltf::Stored;
use crate::sections::{Section, block_count, write_counted};
use crate::{ReadError, WriteError, WriteOptions};

/// All that is known of a format. A new one begins with [`Facts::NONE`].
pub(crate) struct Facts {
    /// The short name, for options: `obj`, `fort14`.
    pub(crate) name: &'static str,
    /// The name in a sentence.
    pub(crate) description: &'static str,
    /// The extensions that ask for the format; the first is the usual one.
    pub(crate) extensions: &'static [&'static str],
    /// The extensions of all files that are written, if they are several; the first names the
    /// others, or is the one that people name.
    pub(crate) files: &'static [&'static str],
    /// The extension of a library of materials beside the file.
    pub(crate) library: Option<&'static str>,
    /// Whether solvers, which need to know the boundary, read the format.
    pub(crate) has_boundary: bool,
    /// Whether a file has a place for how its mesh was made.
    pub(crate) has_remarks: bool,
    /// Whether depths are lost in a file, where a reader would look for them.
    pub(crate) leaves_out_depths: bool,
    /// Whether the format wants degrees where the plane is a projection of them.
    pub(crate) in_degrees: bool,
    /// Whether a file begins as this format alone does. Blanks at its start are left out.
    pub(crate) begins: fn(&[u8]) -> bool,
    /// First words that tell the format, in the first line that is not a comment.
    pub(crate) first_words: &'static [&'static str],
    /// Whether a file that is named so is of this format, whatever it looks like.
    pub(crate) fits: fn(&[u8]) -> bool,
    /// The reader, if meshes are read.
    pub(crate) read: Option<fn(Source<'_>) -> Result<TriMesh, ReadError>>,
    /// The most vertices that the format holds.
    pub(crate) max_vertices: u32,
    /// Whether the format is for meshes in the plane.
    pub(crate) in_plane: bool,
    /// Refuses a number of vertices or of triangles that the format cannot hold. O(1).
    pub(crate) check_size: fn(&WriteOptions, u32, u32) -> Result<(), WriteError>,
    /// Refuses positions that the format cannot hold; for glTF also how they are stored.
    pub(crate) check: fn(&dyn Positions, &WriteOptions) -> Result<Option<Stored>, WriteError>,
    /// Writes the files, and gives the names of the lines that they leave out.
    pub(crate) write: fn(&Job<'_>, &mut Files<'_, '_>) -> Result<Vec<String>, WriteError>,
}

/// The most vertices of a format that counts in 32 bits with a sign.
pub(crate) const SIGNED: u32 = i32::MAX as u32;

/// The files of a mesh that is written: each a name and where it goes.
pub(crate) type Files<'n, 'w> = [(&'n str, &'w mut (dyn Write + Send))];

impl Facts {
    /// The facts of a format that is neither read nor told by its content.
    pub(crate) const NONE: Self = Self {
        name: "",
        description: "",
        extensions: &[],
        files: &[],
        library: None,
        has_boundary: false,
        has_remarks: true,
        leaves_out_depths: true,
        in_degrees: false,
        begins: |_| false,
        first_words: &[],
        fits: |_| false,
        read: None,
        max_vertices: u32::MAX,
        in_plane: false,
        check_size: |_, _, _| Ok(()),
        check: |_, _| Ok(None),
        write: |_, _| Ok(Vec::new()),
    };
}

/// A file that is read.
pub(crate) struct Source<'a> {
    pub(crate) name: &'a Path,
    pub(crate) input: &'a mut dyn BufRead,
    /// Gives the content of a file beside this one.
    pub(crate) beside: &'a mut dyn FnMut(&str) -> io::Result<Vec<u8>>,
}

/// A mesh that is written.
pub(crate) struct Job<'a> {
    pub(crate) mesh: &'a dyn Mesh,
    pub(crate) options: &'a WriteOptions,
    /// The result of [`Facts::check`].
    pub(crate) stored: Option<&'a Stored>,
    /// Hears how much is written, under the name of a stage.
    pub(crate) progress: Progress<'a>,
    pub(crate) stage: &'a str,
}

impl Job<'_> {
    /// How glTF stores the positions.
    pub(crate) fn stored(&self) -> &Stored {
        self.stored.expect("the check of glTF has found it")
    }

    /// Writes each file from its sections, which leave out no line.
    pub(crate) fn write<const N: usize>(
        &self,
        files: &mut Files<'_, '_>,
        contents: [Vec<Section<'_>>; N],
    ) -> Result<Vec<String>, WriteError> {
        let total = contents[..files.len()].iter().map(|sections| block_count(sections)).sum();
        let written = self.progress.counter(self.stage, total);
        for ((_, out), sections) in files.iter_mut().zip(contents) {
            write_counted(out, &sections, &written)?;
            out.flush()?;
        }
        Ok(Vec::new())
    }
}
