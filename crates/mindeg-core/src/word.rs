//! Words: the order in which a strip advances along its two chains.
//!
//! A word of letters X and Y is a monotone staircase. A formula gives every word here, so the
//! letter at an index and the index of a letter are O(1) integer arithmetic.
//!
//! Two kinds suffice for an optimal triangulation of every boundary:
//!
//! - alternating words, with at most one pair of neighbouring letters swapped (the paper's final
//!   adjustment);
//! - balanced words, which spread many X among few Y as equally as integers allow (Christoffel
//!   words and their rotations).
//!
//! Limits: only the constructions of this crate make words. A general word would have to be
//! stored letter by letter.

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
/// Either it alternates, with at most one pair of neighbouring letters swapped, or it spreads many
/// X among few Y as equally as integers allow (a rotation of a Christoffel word). So it takes O(1)
/// memory, and integer arithmetic gives each letter.
///
/// # Example
///
/// ```
/// use mindeg_core::{Boundary, Letter, least_degree_triangulation};
///
/// // 3 vertices share the 8 intervals between the inner vertices of the first side.
/// let triangulation = least_degree_triangulation(&Boundary::new(&[10, 2, 1, 1])?);
/// let word = *triangulation.strips().next().unwrap().word();
/// let letters = (0..word.len()).map(|index| word.letter(index));
/// let spelled: String = letters.map(|l| if l == Letter::X { 'X' } else { 'Y' }).collect();
/// assert_eq!(spelled, "XXXYXXYXXX");
/// # Ok::<(), mindeg_core::Defect>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Word {
    xs: u32,
    ys: u32,
    order: Order,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Order {
    /// X and Y in turn, with the letters at `swapped` and `swapped + 1` swapped.
    Alternating { first: Letter, swapped: Option<u32> },
    /// `(j * xs + shift) / (ys + 1)` X, rounded down, precede the j-th Y, counted from 1. The
    /// inverse, the number of Y before a letter, is again a quotient.
    Balanced { shift: u32 },
}

/// The lengths of the runs of X in a balanced word, in order: the quotient of
/// [`Order::Balanced`], updated by additions instead of a division for each run.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Runs {
    /// The number of X left in the current run.
    pub(crate) left: u32,
    /// The shorter of the two lengths, `xs / count`.
    base: u32,
    /// The remainder of that division, `xs % count`.
    surplus: u32,
    /// The sum of the surpluses so far, modulo `count`. A run is longer where the sum wraps.
    remainder: u32,
    /// The number of runs, `ys + 1`.
    count: u32,
}

impl Runs {
    /// The longer of the two lengths.
    pub(crate) fn longest(&self) -> u32 {
        self.base + 1
    }

    /// Moves to the run after the next Y.
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
    /// The alternating word that starts with `first`.
    ///
    /// `first` occurs as often as the other letter, or once more.
    pub(crate) fn alternating(first: Letter, xs: u32, ys: u32) -> Self {
        debug_assert!(match first {
            Letter::X => xs == ys || xs == ys + 1,
            Letter::Y => ys == xs || ys == xs + 1,
        });
        Self { xs, ys, order: Order::Alternating { first, swapped: None } }
    }

    /// This alternating word with the letters at `index` and `index + 1` swapped.
    pub(crate) fn with_swap(mut self, index: u32) -> Self {
        debug_assert!(index + 1 < self.len());
        debug_assert!(matches!(self.order, Order::Alternating { swapped: None, .. }));
        if let Order::Alternating { swapped, .. } = &mut self.order {
            *swapped = Some(index);
        }
        self
    }

    /// The word `X…X Y X…X Y … Y X…X` whose `ys + 1` runs of X differ by at most one.
    ///
    /// `shift`, in `0..=ys`, selects which runs are the longer ones.
    pub(crate) fn balanced(xs: u32, ys: u32, shift: u32) -> Self {
        debug_assert!(xs > ys && shift <= ys);
        Self { xs, ys, order: Order::Balanced { shift } }
    }

    /// The number of X.
    pub fn xs(&self) -> u32 {
        self.xs
    }

    /// The number of Y.
    pub fn ys(&self) -> u32 {
        self.ys
    }

    /// The number of letters.
    pub fn len(&self) -> u32 {
        self.xs + self.ys
    }

    /// Whether the word has no letters.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The letter at `index`, in `0..len`. O(1).
    ///
    /// # Panics
    ///
    /// If `index` is not below [`len`](Self::len).
    pub fn letter(&self, index: u32) -> Letter {
        let len = self.len();
        assert!(index < len, "index {index} is out of range; the word has {len} letters");
        if self.xs_before(index + 1) > self.xs_before(index) { Letter::X } else { Letter::Y }
    }

    /// The number of X before `index`, in `0..=len`. O(1).
    pub(crate) fn xs_before(&self, index: u32) -> u32 {
        match self.order {
            Order::Alternating { first, swapped } => {
                let plain = |index: u32| match first {
                    Letter::X => index.div_ceil(2),
                    Letter::Y => index / 2,
                };
                // Between the two swapped letters, the count includes the second letter of the
                // plain word and not the first.
                match swapped {
                    Some(swap) if index == swap + 1 => plain(swap) + plain(swap + 2) - plain(index),
                    _ => plain(index),
                }
            }
            Order::Balanced { shift } => {
                let (xs, runs) = (u64::from(self.xs), u64::from(self.ys) + 1);
                let ys = ((u64::from(index) + 1) * runs - u64::from(shift) - 1) / (xs + runs);
                index - ys as u32
            }
        }
    }

    /// The number of Y before the k-th X, `k` in `0..xs`. O(1).
    pub(crate) fn ys_before_x(&self, k: u32) -> u32 {
        match self.order {
            Order::Alternating { first, .. } => {
                self.after_swap(2 * k + u32::from(first == Letter::Y)) - k
            }
            Order::Balanced { shift } => {
                let (xs, runs) = (u64::from(self.xs), u64::from(self.ys) + 1);
                (((u64::from(k) + 1) * runs - u64::from(shift) - 1) / xs) as u32
            }
        }
    }

    /// The number of X before the k-th Y, `k` in `0..ys`. O(1).
    pub(crate) fn xs_before_y(&self, k: u32) -> u32 {
        match self.order {
            Order::Alternating { first, .. } => {
                self.after_swap(2 * k + u32::from(first == Letter::X)) - k
            }
            Order::Balanced { shift } => {
                let (xs, runs) = (u64::from(self.xs), u64::from(self.ys) + 1);
                (((u64::from(k) + 1) * xs + u64::from(shift)) / runs) as u32
            }
        }
    }

    /// The index of the k-th X, counted from 0, if the word has it. O(1).
    pub(crate) fn index_of_x(&self, k: u32) -> Option<u32> {
        (k < self.xs).then(|| k + self.ys_before_x(k))
    }

    /// The index of the k-th Y, counted from 0, if the word has it. O(1).
    pub(crate) fn index_of_y(&self, k: u32) -> Option<u32> {
        (k < self.ys).then(|| k + self.xs_before_y(k))
    }

    /// The indices of the two swapped letters.
    pub(crate) fn swapped_letters(&self) -> [Option<u32>; 2] {
        match self.order {
            Order::Alternating { swapped: Some(swap), .. } => [Some(swap), Some(swap + 1)],
            _ => [None, None],
        }
    }

    /// The runs of X in a balanced word from `index` on: the first run is without its letters
    /// before `index`. None for an alternating word.
    pub(crate) fn runs_from(&self, index: u32) -> Option<Runs> {
        let Order::Balanced { shift } = self.order else { return None };
        let i = self.xs_before(index);
        let (xs, count) = (u64::from(self.xs), u64::from(self.ys) + 1);
        let end = u64::from(index - i + 1) * xs + u64::from(shift);
        Some(Runs {
            left: (end / count) as u32 - i,
            base: (xs / count) as u32,
            surplus: (xs % count) as u32,
            remainder: (end % count) as u32,
            count: count as u32,
        })
    }

    /// The index in this word of the letter at `index` of the plain alternating word.
    fn after_swap(&self, index: u32) -> u32 {
        match self.order {
            Order::Alternating { swapped: Some(swap), .. } if index == swap => swap + 1,
            Order::Alternating { swapped: Some(swap), .. } if index == swap + 1 => swap,
            _ => index,
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
            .map(|index| match word.letter(index) {
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

    /// The letters at these indices, one after the other, agree with every closed form.
    fn check_window(word: Word, window: core::ops::Range<u32>) {
        let mut xs = word.xs_before(window.start);
        let mut ys = window.start - xs;
        for index in window {
            assert_eq!(word.xs_before(index), xs, "{word:?}, {index}");
            if word.letter(index) == Letter::X {
                assert_eq!(word.index_of_x(xs), Some(index), "{word:?}");
                xs += 1;
            } else {
                assert_eq!(word.index_of_y(ys), Some(index), "{word:?}");
                ys += 1;
            }
        }
    }

    /// Windows at both ends, in the middle and around an index.
    fn check_windows(word: Word, around: u32) {
        const WIDTH: u32 = 500;
        let len = word.len();
        for at in [0, around, len / 2, len] {
            check_window(word, at.saturating_sub(WIDTH)..at.saturating_add(WIDTH).min(len));
        }
        assert_eq!(word.xs_before(len), word.xs());
        assert_eq!([word.index_of_x(word.xs()), word.index_of_y(word.ys())], [None, None]);
    }

    #[test]
    fn the_longest_words_do_not_overflow() {
        // A strip of n vertices has n - 4 letters.
        for len in crate::MAX_VERTICES - 8..=crate::MAX_VERTICES - 4 {
            let (less, more) = (len / 2, len - len / 2);
            for first in [Letter::X, Letter::Y] {
                let (xs, ys) = if first == Letter::X { (more, less) } else { (less, more) };
                let word = Word::alternating(first, xs, ys);
                check_windows(word, 0);
                for swap in [0, 1, 2, len / 2, len / 2 + 1, len - 3, len - 2] {
                    check_windows(word.with_swap(swap), swap);
                }
            }
            for ys in [0, 1, 2, 3, 1000, 65_535, 65_536, 1 << 30, less - 2, less - 1] {
                for shift in [0, 1, ys / 2, ys] {
                    let word = Word::balanced(len - ys, ys, shift.min(ys));
                    check_windows(word, word.index_of_y(ys / 2).unwrap_or(0));
                    check_runs(word);
                }
            }
        }
    }

    /// The runs of a balanced word, by additions, are those of the quotients.
    fn check_runs(word: Word) {
        let last = word.ys().saturating_sub(50);
        for start in [0, last] {
            let index = if start == 0 { 0 } else { word.xs_before_y(start - 1) + start };
            let mut runs = word.runs_from(index).unwrap();
            for y in start..word.ys().min(start + 50) {
                let before = if y == 0 { 0 } else { word.xs_before_y(y - 1) };
                assert_eq!(runs.left, word.xs_before_y(y) - before, "{word:?}, run {y}");
                runs.advance();
            }
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
            for (index, letter) in (0_u32..).zip(spelling.chars()) {
                prop_assert_eq!(word.xs_before(index), xs);
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
