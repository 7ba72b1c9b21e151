"""Trees: a dark core for the body of the crown and loose tufts on it for its outline. About 1 unit is a metre."""
import numpy as np

from . import shape
from .rocks import icosphere
from .shape import rgb


def conifer(seed, tall=9.0):
    """A spruce: whorls of drooping fronds down a trunk."""
    rng = np.random.default_rng(seed)
    dark, light = rgb("#22381f"), rgb("#4d6b35")
    corners, colors = [], []
    whorls = 13
    for k in range(whorls):
        s = k / (whorls - 1)
        y = tall * (0.13 + 0.84 * s)
        reach = (1 - s) ** 0.85 * tall * 0.21 + 0.12
        count = max(5, round(11 * (1 - 0.55 * s)))
        for i in range(count):
            a = 2 * np.pi * (i + rng.uniform(-0.25, 0.25)) / count + k * 0.7
            r = reach * rng.uniform(0.78, 1.12)
            out, side = np.array([np.cos(a), 0, np.sin(a)]), np.array([-np.sin(a), 0, np.cos(a)])
            drop = tall * 0.055 * (1 - 0.5 * s) * rng.uniform(0.7, 1.4)
            wide = r * rng.uniform(0.30, 0.42)
            root = np.array([0, y + drop * 0.9, 0])
            middle = out * r * 0.55 + np.array([0, y + drop * 0.1, 0])
            tip = out * r + np.array([0, y - drop, 0])
            left, right = middle + side * wide - [0, drop * 0.55, 0], middle - side * wide - [0, drop * 0.55, 0]
            tone = rng.uniform(0.8, 1.2)
            inner, outer = dark * 0.42 * tone, (dark + (light - dark) * (0.25 + 0.6 * s)) * tone
            ridge = (inner + outer) / 2
            corners += [[root, left, middle], [root, middle, right], [left, tip, middle], [middle, tip, right]]
            colors += [
                [inner, outer, ridge],
                [inner, ridge, outer],
                [outer, outer * 1.25, ridge],
                [ridge, outer * 1.25, outer],
            ]
    leaves = shape.fromTriangles(np.array(corners)[:, ::-1], np.clip(np.array(colors), 0, 1)[:, ::-1], None, shape.FLAT)
    leaves = merged(leaves, np.array([0, tall * 0.25, 0]), 0.6)
    trunk = shape.lathe(
        [(0.17, -0.4), (0.14, tall * 0.3), (0.02, tall * 0.97)], 5, [rgb("#4a3a2c") * 0.8] * 2 + [dark], shape.SMOOTH
    )
    return shape.Asset().add("leaves", leaves).add("paint", trunk)


def broadleaf(seed, tall=7.5, light="#7f9a3f", dark="#2c4420"):
    """A birch or an oak: a few rounded masses, tufts around them."""
    rng = np.random.default_rng(seed)
    light, dark = rgb(light), rgb(dark)
    masses = [(np.array([0, tall * 0.64, 0]), tall * 0.28)]
    for k in range(5):
        a = 2 * np.pi * k / 5 + rng.uniform(-0.4, 0.4)
        masses.append(
            (
                np.array([np.cos(a) * tall * 0.19, tall * rng.uniform(0.36, 0.66), np.sin(a) * tall * 0.19]),
                tall * rng.uniform(0.17, 0.23),
            )
        )
    center = np.array([0, tall * 0.55, 0])
    sphere, t = icosphere(1)
    parts, corners, colors = [], [], []
    low, high = tall * 0.22, tall * 0.95

    def shade(p, tone=1.0):
        s = np.clip((p[..., 1:2] - low) / (high - low), 0, 1)
        return np.clip((dark * 0.55 + (light - dark * 0.55) * s**1.15) * tone, 0, 1)

    for middle, r in masses:
        p = middle + sphere * r * (1 + rng.normal(scale=0.07, size=(len(sphere), 1))) * [1, 0.86, 1]
        parts.append(shape.fromTriangles(p[t], shade(p, 0.72)[t], None, shape.SMOOTH))
        count = int(26 * (r / (tall * 0.2)) ** 2)
        d = rng.normal(size=(count, 3))
        d /= np.linalg.norm(d, axis=1, keepdims=True)
        d = d[(d[:, 1] > -0.75)]
        for v in d:
            at = middle + v * r * rng.uniform(0.92, 1.12) * [1, 0.86, 1]
            if any(np.linalg.norm((at - m) / [1, 0.86, 1]) < q * 0.85 for m, q in masses if m is not middle):
                continue
            size = tall * rng.uniform(0.045, 0.085)
            side = np.cross(v, rng.normal(size=3))
            side /= np.linalg.norm(side)
            other = np.cross(v, side)
            ring = [
                at + (side * np.cos(b) + other * np.sin(b)) * size * rng.uniform(0.7, 1.3) - v * size * 0.25
                for b in np.arange(4) * np.pi / 2
            ]
            top = at + v * size * 0.25
            tone = rng.uniform(0.82, 1.25)
            for i in range(4):
                tri = np.array([top, ring[i], ring[(i + 1) % 4]])
                corners.append(tri)
                colors.append(shade(tri, tone))
    tufts = shape.fromTriangles(np.array(corners), np.array(colors), None, shape.FLAT)
    leaves = merged(shape.join(parts + [tufts]), center, 0.75)
    bark = rgb("#6b6258")
    trunk = shape.tube(
        [(0, -0.4, 0), (0.05, tall * 0.25, 0.03), (0, tall * 0.5, 0)],
        [0.19, 0.13, 0.07],
        [bark, bark * 0.7, bark * 0.4],
        6,
        False,
    )
    return shape.Asset().add("leaves", leaves).add("paint", trunk)


def merged(s, center, share):
    """Bends normals away from the crown's middle, so that it is lit as one body, and merges what then agrees."""
    away = s.p - center
    away /= np.linalg.norm(away, axis=1, keepdims=True)
    n = np.where(np.sum(s.n * away, 1, keepdims=True) < 0, -s.n, s.n)
    n = n * (1 - share) + away * share
    n /= np.linalg.norm(n, axis=1, keepdims=True)
    key = np.concatenate([np.round(s.p, 4), np.round(s.c * 60)], 1)
    _, first, index = np.unique(key, axis=0, return_index=True, return_inverse=True)
    total = np.zeros((len(first), 3))
    np.add.at(total, index.ravel(), n)
    total /= np.linalg.norm(total, axis=1, keepdims=True)
    return shape.Surface(s.p[first], total, s.c[first], index.ravel()[s.t])


def farConifer(seed, tall=14.0):
    """A spruce of few triangles, for forests: ragged cones on each other."""
    rng = np.random.default_rng(seed)
    dark, light = rgb("#1d2f1c"), rgb("#3f5a30")
    corners, colors = [], []
    tiers, sides = 4, 6
    for k in range(tiers):
        s = k / tiers
        low, high = tall * (0.08 + 0.80 * s), tall * min(1.0, 0.08 + 0.80 * s + 0.40)
        reach = tall * 0.17 * (1 - s) ** 0.8 + 0.05 * tall
        a = 2 * np.pi * (np.arange(sides) / sides + rng.uniform(0, 1))
        r = reach * rng.uniform(0.75, 1.2, sides)
        rim = np.stack([r * np.cos(a), low - 0.06 * tall * rng.uniform(0, 1, sides), r * np.sin(a)], -1)
        top = np.array([0, high, 0])
        for i in range(sides):
            corners.append([top, rim[(i + 1) % sides], rim[i]])
            tone = rng.uniform(0.75, 1.25)
            outer = (dark + (light - dark) * (0.3 + 0.6 * s)) * tone
            colors.append([(dark + outer) / 2, outer, outer])
    leaves = shape.fromTriangles(np.array(corners), np.clip(np.array(colors), 0, 1), None, shape.FLAT)
    return shape.Asset().add("leaves", merged(leaves, np.array([0, tall * 0.25, 0]), 0.6))
