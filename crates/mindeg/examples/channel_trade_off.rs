//! The best minimum angle for each maximum degree on a channel with boundary layers:
//!
//! ```text
//! cargo run -p mindeg --example channel_trade_off
//! ```

use std::error::Error;

use mindeg::{Domain, Progress, Side, Spacing, exact};

fn main() -> Result<(), Box<dyn Error>> {
    // Ten times as long as high; the first cells at both walls are a tenth of those in the middle.
    let wall = |name| Side::count(20).named(name);
    let opening = |name| Side::count(12).spaced(Spacing::Bump { ratio: 0.1 }).named(name);
    let sides = vec![wall("floor"), opening("outlet"), wall("ceiling"), opening("inlet")];
    let domain = Domain::rectangle(10.0, 1.0, sides)?.named("channel")?;

    let trade_off = exact::trade_off(&domain, Progress::NONE)?;
    println!("maximum degree  minimum angle  of Delaunay's");
    for exact in trade_off.meshes() {
        println!(
            "{:>14}  {:>12.3}°  {:>11.1} %",
            exact.max_degree,
            exact.min_angle,
            100.0 * trade_off.share(exact),
        );
    }
    Ok(())
}
