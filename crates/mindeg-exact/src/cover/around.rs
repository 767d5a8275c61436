//! Round one hole a dynamic program decides: some edge joins the hole to the outer ring, and cut there the domain is a
//! polygon.
//!
//! A chord between two vertices of one ring cuts a *cap* off, whose triangulations depend on the rest through the
//! chords at its two ends alone. What is left is a strip of triangles with edges of both rings, *bridges*. From a bridge
//! the strip goes on along one ring, past a cap or a boundary edge, to the next one, until it is round:
//!
//! ```text
//!     o' <---- o          the outer ring, against its direction
//!       \     /
//!        \   /
//!          i  ----> i'    the ring of the hole, in its direction
//! ```
//!
//! Some vertex of the hole has a bridge in every triangulation (`cut.rs`). So each of its bridges is
//! tried as the first, with every share of the chords at its two ends before and after the turn.
//!
//! A state is a bridge with the chords at its ends so far; for each number at the outer end the least at the inner one.

use super::caps::{NONE, Rings};
use super::cut::Decided;
use crate::progress::Stage;
use mindeg_mesh::Cancelled;

/// The first bridge of a turn, and how many chords its ends may have until the turn goes on from each, this one included.
#[derive(Clone, Copy)]
struct First {
    bridge: u32,
    ends: [u32; 2],
    before: [u32; 2],
}

/// From where a state was reached, and by which triangle.
#[derive(Clone, Copy, Default)]
struct Reached {
    state: u32,
    x: u8,
    step: u32,
}

impl Rings<'_> {
    /// The ends of a bridge, the outer one first.
    fn ends(&self, bridge: u32) -> [u32; 2] {
        let [a, b] = self.face.chords[bridge as usize];
        if self.is_outer(a) { [a, b] } else { [b, a] }
    }

    /// A triangulation that keeps the numbers of chords round one hole.
    pub(super) fn decide_around(
        &self,
        left: &mut u64,
        stage: &Stage<'_>,
    ) -> Result<Decided, Cancelled> {
        let bridges = self.first_bridges(self.face);
        for (index, &bridge) in bridges.iter().enumerate() {
            stage.report(index as f64 / bridges.len() as f64)?;
            let ends = self.ends(bridge);
            let [most_o, most_i] = ends.map(|end| self.most[end as usize]);
            let shares = (1..=most_o).flat_map(|o| (1..=most_i).map(move |i| [o, i]));
            for before in shares {
                let first = First { bridge, ends, before };
                match self.turn(&first, left, None) {
                    None => return Ok(None),
                    Some(None) => {}
                    Some(Some(_)) => return Ok(Some(Some(self.mesh(&first)))),
                }
            }
        }
        Ok(Some(None))
    }

    /// Whether a turn from a bridge comes back to it; none if the steps are too few. `reached` gets the way to each state.
    fn turn(
        &self,
        first: &First,
        left: &mut u64,
        mut reached: Option<&mut [Reached]>,
    ) -> Option<Option<Vec<u8>>> {
        let stride = self.stride;
        let n = self.face.points.len();
        // Two bits for ends that are those of the first bridge: whether the turn is over there.
        let mut least = vec![NONE; 4 * self.face.chords.len() * stride];
        let mut queue = vec![Vec::new(); n + 1];
        let last = 4 * first.bridge + 3;
        if self.most[first.ends[0] as usize] == 0 || self.most[first.ends[1] as usize] == 0 {
            return Some(None);
        }
        least[4 * first.bridge as usize * stride + 1] = 1;
        queue[0].push(4 * first.bridge);
        for sum in 0..=n {
            for state in std::mem::take(&mut queue[sum]) {
                if state == last {
                    return Some(Some(least));
                }
                let (bridge, bits) = (state / 4, [state & 1, state >> 1 & 1]);
                let ends = self.ends(bridge);
                let done = [0, 1].map(|ring| {
                    let (end, start) = (ends[ring], first.ends[ring]);
                    match (end == start, ring) {
                        (true, _) => bits[ring] * self.lengths[ring],
                        (false, 0) => self.along(end, start),
                        (false, _) => self.along(start, end),
                    }
                });
                let most = |ring: usize, end: u32, over: u32| first.most(self, ring, end, over);
                for (index, step) in (0..).zip(&self.steps[bridge as usize]) {
                    *left = left.checked_sub(stride as u64)?;
                    let ring = usize::from(step.is_inner);
                    let now = done[ring] + step.passed;
                    if now > self.lengths[ring] {
                        continue;
                    }
                    let mut over = bits;
                    over[ring] = u32::from(now == self.lengths[ring]);
                    let to = self.ends(step.to);
                    let next = 4 * step.to + over[0] + 2 * over[1];
                    let is_chord = u32::from(step.cap.is_some());
                    let cap = step.cap.map(|cap| {
                        let at = cap as usize * stride;
                        &self.caps[at..at + stride]
                    });
                    for x in 1..stride as u32 {
                        let y = least[state as usize * stride + x as usize];
                        if y == NONE {
                            continue;
                        }
                        let y = u32::from(y);
                        let moved = if step.is_inner {
                            let Some(room) = most(1, ends[1], bits[1]).checked_sub(y + is_chord)
                            else {
                                continue;
                            };
                            let own = match cap {
                                None => Some(0),
                                Some(cap) => {
                                    cap.iter().position(|&at_end| u32::from(at_end) <= room)
                                }
                            };
                            own.map(|own| [x + 1, own as u32 + is_chord + 1])
                        } else {
                            let Some(room) = most(0, ends[0], bits[0]).checked_sub(x + is_chord)
                            else {
                                continue;
                            };
                            let own = match cap {
                                None => Some(0),
                                Some(cap) => Some(cap[(room as usize).min(stride - 1)])
                                    .filter(|&own| own != NONE)
                                    .map(u32::from),
                            };
                            own.map(|own| [own + is_chord + 1, y + 1])
                        };
                        let Some([x_then, y_then]) = moved else { continue };
                        if x_then > most(0, to[0], over[0]) || y_then > most(1, to[1], over[1]) {
                            continue;
                        }
                        let at = next as usize * stride;
                        if least[at..at + stride].iter().all(|&least| least == NONE) {
                            queue[sum + step.passed as usize].push(next);
                        }
                        let slot = at + x_then as usize;
                        if y_then < u32::from(least[slot]) {
                            least[slot] = y_then as u8;
                            if let Some(reached) = &mut reached {
                                reached[slot] = Reached { state, x: x as u8, step: index };
                            }
                        }
                    }
                }
            }
        }
        Some(None)
    }

    /// The triangles of the turn from a bridge that comes back to it.
    fn mesh(&self, first: &First) -> Vec<[u32; 3]> {
        let stride = self.stride;
        let mut reached = vec![Reached::default(); 4 * self.face.chords.len() * stride];
        let least = self.turn(first, &mut u64::MAX.clone(), Some(&mut reached)).flatten();
        let Some(least) = least else { return Vec::new() };
        let of = |state: u32| &least[state as usize * stride..][..stride];
        let mut at = 4 * first.bridge + 3;
        let mut x = of(at).iter().position(|least| *least != NONE).unwrap_or(0);
        let (mut triangles, mut caps) = (Vec::new(), Vec::new());
        while at != 4 * first.bridge {
            let Reached { state, x: before, step } = reached[at as usize * stride + x];
            let step = self.steps[(state / 4) as usize][step as usize];
            triangles.push(self.face.triangles[step.triangle as usize].corners);
            if let Some(cap) = step.cap {
                let (ring, used) = match step.is_inner {
                    false => (0, u32::from(before)),
                    true => (1, u32::from(of(state)[before as usize])),
                };
                let end = self.ends(state / 4)[ring];
                let room = first.most(self, ring, end, state >> ring & 1) - used - 1;
                let slots = &self.caps[cap as usize * stride..][..stride];
                let own = match step.is_inner {
                    false => (room as usize).min(stride - 1),
                    true => slots.iter().position(|&end| u32::from(end) <= room).unwrap_or(0),
                };
                caps.push((cap, own as u32, u32::from(slots[own])));
            }
            (at, x) = (state, usize::from(before));
        }
        while let Some((cap, at_a, at_b)) = caps.pop() {
            let [low, high] = self.face.chords[(cap / 2) as usize];
            let [a, b] = if cap % 2 == 0 { [low, high] } else { [high, low] };
            let length = self.along(b, a);
            let from = self.roots.partition_point(|root| (root.length, root.chord) < (length, cap));
            let own = self.roots[from..].iter().take_while(|root| root.chord == cap);
            let fits = |&[a, b, ..]: &[u32; 4]| a <= at_a && b <= at_b;
            let found = own.filter_map(|root| Some((root, self.divided(root).find(fits)?))).next();
            let Some((root, [_, _, x, left])) = found else { continue };
            let ([a, _, c], [_, bc, ca]) = self.corners(root);
            triangles.push(self.face.triangles[root.triangle as usize].corners);
            for (edge, from, most) in [(ca, a, x), (bc, c, left)] {
                if self.is_chord(edge) {
                    let end = self.least(edge, from, most).unwrap_or(0);
                    caps.push((self.directed(edge, from), most, end));
                }
            }
        }
        triangles
    }
}

impl First {
    /// The most chords at an end of a bridge, before the turn is over there or after.
    fn most(&self, rings: &Rings<'_>, ring: usize, end: u32, is_over: u32) -> u32 {
        let most = rings.most[end as usize];
        match (end == self.ends[ring], is_over) {
            (false, _) => most,
            (true, 0) => self.before[ring],
            (true, _) => most + 1 - self.before[ring],
        }
    }
}
