"""Boulders: a few shapes to be placed many times over, turned and stretched."""
import numpy as np

from . import shape


def icosphere(level):
    g = (1 + 5**0.5) / 2
    p = [
        (-1, g, 0),
        (1, g, 0),
        (-1, -g, 0),
        (1, -g, 0),
        (0, -1, g),
        (0, 1, g),
        (0, -1, -g),
        (0, 1, -g),
        (g, 0, -1),
        (g, 0, 1),
        (-g, 0, -1),
        (-g, 0, 1),
    ]
    t = [
        (0, 11, 5),
        (0, 5, 1),
        (0, 1, 7),
        (0, 7, 10),
        (0, 10, 11),
        (1, 5, 9),
        (5, 11, 4),
        (11, 10, 2),
        (10, 7, 6),
        (7, 1, 8),
        (3, 9, 4),
        (3, 4, 2),
        (3, 2, 6),
        (3, 6, 8),
        (3, 8, 9),
        (4, 9, 5),
        (2, 4, 11),
        (6, 2, 10),
        (8, 6, 7),
        (9, 8, 1),
    ]
    p = [np.array(v) / np.linalg.norm(v) for v in p]
    for _ in range(level):
        middle, finer = {}, []
        for a, b, c in t:
            m = []
            for i, j in ((a, b), (b, c), (c, a)):
                key = (min(i, j), max(i, j))
                if key not in middle:
                    v = p[i] + p[j]
                    middle[key] = len(p)
                    p.append(v / np.linalg.norm(v))
                m.append(middle[key])
            finer += [(a, m[0], m[2]), (b, m[1], m[0]), (c, m[2], m[1]), tuple(m)]
        t = finer
    return np.array(p), np.array(t)


def boulder(seed, color, level=2):
    """About 1 m across, cut flat by random planes as broken rock is."""
    rng = np.random.default_rng(seed)
    p, t = icosphere(level)
    normals = rng.normal(size=(11, 3))
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    for n, reach in zip(normals, rng.uniform(0.58, 0.85, 11)):
        beyond = np.maximum(p @ n - reach, 0)
        p = p - beyond[:, None] * n
    p = p * rng.uniform(0.82, 1.1, 3) * np.array([0.58, 0.45, 0.52])
    p = p * (1 + rng.normal(scale=0.018, size=(len(p), 1)))
    shade = 0.72 + 0.28 * np.clip(p[:, 1:2] / 0.35 + 0.45, 0, 1)
    tint = rng.normal(scale=0.05, size=(len(p), 1))
    uv = np.stack([p[:, 0] + 0.4 * p[:, 1], p[:, 2] + 0.7 * p[:, 1]], 1) * 0.9 + rng.random(2)
    index = t
    c = np.clip(color * shade * (1 + tint), 0, 1)
    return shape.fromTriangles(p[index], c[index], uv[index], 42)
