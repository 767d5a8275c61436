//! The results of a comparison, as in `report.json`.
//!
//! Every key is always there; what a method does not have is `null` or empty. Only `seconds`
//! differs from run to run. The published schema is `docs/report.schema.json`; keys are added
//! over time, but no key changes its meaning.
//!
//! Limits: figures only. Points and triangles are in the files that `mindeg mesh` writes.

mod changes;
mod html;
mod index;
mod markdown;
mod picture;
mod scene;
mod svg;
mod tables;
mod titles;
mod trade_off;
mod view;
mod viewer;

pub use changes::write_changes_svg;
pub use html::{PageLinks, write_html, write_linked_html};
pub use index::{IndexEntry, write_index};
pub use markdown::write_markdown;
pub use trade_off::{write_trade_off_html, write_trade_off_json, write_trade_off_svg};
pub use view::write_view;
pub use viewer::{space_script, viewer_script, viewer_style};

use crate::InteriorFigures;
use crate::figures::{DomainFigures, MethodFigures};
use mindeg_answers::advice::{Advice, Purpose};
use mindeg_answers::command::MeshCommand;
use mindeg_answers::trade_off::TradeOffAnswer;
use schemars::JsonSchema;
use serde::Serialize;
use std::io::{self, Write};
use std::path::Path;

/// A comparison of triangulations of one domain, by figures.
///
/// # Example
///
/// ```
/// use mindeg_compare::{CompareOptions, compare};
/// use mindeg::{Domain, Side};
///
/// let domain = Domain::rectangle(4.0, 3.0, vec![Side::count(10); 4])?;
/// let comparison = compare(&domain, &CompareOptions::default())?;
/// let report = comparison.report();
/// assert_eq!(report.domain.least_max_degree, Some(4));
/// assert_eq!(report.methods[0].max_degree, Some(4));
/// assert!(report.verdict.contains("take degree 5: minimum angle"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(
    title = "A report of mindeg compare",
    description = "Triangulations of the same boundary points, by figures. Every key is always \
                   there; what a method does not have is null or empty. Only `seconds` differs \
                   from run to run."
)]
pub struct Report {
    /// The program that made the report.
    pub provenance: Provenance,
    /// The domain that was triangulated.
    pub domain: DomainFigures,
    /// The purpose of the mesh, if that was told.
    pub purpose: Option<Purpose>,
    /// Which mesh to take; its figures are null on a domain that is too large to make them all.
    pub advice: Advice,
    /// mindeg first, then the methods it is compared with. All have the same boundary points; `mindeg, points inside` has
    /// more.
    pub methods: Vec<MethodFigures>,
    /// The largest minimum angle of every degree, exactly; null where the domain is too large for that or the time
    /// limit too short. The methods named exact are meshes of its points.
    pub trade_off: Option<TradeOffAnswer>,
    /// Meshes with interior points on the same boundary, beside a refinement; empty unless asked for.
    pub interior: Vec<InteriorFigures>,
    /// The figures in words.
    pub verdict: String,
}

/// The program that made a report, and its input.
///
/// # Example
///
/// ```
/// use mindeg_compare::Provenance;
///
/// assert!(!Provenance::default().version.is_empty());
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Provenance {
    /// The version of mindeg.
    pub version: String,
    /// The file that holds the domain, if that is known.
    pub input: Option<String>,
    /// The command line, if that is known.
    pub command: Option<String>,
    /// The command that makes meshes of the domain.
    #[serde(skip)]
    pub mesh: MeshCommand,
}

impl Default for Provenance {
    fn default() -> Self {
        Self {
            version: env!("CARGO_PKG_VERSION").to_owned(),
            input: None,
            command: None,
            mesh: MeshCommand::default(),
        }
    }
}

impl Provenance {
    /// The title of a page whose domain or mesh has no name: the input without its folder and ending.
    pub(crate) fn title(&self) -> Option<&str> {
        Path::new(self.input.as_deref()?).file_stem()?.to_str()
    }
}

/// Writes a report as JSON on one line, with a line break at the end.
///
/// # Errors
///
/// The errors of `out`.
///
/// # Example
///
/// ```
/// use mindeg_compare::{CompareOptions, compare, write_json};
/// use mindeg::{Domain, Side};
///
/// let domain = Domain::rectangle(4.0, 3.0, vec![Side::count(10); 4])?;
/// let mut json = Vec::new();
/// write_json(compare(&domain, &CompareOptions::default())?.report(), &mut json)?;
/// assert!(String::from_utf8(json)?.contains("\"at_least\":4"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write_json(report: &Report, mut out: impl Write) -> io::Result<()> {
    serde_json::to_writer(&mut out, report)?;
    out.write_all(b"\n")
}

/// The JSON Schema of [`Report`] as JSON text, with a line break at the end.
///
/// ```
/// assert!(mindeg_compare::report_schema().contains("\"degree_histogram\""));
/// ```
#[must_use]
pub fn report_schema() -> String {
    let generator = schemars::generate::SchemaSettings::default().for_serialize().into_generator();
    let schema = generator.into_root_schema_for::<Report>();
    format!("{:#}\n", schema.as_value())
}
