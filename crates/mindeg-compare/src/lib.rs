//! mindeg's mesh beside other triangulations of the same boundary points: what least degree
//! costs, and what it buys.
//!
//! [`compare`] triangulates a domain by mindeg, by Delaunay, by ear clipping and as a fan,
//! checks every result with [`mindeg_mesh::check`], measures all, and says in words what the figures
//! mean. The fan is for convex domains only.
//!
//! ```
//! use mindeg_compare::{CompareOptions, compare};
//! use mindeg::{Domain, Side};
//!
//! let domain = Domain::rectangle(4.0, 3.0, vec![Side::count(10); 4])?;
//! let comparison = compare(&domain, &CompareOptions::default())?;
//! for method in &comparison.report().methods {
//!     println!("{}: degree {:?}, angle {:?}", method.method, method.max_degree, method.min_angle);
//! }
//! println!("{}", comparison.report().verdict);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! [`mindeg::exact`] has what lies between the least degree and Delaunay's angle: the best mesh for every
//! maximum degree.
//!
//! [`write_view`] is for a single mesh of any program: the pictures and charts of the reports.
//!
//! # Limits
//!
//! Whole meshes are kept in memory, of at most [`MAX_COMPARED_VERTICES`] boundary vertices. All
//! other methods use the boundary points alone, and the lines and points inside a map; [`CompareOptions::interior`] adds a
//! refinement with points inside.

mod advised;
pub mod axis;
mod comparison;
mod figures;
mod interior;
mod measure;
mod method;
pub mod reference;
mod regions;
pub mod report;
mod verdict;

pub use comparison::{CompareError, CompareOptions, Comparison, MAX_COMPARED_VERTICES, compare};
pub use figures::{DefectKind, DomainFigures, MethodDefect, MethodFigures};
pub use interior::InteriorFigures;
pub use method::Method;
pub use reference::{NoTriangulation, Reference, Timed};
pub use report::{
    IndexEntry, PageLinks, Provenance, Report, report_schema, space_script, viewer_script,
    viewer_style, write_changes_svg, write_html, write_index, write_json, write_linked_html,
    write_markdown, write_trade_off_html, write_trade_off_json, write_trade_off_svg, write_view,
};
