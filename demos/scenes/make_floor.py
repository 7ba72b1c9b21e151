#!/usr/bin/python3
"""Makes floor.glb and floor_tiles.png: a gallery's court under the open sky, all but its polished floor, and the
picture of the floor's slabs.

Metres, +Y up. The floor is the rectangle of 20 m by 26 m about the origin, at y = 0; the picture is composed for an eye
at about (0.8, 1.7, 11.5) looking towards -z.
"""
import pathlib

import numpy as np

import glb
from make import colored, figure, land, occlusion, shape, texture, trees
from make.shape import Asset, rgb

WIDE, LONG = 20.0, 26.0
BACK, LEFT = -LONG / 2, -WIDE / 2  # z and x of the walls' faces
TALL = 4.4


def faced(size, color=(1, 1, 1), turns=0):
    """A box standing on y = 0, its texture once over each side."""
    x, y, z = np.asarray(size, float) / 2
    corner = np.array([(i, j, k) for i in (-x, x) for j in (0, 2 * y) for k in (-z, z)])
    sides = ((1, 5, 7, 3), (4, 0, 2, 6), (5, 4, 6, 7), (0, 1, 3, 2), (3, 7, 6, 2), (0, 4, 5, 1))
    uv = np.roll(np.array([(0, 1), (1, 1), (1, 0), (0, 0)], float), turns, axis=0)
    parts = [shape.polygons(corner[list(side)], [(0, 1, 2, 3)], color, uv=uv) for side in sides]
    return shape.join(parts)


def column():
    """Fluted, with a base and a capital, 3.9 m tall."""
    stone = rgb("#d8cfbe")
    y = np.array([0.30, 0.34, 1.4, 2.6, 3.42, 3.46])
    radius = np.array([0.275, 0.26, 0.255, 0.24, 0.22, 0.235])
    a = np.linspace(0, 2 * np.pi, 49)
    flute = 1 - 0.06 * np.abs(np.sin(a * 8))
    ring = np.stack([np.cos(a) * flute, np.zeros_like(a), np.sin(a) * flute], -1)
    p = ring[None] * radius[:, None, None] + np.array([0, 1, 0]) * y[:, None, None]
    uv = np.stack(np.broadcast_arrays(a[None] / 4, y[:, None] * 0.7), -1)
    shaft = shape.grid(p, stone, uv, 35)
    profile = [(0.36, 0.10), (0.38, 0.15), (0.36, 0.20), (0.30, 0.23), (0.30, 0.27), (0.28, 0.31)]
    foot = shape.lathe(profile, 20, stone, shape.ROUNDED, (2, 1))
    head = shape.lathe([(0.235, 3.44), (0.27, 3.5), (0.24, 3.53), (0.36, 3.68)], 20, stone, shape.ROUNDED, (2, 1))
    slabs = [
        shape.box((0.78, 0.10, 0.78), (0, 0.05, 0), stone, 0.7),
        shape.box((0.80, 0.22, 0.80), (0, 3.79, 0), stone, 0.7),
    ]
    return shape.join([shaft, foot, head] + slabs)


def ball(radius, color, rings=14):
    a = np.linspace(-np.pi / 2, np.pi / 2, rings)
    profile = np.stack([np.maximum(radius * np.cos(a), 0), radius + radius * np.sin(a)], 1)
    return shape.lathe(profile, 2 * rings, color, shape.SMOOTH, (2, 1 / radius))


class Court:
    def __init__(self):
        self.glb = glb.Glb()
        pictures = {
            "brick": colored.png(colored.brick(), 32),
            "crate": colored.png(colored.crate(), 32),
            "painted": colored.png(colored.painted(), 28),
            "marble": colored.png(colored.marble(), 40),
            "wood": texture.png(texture.wood()),
            "plaster": texture.png(texture.plaster()),
            "ground": texture.png(texture.ground()),
        }
        textures = {name: self.glb.texture(picture) for name, picture in pictures.items()}
        plain = lambda name, roughness, **more: self.glb.material(
            name, texture=textures.get(name), roughness=roughness, **more
        )
        self.materials = {
            "brick": plain("brick", 0.9),
            "crate": plain("crate", 0.8),
            "painted": plain("painted", 0.5),
            "marble": plain("marble", 0.4),
            "wood": plain("wood", 0.8),
            "plaster": plain("plaster", 0.85),
            "ground": plain("ground", 0.95),
            "gloss": plain("gloss", 0.2),
            "iron": plain("iron", 0.45),
            "paint": plain("paint", 0.8),
            "gold": plain("gold", 0.18, metallic=1.0),
            "steel": plain("steel", 0.12, metallic=1.0),
            "leaves": plain("leaves", 0.9, doubleSided=True),
            "hills": plain("hills", 1.0),
        }

    def mesh(self, name, asset):
        return self.glb.mesh(name, [(s, self.materials[m]) for m, s in asset.joined().items()])

    def still(self, name, asset):
        self.glb.node(self.mesh(name, asset))

    def surroundings(self):
        """A terrace about the floor, a lawn, and hills."""
        asset = Asset()
        rim = rgb("#a59a86")
        for size, at in (
            ((WIDE + 3, 0.5, 1.5), (0, -0.25, LONG / 2 + 0.75)),
            ((1.5, 0.5, LONG), (WIDE / 2 + 0.75, -0.25, 0)),
            ((WIDE + 3, 0.5, 1.5), (0, -0.25, BACK - 0.75)),
            ((1.5, 0.5, LONG), (LEFT - 0.75, -0.25, 0)),
        ):
            asset.add("marble", shape.box(size, at, rim, 0.5, cuts=6))
        reach = np.array([-700, -120, -40, -13, 0, 13, 40, 120, 700.0])
        p = np.zeros((len(reach), len(reach), 3))
        p[..., 0], p[..., 2] = reach[:, None], reach[None]
        p[..., 1] = -0.45 - 0.03 * np.maximum(np.hypot(p[..., 0], p[..., 2]) - 40, 0) ** 0.9
        lawn = rgb("#5f6b3a") * (1 + 0.25 * land.waves(p[..., 0], p[..., 2], 4, 30)[..., None])
        asset.add("ground", shape.grid(p, lawn, p[..., ::2] / 3.0, shape.SMOOTH, flip=True))
        self.still("terrace and lawn", asset)
        self.still("hills", Asset().add("hills", shape.move(land.hills(), (0, -9, 0))))
        for k, (x, z, size) in enumerate(
            ((12.6, -15, 0.85), (13.2, -11, 0.6), (13.6, -5.5, 0.75), (15.5, -20, 1.0), (19, -27, 1.1), (-15, -20, 1.0), (-9, -24, 1.2))
        ):
            if k == 0:
                cypress = self.mesh("cypress", trees.conifer(3, 9.0))
            self.glb.node(cypress, (x, -0.5, z), glb.yaw(70 * k), size * np.array([0.7, 1, 0.7]))

    def walls(self):
        asset = Asset()
        white = (1, 1, 1)

        def wall(size, at):
            asset.add("brick", shape.box(size, at, white, 1.0))

        # Behind: three bays, a doorway in the middle one. Its bricks lie level: v is up, which box() gives tall sides.
        for x0, x1 in ((-10, -1.1), (1.1, 10)):
            for a in np.arange(x0, x1 - 0.01, 2.225):
                wall((2.225, TALL, 0.5), (a + 1.1125, TALL / 2, BACK - 0.25))
        wall((2.2, TALL - 2.9, 0.5), (0, (TALL + 2.9) / 2, BACK - 0.25))
        for z in np.arange(BACK, 3.0, 2.0):
            wall((0.5, TALL, 2.0), (LEFT - 0.25, TALL / 2, z + 1.0))
        trim = rgb("#cfc4b0")
        asset.add(
            "marble",
            shape.box((WIDE + 0.9, 0.22, 0.75), (0, TALL + 0.11, BACK - 0.25), trim, 0.5),
            shape.box((0.75, 0.22, 16.2), (LEFT - 0.25, TALL + 0.11, BACK + 7.9), trim, 0.5),
            shape.box((WIDE, 0.32, 0.06), (0, 0.16, BACK + 0.03), trim, 0.5),
            shape.box((0.06, 0.32, 16), (LEFT + 0.03, 0.16, BACK + 8), trim, 0.5),
            shape.box((0.28, 2.9, 0.62), (-1.2, 1.45, BACK - 0.2), trim, 0.5),
            shape.box((0.28, 2.9, 0.62), (1.2, 1.45, BACK - 0.2), trim, 0.5),
            shape.box((2.9, 0.34, 0.66), (0, 3.05, BACK - 0.2), trim, 0.5),
        )
        for x in (-0.53, 0.53):  # the door's leaves
            asset.add("wood", shape.box((1.02, 2.88, 0.08), (x, 1.44, BACK - 0.30), rgb("#5d2f22"), 0.6))
            for y in (0.75, 2.0):
                asset.add("wood", shape.box((0.62, 0.9, 0.04), (x, y, BACK - 0.25), rgb("#7a4030"), 0.6))
        asset.add("gold", shape.move(ball(0.05, rgb("#c9a14a"), 6), (0.12, 1.25, BACK - 0.22)))
        self.still("walls", asset)

    def colonnade(self):
        mesh = self.mesh("column", occlusion.bake(Asset().add("marble", column()), 0.1, 0.5))
        spots = [(x, BACK + 2.4) for x in (-8.4, -5.0, -1.7, 1.7, 5.0, 8.4)]
        spots += [(LEFT + 1.6, z) for z in (-7.2, -3.8, -0.4)]
        for k, (x, z) in enumerate(spots):
            self.glb.node(mesh, (x, 0, z), glb.yaw(45 * k))
        beams = Asset()
        stone, under = rgb("#d3c8b4"), rgb("#8a5a3c")
        beams.add("marble", shape.box((19.2, 0.5, 0.7), (0, 4.15, BACK + 2.4), stone, 0.5))
        beams.add("marble", shape.box((0.7, 0.5, 8.4), (LEFT + 1.6, 4.15, -3.6), stone, 0.5))
        for x in np.arange(-9.2, 9.3, 0.8):  # a pergola's rafters, up to the wall's coping: seen from below in the floor
            beams.add("wood", shape.box((0.14, 0.2, 2.725), (x, 4.5, BACK + 1.4875), under, 0.6))
        for z in np.arange(-7.6, 0.6, 0.8):
            beams.add("wood", shape.box((1.925, 0.2, 0.14), (LEFT + 1.0875, 4.5, z), under, 0.6))
        self.still("beams", beams)

    def railing(self):
        asset = Asset()
        iron = rgb("#2b2e30")
        x, z0, z1 = WIDE / 2 - 0.35, BACK + 4.0, LONG / 2 - 4.5
        for y in (0.12, 1.0):
            asset.add("iron", shape.box((0.035, 0.035, z1 - z0), (x, y, (z0 + z1) / 2), iron))
        bar = self.mesh("bar", Asset().add("iron", shape.lathe([(0.009, 0.0), (0.009, 1.0)], 5, iron, shape.SMOOTH)))
        post = self.mesh(
            "railing's post",
            Asset().add("iron", shape.box((0.05, 1.08, 0.05), (0, 0.54, 0), iron), shape.move(ball(0.045, iron, 6), (0, 1.06, 0))),
        )
        for k, z in enumerate(np.linspace(z0, z1, 106)):
            self.glb.node(post if k % 15 == 0 else bar, (x, 0 if k % 15 == 0 else 0.1, z))
        self.still("rails", asset)

    def statue(self):
        asset = Asset().add("marble", shape.move(figure.figure(), (0, 0.92, 0)))
        stone = rgb("#6d6a66")
        asset.add(
            "marble",
            shape.box((1.3, 0.16, 1.3), (0, 0.08, 0), stone, 0.7),
            shape.box((1.02, 0.62, 1.02), (0, 0.47, 0), stone * 1.1, 0.7, top=(0.92, 0.92)),
            shape.box((1.08, 0.14, 1.08), (0, 0.85, 0), stone, 0.7),
        )
        self.glb.node(self.mesh("statue", occlusion.bake(asset, 0.05, 0.7)), (-2.6, 0, -1.4), glb.yaw(22))

    def boxes(self):
        crate = self.mesh("crate", Asset().add("crate", faced((1, 1, 1))))
        paint = self.mesh("painted crate", Asset().add("painted", faced((1, 1, 1), turns=1)))
        block = self.mesh("block", Asset().add("marble", shape.box((1, 1, 1), (0, 0.5, 0), rgb("#b9a27c"), 0.8)))
        bricks = self.mesh("bricks", Asset().add("brick", faced((1.0, 0.96, 1.0))))
        put = lambda mesh, x, y, z, turn, size: self.glb.node(mesh, (x, y, z), glb.yaw(turn), size)
        put(crate, 4.0, 0, -2.6, 14, 1.15)
        put(crate, 5.45, 0, -2.3, -8, 0.95)
        put(crate, 4.35, 1.15, -2.55, 38, 0.8)
        put(paint, 5.9, 0, 0.6, 31, 1.0)
        put(paint, 5.6, 0.95, -2.3, 60, 0.62)
        put(block, -5.6, 0, -4.9, 20, (0.9, 2.4, 0.9))
        put(block, 1.3, 0, -5.6, -12, (1.5, 0.5, 1.5))
        put(block, 1.3, 0.5, -5.6, 9, (0.9, 0.5, 0.9))
        put(bricks, -6.3, 0, 2.2, -24, 1)
        put(crate, -6.1, 0.96, 2.1, 12, 0.55)
        put(paint, 2.9, 0, 4.4, -20, 0.5)
        put(crate, -4.4, 0, 5.6, 40, 0.42)

    def balls(self):
        things = (
            ("gloss", "#a3262a", 0.45, (1.7, 0, 0.6)),
            ("gold", "#d9a94e", 0.32, (0.5, 0, 2.9)),
            ("steel", "#c9ccd0", 0.6, (7.4, 0, -4.6)),
            ("marble", "#e9e2d2", 0.38, (-3.9, 0, 2.5)),
            ("gloss", "#23527a", 0.26, (3.7, 0, 2.6)),
            ("painted", "#ffffff", 0.5, (-0.9, 0, -4.2)),
            ("marble", "#c7b08a", 0.35, (1.3, 1.0, -5.6)),
            ("gloss", "#e2b33c", 0.15, (-1.4, 0, 5.4)),
        )
        for k, (material, color, radius, at) in enumerate(things):
            self.glb.node(self.mesh(f"ball {k}", Asset().add(material, ball(radius, rgb(color), 10 if radius < 0.3 else 14))), at)

    def pots(self):
        """Clay pots with clipped shrubs."""
        clay = rgb("#a85c3a")
        pot = Asset().add(
            "plaster",
            shape.lathe([(0.24, 0), (0.26, 0.04), (0.36, 0.48), (0.41, 0.50), (0.41, 0.58), (0.36, 0.58), (0.33, 0.5), (0, 0.5)], 20, clay, 40, (2, 1)),
        )
        rng = np.random.default_rng(8)
        for _ in range(420):
            d = rng.normal(size=3)
            d /= np.linalg.norm(d)
            at = np.array([0, 1.0, 0]) + d * rng.uniform(0.36, 0.47)
            side = np.cross(d, rng.normal(size=3))
            side *= 0.07 / np.linalg.norm(side)
            up = np.cross(side, d) * 1.3
            tone = rgb("#4d6a2c") * rng.uniform(0.6, 1.3)
            pot.add("leaves", shape.polygons([at - side, at + up, at + side], [(0, 1, 2)], tone))
        mesh = self.mesh("pot", occlusion.bake(pot, 0.07, 0.6))
        for x, z in ((-1.95, BACK + 0.7), (1.95, BACK + 0.7), (8.9, 3.2), (-8.9, 4.4)):
            self.glb.node(mesh, (x, 0, z), glb.yaw(x * 40))


def main():
    court = Court()
    for build in (
        court.surroundings,
        court.walls,
        court.colonnade,
        court.railing,
        court.statue,
        court.boxes,
        court.balls,
        court.pots,
    ):
        before = court.glb.size()
        build()
        print(f"{build.__name__:12} {(court.glb.size() - before) / 1000:7.0f} kB")
    folder = pathlib.Path(__file__).parent
    court.glb.write(folder / "floor.glb")
    (folder / "floor_tiles.png").write_bytes(colored.png(colored.stoneTiles(), 28))
    for name in ("floor.glb", "floor_tiles.png"):
        print(f"{name}: {(folder / name).stat().st_size} bytes")


if __name__ == "__main__":
    main()
