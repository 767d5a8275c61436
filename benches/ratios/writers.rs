//! Writing files, next to writing the same bytes from memory to the same folder, and next to a
//! writer as one would jot it down.

use crate::clock::rounds;
use crate::{even, table};
use mindeg::{BoundaryMesh, Progress};
use mindeg_formats::{
    Encoding, Format, MshVersion, SurfaceOptions, WriteOptions, Writer, glb, obj,
};
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::PathBuf;

/// Raw bytes are written in blocks as long as the writers' own.
const BLOCK: usize = 1 << 19;

pub(crate) fn print() {
    let columns = [
        "format",
        "triangles",
        "MB",
        "raw, ms",
        "mindeg, ms",
        "speed of raw (aim: text 0.5, binary 0.8)",
        "`writeln!`, ms",
        "times as fast (aim 5)",
    ];
    table::head("Writers", &columns);
    let path = folder().join(format!("mindeg-ratios-{}", std::process::id()));
    let options = SurfaceOptions::default();
    for count in [100_000, 1_000_000, 10_000_000] {
        let mesh = even(count);
        let often = (20_000_000 / count as u32).clamp(5, 50);
        let written = |write: &dyn Fn(File)| {
            write(File::create(&path).unwrap());
            fs::read(&path).unwrap()
        };

        let write_obj = |file| obj::write(&mesh, &options, file).unwrap();
        let jot_down = |file| jot_down(&mesh, file).unwrap();
        let bytes = written(&write_obj);
        // Numbers may be spelled differently: 1e-7 and 0.0000001.
        assert_eq!(lines(&bytes), lines(&written(&jot_down)));
        let [raw, ours, naive] = rounds(
            often,
            [
                &mut || write_raw(&bytes, File::create(&path).unwrap()),
                &mut || write_obj(File::create(&path).unwrap()),
                &mut || jot_down(File::create(&path).unwrap()),
            ],
        );
        print_row("OBJ", count, bytes.len(), raw, ours, 0.5, Some(naive));

        let write_glb = |file| glb::write(&mesh, &options, file).unwrap();
        let bytes = written(&write_glb);
        let [raw, ours] = rounds(
            often,
            [&mut || write_raw(&bytes, File::create(&path).unwrap()), &mut || {
                write_glb(File::create(&path).unwrap())
            }],
        );
        print_row("GLB", count, bytes.len(), raw, ours, 0.8, None);

        for (name, format, options, aim) in others() {
            let writer = Writer::new(format, options, &mesh, mesh.triangle_count()).unwrap();
            let write = |file| {
                writer.write(&mesh, &mut [("", file)], Progress::NONE).unwrap();
            };
            let bytes = written(&write);
            let [raw, ours] = rounds(
                often,
                [&mut || write_raw(&bytes, File::create(&path).unwrap()), &mut || {
                    write(File::create(&path).unwrap())
                }],
            );
            print_row(name, count, bytes.len(), raw, ours, aim, None);
        }
    }
    fs::remove_file(&path).unwrap();
}

/// The formats of one file besides: the aims are those of OBJ for text and of GLB for binary.
fn others() -> Vec<(&'static str, Format, WriteOptions, f64)> {
    let plain = WriteOptions { fields: false, ..WriteOptions::default() };
    let text = WriteOptions { encoding: Encoding::Ascii, ..plain };
    let older = WriteOptions { msh_version: MshVersion::V2, ..plain };
    let fields = WriteOptions::default();
    vec![
        ("MSH 4.1, no fields", Format::Msh, plain, 0.8),
        ("MSH 4.1 as text, no fields", Format::Msh, text, 0.5),
        ("MSH 4.1", Format::Msh, fields, 0.8),
        ("MSH 2.2, no fields", Format::Msh, older, 0.8),
        ("VTU, no fields", Format::Vtu, plain, 0.8),
        ("VTU", Format::Vtu, fields, 0.8),
        ("VTK, no fields", Format::Vtk, plain, 0.8),
        ("VTK", Format::Vtk, fields, 0.8),
        ("SU2", Format::Su2, plain, 0.5),
        ("Abaqus input", Format::Inp, plain, 0.5),
        ("PLY", Format::Ply, plain, 0.8),
        ("fort.14", Format::Fort14, plain, 0.5),
        ("2DM", Format::Sms2dm, plain, 0.5),
    ]
}

/// Where files are in memory.
pub(crate) fn folder() -> PathBuf {
    std::env::var_os("MINDEG_BENCH_FOLDER").unwrap_or_else(|| "/dev/shm".into()).into()
}

fn print_row(
    format: &str,
    count: u64,
    bytes: usize,
    raw: f64,
    ours: f64,
    aim: f64,
    naive: Option<f64>,
) {
    let ms = |seconds: f64| format!("{:.1}", seconds * 1e3);
    table::row(&[
        format.to_owned(),
        table::count(count),
        format!("{:.0}", bytes as f64 / 1e6),
        ms(raw),
        ms(ours),
        table::at_least(raw / ours, aim),
        naive.map(ms).unwrap_or_default(),
        naive.map(|naive| table::at_least(naive / ours, 5.0)).unwrap_or_default(),
    ]);
}

fn lines(bytes: &[u8]) -> usize {
    bytes.iter().filter(|&&byte| byte == b'\n').count()
}

fn write_raw(bytes: &[u8], mut file: File) {
    bytes.chunks(BLOCK).for_each(|block| file.write_all(block).unwrap());
}

/// An OBJ writer without a thought for speed.
fn jot_down(mesh: &BoundaryMesh, file: File) -> io::Result<()> {
    let mut out = BufWriter::new(file);
    writeln!(out, "# mindeg {}", env!("CARGO_PKG_VERSION"))?;
    let (vertices, triangles) = (mesh.vertex_count(), mesh.triangle_count());
    let degree = mesh.max_degree();
    writeln!(out, "# {vertices} vertices, {triangles} triangles, maximum degree {degree}")?;
    writeln!(out, "o mesh")?;
    for point in mesh.points() {
        writeln!(out, "v {} {} 0", point.x, point.y)?;
    }
    let bounds = mesh.placement().bounds();
    for point in mesh.points() {
        let place = (point - bounds.min) / bounds.size();
        writeln!(out, "vt {} {}", place.x as f32, place.y as f32)?;
    }
    for _ in 0..vertices {
        writeln!(out, "vn 0 0 1")?;
    }
    for [a, b, c] in mesh.triangles().map(|triangle| triangle.map(|vertex| vertex + 1)) {
        writeln!(out, "f {a}/{a}/{a} {b}/{b}/{b} {c}/{c}/{c}")?;
    }
    out.flush()
}
