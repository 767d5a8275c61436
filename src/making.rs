//! The common steps of all commands that write a mesh: the outputs, the bar, and the summary.

use crate::args::SurfaceArguments;
use crate::bar::Bar;
use crate::browser::show;
use crate::failure::Failure;
use crate::interrupt::{SESSION, clean_up_on_interrupt};
use crate::standard_output::print_json;
use crate::terminal::say;
use mindeg::{Domain, Positions, Progress, Projection, TriMesh};
use mindeg_answers::advice::Advice;
use mindeg_answers::loops::not_in_the_mesh;
use mindeg_files::{Format, Input, Targets};
use mindeg_mesh::{Mesh, Triangles};
use serde::Serialize;
use std::env;
use std::ffi::OsString;
use std::io::{self, IsTerminal};
use std::path::{Path, PathBuf};

/// A mesh on its way to files.
pub(crate) struct Making {
    targets: Targets<'static>,
    bar: Bar,
    /// Sentences on what files have and leave out.
    remarks: Vec<String>,
    quiet: bool,
    json: bool,
    /// The outputs of a recipe, if one is wanted.
    recipe: Option<Vec<PathBuf>>,
    is_shown: bool,
}

impl Making {
    /// To the outputs that are asked for.
    pub(crate) fn new(
        surface: &SurfaceArguments,
        quiet: bool,
        json: bool,
    ) -> Result<Self, Failure> {
        Self::to(&surface.output, surface, quiet, json)
    }

    /// Understands the outputs; from here on an interrupt leaves nothing behind.
    pub(crate) fn to(
        output: &[PathBuf],
        surface: &SurfaceArguments,
        quiet: bool,
        json: bool,
    ) -> Result<Self, Failure> {
        let targets = Targets::new(&SESSION, output, surface.format, surface.options())?;
        if targets.use_standard_output() && json {
            return Err(Failure::input(
                "standard output can take one mesh, or the summary of --json, not both",
            ));
        }
        let recipe = surface.recipe.then(|| output.to_vec());
        if recipe.is_some() {
            targets.expect_recipe()?;
            if surface.output != output {
                return Err(Failure::input(
                    "--recipe is for files that are named; give -o a name without a pattern or folder",
                ));
            }
        }
        // A bar would be in the way of a mesh on the terminal.
        let to_terminal = targets.use_standard_output() && io::stdout().is_terminal();
        clean_up_on_interrupt()?;
        let bar = Bar::new(quiet || to_terminal);
        Ok(Self { targets, bar, remarks: Vec::new(), quiet, json, recipe, is_shown: surface.show })
    }

    /// The plane of the mesh is a projection of degrees: formats in degrees get these.
    pub(crate) fn unproject(&mut self, projection: Option<&Projection>) {
        let formats = self.targets.unproject(projection.copied());
        let projection = projection.filter(|_| !formats.is_empty());
        self.remarks.extend(projection.map(|projection| {
            format!(
                "{} {} degrees of longitude and latitude, from {projection}",
                formats.join(" and "),
                if formats.len() == 1 { "has" } else { "have" }
            )
        }));
    }

    /// Says these sentences in the end.
    pub(crate) fn tell(&mut self, remarks: Vec<String>) {
        self.remarks.extend(remarks);
    }

    /// Says in the end what the files of meshes have and no output will: values at vertices, larger faces, curved edges.
    pub(crate) fn tell_dropped<'m>(&mut self, meshes: impl IntoIterator<Item = &'m TriMesh>) {
        let mut kinds: Vec<&str> = Vec::new();
        for mesh in meshes {
            let larger = mesh.polygons().map(|_| "faces with more than three corners");
            for kind in mesh.dropped().iter().copied().chain(larger) {
                if !kinds.contains(&kind) {
                    kinds.push(kind);
                }
            }
        }
        self.remarks.extend(not_in_the_mesh(&kinds));
    }

    /// Reads a mesh that the command takes; its materials will be those of the outputs.
    pub(crate) fn read(&mut self, path: &Path) -> Result<TriMesh, Failure> {
        let mesh = read_mesh(path, None, &self.bar)?;
        self.expect_materials(mesh.has_materials())?;
        Ok(mesh)
    }

    pub(crate) fn expect_materials(&mut self, has_materials: bool) -> Result<(), Failure> {
        Ok(self.targets.expect_materials(has_materials)?)
    }

    /// Refuses what the formats cannot hold, before there are triangles.
    pub(crate) fn check(
        &mut self,
        positions: &dyn Positions,
        most_triangles: u32,
    ) -> Result<(), Failure> {
        Ok(self.targets.check(positions, most_triangles)?)
    }

    /// Opens the outputs: what cannot be written is refused before the work, which can take minutes.
    pub(crate) fn open(&mut self) -> Result<(), Failure> {
        Ok(self.targets.open()?)
    }

    /// Whether a format among the outputs is to know the boundary.
    pub(crate) fn need_boundary(&self) -> bool {
        self.targets.need_boundary()
    }

    /// Does work, and shows how far it is.
    pub(crate) fn work<T>(&self, work: impl FnOnce(Progress<'_>) -> T) -> T {
        self.bar.work(work)
    }

    /// The bar, for work that tells no progress.
    pub(crate) fn bar(&self) -> &Bar {
        &self.bar
    }

    /// Writes a mesh of the positions and triangles that were checked.
    pub(crate) fn write_checked(self, mesh: &dyn Mesh) -> Result<Made, Failure> {
        self.write_each(|_| mesh)
    }

    /// Checks a mesh and writes it.
    pub(crate) fn write(mut self, mesh: &TriMesh) -> Result<Made, Failure> {
        self.check(mesh, mesh.triangle_count())?;
        self.write_checked(mesh)
    }

    /// Writes the mesh for each format.
    pub(crate) fn write_each<'m>(
        self,
        mesh_for: impl Fn(Format) -> &'m dyn Mesh,
    ) -> Result<Made, Failure> {
        let Self { mut targets, bar, mut remarks, quiet, json, recipe, is_shown } = self;
        if let Some(outputs) = recipe {
            // All that is read was read.
            targets.set_recipe(&SESSION.recipe(&arguments_of_recipe(), &outputs)?);
        }
        let files = targets.files();
        let shown = targets.first_format().filter(|_| is_shown);
        remarks.extend(bar.work(|progress| targets.write(&mesh_for, progress))?);
        if let Some(format) = shown {
            show(mesh_for(format), files.first().map_or("mesh", String::as_str), &bar)?;
        }
        Ok(Made { files, remarks, quiet, json })
    }
}

/// The arguments of this run but for those that reach no byte of a mesh.
fn arguments_of_recipe() -> Vec<OsString> {
    let reaches_no_byte =
        |word: &OsString| ["-q", "--quiet", "--json"].iter().any(|other| word == other);
    env::args_os().skip(1).filter(|word| !reaches_no_byte(word)).collect()
}

/// A mesh that was written.
pub(crate) struct Made {
    files: Vec<String>,
    remarks: Vec<String>,
    quiet: bool,
    json: bool,
}

impl Made {
    /// Says the text and which files were written, and prints the summary where JSON is wanted.
    pub(crate) fn say<T: Serialize>(
        self,
        text: impl FnOnce() -> String,
        summary: impl FnOnce() -> T,
    ) -> Result<(), Failure> {
        if !self.quiet {
            let text = text();
            let lines = (!text.is_empty()).then_some(text).into_iter();
            let lines = lines.chain(self.remarks).chain(wrote(&self.files));
            let lines = lines.collect::<Vec<_>>().join("\n");
            if !lines.is_empty() {
                say(&lines);
            }
        }
        if self.json {
            print_json(&WithFiles { summary: summary(), files: self.files })?;
        }
        Ok(())
    }

    /// The same, and then what to do next, which can take longer to find than the mesh: a program that reads JSON does not
    /// wait for it.
    pub(crate) fn say_and_advise<T: Serialize>(
        self,
        text: impl FnOnce() -> String,
        advice: impl FnOnce() -> Option<String>,
        summary: impl FnOnce() -> T,
    ) -> Result<(), Failure> {
        let is_read = !self.quiet && !self.json;
        self.say(text, summary)?;
        if is_read && let Some(advice) = advice() {
            say(&advice);
        }
        Ok(())
    }
}

/// Which meshes to take of the parts of a domain, with a bar while they are made.
pub(crate) fn advice_on(parts: &[Domain]) -> Advice {
    let bar = Bar::new(false);
    bar.waiting("measuring other meshes", || Advice::for_hint(parts, Progress::NONE))
}

/// A summary and the files that were written.
#[derive(Serialize)]
pub(crate) struct WithFiles<T> {
    #[serde(flatten)]
    pub(crate) summary: T,
    pub(crate) files: Vec<String>,
}

/// The line on the files that were written; `None` for standard output alone.
pub(crate) fn wrote(files: &[String]) -> Option<String> {
    let files: Vec<&str> = files.iter().map(String::as_str).filter(|file| *file != "-").collect();
    (!files.is_empty()).then(|| format!("wrote {}", files.join(", ")))
}

/// Reads the mesh in a file, or on standard input where the path is `-`, and shows how far it is.
pub(crate) fn read_mesh(
    path: &Path,
    format: Option<Format>,
    bar: &Bar,
) -> Result<TriMesh, Failure> {
    Ok(bar.work(|progress| SESSION.mesh(&Input::of(path), format, progress))?)
}
