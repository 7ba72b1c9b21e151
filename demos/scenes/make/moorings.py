"""What floats and what it is tied to: buoys, mooring poles, ropes; and the small things that lie about a quay."""
import numpy as np

from . import shape
from .shape import rgb


def ballBuoy(color="#e2632a", r=0.36):
    a = np.linspace(-np.pi / 2, np.pi / 2, 9)
    color = rgb(color)
    shade = color * np.where(np.sin(a) < -0.1, 0.35, 1.0)[:, None]
    ball = shape.lathe(np.stack([r * np.cos(a), r * np.sin(a)], 1), 14, shade, shape.SMOOTH)
    return (
        shape.Asset()
        .add("gloss", shape.move(ball, (0, 0.06, 0)))
        .add("paint", shape.lathe([(0.05, 0.35), (0.05, 0.52), (0.0, 0.53)], 6, rgb("#3a3a3a"), 40))
    )


def sparBuoy(first="#c8322b", second="#f1ede2"):
    """A lateral mark: a striped cone on a float, with a top mark."""
    a, b = rgb(first), rgb(second)
    asset = shape.Asset().add(
        "gloss", shape.lathe([(0.0, -0.7), (0.62, -0.55), (0.68, 0.12), (0.60, 0.22), (0.3, 0.26)], 14, a * 0.9, 40)
    )
    for low, high, color in ((0.24, 0.9, a), (0.9, 1.5, b), (1.5, 2.1, a)):
        r = lambda y: 0.32 - 0.11 * y
        asset.add("gloss", shape.lathe([(r(low), low), (r(high), high)], 12, color, 40))
    asset.add("paint", shape.lathe([(0.03, 2.08), (0.03, 2.45)], 6, rgb("#333333"), 40))
    asset.add("gloss", shape.lathe([(0, 2.42), (0.2, 2.44), (0.2, 2.78), (0, 2.8)], 10, a, 30))
    return asset


def rope(a, b, sag, color="#b7a582", radius=0.016):
    a, b = np.asarray(a, float), np.asarray(b, float)
    s = np.linspace(0, 1, 8)[:, None]
    return shape.tube(a + (b - a) * s - np.array([0, 4 * sag, 0]) * s * (1 - s), radius, rgb(color), 3, False)


def barrel(color="#6d5138"):
    c = rgb(color)
    iron = rgb("#45423f")
    profile = [
        (0.24, 0),
        (0.27, 0.10),
        (0.27, 0.15),
        (0.30, 0.32),
        (0.30, 0.52),
        (0.27, 0.70),
        (0.27, 0.75),
        (0.24, 0.85),
        (0.22, 0.85),
        (0.21, 0.80),
        (0, 0.80),
    ]
    return shape.lathe(profile, 11, [c * 0.7, c, iron, iron, iron, iron, iron, c, c * 0.8, c * 0.5, c * 0.6], 35)


def crate(color):
    return shape.box((0.62, 0.30, 0.44), (0, 0.15, 0), rgb(color), top=(1.05, 1.05))


def tyre():
    """Hangs in the plane of x and y."""
    return shape.turn(shape.torus(0.22, 0.085, rgb("#232323"), 12, 6), shape.about("x", 90))


def lifeRing():
    """Hangs in the plane of x and y."""
    colors = np.array([rgb("#d2452f") if (k // 3) % 2 else rgb("#f0ece0") for k in range(12)])
    return shape.turn(shape.torus(0.29, 0.065, colors, 12, 6), shape.about("x", 90))


def netHeap(seed, color="#3f6a5f"):
    rng = np.random.default_rng(seed)
    p = np.zeros((9, 9, 3))
    g = np.linspace(-1, 1, 9)
    p[..., 0], p[..., 2] = g[:, None] * 0.8, g[None] * 0.6
    r = np.maximum(np.abs(g[:, None]), np.abs(g[None]))
    p[..., 1] = np.maximum(0.42 * (1 - r**2) * (1 + 0.35 * rng.normal(size=(9, 9))), 0)
    shade = rgb(color) * (0.5 + 0.9 * p[..., 1:2] / 0.45) * rng.uniform(0.8, 1.2, (9, 9, 1))
    return shape.grid(p, np.clip(shade, 0, 1), None, shape.SMOOTH, flip=True)
