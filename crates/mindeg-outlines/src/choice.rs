//! Choosing among the polygons of a file.

use std::collections::BTreeMap;
use std::fmt;
use std::iter::repeat_n;

use super::globe::ProjectionChoice;
use super::outline::{Feature, FillRule, Outlines};
use super::text::clean;
use crate::error::OutlineError;

/// One polygon of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Polygon {
    /// Its number among all polygons of the file, from 1.
    pub index: usize,
    /// Its name in the domain, with a number if several polygons share it; empty if it has no name.
    pub label: String,
    /// The rings, under the name that the file gives.
    pub feature: Feature,
}

impl Polygon {
    /// The name in messages and files.
    #[must_use]
    pub fn name(&self) -> String {
        if self.label.is_empty() { format!("polygon {}", self.index) } else { self.label.clone() }
    }
}

/// The polygons with labels that differ: of two named lake the second is `lake 2`.
#[must_use]
pub fn labelled(features: Vec<Feature>) -> Vec<Polygon> {
    let mut counts: BTreeMap<String, usize> = BTreeMap::new();
    for name in features.iter().filter_map(|feature| feature.name.as_ref()) {
        *counts.entry(name.clone()).or_default() += 1;
    }
    let mut numbers: BTreeMap<String, usize> = BTreeMap::new();
    let polygon = |(index, feature): (usize, Feature)| {
        let label = match &feature.name {
            None => String::new(),
            Some(name) if counts[name] == 1 => clean(name),
            Some(name) => {
                let number = numbers.entry(name.clone()).or_default();
                *number += 1;
                format!("{} {number}", clean(name))
            }
        };
        Polygon { index: index + 1, label, feature }
    };
    features.into_iter().enumerate().map(polygon).collect()
}

/// The polygons that a text names: one by its label or index, or all of one name.
///
/// # Errors
///
/// No polygon has that name or index; names the first polygons.
pub fn chosen(polygons: Vec<Polygon>, wanted: &str) -> Result<Vec<Polygon>, OutlineError> {
    let of_name = |polygon: &Polygon| polygon.feature.name.as_deref() == Some(wanted);
    let by_label = polygons.iter().any(|polygon| polygon.label == wanted);
    let by_name = !by_label && polygons.iter().any(of_name);
    let index = wanted.parse::<usize>().ok();
    let is_chosen = |polygon: &Polygon| match (by_label, by_name) {
        (true, _) => polygon.label == wanted,
        (_, true) => of_name(polygon),
        _ => Some(polygon.index) == index,
    };
    if !polygons.iter().any(is_chosen) {
        let (count, listed) = (polygons.len(), Listed(&polygons));
        let problem = format!(
            "no polygon is {wanted:?}; give a name, or an index from 1 to {count}: {listed}"
        );
        return Err(OutlineError::place("", problem));
    }
    Ok(polygons.into_iter().filter(|it| is_chosen(it)).collect())
}

impl Outlines {
    /// Keeps the polygons that a text names, as one shape, and what is inside them. Gives them with their labels and indices among all.
    ///
    /// # Errors
    ///
    /// The error of [`chosen`].
    pub fn choose(&mut self, wanted: &str) -> Result<Vec<Polygon>, OutlineError> {
        let polygons = chosen(labelled(std::mem::take(&mut self.features)), wanted)?;
        self.keep_alone(polygons.iter().map(|polygon| polygon.feature.clone()).collect());
        Ok(polygons)
    }

    /// Keeps these polygons as one shape, and what is inside them.
    fn keep_alone(&mut self, features: Vec<Feature>) {
        self.features = features;
        self.shapes.clear();
        self.end_shape();
        self.inside.keep_within(&self.features);
    }

    /// Keeps the polygon of degrees of which a repair in the plane makes the one that a text names, by its label or its index among
    /// all that repairs make, and what is inside it. Gives the label and the index, and how many polygons of the same come before.
    ///
    /// # Errors
    ///
    /// The error of [`chosen`].
    pub fn choose_repaired(
        &mut self,
        wanted: &str,
        rule: Option<FillRule>,
    ) -> Result<(Polygon, usize), OutlineError> {
        let features = std::mem::take(&mut self.features);
        // Each in a plane of its own: no plane has all of a file of the world.
        let made_of = |feature: &Feature| {
            let mut alone = Self { features: vec![feature.clone()], ..Self::default() };
            alone.end_shape();
            let repaired = alone.projected(ProjectionChoice::Auto)?.repaired(rule)?;
            Ok::<usize, OutlineError>(repaired.features.len())
        };
        let counts = features.iter().map(|feature| made_of(feature).unwrap_or(1));
        let owners: Vec<usize> =
            counts.enumerate().flat_map(|(owner, count)| repeat_n(owner, count)).collect();
        let named =
            |&owner: &usize| Feature { name: features[owner].name.clone(), ..Feature::default() };
        let polygon = chosen(labelled(owners.iter().map(named).collect()), wanted)?.swap_remove(0);
        let owner = owners[polygon.index - 1];
        let before = owners[..polygon.index - 1].iter().filter(|&&other| other == owner).count();
        self.keep_alone(vec![features[owner].clone()]);
        Ok((polygon, before))
    }
}

/// The first polygons in a few words, such as `1 (lake), 2 (lake 2)`.
#[derive(Clone, Copy, Debug)]
pub struct Listed<'a>(pub &'a [Polygon]);

impl fmt::Display for Listed<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        const SHOWN: usize = 5;
        for (place, polygon) in self.0.iter().take(SHOWN).enumerate() {
            let comma = if place > 0 { ", " } else { "" };
            write!(f, "{comma}{}", polygon.index)?;
            if !polygon.label.is_empty() {
                write!(f, " ({})", polygon.label)?;
            }
        }
        if self.0.len() > SHOWN {
            f.write_str(", …; mindeg domain lists all")?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn polygons() -> Vec<Polygon> {
        let names = [Some("lake"), None, Some("lake"), Some("2")];
        let feature =
            |name: Option<&str>| Feature { name: name.map(str::to_owned), ..Feature::default() };
        labelled(names.map(feature).to_vec())
    }

    #[test]
    fn polygons_are_chosen_by_label_name_and_index() {
        let indices = |wanted: &str| -> Vec<usize> {
            chosen(polygons(), wanted).unwrap().iter().map(|polygon| polygon.index).collect()
        };
        assert_eq!(indices("lake"), [1, 3]);
        assert_eq!(indices("lake 2"), [3]);
        assert_eq!(indices("1"), [1]);
        // A name comes before an index.
        assert_eq!(indices("2"), [4]);
        assert_eq!(
            chosen(polygons(), "sea").unwrap_err().to_string(),
            "no polygon is \"sea\"; give a name, or an index from 1 to 4: 1 (lake 1), 2, 3 (lake 2), 4 (2)"
        );
    }
}
