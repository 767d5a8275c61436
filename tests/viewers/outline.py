"""The outline of a domain, read from its JSON file without asking the program under test."""

import json
import math
from dataclasses import dataclass


@dataclass
class Outline:
    """What the viewers' readings are compared with: all of it follows from the corners."""

    area: float
    perimeter: float
    # Smallest and largest x and y: ((x, y), (x, y)).
    bounds: tuple

    @property
    def extent(self):
        """The longer side of the bounding box."""
        (left, bottom), (right, top) = self.bounds
        return max(right - left, top - bottom)


def read_outline(domain_path):
    with open(domain_path, encoding="utf-8") as file:
        corners = corners_of(json.load(file))
    # Measured from the first corner: with survey coordinates in the millions, products
    # of the raw coordinates would cancel and lose the digits that are to be compared.
    first_x, first_y = corners[0]
    local = [(x - first_x, y - first_y) for x, y in corners]
    sides = list(zip(local, local[1:] + local[:1]))
    xs, ys = zip(*corners)
    return Outline(
        area=abs(sum(ax * by - bx * ay for (ax, ay), (bx, by) in sides)) / 2,
        perimeter=sum(math.dist(start, end) for start, end in sides),
        bounds=((min(xs), min(ys)), (max(xs), max(ys))),
    )


def corners_of(domain):
    if "polygon" in domain:
        return [tuple(corner) for corner in domain["polygon"]["corners"]]
    rectangle = domain["rectangle"]
    width, height = rectangle["width"], rectangle["height"]
    origin_x, origin_y = rectangle.get("origin", (0, 0))
    # The origin is the first corner; the rotation turns the plate around it.
    turn = math.radians(rectangle.get("rotation", 0))
    return [
        (
            origin_x + x * math.cos(turn) - y * math.sin(turn),
            origin_y + x * math.sin(turn) + y * math.cos(turn),
        )
        for x, y in ((0, 0), (width, 0), (width, height), (0, height))
    ]
