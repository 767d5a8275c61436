"""Whatever is given, the answer is a result, or a fault of Python's with words: never a panic."""

import itertools

import mindeg
import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

FAULTS = (ValueError, TypeError, OverflowError, FileNotFoundError)
SQUARE = np.array([[0.0, 0], [2, 0], [2, 2], [0, 2]])
HALVES = np.array([[0, 1, 2], [0, 2, 3]])
# What is no array of points, or an unusual one.
ODD = [
    None,
    5,
    "text",
    b"bytes",
    object(),
    {},
    {"a": 1},
    [],
    [[]],
    [[], []],
    [1, 2, 3],
    [[1, 2], [3]],
    [["a", "b"]],
    [None, None],
    [[[0, 0], [1, 0], [0, 1]]],
    [[[[0, 0]]]],
    np.zeros(0),
    np.zeros((0, 2)),
    np.zeros((3, 0)),
    np.zeros((3, 1)),
    np.zeros((3, 4)),
    np.zeros((2, 2, 2, 2)),
    np.array(5.0),
    np.full((3, 2), np.nan),
    np.full((3, 2), np.inf),
    np.full((3, 2), 1e308),
    np.zeros((3, 2), complex),
    np.zeros((3, 2), bool),
    np.zeros((3, 2), object),
    np.zeros((3, 2), "U3"),
    np.zeros((3, 2), "datetime64[s]"),
    np.zeros((3, 2), np.float16),
    np.zeros((3, 2), np.longdouble),
    np.zeros(3, [("x", float), ("y", float)]),
    np.ma.masked_all((3, 2)),
    range(6),
    (x for x in range(3)),
]


def is_answered(call):
    """Whether the call gives something, or a fault in words."""
    try:
        call()
    except FAULTS as fault:
        assert str(fault), repr(fault)
    return True


@pytest.mark.parametrize("odd", ODD, ids=lambda odd: repr(odd)[:30])
def test_odd_things_in_place_of_arrays(odd):
    with np.errstate(all="ignore"):
        for call in (
            lambda: mindeg.Domain(odd).mesh(),
            lambda: mindeg.Domain([SQUARE, odd]).mesh(),
            lambda: mindeg.Mesh(odd, HALVES),
            lambda: mindeg.Mesh(SQUARE, odd),
            lambda: mindeg.inspect(odd, HALVES),
            lambda: mindeg.inspect(SQUARE, odd),
            lambda: mindeg.improve(odd, HALVES),
            lambda: mindeg.improve(SQUARE, odd),
            lambda: mindeg.fill_loop(odd),
            lambda: mindeg.bridge_loops(odd, SQUARE),
            lambda: mindeg.bridge_loops(SQUARE, odd),
            lambda: mindeg.fill_loop(SQUARE, external=odd),
            lambda: mindeg.fill_loop(SQUARE, excluded=odd),
            lambda: mindeg.polygon(odd, intervals=2),
            lambda: mindeg.polygon(SQUARE, holes=[odd], intervals=2),
            lambda: mindeg.polygon(SQUARE, intervals=odd),
            lambda: mindeg.rectangle(4, 3, intervals=2, names=odd),
            lambda: mindeg.rectangle(4, 3, intervals=2).mesh(interior=True, sizes=odd),
            lambda: mindeg.rectangle(4, 3, intervals=2).mesh(interior=True, fixed_points=odd),
            lambda: mindeg.rectangle(4, 3, intervals=2).mesh(interior=True, interior_degree=odd),
        ):
            assert is_answered(call)


NUMBERS = [0, 1, -1, 2**31, 2**32, 2**63, 2**64, 10**400, -(10**400), 0.5, 1e308, 5e-324]
NUMBERS += [float("nan"), float("inf"), -float("inf"), None, "3", 3j, True, np.float32(2), np.int8(-3)]


@pytest.mark.parametrize("odd", NUMBERS, ids=repr)
def test_odd_numbers(odd):
    domain = mindeg.rectangle(4, 3, intervals=3)
    for call in (
        # Counts in the billions are a formula, whose arrays nobody should ask for here.
        lambda: mindeg.rectangle(odd, 3, intervals=1),
        lambda: mindeg.rectangle(4, 3, intervals=odd),
        lambda: mindeg.rectangle(4, 3, intervals=[odd, 1, 1, 1]).degree(),
        lambda: mindeg.rectangle(4, 3, size=odd).degree() if odd != 5e-324 else None,
        lambda: domain.mesh(max_degree=odd),
        lambda: domain.mesh(keep_angle=odd),
        lambda: domain.mesh(interior=True, max_points=odd),
        lambda: domain.mesh(interior=True, growth=odd, max_points=2000),
        lambda: domain.mesh(interior=True, size_inside=odd, max_points=2000),
        lambda: domain.mesh(interior=True, target_angle=odd, max_points=2000),
        lambda: domain.mesh(interior=True, boundary_degree=odd, max_points=2000),
        lambda: domain.mesh(interior=True, interior_degree=(odd, odd), max_points=2000),
        lambda: domain.mesh(interior=True, prefer=odd, max_points=2000),
        lambda: domain.mesh(interior=True, sizes=[(odd, 1, 1)], max_points=2000),
        lambda: domain.mesh(interior=True, sizes=[(1, 1, odd)], max_points=2000),
        lambda: domain.mesh(interior=True, fixed_points=[(odd, 1)], max_points=2000),
        lambda: mindeg.inspect(SQUARE, HALVES, weld=odd),
        lambda: mindeg.inspect(SQUARE, HALVES, corner_angle=odd),
        lambda: mindeg.inspect(SQUARE, HALVES, poles_above=odd),
        lambda: mindeg.inspect(SQUARE, [[0, 1, odd]]),
        lambda: mindeg.fill_loop(SQUARE, max_degree=odd),
        lambda: mindeg.fill_loop(SQUARE, external=[odd] * 4),
        lambda: mindeg.fill_loop(SQUARE, excluded=[(0, odd)]),
        lambda: mindeg.bridge_loops(SQUARE, SQUARE + 1, max_degree=odd),
    ):
        assert is_answered(call)


@pytest.mark.parametrize("dtype", ["f4", "f8", ">f8", "f2", "i1", "u2", "i8", "u8", "g"])
def test_points_of_any_real_type_and_layout(dtype):
    points = (SQUARE * 2).astype(dtype)
    padded = np.zeros((8, 5), dtype)
    padded[::2, 1:4:2] = points
    frozen = points.copy()
    frozen.flags.writeable = False
    for same in (points, np.asfortranarray(points), padded[::2, 1:4:2], frozen, points.tolist()):
        assert np.array_equal(mindeg.Mesh(same, HALVES).points, SQUARE * 2)
        assert np.array_equal(mindeg.Domain(same).points, SQUARE * 2)
        assert mindeg.inspect(same, HALVES)["area"] == 16


@pytest.mark.parametrize("dtype", ["i1", "u1", ">i4", "u4", "i8", "u8"])
def test_triangles_of_any_integer_type_and_layout(dtype):
    triangles = HALVES.astype(dtype)
    padded = np.zeros((4, 6), dtype)
    padded[::2, ::2] = triangles
    frozen = triangles.copy()
    frozen.flags.writeable = False
    for same in (triangles, np.asfortranarray(triangles), padded[::2, ::2], frozen, triangles.tolist()):
        assert np.array_equal(mindeg.Mesh(SQUARE, same).triangles, HALVES)


@pytest.mark.parametrize(
    ("points", "triangles", "message"),
    [
        (SQUARE[:, :1], HALVES, "points has 1 columns; give (n, 2) or (n, 3) real numbers"),
        (SQUARE * 1j, HALVES, "points has the type complex128; give"),
        (SQUARE * np.nan, HALVES, "points[0] is not finite; give finite numbers"),
        (SQUARE[0], HALVES, "points has another number of axes than 2"),
        (SQUARE, HALVES[:, :2], "triangles has 2 columns; give (m, 3) indices from 0"),
        (SQUARE, HALVES * 0.5, "triangles has the type float64"),
        (SQUARE, HALVES - 1, "triangles has the index -1"),
        (SQUARE, HALVES + 2**32, "triangles has the index 4294967296"),
        (SQUARE, HALVES + 5, "vertex"),
        (SQUARE, [], "no triangle"),
    ],
)
def test_the_words_say_what_was_found_and_what_to_give(points, triangles, message):
    for call in (mindeg.Mesh, mindeg.inspect, mindeg.improve):
        with pytest.raises(ValueError, match=".") as raised:
            call(points, triangles)
        assert message in str(raised.value)


def test_options_for_outlines_are_checked(tmp_path):
    path = tmp_path / "square.wkt"
    path.write_text("POLYGON((0 0, 4 0, 4 3, 0 3), (1 1, 1 2, 2 2, 2 1))")
    assert len(mindeg.Domain(path, size=0.5).points) == 28 + 8
    for options, message in [
        ({"size": 0}, "size is 0; give a length above 0"),
        ({"size": np.nan}, "size is nan; give a finite number"),
        ({"corner_angle": 181}, "corner_angle is 181"),
        ({"feature": 2}, 'no polygon is "2"; give a name, or an index from 1 to 1: 1'),
    ]:
        with pytest.raises(ValueError, match=".") as raised:
            mindeg.Domain(path, **options)
        assert message in str(raised.value)
    with pytest.raises(TypeError, match="seize"):
        mindeg.Domain(path, seize=1)
    path.write_text("POLYGON((0 0, 4 x))")
    with pytest.raises(ValueError, match="square.wkt: line 1, column 17"):
        mindeg.Domain(path)
    with pytest.raises(OSError, match="missing.svg"):
        mindeg.Domain(tmp_path / "missing.svg")


def test_what_a_reader_leaves_out_is_a_warning(tmp_path):
    path = tmp_path / "mesh.msh"
    mindeg.rectangle(4, 3, intervals=2, names=["a", "b", "c", "d"]).mesh().save(path, ascii=True)
    with pytest.warns(UserWarning, match="left out 6 other elements"):
        domain = mindeg.Domain(path)
    assert len(domain.points) == 8


# Small coordinates, so that points often coincide or lie on a line.
COORDINATES = st.one_of(st.integers(-3, 3).map(float), st.floats(width=16))


@settings(max_examples=150, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(
    arrays.arrays(float, st.tuples(st.integers(0, 7), st.integers(1, 4)), elements=COORDINATES),
    arrays.arrays(
        np.int64, st.tuples(st.integers(0, 8), st.integers(2, 4)), elements=st.integers(-1, 8)
    ),
)
def test_meshes_of_any_arrays(points, triangles):
    try:
        mesh = mindeg.Mesh(points, triangles)
    except FAULTS as fault:
        assert str(fault)
        return
    assert np.array_equal(mesh.triangles, triangles)
    found = mindeg.inspect(points, triangles)
    assert found["triangles"] == len(triangles)
    edges = {
        tuple(sorted(pair))
        for corners in triangles.tolist()
        for pair in itertools.combinations(corners, 2)
        if pair[0] != pair[1]
    }
    if found["welded_vertices"] == 0:
        assert found["edges"] <= len(edges)
    assert is_answered(lambda: mindeg.improve(points, triangles, max_points=100))
    assert is_answered(mesh._repr_svg_)


@settings(max_examples=150, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(arrays.arrays(float, st.tuples(st.integers(0, 9), st.just(2)), elements=COORDINATES))
def test_domains_of_any_points(points):
    assert is_answered(lambda: mindeg.Domain(points).mesh(keep_angle=0.9))
    assert is_answered(lambda: mindeg.fill_loop(points))


JSON = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=5),
    lambda inner: st.lists(inner, max_size=4)
    | st.dictionaries(
        st.sampled_from(["polygon", "corners", "ring", "sides", "intervals", "size", "holes", "type"]),
        inner,
        max_size=4,
    ),
    max_leaves=15,
)


@settings(max_examples=150, deadline=None)
@given(st.dictionaries(st.sampled_from(["ring", "polygon", "rectangle", "sides", "size", "name"]), JSON))
def test_domains_of_any_dict(source):
    assert is_answered(lambda: mindeg.Domain(source))
