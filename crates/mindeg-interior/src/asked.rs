//! The sizes that were asked for, whatever the edges that stay allow.

use crate::across::sizes_across;
use crate::edge_tree::{EdgeTree, Item};
use crate::options::Options;
use crate::triangle::SQRT_3;
use glam::DVec2;
use mindeg_domain::{Size, SizeBetween, SizeFrom};
use mindeg_mesh::planar::{PlanarBoundary, orientation};
use std::f64::consts::TAU;

/// The sizes that options ask for at any place, infinite where none: those of places, regions, names and background meshes, and the
/// greatest and the least. What a boundary allows is not asked, nor is a size far from it.
///
/// ```
/// use glam::DVec2;
/// use mindeg_domain::{Interior, Size, SizeAt};
/// use mindeg_interior::sizes_asked;
/// use mindeg_mesh::planar::PlanarBoundary;
///
/// let square = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]].map(DVec2::from);
/// let harbour = Size::At(SizeAt { at: DVec2::new(4.0, 0.0), size: 0.1 });
/// let wanted = Interior { sizes: vec![harbour], growth: Some(0.5), ..Interior::default() };
/// let size = sizes_asked(&PlanarBoundary::new(&[square])?, &wanted.into());
/// assert_eq!(size(DVec2::new(2.0, 0.0)), 0.1 + 0.5 * 2.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn sizes_asked(
    outline: &PlanarBoundary,
    options: &Options,
) -> impl Fn(DVec2) -> f64 + Sync + use<> {
    let asked = Asked::new(outline, options);
    move |place| asked.at(place)
}

/// The least size that was asked for at any place.
#[derive(Debug, Clone, Default)]
pub(crate) struct Asked {
    /// The sizes at points.
    places: EdgeTree,
    /// Points and edges with sizes that grow from there: those of background meshes, of the ways across the domain, and of the
    /// borders of regions.
    cones: EdgeTree,
    near: Vec<(EdgeTree, SizeFrom)>,
    between: Vec<(EdgeTree, SizeBetween)>,
    regions: Option<Regions>,
    growth: f64,
    /// The size far from the boundary.
    inside: Option<f64>,
    least: f64,
    greatest: Option<f64>,
}

/// The sizes of regions, which are found by the edge nearest to a point.
#[derive(Debug, Clone)]
struct Regions {
    edges: EdgeTree,
    /// The ends of each edge, and the sizes on its left and right.
    sides: Vec<([DVec2; 2], [f64; 2])>,
    /// The edges of each vertex.
    at_vertex: Vec<Vec<u32>>,
    /// The vertices of each edge.
    ends: Vec<[u32; 2]>,
}

/// The sizes wanted at a place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Wanted {
    /// The size in place of the mean of the boundary's lengths.
    pub(crate) base: Option<f64>,
    /// No size is greater than this.
    pub(crate) most: f64,
}

/// The size whose triangles keep to a greatest area, over the side of the equilateral triangle of that area: so many
/// times are the largest triangles larger than those.
const OF_AREA: f64 = 0.8;

/// The size that keeps triangles below an area.
pub fn size_of_area(area: f64) -> f64 {
    OF_AREA * (4.0 * area / SQRT_3).sqrt()
}

impl Asked {
    pub(crate) fn new(outline: &PlanarBoundary, options: &Options) -> Self {
        let wanted = &options.wanted;
        let point = |(id, at): (u32, mindeg_domain::SizeAt)| Item {
            id,
            from: at.at,
            to: at.at,
            size: at.size,
            reach: 0.0,
        };
        let edge = |id: u32, size: Option<f64>| {
            let [from, to] = outline.ends(id).map(|vertex| outline.point(vertex));
            Item { id, from, to, size: size.unwrap_or(from.distance(to)), reach: 0.0 }
        };
        let (mut cones, mut between, mut near) = (Vec::new(), Vec::new(), Vec::new());
        for size in &wanted.sizes {
            match size {
                Size::Between(samples) => {
                    cones.extend((0..).zip(samples.points.iter().copied()).map(point));
                    between.push((circles(samples), samples.clone()));
                }
                Size::From(from) => {
                    let edges = options.edges_named(&from.from);
                    let items = edges.map(|id| edge(id, Some(from.size))).collect();
                    near.push((EdgeTree::of_items(items), from.clone()));
                }
                Size::At(_) | Size::File(_) => {}
            }
        }
        let ways = wanted
            .across
            .map(|across| sizes_across(outline, across, wanted.min_size.unwrap_or(0.0)));
        cones.extend((0..).zip(ways.into_iter().flatten()).map(point));
        let regions = Regions::new(outline, options);
        for (id, (_, sizes)) in (0..).zip(regions.iter().flat_map(|regions| &regions.sides)) {
            let size = sizes[0].min(sizes[1]);
            cones.extend(size.is_finite().then(|| edge(id, Some(size))));
        }
        Self {
            places: EdgeTree::of_items((0..).zip(wanted.sizes_at()).map(point).collect()),
            cones: EdgeTree::of_items(cones),
            near,
            between,
            regions,
            growth: wanted.growth(),
            inside: wanted.size_inside,
            least: wanted.min_size.unwrap_or(0.0),
            greatest: wanted.max_size,
        }
    }

    /// Whether sizes far from the boundary are asked for, here or there.
    pub(crate) fn has_base(&self) -> bool {
        self.inside.is_some() || !self.between.is_empty() || self.regions.is_some()
    }

    /// The sizes at `x` besides those at points.
    pub(crate) fn wanted(&self, x: DVec2) -> Wanted {
        self.wanted_or(x, self.inside)
    }

    fn wanted_or(&self, x: DVec2, inside: Option<f64>) -> Wanted {
        let region = self.regions.as_ref().map(|regions| regions.size(x));
        let mut base = region.filter(|size| size.is_finite()).or(inside);
        for (circles, samples) in &self.between {
            if let Some(size) = interpolated(circles, samples, x) {
                base = Some(base.map_or(size, |base| base.min(size)));
            }
        }
        let mut most = self.greatest.unwrap_or(f64::INFINITY);
        self.cones.least_grown(self.growth, x, &mut most);
        for (edges, SizeFrom { size, growth, until, .. }) in &self.near {
            let Some((_, distance)) = edges.nearest(x, f64::INFINITY) else { continue };
            let own = distance.min(until.unwrap_or(f64::INFINITY));
            let growth = growth.unwrap_or(self.growth).min(self.growth);
            most = most.min(size + growth * own + self.growth * (distance - own));
        }
        Wanted { base: base.map(|base| base.max(self.least)), most: most.max(self.least) }
    }

    /// The size asked for at `x`, infinite where none is; a size far from the boundary is asked for nowhere else.
    pub(crate) fn at(&self, x: DVec2) -> f64 {
        let Wanted { base, mut most } = self.wanted_or(x, None);
        self.places.least_grown(self.growth, x, &mut most);
        base.map_or(most, |base| base.min(most))
    }
}

/// The circles around the triangles of a background mesh.
fn circles(samples: &SizeBetween) -> EdgeTree {
    let circle = |(id, triangle): (u32, &[u32; 3])| {
        let corners = triangle.map(|point| samples.points[point as usize].at);
        let middle = (corners[0] + corners[1] + corners[2]) / 3.0;
        let reach = corners.iter().map(|corner| corner.distance(middle)).fold(0.0, f64::max);
        // A little more, for rounding.
        Item { id, from: middle, to: middle, size: 1.0, reach: reach * (1.0 + 1e-9) }
    };
    EdgeTree::of_items((0..).zip(&samples.triangles).map(circle).collect())
}

/// The size on the triangle that a point is in, the least of several.
fn interpolated(circles: &EdgeTree, samples: &SizeBetween, x: DVec2) -> Option<f64> {
    let mut found: Option<f64> = None;
    circles.visit(
        |node| node.distance(x) <= 0.0,
        |triangle| {
            let [a, b, c] =
                samples.triangles[triangle as usize].map(|i| samples.points[i as usize]);
            let area = (b.at - a.at).perp_dot(c.at - a.at);
            let share = |p: DVec2, q: DVec2| (p - x).perp_dot(q - x) / area;
            let shares = [share(b.at, c.at), share(c.at, a.at), share(a.at, b.at)];
            if shares.iter().all(|share| *share >= -1e-9) {
                let size = shares[0] * a.size + shares[1] * b.size + shares[2] * c.size;
                let size = size.max(a.size.min(b.size).min(c.size));
                found = Some(found.map_or(size, |least| least.min(size)));
            }
        },
    );
    found
}

impl Regions {
    /// None if no region has a size.
    fn new(outline: &PlanarBoundary, options: &Options) -> Option<Self> {
        let size = |face: Option<u32>| {
            let size = face.and_then(|face| options.region_sizes.get(face as usize).copied());
            size.unwrap_or(f64::INFINITY)
        };
        if options.region_sizes.iter().all(|size| size.is_infinite()) {
            return None;
        }
        let ends: Vec<[u32; 2]> =
            (0..outline.edge_count()).map(|edge| outline.ends(edge)).collect();
        let points = outline.points().len() + outline.inner_points().len();
        let mut at_vertex = vec![Vec::new(); points];
        let mut sides = Vec::new();
        for (edge, (ends, beside)) in (0..).zip(ends.iter().zip(&options.beside)) {
            for &end in ends {
                let all = [end].into_iter().chain(outline.twins(end));
                all.for_each(|vertex| at_vertex[vertex as usize].push(edge));
            }
            sides.push((ends.map(|vertex| outline.point(vertex)), beside.map(size)));
        }
        let item = |(id, ([from, to], _)): (u32, &([DVec2; 2], _))| {
            let (from, to) = (*from, *to);
            Item { id, from, to, size: from.distance(to), reach: 0.0 }
        };
        let edges = EdgeTree::of_items((0..).zip(&sides).map(item).collect());
        Some(Self { edges, sides, at_vertex, ends })
    }

    /// The size of the region around a point; on a border the lesser one.
    fn size(&self, x: DVec2) -> f64 {
        let Some((edge, distance)) = self.edges.nearest(x, f64::INFINITY) else {
            return f64::INFINITY;
        };
        let ([from, to], sizes) = self.sides[edge as usize];
        if distance <= 1e-9 * from.distance(to) {
            return sizes[0].min(sizes[1]);
        }
        let along = (x - from).dot(to - from);
        if along > 0.0 && along < (to - from).length_squared() {
            return sizes[usize::from(orientation(from, to, x) < 0.0)];
        }
        // At a vertex, the first edge clockwise from the point has it on its left.
        let vertex = self.ends[edge as usize][usize::from(along > 0.0)];
        let at = if along > 0.0 { to } else { from };
        let mut first = (TAU, f64::INFINITY);
        for &edge in &self.at_vertex[vertex as usize] {
            let ([a, b], [left, right]) = self.sides[edge as usize];
            let (other, size) = if a == at { (b, left) } else { (a, right) };
            let (from, to) = (other - at, x - at);
            let turn = libm::atan2(from.perp_dot(to), from.dot(to)).rem_euclid(TAU);
            if turn < first.0 {
                first = (turn, size);
            }
        }
        first.1
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Interior;
    use crate::edge_tree::distance_to_segment;
    use mindeg_domain::SizeAt;

    fn at(x: f64, y: f64) -> DVec2 {
        DVec2::new(x, y)
    }

    /// A square of 4 with a line of two edges through it, from corner to corner, by way of (1, 2).
    fn square() -> PlanarBoundary {
        let square = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]].map(DVec2::from);
        PlanarBoundary::map(&[square], &[at(1.0, 2.0)], &[vec![0, 4, 2]]).unwrap().0
    }

    fn asked(options: &Options) -> Asked {
        Asked::new(&square(), options)
    }

    #[test]
    fn regions_are_told_by_the_side_of_their_borders() {
        let faces = square().faces(&[at(1.0, 3.0), at(3.0, 1.0)]).unwrap();
        let options = Options {
            beside: faces.beside,
            region_sizes: vec![0.25, f64::INFINITY],
            ..Options::default()
        };
        let asked = asked(&options);
        // Beside edges, beside the bend of the line on either side, beside corners, and on the line.
        for (x, y) in
            [(0.2, 3.0), (0.9, 2.01), (0.8, 2.2), (2.0, 3.2), (0.01, 0.1), (1.0, 2.0), (2.5, 3.0)]
        {
            assert_eq!(asked.wanted(at(x, y)).base, Some(0.25), "{x} {y}");
        }
        for (x, y) in [(3.0, 1.0), (1.1, 1.99), (2.0, 1.0), (0.1, 0.01), (3.9, 3.7)] {
            let wanted = asked.wanted(at(x, y));
            assert_eq!(wanted.base, None, "{x} {y}");
            // From the border it grows.
            let line = [[at(0.0, 0.0), at(1.0, 2.0)], [at(1.0, 2.0), at(4.0, 4.0)]];
            let distances = line.map(|[a, b]| distance_to_segment(at(x, y), a, b));
            let expected = 0.25 + 0.5 * distances[0].min(distances[1]);
            assert!((wanted.most - expected).abs() < 1e-12, "{x} {y} {wanted:?} {expected}");
        }
    }

    #[test]
    fn sizes_grow_from_named_edges_and_further_beyond_a_distance() {
        let from = SizeFrom {
            from: vec!["wall".to_owned()],
            size: 0.1,
            growth: Some(0.2),
            until: Some(1.0),
        };
        let wanted = Interior { sizes: vec![Size::From(from)], ..Interior::default() };
        let names = vec![("wall".to_owned(), 0..1)];
        let asked = asked(&Options { names, ..Options::from(wanted) });
        for (y, size) in [(0.0, 0.1), (0.5, 0.2), (1.0, 0.3), (3.0, 1.3)] {
            assert!((asked.at(at(2.0, y)) - size).abs() < 1e-12, "{y}");
        }
    }

    #[test]
    fn sizes_between_points_are_linear_and_grow_outside() {
        let points = [(1.0, 1.0, 0.1), (2.0, 1.0, 0.2), (1.0, 2.0, 0.3)];
        let points = points.map(|(x, y, size)| SizeAt { at: at(x, y), size }).to_vec();
        let between = SizeBetween { points, triangles: vec![[0, 1, 2]] };
        let wanted = |least, greatest| Interior {
            sizes: vec![Size::Between(between.clone())],
            min_size: least,
            max_size: greatest,
            ..Interior::default()
        };
        let asked_for = |wanted: Interior| asked(&Options::from(wanted));
        let plain = asked_for(wanted(None, None));
        for (x, y, size) in [(1.0, 1.0, 0.1), (1.5, 1.0, 0.15), (1.2, 1.3, 0.18)] {
            assert!((plain.at(at(x, y)) - size).abs() < 1e-12, "{x} {y}");
        }
        assert_eq!(plain.wanted(at(1.0, 0.0)), Wanted { base: None, most: 0.6 });
        let bounded = asked_for(wanted(Some(0.16), Some(0.5)));
        assert_eq!(bounded.at(at(1.0, 1.0)), 0.16);
        assert_eq!(bounded.at(at(1.0, 0.0)), 0.5);
    }
}
