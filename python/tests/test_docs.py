"""What users are shown: every recipe of docs/python.md, and the notebook."""

import json
import re
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
NOTEBOOK = ROOT / "python" / "examples" / "first-mesh.ipynb"


def test_every_recipe_runs(tmp_path, monkeypatch):
    text = (ROOT / "docs" / "python.md").read_text(encoding="utf-8")
    recipes = re.findall(r"^```python\n(.*?)^```", text, re.DOTALL | re.MULTILINE)
    assert len(recipes) == 10
    monkeypatch.chdir(tmp_path)
    # The boundary that recipe 8 has from Gmsh.
    gmsh_boundary(tmp_path / "outline.msh")
    names = {}
    for number, recipe in enumerate(recipes, 1):
        exec(compile(recipe, f"recipe {number}", "exec"), names)
        if number == 1:
            assert (names["mesh"].max_degree, round(names["mesh"].min_angle, 2)) == (6, 6.34)
        if number == 3:
            assert np.array_equal(names["plate"].points, names["ring"].points)
        if number == 5:
            assert names["domain"].suggest()[0].intervals == [12, 11, 4, 4]
    # Between two walls at 0 and 3 under a load of 1, the middle reaches 9/8.
    assert 1.1 < names["u"].max() < 1.13
    assert names["better"].min_angle > 20
    assert len(list((tmp_path / "meshes").glob("part-*.msh"))) == 27


def test_the_page_of_the_package_runs(tmp_path, monkeypatch):
    text = (ROOT / "python" / "README.md").read_text(encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    names = {}
    for example in re.findall(r"^```python\n(.*?)^```", text, re.DOTALL | re.MULTILINE):
        exec(compile(example, "python/README.md", "exec"), names)
    assert names["mesh"].report["violations"] == [] and Path("part.msh").exists()
    assert len(names["plate"].points) == 8


def test_the_notebook_runs_and_shows_pictures(tmp_path):
    import nbformat
    from nbclient import NotebookClient

    source = json.loads(NOTEBOOK.read_text(encoding="utf-8"))
    cells = [cell for cell in source["cells"] if cell["cell_type"] == "code"]
    # Outputs would be a second, older truth in every change.
    assert all(not cell["outputs"] and cell["execution_count"] is None for cell in cells)

    copy = shutil.copy(NOTEBOOK, tmp_path)
    notebook = nbformat.read(copy, as_version=4)
    NotebookClient(notebook, timeout=120, resources={"metadata": {"path": str(tmp_path)}}).execute()
    outputs = [out for cell in notebook.cells for out in cell.get("outputs", [])]
    pictures = [out.data["image/svg+xml"] for out in outputs if "image/svg+xml" in out.get("data", {})]
    assert len(pictures) == 3
    assert all("<svg" in picture and "maximum degree" in picture for picture in pictures)


def gmsh_boundary(path):
    """A rectangle of 4 by 3 whose floor and roof have names, by `gmsh -1`."""
    import gmsh

    gmsh.initialize(interruptible=False)
    try:
        gmsh.option.setNumber("General.Terminal", 0)
        geo = gmsh.model.geo
        corners = [geo.addPoint(x, y, 0, 0.25) for x, y in [(0, 0), (4, 0), (4, 3), (0, 3)]]
        sides = [geo.addLine(a, b) for a, b in zip(corners, corners[1:] + corners[:1])]
        geo.synchronize()
        for name, side in zip(["floor", "right", "roof", "left"], sides):
            gmsh.model.addPhysicalGroup(1, [side], name=name)
        gmsh.model.mesh.generate(1)
        gmsh.write(str(path))
    finally:
        gmsh.finalize()


def test_the_import_takes_numpy_alone():
    """What an import loads is what it takes: `import mindeg` stays below 100 ms."""
    script = (
        "import sys, numpy\n"
        "before = set(sys.modules)\n"
        "import mindeg\n"
        "print(*sorted({name.split('.')[0] for name in set(sys.modules) - before}))"
    )
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    loaded = set(done.stdout.split())
    # Parts of numpy that numpy itself loads late.
    assert loaded <= {"mindeg", "numpy", *sys.stdlib_module_names}, loaded
    assert not loaded & {"concurrent", "multiprocessing", "urllib", "asyncio"}, loaded
