"""What users have in hand is taken as it is meant, or refused by its name: never silently another thing."""

import inspect
import json
import pickle
import re

import mindeg
import numpy as np
import pytest

SQUARE = np.array([[0.0, 0], [4, 0], [4, 3], [0, 3]])
HALVES = [[0, 1, 2], [0, 2, 3]]


@pytest.fixture
def mesh():
    return mindeg.rectangle(4, 3, intervals=2, names=["a", "b", "c", "d"]).mesh()


def refusal(call):
    with pytest.raises(ValueError, match=".") as raised:
        call()
    return str(raised.value)


def test_a_mesh_cannot_be_changed_behind_its_back(mesh):
    """`points *= 1000` once scaled what was pickled, and neither what was saved nor the angles."""
    domain = mindeg.Domain(SQUARE)
    read_only = [mesh.points, mesh.triangles, mesh.degrees, *mesh.lines.values(), domain.points]
    copied = pickle.loads(pickle.dumps(mesh))
    for array in [*read_only, copied.points, copied.triangles]:
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 1
        with pytest.raises(ValueError, match="."):
            array.flags.writeable = True
    assert mesh.points.max() == 4 and mesh.points.copy().flags.writeable


@pytest.mark.parametrize("wrong", [2.9, "3", True, np.bool_(True), np.float64(2.5), float("nan"), [1, 2.9, 1, 1]])
def test_intervals_are_whole_numbers(wrong):
    """2.9 was silently 2."""
    said = refusal(lambda: mindeg.rectangle(4, 3, intervals=wrong))
    assert said.startswith("intervals[1] is 2.9" if isinstance(wrong, list) else "intervals is "), said
    assert "give a whole number" in said


@pytest.mark.parametrize("right", [2, np.int8(2), np.uint64(2), np.float32(2), np.array(2), [2] * 4, np.full(4, 2)])
def test_whole_numbers_of_any_type_are_intervals(right):
    assert len(mindeg.rectangle(4, np.float16(3), intervals=right).points) == 8


def test_a_number_that_is_none_is_refused_by_its_key():
    """NaN was "line 1, column 25: this is not a JSON value"."""
    nan, infinite = float("nan"), np.float32("inf")
    for key, call in [
        ("width", lambda: mindeg.rectangle(nan, 1, intervals=1)),
        ("height", lambda: mindeg.rectangle(1, infinite, intervals=1)),
        ("width", lambda: mindeg.rectangle("4", 1, intervals=1)),
        ("width", lambda: mindeg.rectangle(np.ma.masked, 1, intervals=1)),
        ("size", lambda: mindeg.rectangle(4, 1, size=nan)),
        ("size", lambda: mindeg.rectangle(4, 1, size=True)),
        ("rectangle.width", lambda: mindeg.Domain({"rectangle": {"width": nan, "height": 1}, "size": 1})),
        ("holes[0].ring[0][0]", lambda: mindeg.Domain({"ring": SQUARE, "holes": [{"ring": SQUARE * nan}]})),
        ("sides[1].spacing.geometric.ratio", lambda: mindeg.Domain(
            {"rectangle": {"width": 1, "height": 1}, "size": 1, "sides": [{}, {"spacing": {"geometric": {"ratio": nan}}}, {}, {}]})),
        ("points[2]", lambda: mindeg.Domain([[0, 0], [1, 0], [1, nan]])),
        ("corners[0]", lambda: mindeg.polygon([[nan, 0], [1, 0], [1, 1]], intervals=1)),
        ("holes[0][3]", lambda: mindeg.polygon(SQUARE, holes=[[[1, 1], [2, 1], [2, 2], [nan, 1]]], size=1)),
        ("points[1]", lambda: mindeg.Mesh([[0, 0], [1, nan], [1, 1]], [[0, 1, 2]])),
        ("sizes[0][2]", lambda: mindeg.Domain(SQUARE).mesh(interior=True, sizes=[(1, 1, nan)])),
        ("fixed_points[1][0]", lambda: mindeg.Domain(SQUARE).mesh(interior=True, fixed_points=[(1, 1), (nan, 1)])),
    ]:
        said = refusal(call)
        assert said.startswith((f"{key} is ", f"{key} has ")) and "finite number" in said, said


def test_a_mask_is_never_ignored():
    masked = np.ma.array(SQUARE, mask=SQUARE == 3)
    for call in (
        lambda: mindeg.Domain(masked),
        lambda: mindeg.Domain(list(masked)),
        lambda: mindeg.polygon(masked, intervals=1),
        lambda: mindeg.Domain({"ring": masked}),
        lambda: mindeg.Mesh(masked, HALVES),
        lambda: mindeg.Mesh(SQUARE, np.ma.array(HALVES, mask=[[0, 0, 1], [0, 0, 0]])),
        lambda: mindeg.inspect(masked, HALVES),
        lambda: mindeg.fill_loop(masked),
        lambda: mindeg.rectangle(4, 3, intervals=np.ma.array([1, 2, 3, 4], mask=[0, 0, 1, 0])),
    ):
        assert "masked" in refusal(call)
    # A mask that hides nothing changes nothing.
    whole = np.ma.array(SQUARE, mask=False)
    assert len(mindeg.Domain(whole).points) == len(mindeg.Mesh(whole, HALVES).points) == 4


@pytest.mark.parametrize("dtype", ["f2", "f4", ">f8", "i1", "u2", "i8", "g"])
def test_points_of_any_real_type_and_layout_are_the_same_domain(dtype):
    given = np.zeros((8, 5), dtype)
    given[::2, 1:4:2] = SQUARE
    assert np.array_equal(mindeg.Domain(given[::2, 1:4:2]).points, SQUARE)
    sides = {"polygon": {"corners": given[::2, 1:4:2]}, "size": given.dtype.type(1)}
    assert len(mindeg.Domain(sides).points) == 14


def test_a_closed_ring_of_an_array_is_the_open_one():
    """Files and shapely repeat the first point; an array that did was refused."""
    closed = np.vstack([SQUARE, SQUARE[:1]])
    hole = [[1, 1], [1, 2], [2, 2], [2, 1], [1, 1]]
    assert np.array_equal(mindeg.Domain(closed).points, SQUARE)
    assert len(mindeg.Domain([closed, hole]).points) == 8
    assert len(mindeg.polygon(closed, intervals=[2, 1, 1, 1]).points) == 5
    assert len(mindeg.polygon(closed, holes=[hole], intervals=2).points) == 16


def test_interior_takes_arrays_and_numpys_numbers():
    domain = mindeg.rectangle(4, 3, intervals=8)
    sizes, points = np.array([[2, 1, 0.1]], "f4"), np.array([[1, 1], [3, 2]])
    mesh = domain.mesh(interior=True, sizes=sizes, fixed_points=points, growth=np.float32(0.5), interior_degree=np.array([5, 7]))
    assert np.array_equal(mesh.points[32:34], points)
    plain = domain.mesh(interior=True, sizes=[(2, 1, float(np.float32(0.1)))], fixed_points=[(1, 1), (3, 2)], growth=0.5)
    assert np.array_equal(plain.points, mesh.points)
    assert len(domain.mesh(interior=True, sizes=[], fixed_points=[]).points) > 32


def test_options_are_in_the_signatures():
    """They were **options, of which neither help() nor an editor knew one."""
    options = {"growth", "size_inside", "interior_degree", "boundary_degree", "target_angle"}
    options |= {"prefer", "sizes", "fixed_points", "max_points"}
    for function in (mindeg.mesh, mindeg.Domain.mesh, mindeg.improve):
        assert options <= set(inspect.signature(function).parameters)
    for function in (mindeg.Domain, mindeg.inspect):
        assert "corner_angle" in inspect.signature(function).parameters


def test_a_mesh_in_hand_is_inspected_and_improved(mesh):
    assert mindeg.inspect(mesh) == mindeg.inspect(mesh.points, mesh.triangles)
    better = mindeg.improve(mesh, prefer="angle")
    assert better.min_angle >= mesh.min_angle
    # Beyond what its arrays tell.
    assert list(better.lines) == ["a", "b", "c", "d"]
    for function in (mindeg.inspect, mindeg.improve):
        for call in (lambda: function(mesh, mesh.triangles), lambda: function(mesh.points)):
            assert "give a mesh, or points and triangles" in refusal(call)


@pytest.mark.parametrize("share", [0.95, "95%", " 95 %", "0.95", np.float32(0.95), np.float64(0.95)])
def test_an_angle_is_kept_as_the_command_line_keeps_it(share):
    assert mindeg.rectangle(4, 3, intervals=[12, 9, 4, 4]).mesh(keep_angle=share).max_degree == 6


@pytest.mark.parametrize("wrong", [95, -0.1, float("nan"), "95 of 100", True, "", [0.95]])
def test_a_share_that_is_none_is_refused(wrong):
    said = refusal(lambda: mindeg.rectangle(4, 3, size=1).mesh(keep_angle=wrong))
    assert said.startswith("keep_angle: ") and ("give a share from 0 to 1" in said or "write 0.95" in said), said


def test_points_and_polygons_are_divided_and_repaired_like_files():
    """These options were "for a path to a file only"."""
    shapely = pytest.importorskip("shapely")
    plate = shapely.Polygon(SQUARE, [[[1, 1], [1, 2], [2, 2], [2, 1]]])
    for source in (plate, [SQUARE, np.array(plate.interiors[0].coords)], plate.__geo_interface__):
        domain = mindeg.Domain(source, size=0.5, name="plate")
        assert (len(domain.points), domain.name) == (28 + 8, "plate")
    assert len(mindeg.Domain(SQUARE, size=1).points) == 14
    # A turn of 90° is no corner within 120°: one side all round.
    assert len(mindeg.Domain(SQUARE, size=1, corner_angle=120).mesh().lines) == 1
    touching = [[0, 0], [2, 0], [2, 2], [4, 2], [4, 4], [2, 2], [0, 2]]
    with pytest.raises(ValueError, match="repair mends such places"):
        mindeg.Domain(touching, corner_angle=30)
    star = [[0, 3], [2, -3], [-3, 1], [3, 1], [-2, -3]]
    assert len(mindeg.Domain(star, repair=True, fill_rule="nonzero").points) == 10
    assert "5 polygons" in refusal(lambda: mindeg.Domain(star, repair=True, fill_rule="evenodd"))
    assert "fill_rule" in refusal(lambda: mindeg.Domain(star, fill_rule="evenodd"))
    # The sea between a land and an island, and what is no box.
    lands = shapely.MultiPolygon([shapely.box(-1, -1, 1, 5), shapely.box(2, 1, 3, 2)])
    assert len(mindeg.Domain(lands, sea_in=(0, 0, 4, 3)).points) == 8
    assert "give west, south, east and north" in refusal(lambda: mindeg.Domain(lands, sea_in=(0, 0, 4)))
    assert "lower left corner first" in refusal(lambda: mindeg.Domain(lands, sea_in=(4, 0, 0, 3)))
    two = shapely.MultiPolygon([plate, shapely.box(10, 0, 11, 1)])
    assert "2 polygons; choose one with feature" in refusal(lambda: mindeg.Domain(two))
    assert len(mindeg.Domain(two, feature=2).points) == 4
    assert len(mindeg.Domain(two, feature=np.int64(2), size=np.float32(0.5)).points) == 8


def test_options_that_mean_nothing_say_what_to_do():
    plate = mindeg.rectangle(4, 3, size=1)
    for source in (plate, plate.to_json(), {"rectangle": {"width": 4, "height": 3}, "size": 1}):
        said = refusal(lambda: mindeg.Domain(source, size=0.5))
        assert said.startswith("size is for ") and "JSON" in said, said
    shapely = pytest.importorskip("shapely")
    assert "empty" in refusal(lambda: mindeg.Domain(shapely.Polygon()))
    assert "no Polygon or MultiPolygon" in refusal(lambda: mindeg.Domain(shapely.Point(1, 2)))


def test_the_version_is_that_of_the_crate():
    assert mindeg.__version__.count(".") == 2


def test_an_index_too_large_is_told_as_it_is():
    """2^63 and more were called negative."""
    said = refusal(lambda: mindeg.Mesh(SQUARE, np.array([[0, 1, 2**63 + 5]], "u8")))
    assert "the index 9223372036854775813" in said


@pytest.mark.parametrize("dtype", [np.float16, np.float32, np.int8])
def test_an_archive_of_any_type_of_numbers_is_read(dtype, tmp_path):
    points = np.array([[0, 0], [4, 0], [4, 3], [0, 3]])
    np.savez(tmp_path / "m.npz", points=points.astype(dtype), triangles=np.array([[0.0, 1, 2], [0, 2, 3]]))
    found = mindeg.read(tmp_path / "m.npz")
    assert (found.points[:, :2] == points).all() and found.triangles.tolist() == [[0, 1, 2], [0, 2, 3]]
    np.savez(tmp_path / "m.npz", points=points.astype(dtype), triangles=np.array([[0.0, 1, 2.5]]))
    assert "triangles[0, 2]: is 2.5" in refusal(lambda: mindeg.read(tmp_path / "m.npz"))


def test_a_surface_is_meshed_anew():
    corners = [[i & 1, i >> 1 & 1, i >> 2] for i in range(8)]
    quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
    triangles = [t for a, b, c, d in quads for t in ([a, b, c], [a, c, d])]
    cube = mindeg.remesh(corners, triangles, size=0.25, tolerance=0)
    assert cube.degrees.min() >= 5 and cube.degrees.max() <= 7
    assert cube.report["from_part"]["at_most"] < 1e-7 and cube.report["corners"] == 8
    assert mindeg.remesh(cube, vertices=100, keep_features=True).report["curves"] == 12
    with pytest.raises(ValueError, match="not both"):
        mindeg.remesh(corners, triangles, size=1, vertices=9)
    with pytest.raises(ValueError, match="3 triangles share an edge"):
        mindeg.remesh(corners, triangles + [[0, 3, 4]])


def test_only_what_says_so_is_taken_for_degrees(recwarn):
    """A plate of 100 by 50 is no coast; GeoJSON and a geographic CRS are one."""
    geopandas, shapely = pytest.importorskip("geopandas"), pytest.importorskip("shapely")
    plate = 25 * SQUARE
    for source in (plate, shapely.Polygon(plate), geopandas.GeoSeries([shapely.Polygon(plate)])):
        mindeg.Domain(source, size=5)
    parts = shapely.MultiPolygon([shapely.Polygon(plate), shapely.box(200, 0, 300, 50)])
    mindeg.mesh(parts, size=5)
    assert [str(warning.message) for warning in recwarn] == []
    sea = shapely.box(20, 35, 21, 36)
    degrees = geopandas.GeoSeries([sea], crs="EPSG:4326")
    with pytest.warns(UserWarning, match="project auto makes metres"):
        mindeg.Domain(degrees, size=0.1)
    for source in (degrees, sea, sea.__geo_interface__):
        metres = np.ptp(mindeg.Domain(source, size=5000, project="auto").points, axis=0)
        assert 85_000 < metres[0] < 95_000 and 105_000 < metres[1] < 115_000
    assert "project: " in refusal(lambda: mindeg.Domain(degrees, size=5000, project="mercator"))


def test_the_crs_of_a_frame_is_the_projection_of_its_domain(tmp_path):
    """It was passed over, so that a frame in metres had no place on the globe."""
    geopandas, shapely = pytest.importorskip("geopandas"), pytest.importorskip("shapely")
    sea = shapely.box(236_000, 4_208_000, 326_000, 4_318_000)
    own = "+proj=laea +lat_0=38 +lon_0=25 +datum=WGS84"
    for crs, projection, note in [
        ("EPSG:32635", "+proj=utm +zone=35 +datum=WGS84", "is EPSG:32635: metres, by UTM zone 35 north"),
        ("EPSG:3035", "+proj=laea +lat_0=52 +lon_0=10 +x_0=4321000 +y_0=3210000 +ellps=GRS80", "is EPSG:3035: metres"),
        (own, own, "metres, by Lambert's equal-area projection about 25° E, 38° N"),
        ("EPSG:2100", None, "is EPSG:2100, which is not known here"),
        ("ESRI:54009", None, "is \"ESRI:54009\", which is not known here"),
    ]:
        for source in (geopandas.GeoSeries([sea], crs=crs), geopandas.GeoDataFrame(geometry=[sea], crs=crs)):
            with pytest.warns(UserWarning, match=re.escape(note)):
                domain = mindeg.Domain(source, size=20_000)
            assert json.loads(domain.to_json()).get("projection") == projection
            # The same at once.
            with pytest.warns(UserWarning, match=re.escape(note)):
                mindeg.mesh(source, size=20_000, interior=True).save(tmp_path / "sea.14")
            x = float((tmp_path / "sea.14").read_text().splitlines()[2].split()[1])
            assert (abs(x) <= 180) == (projection is not None)
    with pytest.raises(ValueError, match="projected already"):
        mindeg.Domain(geopandas.GeoSeries([sea], crs="EPSG:32635"), project="laea")


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"size": "2km"}, "size is '2km'; give a finite number"),
        ({"snap": [1], "repair": True}, r"snap is \[1\]; give a finite number"),
        ({"corner_angle": "x"}, "corner_angle is 'x'; give a finite number"),
        ({"repair": "yes"}, "repair is 'yes'; give True or False"),
        ({"layer": 3}, "layer is 3; give a text"),
        ({"project": 5}, "project is 5; give a text"),
    ],
)
def test_options_of_another_type_are_refused_by_their_names(options, message):
    for make in (mindeg.Domain, mindeg.mesh):
        with pytest.raises((TypeError, ValueError), match=f"^{message}$"):
            make(SQUARE, **options)
    with pytest.raises(ValueError, match=r"^fixed_points: give \(n, 2\)"):
        mindeg.mesh(SQUARE, size=1, interior=True, fixed_points=[1, 2])


def test_files_in_degrees_get_degrees_of_a_projected_domain(tmp_path):
    shapely = pytest.importorskip("shapely")
    sea = shapely.box(20, 35, 21, 36)
    mesh = mindeg.Domain(sea, size=20_000, project="auto").mesh(interior=True)
    assert mesh.points[:, 0].min() > 1000
    at_once = mindeg.mesh(sea.__geo_interface__, size=20_000, project="auto", interior=True)
    boxes = [sea, shapely.box(23, 35, 24, 36)]
    apart = [mindeg.mesh(boxes, size=50_000, project="auto", interior=inside) for inside in (False, True)]
    of_domain = mindeg.Domain(sea, size=20_000, project="auto").tradeoff()[0].mesh
    for made in (mesh, at_once, *apart, of_domain, mindeg.improve(mesh), pickle.loads(pickle.dumps(mesh))):
        made.save(tmp_path / "sea.14")
        x, y = (tmp_path / "sea.14").read_text().splitlines()[2].split()[1:3]
        assert 20 <= float(x) <= 24 and 35 <= float(y) <= 36, (x, y)
    mesh.save(tmp_path / "sea.vtu")
    assert mindeg.read(tmp_path / "sea.vtu").points[:, 0].min() > 1000


def test_what_is_no_mesh_is_named(mesh):
    with pytest.raises(TypeError, match=r"^first is a str; give a mindeg.Mesh, which mindeg.read makes of a file$"):
        mindeg.bridge("part.obj")
    with pytest.raises(TypeError, match=r"^meshes\[1\] is a int"):
        mindeg.stitch([mesh, 3])
    with pytest.raises(ValueError, match=r"mindeg.read makes a mesh of a file$"):
        mindeg.inspect("part.obj")


def test_sides_too_coarse_for_their_sizes_are_told():
    square = mindeg.Domain(np.array([(0, 0), (1, 0), (1, 1), (0, 1)]))
    with pytest.warns(UserWarning, match=r"never divided, and too coarse .* make the domain with size=0.01") as told:
        square.mesh(interior=True, sizes=[(0.5, 0.01, 0.01)])
    assert told[0].filename == __file__
