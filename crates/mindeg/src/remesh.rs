//! Surfaces in space meshed anew: 5 to 7 edges at every vertex off the boundary, features kept, the distance proven.
//!
//! [`remesh`] takes any manifold mesh, a [`Remesh`] says what is wanted. The result is judged by
//! [`verify::surface()`](crate::verify::surface()), which shares no code with what made it.
//!
//! ```
//! use mindeg::remesh::{Remesh, remesh};
//! use mindeg::{Progress, TriMesh, glam::DVec3};
//!
//! // A cube: bits 0 to 2 of a vertex are its x, y and z.
//! let at = |v: u32| DVec3::from([v & 1, v >> 1 & 1, v >> 2].map(f64::from));
//! let sides = [[0, 2, 1, 3], [4, 5, 6, 7], [0, 1, 4, 5], [2, 6, 3, 7], [0, 4, 2, 6], [1, 3, 5, 7]];
//! let triangles = sides.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [b, d, c]]).collect();
//! let part = TriMesh::new((0..8).map(at).collect(), triangles)?;
//! let found = remesh(&part, &Remesh { size: Some(0.25), ..Remesh::default() }, Progress::NONE)?;
//! assert!(found.reached.off_degree.is_empty() && found.defects().next().is_none());
//! assert!(found.verified.to_part.upper < 1e-9 && found.verified.from_part.upper < 1e-9);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Limits: manifold surfaces whose triangles face the same way. Degrees and angles come from a search; what is proven
//! is the distance.

mod found;
mod judged;
mod lines;
mod size;
mod wish;

use mindeg_interior::remesh as search;
pub use mindeg_interior::{CornerLimit, OffDegree, RemeshError, RemeshOptions, RemeshReport};
use mindeg_mesh::{Bounds, Progress, TriMesh};
use mindeg_surfaces::{FeatureRules, Given, Surface};
pub use mindeg_surfaces::{SurfaceError, SurfaceFault};

pub use self::found::{FeatureCounts, PartError, RemeshedPart};
use self::judged::judged;
use self::size::{first_size, size_for};
pub use self::wish::Remesh;
use self::wish::check;
use crate::repair::repaired;

/// Lines of sharp edges that end somewhere and have fewer sizes than this are no features.
const SHORTEST: f64 = 3.0;
/// The search aims at this share of the tolerance: it samples, the checker bounds.
const AIM: f64 = 0.8;
/// At this share where edges get the length that the distance needs: vertices have more room, angles and degrees gain.
const ROOMY: f64 = 0.9;
/// A tolerance makes edges no shorter than this share of the size: more vertices than that nobody asked for.
const SHRINK: f64 = 0.3;
/// How often the search is done with a stricter aim.
const REPEATS: u32 = 4;
/// A hole is filled if its rim is shorter than this many sizes: it could not have five edges.
const RIM: f64 = 5.0;
/// Without a wish for size, number of vertices or tolerance, the surfaces come as near as this share of the diagonal if
/// the search can.
const NEAR: f64 = 0.003;
/// Distances below this share of the diagonal count as none; see [`SurfaceRules::tolerance`].
const NOTHING: f64 = 1e-8;

/// Meshes a part anew.
///
/// Where a tolerance is asked for and the result does not keep it, the search is repeated with shorter edges, unless that
/// takes edges shorter than 0.3 sizes; the last result without defects is returned, else the last, and
/// [`RemeshedPart::defects`] says what it lacks.
/// Where neither size, vertices nor tolerance are asked for, the same is done for 0.3 % of the diagonal, which is no
/// defect if it is not reached. Equal input gives equal bytes.
///
/// # Errors
///
/// A part that is no manifold surface, with all places; a wish without a meaning; and a `progress` that cancels.
pub fn remesh(
    part: &TriMesh,
    wish: &Remesh,
    progress: Progress<'_>,
) -> Result<RemeshedPart, PartError> {
    let bounds = Bounds::of_space(part.positions().iter().copied());
    let diagonal = bounds.map_or(0.0, |bounds| bounds.size().length());
    check(wish).map_err(PartError::BadOption)?;
    let mut size = first_size(part, wish, diagonal);
    let mended;
    let (part, repairs) = match wish.repair {
        true => {
            mended = repaired(part, RIM * size, progress)?;
            (&mended.0, Some(mended.1))
        }
        false => (part, None),
    };
    let rules = FeatureRules {
        angle_deg: wish.feature_angle,
        shortest: SHORTEST * size,
        ..FeatureRules::default()
    };
    let group_of: Vec<u32> = (0_u32..)
        .zip(part.groups())
        .flat_map(|(index, group)| group.triangles.clone().map(move |_| index))
        .collect();
    let (edges, corners) = lines::given(part);
    let given = Given { groups: &group_of, edges: &edges, corners: &corners };
    let surface = Surface::keeping(part.positions(), part.triangles(), &given, &rules)?;
    if let (None, Some(count)) = (wish.size, wish.vertices) {
        size = size_for(&surface, wish, count, size, progress)?;
    }
    let tolerance = wish.tolerance.map(|tolerance| tolerance + NOTHING * diagonal);
    let is_free = wish.size.is_none() && wish.vertices.is_none();
    let most = tolerance.or_else(|| is_free.then_some(NEAR * diagonal));
    // A tolerance of zero is for surfaces of planes, which need no aim.
    let aim = wish.tolerance.map(|tolerance| AIM * tolerance);
    let mut options = RemeshOptions {
        size: Some(size),
        tolerance: aim.filter(|aim| *aim > NOTHING * diagonal),
        chord: None,
        curvature: wish.curvature,
        target_angle: wish.target_angle,
        keep_boundary: wish.keep_boundary,
        keep_features: wish.keep_features,
    };
    let (mut repeat, mut before) = (0, None::<RemeshedPart>);
    loop {
        let found = search(&surface, &options, progress)?;
        let mut judged = judged(part, &surface, found, wish, tolerance, progress)?;
        judged.repairs = repairs;
        let distance = judged.distance();
        let is_far = |part: &RemeshedPart| most.is_some_and(|most| part.distance() > most);
        let rank = |part: &RemeshedPart| (part.defects().next().is_some(), is_far(part));
        // Where two sheets are near each other, others of a later mesh may cross.
        let best = match before.take() {
            Some(before) if rank(&before) < rank(&judged) => before,
            _ => judged,
        };
        let Some(most) = most.filter(|most| distance > *most) else {
            return Ok(best);
        };
        let factor = (most / distance).min(0.9);
        if tolerance.is_none() && options.tolerance.is_none() {
            // The distance that was reached tells how short edges must be.
            options.tolerance = Some(ROOMY * most);
            options.chord = Some(factor * size::rules(wish, size).tolerance);
            before = Some(best);
            continue;
        }
        repeat += 1;
        // An edge across a bend is as far off as it is long; one on a curved surface as its square.
        let shorter = if repeat > 1 { factor } else { factor.sqrt() };
        let next = options.size.map(|old| old * shorter).filter(|next| *next >= SHRINK * size);
        if next.is_none() || options.tolerance.is_none() || repeat == REPEATS {
            return Ok(best);
        }
        before = Some(best);
        options.size = next;
        let stricter = if options.chord.is_some() { factor.sqrt() } else { factor };
        options.chord = options.chord.map(|chord| chord * factor);
        options.tolerance = options.tolerance.map(|aim| aim * stricter);
    }
}
