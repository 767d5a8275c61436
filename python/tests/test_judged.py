"""Verdicts on meshes, and holes closed and joined."""

import mindeg
import numpy as np
import pytest

CUBE = [[i & 1, i >> 1 & 1, i >> 2] for i in range(8)]
QUADS = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]


def halves(quads):
    return [half for a, b, c, d in quads for half in ([a, b, c], [a, c, d])]


def test_a_mesh_is_verified_against_its_domain():
    domain = mindeg.rectangle(4, 3, intervals=[12, 9, 4, 4])
    mesh = domain.mesh()
    found = mindeg.verify(mesh, domain, optimal=True)
    assert found["passed"] and found["optimal"] == "yes" and found["failed"] == [] and "file" not in found
    found = mindeg.verify(domain.mesh(keep_angle=0.95), domain, optimal=True, max_degree=4, keep_angle=0.99, target_angle=30)
    assert not found["passed"] and len(found["failed"]) == 3
    assert mindeg.verify(mesh, domain, keep_angle="99%")["failed"] == mindeg.verify(mesh, domain, keep_angle=0.99)["failed"] != []
    for wrong in ("99", 99):
        with pytest.raises(ValueError, match="keep_angle.*(a share from 0 to 1|write 0.99)"):
            mindeg.verify(mesh, domain, keep_angle=wrong)
    moved = mindeg.Mesh(mesh.points + [0.1, 0], mesh.triangles)
    found = mindeg.verify(moved, domain)
    assert not found["valid"] and found["defect"]["kind"] == "no_vertex"
    assert mindeg.verify(domain.mesh(interior=True), domain)["interior_points"] > 0


def test_a_remesh_is_verified_against_its_part():
    part = mindeg.Mesh(CUBE, halves(QUADS))
    mesh = mindeg.remesh(part, size=0.25)
    assert mindeg.verify(mesh, part, keep_features=False)["to_part"]["at_most"] < 1e-6
    assert mindeg.verify(mesh, part, target_angle=20)["passed"]
    found = mindeg.verify(mesh, mindeg.Mesh(np.array(CUBE) * 1.5, halves(QUADS)), tolerance=0.1)
    assert not found["passed"] and found["failed"]


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda d, m: mindeg.verify(d, m), "mesh is a Domain; swap the two"),
        (lambda d, m: mindeg.verify(m, 3), "of is a int"),
        (lambda d, m: mindeg.verify(m, d, keep_boundary=True), "are for a part"),
        (lambda d, m: mindeg.verify(m, m, optimal=True), "are for a Domain"),
        (lambda d, m: mindeg.verify(m, d, tolerance=-1), "tolerance is -1"),
        (lambda d, m: mindeg.verify(m, d, preset="swam"), 'preset is "swam"; give one of .*swan, '),
        (lambda d, m: mindeg.inspect(m, preset="x"), "give one of .*swan"),
        (lambda d, m: mindeg.inspect(m, target_angle=61), "target_angle is 61"),
    ],
)
def test_a_question_without_meaning_is_refused(call, message):
    domain = mindeg.rectangle(4, 3, size=1)
    with pytest.raises(ValueError, match=message):
        call(domain, domain.mesh())


def test_the_rules_of_programs_are_checked():
    assert {"swan", "fvcom", "sms"} <= set(mindeg.PRESETS)
    corners = [(np.cos(a), np.sin(a)) for a in 2 * np.pi * np.arange(12) / 12]
    fan = mindeg.Mesh([(0, 0), *corners], [[0, 1 + i, 1 + (i + 1) % 12] for i in range(12)])
    assert mindeg.inspect(fan)["failed"] == []
    failed = mindeg.inspect(fan, preset="fvcom", max_degree=11, target_angle=40)["failed"]
    assert len(failed) == 3 and failed[2] == "preset fvcom: vertex 0 at (0, 0) has 12 triangles, above 8; mindeg improve makes it 5 to 7 inside"


def test_holes_are_closed_and_the_new_triangles_named():
    open_box = mindeg.Mesh(CUBE, halves(QUADS[2:]))
    closed = mindeg.fill(open_box)
    assert mindeg.inspect(closed)["boundary_edges"] == 0
    assert [len(closed.groups["fill"]), len(closed.triangles)] == [4, 12]
    assert len(closed.report["filled"]) == 2 and closed.report["left_open"] == []
    one = mindeg.fill(open_box.points, open_box.triangles, through=[0])
    assert len(one.groups["fill"]) == 2
    with pytest.raises(ValueError, match="no boundary loop through vertex 99"):
        mindeg.fill(open_box, through=[99])
    with pytest.raises(ValueError, match="it is closed"):
        mindeg.fill(closed)
    with pytest.raises(ValueError, match="extra_area is -1"):
        mindeg.fill(open_box, extra_area=-1)


def test_the_rim_of_a_flat_sheet_stays_open_unless_it_is_named():
    sheet = mindeg.rectangle(4, 3, intervals=[4, 3, 4, 3]).mesh(interior=True)
    with pytest.raises(ValueError, match="rim of a flat sheet"):
        mindeg.fill(sheet)
    assert len(mindeg.fill(sheet, through=[0]).groups["fill"]) == 12


def test_loops_of_one_mesh_or_of_two_are_joined():
    angles = lambda count: 2 * np.pi * np.arange(count) / count
    cup = lambda count, z, tip: mindeg.Mesh(
        [*((np.cos(a), np.sin(a), z) for a in angles(count) * np.sign(tip)), (0, 0, tip)],
        [[i, (i + 1) % count, count] for i in range(count)],
    )
    joined = mindeg.bridge(cup(8, 1, 2), cup(5, -1, -2))
    assert mindeg.inspect(joined)["boundary_edges"] == 0 and len(joined.groups["bridge"]) == 13
    assert joined.report["max_degree"] == 6
    top, bottom = cup(8, 1, 2), cup(5, -1, -2)
    both = mindeg.Mesh([*top.points, *bottom.points], [*top.triangles, *(bottom.triangles + len(top.points))])
    with pytest.raises(ValueError, match="has 0 boundary loops, and 2 are expected"):
        mindeg.bridge(mindeg.Mesh(CUBE, halves(QUADS)))
    assert len(mindeg.bridge(both).groups["bridge"]) == 13
    assert mindeg.bridge(both, through=(9, 0)).report["from"]["vertices"] == 5
    with pytest.raises(ValueError, match="the mesh has no boundary loop through vertex 50"):
        mindeg.bridge(both, through=(0, 50))


def test_ends_far_apart_are_bridged_with_points_between():
    turn = 2 * np.pi * np.arange(16) / 16
    rings = [np.c_[np.cos(turn), np.sin(turn), np.full(16, height)] for height in (0, 0.4, 5, 5.4)]
    index = np.arange(16)
    tube = [[a, b, a + 16] for a, b in zip(index, np.roll(index, -1))] + [[b, b + 16, a + 16] for a, b in zip(index, np.roll(index, -1))]
    both = mindeg.Mesh(np.concatenate(rings), [*tube, *(np.array(tube) + 32)])
    plain, joined = (mindeg.bridge(both, through=(16, 32), interior=interior) for interior in (False, True))
    assert plain.min_angle < 6 and joined.min_angle > 30
    least, most = joined.report["degrees"]
    assert 5 <= least and most <= 7 and joined.report["violations"] == []
    assert len(joined.groups["bridge"]) > 200 and len(joined.points) > 160


def test_a_boundary_is_conditioned():
    strait = mindeg.Domain([[0, 0], [10, 0], [10, 0.5], [0, 0.5]])
    domain, changes = strait.condition()
    assert isinstance(domain, mindeg.Domain) and changes["is_reached"] and changes["moved"] == 0
    assert len(domain.points) == changes["points"] > 4
    assert domain.mesh(interior=True).report["min_angle"] > 25
    step = mindeg.Domain([[0, 0], [5, 0], [5, 0.01], [10, 0.01], [10, 10], [0, 10]])
    assert step.condition(within=0.02)[1]["dropped"] == 1
    assert step.condition(size=2, limit=20)[1]["moved"] <= 0.25
    _, coarse = strait.condition(size=2)
    fine, changes = strait.condition(size=2, across=4, min_size=0.1)
    assert changes["points"] > 2 * coarse["points"]
    lengths = np.linalg.norm(np.diff(fine.points, axis=0), axis=1)
    assert lengths.max() <= 4 / 3 * 0.25
    assert strait.condition(size=2, sizes=[[0, 0, 0.1]])[1]["points"] > coarse["points"]
    assert strait.condition(size=2, sizes=lambda at: np.full(len(at), 0.3))[1]["points"] > coarse["points"]
    assert step.condition(preset="telemac")[1]["points"] > 0
    with pytest.raises(ValueError, match="across"):
        strait.condition(across=0)
    with pytest.raises(ValueError, match='no side "nix" to keep'):
        strait.condition(keep="nix")
    with pytest.raises(ValueError, match="at most 40"):
        strait.condition(limit=50)


def test_meshes_are_stitched():
    square = lambda x: mindeg.polygon([(x, 0), (x + 3, 0), (x + 3, 3), (x, 3)], size=0.5).mesh(interior=True)
    meshes = [square(0), square(4)]
    area = mindeg.Domain([[2.9, 0.3], [4.1, 0.3], [4.1, 2.7], [2.9, 2.7]])
    both = mindeg.stitch(meshes, within=area)
    assert both.report["new_triangles"] == len(both.groups["stitch"]) > 5
    assert (both.triangles[: len(meshes[0].triangles)] == meshes[0].triangles).all()
    assert mindeg.inspect(both)["boundary_loops"] == 1 and both.report["violations"] == []
    with pytest.raises(ValueError, match="stays apart"):
        mindeg.stitch(meshes, within=mindeg.Domain([[2.9, 0.3], [3.5, 0.3], [3.5, 2.7], [2.9, 2.7]]))
