//! The functions of `mindeg.h`, and all of mindeg's own `unsafe` code: reading arrays and text where C says they are.
#![expect(unsafe_code, reason = "C names functions by symbols and gives arrays by their addresses")]

use std::ffi::{CStr, c_char};
use std::ptr;
use std::slice;

use crate::handle::MindegMesh;

/// Meshes the polygon inside the first ring of points and outside the others.
///
/// points: x and y of each point, ring after ring, without a gap. The boundary points of the mesh are these, bit for bit.
/// ring_sizes: the number of points of each ring; rings do not repeat their first point, and run either way round.
/// options: NULL, or JSON text: {"max_degree": 5}, {"keep_angle": "95%"}, {"interior": {"size_inside": 0.5}} and so on.
///
/// The result is never NULL: ask mindeg_error, and give it to mindeg_free in the end.
///
/// # Safety
///
/// ring_sizes has ring_count entries, points twice their sum, and options ends with a zero byte or is NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mindeg_mesh_rings(
    points: *const f64,
    ring_sizes: *const usize,
    ring_count: usize,
    options: *const c_char,
) -> Box<MindegMesh> {
    // SAFETY: the caller promises the lengths of the arrays and the end of the text.
    let (rings, options) = unsafe { (rings(points, ring_sizes, ring_count), text(options)) };
    match (rings, options) {
        (Ok(rings), Ok(options)) => MindegMesh::of_rings(rings, options),
        (Err(error), _) => MindegMesh::of(|| Err(error)),
        (_, Err(error)) => MindegMesh::of(|| Err(format!("options: {error}"))),
    }
}

/// Meshes a domain given as JSON text, with spacing laws, curves, lines inside and degree limits.
///
/// Points are added inside if the domain has the key "interior" and the options ask for no goal.
/// The result is never NULL: ask mindeg_error, and give it to mindeg_free in the end.
///
/// # Safety
///
/// Both texts end with a zero byte; options may be NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mindeg_mesh_domain(
    domain: *const c_char,
    options: *const c_char,
) -> Box<MindegMesh> {
    // SAFETY: the caller promises that both texts end.
    match unsafe { (text(domain), text(options)) } {
        (Ok(Some(domain)), Ok(options)) => MindegMesh::of_domain(domain, options),
        (Ok(None), _) => MindegMesh::of(|| Err("the domain is NULL; give JSON text".to_owned())),
        (Err(error), _) => MindegMesh::of(|| Err(format!("domain: {error}"))),
        (_, Err(error)) => MindegMesh::of(|| Err(format!("options: {error}"))),
    }
}

/// Why there is no mesh, as one line of UTF-8 text that lives as long as the handle; NULL if there is a mesh.
#[unsafe(no_mangle)]
pub extern "C" fn mindeg_error(mesh: Option<&MindegMesh>) -> *const c_char {
    match mesh {
        Some(mesh) => mesh.error().map_or(ptr::null(), CStr::as_ptr),
        None => c"the mesh is NULL".as_ptr(),
    }
}

/// The number of points; 0 without a mesh.
#[unsafe(no_mangle)]
pub extern "C" fn mindeg_point_count(mesh: Option<&MindegMesh>) -> usize {
    mesh.and_then(MindegMesh::made).map_or(0, |made| made.points.len())
}

/// x and y of each point, boundary points first. The array lives as long as the handle; NULL without a mesh.
#[unsafe(no_mangle)]
pub extern "C" fn mindeg_points(mesh: Option<&MindegMesh>) -> *const f64 {
    mesh.and_then(MindegMesh::made).map_or(ptr::null(), |made| made.points.as_ptr().cast())
}

/// The number of triangles; 0 without a mesh.
#[unsafe(no_mangle)]
pub extern "C" fn mindeg_triangle_count(mesh: Option<&MindegMesh>) -> usize {
    mesh.and_then(MindegMesh::made).map_or(0, |made| made.triangles.len())
}

/// Three indices of points for each triangle, from 0, counter-clockwise. The array lives as long as the handle; NULL
/// without a mesh.
#[unsafe(no_mangle)]
pub extern "C" fn mindeg_triangles(mesh: Option<&MindegMesh>) -> *const u32 {
    mesh.and_then(MindegMesh::made).map_or(ptr::null(), |made| made.triangles.as_ptr().cast())
}

/// The most edges at a vertex, boundary edges and edges outside the domain included; 0 without a mesh.
#[unsafe(no_mangle)]
pub extern "C" fn mindeg_max_degree(mesh: Option<&MindegMesh>) -> u32 {
    mesh.and_then(MindegMesh::made).map_or(0, |made| made.max_degree)
}

/// The minimum angle of all triangles, in degrees; NaN without a mesh.
#[unsafe(no_mangle)]
pub extern "C" fn mindeg_min_angle(mesh: Option<&MindegMesh>) -> f64 {
    mesh.and_then(MindegMesh::made).map_or(f64::NAN, |made| made.min_angle)
}

/// The facts that are known and proven of the mesh: JSON text with keys of `mindeg mesh --json`. It lives as long as the handle; NULL
/// without a mesh.
#[unsafe(no_mangle)]
pub extern "C" fn mindeg_report(mesh: Option<&MindegMesh>) -> *const c_char {
    mesh.and_then(MindegMesh::made).map_or(ptr::null(), |made| made.report.as_ptr())
}

/// Frees a handle and all that lives as long as it. NULL does nothing.
#[unsafe(no_mangle)]
pub extern "C" fn mindeg_free(mesh: Option<Box<MindegMesh>>) {
    drop(mesh);
}

/// The version of the library, such as "0.1.0".
#[unsafe(no_mangle)]
pub extern "C" fn mindeg_version() -> *const c_char {
    const VERSION: &str = concat!(env!("CARGO_PKG_VERSION"), "\0");
    VERSION.as_ptr().cast()
}

/// The rings of points.
///
/// # Safety
///
/// As [`mindeg_mesh_rings`].
unsafe fn rings(
    points: *const f64,
    sizes: *const usize,
    count: usize,
) -> Result<Vec<Vec<[f64; 2]>>, String> {
    // SAFETY: the caller promises `count` sizes.
    let sizes = unsafe { array(sizes, count) }.ok_or("ring_sizes is NULL")?;
    let total = sizes.iter().try_fold(0_usize, |sum, size| sum.checked_add(*size));
    let length = total.and_then(|total| total.checked_mul(2));
    let length = length.ok_or("ring_sizes: the sum is too large")?;
    // SAFETY: the caller promises two numbers for each point of each ring.
    let points = unsafe { array(points, length) }.ok_or("points is NULL")?;
    let mut pairs = points.chunks_exact(2).map(|pair| [pair[0], pair[1]]);
    Ok(sizes.iter().map(|size| pairs.by_ref().take(*size).collect()).collect())
}

/// An array of the caller; `None` where it has entries and no address.
///
/// # Safety
///
/// `start` is NULL or the address of `length` values that nobody changes.
unsafe fn array<'a, T>(start: *const T, length: usize) -> Option<&'a [T]> {
    if length == 0 {
        return Some(&[]);
    }
    if start.is_null() || length > isize::MAX as usize / size_of::<T>() {
        return None;
    }
    // SAFETY: the address is not NULL, the values are there, and their size in bytes is within `isize`.
    Some(unsafe { slice::from_raw_parts(start, length) })
}

/// Text of the caller; `None` for NULL.
///
/// # Safety
///
/// `start` is NULL or the address of text that ends with a zero byte and that nobody changes.
unsafe fn text<'a>(start: *const c_char) -> Result<Option<&'a str>, String> {
    if start.is_null() {
        return Ok(None);
    }
    // SAFETY: the address is not NULL, and the text ends.
    let text = unsafe { CStr::from_ptr(start) };
    text.to_str().map(Some).map_err(|_| "the text is not UTF-8".to_owned())
}
