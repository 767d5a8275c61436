//! Polygons repaired together, so that borders stay shared: those that cross get vertices there, on both sides.
//!
//! Vertices that are nearer to each other than a tolerance become the first of them, and an edge that passes a vertex so
//! near goes through it. A place that several polygons cover becomes that of the first.

use mindeg_mesh::planar::doubled_area;
use mindeg_mesh::{listed, number};
use std::collections::BTreeMap;

use glam::DVec2;

use crate::curve::norm;
use crate::error::OutlineError;
use crate::nesting::{Loop, smallest_around};
use crate::noding::noded;
use crate::outline::{Feature, FillRule, Outlines};
use crate::overlay::edge::{Edge, Layer, points_of};
use crate::overlay::faces::{Graph, links};
use crate::overlay::{chords, ring, rounding, turns_left};
use crate::text::{counted, shown};
use crate::vertices::Vertices;

/// So many polygons that are left out are named.
const NAMED: usize = 5;

impl Outlines {
    /// The same polygons without overlaps and crossings, and with the points of neighbours on shared borders. Points
    /// nearer to each other, or to an edge, than `tolerance` become one; without it, those that rounding parts. Notes
    /// tell what was done.
    ///
    /// # Errors
    ///
    /// Edges too many or too near each other to be told apart in some seconds.
    pub fn repaired_together(
        mut self,
        rule: Option<FillRule>,
        tolerance: Option<f64>,
    ) -> Result<Self, OutlineError> {
        self.cut_at_antimeridian()?;
        let Self { features, inside, periodic, kinds, notes, shapes, projection, .. } = self;
        let wrong = |problem: String| OutlineError::place("", problem);
        let rule_of = |index: usize| {
            let shape = shapes.partition_point(|shape| shape.end <= index);
            rule.or(shapes.get(shape).map(|shape| shape.rule)).unwrap_or(FillRule::EvenOdd)
        };
        let layers: Vec<Layer<'_>> = (features.iter().enumerate())
            .map(|(index, feature)| Layer {
                rings: feature.rings.iter().collect(),
                rule: rule_of(index),
            })
            .collect();
        let rounding = rounding(&layers).map_err(wrong)?;
        let mut done =
            Done { tolerance: tolerance.unwrap_or(0.0).max(rounding), ..Done::default() };
        let mut exact = Vertices::new(DVec2::ZERO, rounding);
        let (mut chords, repeated) = chords(&layers, &mut exact);
        done.repeated = repeated;
        let mut vertices = Vertices::new(DVec2::ZERO, done.tolerance);
        let snapped: Vec<u32> = exact.points.iter().map(|&at| vertices.index_near(at)).collect();
        let is_moved = |vertex: u32| {
            vertices.points[snapped[vertex as usize] as usize] != exact.points[vertex as usize]
        };
        for vertex in (0..snapped.len() as u32).filter(|&vertex| is_moved(vertex)) {
            let by =
                vertices.points[snapped[vertex as usize] as usize] - exact.points[vertex as usize];
            done.moved += 1;
            done.farthest = done.farthest.max(norm(by));
        }
        for chord in &mut chords {
            if chord.part.1 > 1 && chord.ends.iter().any(|&end| is_moved(end)) {
                // The curve is no longer whole.
                chord.part.1 += 1;
            }
            chord.ends = chord.ends.map(|end| snapped[end as usize]);
        }
        let edges = (0..).zip(&chords).map(|(chord, it)| Edge { ends: it.ends, chord });
        let edges = edges.filter(|edge| edge.ends[0] != edge.ends[1]).collect();
        let (edges, added) =
            noded(edges, &mut vertices, done.tolerance, |_, _| true).map_err(wrong)?;
        done.added = added;

        let (links, changes) = links(&edges, |edge| chords[edge.chord as usize].layer as u32);
        let points = &vertices.points;
        let graph = Graph::new(&links, points);
        let windings = graph.windings(&changes).map_err(wrong)?;
        let covering = |windings: &Vec<(u32, i64)>| -> Vec<u32> {
            let counts =
                |&&(layer, winding): &&(u32, i64)| layers[layer as usize].rule.counts(winding);
            windings.iter().filter(counts).map(|entry| entry.0).collect()
        };
        let covering: Vec<Vec<u32>> = windings.all.iter().map(covering).collect();
        let on_left = |half: usize| &covering[windings.left[half] as usize];
        let owner = |half: usize| on_left(half).first().copied();
        done.dropped =
            (0..links.len()).filter(|link| owner(2 * link) == owner(2 * link + 1)).count();
        let is_shared = |half: usize| on_left(half).len() > 1;
        for (set, steps) in graph.rings(|half| is_shared(half).then(|| windings.left[half])) {
            done.overlap(&covering[set as usize], &points_of(&steps, points));
        }
        let is_border = |half: usize| owner(half) != owner(half ^ 1);
        let mut rings = graph.rings(|half| owner(half).filter(|_| is_border(half)));
        for (_, steps) in &mut rings {
            let first = (0..steps.len()).min_by_key(|&at| steps[at].chord).unwrap_or_default();
            steps.rotate_left(first);
        }
        rings.sort_by_key(|(owner, steps)| (*owner, steps[0].chord));

        let mut repaired = Self { inside, periodic, kinds, notes, projection, ..Self::default() };
        let mut rest = &rings[..];
        for (index, feature) in (0..).zip(&features) {
            let own = rest.partition_point(|(owner, _)| *owner == index);
            let (of_feature, others) = rest.split_at(own);
            rest = others;
            if of_feature.is_empty() {
                done.vanished.push(name_of(&features, index));
                continue;
            }
            let (outers, holes): (Vec<_>, Vec<_>) = (of_feature.iter())
                .map(|(_, steps)| (points_of(steps, points), ring(steps, points, &chords)))
                .partition(|(points, _)| turns_left(points));
            let (outers, mut polygons): (Vec<_>, Vec<_>) =
                outers.into_iter().map(|(points, ring)| (Loop::new(points), vec![ring])).unzip();
            for (points, ring) in holes {
                if let Some(at) = smallest_around(outers.iter().enumerate(), &points) {
                    polygons[at].push(ring);
                }
            }
            let name = feature.name.clone();
            let max_area = feature.max_area;
            let polygon = |rings| Feature { name: name.clone(), rings, max_area };
            repaired.features.extend(polygons.into_iter().map(polygon));
            repaired.end_shape();
        }
        repaired.notes.push(done.note(&features));
        repaired.clip_inside(done.tolerance)?;
        Ok(repaired)
    }
}

/// The name of a polygon.
fn name_of(features: &[Feature], index: u32) -> String {
    let name = features.get(index as usize).and_then(|feature| feature.name.clone());
    name.unwrap_or_else(|| format!("polygon {}", index + 1))
}

/// The changes of a repair.
#[derive(Default)]
struct Done {
    tolerance: f64,
    moved: usize,
    farthest: f64,
    added: usize,
    repeated: usize,
    dropped: usize,
    /// Twice the area of the places that several polygons covered, with a point of each place.
    overlaps: BTreeMap<Vec<u32>, (f64, DVec2)>,
    vanished: Vec<String>,
}

impl Done {
    fn overlap(&mut self, covering: &[u32], ring: &[DVec2]) {
        let at = ring.first().copied().unwrap_or_default();
        self.overlaps.entry(covering.to_vec()).or_insert((0.0, at)).0 += doubled_area(ring);
    }

    fn note(&self, features: &[Feature]) -> String {
        let mut said = Vec::new();
        if self.moved > 0 {
            let (points, farthest) = (counted(self.moved, "point"), self.farthest);
            said.push(format!("moved {points} by {} at most", number(farthest)));
        }
        if self.added > 0 {
            said.push(format!("added {} where edges meet", counted(self.added, "point")));
        }
        if self.repeated > 0 {
            said.push(format!("dropped {}", counted(self.repeated, "repeated point")));
        }
        if self.dropped > 0 {
            said.push(format!(
                "dropped {} inside one polygon or outside all",
                counted(self.dropped, "edge")
            ));
        }
        let largest = self.overlaps.iter().max_by(|a, b| a.1.0.total_cmp(&b.1.0));
        if let Some((covering, (_, at))) = largest {
            let area: f64 = self.overlaps.values().map(|overlap| overlap.0 / 2.0).sum();
            let names: Vec<String> =
                covering.iter().take(2).map(|&index| name_of(features, index)).collect();
            said.push(format!(
                "gave an area of {}, where polygons overlap, to the first of them: the most of it to {}, at {}",
                number(area),
                names.join(", not "),
                shown(*at)
            ));
        }
        if !self.vanished.is_empty() {
            let names = listed(self.vanished.iter().cloned(), NAMED, ", ");
            said.push(format!("left out {names}, which bound no area"));
        }
        if said.is_empty() {
            said.push("nothing to do".to_owned());
        }
        let count = counted(features.len(), "polygon");
        let tolerance = self.tolerance;
        format!(
            "repaired {count} together, with points nearer than {} as one: {}",
            number(tolerance),
            said.join("; ")
        )
    }
}
