//! Compares the strip between two rings with all possible strips.

use mindeg_core::RingStrip;

/// The largest degree of the strip that a cyclic word spells, as bits: 1 is X.
fn max_degree(word: u32, xs: usize, ys: usize) -> u32 {
    // Two ring edges each; every letter adds the edge between the rings that it starts from.
    let (mut x, mut y) = (vec![2; xs], vec![2; ys]);
    let (mut i, mut j) = (0, 0);
    for letter in 0..xs + ys {
        x[i % xs] += 1;
        y[j % ys] += 1;
        *(if word >> letter & 1 == 1 { &mut i } else { &mut j }) += 1;
    }
    assert_eq!((i, j), (xs, ys));
    x.into_iter().chain(y).max().unwrap()
}

#[test]
fn no_word_has_a_smaller_maximum_degree() {
    for xs in 3..=9_u32 {
        for ys in 3..=9_u32 {
            let words = (0..1_u32 << (xs + ys)).filter(|word| word.count_ones() == xs);
            let least = words.map(|word| max_degree(word, xs as usize, ys as usize)).min();
            assert_eq!(RingStrip::new(xs, ys).unwrap().max_degree(), least.unwrap(), "{xs}, {ys}");
        }
    }
}

#[test]
fn triangles_close_up_between_the_rings_and_have_the_degree_that_is_told() {
    for xs in 3..=40_u32 {
        for ys in 3..=40_u32 {
            let strip = RingStrip::new(xs, ys).unwrap();
            let n = xs + ys;
            let mut edges = vec![0_u8; (n * n) as usize];
            for [a, b, c] in strip.triangles() {
                for (from, to) in [(a, b), (b, c), (c, a)] {
                    edges[(from * n + to) as usize] += 1;
                }
            }
            let ring = |from: u32, to: u32| {
                let is_x = from < xs && to == (from + 1) % xs;
                let is_y = to >= xs && from == xs + (to + 1 - xs) % ys;
                is_x || is_y
            };
            let mut degrees = vec![0; n as usize];
            for from in 0..n {
                for to in 0..n {
                    let [there, back] = [from * n + to, to * n + from].map(|i| edges[i as usize]);
                    if there + back > 0 {
                        degrees[from as usize] += 1;
                    }
                    // A ring edge is in one triangle and has one direction; other edges are in two.
                    if ring(from, to) {
                        assert_eq!((there, back), (1, 0), "{xs}, {ys}: {from} to {to}");
                    } else if !ring(to, from) {
                        assert!(there == back && there <= 1, "{xs}, {ys}: {from} to {to}");
                    }
                }
            }
            assert_eq!(degrees.into_iter().max(), Some(strip.max_degree()), "{xs}, {ys}");
        }
    }
}
