//! The materials of a mesh, each once.

use std::collections::HashMap;
use std::sync::Arc;

use mindeg_mesh::{Group, Material, Triangles};

/// The materials that the groups of a mesh have.
#[derive(Default)]
pub(crate) struct Materials {
    /// In the order of the first groups that have them.
    pub(crate) list: Vec<Arc<Material>>,
    /// For each group the index of its material.
    pub(crate) of_group: Vec<Option<usize>>,
}

impl Materials {
    /// O(n) for n groups.
    pub(crate) fn of<T: Triangles + ?Sized>(mesh: &T) -> Self {
        let mut materials = Self::default();
        let mut indices = HashMap::new();
        for group in mesh.groups() {
            let index = group.material.as_ref().map(|material| {
                let color = material.color.map(|color| color.map(f32::to_bits));
                *indices.entry((&*material.name, color)).or_insert_with(|| {
                    materials.list.push(Arc::clone(material));
                    materials.list.len() - 1
                })
            });
            materials.of_group.push(index);
        }
        materials
    }
}

/// Whether two groups in a row are parts of one object: they have the same name, and differ in their
/// materials alone.
pub(crate) fn is_same_object(a: &Group, b: &Group) -> bool {
    a.name == b.name && a.material != b.material
}
