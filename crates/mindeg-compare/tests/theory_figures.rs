//! The figures of `docs/theory.md` are those that the program draws.

use std::path::Path;

#[path = "../examples/theory_figures.rs"]
#[expect(dead_code, reason = "the example's own entry point")]
mod example;

#[test]
fn the_figures_of_the_theory_are_as_drawn() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/figures");
    for (name, figure) in example::figures().unwrap() {
        let mut drawn = Vec::new();
        mindeg_formats::svg::write(&*figure, &mut drawn).unwrap();
        let kept = std::fs::read(folder.join(name)).unwrap();
        assert!(kept == drawn, "{name} differs; run the example theory_figures again");
    }
}
