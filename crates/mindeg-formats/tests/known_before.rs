//! The size and the faults of a file that are known before it is written.

use mindeg::{Domain, Rectangle, Side};
use mindeg_formats::MeshPlane;
use mindeg_formats::gltf::Stored;

/// There are hundreds of millions of points, and it takes no time.
#[test]
fn the_first_of_many_coincidences_is_named() {
    let crowded = Side::count(1 << 28);
    let sides = vec![Side::count(1), crowded.clone(), crowded, Side::count(1)];
    let outline = Rectangle { rotation: 30.0, ..Rectangle::new(4.0, 3.0) };
    let domain = Domain::new(mindeg::Outline::Rectangle(outline), sides).unwrap();
    for _ in 0..3 {
        let error = Stored::new(domain.placement(), MeshPlane::Xy).unwrap_err().to_string();
        assert!(error.starts_with("vertices 1 and 2 (counted from 0)"), "{error}");
        assert!(error.contains("or write OBJ"));
    }
}
