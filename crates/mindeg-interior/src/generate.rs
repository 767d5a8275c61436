//! From an outline to a mesh: size field, packing, triangulation, optimiser, and other seeds where the first leaves something to be desired.

use crate::array_mesh::{ArrayMesh, Kind, NONE, Vertex};
use crate::asked::Asked;
use crate::breaklines::Breaklines;
use crate::finish::finish;
use crate::fixed::{breaklines, crowded};
use crate::goal::{Goal, Weights, goals};
use crate::joined::report_joined;
use crate::lengths::SizeReport;
use crate::limits::Limits;
use crate::measure::{Wanted, degrees_at_boundary, measure};
use crate::optimise::{Pairs, optimise};
use crate::options::{InteriorError, Options, check_coordinates, check_room, rounding};
use crate::packing::is_inside_of;
use crate::places::mend_places;
use crate::report::{InteriorReport, Violation};
use crate::size::SizeField;
use crate::stage::Stage;
use crate::star::Stars;
use crate::start::Start;
use crate::triangle::SQRT_3;
use crate::verdict::{Gain, check_target, counted, floor, gain, is_enough, is_large};
use glam::DVec2;
use mindeg_domain::{Prefer, Size, SizeAt};
use mindeg_mesh::Progress;
use mindeg_mesh::planar::PlanarBoundary;
use std::sync::Arc;

/// A mesh and what it is like; a draft has no measures.
#[derive(Debug, Clone, PartialEq)]
pub struct Generated<R = InteriorReport> {
    /// The boundary points, bit for bit and in the outline's order; its inner points; the others.
    pub points: Vec<DVec2>,
    /// Counter-clockwise triangles.
    pub triangles: Vec<[u32; 3]>,
    /// The edges that the segments of lines consist of, in their order.
    pub line_edges: Vec<[u32; 2]>,
    /// The measures of the mesh that was reached.
    pub report: R,
}

/// One way to begin: growth over the wanted growth, least distance of points in sizes, whether to search
/// for pairs of operations, and how much to try at places.
struct Seed {
    growth: f64,
    spacing: f64,
    pairs: bool,
    /// The share of the trials at places that it may make.
    trials: f64,
}

/// The usual least distance of points, in sizes.
pub(crate) const SPACING: f64 = 0.75;

const SEEDS: [Seed; 5] = [
    Seed { growth: 1.0, spacing: SPACING, pairs: false, trials: 1.0 },
    Seed { growth: 1.0, spacing: SPACING, pairs: true, trials: 0.3 },
    Seed { growth: 1.0, spacing: 0.8, pairs: true, trials: 0.3 },
    Seed { growth: 1.2, spacing: SPACING, pairs: true, trials: 0.3 },
    Seed { growth: 0.8, spacing: 0.7, pairs: true, trials: 0.3 },
];

/// The choices at the beginning of a try: another one with the same would end at the same mesh.
#[derive(PartialEq)]
struct Begun {
    prefer: Prefer,
    pairs: bool,
    vertices: Vec<Vertex>,
    triangles: Vec<[u32; 3]>,
}

impl Begun {
    fn new(prefer: Prefer, seed: &Seed, mesh: &ArrayMesh) -> Self {
        let triangles = mesh.triangles.iter().map(|triangle| triangle.vertices).collect();
        Self { prefer, pairs: seed.pairs, vertices: mesh.vertices.clone(), triangles }
    }
}

/// The aims at what stays, for one way to divide lines.
pub(crate) struct Aims {
    prefer: Prefer,
    breaklines: Breaklines,
    pub(crate) stars: Stars,
    pub(crate) goals: Vec<Goal>,
}

impl Aims {
    pub(crate) fn new(
        outline: &PlanarBoundary,
        breaklines: &Breaklines,
        options: &Options,
    ) -> Self {
        let stars = options.stars(outline, breaklines);
        let goals = goals(outline, breaklines, &stars, options);
        Self { prefer: options.wanted.prefer(), breaklines: breaklines.clone(), stars, goals }
    }

    fn are_of(&self, prefer: Prefer, breaklines: &Breaklines) -> bool {
        self.prefer == prefer && self.breaklines == *breaklines
    }
}

/// Fills an outline with interior points.
///
/// The boundary stays as it is, and so do lines inside, but for those that [`Options::divisible`] lets be divided. Degrees and angles are aims: the search is heuristic, and the report says
/// what was reached and which limits are proven. Equal input gives equal bytes.
///
/// O(n log n) for n points, plus the time for regions that need operations.
///
/// # Errors
///
/// If an option has no meaning, the target angle is above the proven limit, the mesh would be too large, points are too close to triangulate, or
/// `progress` breaks.
pub fn generate(
    outline: &PlanarBoundary,
    options: &Options,
    progress: Progress<'_>,
) -> Result<Generated, InteriorError> {
    generate_showing(outline, options, None, progress)
}

/// [`generate`] with the first of its starts alone, as large meshes have it, whatever it reaches.
///
/// # Errors
///
/// As [`generate`].
pub fn generate_once(
    outline: &PlanarBoundary,
    options: &Options,
    progress: Progress<'_>,
) -> Result<Generated, InteriorError> {
    generate_of(outline, options, 1, None, progress)
}

/// [`generate`]; `show`, if it is given, gets the mesh of the first packing, before it is worked on: that takes most of the time.
///
/// # Errors
///
/// As [`generate`].
pub fn generate_showing(
    outline: &PlanarBoundary,
    options: &Options,
    show: Option<&mut dyn FnMut(Generated<()>)>,
    progress: Progress<'_>,
) -> Result<Generated, InteriorError> {
    generate_of(outline, options, usize::MAX, show, progress)
}

/// The limits of a boundary where points can be put as wanted.
pub(crate) fn checked(
    outline: &PlanarBoundary,
    options: &Options,
) -> Result<Limits, InteriorError> {
    options.check()?;
    check_coordinates(outline)?;
    let rounding = rounding(outline);
    for [a, b] in outline.edges() {
        let [a, b] = [a, b].map(|v| outline.point(v));
        check_room(a, a.distance(b), rounding)?;
    }
    let limits = options.limits(outline, |_| 0);
    check_target(&limits, options)?;
    Ok(limits)
}

/// [`generate`] with so many starts at most.
fn generate_of(
    outline: &PlanarBoundary,
    options: &Options,
    starts: usize,
    mut show: Option<&mut dyn FnMut(Generated<()>)>,
    progress: Progress<'_>,
) -> Result<Generated, InteriorError> {
    let limits = checked(outline, options)?;
    let floor = floor(options);
    let mut best: Option<Generated> = None;
    let mut wanted_sizes = None;
    let mut in_vain = 0;
    let mut begun = Vec::new();
    let mut aims: Option<Aims> = None;
    // Where angles are preferred, the way that keeps degrees may still reach more.
    let ways: &[Prefer] = match options.wanted.prefer() {
        Prefer::Degree => &[Prefer::Degree],
        Prefer::Angle => &[Prefer::Angle, Prefer::Degree],
    };
    let tries: Vec<(Prefer, &Seed)> =
        ways.iter().flat_map(|way| SEEDS.iter().map(|seed| (*way, seed))).take(starts).collect();
    let mut stage = Stage::new(progress, "adding interior points");
    for (index, (prefer, seed)) in tries.iter().enumerate() {
        let mut way = options.clone();
        way.wanted.growth = Some(options.wanted.growth() * seed.growth);
        way.wanted.prefer = Some(*prefer);
        let is_gentle = options.wanted.growth.is_none();
        let (breaklines, field) = size_field(outline, &way, is_gentle)?;
        // They are the same for all seeds, unless sizes divide lines.
        let known = aims.take().filter(|aims| aims.are_of(*prefer, &breaklines));
        let known = known.unwrap_or_else(|| Aims::new(outline, &breaklines, &way));
        let Aims { stars, goals, .. } = &*aims.insert(known);
        let about = about_checked(outline, options, &field)?;
        let start = Start { outline, stars, goals, breaklines: &breaklines, field: &field, about };
        let end = end_of_try(index, tries.len(), about);
        let stays = outline.points().len() + breaklines.points.len();
        stage.section(end_of_start(&stage, end, about, stays));
        let most = options.wanted.max_points();
        let packing = start.packing(seed.spacing, floor, most, None, &mut stage)?;
        // Without a point inside it is no picture of what comes.
        if packing.vertices.len() > stays
            && let Some(show) = show.take()
        {
            show(Generated::packed(&packing, &breaklines));
        }
        let mut mesh = start.linked(packing)?;
        let own = Begun::new(*prefer, seed, &mesh);
        if begun.contains(&own) {
            in_vain += 1;
            if best.as_ref().is_some_and(|best| is_large(&best.report, in_vain)) {
                break;
            }
            continue;
        }
        begun.push(own);
        let measured = |mesh: &ArrayMesh| {
            let (points, triangles, _) = compact(mesh);
            let wanted = Wanted {
                interior: options.wanted.interior_degree(),
                goals,
                stars,
                limits,
                most: counted(options),
                corners_inside: options.wanted.has_corners_inside(),
            };
            let limits_at = |broken: &[Violation]| {
                let has = degrees_at_boundary(broken, |v| v);
                options.limits(outline, has)
            };
            let mut report = measure(&points, &triangles, &wanted, |v| v, limits_at);
            report_joined(&mut report, outline, stars, &way, (&points, &triangles));
            Generated { points, triangles, line_edges: breaklines.edges.clone(), report }
        };
        let weights = if seed.pairs { Weights::pairs } else { Weights::single };
        let weights = weights(&way, floor);
        let pairs = seed.pairs.then_some(Pairs::FOR_A_TRY);
        optimise(&mut mesh, &weights, pairs, &mut stage)?;
        stage.section(end);
        // Where angles come first, no place is mended for its degrees.
        if *prefer == Prefer::Degree {
            mend_places(&mut mesh, &way, stars, floor, seed.trials, &mut stage)?;
        }
        finish(&mut mesh, &way, floor, &mut stage)?;
        mesh.check().map_err(InteriorError::NotFilled)?;
        let found = measured(&mesh);
        // The first way has the wanted growth.
        wanted_sizes.get_or_insert(field);
        let gain = best.as_ref().map(|best| gain(&found.report, &best.report, options));
        in_vain = if gain.is_none_or(|gain| gain > Gain::Little) { 0 } else { in_vain + 1 };
        if gain.is_none_or(|gain| gain > Gain::None) {
            best = Some(found);
        }
        let ends =
            |best: &Generated| is_enough(&best.report, options) || is_large(&best.report, in_vain);
        if best.as_ref().is_some_and(ends) {
            break;
        }
    }
    stage.section(1.0);
    stage.reach(1.0)?;
    let mut best = best.ok_or_else(|| InteriorError::NotFilled("no seed".into()))?;
    let sizes = wanted_sizes
        .map(|field| SizeReport::new(outline, options, &field, &best.points, &best.triangles));
    best.report.sizes = sizes;
    Ok(best)
}

/// Meshes with more points are begun once and have few places to mend.
const MANY_POINTS: f64 = 2e4;

/// The share of all work at which a try of several ends: few go beyond the first if the mesh is large.
pub(crate) fn end_of_try(index: usize, tries: usize, points: f64) -> f64 {
    let first = if points > MANY_POINTS { 0.95 } else { 1.0 / tries as f64 };
    first + (1.0 - first) * index as f64 / (tries - 1).max(1) as f64
}

/// With more of its points on lines and the boundary than this share, a mesh has many places to mend.
const MANY_STAY: f64 = 0.05;

/// The share of all work at which smoothing ends and places begin to be mended, which takes longest in small meshes and in maps. `stays`: how
/// many points stay where they are.
pub(crate) fn end_of_start(stage: &Stage<'_>, end: f64, points: f64, stays: usize) -> f64 {
    let share = match points > MANY_POINTS {
        true if stays as f64 > MANY_STAY * points => 0.5,
        true => 0.9,
        false => 0.2,
    };
    stage.share() + share * (end - stage.share())
}

/// About how many points the size field asks for, from its sizes at some places: so that far too many
/// are refused at once.
fn about_points(outline: &PlanarBoundary, field: &SizeField) -> f64 {
    const ACROSS: u32 = 16;
    let bounds = outline.bounds();
    let (low, cell) = (bounds.min, bounds.size() / f64::from(ACROSS));
    let place = |i: u32| DVec2::new(f64::from(i % ACROSS) + 0.5, f64::from(i / ACROSS) + 0.5);
    let of_cell = |x: DVec2| {
        let (edge, _) = field.boundary().nearest(x, f64::INFINITY)?;
        let size = field.at(x);
        is_inside_of(outline, edge, x).then(|| cell.element_product() / (size * size))
    };
    // Each point of an equilateral packing takes sqrt(3) / 2 of its size squared.
    let sum: f64 = (0..ACROSS * ACROSS).filter_map(|i| of_cell(low + cell * place(i))).sum();
    sum * 2.0 / SQRT_3
}

/// The same, if a mesh may have so many.
pub(crate) fn about_checked(
    outline: &PlanarBoundary,
    options: &Options,
    field: &SizeField,
) -> Result<f64, InteriorError> {
    let (about, max) = (about_points(outline, field), options.wanted.max_points());
    match about > 2.0 * max as f64 {
        true => Err(InteriorError::TooManyPoints { max }),
        false => Ok(about),
    }
}

/// The size field, with inner points and lines taken in; a gentle one, unless sizes far from the boundary are asked for.
pub(crate) fn size_field(
    outline: &PlanarBoundary,
    options: &Options,
    is_gentle: bool,
) -> Result<(Breaklines, SizeField), InteriorError> {
    let segments = outline.segments().iter().enumerate();
    let stays = segments.filter(|(segment, _)| !options.is_divisible(*segment));
    let frozen: Vec<[u32; 2]> = stays.map(|(_, ends)| *ends).collect();
    let (growth, places) = (options.wanted.growth(), options.wanted.sizes_at().collect::<Vec<_>>());
    let asked = Arc::new(Asked::new(outline, options));
    // Sizes that are asked for are reached as fast as before.
    let is_gentle = is_gentle && !asked.has_base();
    let field = |crowded: &[SizeAt]| {
        let field = SizeField::new(outline, &frozen, growth, &places, crowded);
        let field = if is_gentle { field.gentle(outline) } else { field };
        field.asking(Arc::clone(&asked))
    };
    let plain = field(&[]);
    for (index, size) in options.wanted.sizes.iter().enumerate() {
        let Size::At(place) = size else { continue };
        let nearest = plain.boundary().nearest(place.at, f64::INFINITY);
        // On the boundary is fine.
        if nearest.is_some_and(|(edge, distance)| {
            distance > 1e-9 * place.size && !is_inside_of(outline, edge, place.at)
        }) {
            let what = format!("entry {} of sizes", index + 1);
            return Err(InteriorError::Outside { what, at: place.at.to_array() });
        }
    }
    let lines = breaklines(outline, options, &plain);
    let crowded = crowded(outline, &lines, &plain);
    if crowded.is_empty() {
        return Ok((lines, plain));
    }
    let finer = field(&crowded);
    Ok((breaklines(outline, options, &finer), finer))
}

/// The living vertices and triangles, in order, with the index that each point had in the array mesh.
pub(crate) fn compact(mesh: &ArrayMesh) -> (Vec<DVec2>, Vec<[u32; 3]>, Vec<u32>) {
    let mut renamed = vec![NONE; mesh.vertices.len()];
    let (mut points, mut sources) = (Vec::new(), Vec::new());
    for (v, vertex) in (0..).zip(&mesh.vertices) {
        if vertex.triangles > 0 || vertex.kind != Kind::Free {
            renamed[v as usize] = points.len() as u32;
            points.push(vertex.at);
            sources.push(v);
        }
    }
    let alive = mesh.triangles.iter().filter(|t| t.is_alive());
    let triangles = alive.map(|t| t.vertices.map(|v| renamed[v as usize])).collect();
    (points, triangles, sources)
}
