"""A sandy bay: its bed from the dunes to deep water, as one height function, and the sand's texture."""
import numpy as np

from . import land, shape, texture
from .shape import rgb

DRY, SHELLS, DEEP = rgb("#e6d3a8"), rgb("#f1e6cf"), rgb("#c2b083")
SLOPE = 1 / 21
WIDE, NEAR_Z, FAR_Z = 170, 80, -420  # of what waves are told of


def edge(x):
    """z of the water's edge: a bay that its ends close in, with low cusps."""
    return -0.0034 * np.minimum(np.abs(x), WIDE) ** 2 + 0.9 * np.sin(x / 9.5 + 0.6) + 0.5 * np.sin(x / 4.1)


def height(x, z):
    seaward = edge(x) - z
    deep = -300 * SLOPE * (1 - np.exp(-np.maximum(seaward, 0) / 300)) - 30 * land.smooth(-300, FAR_Z, z) ** 2
    bar = 0.40 * np.exp(-(((seaward - 34) / 10) ** 2)) - 0.12 * np.exp(-(((seaward - 17) / 7) ** 2))
    inland = np.maximum(-seaward, 0)
    berm = 14 * SLOPE * (1 - np.exp(-inland / 14))
    dunes = land.smooth(17, 42, inland) * (2.6 + 1.5 * land.waves(x, z, 11, 26.0, 3))
    hummocks = 0.05 * land.smooth(4, 12, inland) * land.waves(x, z, 12, 3.2, 3)
    heads = land.smooth(100, 210, np.abs(x)) * land.smooth(12, 80, inland) * (17 + 7 * land.waves(x, z, 13, 70.0, 4))
    return deep + bar * (seaward > 0) + berm + dunes + hummocks + heads


def paint(x, y, z):
    """Dry sand, which the renderer wets: a line of shells where waves end, grassy on the dunes."""
    patch = land.waves(x, z, 21, 5.0, 3)[..., None]
    color = DRY * (1 + 0.06 * patch)
    line = np.exp(-(((y - 0.36 - 0.03 * land.waves(x, z, 23, 4.0, 3)) / 0.035) ** 2))[..., None]
    color = color * (1 - 0.12 * line) + SHELLS * 0.12 * line
    below = land.smooth(0.2, 3.0, -y)[..., None]
    color = color * (1 - below) + DEEP * below
    grassy = (land.smooth(1.2, 2.8, y + 0.5 * land.waves(x, z, 24, 6.0, 3)))[..., None]
    color = color * (1 - 0.75 * grassy) + rgb("#7f8a4c") * 0.75 * grassy
    wooded = (land.smooth(4.5, 9.0, y + 2.0 * land.waves(x, z, 25, 14.0, 3)))[..., None]
    bush = rgb("#3f5a2c") * (0.8 + 0.35 * land.waves(x, z, 26, 5.0, 3)[..., None])
    return np.clip(color * (1 - wooded) + bush * wooded, 0, 1)


def sheet(xs, zs):
    z, x = np.meshgrid(zs, xs, indexing="ij")
    y = height(x, z)
    uv = np.stack([x, z], -1) / 1.9
    return shape.grid(np.stack([x, y, z], -1), paint(x, y, z), uv, shape.SMOOTH)


def across():
    return land.spaced((-WIDE, -64, 5), (-64, 64, 1.25), (64, WIDE, 5))


SHOREWARDS = ((FAR_Z, -70, 14), (-70, -32, 2.5), (-32, 22, 1), (22, NEAR_Z, 2.5))


def bed():
    return sheet(across(), land.spaced(*SHOREWARDS))


def seam(fine, coarse, along):
    x, z = shape.seam(fine, coarse, along)
    y = height(x, z)
    return shape.fromTriangles(np.stack([x, y, z], -1), paint(x, y, z), np.stack([x, z], -1) / 1.9, shape.SMOOTH)


def outskirts():
    """What waves are not told of: beside the bay, and behind it. Where sheets meet they share every vertex, or the sky would shine
    through the hills."""
    beside, inland = WIDE + 14, NEAR_Z + 8
    behind = ((inland, 180, 8), (180, 420, 24))
    zs = land.spaced((FAR_Z - 60, -150, 30), (-150, 40, 9), (40, NEAR_Z, 8), (NEAR_Z, inland, 8), *behind)
    border = land.spaced((FAR_Z - 60, FAR_Z, 30), *SHOREWARDS, (NEAR_Z, inland, 8), *behind)
    sides = [sheet(side * land.spaced((beside, 324, 14), (324, 1200, 90))[::side], zs) for side in (-1, 1)]
    seams = [seam(shape.row(side * WIDE, border), shape.row(side * beside, zs), 1) for side in (-1, 1)]
    xs = land.spaced((-WIDE, WIDE, 10))
    return [*sides, *seams, seam(shape.row(across(), NEAR_Z), shape.row(xs, inland), 0), sheet(xs, land.spaced(*behind))]


def sand(size=256):
    """Grains, soft hollows that feet have left, and faint ripples."""
    y, x = np.mgrid[:size, :size] / size
    grains = texture.noise(size, 128, 71) - 0.5 + 0.7 * (texture.noise(size, 64, 72) - 0.5)
    hollows = sum(0.6**i * (texture.noise(size, 7 << i, 73 + i) - 0.5) for i in range(3))
    wind = np.sin(2 * np.pi * (9 * y + 2 * x) + 3.0 * (texture.noise(size, 5, 77) - 0.5) * 2)
    return np.clip(0.86 + 0.16 * grains + 0.13 * hollows + 0.022 * wind, 0, 1)
