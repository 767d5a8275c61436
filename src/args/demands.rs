//! The limits that a mesh must keep for a run to succeed.

use super::values::{target_angle, whole_number};
use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use mindeg::Interior;
use mindeg_answers::demands::Demands;
use mindeg_answers::preset::{PRESETS, Preset};

/// The demands on a mesh that exists.
#[derive(Debug, Args)]
#[command(next_help_heading = "Demands")]
pub(crate) struct DemandArguments {
    /// End with exit code 3 if a vertex has more edges than this
    #[arg(long, value_name = "D", value_parser = whole_number, allow_hyphen_values = true)]
    pub(crate) max_degree: Option<u32>,

    /// End with exit code 3 if a triangle has an angle below this many degrees, up to 60
    #[arg(long, value_name = "A", value_parser = target_angle, allow_hyphen_values = true)]
    pub(crate) target_angle: Option<f64>,

    #[command(flatten)]
    pub(crate) preset: PresetArgument,
}

impl DemandArguments {
    pub(crate) fn demands(&self) -> Demands {
        let Self { max_degree, target_angle, preset } = self;
        Demands { max_degree: *max_degree, target_angle: *target_angle, preset: preset.preset }
    }
}

/// The rules of a program.
#[derive(Debug, Args)]
#[command(next_help_heading = "Demands")]
pub(crate) struct PresetArgument {
    /// End with exit code 3 if the mesh breaks a rule of this program; mindeg formats explains them
    #[arg(long, value_name = "PROGRAM", value_parser = preset_parser())]
    pub(crate) preset: Option<Preset>,
}

impl PresetArgument {
    /// The wishes for points inside with what the rules ask of them.
    pub(crate) fn asked_of(&self, wanted: Interior) -> Interior {
        match self.preset {
            Some(preset) => preset.asked_of(wanted),
            None => wanted,
        }
    }
}

pub(super) fn preset_parser() -> impl TypedValueParser<Value = Preset> {
    PossibleValuesParser::new(PRESETS.iter().map(|preset| preset.name)).map(|name| {
        let named = PRESETS.iter().find(|preset| preset.name == name);
        named.expect("one of the possible values")
    })
}
