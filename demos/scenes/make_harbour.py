#!/usr/bin/python3
"""Makes harbour.glb: where everything stands. What stands there is made by the modules in make/.

Metres, +Y up, the water at y = 0. The picture is composed for an eye at about (0, 2.3, 24) that looks towards -z, with
the sun behind its right shoulder.
"""
import pathlib

import numpy as np

import glb
from make import boats, huts, land, lighthouse, moorings, occlusion, pier, rocks, shape, texture, trees
from make.shape import Asset, rgb

DECK = pier.DECK
PIER_A, PIER_B, PIER_WIDE = np.array([13.0, -2.2]), np.array([-5.5, -4.0]), 2.5  # x and z of the two ends
PLATFORM = (1.6, 8.6, -9.4, -3.6)  # x from, to, z from, to


def quayStone(seed, low, high, cap):
    """One stone of the quay's wall, or of the slabs on it, wet and green where the water reaches."""
    rng = np.random.default_rng(seed)
    tone = rgb("#b8ae9c" if cap else ("#a39b8c", "#918a80", "#b0a58f", "#87817a")[rng.integers(4)]) * rng.uniform(
        0.85, 1.1
    )
    stone = shape.box((1.35 if cap else 1.2, high - low - 0.03, 1.37), (0, (low + high) / 2, 0), tone, 0.55)
    stone.uv = stone.uv + rng.random(2)
    stone.c *= (1 - 0.58 * (1 - land.smooth(0.05, 0.5, stone.p[:, 1])))[:, None]
    stone.c[stone.p[:, 1] < 0.15] *= [0.85, 1.0, 0.7]
    return stone


class Harbour:
    def __init__(self):
        self.glb = glb.Glb()
        self.rng = np.random.default_rng(2024)
        pictures = {
            "wood": texture.wood(),
            "boards": texture.boards(),
            "stone": texture.rock(),
            "plaster": texture.plaster(),
            "ground": texture.ground(),
            "tiles": texture.tiles(),
        }
        textures = {name: self.glb.texture(texture.png(image)) for name, image in pictures.items()}
        self.materials = {
            "wood": self.glb.material("wood", texture=textures["wood"], roughness=0.85),
            "boards": self.glb.material("boards", texture=textures["boards"], roughness=0.8),
            "stone": self.glb.material("stone", texture=textures["stone"], roughness=0.9),
            "plaster": self.glb.material("plaster", texture=textures["plaster"], roughness=0.85),
            "ground": self.glb.material("ground", texture=textures["ground"], roughness=0.95),
            "tiles": self.glb.material("tiles", texture=textures["tiles"], roughness=0.75),
            "paint": self.glb.material("paint", roughness=0.7),
            "gloss": self.glb.material("gloss", roughness=0.35),
            "glass": self.glb.material("glass", roughness=0.12),
            "leaves": self.glb.material("leaves", roughness=0.9, doubleSided=True),
            "hull": self.glb.material("blue hull", rgb("#2f6f8f"), roughness=0.45),
            "hills": self.glb.material("hills", roughness=1.0),
        }

    def mesh(self, name, asset):
        return self.glb.mesh(name, [(s, self.materials[m]) for m, s in asset.joined().items()])

    def still(self, name, asset):
        """A thing that stands once, where it was made."""
        self.glb.node(self.mesh(name, asset))

    # --- ground -----------------------------------------------------------------------------------------------------

    def ground(self):
        self.still("shore and bed", Asset().add("ground", land.near()))
        self.still("island", Asset().add("hills", land.islandPatch()))
        self.still("skerry", Asset().add("stone", land.skerryPatch()))
        self.still("hills", Asset().add("hills", land.hills()))

    def boulders(self):
        grey, warm, dark = rgb("#97918a"), rgb("#a3947f"), rgb("#5f5e57")
        shapes = [
            self.mesh(
                f"boulder {k}", Asset().add("stone", rocks.boulder(k, (grey, warm, dark)[k % 3], 2 if k < 1 else 1))
            )
            for k in range(6)
        ]
        near, far = shapes[:4], shapes[1:]

        def put(kinds, x, z, size, sink=0.25, y=None, turned=True):
            y = float(land.height(x, z)) if y is None else y
            q = glb.yaw(self.rng.uniform(0, 360)) if turned else None
            s = size * self.rng.uniform(0.8, 1.2, 3)
            self.glb.node(kinds[self.rng.integers(len(kinds))], (x, y + size * (0.45 - sink), z), q, s)

        for k in range(38):  # breakwater: from the mainland into the bay
            s = k / 37
            x, z = 14 - 20 * s, -33 - 6 * s**1.5
            for row in (-1, 0, 1):
                if row == 0 or self.rng.random() < 0.65:
                    put(
                        near,
                        x + self.rng.normal(scale=0.3),
                        z + row * 1.25 + self.rng.normal(scale=0.3),
                        self.rng.uniform(1.7, 2.5),
                        y=(0.25 if row == 0 else -0.65) - 0.25 * (s > 0.93),
                    )
            if k % 2 == 0:
                put(far, x, z, 2.6, y=-1.3)
        for _ in range(44):  # foot of the lighthouse's rock
            a, r = self.rng.uniform(0, 2 * np.pi), self.rng.uniform(5.5, 11.5)
            put(
                near,
                land.LIGHTHOUSE[0] + 1.35 * r * np.cos(a),
                land.LIGHTHOUSE[1] + r * np.sin(a),
                self.rng.uniform(1.0, 2.9),
                0.5,
            )
        for k in range(110):  # the bed about the pier, and more of them in front of the eye
            x, z = (
                (self.rng.uniform(-16, 13), self.rng.uniform(-8, 22))
                if k < 55
                else self.rng.normal((1, 14), (5.5, 4.5))
            )
            put(far, x, z, self.rng.uniform(0.15, 0.5) * (2.2 if self.rng.random() < 0.12 else 1), 0.3, turned=False)
        for _ in range(46):  # the beach
            z = self.rng.uniform(8, 24)
            put(near, float(land.coast(z)) + self.rng.uniform(-2.5, 4), z, self.rng.uniform(0.2, 0.9) ** 1.3, 0.3)
        for _ in range(26):  # the shore behind the quay
            z = self.rng.uniform(-95, -34)
            put(far, float(land.coast(z)) + self.rng.uniform(-2, 2), z, self.rng.uniform(0.8, 2.6), 0.3)
        for _ in range(46):  # the island's shore
            a = self.rng.uniform(0, 2 * np.pi)
            d = np.array([82 * np.cos(a), 46 * np.sin(a)])
            s = next(s for s in np.linspace(1.35, 0.5, 80) if land.height(*(land.ISLAND + d * s)) > -0.1)
            put(far, *(land.ISLAND + d * s), self.rng.uniform(1.2, 4.2), 0.3)
        for _ in range(14):
            p = land.ISLAND + self.rng.uniform(-1, 1, 2) * [55, 30]
            put(far, *p, self.rng.uniform(1.5, 4), 0.35)

    def forest(self):
        firs = [self.mesh(f"spruce {k}", trees.conifer(k + 1, 9.0)) for k in range(2)]
        leafy = [
            self.mesh("oak", trees.broadleaf(11, 7.5, "#66803a", "#28401f")),
            self.mesh("birch", trees.broadleaf(15, 8.0, "#7f9442", "#324a24")),
        ]
        taken = []

        def plant(x, z, kind=None, size=None):
            y = float(land.height(x, z))
            if y < 1.7 or any(np.hypot(x - a, z - b) < 3.2 for a, b in taken):
                return False
            taken.append((x, z))
            kinds = (firs if self.rng.random() < 0.55 else leafy) if kind is None else kind
            s = self.rng.uniform(0.8, 1.4) if size is None else size
            self.glb.node(
                kinds[self.rng.integers(len(kinds))],
                (x, y - 0.1, z),
                glb.yaw(self.rng.uniform(0, 360)),
                s * np.array([1, self.rng.uniform(0.9, 1.15), 1]),
            )
            return True

        groves = [
            (48, -188, 18, 12, 14),
            (-16, -180, 13, 9, 11),
            (18, -176, 9, 7, 6),
            (76, -184, 9, 8, 4),
            (8, -200, 30, 10, 5),
        ]
        for x, z, wide, deep, count in groves:
            planted = 0
            for _ in range(200):
                planted += plant(x + self.rng.normal() * wide * 0.55, z + self.rng.normal() * deep * 0.55)
                if planted == count:
                    break
        for _ in range(300):  # behind the quay
            z = self.rng.uniform(-95, -14)
            plant(float(land.coast(z)) + 14 + abs(self.rng.normal()) * 22, z)
            if len(taken) >= 64:
                break

    # --- what people built ------------------------------------------------------------------------------------------

    def quay(self):
        asset = Asset()
        rng = np.random.default_rng(77)
        self.bollard = self.mesh("bollard", Asset().add("gloss", pier.bollard()))
        self.lamp = self.mesh("lamp", Asset().add("paint", *pier.lamp()))
        for row, (low, high) in enumerate(
            ((-2.6, -1.7), (-1.7, -0.75), (-0.75, 0.1), (0.1, 0.7), (0.7, 1.12), (1.1, 1.3))
        ):
            kinds = [
                self.mesh(f"quay stone {row} {k}", Asset().add("stone", quayStone(row * 10 + k, low, high, row == 5)))
                for k in range(3 if row > 2 else 1)
            ]
            for z in np.arange(land.QUAY_FAR - 0.7 * (row % 2), land.QUAY_NEAR, 1.4):
                self.glb.node(
                    kinds[rng.integers(len(kinds))],
                    (land.QUAY_X + 0.6 + rng.uniform(-0.03, 0.03), 0, z + 0.7),
                    glb.yaw(0 if rng.random() < 0.6 or row < 5 else 180),
                )
        p = np.zeros((9, 24, 3))
        p[..., 0] = np.linspace(land.QUAY_X + 1.2, land.QUAY_X + 11.5, 9)[:, None]
        p[..., 2] = np.linspace(land.QUAY_FAR - 1, land.QUAY_NEAR, 24)[None]
        p[..., 1] = land.QUAY_TOP - 0.05 + 0.03 * land.waves(p[..., 0], p[..., 2], 91, 4)
        tone = rgb("#a89a80") * (1 + 0.2 * land.waves(p[..., 0], p[..., 2], 92, 6)[..., None])
        asset.add("ground", shape.grid(p, tone, p[..., ::2] / 2.0, shape.SMOOTH, flip=True))
        end = shape.box((11.6, 3.2, 0.5), (land.QUAY_X + 5.8, -0.45, land.QUAY_NEAR + 0.1), rgb("#8f887c"), 0.4, cuts=4)
        end.c *= (1 - 0.5 * (1 - land.smooth(0.0, 0.6, end.p[:, 1])))[:, None]
        asset.add("stone", end)
        for z in (-26, -19, -12, 1.5, 5.5):
            self.glb.node(self.bollard, (land.QUAY_X + 0.55, land.QUAY_TOP, z))
        for z in (-15, 4.2):
            self.glb.node(self.lamp, (land.QUAY_X + 1.6, land.QUAY_TOP, z))
        self.still("quay", asset)

    def pier(self):
        along = (PIER_B - PIER_A) / np.linalg.norm(PIER_B - PIER_A)
        across = np.array([-along[1], along[0]])
        length = np.linalg.norm(PIER_B - PIER_A)
        heading = np.degrees(np.arctan2(across[0], across[1])) + 90  # planks lie across
        planks = [
            self.mesh(f"plank {k}", Asset().add("wood", shape.yawed(pier.plank(k, PIER_WIDE), heading)))
            for k in range(5)
        ]
        for k in range(int(length / 0.222)):
            p = PIER_A + along * (0.11 + 0.222 * k)
            self.glb.node(planks[self.rng.integers(5)], (p[0], DECK + self.rng.normal(scale=0.004), p[1]))
        x0, x1, z0, z1 = PLATFORM
        boards = [
            self.mesh(f"board {k}", Asset().add("wood", shape.yawed(pier.plank(k + 20, z1 - z0), 90))) for k in range(3)
        ]
        for k in range(int((x1 - x0) / 0.222)):
            self.glb.node(boards[self.rng.integers(3)], (x0 + 0.11 + 0.222 * k, DECK - 0.003, (z0 + z1) / 2))
        posts = [self.mesh(f"post {k}", Asset().add("wood", pier.post(k, DECK - 0.05, -4.2))) for k in range(2)]
        tall = [
            self.mesh(f"tall post {k}", Asset().add("wood", pier.post(k + 5, DECK + 0.75, -4.2, 0.16)))
            for k in range(2)
        ]
        frame = Asset()
        spots = np.linspace(0.9, length - 0.25, 9)
        at = lambda s, t: PIER_A + along * s + across * t
        flat = lambda p, y: (p[0], y, p[1])
        for k, s in enumerate(spots):
            for t in (-1.08, 1.08):
                p = at(s, t)
                kinds = tall if k in (2, 5, 8) else posts
                self.glb.node(kinds[self.rng.integers(2)], flat(p, 0), glb.yaw(self.rng.uniform(0, 360)))
            frame.add("wood", pier.beam(flat(at(s, -1.35), DECK - 0.29), flat(at(s, 1.35), DECK - 0.29)))
            if k in (1, 3, 4, 6, 7, 8):
                frame.add("wood", pier.beam(flat(at(s, -1.0), -0.25), flat(at(s, 1.0), 0.85), (0.07, 0.15), "#5f5040"))
        for t in (-1.08, 0, 1.08):
            frame.add("wood", pier.beam(flat(at(0, t), DECK - 0.13), flat(at(length, t), DECK - 0.13), (0.12, 0.17)))
        for t in (-1.22, 1.22):
            frame.add(
                "wood",
                pier.beam(flat(at(0, t), DECK + 0.05), flat(at(length, t), DECK + 0.05), (0.13, 0.10), "#a08a6c"),
            )
        for x in np.linspace(x0 + 0.4, x1 - 0.4, 4):
            for z in np.linspace(z0 + 0.4, z1 - 0.2, 4):
                self.glb.node(posts[self.rng.integers(2)], (x, 0, z), glb.yaw(self.rng.uniform(0, 360)))
            frame.add("wood", pier.beam((x, DECK - 0.29, z0), (x, DECK - 0.29, z1 + 0.6)))
        for z in (z0 + 0.15, (z0 + z1) / 2, z1 - 0.1):
            frame.add("wood", pier.beam((x0, DECK - 0.14, z), (x1, DECK - 0.14, z), (0.12, 0.17)))
        side = across if across[1] < 0 else -across
        rail = lambda s0, s1, t, seed: pier.railing(
            flat(PIER_A + along * s0 + side * t, DECK), flat(PIER_A + along * s1 + side * t, DECK), seed
        )
        frame.add("paint", rail(0.4, 4.2, 1.15, 1), rail(11.9, length - 0.2, 1.15, 2))
        frame.add(
            "paint",
            pier.railing((x0 + 0.1, DECK, z0 + 0.1), (x1 - 0.1, DECK, z0 + 0.1), 3),
            pier.railing((x0 + 0.1, DECK, z0 + 0.1), (x0 + 0.1, DECK, z1 - 0.6), 4),
        )
        near = -side
        frame.add("wood", pier.ladder(flat(PIER_A + along * 15.4 + near * 1.3, DECK), (near[0], 0, near[1])))
        for s in (4.6, 10.2, 17.6):
            self.glb.node(self.bollard, flat(PIER_A + along * s + near * 1.0, DECK))
        for s in (6.0, 18.0):
            self.glb.node(self.lamp, flat(PIER_A + along * s + side * 1.0, DECK))
        self.still("pier frame", frame)

    def huts(self):
        scene, windows = Asset(), {}

        def place(made, x, y, z, yaw, trim="#f2efe6"):
            hut, panes = made
            scene.include(hut, lambda s: shape.move(shape.yawed(s, yaw), (x, y, z)))
            if trim not in windows:
                windows[trim] = self.mesh(f"window {len(windows)}", huts.window(rgb(trim)))
            for at, turn in panes:
                self.glb.node(windows[trim], shape.about("y", yaw) @ at + [x, y, z], glb.yaw(yaw + turn))

        ochre = huts.hut(
            (4.6, 3.8),
            "#d9a441",
            roof="#7d4434",
            door="#35586b",
            tall=2.3,
            doorAt=0.05,
            windows=((-0.3, "front"), (0.32, "front"), (0, "left"), (0, "right")),
        )
        place(ochre, 5.6, DECK, -6.9, 0)
        red = huts.hut(
            (5.6, 4.6),
            "#a2342a",
            roof="#4d4a4c",
            door="#efe9dc",
            tall=2.7,
            doorAt=0.0,
            doorSide="left",
            windows=((-0.28, "left"), (0.28, "left"), (-0.25, "front"), (0.25, "front"), (0, "back")),
            chimney=True,
        )
        place(red, 18.4, land.QUAY_TOP, -6.2, 4)
        blue = huts.hut(
            (4.4, 4.0),
            "#5f8aa3",
            roof="#8a4b38",
            door="#8a3a2c",
            tall=2.4,
            doorSide="left",
            doorAt=-0.15,
            windows=((0.25, "left"), (0, "front")),
        )
        place(blue, 17.2, land.QUAY_TOP, -16.5, -6)
        white = huts.hut(
            (6.0, 4.6),
            "#e9e2d0",
            trim="#7c5a44",
            roof="#9a4a36",
            door="#7c4a34",
            tall=2.8,
            windows=((-0.28, "left"), (0.28, "left"), (-0.2, "front"), (0.25, "front")),
            doorSide="left",
            chimney=True,
        )
        place(white, 17.8, land.QUAY_TOP, -25.5, 8, "#7c5a44")
        self.window = windows["#f2efe6"]
        things = Asset()
        barrel = self.mesh("barrel", Asset().add("paint", moorings.barrel()))
        self.crates = [
            self.mesh(f"crate {c}", Asset().add("paint", moorings.crate(c)))
            for c in ("#d8832f", "#3f78a8", "#d9c24a", "#c9c4b6")
        ]
        self.ring = self.mesh("life ring", Asset().add("gloss", moorings.lifeRing()))
        for x, y, z, kind in ((2.2, 0, -4.3, 0), (2.25, 0, -4.9, 1), (2.2, 0.3, -4.35, 2), (8.2, 0, -4.4, 1)):
            self.glb.node(self.crates[kind], (x, DECK + y, z), glb.yaw(x * 40 + kind * 25))
        for k in range(4):
            self.glb.node(
                self.crates[k], (14.7 + 0.1 * k, land.QUAY_TOP + 0.3 * (k // 2), -8.6 + 0.55 * (k % 2)), glb.yaw(7 * k)
            )
        for x, y, z in (
            (8.25, DECK, -5.4),
            (8.2, DECK, -6.1),
            (15.2, land.QUAY_TOP, 0.2),
            (15.5, land.QUAY_TOP, 0.75),
            (14.9, land.QUAY_TOP, -11),
        ):
            self.glb.node(barrel, (x, y, z), glb.yaw(x * 50))
        things.add(
            "paint",
            shape.move(moorings.netHeap(3), (14.9, land.QUAY_TOP - 0.03, 2.6)),
            shape.move(moorings.netHeap(8, "#7a4b3a"), (2.6, DECK, -5.9)),
        )
        self.glb.node(self.ring, (4.55, DECK + 1.35, -4.93))
        scene.include(things)
        self.still("huts", occlusion.bake(scene, 0.16, 0.7))

    def lighthouse(self):
        asset = Asset().include(
            lighthouse.lighthouse(), lambda s: shape.move(s, (land.LIGHTHOUSE[0], 2.75, land.LIGHTHOUSE[1]))
        )
        for at, turn in lighthouse.windows():
            self.glb.node(
                self.window, at + [land.LIGHTHOUSE[0], 2.75, land.LIGHTHOUSE[1]], glb.yaw(turn), (0.6, 0.85, 1.5)
            )
        self.still("lighthouse", occlusion.bake(asset, 0.14, 0.6))

    # --- boats -----------------------------------------------------------------------------------------------------

    def fleet(self):
        """The boat that is ashore; make_afloat.py makes the others, and buoys and marks: harbour.toml says where they are."""
        self.glb.node(
            self.mesh("rowing boat", occlusion.bake(boats.rowingBoat(), 0.05, 0.75)),
            (15.2, 0.62, 14.2),
            glb.times(glb.yaw(118), np.array([np.sin(np.radians(6)), 0, 0, np.cos(np.radians(6))])),
        )

    def moorings(self):
        poles = [
            self.mesh(f"pole {k}", Asset().add("wood", pier.post(k + 40, 2.1 + 0.3 * k, -4.5, 0.13))) for k in range(2)
        ]
        for k, (x, z) in enumerate(((-7.2, 1.8), (-13.6, -4.6), (-14.5, -12.5), (3.6, 4.4), (-1.8, 3.6))):
            lean = np.radians(self.rng.normal(scale=1.6, size=2)) / 2
            q = glb.times(
                np.array([lean[0], 0, lean[1], 1]) / np.linalg.norm([lean[0], 0, lean[1], 1]),
                glb.yaw(self.rng.uniform(0, 360)),
            )
            self.glb.node(poles[k % 2], (x, 0, z), q)
        ropes = Asset().add(
            "paint",
            moorings.rope((-2.7, 0.55, 8.7), (-1.8, 1.2, 3.6), 0.35),
            moorings.rope((-0.85, 0.62, -1.1), (-1.35, DECK + 0.2, -2.4), 0.12),
            moorings.rope((4.6, 1.55, 0.7), (3.6, 1.7, 4.4), 0.2),
            moorings.rope((12.9, 0.95, 0.2), (13.55, 1.65, 1.5), 0.1),
            moorings.rope((4.9, 1.45, 0.4), (3.0, DECK + 0.4, -2.0), 0.15),
            moorings.rope((-14.1, 1.1, -6.6), (-13.6, 1.7, -4.6), 0.1),
            moorings.rope((-7.0, 0.85, -10.5), (-5.2, DECK + 0.4, -4.6), 0.45),
        )
        self.still("ropes", ropes)


def main():
    harbour = Harbour()
    parts = (
        harbour.ground,
        harbour.boulders,
        harbour.forest,
        harbour.quay,
        harbour.pier,
        harbour.huts,
        harbour.lighthouse,
        harbour.fleet,
        harbour.moorings,
    )
    glb.build(harbour.glb, parts, pathlib.Path(__file__).parent / "harbour.glb")


if __name__ == "__main__":
    main()
