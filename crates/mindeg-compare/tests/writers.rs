//! The same domain gives the same bytes, but for times; and what is written is what is known.
#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use mindeg::{Domain, Side};
use mindeg_compare::{CompareOptions, compare, write_html, write_json, write_markdown};

fn domain() -> Domain {
    let corners = [[0.0, 0.0], [5.0, 1.0], [6.0, 4.0], [1.0, 5.0]].map(glam::DVec2::from);
    let sides = [9, 4, 7, 2].map(Side::count).to_vec();
    Domain::polygon(corners.to_vec(), sides).unwrap().named("a|b <i>").unwrap()
}

#[test]
fn the_same_domain_gives_the_same_bytes() {
    let written = || {
        let comparison = compare(&domain(), &CompareOptions::default()).unwrap().without_times();
        let mut files = [Vec::new(), Vec::new(), Vec::new()];
        write_html(&comparison, &mut files[0]).unwrap();
        write_json(comparison.report(), &mut files[1]).unwrap();
        write_markdown(&comparison, &mut files[2]).unwrap();
        files
    };
    assert!(written() == written());
}

#[test]
fn the_markdown_has_every_figure() {
    let comparison = compare(&domain(), &CompareOptions::default()).unwrap();
    let mut markdown = Vec::new();
    write_markdown(&comparison, &mut markdown).unwrap();
    let markdown = String::from_utf8(markdown).unwrap();
    assert!(markdown.starts_with("# Comparison: a\\|b \\<i\\>\n"));
    // Four tables, one for each measure, one for the worst of each mesh.
    let methods = &comparison.report().methods;
    let meshes: Vec<_> = methods.iter().filter(|method| method.same_mesh_as.is_none()).collect();
    assert!(meshes.len() < methods.len(), "some mesh has two names");
    assert_eq!(markdown.matches("\n|---|").count(), 4 + 6 + meshes.len());
    for line in markdown.lines().filter(|line| line.starts_with('|')) {
        assert!(line.ends_with('|'), "{line}");
    }
    for mesh in meshes {
        let others = methods.iter().filter(|method| method.same_mesh_as == Some(mesh.method));
        let names: Vec<_> =
            [mesh].into_iter().chain(others).map(|m| m.method.to_string()).collect();
        let row = format!("| {} | {} |", names.join(" and "), mesh.max_degree.unwrap());
        assert!(markdown.contains(&row), "{row}");
    }
}
