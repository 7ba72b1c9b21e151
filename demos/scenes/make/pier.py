"""The pier's timber, by the piece: planks, posts, beams and railings."""
import numpy as np

from . import shape
from .shape import rgb

DECK = 1.25  # top of the planks


def plank(seed, length):
    """Lies along x, its top at y = 0."""
    rng = np.random.default_rng(seed)
    tone = rgb("#b39a7c") * rng.uniform(0.72, 1.12) * np.array([1, rng.uniform(0.95, 1.02), rng.uniform(0.88, 1.02)])
    s = shape.box((length, 0.05, 0.205), (rng.uniform(-0.03, 0.03), -0.025, 0), tone, 0.55)
    s.c[s.n[:, 1] < -0.5] *= 0.38
    s.uv = s.uv + rng.random(2)
    return s


def post(seed, top, bottom, radius=0.14):
    """Round, wet and green where the water reaches."""
    rng = np.random.default_rng(seed)
    y = np.array([bottom, -1.0, -0.15, 0.12, 0.28, 0.6, top - 0.03, top])
    r = radius * (1 + rng.normal(scale=0.03, size=len(y)))
    r[-1] = radius * 0.8
    dry, wet, weed = rgb("#8f7a61"), rgb("#453a2e"), rgb("#3d4526")
    c = np.array([weed * 0.7, weed * 0.9, weed, wet * 0.8, wet, dry * 0.72, dry, dry * 1.1]) * rng.uniform(0.85, 1.1)
    side = shape.lathe(np.stack([r, y], 1), 9, c, shape.ROUNDED, (1, 0.55))
    a = np.linspace(0, 2 * np.pi, 10)[:-1]
    rim = np.stack([r[-1] * np.cos(-a), np.full(9, top), r[-1] * np.sin(-a)], 1)
    lid = shape.polygons(rim, [list(range(9))], dry * 1.15, uv=rim[:, ::2] * 2)
    return shape.join([side, lid])


def beam(a, b, size=(0.18, 0.24), color="#7d6a54"):
    return shape.between(a, b, size, rgb(color) * 0.6, 0.55)


def railing(a, b, seed, tall=1.0):
    """Posts and two rails from a to b, at the deck."""
    rng = np.random.default_rng(seed)
    a, b = np.asarray(a, float), np.asarray(b, float)
    count = max(1, round(np.linalg.norm(b - a) / 1.9))
    color = rgb("#cfc6b4")
    parts = []
    for k in range(count + 1):
        p = a + (b - a) * k / count
        parts.append(shape.between(p - [0, 0.2, 0], p + [0, tall, 0], (0.09, 0.09), color * rng.uniform(0.85, 1.05)))
    for y in (tall * 0.52, tall):
        parts.append(
            shape.between(
                a + [0, y, 0], b + [0, y, 0], (0.12 if y == tall else 0.05, 0.045 if y == tall else 0.11), color
            )
        )
    return shape.join(parts)


def ladder(at, side, depth=-0.9):
    """Down the pier's edge; `side` points out over the water."""
    at, side = np.asarray(at, float), np.asarray(side, float)
    across = np.cross([0, 1, 0], side)
    color = rgb("#6f5c48")
    parts = [
        shape.between(
            at + across * s + side * 0.08 + [0, depth, 0],
            at + across * s + side * 0.08 + [0, 0.55, 0],
            (0.07, 0.07),
            color,
            0.55,
        )
        for s in (-0.23, 0.23)
    ]
    for y in np.arange(depth + 0.15, 0, 0.3):
        parts.append(
            shape.between(
                at - across * 0.23 + side * 0.08 + [0, y, 0],
                at + across * 0.23 + side * 0.08 + [0, y, 0],
                (0.05, 0.05),
                color * 0.9,
                0.55,
            )
        )
    return shape.join(parts)


def bollard():
    return shape.lathe(
        [(0.15, 0), (0.12, 0.06), (0.10, 0.30), (0.17, 0.36), (0.17, 0.43), (0.10, 0.47), (0, 0.48)],
        10,
        rgb("#2c2f33"),
        shape.ROUNDED,
    )


def lamp():
    """A post with a lantern."""
    iron = rgb("#2f3a36")
    return [
        shape.lathe([(0.09, 0), (0.06, 0.25), (0.04, 0.3), (0.035, 2.7)], 8, iron, shape.ROUNDED),
        shape.box((0.20, 0.28, 0.20), (0, 2.86, 0), rgb("#ffe9b8"), top=(1.25, 1.25)),
        shape.lathe([(0.19, 2.99), (0.17, 3.03), (0.03, 3.14), (0, 3.2)], 8, iron, shape.FLAT),
    ]
