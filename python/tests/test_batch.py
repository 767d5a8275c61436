"""Batches on a local cluster: each output once, whole."""

import os

import mindeg
import pytest

distributed = pytest.importorskip("dask.distributed")


def test_every_domain_is_written_once_and_whole(tmp_path):
    from mindeg import batch

    side = [{"intervals": 3}] * 4
    sources = {
        f"plate-{width}": {"rectangle": {"width": width, "height": 3}, "sides": side}
        for width in range(1, 41)
    }
    sources["flat"] = {"rectangle": {"width": 1, "height": 0}, "sides": side}
    cluster = distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None)
    with cluster, distributed.Client(cluster) as client:
        outcomes = batch.mesh_files(client, sources, tmp_path, extension="ply", chunk=7)
    faults = {name: fault for name, fault in outcomes.items() if fault is not None}
    assert list(faults) == ["flat"] and "height" in faults["flat"]
    assert sorted(os.listdir(tmp_path)) == sorted(f"plate-{width}.ply" for width in range(1, 41))
    for width in range(1, 41):
        assert len(mindeg.read(tmp_path / f"plate-{width}.ply").triangles) == 10


def test_names_that_leave_the_folder_are_refused(tmp_path):
    from mindeg import batch

    with pytest.raises(ValueError, match="no file name"):
        batch.mesh_files(None, {"../x": {}}, tmp_path)
