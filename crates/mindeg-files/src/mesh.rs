//! Reading a mesh.

use crate::beside::Beside;
use crate::error::{FileError, extension, plain};
use crate::foreign;
use crate::input::Input;
use crate::kind::{is_domain_name, no_domain};
use crate::session::Session;
use mindeg_formats::{Format, ReadError};
use mindeg_mesh::{Progress, TriMesh};
use std::fs::File;
use std::io::{self, ErrorKind, Read};
use std::path::Path;

/// The stage of progress that counts the bytes of a file that is read.
pub const READING: &str = "reading";

impl Session {
    /// Reads a mesh by the extension of its file or its content. No output may replace the file, or
    /// those beside it that it names, from then on.
    ///
    /// `format` is that of standard input, where the content does not tell it.
    ///
    /// # Errors
    ///
    /// A file that cannot be read, is not a mesh, or names a file outside its folder.
    pub fn mesh(
        &self,
        input: &Input<'_>,
        format: Option<Format>,
        progress: Progress<'_>,
    ) -> Result<TriMesh, FileError> {
        let Input::File(path) = *input else {
            let bytes = self.bytes(input, "mesh")?;
            return self.mesh_of_bytes(input, &bytes, format);
        };
        self.note(path, "mesh");
        let open = || -> Result<Counting<'_>, ReadError> {
            let file = File::open(path)?;
            let total = file.metadata()?.len();
            Ok(Counting { file, done: 0, total, progress })
        };
        let mut beside = Beside::new(self, path, "mesh's data");
        let mesh = open().and_then(|file| {
            mindeg_formats::read(path, file, |name| beside.read(name).map_err(plain))
        });
        mesh.map_err(|error| failed(&input.name(), path, error))
    }

    /// Reads a mesh whose bytes are there; `format`, or else the name or the content, tells the format.
    pub(crate) fn mesh_of_bytes(
        &self,
        input: &Input<'_>,
        bytes: &[u8],
        format: Option<Format>,
    ) -> Result<TriMesh, FileError> {
        let name = input.name();
        if bytes.trim_ascii().is_empty() {
            return Err(FileError::wrong(format!("{name} is empty; a mesh is expected")));
        }
        let told = format;
        let Some(format) = told.or_else(|| Format::of_all(bytes)) else {
            let names: Vec<&str> = Format::READ.into_iter().map(Format::name).collect();
            let (option, names) = (self.option("format"), names.join(", "));
            let problem =
                format!("{name}: the content tells no mesh format; give {option} {names}");
            return Err(FileError::wrong(problem));
        };
        if format == Format::Node && !matches!(input, Input::File(_)) {
            let problem =
                "it looks like Triangle's .node, whose .ele is a second file; give the path of it";
            return Err(FileError::wrong(format!("{name}: {problem}")));
        }
        let path = input.path().unwrap_or(Path::new("-"));
        let mut beside = Beside::new(self, path, "mesh's data");
        let mesh = mindeg_formats::read_as(format, path, bytes, |name| match input {
            Input::File(_) => beside.read(name).map_err(plain),
            alone => Err(io::Error::new(ErrorKind::InvalidInput, alone.alone())),
        });
        mesh.map_err(|error| {
            let error = failed(&name, path, error);
            if told.is_some() { error } else { error.guessed(format, &self.option("format")) }
        })
    }
}

fn failed(name: &str, path: &Path, error: ReadError) -> FileError {
    match error {
        ReadError::Io(error) => FileError::cannot_read(name, &error),
        // A refused name is a mistake in the file that has it.
        ReadError::External { ref source, .. } if source.kind() != ErrorKind::InvalidInput => {
            FileError::system(format!("{name}: {error}"), source.kind())
        }
        error => {
            let advice = || match is_domain_name(path) {
                true => Some(no_domain(name)),
                false => foreign::advice(&extension(path), name),
            };
            let advice = Format::of_path(path).is_none().then(advice).flatten();
            FileError::wrong(format!("{name}: {}", advice.unwrap_or(error.to_string())))
        }
    }
}

/// A file that tells how much of it was read.
struct Counting<'a> {
    file: File,
    done: u64,
    /// The file's length; 0 for a pipe.
    total: u64,
    progress: Progress<'a>,
}

impl Read for Counting<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.file.read(buffer)?;
        self.done += count as u64;
        let report = self.progress.report(READING, self.done, self.total.max(self.done));
        report.map_err(io::Error::other)?;
        Ok(count)
    }
}
