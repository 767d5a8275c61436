//! One number at each point of the plane: a grid, or a mesh with values at its vertices.

use glam::DVec2;
use mindeg_mesh::TriMesh;

use crate::format::Format;
use crate::raster::Raster;
use crate::scanner::Scanner;
use crate::words::finite;
use crate::{ReadError, msh, netcdf, npz, vtu};

/// A number at each point of a grid or of a mesh.
#[derive(Debug)]
pub enum Field {
    /// A grid.
    Grid(Raster),
    /// A mesh with a value at each vertex; NaN where it has none.
    Mesh(Box<TriMesh>, Vec<f64>),
}

impl Field {
    /// Reads an ESRI grid (`.asc`), a grid in classic NetCDF, an NPZ with `values`, `origin` and `spacing`, an array
    /// of numpy (`.npy`) with rows of x, y and value, an MSH with `$NodeData`, or a VTU with point data; the content tells which. Of several data the first with one number at each vertex counts, in a VTU
    /// by name.
    ///
    /// # Errors
    ///
    /// Another format; a file that breaks its format, or has no values.
    ///
    /// # Example
    ///
    /// ```
    /// use mindeg_formats::Field;
    ///
    /// let file = "ncols 2\nnrows 2\nxllcenter 10\nyllcenter 20\ncellsize 5\n3 4\n1 2\n";
    /// let Field::Grid(grid) = Field::read(file.as_bytes())? else { unreachable!("a grid") };
    /// assert_eq!((grid.origin.to_array(), grid.values), ([10.0, 20.0], vec![1.0, 2.0, 3.0, 4.0]));
    /// # Ok::<(), mindeg_formats::ReadError>(())
    /// ```
    pub fn read(file: &[u8]) -> Result<Self, ReadError> {
        let of_mesh = |(mesh, values)| Self::Mesh(Box::new(mesh), values);
        match Format::of_content(file) {
            Some(Format::Ugrid) => netcdf::read_raster(file).map(Self::Grid),
            Some(Format::Npz) => npz::read_raster(file).map(Self::Grid),
            _ if file.starts_with(npz::MAGIC) => npz::read_rows(file).map(Self::Grid),
            Some(Format::Msh) => msh::read_values(file).map(of_mesh),
            Some(Format::Vtu) => vtu::read_values(file).map(of_mesh),
            _ if file
                .trim_ascii_start()
                .get(..5)
                .is_some_and(|word| word.eq_ignore_ascii_case(b"ncols")) =>
            {
                esri_grid(file).map(Self::Grid)
            }
            _ => Err(ReadError::place(
                "",
                "sizes are read from an ESRI grid (.asc), classic NetCDF, an NPZ with values, origin and spacing, a .npy \
                 with rows of x, y and value, an MSH with node data, or a VTU with point data",
            )),
        }
    }

    /// True if a file is an array, in classic NetCDF or of numpy, whatever is wrong with it.
    ///
    /// ```
    /// use mindeg_formats::Field;
    ///
    /// assert!(Field::is_array(b"CDF\x01") && Field::is_array(b"\x93NUMPY") && !Field::is_array(b"PK"));
    /// ```
    #[must_use]
    pub fn is_array(file: &[u8]) -> bool {
        Format::of_content(file) == Some(Format::Ugrid) || file.starts_with(npz::MAGIC)
    }
}

/// Reads an ESRI grid: a head of names and numbers, then rows from the greatest y on.
fn esri_grid(file: &[u8]) -> Result<Raster, ReadError> {
    let mut scanner = Scanner::new(file);
    let mut head: Vec<(String, f64)> = Vec::new();
    loop {
        let start = scanner.offset();
        let Some(word) = scanner.word() else {
            return Err(scanner.problem("the values are missing"));
        };
        if finite(word).is_some() || word.eq_ignore_ascii_case(b"nan") {
            scanner.go_to(start);
            break;
        }
        let name = String::from_utf8_lossy(word).to_ascii_lowercase();
        let value = scanner.word().and_then(finite);
        let value = value.ok_or_else(|| scanner.problem(format!("{name} should be a number")))?;
        head.push((name, value));
    }
    let value = |name: &str| head.iter().find(|(known, _)| known == name).map(|(_, value)| *value);
    let count = |name: &str| {
        let count =
            value(name).filter(|count| *count >= 2.0 && count.fract() == 0.0 && *count < 1e9);
        let count = count.map(|count| count as usize);
        count.ok_or_else(|| {
            ReadError::place(name, "the head needs it, as a whole number of 2 or more")
        })
    };
    let (columns, rows) = (count("ncols")?, count("nrows")?);
    let length = |name: &str| value(name).or(value("cellsize")).filter(|length| *length > 0.0);
    let (Some(dx), Some(dy)) = (length("dx"), length("dy")) else {
        return Err(ReadError::place("cellsize", "the head needs it, above 0; or dx and dy"));
    };
    // Values are at the middles of cells.
    let origin = |corner: &str, center: &str, step: f64| {
        let of_corner = value(corner).map(|corner| corner + step / 2.0);
        let at = value(center).or(of_corner);
        at.ok_or_else(|| ReadError::place(corner, format!("the head needs it, or {center}")))
    };
    let origin =
        DVec2::new(origin("xllcorner", "xllcenter", dx)?, origin("yllcorner", "yllcenter", dy)?);
    let missing = value("nodata_value").unwrap_or(NO_DATA);
    let mut lines: Vec<Vec<f64>> = Vec::new();
    for _ in 0..rows {
        let mut line = Vec::new();
        for _ in 0..columns {
            let word = scanner.word().ok_or_else(|| {
                let found = lines.len() * columns + line.len();
                scanner.problem(format!("{found} values are there, not {rows} rows of {columns}"))
            })?;
            let value = finite(word).filter(|value| *value != missing);
            line.push(value.unwrap_or(f64::NAN));
        }
        lines.push(line);
    }
    if scanner.word().is_some() {
        return Err(scanner.problem(format!("more values than {rows} rows of {columns}")));
    }
    lines.reverse();
    Ok(Raster { origin, spacing: DVec2::new(dx, dy), columns, values: lines.concat() })
}

/// What stands for no value where the head of an ESRI grid names nothing else.
const NO_DATA: f64 = -9999.0;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn esri_grids_are_read() {
        let head =
            "NCOLS 3\nNROWS 2\nXLLCORNER 1\nYLLCORNER -2\nCELLSIZE 0.5\nNODATA_value -9999\n";
        let Field::Grid(grid) =
            Field::read(format!("{head}1 2 3\n4 -9999 6\n").as_bytes()).unwrap()
        else {
            unreachable!("a grid")
        };
        assert_eq!((grid.origin, grid.spacing), (DVec2::new(1.25, -1.75), DVec2::splat(0.5)));
        assert_eq!((grid.columns, grid.values.len()), (3, 6));
        assert_eq!([0, 2, 3, 5].map(|at| grid.values[at]), [4.0, 6.0, 1.0, 3.0]);
        assert!(grid.values[1].is_nan());
        // ESRI's own mark where the head names none.
        let plain = head.replace("NODATA_value -9999\n", "") + "1 2 3\n4 -9999 6\n";
        let Field::Grid(plain) = Field::read(plain.as_bytes()).unwrap() else {
            unreachable!("a grid")
        };
        assert!(plain.values[1].is_nan() && plain.values[2] == 6.0);
        for (text, words) in [
            ("1 2 3\n4 5", "5 values are there, not 2 rows of 3"),
            ("1 2 3\n4 5 6 7", "more values than 2 rows of 3"),
            ("", "the values are missing"),
        ] {
            let error = Field::read(format!("{head}{text}").as_bytes()).unwrap_err().to_string();
            assert!(error.contains(words), "{error}");
        }
        let error = Field::read(b"ncols 3\nnrows x\n").unwrap_err().to_string();
        assert!(error.contains("nrows should be a number"), "{error}");
        let error = Field::read(b"ncols 3\nnrows 2\n1 2 3 4 5 6").unwrap_err().to_string();
        assert!(error.contains("cellsize: the head needs it"), "{error}");
    }

    fn values(file: &[u8]) -> Vec<f64> {
        match Field::read(file).unwrap() {
            Field::Mesh(mesh, values) => {
                assert_eq!(mesh.triangles(), [[0, 1, 2]]);
                values
            }
            Field::Grid(grid) => unreachable!("{grid:?}"),
        }
    }

    #[test]
    fn values_at_the_vertices_of_meshes_are_read() {
        let msh = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 0\n2 1 0 0\n9 0 1 0\n\
            $EndNodes\n$Elements\n1\n1 2 2 1 1 1 2 9\n$EndElements\n$NodeData\n1\n\"size\"\n1\n0\n3\n0\n1\n2\n9 0.5\n1 0.25\n\
            $EndNodeData\n";
        let found = values(msh.as_bytes());
        assert_eq!((found[0], found[2]), (0.25, 0.5));
        assert!(found[1].is_nan());
        let without = msh.split("$NodeData").next().unwrap();
        assert!(Field::read(without.as_bytes()).unwrap_err().to_string().contains("no $NodeData"));
        let array = |kind: &str, name: &str, values: &str| {
            format!("<DataArray type=\"{kind}\" Name=\"{name}\" {values}</DataArray>")
        };
        let vtu = [
            "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid>".to_owned(),
            "<Piece NumberOfPoints=\"3\" NumberOfCells=\"1\"><PointData>".to_owned(),
            array("Float32", "speed", "NumberOfComponents=\"2\">1 2 3 4 5 6"),
            array("Float64", "size", ">0.1 0.2 0.3") + "</PointData><Points>",
            array("Float32", "Points", "NumberOfComponents=\"3\">0 0 0 1 0 0 0 1 0"),
            "</Points><Cells>".to_owned(),
            array("Int32", "connectivity", ">0 1 2") + &array("Int32", "offsets", ">3"),
            array("UInt8", "types", ">5") + "</Cells></Piece></UnstructuredGrid></VTKFile>",
        ];
        assert_eq!(values(vtu.concat().as_bytes()), [0.1, 0.2, 0.3]);
        let error = Field::read(vtu.concat().replace("0.2", "").as_bytes()).unwrap_err();
        assert!(error.to_string().contains("no point data of one number"), "{error}");
        assert!(Field::read(b"hello").unwrap_err().to_string().contains("an ESRI grid (.asc)"));
    }
}
