//! The facts of this build.

use std::env::consts::{ARCH, OS};

/// The features that a build may have.
const FEATURES: [(&str, bool); 2] =
    [("explore", cfg!(feature = "explore")), ("png", cfg!(feature = "png"))];

/// The version, and what else tells builds apart.
pub(crate) fn verbose() -> String {
    let features: Vec<&str> =
        FEATURES.iter().filter(|(_, is_on)| *is_on).map(|(name, _)| *name).collect();
    let features = if features.is_empty() { "none".to_owned() } else { features.join(", ") };
    // The build of a release gives both; others need not run a program to find them.
    let commit =
        option_env!("MINDEG_COMMIT").unwrap_or("not known, as this is no build of a release");
    let rust = option_env!("MINDEG_RUST").unwrap_or("not known");
    format!(
        "mindeg {}\ncommit: {commit}\nfeatures: {features}\ntarget: {ARCH}-{OS}\nrust: {rust}\n",
        env!("CARGO_PKG_VERSION")
    )
}
