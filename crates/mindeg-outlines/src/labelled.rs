//! Polygons with labels to choose them by.

use std::collections::BTreeMap;

use super::outline::Feature;

/// A polygon of a file, and what it is called.
#[derive(Clone, Debug, PartialEq)]
pub struct Labelled {
    /// Its name, with a number if several polygons have it; empty if it has none.
    pub label: String,
    /// The polygon, with the name that the file gives.
    pub feature: Feature,
}

impl Labelled {
    /// The polygon with its label for a name.
    #[must_use]
    pub fn feature(&self) -> Feature {
        let name = (!self.label.is_empty()).then(|| self.label.clone());
        Feature { name, ..self.feature.clone() }
    }
}

/// The polygons with labels that differ.
#[must_use]
pub fn labelled(features: Vec<Feature>) -> Vec<Labelled> {
    let mut counts: BTreeMap<String, usize> = BTreeMap::new();
    for name in features.iter().filter_map(|feature| feature.name.as_ref()) {
        *counts.entry(name.clone()).or_default() += 1;
    }
    let mut numbers: BTreeMap<String, usize> = BTreeMap::new();
    let polygon = |feature: Feature| {
        let label = match &feature.name {
            None => String::new(),
            Some(name) if counts[name] == 1 => name.clone(),
            Some(name) => {
                let number = numbers.entry(name.clone()).or_default();
                *number += 1;
                format!("{name} {number}")
            }
        };
        Labelled { label, feature }
    };
    features.into_iter().map(polygon).collect()
}
