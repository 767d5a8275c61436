//! Meshes of models by annealing, at first of those that look the same from several sides: there the faces that a symmetry
//! moves onto others follow these.
//!
//! A symmetry moves every face onto a congruent one, and neighbours onto neighbours. Take a group of them in which all but
//! the identity move every face. Then one face of each orbit decides about all, and a vertex has, for each symmetry that
//! keeps it, the chords of its whole orbit on these faces. So annealing over few faces, with one limit for an orbit
//! of vertices, finds the meshes with these symmetries sooner than one over all faces, which comes last.
//!
//! Limits: symmetries of closed models whose faces have no holes, and groups of one symmetry or of two that are their own inverses.

use glam::DVec2;
use mindeg_exact::{Problem, anneal};
use mindeg_mesh::{Cancelled, Progress};
use std::collections::BTreeMap;

use super::joint::Joint;

/// The most groups that are tried, from the largest down.
const MOST_GROUPS: usize = 2;

/// The flips that are tried by default: some eight seconds on one core.
const TRIES: u64 = 1 << 29;

/// The most places of faces that are compared.
const MOST_COMPARED: usize = 20_000_000;

/// Lengths that differ by less than this share of a face's size are equal.
const TOLERANCE: f64 = 1e-9;

/// For each face the face that it is moved onto, and the place of its first vertex there.
type Symmetry = Vec<(usize, usize)>;

/// Looks for a mesh of no larger degree by annealing, at first for one that keeps some symmetries; whether it found one.
pub(super) fn reach(
    joint: &mut Joint,
    degree: u32,
    effort: f64,
    progress: Progress<'_>,
) -> Result<bool, Cancelled> {
    let mut left = (TRIES as f64 * effort.max(0.0)) as u64;
    let identity = (0..joint.triangles.len()).map(|face| (face, 0)).collect();
    let symmetric = groups(joint, &symmetries(joint));
    let few = symmetric.len();
    for (index, group) in symmetric.into_iter().chain([vec![identity]]).enumerate() {
        // The more symmetries, the sooner one is found.
        let tries = if index < few { left / 2 } else { left };
        left -= tries;
        if let Some(found) = search(joint, &group, degree, tries, progress)? {
            found.into_iter().enumerate().for_each(|(face, own)| joint.replace(face, own));
            return Ok(true);
        }
    }
    Ok(false)
}

/// All symmetries, the identity first.
fn symmetries(joint: &Joint) -> Vec<Symmetry> {
    let faces = joint.triangles.len();
    let size = |face: usize| joint.face(face).vertices.len();
    let places: usize = (0..faces).map(size).sum();
    let is_disk =
        |face: usize| joint.face(face).is_polygon() && joint.face(face).boundary.ring_count() == 1;
    // The first face goes to any face of its size, with its first vertex to any place.
    let images = (0..faces).filter(|&face| size(face) == size(0));
    let images: Vec<_> =
        images.flat_map(|face| (0..size(face)).map(move |place| (face, place))).collect();
    if !(0..faces).all(is_disk) || places * images.len() > MOST_COMPARED {
        return Vec::new();
    }
    let mut edges = BTreeMap::new();
    for face in 0..faces {
        let vertices = &joint.face(face).vertices;
        for (place, &from) in vertices.iter().enumerate() {
            let to = vertices[(place + 1) % vertices.len()];
            if edges.insert([from, to], (face, place)).is_some() {
                return Vec::new();
            }
        }
    }
    let mut found: Vec<Symmetry> =
        images.into_iter().filter_map(|image| symmetry(joint, &edges, image)).collect();
    found.sort_by_key(|symmetry| !is_identity(symmetry));
    found
}

/// The symmetry that moves the first face onto another, if there is one.
fn symmetry(
    joint: &Joint,
    edges: &BTreeMap<[u32; 2], (usize, usize)>,
    first: (usize, usize),
) -> Option<Symmetry> {
    let vertices = |face: usize| &joint.face(face).vertices;
    // Across an edge lie the face with its reverse and the place where that begins.
    let beyond = |face: usize, place: usize| {
        let own = vertices(face);
        edges.get(&[own[(place + 1) % own.len()], own[place]]).copied()
    };
    let mut images: Vec<Option<(usize, usize)>> = vec![None; joint.triangles.len()];
    images[0] = Some(first);
    let mut open = vec![0];
    while let Some(face) = open.pop() {
        let (image, shift) = images[face]?;
        let n = vertices(face).len();
        if !is_congruent(joint, face, image, shift) {
            return None;
        }
        for place in 0..n {
            let (next, at) = beyond(face, place)?;
            let (next_image, image_at) = beyond(image, (place + shift) % n)?;
            let size = vertices(next_image).len();
            let moved = (next_image, (image_at + size - at % size) % size);
            match images[next] {
                Some(before) if before != moved => return None,
                Some(_) => {}
                None => {
                    images[next] = Some(moved);
                    open.push(next);
                }
            }
        }
    }
    let images = images.into_iter().collect::<Option<Symmetry>>()?;
    // Two parts of a model may go to the same place.
    let mut is_met = vec![false; images.len()];
    images.iter().for_each(|&(image, _)| is_met[image] = true);
    is_met.iter().all(|&met| met).then_some(images)
}

/// Whether a face has the sides and points of another, from that place on.
fn is_congruent(joint: &Joint, face: usize, image: usize, shift: usize) -> bool {
    let [own, other] = [face, image].map(|face| &joint.face(face).boundary);
    let n = own.points().len();
    if other.points().len() != n {
        return false;
    }
    let size = own.points().iter().map(|point| point.distance(own.points()[0])).fold(0.0, f64::max);
    let near = |a: f64, b: f64| (a - b).abs() <= TOLERANCE * size;
    let at = |points: &[DVec2], place: usize| points[place % n];
    (0..n).all(|place| {
        let begins = |runs: &[u32], place: usize| runs[place % n] != runs[(place + n - 1) % n];
        // The distances to three vertices in a row that are not on one line fix a point.
        let distances = |points: &[DVec2], from: usize| {
            [0, n / 3, 2 * n / 3]
                .map(|anchor| at(points, from + anchor).distance(at(points, from + place)))
        };
        let pairs = distances(own.points(), 0).into_iter().zip(distances(other.points(), shift));
        begins(own.runs(), place) == begins(other.runs(), place + shift)
            && pairs.into_iter().all(|(a, b)| near(a, b))
    })
}

fn is_identity(symmetry: &Symmetry) -> bool {
    symmetry.iter().enumerate().all(|(face, &image)| image == (face, 0))
}

fn moves_all_faces(symmetry: &Symmetry) -> bool {
    symmetry.iter().enumerate().all(|(face, image)| image.0 != face)
}

/// Groups of symmetries of which all but the identity move every face, the largest first: those that one symmetry
/// makes, and those of two that are their own inverses.
fn groups(joint: &Joint, symmetries: &[Symmetry]) -> Vec<Vec<Symmetry>> {
    let Some(identity) = symmetries.first() else { return Vec::new() };
    let size = |face: usize| joint.face(face).vertices.len();
    // First one symmetry, then another.
    let then = |first: &Symmetry, second: &Symmetry| -> Symmetry {
        let moved = |&(face, place): &(usize, usize)| {
            let (image, shift) = second[face];
            (image, (place + shift) % size(image))
        };
        first.iter().map(moved).collect()
    };
    let mut groups: Vec<Vec<Symmetry>> = Vec::new();
    let mut own_inverses = Vec::new();
    for symmetry in &symmetries[1..] {
        let powers = std::iter::successors(Some(symmetry.clone()), |last| {
            Some(then(last, symmetry)).filter(|next| next != identity)
        });
        let powers: Vec<Symmetry> = powers.collect();
        if powers.iter().all(moves_all_faces) {
            if powers.len() == 1 {
                own_inverses.push(symmetry);
            }
            groups.push([vec![identity.clone()], powers].concat());
        }
    }
    for (index, first) in own_inverses.iter().enumerate() {
        for second in &own_inverses[..index] {
            let both = then(first, second);
            if both == then(second, first) && moves_all_faces(&both) {
                let own = [identity, first, second, &both].map(Symmetry::clone);
                groups.push(own.to_vec());
            }
        }
    }
    groups.sort_by_key(|group| std::cmp::Reverse(group.len()));
    // Groups of one size are mostly the same one, seen from another side.
    groups.dedup_by_key(|group| group.len());
    groups.truncate(MOST_GROUPS);
    groups
}

/// The triangles of every face of a mesh with these symmetries and degrees up to `degree`, if annealing finds one.
fn search(
    joint: &Joint,
    group: &[Symmetry],
    degree: u32,
    tries: u64,
    progress: Progress<'_>,
) -> Result<Option<Vec<Vec<[u32; 3]>>>, Cancelled> {
    let vertices = |face: usize| &joint.face(face).vertices;
    let faces = 0..joint.triangles.len();
    let first_of_orbit = |face: usize| group.iter().map(|it| it[face].0).min().unwrap_or(face);
    let firsts: Vec<usize> = faces.clone().filter(|&face| first_of_orbit(face) == face).collect();
    // The least vertex of each orbit, and how many symmetries keep a vertex.
    let mut least: Vec<u32> = (0..joint.totals.len() as u32).collect();
    let mut keeping: Vec<u32> = vec![0; least.len()];
    let mut is_seen = vec![false; least.len()];
    for face in faces.clone() {
        for (place, &vertex) in vertices(face).iter().enumerate() {
            if std::mem::replace(&mut is_seen[vertex as usize], true) {
                continue;
            }
            for symmetry in group {
                let (image, shift) = symmetry[face];
                let moved = vertices(image)[(place + shift) % vertices(image).len()];
                keeping[vertex as usize] += u32::from(moved == vertex);
                least[vertex as usize] = least[vertex as usize].min(moved);
            }
        }
    }
    let mut most: Vec<u32> = Vec::with_capacity(least.len());
    for (&edges, &keeping) in joint.edge_degrees.iter().zip(&keeping) {
        let Some(left) = degree.checked_sub(edges) else { return Ok(None) };
        most.push(left / keeping.max(1));
    }
    let problem = |&face: &usize| joint.face(face).problem(&joint.triangles[face]);
    let Some(problems) = firsts.iter().map(problem).collect::<Option<Vec<Problem>>>() else {
        return Ok(None);
    };
    let of_orbits = |&face: &usize| vertices(face).iter().map(|&v| least[v as usize]).collect();
    let orbits: Vec<Vec<u32>> = firsts.iter().map(of_orbits).collect();
    let posed: Vec<_> = problems.iter().zip(&orbits).map(|(it, own)| (it, &own[..])).collect();
    let tangents: Vec<f64> = firsts.iter().map(|&face| joint.thresholds[face]).collect();
    let Some(own) = anneal(&posed, &most, &tangents, tries, progress)? else { return Ok(None) };
    let mut found = vec![Vec::new(); faces.len()];
    for (&face, triangles) in firsts.iter().zip(&own) {
        for symmetry in group {
            let (image, shift) = symmetry[face];
            let n = vertices(image).len() as u32;
            let moved = |place: u32| (place + shift as u32) % n;
            found[image] = triangles.iter().map(|triangle| triangle.map(moved)).collect();
        }
    }
    let holds = |face: usize| {
        let own = joint.face(face);
        let is_wide = joint.thresholds[face] <= 0.0
            || own.min_tangent(&found[face]) >= joint.thresholds[face];
        is_wide && own.problem(&found[face]).is_some()
    };
    Ok(faces.clone().all(holds).then_some(found))
}

#[cfg(test)]
mod tests {
    use super::super::of_model;
    use super::*;
    use mindeg_domain::Model;

    fn of_box(size: [f64; 3], intervals: u32) -> Model {
        let [x, y, z] = size;
        let corners = format!(
            "[[0,0,0], [{x},0,0], [{x},{y},0], [0,{y},0], [0,0,{z}], [{x},0,{z}], [{x},{y},{z}], [0,{y},{z}]]"
        );
        let step = 1.000_001 / f64::from(intervals);
        let faces = "[[0,3,2,1], [4,5,6,7], [0,1,5,4], [1,2,6,5], [2,3,7,6], [3,0,4,7]]";
        let json = format!(r#"{{"corners": {corners}, "faces": {faces}, "size": {step}}}"#);
        Model::from_json(&json).unwrap()
    }

    #[test]
    fn a_cube_has_the_symmetries_of_a_cube() {
        let sizes = |size: [f64; 3]| {
            let model = of_box(size, 1);
            let joint = of_model(&model, &model.positions(), None, Progress::NONE).unwrap();
            let all = symmetries(&joint);
            let groups = groups(&joint, &all);
            (all.len(), groups.iter().map(Vec::len).collect::<Vec<_>>())
        };
        assert_eq!(sizes([1.0; 3]), (24, vec![3, 2]));
        // Of a square prism, two half turns move every face.
        assert_eq!(sizes([1.0, 1.0, 3.0]), (8, vec![2]));
        assert_eq!(sizes([1.0, 2.0, 3.0]), (4, vec![]));
    }

    #[test]
    fn a_mesh_with_symmetries_keeps_the_degree() {
        let model = of_box([1.0; 3], 3);
        let mut joint = of_model(&model, &model.positions(), None, Progress::NONE).unwrap();
        assert!(!reach(&mut joint, 5, 0.01, Progress::NONE).unwrap());
        assert!(joint.max_degree() > 6);
        assert!(reach(&mut joint, 6, 0.1, Progress::NONE).unwrap());
        assert_eq!(joint.max_degree(), 6);
        let mut totals = joint.edge_degrees.clone();
        for (face, triangles) in joint.triangles.iter().enumerate() {
            let face = joint.face(face);
            assert!(face.problem(triangles).is_some());
            let chords = face.chords(triangles);
            chords.iter().zip(&face.vertices).for_each(|(chords, &v)| totals[v as usize] += chords);
        }
        assert_eq!(totals, joint.totals);
    }
}
