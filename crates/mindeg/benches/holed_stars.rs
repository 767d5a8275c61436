//! Which least degrees of star-shaped domains with holes are proven, and how long that takes: by their numbers of points
//! and of holes, twelve domains each.
//!
//! `cargo bench -p mindeg --bench holed_stars -- 250 10` takes 250 points and 10 holes alone.

#[path = "../tests/stars/mod.rs"]
mod stars;

use mindeg::Progress;
use mindeg::exact::degree_of_boundary;
use std::error::Error;
use std::time::Instant;

fn main() -> Result<(), Box<dyn Error>> {
    // Cargo adds `--bench`.
    let words = std::env::args().skip(1).filter(|word| word != "--bench");
    let given = words.map(|word| word.parse()).collect::<Result<Vec<u32>, _>>()?;
    let only = |at: usize, value: u32| given.get(at).is_none_or(|&only| only == value);
    for points in [100, 150, 200, 250, 300, 500, 750] {
        for holes in [1, 2, 5, 10, 20] {
            if !only(0, points) || !only(1, holes) {
                continue;
            }
            let mut seconds = Vec::new();
            let mut open = String::new();
            for seed in 1..=12 {
                let boundary = stars::star(points, holes, seed);
                let start = Instant::now();
                let answer =
                    degree_of_boundary(&boundary, mindeg_exact::MAX_TRIPLES, Progress::NONE)?;
                seconds.push(start.elapsed().as_secs_f64());
                if answer.least_max_degree().is_none() {
                    open +=
                        &format!("; seed {seed} open: {} to {}", answer.at_least, answer.reached);
                }
            }
            seconds.sort_by(f64::total_cmp);
            let [median, slowest] = [seconds[seconds.len() / 2], seconds[seconds.len() - 1]];
            println!("{points} points, {holes} holes: {median:.2} s, slowest {slowest:.2} s{open}");
        }
    }
    Ok(())
}
