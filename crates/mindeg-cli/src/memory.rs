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

/// What takes memory besides: the program, and the stack and buffers of each thread.
const BASE: u64 = 4 << 20;
const PER_THREAD: u64 = 8 << 20;

/// What glibc reserves of the addresses of a process for a thread that allocates, if it can.
const ARENA: u64 = 64 << 20;

/// Threads that a run starts besides those that are there: for signals, the bar, a method.
const OTHERS: u64 = 3;

/// Fails unless the system gives `bytes` of memory, which `what` is about to take.
pub(crate) fn require(bytes: u64, what: &str) -> Result<(), Failure> {
    let threads = rayon::current_num_threads() as u64;
    let wanted = bytes.saturating_add(BASE + threads * PER_THREAD);
    if left(wanted, threads + OTHERS, given) >= wanted {
        return Ok(());
    }
    Err(Failure::Io(format!(
        "out of memory: {what} takes about {} MB; raise the limit on memory, or make it smaller",
        wanted.div_ceil(1_000_000)
    )))
}

/// What the system gives, up to `wanted`, after `threads` threads more have reserved theirs. Of
/// what a limit leaves they take whole arenas, and none where that is not left.
fn left(wanted: u64, threads: u64, given: impl Fn(u64) -> bool) -> u64 {
    const STEP: u64 = 1 << 20;
    let all = wanted.saturating_add(threads * ARENA);
    if given(all) {
        return wanted;
    }
    // Given, and not given, in steps.
    let (mut low, mut high) = (0, all.div_ceil(STEP));
    while high - low > 1 {
        let middle = low + (high - low) / 2;
        *(if given(middle * STEP) { &mut low } else { &mut high }) = middle;
    }
    let free = low * STEP;
    free - (free / ARENA).min(threads) * ARENA
}

/// Whether the system gives so much memory at once; it is given back.
pub(crate) fn given(bytes: u64) -> bool {
    let mut probe = Vec::<u8>::new();
    let given = usize::try_from(bytes).is_ok_and(|len| probe.try_reserve_exact(len).is_ok());
    // Asked for and not used: without this, the whole question could be optimised away.
    std::hint::black_box(&probe);
    given
}

/// Asks for the memory of a mesh that streams: points and buffers, up to a limit.
pub(crate) fn require_to_stream(vertices: u32, what: &str) -> Result<(), Failure> {
    // As measured, 5 MB at 1.4 million vertices and at 10 million.
    const PER_VERTEX: u64 = 48;
    const MOST: u64 = 16 << 20;
    require((u64::from(vertices) * PER_VERTEX).min(MOST), &format!("meshing {what}"))
}

/// The greatest number of points that a mesh with interior points may have, where there is memory for them.
pub(crate) const MOST_POINTS: u64 = 20_000_000;

/// The greatest number of points that a mesh with interior points may have: [`MOST_POINTS`], or what there
/// is memory for.
pub(crate) fn most_points(what: &str) -> Result<usize, Failure> {
    const LEAST: u64 = 20_000;
    let mut points = MOST_POINTS;
    while points > LEAST && require(points * PER_INTERIOR_POINT, what).is_err() {
        points /= 2;
    }
    require(points * PER_INTERIOR_POINT, &format!("meshing {what} with {points} points"))?;
    Ok(points as usize)
}

/// Bytes for each point of a mesh with interior points: as measured, 290, and a third more.
const PER_INTERIOR_POINT: u64 = 400;

/// Asks for the memory of improving a mesh.
pub(crate) fn require_to_improve(
    what: &str,
    vertices: usize,
    triangles: usize,
) -> Result<(), Failure> {
    let points = vertices.max(triangles / 2) as u64;
    require(points.saturating_mul(PER_INTERIOR_POINT), &format!("improving {what}"))
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
    require(of_elements(250, vertices, triangles), &format!("a view of {what}"))
}

/// Asks for the memory of matching a mesh to a domain and checking it.
pub(crate) fn require_to_verify(
    what: &str,
    vertices: usize,
    triangles: usize,
) -> Result<(), Failure> {
    require(of_elements(200, vertices, triangles), &format!("verifying {what}"))
}

/// Asks for the memory of inspecting the mesh of a file.
pub(crate) fn require_to_inspect(
    path: &Path,
    vertices: usize,
    triangles: usize,
) -> Result<(), Failure> {
    // As measured, 85 of a mesh with as many triangles as vertices.
    require(of_elements(130, vertices, triangles), &format!("inspecting {}", path.display()))
}

/// The bytes of so many for each vertex and each triangle.
fn of_elements(bytes: u64, vertices: usize, triangles: usize) -> u64 {
    (vertices as u64 + triangles as u64).saturating_mul(bytes)
}

/// Asks for the memory of filling a loop of so many vertices.
pub(crate) fn require_to_fill(path: &Path, mut loops: Vec<usize>) -> Result<(), Failure> {
    // One cost and one flag for each pair, and some states of 16 bytes for each piece.
    const PER_PAIR: u64 = 80;
    // A loop for each thread at a time.
    loops.sort_unstable_by_key(|&vertices| std::cmp::Reverse(vertices));
    let largest = loops.iter().take(rayon::current_num_threads());
    let pairs = largest.map(|&vertices| (vertices as u64).saturating_pow(2));
    let pairs = pairs.fold(0, u64::saturating_add);
    require(pairs.saturating_mul(PER_PAIR), &format!("filling {}", path.display()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn threads_take_whole_arenas_of_what_a_limit_leaves() {
        let megabytes = |wanted: u64, threads, limit: u64| {
            left(wanted << 20, threads, |bytes| bytes <= limit << 20) >> 20
        };
        for (wanted, threads, limit, left) in [
            (12, 5, 1000, 12),
            (12, 5, 332, 12),
            (12, 5, 331, 11),
            (12, 5, 200, 8),
            (12, 5, 60, 60),
            (12, 5, 5, 5),
            (500, 5, 600, 280),
        ] {
            assert_eq!(megabytes(wanted, threads, limit), left, "{wanted} {threads} {limit}");
        }
    }

    #[test]
    fn what_no_system_has_is_refused() {
        assert!(require(1 << 20, "a megabyte").is_ok());
        let refusal = require(u64::MAX, "x.obj").unwrap_err();
        let message = refusal.message().unwrap_or_default();
        assert!(message.starts_with("out of memory: x.obj takes about "), "{message}");
    }
}
