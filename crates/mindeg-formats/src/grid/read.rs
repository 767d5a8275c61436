//! A mesh from points and cells.

use std::collections::TryReserveError;

use glam::DVec3;
use mindeg_mesh::TriMesh;

use crate::ReadError;
use crate::lists::push;
use crate::runs::Elements;

/// The points and cells of a file so far.
#[derive(Default)]
pub(crate) struct Grid {
    positions: Vec<DVec3>,
    elements: Elements,
}

/// Cells of one piece of a file.
pub(crate) struct Cells<'a> {
    /// The corners of all cells, counted from the first point of the piece.
    pub(crate) connectivity: &'a [i64],
    /// Where the corners of each cell end.
    pub(crate) ends: &'a [i64],
    pub(crate) types: &'a [i64],
    pub(crate) data: &'a CellData,
}

/// The data of a piece's cells besides corners; each list is empty or has a value for each cell.
#[derive(Default)]
pub(crate) struct CellData {
    pub(crate) sides: Vec<i64>,
    pub(crate) side_names: Vec<String>,
    pub(crate) groups: Vec<i64>,
    pub(crate) group_names: Vec<String>,
}

impl Grid {
    /// How many points there are.
    pub(crate) fn point_count(&self) -> usize {
        self.positions.len()
    }

    /// Adds points, three coordinates each.
    pub(crate) fn add_points(&mut self, coordinates: &[f64]) -> Result<(), ReadError> {
        self.positions.try_reserve(coordinates.len() / 3)?;
        self.positions.extend(coordinates.chunks_exact(3).map(DVec3::from_slice));
        Ok(())
    }

    /// Adds cells of the points from `first` on; `at` makes an error of a sentence about a cell.
    pub(crate) fn add_cells(
        &mut self,
        first: usize,
        cells: &Cells<'_>,
        at: impl Fn(String) -> ReadError,
    ) -> Result<(), ReadError> {
        let Cells { connectivity, ends, types, data } = *cells;
        let count = self.positions.len() - first;
        let mut start = 0;
        let mut corners = Vec::new();
        for (cell, (&end, &cell_type)) in ends.iter().zip(types).enumerate() {
            let wrong = |problem: String| at(format!("cell {cell} (counted from 0): {problem}"));
            let of_cell = usize::try_from(end).ok().filter(|&end| start <= end);
            let of_cell =
                of_cell.and_then(|end| connectivity.get(start..end)).ok_or_else(|| {
                    let last = connectivity.len();
                    wrong(format!("its corners end at {end}; expected {start} to {last}"))
                })?;
            start += of_cell.len();
            corners.clear();
            for &corner in of_cell {
                let known = usize::try_from(corner).ok().filter(|&corner| corner < count);
                let Some(corner) = known else {
                    return Err(wrong(format!("point {corner} does not exist; there are {count}")));
                };
                push(&mut corners, (first + corner) as u32)?;
            }
            let added = self.add_cell(cell, cell_type, &mut corners, data);
            added.map_err(|error| error.or_at(wrong))?;
        }
        Ok(())
    }

    fn add_cell(
        &mut self,
        cell: usize,
        cell_type: i64,
        corners: &mut Vec<u32>,
        data: &CellData,
    ) -> Result<(), ReadError> {
        let few = |count: usize| {
            ReadError::place("", format!("a cell of type {cell_type} has {count} corners or more"))
        };
        // The corners of curved cells come first.
        let straight = match cell_type {
            3 | 21 | 35 | 68 => 2,
            5 | 22 | 34 | 69 => 3,
            8 | 9 | 23 | 28 | 30 | 70 => 4,
            _ => 0,
        };
        if corners.len() < straight {
            return Err(few(straight));
        }
        if straight > 0 {
            self.elements.are_straightened |= corners.len() > straight;
            corners.truncate(straight);
        }
        match cell_type {
            1 | 2 => self.elements.points += corners.len() as u64,
            3 | 4 | 21 | 35 | 68 => {
                let side = data.sides.get(cell).copied();
                for pair in corners.windows(2) {
                    let name = || name_of(side, &data.side_names, "side");
                    self.elements.segments.push(side.unwrap_or(-1), [pair[0], pair[1]], name)?;
                }
            }
            5 | 7 | 8 | 9 | 22 | 23 | 28 | 30 | 34 | 69 | 70 => {
                if corners.len() < 3 {
                    return Err(few(3));
                }
                // A pixel has its corners row by row.
                if cell_type == 8 {
                    corners.swap(2, 3);
                }
                self.elements.faces.push(corners)?;
                self.note_group(cell, data)?;
            }
            6 => {
                for (index, triangle) in corners.windows(3).enumerate() {
                    let (a, b) = (triangle[index % 2], triangle[1 - index % 2]);
                    self.elements.faces.push(&[a, b, triangle[2]])?;
                }
                self.note_group(cell, data)?;
            }
            _ => self.elements.volumes += 1,
        }
        Ok(())
    }

    fn note_group(&mut self, cell: usize, data: &CellData) -> Result<(), TryReserveError> {
        let group = data.groups.get(cell).copied();
        let name = || match group {
            Some(_) => name_of(group, &data.group_names, "group"),
            None => String::new(),
        };
        self.elements.groups.push(group.unwrap_or(-1), self.elements.faces.triangle_count(), name)
    }

    pub(crate) fn into_mesh(self) -> Result<TriMesh, ReadError> {
        self.elements.into_mesh(self.positions, "groups", "volume cells")
    }
}

/// The name of a side or group by its index, else its number: names without one in the file count from
/// 1, as those of a domain's sides do.
fn name_of(index: Option<i64>, names: &[String], kind: &str) -> String {
    let Some(index) = index else { return "lines".to_owned() };
    let name = usize::try_from(index).ok().and_then(|index| names.get(index));
    match name {
        Some(name) if !name.trim().is_empty() => name.clone(),
        _ => format!("{kind} {}", index.saturating_add(1)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sides_without_names_count_from_one_as_those_of_a_domain() {
        let names = ["inlet".to_owned(), " ".to_owned()];
        for (index, name) in [
            (Some(0), "inlet"),
            (Some(1), "side 2"),
            (Some(2), "side 3"),
            (Some(-1), "side 0"),
            (Some(i64::MAX), "side 9223372036854775807"),
            (None, "lines"),
        ] {
            assert_eq!(name_of(index, &names, "side"), name);
        }
    }
}
