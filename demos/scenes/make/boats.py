"""Boats. The bow points to +x; the water is at y = 0 when they float at their draught; hulls are closed."""
import numpy as np

from . import shape
from .hull import Hull
from .shape import rgb


def rowingBoat():
    """4.3 m, clinker built. Its hull is white, for a material to colour."""
    asset = shape.Asset()
    hull = Hull(4.3, 1.5, (0.36, 0.46, 0.66), (-0.16, -0.06, -0.02), transom=0.62, fullness=0.56, stations=15)
    main, stripe, inside = np.ones(3), rgb("#f1ece0"), rgb("#b98d5c")
    edges = np.array([0.0, 0.26, 0.42, 0.56, 0.70, 0.84, 1.0])
    rng = np.random.default_rng(5)
    for i in range(6):
        color = (stripe if i == 5 else main * (0.5 if i < 2 else 1)) * rng.uniform(0.93, 1.05)
        low, high = edges[i], edges[i + 1]
        p = hull.point(np.arange(15)[:, None], np.array([low, high])[None])
        p[:, 0, 2] += 0.018 * (i > 0)
        lap = np.stack([hull.point(np.arange(15), low), p[:, 0]], 1)
        for side in (1, -1):
            m = [1, 1, side]
            asset.add("paint" if i == 5 else "hull", shape.grid(p * m, color, None, 70, flip=side < 0))
            if side > 0:
                both = np.stack([p * [1, 1, -1], p])
                asset.add(
                    "paint" if i == 5 else "hull",
                    shape.grid(both[:, -1], color, flip=True),
                    shape.grid(both[:, 0], color * 0.9),
                )
            if i > 0:
                asset.add("hull", shape.grid(lap * m, color * 0.45, None, shape.SMOOTH, flip=side < 0))
    ts = np.linspace(0, 1, 7)
    wood = inside * np.linspace(0.45, 1.0, 7)[:, None]
    asset.add(
        "paint",
        hull.skin(ts, wood, 0.045, True, lift=0.03),
        hull.rim(0.045, inside * 1.15),
        hull.end(ts, wood, 0, 0.045, 1, 0.03),
    )
    top = hull.point(0, 1.0)
    asset.add("paint", shape.box((0.09, 0.03, 2 * top[2]), top * [1, 1, 0] + [0.025, 0.004, 0], inside * 1.2))
    for a, b, h in ((2, 3, 0.20), (6, 7, 0.20), (10, 11, 0.24)):
        x = (hull.s[a] + hull.s[b]) / 2 * 4.3 - 2.15
        wide = min(hull.breadthAt(a, h, 0.04), hull.breadthAt(b, h, 0.04)) - 0.02
        asset.add("wood", shape.box((0.26, 0.045, wide), (x, h, 0), inside * 1.3, 0.7))
    asset.add("wood", shape.box((2.2, 0.03, 0.42), (-0.2, -0.05, 0), inside * 0.7, 0.7))
    for k in range(3, 13, 2):
        rib = hull.point(k, np.linspace(0.25, 0.98, 5), 0.055, 0.03)
        for side in (1, -1):
            asset.add("paint", shape.tube(rib * [1, 1, side], 0.02, inside * 0.75, 4, False))
    rail = hull.point(np.arange(15), 1.0) + [0, 0.0, 0]
    for side in (1, -1):
        asset.add("paint", shape.tube(rail * [1, 1, side] + [0, 0, 0.012 * side], 0.028, inside * 1.25, 5, True))
    for side in (1, -1):
        a, b = np.array([-1.35, 0.30, 0.22 * side]), np.array([1.2, 0.40, 0.26 * side])
        asset.add(
            "paint",
            shape.tube([a, b], [0.026, 0.022], rgb("#d9b98a"), 5),
            shape.between(a - [0.5, 0.012, 0.0], a + [0.06, 0, 0], (0.15, 0.02), rgb("#c8402f")),
        )
    return asset


def sailingBoat():
    """8.2 m, mast 10.5 m above the water, the sail furled on the boom."""
    asset = shape.Asset()
    hull = Hull(
        8.2,
        2.7,
        (0.78, 0.82, 1.12),
        (-0.42, -0.05, 0.05),
        transom=0.66,
        fullness=0.60,
        bow=0.34,
        stations=19,
        rake=0.10,
    )
    white, navy, teak = rgb("#f3f1ea"), rgb("#1f3556"), rgb("#b58f60")
    bands = [(0.0, 0.52, rgb("#7a2a22")), (0.52, 0.60, white), (0.60, 0.92, navy), (0.92, 1.0, white)]
    for low, high, color in bands:
        ts = np.linspace(low, high, 5 if high - low > 0.2 else 2)
        asset.add("gloss", hull.skin(ts, color))
        asset.add("gloss", hull.end(ts, color, 0), hull.stem(ts, color))
    asset.add("paint", hull.deck(1.0, teak * 0.95, camber=0.07))
    toe = hull.point(np.arange(19), 1.0)
    for side in (1, -1):
        asset.add("paint", shape.tube(toe * [1, 1, side] + [0, 0.03, 0], 0.035, teak * 0.8, 4))
    deck = 0.84
    cabin = shape.box((3.1, 0.48, 1.55), (0.65, deck + 0.22, 0), white * 0.97, top=(0.90, 0.84), cuts=2)
    asset.add("gloss", cabin)
    asset.add("gloss", shape.box((2.7, 0.05, 1.25), (0.62, deck + 0.475, 0), white * 0.9))
    for x in (-0.3, 0.45, 1.2):
        for side in (1, -1):
            pane = shape.turn(shape.box((0.5, 0.16, 0.04), color=rgb("#27323d")), shape.about("x", -15 * side))
            asset.add("glass", shape.move(pane, (x, deck + 0.25, 0.715 * side)))
    for side in (1, -1):
        asset.add("paint", shape.box((2.2, 0.26, 0.10), (-2.25, deck + 0.12, 0.72 * side), teak * 0.9, cuts=3))
    asset.add(
        "paint",
        shape.box((2.1, 0.02, 1.3), (-2.25, deck + 0.03, 0), rgb("#5b4630")),
        shape.box((0.10, 0.28, 1.5), (-3.35, deck + 0.13, 0), teak * 0.9),
    )
    asset.add(
        "paint", shape.tube([(-3.2, deck + 0.1, 0), (-3.1, deck + 0.45, 0), (-2.3, deck + 0.6, 0)], 0.03, teak, 5)
    )
    spars(asset, deck)
    for x, z in (
        (3.6, 0.2),
        (3.6, -0.2),
        (2.2, 0.78),
        (2.2, -0.78),
        (-0.2, 1.22),
        (-0.2, -1.22),
        (-3.2, 1.0),
        (-3.2, -1.0),
    ):
        h = 1.0 if x > 3 else deck
        asset.add("paint", shape.tube([(x, h, z), (x, h + 0.62, z)], 0.016, rgb("#d8dadc"), 4))
    for side in (1, -1):
        line = [(3.6, 1.6, 0.2 * side), (2.2, 1.5, 0.78 * side), (-0.2, 1.45, 1.22 * side), (-3.2, 1.45, 1.0 * side)]
        asset.add("paint", shape.tube(line, 0.010, rgb("#d8dadc"), 3, False))
    asset.add(
        "paint",
        shape.tube(
            [(3.6, 1.6, 0.2), (4.25, 1.72, 0.12), (4.35, 1.72, 0), (4.25, 1.72, -0.12), (3.6, 1.6, -0.2)],
            0.018,
            rgb("#d8dadc"),
            4,
        ),
    )
    asset.add("paint", shape.box((0.5, 0.9, 0.05), (-4.14, 0.05, 0), navy))
    return asset


def spars(asset, deck):
    metal, rope = rgb("#d9d4c6"), rgb("#6c6a66")
    foot, top = np.array([0.9, deck + 0.4, 0]), np.array([0.85, 10.5, 0])
    asset.add("paint", shape.tube([foot, (foot + top) / 2, top], [0.075, 0.07, 0.045], metal, 8))
    boom = np.array([[0.8, deck + 1.25, 0], [-2.9, deck + 1.38, 0]])
    asset.add("paint", shape.tube(boom, 0.05, metal, 6))
    s = np.linspace(0, 1, 12)
    sail = boom[0] + (boom[1] - boom[0]) * s[:, None] * 0.97 + [0, 0.14, 0]
    girth = 0.16 * (1 - 0.45 * s) * (1 + 0.10 * np.sin(s * 40))
    girth[0] *= 0.5
    folds = np.where(np.arange(12) % 3 == 1, 0.75, 1.0)[:, None]
    asset.add("paint", shape.tube(sail, girth, rgb("#f4efe0") * folds, 8))
    for side in (1, -1):
        asset.add("paint", shape.tube([(0.85, 6.1, 0), (0.7, 6.15, 0.75 * side)], 0.022, metal, 4))
        asset.add(
            "paint",
            shape.tube([top - [0, 0.15, 0], (0.7, 6.15, 0.75 * side), (0.6, deck, 1.22 * side)], 0.010, rope, 3, False),
        )
        asset.add("paint", shape.tube([(0.86, 6.0, 0), (1.0, deck, 1.15 * side)], 0.010, rope, 3, False))
    asset.add("paint", shape.tube([top - [0, 0.1, 0], (-4.0, deck, 0)], 0.010, rope, 3, False))
    stem = np.array([4.3, 1.15, 0])
    head = np.array([0.9, 9.6, 0])
    jib = stem + (head - stem) * np.linspace(0.05, 0.97, 10)[:, None]
    asset.add(
        "paint",
        shape.tube(
            jib,
            0.075 * np.sin(np.linspace(0.6, 2.9, 10)) + 0.01,
            rgb("#efe9d8") * np.where(np.arange(10) % 2, 0.8, 1.0)[:, None],
            6,
        ),
    )
    asset.add("paint", shape.tube([stem, head], 0.010, rope, 3, False))
    flag = np.zeros((7, 2, 3))
    x = np.linspace(0, 0.75, 7)
    flag[..., 0] = (-4.05 - x)[:, None]
    flag[..., 2] = (0.09 * np.sin(x * 9))[:, None]
    flag[:, 0, 1], flag[:, 1, 1] = 1.75 - 0.25 * x, 2.2 - 0.25 * x
    asset.add("leaves", shape.grid(flag, rgb("#c2382c"), None, shape.SMOOTH))
    asset.add("paint", shape.tube([(-4.0, deck, 0), (-4.06, 2.3, 0)], 0.018, rgb("#8c6b44"), 4))


def fishingBoat():
    """8.6 m, with a wheelhouse aft of the middle, a mast with a derrick, nets and crates."""
    asset = shape.Asset()
    hull = Hull(
        8.6,
        3.1,
        (0.86, 1.0, 1.65),
        (-0.62, -0.30, -0.05),
        transom=0.72,
        fullness=0.64,
        bow=0.44,
        stations=19,
        rake=0.07,
    )
    green, white, red, wood = rgb("#2c7f78"), rgb("#f0ece0"), rgb("#8d2f25"), rgb("#a4855f")
    for low, high, color in [(0.0, 0.53, red), (0.53, 0.585, white), (0.585, 0.88, green), (0.88, 1.0, white)]:
        ts = np.linspace(low, high, 5 if high - low > 0.2 else 2)
        asset.add("gloss", hull.skin(ts, color), hull.end(ts, color, 0), hull.stem(ts, color))
    floor = 0.80
    asset.add("paint", hull.rim(0.10, wood * 1.1))
    ts = np.array([floor, 0.9, 1.0])
    shade = white * np.array([0.45, 0.7, 0.95])[:, None]
    asset.add("paint", hull.skin(ts, shade, 0.10, True), hull.end(ts, shade, 0, 0.10, 1))
    asset.add("paint", hull.deck(floor, wood * 0.8, inset=0.10))
    top = hull.point(0, 1.0)
    asset.add("paint", shape.box((0.14, 0.05, 2 * top[2]), top * [1, 1, 0] + [0.05, 0.0, 0], wood * 1.1))
    rub = hull.point(np.arange(19), 0.89)
    for side in (1, -1):
        asset.add("paint", shape.tube(rub * [1, 1, side], 0.05, wood * 0.7, 5))
    y = 0.45
    house = shape.Asset()
    house.add("gloss", shape.box((2.1, 1.1, 1.9), (0, 0.55, 0), white, cuts=3))
    house.add("gloss", shape.box((2.1, 0.85, 1.9), (0, 1.52, 0), white, top=(0.90, 0.92)))
    house.add("gloss", shape.box((2.5, 0.10, 2.15), (0.05, 2.0, 0), green))
    for z in (-0.58, 0, 0.58):
        house.add(
            "glass",
            shape.move(
                shape.turn(shape.box((0.05, 0.55, 0.48), color=rgb("#2a3843")), shape.about("z", 7.5)), (1.01, 1.52, z)
            ),
        )
    for side in (1, -1):
        for x in (-0.45, 0.4):
            house.add(
                "glass",
                shape.move(
                    shape.turn(shape.box((0.62, 0.5, 0.05), color=rgb("#2a3843")), shape.about("x", -5 * side)),
                    (x, 1.54, 0.92 * side),
                ),
            )
    house.add("boards", shape.box((0.06, 1.65, 0.7), (-1.05, 0.9, 0.3), wood, 0.6))
    asset.include(house, lambda s: shape.move(s, (-1.2, y, 0)))
    asset.add("paint", shape.tube([(-1.9, y + 2.0, 0.5), (-1.9, y + 2.9, 0.5)], 0.09, rgb("#3a3a3a"), 7))
    mast = np.array([0.55, y, 0])
    asset.add("paint", shape.tube([mast, mast + [0, 5.0, 0]], [0.085, 0.05], wood * 1.1, 7))
    asset.add("paint", shape.tube([mast + [0.05, 1.0, 0], mast + [2.6, 3.3, 0]], [0.06, 0.04], wood * 1.1, 6))
    line = rgb("#55524c")
    for a, b in (
        ((0.55, 5.3, 0), (3.15, 3.75, 0)),
        ((0.55, 5.3, 0), (4.2, 1.65, 0)),
        ((0.55, 5.3, 0), (-4.1, 1.0, 0)),
        ((0.55, 4.9, 0), (0.2, 0.95, 1.45)),
        ((0.55, 4.9, 0), (0.2, 0.95, -1.45)),
        ((3.15, 3.75, 0), (3.15, 1.4, 0)),
    ):
        asset.add("paint", shape.tube([a, b], 0.013, line, 3, False))
    asset.add("paint", shape.tube([(1.7, 0.85, -0.7), (1.7, 0.85, 0.7)], [0.33, 0.33], rgb("#5d7a52"), 10))
    for z in (-0.75, 0.75):
        asset.add("paint", shape.tube([(1.7, 0.85, z), (1.7, 0.85, z * 1.08)], 0.45, rgb("#3b4a4f"), 10))
    for z in (-1, 1):
        asset.add(
            "paint",
            shape.tube([(3.2, 1.3, 0.75 * z), (3.2, 1.95, 0.72 * z), (4.35, 2.35, 0.05 * z)], 0.02, rgb("#d8dadc"), 4),
        )
    asset.add("paint", shape.box((0.5, 1.0, 0.08), (-4.35, -0.1, 0), red * 0.8))
    return asset


def fenders():
    """(position) of the tyres along the fishing boat's sides; they lie in the plane of x and y."""
    return [(-2.5, 0.78, 1.62), (-0.4, 0.76, 1.66), (1.5, 0.86, 1.55), (-1.5, 0.76, -1.66), (1.0, 0.82, -1.6)]
