"""A footbridge of timber, by its parts, and what stands in the shallows beside one: stakes and reeds."""
import numpy as np

from . import pier, shape
from .shape import rgb

WIDE, THICK = 2.3, 0.06


def deckHeight(x, length, ends, middle):
    """Of the planks' top, an arc."""
    return ends + (middle - ends) * (1 - (2 * x / length - 1) ** 2)


def span(length, ends, middle):
    """Runs along +x from x = 0 to `length`: planks, four stringers, crossbeams between them, braces, railings."""
    rng = np.random.default_rng(5)
    parts = []
    top = lambda x: deckHeight(x, length, ends, middle)
    step = 0.24
    for x in np.arange(step / 2, length, step):
        tone = rgb("#b39a7c") * rng.uniform(0.72, 1.12) * [1, rng.uniform(0.95, 1.02), rng.uniform(0.88, 1.02)]
        slope = np.degrees(np.arctan((top(x + 0.1) - top(x - 0.1)) / 0.2))
        plank = shape.box((step - 0.018, THICK, WIDE + rng.uniform(-0.06, 0.06)), (0, -THICK / 2, 0), tone, 0.55)
        plank.c[plank.n[:, 1] < -0.5] *= 0.55
        plank.uv = plank.uv + rng.random(2)
        parts.append(shape.move(shape.turn(plank, shape.about("z", slope)), (x, top(x), 0)))
    runs = np.linspace(0, length, 11)
    for z in (-0.95, -0.33, 0.33, 0.95):
        for a, b in zip(runs[:-1], runs[1:]):
            parts.append(pier.beam((a, top(a) - 0.19, z), (b, top(b) - 0.19, z), (0.14, 0.26)))
    for x in runs[1:-1]:
        parts.append(pier.beam((x, top(x) - 0.40, -1.15), (x, top(x) - 0.40, 1.15), (0.16, 0.16), "#6f5c48"))
    for a, b, side in zip(runs[1:-2], runs[2:-1], np.resize([1, -1], len(runs) - 3)):
        parts.append(
            pier.beam((a, top(a) - 0.36, -0.9 * side), (b, top(b) - 0.36, 0.9 * side), (0.08, 0.08), "#5f5040")
        )
    paint = []
    for z in (-1.05, 1.05):
        for a, b in zip(runs[:-1], runs[1:]):
            paint.append(pier.railing((a, top(a), z), (b, top(b), z), int(10 * a)))
    return shape.join(parts), shape.join(paint)


def trestle(top, bottom):
    """Two leaning posts and their braces, across the bridge."""
    lean = lambda y: 0.85 + 0.10 * (top - y)
    parts = []
    for side in (-1, 1):
        post = pier.post(3 + side, top - bottom, 0, 0.15)
        tilt = shape.turn(post, shape.about("x", -side * np.degrees(np.arctan(0.10))))
        parts.append(shape.move(tilt, (0, bottom, side * lean(bottom))))
    parts.append(pier.beam((0, top - 0.1, -1.2), (0, top - 0.1, 1.2), (0.22, 0.22), "#6f5c48"))
    for side in (-1, 1):
        low, high = 0.35, top - 0.35
        parts.append(
            pier.beam((0.1 * side, low, -side * lean(low)), (0.1 * side, high, side * lean(high)), (0.06, 0.14), "#5f5040")
        )
    return shape.join(parts)


def abutment(wide, tall, seed):
    """Courses of rough stone under an end of the bridge, the face towards -x and +x alike; its top at y = 0."""
    rng = np.random.default_rng(seed)
    parts = []
    for y in np.arange(0, tall, 0.55):
        for z in np.arange(-wide / 2, wide / 2, 0.8):
            tone = rgb(("#a39b8c", "#918a80", "#b0a58f", "#87817a")[rng.integers(4)]) * rng.uniform(0.85, 1.1)
            stone = shape.box((1.9 + rng.uniform(-0.08, 0.08), 0.52, 0.77), (0, -y - 0.27, z + 0.4), tone, 0.55)
            stone.uv = stone.uv + rng.random(2)
            parts.append(stone)
    return shape.join(parts)


def stake(seed, tall):
    """A peeled pole that nets are hung on: 3 to 5 cm thick, wet at its foot."""
    rng = np.random.default_rng(seed)
    y = np.array([-2.5, 0.08, 0.3, tall])
    r = rng.uniform(0.020, 0.026) * np.array([1.1, 1.0, 1.0, 0.6])
    wet, dry = rgb("#40382c"), rgb("#a8937a") * rng.uniform(0.8, 1.1)
    return shape.lathe(np.stack([r, y], 1), 6, np.array([wet, wet, dry * 0.8, dry]), shape.SMOOTH)


def reeds(seed, count=14, reach=0.5):
    """A clump of stalks a centimetre thick, with a drooping leaf on each and a plume on some."""
    rng = np.random.default_rng(seed)
    parts = []
    for _ in range(count):
        at = rng.uniform(-reach, reach, 2)
        tall, lean = rng.uniform(0.9, 1.9), rng.normal(scale=0.13, size=2)
        tone = rgb("#8c8a48") * rng.uniform(0.7, 1.15)
        top = np.array([at[0] + lean[0] * tall, tall, at[1] + lean[1] * tall])
        foot = np.array([at[0], -0.9, at[1]])
        parts.append(shape.tube([foot, foot * 0.45 + top * 0.55, top], [0.007, 0.006, 0.003], tone, 3, False))
        a, turn = foot * 0.35 + top * 0.65, rng.uniform(0, 2 * np.pi)
        out = np.array([np.cos(turn), 0, np.sin(turn)])
        side = np.array([-out[2], 0, out[0]]) * 0.010
        b, c = a + out * 0.16 + [0, 0.22, 0], a + out * 0.42 + [0, 0.12, 0]
        leaf = shape.polygons([a - side, b - side, c, b + side, a + side], [(0, 1, 2, 3, 4)], tone * 1.1)
        parts.append(leaf)
        if rng.random() < 0.4:
            parts.append(shape.lathe([(0.004, 0), (0.022, 0.06), (0.0, 0.24)], 5, rgb("#6d5a3a"), shape.SMOOTH))
            parts[-1] = shape.move(parts[-1], top - [0, 0.02, 0])
    return shape.join(parts)
