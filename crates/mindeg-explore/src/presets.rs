//! The domains of `assets/domains`, embedded in the program.

use serde_json::value::RawValue;

use crate::api::Source;

macro_rules! presets {
    ($($name:literal),* $(,)?) => {
        /// The name of each file and its text; the first is shown where no domain is given.
        const PRESETS: &[(&str, &str)] = &[$((
            concat!($name, ".json"),
            include_str!(concat!("../presets/", $name, ".json")),
        )),*];
    };
}

presets![
    "boundary-layer-channel",
    "dominated-side",
    "figure-1",
    "great-britain",
    "gusset",
    "half-round-cap",
    "l-bracket",
    "plate-with-holes",
    "slender-fin",
    "step-channel",
    "survey-parcel",
    "unequal-hexagon",
    "wing-panel",
];

/// The domains of `assets/domains`, by the names of their files without `.json`.
#[must_use]
pub fn presets() -> Vec<Source> {
    let preset = |&(file, text): &(&str, &str)| Source {
        name: file.trim_end_matches(".json").to_owned(),
        domain: RawValue::from_string(text.to_owned()).ok(),
        notes: Vec::new(),
        message: None,
        is_solid: false,
        map: None,
    };
    PRESETS.iter().map(preset).collect()
}
