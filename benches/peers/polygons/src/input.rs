//! The polygons that all programs are given.

// The outlines that the tests of mindeg-exact draw, too.
#[allow(clippy::unwrap_used, reason = "most of it is for tests, which fail by panicking")]
#[path = "../../../../crates/mindeg-exact/tests/outlines/mod.rs"]
mod outlines;

pub(crate) use outlines::turn;

use glam::DVec2;
use mindeg_mesh::planar::{BoundaryFaults, PlanarBoundary};
use outlines::Outline;
use std::error::Error;
use std::ops::Range;
use std::path::Path;

pub(crate) struct Input {
    pub(crate) name: String,
    pub(crate) points: Vec<DVec2>,
    /// The outer ring, counter-clockwise, then the holes, clockwise.
    pub(crate) rings: Vec<Range<u32>>,
    /// For each point the straight side that begins there.
    pub(crate) side_of: Vec<u32>,
    /// A point in each hole.
    pub(crate) in_holes: Vec<DVec2>,
}

impl Input {
    fn of(name: &str, Outline { points, side_of }: Outline) -> Self {
        let rings = std::iter::once(0..points.len() as u32).collect();
        Self { name: name.to_owned(), points, rings, side_of, in_holes: Vec::new() }
    }

    /// The boundary edges.
    pub(crate) fn edges(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        let next =
            |ring: &Range<u32>, from| if from + 1 == ring.end { ring.start } else { from + 1 };
        self.rings
            .iter()
            .flat_map(move |ring| ring.clone().map(move |from| [from, next(ring, from)]))
    }

    pub(crate) fn contours(&self) -> Vec<Vec<[f64; 2]>> {
        let point = |vertex: u32| self.points[vertex as usize].to_array();
        self.rings.iter().map(|ring| ring.clone().map(point).collect()).collect()
    }

    /// The boundary as mindeg takes it.
    pub(crate) fn boundary(&self) -> Result<PlanarBoundary, BoundaryFaults> {
        let of_ring = |ring: &Range<u32>| &self.points[ring.start as usize..ring.end as usize];
        let rings: Vec<&[DVec2]> = self.rings.iter().map(of_ring).collect();
        Ok(PlanarBoundary::new(&rings)?.with_sides(Vec::new(), self.side_of.clone()))
    }

    /// The triangles of any triangulation: two fewer than vertices, and two more for each hole.
    pub(crate) fn triangle_count(&self) -> usize {
        self.points.len() + 2 * self.rings.len() - 4
    }
}

/// Shapes of many points on long sides.
pub(crate) fn generated() -> Vec<Input> {
    vec![
        Input::of("L", Outline::l_shape([500, 250, 250, 250, 250, 500])),
        Input::of("U", Outline::u_shape([250, 167, 83, 83, 84, 83, 83, 167])),
        Input::of("comb", Outline::comb(8, 120, 28)),
        Input::of("gear", Outline::gear(12, 21)),
        Input::of("spiral", Outline::spiral(41)),
        plate(5, 24),
    ]
}

/// A square plate with rows of round holes, each of some corners.
fn plate(rows: u32, corners: u32) -> Input {
    let width = f64::from(rows);
    let square = [(0.0, 0.0), (width, 0.0), (width, width), (0.0, width)];
    let mut plate = Input::of("plate", Outline::new(&square, &[8 * rows; 4]));
    for (x, y) in (0..rows).flat_map(|x| (0..rows).map(move |y| (x, y))) {
        let center = DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
        let start = plate.points.len() as u32;
        for corner in 0..corners {
            let angle = -std::f64::consts::TAU * f64::from(corner) / f64::from(corners);
            let at = DVec2::new(libm::cos(angle), libm::sin(angle));
            plate.side_of.push(plate.points.len() as u32 + 4);
            plate.points.push(center + 0.25 * at);
        }
        plate.rings.push(start..start + corners);
        plate.in_holes.push(center);
    }
    plate
}

/// The ring files of a folder, by name.
pub(crate) fn read_folder(folder: &Path) -> Result<Vec<Input>, Box<dyn Error>> {
    let mut paths = std::fs::read_dir(folder)?
        .map(|it| Ok(it?.path()))
        .collect::<Result<Vec<_>, std::io::Error>>()?;
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "txt"));
    paths.sort();
    paths.iter().map(|path| read(path)).collect()
}

fn read(path: &Path) -> Result<Input, Box<dyn Error>> {
    let name = path.file_stem().unwrap_or_default().to_string_lossy().replace('_', " ");
    let mut input = Input::of(&name, Outline { points: Vec::new(), side_of: Vec::new() });
    input.rings.clear();
    for ring in std::fs::read_to_string(path)?.split("\n\n") {
        let start = input.points.len() as u32;
        for line in ring.lines() {
            let (x, y) = line.split_once(' ').ok_or("a line is not \"x y\"")?;
            input.points.push(DVec2::new(x.parse()?, y.parse()?));
        }
        input.rings.push(start..input.points.len() as u32);
    }
    input.side_of = (0..input.points.len() as u32).collect();
    Ok(input)
}
