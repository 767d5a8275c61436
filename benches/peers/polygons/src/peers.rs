//! The programs, each called in the way that suits it best.

use crate::input::Input;
use cpu_time::ProcessTime;
use i_triangle::float::triangulation::{RawTriangulation, Triangulation};
use i_triangle::float::unchecked::UncheckedTriangulatable;
use mindeg_exact::{Problem, Progress, best_angle, degree_range};
use std::collections::{HashMap, HashSet};
use std::error::Error;
use std::io::Write;
use std::process::{Command, Stdio};
use std::time::Duration;

/// The triangles, or why there are none.
pub(crate) type Triangles = Result<Vec<[u32; 3]>, Box<dyn Error>>;

pub(crate) struct Peer {
    pub(crate) name: &'static str,
    pub(crate) called: &'static str,
    /// Its triangles; some also say how long they took, where the rest of the work is ours.
    pub(crate) run: fn(&Input, &mut Option<Duration>) -> Triangles,
}

/// Beyond this many triples of vertices that see each other, the best angle takes too long here.
const MOST_TRIPLES: u64 = 20_000_000;

/// mindeg comes first; its Delaunay triangulation has the angle that the others are measured by.
pub(crate) const PEERS: [Peer; 9] = [
    Peer {
        name: "mindeg",
        called: "`degree_range`: the least maximum degree with its proof, or the gap; with it the \
                 Delaunay triangulation that it starts from",
        run: |input, _| Ok(degree_range(&problem(input)?, Progress::NONE)?.triangles),
    },
    Peer {
        name: "mindeg, angle",
        called: "the same, then `best_angle` under that degree; not with holes or beyond 20 million \
                 triples of vertices that see each other",
        run: |input, _| {
            let mut problem = problem(input)?;
            problem.set_max_triples(MOST_TRIPLES);
            let least = degree_range(&problem, Progress::NONE)?.max_degree;
            Ok(best_angle(&problem, least, Progress::NONE)?.triangles)
        },
    },
    Peer {
        name: "Delaunay",
        called: "`mindeg_delaunay::triangles`: spade, rings bisected, faces outside dropped",
        run: |input, _| delaunay(input),
    },
    Peer {
        name: "spade",
        called: "`bulk_load_cdt` with the rings as constraints; faces outside dropped",
        run: |input, _| spade(input),
    },
    Peer {
        name: "Triangle",
        called: "Shewchuk's C through its Python binding, the rings as segments (`-p`), its own time",
        run: triangle,
    },
    Peer {
        name: "earcut",
        called: "`Earcut::earcut_slice`",
        run: |input, _| earcut(input, |_, _| ()),
    },
    Peer {
        name: "earcut, refined",
        called: "the same, then `refine`: flips towards Delaunay",
        run: |input, _| earcut(input, earcut::refine),
    },
    Peer {
        name: "i_triangle",
        called: "`unchecked_triangulate`; to match its points with ours is not timed",
        run: |input, time| i_triangle(input, time, |raw| raw.to_triangulation()),
    },
    Peer {
        name: "i_triangle, Delaunay",
        called: "the same, then `into_delaunay`",
        run: |input, time| i_triangle(input, time, |raw| raw.into_delaunay().to_triangulation()),
    },
];

fn delaunay(input: &Input) -> Triangles {
    Ok(mindeg_delaunay::triangles(&input.boundary()?, &[], &[], Progress::NONE)?)
}

fn problem(input: &Input) -> Result<Problem, Box<dyn Error>> {
    Ok(Problem::triangulated(&input.boundary()?, &delaunay(input)?)?)
}

fn spade(input: &Input) -> Triangles {
    use spade::{ConstrainedDelaunayTriangulation, Point2, RefinementParameters, Triangulation};
    let points = input.points.iter().map(|p| p.to_array().into()).collect();
    let edges = input.edges().map(|edge| edge.map(|vertex| vertex as usize)).collect();
    let mut loaded = ConstrainedDelaunayTriangulation::<Point2<f64>>::bulk_load_cdt(points, edges)?;
    // spade's own way to tell which faces are outside.
    let nothing_but =
        RefinementParameters::new().exclude_outer_faces(true).with_max_additional_vertices(0);
    let outside: HashSet<_> = loaded.refine(nothing_but).excluded_faces.into_iter().collect();
    let inside = loaded.inner_faces().filter(|face| !outside.contains(&face.fix()));
    Ok(inside.map(|face| face.vertices().map(|vertex| vertex.fix().index() as u32)).collect())
}

fn earcut(input: &Input, finish: impl Fn(&mut [u32], &[[f64; 2]])) -> Triangles {
    let points: Vec<[f64; 2]> = input.points.iter().map(|p| p.to_array()).collect();
    let holes: Vec<u32> = input.rings[1..].iter().map(|ring| ring.start).collect();
    let mut indices = Vec::new();
    earcut::Earcut::new().earcut_slice(&points, &holes, &mut indices);
    finish(&mut indices, &points);
    Ok(threes(&indices))
}

fn i_triangle(
    input: &Input,
    time: &mut Option<Duration>,
    finish: impl Fn(RawTriangulation<[f64; 2]>) -> Triangulation<[f64; 2], u32>,
) -> Triangles {
    let contours = input.contours();
    let start = ProcessTime::now();
    let raw = contours.unchecked_triangulate();
    let grid = raw.adapter.clone();
    let mesh = finish(raw);
    *time = Some(start.elapsed());
    // It sorts the points, and rounds them to a grid.
    let on_grid = |point: &[f64; 2]| grid.int_to_float(&grid.float_to_int(point)).map(f64::to_bits);
    let ids: HashMap<[u64; 2], u32> = contours.iter().flatten().map(on_grid).zip(0..).collect();
    let vertex = |&index: &u32| {
        let point = mesh.points[index as usize].map(f64::to_bits);
        ids.get(&point).copied().unwrap_or(u32::MAX)
    };
    Ok(threes(&mesh.indices.iter().map(vertex).collect::<Vec<u32>>()))
}

/// Triangle may not be used commercially, so nothing here links to it: the variable
/// `TRIANGLE_PYTHON` names an interpreter that has it.
fn triangle(input: &Input, time: &mut Option<Duration>) -> Triangles {
    let python = std::env::var_os("TRIANGLE_PYTHON").ok_or("left out")?;
    let mut text = format!("{} {}\n", input.points.len(), input.in_holes.len());
    for point in input.points.iter().chain(&input.in_holes) {
        text += &format!("{} {}\n", point.x, point.y);
    }
    input.edges().for_each(|[from, to]| text += &format!("{from} {to}\n"));
    let mut child = Command::new(python)
        .args(["-I", "-c", include_str!("../shewchuk.py")])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()?;
    // It reads everything before it writes anything.
    child.stdin.take().ok_or("no standard input")?.write_all(text.as_bytes())?;
    let output = child.wait_with_output()?;
    if !output.status.success() {
        return Err(output.status.to_string().into());
    }
    let answer = String::from_utf8(output.stdout)?;
    let mut words = answer.split_ascii_whitespace();
    *time = Some(Duration::try_from_secs_f64(words.next().ok_or("no answer")?.parse()?)?);
    Ok(threes(&words.map(str::parse).collect::<Result<Vec<u32>, _>>()?))
}

fn threes(vertices: &[u32]) -> Vec<[u32; 3]> {
    vertices.chunks_exact(3).map(|of| [of[0], of[1], of[2]]).collect()
}
