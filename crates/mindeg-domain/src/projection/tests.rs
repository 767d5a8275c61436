use super::*;

/// Definitions, degrees, and metres by PROJ 9.5.1 through pyproj.
const BY_PROJ: &[(&str, [f64; 2], [f64; 2])] = &[
    ("EPSG:32635", [23.7275, 37.9838], [212581.8145, 4209072.2715]),
    ("EPSG:32635", [22.5, 40.5], [118635.7512, 4492991.8294]),
    ("EPSG:32635", [30.25, -0.001], [861839.0285, -110.7093]),
    ("EPSG:32635", [55.0, 70.0], [1535723.9578, 8009658.8445]),
    ("EPSG:32760", [177.0, -18.5], [500000.0000, 7954494.9627]),
    ("EPSG:32760", [-179.5, -16.0], [874669.4790, 8227907.4960]),
    ("EPSG:25832", [9.0, 54.3], [500000.0000, 6016900.6434]),
    ("+proj=stere +lat_0=38 +lon_0=25 +datum=WGS84", [22.5, 35.5], [-226896.9739, -274506.7176]),
    ("+proj=stere +lat_0=38 +lon_0=25 +datum=WGS84", [40.0, 60.0], [865941.7869, 2566126.1213]),
    (
        "+proj=stere +lat_0=38 +lon_0=25 +datum=WGS84",
        [-150.0, 10.0],
        [-3308641.0830, 28438702.1754],
    ),
    ("EPSG:3413", [-45.5, 70.25], [-18849.7305, -2159965.1739]),
    ("EPSG:3413", [120.0, 88.0], [56079.8117, 209292.7065]),
    ("EPSG:3031", [10.0, -75.5], [274986.3328, 1559524.9897]),
    ("+proj=stere +lat_0=-90 +lon_0=0 +datum=WGS84", [10.0, -75.5], [282684.0998, 1603181.1961]),
    ("EPSG:3035", [10.5, 50.25], [4356664.2983, 3015437.2766]),
    ("EPSG:3035", [-8.0, 60.0], [3326682.6403, 4227129.6055]),
    ("+proj=laea +lat_0=90 +lon_0=0 +datum=WGS84", [30.0, 80.0], [557704.5255, -965972.5737]),
    ("+proj=laea +lat_0=-15 +lon_0=179 +datum=WGS84", [-178.0, -17.0], [319467.6138, -223525.9569]),
];

#[test]
fn a_number_alone_is_a_code() {
    assert_eq!("3035".parse::<Projection>(), "EPSG:3035".parse());
    assert!("".parse::<Projection>().is_err());
}

#[test]
fn points_are_where_proj_puts_them_and_come_back() {
    for (text, degrees, metres) in BY_PROJ {
        let projection: Projection = text.parse().unwrap();
        let [degrees, metres] = [degrees, metres].map(|it| DVec2::from(*it));
        let found = projection.to_plane(degrees);
        assert!(found.distance(metres) < 1e-4, "{text}: {degrees} is at {found}, not {metres}");
        let again = projection.to_degrees(found);
        let off = DVec2::new(wrapped(again.x - degrees.x), again.y - degrees.y);
        assert!(off.length() < 1e-10, "{text}: {degrees} comes back as {again}");
        assert_eq!(projection.to_string().parse(), Ok(projection), "{text}");
    }
}

/// A sea across the antimeridian had triangles round the whole globe in formats in degrees.
#[test]
fn longitudes_go_on_across_the_antimeridian() {
    for text in [
        "+proj=utm +zone=60",
        "+proj=stere +lat_0=-15 +lon_0=179",
        "+proj=laea +lat_0=-15 +lon_0=-179",
    ] {
        let projection: Projection = text.parse().unwrap();
        let around = |longitude: f64| {
            projection.to_degrees(projection.to_plane(DVec2::new(longitude, -17.0))).x
        };
        let step = around(-179.0) - around(179.0);
        assert!((step - 2.0).abs() < 1e-9, "{text}: {step}");
    }
}

#[test]
fn centers_and_poles_come_back() {
    for (text, degrees) in [
        ("+proj=stere +lat_0=38 +lon_0=25", [25.0, 38.0]),
        ("+proj=laea +lat_0=38 +lon_0=25", [25.0, 38.0]),
        ("+proj=stere +lat_0=90 +lon_0=0", [0.0, 90.0]),
        ("+proj=stere +lat_0=-90 +lon_0=0", [0.0, -90.0]),
        ("+proj=laea +lat_0=-90 +lon_0=0", [0.0, -90.0]),
    ] {
        let projection: Projection = text.parse().unwrap();
        let degrees = DVec2::from(degrees);
        assert!(projection.to_plane(degrees).length() < 1e-8, "{text}");
        assert!((projection.to_degrees(DVec2::ZERO) - degrees).length() < 1e-12, "{text}");
    }
    // A pole inside the plane of another centre.
    let projection: Projection = "+proj=stere +lat_0=80 +lon_0=25".parse().unwrap();
    let pole = projection.to_plane(DVec2::new(-90.0, 90.0));
    assert!(pole.x.abs() < 1e-6 && (1.1e6..1.2e6).contains(&pole.y), "{pole}");
    assert!((projection.to_degrees(pole).y - 90.0).abs() < 1e-9);
}

#[test]
fn conformal_projections_keep_angles_and_the_other_areas() {
    for (text, at) in [
        ("EPSG:32635", [22.5, 40.0]),
        ("+proj=stere +lat_0=38 +lon_0=25", [30.0, 60.0]),
        ("+proj=stere +lat_0=90 +lon_0=0", [30.0, 60.0]),
        ("+proj=laea +lat_0=38 +lon_0=25", [30.0, 60.0]),
    ] {
        let projection: Projection = text.parse().unwrap();
        let at = DVec2::from(at);
        let latitude = at.y.to_radians();
        let ellipsoid = Ellipsoid::WGS84;
        let step = 1e-5_f64;
        let at_plane = projection.to_plane(at);
        let east = (projection.to_plane(at + DVec2::X * step) - at_plane)
            / (step.to_radians() * ellipsoid.radius * ellipsoid.parallel(latitude));
        let north = (projection.to_plane(at + DVec2::Y * step) - at_plane)
            / (step.to_radians() * ellipsoid.meridian_radius(latitude));
        if text.contains("laea") {
            assert!((east.perp_dot(north) - 1.0).abs() < 1e-5, "{text}");
        } else {
            assert!((east.length() - north.length()).abs() < 1e-5, "{text}");
            assert!(east.dot(north).abs() < 1e-5, "{text}");
            assert!((projection.scale(at) - north.length()).abs() < 1e-5, "{text}");
        }
    }
}

/// The region of some points.
fn region(points: &[[f64; 2]]) -> GlobeRegion {
    GlobeRegion::of(points.iter().copied().map(DVec2::from)).unwrap()
}

#[test]
fn a_region_has_a_projection_wherever_it_lies() {
    let aegean = region(&[[22.5, 35.5], [28.0, 40.5]]);
    let of = |region: &GlobeRegion| Projection::of_region(region).map(|it| it.to_string());
    assert_eq!(of(&aegean).unwrap(), "+proj=utm +zone=35 +datum=WGS84");
    assert_eq!(
        Projection::equal_area(&aegean).unwrap().to_string(),
        "+proj=laea +lat_0=38 +lon_0=25 +datum=WGS84"
    );
    // Across the antimeridian, around a pole, and too wide for a zone.
    let fiji = region(&[[177.0, -18.5], [-179.5, -16.0]]);
    assert_eq!(of(&fiji).unwrap(), "+proj=utm +zone=60 +south +datum=WGS84");
    let arctic = region(&[[0.0, 70.0], [90.0, 70.0], [180.0, 70.0], [-90.0, 70.0]]);
    let found = of(&arctic).unwrap();
    assert!(found.starts_with("+proj=stere +lat_0=90 "), "{found}");
    assert!(Projection::utm(&arctic).unwrap_err().contains("choose stereographic"));
    let mediterranean = region(&[[-6.0, 30.0], [36.0, 46.0]]);
    let found = of(&mediterranean).unwrap();
    assert!(
        found.starts_with("+proj=stere +lat_0=38.5 +lon_0=15 ")
            || found.starts_with("+proj=stere +lat_0="),
        "{found}"
    );
    let pacific = region(&[
        [120.0, -60.0],
        [-70.0, 60.0],
        [180.0, 0.0],
        [120.0, 60.0],
        [-70.0, -60.0],
        [10.0, 10.0],
    ]);
    let refused = of(&pacific).unwrap_err();
    assert!(refused.contains("choose a part of it"), "{refused}");
    assert_eq!(GlobeRegion::of([]), None);
}

#[test]
fn definitions_are_refused_with_what_to_give() {
    for (text, words) in [
        ("EPSG:2154", "ogr2ogr -t_srs EPSG:2154"),
        ("EPSG:x", "give a number, such as EPSG:32635"),
        ("+proj=utm", "needs a +zone"),
        ("+proj=utm +zone=61", "give one from 1 to 60"),
        ("+proj=merc", "give EPSG:32635 or the like"),
        ("+proj=laea +lat_0=91", "give a number from -90 to 90"),
        ("+proj=laea +ellps=bessel", "+ellps=bessel is not known here"),
        ("+proj=stere +lat_0=50 +lat_ts=70", "for a pole"),
        ("", "not a projection here"),
    ] {
        let error = text.parse::<Projection>().unwrap_err();
        assert!(error.contains(words), "{text}: {error}");
    }
}
