//! `mindeg explore`: a page to edit a boundary on.

use crate::args::ExploreArguments;
use crate::failure::Failure;

/// Without the feature, a sentence says how to get it.
#[cfg(not(feature = "explore"))]
pub(crate) fn run(_: &ExploreArguments) -> Result<(), Failure> {
    let message = "this mindeg was built without explore; build it with \
                   cargo build --release -p mindeg-cli --features explore";
    Err(Failure::Input(message.to_owned()))
}

#[cfg(feature = "explore")]
pub(crate) fn run(arguments: &ExploreArguments) -> Result<(), Failure> {
    use crate::interrupt::clean_up_on_interrupt;
    use crate::standard_output::print;
    use mindeg_explore::{Server, Setup};

    clean_up_on_interrupt()?;
    let setup = Setup { port: arguments.port.unwrap_or(0), start: None };
    let failed = |error: mindeg_explore::ServerError| Failure::Io(error.to_string());
    let server = Server::new(setup).map_err(failed)?;
    print(&format!("{}\n", server.address()))?;
    match server.run().map_err(failed)? {}
}
