"""A white and red lighthouse, about 16 m from the rock to the vane: tower, gallery, lamp room, dome. Base at y = 0."""
import numpy as np

from . import shape
from .shape import rgb

WHITE, RED, IRON = rgb("#f0ece2"), rgb("#b3322a"), rgb("#2d3236")


def lighthouse():
    asset = shape.Asset()
    tower(asset)
    gallery(asset, 11.3, 2.15, 16)
    lampRoom(asset, 11.45)
    return asset


def radius(y):
    return 2.25 - 0.75 * (y / 11) ** 0.8


def tower(asset):
    asset.add(
        "stone",
        shape.lathe(
            [(3.0, -1.6), (2.95, 0.0), (2.8, 0.35), (2.75, 0.55), (2.2, 0.6)], 18, rgb("#9a948a"), 30, (6, 0.4)
        ),
    )
    bands = [(0.55, 2.9, WHITE), (2.9, 5.1, RED), (5.1, 7.3, WHITE), (7.3, 9.4, RED), (9.4, 11.0, WHITE)]
    for low, high, color in bands:
        y = np.linspace(low, high, 3)
        asset.add("plaster", shape.lathe(np.stack([radius(y), y], 1), 22, color, shape.ROUNDED, (8, 0.5)))
    asset.add(
        "paint",
        shape.lathe(
            [(1.5, 10.75), (1.62, 10.95), (2.0, 11.2), (2.25, 11.25), (2.25, 11.42), (1.3, 11.45)], 22, WHITE * 0.95, 30
        ),
    )
    turn = 38
    door = shape.Asset().add(
        "paint",
        shape.box((1.0, 2.1, 0.22), (0, 1.6, 2.17), rgb("#274b5e")),
        shape.box((1.3, 0.16, 0.3), (0, 2.72, 2.12), WHITE * 0.9),
    )
    for x in (-0.58, 0.58):
        door.add("paint", shape.box((0.16, 2.15, 0.3), (x, 1.6, 2.12), WHITE * 0.9))
    for k in range(3):
        door.add("stone", shape.box((1.7, 0.22, 0.42), (0, 0.5 - 0.2 * k, 2.55 + 0.36 * k), rgb("#a39d92"), 0.5))
    asset.include(door, lambda s: shape.yawed(s, turn))


def windows():
    """(position, yaw in degrees) of the tower's windows."""
    return [
        (shape.about("y", a) @ np.array([0, y, radius(y) - 0.02]), a)
        for y, a in ((4.0, 20), (6.2, 60), (8.35, 25), (6.2, -55))
    ]


def gallery(asset, floor, r, count):
    for k in range(count):
        a = 2 * np.pi * k / count
        at = np.array([r * np.cos(a), floor, r * np.sin(a)])
        asset.add("paint", shape.tube([at, at + [0, 1.1, 0]], 0.035, IRON, 4, False))
        inner = np.array([1.52 * np.cos(a), floor - 0.9, 1.52 * np.sin(a)])
        if k % 2 == 0:
            asset.add("paint", shape.between(inner, at + [0, -0.1, 0], (0.10, 0.14), WHITE * 0.85))
    for y in (0.45, 0.8, 1.1):
        asset.add("paint", shape.move(shape.torus(r, 0.035 if y > 1 else 0.022, IRON, 20, 3), (0, floor + y, 0)))


def lampRoom(asset, base):
    asset.add(
        "paint", shape.lathe([(1.22, base), (1.22, base + 0.75), (1.30, base + 0.78), (1.30, base + 0.86)], 12, RED, 30)
    )
    asset.add("glass", shape.lathe([(1.16, base + 0.84), (1.16, base + 2.45)], 12, rgb("#5d7280"), shape.FLAT))
    asset.add(
        "paint",
        shape.lathe(
            [(0, base + 1.0), (0.35, base + 1.05), (0.5, base + 1.6), (0.35, base + 2.2), (0, base + 2.3)],
            10,
            rgb("#ffe3a0"),
            shape.SMOOTH,
        ),
    )
    for k in range(12):
        a = 2 * np.pi * k / 12
        at = np.array([1.19 * np.cos(a), base + 0.84, 1.19 * np.sin(a)])
        asset.add("paint", shape.tube([at, at + [0, 1.62, 0]], 0.045, IRON, 4, False))
    asset.add("paint", shape.move(shape.torus(1.19, 0.035, IRON, 12, 4), (0, base + 1.65, 0)))
    dome = [
        (1.45, base + 2.42),
        (1.48, base + 2.52),
        (1.28, base + 2.75),
        (0.95, base + 3.15),
        (0.45, base + 3.5),
        (0.16, base + 3.62),
    ]
    asset.add("paint", shape.lathe([(0.9, base + 2.42)] + dome, 18, RED, 40))
    ball = [
        (0.08, base + 3.6),
        (0.22, base + 3.75),
        (0.22, base + 3.9),
        (0.05, base + 4.05),
        (0.02, base + 4.8),
        (0, base + 4.82),
    ]
    asset.add("paint", shape.lathe(ball, 8, IRON, shape.ROUNDED))
