//! The arrays of a document.

use super::container::Buffers;
use super::schema::{Accessor, BufferView, Document, Whole, named};
use crate::ReadError;
use crate::numbers::{Scalar, bits};
use glam::DVec3;

/// A document with the bytes of its buffers.
#[derive(Clone, Copy)]
pub(super) struct Arrays<'a> {
    pub(super) document: &'a Document<'a>,
    pub(super) buffers: &'a Buffers<'a>,
}

/// The type of an array's components, by the code of the format.
fn scalar_of(code: Whole) -> Option<Scalar> {
    Some(match code.0 {
        5120 => Scalar::Signed(1),
        5121 => Scalar::Unsigned(1),
        5122 => Scalar::Signed(2),
        5123 => Scalar::Unsigned(2),
        5125 => Scalar::Unsigned(4),
        5126 => Scalar::Float(4),
        _ => return None,
    })
}

/// The type of an array of indices.
fn index_type(code: Whole) -> Option<Scalar> {
    scalar_of(code).filter(|scalar| matches!(scalar, Scalar::Unsigned(_)))
}

impl<'a> Arrays<'a> {
    /// The positions that an accessor holds, and how far each may be off because of the numbers
    /// that hold it.
    pub(super) fn positions(&self, accessor: usize) -> Result<(Vec<DVec3>, f64), ReadError> {
        let source = &self.document.accessors[accessor];
        let is_quantized = self.document.is_quantized();
        let known = match scalar_of(source.component_type) {
            Some(Scalar::Unsigned(4)) => None,
            Some(Scalar::Float(len)) => Some(Scalar::Float(len)),
            integer => integer.filter(|_| is_quantized),
        };
        let Some(scalar) = known.filter(|_| source.kind == "VEC3") else {
            return Err(no_positions(accessor, is_quantized));
        };
        if scalar == Scalar::Float(4) {
            let value = |b: &[u8]| f64::from(f32::from_le_bytes([b[0], b[1], b[2], b[3]]));
            let point = |b: &[u8]| DVec3::new(value(b), value(&b[4..]), value(&b[8..]));
            let positions = self.decoded(accessor, scalar, 3, DVec3::ZERO, point)?;
            let largest = positions.iter().map(|p| p.abs().max_element()).fold(0.0, f64::max);
            return Ok((positions, largest / f64::from(1 << 24)));
        }
        let size = scalar.len();
        let bits = 8 * size - usize::from(matches!(scalar, Scalar::Signed(_)));
        let largest = f64::from((1 << bits) - 1);
        let value = |item: &[u8]| {
            let value = scalar.float(&item[..size], false);
            if source.normalized { (value / largest).max(-1.0) } else { value }
        };
        let point = |b: &[u8]| DVec3::new(value(b), value(&b[size..]), value(&b[2 * size..]));
        let positions = self.decoded(accessor, scalar, 3, DVec3::ZERO, point)?;
        Ok((positions, if source.normalized { 0.5 / largest } else { 0.5 }))
    }

    /// The indices that an accessor holds.
    pub(super) fn indices(&self, accessor: usize) -> Result<Vec<u32>, ReadError> {
        let source = &self.document.accessors[accessor];
        let component = index_type(source.component_type);
        let Some(component) = component.filter(|_| source.kind == "SCALAR") else {
            let problem = "is used for indices; these must be unsigned integers";
            return Err(ReadError::place(format!("accessors[{accessor}]"), problem));
        };
        self.decoded(accessor, component, 1, 0, |bytes| bits(bytes, false) as u32)
    }

    /// The items of an accessor whose type was checked, each of this number of components.
    /// Items without bytes are `zero`.
    fn decoded<T: Clone>(
        &self,
        accessor: usize,
        component: Scalar,
        components: usize,
        zero: T,
        decode: impl Fn(&[u8]) -> T,
    ) -> Result<Vec<T>, ReadError> {
        let place = || format!("accessors[{accessor}]");
        let Accessor { buffer_view, byte_offset, count, sparse, .. } =
            &self.document.accessors[accessor];
        if count.0 == 0 {
            return Err(ReadError::place(place(), "holds no items, and must hold at least one"));
        }
        let whole = |count: Whole| usize::try_from(count.0).unwrap_or(usize::MAX);
        let mut values = Vec::new();
        let start = Start { view: buffer_view.unwrap_or_default(), offset: *byte_offset };
        if buffer_view.is_some() {
            let items = self.items(place(), start, *count, component, components)?;
            values.try_reserve_exact(items.len())?;
            values.extend(items.map(&decode));
        } else {
            values.try_reserve_exact(whole(*count))?;
            values.resize(whole(*count), zero);
        }
        let Some(sparse) = sparse else { return Ok(values) };
        let place = || format!("accessors[{accessor}].sparse");
        let Some(index_type) = index_type(sparse.indices.component_type) else {
            let problem = "has indices that are not unsigned integers";
            return Err(ReadError::place(place(), problem));
        };
        let start = Start { view: sparse.indices.buffer_view, offset: sparse.indices.byte_offset };
        let indices = self.items(place(), start, sparse.count, index_type, 1)?;
        let start = Start { view: sparse.values.buffer_view, offset: sparse.values.byte_offset };
        let items = self.items(place(), start, sparse.count, component, components)?;
        for (bytes, item) in indices.zip(items) {
            let (index, count) = (bits(bytes, false), values.len());
            let value = usize::try_from(index).ok().and_then(|index| values.get_mut(index));
            let value = value.ok_or_else(|| {
                ReadError::place(place(), format!("has the index {index}, and {count} items"))
            })?;
            *value = decode(item);
        }
        Ok(values)
    }

    /// The bytes of each of `count` items.
    fn items(
        &self,
        place: String,
        Start { view, offset }: Start,
        count: Whole,
        component: Scalar,
        components: usize,
    ) -> Result<impl ExactSizeIterator<Item = &'a [u8]> + use<'a>, ReadError> {
        let Self { document, buffers } = *self;
        let problem = |problem: String| ReadError::place(place.clone(), problem);
        let views = ("bufferViews", &document.buffer_views[..]);
        let (view_index, view) = named(views, view, || place.clone())?;
        let buffer_place = || format!("bufferViews[{view_index}].buffer");
        let (buffer, _) = named(("buffers", &document.buffers), view.buffer, buffer_place)?;
        let Some(bytes) = &buffers[buffer] else {
            return Err(match view.extensions.meshopt {
                Some(_) => problem(format!(
                    "lies in bufferViews[{view_index}], which is compressed by meshopt \
                     (EXT_meshopt_compression); export the file without it"
                )),
                None => problem(format!("lies in buffers[{buffer}], which has no data")),
            });
        };
        let size = component.len() * components;
        let BufferView { byte_offset, byte_length, byte_stride, .. } = view;
        let stride = byte_stride.map_or(size as u64, |stride| stride.0);
        if count.0 == 0 {
            return Err(problem("holds no items, and must hold at least one".to_owned()));
        }
        if stride < size as u64 {
            return Err(problem(format!("has items of {size} bytes, {stride} bytes apart")));
        }
        let len = (count.0 - 1).checked_mul(stride).and_then(|last| last.checked_add(size as u64));
        let end = len.and_then(|len| len.checked_add(offset.0));
        if end.is_none_or(|end| end > byte_length.0) {
            return Err(problem(format!("reaches beyond bufferViews[{view_index}]")));
        }
        let view_end = byte_offset.0.checked_add(byte_length.0);
        if view_end.is_none_or(|end| end > bytes.len() as u64) {
            return Err(problem(format!(
                "lies in bufferViews[{view_index}], which reaches beyond buffers[{buffer}]"
            )));
        }
        let (start, unit) = (byte_offset.0 + offset.0, component.len() as u64);
        if !start.is_multiple_of(unit) || !stride.is_multiple_of(unit) {
            return Err(problem(format!(
                "starts at byte {start} of buffers[{buffer}], with {stride} bytes from item to \
                 item; both must be multiples of {unit}"
            )));
        }
        let [start, stride, count] = [start, stride, count.0]
            .map(|bytes| usize::try_from(bytes).expect("all of it is within the buffer"));
        let bytes = &bytes[start..];
        Ok((0..count).map(move |i| &bytes[i * stride..][..size]))
    }
}

/// Where an array starts.
struct Start {
    view: Whole,
    offset: Whole,
}

fn no_positions(accessor: usize, is_quantized: bool) -> ReadError {
    let kinds = if is_quantized { "three floats or short integers" } else { "three 32-bit floats" };
    let problem = format!("is used for positions; these must be {kinds}");
    ReadError::place(format!("accessors[{accessor}]"), problem)
}
