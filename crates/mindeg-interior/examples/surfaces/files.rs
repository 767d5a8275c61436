//! Surfaces from files.

use crate::models::Model;
use glam::DVec3;

/// The triangles of an OBJ or OFF file; faces with more corners become fans.
pub(crate) fn read(path: &str) -> Model {
    let text = std::fs::read_to_string(path).unwrap_or_default();
    let (mut points, mut triangles): (Vec<DVec3>, Vec<[u32; 3]>) = (Vec::new(), Vec::new());
    let mut fan = |corners: &[u32]| {
        triangles.extend((2..corners.len()).map(|i| [corners[0], corners[i - 1], corners[i]]));
    };
    if path.ends_with(".obj") {
        for line in text.lines() {
            let mut words = line.split_whitespace();
            match words.next() {
                Some("v") => points.push(point(words)),
                Some("f") => {
                    let index = |word: &str| word.split('/').next()?.parse::<u32>().ok();
                    fan(&words.filter_map(index).map(|v| v.wrapping_sub(1)).collect::<Vec<_>>());
                }
                _ => {}
            }
        }
    } else {
        let lines = text.lines().map(|line| line.split('#').next().unwrap_or(""));
        let mut words = lines.flat_map(str::split_whitespace).skip(1);
        let mut next = || words.next().and_then(|word| word.parse::<f64>().ok()).unwrap_or(0.0);
        let [vertices, faces, _] = [0; 3].map(|_| next() as usize);
        points.extend((0..vertices).map(|_| DVec3::new(next(), next(), next())));
        for _ in 0..faces {
            let count = next() as usize;
            fan(&(0..count).map(|_| next() as u32).collect::<Vec<_>>());
        }
    }
    (points, triangles, None)
}

fn point<'a>(words: impl Iterator<Item = &'a str>) -> DVec3 {
    let mut numbers = words.map(|word| word.parse().unwrap_or(0.0));
    let mut next = || numbers.next().unwrap_or(0.0);
    DVec3::new(next(), next(), next())
}
