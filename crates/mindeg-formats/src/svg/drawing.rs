//! The mesh itself: faces, edges, outline, dots and labels.

use super::frame::Frame;
use super::solid;
use super::style::{LARGEST_DOT, MAX_DOTS, hex};
use super::view::View;
use crate::corners::{degrees, positions, segments, triangles};
use crate::degree_color;
use crate::names::xml;
use glam::{DVec2, DVec3};
use mindeg_mesh::{Group, Line, Mesh, edges_of, sorted};
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::io::{self, Write};

/// A mesh in a picture.
pub(super) struct Drawing<'a> {
    frame: &'a Frame,
    /// The points in the picture.
    points: Vec<DVec2>,
    /// The visible triangles, if some hide others.
    solid: Option<solid::Order>,
    triangles: Vec<[u32; 3]>,
    groups: Vec<Group>,
    /// The colored degree of each vertex; empty if there are too many for dots.
    classes: Vec<u32>,
    /// The edges of one triangle only, as it runs, sorted.
    boundary: Vec<[u32; 2]>,
    lines: Vec<Line>,
    segments: Vec<[u32; 2]>,
}

impl<'a> Drawing<'a> {
    pub(super) fn new(mesh: &dyn Mesh, frame: &'a Frame, view: View) -> Self {
        let vertices = 0..mesh.vertex_count();
        let points: Vec<DVec3> = positions(mesh, vertices.clone()).collect();
        let triangles = triangles(mesh, 0..mesh.triangle_count());
        let mut classes = Vec::new();
        if mesh.vertex_count() <= MAX_DOTS {
            classes = degrees(mesh, vertices).into_iter().map(degree_class).collect();
        }
        let boundary = boundary(&triangles);
        let solid = solid::Order::of(&points, &triangles, view, boundary.is_empty());
        let lines = mesh.lines().into_owned();
        let segment_count = lines.last().map_or(0, |line| line.segments.end);
        Self {
            frame,
            points: points.into_iter().map(|point| frame.place(view.of_point(point))).collect(),
            solid,
            boundary,
            triangles,
            groups: mesh.groups().to_vec(),
            classes,
            lines,
            segments: segments(mesh, 0..segment_count),
        }
    }

    pub(super) fn write(&self, out: &mut impl Write) -> io::Result<()> {
        if let Some(solid) = &self.solid {
            return self.write_solid(solid, out);
        }
        let outline = self.outline();
        write_outline(&outline, "face", out)?;
        if self.groups.len() > 1 {
            self.write_groups(out)?;
        } else if !self.classes.is_empty() {
            self.write_shade(out)?;
        }
        self.write_edges(out)?;
        write_outline(&outline, "outline", out)?;
        self.write_inner_lines(out)?;
        for (class, _) in self.degree_classes() {
            self.write_dots(class, out)?;
        }
        Ok(())
    }

    /// Triangles from the farthest to the nearest, each over those before it, and each dot over the
    /// nearest triangle of its vertex.
    fn write_solid(&self, solid: &solid::Order, out: &mut impl Write) -> io::Result<()> {
        let width = self.edge_width();
        writeln!(out, "<g stroke-width=\"{width:.2}\" stroke-linejoin=\"round\">")?;
        let radii = self.radii();
        let mut buffer = Vec::new();
        for seen in &solid.triangles {
            let class = if seen.is_front { "solid" } else { "solid inside" };
            buffer.extend_from_slice(format!("<path class=\"{class}\" d=\"").as_bytes());
            let corners = self.triangles[seen.triangle as usize];
            self.push_triangle(&mut buffer, &corners);
            buffer.extend_from_slice(b"\"/>\n");
            for vertex in corners {
                let is_last = solid.last_of_vertex[vertex as usize] == seen.triangle;
                if let (true, Some(&class)) = (is_last, self.classes.get(vertex as usize)) {
                    let color = format!("<g fill=\"{}\">", hex(class));
                    buffer.extend_from_slice(color.as_bytes());
                    push_dot(&mut buffer, self.point(vertex), radii[vertex as usize]);
                    buffer.extend_from_slice(b"</g>\n");
                }
            }
        }
        buffer.extend_from_slice(b"</g>\n");
        out.write_all(&buffer)
    }

    /// The loops of the boundary, without the points inside straight lines.
    fn outline(&self) -> Vec<Vec<DVec2>> {
        // Where lines go once round, their ends are the corners.
        let is_one_loop = self.segments.len() == self.boundary.len()
            && self.lines.iter().all(|line| line.is_straight)
            && self.segments.first().map(|s| s[0]) == self.segments.last().map(|s| s[1]);
        if is_one_loop && !self.lines.is_empty() {
            let starts =
                self.lines.iter().map(|line| self.segments[line.segments.start as usize][0]);
            return vec![starts.map(|vertex| self.point(vertex)).collect()];
        }
        let mut used = vec![false; self.boundary.len()];
        let mut loops = Vec::new();
        for first in 0..used.len() {
            let mut points = Vec::new();
            let mut at = first;
            while !std::mem::replace(&mut used[at], true) {
                let [from, to] = self.boundary[at];
                points.push(self.point(from));
                let next = self.boundary.partition_point(|edge| edge[0] < to);
                let goes_on = |&i: &usize| self.boundary.get(i).is_some_and(|edge| edge[0] == to);
                at = (next..).take_while(goes_on).find(|&i| !used[i]).unwrap_or(first);
            }
            if points.len() > 1 {
                loops.push(points);
            }
        }
        loops
    }

    fn point(&self, vertex: u32) -> DVec2 {
        self.points[vertex as usize]
    }

    /// Every other triangle a shade darker, so that the strips stand out.
    fn write_shade(&self, out: &mut impl Write) -> io::Result<()> {
        let mut buffer = b"<path class=\"shade\" d=\"".to_vec();
        self.triangles.iter().skip(1).step_by(2).for_each(|it| self.push_triangle(&mut buffer, it));
        buffer.extend_from_slice(b"\"/>\n");
        out.write_all(&buffer)
    }

    /// Every group in a color, the same for groups of one name.
    fn write_groups(&self, out: &mut impl Write) -> io::Result<()> {
        // Multiples of the golden angle: hues that follow each other are far apart.
        const STEP: usize = 137;
        let mut hues = BTreeMap::new();
        let mut buffer = Vec::new();
        for group in &self.groups {
            let next = hues.len() * STEP % 360;
            let hue = *hues.entry(group.name.as_str()).or_insert(next);
            let path = format!("<path fill=\"hsl({hue},60%,50%)\" fill-opacity=\"0.2\" d=\"");
            buffer.extend_from_slice(path.as_bytes());
            let [start, end] = [group.triangles.start, group.triangles.end].map(|at| at as usize);
            self.triangles[start..end].iter().for_each(|it| self.push_triangle(&mut buffer, it));
            buffer.extend_from_slice(b"\"/>\n");
        }
        out.write_all(&buffer)
    }

    fn push_triangle(&self, buffer: &mut Vec<u8>, triangle: &[u32; 3]) {
        for (&vertex, command) in triangle.iter().zip(*b"MLL") {
            buffer.push(command);
            push_point(buffer, self.point(vertex));
        }
        buffer.push(b'Z');
    }

    /// The segments of lines that are not on the boundary.
    fn write_inner_lines(&self, out: &mut impl Write) -> io::Result<()> {
        let is_boundary = |[from, to]: [u32; 2]| {
            [[from, to], [to, from]].iter().any(|edge| self.boundary.binary_search(edge).is_ok())
        };
        let mut inner = self.segments.iter().filter(|segment| !is_boundary(**segment)).peekable();
        if inner.peek().is_none() {
            return Ok(());
        }
        let mut buffer = b"<path class=\"outline\" d=\"".to_vec();
        for segment in inner {
            for (&vertex, command) in segment.iter().zip(*b"ML") {
                buffer.push(command);
                push_point(&mut buffer, self.point(vertex));
            }
        }
        buffer.extend_from_slice(b"\"/>\n");
        out.write_all(&buffer)
    }

    /// Every interior edge once. A triangulation has each of them in two triangles, which run
    /// through it in opposite directions, and each boundary edge in one.
    fn write_edges(&self, out: &mut impl Write) -> io::Result<()> {
        let width = self.edge_width();
        let mut buffer =
            format!("<path class=\"edge\" stroke-width=\"{width:.2}\" d=\"").into_bytes();
        for triangle in &self.triangles {
            for [from, to] in edges_of(*triangle) {
                if from < to && self.boundary.binary_search(&[from, to]).is_err() {
                    buffer.push(b'M');
                    push_point(&mut buffer, self.point(from));
                    buffer.push(b'L');
                    push_point(&mut buffer, self.point(to));
                }
            }
        }
        buffer.extend_from_slice(b"\"/>\n");
        out.write_all(&buffer)
    }

    fn edge_width(&self) -> f64 {
        (0.06 * self.spacing()).clamp(0.3, 1.6)
    }

    /// The mean length of the boundary edges in pixels; of all edges in a closed mesh.
    fn spacing(&self) -> f64 {
        let length = |[from, to]: [u32; 2]| self.point(from).distance(self.point(to));
        let mean = |edges: &mut dyn Iterator<Item = [u32; 2]>| {
            let (sum, count) =
                edges.fold((0.0, 0), |(sum, count), it| (sum + length(it), count + 1));
            sum / f64::from(count.max(1))
        };
        if self.boundary.is_empty() {
            return mean(&mut self.triangles.iter().copied().flat_map(edges_of));
        }
        mean(&mut self.boundary.iter().copied())
    }

    /// The degrees with a color that occur, in ascending order, with the number of vertices; none
    /// where there are too many vertices for dots.
    pub(super) fn degree_classes(&self) -> Vec<(u32, usize)> {
        degree_color::DISTINCT
            .map(|class| (class, self.classes.iter().filter(|&&c| c == class).count()))
            .filter(|&(_, count)| count > 0)
            .collect()
    }

    /// The vertices that have the color of `class`.
    fn write_dots(&self, class: u32, out: &mut impl Write) -> io::Result<()> {
        let mut buffer = format!("<g fill=\"{}\">\n", hex(class)).into_bytes();
        for ((&point, &of_vertex), radius) in
            self.points.iter().zip(&self.classes).zip(self.radii())
        {
            if of_vertex == class {
                push_dot(&mut buffer, point, radius);
            }
        }
        buffer.extend_from_slice(b"</g>\n");
        out.write_all(&buffer)
    }

    /// The radius of the dot of each vertex.
    fn radii(&self) -> Vec<f64> {
        let size = self.frame.size;
        let largest = (0.2 * size.min_element()).min(LARGEST_DOT * size.max_element());
        let largest = largest.clamp(0.6, 8.0);
        self.nearest().into_iter().map(|nearest| (0.3 * nearest).clamp(0.6, largest)).collect()
    }

    /// The length of the shortest boundary edge at each vertex, or of the shortest edge if it has
    /// none.
    fn nearest(&self) -> Vec<f64> {
        let shortest = |edges: &mut dyn Iterator<Item = [u32; 2]>| {
            let mut shortest = vec![f64::INFINITY; self.points.len()];
            for [from, to] in edges {
                let length = self.point(from).distance(self.point(to));
                for vertex in [from, to] {
                    shortest[vertex as usize] = shortest[vertex as usize].min(length);
                }
            }
            shortest
        };
        let on_boundary = shortest(&mut self.boundary.iter().copied());
        let of_all = shortest(&mut self.triangles.iter().copied().flat_map(edges_of));
        let choose = |(on_boundary, all): (f64, f64)| {
            if on_boundary.is_finite() { on_boundary } else { all }
        };
        on_boundary.into_iter().zip(of_all).map(choose).collect()
    }

    /// Names and intervals along the lines, outside, where there is space.
    pub(super) fn labels(&self) -> String {
        let mut text = String::new();
        for line in &self.lines {
            let [first, last] = [line.segments.start, line.segments.end - 1].map(|i| i as usize);
            let start = self.point(self.segments[first][0]);
            let end = self.point(self.segments[last][1]);
            let label = format!("{} · {}", line.name, line.segments.len());
            // A letter is about half as wide as high.
            if start.distance(end) < 8.0 * label.chars().count() as f64 {
                continue;
            }
            let along = (end - start).normalize();
            // Left of the way round in the mesh is inside; in the picture, y is turned over.
            let outward = DVec2::new(-along.y, along.x);
            // Read from left to right, and upwards where the side is upright.
            let upright = along.x.abs() < 1e-6;
            let forward = if upright { along.y < 0.0 } else { along.x > 0.0 };
            // Adding zero turns -0 into 0.
            let DVec2 { x, y } = if forward { along } else { -along } + DVec2::ZERO;
            let at = start.midpoint(end) + 24.0 * outward;
            let _ = writeln!(
                text,
                r#"<text class="label" dy=".35em" transform="matrix({x:.4} {y:.4} {:.4} {x:.4} {:.2} {:.2})">{}</text>"#,
                0.0 - y,
                at.x,
                at.y,
                xml(&label),
            );
        }
        text
    }
}

/// The edges of one triangle only, as it runs, sorted.
fn boundary(triangles: &[[u32; 3]]) -> Vec<[u32; 2]> {
    // The same edge of two triangles is one after the other once sorted.
    let mut edges: Vec<([u32; 2], [u32; 2])> =
        triangles.iter().copied().flat_map(edges_of).map(|edge| (sorted(edge), edge)).collect();
    edges.sort_unstable();
    let single = edges.chunk_by(|a, b| a.0 == b.0).filter(|same| same.len() == 1);
    let mut boundary: Vec<[u32; 2]> = single.map(|same| same[0].1).collect();
    boundary.sort_unstable();
    boundary
}

/// The degree whose color stands for `degree`.
fn degree_class(degree: u32) -> u32 {
    degree.clamp(*degree_color::DISTINCT.start(), *degree_color::DISTINCT.end())
}

fn write_outline(loops: &[Vec<DVec2>], class: &str, out: &mut impl Write) -> io::Result<()> {
    let mut buffer = Vec::new();
    if let [points] = loops {
        buffer.extend_from_slice(format!("<polygon class=\"{class}\" points=\"").as_bytes());
        for (i, &point) in points.iter().enumerate() {
            if i > 0 {
                buffer.push(b' ');
            }
            push_point(&mut buffer, point);
        }
    } else {
        let start = format!("<path class=\"{class}\" fill-rule=\"evenodd\" d=\"");
        buffer.extend_from_slice(start.as_bytes());
        for points in loops {
            for (i, &point) in points.iter().enumerate() {
                buffer.push(if i == 0 { b'M' } else { b'L' });
                push_point(&mut buffer, point);
            }
            buffer.push(b'Z');
        }
    }
    buffer.extend_from_slice(b"\"/>\n");
    out.write_all(&buffer)
}

fn push_dot(buffer: &mut Vec<u8>, center: DVec2, radius: f64) {
    // A ring sets a dot off from the edges; it would drown a small one.
    let ring: &[u8] =
        if radius >= 3.0 { b"<circle class=\"ring\" cx=\"" } else { b"<circle cx=\"" };
    buffer.extend_from_slice(ring);
    push_pixels(buffer, center.x);
    buffer.extend_from_slice(b"\" cy=\"");
    push_pixels(buffer, center.y);
    buffer.extend_from_slice(b"\" r=\"");
    push_pixels(buffer, radius);
    buffer.extend_from_slice(b"\"/>\n");
}

fn push_point(buffer: &mut Vec<u8>, point: DVec2) {
    push_pixels(buffer, point.x);
    buffer.push(b' ');
    push_pixels(buffer, point.y);
}

/// A length in pixels, to a hundredth.
fn push_pixels(buffer: &mut Vec<u8>, pixels: f64) {
    // Far outside of any picture; of coordinates too large to draw.
    const FAR: f64 = 1e9;
    let hundredths = (pixels.clamp(-FAR, FAR) * 100.0).round();
    let mut digits = zmij::Buffer::new();
    let number = digits.format_finite(hundredths / 100.0);
    buffer.extend_from_slice(number.strip_suffix(".0").unwrap_or(number).as_bytes());
}
