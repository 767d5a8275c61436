//! `mindeg explore`.

use super::purpose::PurposeArgument;
use super::with_exit_codes;
use clap::Args;
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  mindeg explore
  mindeg explore assets/domains/boundary-layer-channel.json
  mindeg explore outline.svg --port 8080 --no-open";

/// Edit a boundary on a page of this machine and see its meshes follow
///
/// Prints an address and opens it in a browser: drag corners, change interval counts and spacing laws, pick a
/// point of the curve of degree against angle, and download the mesh. The page is loaded from this
/// process, which listens on 127.0.0.1 and answers only who knows the token in the address. Ctrl-C ends it.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES, after_long_help = with_exit_codes(EXAMPLES))]
pub(crate) struct ExploreArguments {
    /// The domain to begin with, in any format that mindeg mesh takes; - reads standard input. Without it, the
    /// boundary-layer channel
    #[arg(value_name = "DOMAIN")]
    pub(crate) domain: Option<PathBuf>,

    #[command(flatten)]
    pub(crate) purpose: PurposeArgument,

    /// The port to listen on; by default any that is free
    #[arg(long, value_name = "PORT", value_parser = clap::value_parser!(u16).range(1..))]
    pub(crate) port: Option<u16>,

    /// Print the address and open no browser
    #[arg(long)]
    pub(crate) no_open: bool,
}
