//! Reading accessors whose every byte is known to be there.

use super::read::place;
use crate::ReadError;
use gltf::Accessor;
use gltf::accessor::sparse::IndexType;
use gltf::accessor::{DataType, Dimensions, Item, Iter};
use gltf::buffer::View;
use std::borrow::Cow;

/// The bytes of a document's buffers.
pub(super) type Buffers<'a> = [Cow<'a, [u8]>];

/// The positions that an accessor holds.
pub(super) fn positions<'a>(
    accessor: &Accessor,
    buffers: &'a Buffers,
) -> Result<impl Iterator<Item = [f32; 3]> + use<'a>, ReadError> {
    if (accessor.data_type(), accessor.dimensions()) != (DataType::F32, Dimensions::Vec3) {
        return Err(problem(accessor, "is used for positions, and those are three 32-bit floats"));
    }
    items(accessor, buffers)
}

/// The indices that an accessor holds.
pub(super) fn indices(accessor: &Accessor, buffers: &Buffers) -> Result<Vec<u32>, ReadError> {
    match (accessor.data_type(), accessor.dimensions()) {
        (DataType::U8, Dimensions::Scalar) => {
            Ok(items::<u8>(accessor, buffers)?.map(u32::from).collect())
        }
        (DataType::U16, Dimensions::Scalar) => {
            Ok(items::<u16>(accessor, buffers)?.map(u32::from).collect())
        }
        (DataType::U32, Dimensions::Scalar) => Ok(items::<u32>(accessor, buffers)?.collect()),
        _ => Err(problem(accessor, "is used for indices, and those are unsigned integers")),
    }
}

/// The items of an accessor of which the type has been checked.
fn items<'a, T: Item>(accessor: &Accessor, buffers: &'a Buffers) -> Result<Iter<'a, T>, ReadError> {
    check_bounds(accessor, buffers).map_err(|what| problem(accessor, what))?;
    Iter::new(accessor.clone(), |buffer| buffers.get(buffer.index()).map(|bytes| &**bytes))
        .ok_or_else(|| problem(accessor, "reaches beyond its buffer"))
}

fn problem(accessor: &Accessor, what: impl Into<String>) -> ReadError {
    place(format!("accessors[{}]", accessor.index()), what)
}

/// Whether all items are within the buffers. The gltf crate computes where they are without
/// a thought of overflow.
fn check_bounds(accessor: &Accessor, buffers: &Buffers) -> Result<(), String> {
    let view = accessor.view().ok_or("has no buffer view, and one without is not supported")?;
    check_view(&view, accessor.offset(), accessor.count(), accessor.size(), buffers)?;
    if let Some(sparse) = accessor.sparse() {
        let (indices, values, count) = (sparse.indices(), sparse.values(), sparse.count());
        let index_size = match indices.index_type() {
            IndexType::U8 => 1,
            IndexType::U16 => 2,
            IndexType::U32 => 4,
        };
        check_view(&indices.view(), indices.offset(), count, index_size, buffers)?;
        check_view(&values.view(), values.offset(), count, accessor.size(), buffers)?;
    }
    Ok(())
}

fn check_view(
    view: &View,
    offset: usize,
    count: usize,
    size: usize,
    buffers: &Buffers,
) -> Result<(), String> {
    let stride = view.stride().unwrap_or(size);
    if count == 0 {
        return Err("holds no items, and must hold at least one".to_owned());
    }
    if stride < size {
        return Err(format!("has items of {size} bytes, {stride} bytes apart"));
    }
    let end = (count - 1)
        .checked_mul(stride)
        .and_then(|last| last.checked_add(size))
        .and_then(|end| end.checked_add(offset));
    let in_view = end.is_some_and(|end| end <= view.length());
    let in_buffer = view
        .offset()
        .checked_add(view.length())
        .is_some_and(|end| buffers.get(view.buffer().index()).is_some_and(|b| end <= b.len()));
    match (in_view, in_buffer) {
        (true, true) => Ok(()),
        (false, _) => Err(format!("reaches beyond bufferViews[{}]", view.index())),
        (true, false) => Err(format!(
            "lies in bufferViews[{}], which reaches beyond buffers[{}]",
            view.index(),
            view.buffer().index()
        )),
    }
}
