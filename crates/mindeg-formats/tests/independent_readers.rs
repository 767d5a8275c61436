//! Written meshes, read by tobj and the gltf crate, which share nothing with our readers.

use glam::DVec3;
use mindeg::{BoundaryMesh, Domain};
use mindeg_formats::{SurfaceOptions, glb, obj};
use mindeg_mesh::{Group, Mesh, TriMesh, filled};
use proptest::prelude::*;
use std::path::Path;

fn positions(mesh: &dyn Mesh) -> Vec<DVec3> {
    filled(0..mesh.vertex_count(), DVec3::ZERO, |first, out| mesh.fill_positions(first, out))
}

fn triangles(mesh: &dyn Mesh) -> Vec<[u32; 3]> {
    filled(0..mesh.triangle_count(), [0; 3], |first, out| mesh.fill_triangles(first, out))
}

/// Options without normals and texture coordinates, since tobj would count by those too.
const OPTIONS: SurfaceOptions = SurfaceOptions {
    normals: false,
    texture_coordinates: false,
    degree_colors: false,
    boundary_lines: false,
    plane: mindeg_formats::MeshPlane::Xy,
};

/// The corners of all faces, as tobj sees them.
fn corners_by_tobj(mesh: &dyn Mesh, options: &SurfaceOptions) -> Vec<[DVec3; 3]> {
    let mut file = Vec::new();
    obj::write(mesh, options, &mut file).unwrap();
    let load = tobj::LoadOptions { single_index: false, ..tobj::LoadOptions::default() };
    let no_material = |_: &Path| Err(tobj::LoadError::OpenFileFailed);
    let (models, _) = tobj::load_obj_buf(&mut &file[..], &load, no_material).unwrap();
    let mut faces = Vec::new();
    for model in &models {
        assert!(model.mesh.face_arities.is_empty(), "every face is a triangle");
        let point = |&v: &u32| DVec3::from_slice(&model.mesh.positions[3 * v as usize..]);
        faces.extend(model.mesh.indices.chunks(3).map(|f| [0, 1, 2].map(|i| point(&f[i]))));
    }
    faces
}

/// The positions and triangles of every node with triangles, as the gltf crate sees them.
fn meshes_by_gltf(mesh: &dyn Mesh, options: &SurfaceOptions) -> Vec<(Vec<DVec3>, Vec<[u32; 3]>)> {
    let mut file = Vec::new();
    glb::write(mesh, options, &mut file).unwrap();
    let gltf = gltf::Gltf::from_slice(&file).unwrap();
    let binary = gltf.blob.as_deref();
    let mut found = Vec::new();
    for primitive in gltf.meshes().flat_map(|mesh| mesh.primitives()) {
        let reader = primitive.reader(|_| binary);
        let points = reader.read_positions().unwrap();
        let points = points.map(|[x, y, z]| DVec3::new(x.into(), y.into(), z.into()));
        let indices: Vec<u32> = reader.read_indices().unwrap().into_u32().collect();
        if primitive.mode() == gltf::mesh::Mode::Triangles {
            let faces = indices.chunks(3).map(|face| [face[0], face[1], face[2]]);
            found.push((points.collect(), faces.collect()));
        }
    }
    found
}

fn check(mesh: &dyn Mesh, options: &SurfaceOptions) {
    let (points, faces) = (positions(mesh), triangles(mesh));
    let corners: Vec<_> = faces.iter().map(|face| face.map(|v| points[v as usize])).collect();
    assert_eq!(corners_by_tobj(mesh, options), corners);

    let mut file = Vec::new();
    glb::write(mesh, options, &mut file).unwrap();
    let gltf = gltf::Gltf::from_slice(&file).unwrap();
    let root = gltf.default_scene().unwrap().nodes().next().unwrap();
    let (translation, _, _) = root.transform().decomposed();
    let moved = DVec3::from_array(translation.map(f64::from));
    let mut all = Vec::new();
    for (found, faces) in meshes_by_gltf(mesh, options) {
        let stored: Vec<_> = points.iter().map(|p| (*p - moved).as_vec3().as_dvec3()).collect();
        assert_eq!(found, stored);
        all.extend(faces);
    }
    assert_eq!(all, faces);
}

#[test]
fn every_example_domain_is_read_as_it_was_written() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../assets/domains");
    let mut domains: Vec<_> =
        std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    domains.sort();
    domains.retain(|path| path.extension().is_some_and(|end| end == "json"));
    assert!(domains.len() > 3);
    for path in domains {
        let domain = Domain::from_json(&std::fs::read_to_string(&path).unwrap()).unwrap();
        if domain.convex().is_none() {
            continue;
        }
        let mesh = BoundaryMesh::least_degree(&domain).unwrap();
        if mesh.triangle_count() < 200_000 {
            check(&mesh, &OPTIONS);
        }
    }
}

fn meshes() -> impl Strategy<Value = TriMesh> {
    let point = || prop_oneof![-1e3..1e3, Just(0.0), -1e-3..1e-3, 1e5..1e6];
    let points = prop::collection::vec((point(), point(), point()), 3..40);
    let faces = prop::collection::vec(any::<[prop::sample::Index; 3]>(), 1..60);
    (points, faces, any::<prop::sample::Index>()).prop_map(|(points, faces, cut)| {
        let points: Vec<DVec3> = points.into_iter().map(DVec3::from).collect();
        let count = points.len();
        let mut faces: Vec<_> =
            faces.iter().map(|face| face.map(|corner| corner.index(count) as u32)).collect();
        // A point that is one vertex twice is another matter.
        faces.retain(|[a, b, c]| a != b && b != c && c != a);
        faces.push([0, 1, 2]);
        let (cut, end) = (cut.index(faces.len()) as u32, faces.len() as u32);
        let group = |name: &str, triangles| Group::new(name, triangles);
        let groups = vec![group("left", 0..cut), group("right", cut..end)];
        TriMesh::new(points, faces).unwrap().with_groups(groups)
    })
}

proptest! {
    #[test]
    fn any_mesh_is_read_as_it_was_written(mesh in meshes()) {
        check(&mesh, &OPTIONS);
    }

    #[test]
    fn groups_and_points_come_back_through_any_format(mesh in meshes()) {
        let no_files = |_: &str| Err(std::io::ErrorKind::Unsupported.into());
        let mut binary = Vec::new();
        glb::write(&mesh, &SurfaceOptions::default(), &mut binary).unwrap();
        let from_glb = glb::read(&binary[..], no_files).unwrap();
        let mut text = Vec::new();
        obj::write(&from_glb, &SurfaceOptions::default(), &mut text).unwrap();
        let again = obj::read(&text[..]).unwrap();
        prop_assert_eq!(again.positions(), from_glb.positions());
        prop_assert_eq!(again.positions().len(), mesh.positions().len());
        prop_assert_eq!(again.triangles(), mesh.triangles());
        prop_assert_eq!(again.groups(), mesh.groups());
        for (read, point) in again.positions().iter().zip(mesh.positions()) {
            prop_assert!(read.distance(*point) < 1e6 / f64::from(1 << 23));
        }
    }
}
