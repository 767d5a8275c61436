//! The sizes that were asked for, whatever the edges that stay allow.

use crate::edge_tree::{EdgeTree, Item};
use crate::options::Options;
use glam::DVec2;

/// The least size that was asked for at any place.
#[derive(Debug, Clone)]
pub(crate) struct Asked {
    places: EdgeTree,
    growth: f64,
}

impl Asked {
    pub(crate) fn new(options: &Options) -> Self {
        let wanted = &options.wanted;
        let item = |place: &mindeg_domain::SizeAt| Item {
            id: 0,
            from: place.at,
            to: place.at,
            size: place.size,
            reach: 0.0,
        };
        let items = wanted.sizes.iter().map(item);
        Self { places: EdgeTree::of_items(items.collect()), growth: wanted.growth() }
    }

    /// The size asked for at `x`, infinite where none is.
    pub(crate) fn at(&self, x: DVec2) -> f64 {
        let mut least = f64::INFINITY;
        self.places.least_grown(self.growth, x, &mut least);
        least
    }
}
