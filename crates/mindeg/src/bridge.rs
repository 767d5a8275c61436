//! Joining two boundary loops by a strip of triangles.
//!
//! The strip has the least maximum degree, the edges that the meshes have at the loops included,
//! and of those strips the largest minimum angle. Without edges beyond those of the loops the
//! least degree is 3 + ⌈p/q⌉ for loops of p >= q vertices, in closed form
//! ([`RingStrip`](mindeg_core::RingStrip)).
//!
//! # Orientation
//!
//! It follows from the meshes. Each loop runs with the faces along it, so the strip has to run
//! against both: forward along the one loop reversed, and backward along the other. So the two
//! loops advance round the strip in opposite senses of their own, as the two ends of a tube do.
//!
//! With points inside, the strip is only where the search begins: [`BridgeOptions::interior`].
//!
//! The loops may be of one mesh, or of two, which are then joined: first the vertices and triangles
//! of the first mesh, then those of the second, then the strip, as the group `bridge`.

use crate::error::MeshError;
use crate::loops::{LoopDefect, Loops};
use crate::points_inside::{Around, NoPoints, PointsInside};
use mindeg_exact::{Bridge, BridgeProblem, bridge_rings, largest_bridge_angle};
use mindeg_mesh::crossing::crossings;
use mindeg_mesh::quality::min_angle;
use mindeg_mesh::{Cancelled, Progress, TriMesh};
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

/// The name of the group of the strip.
pub const BRIDGE: &str = "bridge";

/// Wishes for a bridge; by default a strip without points inside, of the least degree that is possible.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct BridgeOptions {
    /// The limit on total degrees of the strip; without one, the least that is possible.
    pub max_degree: Option<u32>,
    /// Whether the bridge has points inside: edges about as long as those of the loops, 5 to 7 of them at each vertex of the bridge and
    /// its loops, in a tube that continues the mesh at both ends as smoothly as it can. The strip is what it begins with.
    pub interior: bool,
}

/// A mesh with two of its loops joined.
#[derive(Clone, Debug)]
pub struct Bridged {
    /// The mesh.
    pub mesh: TriMesh,
    /// The bridge's triangles.
    pub triangles: Range<u32>,
    /// The figures of the strip without points inside; its triangles are by indices of the loops' vertices.
    pub strip: Bridge,
    /// Its points inside, or why it has none though they were asked for; `None` if they were not.
    pub inside: Option<Result<PointsInside, String>>,
    /// The minimum angle of the bridge, in degrees.
    pub min_angle: f64,
    /// The bridge's triangles that cross another triangle, each with the first that it crosses.
    pub crossings: Vec<[u32; 2]>,
    /// The largest minimum angle of a strip in degrees, if the second mesh were turned over, where
    /// that is more than twice as large: then one of the meshes probably is inside out.
    pub turned_over: Option<f64>,
}

/// Joins a loop of a mesh to another one, or to a loop of a second mesh, each given with its loops, by the strip of least
/// maximum degree, or within [`BridgeOptions::max_degree`], with the largest minimum angle; or with points inside.
///
/// # Errors
///
/// [`MeshError`].
///
/// # Example
///
/// ```
/// use mindeg::{Loops, Progress, TriMesh, bridge::{BridgeOptions, bridge}, glam::DVec3};
///
/// // Two pyramids without bases, back to back.
/// let pyramid = |z: f64, tip: f64, n: u32| {
///     let angle = |i: u32| std::f64::consts::TAU * f64::from(i) / f64::from(n) * tip.signum();
///     let ring = (0..n).map(|i| DVec3::new(angle(i).cos(), angle(i).sin(), z));
///     let points = ring.chain([DVec3::Z * tip]).collect();
///     TriMesh::new(points, (0..n).map(|i| [i, (i + 1) % n, n]).collect())
/// };
/// let (top, bottom) = (pyramid(1.0, 2.0, 8)?, pyramid(-1.0, -2.0, 5)?);
/// let (loops, other) = (Loops::of(&top), Loops::of(&bottom));
/// let options = BridgeOptions::default();
/// let joined = bridge((top, &loops), Some((&bottom, &other)), [0, 0], &options, Progress::NONE)?;
/// assert!(joined.mesh.boundary_loops().is_empty());
/// // Three edges of the pyramids, one of the strip, and two more.
/// assert_eq!(joined.strip.max_degree, 6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn bridge(
    a: (TriMesh, &Loops),
    b: Option<(&TriMesh, &Loops)>,
    [from, to]: [usize; 2],
    options: &BridgeOptions,
    progress: Progress<'_>,
) -> Result<Bridged, MeshError> {
    let (a, own) = a;
    let (b, other) = (b.map(|(mesh, _)| mesh), b.map(|(_, loops)| loops));
    if b.is_none() && from == to {
        return Err(MeshError::Refused(format!(
            "both ends of the bridge are loop {}; give two loops",
            from + 1
        )));
    }
    let target = other.unwrap_or(own);
    let [mut x, y] = [vertices(own, from)?, vertices(target, to)?];
    let first = if b.is_some() { a.positions().len() as u32 } else { 0 };
    if b.is_none()
        && let Some(&vertex) = x.iter().find(|vertex| y.contains(vertex))
    {
        return Err(MeshError::Refused(format!(
            "the loops touch at vertex {vertex}; a bridge needs loops without a common vertex"
        )));
    }
    if let Some(b) = b {
        // -0.0 is 0.0.
        let place = |mesh: &TriMesh, vertex: u32| {
            mesh.positions()[vertex as usize].to_array().map(|x| (x + 0.0).to_bits())
        };
        let there: BTreeMap<_, u32> = y.iter().map(|&vertex| (place(b, vertex), vertex)).collect();
        let same = |&vertex: &u32| there.get(&place(&a, vertex)).map(|&other| (vertex, other));
        if let Some((vertex, other)) = x.iter().find_map(same) {
            return Err(MeshError::Refused(format!(
                "the loops touch: vertex {vertex} of the first mesh and vertex {other} of the second are \
                 at the same place; move one of the meshes"
            )));
        }
    }
    let degrees = |loops: &Loops, ring: &[u32]| -> Vec<u32> {
        ring.iter().map(|&vertex| loops.degrees[vertex as usize]).collect()
    };
    x.reverse();
    let external = [degrees(own, &x), degrees(target, &y)];
    let excluded: Vec<[u32; 2]> = if b.is_none() {
        let pairs = (0_u32..).zip(&x).flat_map(|(i, &vertex)| {
            let places = own.neighbors(vertex).map(|other| y.iter().position(|&v| v == other));
            places.flatten().map(move |j| [i, j as u32])
        });
        pairs.collect()
    } else {
        Vec::new()
    };
    let at = |mesh: &TriMesh, ring: &[u32]| -> Vec<_> {
        ring.iter().map(|&vertex| mesh.positions()[vertex as usize]).collect()
    };
    let [x_points, y_points] = [at(&a, &x), at(b.unwrap_or(&a), &y)];
    let external = [&external[0][..], &external[1]];
    let problem = BridgeProblem::new([&x_points, &y_points], external, excluded)?;
    let strip = bridge_rings(&problem, options.max_degree, progress)?;
    let turned_over = match b {
        Some(_) if !strip.is_planar => {
            let backward: Vec<_> = y_points.iter().rev().copied().collect();
            let degrees: Vec<u32> = external[1].iter().rev().copied().collect();
            let problem = BridgeProblem::new([&x_points, &backward], [external[0], &degrees], [])?;
            let turned = largest_bridge_angle(&problem, progress)?;
            (turned > 2.0 * strip.without_limit.0).then_some(turned)
        }
        _ => None,
    };

    let p = x.len() as u32;
    let vertex = |i: u32| if i < p { x[i as usize] } else { first + y[(i - p) as usize] };
    let triangles: Vec<[u32; 3]> = strip.triangles.iter().map(|t| t.map(vertex)).collect();
    let whole = match b {
        Some(b) => a.with_mesh_added(b)?,
        None => a,
    };
    let start = whole.triangles().len() as u32;
    let y: Vec<u32> = y.iter().map(|&vertex| first + vertex).collect();
    let between = options
        .interior
        .then(|| with_points(&whole, [&x, &y], &triangles, progress))
        .transpose()?;
    let (mesh, triangles, inside) = match between {
        Some(Ok((mesh, triangles, inside))) => (mesh, triangles, Some(Ok(inside))),
        without => {
            let reason = without.and_then(Result::err).map(Err);
            (whole.with_triangles_added(BRIDGE, &triangles)?, triangles, reason)
        }
    };
    progress.report("looking for crossings", 0, 1)?;
    let new = start..mesh.triangles().len() as u32;
    let same = |vertex: u32| match other {
        // Points inside are no vertex twice.
        Some(other) if vertex >= first => {
            other.same.get((vertex - first) as usize).map_or(vertex, |same| first + same)
        }
        _ => own.same.get(vertex as usize).copied().unwrap_or(vertex),
    };
    let merged: Vec<[u32; 3]> = mesh.triangles().iter().map(|t| t.map(same)).collect();
    let crossings = crossings(mesh.positions(), &merged, new.clone());
    let min_angle = min_angle(mesh.positions(), &triangles);
    Ok(Bridged { mesh, triangles: new, strip, inside, min_angle, crossings, turned_over })
}

/// A mesh with a bridge, the bridge's triangles, and its points inside; or why there are none.
type WithPoints = Result<(TriMesh, Vec<[u32; 3]>, PointsInside), String>;

/// A mesh with a bridge that has points inside; `strip` is one without.
fn with_points(
    whole: &TriMesh,
    rims: [&[u32]; 2],
    strip: &[[u32; 3]],
    progress: Progress<'_>,
) -> Result<WithPoints, MeshError> {
    let loops = Loops::of(whole);
    let first = |vertex: u32| loops.same[vertex as usize];
    let [x, y] = rims.map(|rim| rim.iter().map(|&vertex| first(vertex)).collect::<Vec<u32>>());
    let strip: Vec<[u32; 3]> = strip.iter().map(|corners| corners.map(first)).collect();
    let around = Around::of(whole, &loops, x.iter().chain(&y).copied());
    let next = whole.positions().len();
    let filling = match around.meshed(whole, &[&x, &y], &strip, next, progress) {
        Ok(filling) => filling,
        Err(NoPoints::Cancelled) => return Err(Cancelled.into()),
        Err(NoPoints::Because(reason)) => return Ok(Err(reason)),
    };
    let mesh = whole.clone().with_vertices_added(&filling.points)?;
    let mesh = mesh.with_triangles_added(BRIDGE, &filling.triangles)?;
    let mut inside = PointsInside::of(next as u32..mesh.positions().len() as u32);
    let loops = Loops::of(&mesh);
    let open: BTreeSet<u32> = loops.list().iter().flat_map(|it| &it.vertices).copied().collect();
    inside.judge(&[&x, &y], |v| (loops.degrees[v as usize], open.contains(&v)));
    Ok(Ok((mesh, filling.triangles, inside)))
}

/// The vertices of a sound loop.
fn vertices(loops: &Loops, index: usize) -> Result<Vec<u32>, MeshError> {
    let found = loops.get(index)?;
    match found.defect {
        // The others stay open or make more of what is wrong.
        None | Some(LoopDefect::SingleTriangle) => Ok(found.vertices.clone()),
        Some(defect) => {
            let sentence = format!("loop {} cannot be bridged: {defect}", index + 1);
            Err(MeshError::Refused(sentence))
        }
    }
}
