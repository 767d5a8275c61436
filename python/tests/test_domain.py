"""Domains from what Python users have, and what they answer."""

import json
import pickle

import mindeg
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st


def test_the_degree_of_a_rectangle_is_proven():
    degree = mindeg.rectangle(4, 3, intervals=[12, 9, 4, 4]).degree()
    assert (degree.reached, degree.at_least, degree.is_proven) == (5, 5, True)


def test_keeping_the_angle_costs_one_degree():
    domain = mindeg.rectangle(4, 3, intervals=[12, 9, 4, 4])
    least, kept = domain.mesh(), domain.mesh(keep_angle=0.95)
    assert (least.max_degree, kept.max_degree) == (5, 6)
    assert least.min_angle == pytest.approx(5.528, abs=5e-4)
    assert kept.min_angle == pytest.approx(6.340, abs=5e-4)


def test_the_trade_off_ends_at_delaunay():
    points = mindeg.rectangle(4, 3, intervals=[10, 10, 10, 10]).tradeoff()
    assert [point.max_degree for point in points] == [4, 5]
    assert points[-1].share_of_limit == pytest.approx(1.0)
    assert points[0].mesh.max_degree == 4
    assert points[0].mesh.least_max_degree == 4 and all(point.is_proven for point in points)


def test_a_trade_off_round_holes_is_proven():
    squares = [[(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)] for x, y in [(1, 1), (4, 4), (4, 1)]]
    domain = mindeg.polygon([(0, 0), (6, 0), (6, 6), (0, 6)], holes=squares, intervals=1)
    assert (domain.degree().at_least, domain.degree().reached) == (6, 6)
    first = domain.tradeoff()[0]
    assert (first.max_degree, first.is_proven, first.mesh.found_by) == (6, True, "search")
    assert first.mesh.least_max_degree == 6
    assert [change.max_degree for change in domain.suggest()] == [5]


def test_a_trade_off_of_too_many_triangles_is_not_proven():
    angles = np.linspace(0, 2 * np.pi, 301)[:-1]
    radii = 100 - 0.01 * (np.arange(300) % 2)
    ring = np.column_stack([radii * np.cos(angles), radii * np.sin(angles)])
    first = mindeg.polygon(ring, holes=[[(1, 1), (2, 1), (1.5, 2)]], intervals=1).tradeoff()[0]
    assert (first.is_proven, first.mesh.found_by) == (False, "windows")
    assert first.mesh.least_max_degree is None


def test_suggestions_lower_the_degree():
    first = mindeg.rectangle(4, 3, intervals=[12, 9, 4, 4]).suggest()[0]
    assert (first.max_degree, first.changes, first.intervals) == (4, [(1, 2)], [12, 11, 4, 4])


def test_points_of_an_array_come_back_bit_for_bit():
    angles = np.linspace(0, 2 * np.pi, 17)[:-1]
    ring = np.column_stack([np.cos(angles), np.sin(angles)]) / 3
    domain = mindeg.Domain(ring)
    assert np.array_equal(domain.points, ring)
    assert domain.mesh().max_degree <= 4


def test_a_ring_of_shapely_is_a_polygon_with_and_without_options():
    shapely = pytest.importorskip("shapely")
    ring = shapely.LinearRing([(0, 0), (2, 0), (2, 2), (0, 2)])
    assert mindeg.Domain(ring) == mindeg.Domain(shapely.Polygon(ring))
    assert len(mindeg.Domain(ring, size=1).points) == 8


def test_lines_and_points_beside_a_polygon_lie_inside():
    shapely = pytest.importorskip("shapely")
    shapes = [shapely.box(0, 0, 4, 4), shapely.LineString([(1, 1), (2, 1)]), shapely.Point(3, 3)]
    for source in (shapes, shapely.GeometryCollection(shapes)):
        mesh = mindeg.Domain(source, size=1).mesh(interior=True)
        points = mesh.points[:, :2].tolist()
        ends = [points.index(end) for end in ([1, 1], [2, 1])]
        assert any(set(ends) <= set(triangle) for triangle in mesh.triangles.tolist())
        assert [3, 3] in points


def test_a_polygon_of_shapely_with_a_hole():
    shapely = pytest.importorskip("shapely")
    square = [(0, 0), (4, 0), (4, 4), (0, 4)]
    hole = [(1, 1), (2, 1), (2, 2), (1, 2)]
    mesh = mindeg.Domain(shapely.Polygon(square, [hole])).mesh()
    assert area(mesh) == pytest.approx(15)


def test_a_non_convex_polygon():
    corners = [(0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4)]
    domain = mindeg.polygon(corners, intervals=[13, 6, 6, 6, 6, 13])
    assert domain.degree().reached == 5
    assert area(domain.mesh()) == pytest.approx(12)


def test_a_domain_survives_pickling_and_json():
    domain = mindeg.rectangle(4, 3, size=0.5, names=["a", None, "c", None], name="plate")
    for other in (pickle.loads(pickle.dumps(domain)), mindeg.Domain(domain.to_json())):
        assert other.name == "plate"
        assert np.array_equal(other.points, domain.points)


def test_a_dict_may_hold_numpys_numbers():
    sides = [{"intervals": np.int64(2)}] * 4
    source = {"rectangle": {"width": np.float64(4), "height": 3}, "sides": sides}
    assert len(mindeg.Domain(source).points) == 8


def test_interior_points_keep_the_boundary_and_the_degrees():
    domain = mindeg.rectangle(4, 3, intervals=[12, 9, 4, 4])
    mesh = domain.mesh(interior=True, growth=0.4)
    assert np.array_equal(mesh.points[: len(domain.points)], domain.points)
    assert mesh.report["violations"] == []
    assert mesh.report["share_of_limit"] > 0.95
    assert area(mesh) == pytest.approx(12)


def test_improving_keeps_the_boundary():
    points = np.array([[0.0, 0], [2, 0], [2, 2], [0, 2], [0.1, 0.1]])
    mesh = mindeg.improve(points, [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]])
    assert mesh.min_angle > 44 > mesh.report["before"]["min_angle"]


def test_an_unknown_option_is_named():
    with pytest.raises(TypeError, match='no option is named "grow"; did you mean "growth"\\? the options are interior, preset, keep_angle,.* growth,'):
        mindeg.rectangle(4, 3, size=1).mesh(interior=True, grow=1)
    with pytest.raises(TypeError, match='did you mean "interior"'):
        mindeg.rectangle(4, 3, size=1).mesh(interiour=True)


def test_a_preset_asks_for_what_it_needs_as_on_the_command_line():
    mesh = mindeg.rectangle(4, 3, size=0.5).mesh(interior=True, preset="telemac")
    on_boundary = mesh.triangles < len(mindeg.rectangle(4, 3, size=0.5).points)
    assert not on_boundary.all(axis=1).any()


def test_comparing_gives_the_report():
    report = mindeg.rectangle(4, 3, intervals=[14, 3, 5, 2]).compare()
    assert len(report["methods"]) >= 3
    json.dumps(report)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: mindeg.rectangle(-1, 3, size=1), "width"),
        (lambda: mindeg.rectangle(4, 3, intervals=[1, 2, 3]), "found 3 intervals for 4 sides"),
        (lambda: mindeg.rectangle(4, 3), "either intervals or size"),
        (lambda: mindeg.rectangle(4, 3, size=1).mesh(keep_angle=200), "a share from 0 to 1"),
        (lambda: mindeg.rectangle(4, 3, size=1).mesh(optimize="angle", keep_angle=0.9), "exclude"),
        (lambda: mindeg.rectangle(4, 3, intervals=[12, 9, 4, 4]).mesh(max_degree=5, keep_angle=0.95), "maximum degree 6"),
        (lambda: mindeg.rectangle(4, 3, intervals=[9, 1, 1, 1]).mesh(max_degree=3), "3"),
        (lambda: mindeg.Domain({"type": "Point", "coordinates": [0, 0]}), "only lines or points"),
        (lambda: mindeg.Domain([[0, 0, 0], [1, 0, 0], [0, 1, 0]]), "give (n, 2)"),
        (lambda: mindeg.Domain('{"rectangle": {"width": 4}}'), "height"),
    ],
)
def test_faults_are_value_errors_that_say_what_to_do(make, message):
    with pytest.raises(ValueError, match=".*") as raised:
        make()
    assert message in str(raised.value)


@settings(max_examples=60, deadline=None)
@given(st.lists(st.integers(1, 9), min_size=3, max_size=6))
def test_meshes_of_regular_polygons_cover_them(counts):
    sides = len(counts)
    angles = 2 * np.pi * np.arange(sides) / sides
    corners = np.column_stack([np.cos(angles), np.sin(angles)])
    domain = mindeg.polygon(corners, intervals=counts)
    mesh = domain.mesh()
    assert len(mesh.triangles) == sum(counts) - 2
    assert area(mesh) == pytest.approx(sides / 2 * np.sin(2 * np.pi / sides))
    # The degrees, counted by numpy alone.
    edges = {tuple(sorted(edge)) for t in mesh.triangles.tolist() for edge in zip(t, t[1:] + t[:1])}
    degrees = np.bincount(np.array(sorted(edges)).ravel(), minlength=len(mesh.points))
    assert np.array_equal(degrees, mesh.degrees)
    assert degrees.max() == mesh.max_degree == mesh.least_max_degree


def area(mesh):
    """The sum of the signed areas, by numpy."""
    a, b, c = (mesh.points[mesh.triangles[:, corner]] for corner in range(3))
    return float(np.sum(np.cross(b - a, c - a)) / 2) if mesh.points.shape[1] == 3 else float(
        np.sum((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]) / 2
    )


def test_every_goal_has_a_python_type():
    from mindeg._options import GoalOptions

    goals = {goal["key"] for goal in mindeg.GOALS if goal["value"] != "nothing"}
    assert set(GoalOptions.__annotations__) == goals
    domain = mindeg.rectangle(4, 3, intervals=[12, 9, 4, 4])
    assert domain.mesh(optimize="angle").max_degree == 5
    with pytest.raises(TypeError, match="no option is named"):
        domain.mesh(minimise=3)


def frame():
    """Two plots side by side, and an island."""
    geopandas = pytest.importorskip("geopandas")
    shapely = pytest.importorskip("shapely")
    boxes = [shapely.box(0, 0, 2, 2), shapely.box(2, 0, 4, 2), shapely.box(6, 0, 7, 1)]
    return geopandas.GeoDataFrame({"use": ["wheat", "rye", "rye"]}, geometry=boxes)


def test_a_geodataframe_is_a_map_of_regions_named_by_a_column():
    domain = mindeg.Domain(frame().iloc[:2], name_by="use", size=0.5)
    mesh = domain.mesh(interior=True)
    assert set(mesh.groups) == {"wheat", "rye"}
    assert area(mesh) == pytest.approx(8)
    border = mesh.points[np.unique(mesh.lines["wheat | rye"])]
    assert sorted(map(tuple, border)) == [(2, 0), (2, 0.5), (2, 1), (2, 1.5), (2, 2)]


def test_sides_of_a_name_have_a_size_of_their_own():
    plots = frame().iloc[:2]
    domain = mindeg.Domain(plots, name_by="use", size=0.5, size_of={"wheat | rye": 0.25})
    assert len(np.unique(domain.mesh(interior=True).lines["wheat | rye"])) == 9
    for given, error, words in [
        ({"oats": 1}, ValueError, 'no side or line is called "oats"; there are '),
        ({"oats": -1}, ValueError, "size_of"),
        (0.25, TypeError, "give a dict of names and sizes"),
    ]:
        with pytest.raises(error, match=words):
            mindeg.Domain(plots, name_by="use", size_of=given)


def test_a_list_of_polygons_is_a_map_of_regions():
    polygons = list(frame().geometry[:2])
    features = [{"type": "Feature", "properties": {"name": name}, "geometry": one.__geo_interface__} for name, one in zip("ab", polygons)]
    for source, names in ((polygons, {"polygon 1", "polygon 2"}), (features, {"a", "b"})):
        mesh = mindeg.mesh(source, size=0.5, interior=True)
        assert set(mesh.groups) == names
        assert area(mesh) == pytest.approx(8)


def test_parts_of_a_map_that_do_not_hang_together_are_one_mesh():
    frames = frame()
    with pytest.raises(ValueError, match="has 3 polygons"):
        mindeg.Domain(frames, name_by="use")
    mesh = mindeg.mesh(frames, interior=True, name_by="use", size=0.5)
    assert area(mesh) == pytest.approx(9)
    sums = {name: area_of(mesh, triangles) for name, triangles in mesh.groups.items()}
    assert sums == pytest.approx({"wheat": 4, "rye": 5})
    assert mesh.report["violations"] == []


def area_of(mesh, triangles):
    """The area of some triangles, given by indices or by a range."""
    a, b, c = (mesh.points[mesh.triangles[triangles][:, corner]] for corner in range(3))
    return float(np.sum((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]) / 2)


def test_what_a_map_cannot_be_is_said():
    boxes = [[[[0, 0], [2, 0], [2, 2], [0, 2]]], [[[1, 1], [3, 1], [3, 3], [1, 3]]]]
    geometry = {"type": "MultiPolygon", "coordinates": boxes}
    overlap = {"type": "Feature", "properties": {"crop": "oats"}, "geometry": geometry}
    with pytest.raises(ValueError, match="there"):
        mindeg.mesh(overlap, interior=True)
    with pytest.warns(UserWarning, match="an area of 1, where polygons overlap"):
        mesh = mindeg.mesh(overlap, interior=True, repair=True, size=1)
    assert area(mesh) == pytest.approx(7)
    for options, message in [
        ({"snap": 0.1}, "snap is for repair=True alone"),
        ({"snap": -1.0, "repair": True}, "snap is -1; give a length above 0"),
        ({"layer": "states"}, "layer"),
        ({"sizes": lambda points: points[:, 0]}, "a function is for a single domain"),
        ({"name_by": "use"}, "no feature has the property"),
    ]:
        with pytest.raises(ValueError, match=".*") as raised:
            mindeg.mesh(overlap, interior=True, **options)
        assert message in str(raised.value), options
    with pytest.raises(TypeError, match="int is no domain"):
        mindeg.mesh(3)


def test_periodic_sides_come_as_pairs_of_vertices():
    domain = mindeg.Domain(
        {
            "rectangle": {"width": 4, "height": 3},
            "size": 0.5,
            "sides": [{}, {"name": "right", "match": {"of": "left"}}, {}, {"name": "left"}],
            "lines": [{"corners": [[2, 1.2], [4, 1.2]], "intervals": 4}],
        }
    )
    mesh = mindeg.mesh(domain, interior=True)
    assert list(mesh.periodic) == ["right"]
    here, there = mesh.periodic["right"].T
    assert len(here) == 7
    assert np.array_equal(mesh.points[here], mesh.points[there] + [4, 0])
    assert 1.2 in mesh.points[here, 1]
    assert pickle.loads(pickle.dumps(mesh)) == mesh
    assert mindeg.rectangle(1, 1, intervals=2).mesh().periodic == {}


def test_a_limit_of_the_degree_goes_with_the_largest_angle():
    domain = mindeg.rectangle(4, 3, intervals=[12, 9, 4, 4])
    limited = domain.mesh(max_degree=5, optimize="angle")
    assert limited == domain.mesh(max_degree=5)
    assert limited.max_degree == 5
    assert domain.mesh(max_degree=6, keep_angle=0.95).max_degree == 6
