//! Words: the order in which a strip advances along its two chains.
//!
//! A word of letters X and Y is a monotone staircase. All words here are given by a formula,
//! so where a letter stands and what stands at a place are O(1) integer arithmetic.
//!
//! Two kinds suffice for an optimal triangulation of any boundary: alternating words, with at
//! most one pair of neighbouring letters exchanged (the paper's final adjustment), and balanced
//! words, which spread many X among few Y as evenly as integers allow (Christoffel words and
//! their rotations).
//!
//! Limits: words come from the constructions of this crate; there is no general word, which would
//! have to be stored letter by letter.

/// Which chain of a strip a triangle advances along; see [`Word`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Letter {
    /// The triangle has an edge on the x chain.
    X,
    /// The triangle has an edge on the y chain.
    Y,
}

/// The order in which a strip advances along its chains: a word in closed form.
///
/// It alternates, but for one pair of neighbours that may be exchanged, or it spreads many X among
/// few Y as evenly as integers allow (a rotation of a Christoffel word). So it takes O(1) memory,
/// and what stands where is integer arithmetic.
///
/// # Example
///
/// ```
/// use mindeg_core::{Boundary, Letter, min_degree_triangulation};
///
/// // 8 intervals of the first side between its ends, shared by 3 vertices off it.
/// let triangulation = min_degree_triangulation(&Boundary::new(&[10, 2, 1, 1])?);
/// let word = *triangulation.strips().next().unwrap().word();
/// let letters = (0..word.len()).map(|place| word.letter(place));
/// let spelled: String = letters.map(|l| if l == Letter::X { 'X' } else { 'Y' }).collect();
/// assert_eq!(spelled, "XXXYXXYXXX");
/// # Ok::<(), mindeg_core::BoundaryError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Word {
    xs: u32,
    ys: u32,
    order: Order,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Order {
    /// X and Y in turn, the letters at `swapped` and `swapped + 1` exchanged.
    Alternating { first: Letter, swapped: Option<u32> },
    /// Before the j-th Y, counted from 1, stand `(j * xs + shift) / (ys + 1)` X, rounded down.
    /// How many Y stand before something is the number of j for which that is small enough, and
    /// so a quotient again.
    Balanced { shift: u32 },
}

/// The lengths of the runs of X in a balanced word, one after the other: the quotient of
/// [`Order::Balanced`], kept up by adding where it would be divided.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Runs {
    /// The X left in the present run.
    pub(crate) left: u32,
    /// The shorter of the two lengths, `xs / count`.
    base: u32,
    /// What that leaves over, `xs % count`.
    surplus: u32,
    /// What is left over so far, below `count`; where it would reach `count`, a run is longer.
    remainder: u32,
    /// The number of runs, `ys + 1`.
    count: u32,
}

impl Runs {
    /// The longer of the two lengths.
    pub(crate) fn longest(&self) -> u32 {
        self.base + 1
    }

    /// Goes on to the run after the next Y.
    pub(crate) fn advance(&mut self) {
        self.remainder += self.surplus;
        self.left = self.base;
        if self.remainder >= self.count {
            self.remainder -= self.count;
            self.left += 1;
        }
    }
}

impl Word {
    /// The word that alternates, beginning with `first`.
    ///
    /// The letter it begins with occurs as often as the other one or once more.
    pub(crate) fn alternating(first: Letter, xs: u32, ys: u32) -> Self {
        debug_assert!(match first {
            Letter::X => xs == ys || xs == ys + 1,
            Letter::Y => ys == xs || ys == xs + 1,
        });
        Self { xs, ys, order: Order::Alternating { first, swapped: None } }
    }

    /// This alternating word with the letters at `place` and `place + 1` exchanged.
    pub(crate) fn with_swap(mut self, place: u32) -> Self {
        debug_assert!(place + 1 < self.len());
        debug_assert!(matches!(self.order, Order::Alternating { swapped: None, .. }));
        if let Order::Alternating { swapped, .. } = &mut self.order {
            *swapped = Some(place);
        }
        self
    }

    /// The word `X…X Y X…X Y … Y X…X` whose `ys + 1` runs of X differ by at most one.
    ///
    /// `shift`, in `0..=ys`, says where the longer runs fall.
    pub(crate) fn balanced(xs: u32, ys: u32, shift: u32) -> Self {
        debug_assert!(xs > ys && shift <= ys);
        Self { xs, ys, order: Order::Balanced { shift } }
    }

    /// The number of X.
    #[must_use]
    pub fn xs(&self) -> u32 {
        self.xs
    }

    /// The number of Y.
    #[must_use]
    pub fn ys(&self) -> u32 {
        self.ys
    }

    /// The number of letters.
    #[must_use]
    pub fn len(&self) -> u32 {
        self.xs + self.ys
    }

    /// Whether the word has no letters.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The letter at `place`, in `0..len`. O(1).
    ///
    /// # Panics
    ///
    /// When `place` is not below [`len`](Self::len).
    #[must_use]
    pub fn letter(&self, place: u32) -> Letter {
        assert!(place < self.len(), "a word of {} letters has none at {place}", self.len());
        if self.xs_before(place + 1) > self.xs_before(place) { Letter::X } else { Letter::Y }
    }

    /// How many X stand before `place`, in `0..=len`. O(1).
    pub(crate) fn xs_before(&self, place: u32) -> u32 {
        match self.order {
            Order::Alternating { first, swapped } => {
                let plain = |place: u32| match first {
                    Letter::X => place.div_ceil(2),
                    Letter::Y => place / 2,
                };
                // Between two exchanged letters the count is what it would be without the
                // first and with the second.
                match swapped {
                    Some(swap) if place == swap + 1 => plain(swap) + plain(swap + 2) - plain(place),
                    _ => plain(place),
                }
            }
            Order::Balanced { shift } => {
                let (xs, runs) = (u64::from(self.xs), u64::from(self.ys) + 1);
                let ys = ((u64::from(place) + 1) * runs - u64::from(shift) - 1) / (xs + runs);
                place - ys as u32
            }
        }
    }

    /// How many Y stand before the X with the given number, in `0..xs`. O(1).
    pub(crate) fn ys_before_x(&self, number: u32) -> u32 {
        match self.order {
            Order::Alternating { first, .. } => {
                self.place_in_word(2 * number + u32::from(first == Letter::Y)) - number
            }
            Order::Balanced { shift } => {
                let (xs, runs) = (u64::from(self.xs), u64::from(self.ys) + 1);
                (((u64::from(number) + 1) * runs - u64::from(shift) - 1) / xs) as u32
            }
        }
    }

    /// How many X stand before the Y with the given number, in `0..ys`. O(1).
    pub(crate) fn xs_before_y(&self, number: u32) -> u32 {
        match self.order {
            Order::Alternating { first, .. } => {
                self.place_in_word(2 * number + u32::from(first == Letter::X)) - number
            }
            Order::Balanced { shift } => {
                let (xs, runs) = (u64::from(self.xs), u64::from(self.ys) + 1);
                (((u64::from(number) + 1) * xs + u64::from(shift)) / runs) as u32
            }
        }
    }

    /// Where the X with the given number stands, if there are so many. O(1).
    pub(crate) fn place_of_x(&self, number: u32) -> Option<u32> {
        (number < self.xs).then(|| number + self.ys_before_x(number))
    }

    /// Where the Y with the given number stands, if there are so many. O(1).
    pub(crate) fn place_of_y(&self, number: u32) -> Option<u32> {
        (number < self.ys).then(|| number + self.xs_before_y(number))
    }

    /// The places of the two letters that are exchanged.
    pub(crate) fn swapped_places(&self) -> [Option<u32>; 2] {
        match self.order {
            Order::Alternating { swapped: Some(swap), .. } => [Some(swap), Some(swap + 1)],
            _ => [None, None],
        }
    }

    /// The runs of X in a balanced word, the first without its letters before `place`.
    pub(crate) fn runs_from(&self, place: u32) -> Option<Runs> {
        let Order::Balanced { shift } = self.order else { return None };
        let i = self.xs_before(place);
        let (xs, count) = (u64::from(self.xs), u64::from(self.ys) + 1);
        let end = u64::from(place - i + 1) * xs + u64::from(shift);
        Some(Runs {
            left: (end / count) as u32 - i,
            base: (xs / count) as u32,
            surplus: (xs % count) as u32,
            remainder: (end % count) as u32,
            count: count as u32,
        })
    }

    /// Where the letter at `place` of the plain alternating word stands in this one.
    fn place_in_word(&self, place: u32) -> u32 {
        match self.order {
            Order::Alternating { swapped: Some(swap), .. } if place == swap => swap + 1,
            Order::Alternating { swapped: Some(swap), .. } if place == swap + 1 => swap,
            _ => place,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::string::String;
    use proptest::prelude::*;

    fn spell(word: Word) -> String {
        (0..word.len())
            .map(|place| match word.letter(place) {
                Letter::X => 'X',
                Letter::Y => 'Y',
            })
            .collect()
    }

    #[test]
    fn words_are_spelled_as_meant() {
        for (word, spelling) in [
            (Word::alternating(Letter::X, 0, 0), ""),
            (Word::alternating(Letter::X, 2, 2), "XYXY"),
            (Word::alternating(Letter::X, 3, 2), "XYXYX"),
            (Word::alternating(Letter::Y, 2, 2), "YXYX"),
            (Word::alternating(Letter::Y, 1, 2), "YXY"),
            (Word::alternating(Letter::X, 3, 3).with_swap(2), "XYYXXY"),
            (Word::alternating(Letter::X, 3, 3).with_swap(1), "XXYYXY"),
            (Word::balanced(8, 2, 0), "XXYXXXYXXX"),
            (Word::balanced(8, 2, 1), "XXXYXXYXXX"),
            (Word::balanced(8, 2, 2), "XXXYXXXYXX"),
            (Word::balanced(4, 0, 0), "XXXX"),
        ] {
            assert_eq!(spell(word), spelling);
            assert_eq!(word.is_empty(), spelling.is_empty());
        }
    }

    fn words() -> impl Strategy<Value = Word> {
        let first = prop_oneof![Just(Letter::X), Just(Letter::Y)];
        let alternating = (first, 0_u32..20, prop::bool::ANY, any::<Option<u32>>()).prop_map(
            |(first, pairs, one_more, swap)| {
                let more = pairs + u32::from(one_more);
                let (xs, ys) = if first == Letter::X { (more, pairs) } else { (pairs, more) };
                let word = Word::alternating(first, xs, ys);
                match swap {
                    Some(swap) if word.len() >= 2 => word.with_swap(swap % (word.len() - 1)),
                    _ => word,
                }
            },
        );
        let balanced = (0_u32..20, 1_u32..60, prop::num::u32::ANY)
            .prop_map(|(ys, extra, shift)| Word::balanced(ys + extra, ys, shift % (ys + 1)));
        prop_oneof![alternating, balanced]
    }

    proptest! {
        #[test]
        fn the_closed_forms_agree_with_the_spelling(word in words()) {
            let spelling = spell(word);
            prop_assert_eq!(spelling.matches('X').count(), word.xs() as usize);
            let (mut xs, mut ys) = (0, 0);
            for (place, letter) in (0_u32..).zip(spelling.chars()) {
                prop_assert_eq!(word.xs_before(place), xs);
                if letter == 'X' {
                    prop_assert_eq!(word.ys_before_x(xs), ys);
                    xs += 1;
                } else {
                    prop_assert_eq!(word.xs_before_y(ys), xs);
                    ys += 1;
                }
            }
            prop_assert_eq!(word.xs_before(word.len()), xs);
        }

        #[test]
        fn runs_of_a_balanced_word_differ_by_at_most_one(
            ys in 0_u32..30, extra in 1_u32..90, shift in 0_u32..30
        ) {
            let word = Word::balanced(ys + extra, ys, shift % (ys + 1));
            let spelling = spell(word);
            let runs = spelling.split('Y').map(str::len);
            let average = word.xs() as usize / (ys as usize + 1);
            prop_assert!(runs.clone().all(|run| run == average || run == average + 1));
            prop_assert_eq!(runs.sum::<usize>(), word.xs() as usize);
        }
    }
}
