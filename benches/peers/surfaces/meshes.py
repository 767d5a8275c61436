"""Meshes in files."""

import numpy as np


def read_off(path):
    words = path.read_text().split("OFF", 1)[1]
    words = " ".join(line.split("#")[0] for line in words.splitlines()).split()
    count, faces = int(words[0]), int(words[1])
    points = np.array(words[3 : 3 + 3 * count], dtype=float).reshape(-1, 3)
    triangles, at = [], 3 + 3 * count
    for _ in range(faces):
        size = int(words[at])
        corners = [int(word) for word in words[at + 1 : at + 1 + size]]
        triangles += [[corners[0], corners[i], corners[i + 1]] for i in range(1, size - 1)]
        at += 1 + size
    return points, np.array(triangles)


def read_obj(path):
    points, triangles = [], []
    for line in path.read_text().splitlines():
        words = line.split()
        if words[:1] == ["v"]:
            points.append([float(word) for word in words[1:4]])
        elif words[:1] == ["f"]:
            triangles.append([int(word.split("/")[0]) - 1 for word in words[1:4]])
    return np.array(points), np.array(triangles)


def write_obj(path, points, triangles):
    with path.open("w") as file:
        file.writelines(f"v {x!r} {y!r} {z!r}\n" for x, y, z in np.asarray(points, dtype=float).tolist())
        file.writelines(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in np.asarray(triangles).tolist())
