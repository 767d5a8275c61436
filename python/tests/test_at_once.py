"""``mindeg.mesh``: one call for what users have; and meshes as values: equal, drawn, told how far they are."""

import json
import pickle
import subprocess
import sys
from pathlib import Path

import mindeg
import numpy as np
import pytest

SQUARE = np.array([[0.0, 0], [4, 0], [4, 3], [0, 3]])
CLOSED = np.vstack([SQUARE, SQUARE[:1]])
HOLE = np.array([[1.0, 1], [1, 2], [2, 2], [2, 1]])
BRACKET = Path(__file__).resolve().parents[2] / "assets" / "models" / "bracket.obj"


def sources(tmp_path):
    """One square in all forms."""
    shapely = pytest.importorskip("shapely")
    geopandas = pytest.importorskip("geopandas")
    polygon = shapely.Polygon(SQUARE)
    path = tmp_path / "square.wkt"
    path.write_text(polygon.wkt)
    return [
        SQUARE,
        CLOSED,
        SQUARE.tolist(),
        [CLOSED],
        polygon,
        [polygon],
        shapely.MultiPolygon([polygon]),
        geopandas.GeoSeries([polygon]),
        geopandas.GeoDataFrame({"name": ["a"]}, geometry=[polygon]),
        polygon.__geo_interface__,
        path,
        str(path),
        mindeg.Domain(SQUARE, size=0.5),
    ]


def test_all_forms_of_a_square_give_one_mesh(tmp_path):
    for options in ({}, {"interior": True}, {"keep_angle": 0.95}):
        first = None
        for source in sources(tmp_path):
            reading = {} if isinstance(source, mindeg.Domain) else {"size": 0.5}
            mesh = mindeg.mesh(source, **reading, **options)
            points = sorted(map(tuple, mesh.points.tolist()))
            first = first or points
            # Readers of polygons begin and name them in their own ways; the points are the same.
            assert points == first, type(source)
            assert (mesh.report is not None) == ("interior" in options)


def test_a_domain_takes_what_its_users_have_with_a_size():
    shapely = pytest.importorskip("shapely")
    for source in (SQUARE, CLOSED, [SQUARE, HOLE], shapely.Polygon(SQUARE, [HOLE])):
        domain = mindeg.Domain(source, size=0.25)
        assert len(domain.points) in (56, 56 + 16)
    assert len(mindeg.Domain(CLOSED).points) == 4


def test_polygons_apart_are_one_mesh_with_and_without_points_inside():
    shapely = pytest.importorskip("shapely")
    islands = shapely.MultiPolygon([shapely.box(0, 0, 2, 2), shapely.box(5, 0, 6, 1)])
    for interior in (None, True):
        mesh = mindeg.mesh(islands, size=0.5, interior=interior)
        assert len(mesh.points) == (16 + 8 if interior is None else len(mesh.points))
        a, b, c = (mesh.points[mesh.triangles[:, corner]] for corner in range(3))
        area = np.sum((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]) / 2
        assert area == pytest.approx(5)
    assert mindeg.mesh(islands, size=0.5).least_max_degree == 4
    with pytest.raises(ValueError, match="fixed_points are for a single domain"):
        mindeg.mesh(islands, size=0.5, interior=True, fixed_points=[[1, 1]])


def test_a_ring_that_crosses_itself_is_one_mesh_of_its_parts():
    shapely = pytest.importorskip("shapely")
    bow = [[0, 0], [4, 4], [4, 0], [0, 4]]
    with pytest.warns(UserWarning, match="made 2 polygons of 1"):
        meshes = [mindeg.mesh(source, size=1, repair=True) for source in (bow, np.array(bow), shapely.Polygon(bow))]
    assert [len(mesh.points) for mesh in meshes] == [20] * 3
    with pytest.raises(ValueError, match='points: no polygon is "3"; give a name, or an index from 1 to 2'):
        mindeg.mesh(bow, size=1, repair=True, feature=3)
    with pytest.raises(ValueError, match="repair is for points, polygons and files"):
        mindeg.mesh(mindeg.rectangle(4, 3, size=1), repair=True)


def test_a_model_is_one_watertight_mesh(tmp_path):
    mesh = mindeg.mesh(BRACKET, size=4)
    assert mindeg.inspect(mesh)["boundary_edges"] == 0
    assert (mesh.report["faces"], mesh.report["max_degree"]) == (32, mesh.max_degree)
    inside = mindeg.mesh(BRACKET, size=4, interior=True)
    assert inside.report["interior_points"] > 0 and len(inside.points) > len(mesh.points)
    cube = {
        "corners": [[i & 1, i >> 1 & 1, i >> 2] for i in range(8)],
        "faces": [{"corners": face} for face in ([0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5])],
        "size": 0.5,
    }
    path = tmp_path / "cube.json"
    path.write_text(json.dumps(cube))
    assert mindeg.mesh(cube) == mindeg.mesh(path) and len(mindeg.mesh(cube, size=0.25).points) > 26
    box = mindeg.Mesh(cube["corners"], [t for f in cube["faces"] for t in ([*f["corners"][:3]], [f["corners"][0], *f["corners"][2:]])])
    assert len(mindeg.mesh(box, size=0.5, merge_coplanar=True).points) == 20
    with pytest.raises(ValueError, match="give the size of the edges"):
        mindeg.mesh(box)
    with pytest.raises(ValueError, match="no readable domain|faces|model"):
        mindeg.Domain(cube)


def test_the_json_of_a_domain_decides_unless_the_caller_does(tmp_path):
    domain = {"rectangle": {"width": 4, "height": 3}, "size": 0.5, "interior": {"growth": 0.4}}
    path = tmp_path / "plate.json"
    path.write_text(json.dumps(domain))
    for mesh in (mindeg.mesh(domain), mindeg.mesh(path), mindeg.Domain(domain).mesh()):
        assert len(mesh.points) > 28 and mesh.report is not None
    for mesh in (mindeg.mesh(domain, interior=False), mindeg.mesh(path, interior=False)):
        assert len(mesh.points) == 28


def test_the_rules_of_a_program_must_be_kept(tmp_path):
    fan = {"rectangle": {"width": 4, "height": 3}, "sides": [{"intervals": n} for n in (30, 1, 1, 1)]}
    path = tmp_path / "fan.json"
    path.write_text(json.dumps(fan))
    cup = mindeg.Mesh([(0, 0, 0), (4, 0, 0), (4, 3, 0), (0, 3, 0)], [(0, 1, 2), (0, 2, 3)])
    broken = r"preset swan: vertex \d+ at \(.*\) has \d+ triangles, above 10.* \(counted from 0\)"
    for call in (mindeg.Domain(fan).mesh, lambda **rules: mindeg.mesh(fan, **rules), lambda **rules: mindeg.mesh(path, **rules)):
        with pytest.raises(ValueError, match=broken):
            call(preset="swan")
        assert call(preset="adcirc") == call()
        with pytest.raises(ValueError, match='preset is "roms"; give one of adcirc'):
            call(preset="roms")
    with pytest.raises(ValueError, match="preset sms: .*angle"):
        mindeg.mesh(cup, size=0.1, effort=0.1, preset="sms")
    assert mindeg.mesh(SQUARE, size=0.5, interior=True, preset="swan").report["violations"] == []
    corner = mindeg.Mesh([(0, 0, 0), (9, 0, 0), (9, 0.3, 0)], [(0, 1, 2)])
    for call in (mindeg.improve, lambda mesh, **rules: mindeg.remesh(mesh, keep_boundary=True, **rules)):
        with pytest.raises(ValueError, match=r"preset sms: triangle 0 at \(.*\) has angles from 1.909°"):
            call(corner, preset="sms")
        assert call(corner, preset="adcirc") == call(corner)
        with pytest.raises(ValueError, match='preset is "roms"; give one of adcirc'):
            call(corner, preset="roms")


@pytest.mark.parametrize(
    ("options", "fault", "message"),
    [
        ({"growth": 0.3}, ValueError, "growth is for meshes with points inside; give interior=True"),
        ({"interior": True, "keep_angle": 0.9}, ValueError, "keep_angle is for meshes of boundary points alone"),
        ({"interior": {"growth": 0.3}}, TypeError, "interior is .*give True or False"),
        ({"groth": 0.3}, TypeError, 'no option is named "groth"; did you mean "growth"\\? the options are'),
        ({"optimize": "angle", "keep_angle": 0.9}, ValueError, "exclude each other"),
        ({"effort": "much"}, TypeError, "."),
    ],
)
def test_options_without_a_meaning_are_refused_by_name(options, fault, message, tmp_path):
    path = tmp_path / "square.wkt"
    path.write_text("POLYGON((0 0, 4 0, 4 3, 0 3))")
    for source in (SQUARE, path) if "effort" not in options else (path,):
        with pytest.raises(fault, match=message):
            mindeg.mesh(source, size=1, **options)


def test_faults_name_arguments_and_never_lines():
    two = [[0, 0], [1, 1]]
    crossing = [[0, 0], [4, 3], [4, 0], [0, 3]]
    for call, start in [
        (lambda: mindeg.Domain(two), "points: "),
        (lambda: mindeg.Domain([SQUARE, two]), "rings[1]: "),
        (lambda: mindeg.Domain(crossing), "points[2]: "),
        (lambda: mindeg.rectangle(0, 3, size=1), "width: "),
        (lambda: mindeg.rectangle(4, -3, size=1), "height: "),
        (lambda: mindeg.rectangle(4, 3, intervals=[1, 0, 1, 1]), "intervals[1]: "),
        (lambda: mindeg.polygon(crossing, size=1), "corners: "),
        (lambda: mindeg.polygon(SQUARE, holes=[[[1, 1], [2, 2]]], size=1), "holes[0]: "),
        (lambda: mindeg.Domain({"rectangle": {"width": 4, "hight": 3}, "size": 1}), "rectangle.hight: "),
        (lambda: mindeg.Domain({"ring": crossing}), "ring[2]: "),
        (lambda: mindeg.mesh(two), "points: "),
    ]:
        with pytest.raises(ValueError, match=".") as raised:
            call()
        said = str(raised.value)
        assert said.startswith(start) and "line 1" not in said and "column" not in said, said
    # A text that the user wrote has lines.
    with pytest.raises(ValueError, match="line 2, column"):
        mindeg.Domain('{"rectangle": {"width": 4,\n "hight": 3}, "size": 1}')


def test_meshes_and_domains_with_equal_parts_are_equal(tmp_path):
    domain = mindeg.rectangle(4, 3, intervals=2, names=["a", "b", "c", "d"])
    mesh = domain.mesh()
    assert mesh == domain.mesh() == pickle.loads(pickle.dumps(mesh))
    assert hash(mesh) == hash(domain.mesh()) and len({mesh, domain.mesh()}) == 1
    assert mesh != mindeg.Mesh(mesh.points, mesh.triangles)
    assert mesh != mindeg.rectangle(4, 3, intervals=2, names=["a", "b", "c", "x"]).mesh()
    assert mesh != domain.mesh(interior=True) and mesh != 3 and (mesh == None) is False  # noqa: E711
    assert domain == mindeg.Domain(domain) == pickle.loads(pickle.dumps(domain))
    assert hash(domain) == hash(mindeg.Domain(domain.to_json()))
    assert domain != mindeg.rectangle(4, 3, intervals=3) and domain != mesh
    mesh.save(tmp_path / "m.msh")
    assert mindeg.read(tmp_path / "m.msh") == mindeg.read(tmp_path / "m.msh")


def test_a_mesh_is_drawn_with_its_lines_and_values():
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    mesh = mindeg.rectangle(4, 3, size=0.5, names=["a", "b", "c", "d"]).mesh(interior=True)
    axes = mesh.plot()
    assert {line.get_label() for line in axes.lines} >= {"a", "b", "c", "d"}
    assert [text.get_text() for text in axes.get_legend().get_texts()] == ["a", "b", "c", "d"]
    _, own = plt.subplots()
    assert mesh.plot(own, values=mesh.degrees) is own and len(own.figure.axes) == 2
    mesh.plot(values=np.arange(len(mesh.triangles)))
    with pytest.raises(ValueError, match="give .* one for each vertex"):
        mesh.plot(values=[1, 2, 3])
    solid = mindeg.mesh(BRACKET, size=10)
    assert solid.plot(values=solid.degrees).name == "3d"
    plt.close("all")


def test_progress_is_told_and_what_it_raises_cancels():
    domain = mindeg.rectangle(40, 30, size=0.1)
    steps = []
    with mindeg.progress(lambda *step: steps.append(step)):
        domain.mesh(interior=True)
    assert steps and all(isinstance(stage, str) and done <= total for stage, done, total in steps)

    class Enough(Exception):
        pass

    def enough(*_):
        raise Enough

    with pytest.raises(Enough), mindeg.progress(enough):
        domain.mesh(interior=True)
    count = len(steps)
    mindeg.rectangle(4, 3, size=0.1).mesh(interior=True)
    assert len(steps) == count


def test_importing_takes_little_and_leaves_numpy_for_later():
    code = "import time; t = time.process_time(); import mindeg; print(time.process_time() - t); import sys; print('numpy' in sys.modules)"
    runs = [subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split() for _ in range(3)]
    assert min(float(seconds) for seconds, _ in runs) < 0.1
    assert {has_numpy for _, has_numpy in runs} == {"False"}
