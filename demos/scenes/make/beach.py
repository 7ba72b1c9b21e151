"""A sandy bay of an island: its bed from the dunes to deep water, as one height function, and the sand's texture."""
import numpy as np

from . import land, shape, texture
from .shape import rgb

DRY, SHELLS, DEEP = rgb("#e6d3a8"), rgb("#f1e6cf"), rgb("#c2b083")
SLOPE = 1 / 21
ACROSS, ALONG, MIDDLE_Z = 150, 95, 20  # half axes of the island, along x and z
# Of the bed, around the island: it ends where water is so deep that nothing of it is seen.
WIDE, NEAR_Z, FAR_Z = 310, 270, -230


def edge(x):
    """z of the bay's water's edge: its ends close it in, with low cusps."""
    return -0.0034 * x**2 + 0.9 * np.sin(x / 9.5 + 0.6) + 0.5 * np.sin(x / 4.1)


def offshore(x, z):
    """About how far it is from the island, without its bay: below 0 on it."""
    u, v = x / ACROSS, (z - MIDDLE_Z) / ALONG
    axes = np.maximum(np.hypot(u, v), 1e-6)
    return axes * (axes - 1) / np.maximum(np.hypot(u / ACROSS, v / ALONG), axes / ACROSS) + 9 * land.waves(x, z, 14, 90.0, 3)


def rounded(a, b, within):
    """The larger, with a rounded corner."""
    apart = np.maximum(within - np.abs(a - b), 0) / within
    return np.maximum(a, b) + within / 4 * apart**2


def height(x, z):
    seaward = rounded(edge(x) - z, offshore(x, z), 16)
    shelf = 60 - 46 * land.smooth(-20, 60, z)  # wide before the bay
    deep = -300 * SLOPE * (1 - np.exp(-np.maximum(seaward, 0) / 300)) - 100 * land.smooth(shelf, shelf + 90, seaward)
    bar = 0.40 * np.exp(-(((seaward - 34) / 10) ** 2)) - 0.12 * np.exp(-(((seaward - 17) / 7) ** 2))
    inland = np.maximum(-seaward, 0)
    berm = 14 * SLOPE * (1 - np.exp(-inland / 14))
    dunes = land.smooth(17, 42, inland) * (2.6 + 1.5 * land.waves(x, z, 11, 26.0, 3))
    # Only where swash never comes: what it reaches it smooths.
    hummocks = 0.05 * land.smooth(16, 26, inland) * land.waves(x, z, 12, 3.2, 3)
    heads = land.smooth(65, 130, np.abs(x)) * land.smooth(12, 50, inland) * (13 + 7 * land.waves(x, z, 13, 70.0, 4))
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
    aside = [1.3 * land.waves(x, z, seed, 24.0, 2) for seed in (27, 28)]  # [m]: repetitions stand in no rows
    uv = (np.stack([x, z], -1) + np.stack(aside, -1)) / 1.9
    return shape.grid(np.stack([x, y, z], -1), paint(x, y, z), uv, shape.SMOOTH)


def bed():
    xs = land.spaced((-WIDE, -150, 16), (-150, -64, 4), (-64, 64, 1.5), (64, 150, 4), (150, WIDE, 16))
    return sheet(xs, land.spaced((FAR_Z, -70, 12), (-70, -32, 2.5), (-32, 22, 1), (22, 125, 4), (125, NEAR_Z, 12)))


def sand(size=256):
    """Grains, soft hollows that feet have left, and faint ripples."""
    y, x = np.mgrid[:size, :size] / size
    grains = texture.noise(size, 128, 71) - 0.5 + 0.7 * (texture.noise(size, 64, 72) - 0.5)
    hollows = sum(0.6**i * (texture.noise(size, 7 << i, 73 + i) - 0.5) for i in range(3))
    wind = np.sin(2 * np.pi * (9 * y + 2 * x) + 3.0 * (texture.noise(size, 5, 77) - 0.5) * 2)
    return np.clip(0.86 + texture.withoutSlowParts(0.16 * grains + 0.13 * hollows, 8) + 0.022 * wind, 0, 1)
