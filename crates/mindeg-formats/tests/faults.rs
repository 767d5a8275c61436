//! Files that take a byte at a time, are interrupted, or fail anywhere: the same bytes, or the error that
//! the file gave. Never a panic, and never a success with a part of the file.

use glam::DVec3;
use mindeg_formats::{
    Encoding, Format, MshVersion, ReadError, SurfaceOptions, WriteError, WriteOptions, Writer,
    read_as, with_boundary_lines,
};
use mindeg_mesh::{Progress, TriMesh, Triangles};
use std::collections::BTreeSet;
use std::io::{self, BufReader, ErrorKind, Read, Write};
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

/// A grid of squares, each of two triangles; large enough for several blocks of every section.
fn grid(columns: u32, rows: u32) -> TriMesh {
    let point = |v: u32| {
        let (x, y) = (v % (columns + 1), v / (columns + 1));
        DVec3::new(f64::from(x) / 7.0, f64::from(y) / 3.0, 0.0)
    };
    let square = |s: u32| {
        let a = s / columns * (columns + 1) + s % columns;
        let [b, c, d] = [a + 1, a + columns + 2, a + columns + 1];
        [[a, b, c], [a, c, d]]
    };
    let points = (0..(columns + 1) * (rows + 1)).map(point).collect();
    let triangles = (0..columns * rows).flat_map(square).collect();
    with_boundary_lines(TriMesh::new(points, triangles).unwrap().named("grid"))
}

/// Every format with every way to write it.
fn ways() -> Vec<(Format, WriteOptions)> {
    let all = SurfaceOptions {
        normals: true,
        texture_coordinates: true,
        degree_colors: true,
        boundary_lines: true,
        ..SurfaceOptions::default()
    };
    let options = [
        WriteOptions::default(),
        WriteOptions { surface: all, ..WriteOptions::default() },
        WriteOptions { encoding: Encoding::Ascii, ..WriteOptions::default() },
        WriteOptions { msh_version: MshVersion::V2, double: true, ..WriteOptions::default() },
    ];
    let built = |format: &Format| *format != Format::Png || cfg!(feature = "png");
    let formats = Format::WRITTEN.into_iter().filter(built);
    formats.flat_map(|format| options.map(|options| (format, options))).collect()
}

fn file_count(format: Format) -> usize {
    format.files(Path::new("grid")).len()
}

fn write<W: Write + Send>(
    mesh: &TriMesh,
    (format, options): (Format, WriteOptions),
    files: &mut [(&str, W)],
) -> Result<(), WriteError> {
    let writer = Writer::new(format, options, mesh, mesh.triangle_count())?;
    writer.write(mesh, files, Progress::NONE).map(|_| ())
}

fn written(mesh: &TriMesh, way: (Format, WriteOptions)) -> Vec<Vec<u8>> {
    let mut files: Vec<(&str, Vec<u8>)> = vec![("grid.bin", Vec::new()); file_count(way.0)];
    write(mesh, way, &mut files).unwrap();
    files.into_iter().map(|(_, bytes)| bytes).collect()
}

/// The fates of the calls of a stream, counted over all streams that share the counter.
struct Faulty<'a, S> {
    stream: S,
    calls: &'a AtomicUsize,
    /// The call that fails, and how.
    fault: Option<(usize, Fault)>,
    /// The most bytes a call takes; then every third call is interrupted, too.
    most: Option<usize>,
}

#[derive(Clone, Copy, Debug)]
enum Fault {
    Kind(ErrorKind),
    /// Nothing is taken, and no error tells it.
    Nothing,
}

impl<S> Faulty<'_, S> {
    /// The most bytes that this call may take.
    fn next(&self) -> io::Result<usize> {
        let call = self.calls.fetch_add(1, Relaxed);
        match self.fault {
            Some((at, Fault::Kind(kind))) if call >= at => Err(kind.into()),
            Some((at, Fault::Nothing)) if call >= at => Ok(0),
            _ => match self.most {
                Some(_) if call % 3 == 1 => Err(ErrorKind::Interrupted.into()),
                Some(most) => Ok(1 + call % most),
                None => Ok(usize::MAX),
            },
        }
    }
}

impl<S: Write> Write for Faulty<'_, S> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let most = self.next()?;
        self.stream.write(&bytes[..bytes.len().min(most)])
    }

    fn flush(&mut self) -> io::Result<()> {
        match self.fault {
            Some((at, Fault::Kind(kind))) if self.calls.load(Relaxed) >= at => Err(kind.into()),
            _ => self.stream.flush(),
        }
    }
}

impl<S: Read> Read for Faulty<'_, S> {
    fn read(&mut self, bytes: &mut [u8]) -> io::Result<usize> {
        let most = self.next()?;
        let len = bytes.len().min(most);
        self.stream.read(&mut bytes[..len])
    }
}

/// Writes to files that have these faults, and tells the calls they got.
fn write_to_faulty(
    mesh: &TriMesh,
    way: (Format, WriteOptions),
    fault: Option<(usize, Fault)>,
    most: Option<usize>,
) -> (Result<Vec<Vec<u8>>, WriteError>, usize) {
    let calls = AtomicUsize::new(0);
    let file = || ("grid.bin", Faulty { stream: Vec::new(), calls: &calls, fault, most });
    let mut files: Vec<_> = (0..file_count(way.0)).map(|_| file()).collect();
    let result = write(mesh, way, &mut files);
    let files = files.into_iter().map(|(_, file)| file.stream).collect();
    (result.map(|()| files), calls.into_inner())
}

#[test]
fn short_and_interrupted_writes_give_the_same_bytes() {
    let mesh = grid(9, 7);
    for way in ways() {
        let whole = written(&mesh, way);
        let (pieces, calls) = write_to_faulty(&mesh, way, None, Some(5));
        let least = whole.iter().map(Vec::len).sum::<usize>() / 5;
        assert!(calls > least, "{way:?}: {calls} calls");
        assert_eq!(pieces.unwrap(), whole, "{way:?}");
    }
}

/// Each write fails that there is, or the first, one in the middle and the last.
fn errors_of_writes_are_told(mesh: &TriMesh, most: Option<usize>) {
    for way in ways() {
        let (_, calls) = write_to_faulty(mesh, way, None, most);
        assert!(calls > 0);
        for at in BTreeSet::from([0, calls / 2, calls - 1]) {
            let kind = [ErrorKind::StorageFull, ErrorKind::BrokenPipe][at % 2];
            let fault = Some((at, Fault::Kind(kind)));
            match write_to_faulty(mesh, way, fault, most).0 {
                Err(WriteError::Io(error)) => assert_eq!(error.kind(), kind, "{way:?}"),
                other => unreachable!("{way:?}, write {at} of {calls}: {other:?}"),
            }
            match write_to_faulty(mesh, way, Some((at, Fault::Nothing)), most).0 {
                Err(WriteError::Io(error)) => {
                    assert_eq!(error.kind(), ErrorKind::WriteZero, "{way:?}");
                }
                other => unreachable!("{way:?}, write {at} of {calls}: {other:?}"),
            }
        }
    }
}

/// Large enough for sections of several blocks, and so several writes.
#[test]
fn whichever_write_of_a_large_mesh_fails_its_error_is_told() {
    errors_of_writes_are_told(&grid(110, 90), None);
}

#[test]
fn whichever_short_write_fails_its_error_is_told() {
    errors_of_writes_are_told(&grid(4, 3), Some(40));
}

/// Reads a file that has these faults, and tells the calls it got.
fn read_faulty(
    format: Format,
    files: &[Vec<u8>],
    fault: Option<(usize, Fault)>,
    most: Option<usize>,
) -> (Result<TriMesh, ReadError>, usize) {
    let calls = AtomicUsize::new(0);
    let input = Faulty { stream: &files[0][..], calls: &calls, fault, most };
    let beside = |name: &str| {
        let index = if name.ends_with(".poly") { 2 } else { 1 };
        files.get(index).cloned().ok_or(ErrorKind::NotFound.into())
    };
    let name = format!("grid.{}", format.extension());
    let mesh = read_as(format, Path::new(&name), BufReader::with_capacity(64, input), beside);
    (mesh, calls.into_inner())
}

#[test]
fn short_and_interrupted_reads_give_the_same_mesh() {
    let mesh = grid(9, 7);
    for way in ways().into_iter().filter(|(format, _)| Format::READ.contains(format)) {
        let files = written(&mesh, way);
        let whole = read_faulty(way.0, &files, None, None).0.unwrap();
        let pieces = read_faulty(way.0, &files, None, Some(7)).0;
        assert_eq!(pieces.unwrap(), whole, "{way:?}");
        assert_eq!(whole.triangles().len(), mesh.triangles().len(), "{way:?}");
    }
}

#[test]
fn whichever_read_fails_its_error_is_told() {
    let mesh = grid(4, 3);
    for way in ways().into_iter().filter(|(format, _)| Format::READ.contains(format)) {
        let files = written(&mesh, way);
        let (_, calls) = read_faulty(way.0, &files, None, Some(40));
        for at in (0..calls).step_by((calls / 25).max(1)).chain([calls - 1]) {
            let fault = Some((at, Fault::Kind(ErrorKind::TimedOut)));
            match read_faulty(way.0, &files, fault, Some(40)).0 {
                Err(ReadError::Io(error)) => assert_eq!(error.kind(), ErrorKind::TimedOut),
                // The bytes after the last triangle need not be asked for.
                Ok(read) if at == calls - 1 => assert_eq!(read.triangles().len(), 24),
                other => unreachable!("{way:?}, read {at} of {calls}: {other:?}"),
            }
        }
    }
}
