//! `mindeg explore`: a page on this machine on which a boundary is edited and its meshes follow.
//!
//! [`answer`] takes what the page asks for and gives lines of answers, the fast ones first; [`Server`] puts
//! it, the page and the files behind a loopback address that only the page can talk to. Their messages to
//! each other are in [`api`].
//!
//! ```no_run
//! use mindeg_explore::{Server, Setup};
//!
//! let server = Server::new(Setup::default())?;
//! println!("open {}", server.address());
//! server.run()?;
//! # Ok::<(), mindeg_explore::ServerError>(())
//! ```
//!
//! # Limits
//!
//! One user, on this machine. Domains of at most [`MAX_VERTICES`] boundary vertices.

mod all;
mod answer;
pub mod api;
mod arrays;
mod body;
mod changes;
mod command;
mod conditioned;
mod download;
mod facts;
mod files;
mod format;
mod guard;
mod line;
mod mesh;
mod part;
mod presets;
mod reading;
mod received;
mod refusal;
mod routes;
mod server;
mod setup;
mod shown;
mod solid;
mod states;
mod terms;
mod token;
mod whole;
mod work;

pub use answer::{MAX_VERTICES, answer};
pub use api::{AnswerLine, Part, Request, Source, View};
pub use body::MAX_BYTES;
pub use command::KnownFiles;
pub use presets::presets;
pub use reading::{REPAIRED, repaired_if_refused, sources};
pub use server::{Server, ServerError};
pub use setup::{Divide, Setup};
pub use whole::WholeMap;
