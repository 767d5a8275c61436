//! Which boundary loop of a mesh is meant.

use std::str::FromStr;

/// A boundary loop: by its index in the list, by a vertex on it, or as the nearest to a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum LoopChoice {
    /// From 1.
    Number(usize),
    /// A vertex, counted from 0.
    Vertex(u32),
    /// A point in space.
    Near([f64; 3]),
}

impl FromStr for LoopChoice {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let problem = || {
            "give the index of a loop from 1, such as 2, a vertex on it such as v17, or a point near it \
             such as 0,0,1.5"
                .to_owned()
        };
        let text = text.trim();
        if text.contains(',') {
            let numbers: Result<Vec<f64>, _> = text.split(',').map(|x| x.trim().parse()).collect();
            let point: Option<[f64; 3]> = numbers.ok().and_then(|point| point.try_into().ok());
            let point = point.filter(|point| point.iter().all(|x| x.is_finite()));
            return point.map(Self::Near).ok_or_else(problem);
        }
        if let Some(vertex) = text.strip_prefix('v') {
            return vertex.parse().map(Self::Vertex).map_err(|_| problem());
        }
        let number = text.parse().ok().filter(|&number| number > 0);
        number.map(Self::Number).ok_or_else(problem)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn loops_are_named_by_number_vertex_or_point() {
        for (text, choice) in [
            ("2", LoopChoice::Number(2)),
            (" v17", LoopChoice::Vertex(17)),
            ("0,-1, 1.5e2", LoopChoice::Near([0.0, -1.0, 150.0])),
        ] {
            assert_eq!(text.parse(), Ok(choice));
        }
        for wrong in ["", "0", "-1", "v", "v-1", "1,2", "1,2,3,4", "1,2,nan", "two", "1.5"] {
            assert!(wrong.parse::<LoopChoice>().is_err(), "{wrong:?}");
        }
    }
}
