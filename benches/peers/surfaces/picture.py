"""The picture of docs/remesh.md: a part and its remesh, vertices with other degrees than 5 to 7 in red.

    picture.py BEFORE.obj AFTER.obj OUT.png
"""

import sys
from pathlib import Path

import numpy as np
import pyvista
from PIL import Image

from meshes import read_obj


def degrees(points, triangles):
    points, same = np.unique(points, axis=0, return_inverse=True)
    triangles = same.reshape(-1)[triangles]
    edges = np.sort(np.concatenate([triangles[:, pair] for pair in ([0, 1], [1, 2], [2, 0])]), axis=1)
    return points, triangles, np.bincount(np.unique(edges, axis=0).ravel(), minlength=len(points))


def main(before, after, out):
    plotter = pyvista.Plotter(off_screen=True, shape=(1, 2), window_size=(1400, 620), border=False)
    for column, path in enumerate([before, after]):
        points, triangles, degree = degrees(*read_obj(Path(path)))
        faces = np.hstack([np.full((len(triangles), 1), 3), triangles]).ravel()
        plotter.subplot(0, column)
        mesh = pyvista.PolyData(points, faces)
        plotter.add_mesh(mesh, color="#d9e2ec", show_edges=True, edge_color="#334155", line_width=0.6)
        wrong = points[(degree < 5) | (degree > 7)]
        if len(wrong):
            plotter.add_points(wrong, color="#dc2626", point_size=8, render_points_as_spheres=True)
        plotter.camera_position = [(1, -1.2, 0.8), (0, 0, 0), (0, 0, 1)]
        plotter.reset_camera()
        plotter.camera.zoom(1.4)
    plotter.set_background("white")
    image = Image.fromarray(plotter.screenshot(return_img=True)).crop((40, 110, 1360, 610))
    image.quantize(48).save(out, optimize=True)


main(*sys.argv[1:])
