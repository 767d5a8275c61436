//! Depths and open water of `mindeg mesh --interior`.

use crate::args::MeshArguments;
use crate::failure::Failure;
use mindeg::{Depths, Opening, Projection, TriMesh};
use mindeg_answers::ocean::{DepthsAnswer, OpeningRow};
use serde::Serialize;

/// The open water and the depths of an ocean model, beside its mesh.
#[derive(Serialize)]
pub(super) struct Ocean {
    /// The stretches that were asked to be open water.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    openings: Vec<OpeningRow>,
    #[serde(skip_serializing_if = "Option::is_none")]
    depths: Option<DepthsAnswer>,
    /// The projection of degrees, as PROJ writes it.
    #[serde(skip_serializing_if = "Option::is_none")]
    projection: Option<String>,
}

impl Ocean {
    pub(super) fn new(
        openings: &[Opening],
        depths: Option<DepthsAnswer>,
        projection: Option<&Projection>,
    ) -> Self {
        let openings = openings.iter().map(OpeningRow::from).collect();
        Self { openings, depths, projection: projection.map(Projection::to_string) }
    }

    pub(super) fn words(&self) -> Option<String> {
        let hint = || {
            (!self.openings.is_empty()).then(|| {
                "hint: the mesh has no depths, and a fort.14 has 0; --depth FILE takes those of a grid.".to_owned()
            })
        };
        self.depths.as_ref().map(DepthsAnswer::text).or_else(hint)
    }
}

/// Gives the vertices their depths, and says which.
pub(super) fn with_depths(
    mesh: TriMesh,
    depths: Option<&Depths>,
    arguments: &MeshArguments,
    projection: Option<&Projection>,
) -> Result<(TriMesh, Option<DepthsAnswer>), Failure> {
    let Some(depths) = depths else { return Ok((mesh, None)) };
    let (least, time_step) = (arguments.least_depth, arguments.depth.time_step);
    let found = DepthsAnswer::of(mesh, depths, least, time_step, projection);
    let (mesh, answer) = found.ok_or_else(|| {
        Failure::input(
            "--depth: no vertex of the mesh lies on the grid of depths; give the grid of this region",
        )
    })?;
    Ok((mesh, Some(answer)))
}
