//! The boundary loops of a mesh: which one a user means, and the list of them.

use crate::args::LoopChoice;
use crate::failure::Failure;
use mindeg::glam::DVec3;
use mindeg::{Loops, MeshLoop, TriMesh};
use mindeg_answers::loops::LoopName;
use mindeg_answers::numbers::coordinate;
use std::path::Path;

/// How many loops a list names.
const LISTED: usize = 20;

/// The index of the loop that is meant.
pub(crate) fn index_of(
    choice: LoopChoice,
    loops: &Loops,
    mesh: &TriMesh,
    path: &Path,
) -> Result<usize, Failure> {
    let list = loops.list();
    let at = |vertex: u32| mesh.positions()[vertex as usize];
    let found = match choice {
        LoopChoice::Number(number) => (number <= list.len()).then(|| number - 1),
        LoopChoice::Vertex(vertex) => loops.through(vertex),
        LoopChoice::Near(point) => {
            let point = DVec3::from(point);
            let distance = |found: &MeshLoop| {
                let distances = found.vertices.iter().map(|&v| at(v).distance_squared(point));
                distances.fold(f64::INFINITY, f64::min)
            };
            let distances = list.iter().map(distance).enumerate();
            distances.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(index, _)| index)
        }
    };
    found.ok_or_else(|| {
        let what = match choice {
            LoopChoice::Number(number) => format!("loop {number}"),
            LoopChoice::Vertex(vertex) => format!("boundary loop through vertex {vertex}"),
            LoopChoice::Near(_) => "boundary loop".to_owned(),
        };
        Failure::Input(format!("{} has no {what}{}", path.display(), listed(loops, mesh)))
    })
}

/// The list of loops, to choose from.
pub(crate) fn listed(loops: &Loops, mesh: &TriMesh) -> String {
    let list = loops.list();
    if list.is_empty() {
        return "; it is closed".to_owned();
    }
    let mut text = String::from("; its loops are:");
    for (index, found) in list.iter().enumerate().take(LISTED) {
        let points = found.vertices.iter().map(|&vertex| mesh.positions()[vertex as usize]);
        let largest = points.map(|point| point.abs().max_element()).fold(0.0, f64::max);
        // Print the rounding error of a zero as 0.
        let round = |x: f64| if x.abs() < 1e-12 * largest { 0.0 } else { x };
        let center = found.center(mesh.positions()).to_array().map(|x| coordinate(round(x)));
        let name = LoopName::new(index, found).text();
        text += &format!("\n  {name}, around {}", center.join(","));
        if let Some(defect) = found.defect {
            text += &format!("; {defect}");
        }
    }
    if list.len() > LISTED {
        text += &format!("\n  and {} more", list.len() - LISTED);
    }
    text
}
