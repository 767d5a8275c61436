"""Coasts of Natural Earth (npm package world-atlas), clipped to a box of degrees: what is left is the sea."""

import json
from pathlib import Path

from shapely.geometry import Polygon, box, mapping
from shapely.ops import unary_union

BOXES = {"aegean": (22.5, 35.5, 28.0, 40.5), "saronic": (22.9, 37.1, 24.3, 38.1)}


def land(package: Path):
    """The polygons of land-10m.json, a TopoJSON with quantised arcs."""
    topology = json.loads((package / "land-10m.json").read_text())
    scale, translate = topology["transform"]["scale"], topology["transform"]["translate"]
    arcs = []
    for arc in topology["arcs"]:
        at, points = [0, 0], []
        for step in arc:
            at = [at[axis] + step[axis] for axis in (0, 1)]
            points.append(tuple(at[axis] * scale[axis] + translate[axis] for axis in (0, 1)))
        arcs.append(points)

    def ring(indices):
        points = []
        for index in indices:
            arc = arcs[index] if index >= 0 else arcs[~index][::-1]
            points += arc[1:] if points else arc
        return points

    for geometry in topology["objects"]["land"]["geometries"]:
        polygons = geometry["arcs"] if geometry["type"] == "MultiPolygon" else [geometry["arcs"]]
        for polygon in polygons:
            outer, *holes = [ring(indices) for indices in polygon]
            yield Polygon(outer, holes)


def sea(package: Path, name: str):
    """The largest part of the sea in a box, as a feature of GeoJSON."""
    around = box(*BOXES[name])
    parts = [polygon.buffer(0) for polygon in land(package) if polygon.envelope.intersects(around)]
    water = around.difference(unary_union(parts))
    largest = max(getattr(water, "geoms", [water]), key=lambda part: part.area)
    return {"type": "Feature", "properties": {"name": name}, "geometry": mapping(largest)}
