//! The titles of the meshes of a report, in the words of the other pages.
//!
//! The JSON has the names of the methods instead, which never change.

use super::Report;
use crate::Method;
use crate::figures::MethodFigures;
use mindeg_answers::numbers::count;

/// A mesh, or a method without one, under the title of all methods that have it.
pub(crate) struct Named<'a> {
    /// The index of the first of these methods in the report.
    pub(crate) place: usize,
    pub(crate) name: String,
    pub(crate) figures: &'a MethodFigures,
}

/// The meshes of a report, each once, in the order of the methods.
pub(crate) fn named(report: &Report) -> Vec<Named<'_>> {
    let firsts = report.methods.iter().enumerate().filter(|(_, m)| m.same_mesh_as.is_none());
    let named = firsts.map(|(place, figures)| {
        let others = report.methods.iter().filter(|m| m.same_mesh_as == Some(figures.method));
        let name = others.fold(title(report, figures.method), |name, other| {
            name + &same_mesh(report, other.method)
        });
        Named { place, name, figures }
    });
    named.collect()
}

/// The title of the mesh of a method.
pub(crate) fn title(report: &Report, method: Method) -> String {
    match method {
        Method::LeastDegree => "Least degree".to_owned(),
        Method::Reference(reference) => reference.name().to_owned(),
        Method::Exact { max_degree } if !keeps_enough(report, max_degree) => {
            format!("Degree {}, largest angle", count(max_degree))
        }
        Method::Exact { .. } | Method::Kept => "Keeps 95% of the angle".to_owned(),
        Method::Fewest => "Fewest edges".to_owned(),
        Method::Inside => "Points inside".to_owned(),
    }
}

/// The words after the title of a mesh that this method has, too.
fn same_mesh(report: &Report, method: Method) -> String {
    match method {
        Method::Exact { max_degree } if !keeps_enough(report, max_degree) => {
            ", largest angle".to_owned()
        }
        // A name of a person keeps its capital.
        Method::DELAUNAY => " and Delaunay".to_owned(),
        Method::Reference(reference) => format!(" and {}", reference.name().to_lowercase()),
        _ => format!(", {}", title(report, method).to_lowercase()),
    }
}

/// Whether this degree is the least that keeps 95% of Delaunay's minimum angle.
fn keeps_enough(report: &Report, degree: u32) -> bool {
    report.trade_off.as_ref().is_some_and(|trade_off| trade_off.advised == Some(degree))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{CompareOptions, Reference, compare};
    use mindeg::{Domain, Side};

    /// The title of a mesh that all these methods have, where `kept` is the degree to take.
    fn shared(methods: &[Method], kept: Option<u32>) -> String {
        let domain = Domain::rectangle(4.0, 3.0, vec![Side::count(10); 4]).unwrap();
        let mut report = compare(&domain, &CompareOptions::default()).unwrap().report().clone();
        report.trade_off.as_mut().unwrap().advised = kept;
        let of = |(place, &method): (usize, &Method)| MethodFigures {
            method,
            same_mesh_as: (place > 0).then_some(methods[0]),
            ..MethodFigures::default()
        };
        report.methods = methods.iter().enumerate().map(of).collect();
        match &named(&report)[..] {
            [Named { place: 0, name, .. }] => name.clone(),
            others => panic!("{} titles", others.len()),
        }
    }

    #[test]
    fn a_mesh_appears_once_under_a_title_that_reads_well() {
        use Method::{Exact, Fewest, Inside, Kept, LeastDegree};
        let (four, five) = (Exact { max_degree: 4 }, Exact { max_degree: 5 });
        let ears = Method::Reference(Reference::EarClipping);
        for (methods, title) in [
            (&[LeastDegree][..], "Least degree"),
            (&[LeastDegree, four], "Least degree, largest angle"),
            (&[LeastDegree, five], "Least degree, keeps 95% of the angle"),
            (&[LeastDegree, Kept], "Least degree, keeps 95% of the angle"),
            (&[LeastDegree, Method::DELAUNAY, ears], "Least degree and Delaunay and ear clipping"),
            (&[LeastDegree, Fewest], "Least degree, fewest edges"),
            (&[LeastDegree, Inside], "Least degree, points inside"),
            (&[Method::DELAUNAY, four], "Delaunay, largest angle"),
            (&[four], "Degree 4, largest angle"),
            (&[five], "Keeps 95% of the angle"),
            (&[Kept], "Keeps 95% of the angle"),
        ] {
            assert_eq!(shared(methods, Some(5)), title);
        }
        assert_eq!(shared(&[five], None), "Degree 5, largest angle");
    }
}
