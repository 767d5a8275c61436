//! Where a mesh goes: each `-o` understood, then opened, then written.

use crate::bar::Bar;
use crate::failure::Failure;
use crate::output::{Outputs, cannot_write, is_standard_output};
use mindeg_formats::{Format, WriteError, WriteOptions, Writer, extensions};
use mindeg_mesh::{Mesh, Positions, Progress};
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

/// Extensions that tell a format, though none that is written: `--format` does not override them.
const OTHERS: [&str; 17] = [
    "vtp", "mesh", "cgns", "bdf", "med", "dae", "fbx", "3mf", "usd", "usdz", "x3d", "dxf", "pdf",
    "html", "json", "xdmf", "e",
];

/// All `-o` of a command that writes one mesh.
pub(crate) struct Targets<'a> {
    targets: Vec<Target<'a>>,
    options: WriteOptions,
}

/// One `-o`.
struct Target<'a> {
    path: &'a Path,
    format: Format,
    /// The format's files, the one that is named first.
    files: Vec<PathBuf>,
    /// What writes them, once the positions have been looked at.
    writer: Option<Writer>,
    /// The streams that the files go to, once they are open.
    out: Vec<Box<dyn Write>>,
}

impl<'a> Targets<'a> {
    /// The outputs at some paths; `format` is for those whose extension tells none.
    /// `prints_json` if a summary takes standard output.
    pub(crate) fn new(
        paths: &'a [PathBuf],
        format: Option<Format>,
        options: WriteOptions,
        prints_json: bool,
    ) -> Result<Self, Failure> {
        let target = |path: &'a PathBuf| Target::new(path, format);
        let targets: Vec<Target<'_>> = paths.iter().map(target).collect::<Result<_, _>>()?;
        let to_standard_output =
            targets.iter().filter(|target| target.is_standard_output()).count();
        if to_standard_output + usize::from(prints_json) > 1 {
            let message = "standard output can take one mesh, or the summary of --json, not both";
            return Err(Failure::Input(message.to_owned()));
        }
        for (number, path) in paths.iter().enumerate() {
            if paths[..number].contains(path) {
                return Err(Failure::Input(format!("-o {} is given twice", path.display())));
            }
        }
        Ok(Self { targets, options })
    }

    /// The mesh will have materials: formats with a library of materials beside them get that file,
    /// too, where the output is a file. To be called before the outputs are opened.
    pub(crate) fn expect_materials(&mut self, has_materials: bool) {
        for target in self.targets.iter_mut().filter(|_| has_materials) {
            let is_file = fs::metadata(target.path).map_or(true, |found| found.is_file());
            let library = target.format.material_library(target.path);
            target.files.extend(library.filter(|_| is_file && !is_standard_output(target.path)));
        }
    }

    /// Whether one of them goes where this process prints.
    pub(crate) fn use_standard_output(&self) -> bool {
        self.targets.iter().any(Target::is_standard_output)
    }

    /// Refuses what the formats cannot hold, before there are triangles: the cheapest first.
    pub(crate) fn check(
        &mut self,
        positions: &dyn Positions,
        triangle_count: u32,
    ) -> Result<(), Failure> {
        let vertex_count = positions.vertex_count();
        for target in &self.targets {
            Writer::check_size(target.format, &self.options, vertex_count, triangle_count)
                .map_err(|error| target.failure(error))?;
        }
        for target in &mut self.targets {
            let writer = Writer::new(target.format, self.options, positions, triangle_count);
            target.writer = Some(writer.map_err(|error| target.failure(error))?);
        }
        Ok(())
    }

    /// Whether one of them is to know the boundary.
    pub(crate) fn need_boundary(&self) -> bool {
        self.targets.iter().any(|target| target.format.has_boundary())
    }

    /// The names of all files, as the user gave them; `-` for standard output.
    pub(crate) fn files(&self) -> Vec<String> {
        let files = self.targets.iter().flat_map(|target| &target.files);
        files.map(|path| path.display().to_string()).collect()
    }

    /// Opens the files.
    pub(crate) fn open(&mut self, outputs: &mut Outputs) -> Result<(), Failure> {
        self.targets.iter_mut().try_for_each(|target| target.open(outputs))
    }

    /// Writes a mesh of the positions that were [checked](Self::check) to all of them, shows how far
    /// that is, and gives the files their names.
    ///
    /// # Errors
    ///
    /// [`Failure::ClosedPipe`] if a reader did not take all of it; the other outputs are whole.
    pub(crate) fn write(self, mesh: &dyn Mesh, outputs: Outputs, bar: &Bar) -> Result<(), Failure> {
        self.write_each(|_| mesh, outputs, bar)
    }

    /// [`write`](Self::write), with a mesh for each format.
    pub(crate) fn write_each<'m>(
        mut self,
        mesh_for: impl Fn(Format) -> &'m dyn Mesh,
        outputs: Outputs,
        bar: &Bar,
    ) -> Result<(), Failure> {
        let mut all_taken = true;
        for target in &mut self.targets {
            match target.write(mesh_for(target.format), bar) {
                // Nobody reads on, and the other outputs are not for that reader.
                Err(Failure::ClosedPipe) => all_taken = false,
                written => written?,
            }
        }
        outputs.finish()?;
        if all_taken { Ok(()) } else { Err(Failure::ClosedPipe) }
    }
}

impl<'a> Target<'a> {
    fn new(path: &'a Path, format: Option<Format>) -> Result<Self, Failure> {
        let Some(format) = Format::of_path(path).or(format) else {
            return Err(Failure::Input(format!(
                "-o {}: the name tells no format; end it in {}, or give --format",
                path.display(),
                extensions(&Format::WRITTEN)
            )));
        };
        let extension = path.extension().map(|name| name.to_string_lossy().to_lowercase());
        if let Some(other) = extension.filter(|name| OTHERS.contains(&name.as_str())) {
            return Err(Failure::Input(format!(
                "-o {}: mindeg does not write .{other} files; end the name in .{} for what \
                 --format asks for",
                path.display(),
                format.extension()
            )));
        }
        let files = format.files(path);
        let target = Self { path, format, files, writer: None, out: Vec::new() };
        if target.files.len() > 1 && target.is_standard_output() {
            let beside: Vec<_> =
                target.files[1..].iter().filter_map(|file| file.extension()).collect();
            return Err(Failure::Input(format!(
                "a .{} has its {} beside it, so it cannot go to standard output; use another \
                 --format, such as glb",
                format.extension(),
                beside
                    .iter()
                    .map(|name| format!(".{}", name.to_string_lossy()))
                    .collect::<Vec<_>>()
                    .join(" and ")
            )));
        }
        Ok(target)
    }

    fn is_standard_output(&self) -> bool {
        is_standard_output(self.path)
    }

    fn open(&mut self, outputs: &mut Outputs) -> Result<(), Failure> {
        // Files get their names in this order: none names another that is not there.
        for path in self.files.iter().rev() {
            self.out.insert(0, outputs.open(path)?);
        }
        Ok(())
    }

    fn writer(&self) -> &Writer {
        self.writer.as_ref().expect("checked before")
    }

    fn write(&mut self, mesh: &dyn Mesh, bar: &Bar) -> Result<(), Failure> {
        let mut streams = std::mem::take(&mut self.out);
        let names: Vec<_> = self
            .files
            .iter()
            .map(|file| file.file_name().unwrap_or_default().to_string_lossy())
            .collect();
        let mut files: Vec<(&str, &mut Box<dyn Write>)> =
            names.iter().map(|name| &**name).zip(&mut streams).collect();
        let callback = bar.callback();
        let progress = Progress::new(&callback);
        self.writer().write(mesh, &mut files, progress).map_err(|error| self.failure(error))
    }

    fn failure(&self, error: WriteError) -> Failure {
        match error {
            WriteError::Io(error) if self.is_standard_output() => {
                Failure::from_standard_output(&error)
            }
            WriteError::Io(error) => cannot_write(self.path, &error),
            refusal if self.is_standard_output() => Failure::Input(refusal.to_string()),
            refusal => Failure::Input(format!("{}: {refusal}", self.path.display())),
        }
    }
}
