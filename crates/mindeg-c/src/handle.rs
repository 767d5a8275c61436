//! The handle: a mesh, or why there is none.

use std::ffi::{CStr, CString};
use std::panic::{AssertUnwindSafe, catch_unwind};

use mindeg::glam::{DVec2, DVec3};
use mindeg::{Domain, Goal, Mesh, Progress};
use mindeg_answers::interior::InteriorAnswer;
use mindeg_answers::mesh::MeshAnswer;
use mindeg_mesh::filled;
use serde::Serialize;

use crate::wanted::Wanted;

/// A mesh, or the error that says why there is none. Threads may read one handle at the same time.
pub struct MindegMesh(pub(crate) Result<Made, CString>);

/// A mesh that was made.
pub(crate) struct Made {
    pub(crate) points: Vec<[f64; 2]>,
    pub(crate) triangles: Vec<[u32; 3]>,
    pub(crate) max_degree: u32,
    pub(crate) min_angle: f64,
    /// JSON.
    pub(crate) report: CString,
}

impl MindegMesh {
    /// The mesh of the polygon inside the first ring of points and outside the others.
    pub fn of_rings(rings: Vec<Vec<[f64; 2]>>, options: Option<&str>) -> Box<Self> {
        Self::of(|| {
            let rings = rings.into_iter().map(|ring| ring.into_iter().map(DVec2::from));
            made(&Domain::from_rings(rings).map_err(|error| error.to_string())?, options)
        })
    }

    /// The mesh of a domain in JSON.
    pub fn of_domain(domain: &str, options: Option<&str>) -> Box<Self> {
        Self::of(|| made(&Domain::from_json(domain).map_err(|error| error.to_string())?, options))
    }

    /// The result of work; a panic is an error.
    pub(crate) fn of(work: impl FnOnce() -> Result<Made, String>) -> Box<Self> {
        // The work leaves nothing behind that others could see half done.
        let done = catch_unwind(AssertUnwindSafe(work)).unwrap_or_else(|_| {
            Err("mindeg has failed, which is its fault; please report it with this input"
                .to_owned())
        });
        Box::new(Self(done.map_err(c_string)))
    }

    pub(crate) fn made(&self) -> Option<&Made> {
        self.0.as_ref().ok()
    }

    pub(crate) fn error(&self) -> Option<&CStr> {
        self.0.as_ref().err().map(CString::as_c_str)
    }
}

fn made(domain: &Domain, options: Option<&str>) -> Result<Made, String> {
    let given = options.map(Wanted::read).transpose()?.flatten();
    let of_domain = || domain.interior().cloned().map(Wanted::Interior);
    match given.or_else(of_domain).unwrap_or(Wanted::Goal(Goal::default())) {
        Wanted::Goal(goal) => {
            let found = mindeg::mesh(domain, goal, Progress::NONE);
            let found = found.map_err(|error| error.to_string())?;
            let angles = found.mesh.angle_range();
            let answer = MeshAnswer::of(&found, [angles.min, angles.max]);
            Made::new(&found.mesh, answer.max_degree, answer.min_angle, &answer)
        }
        Wanted::Interior(wanted) => {
            let found = mindeg::interior::mesh(domain, &wanted, Progress::NONE);
            let found = found.map_err(|error| error.to_string())?;
            let answer = InteriorAnswer::from(&found);
            Made::new(&found.mesh, answer.max_degree, answer.min_angle, &answer)
        }
    }
}

impl Made {
    fn new(
        mesh: &dyn Mesh,
        max_degree: u32,
        min_angle: f64,
        answer: &impl Serialize,
    ) -> Result<Self, String> {
        let points = filled(0..mesh.vertex_count(), DVec3::ZERO, |first, out| {
            mesh.fill_positions(first, out);
        });
        let triangles = filled(0..mesh.triangle_count(), [0; 3], |first, out| {
            mesh.fill_triangles(first, out);
        });
        let report = serde_json::to_string(answer).map_err(|error| error.to_string())?;
        Ok(Self {
            points: points.into_iter().map(|point| [point.x, point.y]).collect(),
            triangles,
            max_degree,
            min_angle,
            report: c_string(report),
        })
    }
}

/// Text for C, which ends at the first zero byte; JSON and messages have none, or it is left out.
fn c_string(text: String) -> CString {
    CString::new(text.replace('\0', "")).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plate() -> Vec<Vec<[f64; 2]>> {
        let square =
            |x: f64, size: f64| vec![[x, x], [x + size, x], [x + size, x + size], [x, x + size]];
        vec![square(0.0, 3.0), square(1.0, 1.0)]
    }

    #[test]
    fn rings_become_a_mesh_with_their_points() {
        let mesh = MindegMesh::of_rings(plate(), None);
        let made = mesh.made().expect("a square with a hole has a mesh");
        assert_eq!((made.points.len(), made.triangles.len(), made.max_degree), (8, 8, 4));
        assert_eq!(made.points[..4], plate()[0]);
        // The triangles join two corners of the hole and one of the outline, or the other way round.
        assert!(
            (made.min_angle - 0.5_f64.atan2(1.5).to_degrees()).abs() < 1e-9,
            "{}",
            made.min_angle
        );
        let report: serde_json::Value =
            serde_json::from_slice(made.report.as_bytes()).expect("the report is JSON");
        assert_eq!(report["max_degree"], 4);
        assert_eq!(mesh.error(), None);
    }

    #[test]
    fn points_inside_come_by_the_option_and_by_the_domain() {
        let domain = r#"{"rectangle": {"width": 4, "height": 3}, "size": 0.5, "interior": {}}"#;
        let by_domain = MindegMesh::of_domain(domain, None);
        let plain = domain.replace(r#", "interior": {}"#, "");
        let by_option = MindegMesh::of_domain(&plain, Some(r#"{"interior": {}}"#));
        let without = MindegMesh::of_domain(domain, Some(r#"{"least_degree": true}"#));
        let count = |mesh: &MindegMesh| mesh.made().map(|made| made.points.len());
        assert!(count(&by_option) > Some(28), "{:?}", by_option.error());
        assert_eq!(count(&by_option), count(&by_domain));
        assert!(count(&by_domain) > Some(28), "{:?}", by_domain.error());
        assert_eq!(count(&without), Some(28));
    }

    #[test]
    fn errors_and_panics_are_told() {
        let cross = vec![vec![[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]]];
        for (mesh, part) in [
            (MindegMesh::of_rings(cross, None), "cross"),
            (MindegMesh::of_domain("{", None), "line 1"),
            (MindegMesh::of_rings(plate(), Some("{\"max_degree\": 3}")), "degree"),
            (MindegMesh::of(|| unreachable!("as a fault would")), "please report it"),
            (MindegMesh::of(|| Err("a\0b".to_owned())), "ab"),
        ] {
            let error = mesh.error().expect(part).to_string_lossy().into_owned();
            assert!(error.contains(part), "{error}");
            assert!(mesh.made().is_none());
        }
    }

    #[test]
    fn handles_go_to_other_threads() {
        fn is_shared<T: Send + Sync>() {}
        is_shared::<MindegMesh>();
    }
}
