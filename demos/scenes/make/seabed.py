"""A bed of sand, what grows on it and what swims over it."""
import numpy as np

from . import land, shape
from .shape import rgb

SAND, DUST, WEEDY = rgb("#d9c9a3"), rgb("#c4b189"), rgb("#6d7448")


def height(x, z):
    """Of the sand: falling away from the reef, in low swells and, near the middle, in ripples."""
    slope = -7.2 - 0.055 * np.maximum(-z - 6, 0) - 0.9 * np.exp(-((x + 2) ** 2 + (z + 9) ** 2) / 90)
    swells = 0.45 * land.waves(x, z, 81, 11.0, 3)
    reef = 4.4 * np.exp(-(((x - 13) / 6.5) ** 2)) * (0.75 + 0.5 * land.waves(x, z, 82, 7.0, 3))
    return slope + swells + reef


def ripples(x, z):
    bent = x * 0.35 + z + 0.8 * land.waves(x, z, 83, 5.0, 2)
    crest = np.abs(((bent / 0.42) % 1) - 0.5) * 2
    return 0.035 * crest**0.8


def paint(x, z):
    patch = np.clip(land.waves(x, z, 84, 4.0, 3) + 0.2, 0, 1)[..., None]
    dark = np.clip((x - 8.5) / 3, 0, 1)[..., None] * 0.75
    return (SAND * (1 - 0.35 * patch) + DUST * 0.35 * patch) * (1 - dark) + WEEDY * dark


def sheet(xs, zs, lift=None):
    x, z = np.meshgrid(xs, zs, indexing="ij")
    y = height(x, z) + (0 if lift is None else lift(x, z))
    uv = np.stack([x, z], -1) * 0.45
    return shape.grid(np.stack([x, y, z], -1), paint(x, z), uv, shape.SMOOTH, flip=True)


def seam(fine, coarse, along):
    x, z = shape.seam(fine, coarse, along)
    uv = np.stack([x, z], -1) * 0.45
    return shape.fromTriangles(np.stack([x, height(x, z), z], -1), paint(x, z), uv, shape.SMOOTH)


def kelp(seed, tall=4.5, blades=34):
    """A stipe that sways, with blades to both sides of it. Foot at the origin."""
    rng = np.random.default_rng(seed)
    t = np.linspace(0, 1, 9)
    lean = rng.uniform(0, 2 * np.pi)
    sway = 0.32 * tall * t**1.7
    wave = 0.10 * tall * np.sin(t * 5 + rng.uniform(0, 6)) * t
    path = np.stack(
        [sway * np.cos(lean) + wave * np.sin(lean), tall * t * 0.94, sway * np.sin(lean) - wave * np.cos(lean)], 1
    )
    stem = shape.tube(path, 0.022 * (1 - 0.6 * t), rgb("#7a6a2c"), 4, caps=False)
    parts = [stem]
    for k in range(blades):
        at = rng.uniform(0.12, 1)
        foot = np.array([np.interp(at, t, path[:, i]) for i in range(3)])
        turn = rng.uniform(0, 2 * np.pi)
        out = np.array([np.cos(turn), 0, np.sin(turn)])
        long, wide = rng.uniform(0.5, 1.0), rng.uniform(0.03, 0.05)
        s = np.linspace(0, 1, 6)
        middle = foot + out * (long * s * 0.8)[:, None] + np.array([0, 1, 0]) * (long * (0.75 * s - 0.65 * s**2))[:, None]
        across = np.cross(out, [0, 1, 0]) * (wide * np.sin(np.pi * np.clip(s * 0.93 + 0.07, 0, 1)) ** 0.6)[:, None]
        across[:, 1] += 0.02 * np.sin(9 * s)
        tone = rgb("#8f8a34") * rng.uniform(0.7, 1.15) * np.array([rng.uniform(0.85, 1.1), 1, 0.8])
        parts.append(shape.grid(np.stack([middle - across, middle + across], 1), tone, None, shape.SMOOTH))
    return shape.join(parts)


def grass(seed, count=22, tall=0.5):
    """Eelgrass, a tuft half a metre across."""
    rng = np.random.default_rng(seed)
    blades = []
    for _ in range(count):
        foot = np.array([rng.normal(scale=0.16), -0.03, rng.normal(scale=0.16)])
        lean, long = rng.uniform(0, 2 * np.pi), tall * rng.uniform(0.6, 1.2)
        s = np.linspace(0, 1, 4)
        path = foot + np.stack(
            [0.35 * long * s**2 * np.cos(lean), long * s * 0.95, 0.35 * long * s**2 * np.sin(lean)], 1
        )
        across = np.array([-np.sin(lean), 0, np.cos(lean)]) * (0.012 * (1 - 0.8 * s))[:, None]
        tone = rgb("#5f7a35") * rng.uniform(0.65, 1.15)
        blades.append(shape.grid(np.stack([path - across, path + across], 1), tone, None, shape.SMOOTH))
    return shape.join(blades)


def fish(back="#3d5f78", belly="#d8dde0", long=0.26):
    """Swims along +x."""
    x = np.array([-0.42, -0.3, -0.1, 0.12, 0.3, 0.44, 0.5]) * long
    tall = np.array([0.02, 0.055, 0.14, 0.17, 0.13, 0.06, 0.005]) * long
    angle = np.linspace(0, 2 * np.pi, 9)
    p = np.stack(
        [
            np.repeat(x[:, None], 9, 1),
            tall[:, None] * np.sin(angle),
            0.42 * tall[:, None] * np.cos(angle),
        ],
        -1,
    )
    p[:, -1] = p[:, 0]
    up = np.clip(0.5 + 0.9 * np.sin(angle), 0, 1)[None, :, None]
    body = shape.grid(p, rgb(belly) * (1 - up) + rgb(back) * up + np.zeros(p.shape), None, shape.SMOOTH)
    fins = []
    for tip in ((-0.62, 0.15), (-0.62, -0.15)):
        tail = np.array([(-0.40, 0.02), tip, (-0.53, 0.0), (-0.40, -0.02)]) * long
        points = np.stack([tail[:, 0], tail[:, 1], np.zeros(4)], 1)
        fins.append(shape.polygons(points, [[0, 1, 2], [0, 2, 3]], rgb(back) * 0.9))
    dorsal = np.array([(-0.12, 0.13, 0), (0.16, 0.16, 0), (-0.02, 0.24, 0)]) * long
    fins.append(shape.polygons(dorsal, [[0, 1, 2]], rgb(back) * 0.8))
    return body, shape.join(fins)
