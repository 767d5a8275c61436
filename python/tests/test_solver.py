"""From a boundary that Gmsh drew to a solution: names of curves come through the whole way."""

import mindeg
import numpy as np
import pytest
import skfem
from skfem.helpers import dot, grad

# A plate with a slanted inlet, a curved wall and a round hole; the names of its curves.
CURVES = {"inlet": 1, "floor": 1, "outlet": 1, "wall": 1, "bore": 2}


@pytest.fixture(scope="module")
def boundary(tmp_path_factory):
    """What `gmsh -1` writes of it: nodes and line elements in physical groups."""
    import gmsh

    path = tmp_path_factory.mktemp("gmsh") / "plate.msh"
    gmsh.initialize(interruptible=False)
    try:
        gmsh.option.setNumber("General.Terminal", 0)
        geo = gmsh.model.geo
        points = [(0, 0), (6, 0), (6, 3), (1, 4), (3, 3.9), (2, 1.8), (3, 1.8), (4, 1.8)]
        a, b, c, d, top, left, middle, right = [geo.addPoint(x, y, 0, 0.4) for x, y in points]
        curves = {
            "floor": [geo.addLine(a, b)],
            "outlet": [geo.addLine(b, c)],
            "wall": [geo.addSpline([c, top, d])],
            "inlet": [geo.addLine(d, a)],
            "bore": [
                geo.addCircleArc(left, middle, right),
                geo.addCircleArc(right, middle, left),
            ],
        }
        geo.synchronize()
        for name, tags in curves.items():
            gmsh.model.addPhysicalGroup(1, tags, name=name)
        gmsh.model.mesh.generate(1)
        gmsh.write(str(path))
    finally:
        gmsh.finalize()
    return path


def test_a_gmsh_boundary_becomes_a_mesh_that_scikit_fem_solves_on(boundary, tmp_path):
    domain = mindeg.Domain(boundary)
    mesh = domain.mesh(interior=True, growth=0.3)
    assert np.array_equal(mesh.points[: len(domain.points)], domain.points)
    assert mesh.report["interior_points"] > 20
    path = tmp_path / "mesh.msh"
    mesh.save(path)

    plate = skfem.MeshTri.load(path)
    assert set(plate.boundaries) == set(CURVES)
    # A harmonic function, so the equation has no load: its value on the inlet and the bore, its flux through the
    # rest. Linear elements are off by the square of their size.
    error = poisson_error(plate, lambda x, y: x * x - y * y, lambda x, y: (2 * x, -2 * y))
    assert 0 < error < 0.02
    # What linear elements have exactly shows each boundary that is not where it should be.
    linear = poisson_error(plate, lambda x, y: x + 2 * y, lambda x, y: (1 + 0 * x, 2 + 0 * y))
    assert linear < 1e-9


def test_a_finer_boundary_gives_a_better_solution(boundary, tmp_path):
    errors = []
    for size in (0.4, 0.2, 0.1):
        path = tmp_path / f"{size}.msh"
        mindeg.Domain(boundary, size=size).mesh(interior=True).save(path)
        plate = skfem.MeshTri.load(path)
        error = poisson_error(plate, lambda x, y: x * x - y * y, lambda x, y: (2 * x, -2 * y))
        errors.append(error)
    # Half the size, a quarter of the error.
    assert errors[0] > 2.5 * errors[1] > 6.25 * errors[2], errors


def poisson_error(mesh, exact, gradient):
    """The largest error at a vertex, against the range of the solution."""
    element = skfem.ElementTriP1()
    basis = skfem.Basis(mesh, element)
    stiffness = skfem.BilinearForm(lambda u, v, _: dot(grad(u), grad(v))).assemble(basis)
    load = np.zeros(basis.N)
    for name in ("floor", "outlet", "wall"):
        facets = skfem.FacetBasis(mesh, element, facets=mesh.boundaries[name])
        flux = skfem.LinearForm(
            lambda v, w: sum(g * n for g, n in zip(gradient(*w.x), w.n, strict=True)) * v
        )
        load += flux.assemble(facets)
    values = exact(*mesh.p)
    known = basis.get_dofs(["inlet", "bore"]).all()
    solution = skfem.solve(*skfem.condense(stiffness, load, x=values, D=known))
    return np.abs(solution - values).max() / np.ptp(values)
