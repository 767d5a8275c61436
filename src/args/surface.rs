//! Where a mesh goes, and what its files hold besides points and triangles.

use super::values::format_parser;
use clap::Args;
use clap::ValueEnum;
use mindeg_files::{Encoding, Format, MeshPlane, MshVersion, SurfaceOptions, WriteOptions};
use std::path::PathBuf;

/// The files of a mesh.
#[derive(Debug, Args)]
#[command(next_help_heading = "Output")]
pub(crate) struct SurfaceArguments {
    /// Where to write: mesh.vtu, mesh.obj, …; the extension tells the format, and mindeg formats lists them. - is
    /// standard output. May be repeated
    #[arg(short, long, value_name = "FILE", required = true)]
    pub(crate) output: Vec<PathBuf>,

    /// Show the mesh in a browser when it is written
    #[arg(long)]
    pub(crate) show: bool,

    /// The format where the extension does not tell it
    #[arg(long, value_name = "FORMAT", value_parser = format_parser(Format::WRITTEN), hide_possible_values = true)]
    pub(crate) format: Option<Format>,

    /// Write text where the format has text and binary (MSH, VTU, VTK)
    #[arg(long)]
    pub(crate) ascii: bool,

    /// Of MSH: 4.1, as Gmsh writes it, or 2.2, which more programs read
    #[arg(long, value_name = "VERSION", default_value = "4.1", hide_possible_values = true)]
    pub(crate) msh_version: MshVersionName,

    /// Write 64-bit coordinates (PLY); Gmsh cannot read such a .ply
    #[arg(long)]
    pub(crate) double: bool,

    /// Leave out degrees, minimum angles and sides as data (MSH, VTU, VTK, NPZ)
    #[arg(long)]
    pub(crate) no_fields: bool,

    /// Give each vertex a color by its degree (OBJ, glTF, PLY)
    #[arg(long)]
    pub(crate) degree_colors: bool,

    /// Add each side as a named line (OBJ, glTF); MeshLab cannot open such a .glb or .gltf
    #[arg(long)]
    pub(crate) boundary_lines: bool,

    /// Say in each file how it was made; mindeg verify --reproduce makes it anew and compares
    #[arg(long)]
    pub(crate) recipe: bool,

    /// Lay the mesh on the floor, the XZ plane facing +Y, instead of upright in XY (OBJ, glTF)
    #[arg(long)]
    pub(crate) floor: bool,
}

impl SurfaceArguments {
    pub(crate) fn options(&self) -> WriteOptions {
        WriteOptions {
            surface: SurfaceOptions {
                degree_colors: self.degree_colors,
                boundary_lines: self.boundary_lines,
                plane: if self.floor { MeshPlane::Floor } else { MeshPlane::Xy },
                ..SurfaceOptions::default()
            },
            encoding: if self.ascii { Encoding::Ascii } else { Encoding::Binary },
            msh_version: match self.msh_version {
                MshVersionName::V4 => MshVersion::V4,
                MshVersionName::V2 => MshVersion::V2,
            },
            double: self.double,
            fields: !self.no_fields,
        }
    }
}

/// A version of MSH by its number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum MshVersionName {
    /// The version that Gmsh writes today
    #[value(name = "4.1")]
    V4,
    /// The version that more programs read
    #[value(name = "2.2")]
    V2,
}
