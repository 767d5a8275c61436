//! Sizes of a mesh, from a grid or a background mesh.

use crate::beside::Beside;
use crate::error::{FileError, plain};
use crate::foreign;
use crate::input::Input;
use crate::session::Session;
use mindeg_domain::{Depths, Domain, Size, SizeAt, SizeBetween, SizeFile};
use mindeg_formats::Field;
use std::io;

impl Session {
    /// Reads sizes: an ESRI grid (`.asc`), a grid in classic NetCDF, an NPZ with `values`, `origin` and `spacing`, an array of
    /// numpy (`.npy`) with rows of x, y and value, or a mesh with one number at each
    /// vertex, MSH or VTU. Values that are no sizes, such as NaN, are left out with the triangles and cells at them. No
    /// output may replace the file from then on.
    ///
    /// # Errors
    ///
    /// A file that cannot be read, is none of these, or has no size.
    pub fn sizes(&self, input: &Input<'_>) -> Result<SizeBetween, FileError> {
        if let Input::File(path) = input {
            self.note(path, SIZES);
        }
        sizes_of(&input.name(), &self.bytes(input, SIZES)?)
    }

    /// Reads depths on a grid: an ESRI grid (`.asc`), a grid in classic NetCDF, an NPZ with `values`, `origin` and `spacing`, or an array of numpy
    /// (`.npy`) with rows of x, y and value. No output may
    /// replace the file from then on.
    ///
    /// # Errors
    ///
    /// A file that cannot be read, is none of these, or has no value.
    pub fn depths(&self, input: &Input<'_>) -> Result<Depths, FileError> {
        const DEPTHS: &str = "file of depths";
        let name = input.name();
        let wrong = |problem: &str| FileError::wrong(format!("{name}: {problem}"));
        if let Input::File(path) = input {
            self.note(path, DEPTHS);
        }
        let bytes = self.bytes(input, DEPTHS)?;
        match field_of(&name, &bytes)? {
            Field::Grid(grid) => {
                Depths::grid(grid.origin, grid.spacing, grid.columns, &grid.values)
                    .ok_or_else(|| wrong("no value is a finite number"))
            }
            Field::Mesh(..) => Err(wrong(
                "it is a mesh; depths are read from a grid: an ESRI grid (.asc), classic NetCDF, NPZ or .npy",
            )),
        }
    }

    /// The domain of a file with the sizes in files beside it.
    ///
    /// # Errors
    ///
    /// The errors of [`sizes`](Self::sizes), and a file outside the folder of the domain's file.
    pub fn with_sizes(&self, domain: Domain, input: &Input<'_>) -> Result<Domain, FileError> {
        let Some(mut wanted) = domain.interior().cloned() else { return Ok(domain) };
        let mut beside = match input {
            Input::File(path) => Some(Beside::new(self, path, SIZES)),
            _ => None,
        };
        for (index, size) in wanted.sizes.iter_mut().enumerate() {
            let Size::File(SizeFile { file }) = size else { continue };
            let read = match &mut beside {
                Some(beside) => beside.read(file).map_err(plain),
                None => Err(io::Error::other(input.alone())),
            };
            let bytes = read.map_err(|error| {
                let name = input.name();
                FileError::wrong(format!("{name}: interior.sizes[{index}]: {file}: {error}"))
            })?;
            *size = Size::Between(sizes_of(file, &bytes)?);
        }
        Ok(domain.with_interior(wanted))
    }
}

/// The kind of the file in messages.
const SIZES: &str = "file of sizes";

/// The field in a file's bytes.
fn field_of(name: &str, bytes: &[u8]) -> Result<Field, FileError> {
    Field::read(bytes).map_err(|error| {
        // Faults of what is read are told as they are.
        let foreign = foreign::extension_of(bytes).filter(|_| !Field::is_array(bytes));
        let advice = foreign.and_then(|extension| foreign::advice(extension, name));
        FileError::wrong(format!("{name}: {}", advice.unwrap_or(error.to_string())))
    })
}

/// The sizes in a file's bytes.
fn sizes_of(name: &str, bytes: &[u8]) -> Result<SizeBetween, FileError> {
    let wrong = |problem: String| FileError::wrong(format!("{name}: {problem}"));
    let sizes = match field_of(name, bytes)? {
        Field::Grid(grid) => {
            SizeBetween::grid(grid.origin, grid.spacing, grid.columns, &grid.values)
        }
        Field::Mesh(mesh, values) => {
            let at = mesh.positions().iter().zip(values);
            let points = at.map(|(at, size)| SizeAt { at: at.truncate(), size });
            Some(SizeBetween::of_mesh(points.collect(), mesh.triangles()))
        }
    };
    let sizes = sizes.filter(|sizes| !sizes.points.is_empty());
    sizes.ok_or_else(|| wrong("no value is a size; sizes are finite numbers above 0".to_owned()))
}
