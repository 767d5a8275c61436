//! `mindeg explore`.

use super::domain::DomainArguments;
use super::purpose::PurposeArgument;
use super::values::port;
use super::with_exit_codes;
use clap::Args;

const EXAMPLES: &str = "\
Examples:
  mindeg explore
  mindeg explore assets/domains/boundary-layer-channel.json
  mindeg explore assets/models/bracket.obj
  mindeg explore outline.svg --size 0.5 --port 8080 --no-open
  mindeg explore coast.geojson --project auto --size 5km";

/// Edit a boundary on a page of this machine and see its meshes follow
///
/// Prints an address and opens it in a browser: drag corners, change interval counts and spacing laws, pick a
/// point of the curve of degree against angle, and download the mesh. The page is loaded from this
/// process, which listens on 127.0.0.1 and answers only who knows the token in the address. Ctrl-C ends it.
/// Without a domain it begins with the boundary-layer channel. A file with a surface in space (OBJ, STL, PLY, glTF and so on), or
/// with a whole model, is shown in 3D: to be turned, meshed anew, filled or bridged.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES, after_long_help = with_exit_codes(EXAMPLES))]
pub(crate) struct ExploreArguments {
    #[command(flatten)]
    pub(crate) domain: DomainArguments,

    #[command(flatten)]
    pub(crate) purpose: PurposeArgument,

    /// The port to listen on; by default any that is free
    #[arg(long, value_name = "PORT", value_parser = port, allow_hyphen_values = true)]
    pub(crate) port: Option<u16>,

    /// Print the address and open no browser
    #[arg(long)]
    pub(crate) no_open: bool,
}
