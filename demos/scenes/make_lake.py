#!/usr/bin/python3
"""Makes lake.glb and mountains.glb: a lake at dawn, all but its water, and prints its shore for lake.toml.

Metres, +Y up, the water at y = 0. The picture is composed for an eye at about (1, 1.7, 12) looking towards -z, with the
sun behind its right shoulder.
"""
import pathlib

import numpy as np

import glb
from make import boats, colored, land, mountains, occlusion, pier, rocks, shape, texture, trees
from make.shape import Asset, rgb

JETTY_A, JETTY_B, WIDE, DECK = np.array([-5.2, 10.2]), np.array([-4.2, -6.5]), 1.7, 0.62


def meshOf(file, materials, name, asset):
    return file.mesh(name, [(s, materials[m]) for m, s in asset.joined().items()])


def mountainsFile(folder):
    file = glb.Glb()
    picture = file.texture(colored.png(mountains.picture(), 26))
    materials = {"land": file.material("land", texture=picture, roughness=1.0)}
    file.node(meshOf(file, materials, "land", Asset().add("land", mountains.land())))
    write(file, folder / "mountains.glb")


class Lake:
    def __init__(self):
        self.glb = glb.Glb()
        self.rng = np.random.default_rng(77)
        pictures = {"wood": texture.wood(), "stone": texture.rock(), "ground": texture.ground()}
        textures = {name: self.glb.texture(texture.png(image)) for name, image in pictures.items()}
        self.materials = {
            "wood": self.glb.material("wood", texture=textures["wood"], roughness=0.85),
            "stone": self.glb.material("stone", texture=textures["stone"], roughness=0.9),
            "ground": self.glb.material("ground", texture=textures["ground"], roughness=0.95),
            "plain": self.glb.material("plain", roughness=1.0),
            "paint": self.glb.material("paint", roughness=0.7),
            "leaves": self.glb.material("leaves", roughness=0.95, doubleSided=True),
            "hull": self.glb.material("hull", rgb("#a8352a"), roughness=0.45),
        }

    def mesh(self, name, asset):
        return meshOf(self.glb, self.materials, name, asset)

    def shore(self):
        self.glb.node(self.mesh("shore", Asset().add("ground", mountains.foreground())))

    def plain(self):
        self.glb.node(self.mesh("plain", Asset().add("plain", mountains.plain())))

    def boulders(self):
        tones = (rgb("#8f8b86"), rgb("#9a8f80"), rgb("#6c6a66"))
        kinds = [self.mesh(f"boulder {k}", Asset().add("stone", rocks.boulder(k + 3, tones[k % 3], 2 if k < 2 else 1))) for k in range(5)]

        def put(x, z, size, sink):
            y = float(mountains.height(x, z))
            scale = size * self.rng.uniform(0.8, 1.25, 3)
            self.glb.node(kinds[self.rng.integers(5)], (x, y + size * (0.4 - sink), z), glb.yaw(self.rng.uniform(0, 360)), scale)

        for x, z, size in ((8.4, 3.6, 1.0), (10.2, 2.2, 2.0), (11.8, 4.2, 1.1), (5.4, 1.6, 0.7), (12.5, 1.6, 1.6), (8.7, 0.4, 0.9), (4.1, 3.9, 0.45), (13.6, 3.6, 1.0), (-9.6, 5.0, 1.1), (-11.2, 3.4, 1.7), (-13.5, 4.4, 1.2)):
            put(x, z, size, 0.22)
        curve = mountains.CURVE
        for _ in range(150):  # pebbles in front of the eye, stones along the shore
            at = curve[self.rng.integers(0, 40)] + self.rng.normal(scale=1.6, size=2)
            put(*at, self.rng.uniform(0.12, 0.5) ** 1.2, 0.2)
        for _ in range(70):
            put(self.rng.uniform(-7, 10), self.rng.uniform(-4, 8), self.rng.uniform(0.10, 0.38), 0.2)
        for _ in range(120):
            at = curve[self.rng.integers(len(curve))] + self.rng.normal(scale=2.0, size=2)
            if np.hypot(*(at - (1, 11))) < 16:
                continue
            put(*at, self.rng.uniform(0.8, 3.2), 0.3)

    def forest(self):
        near = [self.mesh(f"spruce {k}", trees.conifer(k + 5, 11.0)) for k in range(2)]
        far = [self.mesh(f"far spruce {k}", trees.farConifer(k + 1)) for k in range(5)]
        taken = np.empty((0, 2))

        def plant(kinds, x, z, size, apart):
            nonlocal taken
            y = float(mountains.height(x, z))
            if y < 0.9 or y > 330 or (len(taken) and np.min(np.hypot(*(taken - (x, z)).T)) < apart):
                return
            taken = np.vstack([taken, (x, z)])
            scale = size * np.array([1, self.rng.uniform(0.85, 1.2), 1])
            self.glb.node(kinds[self.rng.integers(len(kinds))], (x, y - 0.25, z), glb.yaw(self.rng.uniform(0, 360)), scale)

        for x, z, size in ((-19, 10, 1.2), (-23, 6, 1.35), (-27, 12, 1.0), (-17, 16, 0.8), (-31, 4, 1.15), (27, 5, 1.25), (32, 1, 1.0), (37, 6, 1.3), (43, 0, 1.1)):
            plant(near, x, z, size, 0)
        curve = mountains.CURVE
        for _ in range(6500):
            k = self.rng.integers(len(curve))
            a, b = curve[k], curve[(k + 1) % len(curve)]
            out = np.array([(b - a)[1], -(b - a)[0]]) / np.linalg.norm(b - a)
            if mountains.fromShore(*(a + out)) < 0:
                out = -out
            at = a + (b - a) * self.rng.random() + out * (5 + abs(self.rng.normal()) * 105)
            if np.hypot(at[0], at[1] - 10) < 42 and abs(at[0]) < 36:
                continue
            sunward = abs(np.degrees(np.arctan2(at[1] - 3, at[0])) - 42)
            if sunward < 24 and np.hypot(*at) < 190:
                continue
            grove = land.waves(at[0], at[1], 81, 130, 2) + 0.4
            if self.rng.random() < 0.35 + grove:
                plant(far, *at, self.rng.uniform(0.6, 1.25), 4.0)
            if len(taken) > 2400:
                break

    def jetty(self):
        along = (JETTY_B - JETTY_A) / np.linalg.norm(JETTY_B - JETTY_A)
        across = np.array([-along[1], along[0]])
        length = np.linalg.norm(JETTY_B - JETTY_A)
        heading = np.degrees(np.arctan2(across[0], across[1])) + 90
        planks = [self.mesh(f"plank {k}", Asset().add("wood", shape.yawed(pier.plank(k, WIDE), heading))) for k in range(4)]
        for k in range(int(length / 0.222)):
            p = JETTY_A + along * (0.11 + 0.222 * k)
            self.glb.node(planks[self.rng.integers(4)], (p[0], DECK + self.rng.normal(scale=0.005), p[1]))
        posts = [self.mesh(f"post {k}", Asset().add("wood", pier.post(k, DECK + top, -3.0, 0.1))) for k, top in enumerate((-0.06, 0.55))]
        frame, flat = Asset(), lambda p, y: (p[0], y, p[1])
        for k, s in enumerate(np.linspace(3.4, length - 0.3, 6)):
            for t in (-0.76, 0.76):
                p = JETTY_A + along * s + across * t
                self.glb.node(posts[1 if k in (3, 5) else 0], flat(p, 0), glb.yaw(self.rng.uniform(0, 360)))
            frame.add("wood", pier.beam(flat(JETTY_A + along * s - across * 0.9, DECK - 0.2), flat(JETTY_A + along * s + across * 0.9, DECK - 0.2), (0.12, 0.15)))
        for t in (-0.72, 0.72):
            frame.add("wood", pier.beam(flat(JETTY_A + across * t, DECK - 0.1), flat(JETTY_B + across * t, DECK - 0.1), (0.1, 0.13)))
        self.glb.node(self.mesh("jetty's frame", frame))

    def boat(self):
        mesh = self.mesh("rowing boat", occlusion.bake(boats.rowingBoat(), 0.05, 0.75))
        self.glb.node(mesh, (-1.9, 0, -3.1), glb.yaw(97))
        rope = np.array([(-2.2, 0.6, -1.05), (-2.8, 0.47, -1.02), (-3.35, 0.62, -0.98), (-3.77, 1.0, -0.95)])
        self.glb.node(self.mesh("rope", Asset().add("paint", shape.tube(rope, 0.014, rgb("#cbbd9c"), 4, False))))


def write(file, path):
    file.write(path)
    print(f"{path.name}: {path.stat().st_size} bytes")


def main():
    folder = pathlib.Path(__file__).parent
    mountainsFile(folder)
    lake = Lake()
    for build in (lake.shore, lake.plain, lake.boulders, lake.forest, lake.jetty, lake.boat):
        before = lake.glb.size()
        build()
        print(f"{build.__name__:10} {(lake.glb.size() - before) / 1000:7.0f} kB, {len(lake.glb.json['nodes'])} things")
    write(lake.glb, folder / "lake.glb")
    # The water reaches a little under the bank.
    middle = mountains.CURVE.mean(0)
    shore = [p + 3 * (p - middle) / np.linalg.norm(p - middle) for p in mountains.outline(2)]
    print("points_m = [" + ", ".join(f"[{x:.1f}, {z:.1f}]" for x, z in shore) + "]")


if __name__ == "__main__":
    main()
