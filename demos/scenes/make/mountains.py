"""A lake among mountains: its outline, the land as one height function, a mesh of all of it that is fine where the eye
is, and its picture from above, in which snow, rock, scree, meadow and forest are."""
import numpy as np

from . import shape
from .land import mix, smooth, waves
from .shape import rgb

# (x, z) of the shore, which is smoothed between them; the eye stands near (0, 10).
SHORE = np.array(
    [
        (-16, 9), (-5, 6.5), (6, 8.5), (20, 4), (48, -2), (92, -8), (150, -60), (205, -170), (262, -300), (300, -450),
        (268, -620), (300, -800), (262, -990), (150, -1120), (20, -1180), (-120, -1130), (-215, -1010),
        (-250, -850), (-190, -700), (-235, -540), (-290, -400), (-262, -250), (-180, -130), (-110, -45), (-52, 2),
    ],
    float,
)
EYE = np.array([0.0, 20.0])  # the middle of the mesh's rings
DEEPEST = -22.0

PEAKS = (  # x, z, height, reach across and along
    (-190, -2900, 800, 950, 760),
    (480, -3050, 600, 700, 600),
    (-930, -2650, 640, 640, 600),
    (980, -2300, 560, 520, 700),
    (-1050, -1150, 560, 470, 800),
    (1120, -1050, 400, 430, 620),
    (-900, -200, 250, 420, 420),
    (1250, -150, 170, 460, 420),
    (-120, -1900, 240, 520, 300),
    (0, 1500, 120, 1600, 600),
)


def outline(per=8):
    """The shore as a closed curve through its points (Catmull and Rom)."""
    p = [np.roll(SHORE, shift, axis=0) for shift in (1, 0, -1, -2)]
    t = (np.arange(per) / per)[None, :, None]
    a, b, c, d = (q[:, None] for q in p)
    curve = 0.5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t**2 + (3 * b - a - 3 * c + d) * t**3)
    return curve.reshape(-1, 2)


CURVE = outline()


def shoreDistance(x, z):
    """Distance to the shore: positive on land."""
    p = np.stack([np.ravel(x), np.ravel(z)], -1)
    best = np.full(len(p), np.inf)
    inside = np.zeros(len(p), bool)
    for a, b in zip(CURVE, np.roll(CURVE, -1, axis=0)):
        along = b - a
        t = np.clip(((p - a) @ along) / (along @ along), 0, 1)
        best = np.minimum(best, np.linalg.norm(p - a - t[:, None] * along, axis=1))
        crosses = (a[1] <= p[:, 1]) != (b[1] <= p[:, 1])
        inside ^= crosses & (a[0] + (p[:, 1] - a[1]) / (along[1] if along[1] else 1) * along[0] < p[:, 0])
    return np.where(inside, -best, best).reshape(np.shape(x))


LOW, STEP = np.array([-1100.0, -2000.0]), 4.0
NET = shoreDistance(*np.meshgrid(LOW[0] + STEP * np.arange(560), LOW[1] + STEP * np.arange(700), indexing="ij"))


def fromShore(x, z):
    """The same from a net, for many points; beyond it by what is left to it."""
    x, z = np.broadcast_arrays(np.asarray(x, float), np.asarray(z, float))
    last = np.array(NET.shape) - 1.001
    i, j = np.clip((x - LOW[0]) / STEP, 0, last[0]), np.clip((z - LOW[1]) / STEP, 0, last[1])
    a, b = i.astype(int), j.astype(int)
    s, t = i - a, j - b
    d = (NET[a, b] * (1 - s) + NET[a + 1, b] * s) * (1 - t) + (NET[a, b + 1] * (1 - s) + NET[a + 1, b + 1] * s) * t
    return d + np.hypot(x - LOW[0] - i * STEP, z - LOW[1] - j * STEP)


def ridged(x, z, seed, size, octaves):
    """Crests and wide valleys, 0..1: folded noise, each octave strongest on the crests of the one before."""
    total, weight, norm, amplitude = 0.0, 1.0, 0.0, 1.0
    for k in range(octaves):
        n = np.clip(1.08 - np.sqrt(waves(x, z, seed + k, size / 1.9**k, 1) ** 2 + 0.006), 0, 1)
        total = total + amplitude * n * weight
        norm += amplitude
        weight = np.clip(n * 1.25, 0, 1)
        amplitude *= 0.47
    return total / norm


def height(x, z):
    x, z = np.broadcast_arrays(np.asarray(x, float), np.asarray(z, float))
    d = fromShore(x, z)
    mass = 0
    for px, pz, top, wide, deep in PEAKS:
        q = np.hypot((x - px) / wide, (z - pz) / deep)
        mass = mass + top * np.exp(-1.2 * q**1.7)
    crest = ridged(x, z, 4, 1700, 6)
    rise = smooth(25, 900, d)
    gullies = ridged(x + 0.12 * crest * 900, z, 20, 620, 5)
    hills = mass * rise * (0.12 + 0.80 * crest + 0.42 * gullies)
    # Low towards the sun, so that it reaches the jetty.
    low = 1 - 0.8 * np.exp(-((x - 75) ** 2 + (z - 75) ** 2) / 95**2)
    bank = 0.9 * smooth(-0.6, 2.2, d) + low * (5 * smooth(3, 60, d) + 0.045 * np.clip(d - 10, 0, 400))
    rough = waves(x, z, 51, 46, 4) * np.clip(d - 2, 0, 60) * 0.045 + waves(x, z, 52, 7, 3) * np.clip(d, 0, 3) * 0.06
    land = bank + rough + hills
    bed = DEEPEST * (1 - np.exp(np.minimum(d, 0) / 46)) - 0.06 + 0.05 * waves(x, z, 53, 5, 3) * np.clip(-d, 0, 3)
    return np.where(d > 0, np.maximum(land, 0.02 * np.minimum(d, 10)), bed)


# --- colour -----------------------------------------------------------------------------------------------------------

SNOW, ROCK, WARM, SCREE, MEADOW, FOREST, PEBBLE, WET = (
    rgb(c) for c in ("#e9eef4", "#7d7a7a", "#8f8378", "#9a9288", "#7f8a4a", "#33482c", "#a39a8c", "#5d574c")
)
AIR = rgb("#8fa3bd")


def paint(x, y, z, slope, d):
    """By height, slope and noise; farther off the air is in it."""
    broad, fine, grain = waves(x, z, 61, 420, 4), waves(x, z, 62, 90, 4), waves(x, z, 63, 19, 3)
    strata = np.sin(y / 17 + 3 * fine + broad)
    rock = mix(ROCK, WARM, np.clip(0.5 + 0.5 * strata + 0.4 * grain, 0, 1)) * (1 + 0.30 * fine + 0.22 * grain)[..., None]
    rock = mix(rock, SCREE * (1 + 0.15 * grain)[..., None], smooth(0.75, 0.45, slope) * smooth(-0.1, 0.4, fine))
    turf = MEADOW * (1 + 0.25 * fine + 0.25 * grain)[..., None]
    woods = FOREST * (1 + 0.30 * fine + 0.65 * grain)[..., None]
    treeline = 300 + 90 * broad + 60 * fine
    green = mix(turf, woods, smooth(-0.25, 0.25, grain * 0.5 + fine + 0.35) * smooth(6, 26, d))
    green = mix(green, turf * 0.92, smooth(treeline - 60, treeline, y))
    c = mix(green, rock, np.maximum(smooth(0.80, 1.15, slope + 0.15 * grain), smooth(treeline, treeline + 90, y)))
    snowline = 400 + 110 * fine + 60 * grain + 260 * smooth(0.7, 1.5, slope)
    c = mix(c, SNOW * (1 - 0.06 * np.abs(grain))[..., None], smooth(snowline - 18, snowline + 40, y))
    c = mix(c, PEBBLE * (1 + 0.3 * grain)[..., None], 1 - smooth(1.5, 4.5, d + 1.5 * grain))
    c = mix(c, WET * (1 + 0.3 * grain)[..., None], 1 - smooth(-0.1, 0.16, y))
    bed = mix(PEBBLE * 0.75, rgb("#5f6a52") * 0.7, smooth(0.8, 6, -y)) * (1 + 0.25 * grain)[..., None]
    c = mix(c, bed, smooth(0.05, 0.4, -y))
    away = np.hypot(x - EYE[0], z - EYE[1])
    return mix(c, AIR * 0.9, 0.62 * (1 - np.exp(-np.maximum(away - 150, 0) / 4200)))


def rings():
    """Azimuths (0 looks along +x, 90 along +z) and radii of the mesh: fine towards -z, coarse behind."""
    azimuth = np.radians(np.concatenate([np.linspace(176, 364, 172), np.linspace(364, 536, 31)[1:]]))
    radius = np.concatenate([[0.0], 40 + 4500 * np.linspace(0, 1, 74) ** 1.7])
    return azimuth, radius


def places(azimuth, radius):
    a, r = np.meshgrid(azimuth, radius, indexing="ij")
    return EYE[0] + r * np.cos(a), EYE[1] + r * np.sin(a)


def slopeAt(x, z, e):
    dx = (height(x + e, z) - height(x - e, z)) / (2 * e)
    dz = (height(x, z + e) - height(x, z - e)) / (2 * e)
    return dx, dz


def land():
    azimuth, radius = rings()
    x, z = places(azimuth, radius)
    y = height(x, z)
    r = np.broadcast_to(radius, x.shape)
    near = np.hypot(x - EYE[0], z - EYE[1]) < 85
    y = y - 0.9 * (near & (y > -30)) * smooth(85, 60, np.hypot(x - EYE[0], z - EYE[1]))  # foreground() lies above it
    u = np.linspace(0, 1, len(azimuth))
    v = np.linspace(0, 1, len(radius))
    uv = np.stack(np.meshgrid(u, v, indexing="ij"), -1)
    s = shape.grid(np.stack([x, y, z], -1), np.ones(3), uv, shape.SMOOTH)
    # Normals of the land itself rather than of its facets.
    e = np.maximum(np.hypot(s.p[:, 0] - EYE[0], s.p[:, 2] - EYE[1]) * 0.008, 0.5)
    dx, dz = slopeAt(s.p[:, 0], s.p[:, 2], e)
    s.n = np.stack([-dx, np.ones_like(dx), -dz], -1)
    s.n /= np.linalg.norm(s.n, axis=1, keepdims=True)
    return s


def plain():
    """From where land() ends to as far as air lets one see: low hills, of which eyes by the lake see little."""
    azimuth, radius = rings()
    radius = np.concatenate([radius[-1:], [5200, 6400, 8000, 11000, 16000, 24000, 36000]])
    x, z = places(azimuth, radius)
    hills = np.maximum(60 * waves(x, z, 71, 5000, 3), -15)  # above the lake
    y = height(x, z) + hills * smooth(radius[0], 8000, np.hypot(x - EYE[0], z - EYE[1]))
    color = paint(x, y, z, np.zeros_like(y), fromShore(x, z))
    return shape.grid(np.stack([x, y, z], -1), color, None, shape.SMOOTH)


def picture(size=(544, 720)):
    """Texture of land(): rows by radius, columns by azimuth; what relief is finer than the mesh is in its tones."""
    azimuth, radius = rings()
    u = (np.arange(size[1]) + 0.5) / size[1] * (len(azimuth) - 1)
    v = (np.arange(size[0]) + 0.5) / size[0] * (len(radius) - 1)
    a = np.interp(u, np.arange(len(azimuth)), azimuth)
    r = np.interp(v, np.arange(len(radius)), radius)
    x, z = (q.T for q in places(a, r))
    e = np.maximum(r * 0.004, 0.3)[:, None]
    dx, dz = slopeAt(x, z, e)
    wide = slopeAt(x, z, e * 4)
    y, d = height(x, z), fromShore(x, z)
    c = paint(x, y, z, np.hypot(dx, dz), d)
    # A slope that turns towards the light in the small is lighter than the mesh's own.
    relief = -(dx - wide[0]) * 0.55 - (dz - wide[1]) * 0.45
    return np.clip(c * (1 + 0.75 * np.clip(relief, -0.6, 0.8))[..., None], 0, 1)


def foreground():
    """The shore about the eye, finely."""
    from .land import spaced

    xs = spaced((-62, -26, 4.0), (-26, 26, 1.25), (26, 62, 4.0))
    zs = spaced((-44, -14, 3.5), (-14, 24, 1.1), (24, 62, 5.0))
    z, x = np.meshgrid(zs, xs, indexing="ij")
    y = height(x, z)
    dx, dz = slopeAt(x, z, 0.4)
    c = paint(x, y, z, np.hypot(dx, dz), fromShore(x, z))
    y = y - 1.2 * smooth(52, 62, np.maximum(np.abs(x), np.abs(z - 9) * 1.15))
    uv = np.stack([x, z], -1) / 2.6
    return shape.grid(np.stack([x, y, z], -1), np.clip(c * 1.15, 0, 1), uv, shape.SMOOTH)
