//! Decisions of degree limits and of angles with holes, against all triangulations; their proofs, and proofs that
//! are not.

use crate::domains::{Holed, Random, for_random};
use mindeg_exact::check::refutation::refutes;
use mindeg_exact::{
    COVER_STEPS, Cover, Decision, Element, Literal, LowerBound, Problem, Progress, Reached,
    Refutation, Unsolved, degree_range,
};

/// The decision, whose mesh has been checked and whose proof repeated.
fn decide(
    domain: &Holed,
    problem: &Problem,
    most: &[u32],
    least_tangent: f64,
) -> (bool, Option<Refutation>) {
    let cover = Cover::of(problem, Progress::NONE).unwrap().unwrap();
    let tangents = [least_tangent];
    match cover.decide(most, &tangents, &[], COVER_STEPS, Progress::NONE).unwrap() {
        Decision::Mesh(faces) => {
            let (chords, tangent) = domain.measured(&faces[0]);
            assert!(chords.iter().zip(most).all(|(chords, most)| chords <= most), "{domain:?}");
            assert!(tangent >= least_tangent, "{domain:?}");
            (true, None)
        }
        Decision::Refuted(refutation) => {
            assert!(refutes(&[domain.checked(least_tangent)], most, &refutation), "{domain:?}");
            (false, Some(refutation))
        }
        Decision::Unknown => unreachable!("{domain:?}"),
    }
}

/// Round holes the dynamic program finds a mesh if there is one.
fn around(domain: &Holed, problem: &Problem, most: &[u32], tangent: f64, is_possible: bool) {
    let cover = Cover::of(problem, Progress::NONE).unwrap().unwrap();
    let mut steps = u64::MAX;
    let found = cover.decide_around(problem, most, tangent, &mut steps, Progress::NONE).unwrap();
    assert_eq!(found.is_some(), domain.rings.len() > 1);
    let Some(found) = found else { return };
    assert_eq!(found.is_some(), is_possible, "{domain:?}, {most:?}");
    if tangent == 0.0 {
        let repeated = domain.checked(0.0).outline.has_triangulation(most, u64::MAX);
        assert_eq!(repeated, Some(is_possible), "{domain:?}, {most:?}");
    }
    if let Some(triangles) = found {
        let (chords, own) = domain.measured(&triangles);
        assert!(own >= tangent, "{domain:?}, {most:?}, {tangent}");
        let count = domain.points.len() + 2 * domain.rings.len() - 4;
        assert_eq!(triangles.len(), count, "{domain:?}, {most:?}");
        assert!(chords.iter().zip(most).all(|(chords, most)| chords <= most), "{domain:?}");
    }
}

#[test]
fn random_domains_agree_with_all_triangulations() {
    for_random(21, 150, |domain, random| {
        let problem = domain.problem();
        let all = domain.triangulations();
        let all: Vec<_> = all.iter().map(|triangles| domain.measured(triangles)).collect();
        assert!(!all.is_empty(), "{domain:?}");
        let n = domain.points.len();
        let is_possible = |most: &[u32], tangent: f64| {
            all.iter().any(|(chords, own)| {
                *own >= tangent && chords.iter().zip(most).all(|(chords, most)| chords <= most)
            })
        };
        let mut proof_of_less = None;
        for degree in 3..=8 {
            let most = vec![degree - 2; n];
            let (found, proof) = decide(domain, &problem, &most, 0.0);
            assert_eq!(found, is_possible(&most, 0.0), "{domain:?}, {degree}");
            around(domain, &problem, &most, 0.0, found);
            if found {
                // The proof against the smaller limit does not refute this one.
                if let Some(proof) = proof_of_less.take() {
                    assert!(!refutes(&[domain.checked(0.0)], &most, &proof), "{domain:?}");
                }
            } else {
                proof_of_less = proof;
            }
        }
        for _ in 0..6 {
            let most: Vec<u32> = (0..n).map(|_| random.below(6) as u32).collect();
            let tangent = all[random.below(all.len() as u64) as usize].1;
            let angles = [0.0, tangent, tangent.next_up()];
            for tangent in angles {
                let (found, _) = decide(domain, &problem, &most, tangent);
                assert_eq!(found, is_possible(&most, tangent), "{domain:?}, {most:?}, {tangent}");
                around(domain, &problem, &most, tangent, found);
                let free = vec![n as u32; n];
                let (found, _) = decide(domain, &problem, &free, tangent);
                assert_eq!(found, is_possible(&free, tangent), "{domain:?}, {tangent}");
                around(domain, &problem, &free, tangent, found);
            }
        }
    });
}

#[test]
fn degree_ranges_with_holes_are_the_least() {
    for_random(22, 200, |domain, random| {
        let mut problem = domain.problem();
        let all = domain.triangulations();
        let all: Vec<_> = all.iter().map(|triangles| domain.measured(triangles).0).collect();
        let n = domain.points.len();
        let mut external = vec![0; n];
        let mut own = vec![u32::MAX; n];
        if random.below(2) == 0 {
            for vertex in 0..n {
                external[vertex] = random.below(3) as u32;
                problem.set_external_degree(vertex as u32, external[vertex]);
                if random.below(3) == 0 {
                    own[vertex] = 4 + random.below(4) as u32;
                    problem.set_degree_limit(vertex as u32, own[vertex]);
                }
            }
        }
        let total = |chords: &Vec<u32>| {
            let totals =
                || chords.iter().zip(&external).map(|(chords, external)| chords + external + 2);
            let keeps = totals().zip(&own).all(|(total, own)| total <= *own);
            keeps.then(|| totals().max().unwrap())
        };
        let least = all.iter().filter_map(total).min();
        match (degree_range(&problem, Progress::NONE), least) {
            (Ok(range), Some(least)) => {
                assert_eq!((range.lower_bound, range.max_degree), (least, least), "{domain:?}");
                let chords = domain.measured(&range.triangles).0;
                assert_eq!(total(&chords), Some(least), "{domain:?}");
                check_bound(domain, &range.bounded_by, least, &external, &own);
            }
            (Err(error), None) => assert_eq!(error, Unsolved::VertexLimits),
            (range, least) => {
                unreachable!("{range:?}, {least:?}: {domain:?}, {external:?}, {own:?}")
            }
        }
    });
}

#[test]
fn the_largest_angles_with_holes_are_those_of_all_triangulations() {
    for_random(25, 120, |domain, random| {
        let problem = domain.problem();
        let all = domain.triangulations();
        let all: Vec<_> = all.iter().map(|it| (it, domain.measured(it))).collect();
        let cover = Cover::of(&problem, Progress::NONE).unwrap().unwrap();
        let degree = |chords: &[u32]| chords.iter().max().unwrap() + 2;
        let (known, (chords, _)) = &all[random.below(all.len() as u64) as usize];
        for limit in degree(chords)..degree(chords) + 3 {
            let within = all.iter().filter(|(_, (chords, _))| degree(chords) <= limit);
            let most = within.map(|(_, (_, tangent))| *tangent).fold(0.0, f64::max);
            let mut steps = COVER_STEPS;
            let found =
                cover.largest_angle(&problem, limit, known, &mut steps, Progress::NONE).unwrap();
            let (chords, tangent) = domain.measured(&found.triangles);
            assert_eq!((tangent, found.is_largest), (most, true), "{domain:?}, {limit}");
            assert!(degree(&chords) <= limit);
            assert_eq!(found.min_angle, libm::atan(tangent).to_degrees());
        }
    });
}

fn check_bound(domain: &Holed, bound: &LowerBound, least: u32, external: &[u32], own: &[u32]) {
    let checked = domain.checked(0.0);
    match bound {
        LowerBound::Refuted(refutation) => {
            let most =
                |(external, own): (&u32, &u32)| (least - 1).min(*own).saturating_sub(external + 2);
            let most: Vec<u32> = external.iter().zip(own).map(most).collect();
            assert!(refutes(&[checked], &most, refutation), "{domain:?}");
        }
        LowerBound::NoStrip => {
            assert!(least == 5 && checked.outline.blocks_all_strips(), "{domain:?}");
        }
        LowerBound::Counting => {
            let counted = checked.outline.counting_bound(|vertex| external[vertex as usize]);
            assert_eq!(counted, least, "{domain:?}");
        }
        LowerBound::Apexes(bound) => assert!(checked.outline.bounds_apexes(bound), "{domain:?}"),
        other => unreachable!("{other:?}: {domain:?}"),
    }
}

/// Degree 4 with one hole: the strips against all triangulations.
#[test]
fn strips_decide_about_degree_4() {
    let (mut with, mut without) = (0, 0);
    for_random(23, 250, |domain, _| {
        if domain.rings.len() != 2 {
            return;
        }
        let all = domain.triangulations();
        let is_four =
            |triangles: &Vec<[u32; 3]>| domain.measured(triangles).0.iter().all(|&c| c <= 2);
        let has_four = all.iter().any(is_four);
        assert_eq!(!domain.checked(0.0).outline.blocks_all_strips(), has_four, "{domain:?}");
        let range = degree_range(&domain.problem(), Progress::NONE).unwrap();
        assert_eq!(range.max_degree == 4, has_four, "{domain:?}");
        with += u32::from(has_four);
        without += u32::from(!has_four);
    });
    assert!(with > 20 && without > 20, "{with}, {without}");
}

/// Domains on which windows and bounds left a gap, and their least degrees.
#[test]
fn known_gaps_are_closed() {
    let hole6 = Holed::new(&[&[(1, 14), (10, 11), (13, 28)], &[(8, 20), (8, 19), (6, 19)]]);
    let hole12 = Holed::new(&[
        &[(0, -4112), (25, 625), (-22, 484)],
        &[(5, -1856), (3, -2013), (4, -1392), (10, -1980)],
        &[(17, -494), (12, 120), (15, 86), (15, 63), (14, -14)],
    ]);
    for (domain, least) in [(hole6, 4), (hole12, 6)] {
        let range = degree_range(&domain.problem(), Progress::NONE).unwrap();
        assert_eq!((range.lower_bound, range.max_degree), (least, least));
        let n = domain.points.len();
        check_bound(&domain, &range.bounded_by, least, &vec![0; n], &vec![u32::MAX; n]);
        if least == 4 {
            assert_eq!(range.reached_by, Reached::Strip);
        } else {
            assert!(matches!(range.bounded_by, LowerBound::Refuted(_)));
        }
    }
}

/// A proof with a change is refused, or what it says holds nevertheless.
#[test]
fn changed_proofs_of_what_is_possible_are_refused() {
    let mut refused = 0;
    for_random(24, 120, |domain, random| {
        let problem = domain.problem();
        let n = domain.points.len();
        let Some((degree, proof)) = (4..9).rev().find_map(|degree| {
            let (found, proof) = decide(domain, &problem, &vec![degree - 2; n], 0.0);
            (!found).then_some((degree, proof?))
        }) else {
            return;
        };
        let below = vec![degree - 2; n];
        let face = [domain.checked(0.0)];
        assert!(refutes(&face, &below, &proof));
        // Without its end it proves nothing.
        let open = Refutation { clauses: proof.clauses[..proof.clauses.len() - 1].to_vec() };
        assert!(!refutes(&face, &below, &open));
        // A clause that does not hold: that a chord of some mesh is not there, and others.
        let possible = vec![degree - 1; n];
        for _ in 0..10 {
            let mut changed = proof.clone();
            let any = changed.clauses.len() as u64;
            let clause = random.below(any) as usize;
            let element = Element::Chord([0, random.below(n as u64) as u32]);
            let literal = Literal { face: 0, element, is_used: random.below(2) == 0 };
            match random.below(3) {
                0 => changed.clauses.insert(clause, vec![literal]),
                1 => changed.clauses[clause].clear(),
                _ => changed.clauses[clause].iter_mut().for_each(|it| it.is_used ^= true),
            }
            assert!(!refutes(&face, &possible, &changed), "{domain:?}");
            refused += 1;
        }
    });
    assert!(refused > 200, "{refused}");
}

/// One change of a proof, as a damaged or forged file may have it.
fn change(proof: &mut Refutation, vertices: usize, random: &mut Random) {
    let clauses = &mut proof.clauses;
    let mut any = |count: usize| random.below(count.max(1) as u64) as usize;
    let (clause, other) = (any(clauses.len()), any(clauses.len()));
    let literal = any(clauses[clause].len());
    let corners = [(); 3].map(|()| any(vertices) as u32);
    let element = match any(2) {
        0 => Element::Chord([corners[0], corners[1]]),
        _ => Element::Triangle(corners),
    };
    let is_used = any(2) == 0;
    match any(8) {
        0 => drop(clauses.remove(clause)),
        1 => clauses.swap(clause, other),
        2 => clauses[clause].clear(),
        3 => clauses.insert(clause, vec![Literal { face: 0, element, is_used }]),
        _ if clauses[clause].is_empty() => {}
        4 => drop(clauses[clause].remove(literal)),
        5 => clauses[clause][literal].is_used ^= true,
        6 => clauses[clause][literal].element = element,
        _ => {
            let moved = clauses[clause].remove(literal);
            clauses[other].push(moved);
        }
    }
}

/// However a proof is changed, and whichever limits it is put to, it never refutes what some mesh keeps, not even limits of
/// one chord more at one vertex than those that it was made for.
#[test]
fn no_change_makes_a_proof_of_a_false_claim() {
    let (mut refused, mut held) = (0, 0);
    for_random(26, 200, |domain, random| {
        let all = domain.triangulations();
        let all: Vec<_> = all.iter().map(|it| domain.measured(it).0).collect();
        let n = domain.points.len();
        let is_possible = |most: &[u32]| {
            all.iter().any(|chords| chords.iter().zip(most).all(|(chords, most)| chords <= most))
        };
        let mesh = &all[random.below(all.len() as u64) as usize];
        let possible: Vec<u32> =
            mesh.iter().map(|chords| chords + u32::from(random.below(2) == 0)).collect();
        let mut below = possible.clone();
        let vertex = random.below(n as u64) as usize;
        below[vertex] = below[vertex].saturating_sub(1 + random.below(2) as u32);
        let (_, Some(proof)) = decide(domain, &domain.problem(), &below, 0.0) else { return };
        let face = [domain.checked(0.0)];
        for _ in 0..20 {
            let mut changed = proof.clone();
            for _ in 0..random.below(4) {
                change(&mut changed, n, random);
                if changed.clauses.is_empty() {
                    changed.clauses.push(Vec::new());
                }
            }
            assert!(!refutes(&face, &possible, &changed), "{domain:?}, {changed:?}");
            // Other rows: a limit less at one vertex and more at another.
            let mut others = possible.clone();
            let [from, to] = [(); 2].map(|()| random.below(n as u64) as usize);
            others[from] = others[from].saturating_sub(1);
            others[to] += 1;
            let is_refuted = refutes(&face, &others, &changed);
            assert!(!is_refuted || !is_possible(&others), "{domain:?}, {changed:?}");
            match refutes(&face, &below, &changed) {
                true => held += 1,
                false => refused += 1,
            }
        }
    });
    assert!(refused > 200 && held > 200, "{refused}, {held}");
}
