"""Small tiling textures, grey as they only modulate colour, and a PNG writer for them."""
import struct
import zlib

import numpy as np


def png(image, levels=20):
    """Grey [h,w] 0..1, in few enough levels to compress well."""
    value = np.round(np.clip(image, 0, 1) * (levels - 1)) / (levels - 1) * 255
    rows = value.astype(np.uint8)
    raw = b"".join(
        b"\2" + (rows[y].astype(int) - (rows[y - 1] if y else 0)).astype(np.uint8).tobytes() for y in range(len(rows))
    )
    plain = b"".join(b"\0" + row.tobytes() for row in rows)
    packed = min((zlib.compress(r, 9) for r in (raw, plain)), key=len)

    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    header = struct.pack(">IIBBBBB", rows.shape[1], rows.shape[0], 8, 0, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", packed) + chunk(b"IEND", b"")


def noise(size, cells, seed):
    """Value noise that tiles; `cells` one number or (down, across); 0..1 about 0.5."""
    down, across = np.broadcast_to(cells, 2)
    lattice = np.random.default_rng(seed).random((down, across))
    y, x = np.arange(size) * down / size, np.arange(size) * across / size
    fade = lambda t: t * t * (3 - 2 * t)
    y0, x0 = y.astype(int), x.astype(int)
    fy, fx = fade(y - y0)[:, None], fade(x - x0)[None]
    y1, x1 = (y0 + 1) % down, (x0 + 1) % across
    return (lattice[np.ix_(y0, x0)] * (1 - fx) + lattice[np.ix_(y0, x1)] * fx) * (1 - fy) + (
        lattice[np.ix_(y1, x0)] * (1 - fx) + lattice[np.ix_(y1, x1)] * fx
    ) * fy


def withoutSlowParts(image, turns):
    """Less what is longer than a tile over so many turns: from afar that is what shows that a tile repeats."""
    size = len(image)
    slow = np.hypot(np.fft.fftfreq(size)[:, None], np.fft.rfftfreq(size)[None]) * size / turns
    return np.fft.irfft2(np.fft.rfft2(image) * (1 - np.exp(-(slow**4))), image.shape)


def wood(size=128):
    """Grain along v (down)."""
    fine = 0.5 * noise(size, (4, 64), 1) + 0.3 * noise(size, (8, 32), 2) + 0.2 * noise(size, (2, 16), 3)
    crack = np.clip(noise(size, (3, 40), 4) - 0.80, 0, 1) * 3
    return np.clip(0.66 + 0.5 * (fine - 0.5) - crack, 0, 1) + 0.08


def boards(size=128, count=6):
    """Upright boards along v with dark joints."""
    x = (np.arange(size) * count / size) % 1
    joint = np.minimum(x, 1 - x)
    tint = np.random.default_rng(11).random(count)[(np.arange(size) * count // size)]
    return (
        np.clip(wood(size) * 0.55 + 0.42 + 0.12 * (tint - 0.5)[None], 0, 1)
        * (0.45 + 0.55 * np.clip(joint / 0.07, 0, 1))[None]
    )


def rock(size=128):
    """Grain with a few faint cracks."""
    n = sum(0.66**i * (noise(size, 5 << i, 20 + i) - 0.5) for i in range(5))
    warped = 0.5 * noise(size, 5, 30) + 0.3 * noise(size, 11, 31) + 0.2 * noise(size, 23, 32)
    crack = np.clip(1 - np.abs(warped - 0.5) / 0.018, 0, 1)
    return np.clip(0.78 + 0.42 * n - 0.16 * crack, 0, 1)


def plaster(size=128):
    n = sum(0.8**i * (noise(size, 6 << i, 60 + i) - 0.5) for i in range(4))
    return np.clip(0.93 + 0.10 * n, 0, 1)


def ground(size=128):
    """Sand, gravel and turf from far enough away."""
    n = sum(0.85**i * (noise(size, 9 << i, 40 + i) - 0.5) for i in range(4))
    return np.clip(0.8 + 0.34 * n, 0, 1)


def tiles(size=128, rows=8, columns=8):
    """Roof tiles, v down the slope."""
    y = np.arange(size) * rows / size
    row = y.astype(int)
    x = np.arange(size) * columns / size
    shifted = (x[None] + 0.5 * (row % 2)[:, None]) % columns
    tint = np.random.default_rng(51).random((rows, columns))[row[:, None], shifted.astype(int)]
    joint = np.minimum(shifted % 1, 1 - shifted % 1)
    lip = np.clip((1 - (y % 1)) / 0.22, 0, 1)[:, None]
    return np.clip((0.78 + 0.25 * (tint - 0.5)) * (0.5 + 0.5 * lip) * (0.6 + 0.4 * np.clip(joint / 0.09, 0, 1)), 0, 1)
