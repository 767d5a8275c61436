//! Faces in classes of which no two share a corner: those of one class can be solved together.

use mindeg_domain::Model;

/// The faces of each class, ascending; every face once, in the first class that has none of its
/// neighbours. O(corners of faces), times the classes at a corner.
pub(super) fn classes(model: &Model) -> Vec<Vec<usize>> {
    let mut used: Vec<Vec<u64>> = vec![Vec::new(); model.corner_count()];
    let mut classes: Vec<Vec<usize>> = Vec::new();
    for face in 0..model.face_count() {
        let corners: Vec<u32> = model.face_loops(face).flatten().collect();
        let is_free = |class: usize| {
            let bit = |words: &Vec<u64>| {
                words.get(class / 64).is_some_and(|w| w >> (class % 64) & 1 == 1)
            };
            !corners.iter().any(|&corner| bit(&used[corner as usize]))
        };
        let class = (0..classes.len()).find(|&class| is_free(class)).unwrap_or(classes.len());
        if class == classes.len() {
            classes.push(Vec::new());
        }
        classes[class].push(face);
        for corner in corners {
            let words = &mut used[corner as usize];
            if words.len() <= class / 64 {
                words.resize(class / 64 + 1, 0);
            }
            words[class / 64] |= 1 << (class % 64);
        }
    }
    classes
}
