//! Where the nodes of a scene are.

use super::schema::{Document, Node, Real, Whole, named};
use crate::ReadError;
use glam::{DMat4, DQuat, DVec3};

/// The nodes of the scene with what moves them to it, parents before children.
pub(super) fn placed_nodes(document: &Document<'_>) -> Result<Vec<(usize, DMat4)>, ReadError> {
    let nodes = &document.nodes;
    let named_node = |index: Whole, named_at: &dyn Fn() -> String| {
        named(("nodes", &nodes[..]), index, named_at).map(|(index, _)| index)
    };
    let scene = match document.scene {
        Some(scene) => Some(named(("scenes", &document.scenes), scene, || "scene".to_owned())?),
        None => document.scenes.first().map(|scene| (0, scene)),
    };
    let mut waiting = Vec::new();
    if let Some((scene_index, scene)) = scene {
        for (i, &root) in scene.nodes.iter().enumerate() {
            let root = named_node(root, &|| format!("scenes[{scene_index}].nodes[{i}]"))?;
            waiting.push((root, DMat4::IDENTITY));
        }
    } else {
        // Without scenes, all nodes are shown.
        let mut is_child = vec![false; nodes.len()];
        for child in nodes.iter().flat_map(|node| &node.children) {
            let child = usize::try_from(child.0).ok().and_then(|child| is_child.get_mut(child));
            // A child that does not exist is found below.
            child.into_iter().for_each(|is_child| *is_child = true);
        }
        let roots = (0..nodes.len()).filter(|&node| !is_child[node]);
        waiting.extend(roots.map(|root| (root, DMat4::IDENTITY)));
    }
    waiting.reverse();
    let mut seen = vec![false; nodes.len()];
    let mut placed = Vec::new();
    while let Some((index, parent)) = waiting.pop() {
        if std::mem::replace(&mut seen[index], true) {
            let problem = "is reached twice, and nodes must form trees";
            return Err(ReadError::place(format!("nodes[{index}]"), problem));
        }
        let node = &nodes[index];
        let to_scene = parent * matrix(node, index)?;
        for (i, &child) in node.children.iter().enumerate().rev() {
            let child = named_node(child, &|| format!("nodes[{index}].children[{i}]"))?;
            waiting.push((child, to_scene));
        }
        placed.push((index, to_scene));
    }
    Ok(placed)
}

/// The transform of a node relative to its parent.
fn matrix(node: &Node, index: usize) -> Result<DMat4, ReadError> {
    if let Some(matrix) = node.matrix {
        return Ok(DMat4::from_cols_array(&matrix.map(|Real(number)| number)));
    }
    let vector = |numbers: Option<[Real; 3]>, none: DVec3| {
        numbers.map_or(none, |numbers| DVec3::from_array(numbers.map(|Real(number)| number)))
    };
    let rotation = match node.rotation {
        None => DQuat::IDENTITY,
        Some(numbers) => {
            let rotation = DQuat::from_array(numbers.map(|Real(number)| number)).normalize();
            if !rotation.is_finite() {
                let problem = "is not a rotation; its length must be 1";
                return Err(ReadError::place(format!("nodes[{index}].rotation"), problem));
            }
            rotation
        }
    };
    Ok(DMat4::from_scale_rotation_translation(
        vector(node.scale, DVec3::ONE),
        rotation,
        vector(node.translation, DVec3::ZERO),
    ))
}
