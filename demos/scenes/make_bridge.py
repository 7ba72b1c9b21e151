#!/usr/bin/python3
"""Makes bridge.glb: a footbridge from the harbour's beach to a skerry, behind the eye of the harbour's other pictures,
with net stakes and reeds about it: things a few centimetres thick, and a deck that is seen from below.

In the harbour's own coordinates. It is looked at from about (19, 1.2, 66) towards -z.
"""
import pathlib

import numpy as np

import glb
from make import bridge, land, moorings, occlusion, pier, rocks, shape, texture
from make.shape import Asset, rgb

START, LENGTH, Z = 8.6, 25.0, 50.0  # x of the skerry's end [m]
ENDS, MIDDLE = 1.75, 2.55  # height of the deck
SKERRY = np.array([5.5, 49.0])


class Bridge:
    def __init__(self):
        self.glb = glb.Glb()
        self.rng = np.random.default_rng(11)
        wood = self.glb.texture(texture.png(texture.wood()))
        stone = self.glb.texture(texture.png(texture.rock()))
        self.materials = {
            "wood": self.glb.material("wood", texture=wood, roughness=0.85),
            "stone": self.glb.material("stone", texture=stone, roughness=0.9),
            "paint": self.glb.material("paint", roughness=0.7),
            "gloss": self.glb.material("gloss", roughness=0.35),
            "reeds": self.glb.material("reeds", roughness=0.9, doubleSided=True),
        }

    def mesh(self, name, asset):
        return self.glb.mesh(name, [(s, self.materials[m]) for m, s in asset.joined().items()])

    def bridge(self):
        timber, railings = bridge.span(LENGTH, ENDS, MIDDLE)
        asset = Asset().add("wood", timber).add("paint", railings)
        for x in (LENGTH * 0.3, LENGTH * 0.7):
            top = float(bridge.deckHeight(x, LENGTH, ENDS, MIDDLE)) - 0.45
            asset.add("wood", shape.move(bridge.trestle(top, -4.0), (x, 0, 0)))
        self.glb.node(self.mesh("bridge", occlusion.bake(asset, 0.12, 0.6)), (START, 0, Z))
        stones = Asset().add("stone", bridge.abutment(2.9, 3.2, 1))
        mesh = self.mesh("abutment", stones)
        self.glb.node(mesh, (START - 0.6, ENDS - 0.12, Z))
        self.glb.node(mesh, (START + LENGTH + 0.6, ENDS - 0.12, Z), glb.yaw(180))

    def skerry(self):
        grey, warm = rgb("#97918a"), rgb("#a3947f")
        kinds = [
            self.mesh(f"rock {k}", Asset().add("stone", rocks.boulder(30 + k, (grey, warm)[k % 2], 2))) for k in range(3)
        ]
        for _ in range(26):
            turn, r = self.rng.uniform(0, 2 * np.pi), 3.6 * np.sqrt(self.rng.random())
            x, z = SKERRY + r * np.array([1.25 * np.cos(turn), np.sin(turn)])
            size = self.rng.uniform(1.6, 3.0)
            y = 0.75 - 0.33 * r - 0.12 * size
            self.glb.node(
                kinds[self.rng.integers(3)], (x, y, z), glb.yaw(self.rng.uniform(0, 360)), size * np.array([1, 0.8, 1])
            )

    def stakes(self):
        kinds = [self.mesh(f"stake {k}", Asset().add("paint", bridge.stake(k, 1.7 + 0.35 * k))) for k in range(3)]
        rows = [(13.0 + 0.9 * k, 57.5 + 0.22 * k) for k in range(12)]  # a net's, in front of the bridge
        rows += [(25.5 + 0.35 * k, 53.0 - 0.9 * k) for k in range(6)]
        rows += [(14.0 + 1.6 * k, 40.0 + 0.3 * k) for k in range(6)]  # and seen beneath it
        for x, z in rows:
            lean = np.radians(self.rng.normal(scale=2.2, size=2)) / 2
            q = np.array([lean[0], 0, lean[1], 1])
            x, z = np.array([x, z]) + self.rng.normal(scale=0.1, size=2)
            self.glb.node(kinds[self.rng.integers(3)], (x, 0, z), q / np.linalg.norm(q))

    def reeds(self):
        clumps = [self.mesh(f"reeds {k}", Asset().add("reeds", bridge.reeds(k))) for k in range(3)]
        spots = [(9.8, 52.3), (10.6, 52.9), (10.2, 53.7), (9.2, 53.2), (11.3, 53.3), (8.3, 53.9), (10.9, 47.5), (11.6, 46.9)]
        for k in range(12):
            z = 52.5 + 0.7 * k
            spots.append((float(land.coast(z)) - 1.2 - self.rng.uniform(0, 1.3), z))
        for x, z in spots:
            self.glb.node(clumps[self.rng.integers(3)], (x, 0, z), glb.yaw(self.rng.uniform(0, 360)))

    def mooring(self):
        """Of a boat that harbour.toml has."""
        ropes = Asset().add("paint", moorings.rope((27.8, 0.6, 54.5), (29.2, 1.0, 51.4), 0.1))
        posts = Asset().add("wood", pier.post(9, 1.3, -3.0, 0.10))
        self.glb.node(self.mesh("rope", ropes))
        self.glb.node(self.mesh("post", posts), (29.2, 0, 51.4))


def main():
    made = Bridge()
    parts = (made.bridge, made.skerry, made.stakes, made.reeds, made.mooring)
    glb.build(made.glb, parts, pathlib.Path(__file__).parent / "bridge.glb")


if __name__ == "__main__":
    main()
