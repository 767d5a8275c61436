//! A mesh that is written and read again is the same, and a file that is damaged between is an error
//! or another mesh, never a panic.

use glam::{DVec2, DVec3};
use mindeg::BoundaryMesh;
use mindeg_formats::{MeshPlane, SurfaceOptions, glb, gltf, obj};
use mindeg_mesh::TriMesh;
use proptest::prelude::*;
use std::io;

fn options() -> impl Strategy<Value = SurfaceOptions> {
    (any::<[bool; 4]>(), prop_oneof![Just(MeshPlane::Xy), Just(MeshPlane::Floor)]).prop_map(
        |([normals, texture_coordinates, degree_colors, boundary_lines], plane)| SurfaceOptions {
            normals,
            texture_coordinates,
            degree_colors,
            boundary_lines,
            plane,
        },
    )
}

/// Where the options put a point.
fn place(point: DVec2, plane: MeshPlane) -> DVec3 {
    match plane {
        MeshPlane::Xy => DVec3::new(point.x, point.y, 0.0),
        MeshPlane::Floor => DVec3::new(point.x, 0.0, -point.y),
    }
}

fn obj(mesh: &BoundaryMesh, options: &SurfaceOptions) -> Vec<u8> {
    let mut file = Vec::new();
    obj::write(mesh, options, &mut file).unwrap();
    file
}

fn glb(mesh: &BoundaryMesh, options: &SurfaceOptions) -> Vec<u8> {
    let mut file = Vec::new();
    glb::write(mesh, options, &mut file).unwrap();
    file
}

fn no_files(_: &str) -> io::Result<Vec<u8>> {
    Err(io::ErrorKind::Unsupported.into())
}

/// The triangles, the lines that were left out, and the boundary, which is the ring of all
/// vertices.
fn check(
    mesh: &BoundaryMesh,
    read: &TriMesh,
    options: &SurfaceOptions,
) -> Result<(), TestCaseError> {
    prop_assert!(read.triangles().iter().copied().eq(mesh.triangles()));
    let lines = if options.boundary_lines { mesh.vertex_count() } else { 0 };
    prop_assert_eq!(read.non_triangles().line_segments, u64::from(lines));
    let loops = read.boundary_loops();
    prop_assert_eq!(loops.len(), 1);
    prop_assert!(loops[0].closed);
    prop_assert!(loops[0].vertices.iter().copied().eq(0..mesh.vertex_count()));
    Ok(())
}

proptest! {
    #[test]
    fn obj_keeps_every_bit(mesh in crate::polygons::meshes(), options in options()) {
        let read = obj::read(obj(&mesh, &options).as_slice()).unwrap();
        check(&mesh, &read, &options)?;
        prop_assert_eq!(read.positions().len(), mesh.vertex_count() as usize);
        for (position, point) in read.positions().iter().zip(mesh.points()) {
            prop_assert_eq!(*position, place(point, options.plane));
        }
    }

    #[test]
    fn gltf_keeps_what_32_bit_floats_can(mesh in crate::polygons::meshes(), options in options()) {
        let read = glb::read(glb(&mesh, &options).as_slice(), no_files).unwrap();
        check(&mesh, &read, &options)?;
        prop_assert_eq!(read.positions().len(), mesh.vertex_count() as usize);
        // No coordinate is stored larger than eight and a half times the size of the domain
        // (at most 10), and rounding changes it by one part in 2^24 at most.
        let unit = 85.0 / f64::from(1 << 24);
        for (position, point) in read.positions().iter().zip(mesh.points()) {
            let error = (*position - place(point, options.plane)).abs().max_element();
            prop_assert!(error <= unit, "{} at {}", error, position);
        }

        let (mut json, mut bin) = (Vec::new(), Vec::new());
        gltf::write(&mesh, &options, "a b.bin", &mut json, &mut bin).unwrap();
        let again = glb::read(json.as_slice(), |name| {
            assert_eq!(name, "a b.bin");
            Ok(bin.clone())
        });
        prop_assert_eq!(again.unwrap(), read);
    }

    #[test]
    fn the_same_mesh_gives_the_same_bytes(mesh in crate::polygons::meshes(), options in options()) {
        let copy = mesh.clone();
        prop_assert_eq!(obj(&mesh, &options), obj(&copy, &options));
        prop_assert_eq!(glb(&mesh, &options), glb(&copy, &options));
    }
}

/// How a file can be damaged: bits turned over, bytes cut out or doubled, the end missing.
#[derive(Clone, Debug)]
enum Damage {
    Flip(usize, u8),
    Cut(usize, usize),
    Repeat(usize, usize),
    Truncate(usize),
    Digit(usize, u8),
}

fn damage() -> impl Strategy<Value = Damage> {
    prop_oneof![
        (any::<usize>(), 0..8_u8).prop_map(|(at, bit)| Damage::Flip(at, bit)),
        (any::<usize>(), 1..40_usize).prop_map(|(at, count)| Damage::Cut(at, count)),
        (any::<usize>(), 1..40_usize).prop_map(|(at, count)| Damage::Repeat(at, count)),
        any::<usize>().prop_map(Damage::Truncate),
        (any::<usize>(), b'-'..=b'9').prop_map(|(at, byte)| Damage::Digit(at, byte)),
    ]
}

fn damaged(mut file: Vec<u8>, damages: &[Damage]) -> Vec<u8> {
    for damage in damages {
        let len = file.len();
        if len == 0 {
            break;
        }
        match *damage {
            Damage::Flip(at, bit) => file[at % len] ^= 1 << bit,
            Damage::Cut(at, count) => drop(file.drain(at % len..(at % len + count).min(len))),
            Damage::Repeat(at, count) => {
                let piece = file[at % len..(at % len + count).min(len)].to_vec();
                file.splice(at % len..at % len, piece);
            }
            Damage::Truncate(at) => file.truncate(at % len),
            // Digits are where numbers go wrong; look for the next one.
            Damage::Digit(at, byte) => {
                let digit = (at % len..len).find(|&i| file[i].is_ascii_digit());
                digit.into_iter().for_each(|i| file[i] = byte);
            }
        }
    }
    file
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(800))]

    #[test]
    fn no_damage_makes_a_reader_panic(
        mesh in crate::polygons::meshes(),
        options in options(),
        damages in prop::collection::vec(damage(), 1..4),
    ) {
        for file in [obj(&mesh, &options), glb(&mesh, &options)] {
            let file = damaged(file, &damages);
            let meshes =
                [obj::read(file.as_slice()), glb::read(file.as_slice(), no_files)];
            for mesh in meshes.into_iter().flatten() {
                let _ = mesh.boundary_loops();
            }
        }
        let (mut json, mut bin) = (Vec::new(), Vec::new());
        gltf::write(&mesh, &options, "x.bin", &mut json, &mut bin).unwrap();
        let json = damaged(json, &damages);
        if let Ok(mesh) = glb::read(json.as_slice(), |_| Ok(bin.clone())) {
            let _ = mesh.boundary_loops();
        }
    }
}
