//! Where a mesh goes, and what its files hold besides points and triangles.

use super::values::format_parser;
use clap::Args;
use mindeg_formats::{Format, Plane, SurfaceOptions};
use std::path::PathBuf;

/// The files of a mesh.
#[derive(Debug, Args)]
pub(crate) struct SurfaceArguments {
    /// Where to write, by extension .obj, .glb, .gltf (with its .bin) or .svg; - is standard
    /// output. May be given several times
    #[arg(short, long, value_name = "FILE", required = true)]
    pub(crate) output: Vec<PathBuf>,

    /// The format where the extension does not tell it
    #[arg(long, value_name = "FORMAT", value_parser = format_parser(Format::WRITTEN))]
    pub(crate) format: Option<Format>,

    /// Give each vertex a colour by its degree (OBJ, glTF)
    #[arg(long)]
    pub(crate) degree_colors: bool,

    /// Add each side as a named line (OBJ, glTF); MeshLab cannot open such a .glb or .gltf
    #[arg(long)]
    pub(crate) boundary_lines: bool,

    /// Lay the mesh on the floor, the XZ plane facing +Y, instead of upright in XY (OBJ, glTF)
    #[arg(long)]
    pub(crate) floor: bool,
}

impl SurfaceArguments {
    pub(crate) fn options(&self) -> SurfaceOptions {
        SurfaceOptions {
            degree_colors: self.degree_colors,
            boundary_lines: self.boundary_lines,
            plane: if self.floor { Plane::Floor } else { Plane::Xy },
            ..SurfaceOptions::default()
        }
    }
}
