"""Wooden huts: boarded walls with corner posts, a tiled gable roof with eaves, a door, windows. The ridge runs along x;
+z is the front. The floor is at y = 0."""
import numpy as np

from . import shape
from .shape import rgb

STEPS = 5  # rows of vertices up a wall: enough for the shade under the eaves


def hut(
    size,
    wall,
    trim="#f2efe6",
    roof="#8a4b38",
    door="#3d5a4a",
    tall=2.4,
    pitch=0.85,
    windows=((-0.3, "front"), (0.3, "front")),
    doorAt=0.0,
    doorSide="front",
    chimney=False,
):
    """`size` along x and z. Windows and door: share of the side's length from its middle, and the side. Gives the hut,
    and (position, yaw in degrees) of each window, for window() to be placed there."""
    asset = shape.Asset()
    w, d = size
    wall, trim = rgb(wall), rgb(trim)
    ridge = tall + d / 2 * pitch
    for side, (a, b) in {
        "front": ((-w / 2, d / 2), (w / 2, d / 2)),
        "back": ((w / 2, -d / 2), (-w / 2, -d / 2)),
        "right": ((w / 2, d / 2), (w / 2, -d / 2)),
        "left": ((-w / 2, -d / 2), (-w / 2, d / 2)),
    }.items():
        gable = side in ("left", "right")
        asset.add("boards", wallOf(np.array(a), np.array(b), tall, ridge if gable else tall, wall))
    for x in (-w / 2, w / 2):
        for z in (-d / 2, d / 2):
            asset.add("paint", shape.box((0.14, tall, 0.14), (x, tall / 2, z), trim))
    asset.add("paint", shape.box((w + 0.06, 0.14, d + 0.06), (0, 0.07, 0), rgb("#8c8479")))
    roofOver(asset, w, d, tall, ridge, pitch, rgb(roof), trim)
    places = {"front": (0, d / 2, w), "back": (180, d / 2, w), "right": (90, w / 2, d), "left": (-90, w / 2, d)}
    panes = []
    for share, side in windows:
        turn, out, length = places[side]
        panes.append((shape.about("y", turn) @ np.array([share * length, tall * 0.56, out]), turn))
    turn, out, length = places[doorSide]
    asset.include(doorOf(trim, rgb(door)), lambda s: shape.yawed(shape.move(s, (doorAt * length, 0.1, out)), turn))
    if chimney:
        asset.add("stone", shape.box((0.55, 1.3, 0.55), (w * 0.24, ridge + 0.25, 0), rgb("#a9674f"), 1.4))
        asset.add("paint", shape.box((0.66, 0.10, 0.66), (w * 0.24, ridge + 0.93, 0), rgb("#5d5650")))
    return asset, panes


def wallOf(a, b, tall, peak, color):
    """From a to b (x, z), seen from outside left to right; rises to a peak in the middle."""
    n = 6
    s = np.linspace(0, 1, n + 1)
    top = tall + (peak - tall) * (1 - np.abs(2 * s - 1))
    t = np.linspace(0, 1, STEPS + 1)
    p = np.zeros((n + 1, STEPS + 1, 3))
    p[..., 0] = (a[0] + (b - a)[0] * s)[:, None]
    p[..., 2] = (a[1] + (b - a)[1] * s)[:, None]
    p[..., 1] = top[:, None] * t
    length = np.linalg.norm(b - a)
    uv = np.stack([np.broadcast_to((s * length)[:, None] / 1.1, p.shape[:2]), p[..., 1] / 1.6], -1)
    return shape.grid(p, color, uv, shape.FLAT)


def roofOver(asset, w, d, tall, ridge, pitch, color, trim):
    eaves, gable, thick = 0.42, 0.38, 0.11
    run = d / 2 + eaves
    low = ridge - run * pitch + 0.06
    high = ridge + 0.06
    x = np.linspace(-w / 2 - gable, w / 2 + gable, 7)
    for sign in (1, -1):
        s = np.linspace(0, 1, 5)
        p = np.zeros((7, 5, 3))
        p[..., 0] = x[:, None]
        p[..., 1] = high + (low - high) * s
        p[..., 2] = sign * run * s
        uv = np.stack([p[..., 0] / 1.5, np.abs(p[..., 2]) * np.hypot(1, pitch) / 1.5], -1)
        over = p + [0, thick, 0]
        asset.add("tiles", shape.grid(over, color, uv, shape.FLAT, flip=sign > 0))
        asset.add("paint", shape.grid(p, rgb("#6b5a49"), None, shape.FLAT, flip=sign < 0))
        edge = np.stack([p[:, -1], over[:, -1]], 1)
        asset.add("paint", shape.grid(edge, trim, None, shape.FLAT, flip=sign < 0))
        for end in (0, -1):
            face = np.stack([p[end] - [0, 0.08, 0], over[end]], 1)
            asset.add("paint", shape.grid(face, trim, None, shape.FLAT, flip=(end == 0) != (sign > 0)))
    asset.add("paint", shape.box((w + 2 * gable, 0.07, 0.22), (0, high + thick + 0.01, 0), color * 0.75))


def window(trim):
    """Panes set into a frame; faces +z."""
    asset = shape.Asset().add("glass", shape.box((0.78, 0.92, 0.04), (0, 0, 0.02), rgb("#39485a")))
    for y in (-0.5, 0.5):
        asset.add("paint", shape.box((1.02, 0.10, 0.09), (0, y, 0.03), trim))
    for x in (-0.45, 0.45):
        asset.add("paint", shape.box((0.12, 0.92, 0.08), (x, 0, 0.03), trim))
    asset.add(
        "paint", shape.box((0.05, 0.92, 0.07), (0, 0, 0.02), trim), shape.box((0.78, 0.05, 0.07), (0, 0.08, 0.02), trim)
    )
    return asset


def doorOf(trim, color):
    asset = shape.Asset().add("boards", shape.box((0.92, 1.95, 0.06), (0, 0.98, 0.02), color, 0.6, cuts=3))
    for x in (-0.52, 0.52):
        asset.add("paint", shape.box((0.12, 2.05, 0.10), (x, 1.02, 0.03), trim))
    asset.add("paint", shape.box((1.28, 0.13, 0.12), (0, 2.08, 0.03), trim))
    asset.add("paint", shape.box((0.05, 0.16, 0.05), (0.34, 0.95, 0.07), rgb("#2a2a2a")))
    return asset
