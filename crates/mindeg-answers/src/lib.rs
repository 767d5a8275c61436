//! The answers about a domain or a mesh, each once: values to serialise, with their text.
//!
//! The command line prints them, `mindeg explore` sends them and Python gets them as dicts, so a key
//! and a sentence are the same everywhere.
//!
//! ```
//! use mindeg::{Domain, Progress, Side};
//! use mindeg_answers::degree::DegreeReport;
//!
//! let domain = Domain::rectangle(4.0, 3.0, [12, 9, 4, 4].map(Side::count).to_vec())?;
//! let report = DegreeReport::of(&domain, Progress::NONE)?;
//! println!("{}", report.text());
//! assert_eq!(report.least_max_degree, Some(5));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Limits
//!
//! One language; angles are in degrees.

pub mod advice;
mod advised;
pub mod command;
pub mod condition;
pub mod degree;
pub mod demands;
pub mod inspected;
pub mod interior;
pub mod interior_keys;
pub mod limit;
pub mod loops;
pub mod measures;
pub mod mesh;
pub mod model;
pub mod names;
pub mod numbers;
pub mod ocean;
pub mod on_edges;
pub mod preset;
pub mod proof;
pub mod proven;
mod purpose;
pub mod remesh;
pub mod sizes;
pub mod stitch;
pub mod suggest;
pub mod surface;
pub mod trade_off;
pub mod verify;
