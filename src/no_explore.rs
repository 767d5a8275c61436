//! `mindeg explore` in a build without the feature: a sentence says how to get it.

use crate::args::ExploreArguments;
use crate::failure::Failure;

pub(crate) fn run(_: &ExploreArguments) -> Result<(), Failure> {
    Err(Failure::input(
        "this mindeg was built without explore; build it with \
                   cargo build --release -p mindeg-cli --features explore",
    ))
}
