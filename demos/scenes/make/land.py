"""The ground, above and below the water: a mainland on the right with a beach, an island, the lighthouse's rock and the
sea bed, as one height function; meshes of it; and the far hills."""
import numpy as np

from . import shape
from .shape import rgb

QUAY_X, QUAY_NEAR, QUAY_FAR, QUAY_TOP = 13.0, 8.0, -30.0, 1.3
LIGHTHOUSE = np.array([-34.0, -52.0])
ISLAND = np.array([22.0, -185.0])
DEEPEST = -8.0


def waves(x, z, seed, size, octaves=4):
    """Smooth noise, about -1..1: sums of turned sines, cheap and without a lattice."""
    rng = np.random.default_rng(seed)
    total, amplitude, norm = 0, 1.0, 0
    for octave in range(octaves):
        for _ in range(4):
            a, phase = rng.uniform(0, 2 * np.pi, 2)
            k = 2 * np.pi / size * 2**octave * rng.uniform(0.7, 1.3)
            warp = 0.6 * np.sin((x * np.sin(a * 3) + z * np.cos(a * 3)) * k * 0.6 + phase * 2)
            total = total + amplitude * np.sin((x * np.cos(a) + z * np.sin(a)) * k + phase + warp)
        norm += amplitude * 2
        amplitude *= 0.5
    return total / norm


def smooth(low, high, x):
    t = np.clip((x - low) / (high - low), 0, 1)
    return t * t * (3 - 2 * t)


def coast(z):
    """x of the mainland's shore; land lies to the right."""
    beach = 13 + 0.42 * np.maximum(z - QUAY_NEAR, 0)
    back = np.maximum(QUAY_FAR - z, 0)
    return beach + back * 0.75 + 2.2 * np.sin(z * 0.13 + 1) * smooth(2, 14, np.maximum(z - QUAY_NEAR, QUAY_FAR - z))


def mainland(x, z):
    d = x - coast(z)
    rough = waves(x, z, 3, 38)
    inland = 1.1 * smooth(-1, 6, d) + 0.052 * np.maximum(d - 8, 0) + 6 * smooth(25, 110, d)
    up = inland + rough * 0.055 * np.clip(d, 0, 45)
    down = DEEPEST * (1 - np.exp(np.minimum(d, 0) / 52)) + 0.10 * rough * np.clip(-d, 0, 4)
    quay = smooth(QUAY_FAR - 3, QUAY_FAR, z) * (1 - smooth(QUAY_NEAR - 1.5, QUAY_NEAR + 0.5, z))
    behind = np.where(d > 0.9, np.where(d < 11, 0.9, up), down - 1.1)
    shore = np.where(d > 0, up, down)
    return shore * (1 - quay) + behind * quay


def shoal(x, z):
    """Sand in front of the eye, so that the bed is seen."""
    return 3.0 * np.exp(-((x - 3) ** 2 + (z - 17) ** 2) / 11**2)


def island(x, z):
    q = (np.array([x, z], dtype=float).transpose(*range(1, np.ndim(x) + 1), 0) - ISLAND) / np.array([82, 46])
    angle = np.arctan2(q[..., 1], q[..., 0])
    r = np.linalg.norm(q, axis=-1) * (1 + 0.14 * np.sin(3 * angle + 0.7) + 0.09 * np.sin(5 * angle + 2.1))
    rise = np.clip(1 - r, -1.2, 1)
    beach = np.where(rise > 0, 9.5 * smooth(0.0, 0.85, rise) + 2.2 * np.clip(rise / 0.12, 0, 1), rise * 34)
    knoll = 6.5 * np.exp(-(((x - 48) / 26) ** 2 + ((z + 190) / 20) ** 2)) + 3.5 * np.exp(
        -(((x + 14) / 22) ** 2 + ((z + 182) / 16) ** 2)
    )
    return beach + (knoll + 1.3 * waves(x, z, 8, 34)) * np.clip(rise * 5, 0, 1)


def skerry(x, z):
    """The lighthouse's rock."""
    dx, dz = x - LIGHTHOUSE[0], z - LIGHTHOUSE[1]
    angle = np.arctan2(dz, dx)
    r = np.hypot(dx / 1.35, dz) * (1 + 0.12 * np.sin(2 * angle + 1) + 0.10 * np.sin(5 * angle))
    h = 2.9 * (1 - smooth(3.6, 10.5, r)) ** 0.8 - 1.1 * np.maximum(r - 9.5, 0)
    ledges = np.abs(waves(x, z, 12, 7)) * 1.1 + 0.35 * waves(x, z, 13, 2.6, 2)
    return np.where(r < 3.2, 2.9, h + ledges * smooth(3.2, 4.6, r) - 0.25)


def shore(x, z):
    """Mainland and sea bed."""
    bed = np.maximum(mainland(x, z), DEEPEST)
    bed = np.maximum(bed, np.minimum(bed + shoal(x, z), -0.95))
    rippled = np.minimum(bed + 0.07 * waves(x, z, 21, 6, 3), np.maximum(bed, -0.05))
    return np.where(x < coast(z), rippled, bed)


def height(x, z):
    """All of it."""
    x, z = np.broadcast_arrays(np.asarray(x, float), np.asarray(z, float))
    return np.maximum.reduce([shore(x, z), island(x, z), skerry(x, z)])


# --- colour ----------------------------------------------------------------------------------------------------------

SAND, WET, SILT, GRASS, MEADOW, DRY, ROCK, WEED = (
    rgb(c) for c in ("#d8c49a", "#a08a62", "#93906c", "#566d35", "#70823f", "#9c9257", "#8b857c", "#4b5230")
)


def mix(a, b, t):
    return a + (b - a) * np.asarray(t)[..., None]


def colors(x, y, z, slope):
    """By height, slope and noise."""
    patch, fine = waves(x, z, 31, 24), waves(x, z, 32, 5, 3)
    turf = mix(mix(GRASS, MEADOW, 0.5 + 0.6 * patch), DRY, np.clip(0.25 + 0.7 * fine, 0, 0.6))
    c = mix(SAND, turf, smooth(0.75, 1.6, y + 0.35 * fine))
    c = mix(c, ROCK * (1 + 0.25 * fine[..., None]), smooth(0.42, 0.75, slope + 0.08 * fine) * (y > -0.5))
    c = mix(c, WET, 1 - smooth(-0.05, 0.30, y + 0.08 * fine))
    under = mix(SAND * 0.82, SILT * 0.75, smooth(0.3, 5, -y))
    under = mix(under, WEED, 0.75 * smooth(0.15, 0.45, waves(x, z, 33, 9)) * smooth(0.9, 2.2, -y))
    return mix(c, under * (1 + 0.18 * fine[..., None]), smooth(0.0, 0.35, -y))


def patchOver(xs, zs, surface, paint):
    """A mesh of a height function over a rectangular net."""
    z, x = np.meshgrid(zs, xs, indexing="ij")
    y = surface(x, z)
    e = 0.4
    slope = np.hypot(surface(x + e, z) - surface(x - e, z), surface(x, z + e) - surface(x, z - e)) / (2 * e)
    uv = np.stack([x, z], -1) / 2.6
    return shape.grid(np.stack([x, y, z], -1), np.clip(paint(x, y, z, slope), 0, 1), uv, shape.SMOOTH)


def spaced(*runs):
    """Joined runs of (from, to, step)."""
    return np.unique(
        np.round(np.concatenate([np.linspace(a, b, max(2, round((b - a) / s) + 1)) for a, b, s in runs]), 3)
    )


def near():
    xs = spaced(
        (-900, -300, 300),
        (-300, -90, 70),
        (-90, -30, 15),
        (-30, -12, 4.5),
        (-12, 12.4, 1.8),
        (12.4, 14.2, 0.6),
        (14.2, 26, 2.3),
        (26, 60, 5.5),
        (60, 180, 20),
    )
    zs = spaced(
        (-620, -300, 160),
        (-300, -140, 40),
        (-140, -50, 12),
        (-50, -20, 5),
        (-20, -6, 2.4),
        (-6, 24, 1.9),
        (24, 40, 4),
        (40, 100, 15),
        (100, 400, 150),
    )

    def sunk(x, z):
        """Down at the far rim, so that the bed has no end to be seen."""
        rim = np.maximum(np.abs(x + 60) - 400, np.abs(z + 90) - 450)
        return np.where((rim > 0) & (x < 100), -30, shore(x, z))

    return patchOver(xs, zs, sunk, colors)


def islandPatch():
    s = patchOver(ISLAND[0] + np.linspace(-104, 104, 38), ISLAND[1] + np.linspace(-60, 60, 25), island, colors)
    s.uv = None
    s.c *= 0.75
    return s


def skerryPatch():
    def paint(x, y, z, slope):
        fine = waves(x, z, 41, 3, 3)
        c = mix(ROCK, rgb("#6d675f"), 0.5 + 0.8 * fine)
        c = mix(c, rgb("#a59a80"), smooth(1.8, 3.0, y) * 0.6)
        c = mix(c, rgb("#37382c"), 1 - smooth(0.15, 0.75, y + 0.2 * fine))
        return c

    return patchOver(LIGHTHOUSE[0] + np.linspace(-19, 19, 24), LIGHTHOUSE[1] + np.linspace(-15, 15, 19), skerry, paint)


def hills():
    """Far ridges along part of the horizon, woods and heath; the farther, the more air is in their colour."""
    parts = []
    ridges = (
        (620, 196, 238, 34, "#4a5a43", 61),
        (1050, 190, 252, 72, "#586b5c", 62),
        (1500, 226, 262, 95, "#71867f", 63),
        (760, 298, 345, 62, "#4c5d48", 64),
        (1350, 286, 352, 120, "#687c6f", 65),
    )
    for radius, start, stop, top, color, seed in ridges:
        a = np.linspace(start, stop, 38)
        s = (a - start) / (stop - start)
        end = np.sin(np.pi * s) ** 1.3
        rise = (
            end * top * (0.55 + 0.40 * waves(a * 3, a * 0, seed, 60, 5) + 0.10 * waves(a * 9, a * 0, seed + 9, 30, 3))
        )
        rise = np.maximum(rise, 0) + 0.5
        rows = []
        # From the air they are seen from behind, with bays and spurs, and where they end.
        before, behind = (0.6 + 0.5 * end + 0.7 * waves(a * 2, a * 0, seed + side, 14, 4) for side in (1, 2))
        shades = []
        for share, back, spread, shade in (
            (-0.2, 0.0, -0.05, 1.12),
            (0.4, 0.03, -0.02, 1.05),
            (0.8, 0.09, 0, 0.97),
            (1.0, 0.13, 0, 0.9),
            (0.7, 0.13, 0.04, 0.95),
            (0.35, 0.13, 0.09, 1.0),
            (-0.2, 0.13, 0.14, 1.05),
        ):
            shades.append(shade)
            bay = behind if spread > 0 else before
            width = back * np.minimum(3 * end, 1) + spread * bay * np.minimum(2 * end, 1)
            r = radius * (1 + width + 0.012 * waves(a * 2, a * 0, seed + 3, 40, 2))
            y = rise * share if share > 0 else np.full_like(a, -6)
            if 0 < share < 1:
                y = y * (1 + 0.2 * waves(a * 5, a * 0 + share * 60, seed + 5, 40, 3))
            rows.append(np.stack([r * np.cos(np.radians(a)), y, r * np.sin(np.radians(a))], -1))
        p = np.array(rows)
        tint = rgb(color) * (1 + 0.16 * waves(p[..., 0], p[..., 2], seed + 7, radius * 0.08, 3)[..., None])
        parts.append(shape.grid(p, tint * np.array(shades)[:, None, None], None, shape.SMOOTH, flip=True))
    return shape.join(parts)
