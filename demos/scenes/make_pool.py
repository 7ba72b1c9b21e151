#!/usr/bin/python3
"""Makes pool.glb: a swimming pool of 10 m by 25 m and what stands around it, all but its water.

Metres, +Y up. The basin lies between x = -5 and 5, z = -20 and 5; its water stands at y = 0 and its deck at 0.16. The
picture is composed for an eye at about (-3.4, 1.7, 9) looking towards -z.
"""
import pathlib

import numpy as np

import glb
from make import colored, land, occlusion, shape, texture, trees
from make.shape import Asset, rgb

LEFT, RIGHT, BACK, FRONT = -5.0, 5.0, -20.0, 5.0
DECK = 0.16
SHALLOW, DEEP = -1.25, -2.1  # bed at the front and at the back
LANES = (-3.75, -1.25, 1.25, 3.75)  # x of their middles
ROPES = (-2.5, 0.0, 2.5)


def bed(z):
    """Its height: level, then a slope, then level again."""
    return SHALLOW + (DEEP - SHALLOW) * land.smooth(-2, -13, np.asarray(z, float))


def floats(colors):
    """2.5 m of a lane rope, along -z from the origin."""
    line = [shape.tube([(0, 0, 0), (0, 0, -2.5)], 0.008, rgb("#d8d4c8"), 4, False)]
    for k in range(20):
        one = shape.lathe(
            [(0.0, -0.055), (0.05, -0.05), (0.062, 0), (0.05, 0.05), (0.0, 0.055)], 9, rgb(colors[k % len(colors)]), 60
        )
        line.append(shape.move(shape.turn(one, shape.about("x", 90)), (0, 0, -0.0625 - 0.125 * k)))
    return shape.join(line)


def ladder():
    """Over the edge at x = 0; the water lies towards -x."""
    parts = []
    for z in (-0.26, 0.26):
        a = np.linspace(0, np.pi, 9)
        arc = np.stack([0.02 + 0.28 * np.cos(a), 0.55 + 0.30 * np.sin(a), np.full_like(a, z)], 1)
        path = np.concatenate([[(0.30, -0.02, z)], arc, [(-0.26, -0.2, z), (-0.26, -1.25, z)]])
        parts.append(shape.tube(path, 0.021, rgb("#e8ebee"), 8))
    for y in (-0.3, -0.6, -0.9, -1.2):
        parts.append(shape.box((0.09, 0.025, 0.54), (-0.26, y, 0), rgb("#d5dade")))
    return shape.join(parts)


def parasol(color):
    rng = np.random.default_rng(4)
    cloth, white = rgb(color), rgb("#f4efe2")
    a = np.linspace(0, 2 * np.pi, 17)
    corners, colors = [], []
    for k in range(16):
        tone = (cloth if k % 2 else white) * rng.uniform(0.96, 1.03)
        top = np.array([0, 2.65, 0])
        rim = [np.array([1.55 * np.cos(b), 2.12 - 0.05 * (k % 2), 1.55 * np.sin(b)]) for b in a[k : k + 2]]
        drop = [p - [0, 0.16, 0] for p in rim]
        for triangle in ((top, rim[1], rim[0]), (rim[0], rim[1], drop[1]), (rim[0], drop[1], drop[0])):
            corners.append(triangle)
            colors.append([tone] * 3)
    cover = shape.fromTriangles(np.array(corners), np.array(colors), None, shape.FLAT)
    asset = Asset().add("cloth", cover)
    asset.add("paint", shape.lathe([(0.28, 0), (0.26, 0.07), (0.05, 0.1), (0.025, 0.3), (0.02, 2.66)], 8, rgb("#e6e1d5")))
    return asset


def lounger(color):
    """Its head towards +z."""
    asset, wood = Asset(), rgb("#b98f5e")
    for x in (-0.31, 0.31):
        asset.add("wood", shape.box((0.06, 0.08, 1.95), (x, 0.30, 0), wood, 0.6))
        for z in (-0.85, 0.85):
            asset.add("wood", shape.box((0.06, 0.28, 0.06), (x, 0.14, z), wood, 0.6))
    asset.add("cloth", shape.box((0.60, 0.09, 1.25), (0, 0.385, -0.33), rgb(color)))
    back = shape.turn(shape.box((0.60, 0.09, 0.78), (0, 0, 0.37), rgb(color)), shape.about("x", -33))
    asset.add("cloth", shape.move(back, (0, 0.37, 0.30)))
    asset.add("cloth", shape.box((0.44, 0.03, 0.55), (0, 0.445, -0.55), rgb("#f2efe8")))
    return asset


class Pool:
    def __init__(self):
        self.glb = glb.Glb()
        self.rng = np.random.default_rng(31)
        pictures = {
            "tiles": colored.png(colored.mosaic(("#bfe3ea", "#a9d7e2", "#d3edf0", "#9ccfdd"), "#eef3f0"), 24),
            "band": colored.png(colored.mosaic(("#1f5f92", "#2a74a8", "#184c7c"), "#c9d6da", seed=64), 24),
            "slabs": colored.png(colored.mosaic(("#d9cdb8", "#cfc2ab", "#e0d6c4"), "#a99c86", 256, 4, 2.2, 71), 28),
            "wood": texture.png(texture.wood()),
            "plaster": texture.png(texture.plaster()),
            "ground": texture.png(texture.ground()),
            "boards": texture.png(texture.boards()),
        }
        textures = {name: self.glb.texture(picture) for name, picture in pictures.items()}
        plain = lambda name, roughness, **more: self.glb.material(
            name, texture=textures.get(name), roughness=roughness, **more
        )
        self.materials = {
            "tiles": plain("tiles", 0.3),
            "band": plain("band", 0.25),
            "slabs": plain("slabs", 0.8),
            "wood": plain("wood", 0.75),
            "boards": plain("boards", 0.8),
            "plaster": plain("plaster", 0.85),
            "ground": plain("ground", 0.95),
            "paint": plain("paint", 0.6),
            "gloss": plain("gloss", 0.3),
            "glass": plain("glass", 0.08),
            "steel": plain("steel", 0.16, metallic=1.0),
            "cloth": plain("cloth", 0.9, doubleSided=True),
            "leaves": plain("leaves", 0.9, doubleSided=True),
        }

    def mesh(self, name, asset):
        return self.glb.mesh(name, [(s, self.materials[m]) for m, s in asset.joined().items()])

    def still(self, name, asset):
        self.glb.node(self.mesh(name, asset))

    def basin(self):
        asset = Asset()
        z = np.linspace(BACK, FRONT, 41)
        x = np.linspace(LEFT, RIGHT, 9)
        p = np.zeros((len(z), len(x), 3))
        p[..., 0], p[..., 2] = x[None], z[:, None]
        p[..., 1] = bed(z)[:, None]
        corner = np.minimum(np.abs(p[..., 0]) * -1 + RIGHT, np.minimum(p[..., 2] - BACK, FRONT - p[..., 2]))
        shade = (0.82 + 0.18 * land.smooth(0, 1.2, corner))[..., None]
        asset.add("tiles", shape.grid(p, np.ones(3) * shade, p[..., ::2] / 1.2))
        for lane in LANES:  # a line along its bed, with a bar before each end
            strip = np.stack([p[2:-2, :2].copy(), p[2:-2, :2].copy()], 0)[0]
            strip[:, 0, 0], strip[:, 1, 0] = lane - 0.13, lane + 0.13
            strip[..., 1] += 0.006
            asset.add("band", shape.grid(strip, np.ones(3), strip[..., ::2] / 1.2))
            for end in (z[2], z[-3]):
                bar = shape.box((1.0, 0.012, 0.26), (lane, float(bed(end)), end), np.ones(3), 1 / 1.2)
                asset.add("band", bar)
        self.walls(asset)
        self.still("basin", asset)

    def walls(self, asset):
        sides = (
            ((LEFT, FRONT), (LEFT, BACK)),
            ((LEFT, BACK), (RIGHT, BACK)),
            ((RIGHT, BACK), (RIGHT, FRONT)),
            ((RIGHT, FRONT), (LEFT, FRONT)),
        )
        for a, b in sides:
            a, b = np.array(a), np.array(b)
            s = np.linspace(0, 1, 41)
            line = a + (b - a) * s[:, None]
            along = s * np.linalg.norm(b - a)
            for material, low, high in (("tiles", bed(line[:, 1]), -0.28), ("band", -0.28, DECK - 0.1)):
                p = np.zeros((41, 2, 3))
                p[..., 0], p[..., 2] = line[:, None, 0], line[:, None, 1]
                p[:, 0, 1], p[:, 1, 1] = low, high
                uv = np.stack([np.repeat(along[:, None], 2, 1), p[..., 1]], -1) / 1.2
                asset.add(material, shape.grid(p, np.ones(3) * (0.88 if material == "tiles" else 1), uv, shape.FLAT))

    def deck(self):
        asset = Asset()
        wide = 6.0
        rim = rgb("#f0ebe0")
        for size, at in (
            ((RIGHT - LEFT + 0.8, 0.1, 0.4), (0, DECK - 0.05, FRONT + 0.2)),
            ((RIGHT - LEFT + 0.8, 0.1, 0.4), (0, DECK - 0.05, BACK - 0.2)),
            ((0.4, 0.1, FRONT - BACK), (LEFT - 0.2, DECK - 0.05, (FRONT + BACK) / 2)),
            ((0.4, 0.1, FRONT - BACK), (RIGHT + 0.2, DECK - 0.05, (FRONT + BACK) / 2)),
        ):
            asset.add("plaster", shape.box(size, at, rim, 0.5, cuts=6))
        low, high = np.array([LEFT - 0.4, BACK - 0.4]), np.array([RIGHT + 0.4, FRONT + 0.4])
        for a, b in (
            ((low[0] - wide, high[1]), (high[0] + wide, high[1] + wide)),
            ((low[0] - wide, low[1] - wide), (high[0] + wide, low[1])),
            ((low[0] - wide, low[1]), (low[0], high[1])),
            ((high[0], low[1]), (high[0] + wide, high[1])),
        ):
            u, v = np.meshgrid(np.linspace(0, 1, 9), np.linspace(0, 1, 9), indexing="ij")
            p = np.zeros((9, 9, 3))
            p[..., 0], p[..., 2] = a[0] + (b[0] - a[0]) * u, a[1] + (b[1] - a[1]) * v
            p[..., 1] = DECK - 0.004
            tone = 1 + 0.07 * land.waves(p[..., 0], p[..., 2], 5, 4)[..., None]
            asset.add("slabs", shape.grid(p, np.ones(3) * tone, p[..., ::2] / 2.4, flip=True))
        self.still("deck", asset)

    def garden(self):
        # As far as air lets one see from above: meadows, fields and heath.
        reach = np.array([-90, -30, -11.4, 11.4, 30, 90.0])
        deep = np.array([-120, -50, -26.4, 11.4, 30, 90.0])
        afar = land.spaced((160, 1000, 105), (1000, 4000, 500), (4000, 12000, 2000), (12000, 36000, 8000))
        reach, deep = (np.concatenate([-afar[::-1], near, afar]) for near in (reach, deep))
        p = np.zeros((len(reach), len(deep), 3))
        p[..., 0], p[..., 2] = reach[:, None], deep[None]
        p[..., 1] = DECK - 0.06
        x, z = p[..., 0], p[..., 2]
        far = land.smooth(120, 400, np.hypot(x, z))[..., None]
        kinds = np.array([rgb("#7d8a45"), rgb("#a39a5a"), rgb("#4d6a34"), rgb("#8f9a55")])
        fields = kinds[np.random.default_rng(97).integers(len(kinds), size=x.shape)]
        tone = rgb("#6f8a3c") * (1 - far) + fields * far
        tone = tone * (1 + 0.12 * land.waves(x, z, 7, 40)[..., None])
        grass = shape.grid(p, tone, p[..., ::2] / 2.0, flip=True)
        middle = np.array([0, 0, (-26.4 + 11.4) / 2])
        keep = np.abs(grass.p[grass.t].mean(1) - middle)[:, [0, 2]] > [9, 17]  # the deck and the basin lie there
        grass.t = grass.t[keep.any(1)]
        self.still("lawn", Asset().add("ground", grass))
        kinds = [
            self.mesh("oak", trees.broadleaf(11, 7.5, "#7d9440", "#304a22")),
            self.mesh("birch", trees.broadleaf(15, 8.0, "#8fa34a", "#3a5428")),
            self.mesh("cypress", trees.conifer(3, 9.0)),
        ]
        for x, z, kind, size in (
            (-15, -29, 0, 1.0), (-19, -20, 1, 1.1), (-15.5, -10, 0, 0.85), (-17, 0, 1, 0.9), (-9, -33, 1, 1.05),
            (10, -34, 0, 1.1), (15, -31, 2, 0.9), (17.5, -27, 2, 1.05), (19, -18, 0, 1.0), (18, -6, 1, 0.95),
            (16.5, 3, 0, 0.8), (3, -38, 2, 1.1), (-3, -37, 0, 1.2), (24, -36, 1, 1.3), (-26, -34, 0, 1.3),
        ):
            self.glb.node(kinds[kind], (x, DECK - 0.1, z), glb.yaw(x * 37 + z), size)
        hedge = Asset()
        for _ in range(260):
            at = np.array([self.rng.uniform(0, 3), self.rng.uniform(0.1, 1.35), 0])
            face = self.rng.integers(3)
            n = np.array([(0, 0, 1), (0, 0, -1), (0, 1, 0)][face], float)
            at = np.array([at[0], 1.4, self.rng.uniform(-0.4, 0.4)]) if face == 2 else at + n * 0.42
            side = np.cross(n, self.rng.normal(size=3))
            side *= 0.14 / np.linalg.norm(side)
            up = np.cross(side, n) * 1.2
            tone = rgb("#466b2b") * self.rng.uniform(0.65, 1.3) * (0.55 + 0.45 * at[1] / 1.4)
            hedge.add("leaves", shape.polygons([at - side, at + up, at + side], [(0, 1, 2)], tone))
        hedge.add("paint", shape.box((3, 1.36, 0.78), (1.5, 0.68, 0), rgb("#2b4520"), cuts=2))
        mesh = self.mesh("hedge", hedge)
        for k in range(12):
            self.glb.node(mesh, (-11.6, DECK - 0.06, 10 - 3 * k), glb.yaw(90))
            self.glb.node(mesh, (11.6, DECK - 0.06, 10 - 3 * k), glb.yaw(90))

    def house(self):
        """A low pavilion behind the far end."""
        asset, white, z = Asset(), rgb("#efeae0"), BACK - 7.5
        asset.add("plaster", shape.box((15, 3.0, 0.3), (0, DECK + 1.5, z - 4), white, 0.4, cuts=5))
        for x in (-7.35, 7.35):
            asset.add("plaster", shape.box((0.3, 3.0, 4.2), (x, DECK + 1.5, z - 2), white, 0.4, cuts=4))
        asset.add("plaster", shape.box((16.6, 0.34, 6.4), (0, DECK + 3.17, z - 1.6), white, 0.4, cuts=6))
        asset.add("wood", shape.box((16.7, 0.10, 6.5), (0, DECK + 2.97, z - 1.6), rgb("#9a7448"), 0.5, cuts=6))
        for x in np.linspace(-6.9, 6.9, 7):
            asset.add("paint", shape.box((0.09, 2.9, 0.09), (x, DECK + 1.45, z + 0.1), rgb("#3a3e42")))
        for k in range(6):
            x = -5.75 + 2.3 * k
            if k in (1, 4):
                asset.add("boards", shape.box((2.1, 2.85, 0.06), (x, DECK + 1.42, z), rgb("#b07c48"), 0.6, cuts=3))
            else:
                asset.add("glass", shape.box((2.2, 2.85, 0.03), (x, DECK + 1.42, z), rgb("#223038")))
        asset.add("plaster", shape.box((3.6, 4.6, 3.2), (-4.6, DECK + 2.3, z - 5.2), rgb("#d9805a"), 0.4, cuts=4))
        self.still("pavilion", occlusion.bake(asset, 0.16, 0.7))

    def things(self):
        rope = [
            self.mesh("rope's end", Asset().add("gloss", floats(("#d2362f",)))),
            self.mesh("rope", Asset().add("gloss", floats(("#2d6fb3", "#2d6fb3", "#f2f2ee", "#f2f2ee")))),
        ]
        for x in ROPES:
            for k in range(10):
                self.glb.node(rope[0 if k in (0, 1, 8, 9) else 1], (x, 0.012, FRONT - 2.5 * k))
        block = Asset()
        block.add("gloss", shape.box((0.52, 0.34, 0.5), (0, 0.17, -0.05), rgb("#f1f1ec")))
        top = shape.turn(shape.box((0.56, 0.05, 0.62), (0, 0, 0), rgb("#2a6aa8")), shape.about("x", 9))
        block.add("paint", shape.move(top, (0, 0.40, -0.02)))
        mesh = self.mesh("starting block", occlusion.bake(block, 0.05, 0.6))
        for x in LANES:
            self.glb.node(mesh, (x, DECK, BACK - 0.45))
        steel = self.mesh("ladder", Asset().add("steel", ladder()))
        for z in (1.5, -15.5):
            self.glb.node(steel, (RIGHT + 0.02, DECK, z))
            self.glb.node(steel, (LEFT - 0.02, DECK, z), glb.yaw(180))
        beds = [self.mesh(f"lounger {c}", occlusion.bake(lounger(c), 0.06, 0.6)) for c in ("#2f7f9c", "#e0a23a")]
        shades = [self.mesh(f"parasol {c}", parasol(c)) for c in ("#2f7f9c", "#d2553a")]
        for k, z in enumerate((0.5, -5.0, -10.5)):
            for side in (-1, 1):
                if side < 0 and k == 0:
                    continue
                turn = -90 * side
                self.glb.node(shades[k % 2], (side * 8.6, DECK, z), glb.yaw(11 * k))
                for shift in (-1.0, 1.0):
                    self.glb.node(beds[k % 2], (side * 8.2, DECK, z + shift), glb.yaw(-turn))
        ring = shape.torus(0.33, 0.09, np.array([rgb("#e5e2da"), rgb("#e5e2da"), rgb("#d63a2c")] * 6), 18, 8)
        self.glb.node(self.mesh("float", Asset().add("gloss", ring)), (-1.6, 0.03, 0.7), glb.yaw(20))
        a = np.linspace(-np.pi / 2, np.pi / 2, 9)
        panels = [rgb(c) for c in ("#f4f1e8", "#d63a2c", "#f4f1e8", "#2d6fb3", "#f4f1e8", "#e6b43a")]
        corners, colors = [], []
        for k in range(18):
            for i in range(8):
                q = lambda e, b: 0.21 * np.array([np.cos(e) * np.cos(b), np.sin(e), np.cos(e) * np.sin(b)])
                b0, b1 = 2 * np.pi * k / 18, 2 * np.pi * (k + 1) / 18
                corners += [[q(a[i], b0), q(a[i + 1], b0), q(a[i + 1], b1)], [q(a[i], b0), q(a[i + 1], b1), q(a[i], b1)]]
                colors += [[panels[k // 3]] * 3] * 2
        ball = shape.fromTriangles(np.array(corners), np.array(colors), None, shape.SMOOTH)
        tilted = np.array([np.sin(0.35), 0, 0, np.cos(0.35)])
        self.glb.node(self.mesh("ball", Asset().add("gloss", ball)), (0.9, 0.13, 2.1), tilted)


def main():
    pool = Pool()
    parts = (pool.basin, pool.deck, pool.garden, pool.house, pool.things)
    glb.build(pool.glb, parts, pathlib.Path(__file__).parent / "pool.glb")


if __name__ == "__main__":
    main()
