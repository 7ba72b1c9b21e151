"""Ambient occlusion into vertex colours: depth maps of the asset's own points from many directions, and how much of the
cosine-weighted sky above each vertex they leave open."""
import numpy as np


def spherePoints(count):
    """Fibonacci lattice."""
    i = np.arange(count) + 0.5
    y = 1 - 2 * i / count
    a = np.pi * (1 + 5**0.5) * i
    r = np.sqrt(1 - y * y)
    return np.stack([r * np.cos(a), y, r * np.sin(a)], 1)


def scatter(p, t, spacing, rng):
    """Points over triangles, about one a spacing squared, and at least a few on each."""
    a, b, c = p[t[:, 0]], p[t[:, 1]], p[t[:, 2]]
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2
    count = np.ceil(area / spacing**2).astype(int) + 1
    which = np.repeat(np.arange(len(t)), count)
    u, v = rng.random(len(which)), rng.random(len(which))
    fold = u + v > 1
    u[fold], v[fold] = 1 - u[fold], 1 - v[fold]
    return a[which] + u[:, None] * (b - a)[which] + v[:, None] * (c - a)[which]


def openness(surfaces, cell, count=72, below=0.35):
    """For each surface, how open each vertex is, 0..1. Light from below the horizon, off water and ground, counts
    `below` as much as the sky's."""
    rng = np.random.default_rng(1)
    cloud = np.concatenate([scatter(s.p, s.t, cell * 0.7, rng) for s in surfaces])
    p = np.concatenate([s.p for s in surfaces])
    n = np.concatenate([s.n for s in surfaces])
    lifted = p + n * cell * 0.6
    got, whole = np.zeros(len(p)), np.zeros(len(p))
    for d in spherePoints(count):
        weight = np.maximum(n @ d, 0) * (1 if d[1] > -0.05 else below)
        side = np.cross(d, [0, 1, 0] if abs(d[1]) < 0.9 else [1, 0, 0])
        side /= np.linalg.norm(side)
        frame = np.stack([side, np.cross(d, side), d], 1)
        q, r = cloud @ frame, lifted @ frame
        low = q[:, :2].min(0)
        extent = ((q[:, :2].max(0) - low) / cell).astype(int) + 3
        flat = lambda x: np.clip(((x[:, :2] - low) / cell + 1).astype(int), 0, extent - 1) @ np.array([extent[1], 1])
        depth = np.full(extent.prod(), -np.inf)
        order = np.argsort(q[:, 2])
        depth[flat(q)[order]] = q[order, 2]
        got += weight * (r[:, 2] > depth[flat(r)] - cell * 0.9)
        whole += weight
    value = got / np.maximum(whole, 1e-6)
    sizes = np.cumsum([len(s.p) for s in surfaces])[:-1]
    return np.split(value, sizes)


def bake(asset, cell=0.08, depth=0.75, count=72):
    """Darkens the asset's colours; `depth` 0 leaves them."""
    joined = asset.joined()
    for surface, value in zip(joined.values(), openness(list(joined.values()), cell, count)):
        surface.c *= (1 - depth + depth * value**0.9)[:, None]
    asset.parts = {material: [surface] for material, surface in joined.items()}
    return asset
