//! Sizes of a mesh, from a grid or a background mesh.

use crate::error::FileError;
use crate::input::Input;
use crate::session::Session;
use mindeg_domain::{SizeAt, SizeBetween};
use mindeg_formats::Field;

impl Session {
    /// Reads sizes: an ESRI grid (`.asc`), an NPZ with `values`, `origin` and `spacing`, or a mesh with one number at each
    /// vertex, MSH or VTU. Values that are no sizes, such as NaN, are left out with the triangles and cells at them. No
    /// output may replace the file from then on.
    ///
    /// # Errors
    ///
    /// A file that cannot be read, is none of these, or has no size.
    pub fn sizes(&self, input: &Input<'_>) -> Result<SizeBetween, FileError> {
        let name = input.name();
        let wrong = |problem: String| FileError::wrong(format!("{name}: {problem}"));
        if let Input::File(path) = input {
            self.note(path, "file of sizes");
        }
        let bytes = self.bytes(input, "file of sizes")?;
        let sizes = match Field::read(&bytes).map_err(|error| wrong(error.to_string()))? {
            Field::Grid(grid) => {
                SizeBetween::grid(grid.origin, grid.spacing, grid.columns, &grid.values)
            }
            Field::Mesh(mesh, values) => {
                let at = mesh.positions().iter().zip(values);
                let point = at.map(|(at, size)| SizeAt { at: at.truncate(), size });
                Some(SizeBetween::of_mesh(point.collect(), mesh.triangles()))
            }
        };
        let sizes = sizes.filter(|sizes| !sizes.points.is_empty());
        sizes
            .ok_or_else(|| wrong("no value is a size; sizes are finite numbers above 0".to_owned()))
    }
}
