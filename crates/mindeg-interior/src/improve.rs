//! The optimiser alone, on any planar triangle mesh.

use crate::array_mesh::{ArrayMesh, Kind, NONE, Vertex};
use crate::breaklines::Breaklines;
use crate::finish::finish;
use crate::generate::SPACING;
use crate::generate::{compact, end_of_start, end_of_try};
use crate::goal::{Weights, goals};
use crate::limits::Limits;
use crate::measure::{Wanted, degrees_at_boundary, measure};
use crate::optimise::{Pairs, optimise};
use crate::options::{InteriorError, MAX_POINTS, Options, is_usable};
use crate::places::mend_places;
use crate::report::{InteriorReport, Violation};
use crate::size::SizeField;
use crate::stage::Stage;
use crate::star::Stars;
use crate::start::Start;
use crate::triangle::{SQRT_3, doubled_area};
use crate::verdict::{check_target, counted, floor, is_enough, rank};
use glam::DVec2;
use mindeg_domain::Prefer;
use mindeg_mesh::Progress;
use mindeg_mesh::planar::{PlanarBoundary, orientation};

/// The vertices and edges that a mesh keeps, beside its boundary.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Keep {
    /// Vertices that neither move nor go.
    pub vertices: Vec<u32>,
    /// Edges that stay; so do their ends.
    pub edges: Vec<[u32; 2]>,
}

/// An improved mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct Improved {
    /// The points: those of the input that are left, in order, then new ones.
    pub points: Vec<DVec2>,
    /// The index that each point has in the input, `None` for new points.
    pub sources: Vec<Option<u32>>,
    /// Counter-clockwise triangles.
    pub triangles: Vec<[u32; 3]>,
    /// The measures before; vertices have the indices of the input.
    pub before: InteriorReport,
    /// The measures after; vertices have the indices of the result.
    pub after: InteriorReport,
}

/// Improves a planar triangle mesh: its boundary stays, degrees and angles get nearer to what is wanted.
///
/// Size options are not used: sizes are as they are. A mesh without points inside that may move is also filled anew, by the
/// sizes of its boundary. The result is never worse than the input: it has no
/// more violations and, with equally many, no smaller minimum angle up to the target (or the other way
/// round with [`Prefer::Angle`](crate::Prefer::Angle)). Points without triangles stay.
///
/// # Errors
///
/// If an option has no meaning, the mesh is no planar triangle mesh whose triangles are counter-clockwise
/// and meet edge to edge in one fan at each vertex, or `progress` breaks. Overlaps of distant parts are not looked for.
pub fn improve(
    points: &[DVec2],
    triangles: &[[u32; 3]],
    keep: &Keep,
    options: &Options,
    progress: Progress<'_>,
) -> Result<Improved, InteriorError> {
    options.check()?;
    let start = Input::new(points, triangles, keep, options)?;
    check_target(&start.limits, options)?;
    let before =
        start.measure(points, triangles, options, |v| start.mesh.vertices[v as usize].goal);
    let mut best: Option<Improved> = None;
    let mut stage = Stage::new(progress, "improving");
    let count = points.len() as f64;
    for (index, (pairs, is_anew)) in
        [(false, false), (true, false), (true, true)].into_iter().enumerate()
    {
        let mesh = match is_anew {
            true => start.begun_anew(floor(options), options, &mut stage)?,
            false => Some(start.mesh.clone()),
        };
        let Some(mut mesh) = mesh else { break };
        let weights = if pairs { Weights::pairs } else { Weights::single };
        let end = end_of_try(index, 3, count);
        stage.section(end_of_start(&stage, end, count, start.boundary.points().len()));
        let floor = floor(options);
        let all = Pairs { firsts: 12, most: usize::MAX, ..Pairs::FOR_A_TRY };
        optimise(&mut mesh, &weights(options, floor), pairs.then_some(all), &mut stage)?;
        stage.section(end);
        if options.wanted.prefer() == Prefer::Degree {
            mend_places(&mut mesh, options, &start.stars, floor, 1.0, &mut stage)?;
        }
        finish(&mut mesh, options, floor, &mut stage)?;
        mesh.check().map_err(InteriorError::BadMesh)?;
        let (new_points, new_triangles, sources) = compact(&mesh);
        let goal = |v: u32| mesh.vertices[sources[v as usize] as usize].goal;
        let after = start.measure(&new_points, &new_triangles, options, goal);
        let count = points.len() as u32;
        let found = Improved {
            sources: sources.into_iter().map(|v| (v < count).then_some(v)).collect(),
            points: new_points,
            triangles: new_triangles,
            before: before.clone(),
            after,
        };
        let least = best.as_ref().map_or(&before, |best| &best.after);
        if rank(&found.after, options) < rank(least, options) {
            best = Some(found);
        }
        if best.as_ref().is_some_and(|best| is_enough(&best.after, options)) {
            break;
        }
    }
    stage.section(1.0);
    stage.reach(1.0)?;
    Ok(best.unwrap_or_else(|| Improved {
        points: points.to_vec(),
        sources: (0..points.len() as u32).map(Some).collect(),
        triangles: triangles.to_vec(),
        after: before.clone(),
        before,
    }))
}

/// A checked mesh, ready to be worked on.
struct Input {
    mesh: ArrayMesh,
    boundary: PlanarBoundary,
    lines: Breaklines,
    /// The index in the input of the boundary's vertices, then of those of lines.
    names: Vec<u32>,
    stars: Stars,
    limits: Limits,
}

impl Input {
    fn new(
        points: &[DVec2],
        triangles: &[[u32; 3]],
        keep: &Keep,
        options: &Options,
    ) -> Result<Self, InteriorError> {
        check(points, triangles, keep).map_err(InteriorError::BadMesh)?;
        let mut areas = vec![(0.0, 0_u32); points.len()];
        for t in triangles {
            let area = doubled_area(t.map(|v| points[v as usize])) / 2.0;
            for v in t {
                areas[*v as usize].0 += area;
                areas[*v as usize].1 += 1;
            }
        }
        let vertex = |(at, (area, count)): (&DVec2, (f64, u32))| Vertex {
            at: *at,
            // The edge of an equilateral triangle of the mean area.
            size: (area / f64::from(count.max(1)) * 4.0 / SQRT_3).sqrt(),
            anchor: NONE,
            goal: NONE,
            triangles: 0,
            kind: if count == 0 { Kind::Fixed } else { Kind::Free },
        };
        let mut vertices: Vec<Vertex> = points.iter().zip(areas).map(vertex).collect();
        let kept = keep.vertices.iter().chain(keep.edges.iter().flatten());
        kept.for_each(|v| vertices[*v as usize].kind = Kind::Fixed);
        let mut mesh = ArrayMesh::new(vertices, triangles, Vec::new(), &keep.edges)
            .map_err(InteriorError::BadMesh)?;
        let (outline, lines, names) = mesh.frozen();
        let on_rings = outline.vertex_count();
        for (goal, v) in (0..).zip(&names) {
            let vertex = &mut mesh.vertices[*v as usize];
            vertex.goal = goal;
            if goal < on_rings {
                vertex.kind = Kind::Boundary;
            }
        }
        let stars = options.stars(&outline, &lines);
        mesh.goals = goals(&outline, &lines, &stars, options);
        let mut limits = options.limits(&outline, |_| 0);
        let name = |v: &mut u32| *v = names[*v as usize];
        name(&mut limits.any_degree.vertex);
        name(&mut limits.with_degree_limit.vertex);
        limits.tent.iter_mut().for_each(|tent| tent.edges.iter_mut().for_each(name));
        Ok(Self { mesh, boundary: outline, lines, names, stars, limits })
    }

    /// A mesh of the same boundary and lines with points of its own inside, if the input has none that may move: nothing
    /// tells which sizes are wanted there, and operations alone seldom find a way from triangles that long.
    fn begun_anew(
        &self,
        floor: f64,
        options: &Options,
        stage: &mut Stage<'_>,
    ) -> Result<Option<ArrayMesh>, InteriorError> {
        if self.mesh.vertices.iter().any(|vertex| vertex.kind == Kind::Free) {
            return Ok(None);
        }
        let field = SizeField::new(&self.boundary, &[], options.wanted.growth(), &[], &[]);
        let start = Start {
            outline: &self.boundary,
            stars: &self.stars,
            goals: &self.mesh.goals,
            breaklines: &self.lines,
            field: &field,
            about: f64::INFINITY,
        };
        let packing = start.packing(SPACING, floor, options.wanted.max_points(), None, stage);
        let packed = match packing.and_then(|packing| start.linked(packing)) {
            Err(InteriorError::Cancelled(cancelled)) => return Err(cancelled.into()),
            Err(_) => return Ok(None),
            Ok(packed) => packed,
        };
        let (mut vertices, mut names) = (self.mesh.vertices.clone(), self.names.clone());
        for vertex in &packed.vertices[names.len()..] {
            names.push(vertices.len() as u32);
            vertices.push(*vertex);
        }
        vertices.iter_mut().for_each(|v| (v.anchor, v.triangles) = (NONE, 0));
        let name = |v: u32| names[v as usize];
        let triangles: Vec<[u32; 3]> =
            packed.triangles.iter().map(|t| t.vertices.map(name)).collect();
        let locked: Vec<[u32; 2]> = self.lines.edges.iter().map(|e| e.map(name)).collect();
        Ok(ArrayMesh::new(vertices, &triangles, self.mesh.goals.clone(), &locked).ok())
    }

    fn measure(
        &self,
        points: &[DVec2],
        triangles: &[[u32; 3]],
        options: &Options,
        goal: impl Fn(u32) -> u32,
    ) -> InteriorReport {
        let limits_at = |broken: &[Violation]| {
            let has = degrees_at_boundary(broken, &goal);
            options.limits(&self.boundary, has)
        };
        let wanted = Wanted {
            interior: options.wanted.interior_degree(),
            goals: &self.mesh.goals,
            stars: &self.stars,
            limits: self.limits,
            most: counted(options),
            corners_inside: options.wanted.has_corners_inside(),
        };
        measure(points, triangles, &wanted, &goal, limits_at)
    }
}

fn check(points: &[DVec2], triangles: &[[u32; 3]], keep: &Keep) -> Result<(), String> {
    if points.len() > MAX_POINTS || triangles.is_empty() {
        let (p, t) = (points.len(), triangles.len());
        return Err(format!(
            "it has {p} points (at most {MAX_POINTS}) and {t} triangles (at least 1)"
        ));
    }
    if let Some(v) = points.iter().position(|p| !is_usable(*p)) {
        return Err(format!(
            "vertex {v} is at {}; coordinates are finite, and 0 or of magnitude 1e-70 to 1e70",
            points[v]
        ));
    }
    let all = triangles.iter().flatten().chain(&keep.vertices).chain(keep.edges.iter().flatten());
    if let Some(v) = all.into_iter().find(|v| **v as usize >= points.len()) {
        return Err(format!("vertex {v} is named, but the last vertex is {}", points.len() - 1));
    }
    for (t, triangle) in triangles.iter().enumerate() {
        let [a, b, c] = triangle.map(|v| points[v as usize]);
        if orientation(a, b, c) <= 0.0 {
            return Err(format!(
                "triangle {t} is flat or clockwise; every triangle must be counter-clockwise"
            ));
        }
    }
    Ok(())
}
