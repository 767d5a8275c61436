//! The arguments as they are typed.

use crate::gates::Gates;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::{Args, Parser, Subcommand, ValueEnum};
use mindeg::Spacing;
use mindeg_formats::{Format, Plane, SurfaceOptions};
use std::path::PathBuf;

const EXIT_CODES: &str = "\
Exit codes:
  0  success (also when the reader of standard output stops early)
  1  something could not be read or written, or does not fit where it is to go
  2  bad input: wrong usage, a domain that is no convex polygon, counts out of range, caps that
     cannot be kept, a broken file
  3  a mesh fails --max-degree or --min-angle";

/// Mesh a rectangle or convex polygon from its boundary points alone, with the least possible
/// maximum degree.
#[derive(Debug, Parser)]
#[command(name = "mindeg", version, after_help = EXIT_CODES, max_term_width = 100)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    pub(crate) command: Command,
}

#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    Degree(DegreeArguments),
    Suggest(SuggestArguments),
    Mesh(MeshArguments),
    Tradeoff(TradeoffArguments),
    Compare(CompareArguments),
    Inspect(InspectArguments),
    Convert(ConvertArguments),
}

/// Tell the least possible maximum degree from interval counts alone, and why it cannot be less
///
/// The degree of a vertex is the number of edges at it, boundary edges included (its valence).
#[derive(Debug, Args)]
#[command(after_help = EXIT_CODES)]
pub(crate) struct DegreeArguments {
    /// The intervals of each side, counter-clockwise, such as 3,3,2,2
    #[arg(value_name = "INTERVALS")]
    pub(crate) intervals: IntervalCounts,

    /// Print JSON: intervals, vertices, triangles, interior_edges, max_degree, certificate
    #[arg(long)]
    pub(crate) json: bool,
}

/// Suggest the least change of interval counts that brings the least maximum degree down
///
/// Least means the fewest intervals added or taken away in all, with adding preferred: it never
/// coarsens a mesh.
#[derive(Debug, Args)]
#[command(after_help = EXIT_CODES)]
pub(crate) struct SuggestArguments {
    /// The intervals of each side, counter-clockwise, such as 30,2,4,2
    #[arg(value_name = "INTERVALS")]
    pub(crate) intervals: IntervalCounts,

    /// The degree to come down to; without it, every lower degree that a least change leads to
    #[arg(long, value_name = "D")]
    pub(crate) target: Option<u32>,

    /// Print JSON: intervals, max_degree, and suggestions, a list of max_degree, cost, changes
    /// (side counted from 0, by) and intervals
    #[arg(long)]
    pub(crate) json: bool,
}

/// Mesh a domain from its boundary points alone and write it to files
///
/// Vertices are numbered counter-clockwise from the first corner. Every vertex is a boundary
/// point, no vertex has more edges than any triangulation must have somewhere, and among the
/// meshes of that degree that the construction offers the one with the largest smallest angle is
/// taken. A domain whose file gives outside_degree or max_degree is meshed as with --optimize
/// angle. If a gate fails, nothing is written. Files appear whole or not at all, and what cannot be
/// written is refused before the mesh is looked for. Standard output can be compressed on the way:
/// -o - --format obj | zstd > mesh.obj.zst
#[derive(Debug, Args)]
#[command(after_help = EXIT_CODES)]
pub(crate) struct MeshArguments {
    #[command(flatten)]
    pub(crate) domain: DomainArguments,

    /// Where to write, by extension .obj, .glb, .gltf (with its .bin) or .svg; - is standard
    /// output. May be given several times
    #[arg(short, long, value_name = "FILE", required = true)]
    pub(crate) output: Vec<PathBuf>,

    /// The format where the extension does not tell it
    #[arg(long, value_name = "FORMAT", value_parser = format_parser())]
    pub(crate) format: Option<Format>,

    #[command(flatten)]
    pub(crate) surface: SurfaceArguments,

    /// Take the mesh with the largest smallest angle of all, exactly, at the least possible maximum
    /// degree, or at the one that --max-degree gives, which then is no gate; up to 4096 vertices
    #[arg(long, value_name = "WHAT")]
    pub(crate) optimize: Option<Optimize>,

    /// Print a summary as JSON: vertices, triangles, max_degree, optimal_max_degree, min_angle,
    /// max_angle, outputs
    #[arg(long)]
    pub(crate) json: bool,

    /// Print no summary and show no progress on standard error
    #[arg(short, long)]
    pub(crate) quiet: bool,

    #[command(flatten)]
    pub(crate) gates: Gates,
}

/// Tell what is wrong with any triangle mesh, how many edges meet where, and how well its
/// triangles are shaped
///
/// Takes meshes of any program: with interior vertices, in several parts, closed or broken.
/// Edges and degrees are those of the faces in the file, quads and larger polygons among them; areas
/// and angles are those of the triangles they are cut into. Vertices, faces and triangles are
/// numbered from 0, in the order of the file.
#[derive(Debug, Args)]
#[command(after_help = EXIT_CODES)]
pub(crate) struct InspectArguments {
    /// The mesh, by extension .obj, .glb or .gltf (with the files it names in its folder); - is
    /// standard input, whose content tells the format
    #[arg(value_name = "MESH")]
    pub(crate) file: PathBuf,

    /// The format of standard input, where its content does not tell it
    #[arg(long, value_name = "FORMAT", value_parser = read_format_parser())]
    pub(crate) format: Option<Format>,

    /// Name the vertices with more edges than this, poles
    #[arg(long, value_name = "N", default_value_t = 8)]
    pub(crate) poles_above: u32,

    /// By how many degrees a convex outline must turn at its corners, 0 to 90
    #[arg(long, value_name = "A", default_value_t = 1.0, value_parser = parse_corner_angle, allow_hyphen_values = true)]
    pub(crate) corner_angle: f64,

    /// Merge vertices no farther apart than this, in the file's unit of length, and all of a chain
    /// of such vertices; 0 merges vertices with identical coordinates, as without the option
    #[arg(long, value_name = "TOLERANCE", default_value_t = 0.0, value_parser = parse_tolerance, allow_hyphen_values = true, hide_default_value = true)]
    pub(crate) weld: f64,

    /// Do not merge vertices with identical coordinates
    #[arg(long, conflicts_with = "weld")]
    pub(crate) no_weld: bool,

    /// Print JSON: file, vertices, welded_vertices, triangles, quads, polygons, line_segments,
    /// points, not_read, faces, edges, boundary_edges, boundary_loops, open_boundaries, components,
    /// euler_characteristic, non_manifold_edges, non_manifold_vertices, inconsistent_edges,
    /// duplicate_faces, duplicate_triangles, zero_area_triangles, unreferenced_vertices,
    /// max_degree, degree_histogram, poles, area, min_angle, max_angle, metrics,
    /// share_below_degrees, worst_triangles, outline, no_outline
    #[arg(long)]
    pub(crate) json: bool,

    /// Show no progress on standard error
    #[arg(short, long)]
    pub(crate) quiet: bool,

    #[command(flatten)]
    pub(crate) gates: Gates,
}

fn parse_tolerance(text: &str) -> Result<f64, String> {
    let tolerance =
        text.parse().ok().filter(|tolerance: &f64| *tolerance >= 0.0 && tolerance.is_finite());
    tolerance.ok_or_else(|| "give a length, 0 or more".to_owned())
}

fn parse_corner_angle(text: &str) -> Result<f64, String> {
    let angle = text.parse().ok().filter(|angle| (0.0..=90.0).contains(angle));
    angle.ok_or_else(|| "give degrees from 0 to 90".to_owned())
}

/// Write a mesh of any program in other formats
///
/// Positions, triangles, names and groups stay; normals are made anew.
#[derive(Debug, Args)]
#[command(after_help = EXIT_CODES)]
pub(crate) struct ConvertArguments {
    /// The mesh, by extension .obj, .glb or .gltf (with the files it names in its folder)
    #[arg(value_name = "MESH")]
    pub(crate) file: PathBuf,

    /// Where to write, by extension .obj, .glb, .gltf (with its .bin) or .svg; - is standard
    /// output. May be given several times
    #[arg(short, long, value_name = "FILE", required = true)]
    pub(crate) output: Vec<PathBuf>,

    /// The format where the extension does not tell it
    #[arg(long, value_name = "FORMAT", value_parser = format_parser())]
    pub(crate) format: Option<Format>,

    #[command(flatten)]
    pub(crate) surface: SurfaceArguments,

    /// Show no progress on standard error
    #[arg(short, long)]
    pub(crate) quiet: bool,
}

/// What a file holds besides points and triangles.
#[derive(Debug, Args)]
pub(crate) struct SurfaceArguments {
    /// Give each vertex a colour by its degree (OBJ, glTF)
    #[arg(long)]
    pub(crate) degree_colors: bool,

    /// Add each side as a named line (OBJ, glTF)
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

fn format_parser() -> impl TypedValueParser<Value = Format> {
    one_of(Format::WRITTEN)
}

fn read_format_parser() -> impl TypedValueParser<Value = Format> {
    one_of(Format::READ)
}

fn one_of<const N: usize>(formats: [Format; N]) -> impl TypedValueParser<Value = Format> {
    let values =
        formats.map(|format| PossibleValue::new(format.extension()).help(format.description()));
    PossibleValuesParser::new(values).map(move |name| {
        let is_named = |format: &Format| format.extension() == name;
        formats.into_iter().find(is_named).expect("one of the possible values")
    })
}

/// What a mesh is chosen for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Optimize {
    /// The smallest angle of all triangles
    Angle,
}

/// Tell how large the smallest angle can be for each maximum degree, exactly
///
/// From the least possible degree up to the first at which no larger angle can be had, which
/// is that of a Delaunay triangulation. Degrees and caps are total: edges outside count. Up to
/// 4096 boundary vertices.
#[derive(Debug, Args)]
#[command(after_help = EXIT_CODES)]
pub(crate) struct TradeoffArguments {
    #[command(flatten)]
    pub(crate) domain: DomainArguments,

    /// Where to write a report with the curve and the meshes, by extension .html or .svg, or the
    /// figures, .json; may be given several times
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Vec<PathBuf>,

    /// Print JSON instead of a table: points, a list of max_degree, min_angle and exact; and
    /// delaunay_min_angle
    #[arg(long)]
    pub(crate) json: bool,

    /// Show no progress on standard error
    #[arg(short, long)]
    pub(crate) quiet: bool,
}

/// Compare the least-degree mesh with a Delaunay triangulation, ear clipping and a fan
///
/// All methods get the same boundary points. Each result is checked before it is shown, and none
/// is repaired. The report begins with a verdict that is computed from the figures.
#[derive(Debug, Args)]
#[command(after_help = EXIT_CODES)]
pub(crate) struct CompareArguments {
    #[command(flatten)]
    pub(crate) domain: DomainArguments,

    /// Where to write the report, by extension .html, .json or .md; may be given several times.
    /// A folder takes an HTML report for each domain and an index page; several domains need one
    #[arg(short, long, value_name = "FILE", required = true)]
    pub(crate) output: Vec<PathBuf>,

    /// How long each method may take, in seconds; the report lists one that takes longer as such
    #[arg(long, value_name = "SECONDS", default_value = "60", allow_hyphen_values = true)]
    pub(crate) time_limit: f64,

    /// Print no verdicts on standard error
    #[arg(short, long)]
    pub(crate) quiet: bool,

    #[command(flatten)]
    pub(crate) gates: Gates,
}

/// The domain, from files or from options; options override what files say of sides.
#[derive(Debug, Args)]
pub(crate) struct DomainArguments {
    /// A domain in JSON; - reads standard input
    #[arg(value_name = "DOMAIN.json")]
    pub(crate) files: Vec<PathBuf>,

    /// A rectangle with these side lengths; its sides are bottom, right, top, left
    #[arg(long, value_name = "WxH", conflicts_with_all = ["files", "corners"], allow_hyphen_values = true)]
    pub(crate) rectangle: Option<RectangleSize>,

    /// A convex polygon with these corners, such as "0,0 4,0 3,2"
    #[arg(long, value_name = "x,y x,y …", conflicts_with = "files", allow_hyphen_values = true)]
    pub(crate) corners: Option<Corners>,

    /// The intervals of each side, counter-clockwise, such as 3,3,2,2
    #[arg(long, value_name = "a,b,…", conflicts_with = "size")]
    pub(crate) intervals: Option<IntervalCounts>,

    /// The length that the intervals of every side should have
    #[arg(long, value_name = "S", allow_hyphen_values = true)]
    pub(crate) size: Option<f64>,

    /// How the intervals of every side are spaced: uniform, geometric:RATIO, bump:RATIO,
    /// beta:BETA or first-length:LENGTH
    #[arg(long, value_name = "LAW")]
    pub(crate) spacing: Option<Spacing>,
}

/// Width and height.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct RectangleSize {
    pub(crate) width: f64,
    pub(crate) height: f64,
}

impl std::str::FromStr for RectangleSize {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let sizes = text.split_once(['x', 'X', '×']).and_then(|(width, height)| {
            Some(Self { width: width.trim().parse().ok()?, height: height.trim().parse().ok()? })
        });
        sizes.ok_or_else(|| format!("{text:?} is not a width and a height, such as 4x3"))
    }
}

/// A list of points.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Corners(pub(crate) Vec<[f64; 2]>);

impl std::str::FromStr for Corners {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let parse = |(number, corner): (usize, &str)| {
            let coordinates = corner
                .split_once(',')
                .and_then(|(x, y)| Some([x.trim().parse().ok()?, y.trim().parse().ok()?]));
            coordinates.ok_or_else(|| {
                format!(
                    "corner {}: {corner:?} is not x,y; give corners such as \"0,0 4,0 3,2\"",
                    number + 1
                )
            })
        };
        text.split_whitespace().enumerate().map(parse).collect::<Result<_, _>>().map(Self)
    }
}

/// A list of interval counts, one for each side.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct IntervalCounts(pub(crate) Vec<u64>);

impl std::str::FromStr for IntervalCounts {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let parse = |(side, count): (usize, &str)| {
            count.trim().parse().map_err(|_| {
                format!(
                    "side {}: {count:?} is not a whole number of intervals; give one count for \
                     each side, such as 3,3,2,2",
                    side + 1
                )
            })
        };
        text.split(',').enumerate().map(parse).collect::<Result<_, _>>().map(Self)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn the_arguments_are_well_formed() {
        Arguments::command().debug_assert();
    }

    #[test]
    fn interval_counts_are_read_side_by_side() {
        assert_eq!("3, 3,2,2".parse(), Ok(IntervalCounts(vec![3, 3, 2, 2])));
        for (text, side) in
            [("", "side 1"), ("3,,2", "side 2"), ("3,-1,2", "side 2"), ("1,2,2.5", "side 3")]
        {
            let error = text.parse::<IntervalCounts>().unwrap_err();
            assert!(error.starts_with(side), "{text:?}: {error}");
        }
    }

    #[test]
    fn sizes_and_corners_are_read() {
        let size = RectangleSize { width: 4.0, height: 0.5 };
        assert_eq!("4x.5".parse(), Ok(size));
        assert_eq!("4 x 5e-1".parse(), Ok(size));
        for text in ["", "4", "4x", "4x3x2", "ax3"] {
            assert!(text.parse::<RectangleSize>().is_err(), "{text:?}");
        }
        let corners = Corners(vec![[0.0, 0.0], [-4.0, 1e3], [3.5, 2.0]]);
        assert_eq!(" 0,0  -4,1e3\n3.5,2".parse(), Ok(corners));
        for (text, corner) in
            [("0,0 4", "corner 2"), ("0;0", "corner 1"), ("0,0 1,1 1,2,3", "corner 3")]
        {
            let error = text.parse::<Corners>().unwrap_err();
            assert!(error.starts_with(corner), "{text:?}: {error}");
        }
    }
}
