"""Tiling textures in colour, and a PNG writer for them: brick, planks, paint, stone."""
import struct
import zlib

import numpy as np

from . import texture
from .shape import rgb


def png(image, levels=48):
    """[h,w,3 or 4], linear colour and plain alpha, 0..1; in few enough levels to compress well."""
    color = np.clip(image[..., :3], 0, 1)
    shown = np.where(color <= 0.0031308, 12.92 * color, 1.055 * color ** (1 / 2.4) - 0.055)
    value = np.concatenate([shown, np.clip(image[..., 3:], 0, 1)], -1)
    rows = (np.round(value * (levels - 1)) / (levels - 1) * 255 + 0.5).astype(np.uint8)
    height, width, channels = rows.shape

    def filtered(kind):
        for y in range(height):
            above = rows[y - 1].astype(int) if y else np.zeros((width, channels), int)
            left = np.concatenate([np.zeros((1, channels), int), rows[y, :-1].astype(int)])
            taken = (0, left, above)[kind]
            yield bytes([kind]) + (rows[y].astype(int) - taken).astype(np.uint8).tobytes()

    packed = min((zlib.compress(b"".join(filtered(kind)), 9) for kind in range(3)), key=len)

    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    header = struct.pack(">IIBBBBB", width, height, 8, 6 if channels == 4 else 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", packed) + chunk(b"IEND", b"")


def mix(a, b, t):
    return a + (b - a) * np.asarray(t)[..., None]


def cloudy(size, cells, seed, octaves=4, fall=0.6):
    """Noise of several sizes, about -1..1."""
    n = sum(fall**i * (texture.noise(size, cells << i, seed + i) - 0.5) for i in range(octaves))
    return 2 * n / sum(fall**i for i in range(octaves))


def cells(size, rows, columns, shift):
    """Courses of bricks or planks: which one each texel is in, and how far from its edges [texels]."""
    y = np.arange(size) * rows / size
    row = y.astype(int)
    x = (np.arange(size)[None] * columns / size + shift * (row % 2)[:, None]) % columns
    column = x.astype(int)
    fromSide = np.minimum(x % 1, 1 - x % 1) * size / columns
    fromEnd = (np.minimum(y % 1, 1 - y % 1) * size / rows)[:, None]
    return row[:, None] * columns + column, np.minimum(fromSide, fromEnd)


def brick(size=256, rows=12, columns=4):
    """A repeat is 1 m wide and 0.96 m tall."""
    which, edge = cells(size, rows, columns, 0.5)
    rng = np.random.default_rng(3)
    tones = np.array([rgb(c) for c in ("#9a4a36", "#8a3f30", "#a85a41", "#7a3a2e", "#b06a4c", "#94503e")])
    tone = tones[rng.integers(len(tones), size=rows * columns)] * rng.uniform(0.8, 1.15, rows * columns)[:, None]
    grain = cloudy(size, 24, 10, 3)
    stone = tone[which] * (1 + 0.35 * grain + 0.15 * cloudy(size, 6, 15))[..., None]
    stone = mix(stone, rgb("#4a2c25"), np.clip(cloudy(size, 32, 17, 2) - 0.35, 0, 1))
    mortar = rgb("#b5aa98") * (0.85 + 0.3 * grain)[..., None]
    return mix(mortar, stone, np.clip((edge + 0.8 * grain - 1.6) / 1.2, 0, 1))


def planks(size=256, count=5, color="#a9814f", seed=30):
    """Upright boards with grain, knots, gaps and nails."""
    which, edge = cells(size, 1, count, 0)
    rng = np.random.default_rng(seed)
    grain = 0.55 * texture.noise(size, (5, 90), seed) + 0.45 * texture.noise(size, (3, 40), seed + 1)
    tint = rng.uniform(0.75, 1.15, count)[which]
    wood = rgb(color) * (tint * (0.65 + 0.6 * grain))[..., None]
    y, x = np.mgrid[:size, :size]
    for _ in range(4):
        at = rng.uniform(0, size, 2)
        away = np.hypot((y - at[0]) / 1.7, x - at[1])
        wood *= (1 - 0.55 * np.exp(-((away / 5) ** 2)) - 0.15 * np.cos(away * 0.9) * np.exp(-away / 14))[..., None]
    side = np.minimum((x * count / size) % 1, 1 - (x * count / size) % 1) * size / count
    wood *= (0.25 + 0.75 * np.clip(side / 2.2, 0, 1))[..., None]
    nail = np.hypot(side - 9, np.minimum(np.abs(y - 14), np.abs(y - size + 15)))
    return wood * (1 - 0.7 * np.clip(2.6 - nail, 0, 1))[..., None]


def crate(size=256):
    """One side of a wooden box: planks within a frame, a brace across, and a stencil."""
    wood = planks(size)
    y, x = np.mgrid[:size, :size] / size
    border = np.minimum(np.minimum(x, 1 - x), np.minimum(y, 1 - y))
    across = np.abs(x - y) / 2**0.5
    frame = planks(size, 1, "#b8935c", 50)
    turned = np.transpose(frame, (1, 0, 2))
    upright = np.minimum(x, 1 - x) < np.minimum(y, 1 - y)
    wood *= (1 - 0.6 * np.exp(-np.maximum(border - 0.11, 0) / 0.02) * (border > 0.11))[..., None]
    wood *= (1 - 0.5 * np.exp(-np.maximum(across - 0.06, 0) / 0.015) * (across > 0.06))[..., None]
    wood = np.where((across < 0.06)[..., None], turned * 0.9, wood)
    wood = np.where((border < 0.11)[..., None], np.where(upright[..., None], frame, turned), wood)
    return wood * (1 - 0.5 * np.clip(1 - np.abs(border - 0.11) * size / 2, 0, 1))[..., None]


def painted(size=256):
    """Sheet metal in two colours with a slanting stripe, chipped to primer and rust at its edges."""
    y, x = np.mgrid[:size, :size] / size
    band = (y > 0.36) & (y < 0.64)
    slant = ((x * 6 + y * 6) % 1) < 0.5
    yellow, blue, black = rgb("#d9a326"), rgb("#2d5f86"), rgb("#26262a")
    color = np.where(band[..., None], np.where(slant[..., None], yellow, black), blue)
    wear = cloudy(size, 10, 70, 5, 0.7)
    border = np.minimum(np.minimum(x, 1 - x), np.minimum(y, 1 - y))
    color = color * (1 + 0.12 * cloudy(size, 4, 80) + 0.06 * wear)[..., None]
    bare = np.clip((wear - 0.42 + 0.75 * np.exp(-border / 0.03)) * 9, 0, 1)
    rust = mix(rgb("#7d7f80"), rgb("#6b3418"), np.clip(0.5 + 1.4 * cloudy(size, 20, 90), 0, 1))
    color = mix(color, rust, bare)
    ridge = np.abs(border - 0.06)
    return color * (1 - 0.35 * np.exp(-((ridge * size / 2) ** 2)))[..., None]


def mosaic(tones, grout, size=256, tiles=8, joint=1.6, seed=60):
    """Square tiles, each of one of the tones and a little tilted in its own, on grout."""
    which, edge = cells(size, tiles, tiles, 0)
    rng = np.random.default_rng(seed)
    tone = np.array([rgb(c) for c in tones])[rng.integers(len(tones), size=tiles * tiles)]
    tone = tone * rng.uniform(0.88, 1.08, tiles * tiles)[:, None]
    glaze = tone[which] * (1 + 0.05 * cloudy(size, 12, seed + 1, 3))[..., None]
    return mix(rgb(grout), glaze, np.clip((edge - joint / 2) / 0.8, 0, 1))


def veins(size, seed, cellsAcross=4, sharp=0.018):
    """Thin lines that wander, 0..1."""
    n = cloudy(size, cellsAcross, seed, 5, 0.62)
    return np.exp(-np.abs(n) / sharp) + 0.5 * np.exp(-np.abs(cloudy(size, cellsAcross, seed + 20, 5, 0.66)) / (0.6 * sharp))


def marble(size=256):
    light = rgb("#e4ded2") * (1 + 0.10 * cloudy(size, 5, 100))[..., None]
    return mix(light, rgb("#8d8a86"), np.clip(0.55 * veins(size, 110, 3, 0.02), 0, 0.7))


def stoneTiles(size=512, tiles=2):
    """Polished slabs, light and dark in turn, each with veins of its own; alpha: the polish, which joints lack."""
    y, x = np.mgrid[:size, :size] * tiles / size
    row, column = y.astype(int), x.astype(int)
    dark = (row + column) % 2 == 1
    image = np.zeros((size, size, 4))
    for kind in range(tiles * tiles):
        here = row * tiles + column == kind
        cloud, thread = cloudy(size, 4, 200 + 40 * kind, 6, 0.68), veins(size, 215 + 40 * kind, 3)
        if (kind // tiles + kind % tiles) % 2:
            slab = rgb("#2b3833") * (1 + 0.55 * cloud)[..., None]
            slab = mix(slab, rgb("#a9b3a4"), np.clip(0.55 * thread, 0, 0.7))
        else:
            slab = rgb("#c9b798") * (1 + 0.16 * cloud)[..., None]
            slab = mix(slab, rgb("#8a6a4a"), np.clip(0.45 * thread, 0, 0.6))
        image[here, :3] = slab[here]
    # Scuffs dull the coat a little, as feet do.
    polish = 1 - 0.18 * np.clip(cloudy(size, 6, 400, 5, 0.75) + 0.1, 0, 1) - 0.06 * dark
    edge = np.minimum(np.minimum(x % 1, 1 - x % 1), np.minimum(y % 1, 1 - y % 1)) * size / tiles
    joint = np.clip(2.0 - edge, 0, 1)
    image[..., :3] = mix(image[..., :3], rgb("#4d473f"), joint)
    image[..., 3] = polish * (1 - 0.9 * joint)
    return image
