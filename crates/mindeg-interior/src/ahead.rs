//! Discs that are worked on ahead of their turn, on all threads.
//!
//! Places have their turns one after the other, and each finds the mesh as those before it left it. What was done ahead
//! counts if nothing in the disc has changed when its turn comes. So the result is, bit for bit, that of one thread.

use crate::disc::Disc;
use mindeg_mesh::parallel::{map_all, threads};
use std::collections::BTreeSet;

/// So many discs are worked on at once for each thread: some take longer than others.
const DISCS: usize = 2;
/// Of so many places for each thread that come next.
const PLACES: usize = 8;

/// Places with their discs, and what was made of them.
pub(crate) struct Ahead<R> {
    done: Vec<(u32, Disc, R)>,
}

impl<R: Send> Ahead<R> {
    pub(crate) fn new() -> Self {
        Self { done: Vec::new() }
    }

    /// The disc of the first place, and what is made of it. `cut` gives the disc of a place as the mesh is now, if it is to
    /// be worked on; `work` must depend on nothing else that changes.
    pub(crate) fn turn(
        &mut self,
        places: &[u32],
        cut: impl Fn(u32) -> Option<Disc>,
        work: impl Fn(&Disc) -> R + Sync + Send,
    ) -> Option<(Disc, R)> {
        let (&first, later) = places.split_first()?;
        if let Some(at) = self.done.iter().position(|done| done.0 == first) {
            let (_, disc, made) = self.done.swap_remove(at);
            return Some((disc, made));
        }
        let disc = cut(first)?;
        let threads = threads();
        let (most, near) = if threads > 1 { (DISCS * threads, PLACES * threads) } else { (1, 0) };
        let mut seen: BTreeSet<u32> = disc.vertices().iter().copied().collect();
        let mut batch = vec![(first, disc)];
        for place in later.iter().take(near) {
            if batch.len() == most {
                break;
            }
            if seen.contains(place) || self.done.iter().any(|done| done.0 == *place) {
                continue;
            }
            let Some(disc) = cut(*place) else { continue };
            let is_apart = disc.vertices().iter().all(|v| !seen.contains(v));
            // A disc that shares vertices with one before it would be changed by that.
            seen.extend(disc.vertices());
            if is_apart {
                batch.push((*place, disc));
            }
        }
        let mut made = map_all(batch, |(place, disc)| {
            let made = work(&disc);
            (place, disc, made)
        });
        let (_, disc, first) = made.swap_remove(0);
        self.done.extend(made);
        Some((disc, first))
    }

    /// Forgets what was made of discs that share vertices with one that changes.
    pub(crate) fn forget(&mut self, disc: &Disc) {
        if !self.done.is_empty() {
            let changed: BTreeSet<u32> = disc.vertices().iter().copied().collect();
            self.done.retain(|done| done.1.vertices().iter().all(|v| !changed.contains(v)));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::array_mesh::tests::grid;
    use crate::goal::Weights;
    use crate::options::Options;
    use std::sync::atomic::{AtomicUsize, Ordering};

    #[test]
    fn what_was_made_ahead_counts_unless_its_disc_changes() {
        let mesh = grid(30);
        let weights = Weights::local(&Options::default(), 36.0);
        let cut = |v| Disc::cut(&mesh, &weights, v, 2, 200);
        let made = AtomicUsize::new(0);
        let work = |disc: &Disc| {
            made.fetch_add(1, Ordering::Relaxed);
            disc.vertices()[0]
        };
        // The second and the fourth overlap.
        let places = [130, 140, 300, 141];
        let mut ahead = Ahead::new();
        let (changed, vertex) = ahead.turn(&places, cut, work).unwrap();
        assert_eq!(vertex, 130);
        let at_once = made.load(Ordering::Relaxed);
        assert!((1..=3).contains(&at_once));
        ahead.forget(&changed);
        assert_eq!(ahead.turn(&places[1..], cut, work).unwrap().1, 140);
        let (changed, _) = ahead.turn(&places[3..], cut, work).unwrap();
        let before = made.load(Ordering::Relaxed);
        ahead.forget(&changed);
        assert_eq!(ahead.turn(&places[2..], cut, work).unwrap().1, 300);
        let is_known = threads() > 1;
        assert_eq!(made.load(Ordering::Relaxed) == before, is_known);
        // Made before the disc beside it changed.
        let mut ahead = Ahead { done: vec![(140, cut(140).unwrap(), 0)] };
        ahead.forget(&changed);
        assert_eq!(ahead.turn(&places[1..], cut, work).unwrap().1, 140);
    }
}
