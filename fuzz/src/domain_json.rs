//! Domains and models in JSON: any text is a domain, or an error of one or more words.

use mindeg::Domain;

pub(crate) fn run(text: &str) {
    // A domain of the most points there may be takes 3 GB.
    match Domain::from_json_up_to(text, 1 << 20) {
        Ok(domain) => {
            let rings = domain.rings();
            for vertex in [0, rings.vertex_count() / 2, rings.vertex_count() - 1] {
                assert!(domain.placement().point(vertex).is_finite());
                let _ = (domain.degree_limit(vertex), domain.external_degree(vertex));
            }
            assert!(domain.placement().area() > 0.0);
            for side in 0..rings.side_count() {
                assert!(!domain.side_name(side).is_empty());
            }
            if rings.vertex_count() < 2_000 {
                let _ = domain.straight_runs();
            }
        }
        Err(error) => assert!(!error.to_string().is_empty()),
    }
}
