//! Faces in classes of which no two share a vertex: those of one class can be solved together.

use super::joint::Joint;

/// The faces of each class, ascending; every face once, in the first class that has none of its
/// neighbours. O(vertices of faces), times the classes at a vertex.
pub(super) fn classes(joint: &Joint) -> Vec<Vec<usize>> {
    let mut used: Vec<Vec<u64>> = vec![Vec::new(); joint.totals.len()];
    let mut classes: Vec<Vec<usize>> = Vec::new();
    for face in 0..joint.face_count() {
        let vertices = &joint.face(face).vertices;
        let is_free = |class: usize| {
            let bit = |words: &Vec<u64>| {
                words.get(class / 64).is_some_and(|w| w >> (class % 64) & 1 == 1)
            };
            !vertices.iter().any(|&vertex| bit(&used[vertex as usize]))
        };
        let class = (0..classes.len()).find(|&class| is_free(class)).unwrap_or(classes.len());
        if class == classes.len() {
            classes.push(Vec::new());
        }
        classes[class].push(face);
        for &vertex in vertices {
            let words = &mut used[vertex as usize];
            if words.len() <= class / 64 {
                words.resize(class / 64 + 1, 0);
            }
            words[class / 64] |= 1 << (class % 64);
        }
    }
    classes
}
