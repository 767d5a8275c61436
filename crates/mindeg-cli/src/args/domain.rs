//! What describes a domain.

use super::values::{Corners, IntervalCounts, RectangleSize, length};
use clap::Args;
use mindeg::Spacing;
use std::path::PathBuf;

/// One domain, from a file or from options.
#[derive(Debug, Args)]
pub(crate) struct DomainArguments {
    /// A domain in JSON; - reads standard input. mindeg mesh also takes a model: an OBJ with faces,
    /// a .glb or .gltf, or JSON with "faces"
    #[arg(id = "domain", value_name = "DOMAIN.json")]
    pub(crate) file: Option<PathBuf>,

    #[command(flatten)]
    pub(crate) options: DomainOptions,
}

/// A domain without a file; with a file, what replaces what it gives for its sides.
#[derive(Debug, Args)]
pub(crate) struct DomainOptions {
    /// A rectangle with these side lengths; its sides are bottom, right, top, left
    #[arg(long, value_name = "WxH", conflicts_with_all = ["domain", "corners"], allow_hyphen_values = true)]
    pub(crate) rectangle: Option<RectangleSize>,

    /// A convex polygon with these corners, in quotes, such as "0,0 4,0 3,2"
    #[arg(long, value_name = "x,y x,y …", conflicts_with = "domain", allow_hyphen_values = true)]
    pub(crate) corners: Option<Corners>,

    /// The intervals of each side, counter-clockwise, such as 3,3,2,2
    #[arg(long, value_name = "a,b,…", conflicts_with = "size", allow_hyphen_values = true)]
    pub(crate) intervals: Option<IntervalCounts>,

    /// The length that the intervals of every side should have
    #[arg(long, value_name = "S", value_parser = length, allow_hyphen_values = true)]
    pub(crate) size: Option<f64>,

    /// How the intervals of every side are spaced: uniform, geometric:RATIO, bump:RATIO,
    /// beta:BETA, first-length:LENGTH or last-length:LENGTH
    #[arg(long, value_name = "LAW", value_parser = spacing)]
    pub(crate) spacing: Option<Spacing>,
}

fn spacing(text: &str) -> Result<Spacing, String> {
    let laws = [
        ("geometric", "a ratio", "geometric:1.2"),
        ("bump", "a ratio", "bump:0.2"),
        ("beta", "a number", "beta:1.05"),
        ("first-length", "a length", "first-length:0.01"),
        ("last-length", "a length", "last-length:0.01"),
    ];
    text.parse().map_err(|_| {
        let law = text.split([':', '=', ' ']).next().unwrap_or_default();
        match laws.into_iter().find(|&(name, ..)| name == law) {
            Some((name, what, example)) => format!("{name} takes {what}, such as {example}"),
            None => "write uniform, geometric:RATIO, bump:RATIO, beta:BETA, first-length:LENGTH \
                     or last-length:LENGTH; explicit parameters need a domain file"
                .to_owned(),
        }
    })
}
