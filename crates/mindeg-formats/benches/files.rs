//! How fast files are made, without writing them anywhere, and read and inspected, from memory.
//!
//! A rectangle of 4 by 3 with the same number of intervals on all sides.

#![expect(clippy::unwrap_used, reason = "a benchmark may panic")]

use divan::Bencher;
use divan::counter::{BytesCount, ItemsCount};
use mindeg::inspection::{Inspection, InspectionOptions};
use mindeg::{BoundaryMesh, Domain, Side};
use mindeg_formats::{SurfaceOptions, glb, obj};
use std::io;

fn main() {
    divan::main();
}

const TRIANGLES: [u64; 3] = [10_000, 100_000, 2_000_000];

fn mesh(triangles: u64) -> BoundaryMesh {
    let sides = (0..4).map(|_| Side::count(triangles / 4)).collect();
    BoundaryMesh::least_degree(&Domain::rectangle(4.0, 3.0, sides).unwrap()).unwrap()
}

fn obj_file(mesh: &BoundaryMesh) -> Vec<u8> {
    let mut file = Vec::new();
    obj::write(mesh, &SurfaceOptions::default(), &mut file).unwrap();
    file
}

fn glb_file(mesh: &BoundaryMesh) -> Vec<u8> {
    let mut file = Vec::new();
    glb::write(mesh, &SurfaceOptions::default(), &mut file).unwrap();
    file
}

#[divan::bench(args = TRIANGLES, sample_count = 10)]
fn write_obj(bencher: Bencher<'_, '_>, triangles: u64) {
    let (mesh, options) = (mesh(triangles), SurfaceOptions::default());
    let bytes = BytesCount::of_slice(&obj_file(&mesh));
    bencher.counter(bytes).bench_local(|| obj::write(&mesh, &options, io::sink()));
}

#[divan::bench(args = TRIANGLES, sample_count = 10)]
fn write_glb(bencher: Bencher<'_, '_>, triangles: u64) {
    let (mesh, options) = (mesh(triangles), SurfaceOptions::default());
    let bytes = BytesCount::of_slice(&glb_file(&mesh));
    bencher.counter(bytes).bench_local(|| glb::write(&mesh, &options, io::sink()));
}

#[divan::bench(args = TRIANGLES, sample_count = 5)]
fn read_obj(bencher: Bencher<'_, '_>, triangles: u64) {
    let file = obj_file(&mesh(triangles));
    bencher.counter(BytesCount::of_slice(&file)).bench_local(|| obj::read(&file[..]));
}

#[divan::bench(args = TRIANGLES, sample_count = 5)]
fn read_glb(bencher: Bencher<'_, '_>, triangles: u64) {
    let file = glb_file(&mesh(triangles));
    let no_files = |_: &str| Err(io::ErrorKind::Unsupported.into());
    bencher.counter(BytesCount::of_slice(&file)).bench_local(|| glb::read(&file[..], no_files));
}

#[divan::bench(args = TRIANGLES, sample_count = 5)]
fn inspect(bencher: Bencher<'_, '_>, triangles: u64) {
    let mesh = obj::read(&obj_file(&mesh(triangles))[..]).unwrap();
    let options = InspectionOptions::default();
    bencher.counter(ItemsCount::new(triangles)).bench_local(|| Inspection::of(&mesh, &options));
}
