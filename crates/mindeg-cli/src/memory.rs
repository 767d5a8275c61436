//! Asking for memory before work that would abort without it.
//!
//! Collections abort the process when the system has no memory for them, and the libraries below
//! use them freely. So a command that keeps a whole mesh estimates what it takes, asks the system
//! for that much at once, and gives it back.
//!
//! Limits: an estimate is no promise, and what others take meanwhile is gone. A system that
//! promises more memory than it has, as Linux does unless told otherwise, refuses nothing; a limit
//! on the process (`ulimit -v`) or a container's is where this matters.

use crate::failure::Failure;
use mindeg_formats::Format;
use std::fs;
use std::path::Path;

/// What threads, buffers and the program itself take besides.
const BASE: u64 = 4 << 20;

/// Fails unless the system gives `bytes` of memory, which `what` is about to take.
pub(crate) fn require(bytes: u64, what: &str) -> Result<(), Failure> {
    let wanted = bytes.saturating_add(BASE);
    let mut probe = Vec::<u8>::new();
    let given = usize::try_from(wanted).is_ok_and(|len| probe.try_reserve_exact(len).is_ok());
    // Asked for and not used: without this, the whole question could be optimised away.
    std::hint::black_box(&probe);
    if given {
        return Ok(());
    }
    Err(Failure::Io(format!(
        "out of memory: {what} takes about {} MB; raise the limit on memory, or make it smaller",
        wanted.div_ceil(1_000_000)
    )))
}

/// Asks for the memory of a mesh that streams: points and buffers, up to a limit.
pub(crate) fn require_to_stream(vertices: u32, what: &str) -> Result<(), Failure> {
    // As measured, 5 MB at 1.4 million vertices and at 10 million.
    const PER_VERTEX: u64 = 48;
    const MOST: u64 = 16 << 20;
    require((u64::from(vertices) * PER_VERTEX).min(MOST), &format!("meshing {what}"))
}

/// Asks for the memory of reading a mesh from a file.
pub(crate) fn require_to_read(path: &Path) -> Result<(), Failure> {
    // As measured, 2.1 of an OBJ of long numbers and 2.3 of a GLB; short numbers take more.
    let per_byte = if Format::of_path(path) == Some(Format::Obj) { 6 } else { 4 };
    // What is no file has no length, and what is not there says so when it is read.
    let len = fs::metadata(path).map_or(0, |metadata| metadata.len());
    require(len.saturating_mul(per_byte), &format!("reading {}", path.display()))
}

/// Asks for the memory of a page for one mesh.
pub(crate) fn require_to_view(
    what: &str,
    vertices: usize,
    triangles: usize,
) -> Result<(), Failure> {
    // As measured, 165 of a boundary mesh of a million vertices.
    const PER_ELEMENT: u64 = 250;
    let bytes = (vertices as u64 + triangles as u64).saturating_mul(PER_ELEMENT);
    require(bytes, &format!("a view of {what}"))
}

/// Asks for the memory of inspecting the mesh of a file.
pub(crate) fn require_to_inspect(
    path: &Path,
    vertices: usize,
    triangles: usize,
) -> Result<(), Failure> {
    // As measured, 85 of a mesh with as many triangles as vertices.
    const PER_ELEMENT: u64 = 130;
    let bytes = (vertices as u64 + triangles as u64).saturating_mul(PER_ELEMENT);
    require(bytes, &format!("inspecting {}", path.display()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_no_system_has_is_refused() {
        assert!(require(1 << 20, "a megabyte").is_ok());
        let refusal = require(u64::MAX, "x.obj").unwrap_err();
        let message = refusal.message().unwrap_or_default();
        assert!(message.starts_with("out of memory: x.obj takes about "), "{message}");
    }
}
