"""Triangulates the boundary points on standard input with Triangle, and times it.

    python shewchuk.py LIMIT_IN_SECONDS < points > answer

Points are pairs of f64, counter-clockwise. The answer is the best time in seconds as an f64, then
the triangles' ids as i32s. All little-endian.
"""

import resource
import sys
import time

import numpy
from triangle.core import triang

# Past its limit the system ends the process, wherever it is.
limit = int(sys.argv[1])
resource.setrlimit(resource.RLIMIT_CPU, (limit, limit))

points = numpy.frombuffer(bytearray(sys.stdin.buffer.read())).reshape(-1, 2)
ids = numpy.arange(len(points), dtype=numpy.int32)
ring = numpy.stack([ids, numpy.roll(ids, -1)], axis=1)

times = []
while not times or (sum(times) < 0.3 and len(times) < 100):
    # The thread's time: once a process has a limit, its own is only kept by the tick.
    start = time.thread_time()
    # Quietly, ids from 0, within the given segments, and nothing back but the triangles.
    answer, _ = triang({"pointlist": points, "segmentlist": ring}, "QzpNPB")
    times.append(time.thread_time() - start)

sys.stdout.buffer.write(numpy.float64(min(times)).tobytes())
sys.stdout.buffer.write(answer["trianglelist"].astype(numpy.int32).tobytes())
