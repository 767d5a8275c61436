//! Where `mindeg mesh` writes to: each `-o` understood, then prepared, then written.

use crate::args::{Format, MeshArguments};
use crate::bar::{Bar, Counting};
use crate::failure::Failure;
use crate::output::{Outputs, cannot_write};
use mindeg_geometry::export::{ExportError, SurfaceOptions, gltf, obj, svg};
use mindeg_geometry::{Domain, Mesh};
use std::io::{self, Write};
use std::path::Path;

/// An OBJ is refused for want of room only if this share of its estimated length is more than what
/// is free: estimates were found to be off by half a percent at most.
const SURE_PERCENT: u64 = 98;

/// One `-o`, understood.
pub(super) struct Target<'a> {
    path: &'a Path,
    format: Format,
}

/// The outputs that the arguments ask for.
pub(super) fn targets(arguments: &MeshArguments) -> Result<Vec<Target<'_>>, Failure> {
    let target = |path| Target::new(path, arguments.format);
    let targets: Vec<Target<'_>> =
        arguments.output.iter().map(|path| target(path)).collect::<Result<_, _>>()?;
    let to_standard_output = targets.iter().filter(|target| target.is_standard_output()).count();
    if to_standard_output + usize::from(arguments.json) > 1 {
        let message = "standard output can take one mesh, or the summary of --json, not both";
        return Err(Failure::Input(message.to_owned()));
    }
    for (number, path) in arguments.output.iter().enumerate() {
        if arguments.output[..number].contains(path) {
            return Err(Failure::Input(format!("-o {} is given twice", path.display())));
        }
    }
    Ok(targets)
}

impl<'a> Target<'a> {
    fn new(path: &'a Path, format: Option<Format>) -> Result<Self, Failure> {
        let extension =
            path.extension().map(|extension| extension.to_string_lossy().to_lowercase());
        let by_extension = match extension.as_deref() {
            Some("obj") => Some(Format::Obj),
            Some("glb") => Some(Format::Glb),
            Some("gltf") => Some(Format::Gltf),
            Some("svg") => Some(Format::Svg),
            _ => None,
        };
        let Some(format) = by_extension.or(format) else {
            return Err(Failure::Input(format!(
                "-o {}: the name tells no format; end it in .obj, .glb, .gltf or .svg, or say \
                 --format",
                path.display()
            )));
        };
        let target = Self { path, format };
        if format == Format::Gltf && target.is_standard_output() {
            let message = "a .gltf has its .bin beside it, so it cannot go to standard output; \
                           use --format glb";
            return Err(Failure::Input(message.to_owned()));
        }
        Ok(target)
    }

    /// Whether it goes where this process prints.
    pub(super) fn is_standard_output(&self) -> bool {
        ["-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"].map(Path::new).contains(&self.path)
    }

    /// Refuses a domain that has too many vertices for the format. O(1).
    pub(super) fn check(&self, domain: &Domain, options: &SurfaceOptions) -> Result<(), Failure> {
        match self.format {
            Format::Glb => gltf::check_glb_size(domain.boundary(), options),
            Format::Svg => svg::check_size(domain.boundary()),
            Format::Obj | Format::Gltf => Ok(()),
        }
        .map_err(|error| self.failure(error))
    }

    /// Finds out whatever else stands in the way, and opens the output. O(n).
    pub(super) fn prepare(
        self,
        domain: &'a Domain,
        options: &'a SurfaceOptions,
        outputs: &mut Outputs,
    ) -> Result<Prepared<'a>, Failure> {
        let content = match self.format {
            Format::Obj => {
                let estimate = obj::estimated_len(domain, options);
                let least = estimate / 100 * SURE_PERCENT;
                Content::Obj(options, Part { expected: estimate, ..self.open(outputs, least)? })
            }
            Format::Glb => {
                let glb = gltf::Glb::new(domain, options).map_err(|error| self.failure(error))?;
                let part = self.open(outputs, glb.file_len())?;
                Content::Glb(glb, part)
            }
            Format::Gltf => {
                let path = self.path.with_extension("bin");
                let name = path.file_name().unwrap_or_default().to_string_lossy();
                let gltf = gltf::Gltf::new(domain, options, &name);
                let gltf = gltf.map_err(|error| self.failure(error))?;
                let [json_len, binary_len] = gltf.file_lens();
                // Files get their names in this order: no .gltf names a .bin that is not there.
                let binary = Target { path: &path, ..self }.open(outputs, binary_len)?;
                let json = self.open(outputs, json_len)?;
                Content::Gltf(gltf, [json, binary])
            }
            // Small, since there are few vertices.
            Format::Svg => Content::Svg(self.open(outputs, 0)?),
        };
        Ok(Prepared { target: self, content })
    }

    /// Opens the output for `least_len` bytes or more.
    fn open(&self, outputs: &mut Outputs, least_len: u64) -> Result<Part, Failure> {
        let out: Box<dyn Write> = if self.is_standard_output() {
            Box::new(io::stdout())
        } else {
            Box::new(outputs.create(self.path, least_len)?)
        };
        Ok(Part { out, expected: least_len })
    }

    fn failure(&self, error: ExportError) -> Failure {
        match error {
            ExportError::Io(error) if self.is_standard_output() => {
                Failure::from_standard_output(&error)
            }
            ExportError::Io(error) => cannot_write(self.path, &error),
            refusal if self.is_standard_output() => Failure::Input(refusal.to_string()),
            refusal => Failure::Input(format!("{}: {refusal}", self.path.display())),
        }
    }
}

/// An output that nothing is known to stand in the way of.
pub(super) struct Prepared<'a> {
    target: Target<'a>,
    content: Content<'a>,
}

/// What is written, as far as it is known without the mesh, and where to.
enum Content<'a> {
    Obj(&'a SurfaceOptions, Part),
    Glb(gltf::Glb<'a>, Part),
    Gltf(gltf::Gltf<'a>, [Part; 2]),
    Svg(Part),
}

/// A stream of bytes.
struct Part {
    out: Box<dyn Write>,
    /// How many are expected.
    expected: u64,
}

impl Part {
    fn counted<'b>(&'b mut self, bar: &'b Bar) -> Counting<'b, &'b mut dyn Write> {
        bar.counting(&mut *self.out, self.expected)
    }
}

impl Prepared<'_> {
    /// About how many bytes will be written.
    pub(super) fn expected_len(&self) -> u64 {
        match &self.content {
            Content::Obj(_, part) | Content::Glb(_, part) | Content::Svg(part) => part.expected,
            Content::Gltf(_, parts) => parts.iter().map(|part| part.expected).sum(),
        }
    }

    /// Writes the mesh, and lets the bar count the bytes.
    pub(super) fn write(mut self, mesh: &Mesh, bar: &Bar) -> Result<(), Failure> {
        let written = match &mut self.content {
            Content::Obj(options, part) => {
                obj::write(mesh, options, part.counted(bar)).map_err(ExportError::from)
            }
            Content::Glb(glb, part) => {
                glb.write(mesh, part.counted(bar)).map_err(ExportError::from)
            }
            Content::Gltf(gltf, [json, binary]) => {
                let written = gltf.write(mesh, json.counted(bar), binary.counted(bar));
                written.map_err(ExportError::from)
            }
            Content::Svg(part) => svg::write(mesh, part.counted(bar)),
        };
        written.map_err(|error| self.target.failure(error))
    }
}
