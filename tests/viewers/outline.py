"""The outline of a domain, read from its JSON file without asking the program under test."""

import json
import math
from dataclasses import dataclass


@dataclass
class Outline:
    """What the viewers' readings are compared with: all of it follows from the domain file."""

    area: float
    perimeter: float
    # Smallest and largest x and y: ((x, y), (x, y)).
    bounds: tuple
    holes: int

    @property
    def extent(self):
        """The longer side of the bounding box."""
        (left, bottom), (right, top) = self.bounds
        return max(right - left, top - bottom)


def read_outline(domain_path):
    with open(domain_path, encoding="utf-8") as file:
        domain = json.load(file)
    outer, *holes = [ring_of(ring) for ring in (domain, *domain.get("holes", []))]
    xs, ys = zip(*outer)
    return Outline(
        area=area(outer) - sum(map(area, holes)),
        perimeter=sum(map(perimeter, (outer, *holes))),
        bounds=((min(xs), min(ys)), (max(xs), max(ys))),
        holes=len(holes),
    )


def area(ring):
    # Measured from the first corner: with survey coordinates in the millions, products
    # of the raw coordinates would cancel and lose the digits that are to be compared.
    first_x, first_y = ring[0]
    local = [(x - first_x, y - first_y) for x, y in ring]
    return abs(sum(ax * by - bx * ay for (ax, ay), (bx, by) in sides(local))) / 2


def perimeter(ring):
    return sum(math.dist(start, end) for start, end in sides(ring))


def sides(corners):
    return zip(corners, corners[1:] + corners[:1])


def ring_of(domain):
    """The points where the boundary turns: corners, and the points that divide an arc."""
    if "ring" in domain:
        return [tuple(point) for point in domain["ring"]]
    corners = corners_of(domain)
    given = domain.get("sides", [])
    given = given + [{}] * (len(corners) - len(given))
    ring = []
    for (start, end), side in zip(sides(corners), given):
        curves = {"bezier", "polyline", "points"} & side.keys()
        if curves:
            raise ValueError(f"the checks do not know the outline of a side with {curves.pop()}")
        ring += points_of_arc(start, end, side) if "arc" in side else [start]
    return ring


def points_of_arc(start, end, side):
    """The first corner and the points after it, which divide the arc evenly."""
    arc = side["arc"]
    if "spacing" in side or "intervals" not in side:
        raise ValueError("the checks need the intervals of an arc, and know no spacing on it")
    if "center" in arc:
        center, clockwise = arc["center"], arc.get("clockwise", False)
    else:
        center, clockwise = circle(start, arc["through"], end)
    first, last = (math.atan2(y - center[1], x - center[0]) for x, y in (start, end))
    turn = (first - last if clockwise else last - first) % math.tau
    # From a corner to itself is once around.
    turn = (turn if start != end else math.tau) * (-1 if clockwise else 1)
    radius = math.dist(start, center)
    angles = [first + turn * step / side["intervals"] for step in range(1, side["intervals"])]
    return [start] + [
        (center[0] + radius * math.cos(angle), center[1] + radius * math.sin(angle))
        for angle in angles
    ]


def circle(a, b, c):
    """The center of the circle through three points, and whether they run clockwise on it."""
    bx, by, cx, cy = b[0] - a[0], b[1] - a[1], c[0] - a[0], c[1] - a[1]
    cross = 2 * (bx * cy - by * cx)
    b2, c2 = bx * bx + by * by, cx * cx + cy * cy
    return (a[0] + (cy * b2 - by * c2) / cross, a[1] + (bx * c2 - cx * b2) / cross), cross < 0


def corners_of(domain):
    if "corners" in domain or "polygon" in domain:
        return [tuple(corner) for corner in domain.get("polygon", domain)["corners"]]
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
