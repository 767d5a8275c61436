//! From a polygon of a file to a domain.

use glam::DVec2;
use mindeg_domain::{Domain, Ring, Side};

use super::outline::Feature;
use super::sides::{DividedSide, Division};
use super::text::clean;
use crate::error::OutlineError;

impl Feature {
    /// The domain inside the outer ring and outside the holes.
    ///
    /// # Errors
    ///
    /// A size that makes too many points; rings that cross or touch, and everything else that
    /// [`Domain::of_rings`] refuses.
    pub fn domain(&self, division: &Division) -> Result<Domain, OutlineError> {
        let divided = self.rings.iter().map(|ring| ring.divided(division));
        let divided: Vec<Vec<DividedSide>> = divided.collect::<Result<_, _>>()?;
        let rings = divided.into_iter().map(|sides| {
            let corners: Vec<DVec2> = sides.iter().map(|side| side.points[0]).collect();
            let sides = sides.into_iter().map(domain_side).collect();
            Ring { corners, sides }
        });
        let domain = Domain::of_rings(rings.collect())?;
        match self.name.as_deref().map(clean).filter(|name| !name.is_empty()) {
            Some(name) => Ok(domain.named(name)?),
            None => Ok(domain),
        }
    }
}

pub(super) fn domain_side(divided: DividedSide) -> Side {
    let DividedSide { name, mut points, is_line } = divided;
    let name = name.map(|name| clean(&name)).filter(|name| !name.is_empty());
    let side = if is_line || points.len() == 1 {
        Side::count(points.len() as u64)
    } else {
        points.remove(0);
        Side::points(points)
    };
    Side { name, ..side }
}

#[cfg(test)]
mod tests {
    use super::super::{OutlineFormat, read};
    use super::*;

    /// No file stands beside these.
    fn alone(_: &str) -> std::io::Result<Vec<u8>> {
        Err(std::io::ErrorKind::NotFound.into())
    }

    fn domain(text: &str, format: OutlineFormat, size: Option<f64>) -> Domain {
        let outlines = read(text.as_bytes(), format, alone).unwrap();
        outlines.features[0].domain(&Division { size, ..Division::default() }).unwrap()
    }

    /// Whether names and points are the same, bit for bit. Sides of a turned ring come back with
    /// their points.
    fn same(one: &Domain, other: &Domain) -> bool {
        let names = |domain: &Domain| {
            domain.sides().iter().map(|side| side.name.clone()).collect::<Vec<_>>()
        };
        one.name() == other.name()
            && names(one) == names(other)
            && one.rings() == other.rings()
            && one.placement().points().eq(other.placement().points())
    }

    #[test]
    fn sides_keep_their_names_and_points() {
        let nodes = "1 0 0 0\n2 1 0 0\n3 2 0.1 0\n4 2 2 0\n5 0 2 0\n";
        let lines = [(7, 1, 2), (7, 2, 3), (8, 3, 4), (8, 4, 5), (9, 5, 1)];
        let bell = '\u{7}';
        let mut text = format!(
            "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n1 1 \"wall\"\n1 2 \"in{bell}let\"\n$EndPhysicalNames\n$Nodes\n5\n{nodes}$EndNodes\n$Elements\n5\n"
        );
        for (index, (curve, a, b)) in lines.into_iter().enumerate() {
            let group = if curve == 9 { 2 } else { 1 };
            text += &format!("{} 1 2 {group} {curve} {a} {b}\n", index + 1);
        }
        text += "$EndElements\n";
        let domain = domain(&text, OutlineFormat::Msh, None);
        let names: Vec<Option<&str>> = domain.sides().iter().map(|it| it.name.as_deref()).collect();
        // The curve 8 has a corner, so it is two sides.
        assert_eq!(names, [Some("wall"), Some("wall"), Some("wall"), Some("in let")]);
        assert!(domain.rings().sides().eq([2, 1, 1, 1]));
        let points: Vec<[f64; 2]> = domain.placement().points().map(|it| it.to_array()).collect();
        assert_eq!(points, [[0.0, 0.0], [1.0, 0.0], [2.0, 0.1], [2.0, 2.0], [0.0, 2.0]]);
        let again = Domain::from_json(&domain.to_json()).unwrap();
        assert!(same(&again, &domain));
    }

    #[test]
    fn curves_become_points_of_their_sides() {
        let svg = "<svg><path id='a&#10;b' d='M0 0h4a2 2 0 0 1 0 4h-4z'/></svg>";
        let kept = domain(svg, OutlineFormat::Svg, None);
        assert_eq!(kept.name(), Some("a b"));
        // The lines go on into the arc without a corner; turned, since y points up.
        assert!(kept.rings().sides().eq([1, 14]));
        let divided = domain(svg, OutlineFormat::Svg, Some(0.5));
        assert!(divided.rings().sides().eq([8, 29]));
        for domain in [kept, divided] {
            assert!(same(&Domain::from_json(&domain.to_json()).unwrap(), &domain));
        }
    }

    #[test]
    fn touching_rings_may_be_mended() {
        for (wkt, is_touch) in [
            ("POLYGON((0 0,2 1,4 0,4 2,2 1,0 2))", true),
            ("POLYGON((0 0,4 4,4 0,0 4))", true),
            ("POLYGON((0 0,0 0,4 4,4 0))", true),
            ("POLYGON((0 0,4 0))", false),
        ] {
            let outlines = read(wkt.as_bytes(), OutlineFormat::Wkt, alone).unwrap();
            let error = outlines.features[0].domain(&Division::default()).unwrap_err();
            assert_eq!(error.is_touch, is_touch, "{error}");
        }
    }
}
