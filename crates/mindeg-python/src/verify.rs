//! Meshes judged: what is wrong with one, and whether it is what it was made for.

use mindeg::Goal;
use mindeg::inspection::{Inspection, InspectionOptions};
use mindeg::verify::{SurfaceRules, optimality, surface, triangulation};
use mindeg_answers::inspected::InspectionReport;
use mindeg_answers::preset::PRESETS;
use mindeg_answers::surface::SurfaceAnswer;
use mindeg_answers::verify::{VerifyAnswer, VerifyDemands};
use mindeg_mesh::Bounds;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::demands::demands;
use crate::dict::dict;
use crate::domain::Domain;
use crate::mesh::{Mesh, tri_mesh};
use crate::work::{done, value_error};

/// How far a remesh may be from its part, as a share of the part's diagonal, where nothing else is asked for.
const SHARE: f64 = 0.003;

/// The programs whose rules a mesh can be asked to keep, and these rules, by name.
#[pyfunction]
#[pyo3(name = "_presets")]
pub(crate) fn presets(py: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
    let dict = PyDict::new(py);
    for preset in &PRESETS {
        dict.set_item(preset.name, preset.description)?;
    }
    Ok(dict)
}

/// The faults of a mesh, or of points and triangles, and its quality: a dict with the keys of
/// `mindeg inspect --json`, which `docs/inspect.md` explains.
///
/// Vertices at most `weld` apart count as one; none do with `None`. The boundary turns at a corner by more than `corner_angle`
/// degrees; vertices with more than `poles_above` edges are listed. `failed` has, in sentences, where the mesh breaks `max_degree`,
/// `target_angle` in degrees, or the rules of a `preset` of `mindeg.PRESETS`.
#[pyfunction]
#[pyo3(
    signature = (
        points, triangles=None, *, weld=Some(0.0), corner_angle=1.0, poles_above=8, max_degree=None, target_angle=None,
        preset=None
    ),
    text_signature = "(points, triangles=None, *, weld=0.0, corner_angle=1.0, poles_above=8, max_degree=None, target_angle=None, preset=None)"
)]
#[expect(clippy::too_many_arguments, reason = "they are keywords in Python")]
pub(crate) fn inspect<'py>(
    py: Python<'py>,
    points: &Bound<'py, PyAny>,
    triangles: Option<&Bound<'py, PyAny>>,
    weld: Option<f64>,
    corner_angle: f64,
    poles_above: u32,
    max_degree: Option<u32>,
    target_angle: Option<f64>,
    preset: Option<&str>,
) -> PyResult<Bound<'py, PyAny>> {
    if let Some(weld) = weld.filter(|weld| !(weld.is_finite() && *weld >= 0.0)) {
        return Err(value_error(format!("weld is {weld}; give a length of 0 or more, or None")));
    }
    if !(0.0..=180.0).contains(&corner_angle) {
        return Err(value_error(format!(
            "corner_angle is {corner_angle}; give degrees from 0 to 180"
        )));
    }
    let mesh = tri_mesh(points, triangles)?;
    let options = InspectionOptions { weld, corner_angle, pole_degree: poles_above };
    let demands = demands(max_degree, target_angle, preset)?;
    let (report, failed) = py.detach(|| {
        let found = Inspection::of(&mesh, &options);
        let report = InspectionReport::new(None, &mesh, &found, &options);
        let welded = options.weld.map(|tolerance| mesh.welded(tolerance));
        let failed = demands.unmet_by(welded.as_ref().unwrap_or(&mesh), report.min_angle);
        (report, failed)
    });
    let report = dict(py, &report)?;
    report.set_item("failed", failed)?;
    Ok(report)
}

/// The share that `keep_angle` gives as a number, or as people write it.
fn share(given: &Bound<'_, PyAny>) -> PyResult<f64> {
    if let Ok(text) = given.extract::<String>() {
        return Goal::share(&text).map_err(|error| value_error(format!("keep_angle: {error}")));
    }
    let share: f64 = given.extract()?;
    if !(0.0..=1.0).contains(&share) {
        return Err(value_error(format!("keep_angle is {share}; give a share from 0 to 1")));
    }
    Ok(share)
}

/// Whether a mesh triangulates a domain, or keeps the surface of a part, judged by code that shares nothing with what
/// makes meshes.
///
/// `of` is the `Domain`, or the mesh that was meshed anew. Gives a dict with the keys of `mindeg verify --json`, which
/// `docs/verify.md` explains: `passed` is the verdict; `defect`, `defects` and `failed` say what is wrong. `tolerance` is a length.
/// The mesh fails where it breaks `max_degree`, `target_angle` in degrees, or the rules of a `preset` of `mindeg.PRESETS`.
///
/// For a domain: `keep_angle` is a share, 0.95 or `"95%"`, of the largest minimum angle possible; with `optimal` the maximum degree must
/// be proven to be the least. For a part: edges that turn by more than `feature_angle` degrees must be kept within the
/// tolerance, 0.3 % of the part's diagonal unless given; with `keep_boundary` and `keep_features` bit for bit.
#[pyfunction]
#[pyo3(signature = (
    mesh, of, *, tolerance=None, max_degree=None, target_angle=None, preset=None, keep_angle=None, optimal=false,
    feature_angle=None, keep_boundary=false, keep_features=false
))]
#[expect(clippy::too_many_arguments, reason = "they are keywords in Python")]
pub(crate) fn verify<'py>(
    py: Python<'py>,
    mesh: &Bound<'py, PyAny>,
    of: &Bound<'py, PyAny>,
    tolerance: Option<f64>,
    max_degree: Option<u32>,
    target_angle: Option<f64>,
    preset: Option<&str>,
    keep_angle: Option<&Bound<'py, PyAny>>,
    optimal: bool,
    feature_angle: Option<f64>,
    keep_boundary: bool,
    keep_features: bool,
) -> PyResult<Bound<'py, PyAny>> {
    let Ok(mesh) = mesh.cast::<Mesh>() else {
        let what = mesh.get_type().name()?;
        let swap = if of.cast::<Mesh>().is_ok() { "; swap the two" } else { "" };
        return Err(value_error(format!("mesh is a {what}{swap}; give a Mesh, then its Domain")));
    };
    for (key, value) in [("tolerance", tolerance), ("feature_angle", feature_angle)] {
        if let Some(value) = value.filter(|value| !(value.is_finite() && *value >= 0.0)) {
            return Err(value_error(format!("{key} is {value}; give a number of 0 or more")));
        }
    }
    let keep_angle = keep_angle.map(share).transpose()?;
    let demands = demands(max_degree, target_angle, preset)?;
    let mesh = mesh.get().list()?;
    let answer = if let Ok(domain) = of.cast::<Domain>() {
        if feature_angle.is_some() || keep_boundary || keep_features {
            return Err(value_error(
                "feature_angle, keep_boundary and keep_features are for a part, given as a Mesh",
            ));
        }
        let domain = domain.get().inner();
        let answer = done(py, |progress| {
            let demands = VerifyDemands { demands, keep_angle, optimal };
            let verified = match triangulation(&mesh, domain, tolerance) {
                Ok(verified) => verified,
                Err(defect) if defect.kind == "tolerance_too_large" => return Err(defect.message),
                Err(defect) => return Ok(VerifyAnswer::invalid("", domain, defect)),
            };
            let optimality = optimality(&verified, domain, progress);
            let optimality = optimality.map_err(|error| error.to_string())?;
            Ok(VerifyAnswer::of("", domain, &mesh, &verified, &optimality, &demands, progress))
        })?;
        dict(py, &answer)?
    } else if let Ok(part) = of.cast::<Mesh>() {
        if keep_angle.is_some() || optimal {
            return Err(value_error("keep_angle and optimal are for a Domain"));
        }
        let part = part.get().list()?;
        let diagonal = Bounds::of_space(part.positions().iter().copied())
            .map_or(0.0, |bounds| bounds.size().length());
        let rules = SurfaceRules {
            feature_angle: feature_angle.or(keep_features.then_some(40.0)),
            keep_boundary,
            keep_features,
            ..SurfaceRules::within(tolerance.unwrap_or(SHARE * diagonal))
        };
        let found = done(py, |progress| surface(&mesh, &part, &rules, progress))?;
        let verdict =
            dict(py, &SurfaceAnswer::of(("", &mesh), ("", &part), &rules, &found, &demands))?;
        verdict.del_item("part")?;
        verdict
    } else {
        let what = of.get_type().name()?;
        return Err(value_error(format!(
            "of is a {what}; give the Domain, or the Mesh that was meshed anew"
        )));
    };
    answer.del_item("file")?;
    Ok(answer)
}
