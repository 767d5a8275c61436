"""Faults speak of the arguments of Python, and help() shows their types."""

import inspect

import mindeg
import pytest

SQUARE = [[0, 0], [4, 0], [4, 3], [0, 3]]


@pytest.mark.parametrize(
    ("words", "options"),
    [
        (r"^fixed_points\[1\]: .*leaves the domain near \(9, 9\)", {"interior": True, "fixed_points": [[1, 1], [9, 9]]}),
        (r"^fixed_points\[\d\]: .*same point", {"interior": True, "fixed_points": [[1, 1], [1, 1]]}),
        (r"^sizes\[0\]: size 0 is 0", {"interior": True, "sizes": [[1, 1, 0]]}),
        (r"^growth is -1;", {"interior": True, "growth": -1}),
        (r"^max_degree is the text 5; give a whole number", {"max_degree": "5"}),
    ],
)
def test_options_are_named(words, options):
    with pytest.raises(ValueError, match=words):
        mindeg.mesh(SQUARE, size=0.5, **options)


def test_points_are_named():
    for ragged in ([[0, 0], [4, 0], [4, 3, 1], [0, 3]], [[0, 0], [4], [4, 3], [0, 3]]):
        with pytest.raises(ValueError, match=r"^points has rows of different lengths; give \(n, 2\)"):
            mindeg.Domain(ragged)
    with pytest.raises(ValueError, match=r"^points: .*the same point \(4, 0\)"):
        mindeg.mesh([[0, 0], [4, 0], [4, 0], [4, 3], [0, 3]], size=0.5)


def test_what_is_empty_is_named():
    geopandas = pytest.importorskip("geopandas")
    for make in (mindeg.Domain, mindeg.mesh):
        with pytest.raises(ValueError, match="^the GeoDataFrame is empty; give at least one polygon"):
            make(geopandas.GeoDataFrame(geometry=[]), size=0.5)


@pytest.mark.parametrize("function", ["bridge", "bridge_loops", "fill", "fill_loop", "inspect", "read", "remesh", "stitch", "verify"])
def test_help_shows_types(function):
    function = getattr(mindeg, function)
    signature = inspect.signature(function)
    assert all(parameter.annotation is not parameter.empty for parameter in signature.parameters.values())
    assert signature.return_annotation is not signature.empty and function.__doc__
    assert "'" not in str(signature).replace("'none'", "")


def test_what_the_package_offers_is_what_it_says():
    offered = {name for name in dir(mindeg) if not name.startswith("_")}
    assert offered - {"batch"} == set(mindeg.__all__) - {"__version__"}


def test_the_types_are_those_of_the_stub():
    assert str(inspect.signature(mindeg.Mesh)) == "(points: ArrayLike, triangles: ArrayLike, name: str | None = None) -> Mesh"
    assert str(inspect.signature(mindeg.fill)) == (
        "(points: Mesh | ArrayLike, triangles: ArrayLike | None = None, *, interior: bool = False, "
        "through: Sequence[int] | None = None, max_degree: int | None = None, extra_area: float = 0.05, max_loop: int = 500) -> Mesh"
    )
