//! The demands on a mesh, from keyword arguments.

use mindeg_answers::demands::Demands;
use mindeg_answers::preset::{PRESETS, Preset};
use pyo3::prelude::*;

use crate::work::value_error;

/// The demands on a mesh.
pub(crate) fn demands(
    max_degree: Option<u32>,
    target_angle: Option<f64>,
    preset: Option<&str>,
) -> PyResult<Demands> {
    if let Some(angle) = target_angle.filter(|angle| !(0.0..=60.0).contains(angle)) {
        return Err(value_error(format!("target_angle is {angle}; give degrees from 0 to 60")));
    }
    let preset = preset.map(|name| -> PyResult<Preset> {
        PRESETS.iter().find(|preset| preset.name == name).ok_or_else(|| {
            let names: Vec<&str> = PRESETS.iter().map(|preset| preset.name).collect();
            value_error(format!("preset is \"{name}\"; give one of {}", names.join(", ")))
        })
    });
    Ok(Demands { max_degree, target_angle, preset: preset.transpose()? })
}
