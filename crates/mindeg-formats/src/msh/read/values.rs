//! Data at the nodes of an MSH.

use mindeg_mesh::TriMesh;

use super::{Contents, contents};
use crate::ReadError;
use crate::lists::push;
use crate::numbers::Numbers;
use crate::scanner::Scanner;

/// Reads a mesh and the first data with one number at each node: by vertex, NaN where there is none.
pub(crate) fn read_values(file: &[u8]) -> Result<(TriMesh, Vec<f64>), ReadError> {
    let mut contents =
        contents(file, Contents { values: Some(Vec::new()), ..Contents::default() })?;
    let Some(by_tag) = contents.values.take().filter(|values| !values.is_empty()) else {
        return Err(ReadError::place("", "the mesh has no $NodeData of one number at each node"));
    };
    let nodes = contents.nodes.as_ref();
    let mut values = vec![f64::NAN; nodes.map_or(0, |nodes| nodes.positions.len())];
    for (tag, value) in by_tag {
        if let Some(index) = nodes.and_then(|nodes| nodes.index(tag)) {
            values[index as usize] = value;
        }
    }
    Ok((contents.into_mesh()?, values))
}

impl Contents {
    /// A head of texts, numbers and whole numbers as text; then tags and values.
    pub(super) fn take_values(
        &mut self,
        scanner: &mut Scanner<'_>,
        encoding: Numbers,
    ) -> Result<(), ReadError> {
        let texts = scanner.size("the number of texts")?;
        scanner.line();
        for _ in 0..texts {
            scanner.line();
        }
        for _ in 0..scanner.size("the number of reals")? {
            scanner.double("a real")?;
        }
        let mut counts = [0, 1, 0];
        let mut places = counts.iter_mut();
        for _ in 0..scanner.size("the number of whole numbers")? {
            let count = scanner.size("a whole number")?;
            if let Some(known) = places.next() {
                *known = count;
            }
        }
        scanner.line();
        scanner.encoding = encoding;
        let [_, components, count] = counts;
        let mut values = Vec::new();
        for _ in 0..count {
            let tag = scanner.int("the tag of a node")?;
            let mut value = f64::NAN;
            for _ in 0..components {
                value = scanner.double("a value")?;
            }
            push(&mut values, (u64::try_from(tag).unwrap_or(u64::MAX), value))?;
        }
        if components == 1 {
            self.values = Some(values);
        }
        Ok(())
    }
}
