//! The same domain gives the same bytes, but for times; and what is written is what is known.

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
    let rows: Vec<&str> = markdown.lines().skip_while(|line| *line != "## Overview").collect();
    let rows: Vec<&str> = rows.iter().skip(4).map_while(|line| line.get(2..)).collect();
    assert!(rows[0].starts_with("Least degree, largest angle | 4 |"), "{}", rows[0]);
    // The words of the JSON are not those of a reader.
    assert!(!markdown.contains("Exact,") && !markdown.contains("| mindeg"), "{markdown}");
    for (mesh, row) in meshes.iter().zip(&rows) {
        let degree = mesh.max_degree.unwrap();
        assert!(row.contains(&format!(" | {degree} | ")), "{row}");
    }
    assert_eq!(meshes.len(), rows.len());
}
