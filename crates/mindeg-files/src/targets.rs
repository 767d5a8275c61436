//! Where a mesh goes: each output understood, then opened, then written.

use crate::error::{FileError, extension};
use crate::foreign;
use crate::outputs::{Outputs, cannot_write, is_standard_output};
use crate::recipe::Recipe;
use crate::session::Session;
use glam::DVec3;
use mindeg_domain::Projection;
use mindeg_formats::{Format, WriteError, WriteOptions, Writer, extensions};
use mindeg_mesh::{Mesh, Positions, Progress, Written, filled, listed};
use mindeg_outlines::OutlineFormat;
use std::fs;
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

/// The decimals of degrees: nine are a tenth of a millimetre.
const DECIMALS: f64 = 1e9;

/// Of more lines that are left out the names are not told.
const MOST_NAMES: usize = 5;

/// A point of a plane in degrees of longitude and latitude, as the plane was projected and files have it.
#[must_use]
pub fn in_degrees(projection: &Projection, point: DVec3) -> DVec3 {
    let degrees = projection.to_degrees(point.truncate()) * DECIMALS;
    (degrees.map(libm::round) / DECIMALS).extend(point.z)
}

/// Whether a triangle has its corners on more than half of all longitudes: it has a pole inside, or lies where longitudes
/// begin. O(n) time for n triangles.
fn is_folded(mesh: &dyn Mesh, projection: &Projection) -> bool {
    const BLOCK: u32 = 1 << 12;
    let places =
        filled(0..mesh.vertex_count(), DVec3::ZERO, |first, out| mesh.fill_positions(first, out));
    let longitude = |place: &DVec3| projection.to_degrees(place.truncate()).x;
    let longitudes: Vec<f64> = places.iter().map(longitude).collect();
    let count = mesh.triangle_count();
    (0..count).step_by(BLOCK as usize).any(|first| {
        let block = first..first.saturating_add(BLOCK).min(count);
        let triangles = filled(block, [0; 3], |first, out| mesh.fill_triangles(first, out));
        triangles.iter().any(|corners| {
            let [a, b, c] = corners.map(|corner| longitudes[corner as usize]);
            a.max(b).max(c) - a.min(b).min(c) > 180.0
        })
    })
}

/// All outputs of one mesh.
pub struct Targets<'a> {
    session: &'a Session,
    targets: Vec<Target>,
    options: WriteOptions,
    outputs: Outputs<'a>,
    recipe: Option<String>,
    projection: Option<Projection>,
}

/// An output.
struct Target {
    path: PathBuf,
    format: Format,
    /// The format's files, the one that is named first.
    files: Vec<PathBuf>,
    /// The writer of the files, once the positions are checked.
    writer: Option<Writer>,
    /// The streams that the files go to, once they are open.
    out: Vec<Box<dyn Write + Send>>,
}

impl<'a> Targets<'a> {
    /// The outputs at some paths, of which `-` is standard output; `format` is for those whose extension
    /// tells none.
    ///
    /// # Errors
    ///
    /// A name that tells no format, or another one than `format`; an output that is given twice.
    pub fn new(
        session: &'a Session,
        paths: &[PathBuf],
        format: Option<Format>,
        options: WriteOptions,
    ) -> Result<Self, FileError> {
        if let Some(asked) = format
            && let [path, ..] = paths
            && paths.iter().all(|path| Format::of_path(path).is_some_and(|told| told != asked))
        {
            let (path, asked, option) = (path.display(), asked.name(), session.option("format"));
            return Err(FileError::wrong(format!(
                "{path}: the name tells its format, and {option} asks for {asked}; change the name, or leave \
                 out {option}"
            )));
        }
        let target = |path: &PathBuf| Target::new(session, path, format);
        let targets: Vec<Target> = paths.iter().map(target).collect::<Result<_, _>>()?;
        for (number, path) in paths.iter().enumerate() {
            if paths[..number].contains(path) {
                return Err(FileError::wrong(format!("{} is given twice", path.display())));
            }
        }
        if targets.iter().filter(|target| target.is_standard_output()).count() > 1 {
            return Err(FileError::wrong("standard output can take one mesh"));
        }
        let outputs = Outputs::new(session);
        Ok(Self { session, targets, options, outputs, recipe: None, projection: None })
    }

    /// The mesh will have materials: formats with a library of materials beside them get that file,
    /// too, where the output is a file. To be called before the outputs are opened.
    ///
    /// # Errors
    ///
    /// A name that cannot stand in a file.
    pub fn expect_materials(&mut self, has_materials: bool) -> Result<(), FileError> {
        for target in self.targets.iter_mut().filter(|_| has_materials) {
            let is_file = fs::metadata(&target.path).map_or(true, |found| found.is_file());
            let library = target.format.material_library(&target.path);
            target.files.extend(library.filter(|_| is_file && !target.is_standard_output()));
            target.refuse_unnameable()?;
        }
        Ok(())
    }

    /// Refuses outputs that have no place for a [recipe](Self::set_recipe).
    ///
    /// # Errors
    ///
    /// The output, and what to do.
    pub fn expect_recipe(&self) -> Result<(), FileError> {
        match self.targets.iter().find(|target| !target.format.has_remarks()) {
            Some(target) => Err(FileError::wrong(format!(
                "{}: a .{} has no place for a recipe; write another format, or leave out {}",
                target.path.display(),
                target.format.extension(),
                self.session.option("recipe")
            ))),
            None => Ok(()),
        }
    }

    /// The files will say how they were made.
    pub fn set_recipe(&mut self, recipe: &Recipe) {
        self.recipe = Some(recipe.to_string());
    }

    /// The plane of the mesh is a projection of degrees: formats in degrees get these. Gives their names, each once.
    pub fn unproject(&mut self, projection: Option<Projection>) -> Vec<&'static str> {
        self.projection = projection;
        let formats = self.targets.iter().map(|target| target.format);
        let in_degrees = formats.filter(|format| projection.is_some() && format.in_degrees());
        let mut names: Vec<&str> = in_degrees.map(Format::description).collect();
        names.sort_unstable();
        names.dedup();
        names
    }

    /// Whether one of them goes where this process prints.
    #[must_use]
    pub fn use_standard_output(&self) -> bool {
        self.targets.iter().any(Target::is_standard_output)
    }

    /// Refuses what the formats cannot hold, before there are triangles: the cheapest first.
    ///
    /// # Errors
    ///
    /// A mesh that a format cannot hold.
    pub fn check(
        &mut self,
        positions: &dyn Positions,
        triangle_count: u32,
    ) -> Result<(), FileError> {
        let vertex_count = positions.vertex_count();
        for target in &self.targets {
            Writer::check_size(target.format, &self.options, vertex_count, triangle_count)
                .map_err(|error| target.failed(error))?;
        }
        for target in &mut self.targets {
            let writer = Writer::new(target.format, self.options, positions, triangle_count);
            target.writer = Some(writer.map_err(|error| target.failed(error))?);
        }
        Ok(())
    }

    /// Whether one of them is to know the boundary.
    #[must_use]
    pub fn need_boundary(&self) -> bool {
        self.targets.iter().any(|target| target.format.has_boundary())
    }

    /// The names of all files, as the user gave them; `-` for standard output.
    #[must_use]
    pub fn files(&self) -> Vec<String> {
        let files = self.targets.iter().flat_map(|target| &target.files);
        files.map(|path| path.display().to_string()).collect()
    }

    /// The format of the first.
    #[must_use]
    pub fn first_format(&self) -> Option<Format> {
        self.targets.first().map(|target| target.format)
    }

    /// Opens the files.
    ///
    /// # Errors
    ///
    /// The errors of [`Outputs::open`].
    pub fn open(&mut self) -> Result<(), FileError> {
        for target in &mut self.targets {
            // Files get their names in this order: none names another that is not there.
            for file in target.files.iter().rev() {
                if *file != target.path {
                    let (path, beside) = (target.path.display(), file.display());
                    self.session.refuse_input(file).map_err(|error| {
                        FileError::wrong(format!("{path} has {beside} beside it; {error}"))
                    })?;
                }
                let out = self.outputs.open(file)?;
                target.out.insert(0, out);
            }
        }
        Ok(())
    }

    /// Writes a mesh of the positions that were [checked](Self::check) to all of them and gives the files
    /// their names. `mesh_for` gives the mesh for a format. Says what the files leave out, a sentence each.
    ///
    /// # Errors
    ///
    /// The errors of the files. That a reader of standard output did not take all of it is an error of kind
    /// [`ErrorKind::BrokenPipe`]; the other outputs are whole.
    pub fn write<'m>(
        self,
        mesh_for: impl Fn(Format) -> &'m dyn Mesh,
        progress: Progress<'_>,
    ) -> Result<Vec<String>, FileError> {
        let (mut taken, mut left_out) = (Ok(()), Vec::new());
        for target in self.targets {
            let projection = self.projection.filter(|_| target.format.in_degrees());
            if projection.is_some_and(|it| is_folded(mesh_for(target.format), &it)) {
                return Err(FileError::wrong(format!(
                    "{}: degrees fold a mesh around a pole, where longitudes meet; write metres: to a format that has the \
                     plane, such as 2DM or SELAFIN, or keep the domain in JSON and mesh that with {} none",
                    target.path.display(),
                    self.session.option("project")
                )));
            }
            let degrees = projection.map(|projection| move |point| in_degrees(&projection, point));
            let mesh = Written {
                mesh: mesh_for(target.format),
                made_by: self.recipe.as_deref(),
                place: degrees.as_ref().map(|place| place as _),
            };
            let written = target.write(&mesh, progress);
            match written {
                // Nobody reads on, and the other outputs are not for that reader.
                Err(error) if error.kind() == Some(ErrorKind::BrokenPipe) => taken = Err(error),
                told => left_out.extend(told?),
            }
        }
        self.outputs.finish()?;
        taken.map(|()| left_out)
    }
}

impl Session {
    /// Writes a mesh to a file and those beside it, whole or not at all; `format` is for a name whose
    /// extension tells none. Formats in degrees get these if the mesh lies in a projection of degrees.
    ///
    /// # Errors
    ///
    /// A name that tells no format, what the format cannot hold, and files that cannot be written.
    pub fn save(
        &self,
        mesh: &dyn Mesh,
        path: &Path,
        format: Option<Format>,
        options: WriteOptions,
        projection: Option<Projection>,
    ) -> Result<(), FileError> {
        let mut targets = Targets::new(self, &[path.to_path_buf()], format, options)?;
        targets.unproject(projection);
        targets.expect_materials(mesh.groups().iter().any(|group| group.material.is_some()))?;
        targets.check(mesh, mesh.triangle_count())?;
        targets.open()?;
        targets.write(|_| mesh, Progress::NONE).map(|_| ())
    }
}

impl Target {
    fn new(session: &Session, path: &Path, format: Option<Format>) -> Result<Self, FileError> {
        let (shown, option) = (path.display(), session.option("format"));
        let wrong = |problem: String| Err(FileError::wrong(format!("{shown}: {problem}")));
        let told = Format::of_path(path);
        let Some(format) = told.or(format) else {
            let formats = extensions(&Format::WRITTEN);
            return wrong(format!(
                "the name tells no format; end it in {formats}, or give {option}"
            ));
        };
        let other = extension(path);
        let is_foreign = foreign::advice(&other, "").is_some()
            || other == "json"
            || OutlineFormat::of_path(path).is_some();
        if told.is_none() && is_foreign {
            return wrong(format!(
                "mindeg does not write .{other} files; end the name in .{} for what {option} asks for",
                format.extension()
            ));
        }
        let files = format.files(path);
        let target =
            Self { path: path.to_path_buf(), format, files, writer: None, out: Vec::new() };
        if target.files.len() > 1 && target.is_standard_output() {
            return Err(FileError::wrong(format!(
                "a .{} has its {} beside it, so it cannot go to standard output; use another \
                 {option}, such as glb",
                format.extension(),
                target.beside()
            )));
        }
        target.refuse_unnameable()?;
        Ok(target)
    }

    /// Refuses a name that the file would have to give for those beside it, and cannot.
    fn refuse_unnameable(&self) -> Result<(), FileError> {
        if self.files.len() == 1 || self.path.to_str().is_some() {
            return Ok(());
        }
        let (path, beside) = (self.path.display(), self.beside());
        Err(FileError::wrong(format!(
            "{path}: the name is not UTF-8 text, and the file has to name its {beside}; give another name"
        )))
    }

    /// The extensions of the files beside the one that is named.
    fn beside(&self) -> String {
        let extensions = self.files[1..].iter().map(|file| format!(".{}", extension(file)));
        extensions.collect::<Vec<_>>().join(" and ")
    }

    fn is_standard_output(&self) -> bool {
        is_standard_output(&self.path)
    }

    /// Says what the files leave out.
    fn write(mut self, mesh: &dyn Mesh, progress: Progress<'_>) -> Result<Vec<String>, FileError> {
        let mut streams = std::mem::take(&mut self.out);
        let name = |file: &PathBuf| file.file_name().unwrap_or_default().to_string_lossy().into();
        let names: Vec<String> = self.files.iter().map(name).collect();
        let mut files: Vec<(&str, &mut Box<dyn Write + Send>)> =
            names.iter().map(String::as_str).zip(&mut streams).collect();
        let writer = self.writer.as_ref().expect("the formats were checked before");
        let written = writer.write(mesh, &mut files, progress);
        let names = written.map_err(|error| self.failed(error))?;
        let path = self.path.display();
        let lines = if names.len() == 1 { "a line" } else { "lines" };
        let lines = (!names.is_empty()).then(|| {
            let some = listed(names, MOST_NAMES, ", ");
            format!(
                "{path} leaves out {lines} inside, since the format has boundaries alone: {some}"
            )
        });
        let depths = self.format.leaves_out_depths(mesh).then(|| {
            format!("{path} leaves out the depths, since the format has no place for them; those of ocean models have one")
        });
        Ok(lines.into_iter().chain(depths).collect())
    }

    fn failed(&self, error: WriteError) -> FileError {
        match error {
            WriteError::Io(error) => cannot_write(&self.path, &error),
            refusal if self.is_standard_output() => FileError::wrong(refusal.to_string()),
            refusal => FileError::wrong(format!("{}: {refusal}", self.path.display())),
        }
    }
}
