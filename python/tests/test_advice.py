"""The advice on a domain is that of the program, which `MINDEG` names."""

import json
import os
import subprocess
from pathlib import Path

import mindeg
import pytest

DOMAINS = Path(__file__).resolve().parents[2] / "assets" / "domains"


def test_advice_leads_to_the_meshes_that_it_tells_of():
    domain = mindeg.rectangle(4, 3, intervals=[12, 9, 4, 4])
    advice = domain.advice()
    assert advice["first"] == "solver"
    assert advice["patch"]["words"].startswith("For a patch that must keep its points, take degree 6: minimum angle 6.340°")
    for purpose in ("solver", "patch", "fewest"):
        mesh = domain.mesh(**advice[purpose]["options"])
        assert (mesh.max_degree, mesh.min_angle) == (advice[purpose]["max_degree"], pytest.approx(advice[purpose]["min_angle"]))
    with_points = mindeg.Domain({**json.loads(domain.to_json()), "interior": {}})
    assert with_points.mesh(**advice["fewest"]["options"]) == domain.mesh(optimize="angle")
    assert advice["no_solver"] is None


def test_where_no_points_can_be_inside_the_advice_says_why():
    few = {"rectangle": {"width": 4, "height": 3}, "size": 0.1, "interior": {"max_points": 50}}
    advice = mindeg.Domain(few).advice()
    assert (advice["first"], advice["solver"]) == ("patch", None)
    assert "more than 50 points" in advice["no_solver"]


def test_a_boundary_that_leaves_little_room_is_told_with_what_points_on_it_bring():
    domain = mindeg.Domain(DOMAINS / "boundary-layer-channel.json")
    advice = domain.advice()
    conditioned, changes = domain.condition()
    assert advice["points_on_edges"] == changes["inserted"] > 0
    mesh = conditioned.mesh(interior=True)
    assert mesh.min_angle == pytest.approx(advice["conditioned"]["min_angle"])
    assert mesh.min_angle > 2 * advice["solver"]["min_angle"]


@pytest.mark.skipif("MINDEG" not in os.environ, reason="MINDEG names no program")
@pytest.mark.parametrize("name", sorted(path.stem for path in DOMAINS.glob("*.json")))
def test_the_advice_is_that_of_the_program(name):
    def asked(*options):
        command = [os.environ["MINDEG"], "tradeoff", str(DOMAINS / f"{name}.json"), *options]
        return subprocess.run(command, check=True, capture_output=True, encoding="utf-8", timeout=100).stdout

    told = json.loads(asked("--json"))["advice"]
    advice = mindeg.Domain(DOMAINS / f"{name}.json").advice()
    for key in ("first", "conditioned", "points_on_edges"):
        assert advice[key] == told[key], key
    for purpose in ("solver", "patch", "fewest"):
        figures = {key: advice[purpose][key] for key in told[purpose]}
        assert figures == told[purpose], purpose
        assert asked("--for", purpose).endswith(f"\n{advice[purpose]['words']}\n"), purpose
