//! The advised mesh of a comparison, and the command that makes it.
//!
//! The rule is that of `mindeg mesh --keep-angle 95%`: the smallest degree whose best mesh keeps
//! [`KEPT`] of Delaunay's minimum angle.
//!
//! Limits: the rule looks at the minimum angle alone. The verdict says where the other triangles
//! speak against it.

use crate::Method;
use crate::figures::MethodFigures;
use mindeg::exact::{keeps, share_of};
use mindeg_answers::advice::KEPT;
use schemars::JsonSchema;
use serde::Serialize;

/// The mesh to take.
///
/// # Example
///
/// ```
/// use mindeg_compare::{CompareOptions, compare};
/// use mindeg::{Domain, Side};
///
/// let domain = Domain::rectangle(4.0, 3.0, vec![Side::count(10); 4])?;
/// let advice = compare(&domain, &CompareOptions::default())?.report().advice.unwrap();
/// assert_eq!((advice.max_degree, advice.share_of_delaunay), (5, 1.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Advice {
    /// The method that has it.
    pub method: Method,
    /// Its maximum degree.
    pub max_degree: u32,
    /// Its minimum angle as a share of Delaunay's: 1 (all of it) to 0.
    pub share_of_delaunay: f64,
}

impl Advice {
    /// The valid mesh of the lowest degree that keeps [`KEPT`] of Delaunay's minimum angle; of
    /// several, the one with the largest angle, and then the first. None without a valid Delaunay
    /// triangulation to compare with, and none where only Delaunay's mesh would be left but degrees
    /// between the least and its were not looked at.
    pub(crate) fn of(methods: &[MethodFigures], has_trade_off: bool) -> Option<Self> {
        let delaunay = methods.iter().find(|method| method.method == Method::DELAUNAY)?;
        let (degree_there, whole) = delaunay.outcome()?;
        let lowest =
            methods.iter().filter_map(MethodFigures::outcome).map(|(degree, _)| degree).min();
        let all_looked_at = has_trade_off || lowest == Some(degree_there);
        methods
            .iter()
            .filter_map(|method| Some((method.method, method.outcome()?)))
            .filter(|(_, (_, angle))| keeps(*angle, KEPT, whole))
            .filter(|(_, (degree, _))| all_looked_at || *degree < degree_there)
            .min_by(|(_, (degree, angle)), (_, (other, its_angle))| {
                degree.cmp(other).then(its_angle.total_cmp(angle))
            })
            .map(|(method, (max_degree, angle))| Self {
                method,
                max_degree,
                share_of_delaunay: share_of(angle, whole).min(1.0),
            })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn method(method: Method, degree: u32, angle: f64) -> MethodFigures {
        MethodFigures {
            method,
            max_degree: Some(degree),
            min_angle: Some(angle),
            valid: true,
            ..MethodFigures::default()
        }
    }

    #[test]
    fn the_lowest_degree_that_keeps_the_angle_is_advised() {
        let exact = |max_degree| Method::Exact { max_degree };
        let least = || method(Method::LeastDegree, 4, 1.0);
        let delaunay = || method(Method::DELAUNAY, 9, 10.0);
        for (others, expected) in [
            (vec![], (Method::DELAUNAY, 9)),
            (vec![method(exact(4), 4, 9.5)], (exact(4), 4)),
            (vec![method(exact(4), 4, 9.4), method(exact(5), 5, 9.6)], (exact(5), 5)),
            (vec![method(exact(5), 5, 9.6), method(exact(6), 5, 9.7)], (exact(6), 5)),
        ] {
            let methods = [vec![least(), delaunay()], others].concat();
            let advice = Advice::of(&methods, true).unwrap();
            assert_eq!((advice.method, advice.max_degree), expected);
        }
        assert_eq!(Advice::of(&[least(), delaunay()], false), None);
        assert!(Advice::of(&[method(Method::LeastDegree, 4, 9.9), delaunay()], false).is_some());
        assert_eq!(Advice::of(&[least()], true), None);
        let broken = MethodFigures { valid: false, ..delaunay() };
        assert_eq!(Advice::of(&[least(), broken], true), None);
    }
}
