"""Triangulates rings with Triangle, and times it.

Standard input has the numbers of points and of holes, the points, a point in each hole, and the edges. The
answer is the best time in seconds, then the triangles.
"""

import sys
import time

import numpy
from triangle.core import triang

numbers = sys.stdin.read().split()
count, holes = int(numbers[0]), int(numbers[1])
places = numpy.array(numbers[2 : 2 + 2 * (count + holes)], dtype=float).reshape(-1, 2)
edges = numpy.array(numbers[2 + 2 * (count + holes) :], dtype=numpy.int32).reshape(-1, 2)
given = {"pointlist": places[:count], "segmentlist": edges}
if holes:
    given["holelist"] = places[count:]
times = []
while not times or (sum(times) < 0.1 and len(times) < 20):
    start = time.thread_time()
    # Quietly, ids from 0, within the given segments, and nothing back but the triangles.
    answer, _ = triang(given, "QzpNPB")
    times.append(time.thread_time() - start)
print(min(times))
print(*answer["trianglelist"].ravel().tolist())
