//! Files of other programs that mindeg neither reads nor writes, and how to get them in.

/// Extensions, what such a file is, and what turns it into one that mindeg reads.
const FOREIGN: &[(&[&str], &str, &str)] = &[
    (
        &["shp", "shx", "dbf", "gpkg", "kml", "gml", "gdb", "fgb", "parquet"],
        "a map of a geographic program",
        "`ogr2ogr outline.geojson FILE` writes its polygons as GeoJSON",
    ),
    (
        &["prj", "cpg", "qpj"],
        "a part of a shapefile, without its polygons",
        "`ogr2ogr outline.geojson FILE` writes those as GeoJSON, given the .shp beside it",
    ),
    (
        &["zip"],
        "a zipped folder",
        "`ogr2ogr outline.geojson /vsizip/FILE` writes the polygons of a shapefile in it as GeoJSON; else unpack it",
    ),
    (
        &["nc"],
        "a file in NetCDF",
        "only grids for depths and sizes are read of it, in the classic format, which `nccopy -k classic FILE grid.nc` writes",
    ),
    (
        &["tif", "tiff"],
        "a grid of a geographic program",
        "`gdal_translate -of AAIGrid FILE grid.asc` writes its values as a grid for depths and sizes",
    ),
    (
        &["npy"],
        "an array of numpy",
        "only depths and sizes are read of it, from rows of x, y and value",
    ),
    (
        &["geo"],
        "a script for Gmsh",
        "`gmsh -1 FILE -o outline.msh` writes its curves as an outline",
    ),
    (
        &["step", "stp", "iges", "igs", "brep", "sat", "3dm"],
        "a solid of a CAD program",
        "`gmsh -1 FILE -o outline.msh` writes the edges of a flat part as an outline, and `gmsh -2 FILE -o \
         part.msh` a mesh of its faces",
    ),
    (
        &["dae", "fbx", "3mf", "usd", "usda", "usdc", "usdz", "x3d", "blend", "3ds", "wrl"],
        "a scene of a 3D program",
        "save it as .glb or .obj there",
    ),
    (
        &["vtp", "mesh", "cgns", "bdf", "nas", "med", "xdmf", "e", "exo", "unv"],
        "a mesh of another program",
        "`meshio convert FILE part.vtu` or Gmsh can turn it into a format that mindeg reads",
    ),
    (&["pdf", "dwg", "ai", "eps"], "a drawing of another program", "save it as .svg or .dxf there"),
    (&["html", "htm"], "a page", "give the mesh or the domain that it was made from"),
];

/// The kind of file that this extension names, and advice; `file` stands in the commands.
pub(crate) fn advice(extension: &str, file: &str) -> Option<String> {
    let is_one = |(extensions, ..): &&(&[&str], _, _)| extensions.contains(&extension);
    let (_, what, way) = FOREIGN.iter().find(is_one)?;
    Some(format!("it is {what}, which mindeg does not read; {}", way.replace("FILE", file)))
}

/// The usual extension of a file of other programs, by its first bytes.
pub(crate) fn extension_of(bytes: &[u8]) -> Option<&'static str> {
    let text = bytes.trim_ascii_start();
    let starts: [(&[u8], &str); 14] = [
        (&[0, 0, 0x27, 0x0a], "shp"),
        (b"ISO-10303-21", "step"),
        (b"%PDF", "pdf"),
        (b"Kaydara FBX", "fbx"),
        (b"SQLite format 3", "gpkg"),
        (b"fgb\x03", "fgb"),
        (b"PAR1", "parquet"),
        (b"CDF\x01", "nc"),
        (b"CDF\x02", "nc"),
        (b"CDF\x05", "nc"),
        (b"\x89HDF\r\n", "nc"),
        (b"II*\0", "tif"),
        (b"MM\0*", "tif"),
        (b"\x93NUMPY", "npy"),
    ];
    let start =
        starts.iter().find(|(start, _)| bytes.starts_with(start) || text.starts_with(start));
    start.map(|(_, extension)| *extension)
}

/// So much of a file tells that it is a script.
const SCRIPT: usize = 1 << 14;

/// Whether a text is a script for Gmsh: its first statement sets a number or a point, and it has a point. WKT can begin with `Point`, too.
pub(crate) fn is_gmsh_script(bytes: &[u8]) -> bool {
    let text = String::from_utf8_lossy(&bytes[..bytes.len().min(SCRIPT)]);
    let is_statement = |line: &&str| !line.is_empty() && !line.starts_with("//");
    let Some(first) = text.lines().map(str::trim).find(is_statement) else { return false };
    let is_set = first.split_once('=').is_some_and(|(name, _)| {
        let is_name = |letter: char| letter.is_alphanumeric() || "_.()[] ".contains(letter);
        // WKT can begin with the number of its projection, as if that were set.
        let is_wkt = name.trim().eq_ignore_ascii_case("SRID");
        name.starts_with(char::is_alphabetic) && name.chars().all(is_name) && !is_wkt
    });
    first.starts_with("SetFactory") || is_set && first.contains(';') && text.contains("Point")
}
