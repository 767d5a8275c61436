//! Where a mesh goes: each `-o` understood, then opened, then written.

use crate::bar::{Bar, Counting, Unit};
use crate::failure::Failure;
use crate::output::{Outputs, cannot_write, is_standard_output};
use mindeg_formats::gltf::Stored;
use mindeg_formats::{Format, SurfaceOptions, WriteError, glb, gltf, obj, svg};
use mindeg_mesh::{Mesh, Positions};
use std::io::Write;
use std::path::{Path, PathBuf};

/// Extensions that tell a format, though none that is written: `--format` does not override them.
const OTHERS: [&str; 24] = [
    "ply", "stl", "off", "vtk", "vtu", "vtp", "msh", "mesh", "su2", "cgns", "inp", "bdf", "med",
    "dae", "fbx", "3mf", "usd", "usdz", "x3d", "dxf", "png", "pdf", "html", "json",
];

/// All `-o` of a command that writes one mesh.
pub(crate) struct Targets<'a> {
    targets: Vec<Target<'a>>,
    options: SurfaceOptions,
    /// How glTF stores the positions, once they have been looked at.
    stored: Option<Stored>,
}

/// One `-o`.
struct Target<'a> {
    path: &'a Path,
    format: Format,
    /// The streams that the format's files go to, once they are open: for a `.gltf` the document
    /// and the binary.
    out: Vec<Box<dyn Write>>,
}

impl<'a> Targets<'a> {
    /// The outputs at some paths; `format` is for those whose extension tells none.
    /// `prints_json` if a summary takes standard output.
    pub(crate) fn new(
        paths: &'a [PathBuf],
        format: Option<Format>,
        options: SurfaceOptions,
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
        Ok(Self { targets, options, stored: None })
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
            match target.format {
                Format::Glb => glb::check_size(vertex_count, triangle_count, &self.options),
                Format::Svg => svg::check_size(vertex_count),
                Format::Obj | Format::Gltf => Ok(()),
            }
            .map_err(|error| target.failure(error))?;
        }
        let is_gltf = |target: &&Target<'_>| matches!(target.format, Format::Glb | Format::Gltf);
        if let Some(target) = self.targets.iter().find(is_gltf) {
            let stored = Stored::new(positions, self.options.plane);
            self.stored = Some(stored.map_err(|error| target.failure(error))?);
        }
        Ok(())
    }

    /// The names of all files, as the user gave them; `-` for standard output.
    pub(crate) fn files(&self) -> Vec<String> {
        let files = self.targets.iter().flat_map(|target| {
            let binary = (target.format == Format::Gltf).then(|| target.binary());
            [Some(target.path.to_path_buf()), binary].into_iter().flatten()
        });
        files.map(|path| path.display().to_string()).collect()
    }

    /// Opens the files.
    pub(crate) fn open(&mut self, outputs: &mut Outputs) -> Result<(), Failure> {
        self.targets.iter_mut().try_for_each(|target| target.open(outputs))
    }

    /// Writes a mesh of the positions that were [checked](Self::check) to all of them, and lets the
    /// bar count the bytes. Whether all readers took all of it.
    pub(crate) fn write(mut self, mesh: &dyn Mesh, bar: &Bar) -> Result<bool, Failure> {
        let mut writers = Vec::new();
        for target in &mut self.targets {
            let expected = target.expected_lens(mesh, self.stored.as_ref(), &self.options)?;
            writers.push((target, expected));
        }
        let total = writers.iter().flat_map(|(_, expected)| expected).sum();
        bar.stage("writing", total, Unit::Bytes);
        let mut all_taken = true;
        for (target, expected) in writers {
            match target.write(mesh, self.stored.as_ref(), &self.options, &expected, bar) {
                // Nobody reads on, and the other outputs are not for that reader.
                Err(Failure::ClosedPipe) => all_taken = false,
                written => written?,
            }
        }
        Ok(all_taken)
    }
}

impl<'a> Target<'a> {
    fn new(path: &'a Path, format: Option<Format>) -> Result<Self, Failure> {
        let Some(format) = Format::of_path(path).or(format) else {
            return Err(Failure::Input(format!(
                "-o {}: the name tells no format; end it in .obj, .glb, .gltf or .svg, or give \
                 --format",
                path.display()
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
        let target = Self { path, format, out: Vec::new() };
        if format == Format::Gltf && target.is_standard_output() {
            let message = "a .gltf has its .bin beside it, so it cannot go to standard output; \
                           use --format glb";
            return Err(Failure::Input(message.to_owned()));
        }
        Ok(target)
    }

    fn is_standard_output(&self) -> bool {
        is_standard_output(self.path)
    }

    /// The file beside a `.gltf`.
    fn binary(&self) -> PathBuf {
        self.path.with_extension("bin")
    }

    fn open(&mut self, outputs: &mut Outputs) -> Result<(), Failure> {
        // Files get their names in this order: no .gltf names a .bin that is not there.
        let binary = match self.format {
            Format::Gltf => Some(outputs.open(&self.binary())?),
            _ => None,
        };
        self.out = [Some(outputs.open(self.path)?), binary].into_iter().flatten().collect();
        Ok(())
    }

    /// About how many bytes go to each stream.
    fn expected_lens(
        &self,
        mesh: &dyn Mesh,
        stored: Option<&Stored>,
        options: &SurfaceOptions,
    ) -> Result<Vec<u64>, Failure> {
        Ok(match (self.format, stored) {
            (Format::Obj, _) => vec![obj::estimated_len(mesh, options)],
            (Format::Glb, Some(stored)) => {
                let len = glb::file_len(mesh, stored, options);
                vec![len.map_err(|error| self.failure(error))?]
            }
            (Format::Gltf, Some(stored)) => gltf::file_lens(mesh, stored, options).into(),
            // A picture is small.
            (Format::Svg | Format::Glb | Format::Gltf, _) => vec![0],
        })
    }

    fn write(
        &mut self,
        mesh: &dyn Mesh,
        stored: Option<&Stored>,
        options: &SurfaceOptions,
        expected: &[u64],
        bar: &Bar,
    ) -> Result<(), Failure> {
        let beside = self.binary();
        let mut out: Vec<Counting<'_, &mut Box<dyn Write>>> = self
            .out
            .iter_mut()
            .zip(expected)
            .map(|(out, &expected)| bar.counting(out, expected))
            .collect();
        let written = match (self.format, stored, &mut out[..]) {
            (Format::Obj, _, [out]) => obj::write(mesh, options, out).map_err(WriteError::from),
            (Format::Svg, _, [out]) => svg::write(mesh, out),
            (Format::Glb, Some(stored), [out]) => glb::write_stored(mesh, stored, options, out),
            (Format::Gltf, Some(stored), [document, binary]) => {
                let name = beside.file_name().unwrap_or_default().to_string_lossy();
                let written = gltf::write_stored(mesh, stored, options, &name, document, binary);
                written.map_err(WriteError::from)
            }
            _ => unreachable!("checked and opened before"),
        };
        drop(out);
        written.map_err(|error| self.failure(error))
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
